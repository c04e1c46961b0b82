// SPDX-License-Identifier: BSD-3-Clause
// vtkSunHours: a courtyard, a wall and a year behind a fence, integrated along a Sun of another origin; names, marks,
// messages.
#include "vtkSunHours.h"

#include "MeeusSun.h"
#include "Messages.h"
#include "TestPolyData.h"
#include "scCivilTime.h"
#include "vtkLabelOccluders.h"
#include "vtkSunPath.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double latitude = 47.3;
constexpr double longitude = 11.4;

vtkSmartPointer<vtkSunPath> Path(const char* start, const char* end, double step, double diameter = 0.0)
{
  auto path = vtkSmartPointer<vtkSunPath>::New();
  path->SetLatitude(latitude);
  path->SetLongitude(longitude);
  path->SetStart(start);
  path->SetEnd(end);
  path->SetStep(step);
  path->SetAngularDiameter(diameter);
  return path;
}

vtkSmartPointer<vtkSunHours> Hours(vtkDataObject* where, vtkDataObject* mesh, vtkSunPath* path)
{
  auto filter = vtkSmartPointer<vtkSunHours>::New();
  filter->SetInputDataObject(0, where);
  filter->SetMeshData(mesh);
  filter->SetPathConnection(path->GetOutputPort());
  return filter;
}

double Value(vtkSunHours* filter, const char* name, vtkIdType point = 0)
{
  vtkDataArray* array =
    ArrayOf(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData(), name, VTK_FLOAT, 1);
  return array ? array->GetComponent(point, 0) : -1e300;
}

/// What a point sees of a hard Sun, by a Sun of another origin.
struct Truth
{
  double Hours = 0.0;
  double First = -1.0;
  double Last = -1.0;
  double Longest = 0.0;
  int Changes = 0;

  /// @param isLit does light from there, above the horizon, arrive? @param step seconds.
  Truth(const char* start, const char* end, double step, const std::function<bool(const Vector3&)>& isLit)
  {
    double from = 0.0;
    double to = 0.0;
    EXPECT_TRUE(ReadCivilTime(start, from) && ReadCivilTime(end, to));
    double run = 0.0;
    bool before = false;
    for (double t = 0.0; t < to - from; t += step)
    {
      const Vector3 sun = MeeusDirection(from + t + 0.5 * step, latitude, longitude);
      const bool lit = sun.Z > 0.0 && isLit(sun);
      this->Changes += lit != before;
      before = lit;
      run = lit ? run + step / 3600.0 : 0.0;
      this->Longest = std::max(this->Longest, run);
      this->Hours += lit ? step / 3600.0 : 0.0;
      this->First = lit && this->First < 0.0 ? t / 3600.0 : this->First;
      this->Last = lit ? (t + step) / 3600.0 : this->Last;
    }
  }
};

/// Four walls around the origin, 10 by 6 inside and 4 high, each of its own.
vtkSmartPointer<vtkPolyData> Courtyard()
{
  MeshBuilder builder;
  builder.AddBox(5.5, 0.0, 2.0, 0.5, 10.0, 2.0, 10);
  builder.AddBox(-5.5, 0.0, 2.0, 0.5, 10.0, 2.0, 11);
  builder.AddBox(0.0, 3.5, 2.0, 5.0, 0.5, 2.0, 12);
  builder.AddBox(0.0, -3.5, 2.0, 5.0, 0.5, 2.0, 13);
  return builder.Build();
}

/// Light over the walls' inner edges reaches (x, y, 0).
bool ReachesFloor(const Vector3& sun, double x, double y)
{
  const double along = 4.0 / sun.Z; // until the height of the walls
  return std::fabs(x + along * sun.X) < 5.0 && std::fabs(y + along * sun.Y) < 3.0;
}

} // namespace

TEST(SunHours, ACourtyardInMay)
{
  const std::vector<std::pair<double, double>> places = { { 0.0, 0.0 }, { 3.0, 2.0 }, { -4.0, 2.5 }, { 1.0, 0.7 } };
  std::vector<double> points;
  for (const auto& place : places)
  {
    points.insert(points.end(), { place.first, place.second, 0.0 });
  }
  const char* start = "2023-05-10T00:00:00+02:00";
  const char* end = "2023-05-11T00:00:00+02:00";
  for (const double diameter : { 0.0, 0.533 })
  {
    for (const double step : { 10.0, 1.0 })
    {
      const auto path = Path(start, end, step, diameter);
      const auto filter = Hours(PointsAt(points), Courtyard(), path);
      filter->Update();
      for (std::size_t k = 0; k < places.size(); ++k)
      {
        const auto id = static_cast<vtkIdType>(k);
        const Truth truth(
          start, end, 2.0, [&](const Vector3& sun) { return ReachesFloor(sun, places[k].first, places[k].second); });
        // .012 degrees of another formula are 3 s or so an edge; the disc's edges take time of their own.
        const double other = truth.Changes * (diameter > 0.0 ? 0.01 : 0.002);
        const double error = Value(filter, "SunHoursError", id);
        EXPECT_NEAR(Value(filter, "SunHours", id), truth.Hours, error + other) << k << " step " << step;
        EXPECT_NEAR(error, 0.5 * truth.Changes * step / 60.0, 1e-4) << k;
        const double edge = 0.5 * step / 60.0 + (diameter > 0.0 ? 0.06 : 0.002);
        EXPECT_NEAR(Value(filter, "FirstSun", id), truth.First, edge) << k;
        EXPECT_NEAR(Value(filter, "LastSun", id), truth.Last, edge) << k;
        EXPECT_NEAR(Value(filter, "LongestSun", id), truth.Longest, error + other) << k;
      }
    }
  }
}

TEST(SunHours, AYearBehindAFence)
{
  // 2 m high, 40 long, 3 m south of a sensor on the ground; in steps of ten minutes, at whose middles the other Sun is
  // asked too.
  const double half = 20.0;
  const auto fence = Plane({ -half, -3.0, 0.0 }, { 2.0 * half, 0.0, 0.0 }, { 0.0, 0.0, 2.0 });
  const auto reaches = [half](const Vector3& sun)
  {
    const double along = -3.0 / sun.Y;
    return !(sun.Y < 0.0 && along * sun.Z < 2.0 && std::fabs(along * sun.X) < half);
  };
  const auto path = Path("2023-01-01", "2024-01-01", 10.0);
  const auto filter = Hours(PointsAt({ 0.0, 0.0, 0.0 }), fence, path);
  filter->Update();
  const Truth same("2023-01-01", "2024-01-01", 600.0, reaches);
  // Of 1,500 or so risings, settings and edges few come within 3 s of the middle of ten minutes.
  EXPECT_NEAR(Value(filter, "SunHours"), same.Hours, 12.0 / 6.0);
  EXPECT_EQ(Value(filter, "FirstSun"), static_cast<float>(same.First));
  EXPECT_EQ(Value(filter, "LastSun"), static_cast<float>(same.Last));
  EXPECT_NEAR(Value(filter, "LongestSun"), same.Longest, 0.17);
  // Finer steps: within the bound, and far within it.
  const Truth fine("2023-01-01", "2024-01-01", 30.0, reaches);
  const double error = Value(filter, "SunHoursError");
  EXPECT_NEAR(error, same.Changes / 12.0, 1.0);
  EXPECT_NEAR(Value(filter, "SunHours"), fine.Hours, 0.1 * error);
  EXPECT_GT(fine.Hours, 3000.0); // of 4,400
  EXPECT_LT(fine.Hours, 4200.0);
}

TEST(SunHours, NightIsDarkWhateverTheMesh)
{
  // An open sky: from sunrise to sunset, and above 10 degrees.
  const auto path = Path("2023-03-10", "2023-03-11", 1.0);
  const auto filter =
    Hours(PointsAt({ 0.0, 0.0, 0.0 }), Plane({ 500.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }), path);
  for (const double least : { 0.0, 10.0, -6.0 })
  {
    filter->SetMinimumAltitude(least);
    filter->Update();
    double hours = 0.0;
    double from = 0.0;
    ASSERT_TRUE(ReadCivilTime("2023-03-10", from));
    for (double t = 1.0; t < 86400.0; t += 2.0)
    {
      hours += MeeusSun(from + t, latitude, longitude).Altitude > least ? 2.0 / 3600.0 : 0.0;
    }
    EXPECT_NEAR(Value(filter, "SunHours"), hours, Value(filter, "SunHoursError") + 0.005);
    EXPECT_NEAR(Value(filter, "SunHoursError"), 1.0 / 60.0, 1e-6);
  }
}

TEST(SunHours, TheTimeOfThePipelinePlaysNoPart)
{
  const auto path = Path("2023-05-10", "2023-05-11", 30.0);
  const auto filter = Hours(PointsAt({ 0.0, 0.0, 0.0 }), Courtyard(), path);
  filter->Update(); // at 0 h, when there is no light
  const double hours = Value(filter, "SunHours");
  EXPECT_GT(hours, 1.0);
  vtkInformation* info = filter->GetOutputInformation(0);
  EXPECT_FALSE(info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
  const vtkMTimeType made = filter->GetOutputDataObject(0)->GetMTime();
  filter->UpdateTimeStep(43200.0);
  EXPECT_EQ(Value(filter, "SunHours"), hours);
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetMTime(), made);
  path->UpdateTimeStep(43200.0);
  const auto again = vtkSmartPointer<vtkSunHours>::New();
  again->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
  again->SetMeshData(Courtyard());
  again->SetPathData(path->GetOutput());
  again->Update();
  EXPECT_EQ(Value(again, "SunHours"), hours);
}

TEST(SunHours, SurfacesCellsAndNames)
{
  // A cube's own faces: each in the plane of a sensor's triangle. The north face sees the Sun in summer only, the
  // bottom never.
  vtkNew<vtkLabelOccluders> labels;
  MeshBuilder builder;
  builder.AddBox(0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 7);
  builder.AddBox(0.0, -6.0, 20.0, 50.0, 0.5, 20.0, 3); // a tall wall in the south
  labels->SetInputData(builder.Build());
  labels->SetLabelByToArray();
  labels->Update();
  const auto path = Path("2023-12-10", "2023-12-11", 10.0);
  const auto filter = Hours(labels->GetOutput(), labels->GetOutput(), path);
  filter->SetAssociationToCells();
  filter->ComputeOccludersOn();
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* hours = ArrayOf(output->GetCellData(), "SunHours", VTK_FLOAT, 1);
  vtkDataArray* ids = ArrayOf(output->GetCellData(), "OccluderId", VTK_INT, 1);
  auto* names = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("OccluderNames"));
  ASSERT_TRUE(hours && ids && names);
  EXPECT_TRUE(output->GetFieldData()->HasArray("CastersFingerprint"));
  int behindWall = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    output->GetCellBounds(cell, bounds);
    if (bounds[2] == -1.0 && bounds[3] == -1.0) // the cube's south face
    {
      ++behindWall;
      EXPECT_EQ(hours->GetComponent(cell, 0), 0.0);
      ASSERT_GE(ids->GetComponent(cell, 0), 0.0);
      EXPECT_EQ(names->GetValue(static_cast<vtkIdType>(ids->GetComponent(cell, 0))), "3");
    }
    if (bounds[2] == -6.5 && bounds[3] == -6.5) // the wall's south face: all of the day, and nobody's shadow
    {
      EXPECT_GT(hours->GetComponent(cell, 0), 8.0);
      EXPECT_EQ(ids->GetComponent(cell, 0), -1.0);
    }
    if (bounds[2] == 1.0 && bounds[3] == 1.0) // the cube's north face: in its own shadow
    {
      EXPECT_EQ(hours->GetComponent(cell, 0), 0.0);
    }
  }
  EXPECT_EQ(behindWall, 2);
}

TEST(SunHours, NormalsHideWhatComesFromBelow)
{
  // An open sheet that faces north, far from everything: without normals it is lit from behind.
  const auto sheet = Plane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 });
  ASSERT_EQ(sheet->GetPointData()->GetNormals()->GetComponent(0, 1), 1.0);
  const auto path = Path("2023-12-10", "2023-12-11", 10.0);
  const auto filter = Hours(sheet, sheet, path);
  filter->Update();
  EXPECT_EQ(Value(filter, "SunHours"), 0.0);
  filter->UseNormalsOff();
  filter->Update();
  EXPECT_GT(Value(filter, "SunHours"), 8.0);
}

TEST(SunHours, HiddenPointsAreMarked)
{
  const auto points = PointsAt({ 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0 });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const int mark :
    { 0, static_cast<int>(vtkDataSetAttributes::HIDDENPOINT), static_cast<int>(vtkDataSetAttributes::DUPLICATEPOINT) })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(mark));
  }
  points->GetPointData()->AddArray(ghosts);
  const auto path = Path("2023-05-10", "2023-05-11", 30.0);
  const auto filter = Hours(points, Courtyard(), path);
  filter->ComputeOccludersOn();
  filter->Update();
  for (const char* name : { "SunHours", "FirstSun", "LastSun", "LongestSun", "SunHoursError" })
  {
    EXPECT_TRUE(std::isnan(Value(filter, name, 1))) << name;
    EXPECT_FALSE(std::isnan(Value(filter, name, 0))) << name;
    EXPECT_FALSE(std::isnan(Value(filter, name, 2))) << name;
  }
  EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))
              ->GetPointData()
              ->GetArray("OccluderId")
              ->GetComponent(1, 0),
    -1.0);
}

TEST(SunHours, ReceiversBlocksAndGrids)
{
  // A receiver casts no shadow; blocks of a mesh are joined; composites of places are answered block by block.
  const auto path = Path("2023-05-10", "2023-05-11", 30.0);
  MeshBuilder walls;
  walls.AddBox(0.0, -2.0, 10.0, 90.0, 0.5, 10.0, -1);
  vtkNew<vtkMultiBlockDataSet> mesh;
  mesh->SetBlock(0, walls.Build());
  mesh->SetBlock(1, Courtyard());
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(2, 2, 2);
  const auto both = Hours(grid, mesh, path);
  both->Update();
  const auto alone = Hours(grid, Courtyard(), path);
  alone->Update();
  for (vtkIdType k = 0; k < 8; ++k)
  {
    EXPECT_EQ(Value(both, "SunHours", k), Value(alone, "SunHours", k));
  }
  EXPECT_GT(Value(alone, "SunHours", 0), 1.0);
  vtkNew<vtkMultiBlockDataSet> places;
  places->SetBlock(0, grid);
  places->SetBlock(1, PointsAt({ 0.0, 0.0, 0.0 }));
  const auto iterated = Hours(places, mesh, path);
  iterated->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(iterated->GetOutputDataObject(0));
  ASSERT_NE(blocks, nullptr);
  EXPECT_EQ(vtkDataSet::SafeDownCast(blocks->GetBlock(1))->GetPointData()->GetArray("SunHours")->GetComponent(0, 0),
    Value(alone, "SunHours", 0));
}

TEST(SunHours, EmptyInEmptyOut)
{
  const auto path = Path("2023-05-10", "2023-05-11", 30.0);
  vtkNew<vtkPolyData> nothing;
  const auto nowhere = Hours(nothing, Courtyard(), path);
  Messages messages(nowhere);
  nowhere->Update();
  EXPECT_EQ(messages.Errors + messages.Warnings, "");
  EXPECT_EQ(vtkDataSet::SafeDownCast(nowhere->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  const auto open = Hours(PointsAt({ 0.0, 0.0, 0.0 }), nothing, path);
  EXPECT_EQ(ErrorsOf(open), "");
  EXPECT_GT(Value(open, "SunHours"), 14.0);
  const auto moment = Hours(PointsAt({ 0.0, 0.0, 0.0 }), nothing, Path("2023-05-10", "2023-05-10", 30.0));
  EXPECT_EQ(WarningsOf(moment) + ErrorsOf(moment), "");
  EXPECT_EQ(Value(moment, "SunHours"), 0.0);
}

TEST(SunHours, WhatMayBeWrongIsSaid)
{
  const auto winter = Path("2023-12-10", "2023-12-11", 60.0);
  winter->SetLatitude(80.0);
  const auto filter = Hours(PointsAt({ 0.0, 0.0, 0.0 }), Courtyard(), winter);
  EXPECT_SAYS(WarningsOf(filter),
    "The Sun is above MinimumAltitude, 0 degrees, in none of the 24 steps of its path: the highest is "
    "at -12.9");
  std::vector<double> inside;
  for (int k = 0; k < 12; ++k)
  {
    inside.insert(inside.end(), { 5.5, 0.1 * k, 1.0 });
  }
  const auto dark = Hours(PointsAt(inside), Courtyard(), Path("2023-05-10", "2023-05-11", 60.0));
  EXPECT_SAYS(WarningsOf(dark), "None of 12 points sees any of the light: nothing is lit.");
}

TEST(SunHours, FaultsAreSaid)
{
  const auto path = Path("2023-05-10", "2023-05-11", 30.0);
  path->Update();
  const auto changed = [&path](const std::function<void(vtkFieldData*)>& change)
  {
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(path->GetOutput());
    change(copy->GetFieldData());
    auto filter = vtkSmartPointer<vtkSunHours>::New();
    filter->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
    filter->SetMeshData(Courtyard());
    filter->SetPathData(copy);
    const std::string errors = ErrorsOf(filter);
    EXPECT_EQ(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0) << errors;
    return errors;
  };
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->RemoveArray("SunStepTime"); }),
    "The path of the Sun has no field array \"SunStepTime\": connect a vtkSunPath with SetPathConnection.");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->RemoveArray("SunStepLength"); }),
    "The Sun's path has no array \"SunStepLength\".");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->GetArray("SunStepAltitude")->SetNumberOfTuples(3); }),
    "The array \"SunStepAltitude\" of the Sun's path has 3 tuples where 48 are needed.");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->GetArray("SunStepDirection")->SetComponent(4, 1, std::nan("")); }),
    "Step 4 of the Sun's path has a number that is not finite, no direction, or no length.");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->GetArray("SunStepLength")->SetComponent(5, 0, 0.0); }),
    "Step 5 of the Sun's path");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->GetArray("SunAngularDiameter")->SetComponent(0, 0, 200.0); }),
    "The sun's angular diameter must be from 0 to 180 degrees.");
  EXPECT_SAYS(changed([](vtkFieldData* data) { data->GetArray("SunUp")->SetComponent(0, 1, std::nan("")); }),
    "\"SunUp\" of the Sun's path must be a direction.");

  const auto set = [&path](const std::function<void(vtkSunHours*)>& change)
  {
    const auto filter = Hours(PointsAt({ 0.0, 0.0, 0.0 }), Courtyard(), path);
    change(filter);
    return ErrorsOf(filter);
  };
  EXPECT_SAYS(
    set([](vtkSunHours* f) { f->SetMinimumAltitude(91.0); }), "MinimumAltitude is 91: it must be in -90..90.");
  EXPECT_SAYS(set([](vtkSunHours* f) { f->SetMinimumAltitude(std::nan("")); }), "MinimumAltitude is nan");
  EXPECT_SAYS(
    set([](vtkSunHours* f) { f->SetAssociation(2); }), "Association is 2: it must be Points (0) or Cells (1).");
  EXPECT_SAYS(
    set([](vtkSunHours* f) { f->SetNumberOfLightSamples(0); }), "NumberOfLightSamples is 0: it must be in 1..65536.");
  EXPECT_SAYS(set([](vtkSunHours* f) { f->SetInputConnection(1, nullptr); }),
    "No mesh on input port 1: connect a vtkLabelOccluders or another mesh with SetMeshConnection.");
  EXPECT_SAYS(set([](vtkSunHours* f) { f->SetInputConnection(2, nullptr); }),
    "No path of the Sun on input port 2: connect a vtkSunPath with SetPathConnection.");
  EXPECT_SAYS(set(
                [](vtkSunHours* f) {
                  f->SetMeshData(PointsAt({ 0.0, 0.0, 0.0 }));
                }),
    "The mesh on input port 1 has 1 cells and no polygon: shadows need surfaces. Run vtkLabelOccluders on it first.");
  EXPECT_SAYS(set(
                [](vtkSunHours* f) {
                  f->SetInputData(PointsAt({ 0.0, 0.0, std::nan("") }));
                }),
    "Point 0 of the data set on input port 0 has a coordinate that is not finite.");
}

TEST(SunHours, PrintsAllParameters)
{
  std::ostringstream text;
  vtkNew<vtkSunHours> filter;
  filter->Print(text);
  for (const char* name : { "MinimumAltitude: 0", "Association: Points", "NumberOfLightSamples: 64",
         "ComputeOccluders: off", "UseNormals: on", "Seed: 1" })
  {
    EXPECT_SAYS(text.str(), name);
  }
}
