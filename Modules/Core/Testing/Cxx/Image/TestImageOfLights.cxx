// SPDX-License-Identifier: BSD-3-Clause
// Images in the light of several lights are the sums of images in the light of each, in every mode.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scVisibilityGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int width = 20;
constexpr int height = 15;

/// A plate under lamps over a floor, in fog; a cone a lamp that holds the plate's shadow.
class Hall
{
public:
  Hall()
  {
    this->Walls.AddSheet({ -0.7, 1.0, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 }, 0);
    this->Walls.AddSheet({ -6.0, 0.0, 6.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, -1);
    this->Casters.AddSheet({ -0.7, 1.0, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 }, 0);
    this->Fog.SigmaS.assign(7, 0.1);
    this->Fog.SigmaA.assign(7, 0.05);
    this->Fog.Bounds = { { -3.0, -0.1, -3.0 }, { 3.0, 3.2, 3.0 } };
    this->View.Position = { 0.0, 3.0, 6.0 };
    this->View.Forward = Normalized({ 0.0, -0.2, -1.0 });
    this->View.Up = Cross(this->View.Right, this->View.Forward);
    this->View.HalfHeight = 0.5;
    this->Options.Width = width;
    this->Options.Height = height;
    this->Options.Extent = { 0, width - 1, 0, height - 1 };
    this->Options.NumberOfSteps = 12;
    this->Options.NumberOfLightSamples = 4;
    this->Options.NumberOfSurfaceLightSamples = 8;
    // What is an edge depends on all lights that are seen.
    this->Options.NumberOfEdgeSamples = 1;
  }

  ScatteringImage Render(ScatteringMode mode, const std::vector<Light>& lights) const
  {
    const OccluderScene occluders(this->Walls.View());
    const OccluderScene casters(this->Casters.View());
    std::vector<std::unique_ptr<ConeHierarchy>> cones;
    std::vector<VisibilityGrid> grids(lights.size());
    std::vector<ScatteringScene> scenes;
    for (std::size_t k = 0; k < lights.size(); ++k)
    {
      cones.push_back(std::make_unique<ConeHierarchy>(std::vector<Cone>{ ConeOf(lights[k]) }, this->Fog.Bounds));
      VisibilityGridOptions options;
      options.Dimensions = { 13, 13, 13 };
      options.Method = mode == ScatteringMode::Soft ? VisibilityMethod::Soft : VisibilityMethod::Exact;
      EXPECT_TRUE(FillVisibilityGrid({ ConeOf(lights[k]) }, lights[k],
        mode == ScatteringMode::Soft ? nullptr : &casters, this->Fog.Bounds, options, {}, grids[k]));
      const bool usesGrid = mode == ScatteringMode::Soft || mode == ScatteringMode::Volume;
      scenes.push_back({ occluders, lights[k], this->Fog, this->View,
        mode == ScatteringMode::BruteForce ? nullptr : cones[k].get(), usesGrid ? &grids[k] : nullptr });
    }
    ScatteringOptions options = this->Options;
    options.Mode = mode;
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering(scenes, options, {}, image));
    return image;
  }

private:
  /// It holds what the plate hides of a lamp above it.
  static Cone ConeOf(const Light& light)
  {
    Cone cone;
    cone.Center = { -0.1, 1.15, 0.05 };
    cone.Axis = Normalized(IsAtInfinity(light) ? light.Normal : cone.Center - light.Center);
    cone.Normal = cone.Axis;
    cone.BaseRadius = 0.95;
    cone.HalfAngle = 0.7;
    cone.OccluderId = 0;
    return cone;
  }

  TestMesh Walls;
  TestMesh Casters;
  Medium Fog;
  Camera View;
  ScatteringOptions Options;
};

Light Coloured(Light light, double first)
{
  for (std::size_t k = 0; k < light.Spectrum.size(); ++k)
  {
    light.Spectrum[k] = first + 0.1 * static_cast<double>(k);
  }
  return light;
}

std::vector<Light> Lamps()
{
  return { Coloured(DiscLight({ -0.8, 2.9, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3), 1.0),
    Coloured(SphereLight({ 1.1, 2.6, -0.4 }, 0.2), 2.0), Coloured(SunLight({ 0.3, -1.0, 0.1 }, 0.02), 0.1) };
}

double Mean(const PixelArray<float>& values, std::size_t pixel)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 7; ++k)
  {
    sum += values[7 * pixel + k] / 7.0;
  }
  return sum;
}

void ExpectSum(const PixelArray<float>& all, const std::vector<const PixelArray<float>*>& parts)
{
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    double sum = 0.0;
    for (const PixelArray<float>* part : parts)
    {
      sum += (*part)[i];
    }
    ASSERT_NEAR(all[i], sum, 2e-6 * sum) << i;
  }
}

class ImageOfLights : public ::testing::TestWithParam<ScatteringMode>
{
};
} // anonymous namespace

TEST_P(ImageOfLights, IsTheSumOfImages)
{
  const Hall hall;
  const std::vector<Light> lights = Lamps();
  const ScatteringImage all = hall.Render(GetParam(), lights);
  std::vector<ScatteringImage> images;
  for (const Light& light : lights)
  {
    images.push_back(hall.Render(GetParam(), { light }));
  }
  const ScatteringImage& a = images[0];
  const ScatteringImage& b = images[1];
  const ScatteringImage& c = images[2];
  ExpectSum(all.InScattering, { &a.InScattering, &b.InScattering, &c.InScattering });
  ExpectSum(all.SurfaceRadiance, { &a.SurfaceRadiance, &b.SurfaceRadiance, &c.SurfaceRadiance });
  ExpectSum(all.Radiance, { &a.Radiance, &b.Radiance, &c.Radiance });
  EXPECT_EQ(all.Depth, a.Depth);
  EXPECT_EQ(all.Transmittance, a.Transmittance);
  for (std::size_t pixel = 0; pixel < all.SampleCount.size(); ++pixel)
  {
    EXPECT_EQ(all.SampleCount[pixel], a.SampleCount[pixel] + b.SampleCount[pixel] + c.SampleCount[pixel]);
    // Errors add up, those of lights whose own estimate is black or below too.
    double error = 0.0;
    bool known = true;
    for (const ScatteringImage& image : images)
    {
      known = known && image.MediumError[pixel] >= 0.0f;
      error += image.MediumError[pixel];
    }
    ASSERT_EQ(all.RelativeError[pixel] >= 0.0f, known) << pixel;
    const double mean = Mean(all.InScattering, pixel);
    if (known && mean > 0.0)
    {
      ASSERT_NEAR(all.RelativeError[pixel], error / mean, 1e-4 * error / mean) << pixel;
    }
  }
}

TEST_P(ImageOfLights, OneLampTwiceIsTwiceAsBright)
{
  const Hall hall;
  const Light lamp = Lamps()[0];
  const ScatteringImage one = hall.Render(GetParam(), { lamp });
  const ScatteringImage two = hall.Render(GetParam(), { lamp, lamp });
  double brightest = 0.0;
  for (std::size_t i = 0; i < one.Radiance.size(); ++i)
  {
    ASSERT_NEAR(two.InScattering[i], 2.0 * one.InScattering[i], 1e-6 * one.InScattering[i]) << i;
    ASSERT_NEAR(two.SurfaceRadiance[i], 2.0 * one.SurfaceRadiance[i], 1e-6 * one.SurfaceRadiance[i]) << i;
    ASSERT_NEAR(two.Radiance[i], 2.0 * one.Radiance[i], 2e-6 * one.Radiance[i]) << i;
    brightest = std::max<double>(brightest, one.SurfaceRadiance[i]);
  }
  EXPECT_GT(brightest, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Modes, ImageOfLights,
  ::testing::Values(ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast, ScatteringMode::Guided,
    ScatteringMode::Soft, ScatteringMode::Volume));

TEST(ImageOfLights, EveryLampIsSeen)
{
  // Two discs that face the camera, in nothing: each shows its own radiance, and where one is behind the other both.
  TestMesh nothing;
  const OccluderScene occluders(nothing.View());
  const Light near = Coloured(DiscLight({ -0.3, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 0.5), 1.0);
  const Light far = Coloured(DiscLight({ 0.3, 0.0, -1.0 }, { 0.0, 0.0, 1.0 }, 0.5), 3.0);
  Medium air;
  air.SigmaS.assign(7, 0.0);
  air.SigmaA.assign(7, 0.0);
  air.Bounds = { { -1.0, -1.0, -2.0 }, { 1.0, 1.0, 1.0 } };
  Camera eye;
  eye.Position = { 0.0, 0.0, 5.0 };
  eye.Parallel = true;
  eye.HalfHeight = 0.5;
  ScatteringOptions options;
  options.Width = 20;
  options.Height = 10;
  options.Extent = { 0, 19, 0, 9 };
  options.NumberOfEdgeSamples = 1;
  ScatteringImage image;
  ASSERT_TRUE(RenderScattering({ { occluders, near, air, eye }, { occluders, far, air, eye } }, options, {}, image));
  const auto at = [&](int i) { return image.Radiance[7 * (5 * 20 + static_cast<std::size_t>(i))]; };
  // Pixel i looks at x = (i - 9.5) / 10 or (i - 10) / 10: the discs are -0.8 .. 0.2 and -0.2 .. 0.8.
  EXPECT_FLOAT_EQ(at(4), 1.0f);
  EXPECT_FLOAT_EQ(at(10), 4.0f);
  EXPECT_FLOAT_EQ(at(15), 3.0f);
  EXPECT_FLOAT_EQ(at(0), 0.0f);
}
