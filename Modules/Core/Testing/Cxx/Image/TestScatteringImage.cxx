// SPDX-License-Identifier: BSD-3-Clause
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scTileRange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

Medium MakeMedium(const Box& bounds, double sigmaS, double sigmaA, int wavelengths = 1)
{
  Medium medium;
  medium.SigmaS.assign(static_cast<std::size_t>(wavelengths), sigmaS);
  medium.SigmaA.assign(static_cast<std::size_t>(wavelengths), sigmaA);
  medium.Bounds = bounds;
  return medium;
}

/// A room with a lamp at the top, a tilted plate below it and a floor; the camera looks in from the front.
struct Room
{
  TestMesh Mesh;
  Light Lamp = MakeLight(LightShape::Disc, { 0.0, 2.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.4, { 1.0 });
  Medium Fog = MakeMedium({ { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } }, 0.2, 0.05);
  Camera View;
  ScatteringOptions Options;

  Room()
  {
    this->Mesh.AddSheet({ -0.7, 0.1, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 });
    this->Mesh.AddSheet({ -2.0, -1.9, -2.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
    this->View.Position = { 0.0, 0.0, 7.0 };
    this->View.HalfHeight = 0.35;
    this->Options.Width = 16;
    this->Options.Height = 12;
    this->Options.Extent = { 0, 15, 0, 11 };
    this->Options.NumberOfLightSamples = 4;
    this->Options.NumberOfSteps = 12;
  }

  /// Cones that hold all of the plate's shadow, and no part of the floor.
  std::vector<Cone> BoundingCones() const
  {
    Cone cone;
    cone.Center = { -0.1, 0.9, 0.0 };
    cone.Axis = { 0.0, -1.0, 0.0 };
    cone.BaseRadius = 1.5;
    cone.HalfAngle = std::atan((1.5 + 0.5) / 1.1);
    cone.OccluderId = 0;
    return { cone };
  }

  ScatteringImage Render(ScatteringMode mode, const std::vector<Cone>& cones = {}) const
  {
    const OccluderScene scene(this->Mesh.View());
    const ConeHierarchy hierarchy(cones, this->Fog.Bounds);
    ScatteringOptions options = this->Options;
    options.Mode = mode;
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering({ scene, this->Lamp, this->Fog, this->View, &hierarchy }, options, {}, image));
    return image;
  }
};

double Sum(const std::vector<float>& values)
{
  double sum = 0.0;
  for (const float value : values)
  {
    sum += value;
  }
  return sum;
}

void ExpectSameBytes(const ScatteringImage& a, const ScatteringImage& b)
{
  EXPECT_EQ(a.Radiance, b.Radiance);
  EXPECT_EQ(a.InScattering, b.InScattering);
  EXPECT_EQ(a.SurfaceRadiance, b.SurfaceRadiance);
  EXPECT_EQ(a.Transmittance, b.Transmittance);
  EXPECT_EQ(a.Depth, b.Depth);
  EXPECT_EQ(a.RelativeError, b.RelativeError);
  EXPECT_EQ(a.SampleCount, b.SampleCount);
}

/// One ray along -z from (x, y, z): a camera of one pixel.
Camera SinglePixel(const Vector3& position)
{
  Camera camera;
  camera.Position = position;
  camera.HalfHeight = 1e-9;
  return camera;
}

ScatteringImage RenderPixel(
  const TestMesh& mesh, const Light& light, const Medium& medium, const Camera& camera, ScatteringOptions options)
{
  options.Width = options.Height = 1;
  options.Extent = { 0, 0, 0, 0 };
  const OccluderScene scene(mesh.View());
  ScatteringImage image;
  EXPECT_TRUE(RenderScattering({ scene, light, medium, camera }, options, {}, image));
  return image;
}

} // namespace

TEST(ScatteringImage, AirlightOfAPointMatchesASimpleQuadrature)
{
  const Box box{ { -3.0, -1.0, -2.0 }, { 3.0, 4.0, 5.0 } };
  const Light light = MakeLight(LightShape::Point, { 0.5, 1.5, 1.0 }, { 0.0, 0.0, 1.0 }, 0.0, { 1.0 });
  const double sigmaS = 0.3;
  const double sigmaT = 0.4;
  ScatteringOptions options;
  options.NumberOfSteps = 64;
  options.NumberOfLightSamples = 1;
  const ScatteringImage image =
    RenderPixel({}, light, MakeMedium(box, sigmaS, sigmaT - sigmaS), SinglePixel({ 0.2, 0.3, 9.0 }), options);

  // From z = 5 down to z = -2; the lamp is inside the box, so its leg is the whole distance.
  const int steps = 100000;
  double expected = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double z = 5.0 - 7.0 * (i + 0.5) / steps;
    const double d = std::sqrt(0.3 * 0.3 + 1.2 * 1.2 + (z - 1.0) * (z - 1.0));
    expected += sigmaS / (4.0 * Pi) / (d * d) * std::exp(-sigmaT * (5.0 - z + d)) * 7.0 / steps;
  }
  EXPECT_NEAR(image.InScattering[0] / expected, 1.0, 0.002);
  EXPECT_NEAR(image.Transmittance[0], std::exp(-sigmaT * 7.0), 1e-6);
  EXPECT_EQ(image.Depth[0], -1.0f);
}

TEST(ScatteringImage, LightFromOutsideIsAttenuatedInsideTheBoxOnly)
{
  const Box box{ { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
  // The sun shines down; the light leg is 1 - y = 0.5 for every point of the ray.
  const Light light = MakeLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 1.0 });
  const ScatteringImage image = RenderPixel({}, light, MakeMedium(box, 0.5, 0.0), SinglePixel({ 0.0, 0.5, 8.0 }), {});
  const double expected = 0.5 / (4.0 * Pi) * std::exp(-0.5 * 0.5) * (1.0 - std::exp(-0.5 * 2.0)) / 0.5;
  EXPECT_NEAR(image.InScattering[0] / expected, 1.0, 0.001);
}

TEST(ScatteringImage, ParallelLightWithAShadowedIntervalMatchesTheClosedForm)
{
  const Box box{ { -1.0, 0.0, -3.0 }, { 1.0, 1.0, 1.0 } };
  const Light light = MakeLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 1.0 });
  // A plate above the box shadows z in [-1.3, -0.2], that is 1.2 to 2.3 along the ray from z = 1.
  TestMesh mesh;
  mesh.AddSheet({ -2.0, 2.0, -1.3 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 1.1 });
  ScatteringOptions options;
  options.NumberOfSteps = 64;
  options.MaximumHalvings = 8;
  options.NumberOfLightSamples = 1;
  const double sigmaS = 0.35;
  const double sigmaT = 0.5;
  const double y = 0.4;
  const ScatteringImage image =
    RenderPixel(mesh, light, MakeMedium(box, sigmaS, sigmaT - sigmaS), SinglePixel({ 0.0, y, 6.0 }), options);
  const double blocked = std::exp(-sigmaT * 1.2) - std::exp(-sigmaT * 2.3);
  const double expected =
    sigmaS / (4.0 * Pi * sigmaT) * std::exp(-sigmaT * (1.0 - y)) * (1.0 - std::exp(-sigmaT * 4.0) - blocked);
  EXPECT_NEAR(image.InScattering[0] / expected, 1.0, 0.001);
}

TEST(ScatteringImage, ADiscOnTheAxisScattersItsSolidAngle)
{
  // A medium 0.01 thick at height 1 below a disc of radius 0.6, seen from the side.
  const Box box{ { -0.005, -0.005, -0.005 }, { 0.005, 0.005, 0.005 } };
  const Light light = MakeLight(LightShape::Disc, { 0.0, 1.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.6, { 1.0 });
  ScatteringOptions options;
  options.NumberOfLightSamples = 64;
  const ScatteringImage image =
    RenderPixel({}, light, MakeMedium(box, 1e-3, 0.0), SinglePixel({ 0.0, 0.0, 3.0 }), options);
  const double solidAngle = 2.0 * Pi * (1.0 - 1.0 / std::sqrt(1.0 + 0.36));
  EXPECT_NEAR(image.InScattering[0] / (1e-3 * solidAngle / (4.0 * Pi) * 0.01), 1.0, 0.005);
}

TEST(ScatteringImage, ForwardScatteringLooksTowardsTheLight)
{
  const Box box{ { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
  Medium medium = MakeMedium(box, 0.1, 0.0);
  medium.Phase = { PhaseFunctionKind::HenyeyGreenstein, {}, 0.7 };
  // The sun shines along +z, into the camera's eye; then along -z, from behind it.
  const Light against = MakeLight(LightShape::Sun, {}, { 0.0, 0.0, 1.0 }, 0.0, { 1.0 });
  const Light behind = MakeLight(LightShape::Sun, {}, { 0.0, 0.0, -1.0 }, 0.0, { 1.0 });
  const Camera camera = SinglePixel({ 0.0, 0.0, 4.0 });
  const double towards = RenderPixel({}, against, medium, camera, {}).InScattering[0];
  const double away = RenderPixel({}, behind, medium, camera, {}).InScattering[0];
  EXPECT_GT(towards, 20.0 * away);
}

TEST(ScatteringImage, SurfaceRadianceUnderADisc)
{
  TestMesh mesh;
  mesh.AddSheet({ -5.0, 0.0, -5.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.0, 10.0 });
  const double h = 2.0;
  const double radius = 0.7;
  const Light light = MakeLight(LightShape::Disc, { 0.0, h, 0.0 }, { 0.0, -1.0, 0.0 }, radius, { 1.0 });
  Camera camera;
  camera.Position = { 0.0, 3.0, 4.0 };
  camera.Forward = Normalized({ 0.0, -3.0, -4.0 });
  camera.Right = { 1.0, 0.0, 0.0 };
  camera.Up = Cross(camera.Right, camera.Forward);
  camera.HalfHeight = 1e-9;
  ScatteringOptions options;
  options.NumberOfSurfaceLightSamples = 256;
  options.Reflectance = 0.8;
  options.LightVisible = false;
  const Medium vacuum = MakeMedium({ { 9.0, 9.0, 9.0 }, { 10.0, 10.0, 10.0 } }, 0.1, 0.0);
  const double irradiance = Pi * radius * radius / (h * h + radius * radius);
  const ScatteringImage clear = RenderPixel(mesh, light, vacuum, camera, options);
  EXPECT_NEAR(clear.SurfaceRadiance[0] / (0.8 / Pi * irradiance), 1.0, 0.005);
  EXPECT_NEAR(clear.Depth[0], 5.0, 1e-5);
  EXPECT_EQ(clear.InScattering[0], 0.0f);
  EXPECT_EQ(clear.SampleCount[0], 0);

  // The surface is two-sided: seen from below it is dark, because the lamp is above.
  camera.Position = { 0.0, -3.0, 4.0 };
  camera.Forward = Normalized({ 0.0, 3.0, -4.0 });
  camera.Up = Cross(camera.Right, camera.Forward);
  EXPECT_EQ(RenderPixel(mesh, light, vacuum, camera, options).SurfaceRadiance[0], 0.0f);

  // Reflectance per triangle takes the place of the parameter.
  camera.Position = { 0.0, 3.0, 4.0 };
  camera.Forward = Normalized({ 0.0, -3.0, -4.0 });
  camera.Up = Cross(camera.Right, camera.Forward);
  options.SurfaceReflectance = { 0.4f, 0.4f };
  EXPECT_FLOAT_EQ(
    RenderPixel(mesh, light, vacuum, camera, options).SurfaceRadiance[0], 0.5f * clear.SurfaceRadiance[0]);
}

TEST(ScatteringImage, SurfacesAreSeenThroughTheMediumOnBothLegs)
{
  TestMesh mesh;
  mesh.AddSheet({ -5.0, 0.0, -5.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.0, 10.0 });
  const Light sun = MakeLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 1.0 });
  Camera camera;
  camera.Position = { 0.0, 4.0, 0.0 };
  camera.Forward = { 0.0, -1.0, 0.0 };
  camera.Up = { 0.0, 0.0, -1.0 };
  camera.HalfHeight = 1e-9;
  const Medium medium = MakeMedium({ { -5.0, -1.0, -5.0 }, { 5.0, 1.5, 5.0 } }, 0.2, 0.1);
  const ScatteringImage image = RenderPixel(mesh, sun, medium, camera, {});
  EXPECT_NEAR(image.SurfaceRadiance[0], 0.5 / Pi * std::exp(-0.3 * 3.0), 1e-5);
  EXPECT_NEAR(image.Transmittance[0], std::exp(-0.3 * 1.5), 1e-5);
  EXPECT_FLOAT_EQ(image.Radiance[0], image.SurfaceRadiance[0] + image.InScattering[0]);
}

TEST(ScatteringImage, TheCameraSeesTheLightFromItsBrightSide)
{
  const Box box{ { -1.0, -1.0, 0.0 }, { 1.0, 1.0, 2.0 } };
  const Medium medium = MakeMedium(box, 0.0, 0.5);
  Light rectangle = MakeLight(LightShape::Disc, {}, { 0.0, 0.0, 1.0 }, 1.0, { 1.0 });
  rectangle.Shape = LightShape::Rectangle;
  rectangle.AxisU = { 0.5, 0.0, 0.0 };
  rectangle.AxisV = { 0.0, 0.5, 0.0 };
  ASSERT_EQ(PrepareLight(rectangle), nullptr);
  Light mesh = rectangle;
  mesh.Shape = LightShape::Mesh;
  mesh.Triangles = { { Vector3{ -1.0, -1.0, 0.0 }, Vector3{ 1.0, -1.0, 0.0 }, Vector3{ 0.0, 2.0, 0.0 } } };
  ASSERT_EQ(PrepareLight(mesh), nullptr);
  const double sunRadius = 0.1;
  const Light sun = MakeLight(LightShape::Sun, {}, { 0.0, 0.0, 1.0 }, sunRadius, { 1.0 });

  const Camera camera = SinglePixel({ 0.0, 0.0, 5.0 });
  const double seen = std::exp(-0.5 * 2.0);
  for (const Light& light : { MakeLight(LightShape::Disc, {}, { 0.0, 0.0, 1.0 }, 0.3, { 1.0 }), rectangle, mesh,
         MakeLight(LightShape::Sphere, { 0.0, 0.0, -0.3 }, { 0.0, 0.0, 1.0 }, 0.3, { 1.0 }) })
  {
    EXPECT_NEAR(RenderPixel({}, light, medium, camera, {}).Radiance[0], seen, 1e-5)
      << "shape " << static_cast<int>(light.Shape);
    ScatteringOptions hidden;
    hidden.LightVisible = false;
    EXPECT_EQ(RenderPixel({}, light, medium, camera, hidden).Radiance[0], 0.0f);
    EXPECT_EQ(RenderPixel({}, light, medium, SinglePixel({ 3.0, 0.0, 5.0 }), {}).Radiance[0], 0.0f) << "beside it";
  }
  // A sun of irradiance 1 has the radiance 1 / solid angle.
  const double solidAngle = 2.0 * Pi * (1.0 - std::cos(sunRadius));
  EXPECT_NEAR(RenderPixel({}, sun, medium, camera, {}).Radiance[0] / (seen / solidAngle), 1.0, 1e-5);
  // The back of a disc is dark, and a surface in front hides the light.
  EXPECT_EQ(
    RenderPixel({}, MakeLight(LightShape::Disc, {}, { 0.0, 0.0, -1.0 }, 0.3, { 1.0 }), medium, camera, {}).Radiance[0],
    0.0f);
  TestMesh screen;
  screen.AddSheet({ -1.0, -1.0, 0.5 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  ScatteringOptions black;
  black.NumberOfSurfaceLightSamples = 0;
  EXPECT_EQ(RenderPixel(screen, rectangle, medium, camera, black).Radiance[0], 0.0f);
}

TEST(ScatteringImage, AnUnoccludedSceneIsTheSameInEveryMode)
{
  Room room;
  room.Mesh = {};
  const ScatteringImage bruteForce = room.Render(ScatteringMode::BruteForce);
  EXPECT_GT(Sum(bruteForce.InScattering), 0.0);
  ExpectSameBytes(bruteForce, room.Render(ScatteringMode::Medium));
  ExpectSameBytes(bruteForce, room.Render(ScatteringMode::Fast));
  // A mesh on the dark side of the lamp changes nothing in the medium either.
  room.Mesh.AddSheet({ -1.0, 3.0, -1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 });
  EXPECT_EQ(bruteForce.InScattering, room.Render(ScatteringMode::BruteForce).InScattering);
}

TEST(ScatteringImage, MediumHasTheBytesOfBruteForceWhereConesBoundTheShadow)
{
  Room room;
  room.Options.NumberOfSteps = 24;
  const auto cones = room.BoundingCones();
  const ScatteringImage bruteForce = room.Render(ScatteringMode::BruteForce);
  const ScatteringImage medium = room.Render(ScatteringMode::Medium, cones);
  ExpectSameBytes(bruteForce, medium);
  EXPECT_LT(medium.NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays);
  EXPECT_GT(medium.NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays / 20);
  // Without cones light leaks into the shadow.
  EXPECT_GT(Sum(room.Render(ScatteringMode::Medium).InScattering), 1.01 * Sum(bruteForce.InScattering));
}

TEST(ScatteringImage, MediumHasTheSameLightWithNodesDenserAtTheEndsOfCones)
{
  Room room;
  room.Options.NumberOfSteps = 96;
  room.Options.NumberOfLightSamples = 16;
  const double bruteForce = Sum(room.Render(ScatteringMode::BruteForce).InScattering);
  room.Options.ShareNearEnds = 0.5;
  const ScatteringImage medium = room.Render(ScatteringMode::Medium, room.BoundingCones());
  EXPECT_NEAR(Sum(medium.InScattering), bruteForce, 4e-3 * bruteForce);
  // The option does nothing for the others.
  const ScatteringImage others = room.Render(ScatteringMode::BruteForce);
  room.Options.ShareNearEnds = 0.0;
  ExpectSameBytes(others, room.Render(ScatteringMode::BruteForce));
}

TEST(ScatteringImage, FastCastsNoRaysAndIsDarker)
{
  const Room room;
  const auto cones = room.BoundingCones();
  const ScatteringImage bruteForce = room.Render(ScatteringMode::BruteForce);
  const ScatteringImage fast = room.Render(ScatteringMode::Fast, cones);
  EXPECT_EQ(fast.NumberOfOcclusionRays, 0);
  EXPECT_LT(Sum(fast.InScattering), 0.9 * Sum(bruteForce.InScattering));
  EXPECT_GT(Sum(fast.InScattering), 0.0);
}

TEST(ScatteringImage, FastLeavesOutExactlyTheCones)
{
  // The sun from above; a cylinder across the ray takes out z in [-0.5, 0.5].
  const Box box{ { -1.0, -1.0, -2.0 }, { 1.0, 1.0, 2.0 } };
  const Light sun = MakeLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 1.0 });
  const Medium medium = MakeMedium(box, 0.1, 0.0);
  Cone cylinder;
  cylinder.Center = { 0.0, 0.9, 0.0 };
  cylinder.Axis = { 0.0, -1.0, 0.0 };
  cylinder.BaseRadius = 0.5;
  const OccluderScene scene(TestMesh{}.View());
  const ConeHierarchy cones({ cylinder }, box);
  ScatteringOptions options;
  options.Mode = ScatteringMode::Fast;
  options.Width = options.Height = 1;
  options.Extent = { 0, 0, 0, 0 };
  ScatteringImage image;
  const Camera camera = SinglePixel({ 0.0, 0.5, 4.0 });
  ASSERT_TRUE(RenderScattering({ scene, sun, medium, camera, &cones }, options, {}, image));
  const double s = 0.1;
  const double lit = (1.0 - std::exp(-s * 1.5) + std::exp(-s * 2.5) - std::exp(-s * 4.0)) / s;
  EXPECT_NEAR(image.InScattering[0] / (s / (4.0 * Pi) * std::exp(-s * 0.5) * lit), 1.0, 1e-4);
}

TEST(ScatteringImage, ExtentsPutTogetherAreTheWhole)
{
  Room room;
  const ScatteringImage whole = room.Render(ScatteringMode::BruteForce);
  vtkIdType rays = 0;
  for (const auto& extent : { std::array<int, 4>{ 0, 4, 0, 6 }, { 5, 15, 0, 6 }, { 0, 4, 7, 11 }, { 5, 15, 7, 11 } })
  {
    room.Options.Extent = extent;
    const ScatteringImage part = room.Render(ScatteringMode::BruteForce);
    rays += part.NumberOfOcclusionRays;
    std::size_t index = 0;
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++index)
      {
        EXPECT_EQ(part.Radiance[index], whole.Radiance[static_cast<std::size_t>(16 * j + i)]);
      }
    }
  }
  EXPECT_EQ(rays, whole.NumberOfOcclusionRays);
}

TEST(ScatteringImage, EveryWavelengthIsItsOwnImage)
{
  Room room;
  room.Options.MaximumHalvings = 0; // halving looks at the mean over wavelengths
  room.Lamp.Spectrum = { 1.0, 0.5, 2.0 };
  room.Fog.SigmaS = { 0.1, 0.2, 0.1 };
  room.Fog.SigmaA = { 0.0, 0.3, 0.0 };
  const ScatteringImage image = room.Render(ScatteringMode::BruteForce);
  ASSERT_EQ(image.NumberOfWavelengths, 3);
  const Room whole = room;
  for (std::size_t k = 0; k < 3; ++k)
  {
    room.Lamp.Spectrum = { whole.Lamp.Spectrum[k] };
    room.Fog.SigmaS = { whole.Fog.SigmaS[k] };
    room.Fog.SigmaA = { whole.Fog.SigmaA[k] };
    const ScatteringImage single = room.Render(ScatteringMode::BruteForce);
    for (std::size_t i = 0; i < single.Depth.size(); ++i)
    {
      EXPECT_EQ(image.InScattering[3 * i + k], single.InScattering[i]);
      // How long a surface is looked at is told by the mean over wavelengths: it is the same up to its error.
      EXPECT_NEAR(image.SurfaceRadiance[3 * i + k], single.SurfaceRadiance[i],
        4.0f * (image.SurfaceRelativeError[i] + single.SurfaceRelativeError[i]) * single.SurfaceRadiance[i]);
      EXPECT_EQ(image.Transmittance[3 * i + k], single.Transmittance[i]);
    }
  }
}

TEST(ScatteringImage, RelativeErrorIsTheSpreadOverSeeds)
{
  Room room; // nine samples: a grid of three by three
  room.Options.Width = 4;
  room.Options.Height = 3;
  room.Options.Extent = { 0, 3, 0, 2 };
  room.Options.NumberOfLightSamples = 9;
  room.Options.MaximumHalvings = 0;
  const int seeds = 300;
  std::vector<double> sum(12), squares(12), claimed(12);
  for (int seed = 0; seed < seeds; ++seed)
  {
    room.Options.Seed = static_cast<std::uint64_t>(seed);
    const ScatteringImage image = room.Render(ScatteringMode::BruteForce);
    for (std::size_t i = 0; i < 12; ++i)
    {
      const double value = image.InScattering[i];
      sum[i] += value;
      squares[i] += value * value;
      claimed[i] += std::pow(image.RelativeError[i] * value, 2);
    }
  }
  double trueVariance = 0.0;
  double claimedVariance = 0.0;
  for (std::size_t i = 0; i < 12; ++i)
  {
    trueVariance += squares[i] / seeds - std::pow(sum[i] / seeds, 2);
    claimedVariance += claimed[i] / seeds;
  }
  const double ratio = std::sqrt(claimedVariance / trueVariance);
  EXPECT_GT(ratio, 0.9);
  EXPECT_LT(ratio, 1.3);
  // One sample alone has no spread to show.
  room.Options.NumberOfLightSamples = 1;
  EXPECT_EQ(room.Render(ScatteringMode::BruteForce).RelativeError[0], -1.0f);
}

TEST(ScatteringImage, SeedsDifferAndRepeat)
{
  Room room;
  const ScatteringImage first = room.Render(ScatteringMode::BruteForce);
  ExpectSameBytes(first, room.Render(ScatteringMode::BruteForce));
  room.Options.Seed = 2;
  const ScatteringImage other = room.Render(ScatteringMode::BruteForce);
  EXPECT_NE(first.InScattering, other.InScattering);
  EXPECT_NEAR(Sum(first.InScattering) / Sum(other.InScattering), 1.0, 0.01);
}

TEST(ScatteringImage, HalvingFindsAThinShaft)
{
  // A slit 0.1 wide in a wide plate under the sun: a shaft that a coarse march meets by luck only.
  const Box box{ { -1.0, -1.0, -2.0 }, { 1.0, 1.0, 2.0 } };
  const Light sun = MakeLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 1.0 });
  TestMesh mesh;
  mesh.AddSheet({ -2.0, 1.5, -3.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 3.02 });
  mesh.AddSheet({ -2.0, 1.5, 0.32 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 3.0 });
  ScatteringOptions options;
  options.NumberOfLightSamples = 1;
  options.NumberOfSteps = 20;
  options.MaximumHalvings = 0;
  const Medium medium = MakeMedium(box, 0.01, 0.0);
  const double expected = 0.01 / (4.0 * Pi) * 0.3 * std::exp(-0.01 * (1.0 - 0.17 + 2.0 - 0.17));
  const Camera camera = SinglePixel({ 0.0, 0.17, 5.0 });
  const double coarse = RenderPixel(mesh, sun, medium, camera, options).InScattering[0];
  options.MaximumHalvings = 8;
  const ScatteringImage fine = RenderPixel(mesh, sun, medium, camera, options);
  EXPECT_GT(std::fabs(coarse / expected - 1.0), 0.05);
  EXPECT_NEAR(fine.InScattering[0] / expected, 1.0, 0.01);
  EXPECT_LT(fine.SampleCount[0], 21 + 2 * 8 + 8);
}

TEST(ScatteringImage, FarAwayAndTinyScenesLookTheSame)
{
  const Room room;
  const ScatteringImage here = room.Render(ScatteringMode::BruteForce);
  const auto moved = [&room](double scale, const Vector3& offset)
  {
    Room other = room;
    for (std::size_t i = 0; i < other.Mesh.Points.size(); ++i)
    {
      other.Mesh.Points[i] = scale * other.Mesh.Points[i] + offset[static_cast<int>(i % 3)];
    }
    other.Lamp.Center = scale * other.Lamp.Center + offset;
    other.Lamp.Radius *= scale;
    other.Fog.Bounds = { scale * other.Fog.Bounds.Min + offset, scale * other.Fog.Bounds.Max + offset };
    other.Fog.SigmaS[0] /= scale;
    other.Fog.SigmaA[0] /= scale;
    other.View.Position = scale * other.View.Position + offset;
    return other.Render(ScatteringMode::BruteForce);
  };
  const double whole = Sum(here.Radiance);
  EXPECT_NEAR(Sum(moved(1.0, { 1e6, -1e6, 1e6 }).Radiance) / whole, 1.0, 1e-3);
  EXPECT_NEAR(Sum(moved(1e-3, {}).Radiance) / whole, 1.0, 1e-3);
  EXPECT_NEAR(Sum(moved(1e4, {}).Radiance) / whole, 1.0, 1e-3);
}

TEST(ScatteringImage, ACameraInsideAClosedOccluderSeesDarkness)
{
  TestMesh mesh;
  const double s = 0.5;
  mesh.AddSheet({ -s, -s, -s }, { 2 * s, 0, 0 }, { 0, 2 * s, 0 });
  mesh.AddSheet({ -s, -s, s }, { 2 * s, 0, 0 }, { 0, 2 * s, 0 });
  mesh.AddSheet({ -s, -s, -s }, { 0, 0, 2 * s }, { 0, 2 * s, 0 });
  mesh.AddSheet({ s, -s, -s }, { 0, 0, 2 * s }, { 0, 2 * s, 0 });
  mesh.AddSheet({ -s, -s, -s }, { 2 * s, 0, 0 }, { 0, 0, 2 * s });
  mesh.AddSheet({ -s, s, -s }, { 2 * s, 0, 0 }, { 0, 0, 2 * s });
  const Room room;
  const ScatteringImage image = RenderPixel(mesh, room.Lamp, room.Fog, SinglePixel({ 0.1, 0.05, 0.0 }), {});
  EXPECT_EQ(image.Radiance[0], 0.0f);
  EXPECT_NEAR(image.Depth[0], 0.5f, 1e-5);
}

TEST(ScatteringOptions, AreCheckedOneByOne)
{
  EXPECT_EQ(CheckScatteringOptions({}), nullptr);
  const auto fault = [](auto change)
  {
    ScatteringOptions options;
    change(options);
    const char* text = CheckScatteringOptions(options);
    return std::string(text ? text : "");
  };
  constexpr int most = 2147483647;
  const auto expect = [](const std::string& text, const char* part)
  { EXPECT_NE(text.find(part), std::string::npos) << text; };
  expect(fault([](auto& o) { o.Width = o.Height = most; }), "at most 2^31 - 1");
  expect(fault([](auto& o) { o.Extent = { -1, 255, 0, 255 }; }), "Extent");
  expect(fault([](auto& o) { o.NumberOfSteps = most; }), "1..1000000");
  expect(fault([](auto& o) { o.MaximumHalvings = most; }), "0..16");
  expect(fault([](auto& o) { o.NumberOfLightSamples = most; }), "NumberOfLightSamples must lie in 1..65536");
  expect(fault([](auto& o) { o.NumberOfSurfaceLightSamples = most; }), "0..65536");
  expect(fault([](auto& o) { o.NumberOfEdgeSamples = most; }), "1..1024");
  expect(fault([](auto& o) { o.MaximumSamples = 0; }), "MaximumSamples");
  expect(fault([](auto& o) { o.IntensityThreshold = std::nan(""); }), "IntensityThreshold");
  expect(fault([](auto& o) { o.ShareNearEnds = 1.0; }), "ShareNearEnds");
  expect(fault([](auto& o) { o.RelativeErrorGoal = -1.0; }), "RelativeErrorGoal");
  expect(fault([](auto& o) { o.Reflectance = 1.1; }), "Reflectance");
  expect(fault([](auto& o) { o.Mode = static_cast<ScatteringMode>(6); }), "Mode");
  EXPECT_EQ(fault([](auto& o) { o.MaximumSamples = most; }), "");
}

TEST(TileRange, TilesCoverAnExtentAlsoAtTheLargestNumbers)
{
  constexpr int most = 2147483647;
  const std::vector<TileRange> tiles = TilesOf({ most - 40, most - 1, 5, 33 }, 32);
  vtkIdType pixels = 0;
  for (const TileRange& tile : tiles)
  {
    EXPECT_LE(most - 40, tile.I0);
    EXPECT_LE(tile.I1, most - 1);
    EXPECT_EQ(tile.I0 / 32, tile.I1 / 32);
    EXPECT_EQ(tile.J0 / 32, tile.J1 / 32);
    pixels += static_cast<vtkIdType>(tile.I1 - tile.I0 + 1) * (tile.J1 - tile.J0 + 1);
  }
  EXPECT_EQ(pixels, 40 * 29);
  EXPECT_TRUE(TilesOf({ 0, -1, 0, 5 }, 32).empty());
}

TEST(ScatteringImage, StopsWhereTheMonitorSaysSo)
{
  const Room room;
  const OccluderScene scene(room.Mesh.View());
  Monitor monitor;
  double reported = 0.0;
  monitor.Progress = [&reported](double share) { reported = share; };
  ScatteringImage image;
  EXPECT_TRUE(RenderScattering({ scene, room.Lamp, room.Fog, room.View }, room.Options, monitor, image));
  EXPECT_EQ(reported, 1.0);
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(RenderScattering({ scene, room.Lamp, room.Fog, room.View }, room.Options, monitor, image));
}
