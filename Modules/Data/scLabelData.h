// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLabelData.h
 * @brief A mesh as it is given to be labelled, and the labelled mesh: one occluder an id, with all its attributes.
 */
#ifndef scLabelData_h
#define scLabelData_h

#include "ShadowConesDataModule.h"
#include "scMeshData.h"
#include "scOccluderTopology.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace shadowcones
{

/// A mesh with what each triangle is labelled by.
struct SHADOWCONESDATA_EXPORT GivenMesh
{
  TriangleMesh Mesh;
  std::vector<int> Labels;             ///< one a triangle, of Names; empty: none was given
  std::vector<std::string> Names;      ///< by label
  std::vector<vtkIdType> SourcePoints; ///< of each point; empty: the same
  vtkIdType ExtractedSurfaces = 0; ///< data sets that were no poly data
  vtkIdType TriangulatedPolygons = 0;
  vtkIdType DroppedPolygons = 0; ///< fewer than three corners
  vtkIdType IgnoredCells = 0;
  bool HasCells = false; ///< hidden ones too

  vtkIdType SourcePoint(vtkIdType point) const
  {
    return this->SourcePoints.empty() ? point : this->SourcePoints[static_cast<std::size_t>(point)];
  }
};

/// Read a mesh, see ReadTriangles, and count its cells. @return false, with a sentence in @p error.
SHADOWCONESDATA_EXPORT bool ReadGivenMesh(vtkDataObject* input, GivenMesh& given, std::string& error);

/// Label by the ids that the mesh came with.
SHADOWCONESDATA_EXPORT void LabelByGiven(GivenMesh& given);
/// Label by its blocks.
SHADOWCONESDATA_EXPORT void LabelByBlock(GivenMesh& given);
/**
 * Label by a cell array of ids; below 0 are receivers, beside those of "OccluderId". Triangles of different labels share no
 * point then. @return false, with a sentence in @p error, where a block lacks the array or an id is not a number.
 */
SHADOWCONESDATA_EXPORT bool LabelByArray(const std::string& name, GivenMesh& given, std::string& error);

/// Triangles [begin, end) of the topology with their points and what came with them, and a report as field data.
SHADOWCONESDATA_EXPORT void WriteLabelledMesh(
  const GivenMesh& given, const OccluderTopology& topology, vtkIdType begin, vtkIdType end, vtkPolyData* output);

} // namespace shadowcones

#endif
