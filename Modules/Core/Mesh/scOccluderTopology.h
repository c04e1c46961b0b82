// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderTopology.h
 * @brief Triangles as occluders: welded, without degenerate ones, wound outward, labelled. Hides OpenMesh.
 */
#ifndef scOccluderTopology_h
#define scOccluderTopology_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scTriangleMesh.h"

#include <vector>

namespace shadowcones
{

enum class OccluderLabel : int
{
  Component = 0, ///< triangles that share a point belong together
  Block = 1,     ///< one occluder a block
  Whole = 2      ///< all triangles are one occluder
};

struct OccluderTopologyOptions
{
  /// Distance within which points are one, as a share of the shortest edge at each of them (and no less than rounding of
  /// their coordinates); at least 0; 0: exact duplicates only.
  double WeldTolerance = 1e-9;
  OccluderLabel LabelBy = OccluderLabel::Component;
  bool Orient = true; ///< off: every triangle keeps its winding
};

struct OccluderTopology
{
  std::vector<vtkIdType> Points;          ///< for each point that is kept its index in the input, ascending
  std::vector<vtkIdType> Triangles;       ///< 3 indices into Points, wound as they are to be
  std::vector<vtkIdType> InputTriangles;  ///< for each triangle its index in the input, ascending
  std::vector<int> OccluderIds;           ///< one a triangle, in order of the first triangle; -1: a receiver
  std::vector<unsigned char> Closed;      ///< for each occluder 1 where its surface has no border

  vtkIdType WeldedPoints = 0;        ///< points that were replaced by an earlier one
  vtkIdType DegenerateTriangles = 0; ///< dropped: repeated points or no area
  vtkIdType DuplicateTriangles = 0;  ///< dropped: the same three points as an earlier one, wound either way
  vtkIdType FlippedTriangles = 0;
  vtkIdType NonManifoldEdges = 0; ///< of occluders: more than two triangles meet
  vtkIdType BoundaryEdges = 0;    ///< of occluders: only one triangle
};

/**
 * Build the topology of a mesh. Triangles with a negative occluder id are receivers: welded and cleaned, but they keep
 * their winding and get -1. With LabelBy = Block, @p blocks (one a triangle) must be given, and points of different
 * blocks are not welded; otherwise it is not read.
 *
 * Winding spreads over edges of exactly two triangles. A patch without border is turned so that its signed volume is
 * positive, any other so that the fewest triangles are flipped. Patches are closed by the half-edges of OpenMesh, in
 * which surfaces that touch along an edge or at a point are taken apart; surfaces that cannot be oriented are open.
 *
 * Deterministic, one thread, near-linear cost; about 200 bytes a triangle. Throws std::runtime_error where the bounds
 * are too large to be measured. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool BuildOccluderTopology(const TriangleMeshView& mesh, const int* blocks,
  const OccluderTopologyOptions& options, const Monitor& monitor, OccluderTopology& result);

} // namespace shadowcones

#endif
