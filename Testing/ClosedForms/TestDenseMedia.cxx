// SPDX-License-Identifier: BSD-3-Clause
// Media from thin haze to ink, and lights that a ray passes ever so closely: against closed forms.
#include "ClosedForms.h"
#include "Scenes.h"
#include "scDensityGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Irradiance = 3.0;
constexpr ScatteringMode FastModes[] = { ScatteringMode::Guided, ScatteringMode::Soft, ScatteringMode::Volume };

/// A slab of height 2, seen from above; the sun leans by @p lean radians from the view.
ImageTestScene Slab(double lean, std::vector<double> sigmaS, std::vector<double> sigmaA)
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Sun, {}, { std::sin(lean), 0.0, -std::cos(lean) }, 0.0,
    std::vector<double>(sigmaS.size(), Irradiance));
  scene.SetMedium(std::move(sigmaS), std::move(sigmaA), { -50.0, -50.0, -1.0 }, { 50.0, 50.0, 1.0 });
  scene.AddNothing();
  scene.Eye = LookAt({ 0.0, 0.0, 10.0 }, { 0.0, 0.0, 0.0 }, 0.02, true);
  scene.SetSize(3, 3);
  scene.Options.RelativeErrorGoal = 0.005;
  scene.GridOptions.Dimensions = { 3, 3, 3 };
  return scene;
}

/// Both legs together are 1 + 1 / cos(lean) times the depth below the top.
double SlabForm(double sigmaS, double sigmaT, double lean, double length)
{
  const double legs = 1.0 + 1.0 / std::cos(lean);
  return -sigmaS * Irradiance / (4.0 * closedforms::Pi) * std::expm1(-sigmaT * legs * length) / (sigmaT * legs);
}
} // namespace

TEST(DenseMedia, SunOnASlab)
{
  for (const double lean : { 0.0, 1.0 })
  {
    for (const double sigma : { 1e-9, 1e-3, 1.0, 20.0, 1e3, 1e4, 1e6 })
    {
      // The second wavelength is much thinner than the first: one profile serves both.
      const ImageTestScene scene = Slab(lean, { 0.7 * sigma, 0.01 * sigma }, { 0.3 * sigma, 0.0 });
      for (const ScatteringMode mode : FastModes)
      {
        const ScatteringImage image = scene.Render(mode);
        for (std::size_t pixel = 0; pixel < 9; ++pixel)
        {
          EXPECT_NEAR(image.InScattering[2 * pixel] / SlabForm(0.7 * sigma, sigma, lean, 2.0), 1.0, 1e-3)
            << NameOf(mode) << ", sigma_t " << sigma << ", lean " << lean;
          EXPECT_NEAR(image.InScattering[2 * pixel + 1] / SlabForm(0.01 * sigma, 0.01 * sigma, lean, 2.0), 1.0, 1e-3)
            << NameOf(mode) << ", sigma_t " << 0.01 * sigma << ", lean " << lean;
          EXPECT_LE(image.RelativeError[pixel], 0.0075f);
        }
      }
    }
  }
}

TEST(DenseMedia, AnyDensityUnderTheSunIsItsDepth)
{
  // With the sun behind the camera the integral of sigma_s density exp(-2 depth) depends on the whole depth alone.
  DensityGrid grid;
  grid.Dimensions = { 1, 1, 41 };
  grid.Origin = { 0.0, 0.0, -1.0 };
  grid.Axes = { Vector3{ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 0.05 } };
  double depth = 0.0;
  for (int k = 0; k < 41; ++k)
  {
    // Nothing above, then a bank with a sharp rim, thin below.
    const double z = -1.0 + 0.05 * k;
    grid.Values.push_back(static_cast<float>(z > 0.42 ? 0.0 : (z > 0.1 ? 1.0 + 0.3 * std::sin(9.0 * z) : 1e-3)));
    depth += k > 0 ? 0.025 * (grid.Values.back() + grid.Values[static_cast<std::size_t>(k - 1)]) : 0.0;
  }
  ASSERT_EQ(PrepareDensityGrid(grid), nullptr);
  for (const double sigma : { 1.0, 50.0, 1e4, 1e6 })
  {
    ImageTestScene scene = Slab(0.0, { 0.5 * sigma }, { 0.5 * sigma });
    scene.Fog.Density = &grid;
    for (const ScatteringMode mode : FastModes)
    {
      const ScatteringImage image = scene.Render(mode);
      EXPECT_NEAR(image.InScattering[4] / SlabForm(0.5 * sigma, sigma, 0.0, depth), 1.0, 1e-3)
        << NameOf(mode) << ", sigma_t " << sigma;
    }
  }
}

TEST(DenseMedia, StepsOfInkAreLitOnTheirFaces)
{
  // Lommel and Seeliger: where both legs grow alike, as below a face, single scattering leaves mu0 / (mu + mu0) of what an
  // albedo of 1 would send on, whatever the density. Steps of two heights, so that rays beside each other differ.
  constexpr int columns = 8;
  DensityGrid grid;
  grid.Dimensions = { 10 * columns + 1, 2, 41 };
  grid.Origin = { -0.5 * columns, -50.0, -1.0 };
  grid.Axes = { Vector3{ 0.1, 0.0, 0.0 }, { 0.0, 100.0, 0.0 }, { 0.0, 0.0, 0.05 } };
  const auto top = [](int column) { return column % 2 == 0 ? 0.4 : -0.2; }; // of nodes without density
  for (int k = 0; k < 41; ++k)
  {
    for (int i = 0; i < 2 * (10 * columns + 1); ++i)
    {
      grid.Values.push_back(-1.0 + 0.05 * k < top(i % (10 * columns + 1) / 10) - 1e-6 ? 1.0f : 0.0f);
    }
  }
  ASSERT_EQ(PrepareDensityGrid(grid), nullptr);
  const double lean = 0.7;
  const double mu0 = std::cos(lean);
  int tried = 0;
  for (const auto& [sigma, mode] : { std::make_pair(30.0, ScatteringMode::BruteForce),
         std::make_pair(30.0, ScatteringMode::Guided), std::make_pair(1e4, ScatteringMode::Guided),
         std::make_pair(1e9, ScatteringMode::Guided), std::make_pair(1e15, ScatteringMode::Guided) })
  {
    ImageTestScene scene;
    scene.SetLight(LightShape::Sun, {}, { 0.0, std::sin(lean), -mu0 }, 0.0, { Irradiance });
    scene.SetMedium({ 0.6 * sigma }, { 0.4 * sigma }, { -0.5 * columns, -50.0, -1.0 }, { 0.5 * columns, 50.0, 1.0 });
    scene.AddNothing();
    scene.Fog.Density = &grid;
    scene.Eye = LookAt({ 0.13, 0.0, 6.0 }, { 0.0, 0.0, 0.0 }, 0.2);
    scene.SetSize(48, 8);
    scene.Options.Extent = { 0, 47, 0, 3 };
    scene.Options.RelativeErrorGoal = 0.005;
    scene.Options.NumberOfSteps = 1000;
    const double ofSteps = mode == ScatteringMode::BruteForce ? 3e-4 : 1e-4;
    const ScatteringImage image = scene.Render(mode);
    for (int pixel = 0; pixel < 48 * 4; ++pixel)
    {
      const Ray ray = scene.PixelRay(pixel % 48, pixel / 48);
      const auto placeAt = [&](double z)
      { return ray.Origin.X + (z - ray.Origin.Z) / ray.Direction.Z * ray.Direction.X + 0.5 * columns; };
      const double place = placeAt(top(0));
      const auto column = static_cast<int>(std::floor(place));
      const double below = placeAt(top(column));
      const double least = std::min(place, below) - column;
      const double most = std::max(place, below) - column;
      if (column < 0 || column >= columns || least < 0.15 || most > 0.75)
      {
        continue; // next to a wall, or beside them all
      }
      const double expected = 0.6 * Irradiance / (4.0 * closedforms::Pi) * mu0 / (mu0 - ray.Direction.Z);
      const auto index = static_cast<std::size_t>(pixel);
      EXPECT_NEAR(image.InScattering[index] / expected, 1.0, 2.0 * image.RelativeError[index] + ofSteps)
        << NameOf(mode) << ", sigma_t " << sigma << ", pixel " << pixel;
      tried += 1;
    }
  }
  EXPECT_EQ(tried, 5 * 64);
}

TEST(DenseMedia, ShadowsOfTheSizeOfAMeanFreePath)
{
  for (const double sigma : { 20.0, 1e3, 1e4 })
  {
    // Seen along x, a mean free path below a face that the sun stands on; a plate hides a part of the first few of
    // them.
    const double path = 1.0 / sigma;
    ImageTestScene scene;
    scene.SetLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { Irradiance });
    scene.SetMedium({ 0.6 * sigma }, { 0.4 * sigma }, { 0.0, -1.0, -0.5 }, { 1.0, 0.0, 0.5 });
    scene.Mesh.AddSheet({ 0.4 * path, 0.5 * path, -0.4 }, { 0.8 * path, 0.0, 0.0 }, { 0.0, 0.0, 0.8 });
    scene.Eye = LookAt({ -1.0, -path, 0.0 }, { 1.0, -path, 0.0 }, 0.01 * path, true);
    scene.SetSize(3, 3);
    scene.Options.RelativeErrorGoal = 0.003;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
    for (int pixel = 0; pixel < 9; ++pixel)
    {
      const double y = scene.PixelRay(pixel % 3, pixel / 3).Origin.Y;
      const double expected = closedforms::SlabRadiance(
        0.6 * sigma, sigma, Irradiance, 1.0 + y, 1.0, { { 0.4 * path, 1.2 * path } });
      const auto index = static_cast<std::size_t>(pixel);
      EXPECT_NEAR(image.InScattering[index] / expected, 1.0, 3.0 * image.RelativeError[index] + 1e-3)
        << "sigma_t " << sigma;
      EXPECT_LE(image.RelativeError[index], 0.0046f) << "sigma_t " << sigma;
    }
  }
}

TEST(DenseMedia, MarchesSayWhenTheirStepsAreThick)
{
  struct Case
  {
    double Sigma;
    int Steps;
    bool Thick;
  };
  // Steps of optical depth x are too bright by x / tanh(x): 0.3 % at 0.1, 31 % at 1.
  for (const Case& one : { Case{ 1.0, 32, false }, { 10.0, 400, false }, { 10.0, 20, true }, { 1e4, 256, true } })
  {
    ImageTestScene scene = Slab(0.0, { 0.7 * one.Sigma }, { 0.3 * one.Sigma });
    scene.Options.NumberOfSteps = one.Steps;
    scene.Options.MaximumHalvings = 0;
    for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast })
    {
      const ScatteringImage image = scene.Render(mode);
      const double depth = 2.0 * one.Sigma / one.Steps;
      const double excess = depth / std::tanh(depth);
      EXPECT_NEAR(image.InScattering[4] / SlabForm(0.7 * one.Sigma, one.Sigma, 0.0, 2.0), excess, 1e-4 * excess);
      EXPECT_EQ(image.NumberOfThickRays, one.Thick ? 9 : 0) << NameOf(mode) << ", sigma_t " << one.Sigma;
      EXPECT_NEAR(image.MarchOpticalDepth, one.Thick ? depth : 0.0, 1e-9 * depth);
    }
    const ScatteringImage guided = scene.Render(ScatteringMode::Guided);
    EXPECT_EQ(guided.NumberOfThickRays, 0);
  }
}

TEST(DenseMedia, AWideMediumPastALamp)
{
  // All but clear: L = sigma_s I / (4 pi d) times the angle under which the lamp sees the ray.
  const double half = 1e3;
  const double sigmaS = 1e-9;
  for (const double distance : { 1.0, 1e-2, 1e-3, 1e-4, 1e-5 }) // down to 5e-9 of the ray's length
  {
    ImageTestScene scene;
    scene.SetLight(LightShape::Point, { 31.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 0.0, { 2.0 });
    scene.SetMedium({ sigmaS }, { 0.0 }, { -half, -2.0, -2.0 }, { half, 2.0, 2.0 });
    scene.AddNothing();
    scene.Eye = LookAt({ -half - 1.0, 0.0, distance }, { half, 0.0, distance }, 0.3 * distance, true);
    scene.SetSize(3, 3);
    scene.Options.RelativeErrorGoal = 0.005;
    for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume })
    {
      const ScatteringImage image = scene.Render(mode);
      for (int pixel = 0; pixel < 9; ++pixel)
      {
        const Vector3 origin = scene.PixelRay(pixel % 3, pixel / 3).Origin;
        const double d = std::hypot(origin.Y, origin.Z);
        const double expected = sigmaS * 2.0 / (4.0 * closedforms::Pi * d) *
          (std::atan((half - 31.0) / d) + std::atan((half + 31.0) / d));
        const auto index = static_cast<std::size_t>(pixel);
        EXPECT_NEAR(image.InScattering[index] / expected, 1.0, 2e-3) << NameOf(mode) << ", at " << d;
        EXPECT_LE(image.RelativeError[index], 0.0075f);
      }
    }
  }
}
