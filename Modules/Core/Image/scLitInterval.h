// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitInterval.h
 * @brief The part of a camera ray in the medium that the light can reach. Internal to Core.
 */
#ifndef scLitInterval_h
#define scLitInterval_h

#include "scRayInterval.h"

namespace shadowcones
{

/**
 * The part of a camera ray in the medium that the light can reach and the camera can see: inside the box, not too deep,
 * on the side to which a flat light emits, outside of a sphere.
 */
struct LitInterval : RayInterval
{
  double MediumBegin = 0.0; ///< where the ray enters the box: attenuation counts from here
  bool HasGap = false;      ///< a sphere that emits lies in between
  double HalfGap = 0.0;     ///< half the length in it, about the ray's point nearest to its centre
  int Faces = -1;           ///< the same number: neighbouring rays change smoothly from one to the other; -1: no part
};

} // namespace shadowcones

#endif
