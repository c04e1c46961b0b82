// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowVectorFilter: its arrays, its parameters, and a message for each fault.
#include "Messages.h"
#include "TestPolyData.h"
#include "vtkShadowVectorFilter.h"

#include "vtkCellArray.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace shadowcones::testsupport;

namespace
{

vtkSmartPointer<vtkPolyData> BoxOverFloor()
{
  return MeshBuilder().AddBox(0.0, 0.0, 1.0, 0.5, 0.5, 0.1, 0).AddSquare(0.0, 3.0, -1).Build();
}

struct Outcome
{
  int Points = 0;
  std::string Errors;
  std::string Warnings;
};

vtkSmartPointer<vtkShadowVectorFilter> FilterOf(vtkPolyData* mesh, vtkAreaLightSource* light, vtkIdType photons)
{
  auto filter = vtkSmartPointer<vtkShadowVectorFilter>::New();
  filter->SetToPaper();
  filter->SetInputData(mesh);
  filter->SetLightConnection(light->GetOutputPort());
  filter->SetNumberOfPhotons(photons);
  return filter;
}

/// Run on the mesh with what @p change sets; all three outputs are counted.
template <typename Change>
Outcome Execute(vtkPolyData* mesh, Change change)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(mesh, light, 200);
  change(filter.GetPointer());
  Messages messages(filter);
  filter->Update();
  Outcome outcome;
  for (int port = 0; port < 3; ++port)
  {
    outcome.Points += static_cast<int>(filter->GetOutput(port)->GetNumberOfPoints());
  }
  outcome.Errors = messages.Errors;
  outcome.Warnings = messages.Warnings;
  return outcome;
}

const auto Nothing = [](vtkShadowVectorFilter*) {};

} // namespace

TEST(ShadowVectorFilter, GivesTheDocumentedArrays)
{
  const auto light = LampAbove(3.0);
  vtkNew<vtkShadowVectorFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(BoxOverFloor());
  filter->SetLightConnection(light->GetOutputPort());
  filter->SetNumberOfPhotons(2000);
  filter->SetSeed(5);
  filter->Update();

  vtkPolyData* vectors = filter->GetOutput(0);
  const vtkIdType count = vectors->GetNumberOfPoints();
  ASSERT_GT(count, 100);
  EXPECT_EQ(vectors->GetNumberOfVerts(), count);
  EXPECT_EQ(vectors->GetNumberOfCells(), count);
  EXPECT_EQ(vectors->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkPointData* data = vectors->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 8);
  vtkDataArray* directions = ArrayOf(data, "Direction", VTK_FLOAT, 3);
  ArrayOf(data, "Normal", VTK_FLOAT, 3);
  ArrayOf(data, "OccluderId", VTK_INT, 1);
  vtkDataArray* starts = ArrayOf(data, "EmissionPoint", VTK_DOUBLE, 3);
  vtkDataArray* lengths = ArrayOf(data, "PathLength", VTK_FLOAT, 1);
  vtkDataArray* thicknesses = ArrayOf(data, "Thickness", VTK_FLOAT, 1);
  ArrayOf(data, "PhotonIndex", VTK_ID_TYPE, 1);
  ArrayOf(data, "LightId", VTK_INT, 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    vectors->GetPoint(i, p);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(starts->GetComponent(i, c) + lengths->GetTuple1(i) * directions->GetComponent(i, c), p[c], 1e-5);
    }
    EXPECT_NEAR(starts->GetComponent(i, 2), 3.0, 1e-12);
    EXPECT_GE(thicknesses->GetTuple1(i), 0.0);
  }

  vtkPolyData* paths = filter->GetOutput(1);
  data = paths->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 7);
  vtkDataArray* states = ArrayOf(data, "PathState", VTK_INT, 1);
  vtkDataArray* occluders = ArrayOf(data, "OccluderId", VTK_INT, 1);
  ArrayOf(data, "EmissionPoint", VTK_DOUBLE, 3);
  ArrayOf(data, "Direction", VTK_FLOAT, 3);
  ArrayOf(data, "Power", VTK_FLOAT, 1);
  ArrayOf(data, "PhotonIndex", VTK_ID_TYPE, 1);
  ArrayOf(data, "LightId", VTK_INT, 1);
  vtkIdType blocked = 0;
  for (vtkIdType i = 0; i < paths->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(states->GetTuple1(i) == 0.0, occluders->GetTuple1(i) == -1.0);
    blocked += states->GetTuple1(i) == 1.0;
  }
  EXPECT_EQ(blocked, count);
  EXPECT_LT(blocked, paths->GetNumberOfPoints());

  vtkPolyData* photons = filter->GetOutput(2);
  data = photons->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 7);
  ArrayOf(data, "Normal", VTK_FLOAT, 3);
  ArrayOf(data, "Direction", VTK_FLOAT, 3);
  vtkDataArray* powers = ArrayOf(data, "Power", VTK_FLOAT, 1);
  ArrayOf(data, "OccluderId", VTK_INT, 1);
  vtkDataArray* receivers = ArrayOf(data, "ReceiverId", VTK_INT, 1);
  ArrayOf(data, "PhotonIndex", VTK_ID_TYPE, 1);
  ArrayOf(data, "LightId", VTK_INT, 1);
  ASSERT_EQ(photons->GetNumberOfPoints(), blocked); // the floor is wide enough for all of them
  for (vtkIdType i = 0; i < blocked; ++i)
  {
    EXPECT_LT(powers->GetTuple1(i), 0.0);
    EXPECT_EQ(receivers->GetTuple1(i), -1.0);
    EXPECT_NEAR(photons->GetPoint(i)[2], 0.0, 1e-9);
  }

  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    EXPECT_EQ(FieldValue(output, "NumberOfPhotons"), 2000.0);
    EXPECT_EQ(FieldValue(output, "Seed"), 5.0);
    EXPECT_EQ(FieldValue(output, "Storage"), 0.0);
    EXPECT_GT(FieldValue(output, "MeanSolidAngle"), 0.0);
    EXPECT_EQ(FieldValue(output, "LightShape"), 0.0);
    EXPECT_EQ(FieldValue(output, "LightRadius"), 0.5);
  }
}

TEST(ShadowVectorFilter, TakesAnyMeshOrVertexForALight)
{
  vtkNew<vtkShadowVectorFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(BoxOverFloor());
  MeshBuilder builder;
  const vtkIdType a = builder.AddPoint(-0.5, -0.5, 3.0);
  builder.AddPoint(-0.5, 0.5, 3.0);
  builder.AddPoint(0.5, 0.5, 3.0);
  builder.AddPoint(0.5, -0.5, 3.0);
  builder.AddQuad(a, a + 1, a + 2, a + 3, 0); // faces down
  filter->SetLightData(builder.Build());
  filter->SetNumberOfPhotons(500);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 50);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("LightShape"), nullptr); // it has no exact shape

  vtkNew<vtkPolyData> vertex;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 3.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0 });
  vertex->SetPoints(points);
  vertex->SetVerts(cells);
  filter->SetLightData(vertex);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 50);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("EmissionPoint")->GetRange(2)[0], 3.0);
}

TEST(ShadowVectorFilter, TakesPolygonsStripsAndSinglePrecision)
{
  vtkSmartPointer<vtkPolyData> quads = MeshBuilder().AddSquare(0.0, 1.0, 7).Build();
  const Outcome whole = Execute(quads, Nothing);
  EXPECT_GT(whole.Points, 0);
  vtkNew<vtkPolyData> strip;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i & 2 ? 1.0 : -1.0, i & 1 ? 1.0 : -1.0, 0.0);
  }
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strip->SetPoints(points);
  strip->SetStrips(strips);
  vtkNew<vtkIntArray> ids;
  ids->SetName("OccluderId");
  ids->InsertNextValue(7);
  strip->GetCellData()->AddArray(ids);
  EXPECT_EQ(Execute(strip, Nothing).Points, whole.Points);
}

TEST(ShadowVectorFilter, ParametersChangeWhatTheySay)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(BoxOverFloor(), light, 300);
  filter->SetStorageToHitPoint();
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[5], 1.1, 1e-9); // top of the box
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Storage"), 1.0);
  filter->SetStorageToBackSide();
  filter->SetTargetNumberOfVectors(250);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 250);
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[4], 0.9, 1e-9); // bottom of the box
  filter->SetTargetNumberOfVectors(0);
  filter->SetNumberOfPhotons(0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "NumberOfPhotons: 0", "TargetNumberOfVectors: 0", "Storage: BackSide", "Seed: 1" })
  {
    EXPECT_SAYS(text.str(), name);
  }
}

TEST(ShadowVectorFilter, AnEmptyMeshGivesEmptyOutputs)
{
  vtkNew<vtkPolyData> empty;
  const Outcome outcome = Execute(empty, [](vtkShadowVectorFilter* filter) { filter->SetTargetNumberOfVectors(100); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_EQ(outcome.Errors + outcome.Warnings, "");
}

TEST(ShadowVectorFilter, ReceiversAloneCastNothing)
{
  const Outcome outcome = Execute(MeshBuilder().AddSquare(0.0, 1.0, -1).Build(), Nothing);
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_EQ(outcome.Errors, "");
}

TEST(ShadowVectorFilterErrors, NoPolygons)
{
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  lines->SetPoints(points);
  lines->SetLines(cells);
  const Outcome outcome = Execute(lines, Nothing);
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "no polygon");
}

TEST(ShadowVectorFilterErrors, MissingLight)
{
  const Outcome outcome =
    Execute(BoxOverFloor(), [](vtkShadowVectorFilter* filter) { filter->SetLightConnection(nullptr); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "No light on input port 1");
  EXPECT_SAYS(outcome.Errors, "SetLightConnection");
}

TEST(ShadowVectorFilterErrors, MissingOccluderIds)
{
  const auto mesh = BoxOverFloor();
  mesh->GetCellData()->RemoveArray("OccluderId");
  const Outcome outcome = Execute(mesh, Nothing);
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "\"OccluderId\"");
  EXPECT_SAYS(outcome.Errors, "vtkLabelOccluders");
}

TEST(ShadowVectorFilterErrors, OccluderIdsOfTheWrongSize)
{
  const auto mesh = BoxOverFloor();
  vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("OccluderId"))->InsertNextValue(3);
  const Outcome outcome = Execute(mesh, Nothing);
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "\"OccluderId\"");
  EXPECT_SAYS(outcome.Errors, "7 are needed");
}

TEST(ShadowVectorFilterErrors, PointThatIsNotANumber)
{
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    const auto mesh = BoxOverFloor();
    mesh->GetPoints()->SetPoint(3, 0.0, bad, 0.0);
    const Outcome outcome = Execute(mesh, Nothing);
    EXPECT_EQ(outcome.Points, 0);
    EXPECT_SAYS(outcome.Errors, "Point 3");
    EXPECT_SAYS(outcome.Errors, "not finite");
  }
}

TEST(ShadowVectorFilterErrors, CellThatUsesAPointThatIsNotThere)
{
  MeshBuilder builder;
  builder.AddSquare(0.0, 1.0, 0);
  builder.AddQuad(0, 1, 2, 99, 0);
  const Outcome outcome = Execute(builder.Build(), Nothing);
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "Cell 1 uses point 99");
}

TEST(ShadowVectorFilterErrors, LightWithoutArea)
{
  MeshBuilder builder;
  const vtkIdType a = builder.AddPoint(0.0, 0.0, 3.0);
  builder.AddPoint(1.0, 0.0, 3.0);
  builder.AddQuad(a, a + 1, a + 1, a, 0);
  const Outcome outcome =
    Execute(BoxOverFloor(), [&](vtkShadowVectorFilter* filter) { filter->SetLightData(builder.Build()); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "zero area");
}

TEST(ShadowVectorFilterErrors, EmptyLight)
{
  vtkNew<vtkPolyData> empty;
  const Outcome outcome = Execute(BoxOverFloor(), [&](vtkShadowVectorFilter* filter) { filter->SetLightData(empty); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "light is empty");
}

TEST(ShadowVectorFilterErrors, BadParameters)
{
  Outcome outcome = Execute(BoxOverFloor(), [](vtkShadowVectorFilter* filter) { filter->SetNumberOfPhotons(-1); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "NumberOfPhotons (-1)");
  outcome = Execute(BoxOverFloor(), [](vtkShadowVectorFilter* filter) { filter->SetTargetNumberOfVectors(-7); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "TargetNumberOfVectors (-7)");
  outcome = Execute(BoxOverFloor(), [](vtkShadowVectorFilter* filter) { filter->SetStorage(2); });
  EXPECT_EQ(outcome.Points, 0);
  EXPECT_SAYS(outcome.Errors, "Storage is 2");
}

TEST(ShadowVectorFilterErrors, AFaultClearsTheOutputsAndAGoodRunFollows)
{
  const auto light = LampAbove(3.0);
  const auto filter = FilterOf(BoxOverFloor(), light, 300);
  filter->Update();
  const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
  ASSERT_GT(count, 0);
  Messages messages(filter);
  filter->SetStorage(9);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
  filter->SetStorage(0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), count);
}

TEST(ShadowVectorFilterWarnings, TargetThatCannotBeMet)
{
  const auto away = LampAbove(3.0);
  away->SetNormal(0.0, 0.0, 1.0);
  const Outcome outcome = Execute(BoxOverFloor(),
    [&](vtkShadowVectorFilter* filter)
    {
      filter->SetLightConnection(away->GetOutputPort());
      filter->SetTargetNumberOfVectors(10);
    });
  EXPECT_EQ(outcome.Errors, "");
  EXPECT_SAYS(outcome.Warnings, "Only 0 of 10 vectors");
}
