// SPDX-License-Identifier: BSD-3-Clause
#include "scLitQuadrature.h"

#include "scDensityGrid.h"
#include "scLightLegs.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// A medium is dense that is more mean free paths across than this; panels that it takes at least, as a level.
constexpr double denseDepth = 16.0;
constexpr int densePanels = 3;

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
    smallest = groups.MeanScatteredRadiance[g] > 0.0 ? std::min(smallest, groups.SigmaT[g]) : smallest;
  }
  return medium.Density || !(smallest > 0.0) ? HUGE_VAL : LitQuadrature::DeepestOpticalDepth / smallest;
}
} // anonymous namespace

LitQuadrature::LitQuadrature(const Light& light, const Medium& medium, const ExtinctionGroups& groups)
  : Lamp(light)
  , Air(medium)
  , Groups(groups)
  , Intervals(light, medium.Bounds, DeepestLength(medium, groups))
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

void LitQuadrature::UseTable(const LightLegs* legs)
{
  this->Legs = legs;
  this->NodeWeights.clear();
  for (const LightRule& rule : this->Rules)
  {
    this->NodeWeights.push_back(legs ? legs->WeightsOf(rule) : std::vector<float>());
  }
}

LitLevel LitQuadrature::FirstLevel() const
{
  LitLevel level;
  level.Panels = this->DenseSigmaT > 0.0 ? densePanels : 0;
  return level;
}

} // namespace shadowcones
