// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPrimaryHit.h
 * @brief The nearest surface on a camera ray. Internal to Core.
 */
#ifndef scPrimaryHit_h
#define scPrimaryHit_h

#include "scOccluderScene.h"
#include "scRay.h"

#include <cmath>
#include <cstdint>

namespace shadowcones
{

/// The nearest surface on a camera ray.
struct PrimaryHit
{
  double T = HUGE_VAL;     ///< distance; infinite where there is none
  vtkIdType Triangle = -1; ///< -1 where there is none
  /// The lights that are before the surface: bit k % 64 for the k-th.
  std::uint64_t LightsSeen = 0;

  bool HasSurface() const { return this->Triangle >= 0; }
};

/// The unit normal of the surface that a ray hits, on the ray's side.
inline Vector3 NormalTowards(const OccluderScene& occluders, const Ray& ray, const PrimaryHit& hit)
{
  const Vector3 normal = occluders.TriangleNormal(hit.Triangle);
  return Dot(normal, ray.Direction) > 0.0 ? -normal : normal;
}

/// What a single ray meets; of the lights nothing is said.
inline PrimaryHit NearestSurface(const OccluderScene& occluders, const Ray& ray)
{
  PrimaryHit hit;
  RayHit surface;
  if (occluders.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, surface))
  {
    hit.T = surface.T;
    hit.Triangle = surface.Triangle;
  }
  return hit;
}

} // namespace shadowcones

#endif
