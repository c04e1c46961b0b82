// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLight.h
 * @brief Area lights: exact shapes, and sampling them by area or by solid angle, with densities and inverses.
 *
 * Emission is Lambertian and one-sided: a face emits along its normal, a sphere outward.
 */
#ifndef scLight_h
#define scLight_h

#include "ShadowConesCoreModule.h"
#include "scVector3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Values of the field array "LightShape".
enum class LightShape : int
{
  Disc = 0,
  Rectangle = 1,
  Sphere = 2,
  Point = 3,
  Sun = 4,
  Mesh = 5 ///< every polygon of the mesh emits along its normal; without polygons every vertex is a point light
};

struct Light
{
  LightShape Shape = LightShape::Disc;
  Vector3 Center;                  ///< unused by Sun and Mesh
  Vector3 Normal{ 0.0, 0.0, 1.0 }; ///< unit; Disc and Rectangle: emitting side; Sun: the way the light travels
  Vector3 AxisU{ 1.0, 0.0, 0.0 };  ///< Rectangle: from the centre to the middle of an edge (half an edge long)
  Vector3 AxisV{ 0.0, 1.0, 0.0 };  ///< Rectangle: as AxisU, for the neighbouring edge
  double Radius = 0.5;             ///< Disc, Sphere: world units; Sun: half of its angular diameter, radians
  /**
   * Per wavelength sample: radiance (W m^-2 sr^-1); for Point and a vertex of a Mesh radiant intensity (W sr^-1); for Sun
   * the irradiance of a plane that faces it (W m^-2), so that its angular diameter changes softness, not brightness.
   */
  std::vector<double> Spectrum;
  std::vector<std::array<Vector3, 3>> Triangles; ///< Mesh only
  std::vector<double> CumulativeArea;            ///< Mesh only: running sums of the triangles' areas; see PrepareLight
  std::vector<Vector3> Vertices;                 ///< Mesh without triangles only: point lights
};

/// Normalise Normal, fill CumulativeArea. @return nullptr, or what is wrong with the light (zero area, NaN, no normal).
SHADOWCONESCORE_EXPORT const char* PrepareLight(Light& light);

/// Emitting area in square units; 0 for Point, Sun and vertices.
SHADOWCONESCORE_EXPORT double LightArea(const Light& light);
/// True where the light has no position: rays towards it are parallel up to its angular radius.
inline bool IsAtInfinity(const Light& light)
{
  return light.Shape == LightShape::Sun;
}
/// Centre and radius of a sphere that holds the light (Sun: radius 0 at the origin).
SHADOWCONESCORE_EXPORT void LightBoundingSphere(const Light& light, Vector3& center, double& radius);

/**
 * A number that tells lights apart: a hash of what their shape uses of place, direction and size, not of their
 * spectrum. The same for -0 and 0.
 */
SHADOWCONESCORE_EXPORT std::uint64_t FingerprintOf(const Light& light);

/// A point on the light. Sun: Position is the unit vector towards the sampled point of its face.
struct LightSurfaceSample
{
  Vector3 Position;
  Vector3 Normal;
  double Density = 0.0; ///< per square unit (Point, vertices: 1 / number of points; Sun: per steradian)
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
  double Density = 0.0;  ///< per steradian; 0 where the light cannot be seen from the point
};

/**
 * Uniform by solid angle. Sphere and Sun: uniform cone. Rectangle: Urena, Fajardo and King (EGSR 2013). Disc: the spherical
 * ellipse of Guillen et al. (EGSR 2017), radial map, its azimuth inverted numerically to 1e-9. Mesh: by area, with the
 * density converted. Point: the one direction, Density 1.
 */
SHADOWCONESCORE_EXPORT LightDirectionSample SampleLightSolidAngle(
  const Light& light, const Vector3& from, double u, double v);
/// Density (per steradian) with which SampleLightSolidAngle draws @p direction; 0 where it cannot.
SHADOWCONESCORE_EXPORT double LightSolidAngleDensity(const Light& light, const Vector3& from, const Vector3& direction);
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
