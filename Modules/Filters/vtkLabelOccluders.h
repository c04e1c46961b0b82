// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLabelOccluders
 * @brief Make a mesh fit to cast shadows: clean triangles, wound outward, one id an occluder.
 *
 * Every filter that takes a mesh expects what this one gives: triangles with the cell array "OccluderId". In order:
 *
 * 1. Polygons and strips become triangles; concave polygons and polygons with bridged holes are fine. Lines and vertices
 *    are ignored. Cells that "vtkGhostType" marks as hidden or duplicate are not there.
 * 2. Points closer than WeldTolerance times the shortest edge at each of them become one, the earliest in input order, at
 *    its own place.
 * 3. Triangles with repeated points or without area are dropped, and so are triangles on the same three points as an
 *    earlier one (wound either way).
 * 4. Winding spreads over edges where exactly two triangles meet. Closed surfaces are turned outward (positive signed
 *    volume); open ones are made consistent by flipping the fewest triangles. Surfaces that touch along an edge of more
 *    than two triangles are oriented each for itself, so that a triangle alone between such edges keeps its winding.
 * 5. Occluders are numbered from 0 in order of their first triangle. See SetLabelBy().
 *
 * The half-edge structure is that of OpenMesh. Cost is near-linear: 70,000 triangles take about a tenth of a second.
 * All work is in double precision and lengths are measured against the triangles at hand: place and size do not matter.
 *
 * **Input 0**: any vtkDataSet, or composite data of them. Of data that are no vtkPolyData the outer surface is taken: the faces
 * that belong to one cell alone (hidden and duplicate cells are not there, so that what they hid is seen), and cells that are
 * faces; nonlinear faces become triangles. A triangle then has the id of its cell in "vtkOriginalCellIds" (id, cell data,
 * counted in each block), in place of an array of that name. Occluders that meet inside a volume have no wall between
 * them, and are open there. A block is a leaf of a multiblock, or one vtkPartitionedDataSet or vtkMultiPieceDataSet with all its pieces.
 * Cell and point arrays that all blocks have are passed on: a triangle gets its cell's values, a point those of the
 * earliest point welded into it. The point array "Normals" (or the active normals) is passed on too, turned where a
 * triangle was turned; a point stands once for each of its normals, so that sharp edges stay sharp. A cell array
 * "OccluderId" (1 component, any numeric type) marks receivers by negative values: walls and floors that catch shadows but
 * cast none. Its other values are ids of casters: they become names, and with LabelBy = Array occluders.
 *
 * **Output 0**: vtkPolyData, triangles, points in double precision. Cell data:
 * - "OccluderId" (int): from 0; -1 for receivers, which keep their winding and are in none of the edge counts.
 *
 * Field data, all of 1 component and, but for the last two, 1 value:
 * - "NumberOfOccluders" (id)
 * - "ExtractedSurfaces" (id): data sets that were no vtkPolyData, whose outer surface was taken
 * - "TriangulatedPolygons" (id): polygons of more than three corners, and strips
 * - "WeldedPoints" (id): points of polygons that were replaced by an earlier one
 * - "DroppedCells" (id): triangles of step 3, and polygons of fewer than three corners
 * - "IgnoredCells" (id): lines and vertices
 * - "FlippedTriangles" (id)
 * - "NonManifoldEdges" (id): edges where more than two triangles of occluders meet
 * - "BoundaryEdges" (id): edges of only one triangle of an occluder
 * - "OccluderClosed" (unsigned char, one value an occluder): 1 where its surface has no border and can be oriented
 *
 * - "OccluderNames" (string, one value an occluder): the id that was given to its triangles, as text, or the name of
 *   their block, or where there is neither its number; several names are joined by commas
 *
 * Piece requests are honoured: the whole mesh is read and labelled, and piece p of n gets triangles [N p / n, N (p + 1)
 * / n) with the whole mesh's ids and field data. Empty input (no cells, no points) gives empty output.
 *
 * @warning A cavity is a closed surface of its own and is turned outward too, like every other one.
 * @warning Dropping a triangle without area opens a surface that was closed only by it.
 *
 * @sa vtkShadowVectorFilter vtkCleanPolyData vtkPolyDataNormals
 */
#ifndef vtkLabelOccluders_h
#define vtkLabelOccluders_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace shadowcones
{
struct GivenMesh;
}

class SHADOWCONESFILTERS_EXPORT vtkLabelOccluders : public vtkPolyDataAlgorithm
{
public:
  static vtkLabelOccluders* New();
  vtkTypeMacro(vtkLabelOccluders, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// What makes one occluder.
  enum LabelByType
  {
    Automatic = 0, ///< Block for a multiblock or a collection, Component for anything else
    Component = 1, ///< triangles that share a point, also over the borders of blocks
    Block = 2,     ///< one occluder for each block that has triangles; points of different blocks are not welded
    Whole = 3,     ///< all triangles are one occluder
    Array = 4,     ///< one occluder for each id of a cell array; triangles of different ids share no point
    // Older spelling.
    AUTOMATIC = Automatic,
    COMPONENT = Component,
    BLOCK = Block,
    WHOLE = Whole,
    ARRAY = Array
  };

  ///@{
  /**
   * What makes one occluder. Array: the ids of the cell array that SetInputArrayToProcess() names, "OccluderId" unless
   * told. Default: Automatic.
   */
  vtkSetMacro(LabelBy, int);
  vtkGetMacro(LabelBy, int); ///< 0 Automatic, 1 Component, 2 Block, 3 Whole, 4 Array.
  /// Block for composite inputs, Component for anything else.
  void SetLabelByToAutomatic() { this->SetLabelBy(Automatic); }
  void SetLabelByToComponent() { this->SetLabelBy(Component); } ///< Triangles that share a point are one occluder.
  void SetLabelByToBlock() { this->SetLabelBy(Block); }         ///< Each block that has triangles is one occluder.
  void SetLabelByToWhole() { this->SetLabelBy(Whole); }         ///< All triangles are one occluder.
  void SetLabelByToArray() { this->SetLabelBy(Array); }         ///< Each id of the chosen cell array is one occluder.
  ///@}

  ///@{
  /**
   * Distance within which points are one, as a share of the shortest edge at each of the two points, so that nothing small
   * is lost next to something large; never less than rounding of their coordinates in double precision. 0: only points
   * with exactly the same coordinates. Default: 1e-9. Valid range: 0 to 0.1.
   */
  vtkSetMacro(WeldTolerance, double);
  /// Distance within which points are one, as a share of the shortest edge at each of them.
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /**
   * Turn triangles so that closed surfaces face outward and open ones are consistent. Off: every triangle keeps its
   * winding. Default: on.
   */
  vtkSetMacro(Orient, bool);
  vtkGetMacro(Orient, bool); ///< Whether closed surfaces are turned outward and open ones made consistent.
  /// Turn closed surfaces outward and make open ones consistent.
  vtkBooleanMacro(Orient, bool); ///< Every triangle keeps its winding.
  ///@}

protected:
  vtkLabelOccluders();
  ~vtkLabelOccluders() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLabelOccluders(const vtkLabelOccluders&) = delete;
  void operator=(const vtkLabelOccluders&) = delete;

  /// Check the parameters, read the mesh and label it. @return false, with a sentence in @p error.
  bool ReadInput(vtkDataObject* input, shadowcones::GivenMesh& given, std::string& error);

  int LabelBy = Automatic;
  double WeldTolerance = 1e-9;
  bool Orient = true;
};

#endif
