// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTriangleCrossing.h
 * @brief Does a ray cross a triangle? In double precision, watertight. Internal to Core.
 */
#ifndef scTriangleCrossing_h
#define scTriangleCrossing_h

#include "scVector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{

/// The largest of the absolute values of a vector's components.
inline double LargestComponent(const Vector3& a)
{
  const double x = std::fabs(a.X);
  const double y = std::fabs(a.Y);
  const double z = std::fabs(a.Z);
  const double xy = x > y ? x : y;
  return xy > z ? xy : z;
}

/// A stretch of a ray that is asked for what it crosses.
struct RayStretch
{
  Vector3 Origin;
  Vector3 Direction;   ///< unit
  double Begin = 0.0;  ///< distances along the ray
  double End = 0.0;    ///< may be infinite
  /// Planes so near to the ray's begin, or end, in world units, are not crossed. See RayRules.
  double BeginTolerance = 0.0;
  double EndTolerance = 0.0;
};

/// A triangle from the corner between its two shorter edges, where its normal loses the fewest digits.
struct TriangleFrame
{
  TriangleFrame(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double ab = LargestComponent(b - a);
    const double bc = LargestComponent(c - b);
    const double ca = LargestComponent(a - c);
    const bool atA = bc >= ab && bc >= ca;
    const bool atB = !atA && ca >= ab;
    this->Corner = atA ? a : atB ? b : c;
    this->ToNext = (atA ? b : atB ? c : a) - this->Corner;
    this->ToLast = (atA ? c : atB ? a : b) - this->Corner;
    this->Normal = Cross(this->ToNext, this->ToLast);
  }

  Vector3 Corner;
  Vector3 ToNext; ///< edges
  Vector3 ToLast;
  Vector3 Normal; ///< twice the area long
};

/// Distance along a ray to the plane of a triangle; @p front: the ray runs against the triangle's normal.
inline double DistanceToPlane(const Vector3& origin, const Vector3& direction, const Vector3& a, const Vector3& b,
  const Vector3& c, bool& front)
{
  const TriangleFrame triangle(a, b, c);
  const double slope = Dot(triangle.Normal, direction);
  front = slope <= 0.0;
  return Dot(triangle.Normal, triangle.Corner - origin) / slope;
}

/**
 * Does the stretch cross the triangle with corners @p p0, @p p1, @p p2? Begin and end must lie on the two sides of its
 * plane, each farther from it than rounding and the tolerances of the stretch (but at most a thousandth of the triangle's
 * size). Rays through an edge or corner, up to rounding, cross all triangles that share it.
 */
inline bool Crosses(const RayStretch& ray, const Vector3& p0, const Vector3& p1, const Vector3& p2)
{
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  constexpr double largestTolerance = 1e-3;
  const TriangleFrame triangle(p0, p1, p2);
  Vector3 a = triangle.Corner - ray.Origin;
  const double slope = Dot(triangle.Normal, ray.Direction);
  const double height = slope > 0.0 ? Dot(triangle.Normal, a) : -Dot(triangle.Normal, a);
  const double way = std::fabs(slope);
  if (!(way > 0.0))
  {
    return false;
  }
  const double next = LargestComponent(triangle.ToNext);
  const double last = LargestComponent(triangle.ToLast);
  const double size = std::max(next, last);
  const double away = LargestComponent(a);
  // Seen from where the ray is nearest to the corner: far origins would cost digits.
  const double ahead = Dot(a, ray.Direction);
  const double far = std::fabs(ahead) + LargestComponent(ray.Origin);
  a = a - ahead * ray.Direction;
  const Vector3 b = a + triangle.ToNext;
  const Vector3 c = a + triangle.ToLast;
  // Of an edge function: of both its corners' distances, and of where the ray was moved to.
  const double fromA = LargestComponent(a);
  const double fromB = LargestComponent(b);
  const double fromC = LargestComponent(c);
  const double moved = 0.25 * far;
  const auto slackOf = [moved](double i, double j) { return 2.0 * rounding * (i * j + moved * (i + j)); };
  const double u = Dot(ray.Direction, Cross(b, c));
  const double v = Dot(ray.Direction, Cross(c, a));
  const double w = Dot(ray.Direction, Cross(a, b));
  const double slackU = slackOf(fromB, fromC);
  const double slackV = slackOf(fromC, fromA);
  const double slackW = slackOf(fromA, fromB);
  const bool below = u < -slackU || v < -slackV || w < -slackW;
  const bool above = u > slackU || v > slackV || w > slackW;
  if (below && above)
  {
    return false;
  }
  const double length = Length(triangle.Normal);
  const double slack = rounding * (next * last * away + length * LargestComponent(ray.Origin));
  const double largest = largestTolerance * size;
  return height - ray.Begin * way > slack + length * std::min(ray.BeginTolerance, largest) &&
    ray.End * way - height > slack + length * std::min(ray.EndTolerance, largest);
}

} // namespace shadowcones

#endif
