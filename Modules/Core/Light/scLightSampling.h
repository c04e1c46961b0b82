// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightSampling.h
 * @brief Points and directions of a light, by area or by solid angle, with their probability densities and inverses.
 */
#ifndef scLightSampling_h
#define scLightSampling_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"

#include <array>

namespace shadowcones
{

/// A point on the light. Sun: Position is the unit vector towards the sampled point of its face.
struct LightSurfaceSample
{
  Vector3 Position;
  Vector3 Normal;
  double Pdf = 0.0; ///< per square unit (Point, vertices: 1 / number of points; Sun: per steradian)
};

/// Uniform by area from (u, v) in [0, 1)^2. Discs use the concentric map of Shirley and Chiu (1997).
SHADOWCONESCORE_EXPORT LightSurfaceSample SampleLightArea(const Light& light, double u, double v);
/// The (u, v) that SampleLightArea maps to @p position (Disc, Rectangle, Sphere, Sun, Mesh; Point: 0.5, 0.5).
SHADOWCONESCORE_EXPORT std::array<double, 2> InvertLightArea(const Light& light, const Vector3& position);

/// A direction from a point towards the light.
struct LightDirectionSample
{
  Vector3 Direction;     ///< unit, from the point towards the light
  double Distance = 0.0; ///< to the light along Direction; infinity for Sun
  double Pdf = 0.0;      ///< per steradian; 0 where the light cannot be seen from the point
};

/**
 * Uniform by solid angle. Sphere and Sun: uniform cone. Rectangle: Urena, Fajardo and King (EGSR 2013). Disc: the spherical
 * ellipse of Guillen et al. (EGSR 2017), radial map, its azimuth inverted numerically to 1e-9. Mesh: by area, with the
 * density converted. Point: the one direction, Pdf 1.
 */
SHADOWCONESCORE_EXPORT LightDirectionSample SampleLightSolidAngle(
  const Light& light, const Vector3& from, double u, double v);
/// Probability density (per steradian) with which SampleLightSolidAngle draws @p direction; 0 where it cannot.
SHADOWCONESCORE_EXPORT double LightSolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction);
/// The (u, v) that SampleLightSolidAngle maps to @p direction.
SHADOWCONESCORE_EXPORT std::array<double, 2> InvertLightSolidAngle(
  const Light& light, const Vector3& from, const Vector3& direction);
/// Solid angle (sr) of the emitting side seen from a point, nothing in the way. Mesh: the faces that face the point.
SHADOWCONESCORE_EXPORT double LightSolidAngle(const Light& light, const Vector3& from);

/// What a light sample brings to a point: mean over samples of Weight * Spectrum = integral of L over directions.
struct IncidentSample
{
  Vector3 Direction;     ///< unit, from the point towards the light
  double Distance = 0.0; ///< infinity for Sun
  double Weight = 0.0;   ///< sr for area lights (Point: 1/d^2; Sun: 1); 0 on the dark side
};

enum class LightSampling
{
  Auto,      ///< by solid angle within two light radii of the light and always for Sphere and Sun, else by area
  Area,      ///< uniform on the light
  SolidAngle ///< uniform in the directions under which the light is seen
};

/// One sample for an estimate of incident light at a point. The hot path of the renderers: no allocation.
SHADOWCONESCORE_EXPORT IncidentSample SampleIncidentLight(
  const Light& light, const Vector3& from, double u, double v, LightSampling sampling = LightSampling::Auto);

/**
 * One sample for the *visible fraction* of the light: uniform by area (Disc, Rectangle, Mesh) or by the solid angle of the
 * visible cap (Sphere, Sun). Weight is 1 on the emitting side and 0 on the dark side.
 */
SHADOWCONESCORE_EXPORT IncidentSample SampleVisibleLight(const Light& light, const Vector3& from, double u, double v);

} // namespace shadowcones

#endif
