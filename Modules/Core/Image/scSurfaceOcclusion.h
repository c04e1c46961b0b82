// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfaceOcclusion.h
 * @brief Which surface points need occlusion rays, and which a grid answers for. Internal to Core.
 */
#ifndef scSurfaceOcclusion_h
#define scSurfaceOcclusion_h

#include "scConeHierarchy.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"

#include <memory>

namespace shadowcones
{

/**
 * BruteForce traces from everywhere. Medium, Guided and Volume trace where a cone reaches the point, or, without cones,
 * where a vertex of the grid within a cell of it is marked; without both, from everywhere. Fast and Soft never trace.
 */
class SurfaceOcclusion
{
public:
  /// The scene must outlive it.
  SurfaceOcclusion(const ScatteringScene& scene, const ScatteringOptions& options);

  /// Can anything hide the light from a surface point? Where not, no ray is needed.
  bool NeedsRays(const Vector3& point) const;

  /// Soft: the fraction of the light that reaches a surface point, seen from the side of its unit normal; else 1.
  double VisibleFraction(const Vector3& point, const Vector3& normal) const;

private:
  bool NearMark(const Vector3& point) const;

  const ScatteringMode Mode;
  const VisibilityGrid* const Grid;
  std::unique_ptr<ConeHierarchy> Cones; ///< lengthened, over all surfaces
};

} // namespace shadowcones

#endif
