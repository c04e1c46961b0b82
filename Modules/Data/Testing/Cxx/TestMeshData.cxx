// SPDX-License-Identifier: BSD-3-Clause
// Meshes: what is read, what is refused and in which words.
#include "scMeshData.h"

#include "scFieldArrays.h"
#include "scOccluderNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
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

/// Squares of area 1 in a row along x, each with points of its own.
vtkSmartPointer<vtkPolyData> Squares(int count, double first = 0.0)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::vector<double> coordinates;
  vtkNew<vtkCellArray> polys;
  for (int k = 0; k < count; ++k)
  {
    const double x = first + 2.0 * k;
    coordinates.insert(coordinates.end(), { x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0 });
    const vtkIdType p = 4 * k;
    polys->InsertNextCell({ p, p + 1, p + 2, p + 3 });
  }
  SetPoints(data, coordinates);
  data->SetPolys(polys);
  return data;
}

template <typename ArrayT, typename T>
void SetIds(vtkPolyData* data, const std::vector<T>& ids)
{
  vtkNew<ArrayT> array;
  array->SetName("OccluderId");
  for (const T id : ids)
  {
    array->InsertNextValue(id);
  }
  data->GetCellData()->AddArray(array);
}

TriangleMesh ReadMesh(vtkDataObject* input)
{
  TriangleMesh mesh;
  std::string error;
  EXPECT_TRUE(ReadTriangles(input, mesh, error)) << error;
  return mesh;
}

std::string ErrorOf(vtkDataObject* input)
{
  TriangleMesh mesh;
  std::string error;
  EXPECT_FALSE(ReadTriangles(input, mesh, error));
  return error;
}

/// Marks of cells or points, the others 0.
void SetGhosts(vtkDataSetAttributes* data, vtkIdType count, std::map<vtkIdType, unsigned char> marks)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(marks[i]);
  }
  data->AddArray(array);
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
    EXPECT_EQ(mesh.OccluderIds, (std::vector<int>{ 0, 0, -1, -1, -1, -1, 1, 1, 1 }));
    EXPECT_EQ(mesh.OccluderNames, (std::vector<std::string>{ "5", "8" }));
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

TEST(MeshData, IdsOfEveryTypeAreNumberedFromZero)
{
  // In the order in which they are met; whole numbers of 64 bits to the last digit; below 0 are receivers.
  const auto mesh = Squares(5);
  const std::vector<int> numbers{ 0, 0, 1, 1, -1, -1, 0, 0, 2, 2 };
  SetIds<vtkTypeInt64Array, std::int64_t>(mesh, { 9007199254740993, 2402018120, -7, 9007199254740993, 7 });
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, numbers);
  EXPECT_EQ(ReadMesh(mesh).OccluderNames, (std::vector<std::string>{ "9007199254740993", "2402018120", "7" }));
  SetIds<vtkTypeUInt64Array, std::uint64_t>(mesh, { 18446744073709551615u, 3000000000u, 5, 18446744073709551614u, 0 });
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, (std::vector<int>{ 0, 0, 1, 1, 2, 2, 3, 3, 4, 4 }));
  EXPECT_EQ(ReadMesh(mesh).OccluderNames,
    (std::vector<std::string>{ "18446744073709551615", "3000000000", "5", "18446744073709551614", "0" }));
  SetIds<vtkDoubleArray, double>(mesh, { 4e9, 2.5, -0.5, 4e9, 2.25 });
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, numbers);
  EXPECT_EQ(ReadMesh(mesh).OccluderNames, (std::vector<std::string>{ "4000000000", "2.5", "2.25" }));
  SetIds<vtkSignedCharArray, signed char>(mesh, { 100, 3, -128, 100, 4 });
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, numbers);
  SetIds<vtkFloatArray, float>(mesh, { 1.0f, 2.0f, -1.0f, 1.0f, static_cast<float>(NaN) });
  EXPECT_EQ(
    ErrorOf(mesh), "The \"OccluderId\" of cell 4 is not a number: it must be 0 or above, or below 0 for a receiver.");
  mesh->GetCellData()->RemoveArray("OccluderId");
  vtkNew<vtkStringArray> words;
  words->SetName("OccluderId");
  words->SetNumberOfValues(5);
  mesh->GetCellData()->AddArray(words);
  EXPECT_EQ(ErrorOf(mesh), "The array \"OccluderId\" of the mesh is not numeric.");
  AddIntArray(mesh->GetCellData(), "OccluderId", 1, {});
  EXPECT_EQ(ErrorOf(mesh), "The array \"OccluderId\" of the mesh has 0 tuples where 5 are needed.");
  AddIntArray(mesh->GetCellData(), "OccluderId", 2, std::vector<int>(10, 0));
  EXPECT_EQ(ErrorOf(mesh), "The array \"OccluderId\" of the mesh has 2 components where 1 are needed.");
}

TEST(MeshData, NamedIdsStayAsTheyAre)
{
  const auto mesh = Squares(3);
  AddIntArray(mesh->GetCellData(), "OccluderId", 1, { 3, -1, 1 });
  const std::vector<std::string> names{ "roof", "wall", "door", "tree" };
  WriteOccluderNames(names, mesh->GetFieldData());
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, (std::vector<int>{ 3, 3, -1, -1, 1, 1 }));
  EXPECT_EQ(ReadMesh(mesh).OccluderNames, names);
  // Names that do not reach stand for nothing.
  AddIntArray(mesh->GetCellData(), "OccluderId", 1, { 4, -1, 1 });
  EXPECT_EQ(ReadMesh(mesh).OccluderIds, (std::vector<int>{ 0, 0, -1, -1, 1, 1 }));
  EXPECT_EQ(ReadMesh(mesh).OccluderNames, (std::vector<std::string>{ "4", "1" }));
  WriteOccluderNames({}, mesh->GetFieldData());
  EXPECT_TRUE(ReadOccluderNames(mesh->GetFieldData()).empty());
}

TEST(MeshData, BlocksAreJoined)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Squares(2, 100.0));
  inner->SetBlock(1, vtkNew<vtkPolyData>());
  inner->SetBlock(2, nullptr);
  inner->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "roof");
  vtkNew<vtkMultiPieceDataSet> pieces;
  pieces->SetPiece(0, Squares(1, 200.0));
  pieces->SetPiece(1, Squares(1, 300.0));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Squares(1));
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, pieces);
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "wall");
  const TriangleMesh mesh = ReadMesh(blocks);
  EXPECT_DOUBLE_EQ(Area(mesh), 5.0);
  EXPECT_EQ(mesh.OccluderIds, (std::vector<int>{ 0, 0, 1, 1, 1, 1, 3, 3, 3, 3 }));
  EXPECT_EQ(mesh.OccluderNames, (std::vector<std::string>{ "0", "roof", "2", "wall" }));
  EXPECT_EQ(mesh.SourceCells, (std::vector<vtkIdType>{ 0, 0, 1, 1, 2, 2, 3, 3, 4, 4 }));
  EXPECT_EQ(mesh.Blocks[mesh.BlockOfCell(4)].Label(), "3 (\"wall\")");

  // An id is the same occluder in every block; blocks without ids are one each.
  AddIntArray(vtkPolyData::SafeDownCast(inner->GetBlock(0))->GetCellData(), "OccluderId", 1, { 8, 9 });
  AddIntArray(vtkPolyData::SafeDownCast(pieces->GetPieceAsDataObject(0))->GetCellData(), "OccluderId", 1, { 9 });
  EXPECT_EQ(ReadMesh(blocks).OccluderIds, (std::vector<int>{ 0, 0, 1, 1, 2, 2, 2, 2, 4, 4 }));
  EXPECT_EQ(ReadMesh(blocks).OccluderNames, (std::vector<std::string>{ "0", "8", "9", "2", "wall" }));

  vtkNew<vtkPartitionedDataSetCollection> collection;
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Squares(1));
  parts->SetPartition(1, Squares(1));
  collection->SetPartitionedDataSet(0, parts);
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "gate");
  EXPECT_EQ(ReadMesh(collection).OccluderNames, std::vector<std::string>{ "gate" });
  EXPECT_EQ(ReadMesh(collection).OccluderIds, std::vector<int>(4, 0));
  EXPECT_EQ(ReadMesh(vtkNew<vtkMultiBlockDataSet>()).View().NumberOfTriangles, 0);
}

TEST(MeshData, BlocksThatAreNoSurfaceAreNamed)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Squares(1));
  blocks->SetBlock(1, vtkNew<vtkImageData>());
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "smoke");
  EXPECT_EQ(ErrorOf(blocks),
    "Block 1 (\"smoke\") is a vtkImageData: every block must be a vtkPolyData. Run vtkDataSetSurfaceFilter on it "
    "first, or take it out.");
  const auto wires = Squares(1);
  wires->SetLines(wires->GetPolys());
  wires->SetPolys(vtkNew<vtkCellArray>());
  blocks->SetBlock(1, wires);
  EXPECT_EQ(ErrorOf(blocks), "Block 1 (\"smoke\"): It has 1 cells and no polygon, and is no surface: take it out.");
}

TEST(MeshData, HiddenAndDuplicateCellsAreNotThere)
{
  const auto mesh = Squares(6);
  AddIntArray(mesh->GetCellData(), "OccluderId", 1, { 0, 1, 2, 3, 4, 5 });
  SetGhosts(mesh->GetCellData(), 6,
    { { 1, vtkDataSetAttributes::HIDDENCELL }, { 2, vtkDataSetAttributes::DUPLICATECELL },
      { 3, vtkDataSetAttributes::EXTERIORCELL } });
  // A cell with a hidden corner is hidden, wherever that lies; a duplicate point is a point.
  SetGhosts(mesh->GetPointData(), 24,
    { { 17, vtkDataSetAttributes::HIDDENPOINT }, { 0, vtkDataSetAttributes::DUPLICATEPOINT } });
  mesh->GetPoints()->SetPoint(17, NaN, NaN, NaN);
  const TriangleMesh read = ReadMesh(mesh);
  EXPECT_DOUBLE_EQ(Area(read), 3.0);
  EXPECT_EQ(read.NumberOfCells, 3);
  EXPECT_EQ(read.SourceCells, (std::vector<vtkIdType>{ 0, 0, 3, 3, 5, 5 }));
  EXPECT_EQ(read.OccluderNames, (std::vector<std::string>{ "0", "3", "5" }));
}

TEST(MeshData, APolygonThatCrossesItselfIsNamed)
{
  vtkNew<vtkPolyData> data;
  SetPoints(data, { 0, 0, 0, 2, 1, 0, 2, 0, 0, 0, 1.5, 0 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 2, 1 });
  polys->InsertNextCell({ 0, 1, 2, 3 });
  data->SetPolys(polys);
  EXPECT_EQ(ErrorOf(data),
    "Cell 1, a polygon of 4 corners, crosses itself or goes round a place twice: it has no one area. Cut it into "
    "simple "
    "polygons.");
}

TEST(MeshData, NormalsOfBlocks)
{
  const auto square = [](float x)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    SetPoints(data, { x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0 });
    vtkNew<vtkCellArray> polys;
    polys->InsertNextCell({ 0, 1, 2, 3 });
    data->SetPolys(polys);
    return data;
  };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, square(0.0f));
  auto second = square(2.0f);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int k = 0; k < 4; ++k)
  {
    normals->InsertNextTuple3(k, 0.0, 2.0);
  }
  TriangleMesh mesh;
  std::vector<float> values{ 1.0f };
  std::string error;
  blocks->SetBlock(1, second);
  ASSERT_TRUE(ReadTriangles(blocks, mesh, error));
  ASSERT_TRUE(ReadPointNormals(mesh, values, error));
  EXPECT_TRUE(values.empty()) << "no block has any";

  second->GetPointData()->AddArray(normals);
  ASSERT_TRUE(ReadTriangles(blocks, mesh, error));
  ASSERT_TRUE(ReadPointNormals(mesh, values, error));
  const std::vector<float> expected{ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 2, 2, 0, 2, 3, 0, 2 };
  EXPECT_EQ(values, expected) << "none of the first block";
  normals->SetName("Active");
  second->GetPointData()->SetNormals(normals);
  ASSERT_TRUE(ReadPointNormals(mesh, values, error));
  EXPECT_EQ(values, expected);

  normals->SetComponent(2, 1, NaN);
  EXPECT_FALSE(ReadPointNormals(mesh, values, error));
  EXPECT_EQ(error, "Point array \"Normals\" of the mesh is not finite at point 2.");
  normals->SetNumberOfTuples(3);
  EXPECT_FALSE(ReadPointNormals(mesh, values, error));
  EXPECT_EQ(error,
    "Point array \"Normals\" of the mesh has 3 tuples of 3 components for 4 points: it must have 3 components and one "
    "tuple a point.");
}

TEST(MeshData, ReflectanceOfBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int k = 0; k < 3; ++k)
  {
    blocks->SetBlock(static_cast<unsigned int>(k), Squares(1, 10.0 * k));
  }
  AddDoubleArray(vtkPolyData::SafeDownCast(blocks->GetBlock(0))->GetCellData(), "Reflectance", 1, { 0.25 });
  AddDoubleArray(vtkPolyData::SafeDownCast(blocks->GetBlock(2))->GetCellData(), "Reflectance", 2, { 0.5, 0.75 });
  SurfaceReflectance reflectance;
  std::string error;
  ASSERT_TRUE(ReadReflectance(ReadMesh(blocks), 2, 0.125, reflectance, error)) << error;
  EXPECT_EQ(reflectance.Components, 2);
  EXPECT_EQ(reflectance.Values,
    (std::vector<float>{ 0.25f, 0.25f, 0.25f, 0.25f, 0.125f, 0.125f, 0.125f, 0.125f, 0.5f, 0.75f, 0.5f, 0.75f }));
}
