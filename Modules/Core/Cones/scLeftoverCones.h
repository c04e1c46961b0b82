// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLeftoverCones.h
 * @brief Cones for the shadow vectors that no base took (section 3.2.1 discards them). Internal to Core.
 */
#ifndef scLeftoverCones_h
#define scLeftoverCones_h

#include "scConeSet.h"
#include "scLightExtent.h"
#include "scShadowVectorView.h"

namespace shadowcones
{

/**
 * One cone for each vector that still has none, in index order: around it and its nearest vectors of the same occluder, as many
 * as make a cone, up to a gap; from the foremost of them on. All vectors in its base have a cone then. @return false where aborted.
 */
bool CoverLeftovers(const ShadowVectorView& vectors, const LightExtent& light, const ConeSetOptions& options,
  const Monitor& monitor, Team* workers, ConeSet& result);

} // namespace shadowcones

#endif
