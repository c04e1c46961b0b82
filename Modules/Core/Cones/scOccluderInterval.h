// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderInterval.h
 * @brief A part of a ray inside cones.
 */
#ifndef scOccluderInterval_h
#define scOccluderInterval_h

#include "scRayInterval.h"

namespace shadowcones
{

struct OccluderInterval : RayInterval
{
  int OccluderId = -1; ///< of the cone; -1 after merging over occluders
};

} // namespace shadowcones

#endif
