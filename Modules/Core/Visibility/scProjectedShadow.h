// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scProjectedShadow.h
 * @brief The hard shadow of convex bodies as exact solids: silhouettes extruded, cut to a box.
 */
#ifndef scProjectedShadow_h
#define scProjectedShadow_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scLight.h"
#include "scTriangleMesh.h"

#include <array>
#include <string>
#include <vector>

namespace shadowcones
{

/// Closed surfaces of triangles, wound outward.
struct ProjectedShadow
{
  std::vector<Vector3> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
  vtkIdType NumberOfSolids = 0;
};

/// Is the light a point, or a Sun without width? Then shadows have no penumbra.
SHADOWCONESCORE_EXPORT bool HasHardShadows(const Light& light);

/**
 * The hard shadow of each connected part of a mesh: the part itself and all behind it, inside @p bounds (which must have a
 * volume). Faces that turn to the light stay, the others move away from it to beyond the bounds, quadrilaterals join the
 * two along the silhouette; then the faces of the bounds cut what lies outside and close it. Exact up to rounding where the part is a
 * closed convex body, or a flat convex sheet. Solids of several parts overlap where their shadows do: they are not united.
 *
 * @param light a point, or a Sun; its width, and all points but the first, are not looked at.
 * @return false, with a sentence in @p error that reads on from the name of the occluder, where a part is neither, or the light lies in it.
 */
SHADOWCONESCORE_EXPORT bool ProjectShadow(
  const TriangleMeshView& mesh, const Light& light, const Box& bounds, ProjectedShadow& shadow, std::string& error);

} // namespace shadowcones

#endif
