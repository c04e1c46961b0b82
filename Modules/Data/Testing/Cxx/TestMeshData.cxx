// SPDX-License-Identifier: BSD-3-Clause
// Meshes: what is read, what is refused and in which words.
#include "scMeshData.h"

#include "scFieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

void SetPoints(vtkPolyData* data, const std::vector<double>& coordinates)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
  {
    points->InsertNextPoint(coordinates.data() + i);
  }
  data->SetPoints(points);
}

/// Area of triangles in the plane z = 0, negative where wound clockwise; every triangle must be wound alike.
double Area(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (vtkIdType t = 0; t < mesh.View().NumberOfTriangles; ++t)
  {
    const Vector3 a = mesh.View().Corner(t, 0);
    const double part = 0.5 * Cross(mesh.View().Corner(t, 1) - a, mesh.View().Corner(t, 2) - a).Z;
    EXPECT_GT(part, 0.0) << "triangle " << t;
    area += part;
  }
  return area;
}

} // namespace

TEST(MeshData, PolygonsAndStripsBecomeTriangles)
{
  // A concave quad, an L of six corners, a triangle and a strip, after a vertex and a line.
  for (const double far : { 0.0, 1e6 })
  {
    vtkNew<vtkPolyData> data;
    std::vector<double> coordinates = { 0, 0, 0, 2, 0, 0, 0.5, 0.5, 0, 0, 2, 0, // quad, area 1
      10, 0, 0, 12, 0, 0, 12, 1, 0, 11, 1, 0, 11, 2, 0, 10, 2, 0,               // L, area 3
      20, 0, 0, 21, 0, 0, 20, 1, 0, 21, 1, 0, 20, 2, 0 };                       // strip, area 1.5
    for (double& x : coordinates)
    {
      x += far;
    }
    SetPoints(data, coordinates);
    vtkNew<vtkCellArray> verts;
    verts->InsertNextCell({ 0 });
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    vtkNew<vtkCellArray> polys;
    polys->InsertNextCell({ 1, 2, 3, 0 });
    polys->InsertNextCell({ 4, 5, 6, 7, 8, 9 });
    vtkNew<vtkCellArray> strips;
    strips->InsertNextCell({ 10, 11, 12, 13, 14 });
    data->SetVerts(verts);
    data->SetLines(lines);
    data->SetPolys(polys);
    data->SetStrips(strips);
    AddIntArray(data->GetCellData(), "OccluderId", 1, { 90, 91, 5, -2, 8 });

    TriangleMesh mesh;
    std::string error;
    ASSERT_TRUE(ReadTriangles(data, mesh, error)) << error;
    EXPECT_NEAR(Area(mesh), 5.5, 1e-9);
    EXPECT_EQ(mesh.SourceCells, (std::vector<vtkIdType>{ 2, 2, 3, 3, 3, 3, 4, 4, 4 }));
    EXPECT_EQ(mesh.OccluderIds, (std::vector<int>{ 5, 5, -2, -2, -2, -2, 8, 8, 8 }));
  }
}

TEST(MeshData, DegeneratePolygonsKeepTheirCount)
{
  // Six corners on a line cannot be triangulated: a fan keeps n - 2 triangles, to be dropped by who minds.
  vtkNew<vtkPolyData> data;
  SetPoints(data, { 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 5, 0, 0 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  polys->InsertNextCell({ 0, 1 });
  data->SetPolys(polys);
  TriangleMesh mesh;
  std::string error;
  ASSERT_TRUE(ReadTriangles(data, mesh, error)) << error;
  EXPECT_EQ(mesh.SourceCells, std::vector<vtkIdType>(4, 0));
  EXPECT_TRUE(mesh.OccluderIds.empty());
}

TEST(MeshData, EmptyMeshIsEmpty)
{
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(vtkNew<vtkPolyData>(), mesh, error));
  EXPECT_EQ(mesh.View().NumberOfTriangles, 0);
  EXPECT_FALSE(ReadTriangles(nullptr, mesh, error));
  EXPECT_EQ(error, "There is no mesh.");
}

TEST(MeshData, MeshFaultsAreNamed)
{
  vtkNew<vtkPolyData> data;
  SetPoints(data, { NaN, 0, 0, 1, 0, 0, 0, 1, 0, 0, NaN, 0, 1, 1, 0 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 1, 2, 4 });
  data->SetPolys(polys);
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(data, mesh, error)) << "points that no polygon uses do no harm";

  polys->InsertNextCell({ 1, 2, 3 });
  EXPECT_FALSE(ReadTriangles(data, mesh, error));
  EXPECT_EQ(error, "Point 3, used by cell 1, has a coordinate that is not finite.");

  vtkNew<vtkCellArray> beyond;
  beyond->InsertNextCell({ 1, 2, 17 });
  data->SetPolys(beyond);
  EXPECT_FALSE(ReadTriangles(data, mesh, error));
  EXPECT_EQ(error, "Cell 0 uses point 17, but there are 5 points.");

  vtkNew<vtkCellArray> proper;
  proper->InsertNextCell({ 1, 2, 4 });
  data->SetPolys(proper);
  AddIntArray(data->GetCellData(), "OccluderId", 1, { 0, 0 });
  EXPECT_FALSE(ReadTriangles(data, mesh, error));
  EXPECT_EQ(error, "The array \"OccluderId\" of the mesh has 2 tuples where 1 are needed.");
}
