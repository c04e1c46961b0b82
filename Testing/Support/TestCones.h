// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestCones.h
 * @brief Cones by hand.
 */
#ifndef TestCones_h
#define TestCones_h

#include "scCone.h"

namespace shadowcones
{
namespace testsupport
{

/// A cone whose base is a disc across its axis.
inline Cone MakeCone(const Vector3& center, const Vector3& axis, double radius, double halfAngle, int occluder = -1)
{
  Cone cone;
  cone.Center = center;
  cone.Axis = axis;
  cone.Normal = axis;
  cone.BaseRadius = radius;
  cone.HalfAngle = halfAngle;
  cone.OccluderId = occluder;
  return cone;
}

} // namespace testsupport
} // namespace shadowcones

#endif
