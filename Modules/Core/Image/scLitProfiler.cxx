// SPDX-License-Identifier: BSD-3-Clause
#include "scLitProfiler.h"

#include "scGaussLegendre.h"
#include "scLitKernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int cells = LitProfileLayout::Cells;
constexpr int nodes = 8; ///< a panel
/// Light whose polynomial ends with terms that are this large, over the most on the ray, is not smooth in the panel.
constexpr double roughEnd = 0.05;

/// Integrals over cells from values at the nodes of a panel, for every number of panels; over a panel of width 1.
struct PanelRules
{
  PanelRules()
    : Rule(nodes)
  {
    for (std::size_t j = 0; j < nodes; ++j)
    {
      this->Inverses[j] = 1.0;
      for (std::size_t m = 0; m < nodes; ++m)
      {
        this->Inverses[j] /= m == j ? 1.0 : this->Rule.Nodes[j] - this->Rule.Nodes[m];
      }
    }
    for (std::size_t j = 0; j < nodes; ++j)
    {
      // Legendre polynomials up to the last two that the nodes tell apart.
      const double x = 2.0 * this->Rule.Nodes[j] - 1.0;
      std::array<double, nodes> legendre{ { 1.0, x } };
      for (std::size_t n = 2; n < nodes; ++n)
      {
        const auto degree = static_cast<double>(n);
        legendre[n] = ((2.0 * degree - 1.0) * x * legendre[n - 1] - (degree - 1.0) * legendre[n - 2]) / degree;
      }
      for (std::size_t k = 0; k < 2; ++k)
      {
        const std::size_t n = nodes - 2 + k;
        this->LastTerms[k][j] = static_cast<double>(2 * n + 1) * this->Rule.Weights[j] * legendre[n];
      }
    }
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

  /// The Lagrange polynomials of a panel's nodes at @p x of it.
  std::array<double, nodes> PolynomialsAt(double x) const
  {
    // Products of the differences before a node and behind it.
    std::array<double, nodes> values = this->Inverses;
    double before = 1.0;
    double behind = 1.0;
    for (std::size_t j = 0; j < nodes; ++j)
    {
      values[j] *= before;
      before *= x - this->Rule.Nodes[j];
      const std::size_t last = nodes - 1 - j;
      values[last] *= behind;
      behind *= x - this->Rule.Nodes[last];
    }
    return values;
  }

  GaussLegendre Rule;
  std::array<double, nodes> Inverses; ///< of the polynomials' products of differences of nodes
  std::array<std::array<double, nodes>, 2> LastTerms; ///< of the polynomial through values at the nodes, in Legendre's
  GaussLegendre CellRule{ 2 };        ///< of one cell where a density varies
  std::array<std::vector<double>, LitQuadrature::NumberOfPanelLevels> Matrices;
};

const PanelRules& Panels()
{
  static const PanelRules rules;
  return rules;
}
} // anonymous namespace

LitProfiler::LitProfiler(const LitQuadrature& quadrature)
  : Quadrature(quadrature)
  , OpticalDepth(quadrature.Air)
{
  Panels();
}

int LitProfiler::NumberOfEvaluations(const LitQuadrature& quadrature, const LitLevel& level)
{
  return (nodes << level.Panels) * quadrature.Rules[static_cast<std::size_t>(level.Rule)].Count();
}

void LitProfiler::Evaluate(const Ray& ray, const LitInterval& interval, const LitLevel& level, float* values)
{
  std::fill(values, values + this->Quadrature.Layout.Size(), 0.0f);
  this->OpticalDepth.SetRay(ray.Origin, ray.Direction, interval.MediumBegin, interval.End);
  const bool homogeneous = this->OpticalDepth.IsHomogeneous();
  const LitVariable variable(this->Quadrature, ray, interval, homogeneous ? nullptr : &this->OpticalDepth);
  std::array<double, cells + 1> edges;
  variable.FillEdges(edges.data());
  for (int k = 0; k <= cells; ++k)
  {
    values[k] = static_cast<float>(edges[static_cast<std::size_t>(k)] - interval.Begin);
  }
  if (!homogeneous)
  {
    this->IntegrateDensity(ray, variable, edges.data(), level, values);
    return;
  }

  const int groups = this->Quadrature.Groups.Count();
  const PanelRules& rules = Panels();
  const int panelLevel = interval.HasGap ? std::max(level.Panels, 1) : level.Panels; // no panel reaches across a gap
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
      this->AddNode(ray, t, this->OpticalDepth.Along(t), perPanel * variable.Flattened(t, coordinate), level,
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
          sum +=
            matrix[static_cast<std::size_t>(k * nodes + j)] * this->Nodes[static_cast<std::size_t>(j * groups + g)];
        }
        cell[k] = static_cast<float>(sum);
      }
    }
  }
}

void LitProfiler::IntegrateDensity(
  const Ray& ray, const LitVariable& variable, const double* edges, const LitLevel& level, float* values)
{
  // Two Gauss nodes a cell in the optical depth instead of the distance: a layer that is thinner than a cell
  // counts in full, and where it lies.
  const GaussLegendre& rule = Panels().CellRule;
  const int groups = this->Quadrature.Groups.Count();
  this->TabulateLight(ray, variable, level);
  this->Nodes.resize(static_cast<std::size_t>(groups));
  for (int k = 0; k < cells; ++k)
  {
    const double end = variable.IsGap(k + 1) ? variable.DistanceAt(k + 1) : edges[k + 1];
    const double low = std::min(edges[k], end);
    const double high = std::max(edges[k], end);
    const double before = this->OpticalDepth.Along(low);
    const double depth = this->OpticalDepth.Along(high) - before;
    if (!(depth > 0.0))
    {
      continue;
    }
    std::fill(this->Nodes.begin(), this->Nodes.end(), 0.0);
    for (int j = 0; j < 2; ++j)
    {
      const double t = this->OpticalDepth.DistanceAt(before + rule.Nodes[j] * depth, low, high);
      const double factor = 0.5 * depth / std::fabs(variable.CellFactor());
      // Within a cell the variable goes with the distance, nearly.
      const double coordinate = k + std::clamp((t - edges[k]) / (end - edges[k]), 0.0, 1.0);
      this->AddPlace(ray, t, coordinate, factor, level, this->Nodes.data());
    }
    for (int g = 0; g < groups; ++g)
    {
      values[LitProfileLayout::Edges + g * cells + k] = static_cast<float>(this->Nodes[static_cast<std::size_t>(g)]);
    }
  }
}

double LitProfiler::Evened(const Vector3& point) const
{
  const Vector3 offset = point - this->Quadrature.Center;
  return IsAtInfinity(this->Quadrature.Lamp) ? 1.0 : Dot(offset, offset);
}

void LitProfiler::TabulateLight(const Ray& ray, const LitVariable& variable, const LitLevel& level)
{
  const int panels = 1 << level.Panels;
  // As many nodes as cells have between them gain nothing; and no panel reaches across a gap.
  this->TablePanels = nodes * panels < 2 * cells && !variable.IsGap(cells / 2) ? panels : 0;
  if (this->TablePanels == 0)
  {
    return;
  }
  const int groups = this->Quadrature.Groups.Count();
  const GaussLegendre& rule = Panels().Rule;
  this->Table.assign(static_cast<std::size_t>(panels * nodes * groups), 0.0);
  for (int node = 0; node < panels * nodes; ++node)
  {
    const double coordinate =
      static_cast<double>(cells) / panels * (node / nodes + rule.Nodes[static_cast<std::size_t>(node % nodes)]);
    const double t = variable.DistanceAt(coordinate);
    this->AddNode(ray, t, 0.0, this->Evened(ray.Origin + t * ray.Direction), level,
      this->Table.data() + static_cast<std::size_t>(node * groups));
  }
  this->FindRoughPanels();
}

void LitProfiler::FindRoughPanels()
{
  const int groups = this->Quadrature.Groups.Count();
  this->RoughPanels.assign(static_cast<std::size_t>(this->TablePanels), 0);
  for (int g = 0; g < groups; ++g)
  {
    double most = 0.0;
    for (int node = 0; node < this->TablePanels * nodes; ++node)
    {
      most = std::max(most, this->Table[static_cast<std::size_t>(node * groups + g)]);
    }
    for (int panel = 0; panel < this->TablePanels; ++panel)
    {
      double last[2] = { 0.0, 0.0 };
      for (int j = 0; j < nodes; ++j)
      {
        const double value = this->Table[static_cast<std::size_t>((panel * nodes + j) * groups + g)];
        last[0] += Panels().LastTerms[0][static_cast<std::size_t>(j)] * value;
        last[1] += Panels().LastTerms[1][static_cast<std::size_t>(j)] * value;
      }
      if (std::fabs(last[0]) + std::fabs(last[1]) > roughEnd * most)
      {
        this->RoughPanels[static_cast<std::size_t>(panel)] = 1;
      }
    }
  }
}

void LitProfiler::AddPlace(
  const Ray& ray, double t, double coordinate, double factor, const LitLevel& level, double* value)
{
  if (this->TablePanels > 0)
  {
    const double place = coordinate / cells * this->TablePanels;
    const int panel = std::clamp(static_cast<int>(place), 0, this->TablePanels - 1);
    if (this->RoughPanels[static_cast<std::size_t>(panel)] == 0)
    {
      this->AddFromTable(ray, t, panel, place - panel, factor, value);
      return;
    }
  }
  this->AddNode(ray, t, this->OpticalDepth.Along(t), factor, level, value);
}

void LitProfiler::AddFromTable(const Ray& ray, double t, int panel, double x, double factor, double* value) const
{
  const std::array<double, nodes> polynomials = Panels().PolynomialsAt(x);
  const ExtinctionGroups& groups = this->Quadrature.Groups;
  const double cameraLeg = this->OpticalDepth.Along(t);
  const double even = this->Evened(ray.Origin + t * ray.Direction);
  const double* table = this->Table.data() + static_cast<std::size_t>(panel * nodes * groups.Count());
  for (int g = 0; g < groups.Count(); ++g)
  {
    double sum = 0.0;
    for (int j = 0; j < nodes; ++j)
    {
      sum += polynomials[static_cast<std::size_t>(j)] * table[j * groups.Count() + g];
    }
    const double transmittance = TransmittanceOver(groups.SigmaT[static_cast<std::size_t>(g)], cameraLeg);
    // Light is never below 0, as the polynomial may be where there is next to none.
    value[g] += even > 0.0 ? factor / even * std::max(sum, 0.0) * transmittance : 0.0;
  }
}

void LitProfiler::AddNode(
  const Ray& ray, double t, double cameraLeg, double factor, const LitLevel& level, double* value)
{
  const LitQuadrature& quadrature = this->Quadrature;
  const Vector3 point = ray.Origin + t * ray.Direction;
  const LightRule& coarse = quadrature.Rules[static_cast<std::size_t>(level.Rule)];
  const int rule = std::min(level.Rule + coarse.LevelsNearer(point), LightRule::NumberOfLevels - 1);
  const LightRule& light = quadrature.Rules[static_cast<std::size_t>(rule)];
  if (quadrature.Legs)
  {
    quadrature.Legs->LookAt(point, this->Place);
  }
  const bool alongLines = this->OpticalDepth.IsHomogeneous() || (quadrature.Legs && this->Place.InTable);
  if (alongLines && light.IsByArea(point))
  {
    this->AddLightPoints(rule, point, ray.Direction, cameraLeg, factor, value);
    return;
  }
  light.ForEach(point,
    [&](const IncidentSample& sample) { this->AddSample(sample, point, ray.Direction, cameraLeg, factor, value); });
}

double LitProfiler::DepthTowards(const Vector3& point, const IncidentSample& sample) const
{
  return this->Quadrature.Legs ? this->Quadrature.Legs->Towards(this->Place, sample.Direction, sample.Distance)
                               : this->OpticalDepth.Towards(point, sample.Direction, sample.Distance);
}

void LitProfiler::AddSample(const IncidentSample& sample, const Vector3& point, const Vector3& direction,
  double cameraLeg, double factor, double* value)
{
  const ExtinctionGroups& groups = this->Quadrature.Groups;
  const double source =
    factor * sample.Weight * EvaluatePhaseFunction(this->Quadrature.Air.Phase, Dot(sample.Direction, direction));
  const double depth = cameraLeg + this->DepthTowards(point, sample);
  for (int g = 0; g < groups.Count(); ++g)
  {
    value[g] += source * TransmittanceOver(groups.SigmaT[static_cast<std::size_t>(g)], depth);
  }
}

void LitProfiler::AddLightPoints(
  int level, const Vector3& point, const Vector3& direction, double cameraLeg, double factor, double* value)
{
  const LightRule& rule = this->Quadrature.Rules[static_cast<std::size_t>(level)];
  const Medium& medium = this->Quadrature.Air;
  const LightPoints points = rule.AreaPoints();
  const auto count = static_cast<std::size_t>(points.Count);
  this->Weights.resize(count);
  this->Cosines.resize(count);
  this->Legs.resize(count);
  LookAtLight(points, rule.ViewFrom(point, direction, medium.Bounds), this->Weights.data(), this->Cosines.data(),
    this->Legs.data());
  if (this->Quadrature.Legs)
  {
    const std::vector<float>& weights = this->Quadrature.NodeWeights[static_cast<std::size_t>(level)];
    LightLegs::MultiplyByMeans(this->Place, weights.data(), points.Count, this->Legs.data());
  }
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
  const bool isotropic = medium.Phase.Kind == PhaseFunctionKind::Isotropic;
  const double scale = isotropic ? factor * EvaluatePhaseFunction(medium.Phase, 1.0) : factor;
  for (std::size_t k = 0; k < count && !isotropic; ++k)
  {
    this->Weights[k] *= static_cast<float>(EvaluatePhaseFunction(medium.Phase, static_cast<double>(this->Cosines[k])));
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
