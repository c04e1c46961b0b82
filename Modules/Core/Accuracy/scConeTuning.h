// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeTuning.h
 * @brief Choosing the parameters of a cone set from the photon paths alone (Hougs and Day, section 6.1).
 */
#ifndef scConeTuning_h
#define scConeTuning_h

#include "ShadowConesCoreModule.h"
#include "scConeSet.h"
#include "scLightExtent.h"
#include "scPhotonPathView.h"
#include "scShadowVectorView.h"
#include "scTeam.h"

#include <string>

namespace shadowcones
{

enum class ConeTuning : int
{
  Manual = 0,       ///< the options as they are
  Conservative = 1, ///< bounds: Leak + 0.05 cones per vector
  Preview = 2,      ///< the shadow itself: what of Lost and Leak does not cancel in 12 x 12 x 12 cells, where Lost equals Leak
  Soft = 3,         ///< surfels: 1 - intersection over union, where false positives equal false negatives
  Tight = 4         ///< bounds that a proof makes whole: lit share of the cones' light + 0.25 Leak, some 150 cones a light
};

struct ConeTuningResult
{
  ConeSetOptions Options;        ///< what to fit with
  double Objective = 0.0;        ///< of the options chosen, on the held-out paths; less is better
  double StartObjective = 0.0;   ///< of the recipe that the search started from
  double Leak = 0.0;             ///< blocked light outside the cones over all blocked light; Soft: missed share of blocked paths
  double Lost = 0.0;             ///< lit light inside the cones over all blocked light; Soft: lit paths caught over blocked paths
  int NumberOfFits = 0;
  /// Empty, or what the paths lack to learn from: Options are then those of bounds that need no paths, and nothing was measured.
  std::string Lacking;
};

/// Parameters for bounds that no photon path is needed for: large overlapping cones from the light's geometry, none left over.
SHADOWCONESCORE_EXPORT ConeSetOptions BoundsOptions(const ConeSetOptions& options);

/**
 * Hold a quarter of the photons out (those whose emission point and direction hash so), fit cones to the vectors of the
 * others, and measure the cones on the paths held out: first a recipe, then 24 parameter sets (Tight: 12) spread over the
 * useful ranges of p1, p3, p4 and the variance threshold, then steps from the best, for Preview of MaximumOverspill too. At most 40,000
 * vectors and 6,000 held-out paths are used; Preview and Soft search with at most 6,000 vectors and, where there are more,
 * measure the recipe and the best six again with up to 40,000. A path's light is its length inside the paths' bounds, grown by
 * half their diagonal (Preview: a quarter, in 8 samples).
 *
 * Vectors and paths of several lights, one extent each, are measured against the cones of their own light and share one
 * set of parameters. @p options gives what is not searched (NumberOfSectors, PlanarityThreshold). @return false where
 * aborted. Where the held-out paths are all lit, or for Preview and Soft all blocked, the result is BoundsOptions and says so.
 * The options found are to be fitted with
 * the same paths: Preview trims bases by them. @param workers processes that search together: each measures a share of the
 * parameter sets, then all know all.
 */
SHADOWCONESCORE_EXPORT bool TuneConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const std::vector<LightExtent>& lights, ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor,
  ConeTuningResult& result, Team* workers = nullptr);

/**
 * The measure that tuning minimises, for given options: what a comparison with other parameter sets needs. For Preview and
 * Soft the ExpansionFraction or RadiusScale that balances is chosen here and set in the result's options. Where Lacking is not
 * empty nothing was measured.
 */
SHADOWCONESCORE_EXPORT bool MeasureTuning(const ShadowVectorView& vectors, const PhotonPathView& paths,
  const std::vector<LightExtent>& lights, ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor,
  ConeTuningResult& result);

/// The same for one light.
inline bool TuneConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const LightExtent& light,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result)
{
  return TuneConeSet(vectors, paths, std::vector<LightExtent>{ light }, tuning, options, monitor, result);
}
inline bool MeasureTuning(const ShadowVectorView& vectors, const PhotonPathView& paths, const LightExtent& light,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result)
{
  return MeasureTuning(vectors, paths, std::vector<LightExtent>{ light }, tuning, options, monitor, result);
}

} // namespace shadowcones

#endif
