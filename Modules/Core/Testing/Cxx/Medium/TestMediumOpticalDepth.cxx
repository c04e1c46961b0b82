// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumOpticalDepth.h"

#include "SampledDensity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

using namespace shadowcones;

namespace
{

Medium MediumInside(const Vector3& low, const Vector3& high, const DensityGrid* density)
{
  Medium medium;
  medium.Bounds.Min = low;
  medium.Bounds.Max = high;
  medium.Density = density;
  return medium;
}

/// Points from (-1, -1, -1) on, a quarter of them dense.
DensityGrid Speckled(
  const std::array<int, 3>& dimensions, const Vector3& spacing, std::uint32_t state, double dense, double others)
{
  return SampleDensity(dimensions, { -1.0, -1.0, -1.0 }, UnitAxes(spacing),
    [&](const Vector3&)
    {
      state = state * 1664525u + 1013904223u;
      return state >> 30 == 0 ? dense : others;
    });
}

} // namespace

TEST(MediumOpticalDepth, IsLengthInAHomogeneousMedium)
{
  const Medium medium = MediumInside({ 0.0, 0.0, 0.0 }, { 4.0, 1.0, 1.0 }, nullptr);
  MediumOpticalDepth depth(medium);
  EXPECT_TRUE(depth.IsHomogeneous());
  depth.SetRay({ -1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, 1.0, 5.0);
  EXPECT_EQ(depth.Along(3.25), 2.25);
  EXPECT_EQ(depth.MeanDensity(2.0, 2.5), 1.0);
  EXPECT_EQ(depth.Towards({ 1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, HUGE_VAL), 3.0);
  EXPECT_EQ(depth.Towards({ 1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, 0.5), 0.5);
  EXPECT_EQ(depth.TowardsFromOutside({ -1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, 3.0), 2.0);
  EXPECT_EQ(depth.TowardsFromOutside({ -1.0, 0.5, 0.5 }, { -1.0, 0.0, 0.0 }, 3.0), 0.0);
  EXPECT_EQ(depth.DensityAt({ 9.0, 9.0, 9.0 }), 1.0);
}

TEST(MediumOpticalDepth, OfAConstantImageIsDensityTimesLength)
{
  const DensityGrid grid = SampleDensity(
    { { 6, 7, 8 } }, { -1.0, -1.0, -1.0 }, UnitAxes({ 1.0, 0.5, 0.5 }), [](const Vector3&) { return 0.75; });
  const Medium with = MediumInside({ -1.0, -1.0, -1.0 }, { 4.0, 2.0, 2.5 }, &grid);
  const Medium without = MediumInside({ -1.0, -1.0, -1.0 }, { 4.0, 2.0, 2.5 }, nullptr);
  MediumOpticalDepth dense(with);
  MediumOpticalDepth plain(without);
  EXPECT_FALSE(dense.IsHomogeneous());
  for (int k = 0; k < 20; ++k)
  {
    const Vector3 direction = Normalized({ std::cos(1.7 * k), std::sin(2.9 * k), std::cos(0.3 * k * k) });
    const Vector3 point{ 0.1 * k, 0.3, 0.2 };
    EXPECT_NEAR(dense.Towards(point, direction, HUGE_VAL), 0.75 * plain.Towards(point, direction, HUGE_VAL), 1e-12);
    const Vector3 origin = point - 9.0 * direction;
    EXPECT_NEAR(dense.TowardsFromOutside(origin, direction, 10.0),
      0.75 * plain.TowardsFromOutside(origin, direction, 10.0), 1e-12);
    double begin = 0.0;
    double end = HUGE_VAL;
    ASSERT_TRUE(with.Bounds.Clip(origin, direction, begin, end));
    dense.SetRay(origin, direction, begin, end);
    for (const double share : { 0.0, 0.123, 0.5, 0.997, 1.0 })
    {
      const double t = begin + share * (end - begin);
      EXPECT_NEAR(dense.Along(t), 0.75 * (t - begin), 1e-12);
    }
    EXPECT_NEAR(dense.MeanDensity(begin + 0.1 * (end - begin), end), 0.75, 1e-12);
  }
  EXPECT_DOUBLE_EQ(dense.DensityAt({ 3.9, 1.9, 2.4 }), 0.75);
}

TEST(MediumOpticalDepth, OfARampIsAParabola)
{
  // Density 2 + x on [0, 4], inside wider bounds: 0 before and after.
  const DensityGrid grid =
    SampleDensity({ { 5, 2, 1 } }, {}, UnitAxes({ 1.0, 1.0, 1.0 }), [](const Vector3& x) { return 2.0 + x.X; });
  const Medium medium = MediumInside({ -3.0, 0.0, -1.0 }, { 9.0, 1.0, 1.0 }, &grid);
  MediumOpticalDepth depth(medium);
  depth.SetRay({ -5.0, 0.5, 0.0 }, { 1.0, 0.0, 0.0 }, 2.0, 14.0);
  const auto expected = [](double x) { return 2.0 * x + 0.5 * x * x; };
  for (const double x : { 0.0, 0.2, 1.0, 1.7, 3.99, 4.0 })
  {
    EXPECT_NEAR(depth.Along(5.0 + x), expected(x), 1e-5) << "x " << x;
    EXPECT_NEAR(depth.Towards({ x, 0.5, 0.0 }, { -1.0, 0.0, 0.0 }, HUGE_VAL), expected(x), 1e-5) << "x " << x;
  }
  EXPECT_EQ(depth.Along(2.0), 0.0);
  EXPECT_EQ(depth.Along(4.0), 0.0);
  EXPECT_NEAR(depth.Along(14.0), expected(4.0), 1e-5);
  EXPECT_EQ(depth.MeanDensity(2.0, 4.5), 0.0);
  EXPECT_NEAR(depth.MeanDensity(6.0, 7.0), 3.5, 1e-5);
  EXPECT_EQ(depth.MeanDensity(6.0, 6.0), 0.0);

  // The next ray misses: nothing of the last one's table is left.
  depth.SetRay({ 8.0, 0.5, -5.0 }, { 0.0, 0.0, 1.0 }, 4.0, 6.0);
  EXPECT_EQ(depth.Along(5.0), 0.0);
  EXPECT_EQ(depth.Along(6.0), 0.0);
}

TEST(MediumOpticalDepth, BoundsCutTheImage)
{
  const DensityGrid grid = SampleDensity(
    { { 2, 2, 2 } }, { -9.0, -9.0, -9.0 }, UnitAxes({ 18.0, 18.0, 18.0 }), [](const Vector3&) { return 1.0; });
  const Medium medium = MediumInside({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, &grid);
  const MediumOpticalDepth depth(medium);
  EXPECT_NEAR(depth.Towards({ 0.25, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, HUGE_VAL), 0.75, 1e-12);
  EXPECT_NEAR(depth.TowardsFromOutside({ -5.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, HUGE_VAL), 1.0, 1e-12);
}

TEST(MediumOpticalDepth, TheTableOfARayIsItsIntegral)
{
  // Voxels of ink beside empty ones: cubics that begin within cells.
  const DensityGrid grid = Speckled({ { 5, 6, 4 } }, { 0.5, 0.4, 0.7 }, 5, 1e9, 0.0);
  const Medium medium = MediumInside({ -1.5, -1.5, -1.5 }, { 2.0, 2.0, 2.0 }, &grid);
  MediumOpticalDepth depth(medium);
  for (int k = 0; k < 40; ++k)
  {
    const Vector3 direction =
      k == 0 ? Vector3{ 0.0, 0.0, 1.0 } : Normalized({ std::cos(1.7 * k), std::sin(2.9 * k), std::cos(0.3 * k * k) });
    const Vector3 origin = Vector3{ 0.05 * (k % 7), 0.1, -0.1 } - 9.0 * direction;
    double begin = 0.0;
    double end = HUGE_VAL;
    ASSERT_TRUE(medium.Bounds.Clip(origin, direction, begin, end));
    depth.SetRay(origin, direction, begin, end);
    const double whole = depth.Along(end);
    for (int part = 0; part <= 100; ++part)
    {
      const double t = begin + 0.01 * part * (end - begin);
      const double expected = grid.Integrate(origin, direction, begin, t);
      EXPECT_NEAR(depth.Along(t), expected, 1e-12 * whole + 1e-9 * expected) << k << " " << t;
      const double found = depth.DistanceAt(0.01 * part * whole, begin, end);
      EXPECT_NEAR(depth.Along(found), 0.01 * part * whole, 1e-10 * whole) << k << " " << part;
      EXPECT_NEAR(depth.DensityAlong(t), depth.DensityAt(origin + t * direction), 1e-3) << k << " " << t;
    }
  }
}

TEST(MediumOpticalDepth, NeverGrowsLess)
{
  // What is thin beside ink, in one cell: more digits apart than numbers have.
  const DensityGrid grid = Speckled({ { 3, 4, 3 } }, { 0.7, 0.5, 0.9 }, 9, 1e15, 7.0);
  const Medium medium = MediumInside({ -1.5, -1.5, -1.5 }, { 2.0, 2.0, 2.0 }, &grid);
  MediumOpticalDepth depth(medium);
  for (int k = 0; k < 200; ++k)
  {
    const Vector3 direction = Normalized({ std::cos(1.7 * k), std::sin(2.9 * k), std::cos(0.3 * k * k) });
    const Vector3 origin = Vector3{ 0.05 * (k % 7), 0.1, -0.1 } - 9.0 * direction;
    double begin = 0.0;
    double end = HUGE_VAL;
    ASSERT_TRUE(medium.Bounds.Clip(origin, direction, begin, end));
    depth.SetRay(origin, direction, begin, end);
    double before = 0.0;
    for (int part = 1; part <= 1000; ++part)
    {
      const double t = begin + 0.001 * part * (end - begin);
      const double step = 0.001 * (end - begin);
      EXPECT_GE(depth.MeanDensity(t - step, t), 0.0) << k << " " << t;
      EXPECT_GE(depth.MeanDensity(t - 1e-9, t), 0.0) << k << " " << t;
      EXPECT_GE(depth.Along(t), before - 1e-15 * before) << k << " " << t;
      before = depth.Along(t);
    }
  }
}
