// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfacePoint.h
 * @brief Points on the surfaces of a scattering image, with the normals that they are shaded with. Internal to Core.
 */
#ifndef scSurfacePoint_h
#define scSurfacePoint_h

#include "scExtinctionGroups.h"
#include "scMediumOpticalDepth.h"
#include "scPrimaryHit.h"
#include "scRay.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"

#include <vector>

namespace shadowcones
{

/// A point on a surface, as a camera ray sees it.
struct SurfacePoint
{
  Vector3 Position; ///< a little above the surface: where rays to the light start
  Vector3 Facet;    ///< unit normals on the camera's side: of the triangle,
  Vector3 Normal;   ///< and of the surface that it stands for
  bool Inside = false;            ///< the medium
  std::vector<double> Throughput; ///< per wavelength: radiance at the camera over irradiance here
};

/// Makes the points; one a thread.
class SurfacePoints
{
public:
  /// Everything must outlive it; of the scene the light does not matter.
  SurfacePoints(const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups);

  /**
   * The point that a ray meets. Normals of the mesh, where it has some, are interpolated and turned to the camera's side;
   * the point is lifted from the triangle to the curved surface that the normals describe (Hanika, "Hacking the Shadow
   * Terminator", Ray Tracing Gems II, 2021): so the shadow that a body casts on itself ends where its curved shape's
   * does, not at the edges of triangles. Normals of no length, or below the triangle, are not used.
   */
  void Find(const Ray& ray, const PrimaryHit& hit, SurfacePoint& point) const;

private:
  void Smooth(vtkIdType triangle, SurfacePoint& point) const;

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const MediumOpticalDepth OpticalDepth;
};

} // namespace shadowcones

#endif
