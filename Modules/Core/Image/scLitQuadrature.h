// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitQuadrature.h
 * @brief What unshadowed profiles of an image share, and how fine they are. Internal to Core.
 */
#ifndef scLitQuadrature_h
#define scLitQuadrature_h

#include "scExtinctionGroups.h"
#include "scLight.h"
#include "scLightRule.h"
#include "scLitIntervals.h"
#include "scLitProfileLayout.h"
#include "scMedium.h"
#include "scVector3.h"

#include <vector>

namespace shadowcones
{

class LightLegs;

/// How fine a profile is computed.
struct LitLevel
{
  int Panels = 0; ///< 0 .. NumberOfPanelLevels - 1
  int Rule = 0;   ///< 0 .. LightRule::NumberOfLevels - 1
};

/// What the profiles of an image share: quadrature rules of the light. The arguments must outlive it.
class LitQuadrature
{
public:
  static constexpr int NumberOfPanelLevels = 7; ///< 1, 2, 4 ... 64 panels of 8 nodes
  /// From behind so many mean free paths comes less than the smallest float.
  static constexpr double DeepestOpticalDepth = 120.0;

  LitQuadrature(const Light& light, const Medium& medium, const ExtinctionGroups& groups);

  const Light& Lamp;
  const Medium& Air;
  const ExtinctionGroups& Groups;
  LitProfileLayout Layout;
  std::vector<LightRule> Rules; ///< one a level
  LitIntervals Intervals;
  Vector3 Center;      ///< of the light
  double Radius = 0.0; ///< of the sphere around it
  double Extent = 0.0; ///< diagonal of the medium
  /// The largest extinction where the medium is dense: half of the cells lie close behind a ray's entry then. 0: it is
  /// not.
  double DenseSigmaT = 0.0;
  /// In a varying density: its means towards the light from a table, where one serves; it must outlive this.
  const LightLegs* Legs = nullptr;
  void UseTable(const LightLegs* legs);
  /// Of the table's nodes, for the points of every rule.
  std::vector<std::vector<float>> NodeWeights;
  /// The coarsest that is worth looking at.
  LitLevel FirstLevel() const;
};

} // namespace shadowcones

#endif
