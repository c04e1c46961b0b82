// SPDX-License-Identifier: BSD-3-Clause
// vtkLabelOccluders: its report on tiny meshes and on real ones, its messages, and what every filter promises.
#include "vtkLabelOccluders.h"

#include "Messages.h"
#include "RealMeshes.h"
#include "TestPolyData.h"
#include "TimeLimit.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{

using Filter = vtkSmartPointer<vtkLabelOccluders>;

int Report(vtkPolyData* data, const char* name, vtkIdType index = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  EXPECT_TRUE(array) << name;
  // A count may be larger than an int can be.
  EXPECT_EQ(array && std::strcmp(name, "OccluderClosed") != 0 && array->GetDataType() != VTK_ID_TYPE, false) << name;
  return array && index < array->GetNumberOfTuples() ? static_cast<int>(array->GetComponent(index, 0)) : -99;
}

int OccluderId(vtkPolyData* data, vtkIdType cell)
{
  return vtkIntArray::SafeDownCast(data->GetCellData()->GetArray("OccluderId"))->GetValue(cell);
}

vtkSmartPointer<vtkPolyData> Cube(double x = 0.0, double y = 0.0, double z = 0.0)
{
  vtkNew<vtkCubeSource> source;
  source->SetCenter(x, y, z);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Make(
  const std::vector<double>& coordinates, const std::vector<std::vector<vtkIdType>>& polygons)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
  {
    points->InsertNextPoint(coordinates.data() + i);
  }
  vtkNew<vtkCellArray> polys;
  for (const auto& polygon : polygons)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

/// Run on @p input, which must stay as it is.
Filter Labelled(vtkDataObject* input, double tolerance = 1e-9, int labelBy = vtkLabelOccluders::Automatic)
{
  auto filter = Filter::New();
  filter->SetInputDataObject(input);
  filter->SetWeldTolerance(tolerance);
  filter->SetLabelBy(labelBy);
  const vtkMTimeType before = input->GetMTime();
  filter->Update();
  EXPECT_EQ(input->GetMTime(), before);
  return filter;
}

/// The message for @p input; the output must be empty.
std::string Error(vtkDataObject* input, double tolerance = 1e-9, int labelBy = vtkLabelOccluders::Automatic)
{
  auto filter = Filter::New();
  filter->SetInputDataObject(input);
  filter->SetWeldTolerance(tolerance);
  filter->SetLabelBy(labelBy);
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  return messages.Errors;
}

int CountEdges(vtkPolyData* data, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(data);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return static_cast<int>(edges->GetOutput()->GetNumberOfLines());
}

bool SameBytes(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y)
  {
    bool equal = x->GetDataType() == y->GetDataType() && x->GetNumberOfValues() == y->GetNumberOfValues();
    for (vtkIdType i = 0; equal && i < x->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; equal && c < x->GetNumberOfComponents(); ++c)
      {
        equal = x->GetComponent(i, c) == y->GetComponent(i, c);
      }
    }
    return equal;
  };
  return same(a->GetPoints()->GetData(), b->GetPoints()->GetData()) &&
    same(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()) &&
    same(a->GetCellData()->GetArray("OccluderId"), b->GetCellData()->GetArray("OccluderId"));
}

} // namespace

TEST(LabelOccluders, CubeSource)
{
  // Six quads on 24 points, because each face has its own normals.
  const Filter filter = Labelled(Cube(), 0.0);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfCells(), 12);
  EXPECT_EQ(output->GetNumberOfPoints(), 24) << "one for each normal of a corner";
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(Report(output, "NumberOfOccluders"), 1);
  EXPECT_EQ(Report(output, "TriangulatedPolygons"), 6);
  EXPECT_EQ(Report(output, "WeldedPoints"), 16);
  EXPECT_EQ(Report(output, "DroppedCells"), 0);
  EXPECT_EQ(Report(output, "IgnoredCells"), 0);
  EXPECT_EQ(Report(output, "FlippedTriangles"), 0);
  EXPECT_EQ(Report(output, "NonManifoldEdges"), 0);
  EXPECT_EQ(Report(output, "BoundaryEdges"), 0);
  EXPECT_EQ(Report(output, "OccluderClosed"), 1);
  ASSERT_NE(output->GetPointData()->GetNormals(), nullptr);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(output);
  EXPECT_NEAR(mass->GetVolume(), 1.0, 1e-12);
}

TEST(LabelOccluders, ReportOnATinyMesh)
{
  // A square of two triangles, one wound the other way, with a copy of one, a triangle on a line, a polygon of two
  // points, a concave pentagon apart, and a line. Points 4 and 5 repeat points 1 and 2.
  auto mesh = Make(
    { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 5, 0, 0, 7, 0, 0, 7, 2, 0, 6, 0.5, 0, 5, 2, 0 },
    { { 0, 1, 2 }, { 4, 5, 3 }, { 2, 1, 0 }, { 0, 1, 6 }, { 0, 1 }, { 7, 8, 9, 10, 11 } });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 3 });
  mesh->SetLines(lines);
  vtkNew<vtkFloatArray> reflectance;
  reflectance->SetName("Reflectance");
  for (const float value : { 9.f, 0.f, 1.f, 2.f, 3.f, 4.f, 5.f }) // cells count from the lines
  {
    reflectance->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(reflectance);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  for (int i = 0; i < 12; ++i)
  {
    number->InsertNextValue(100 + i);
  }
  mesh->GetPointData()->AddArray(number);

  const Filter filter = Labelled(mesh);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfCells(), 5);
  EXPECT_EQ(output->GetNumberOfPoints(), 9);
  EXPECT_EQ(Report(output, "NumberOfOccluders"), 2);
  EXPECT_EQ(Report(output, "TriangulatedPolygons"), 1);
  EXPECT_EQ(Report(output, "WeldedPoints"), 2);
  EXPECT_EQ(Report(output, "DroppedCells"), 3);
  EXPECT_EQ(Report(output, "IgnoredCells"), 1);
  EXPECT_EQ(Report(output, "FlippedTriangles"), 1);
  EXPECT_EQ(Report(output, "NonManifoldEdges"), 0);
  EXPECT_EQ(Report(output, "BoundaryEdges"), 4 + 5);
  EXPECT_EQ(Report(output, "OccluderClosed", 0), 0);
  EXPECT_EQ(Report(output, "OccluderClosed", 1), 0);

  vtkDataArray* passed = output->GetCellData()->GetArray("Reflectance");
  ASSERT_TRUE(passed);
  const double expected[5] = { 0, 1, 5, 5, 5 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(passed->GetComponent(i, 0), expected[i]) << i;
    EXPECT_EQ(OccluderId(output, i), i < 2 ? 0 : 1) << i;
  }
  vtkDataArray* numbers = output->GetPointData()->GetArray("Number");
  ASSERT_TRUE(numbers);
  const double kept[9] = { 100, 101, 102, 103, 107, 108, 109, 110, 111 };
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(numbers->GetComponent(i, 0), kept[i]) << i;
  }
}

TEST(LabelOccluders, NonManifoldEdge)
{
  const Filter filter =
    Labelled(Make({ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1 }, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }));
  EXPECT_EQ(Report(filter->GetOutput(), "NonManifoldEdges"), 1);
  EXPECT_EQ(Report(filter->GetOutput(), "BoundaryEdges"), 6);
  EXPECT_EQ(Report(filter->GetOutput(), "FlippedTriangles"), 0);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 1);
}

TEST(LabelOccluders, OrientOff)
{
  auto filter = Filter::New();
  filter->SetInputData(Make({ 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 }, { { 0, 1, 2 }, { 1, 2, 3 } }));
  filter->Update();
  EXPECT_EQ(Report(filter->GetOutput(), "FlippedTriangles"), 1);
  filter->OrientOff();
  filter->Update();
  EXPECT_EQ(Report(filter->GetOutput(), "FlippedTriangles"), 0);
}

TEST(LabelOccluders, ReceiversKeepMinusOne)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  int next = 40;
  for (const double x : { 0.0, 2.0, 4.0 })
  {
    auto cube = Cube(x);
    vtkNew<vtkIntArray> ids;
    ids->SetName("OccluderId");
    for (int i = 0; i < 6; ++i)
    {
      ids->InsertNextValue(x == 2.0 ? -5 : next);
    }
    --next;
    cube->GetCellData()->AddArray(ids);
    append->AddInputData(cube);
  }
  append->Update();
  const Filter filter = Labelled(append->GetOutput());
  EXPECT_EQ(OccluderId(filter->GetOutput(), 0), 0);
  EXPECT_EQ(OccluderId(filter->GetOutput(), 12), -1);
  EXPECT_EQ(OccluderId(filter->GetOutput(), 24), 1);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 2);

  const Filter again = Labelled(filter->GetOutput());
  EXPECT_TRUE(SameBytes(again->GetOutput(), filter->GetOutput())) << "a second pass changes nothing";
}

TEST(LabelOccluders, BlocksOfEveryComposite)
{
  // Two cubes that share a wall, then a third apart in the same block as the second, then nothing, then a fourth.
  vtkNew<vtkAppendPolyData> pair;
  pair->AddInputData(Cube(1.0));
  pair->AddInputData(Cube(5.0));
  pair->Update();
  auto marked = Cube(9.0);
  for (vtkPolyData* data : { marked.GetPointer(), pair->GetOutput() })
  {
    vtkNew<vtkIntArray> extra;
    extra->SetName("Extra");
    extra->SetNumberOfTuples(data->GetNumberOfCells());
    extra->Fill(data == marked ? 1 : 0);
    data->GetCellData()->AddArray(extra);
  }

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, pair->GetOutput());
  inner->SetBlock(2, vtkNew<vtkPolyData>());
  blocks->SetBlock(0, Cube(0.0));
  blocks->SetBlock(2, inner);
  blocks->SetBlock(3, marked);
  Filter filter = Labelled(blocks);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 48);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 3);
  EXPECT_EQ(Report(filter->GetOutput(), "NonManifoldEdges"), 0);
  EXPECT_EQ(OccluderId(filter->GetOutput(), 35), 1);
  EXPECT_EQ(OccluderId(filter->GetOutput(), 36), 2);
  EXPECT_FALSE(filter->GetOutput()->GetCellData()->HasArray("Extra")) << "the first block has none";
  filter = Labelled(blocks, 1e-9, vtkLabelOccluders::Component);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 3) << "0 and 1 touch, 5, 9";
  filter = Labelled(blocks, 1e-9, vtkLabelOccluders::Whole);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 1);

  vtkNew<vtkPartitionedDataSet> pieces;
  pieces->SetPartition(0, pair->GetOutput());
  pieces->SetPartition(1, marked);
  filter = Labelled(pieces);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 3) << "pieces of one mesh, by component";
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Extra")->GetComponent(24, 0), 1.0);
  filter = Labelled(pieces, 1e-9, vtkLabelOccluders::Block);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 1);

  vtkNew<vtkPartitionedDataSetCollection> collection;
  vtkNew<vtkPartitionedDataSet> first;
  first->SetPartition(0, Cube(0.0));
  collection->SetPartitionedDataSet(0, first);
  collection->SetPartitionedDataSet(1, pieces);
  filter = Labelled(collection);
  EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 2);

  vtkNew<vtkMultiBlockDataSet> mixed;
  mixed->SetBlock(0, Cube());
  mixed->SetBlock(1, vtkNew<vtkTable>());
  EXPECT_SAYS(Error(mixed), "Block 1 is a vtkTable: every block must be a vtkPolyData.");
}

TEST(LabelOccluders, EmptyInEmptyOut)
{
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{
         vtkPolyData::New(), vtkMultiBlockDataSet::New(), vtkPartitionedDataSetCollection::New() })
  {
    auto filter = Filter::New();
    filter->SetInputDataObject(input);
    Messages messages(filter);
    filter->Update();
    EXPECT_EQ(messages.Errors, "");
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(Report(filter->GetOutput(), "NumberOfOccluders"), 0);
    EXPECT_TRUE(filter->GetOutput()->GetCellData()->HasArray("OccluderId"));
    input->Delete();
  }
}

TEST(LabelOccluders, FaultsAreNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_SAYS(Error(Make({ 0, 0, 0 }, {})), "The mesh has no polygons");
  EXPECT_SAYS(Error(Make({ 0, 0, 0, 1, 0, 0, 0, nan, 0 }, { { 0, 1, 2 } })),
    "Point 2, used by cell 0, has a coordinate that is not finite.");
  EXPECT_SAYS(Error(Make({ 0, 0, 0, 1, 0, 0, 2, 0, 0 }, { { 0, 1, 2 } })), "No polygon of the mesh has an area");
  EXPECT_SAYS(Error(Make({ -1.6e308, 0, 0, 1.6e308, 0, 0, 0, 1, 0 }, { { 0, 1, 2 } })), "beyond 1e18");
  EXPECT_SAYS(Error(Cube(), -1.0), "WeldTolerance is -1: it must be in 0..0.1.");
  EXPECT_SAYS(Error(Cube(), 0.2), "WeldTolerance is 0.2:");
  EXPECT_SAYS(Error(Cube(), nan), "WeldTolerance is ");
  EXPECT_SAYS(Error(Cube(), 0.0, 5), "LabelBy is 5");

  auto cube = Cube();
  vtkNew<vtkFloatArray> shortArray;
  shortArray->SetName("Reflectance");
  shortArray->InsertNextValue(1.0f);
  cube->GetCellData()->AddArray(shortArray);
  EXPECT_SAYS(Error(cube), "The cell array \"Reflectance\" has 1 tuples where 6 are needed.");

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Cube());
  blocks->SetBlock(1, Make({ nan, 0, 0, 1, 0, 0, 0, 1, 0 }, { { 0, 1, 2 } }));
  EXPECT_SAYS(Error(blocks), "Block 1: Point 0, used by cell 0");
}

TEST(LabelOccluders, FarAwayAndTiny)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(20);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  const Filter near = Labelled(sphere->GetOutput());
  for (const double scale : { 1.0, 1e-3 })
  {
    for (const double far : { 1e6, -1e9 * scale })
    {
      vtkNew<vtkPolyData> moved;
      moved->DeepCopy(sphere->GetOutput());
      for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
      {
        double p[3];
        moved->GetPoint(i, p);
        moved->GetPoints()->SetPoint(i, scale * p[0] + far, scale * p[1] + far, scale * p[2] - far);
      }
      const Filter filter = Labelled(moved);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), near->GetOutput()->GetNumberOfCells()) << scale << " " << far;
      EXPECT_EQ(Report(filter->GetOutput(), "WeldedPoints"), 0) << scale << " " << far;
      EXPECT_EQ(Report(filter->GetOutput(), "OccluderClosed"), 1) << scale << " " << far;
    }
  }
}

TEST(LabelOccluders, APieceHasTheReportOfTheWhole)
{
  vtkNew<vtkSphereSource> sphere;
  auto filter = Filter::New();
  filter->SetInputConnection(sphere->GetOutputPort());
  for (int piece = 0; piece < 4; ++piece)
  {
    filter->UpdatePiece(piece, 4, 0);
    EXPECT_EQ(Report(filter->GetOutput(), "OccluderClosed"), 1);
  }
}

TEST(LabelOccluders, PrintsEveryMember)
{
  std::ostringstream text;
  Filter::New()->Print(text);
  for (const char* part : { "LabelBy: 0", "WeldTolerance: 1e-09", "Orient: On" })
  {
    EXPECT_SAYS(text.str(), part);
  }
}

TEST(LabelOccluders, MeshesOfThisProject)
{
  const auto closed = [](vtkPolyData* data)
  {
    int count = 0;
    for (int i = 0; i < Report(data, "NumberOfOccluders"); ++i)
    {
      count += Report(data, "OccluderClosed", i);
    }
    return count;
  };
  const Filter chair = Labelled(ReadData("chair.vtp"));
  EXPECT_EQ(Report(chair->GetOutput(), "NumberOfOccluders"), 27);
  EXPECT_EQ(closed(chair->GetOutput()), 27);
  EXPECT_EQ(Report(chair->GetOutput(), "FlippedTriangles"), 0);

  const Filter tree = Labelled(ReadData("tree.vtp"));
  EXPECT_EQ(Report(tree->GetOutput(), "NumberOfOccluders"), 1336);
  EXPECT_EQ(closed(tree->GetOutput()), 364);
  EXPECT_EQ(Report(tree->GetOutput(), "NonManifoldEdges"), 0);

  const Filter blob = Labelled(ReadData("blob.vtp"));
  EXPECT_EQ(Report(blob->GetOutput(), "NumberOfOccluders"), 1);
  EXPECT_EQ(closed(blob->GetOutput()), 1);

  const Filter box = Labelled(ReadData("cornell-box.vtp"));
  EXPECT_EQ(Report(box->GetOutput(), "NumberOfOccluders"), 0);
  EXPECT_EQ(OccluderId(box->GetOutput(), 9), -1);
  vtkDataArray* reflectance = box->GetOutput()->GetCellData()->GetArray("Reflectance");
  ASSERT_TRUE(reflectance);
  EXPECT_EQ(reflectance->GetNumberOfComponents(), 7);
}

TEST(LabelOccluders, Bunny)
{
  const std::string path = Model("bunny.obj");
  if (path.empty())
  {
    GTEST_SKIP() << "glmark2-data is not installed";
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto start = std::chrono::steady_clock::now();
  const Filter filter = Labelled(reader->GetOutput());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("Seconds", std::to_string(seconds));
  EXPECT_LT(seconds, TimeLimit(2.0));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfCells(), 69666);
  EXPECT_EQ(Report(output, "NumberOfOccluders"), 1);
  EXPECT_EQ(Report(output, "DroppedCells"), 0);
  EXPECT_EQ(Report(output, "NonManifoldEdges"), 0);
  EXPECT_EQ(Report(output, "BoundaryEdges"), 0);
  EXPECT_EQ(Report(output, "OccluderClosed"), 1);
}

namespace
{

class RealMesh : public testing::TestWithParam<std::tuple<const char*, int, int>>
{
};

} // namespace

TEST_P(RealMesh, EdgesAsVtkCountsThem)
{
  const std::string path = Model(std::get<0>(GetParam()));
  if (path.empty())
  {
    GTEST_SKIP() << "glmark2-data is not installed";
  }
  auto imported = Import3DS(path, true);
  imported->GetPointData()->Initialize(); // points with several normals are not welded
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(imported);
  clean->Update();
  const Filter filter = Labelled(imported, 0.0);
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(Report(output, "NonManifoldEdges"), std::get<1>(GetParam()));
  EXPECT_EQ(Report(output, "BoundaryEdges"), std::get<2>(GetParam()));
  EXPECT_EQ(CountEdges(output, false), std::get<1>(GetParam()));
  EXPECT_EQ(CountEdges(output, true), std::get<2>(GetParam()));
  EXPECT_EQ(output->GetNumberOfPoints(), clean->GetOutput()->GetNumberOfPoints());

  vtkNew<vtkPolyDataConnectivityFilter> regions;
  regions->SetInputData(output);
  regions->SetExtractionModeToAllRegions();
  regions->Update();
  EXPECT_EQ(Report(output, "NumberOfOccluders"), regions->GetNumberOfExtractedRegions());
}

INSTANTIATE_TEST_SUITE_P(
  LabelOccluders, RealMesh, testing::Values(std::make_tuple("horse.3ds", 24, 0), std::make_tuple("cat.3ds", 0, 330)));
