// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfacePatches.h
 * @brief Triangles that winding can spread over: how they hang together, and which way they are to be wound. Hides OpenMesh. Internal to Core.
 */
#ifndef scSurfacePatches_h
#define scSurfacePatches_h

#include "scOccluderTopology.h"
#include "scTriangleMesh.h"
#include "scUnitFrame.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Triangles that winding can spread over.
struct SurfacePatches
{
  std::vector<vtkIdType> Order;    ///< triangles, patch after patch, each next to an earlier one of its patch
  std::vector<vtkIdType> Begin;    ///< of each patch in Order, and the end
  std::vector<unsigned char> Flip; ///< for each triangle: wound against the first one of its patch

  std::size_t Count() const { return this->Begin.empty() ? 0 : this->Begin.size() - 1; }
};

/// For each side the one other side on the same edge, or -1 where there is none or more than one. Counts the edges.
std::vector<vtkIdType> PairSides(OccluderTopology& topology);

/// Spread winding; sides where it contradicts itself (a surface that cannot be oriented) are taken apart.
SurfacePatches SpreadWinding(const OccluderTopology& topology, std::vector<vtkIdType>& opposite);

/// For each patch 1 where it has no border.
std::vector<unsigned char> ClosedPatches(
  const OccluderTopology& topology, const std::vector<vtkIdType>& opposite, const SurfacePatches& patches);

/// Turn the triangles of each patch as they are to be wound, and count those that are flipped.
void OrientPatches(const TriangleMeshView& mesh, const UnitFrame& frame, const std::vector<unsigned char>& closed,
  SurfacePatches& patches, OccluderTopology& topology);

} // namespace shadowcones

#endif
