// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightExtent.h
 * @brief How far a light reaches, and the cones of shadow behind a disc before it.
 */
#ifndef scLightExtent_h
#define scLightExtent_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"
#include "scVector3.h"
#include "vtkType.h"

#include <vector>

namespace shadowcones
{

/// What cones need to know of a light.
struct LightExtent
{
  bool AtInfinity = false;       ///< a Sun: Radius is its angular radius, radians
  std::vector<Vector3> Extremes; ///< points whose convex hull holds the light; empty: the sphere of Center and Radius
  Vector3 Center;                ///< a Sun: the unit way that its light travels
  double Radius = 0.0;
};

/// The extent of an exact light shape.
SHADOWCONESCORE_EXPORT LightExtent LightExtentOf(const Light& light);
/// The extent that emission points (3 values each) span: the sphere around their bounds.
SHADOWCONESCORE_EXPORT LightExtent LightExtentOf(const double* emissionPoints, vtkIdType count);

/**
 * Half angles of the outer cone (the penumbra's bound) and of the inner one (the umbra) of a base disc under the light:
 * the largest (r + rho) / d and the smallest (r - rho) / d over the light's points, with rho their distance from the cone's
 * axis and d their height above the base.
 */
SHADOWCONESCORE_EXPORT void PenumbraAngles(const LightExtent& light, const Vector3& center, const Vector3& axis,
  double baseRadius, double& outer, double& inner);

} // namespace shadowcones

#endif
