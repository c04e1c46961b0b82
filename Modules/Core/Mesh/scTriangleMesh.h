// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTriangleMesh.h
 * @brief A triangle mesh as Core sees it, its bounds, and which of its occluders are closed.
 */
#ifndef scTriangleMesh_h
#define scTriangleMesh_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "vtkType.h"

#include <vector>

namespace shadowcones
{

/// A triangle mesh, not owned. Points: 3 doubles each. Triangles: 3 point ids each.
struct TriangleMeshView
{
  const double* Points = nullptr;
  vtkIdType NumberOfPoints = 0;
  const vtkIdType* Triangles = nullptr;
  vtkIdType NumberOfTriangles = 0;
  const int* OccluderIds = nullptr; ///< one a triangle, or nullptr: all 0; negative: a receiver, it casts no vectors

  Vector3 Point(vtkIdType id) const
  {
    return { this->Points[3 * id], this->Points[3 * id + 1], this->Points[3 * id + 2] };
  }
  Vector3 Corner(vtkIdType triangle, int corner) const { return this->Point(this->Triangles[3 * triangle + corner]); }
  Box BoundsOf(vtkIdType triangle) const
  {
    Box bounds;
    for (int corner = 0; corner < 3; ++corner)
    {
      bounds.Add(this->Corner(triangle, corner));
    }
    return bounds;
  }
  int OccluderId(vtkIdType triangle) const { return this->OccluderIds ? this->OccluderIds[triangle] : 0; }
};

/// Bounds of the triangles' points.
SHADOWCONESCORE_EXPORT Box MeshBounds(const TriangleMeshView& mesh);
/// The same of the triangles that cast shadow: those whose occluder id is not negative.
SHADOWCONESCORE_EXPORT Box CasterBounds(const TriangleMeshView& mesh);

/**
 * For each triangle whether its occluder's triangles form a closed, consistently oriented surface: every edge is used as
 * often in one direction as in the other. Points with equal coordinates are one.
 */
SHADOWCONESCORE_EXPORT std::vector<bool> ClosedOccluders(const TriangleMeshView& mesh);

} // namespace shadowcones

#endif
