// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshData.h
 * @brief Meshes as poly data: triangles, receivers, reflectances.
 */
#ifndef scMeshData_h
#define scMeshData_h

#include "ShadowConesDataModule.h"
#include "scOccluderScene.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace shadowcones
{

/// A poly data's polygons and strips as triangles, in double precision; holds what TriangleMeshView points to.
struct SHADOWCONESDATA_EXPORT TriangleMesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<int> OccluderIds;       ///< per triangle; empty where the input has no cell array "OccluderId"
  std::vector<vtkIdType> SourceCells; ///< per triangle, the cell of the input that it comes from

  TriangleMeshView View() const;
};

/**
 * Read the polygons and strips of @p input as triangles; concave polygons are fine, lines and vertices are ignored.
 * @return false, with a sentence in @p error that names the point that is not finite, the cell that uses a point that
 * is not there, or a cell array "OccluderId" of the wrong size. Empty input gives an empty mesh.
 */
SHADOWCONESDATA_EXPORT bool ReadTriangles(vtkPolyData* input, TriangleMesh& mesh, std::string& error);

/// Leave out the triangles of receivers, whose "OccluderId" is negative: they cast no shadow.
SHADOWCONESDATA_EXPORT void DropReceivers(TriangleMesh& mesh);

/// How much light each triangle throws back.
struct SurfaceReflectance
{
  int Components = 0;        ///< 0: the mesh does not say; 1, or one a wavelength
  std::vector<float> Values; ///< 0..1, of each triangle in turn
};

/**
 * Read the mesh's optional cell array "Reflectance" for triangles that come from @p sourceCells.
 * @return false, with a sentence in @p error that names the wrong size or the cell whose value is not in 0..1.
 */
SHADOWCONESDATA_EXPORT bool ReadReflectance(vtkPolyData* mesh, const std::vector<vtkIdType>& sourceCells,
  std::size_t wavelengths, SurfaceReflectance& reflectance, std::string& error);

} // namespace shadowcones

#endif
