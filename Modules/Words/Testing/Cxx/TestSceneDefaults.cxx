// SPDX-License-Identifier: BSD-3-Clause
// Lamp, camera and medium that suit a mesh: a thing, a room, a closed room, a plain box, something flat.
#include "vtkSceneDefaults.h"

#include "Messages.h"
#include "TestPolyData.h"
#include "vtkAreaLightSource.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{

// A box of walls without thickness, 4 wide, 3 high (y), 6 deep, with some sides: 0, 1 x, 2, 3 y, 4, 5 z.
MeshBuilder Walls(const std::vector<int>& sides)
{
  MeshBuilder mesh;
  constexpr int quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  for (int i = 0; i < 8; ++i)
  {
    mesh.AddPoint(i & 1 ? 2.0 : -2.0, i & 2 ? 3.0 : 0.0, i & 4 ? 3.0 : -3.0);
  }
  for (const int side : sides)
  {
    mesh.AddQuad(quads[side][0], quads[side][1], quads[side][2], quads[side][3], 0);
  }
  return mesh;
}

struct Scene
{
  explicit Scene(vtkPolyData* mesh, vtkAreaLightSource* light = nullptr)
  {
    this->Defaults->SetMesh(mesh);
    if (light)
    {
      light->Update();
      this->Defaults->AddLight(light->GetOutput());
    }
    EXPECT_TRUE(this->Defaults->Find()) << this->Defaults->GetError();
    this->Defaults->PlaceLight(this->Light);
    this->Defaults->PlaceCamera(this->Camera, 1.5);
    this->Defaults->GetMediumBounds(this->Medium.data());
  }
  // Where a point is seen: across and up, within -1 .. 1 in the picture.
  std::array<double, 2> Seen(double x, double y, double z)
  {
    double point[4] = { x, y, z, 1.0 };
    double seen[4];
    this->Camera->GetProjectionTransformMatrix(1.5, -1.0, 1.0);
    vtkMatrix4x4* matrix = this->Camera->GetCompositeProjectionTransformMatrix(1.5, -1.0, 1.0);
    matrix->MultiplyPoint(point, seen);
    return { seen[0] / seen[3], seen[1] / seen[3] };
  }

  vtkNew<vtkSceneDefaults> Defaults;
  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkCamera> Camera;
  std::array<double, 6> Medium;
};

} // namespace

TEST(SceneDefaults, AThingIsLitFromAboveAndSeenWhole)
{
  Scene scene(MeshBuilder().AddBox(10.0, 21.0, 30.0, 1.0, 1.0, 0.8, 0).Build());
  EXPECT_FALSE(scene.Defaults->IsRoom());
  EXPECT_EQ(scene.Defaults->GetFoundUp(), vtkSceneDefaults::Y);
  EXPECT_GT(scene.Light->GetCenter()[1], 22.0);
  EXPECT_LT(scene.Light->GetNormal()[1], -0.5);
  EXPECT_EQ(scene.Medium[2], 20.0); // the ground
  EXPECT_GE(scene.Medium[3], scene.Light->GetCenter()[1]);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (const double seen : scene.Seen(9.0 + 2.0 * (corner & 1), 20.0 + 2.0 * (corner >> 1 & 1), 29.2 + 1.6 * (corner >> 2)))
    {
      largest = std::max(largest, std::fabs(seen));
    }
  }
  for (const double seen :
    scene.Seen(scene.Light->GetCenter()[0], scene.Light->GetCenter()[1], scene.Light->GetCenter()[2]))
  {
    largest = std::max(largest, std::fabs(seen));
  }
  // All of it and the lamp, and no further away than that takes.
  EXPECT_LT(largest, 1.0);
  EXPECT_GT(largest, 0.75);
  EXPECT_GT(scene.Defaults->GetSigmaS(), 0.0);
}

TEST(SceneDefaults, TheSameAtAnySizeAndPlace)
{
  Scene small(MeshBuilder().AddBox(0.0, 0.0, 0.0, 1.0, 1.0, 0.8, 0).Build());
  Scene large(MeshBuilder().AddBox(5000.0, 0.0, 0.0, 1000.0, 1000.0, 800.0, 0).Build());
  EXPECT_NEAR(large.Light->GetRadius(), 1000.0 * small.Light->GetRadius(), 1e-9);
  EXPECT_NEAR(large.Light->GetCenter()[1], 1000.0 * small.Light->GetCenter()[1], 1e-9);
  EXPECT_NEAR(large.Light->GetCenter()[0], 5000.0 + 1000.0 * small.Light->GetCenter()[0], 1e-9);
  EXPECT_NEAR(large.Defaults->GetSigmaS(), small.Defaults->GetSigmaS() / 1000.0, 1e-12);
}

TEST(SceneDefaults, OpenRoomHasItsLampUnderTheCeilingAndTheCameraBeforeTheOpenSide)
{
  Scene scene(Walls({ 0, 1, 2, 3, 5 }).Build()); // open towards -z
  EXPECT_TRUE(scene.Defaults->IsRoom());
  EXPECT_NEAR(scene.Light->GetCenter()[0], 0.0, 1e-12);
  EXPECT_LT(scene.Light->GetCenter()[1], 3.0);
  EXPECT_GT(scene.Light->GetCenter()[1], 2.9);
  EXPECT_EQ(scene.Light->GetNormal()[1], -1.0);
  EXPECT_LT(scene.Camera->GetPosition()[2], -3.0);
  EXPECT_EQ(scene.Medium, (std::array<double, 6>{ -2.0, 2.0, 0.0, 3.0, -3.0, 3.0 }));
}

TEST(SceneDefaults, ClosedRoomHasItsCameraInside)
{
  Scene scene(Walls({ 0, 1, 2, 3, 4, 5 }).AddBox(0.5, 0.8, -0.7, 0.5, 0.8, 0.6, 0).Build());
  EXPECT_TRUE(scene.Defaults->IsRoom());
  EXPECT_LT(scene.Light->GetCenter()[1], 3.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GT(scene.Camera->GetPosition()[axis], scene.Medium[2 * axis]);
    EXPECT_LT(scene.Camera->GetPosition()[axis], scene.Medium[2 * axis + 1]);
  }
}

TEST(SceneDefaults, AClosedBoxAndATableAreThings)
{
  EXPECT_FALSE(Scene(Walls({ 0, 1, 2, 3, 4, 5 }).Build()).Defaults->IsRoom());
  MeshBuilder table;
  table.AddBox(0.0, 1.0, 0.0, 1.0, 0.05, 1.0, 0);
  for (int leg = 0; leg < 4; ++leg)
  {
    table.AddBox(leg & 1 ? 0.9 : -0.9, 0.475, leg & 2 ? 0.9 : -0.9, 0.05, 0.475, 0.05, 0);
  }
  EXPECT_FALSE(Scene(table.Build()).Defaults->IsRoom());
}

TEST(SceneDefaults, UpFollowsLightAndShape)
{
  auto plate = MeshBuilder().AddBox(0.0, 0.0, 0.0, 5.0, 4.0, 1.0, 0).Build();
  EXPECT_EQ(Scene(plate).Defaults->GetFoundUp(), vtkSceneDefaults::Z);
  vtkNew<vtkAreaLightSource> light;
  light->SetCenter(0.0, 10.0, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  EXPECT_EQ(Scene(plate, light).Defaults->GetFoundUp(), vtkSceneDefaults::Y);
  vtkNew<vtkSceneDefaults> asked;
  asked->SetMesh(plate);
  asked->SetUpToX();
  EXPECT_TRUE(asked->Find());
  EXPECT_EQ(asked->GetFoundUp(), vtkSceneDefaults::X);
}

TEST(SceneDefaults, NothingAndFlatThingsAreFine)
{
  Scene none(nullptr);
  EXPECT_EQ(none.Medium[2], -0.5);
  Scene sheet(MeshBuilder().AddSquare(0.0, 1.0, 0).Build());
  EXPECT_EQ(sheet.Defaults->GetFoundUp(), vtkSceneDefaults::Z);
  EXPECT_GT(sheet.Light->GetCenter()[2], 1.0);
  EXPECT_TRUE(std::isfinite(sheet.Camera->GetPosition()[0]));
}

TEST(SceneDefaults, Faults)
{
  vtkNew<vtkSceneDefaults> defaults;
  defaults->SetUp(7);
  EXPECT_FALSE(defaults->Find());
  EXPECT_SAYS(defaults->GetError(), "Up is 7: it must be 0 (Automatic), 1 (X), 2 (Y) or 3 (Z).");
  defaults->SetUpToAutomatic();
  vtkNew<vtkPolyData> nothing;
  defaults->AddLight(nothing);
  EXPECT_FALSE(defaults->Find());
  EXPECT_FALSE(defaults->GetError().empty());
}
