// SPDX-License-Identifier: BSD-3-Clause
#include "scLitProfile.h"

#include "scGaussLegendre.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
constexpr int cells = LitProfileLayout::Cells;
constexpr int nodes = 8; ///< a panel
/// Rays pass the light at no less than this share of its radius, as far as the change of variable is concerned.
constexpr double smallestDistance = 0.3;
/// A light farther away than so many lengths of the ray looks the same from all of it.
constexpr double farAway = 1000.0;

/// Integrals over cells from values at the nodes of a panel, for every number of panels; over a panel of width 1.
struct PanelRules
{
  PanelRules()
    : Rule(nodes)
  {
    for (int level = 0; level < LitQuadrature::NumberOfPanelLevels; ++level)
    {
      const int count = cells >> level;
      this->Matrices[level].resize(static_cast<std::size_t>(count * nodes));
      for (int cell = 0; cell < count; ++cell)
      {
        for (int j = 0; j < nodes; ++j)
        {
          // The j-th Lagrange polynomial over the cell, by the same rule: exact.
          double sum = 0.0;
          for (int k = 0; k < nodes; ++k)
          {
            const double x = (cell + this->Rule.Nodes[k]) / count;
            double value = this->Rule.Weights[k] / count;
            for (int m = 0; m < nodes; ++m)
            {
              value *= m == j ? 1.0 : (x - this->Rule.Nodes[m]) / (this->Rule.Nodes[j] - this->Rule.Nodes[m]);
            }
            sum += value;
          }
          this->Matrices[level][static_cast<std::size_t>(cell * nodes + j)] = sum;
        }
      }
    }
  }

  GaussLegendre Rule;
  GaussLegendre CellRule{ 2 }; ///< of one cell where a density varies
  std::array<std::vector<double>, LitQuadrature::NumberOfPanelLevels> Matrices;
};

const PanelRules& Panels()
{
  static const PanelRules rules;
  return rules;
}
} // anonymous namespace

/// The variable at the edges of the cells: even, or even on both sides of a gap, which the cell before it takes in.
struct CellVariables
{
  CellVariables(const LitAngle& angle, const MediumSpan& span)
    : Begin(angle.ToVariable(span.Begin))
    , Width(angle.CellWidth)
  {
    this->WidthBehind = this->Width;
    this->Behind = this->Begin + middle * this->Width;
    if (span.HasGap)
    {
      const double end = this->Begin + cells * this->Width;
      this->Width = (angle.ToVariable(angle.Nearest - span.HalfGap) - this->Begin) / middle;
      this->Behind = angle.ToVariable(angle.Nearest + span.HalfGap);
      this->WidthBehind = (end - this->Behind) / (cells - middle);
    }
  }

  double WidthAt(int cell) const { return cell < middle ? this->Width : this->WidthBehind; }
  /// @p offset in cells from the beginning of a cell.
  double At(int cell, double offset) const
  {
    return cell < middle ? this->Begin + (cell + offset) * this->Width
                         : this->Behind + (cell - middle + offset) * this->WidthBehind;
  }
  void FillEdges(const LitAngle& angle, double reference, float* edges) const
  {
    Fill(angle, this->Begin, this->Width, middle, reference, edges);
    Fill(angle, this->Behind, this->WidthBehind, cells - middle, reference, edges + middle);
  }
  static void Fill(const LitAngle& angle, double begin, double width, int count, double reference, float* edges)
  {
    if (angle.IsLength)
    {
      for (int k = 0; k < count; ++k)
      {
        edges[k] = static_cast<float>(begin + k * width - reference);
      }
      return;
    }
    // Tangents of even angles: a vector that is turned by the same angle again and again.
    const double cosine = std::cos(width);
    const double sine = std::sin(width);
    double x = std::cos(begin);
    double y = std::sin(begin);
    for (int k = 0; k < count; ++k)
    {
      edges[k] = static_cast<float>(angle.Nearest + angle.Scale * (y / x) - reference);
      const double turned = cosine * x - sine * y;
      y = sine * x + cosine * y;
      x = turned;
    }
  }

  static constexpr int middle = cells / 2;
  double Begin;
  double Width;
  double Behind;
  double WidthBehind;
};

LitQuadrature::LitQuadrature(const Light& light, const Medium& medium, const ExtinctionGroups& groups)
  : Source(light)
  , Fog(medium)
  , Groups(groups)
  , Spans(light, medium.Bounds)
{
  this->Layout.NumberOfGroups = groups.Count();
  for (int level = 0; level < LightRule::NumberOfLevels; ++level)
  {
    this->Rules.emplace_back(light, level);
  }
  LightBoundingSphere(light, this->Center, this->Radius);
  this->Extent = medium.Bounds.Diagonal();
}

LitAngle::LitAngle(const LitQuadrature& quadrature, const Ray& ray, const MediumSpan& span)
{
  const double length = std::fabs(span.End - span.Begin);
  this->Nearest = Dot(quadrature.Center - ray.Origin, ray.Direction);
  const double distance = Length(ray.Origin + this->Nearest * ray.Direction - quadrature.Center);
  this->IsLength = IsAtInfinity(quadrature.Source) || distance > farAway * quadrature.Extent;
  if (this->IsLength)
  {
    this->CellWidth = (span.End - span.Begin) / cells;
    return;
  }
  this->Scale = std::max({ distance, smallestDistance * quadrature.Radius, 1e-4 * length });
  // The difference of the two angles, from one arc tangent.
  const double a = (span.Begin - this->Nearest) / this->Scale;
  const double b = (span.End - this->Nearest) / this->Scale;
  this->CellWidth = std::atan2(b - a, 1.0 + a * b) / cells;
}

LitProfiler::LitProfiler(const LitQuadrature& quadrature)
  : Quadrature(quadrature)
  , Depth(quadrature.Fog)
{
  Panels();
}

int LitProfiler::NumberOfEvaluations(const LitQuadrature& quadrature, const LitLevel& level)
{
  return (nodes << level.Panels) * quadrature.Rules[static_cast<std::size_t>(level.Rule)].Count();
}

void LitProfiler::Evaluate(
  const Ray& ray, const MediumSpan& span, double reference, const LitLevel& level, float* values)
{
  std::fill(values, values + this->Quadrature.Layout.Size(), 0.0f);
  const LitAngle angle(this->Quadrature, ray, span);
  const CellVariables variables(angle, span);
  variables.FillEdges(angle, reference, values);
  values[0] = static_cast<float>(span.Begin - reference);
  values[cells] = static_cast<float>(span.End - reference);
  this->Depth.SetRay(ray.Origin, ray.Direction, span.MediumBegin, span.End);
  if (!this->Depth.IsHomogeneous())
  {
    this->IntegrateDensity(ray, span, angle, variables, reference, level, values);
    return;
  }

  const int groups = this->Quadrature.Groups.Count();
  const PanelRules& rules = Panels();
  const int panelLevel = span.HasGap ? std::max(level.Panels, 1) : level.Panels; // no panel reaches across a gap
  const int panels = 1 << panelLevel;
  const int perPanel = cells / panels;
  const std::vector<double>& matrix = rules.Matrices[static_cast<std::size_t>(panelLevel)];
  this->Nodes.resize(static_cast<std::size_t>(nodes * groups));
  for (int panel = 0; panel < panels; ++panel)
  {
    std::fill(this->Nodes.begin(), this->Nodes.end(), 0.0);
    const double share = span.HasGap ? variables.WidthAt(perPanel * panel) / angle.CellWidth : 1.0;
    for (int j = 0; j < nodes; ++j)
    {
      const double t = angle.ToDistance(variables.At(perPanel * panel, perPanel * rules.Rule.Nodes[j]));
      this->AddNode(
        ray, t, perPanel * share * angle.Flattened(t), level, this->Nodes.data() + static_cast<std::size_t>(j * groups));
    }
    for (int g = 0; g < groups; ++g)
    {
      float* cell = values + LitProfileLayout::Edges + g * cells + panel * perPanel;
      for (int k = 0; k < perPanel; ++k)
      {
        double sum = 0.0;
        for (int j = 0; j < nodes; ++j)
        {
          sum += matrix[static_cast<std::size_t>(k * nodes + j)] * this->Nodes[static_cast<std::size_t>(j * groups + g)];
        }
        cell[k] = static_cast<float>(sum);
      }
    }
  }
}

void LitProfiler::IntegrateDensity(const Ray& ray, const MediumSpan& span, const LitAngle& angle,
  const CellVariables& variables, double reference, const LitLevel& level, float* values)
{
  // Two Gauss nodes a cell in the optical depth instead of the distance: a layer of fog that is thinner than a cell counts
  // in full, and where it lies.
  const GaussLegendre& rule = Panels().CellRule;
  const int groups = this->Quadrature.Groups.Count();
  this->Nodes.resize(static_cast<std::size_t>(groups));
  for (int k = 0; k < cells; ++k)
  {
    const double a = reference + static_cast<double>(values[k]);
    const double b = reference + static_cast<double>(values[k + 1]);
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    const double before = this->Depth.Along(low);
    const double depth = this->Depth.Along(high) - before;
    if (!(depth > 0.0))
    {
      continue;
    }
    std::fill(this->Nodes.begin(), this->Nodes.end(), 0.0);
    const double share = span.HasGap ? variables.WidthAt(k) / angle.CellWidth : 1.0;
    for (int j = 0; j < 2; ++j)
    {
      const double wanted = before + rule.Nodes[j] * depth;
      double from = low;
      double to = high;
      for (int step = 0; step < 24; ++step)
      {
        const double middle = 0.5 * (from + to);
        (this->Depth.Along(middle) < wanted ? from : to) = middle;
      }
      const double t = 0.5 * (from + to);
      const double factor = 0.5 * share * this->Depth.MeanDensity(low, high) * angle.Flattened(t);
      this->AddNode(ray, t, factor, level, this->Nodes.data());
    }
    for (int g = 0; g < groups; ++g)
    {
      values[LitProfileLayout::Edges + g * cells + k] = static_cast<float>(this->Nodes[static_cast<std::size_t>(g)]);
    }
  }
}

void LitProfiler::AddNode(const Ray& ray, double t, double factor, const LitLevel& level, double* value)
{
  const LitQuadrature& quadrature = this->Quadrature;
  const int groups = quadrature.Groups.Count();
  const double* sigmaT = quadrature.Groups.SigmaT.data();
  const Vector3 point = ray.Origin + t * ray.Direction;
  const double cameraLeg = this->Depth.Along(t);
  const LightRule& coarse = quadrature.Rules[static_cast<std::size_t>(level.Rule)];
  const int rule = std::min(level.Rule + coarse.LevelsNearer(point), LightRule::NumberOfLevels - 1);
  const LightRule& light = quadrature.Rules[static_cast<std::size_t>(rule)];
  if (this->Depth.IsHomogeneous() && light.IsByArea(point))
  {
    this->AddLightPoints(light, point, ray.Direction, cameraLeg, factor, value);
    return;
  }
  light.ForEach(point,
    [&](const IncidentSample& sample)
    {
      const double source =
        factor * sample.Weight * EvaluatePhaseFunction(quadrature.Fog.Phase, Dot(sample.Direction, ray.Direction));
      const double depth = cameraLeg + this->Depth.Towards(point, sample.Direction, sample.Distance);
      for (int g = 0; g < groups; ++g)
      {
        value[g] += source * TransmittanceOver(sigmaT[g], depth);
      }
    });
}

void LitProfiler::AddLightPoints(const LightRule& rule, const Vector3& point, const Vector3& direction,
  double cameraLeg, double factor, double* value)
{
  const Medium& fog = this->Quadrature.Fog;
  const LightPoints points = rule.AreaPoints();
  const auto count = static_cast<std::size_t>(points.Count);
  this->Weights.resize(count);
  this->Cosines.resize(count);
  this->Legs.resize(count);
  LookAtLight(points, rule.ViewFrom(point, direction, fog.Bounds), this->Weights.data(), this->Cosines.data(), this->Legs.data());
  const bool isotropic = fog.Phase.Kind == PhaseFunctionKind::Isotropic;
  const double scale = isotropic ? factor * EvaluatePhaseFunction(fog.Phase, 1.0) : factor;
  for (std::size_t k = 0; k < count && !isotropic; ++k)
  {
    this->Weights[k] *= static_cast<float>(EvaluatePhaseFunction(fog.Phase, static_cast<double>(this->Cosines[k])));
  }
  const ExtinctionGroups& groups = this->Quadrature.Groups;
  for (int g = 0; g < groups.Count(); ++g)
  {
    const double sigmaT = groups.SigmaT[static_cast<std::size_t>(g)];
    const float sum = SumAttenuated(this->Weights.data(), this->Legs.data(), points.Count, static_cast<float>(sigmaT));
    value[g] += scale * TransmittanceOver(sigmaT, cameraLeg) * static_cast<double>(sum);
  }
}

} // namespace shadowcones
