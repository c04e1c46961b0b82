// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFlatFace.h
 * @brief The plane of a flat lamp, and which triangles lie in it: these never hide the lamp.
 */
#ifndef scFlatFace_h
#define scFlatFace_h

#include "scSinglePrecision.h"
#include "scVector3.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

/// The plane of a lamp that emits to one side of it.
struct FlatFace
{
  bool IsFlat = false;
  Vector3 Center;
  Vector3 Normal; ///< unit, towards the side that is lit
  double Radius = 0.0;
};

/// By how much a coordinate in single precision may be off; 0 where the point is not one in single precision.
inline double SinglePrecisionRounding(const Vector3& p)
{
  return IsSinglePrecision(p.X) && IsSinglePrecision(p.Y) && IsSinglePrecision(p.Z)
    ? 0x1p-22 * std::max({ std::fabs(p.X), std::fabs(p.Y), std::fabs(p.Z) })
    : 0.0;
}

/**
 * Height over a lamp's plane up to which a point counts as lying in it: a millionth of its distance from the lamp's centre
 * (of the lamp's radius, where that is more), and what rounding to single precision makes of it, where its coordinates are
 * in single precision.
 */
inline double FlushTolerance(const FlatFace& face, const Vector3& point)
{
  return 1e-6 * std::max(Length(point - face.Center), face.Radius) + SinglePrecisionRounding(point);
}

/**
 * Does no corner of a triangle rise above the lamp's plane? Then it lies between no point of the lamp and no point that the
 * lamp shines on. This is the one rule for surfaces that are flush with a lamp: whoever asks for shadow of a lamp passes
 * such triangles by.
 */
inline bool IsFlush(const FlatFace& face, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto below = [&face](const Vector3& p)
  { return Dot(p - face.Center, face.Normal) <= FlushTolerance(face, p); };
  return face.IsFlat && below(a) && below(b) && below(c);
}

} // namespace shadowcones

#endif
