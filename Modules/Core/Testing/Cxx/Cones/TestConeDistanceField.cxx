// SPDX-License-Identifier: BSD-3-Clause
// The implicit function of a cone set: against dense points on cones, against ConeContains, and as sampled on grids.
#include "scCone.h"
#include "scConeDistanceField.h"
#include "scRandom.h"
#include "scRegularGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace shadowcones;

namespace
{
Vector3 RandomVector(RandomStream& random, double size)
{
  return { size * (2.0 * random.Next() - 1.0), size * (2.0 * random.Next() - 1.0), size * (2.0 * random.Next() - 1.0) };
}

/// Cones of every kind: opening, closing to a tip, cylinders, and some that start in a point.
std::vector<Cone> RandomCones(int count, double size, std::uint64_t seed)
{
  RandomStream random(seed, 0);
  std::vector<Cone> cones(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    Cone& cone = cones[i];
    cone.Center = RandomVector(random, size);
    cone.Axis = i % 7 == 0 ? Vector3{ 0.0, -1.0, 0.0 } : Normalized(RandomVector(random, 1.0));
    cone.BaseRadius = i % 11 == 3 ? 0.0 : 0.3 * random.Next();
    cone.HalfAngle = i % 5 == 0 ? 0.0 : 0.9 * (2.0 * random.Next() - 0.6);
    cone.InnerHalfAngle = -std::abs(cone.HalfAngle);
  }
  return cones;
}

/// Distance to a cone of length @p length from points on its profile, in the half plane of the axis and the point.
double SlowDistance(const Cone& cone, double length, const Vector3& point)
{
  const double tangent = std::tan(cone.HalfAngle);
  const double height = tangent < 0.0 ? std::min(length, -cone.BaseRadius / tangent) : length;
  const Vector3 offset = point - cone.Center;
  const double h = Dot(offset, cone.Axis);
  const double r = Length(offset - h * cone.Axis);
  const double endRadius = cone.BaseRadius + height * tangent;
  double nearest = HUGE_VAL;
  const int steps = 4000;
  for (int k = 0; k <= steps; ++k)
  {
    const double s = static_cast<double>(k) / steps;
    nearest = std::min({ nearest, std::hypot(r - s * cone.BaseRadius, h), std::hypot(r - s * endRadius, h - height),
      std::hypot(r - cone.BaseRadius - s * (endRadius - cone.BaseRadius), h - s * height) });
  }
  return ConeContains(cone, point, length) ? -nearest : nearest;
}
} // namespace

TEST(ConeDistanceField, DistanceToOneCone)
{
  const double length = 1.5;
  RandomStream random(3, 0);
  int inside = 0;
  for (const Cone& cone : RandomCones(40, 1.0, 5))
  {
    const ConeDistanceField field({ cone }, ConeBound::Outer, length);
    if (field.Region().Empty())
    {
      EXPECT_TRUE(cone.BaseRadius == 0.0 && cone.HalfAngle <= 0.0);
      continue;
    }
    for (int k = 0; k < 20; ++k)
    {
      const Vector3 point = cone.Center + 0.5 * length * cone.Axis + RandomVector(random, 1.0);
      if (!field.Region().Contains(point))
      {
        continue; // there the distance to the region's box may be the larger one
      }
      const double expected = SlowDistance(cone, length, point);
      EXPECT_NEAR(field.Distance(point), expected, 1e-3);
      inside += expected < 0.0;
    }
  }
  EXPECT_GT(inside, 30);
}

TEST(ConeDistanceField, SignIsThatOfTheConesInsideTheBounds)
{
  const auto cones = RandomCones(60, 1.0, 6);
  const Box bounds{ { -0.8, -1.0, -1.1 }, { 1.0, 0.7, 0.9 } };
  const double length = 0.8;
  for (const ConeBound bound : { ConeBound::Outer, ConeBound::Inner })
  {
    const ConeDistanceField field(cones, bound, length, bounds);
    RandomStream random(7, 0);
    int inside = 0;
    for (int k = 0; k < 5000; ++k)
    {
      const Vector3 point = RandomVector(random, 1.5);
      bool expected = false;
      for (Cone cone : cones)
      {
        cone.HalfAngle = bound == ConeBound::Outer ? cone.HalfAngle : cone.InnerHalfAngle;
        expected = expected || (bounds.Contains(point) && ConeContains(cone, point, length));
      }
      EXPECT_EQ(field.Distance(point) <= 0.0, expected) << point.X << " " << point.Y << " " << point.Z;
      inside += expected;
    }
    EXPECT_GT(inside, 50);
    EXPECT_LT(inside, 4500);
  }
}

TEST(ConeDistanceField, ChangesByAtMostTheDistance)
{
  const ConeDistanceField field(
    RandomCones(30, 1.0, 8), ConeBound::Outer, 0.6, { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } });
  RandomStream random(9, 0);
  double steepest = 0.0;
  for (int k = 0; k < 5000; ++k)
  {
    const Vector3 a = RandomVector(random, 1.5);
    const Vector3 b = a + RandomVector(random, 0.02);
    steepest = std::max(steepest, std::abs(field.Distance(a) - field.Distance(b)) / Length(a - b));
  }
  EXPECT_LE(steepest, 1.0 + 1e-9);
  EXPECT_GT(steepest, 0.99);
}

TEST(ConeDistanceField, BoundsCutEndlessCones)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.BaseRadius = 0.25;
  cone.HalfAngle = 0.1;
  const Box bounds{ { -5.0, -0.1, -1.0 }, { 5.0, 5.0, 3.0 } };
  const ConeDistanceField field({ cone }, ConeBound::Outer, HUGE_VAL, bounds);
  const double radius = 0.25 + 3.0 * std::tan(0.1);
  EXPECT_DOUBLE_EQ(field.Region().Min.Y, -0.1);
  EXPECT_DOUBLE_EQ(field.Region().Min.Z, 0.0);
  EXPECT_DOUBLE_EQ(field.Region().Max.Z, 3.0);
  EXPECT_NEAR(field.Region().Max.X, radius, 1e-12);
  EXPECT_NEAR(field.Region().Max.Y, radius, 1e-12);

  cone.Center.Z = 3.5; // shines away from the box
  EXPECT_TRUE(ConeDistanceField({ cone }, ConeBound::Outer, HUGE_VAL, bounds).Region().Empty());
  EXPECT_TRUE(ConeDistanceField({}, ConeBound::Outer, 1.0).Region().Empty());
}

TEST(ConeDistanceField, GridClosesAtTheFacesOfItsBox)
{
  const Box box{ { -1.0, 2.0, 0.0 }, { 3.0, 3.0, 0.01 } };
  const RegularGrid grid = GridOver(box, 40);
  EXPECT_EQ(grid.Dimensions, (std::array<int, 3>{ 42, 12, 3 }));
  EXPECT_EQ(grid.NumberOfPoints(), 42 * 12 * 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(0.5 * (grid.Point(0, 0, 0)[axis] + grid.Point(1, 1, 1)[axis]), box.Min[axis], 1e-12);
    const Vector3 last = grid.Point(grid.Dimensions[0] - 1, grid.Dimensions[1] - 1, grid.Dimensions[2] - 1);
    EXPECT_NEAR(last[axis] - 0.5 * grid.Spacing[axis], box.Max[axis], 1e-12);
  }
}

TEST(ConeDistanceField, ABoxWithoutVolumeHasNoGrid)
{
  const Box flat{ { -1.0, 2.0, 0.0 }, { 3.0, 2.0, 1.0 } };
  const Box point{ { 1.0, 2.0, 3.0 }, { 1.0, 2.0, 3.0 } };
  for (const Box& box : { flat, point, Box() })
  {
    EXPECT_EQ(GridOver(box, 40).NumberOfPoints(), 0);
  }
  EXPECT_EQ(GridOver({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } }, 0).NumberOfPoints(), 0);
}

TEST(ConeDistanceField, SamplesAreDistancesNearTheSurface)
{
  const auto cones = RandomCones(120, 1.0, 10);
  for (const Vector3& offset : { Vector3{}, Vector3{ 1e6, -1e6, 1e6 } })
  {
    auto moved = cones;
    for (Cone& cone : moved)
    {
      cone.Center += offset;
    }
    const ConeDistanceField field(moved, ConeBound::Outer, 0.3);
    const RegularGrid grid = GridOver(field.Region(), 37);
    std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
    ASSERT_TRUE(field.Sample(grid, {}, values.data()));
    const double diagonal = Length(grid.Spacing);
    int exact = 0;
    int filled = 0;
    vtkIdType id = 0;
    for (int k = 0; k < grid.Dimensions[2]; ++k)
    {
      for (int j = 0; j < grid.Dimensions[1]; ++j)
      {
        for (int i = 0; i < grid.Dimensions[0]; ++i, ++id)
        {
          const double expected = field.Distance(grid.Point(i, j, k));
          ASSERT_EQ(values[id] < 0.0f, expected < 0.0);
          const bool same = values[id] == static_cast<float>(expected);
          ASSERT_TRUE(same || std::abs(expected) > diagonal);
          exact += same;
          filled += !same;
          if (i == 0 || j == 0 || k == 0)
          {
            ASSERT_GT(values[id], 0.0f);
          }
        }
      }
    }
    EXPECT_GT(exact, 10000);
    EXPECT_GT(filled, 1000); // blocks far away are skipped
  }
}

TEST(ConeDistanceField, Abort)
{
  const ConeDistanceField field(RandomCones(10, 1.0, 11), ConeBound::Outer, 0.3);
  const RegularGrid grid = GridOver(field.Region(), 64);
  std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(field.Sample(grid, monitor, values.data()));
}
