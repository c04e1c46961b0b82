// SPDX-License-Identifier: BSD-3-Clause
// A round lamp in a ceiling that is an ordinary occluder: nothing lies between the two and the room, for all who ask.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRandom.h"
#include "scRenderScattering.h"
#include "scSampleTruth.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scShadowVectors.h"
#include "scVisibilityGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{

Vector3 Turned(double x, double y, double z)
{
  constexpr double a = 0.7;
  constexpr double b = 0.4;
  const double u = std::cos(a) * x - std::sin(a) * y;
  const double v = std::sin(a) * x + std::cos(a) * y;
  return { u, std::cos(b) * v - std::sin(b) * z, std::sin(b) * v + std::cos(b) * z };
}

/// A turned room, half as wide as 10: the ceiling at 5.5 of 20 x 20 quads in single precision, and a sheet far from all.
TestMesh Room(bool ceiling)
{
  TestMesh mesh;
  constexpr double half = 10.0;
  for (int i = 0; ceiling && i < 20; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      mesh.AddSheet(Turned(i - half, j - half, 5.5), Turned(1.0, 0.0, 0.0), Turned(0.0, 1.0, 0.0), 0);
    }
  }
  mesh.AddSheet(Turned(-9.0, -9.0, 4.0), Turned(0.1, 0.0, 0.0), Turned(0.0, 0.1, 0.0), 1);
  for (double& x : mesh.Points)
  {
    x = static_cast<float>(x);
  }
  return mesh;
}

Light Lamp()
{
  return Prepared(DiscLight(Turned(0.013, 0.027, 5.5), Turned(0.0, 0.0, -1.0), 0.3));
}

/// What a ray in the fog, parallel to the ceiling and a little below it, scatters towards the camera.
double InScattering(bool ceiling, ScatteringMode mode, double below)
{
  const TestMesh mesh = Room(ceiling);
  const OccluderScene scene(mesh.View());
  const Light lamp = Lamp();
  Medium fog;
  fog.SigmaS.assign(7, 0.01);
  fog.SigmaA.assign(7, 0.0);
  fog.Bounds = { { -20.0, -20.0, -20.0 }, { 20.0, 20.0, 20.0 } };
  Camera camera;
  camera.Position = Turned(3.0, -9.0, 5.5 - below);
  camera.Forward = Turned(0.0, 1.0, 0.0);
  camera.Right = Turned(1.0, 0.0, 0.0);
  camera.Up = Turned(0.0, 0.0, 1.0);
  camera.HalfHeight = 1e-6;
  ScatteringOptions options;
  options.Mode = mode;
  options.Width = 1;
  options.Height = 1;
  options.Extent = { 0, 0, 0, 0 };
  options.NumberOfSteps = 256;
  ScatteringImage image;
  EXPECT_TRUE(RenderScattering({ scene, lamp, fog, camera }, options, {}, image));
  return image.InScattering.front();
}

} // namespace

TEST(FlushLamp, TheFogBelowACeilingIsAsBrightAsWithoutIt)
{
  for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Guided })
  {
    for (const double below : { 0.01, 0.1 })
    {
      const double without = InScattering(false, mode, below);
      ASSERT_GT(without, 0.0);
      EXPECT_NEAR(InScattering(true, mode, below) / without, 1.0, 1e-3) << static_cast<int>(mode) << " " << below;
    }
  }
}

TEST(FlushLamp, ItsCeilingStoresNoVectors)
{
  const TestMesh mesh = Room(true);
  const OccluderScene scene(mesh.View());
  ShadowVectorOptions options;
  options.NumberOfPhotons = 20000;
  ShadowVectorResult result;
  ASSERT_TRUE(TraceShadowVectors(scene, Lamp(), options, {}, result));
  EXPECT_EQ(std::count(result.Vectors.OccluderIds.begin(), result.Vectors.OccluderIds.end(), 0), 0);
}

TEST(FlushLamp, PointsBelowACeilingSeeAllOfIt)
{
  const TestMesh mesh = Room(true);
  const OccluderScene scene(mesh.View());
  std::vector<Vector3> points;
  for (std::uint64_t i = 0; i < 500; ++i)
  {
    RandomStream random(9, i);
    const double depth = std::pow(10.0, -3.0 * random.Next());
    points.push_back(Turned(16.0 * random.Next() - 8.0, 18.0 * random.Next() - 8.0, 5.5 - depth));
  }
  std::vector<SampleTruth> truth;
  ASSERT_TRUE(MeasureTruth(points, scene, Lamp(), 16, 1, {}, truth));
  EXPECT_TRUE(std::all_of(truth.begin(), truth.end(), [](const SampleTruth& t) { return t.Blocked == 0; }));

  Cone everywhere;
  everywhere.Center = { 0.0, 0.0, 100.0 };
  everywhere.Axis = { 0.0, 0.0, -1.0 };
  everywhere.Normal = everywhere.Axis;
  everywhere.BaseRadius = 100.0;
  // A grid in the room, below the ceiling.
  const Vector3 corner = Turned(2.0, 2.0, 4.0);
  const Box box{ corner - Vector3{ 0.5, 0.5, 0.5 }, corner + Vector3{ 0.5, 0.5, 0.5 } };
  VisibilityGridOptions options;
  options.Dimensions = { 7, 7, 7 };
  VisibilityGrid grid;
  ASSERT_TRUE(FillVisibilityGrid({ everywhere }, Lamp(), &scene, box, options, {}, grid));
  EXPECT_EQ(std::count(grid.Visibility.begin(), grid.Visibility.end(), 1.0f), 343);
}
