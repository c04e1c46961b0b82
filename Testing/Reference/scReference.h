// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scReference.h
 * @brief Slow, plain truth that every fast path is held against.
 *
 * It shares the plain structs of Core (mesh view, light, medium, camera, cone) and none of its code: own ray-triangle
 * test in double precision, own median-split tree, own independent random numbers (std::mt19937_64) and own light rule.
 */
#ifndef scReference_h
#define scReference_h

#include "scCamera.h"
#include "scCone.h"
#include "scDensityGrid.h"
#include "scLight.h"
#include "scMedium.h"
#include "scTriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Triangles in double precision under a median-split tree. Copies the mesh.
class ReferenceScene
{
public:
  explicit ReferenceScene(const TriangleMeshView& mesh);

  /// Distance of the nearest hit in (tMin, tMax) along a unit direction; infinity where there is none. @p normal, if
  /// given, receives the unit normal of what is hit, on the side of the ray.
  double Nearest(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
    Vector3* normal = nullptr) const;
  /// Is there any hit in (tMin, tMax)?
  bool Blocked(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const;
  /// Number of hits in (tMin, tMax), by a plain loop over all triangles.
  int CountHits(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const;

private:
  struct Node
  {
    std::array<double, 3> Min;
    std::array<double, 3> Max;
    int Begin = 0;  ///< leaf: first triangle
    int End = 0;    ///< leaf: one past the last; inner node: 0
    int Second = 0; ///< inner node: the second child; the first one follows its parent
  };
  int Build(int begin, int end);
  double Search(const Vector3& origin, const Vector3& direction, double tMin, double tMax, bool any, int& found) const;

  std::vector<std::array<Vector3, 3>> Triangles;
  std::vector<Node> Nodes;
};

/**
 * Visible fraction of the light from a point, by independent random points on it: uniform by area (Disc, Rectangle,
 * Mesh) or by the solid angle of the visible cap (Sphere, Sun). 0 where only the dark side faces the point.
 */
double ReferenceVisibility(
  const ReferenceScene& scene, const Light& light, const Vector3& x, int samples, std::uint64_t seed = 1);

/// One value per wavelength sample each.
struct ReferenceEstimate
{
  std::vector<double> Mean;
  std::vector<double> StandardError;
};

/**
 * Single scattering along the ray through the centre of pixel (i, j), up to the first surface: random positions on the
 * ray (a quarter of them uniform, the others equi-angular about the light), one independent random light point each,
 * attenuation on both legs over the length inside the medium, or over the density along it: trilinear values summed up
 * in steps of a quarter of a cell. Sixteen independent estimates give the standard error.
 */
ReferenceEstimate ReferenceInScattering(const ReferenceScene& scene, const Light& light, const Medium& medium,
  const Camera& camera, int i, int j, int width, int height, int samples, std::uint64_t seed = 1);

/// What several lights send: means add up, standard errors as independent ones do.
ReferenceEstimate operator+(const ReferenceEstimate& a, const ReferenceEstimate& b);

/**
 * Light that the first surface along the ray through the centre of pixel (i, j) sends to the camera: reflectance over pi
 * times the irradiance from @p samples independent random light points, attenuated on both legs. 0 where there is none.
 */
ReferenceEstimate ReferenceSurface(const ReferenceScene& scene, const Light& light, const Medium& medium,
  const Camera& camera, int i, int j, int width, int height, double reflectance, int samples, std::uint64_t seed = 1);

/// Optical depth of the segment from @p a to @p b in units of sigma_t: what lies in the bounds, times the density there.
double ReferenceDepth(const Medium& medium, const Vector3& a, const Vector3& b);

/// Density per steradian, written out again from the literature.
double ReferencePhaseFunction(const PhaseFunction& phase, double cosine);

/// Is the point inside the cone that is cut at @p length from its base?
bool ReferenceConeContains(const Cone& cone, const Vector3& point, double length);
/// First and last point of a ray inside a cone: @p samples points on [tMin, tMax], then bisection of both ends.
bool ReferenceConeInterval(const Cone& cone, double length, const Vector3& origin, const Vector3& direction,
  double tMin, double tMax, double& begin, double& end, int samples = 20000);

} // namespace shadowcones

#endif
