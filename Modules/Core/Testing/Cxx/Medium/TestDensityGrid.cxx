// SPDX-License-Identifier: BSD-3-Clause
#include "scDensityGrid.h"

#include "SampledDensity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

using namespace shadowcones;

TEST(DensityGrid, IsTrilinearBetweenPointsAndZeroOutside)
{
  const auto density = [](const Vector3& x) { return 1.0 + 0.5 * x.X + 0.25 * x.Y + 2.0 * x.Z + x.X * x.Y * x.Z; };
  const DensityGrid grid = SampleDensity({ { 3, 4, 5 } }, { -1.0, 0.0, 1.0 }, UnitAxes({ 0.5, 0.25, 0.75 }), density);
  // In the cell with the corner at the origin of the grid: trilinear there means exact for each monomial of one cell.
  const Vector3 corner{ -1.0, 0.0, 1.0 };
  const Vector3 center = corner + 0.5 * Vector3{ 0.5, 0.25, 0.75 };
  double mean = 0.0;
  for (int k = 0; k < 8; ++k)
  {
    mean += density(corner + Vector3{ k & 1 ? 0.5 : 0.0, k & 2 ? 0.25 : 0.0, k & 4 ? 0.75 : 0.0 }) / 8.0;
  }
  EXPECT_NEAR(grid.At(center), mean, 1e-6);
  EXPECT_NEAR(grid.At(corner), density(corner), 1e-6);
  EXPECT_NEAR(grid.At({ 0.0, 0.75, 4.0 }), density({ 0.0, 0.75, 4.0 }), 1e-6);
  EXPECT_NEAR(grid.At({ -0.5, 0.3, 1.75 }), density({ -0.5, 0.3, 1.75 }), 1e-6);
  for (const Vector3& outside :
    { Vector3{ -1.001, 0.1, 1.1 }, Vector3{ -0.5, 0.7501, 1.1 }, Vector3{ -0.5, 0.1, 4.01 } })
  {
    EXPECT_EQ(grid.At(outside), 0.0);
  }
}

TEST(DensityGrid, AnAxisWithOnePointIsNoLimit)
{
  const DensityGrid layers =
    SampleDensity({ { 1, 5, 1 } }, {}, UnitAxes({ 1.0, 0.5, 1.0 }), [](const Vector3& x) { return 3.0 - x.Y; });
  EXPECT_NEAR(layers.At({ 1e4, 0.7, -1e4 }), 2.3, 1e-6);
  EXPECT_EQ(layers.At({ 0.0, 2.1, 0.0 }), 0.0);
  EXPECT_NEAR(layers.Integrate({ 5.0, 0.7, 7.0 }, { 1.0, 0.0, 0.0 }, 2.0, 6.0), 4.0 * 2.3, 1e-5);
  EXPECT_NEAR(layers.Integrate({ 5.0, -9.0, 7.0 }, { 0.0, 1.0, 0.0 }, 0.0, 90.0), 4.0, 1e-5);

  const DensityGrid everywhere =
    SampleDensity({ { 1, 1, 1 } }, {}, UnitAxes({ 1.0, 1.0, 1.0 }), [](const Vector3&) { return 2.5; });
  EXPECT_EQ(everywhere.At({ 1e6, -3.0, 2.0 }), 2.5);
  EXPECT_DOUBLE_EQ(everywhere.Integrate({ 5.0, -9.0, 7.0 }, { 0.0, 0.6, 0.8 }, 1.0, 9.0), 20.0);
}

TEST(DensityGrid, IntegralsAreThoseOfTheInterpolant)
{
  // Turned, skewed in scale and far away: along any ray the integral is a fine sum of At().
  const DensityGrid grid = SampleDensity({ { 9, 7, 8 } }, { 1e6, -2.0, 3.0 }, TurnedAxes({ 0.5, 0.75, 0.25 }),
    [](const Vector3& x) { return 2.0 + std::sin(1.3 * x.Y) * std::cos(0.9 * x.Z + x.X - 1e6); });
  const Vector3 middle = grid.Origin + 4.0 * grid.Axes[0] + 3.0 * grid.Axes[1] + 3.5 * grid.Axes[2];
  for (int k = 0; k < 20; ++k)
  {
    const Vector3 direction = Normalized({ std::cos(1.7 * k), std::sin(2.9 * k), std::cos(0.3 * k * k) });
    const Vector3 origin = middle - 6.0 * direction + 0.02 * k * grid.Axes[k % 3];
    // A stretch inside the grid, across several cells.
    const double begin = 5.25;
    const double end = 6.75;
    double expected = 0.0;
    const int steps = 4000;
    for (int s = 0; s < steps; ++s)
    {
      expected += (end - begin) / steps * grid.At(origin + (begin + (s + 0.5) * (end - begin) / steps) * direction);
    }
    ASSERT_GT(expected, 1.0);
    EXPECT_NEAR(grid.Integrate(origin, direction, begin, end) / expected, 1.0, 1e-6) << "ray " << k;
  }
}

TEST(DensityGrid, EmptySpaceIsSkipped)
{
  // One dense point in a large grid: the support is its neighbourhood, and rays beside it meet nothing.
  const DensityGrid grid = SampleDensity({ { 64, 64, 64 } }, {}, UnitAxes({ 1.0, 1.0, 1.0 }),
    [](const Vector3& x) { return x.X == 20.0 && x.Y == 30.0 && x.Z == 40.0 ? 4.0 : 0.0; });
  EXPECT_NEAR(Length(grid.Support.Min - Vector3{ 19.0, 29.0, 39.0 }), 0.0, 1e-5);
  EXPECT_NEAR(Length(grid.Support.Max - Vector3{ 21.0, 31.0, 41.0 }), 0.0, 1e-5);
  EXPECT_NEAR(grid.Integrate({ -5.0, 30.0, 40.0 }, { 1.0, 0.0, 0.0 }, 0.0, 100.0), 4.0, 1e-4);
  EXPECT_EQ(grid.Integrate({ -5.0, 33.0, 40.0 }, { 1.0, 0.0, 0.0 }, 0.0, 100.0), 0.0);

  const DensityGrid nothing =
    SampleDensity({ { 4, 4, 4 } }, {}, UnitAxes({ 1.0, 1.0, 1.0 }), [](const Vector3&) { return 0.0; });
  EXPECT_EQ(nothing.Integrate({ -5.0, 1.0, 1.0 }, { 1.0, 0.0, 0.0 }, 0.0, 100.0), 0.0);
  EXPECT_EQ(nothing.At({ 1.0, 1.0, 1.0 }), 0.0);
}

TEST(DensityGrid, FaultsAreNamed)
{
  const auto fault = [](const std::function<void(DensityGrid&)>& damage)
  {
    DensityGrid grid =
      SampleDensity({ { 2, 2, 2 } }, {}, UnitAxes({ 1.0, 1.0, 1.0 }), [](const Vector3&) { return 1.0; });
    damage(grid);
    const char* message = PrepareDensityGrid(grid);
    return std::string(message ? message : "");
  };
  EXPECT_EQ(fault([](DensityGrid&) {}), "");
  EXPECT_NE(fault([](DensityGrid& g) { g.Dimensions[1] = 0; }).find("no points"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Values.pop_back(); }).find("one value for each"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Values[3] = -1.0f; }).find("negative"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Values[3] = std::numeric_limits<float>::quiet_NaN(); }).find("not finite"),
    std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Axes[2] = g.Axes[0]; }).find("span"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Axes[2] = {}; }).find("span"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Axes[2] = { 0.0, 0.0, 1e-19 }; }).find("1e-18 to 1e18"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Axes[1] = { 0.0, 1e19, 0.0 }; }).find("1e-18 to 1e18"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Origin = { 1.7e308, 1.7e308, 1.7e308 }; }).find("beyond 1e18"), std::string::npos);
  EXPECT_NE(fault([](DensityGrid& g) { g.Origin.X = HUGE_VAL; }).find("origin"), std::string::npos);
}
