// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scProvedSet.h
 * @brief A fitted cone set made to hold all of the shadow, or cones around parts of the mesh in its place.
 */
#ifndef scProvedSet_h
#define scProvedSet_h

#include "ShadowConesCoreModule.h"
#include "scConeProof.h"
#include "scConeSet.h"
#include "scShadowVectorView.h"

#include <vector>

namespace shadowcones
{

/// Fitted cones against cones around parts of the mesh: how many, and how much space they hold.
struct ProofChoice
{
  bool TakesParts = false;
  bool FittedProved = true; ///< the figures are those of the fitted cones once proved; else before: a proof makes them no smaller
  std::size_t NumberOfFittedCones = 0;
  std::size_t NumberOfPartCones = 0;
  double FittedVolume = 0.0; ///< cubic world units
  double PartVolume = 0.0;
};

/**
 * Prove the cones of @p set, see ProveConeSet, or with @p choose take cones around parts of the mesh where they are tighter.
 * Vectors that no base took, and all where no cone was fitted, then belong to the first cone of their light that holds them.
 * @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ProveFittedSet(const TriangleMeshView& mesh, const std::vector<Light>& lights,
  const ShadowVectorView& vectors, bool choose, const Monitor& monitor, ConeSet& set, ConeProof& proof,
  ProofChoice& choice);

} // namespace shadowcones

#endif
