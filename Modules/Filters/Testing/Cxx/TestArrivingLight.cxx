// SPDX-License-Identifier: BSD-3-Clause
// Irradiance, fluence rate and illuminance of the probe, and the fluence rate of the volume, against closed forms.
#include "Messages.h"
#include "TestPolyData.h"

#include "vtkConeSetProbe.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVisibilityVolume.h"

#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Points with one normal for all.
vtkSmartPointer<vtkPolyData> SurfacePoints(const std::vector<double>& coordinates, const Vector3& normal)
{
  auto points = PointsAt(coordinates);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(normal.X, normal.Y, normal.Z);
  }
  points->GetPointData()->SetNormals(normals);
  return points;
}

/// A sheet at the height z over x from..to, as wide as can be.
vtkSmartPointer<vtkPolyData> Sheet(double from, double to, double z)
{
  return Plane({ from, -50.0, z }, { to - from, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
}

/// Out of the way of every test.
vtkSmartPointer<vtkPolyData> Nothing()
{
  return Plane({ 0.0, 0.0, -900.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
}

vtkSmartPointer<vtkConeSetProbe> Probe(vtkPolyData* points, vtkAreaLightSource* light, vtkPolyData* mesh)
{
  auto probe = vtkSmartPointer<vtkConeSetProbe>::New();
  probe->SetInputData(points);
  probe->SetLightConnection(light->GetOutputPort());
  probe->SetMeshData(mesh);
  probe->SetNumberOfLightSamples(4096);
  probe->ComputeIrradianceOn();
  probe->ComputeFluenceRateOn();
  probe->Update();
  return probe;
}

double Value(vtkConeSetProbe* probe, const char* name, vtkIdType point = 0, int component = 0)
{
  vtkDataArray* array = probe->GetOutput()->GetPointData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(point, component) : -1.0;
}

/// Howell's B-3: an element parallel to a rectangle a by b at the distance c, below one of its corners.
double CornerFactor(double a, double b, double c)
{
  const double A = a / c;
  const double B = b / c;
  return (A / std::sqrt(1.0 + A * A) * std::atan(B / std::sqrt(1.0 + A * A)) +
           B / std::sqrt(1.0 + B * B) * std::atan(A / std::sqrt(1.0 + B * B))) /
    (2.0 * pi);
}

/// A rectangle 2 by 1 at z = 2 that faces down, one corner above the origin.
vtkSmartPointer<vtkAreaLightSource> Panel()
{
  auto panel = vtkSmartPointer<vtkAreaLightSource>::New();
  panel->SetShapeToRectangle();
  panel->SetCenter(1.0, 0.5, 2.0);
  panel->SetNormal(0.0, 0.0, -1.0);
  panel->SetUp(0.0, 1.0, 0.0);
  panel->SetWidth(2.0);
  panel->SetHeight(1.0);
  return panel;
}
} // anonymous namespace

TEST(ArrivingLight, WithNothingInTheWayItIsTheClosedForm)
{
  const auto lamp = LampAbove(3.0, 0.7);
  lamp->SetRadiance(2.0);
  lamp->SetRadianceSpectrum(1, 5.0);
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }), lamp, Nothing());
  const double factor = pi * 0.49 / 9.49;
  EXPECT_NEAR(Value(probe, "Irradiance"), 2.0 * factor, 1e-6);
  EXPECT_NEAR(Value(probe, "Irradiance", 0, 1), 5.0 * factor, 1e-6);
  EXPECT_NEAR(Value(probe, "FluenceRate"), 2.0 * 2.0 * pi * (1.0 - 3.0 / std::sqrt(9.49)), 1e-6);
  ArrayOf(probe->GetOutput()->GetPointData(), "Irradiance", VTK_FLOAT, 7);
  ArrayOf(probe->GetOutput()->GetPointData(), "IrradianceError", VTK_FLOAT, 7);
  ArrayOf(probe->GetOutput()->GetPointData(), "FluenceRate", VTK_FLOAT, 7);
  ArrayOf(probe->GetOutput()->GetPointData(), "FluenceRateError", VTK_FLOAT, 7);
  EXPECT_GT(Value(probe, "IrradianceError"), 0.0) << "rays were sent everywhere: a sliver may hide";
  // Cones that do not reach the point: nothing is sampled, and nothing is in doubt.
  probe->SetConeSetData(ConeSetOf({}));
  probe->Update();
  EXPECT_EQ(Value(probe, "IrradianceError"), 0.0);
  EXPECT_EQ(Value(probe, "FluenceRateError"), 0.0);
}

TEST(ArrivingLight, HalfADiscBehindAStraightEdge)
{
  // A wall whose edge passes under the middle of the disc hides half of it from below; both halves bring the same.
  const auto lamp = LampAbove(3.0, 0.7);
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), lamp, Sheet(0.0, 50.0, 1.0));
  EXPECT_NEAR(Value(probe, "Irradiance"), 0.5 * pi * 0.49 / 9.49, 3e-4);
  EXPECT_NEAR(Value(probe, "FluenceRate"), pi * (1.0 - 3.0 / std::sqrt(9.49)), 3e-4);
  EXPECT_LT(std::fabs(Value(probe, "Irradiance") - 0.5 * pi * 0.49 / 9.49), Value(probe, "IrradianceError"));
}

TEST(ArrivingLight, WhatIsLeftOfARectangleIsARectangle)
{
  // From the origin a sheet at z = 1 over x from 0.25 on hides the panel beyond x = 0.5.
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), Panel(), Sheet(0.25, 50.0, 1.0));
  const double whole = pi * CornerFactor(2.0, 1.0, 2.0);
  const double left = pi * CornerFactor(0.5, 1.0, 2.0);
  EXPECT_GT(left / whole, 0.3) << "near parts count for more than their area";
  EXPECT_NEAR(Value(probe, "Visibility"), 0.25, 2e-3);
  EXPECT_NEAR(Value(probe, "Irradiance") / left, 1.0, 3e-3);
  EXPECT_LT(std::fabs(Value(probe, "Irradiance") - left), 2.0 * Value(probe, "IrradianceError"));
  const double solidAngle = std::asin(0.5 * 1.0 / std::sqrt((0.25 + 4.0) * (1.0 + 4.0)));
  EXPECT_NEAR(Value(probe, "FluenceRate") / solidAngle, 1.0, 3e-3);
}

TEST(ArrivingLight, ASunAndAPillar)
{
  vtkNew<vtkAreaLightSource> sun;
  sun->SetShapeToSun();
  sun->SetNormal(-1.0, 0.0, -1.0);
  sun->SetRadiance(800.0);
  MeshBuilder pillar;
  pillar.AddBox(0.0, 0.0, 1.0, 0.2, 0.2, 1.0, 0);
  const auto probe =
    Probe(SurfacePoints({ -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, -5.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), sun, pillar.Build());
  EXPECT_EQ(Value(probe, "Irradiance", 0), 0.0) << "behind the pillar";
  EXPECT_EQ(Value(probe, "FluenceRate", 0), 0.0);
  for (const vtkIdType lit : { 1, 2 })
  {
    EXPECT_NEAR(Value(probe, "Irradiance", lit), 800.0 / std::sqrt(2.0), 0.01);
    EXPECT_NEAR(Value(probe, "FluenceRate", lit), 800.0, 0.01);
  }
  vtkNew<vtkAreaLightSource> bulb;
  bulb->SetShapeToPoint();
  bulb->SetCenter(3.0, 0.0, 1.0);
  bulb->SetRadiance(10.0);
  probe->SetLightConnection(bulb->GetOutputPort());
  probe->Update();
  EXPECT_EQ(Value(probe, "FluenceRate", 0), 0.0);
  EXPECT_NEAR(Value(probe, "FluenceRate", 1), 10.0 / 5.0, 1e-6);
  EXPECT_NEAR(Value(probe, "Irradiance", 1), 10.0 / 5.0 / std::sqrt(5.0), 1e-6);
  EXPECT_EQ(Value(probe, "IrradianceError", 1), 0.0) << "a point has no samples to err";
}

TEST(ArrivingLight, TheHorizonOfTheSurfaceCutsTheLamp)
{
  // A wall below the middle of a lamp whose axis lies in it sees half of the lamp.
  const auto lamp = LampAbove(3.0, 0.7);
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }), lamp, Nothing());
  const auto integrand = [](double radius, double angle)
  { return radius * radius * std::cos(angle) * 3.0 / std::pow(9.0 + radius * radius, 2); };
  double sum = 0.0;
  constexpr int steps = 400;
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; j < steps; ++j)
    {
      sum += integrand(0.7 * (i + 0.5) / steps, pi * ((j + 0.5) / steps - 0.5)) * 0.7 / steps * pi / steps;
    }
  }
  EXPECT_NEAR(Value(probe, "Irradiance") / sum, 1.0, 1e-5);
  EXPECT_NEAR(Value(probe, "FluenceRate"), pi * (1.0 - 3.0 / std::sqrt(9.49)), 1e-3) << "the half above the surface";
  probe->UseNormalsOff();
  probe->ComputeIrradianceOff();
  probe->Update();
  EXPECT_NEAR(Value(probe, "FluenceRate"), 2.0 * pi * (1.0 - 3.0 / std::sqrt(9.49)), 1e-6) << "all of it";
}

TEST(ArrivingLight, LampsAddUp)
{
  const auto points = SurfacePoints({ 0.3, 0.1, 0.0 }, { 0.0, 0.0, 1.0 });
  const auto a = LampAbove(3.0, 0.7);
  const auto b = Panel();
  b->SetRadiance(3.0);
  const auto mesh = Sheet(0.3, 50.0, 1.0);
  const auto first = Probe(points, a, mesh);
  const auto second = Probe(points, b, mesh);
  const auto both = Probe(points, a, mesh);
  both->AddLightConnection(b->GetOutputPort());
  both->Update();
  for (const char* name : { "Irradiance", "FluenceRate" })
  {
    EXPECT_NEAR(Value(both, name), Value(first, name) + Value(second, name), 1e-6) << name;
  }
  EXPECT_NEAR(Value(both, "IrradianceError"),
    std::hypot(Value(first, "IrradianceError"), Value(second, "IrradianceError")), 1e-7);
}

TEST(ArrivingLight, LuxFromTheEyesCurveOrFromWeights)
{
  const auto lamp = LampAbove(3.0, 0.7);
  lamp->SetNumberOfWavelengths(1); // a band around 550 nm
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), lamp, Nothing());
  probe->ComputeIlluminanceOn();
  probe->Update();
  const double irradiance = pi * 0.49 / 9.49;
  EXPECT_NEAR(Value(probe, "Illuminance") / (683.0 * 0.995 * irradiance), 1.0, 0.01) << "V(550 nm) is 0.995";
  EXPECT_EQ(probe->GetLuminousEfficacySpectrum(0), -1.0);
  probe->SetLuminousEfficacySpectrum(0, 100.0);
  probe->Update();
  EXPECT_NEAR(Value(probe, "Illuminance"), 100.0 * irradiance, 1e-4);
  EXPECT_NEAR(Value(probe, "IlluminanceError") / Value(probe, "IrradianceError"), 100.0, 1e-3);
  probe->SetLuminousEfficacySpectrum(4, 1.0);
  EXPECT_SAYS(ErrorsOf(probe), "LuminousEfficacySpectrum is 1 at index 4: the index must be that of one of the 1 wave");
  probe->ClearLuminousEfficacySpectrum();
  EXPECT_EQ(ErrorsOf(probe), "");
}

TEST(ArrivingLight, NeedsNormalsAndLeavesHiddenPointsOut)
{
  const auto lamp = LampAbove(3.0, 0.7);
  const auto bare = PointsAt({ 0.0, 0.0, 0.0, 0.1, 0.0, 0.0 });
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), lamp, Nothing());
  probe->SetInputData(bare);
  EXPECT_SAYS(ErrorsOf(probe), "Irradiance and illuminance need the active normals of the points");
  EXPECT_EQ(probe->GetOutput()->GetNumberOfPoints(), 0);
  probe->UseNormalsOff();
  EXPECT_SAYS(ErrorsOf(probe), "Irradiance and illuminance need normals: turn UseNormals on.");
  probe->UseNormalsOn();
  const auto points = SurfacePoints({ 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.2, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  points->GetPointData()->GetNormals()->SetTuple3(1, 0.0, 0.0, 0.0);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  for (const int ghost : { 0, 0, 2 })
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(ghost));
  }
  points->GetPointData()->AddArray(ghosts);
  probe->SetInputData(points);
  probe->Update();
  EXPECT_GT(Value(probe, "Irradiance", 0), 0.1);
  EXPECT_TRUE(std::isnan(Value(probe, "Irradiance", 1))) << "no direction to face";
  EXPECT_GT(Value(probe, "FluenceRate", 1), 0.1);
  EXPECT_TRUE(std::isnan(Value(probe, "FluenceRate", 2))) << "hidden";
  // Nothing in gives the arrays all the same.
  probe->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_EQ(ErrorsOf(probe), "");
  ArrayOf(probe->GetOutput()->GetPointData(), "Irradiance", VTK_FLOAT, 7);
}

TEST(ArrivingLight, SoftDiscsHideTheirShareToo)
{
  // A disc that hides the middle of the lamp from the origin: half its radius as seen there.
  Cone disc;
  disc.Center = { 0.0, 0.0, 1.5 };
  disc.Axis = { 0.0, 0.0, -1.0 };
  disc.Normal = disc.Axis;
  disc.BaseRadius = 0.5 * 0.7 * 0.5;
  disc.OccluderId = 0;
  const auto lamp = LampAbove(3.0, 0.7);
  const auto probe = Probe(SurfacePoints({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }), lamp, Nothing());
  probe->SetConeSetData(ConeSetOf({ disc }));
  probe->SetMethodToSoft();
  probe->Update();
  const double hidden = pi * 0.1225 / 9.1225;
  EXPECT_NEAR(Value(probe, "Irradiance"), pi * 0.49 / 9.49 - hidden, 1e-3);
}

TEST(ArrivingLight, OnAGridItIsWhatTheProbeFinds)
{
  const auto lamp = LampAbove(3.0, 0.7);
  lamp->SetRadianceSpectrum(2, 4.0);
  vtkNew<vtkVisibilityVolume> volume;
  volume->SetLightConnection(lamp->GetOutputPort());
  volume->SetMeshData(Sheet(0.0, 50.0, 1.0));
  volume->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 3.5);
  volume->SetDimensions(5, 5, 10);
  volume->SetNumberOfLightSamples(256);
  volume->ComputeFluenceRateOn();
  volume->Update();
  vtkImageData* grid = volume->GetOutput();
  vtkDataArray* fluence = ArrayOf(grid->GetPointData(), "FluenceRate", VTK_FLOAT, 7);
  vtkDataArray* errors = ArrayOf(grid->GetPointData(), "FluenceRateError", VTK_FLOAT, 7);
  const vtkIdType below = grid->FindPoint(0.0, 0.0, 0.0);
  EXPECT_NEAR(fluence->GetComponent(below, 0), pi * (1.0 - 3.0 / std::sqrt(9.49)), 2e-3) << "half of the disc";
  EXPECT_NEAR(fluence->GetComponent(below, 2), 4.0 * fluence->GetComponent(below, 0), 1e-6);
  EXPECT_GT(errors->GetComponent(below, 0), 0.0);
  const vtkIdType above = grid->FindPoint(0.0, 0.0, 3.5);
  EXPECT_EQ(fluence->GetComponent(above, 0), 0.0) << "behind the lamp";
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(grid);
  probe->SetLightConnection(lamp->GetOutputPort());
  probe->SetMeshData(Sheet(0.0, 50.0, 1.0));
  probe->SetNumberOfLightSamples(256);
  probe->ComputeFluenceRateOn();
  probe->Update();
  vtkDataArray* same = probe->GetOutput()->GetPointData()->GetArray("FluenceRate");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(fluence->GetComponent(i, 0), same->GetComponent(i, 0), 1e-6) << i;
  }
}
