// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowVolume from a mesh and lights: solids of what is truly seen, projected ones, inner cones that are proved, messages.
#include "vtkShadowVolume.h"

#include "Messages.h"
#include "SolidReference.h"
#include "SolidScenes.h"
#include "TestPolyData.h"
#include "TestSolids.h"

#include "scLightData.h"
#include "scMeshData.h"
#include "vtkVisibilityVolume.h"

#include "vtkBooleanOperationPolyDataFilter.h"
#include "vtkConeSetFilter.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{
using Filter = vtkSmartPointer<vtkShadowVolume>;
using Source = vtkSmartPointer<vtkAreaLightSource>;

Source SunAt45(double diameter)
{
  auto sun = Source::New();
  sun->SetShapeToSun();
  sun->SetNormal(1.0, 0.0, -1.0);
  sun->SetAngularDiameter(diameter);
  return sun;
}

vtkSmartPointer<vtkPolyData> House()
{
  TestMesh mesh;
  mesh.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 10.0, 20.0 });
  return ToPolyData(mesh);
}

/// The solids behind a mesh; the house's bounds unless others are set.
Filter Solids(vtkDataObject* mesh, vtkAreaLightSource* light, int method, int resolution = 32)
{
  auto filter = Filter::New();
  filter->SetMethod(method);
  filter->SetMeshData(mesh);
  filter->SetLightConnection(light->GetOutputPort());
  filter->SetBounds(10.0, 45.0, -5.0, 15.0, 0.0, 20.0);
  filter->SetResolution(resolution);
  return filter;
}

template <typename Change>
std::string Error(Change&& change)
{
  const Filter filter = Solids(House(), SunAt45(0.5), vtkShadowVolume::Visibility, 8);
  change(filter.Get());
  const std::string errors = ErrorsOf(filter);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfCells(), 0);
  return errors;
}

/// Cones of the paper, of the house under a Sun: discs that hang over its edges.
vtkSmartPointer<vtkPolyData> ConesOf(vtkPolyData* mesh, vtkAreaLightSource* light)
{
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(mesh);
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetToPaper();
  vectors->SetInputConnection(labels->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetTargetNumberOfVectors(3000);
  vectors->SetStorageToHitPoint();
  vtkNew<vtkConeSetFilter> cones;
  cones->SetToPaper();
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetExpansionToLightGeometry();
  cones->SetOverlap(true);
  cones->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(cones->GetOutput());
  return copy;
}
} // namespace

TEST(ShadowSolids, HouseUnderTheSun)
{
  const Filter filter = Solids(House(), SunAt45(0.533), vtkShadowVolume::Visibility, 48);
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors + messages.Warnings, "");
  // By 2 million random points elsewhere.
  EXPECT_NEAR(ExpectSolid(filter->GetOutput(0)), 2060.0, 0.01 * 2060.0);
  EXPECT_NEAR(ExpectSolid(filter->GetOutput(1)), 1963.0, 0.01 * 1963.0);
  EXPECT_EQ(FieldValue(filter->GetOutput(1), "InnerCertified"), 0.0);
  EXPECT_EQ(FieldValue(filter->GetOutput(1), "Method"), 1.0);
}

TEST(ShadowSolids, AgainstRandomPoints)
{
  for (const auto& [occluder, light] : { std::make_pair("plate", "disc"), { "ring", "sun" }, { "ring", "point" } })
  {
    const SolidScene scene = MakeSolidScene(occluder, light);
    vtkNew<vtkAreaLightSource> source;
    source->SetShape(static_cast<int>(scene.Lamp.Shape));
    source->SetCenter(scene.Lamp.Center.X, scene.Lamp.Center.Y, scene.Lamp.Center.Z);
    source->SetNormal(scene.Lamp.Normal.X, scene.Lamp.Normal.Y, scene.Lamp.Normal.Z);
    source->SetRadius(scene.Lamp.Shape == LightShape::Disc ? scene.Lamp.Radius : 1.0);
    source->SetAngularDiameter(2.0 * scene.Lamp.Radius * 180.0 / Pi);
    const Filter filter = Solids(ToPolyData(scene.Mesh), source, vtkShadowVolume::Visibility, 40);
    const Box& b = scene.Bounds;
    filter->SetBounds(b.Min.X, b.Max.X, b.Min.Y, b.Max.Y, b.Min.Z, b.Max.Z);
    filter->Update();
    const ReferenceVolumes truth = MeasureShadow(scene.Mesh.View(), scene.Lamp, b, 44, 16);
    const double outer = ExpectSolid(filter->GetOutput(0));
    const double inner = ExpectSolid(filter->GetOutput(1));
    EXPECT_NEAR(outer, truth.Outer, 0.01 * truth.Outer + 2.0 * truth.OuterError) << scene.Name;
    EXPECT_NEAR(inner, truth.Inner, 0.01 * truth.Inner + 2.0 * truth.InnerError) << scene.Name;
    TriangleMesh surface;
    std::string error;
    ASSERT_TRUE(ReadSurface(filter->GetOutput(1), surface, error)) << error;
    EXPECT_LE(LitShare(scene.Mesh.View(), scene.Lamp, surface.View(), b, 4000, 16), 0.002) << scene.Name;
  }
}

TEST(ShadowSolids, ProjectionOfTheHouseIsExact)
{
  const Filter filter = Solids(House(), SunAt45(0.0), vtkShadowVolume::Projection);
  filter->Update();
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_NEAR(ExpectSolid(filter->GetOutput(port)), 2000.0, 1e-6);
    EXPECT_EQ(FieldValue(filter->GetOutput(port), "InnerCertified"), 1.0);
  }
}

TEST(ShadowSolids, ProjectionOfASphere)
{
  // Under a Sun: a half ball and a cylinder, of a polyhedron; against the same by Visibility.
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 2.0 }, 1.0, 24);
  auto sun = SunAt45(0.0);
  sun->SetNormal(0.1, 0.2, -1.0);
  double volumes[2];
  for (const int method : { vtkShadowVolume::Visibility, vtkShadowVolume::Projection })
  {
    const Filter filter = Solids(ToPolyData(mesh), sun, method, 40);
    filter->SetBounds(-3.0, 3.0, -3.0, 3.0, -1.0, 4.0);
    filter->Update();
    volumes[method - 1] = ExpectSolid(filter->GetOutput(0));
  }
  const double slope = std::sqrt(1.0 + 0.01 + 0.04);
  const double exact = 2.0 / 3.0 * Pi + Pi * 3.0 * slope; // the cut through the cylinder's axis lies at z = -1
  EXPECT_NEAR(volumes[1] / exact, 1.0, 0.012);            // a ball of 48 sides is smaller by half a per cent
  EXPECT_NEAR(volumes[0] / volumes[1], 1.0, 0.006);
}

TEST(ShadowSolids, OneAnOccluderAndOneForAll)
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 0);
  mesh.AddSheet({ 0.0, -1.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 1);
  auto data = ToPolyData(mesh);
  AddIntArray(data->GetCellData(), "OccluderId", 1, { 0, 0, 1, 1 });
  const auto lamp = LampAbove(3.0, 0.4);
  const Filter filter = Solids(data, lamp, vtkShadowVolume::Visibility, 24);
  filter->SetBounds(-3.0, 3.0, -3.0, 3.0, 0.0, 2.0);
  filter->Update();
  const double alone = VolumeOf(filter->GetOutput(1));
  EXPECT_EQ(filter->GetOutput(1)->GetCellData()->GetArray("OccluderId")->GetRange()[1], 1.0);
  filter->PerOccluderOff();
  filter->Update();
  // Together they hide what each lets through.
  EXPECT_GT(ExpectSolid(filter->GetOutput(1)), 1.1 * alone);
  EXPECT_EQ(filter->GetOutput(1)->GetCellData()->GetArray("OccluderId")->GetRange()[1], -1.0);
}

TEST(ShadowSolids, VisibilityVolumeSeedsThem)
{
  const auto sun = SunAt45(0.533);
  vtkNew<vtkVisibilityVolume> volume;
  volume->SetMeshData(House());
  volume->SetLightConnection(sun->GetOutputPort());
  volume->SetDimensions(17, 11, 11);
  volume->SetBounds(10.0, 45.0, -5.0, 15.0, 0.0, 20.0);
  const Filter filter = Solids(House(), sun, vtkShadowVolume::Visibility);
  filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  filter->SetVisibilityVolumeConnection(volume->GetOutputPort());
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_NEAR(ExpectSolid(filter->GetOutput(0)), 2060.0, 0.015 * 2060.0);
}

TEST(ShadowSolids, BooleansRun)
{
  const Filter filter = Solids(House(), SunAt45(0.533), vtkShadowVolume::Visibility, 12);
  filter->Update();
  // VTK 9.1's Booleans lose parts where triangles as large as a box's sides are cut, of whatever solid.
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(20.013, 4.1, 8.07);
  ball->SetRadius(6.3);
  ball->SetThetaResolution(23);
  ball->SetPhiResolution(19);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(ball->GetOutputPort());
  triangles->Update();
  for (int port = 0; port < 2; ++port)
  {
    double parts = 0.0;
    for (const int operation :
      { vtkBooleanOperationPolyDataFilter::VTK_INTERSECTION, vtkBooleanOperationPolyDataFilter::VTK_DIFFERENCE })
    {
      vtkNew<vtkBooleanOperationPolyDataFilter> boolean;
      boolean->SetInputData(0, filter->GetOutput(port));
      boolean->SetInputData(1, triangles->GetOutput());
      boolean->SetOperation(operation);
      boolean->Update();
      parts += VolumeOf(boolean->GetOutput());
    }
    EXPECT_NEAR(parts / VolumeOf(filter->GetOutput(port)), 1.0, 1e-3);
  }
}

TEST(ShadowSolids, ProvedInnerConesSeeNoLight)
{
  // Under a hard Sun discs that hang over an edge or a hole of the mesh claim light for umbra, unless they are proved.
  const TestMesh ring = RingMesh({ 0.0, 0.0, 2.0 }, 0.35, 1.2, 48);
  const Light sun = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  const auto source = SunAt45(0.0);
  source->SetNormal(0.0, 0.0, -1.0);
  const auto cones = ConesOf(ToPolyData(ring), source);
  double lit[2];
  double volumes[2];
  for (int proved = 0; proved < 2; ++proved)
  {
    auto filter = Filter::New();
    filter->SetInputData(cones);
    if (proved)
    {
      filter->SetMeshData(ToPolyData(ring));
    }
    filter->SetBounds(-2.0, 2.0, -2.0, 2.0, 0.0, 3.0);
    filter->SetResolution(64);
    Messages messages(filter);
    filter->Update();
    EXPECT_EQ(messages.Errors, "");
    EXPECT_EQ(FieldValue(filter->GetOutput(1), "InnerCertified"), proved);
    TriangleMesh surface;
    std::string error;
    ASSERT_TRUE(ReadSurface(filter->GetOutput(1), surface, error)) << error;
    const Box bounds{ { -2.0, -2.0, 0.0 }, { 2.0, 2.0, 2.0 } };
    lit[proved] = LitShare(ring.View(), sun, surface.View(), bounds, 4000, 1);
    volumes[proved] = VolumeOf(filter->GetOutput(1));
    if (proved)
    {
      EXPECT_GT(FieldValue(filter->GetOutput(1), "NumberOfShrunkInnerCones"), 0.0);
    }
  }
  EXPECT_GT(lit[0], 0.02);
  EXPECT_LT(lit[1], 0.004); // what the contour of a cell's size makes of the cones
  EXPECT_GT(volumes[1], 0.5 * volumes[0]);
}

TEST(ShadowSolids, EmptyInEmptyOut)
{
  for (const int method : { vtkShadowVolume::Visibility, vtkShadowVolume::Projection })
  {
    const Filter filter = Solids(vtkSmartPointer<vtkPolyData>::New(), SunAt45(0.0), method);
    EXPECT_EQ(ErrorsOf(filter), "");
    EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
    EXPECT_TRUE(filter->GetOutput(0)->GetCellData()->GetArray("OccluderId"));
  }
}

TEST(ShadowSolids, Messages)
{
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetMethod(3); }), "Method is 3");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetNumberOfLightSamples(0); }), "NumberOfLightSamples is 0");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetMethodToCones(); }), "No cone set on input port 0");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetMeshConnection(nullptr); }), "need the mesh on input port 2");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->RemoveAllLights(); }), "need a light on input port 3");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetMethodToProjection(); }), "Light 0 has a width");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetLightConnection(SunAt45(175.0)->GetOutputPort()); }), "171 degrees");
  EXPECT_SAYS(Error(
                [](vtkShadowVolume* f)
                {
                  f->SetMethodToProjection();
                  f->SetMeshData(ToPolyData(RingMesh({ 0.0, 0.0, 2.0 }, 0.5, 1.0, 12)));
                  f->SetLightConnection(SunAt45(0.0)->GetOutputPort());
                  f->SetBounds(-3.0, 3.0, -3.0, 3.0, -3.0, 3.0);
                }),
    "Occluder 0 is neither a closed convex body");
  EXPECT_SAYS(Error([](vtkShadowVolume* f) { f->SetMeshData(PointsAt({ 0.0, 0.0, 0.0 })); }), "no polygon");
  // Two boxes in one solid.
  TestMesh two;
  two.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  two.AddBox({ 3.0, 0.0, 0.0 }, { 4.0, 1.0, 1.0 });
  const Filter filter = Solids(ToPolyData(two), SunAt45(0.0), vtkShadowVolume::Projection);
  filter->SetBounds(-5.0, 5.0, -5.0, 5.0, -5.0, 5.0);
  EXPECT_SAYS(WarningsOf(filter), "1 of 1 solids are made of several convex parts");
}
