// SPDX-License-Identifier: BSD-3-Clause
#include "scCamera.h"
#include "scConeBeam.h"

#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace shadowcones;

namespace
{
const Box bounds{ { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } };

Cone MakeCone(const Vector3& center, const Vector3& axis, double radius, double halfAngle)
{
  Cone cone;
  cone.Center = center;
  cone.Axis = Normalized(axis);
  cone.Normal = cone.Axis;
  cone.BaseRadius = radius;
  cone.HalfAngle = halfAngle;
  return cone;
}

Camera LookAlongZ(bool parallel)
{
  Camera camera;
  camera.Position = { 0.1, -0.2, 6.0 };
  camera.HalfHeight = parallel ? 2.0 : 0.4;
  camera.Parallel = parallel;
  return camera;
}

/// The corners of a bundle of pixels, half a pixel beyond them.
std::array<Ray, 4> Corners(const Camera& camera, int i0, int i1, int j0, int j1, int size)
{
  return { { camera.PixelRay(i0 - 0.5, j0 - 0.5, size, size), camera.PixelRay(i1 + 0.5, j0 - 0.5, size, size),
    camera.PixelRay(i1 + 0.5, j1 + 0.5, size, size), camera.PixelRay(i0 - 0.5, j1 + 0.5, size, size) } };
}

template <typename Interval>
double TotalLength(const std::vector<Interval>& intervals)
{
  double sum = 0.0;
  for (const RayInterval& interval : intervals)
  {
    sum += interval.End - interval.Begin;
  }
  return sum;
}
} // namespace

TEST(ConeBeam, HoldsWhatTheHierarchyFindsAndLittleMore)
{
  std::vector<Cone> cones;
  for (std::uint64_t k = 0; k < 60; ++k)
  {
    RandomStream random(5, k);
    const Vector3 center{ 3.0 * random.Next() - 1.5, 3.0 * random.Next() - 1.5, 3.0 * random.Next() - 1.5 };
    const Vector3 axis{ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 };
    cones.push_back(MakeCone(center, axis, 0.02 + 0.2 * random.Next(), 0.8 * random.Next() - 0.3));
  }
  const ConeHierarchy hierarchy(cones, bounds);
  constexpr int size = 40;
  int met = 0;
  for (const bool parallel : { false, true })
  {
    const Camera camera = LookAlongZ(parallel);
    ConeBeam beam(hierarchy);
    std::vector<OccluderInterval> exact;
    std::vector<RayInterval> intervals;
    for (int block = 0; block < 25; ++block)
    {
      const int i0 = block % 5 * 8;
      const int j0 = block / 5 * 8;
      beam.Gather(Corners(camera, i0, i0 + 7, j0, j0 + 7, size));
      for (int k = 0; k < 64; k += 3)
      {
        const Ray ray = camera.PixelRay(i0 + k % 8, j0 + k / 8, size, size);
        double begin = 0.0;
        double end = HUGE_VAL;
        if (!bounds.Clip(ray.Origin, ray.Direction, begin, end))
        {
          continue;
        }
        beam.Intersect(ray, begin, end, intervals);
        hierarchy.Intersect(ray.Origin, ray.Direction, begin, end, exact);
        for (const RayInterval& interval : exact)
        {
          const bool held = std::any_of(intervals.begin(), intervals.end(),
            [&](const RayInterval& s) { return s.Begin <= interval.Begin + 1e-9 && s.End >= interval.End - 1e-9; });
          EXPECT_TRUE(held) << "pixel " << i0 + k % 8 << ", " << j0 + k / 8;
        }
        // Two parts of 128 an interval are lost to rounding.
        const double rounding = 2.0 * (end - begin) / 128.0;
        EXPECT_LE(TotalLength(intervals), TotalLength(exact) + (static_cast<double>(exact.size()) + 0.01) * rounding);
        for (std::size_t s = 0; s < intervals.size(); ++s)
        {
          EXPECT_LT(intervals[s].Begin, intervals[s].End);
          EXPECT_TRUE(s == 0 || intervals[s - 1].End < intervals[s].Begin);
        }
        met += !exact.empty();
      }
    }
  }
  EXPECT_GT(met, 200);
}

TEST(ConeBeam, GathersOnlyWhatTheBundleMeets)
{
  const ConeHierarchy hierarchy(
    { MakeCone({ -1.5, -1.5, 0.0 }, { 0.0, 0.0, -1.0 }, 0.1, 0.0),
      MakeCone({ 1.5, 1.5, 0.0 }, { 0.0, 0.0, -1.0 }, 0.1, 0.0) },
    bounds);
  const Camera camera = LookAlongZ(true);
  ConeBeam beam(hierarchy);
  beam.Gather(Corners(camera, 0, 15, 0, 15, 32));
  EXPECT_EQ(beam.NumberOfCones(), 1u);
  beam.Gather(Corners(camera, 16, 31, 16, 31, 32));
  EXPECT_EQ(beam.NumberOfCones(), 1u);
  beam.Gather(Corners(camera, 0, 31, 0, 31, 32));
  EXPECT_EQ(beam.NumberOfCones(), 2u);
  beam.Gather(Corners(camera, 0, 3, 28, 31, 32));
  EXPECT_EQ(beam.NumberOfCones(), 0u);
  std::vector<RayInterval> intervals{ { 1.0, 2.0 } };
  beam.Intersect(camera.PixelRay(1, 30, 32, 32), 4.0, 8.0, intervals);
  EXPECT_TRUE(intervals.empty());
}

TEST(ConeBeam, ARayAlongTheAxis)
{
  // A cylinder from z = 1 downwards, cut by the bounds at z = -2.
  const ConeHierarchy hierarchy({ MakeCone({ 0.1, -0.2, 1.0 }, { 0.0, 0.0, -1.0 }, 0.3, 0.0) }, bounds);
  const Camera camera = LookAlongZ(true);
  ConeBeam beam(hierarchy);
  beam.Gather(Corners(camera, 7, 8, 7, 8, 16));
  std::vector<RayInterval> intervals;
  beam.Intersect({ { 0.1, -0.2, 6.0 }, { 0.0, 0.0, -1.0 } }, 4.0, 8.0, intervals);
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_NEAR(intervals[0].Begin, 5.0, 4.0 / 128.0 + 1e-9);
  EXPECT_LE(intervals[0].Begin, 5.0);
  EXPECT_EQ(intervals[0].End, 8.0);
}
