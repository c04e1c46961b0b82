// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowFootprint.h
 * @brief Where on a surface shadow begins and where umbra does: outlines and the areas between them.
 */
#ifndef scShadowFootprint_h
#define scShadowFootprint_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scShadowClass.h"
#include "scTriangleMesh.h"
#include "scVisibilityProbe.h"
#include "vtkType.h"

#include <array>
#include <vector>

namespace shadowcones
{

struct FootprintOptions
{
  double Spacing = 0.1;    ///< longest side of the triangles whose corners are asked, world units, above 0
  int Refinements = 2;     ///< times that triangles in which shadow begins or ends are cut in four, 0 and up
  bool PerOccluder = true; ///< each occluder's own shadow; else that of all together, with the occluder id -1
};

/// The surface that is looked at.
struct FootprintSurface
{
  TriangleMeshView Triangles;      ///< its occluder ids are not used
  const double* Normals = nullptr; ///< 3 a point, any length; light from below is no light; or nullptr
};

struct FootprintOutline
{
  int OccluderId = -1;
  ShadowClass Class = ShadowClass::Penumbra; ///< Penumbra: where the whole shadow begins; Umbra: where the umbra does
  bool Closed = true;
  std::vector<vtkIdType>
    Points; ///< in order, the shadow on the left where the surface faces the eye; closed: the first is not repeated
};

struct FootprintPolygon
{
  int OccluderId = -1;
  ShadowClass Class = ShadowClass::Penumbra; ///< Penumbra: without the umbra
  std::vector<vtkIdType> Points;
};

struct ShadowFootprints
{
  std::vector<double> Points;             ///< 3 each
  std::vector<FootprintOutline> Outlines; ///< by occluder and class
  std::vector<FootprintPolygon> Polygons;
  vtkIdType NumberOfPlaces = 0; ///< that were asked
};

/// Triangles that a surface of this size is cut into, about, by sides of this length.
SHADOWCONESCORE_EXPORT double CountFootprintTriangles(const TriangleMeshView& surface, double spacing);

/**
 * The surface is cut until no side is longer than Spacing; equal points with equal normals are one. Its corners are asked which
 * occluders hide samples of the light, and which hide all. Along sides whose ends differ the place is found by halving, so
 * that outlines lie on true edges there and are straight in between. Where the surface ends outlines follow its border. A
 * light of one sample has an umbra only.
 * @param probe of the one light, made with Outline; @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool FindShadowFootprints(const VisibilityProbe& probe, const FootprintSurface& surface,
  const FootprintOptions& options, const Monitor& monitor, ShadowFootprints& footprints);

} // namespace shadowcones

#endif
