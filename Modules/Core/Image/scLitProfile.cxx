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
/// Of a ray's length: nearer than this is not told apart from it, and nearer than that not in single precision.
constexpr double smallestScale = 1e-11;
constexpr double closeScale = 1e-4;
/// A light farther away than so many lengths of the ray looks the same from all of it.
constexpr double farAway = 1000.0;
constexpr int middle = cells / 2; ///< where a gap is

/// A medium is dense that is more mean free paths across than this.
constexpr double denseDepth = 16.0;
/// Cells of a dense medium begin to grow at this optical depth; panels that it takes at least, as a level.
constexpr double firstDepth = 0.1;
constexpr int densePanels = 3;
/// From behind so many mean free paths comes less than the smallest float.
constexpr double deepest = 120.0;
constexpr double largestDepth = 1e3 * deepest;

double LargestSigmaT(const ExtinctionGroups& groups)
{
  return *std::max_element(groups.SigmaT.begin(), groups.SigmaT.end());
}

/// The length of medium behind which nothing is seen.
double DeepestLength(const Medium& medium, const ExtinctionGroups& groups)
{
  double smallest = HUGE_VAL;
  for (std::size_t g = 0; g < groups.SigmaT.size(); ++g)
  {
    smallest = groups.MeanSource[g] > 0.0 ? std::min(smallest, groups.SigmaT[g]) : smallest;
  }
  return medium.Density || !(smallest > 0.0) ? HUGE_VAL : deepest / smallest;
}

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

LitQuadrature::LitQuadrature(const Light& light, const Medium& medium, const ExtinctionGroups& groups)
  : Source(light)
  , Fog(medium)
  , Groups(groups)
  , Spans(light, medium.Bounds, DeepestLength(medium, groups))
{
  this->Layout.NumberOfGroups = groups.Count();
  for (int level = 0; level < LightRule::NumberOfLevels; ++level)
  {
    this->Rules.emplace_back(light, level);
  }
  LightBoundingSphere(light, this->Center, this->Radius);
  this->Extent = medium.Bounds.Diagonal();
  const double sigmaT = LargestSigmaT(groups);
  double density = 1.0;
  if (medium.Density && !medium.Density->Values.empty())
  {
    density = *std::max_element(medium.Density->Values.begin(), medium.Density->Values.end());
  }
  if (sigmaT * density * this->Extent > denseDepth)
  {
    this->DenseSigmaT = sigmaT;
  }
}

LitLevel LitQuadrature::FirstLevel() const
{
  LitLevel level;
  level.Panels = this->DenseSigmaT > 0.0 ? densePanels : 0;
  return level;
}

LitVariable::LitVariable(
  const LitQuadrature& quadrature, const Ray& ray, const MediumSpan& span, const MediumDepth* depth)
  : HasGap(span.HasGap)
  , SigmaT(quadrature.DenseSigmaT)
  , Depth(depth)
{
  const double length = std::fabs(span.End - span.Begin);
  this->Dense = this->SigmaT > 0.0;
  this->Nearest = Dot(quadrature.Center - ray.Origin, ray.Direction);
  const double distance = Length(ray.Origin + this->Nearest * ray.Direction - quadrature.Center);
  this->IsLength = IsAtInfinity(quadrature.Source) || distance > farAway * quadrature.Extent;
  if (!this->IsLength)
  {
    this->Scale = std::max({ distance, smallestDistance * quadrature.Radius, smallestScale * length });
    this->Close = this->Scale < closeScale * length;
  }
  this->CellWidth = this->Between(span.Begin, span.End) / cells;
  if (this->HasGap)
  {
    this->SetPart(this->Parts[0], span.Begin, this->Nearest - span.HalfGap, 0, middle);
    this->SetPart(this->Parts[1], this->Nearest + span.HalfGap, span.End, middle, cells - middle);
    return;
  }
  this->SetPart(this->Parts[0], span.Begin, span.End, 0, cells);
}

void LitVariable::SetPart(Part& part, double begin, double end, int firstCell, int count) const
{
  part.Begin = begin;
  part.End = end;
  part.FirstCell = firstCell;
  part.Cells = count;
  part.Width = this->HasGap ? this->Between(begin, end) / count : this->CellWidth;
  part.Graded = this->Dense && firstCell == 0;
  if (part.Graded)
  {
    part.Logarithm = std::log1p(this->DepthBetween(begin, end) / firstDepth);
    part.Graded = part.Logarithm > 0.0;
  }
}

double LitVariable::Between(double from, double to) const
{
  if (this->IsLength)
  {
    return to - from;
  }
  // The difference of the two angles, from one arc tangent.
  const double a = (from - this->Nearest) / this->Scale;
  const double b = (to - this->Nearest) / this->Scale;
  return std::atan2(b - a, 1.0 + a * b);
}

double LitVariable::DepthBetween(double from, double to) const
{
  const double length = this->Depth ? this->Depth->Along(to) - this->Depth->Along(from) : to - from;
  return std::max(this->SigmaT * (this->Depth ? std::min(length, largestDepth / this->SigmaT) : length), 0.0);
}

double LitVariable::CoordinateIn(const Part& part, double t) const
{
  const double even = this->Between(part.Begin, t) / part.Width;
  if (!part.Graded)
  {
    return even;
  }
  const double graded = std::log1p(this->DepthBetween(part.Begin, t) / firstDepth) / part.Logarithm;
  return 0.5 * (even + graded * part.Cells);
}

double LitVariable::CellCoordinate(double t) const
{
  const Part& part = this->HasGap && t > this->Nearest ? this->Parts[1] : this->Parts[0];
  if (!(part.End > part.Begin))
  {
    return part.FirstCell;
  }
  return part.FirstCell + std::clamp<double>(this->CoordinateIn(part, t), 0.0, part.Cells);
}

double LitVariable::DistanceIn(const Part& part, double offset) const
{
  if (!part.Graded)
  {
    if (this->IsLength)
    {
      return part.Begin + offset * part.Width;
    }
    return this->Nearest +
      this->Scale * std::tan(std::atan((part.Begin - this->Nearest) / this->Scale) + offset * part.Width);
  }
  double low = part.Begin;
  double high = part.End;
  if (!this->Depth)
  {
    // Each half of the coordinate alone is a bound; the depth behind the entry is what has to be told apart.
    const auto atGraded = [&](double share)
    { return part.Begin + firstDepth / this->SigmaT * std::expm1(share * part.Logarithm); };
    const double share = offset / part.Cells;
    low = std::max(low, atGraded(std::max(2.0 * share - 1.0, 0.0)));
    high = std::min(high, atGraded(std::min(2.0 * share, 1.0)));
  }
  for (int step = 0; step < 60 && high - low > 1e-12 * (high - part.Begin); ++step)
  {
    const double between = 0.5 * (low + high);
    (this->CoordinateIn(part, between) < offset ? low : high) = between;
  }
  return 0.5 * (low + high);
}

double LitVariable::DistanceAt(double cellCoordinate) const
{
  const Part& part = this->PartOf(cellCoordinate);
  return this->DistanceIn(part, cellCoordinate - part.FirstCell);
}

void LitVariable::FillEven(const Part& part, double* edges) const
{
  if (this->IsLength)
  {
    for (int k = 0; k < part.Cells; ++k)
    {
      edges[k] = part.Begin + k * part.Width;
    }
    return;
  }
  // Tangents of even angles: a vector that is turned by the same angle again and again.
  const double cosine = std::cos(part.Width);
  const double sine = std::sin(part.Width);
  const double begin = std::atan((part.Begin - this->Nearest) / this->Scale);
  double x = std::cos(begin);
  double y = std::sin(begin);
  for (int k = 0; k < part.Cells; ++k)
  {
    edges[k] = this->Nearest + this->Scale * (y / x);
    const double turned = cosine * x - sine * y;
    y = sine * x + cosine * y;
    x = turned;
  }
}

void LitVariable::FillEdges(double* edges) const
{
  for (int k = 0; k < (this->HasGap ? 2 : 1); ++k)
  {
    const Part& part = this->Parts[static_cast<std::size_t>(k)];
    if (!part.Graded)
    {
      this->FillEven(part, edges + part.FirstCell);
      continue;
    }
    for (int cell = 0; cell < part.Cells; ++cell)
    {
      edges[part.FirstCell + cell] = this->DistanceIn(part, cell);
    }
  }
  // The cell before a gap takes it in.
  edges[0] = this->Parts[0].Begin;
  edges[cells] = this->Parts[this->HasGap ? 1 : 0].End;
}

double LitVariable::Flattened(double t, double cellCoordinate) const
{
  const Part& part = this->PartOf(cellCoordinate);
  const double offset = t - this->Nearest;
  const double even = this->IsLength ? 1.0 : this->Scale * this->Scale + offset * offset;
  if (!this->Dense)
  {
    return this->HasGap ? even * (part.Width / this->CellWidth) : even;
  }
  // Distance per cell.
  const double perCell = this->IsLength ? part.Width : part.Width * even / this->Scale;
  if (!part.Graded)
  {
    return perCell;
  }
  const double gradedPerCell = part.Logarithm / part.Cells *
    (firstDepth / this->SigmaT + (t - part.Begin));
  return 2.0 / (1.0 / perCell + 1.0 / gradedPerCell);
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

void LitProfiler::Evaluate(const Ray& ray, const MediumSpan& span, const LitLevel& level, float* values)
{
  std::fill(values, values + this->Quadrature.Layout.Size(), 0.0f);
  this->Depth.SetRay(ray.Origin, ray.Direction, span.MediumBegin, span.End);
  const bool homogeneous = this->Depth.IsHomogeneous();
  const LitVariable variable(this->Quadrature, ray, span, homogeneous ? nullptr : &this->Depth);
  std::array<double, cells + 1> edges;
  variable.FillEdges(edges.data());
  for (int k = 0; k <= cells; ++k)
  {
    values[k] = static_cast<float>(edges[static_cast<std::size_t>(k)] - span.Begin);
  }
  if (!homogeneous)
  {
    this->IntegrateDensity(ray, variable, edges.data(), level, values);
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
    for (int j = 0; j < nodes; ++j)
    {
      const double coordinate = perPanel * (panel + rules.Rule.Nodes[j]);
      const double t = variable.DistanceAt(coordinate);
      this->AddNode(ray, t, perPanel * variable.Flattened(t, coordinate), level,
        this->Nodes.data() + static_cast<std::size_t>(j * groups));
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

void LitProfiler::IntegrateDensity(
  const Ray& ray, const LitVariable& variable, const double* edges, const LitLevel& level, float* values)
{
  // Two Gauss nodes a cell in the optical depth instead of the distance: a layer of fog that is thinner than a cell
  // counts in full, and where it lies.
  const GaussLegendre& rule = Panels().CellRule;
  const int groups = this->Quadrature.Groups.Count();
  this->Nodes.resize(static_cast<std::size_t>(groups));
  for (int k = 0; k < cells; ++k)
  {
    const double end = variable.IsGap(k + 1) ? variable.DistanceAt(k + 1) : edges[k + 1];
    const double low = std::min(edges[k], end);
    const double high = std::max(edges[k], end);
    const double before = this->Depth.Along(low);
    const double depth = this->Depth.Along(high) - before;
    if (!(depth > 0.0))
    {
      continue;
    }
    std::fill(this->Nodes.begin(), this->Nodes.end(), 0.0);
    for (int j = 0; j < 2; ++j)
    {
      const double wanted = before + rule.Nodes[j] * depth;
      double from = low;
      double to = high;
      for (int step = 0; step < 24; ++step)
      {
        const double between = 0.5 * (from + to);
        (this->Depth.Along(between) < wanted ? from : to) = between;
      }
      this->AddNode(ray, 0.5 * (from + to), 0.5 * depth / std::fabs(variable.CellFactor()), level, this->Nodes.data());
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
  light.ForEach(point, [&](const IncidentSample& sample)
    { this->AddSample(sample, point, ray.Direction, cameraLeg, factor, value); });
}

void LitProfiler::AddSample(const IncidentSample& sample, const Vector3& point, const Vector3& direction,
  double cameraLeg, double factor, double* value)
{
  const ExtinctionGroups& groups = this->Quadrature.Groups;
  const double source =
    factor * sample.Weight * EvaluatePhaseFunction(this->Quadrature.Fog.Phase, Dot(sample.Direction, direction));
  const double depth = cameraLeg + this->Depth.Towards(point, sample.Direction, sample.Distance);
  for (int g = 0; g < groups.Count(); ++g)
  {
    value[g] += source * TransmittanceOver(groups.SigmaT[static_cast<std::size_t>(g)], depth);
  }
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
  LookAtLight(points, rule.ViewFrom(point, direction, fog.Bounds), this->Weights.data(), this->Cosines.data(),
    this->Legs.data());
  rule.FindNear(point, this->NearSamples, this->ReplacedPoints);
  for (const IncidentSample& sample : this->NearSamples)
  {
    this->AddSample(sample, point, direction, cameraLeg, factor, value);
  }
  for (std::size_t k = 0; k < this->ReplacedPoints.size(); k += 2)
  {
    std::fill(this->Weights.begin() + static_cast<std::ptrdiff_t>(this->ReplacedPoints[k]),
      this->Weights.begin() + static_cast<std::ptrdiff_t>(this->ReplacedPoints[k + 1]), 0.0f);
  }
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
