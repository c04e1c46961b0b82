// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCone.h
 * @brief A truncated cone, and its geometry: the one place where it is computed.
 */
#ifndef scCone_h
#define scCone_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scVector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Values of the array "ConeOrigin".
enum class ConeOrigin : int
{
  Fitted = 0, ///< to shadow vectors
  Grown = 1,  ///< fitted, then made larger to hold parts of occluders with all their shadow
  Added = 2   ///< around parts of occluders
};

/// One cone: all points x with h = (x - Center) . Axis >= 0 and distance from the axis <= BaseRadius + h tan(HalfAngle).
struct Cone
{
  Vector3 Center;              ///< of the base disc
  Vector3 Axis;                ///< unit, away from the light
  double BaseRadius = 0.0;     ///< world units
  double HalfAngle = 0.0;      ///< outer half angle, radians, in (-pi/2, pi/2); negative: the cone converges to a tip
  double InnerHalfAngle = 0.0; ///< of the umbra of the base disc, radians; negative: the umbra contracts to a tip
  Vector3 Normal;              ///< unit, of the plane fitted to the vectors, on the side of Axis
  int OccluderId = -1;         ///< the occluder of most of its vectors
  int VectorCount = 0;         ///< vectors inside the base
  double Planarity = 0.0;      ///< rms distance of the vectors from the base plane over BaseRadius
  double Overspill = -1.0;     ///< share of lit photon paths among those through the base disc; -1: no paths were given
  int LightId = 0;             ///< of the light whose shadow it bounds
  ConeOrigin Origin = ConeOrigin::Fitted;
};

/// Half angles of cones stay below this (89.4 degrees), so that tan() is finite.
constexpr double LargestHalfAngle = 1.56;

/// @name Geometry of a cone whose radius grows by @p tangent a unit of height
///@{
/// Height of the tip of a cone that converges, where the radius is 0; infinite where it does not.
inline double TipHeight(double baseRadius, double tangent)
{
  return tangent < 0.0 ? -baseRadius / tangent : HUGE_VAL;
}
/// Radius at a height above the base, 0 beyond the tip.
inline double RadiusAt(double baseRadius, double tangent, double height)
{
  return std::max(0.0, baseRadius + height * tangent);
}
/// How far a disc across the unit vector @p axis reaches from its centre along each axis of the world.
inline Vector3 DiscExtent(const Vector3& axis, double radius)
{
  return { radius * std::sqrt(std::max(0.0, 1.0 - axis.X * axis.X)),
    radius * std::sqrt(std::max(0.0, 1.0 - axis.Y * axis.Y)),
    radius * std::sqrt(std::max(0.0, 1.0 - axis.Z * axis.Z)) };
}
/// Height of the box's farthest corner above the cone's base.
inline double HighestCorner(const Cone& cone, const Box& box)
{
  const Vector3 corner{ cone.Axis.X >= 0.0 ? box.Max.X : box.Min.X, cone.Axis.Y >= 0.0 ? box.Max.Y : box.Min.Y,
    cone.Axis.Z >= 0.0 ? box.Max.Z : box.Min.Z };
  return Dot(corner - cone.Center, cone.Axis);
}
///@}

/// @return true where the cone, cut at @p length from its base, holds the point.
SHADOWCONESCORE_EXPORT bool ConeContains(const Cone& cone, const Vector3& point, double length = HUGE_VAL);

/// A cone that holds a box, with a little to spare: with it as the only cone, whoever asks inside cones asks everywhere.
SHADOWCONESCORE_EXPORT Cone ConeAroundBox(const Box& box);

/// Cones that begin one base radius nearer to the light: points on a surface may lie just before the base fitted to it.
SHADOWCONESCORE_EXPORT std::vector<Cone> Lengthened(std::vector<Cone> cones);

/// The cones of each of @p count lights, in their order.
SHADOWCONESCORE_EXPORT std::vector<std::vector<Cone>> ConesOfLights(const std::vector<Cone>& cones, std::size_t count);

} // namespace shadowcones

#endif
