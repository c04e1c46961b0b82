// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConvexGap.h
 * @brief Is there a gap between two convex bodies? Internal to Core.
 */
#ifndef scConvexGap_h
#define scConvexGap_h

#include "scBox.h"
#include "scVector3.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace shadowcones
{

/// The convex hull of a few points.
template <std::size_t Count>
struct PointHull
{
  std::array<Vector3, Count> Points;

  Vector3 Middle() const { return this->Points[0]; }
  Vector3 Farthest(const Vector3& along) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k < Count; ++k)
    {
      best = Dot(this->Points[k], along) > Dot(this->Points[best], along) ? k : best;
    }
    return this->Points[best];
  }
};

/// A box along the axes by its middle.
struct BoxBody
{
  Vector3 Center;
  Vector3 Half;

  explicit BoxBody(const Box& box)
    : Center(box.Center())
    , Half(0.5 * box.Size())
  {
  }
  Vector3 Middle() const { return this->Center; }
  Vector3 Farthest(const Vector3& along) const
  {
    return this->Center +
      Vector3{ std::copysign(this->Half.X, along.X), std::copysign(this->Half.Y, along.Y),
        std::copysign(this->Half.Z, along.Z) };
  }
};

/// At most four points of the difference of two bodies: the nearest to the origin that their hull has.
class GapSimplex
{
public:
  void Add(const Vector3& point) { this->Points[this->Count++] = point; }
  bool Has(const Vector3& point) const
  {
    return std::any_of(this->Points.begin(), this->Points.begin() + this->Count,
      [&point](const Vector3& p) { return p.X == point.X && p.Y == point.Y && p.Z == point.Z; });
  }
  /// Keep the points that span the nearest place, which is @p nearest. @return false where the hull holds the origin.
  bool Reduce(Vector3& nearest);

private:
  void Keep(const std::array<int, 3>& which, int count);
  Vector3 ReduceSegment();
  Vector3 ReduceTriangle();

  std::array<Vector3, 4> Points;
  int Count = 0;
};

/**
 * True where a plane with a body on each side of it was found (Gilbert, Johnson and Keerthi 1988): that is then a fact, up to
 * rounding. Bodies that touch, or nearly, get false. Bodies have Farthest(along), their farthest point along a vector, and
 * Middle(), any of their points. @param across is tried as the plane's normal first, unless it is zero, and receives the one
 * that was found: of neighbours the same plane often does.
 */
template <typename First, typename Second>
bool AreApart(const First& first, const Second& second, Vector3& across, int mostSteps = 40)
{
  constexpr double leastGap = 1e-22; // squared, over the size of what is compared
  GapSimplex simplex;
  const Vector3 between = first.Middle() - second.Middle();
  Vector3 nearest = Dot(across, across) > 0.0 ? across : between;
  double size = Dot(between, between);
  if (!(Dot(nearest, nearest) > 0.0))
  {
    return false;
  }
  for (int step = 0; step < mostSteps; ++step)
  {
    const Vector3 point = first.Farthest(-nearest) - second.Farthest(nearest);
    const double along = Dot(point, nearest);
    const double squared = Dot(nearest, nearest);
    size = std::max(size, Dot(point, point));
    if (along > 0.0 && along * along > leastGap * squared * size)
    {
      across = nearest;
      return true;
    }
    if (simplex.Has(point))
    {
      return false;
    }
    simplex.Add(point);
    if (!simplex.Reduce(nearest) || !(Dot(nearest, nearest) > leastGap * size))
    {
      return false;
    }
  }
  return false;
}

template <typename First, typename Second>
bool AreApart(const First& first, const Second& second)
{
  Vector3 across;
  return AreApart(first, second, across);
}

} // namespace shadowcones

#endif
