// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSolidData.h
 * @brief Closed surfaces of shadows as poly data.
 */
#ifndef scSolidData_h
#define scSolidData_h

#include "ShadowConesDataModule.h"
#include "scMeshData.h"
#include "scProjectedShadow.h"
#include "scRegularGrid.h"
#include "scShadowField.h"
#include "scVisibilityGrid.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkCellArray;
class vtkFieldData;
class vtkPoints;
class vtkPolyData;

namespace shadowcones
{

/// What a surface bounds the shadow of: a light, and an occluder or -1 for all.
using SolidKey = std::pair<int, int>;

/// The surface between the points of a grid that are inside (1) and those that are not (0), crossing edges at their middle.
SHADOWCONESDATA_EXPORT GridSurface SurfaceBetween(const RegularGrid& grid, std::vector<unsigned char>& inside);

/// Collects closed surfaces, which are wound outward.
class SHADOWCONESDATA_EXPORT SolidBuilder
{
public:
  SolidBuilder();
  ~SolidBuilder();
  SolidBuilder(const SolidBuilder&) = delete;
  SolidBuilder& operator=(const SolidBuilder&) = delete;

  /// Contour the zero of a field that is negative inside; @p values is changed.
  void AddContour(const RegularGrid& grid, std::vector<float>& values, const SolidKey& key);
  void Add(const RegularGrid& grid, const GridSurface& surface, const SolidKey& key);
  void Add(const ProjectedShadow& shadow, const SolidKey& key);

  /// Did the last occluder with triangles have this id?
  bool EndsWith(int occluderId) const { return !this->OccluderIds.empty() && this->OccluderIds.back() == occluderId; }

  /// Points in double precision, triangles, cell data "OccluderId" and "LightId", and the field data.
  void Finish(vtkPolyData* output, vtkFieldData* fieldData);

private:
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, const SolidKey& key);

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  std::vector<int> OccluderIds;
  std::vector<int> LightIds;
};

/// The triangles of each occluder with the points that they use, by id in ascending order; with @p each off all of them, as -1.
SHADOWCONESDATA_EXPORT std::map<int, TriangleMesh> SplitOccluders(const TriangleMesh& mesh, bool each);

/// The box of a visibility volume.
SHADOWCONESDATA_EXPORT Box BoundsOf(const VisibilityGrid& grid);
/// A box around its vertices that are in shadow, a cell wider; empty where none is.
SHADOWCONESDATA_EXPORT Box ShadowOf(const VisibilityGrid& grid);

/// What a grid over the region would need that cannot be had; empty where it can.
SHADOWCONESDATA_EXPORT std::string CheckSolidRegion(const Box& region, int resolution);

} // namespace shadowcones

#endif
