// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBoundingCone.h
 * @brief How deep a caster and its shadow lie inside a cone, and the cone around some of them. Internal to Core.
 *
 * A cone C of half angle 0 <= theta < pi/2 is convex, and closed under adding any vector that makes an angle of at most
 * theta with its axis. Behind t, in the hull of points t_i, the light from y, in the hull of points y_j, is missing at
 * t + s (t - y), s >= 0, and t - y is a mean of the t_i - y_j. Hence all of that shadow lies in C where every t_i does and
 * every t_i - y_j makes an angle of at most theta with the axis.
 */
#ifndef scBoundingCone_h
#define scBoundingCone_h

#include "scCone.h"
#include "scLightParts.h"
#include "scSinglePrecision.h"

#include <vector>

namespace shadowcones
{

/// Half angles of cones that are proved stay below this: wider ones hold half of space.
constexpr double largestProvedAngle = 1.5;
/// Angles to a light at infinity are held with this margin, radians.
constexpr double angularMargin = 1e-6;

/// A unit vector as readers see it that store it in single precision and normalise what they read; the same when it is stored again.
Vector3 StoredDirection(const Vector3& direction);

/// A cone with what asking it often needs.
class BoundingCone
{
public:
  explicit BoundingCone(const Cone& cone);

  /// Signed distance from the point to the cone's surface, from inside; where the cone converges it holds nothing.
  double Depth(const Vector3& point) const;
  /**
   * The same for the vectors from the points of the part to @p point, in the cone of directions. It lies between
   * ShadowDepthAtLeast and ShadowDepthAtMost, which cost less. All three change by no more than the point moves.
   */
  double ShadowDepth(const LightPart& part, const Vector3& point) const;
  double ShadowDepthAtLeast(const LightPart& part, const Vector3& point) const;
  double ShadowDepthAtMost(const LightPart& part, const Vector3& point) const;
  /// Does the cone hold a ball of @p margin around the point, and all its shadow?
  bool Holds(const LightPart& part, const Vector3& point, double margin) const;

private:
  double DirectionDepth(const Vector3& v) const;

  Vector3 Center;
  Vector3 Axis;
  double Radius;
  double Angle;
  double Sine;
  double Cosine;
};

/// Smallest half angle of a cone along @p axis that holds all directions from the part to the ball; above pi/2: none does.
double NeededAngle(const LightPart& part, const Vector3& axis, const Vector3& point, double margin);

/// A point that a cone has to hold, with the part of the light that it hides.
struct HeldPoint
{
  Vector3 Point;
  int Part = 0;
  double Margin = 0.0;
};

/**
 * A narrow cone that holds the points and their shadows: along the mean direction from the light, from the foremost point on.
 * With @p core the cone also holds that cone and keeps its axis. Values are as they are stored, in single precision. @return
 * false where it would be wider than largestProvedAngle.
 */
bool ConeAround(const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points, const Cone* core, Cone& cone);
/// The same along an axis of one's own.
bool ConeAlong(const Vector3& axis, const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points,
  const Cone* core, Cone& cone);

} // namespace shadowcones

#endif
