// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightParts.h
 * @brief Convex parts of a light, and the casters in front of them. Internal to Core.
 */
#ifndef scLightParts_h
#define scLightParts_h

#include "scLight.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// A convex body that holds a part of a light. A part with halves is held by its halves too.
struct LightPart
{
  std::vector<Vector3> Points; ///< their convex hull holds the part; empty: the ball of Center and Radius does
  Vector3 Center;              ///< of a ball that holds the part; AtInfinity: the unit way that its light travels
  double Radius = 0.0;         ///< of that ball; AtInfinity: angular radius, radians
  bool AtInfinity = false;
  bool OneSided = false; ///< it shines to where Normal . (x - Center) > 0 alone
  Vector3 Normal;
  std::array<int, 2> Halves{ -1, -1 }; ///< indices of other parts, or -1

  /// A bound from below of the distance from a point to the part; infinity for a light at infinity.
  double Distance(const Vector3& point) const;
};

/// The whole light first; a mesh light is cut in halves down to its faces or vertices.
std::vector<LightPart> LightPartsOf(const Light& light);

/// A convex polygon of at most four corners.
struct Polygon
{
  std::array<Vector3, 4> Corners;
  int Count = 0;

  const Vector3* begin() const { return this->Corners.data(); }
  const Vector3* end() const { return this->Corners.data() + this->Count; }
};

/**
 * What of a triangle the part shines on: what lies over the plane of a one-sided part; nothing of a triangle inside a sphere;
 * else the triangle.
 */
Polygon InFrontOf(const LightPart& part, const std::array<Vector3, 3>& triangle);

} // namespace shadowcones

#endif
