// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshData.h
 * @brief Meshes as poly data and composites of them: triangles, receivers, reflectances.
 */
#ifndef scMeshData_h
#define scMeshData_h

#include "ShadowConesDataModule.h"
#include "scMeshBlocks.h"
#include "scTriangleMesh.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace shadowcones
{

/// The polygons and strips of a mesh as triangles, in double precision; holds what TriangleMeshView points to.
struct SHADOWCONESDATA_EXPORT TriangleMesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<int> OccluderIds;           ///< per triangle, from 0, -1: a receiver; empty where the input has no ids
  std::vector<std::string> OccluderNames; ///< by id: the id or block name that was given; empty where there is none
  std::vector<vtkIdType> SourceCells;     ///< per triangle its cell of the input, counted on over all blocks
  std::vector<MeshBlock> Blocks;          ///< what it was read from; one for a poly data
  vtkIdType NumberOfCells = 0;            ///< of any kind that are there: neither hidden nor another rank's

  TriangleMeshView View() const;
  /// Index into Blocks of what has this point or this of the SourceCells.
  std::size_t BlockOfPoint(vtkIdType point) const;
  std::size_t BlockOfCell(vtkIdType cell) const;
};

/**
 * Read the polygons and strips of @p input as triangles; concave polygons and polygons with bridged holes are fine, lines
 * and vertices are ignored. Composite data are joined. Cells that "vtkGhostType" marks as duplicate or hidden, and cells
 * that use a hidden point, are not there.
 *
 * Ids: every value >= 0 of the cell array "OccluderId", of any numeric type, is a caster, below 0 a receiver. Occluders
 * are numbered from 0 in the order in which they are met, and OccluderNames has the ids as text. Where field array
 * "OccluderNames" names every id, as in what vtkLabelOccluders gives, both are taken as they are. Blocks without ids are an
 * occluder each.
 *
 * @return false, with a sentence in @p error that names the point that is not finite, the cell that uses a point that
 * is not there, that crosses itself or whose id is not a number, a cell array "OccluderId" of the wrong size, or the block
 * that is no surface. Empty input gives an empty mesh.
 */
SHADOWCONESDATA_EXPORT bool ReadTriangles(vtkDataObject* input, TriangleMesh& mesh, std::string& error);
/// The same triangles alone, without ids: of a light.
SHADOWCONESDATA_EXPORT bool ReadSurface(vtkPolyData* input, TriangleMesh& mesh, std::string& error);

/// Leave out the triangles of receivers, whose "OccluderId" is negative: they cast no shadow.
SHADOWCONESDATA_EXPORT void DropReceivers(TriangleMesh& mesh);

/// How much light each triangle throws back.
struct SurfaceReflectance
{
  int Components = 0;        ///< 0: the mesh does not say; 1, or one a wavelength
  std::vector<float> Values; ///< 0..1, of each triangle in turn
};

/**
 * Read the mesh's optional cell array "Reflectance"; triangles of blocks without one get @p missing.
 * @return false, with a sentence in @p error that names the wrong size or the cell whose value is not in 0..1.
 */
SHADOWCONESDATA_EXPORT bool ReadReflectance(const TriangleMesh& mesh, std::size_t wavelengths, double missing,
  SurfaceReflectance& reflectance, std::string& error);

/**
 * Read the mesh's optional point array "Normals", or else its active normals: 3 values a point, of any length, 0 for points of
 * blocks without; empty where no block has any.
 * @return false, with a sentence in @p error that names the wrong size or the point whose normal is not finite.
 */
SHADOWCONESDATA_EXPORT bool ReadPointNormals(
  const TriangleMesh& mesh, std::vector<float>& normals, std::string& error);

} // namespace shadowcones

#endif
