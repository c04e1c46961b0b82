// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLight.h
 * @brief Area lights: exact shapes. scLightSampling.h draws points and directions of them.
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

/// Points whose convex hull holds the light: none for spheres, Suns and meshes of many corners, whose bounding sphere does.
SHADOWCONESCORE_EXPORT std::vector<Vector3> LightHull(const Light& light);

} // namespace shadowcones

#endif
