// SPDX-License-Identifier: BSD-3-Clause
// What discs together hide of a light: against the closed form of one disc, and as sampled on grids.
#include "scUmbraField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;

namespace
{
Light DiscLight(double radius)
{
  Light light;
  light.Normal = { 0.0, 0.0, 1.0 };
  light.Radius = radius;
  light.Spectrum = { 1.0 };
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

Cone DiscAt(double x, double radius)
{
  Cone cone;
  cone.Center = { x, 0.0, 2.0 };
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.BaseRadius = radius;
  return cone;
}
} // namespace

TEST(UmbraField, OneDiscUnderADiscLight)
{
  const double R = 0.5;
  const double r = 0.3;
  const UmbraField field({ DiscAt(0.0, r) }, DiscLight(R), 10.0);
  for (const double z : { 2.2, 2.8, 3.5, 4.5, 5.5 })
  {
    const double umbra = r - (R - r) * (z - 2.0) / 2.0;
    // The light's rim is a polygon of 32 corners around it, half a per cent wider.
    const double inside = umbra - 0.006 * R * (z - 2.0) / 2.0;
    if (inside > 0.0)
    {
      EXPECT_LT(field.Value({ inside, 0.0, z }), 0.0);
      EXPECT_LT(field.Value({ 0.0, -inside, z }), 0.0);
    }
    EXPECT_GT(field.Value({ std::abs(umbra) + 1e-6, 0.0, z }), 0.0);
    EXPECT_GT(field.Value({ 0.0, -std::abs(umbra) - 1e-6, z }), 0.0);
  }
  EXPECT_GT(field.Value({ 0.0, 0.0, 1.9 }), 0.0) << "before the disc";
}

TEST(UmbraField, ASunsUmbraContractsByItsRadius)
{
  Light sun;
  sun.Shape = LightShape::Sun;
  sun.Normal = { 0.0, 0.0, 1.0 };
  sun.Radius = 0.1;
  sun.Spectrum = { 1.0 };
  ASSERT_EQ(PrepareLight(sun), nullptr);
  const UmbraField field({ DiscAt(0.0, 0.5) }, sun, 10.0);
  for (const double h : { 0.5, 2.0, 4.0 })
  {
    const double umbra = 0.5 - h * std::tan(0.1);
    EXPECT_LT(field.Value({ umbra - 0.01, 0.0, 2.0 + h }), 0.0);
    EXPECT_GT(field.Value({ umbra + 0.01, 0.0, 2.0 + h }), 0.0);
  }
}

TEST(UmbraField, TwoDiscsHideTogether)
{
  const Light light = DiscLight(0.3);
  const UmbraField both({ DiscAt(-0.3, 0.4), DiscAt(0.3, 0.4) }, light, 10.0);
  const Vector3 between{ 0.0, 0.0, 3.5 };
  EXPECT_LT(both.Value(between), 0.0);
  EXPECT_GT(UmbraField({ DiscAt(-0.3, 0.4) }, light, 10.0).Value(between), 0.0);
  EXPECT_GT(UmbraField({ DiscAt(-0.45, 0.4), DiscAt(0.45, 0.4) }, light, 10.0).Value(between), 0.0)
    << "through the gap";
}

TEST(UmbraField, SamplesOfManyDiscsAreThoseOfALookAtEveryDisc)
{
  std::vector<Cone> discs;
  for (int k = 0; k < 120; ++k)
  {
    Cone disc = DiscAt(0.9 * std::cos(2.4 * k) * std::sqrt(k / 30.0), 0.12 + 0.002 * k);
    disc.Center.Y = 0.9 * std::sin(2.4 * k) * std::sqrt(k / 30.0);
    disc.Center.Z = 2.0 + 0.004 * k;
    discs.push_back(disc);
  }
  const Box region{ { -2.0, -2.0, 2.0 }, { 2.0, 2.0, 4.0 } };
  const UmbraField field(discs, DiscLight(0.3), 10.0, region);
  const RegularGrid grid = GridOver(region, 40);
  std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
  ASSERT_TRUE(field.Sample(grid, region, {}, values.data()));
  const double largest = 2.0 * Length(grid.Spacing);
  int near = 0;
  vtkIdType id = 0;
  for (int k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.Dimensions[0]; ++i, ++id)
      {
        const Vector3 p = grid.Point(i, j, k);
        const bool inside = region.Contains(p) && std::fabs(values[id]) < 0.99 * largest;
        if (inside && (i + j + k) % 5 == 0)
        {
          const double outside = std::max({ region.Min.X - p.X, p.X - region.Max.X, region.Min.Y - p.Y,
            p.Y - region.Max.Y, region.Min.Z - p.Z, p.Z - region.Max.Z });
          ASSERT_NEAR(values[id], std::max(field.Value(p), outside), 1e-6) << i << " " << j << " " << k;
          ++near;
        }
      }
    }
  }
  EXPECT_GT(near, 300);
}

TEST(UmbraField, SamplesHaveTheSignOfTheField)
{
  std::vector<Cone> discs;
  for (int k = 0; k < 9; ++k)
  {
    discs.push_back(DiscAt(0.2 * (k - 4), 0.15 + 0.02 * k));
  }
  const UmbraField field(discs, DiscLight(0.1), 1.5);
  const Box region = field.Region();
  const RegularGrid grid = GridOver(region, 25);
  std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
  ASSERT_TRUE(field.Sample(grid, region, {}, values.data()));
  int inside = 0;
  vtkIdType id = 0;
  Box umbra;
  for (int k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.Dimensions[0]; ++i, ++id)
      {
        const Vector3 point = grid.Point(i, j, k);
        const bool expected = region.Contains(point) && field.Value(point) < 0.0;
        EXPECT_EQ(values[id] < 0.0f, expected);
        inside += expected;
        if (expected)
        {
          umbra.Add(point);
        }
      }
    }
  }
  EXPECT_GT(inside, 100);
  const Box found = field.Find(region, 25, {});
  EXPECT_TRUE(found.Contains(umbra.Min) && found.Contains(umbra.Max));
  EXPECT_LT(found.Diagonal(), region.Diagonal());

  Monitor monitor;
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(field.Sample(grid, region, monitor, values.data()));
  EXPECT_TRUE(field.Find(region, 25, monitor).Empty());
}
