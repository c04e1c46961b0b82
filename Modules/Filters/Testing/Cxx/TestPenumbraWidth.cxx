// SPDX-License-Identifier: BSD-3-Clause
// Widths of penumbrae against closed forms: a straight edge under a disc and under the Sun, across it and along a line.
#include "Messages.h"
#include "TestPolyData.h"

#include "vtkPenumbraWidth.h"

#include "vtkAppendPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkLineSource.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// The place of a straight edge across a disc of radius 1 that leaves the share @p v of it seen: -1..1.
double EdgeOf(double v)
{
  double low = -1.0;
  double high = 1.0;
  for (int k = 0; k < 60; ++k)
  {
    const double t = 0.5 * (low + high);
    const double share = (std::acos(-t) + t * std::sqrt(1.0 - t * t)) / pi;
    (share < v ? low : high) = t;
  }
  return low;
}

/// A wall at z = 2 over all x above 0.
vtkSmartPointer<vtkPolyData> HalfWall()
{
  return Plane({ 0.0, -50.0, 2.0 }, { 50.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
}

/// The floor, of so many points along x and y.
vtkSmartPointer<vtkPolyData> Floor(double half, int points, int rows)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-half, -half, 0.0);
  plane->SetPoint1(half, -half, 0.0);
  plane->SetPoint2(-half, half, 0.0);
  plane->SetResolution(points - 1, rows - 1);
  plane->Update();
  return plane->GetOutput();
}

vtkSmartPointer<vtkPolyData> Line(double fromX, double fromY, double toX, double toY)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(fromX, fromY, 0.0);
  line->SetPoint2(toX, toY, 0.0);
  line->Update();
  return line->GetOutput();
}

vtkSmartPointer<vtkPenumbraWidth> Widths(vtkPolyData* where, vtkAlgorithmOutput* light, vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkPenumbraWidth>::New();
  filter->SetInputData(where);
  filter->SetLightConnection(light);
  filter->SetMeshData(mesh);
  return filter;
}

vtkDataArray* PointArray(vtkPenumbraWidth* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

vtkDataArray* LineArray(vtkPenumbraWidth* filter, const char* name)
{
  return filter->GetOutput(1)->GetCellData()->GetArray(name);
}
} // anonymous namespace

TEST(PenumbraWidth, AStraightEdgeUnderADisc)
{
  // The lamp at z = 4, the edge at z = 2: from (x, 0, 0) the edge covers the lamp's plane from -x on.
  const auto lamp = LampAbove(4.0, 0.4);
  const double exact = 0.4 * (EdgeOf(0.95) - EdgeOf(0.05));
  const auto filter = Widths(Floor(0.5, 11, 2), lamp->GetOutputPort(), HalfWall());
  filter->SetNumberOfLightSamples(2048);
  EXPECT_EQ(ErrorsOf(filter), "");
  vtkDataArray* widths = ArrayOf(filter->GetOutput()->GetPointData(), "PenumbraWidth", VTK_FLOAT, 1);
  vtkDataArray* errors = ArrayOf(filter->GetOutput()->GetPointData(), "PenumbraWidthError", VTK_FLOAT, 1);
  int measured = 0;
  for (vtkIdType i = 0; i < widths->GetNumberOfTuples(); ++i)
  {
    const double x = filter->GetOutput()->GetPoint(i)[0];
    if (std::fabs(x) > 0.4)
    {
      EXPECT_TRUE(std::isnan(widths->GetComponent(i, 0))) << "lit, or in umbra: " << x;
    }
    else if (std::fabs(x) < 0.39)
    {
      EXPECT_NEAR(widths->GetComponent(i, 0) / exact, 1.0, 0.01) << x;
      EXPECT_LT(std::fabs(widths->GetComponent(i, 0) - exact), errors->GetComponent(i, 0)) << x;
      ++measured;
    }
  }
  EXPECT_EQ(measured, 7 * 2);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfLines(), measured);
  double* dark = filter->GetOutput(1)->GetPoint(0);
  EXPECT_NEAR(dark[0], -0.4 * EdgeOf(0.05), 0.01) << "from Lower to Upper: the dark end lies under the wall";
  EXPECT_EQ(LineArray(filter, "OccluderId")->GetComponent(0, 0), 0.0);
}

TEST(PenumbraWidth, AStraightEdgeUnderTheSun)
{
  // The Sun at its zenith: the width is that of its disc's chord, at the height of the edge; flat, as its angle is small.
  vtkNew<vtkAreaLightSource> sun;
  sun->SetShapeToSun();
  sun->SetNormal(0.0, 0.0, -1.0);
  const double radius = 2.0 * std::tan(0.5 * 0.533 * pi / 180.0);
  const double exact = radius * (EdgeOf(0.95) - EdgeOf(0.05));
  const auto line = Widths(Line(-1.0, 0.0, 1.0, 0.0), sun->GetOutputPort(), HalfWall());
  line->SetNumberOfLightSamples(4096);
  EXPECT_EQ(ErrorsOf(line), "");
  ASSERT_EQ(line->GetOutput(1)->GetNumberOfLines(), 1);
  EXPECT_NEAR(LineArray(line, "PenumbraWidth")->GetComponent(0, 0) / exact, 1.0, 0.01);
  EXPECT_TRUE(std::isnan(PointArray(line, "PenumbraWidth")->GetComponent(0, 0))) << "its ends lie beyond";
  EXPECT_EQ(PointArray(line, "Visibility")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(PointArray(line, "Visibility")->GetComponent(1, 0), 0.0);

  // On a floor that leans by 60 degrees towards the edge's shadow the width is twice as long.
  const double tilt = std::sqrt(3.0);
  auto point = PointsAt({ 0.0, 0.0, 0.0 });
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(-tilt, 0.0, 1.0);
  point->GetPointData()->SetNormals(normals);
  const auto leaning = Widths(point, sun->GetOutputPort(), HalfWall());
  leaning->SetNumberOfLightSamples(4096);
  leaning->SetMaximumDistance(1.0);
  EXPECT_EQ(ErrorsOf(leaning), "");
  EXPECT_NEAR(PointArray(leaning, "PenumbraWidth")->GetComponent(0, 0) / (2.0 * exact), 1.0, 0.02);
}

TEST(PenumbraWidth, AlongALineItIsTheWayAcrossTheEdge)
{
  // A line at 45 degrees takes root 2 times as long; a strip has an edge on either side.
  const auto lamp = LampAbove(4.0, 0.4);
  const auto strip = Plane({ -1.0, -50.0, 2.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
  const double exact = 0.4 * (EdgeOf(0.95) - EdgeOf(0.05));
  const auto filter = Widths(Line(-4.0, -4.0, 4.0, 4.0), lamp->GetOutputPort(), strip);
  filter->SetNumberOfLightSamples(2048);
  EXPECT_EQ(ErrorsOf(filter), "");
  ASSERT_EQ(filter->GetOutput(1)->GetNumberOfLines(), 2);
  for (vtkIdType k = 0; k < 2; ++k)
  {
    EXPECT_NEAR(LineArray(filter, "PenumbraWidth")->GetComponent(k, 0) / (std::sqrt(2.0) * exact), 1.0, 0.02);
    EXPECT_EQ(LineArray(filter, "InputId")->GetComponent(k, 0), 0.0);
  }
  double ends[4][3];
  for (vtkIdType k = 0; k < 4; ++k)
  {
    filter->GetOutput(1)->GetPoint(k, ends[k]);
  }
  EXPECT_LT(ends[1][0], ends[0][0]) << "bright on the outside";
  EXPECT_GT(ends[3][0], ends[2][0]);
  filter->SetLower(0.25);
  filter->SetUpper(0.75);
  filter->Update();
  EXPECT_NEAR(
    LineArray(filter, "PenumbraWidth")->GetComponent(0, 0), std::sqrt(2.0) * 0.4 * (EdgeOf(0.75) - EdgeOf(0.25)), 0.01);
}

TEST(PenumbraWidth, ATwigHasNoUmbraAndAPointLightNoPenumbra)
{
  const auto lamp = LampAbove(4.0, 0.4);
  const auto twig = Plane({ -0.05, -50.0, 2.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
  const auto filter = Widths(Floor(0.6, 7, 7), lamp->GetOutputPort(), twig);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfLines(), 0) << "the fraction never falls to 5 %";
  vtkNew<vtkAreaLightSource> bulb;
  bulb->SetShapeToPoint();
  bulb->SetCenter(0.0, 0.0, 4.0);
  const auto hard = Widths(Floor(0.6, 7, 7), bulb->GetOutputPort(), HalfWall());
  EXPECT_EQ(ErrorsOf(hard), "");
  EXPECT_EQ(hard->GetOutput(1)->GetNumberOfLines(), 0);
  EXPECT_EQ(hard->GetOutput()->GetNumberOfPoints(), 49);
}

TEST(PenumbraWidth, LampsNamesAndHiddenPoints)
{
  const auto a = LampAbove(4.0, 0.4);
  const auto b = LampAbove(4.0, 0.2);
  const auto wall = HalfWall();
  vtkNew<vtkIntArray> ids;
  ids->SetName("OccluderId");
  ids->InsertNextValue(77);
  wall->GetCellData()->AddArray(ids);
  const auto floor = Floor(0.1, 3, 3);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->SetNumberOfValues(9);
  ghosts->FillValue(0);
  ghosts->SetValue(4, 2);
  floor->GetPointData()->AddArray(ghosts);
  const auto filter = Widths(floor, a->GetOutputPort(), wall);
  filter->AddLightConnection(b->GetOutputPort());
  EXPECT_EQ(ErrorsOf(filter), "");
  vtkDataArray* widths = ArrayOf(filter->GetOutput()->GetPointData(), "PenumbraWidth", VTK_FLOAT, 2);
  EXPECT_NEAR(widths->GetComponent(0, 0) / widths->GetComponent(0, 1), 2.0, 0.05);
  EXPECT_TRUE(std::isnan(widths->GetComponent(4, 0)));
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfLines(), 16);
  for (int port = 0; port < 2; ++port)
  {
    auto* names =
      vtkStringArray::SafeDownCast(filter->GetOutput(port)->GetFieldData()->GetAbstractArray("OccluderNames"));
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(names->GetValue(0), "77");
  }
  EXPECT_EQ(LineArray(filter, "LightId")->GetComponent(1, 0), 1.0);
}

TEST(PenumbraWidth, ASurfaceInTheMeshHidesNothingOfItself)
{
  // A floor that leans, in single precision, wound either way and without normals: with it in the mesh and without.
  const auto lamp = LampAbove(4.0, 0.4);
  for (const bool up : { true, false })
  {
    const Vector3 along{ 0.6, 0.0, 0.07 };
    const Vector3 beside{ 0.0, 0.6, 0.03 };
    const auto leaning = Plane({ -0.3, -0.3, 0.0 }, up ? along : beside, up ? beside : along);
    vtkNew<vtkPlaneSource> fine;
    fine->SetOrigin(leaning->GetPoint(0));
    fine->SetPoint1(leaning->GetPoint(1));
    fine->SetPoint2(leaning->GetPoint(2));
    fine->SetResolution(6, 6);
    fine->Update();
    vtkPolyData* floor = fine->GetOutput();
    floor->GetPointData()->SetNormals(nullptr);
    vtkNew<vtkAppendPolyData> both;
    const auto wall = HalfWall();
    both->AddInputData(wall);
    both->AddInputData(floor);
    both->Update();
    const auto alone = Widths(floor, lamp->GetOutputPort(), wall);
    const auto with = Widths(floor, lamp->GetOutputPort(), both->GetOutput());
    EXPECT_EQ(ErrorsOf(alone) + ErrorsOf(with), "");
    EXPECT_GT(alone->GetOutput(1)->GetNumberOfLines(), 30) << up;
    ASSERT_EQ(with->GetOutput(1)->GetNumberOfLines(), alone->GetOutput(1)->GetNumberOfLines()) << up;
    for (vtkIdType k = 0; k < with->GetOutput(1)->GetNumberOfLines(); ++k)
    {
      EXPECT_NEAR(LineArray(with, "PenumbraWidth")->GetComponent(k, 0),
        LineArray(alone, "PenumbraWidth")->GetComponent(k, 0), 0.02) << up << " " << k;
    }
  }
}

TEST(PenumbraWidth, SaysWhatIsWrong)
{
  const auto lamp = LampAbove(4.0, 0.4);
  const auto filter = Widths(Floor(0.5, 3, 3), lamp->GetOutputPort(), HalfWall());
  filter->SetLower(0.96);
  EXPECT_SAYS(ErrorsOf(filter), "Lower is 0.96: it must be above 0 and below Upper.");
  filter->SetLower(0.05);
  filter->SetUpper(1.0);
  EXPECT_SAYS(ErrorsOf(filter), "Upper is 1: it must be below 1.");
  filter->SetUpper(0.95);
  filter->SetSamplesPerLine(1);
  EXPECT_SAYS(ErrorsOf(filter), "SamplesPerLine is 1: it must be in 2..1000000.");
  filter->SetSamplesPerLine(256);
  filter->SetMaximumDistance(-1.0);
  EXPECT_SAYS(ErrorsOf(filter), "MaximumDistance is -1: it must be 0 or above and finite.");
  filter->SetMaximumDistance(0.0);
  filter->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
  EXPECT_SAYS(ErrorsOf(filter), "neither polygons nor lines");
  filter->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
  filter->SetInputData(Floor(0.5, 3, 3));
  filter->RemoveAllLights();
  EXPECT_SAYS(ErrorsOf(filter), "No light on input port 1");
  filter->SetLightConnection(lamp->GetOutputPort());
  filter->SetMeshConnection(nullptr);
  EXPECT_SAYS(ErrorsOf(filter), "No mesh on input port 2");
  filter->SetMeshData(PointsAt({ 0.0, 0.0, 0.0 }));
  EXPECT_SAYS(ErrorsOf(filter), "has 1 cells and no polygon");
}
