// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFrame.h
 * @brief Two unit vectors across an axis.
 */
#ifndef scFrame_h
#define scFrame_h

#include "scVector3.h"

#include <cmath>

namespace shadowcones
{

/// Two unit vectors that make a right-handed frame (U, V, axis) with a unit axis.
struct Frame
{
  Vector3 U;
  Vector3 V;
};

/// Branch-free frame of Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 2017).
inline Frame FrameAround(const Vector3& axis)
{
  const double sign = std::copysign(1.0, axis.Z);
  const double a = -1.0 / (sign + axis.Z);
  const double b = axis.X * axis.Y * a;
  return { { 1.0 + sign * axis.X * axis.X * a, sign * b, -sign * axis.X }, { b, sign + axis.Y * axis.Y * a, -axis.Y } };
}

} // namespace shadowcones

#endif
