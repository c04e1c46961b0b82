// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeIntervals.h
 * @brief Where a ray runs inside cones (Hougs and Day, section 3.3.1 and appendix A).
 */
#ifndef scConeIntervals_h
#define scConeIntervals_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scOccluderInterval.h"
#include "scRay.h"

#include <vector>

namespace shadowcones
{

/**
 * What of a part of a ray lies inside the cone, by the quadratic of appendix A for the truncated cone: base plane, only the sheet
 * ahead of it, cut at @p length from the base. A convex body, hence one interval. @return false where there is none.
 */
SHADOWCONESCORE_EXPORT bool IntersectCone(
  const Cone& cone, double length, const Ray& ray, const RayInterval& part, OccluderInterval& interval);

/// Sort intervals and merge those that touch; with @p perOccluder only within the same occluder.
SHADOWCONESCORE_EXPORT void MergeIntervals(std::vector<OccluderInterval>& intervals, bool perOccluder = false);

} // namespace shadowcones

#endif
