// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeSlice.h
 * @brief The part of a cone between two heights, against rays. Internal to Core.
 */
#ifndef scConeSlice_h
#define scConeSlice_h

#include "scCone.h"
#include "scRay.h"
#include "scRayInterval.h"

namespace shadowcones
{

struct ConeSlice
{
  const Cone& Whole;
  double Tangent = 0.0; ///< of its half angle
  double Low = 0.0;     ///< heights above the base; the radius must not be negative between them
  double High = 0.0;

  /// The part of the ray inside; the direction may have any length. @return false where there is none.
  bool Intersect(const Ray& ray, const RayInterval& part, RayInterval& inside) const;
};

} // namespace shadowcones

#endif
