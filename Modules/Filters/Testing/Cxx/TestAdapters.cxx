// SPDX-License-Identifier: BSD-3-Clause
// Adapters: what they read, what they refuse and in which words.
#include "scAdapters.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
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

Cone ExampleCone()
{
  Cone cone;
  cone.Center = { 1e6 + 0.1, 2.0, 3.0 };
  cone.Axis = Normalized({ 1.0, 2.0, 3.0 });
  cone.BaseRadius = 0.25;
  cone.HalfAngle = -0.125;
  cone.InnerHalfAngle = -0.5;
  cone.Normal = Normalized({ 0.0, 2.0, 3.0 });
  cone.OccluderId = 7;
  cone.VectorCount = 31;
  cone.Planarity = 0.0625;
  cone.Overspill = 0.75;
  return cone;
}

std::string ConeError(vtkPolyData* data)
{
  std::vector<Cone> cones(3);
  std::string error;
  EXPECT_FALSE(ReadConeSet(data, cones, error));
  EXPECT_TRUE(cones.empty());
  return error;
}

/// Two cones in which one value of the second is replaced.
std::string ConeErrorWith(const char* array, int component, double value)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone(), ExampleCone() }, data);
  data->GetPointData()->GetArray(array)->SetComponent(1, component, value);
  return ConeError(data);
}

/// Two shadow vectors that are photon paths too.
void MakeVectors(vtkPolyData* data)
{
  SetVertices(data, { 1, 2, 3, 4, 5, 6 });
  AddFloatArray(data->GetPointData(), "Direction", 3, { 0, 0, -1, 0.6f, 0, 0.8f });
  AddDoubleArray(data->GetPointData(), "EmissionPoint", 3, { 0, 0, 9, 0.1, 0, 9 });
  AddIntArray(data->GetPointData(), "OccluderId", 1, { 3, 4 });
  AddIntArray(data->GetPointData(), "PathState", 1, { 0, 1 });
}

} // namespace

TEST(Adapters, PolygonsAndStripsBecomeTriangles)
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

TEST(Adapters, DegeneratePolygonsKeepTheirCount)
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

TEST(Adapters, EmptyMeshIsEmpty)
{
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(vtkNew<vtkPolyData>(), mesh, error));
  EXPECT_EQ(mesh.View().NumberOfTriangles, 0);
  EXPECT_FALSE(ReadTriangles(nullptr, mesh, error));
  EXPECT_EQ(error, "There is no mesh.");
}

TEST(Adapters, MeshFaultsAreNamed)
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

TEST(Adapters, ConeSetRoundTrip)
{
  const Cone cone = ExampleCone();
  vtkNew<vtkPolyData> data;
  WriteConeSet({ Cone{ {}, { 0, 0, 1 }, 1.0, 0.5, 0.25, { 0, 0, 1 }, 0, 1, 0.0, -1.0 }, cone }, data);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("Axis")));
  EXPECT_TRUE(vtkIntArray::SafeDownCast(data->GetPointData()->GetArray("OccluderId")));

  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  ASSERT_EQ(cones.size(), 2u);
  const Cone& read = cones[1];
  EXPECT_EQ(read.Center.X, cone.Center.X) << "positions keep double precision";
  EXPECT_NEAR(Dot(read.Axis, cone.Axis), 1.0, 1e-12);
  EXPECT_NEAR(Length(read.Axis), 1.0, 1e-15);
  EXPECT_NEAR(Dot(read.Normal, cone.Normal), 1.0, 1e-12);
  EXPECT_EQ(read.BaseRadius, cone.BaseRadius);
  EXPECT_EQ(read.HalfAngle, cone.HalfAngle);
  EXPECT_EQ(read.InnerHalfAngle, cone.InnerHalfAngle);
  EXPECT_EQ(read.OccluderId, cone.OccluderId);
  EXPECT_EQ(read.VectorCount, cone.VectorCount);
  EXPECT_EQ(read.Planarity, cone.Planarity);
  EXPECT_EQ(read.Overspill, cone.Overspill);
}

TEST(Adapters, ConeSetFallbacks)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  for (const char* name : { "InnerHalfAngle", "Normal", "OccluderId", "VectorCount", "Planarity", "Overspill" })
  {
    data->GetPointData()->RemoveArray(name);
  }
  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  EXPECT_EQ(cones[0].InnerHalfAngle, -0.125);
  EXPECT_EQ(cones[0].Normal.X, cones[0].Axis.X);
  EXPECT_EQ(cones[0].OccluderId, 0);
  EXPECT_EQ(cones[0].VectorCount, 0);
  EXPECT_EQ(cones[0].Overspill, -1.0);
  EXPECT_TRUE(ReadConeSet(vtkNew<vtkPolyData>(), cones, error));
  EXPECT_TRUE(cones.empty());
}

TEST(Adapters, ConeSetFaultsAreNamed)
{
  for (const char* name : { "Axis", "BaseRadius", "HalfAngle" })
  {
    vtkNew<vtkPolyData> data;
    WriteConeSet({ ExampleCone() }, data);
    data->GetPointData()->RemoveArray(name);
    EXPECT_EQ(ConeError(data), std::string("The cone set has no array \"") + name + "\".");
  }
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  AddFloatArray(data->GetPointData(), "Axis", 2, { 1, 0 });
  EXPECT_EQ(ConeError(data), "The array \"Axis\" of the cone set has 2 components where 3 are needed.");
  AddFloatArray(data->GetPointData(), "Axis", 3, { 1, 0, 0, 1, 0, 0 });
  EXPECT_EQ(ConeError(data), "The array \"Axis\" of the cone set has 2 tuples where 1 are needed.");
  EXPECT_EQ(ConeError(nullptr), "There is no cone set.");

  EXPECT_EQ(ConeErrorWith("Axis", 0, NaN), "The \"Axis\" of cone 1 is not finite.");
  EXPECT_EQ(ConeErrorWith("Axis", 0, 5.0).find("The \"Axis\" of cone 1 has the length 5.0"), 0u);
  EXPECT_EQ(ConeErrorWith("Normal", 1, NaN), "The \"Normal\" of cone 1 is not finite.");
  EXPECT_EQ(ConeErrorWith("BaseRadius", 0, -1.0),
    "The \"BaseRadius\" of cone 1 is -1.000000: it must be finite and not negative.");
  EXPECT_EQ(ConeErrorWith("BaseRadius", 0, NaN).find("The \"BaseRadius\" of cone 1 is "), 0u);
  for (const double angle : { 1.5709, -1.5709, NaN, HUGE_VAL })
  {
    EXPECT_EQ(ConeErrorWith("HalfAngle", 0, angle).find("The \"HalfAngle\" of cone 1 is "), 0u) << angle;
    EXPECT_EQ(ConeErrorWith("InnerHalfAngle", 0, angle).find("The \"InnerHalfAngle\" of cone 1 is "), 0u) << angle;
  }
  EXPECT_EQ(ConeErrorWith("Overspill", 0, NaN), "The \"Planarity\" or \"Overspill\" of cone 1 is not finite.");

  WriteConeSet({ ExampleCone() }, data);
  data->GetPoints()->SetPoint(0, 0.0, NaN, 0.0);
  EXPECT_EQ(ConeError(data), "The position of cone 0 is not finite.");
}

TEST(Adapters, AxesNearUnitAreNormalised)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  AddDoubleArray(data->GetPointData(), "Axis", 3, { 0.0, 0.0, 1.0009 });
  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  EXPECT_EQ(cones[0].Axis.Z, 1.0);
  AddDoubleArray(data->GetPointData(), "Axis", 3, { 0.0, 0.0, 1.0011 });
  EXPECT_FALSE(ReadConeSet(data, cones, error));
}

TEST(Adapters, ShadowVectors)
{
  vtkNew<vtkPolyData> data;
  MakeVectors(data);
  ShadowVectorArrays vectors;
  std::string error;
  ASSERT_TRUE(ReadShadowVectors(data, vectors, error, true)) << error;
  const ShadowVectorView view = vectors.View();
  EXPECT_EQ(view.Count, 2);
  EXPECT_EQ(view.Points[5], 6.0);
  EXPECT_EQ(view.Directions[3], 0.6f);
  EXPECT_EQ(view.EmissionPoints[3], 0.1);
  EXPECT_EQ(view.OccluderIds[1], 4);

  data->GetPointData()->RemoveArray("OccluderId");
  data->GetPointData()->RemoveArray("EmissionPoint");
  ASSERT_TRUE(ReadShadowVectors(data, vectors, error)) << error;
  EXPECT_EQ(vectors.View().OccluderIds, nullptr);
  EXPECT_EQ(vectors.View().EmissionPoints, nullptr);
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error, true));
  EXPECT_EQ(error, "The shadow-vector input has no array \"EmissionPoint\".");
  EXPECT_EQ(vectors.View().Count, 0);

  data->GetPointData()->GetArray("Direction")->SetComponent(1, 0, NaN);
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error));
  EXPECT_EQ(error, "The \"Direction\" of shadow vector 1 is not finite.");
  data->GetPointData()->RemoveArray("Direction");
  EXPECT_FALSE(ReadShadowVectors(data, vectors, error));
  EXPECT_EQ(error, "The shadow-vector input has no array \"Direction\".");
  EXPECT_TRUE(ReadShadowVectors(vtkNew<vtkPolyData>(), vectors, error, true));
  EXPECT_EQ(vectors.View().Count, 0);
}

TEST(Adapters, PhotonPaths)
{
  vtkNew<vtkPolyData> data;
  MakeVectors(data);
  PhotonPathArrays paths;
  std::string error;
  ASSERT_TRUE(ReadPhotonPaths(data, paths, error)) << error;
  EXPECT_EQ(paths.View().Count, 2);
  EXPECT_EQ(paths.View().States[1], 1);
  EXPECT_EQ(paths.View().EmissionPoints[2], 9.0);

  AddIntArray(data->GetPointData(), "PathState", 1, { 0, 2 });
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The \"PathState\" of photon path 1 is 2: it must be 0 (lit) or 1 (blocked).");
  data->GetPointData()->RemoveArray("PathState");
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The photon-path input has no array \"PathState\".");

  MakeVectors(data);
  data->GetPointData()->GetArray("EmissionPoint")->SetComponent(0, 2, NaN);
  EXPECT_FALSE(ReadPhotonPaths(data, paths, error));
  EXPECT_EQ(error, "The \"EmissionPoint\" of photon path 0 is not finite.");
}

TEST(Adapters, MonitorIsTheFilters)
{
  vtkNew<vtkSphereSource> filter;
  const Monitor monitor = MonitorOf(filter);
  monitor.Progress(0.375);
  EXPECT_EQ(filter->GetProgress(), 0.375);
  EXPECT_FALSE(monitor.IsAborted());
  filter->SetAbortExecute(1);
  EXPECT_TRUE(monitor.IsAborted());
}
