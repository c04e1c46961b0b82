// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBoxRay.h
 * @brief A ray that is to meet many boxes, as those of a tree. Internal to Core.
 */
#ifndef scBoxRay_h
#define scBoxRay_h

#include "scBox.h"

namespace shadowcones
{

/**
 * The ray as Box::Clip() takes it, with its divisions done once. A ray in the face of a box meets it, and rounding differs from
 * Clip(): for boxes that have some room.
 */
struct BoxRay
{
  BoxRay(const Vector3& origin, const Vector3& direction)
    : Origin(origin)
    , Inverse{ InverseOf(direction.X), InverseOf(direction.Y), InverseOf(direction.Z) }
  {
  }

  /// Cut [tMin, tMax] to the part inside the box; false where nothing is left.
  bool Clip(const Box& box, double& tMin, double& tMax) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = (box.Min[axis] - this->Origin[axis]) * this->Inverse[axis];
      const double b = (box.Max[axis] - this->Origin[axis]) * this->Inverse[axis];
      const double near = a < b ? a : b;
      const double far = a < b ? b : a;
      tMin = near > tMin ? near : tMin;
      tMax = far < tMax ? far : tMax;
    }
    return tMin <= tMax;
  }

  Vector3 Origin;
  Vector3 Inverse; ///< of the direction

private:
  /// A finite stand-in for 1 / 0: no NaN where a ray runs in the face of a box.
  static double InverseOf(double x) { return x != 0.0 ? 1.0 / x : 1e300; }
};

} // namespace shadowcones

#endif
