// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeSurface.h
 * @brief Cones as generator lines, cut for looking at.
 */
#ifndef scConeSurface_h
#define scConeSurface_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"

#include <vector>

namespace shadowcones
{

/// Where drawn cones end.
struct ConeCut
{
  enum class Kind : int
  {
    Length = 0, ///< at a height above the base
    Plane = 1,  ///< where the generators meet a plane
    Box = 2     ///< where the generators leave a box
  };
  Kind Where = Kind::Length;
  double Length = 1.0; ///< world units along the axis, > 0; also the longest that a plane or box may leave
  Vector3 PlaneOrigin;
  Vector3 PlaneNormal{ 0.0, 1.0, 0.0 };
  Box Bounds;
};

/// One straight line on a cone's surface.
struct ConeGenerator
{
  Vector3 Base;   ///< on the base's rim
  Vector3 End;    ///< where it is cut, or the tip of a converging cone
  Vector3 Normal; ///< unit, outward
};

/**
 * @p resolution generators around a cone that opens by @p halfAngle (its HalfAngle or InnerHalfAngle), evenly spaced;
 * @p generators is overwritten. Generators that run away from the plane end by Length alone; those that start outside the box have no length.
 */
SHADOWCONESCORE_EXPORT void ConeGenerators(const Cone& cone, double halfAngle, int resolution, const ConeCut& cut,
  std::vector<ConeGenerator>& generators);

} // namespace shadowcones

#endif
