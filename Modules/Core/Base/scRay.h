// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRay.h
 * @brief A ray: one type for camera rays, photons and rays towards the light.
 */
#ifndef scRay_h
#define scRay_h

#include "scVector3.h"

namespace shadowcones
{

struct Ray
{
  Vector3 Origin;
  Vector3 Direction; ///< unit
};

} // namespace shadowcones

#endif
