// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibleLight.h
 * @brief The light as the camera sees it: its exact shape against a ray. Internal to Core.
 */
#ifndef scVisibleLight_h
#define scVisibleLight_h

#include "scLight.h"
#include "scOccluderScene.h"

#include <memory>
#include <vector>

namespace shadowcones
{

/// Point lights and vertices are never seen; faces are seen from their emitting side only.
class VisibleLight
{
public:
  explicit VisibleLight(const Light& light);

  /**
   * Does the ray meet the light at a distance below @p tMax? @p t receives the distance (Sun: infinity), @p scale what
   * the light's spectrum is multiplied by to give radiance.
   */
  bool Intersect(const Vector3& origin, const Vector3& direction, double tMax, double& t, double& scale) const;

private:
  bool IntersectShape(const Vector3& origin, const Vector3& direction, double tMax, double& t) const;

  const Light& Lamp;
  double Scale = 1.0;
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::unique_ptr<OccluderScene> Faces; ///< Mesh only
};

} // namespace shadowcones

#endif
