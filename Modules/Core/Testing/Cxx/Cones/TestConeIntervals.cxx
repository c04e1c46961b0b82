// SPDX-License-Identifier: BSD-3-Clause
// Ray-cone intervals against points along the ray, and the hierarchy against a loop over all cones.
#include "scCone.h"
#include "scConeHierarchy.h"
#include "scConeIntervals.h"
#include "scConeSurface.h"
#include "scFrame.h"
#include "scOccluderInterval.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace shadowcones;

namespace
{

constexpr double Pi = 3.14159265358979323846;

Vector3 RandomUnit(RandomStream& random)
{
  const double z = 2.0 * random.Next() - 1.0;
  const double phi = 2.0 * Pi * random.Next();
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(phi), r * std::sin(phi), z };
}

/// Every kind: widening, converging, cylinders, nearly flat, points, lines.
Cone RandomCone(RandomStream& random, int kind)
{
  Cone cone;
  cone.Center = { 2.0 * random.Next() - 1.0, 2.0 * random.Next() - 1.0, 2.0 * random.Next() - 1.0 };
  cone.Axis = kind % 5 == 4 ? Vector3{ 0.0, 0.0, kind % 2 ? 1.0 : -1.0 } : RandomUnit(random);
  cone.BaseRadius = kind % 7 == 6 ? 0.0 : 0.05 + random.Next();
  const double angles[] = { 0.6 * random.Next(), -0.6 * random.Next(), 0.0, 1.2 + 0.3 * random.Next(), -1.0 };
  cone.HalfAngle = angles[(kind / 7) % 5];
  cone.OccluderId = kind % 3;
  return cone;
}

/// Anywhere, along the axis, across it, along a generator, through the tip.
Ray RandomRay(RandomStream& random, const Cone& cone, int kind)
{
  Ray ray;
  ray.Origin = { 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0 };
  const Frame frame = FrameAround(cone.Axis);
  switch (kind % 6)
  {
    case 0:
      ray.Direction = kind % 4 ? cone.Axis : -cone.Axis;
      break;
    case 1:
      ray.Direction = frame.U;
      break;
    case 2:
      ray.Direction = Normalized(cone.Axis + std::tan(cone.HalfAngle) * frame.U);
      break;
    case 3:
      ray.Direction = Normalized(cone.Center + 0.5 * cone.Axis - ray.Origin);
      break;
    default:
      ray.Direction = RandomUnit(random);
  }
  return ray;
}

/// Distance by which a point lies inside the cut cone; negative outside. Written apart from the code under test.
double Depth(const Cone& cone, double length, const Vector3& point)
{
  const Vector3 offset = point - cone.Center;
  const double h = Dot(offset, cone.Axis);
  const double lateral = Length(Cross(offset, cone.Axis));
  const double radius = cone.BaseRadius + std::tan(cone.HalfAngle) * h;
  return std::min({ h, length - h, (radius - lateral) * std::cos(cone.HalfAngle) });
}

bool Inside(const std::vector<OccluderInterval>& intervals, double t)
{
  return std::any_of(
    intervals.begin(), intervals.end(), [t](const OccluderInterval& i) { return i.Begin <= t && t <= i.End; });
}

std::vector<Cone> RandomCones(int count, std::uint64_t seed)
{
  std::vector<Cone> cones;
  RandomStream random(seed, 0);
  for (int i = 0; i < count; ++i)
  {
    cones.push_back(RandomCone(random, i));
    cones.back().BaseRadius *= 0.2;
    cones.back().HalfAngle *= 0.3;
  }
  return cones;
}

const Box Room{ { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } };

} // namespace

TEST(IntersectCone, IsWhereThePointsOfTheRayAreInside)
{
  RandomStream random(5, 0);
  int met = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const Cone cone = RandomCone(random, i);
    const Ray ray = RandomRay(random, cone, i / 3);
    const double length = i % 2 ? HUGE_VAL : 0.2 + random.Next();
    const double tMin = i % 11 ? 0.0 : 0.5;
    const double tMax = 6.0;
    OccluderInterval interval{ 0.0, -1.0, -1 };
    const bool hit = IntersectCone(cone, length, ray, { tMin, tMax }, interval);
    met += hit;
    if (hit)
    {
      ASSERT_LE(interval.Begin, interval.End);
      ASSERT_GE(interval.Begin, tMin);
      ASSERT_LE(interval.End, tMax);
      ASSERT_EQ(interval.OccluderId, cone.OccluderId);
    }
    for (int k = 0; k < 200; ++k)
    {
      const double t = tMin + (tMax - tMin) * (k + 0.5) / 200.0;
      const double depth = Depth(cone, length, ray.Origin + t * ray.Direction);
      const bool covered = hit && interval.Begin <= t && t <= interval.End;
      if (std::abs(depth) > 1e-7)
      {
        ASSERT_EQ(covered, depth > 0.0) << "cone " << i << " angle " << cone.HalfAngle << " t " << t << " depth "
                                        << depth;
        ASSERT_EQ(ConeContains(cone, ray.Origin + t * ray.Direction, length), depth > 0.0);
      }
    }
  }
  EXPECT_GT(met, 1000);
}

TEST(IntersectCone, EndsLieOnTheSurface)
{
  RandomStream random(6, 0);
  int checked = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Cone cone = RandomCone(random, i);
    const Ray ray = RandomRay(random, cone, i / 3);
    OccluderInterval interval;
    if (IntersectCone(cone, 1.5, ray, { -20.0, 20.0 }, interval))
    {
      EXPECT_NEAR(Depth(cone, 1.5, ray.Origin + interval.Begin * ray.Direction), 0.0, 1e-6) << i;
      EXPECT_NEAR(Depth(cone, 1.5, ray.Origin + interval.End * ray.Direction), 0.0, 1e-6) << i;
      checked += interval.End > interval.Begin;
    }
  }
  EXPECT_GT(checked, 1000);
}

TEST(IntersectCone, KnowsOnlyTheSheetAhead)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.BaseRadius = 0.5;
  cone.HalfAngle = Pi / 4.0; // the apex is at z = -0.5, the ghost sheet below it
  OccluderInterval interval;
  EXPECT_FALSE(IntersectCone(cone, HUGE_VAL, { { -9.0, 0.0, -2.0 }, { 1.0, 0.0, 0.0 } }, { 0.0, 20.0 }, interval));
  EXPECT_FALSE(IntersectCone(
    cone, HUGE_VAL, { { -9.0, 0.0, -0.1 }, { 1.0, 0.0, 0.0 } }, { 0.0, 20.0 }, interval)); // below the base
  ASSERT_TRUE(IntersectCone(cone, HUGE_VAL, { { 0.2, 0.0, -9.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 20.0 }, interval));
  EXPECT_NEAR(interval.Begin, 9.0, 1e-12); // enters through the base
  EXPECT_EQ(interval.End, 20.0);
  ASSERT_TRUE(IntersectCone(cone, 2.0, { { 0.2, 0.0, -9.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 20.0 }, interval));
  EXPECT_NEAR(interval.End, 11.0, 1e-12); // cut at its length

  cone.HalfAngle = -Pi / 4.0; // the tip is at z = 0.5
  EXPECT_FALSE(IntersectCone(cone, HUGE_VAL, { { -9.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } }, { 0.0, 20.0 }, interval));
  ASSERT_TRUE(IntersectCone(cone, HUGE_VAL, { { 0.0, 0.0, -9.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 20.0 }, interval));
  EXPECT_NEAR(interval.End, 9.5, 1e-9);
  ASSERT_TRUE(IntersectCone(cone, HUGE_VAL, { { -9.0, 0.0, 0.25 }, { 1.0, 0.0, 0.0 } }, { 0.0, 20.0 }, interval));
  EXPECT_NEAR(interval.Begin, 8.75, 1e-9);
  EXPECT_NEAR(interval.End, 9.25, 1e-9);
}

TEST(IntersectCone, KeepsItsDigitsFarFromTheOrigin)
{
  // A camera a million units away sees the same interval as one close by.
  RandomStream random(8, 0);
  for (int i = 0; i < 500; ++i)
  {
    Cone cone = RandomCone(random, i);
    cone.BaseRadius += 0.05; // a line has no inside to agree on
    const Vector3 direction = RandomUnit(random);
    const Vector3 origin = cone.Center + 0.3 * cone.Axis - 5.0 * direction;
    OccluderInterval close;
    OccluderInterval far;
    const bool hit = IntersectCone(cone, 2.0, { origin, direction }, { 0.0, 10.0 }, close);
    ASSERT_EQ(IntersectCone(cone, 2.0, { origin - 1e6 * direction, direction }, { 1e6, 1e6 + 10.0 }, far), hit) << i;
    if (hit)
    {
      EXPECT_NEAR(far.Begin - 1e6, close.Begin, 1e-6) << i;
      EXPECT_NEAR(far.End - 1e6, close.End, 1e-6) << i;
    }
  }
}

TEST(MergeIntervals, JoinsWhatTouches)
{
  std::vector<OccluderInterval> intervals{ { 3.0, 4.0, 1 }, { 0.0, 1.0, 2 }, { 1.0, 2.0, 1 }, { 3.5, 3.6, 2 },
    { 6.0, 7.0, 1 } };
  std::vector<OccluderInterval> merged = intervals;
  MergeIntervals(merged);
  ASSERT_EQ(merged.size(), 3u);
  EXPECT_EQ(merged[0].Begin, 0.0);
  EXPECT_EQ(merged[0].End, 2.0);
  EXPECT_EQ(merged[0].OccluderId, -1);
  EXPECT_EQ(merged[1].End, 4.0); // an inner interval does not shorten it
  EXPECT_EQ(merged[2].Begin, 6.0);

  merged = intervals;
  MergeIntervals(merged, true);
  ASSERT_EQ(merged.size(), 5u);
  EXPECT_EQ(merged[0].OccluderId, 2);
  EXPECT_EQ(merged[1].OccluderId, 1);
  EXPECT_TRUE(std::is_sorted(merged.begin(), merged.end(),
    [](const OccluderInterval& a, const OccluderInterval& b) { return a.Begin < b.Begin; }));

  merged.clear();
  MergeIntervals(merged);
  EXPECT_TRUE(merged.empty());
}

TEST(ConeHierarchy, IsALoopOverAllCones)
{
  const std::vector<Cone> cones = RandomCones(400, 21);
  for (const double length : { HUGE_VAL, 0.7 })
  {
    const ConeHierarchy hierarchy(cones, Room, length);
    ASSERT_EQ(hierarchy.Cones().size(), cones.size());
    RandomStream random(22, 0);
    std::vector<OccluderInterval> found;
    int covered = 0;
    for (int i = 0; i < 1500; ++i)
    {
      const Ray ray = RandomRay(random, cones[i % cones.size()], i);
      for (const bool perOccluder : { false, true })
      {
        double tMin = 0.0;
        double tMax = i % 3 ? HUGE_VAL : 1.5;
        hierarchy.Intersect(ray.Origin, ray.Direction, tMin, tMax, found, perOccluder);
        std::vector<OccluderInterval> truth;
        if (Room.Clip(ray.Origin, ray.Direction, tMin, tMax))
        {
          for (const Cone& cone : cones)
          {
            OccluderInterval interval;
            if (IntersectCone(cone, length, ray, { tMin, tMax }, interval))
            {
              truth.push_back(interval);
            }
          }
        }
        MergeIntervals(truth, perOccluder);
        // Touching slices and round-off may leave or join slivers: what is covered has to be the same.
        for (const auto* set : { &truth, &found })
        {
          const auto* other = set == &truth ? &found : &truth;
          for (const OccluderInterval& interval : *set)
          {
            if (interval.End - interval.Begin < 1e-9)
            {
              continue;
            }
            const auto same = std::find_if(other->begin(), other->end(),
              [&](const OccluderInterval& o)
              {
                return o.OccluderId == interval.OccluderId && std::abs(o.Begin - interval.Begin) < 1e-9 &&
                  std::abs(o.End - interval.End) < 1e-9;
              });
            ASSERT_NE(same, other->end()) << "ray " << i << " " << interval.Begin << " " << interval.End;
            ++covered;
          }
        }
      }
    }
    EXPECT_GT(covered, 5000);
  }
}

TEST(ConeHierarchy, ContainsWhatAnyConeContains)
{
  const std::vector<Cone> cones = RandomCones(200, 31);
  for (const double length : { HUGE_VAL, 0.7 })
  {
    const ConeHierarchy hierarchy(cones, Room, length);
    RandomStream random(32, 0);
    int inside = 0;
    for (int i = 0; i < 20000; ++i)
    {
      const Vector3 p{ 5.0 * random.Next() - 2.5, 5.0 * random.Next() - 2.5, 5.0 * random.Next() - 2.5 };
      const bool truth = Room.Contains(p) &&
        std::any_of(cones.begin(), cones.end(), [&](const Cone& cone) { return ConeContains(cone, p, length); });
      ASSERT_EQ(hierarchy.Contains(p), truth) << i;
      inside += truth;
    }
    EXPECT_GT(inside, 1000);
    EXPECT_LT(inside, 19000);
  }
}

TEST(ConeHierarchy, AgreesWithItsOwnPoints)
{
  const std::vector<Cone> cones = RandomCones(100, 41);
  const ConeHierarchy hierarchy(cones, Room);
  RandomStream random(42, 0);
  std::vector<OccluderInterval> intervals;
  for (int i = 0; i < 300; ++i)
  {
    const Ray ray = RandomRay(random, cones[i % 100], i);
    hierarchy.Intersect(ray.Origin, ray.Direction, 0.0, 8.0, intervals);
    for (int k = 0; k < 100; ++k)
    {
      const double t = 8.0 * (k + 0.5) / 100;
      const bool close = std::any_of(intervals.begin(), intervals.end(),
        [t](const OccluderInterval& v) { return std::abs(t - v.Begin) < 1e-6 || std::abs(t - v.End) < 1e-6; });
      if (!close)
      {
        ASSERT_EQ(hierarchy.Contains(ray.Origin + t * ray.Direction), Inside(intervals, t)) << i << " " << t;
      }
    }
  }
}

TEST(ConeHierarchy, NamesTheConesAndOccludersAtAPoint)
{
  std::vector<Cone> cones = RandomCones(200, 51);
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    cones[i].OccluderId = static_cast<int>(i % 7);
  }
  const ConeHierarchy hierarchy(cones, Room, 2.0);
  int several = 0;
  for (int i = 0; i < 2000; ++i)
  {
    RandomStream random(52, static_cast<std::uint64_t>(i));
    const Vector3 size = Room.Size();
    const double u = random.Next();
    const double v = random.Next();
    const Vector3 point = Room.Min + Vector3{ u * size.X, v * size.Y, random.Next() * size.Z };
    std::vector<int> expected;
    std::vector<int> occluders;
    for (std::size_t c = 0; c < cones.size(); ++c)
    {
      if (ConeContains(cones[c], point, 2.0))
      {
        expected.push_back(static_cast<int>(c));
        occluders.push_back(cones[c].OccluderId);
      }
    }
    std::sort(occluders.begin(), occluders.end());
    occluders.erase(std::unique(occluders.begin(), occluders.end()), occluders.end());
    std::vector<int> found;
    hierarchy.ConesAt(point, found);
    EXPECT_EQ(found, expected);
    hierarchy.OccludersAt(point, found);
    EXPECT_EQ(found, occluders);
    several += expected.size() > 1;
  }
  EXPECT_GT(several, 100);
}

TEST(ConeHierarchy, MarksGridsWithoutExtentAndMirroredOnes)
{
  const std::vector<Cone> cones = RandomCones(30, 61);
  const ConeHierarchy hierarchy(cones, Room);
  const std::array<int, 3> dimensions{ 11, 7, 5 };
  const Vector3 size = Room.Size();
  const Vector3 middle = Room.Center();
  for (const Vector3& spacing : { Vector3{}, Vector3{ 0.0, size.Y / 12.0, size.Z / 8.0 },
         Vector3{ -size.X / 22.0, size.Y / 14.0, -size.Z / 12.0 }, Vector3{ 1e-320, 0.0, 0.0 } })
  {
    std::vector<unsigned char> marks(11 * 7 * 5, 7);
    ASSERT_TRUE(hierarchy.MarkGrid(middle, spacing, dimensions, {}, marks.data()));
    for (int id = 0; id < 11 * 7 * 5; ++id)
    {
      const Vector3 point =
        middle + Vector3{ spacing.X * (id % 11), spacing.Y * (id / 11 % 7), spacing.Z * (id / 77) };
      EXPECT_EQ(marks[static_cast<std::size_t>(id)], hierarchy.Contains(point) ? 1 : 0)
        << "spacing " << spacing.X << ", vertex " << id;
    }
  }
}

TEST(ConeHierarchy, MarksTheVerticesThatContainsFinds)
{
  const std::vector<Cone> cones = RandomCones(30, 61);
  const ConeHierarchy hierarchy(cones, Room);
  const std::array<int, 3> dimensions{ 23, 17, 19 };
  const Vector3 size = Room.Size();
  const Vector3 spacing{ size.X / 22.0, size.Y / 16.0, size.Z / 18.0 };
  std::vector<unsigned char> marks(23 * 17 * 19, 7);
  ASSERT_TRUE(hierarchy.MarkGrid(Room.Min, spacing, dimensions, {}, marks.data()));
  int marked = 0;
  int different = 0;
  for (int k = 0; k < 19; ++k)
  {
    for (int j = 0; j < 17; ++j)
    {
      for (int i = 0; i < 23; ++i)
      {
        const Vector3 point = Room.Min + Vector3{ spacing.X * i, spacing.Y * j, spacing.Z * k };
        const int mark = marks[i + 23 * (j + 17 * k)];
        ASSERT_LE(mark, 1);
        marked += mark;
        different += (mark != 0) != hierarchy.Contains(point);
      }
    }
  }
  EXPECT_GT(marked, 100);
  EXPECT_LT(marked, 23 * 17 * 19 - 100);
  EXPECT_LE(different, 2); // vertices on the room's faces, where round-off decides
}

TEST(ConeHierarchy, OfNothingIsEmpty)
{
  const ConeHierarchy hierarchy({}, Room);
  std::vector<OccluderInterval> intervals(2);
  hierarchy.Intersect({}, { 0.0, 0.0, 1.0 }, 0.0, 9.0, intervals);
  EXPECT_TRUE(intervals.empty());
  EXPECT_FALSE(hierarchy.Contains({}));
}

TEST(ConeGenerators, LieOnTheConeAndPointOutward)
{
  RandomStream random(51, 0);
  std::vector<ConeGenerator> generators;
  for (int i = 0; i < 200; ++i)
  {
    const Cone cone = RandomCone(random, i);
    ConeCut cut;
    cut.Length = 0.8;
    ConeGenerators(cone, cone.HalfAngle, 17, cut, generators);
    ASSERT_EQ(generators.size(), 17u);
    for (const ConeGenerator& g : generators)
    {
      EXPECT_NEAR(Depth(cone, HUGE_VAL, g.Base), 0.0, 1e-9);
      const double h = Dot(g.End - cone.Center, cone.Axis);
      const double tip = cone.HalfAngle < 0.0 ? cone.BaseRadius / std::tan(-cone.HalfAngle) : HUGE_VAL;
      EXPECT_NEAR(h, std::min(0.8, tip), 1e-9);
      const double lateral = Length(Cross(g.End - cone.Center, cone.Axis));
      EXPECT_NEAR(lateral, cone.BaseRadius + h * std::tan(cone.HalfAngle), 1e-9 * (1.0 + lateral));
      EXPECT_NEAR(Length(g.Normal), 1.0, 1e-12);
      EXPECT_NEAR(Dot(g.Normal, g.End - g.Base), 0.0, 1e-9 * (1.0 + lateral));
      EXPECT_GE(Dot(g.Normal, g.Base - cone.Center), -1e-12);
    }
  }
}

TEST(ConeGenerators, EndAtAPlaneOrABox)
{
  Cone cone;
  cone.Center = { 0.1, 0.2, 0.3 };
  cone.Axis = Normalized({ 0.1, 0.2, -1.0 });
  cone.BaseRadius = 0.2;
  cone.HalfAngle = 0.2;
  std::vector<ConeGenerator> generators;
  ConeCut cut;
  cut.Length = 100.0;
  cut.Where = ConeCut::Kind::Plane;
  cut.PlaneOrigin = { 7.0, 8.0, -1.0 };
  for (const double side : { 1.0, -1.0 })
  {
    cut.PlaneNormal = { 0.0, 0.0, side };
    ConeGenerators(cone, cone.HalfAngle, 12, cut, generators);
    for (const ConeGenerator& g : generators)
    {
      EXPECT_NEAR(g.End.Z, -1.0, 1e-12);
      EXPECT_LT(g.End.Z, g.Base.Z);
    }
  }
  // A plane behind the base is not met: the length ends it.
  cut.PlaneOrigin = { 0.0, 0.0, 5.0 };
  cut.Length = 2.0;
  ConeGenerators(cone, cone.HalfAngle, 12, cut, generators);
  EXPECT_NEAR(Dot(generators[0].End - cone.Center, cone.Axis), 2.0, 1e-12);

  cut.Where = ConeCut::Kind::Box;
  cut.Length = 100.0;
  cut.Bounds = { { -1.0, -1.0, -1.5 }, { 1.0, 1.0, 1.0 } };
  ConeGenerators(cone, cone.HalfAngle, 12, cut, generators);
  for (const ConeGenerator& g : generators)
  {
    const double faces[] = { std::abs(g.End.X) - 1.0, std::abs(g.End.Y) - 1.0, std::abs(g.End.Z + 0.25) - 1.25 };
    EXPECT_NEAR(*std::max_element(faces, faces + 3), 0.0, 1e-12); // on a face, outside of none
  }
  cut.Bounds = { { 5.0, 5.0, 5.0 }, { 6.0, 6.0, 6.0 } };
  ConeGenerators(cone, cone.HalfAngle, 12, cut, generators);
  for (const ConeGenerator& g : generators)
  {
    EXPECT_EQ(Length(g.End - g.Base), 0.0);
  }
}

TEST(ConeGenerators, ConvergingConesEndAtTheirTip)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.BaseRadius = 0.5;
  std::vector<ConeGenerator> generators;
  ConeCut cut;
  cut.Length = 10.0;
  ConeGenerators(cone, -Pi / 4.0, 8, cut, generators);
  for (const ConeGenerator& g : generators)
  {
    EXPECT_LT(Length(g.End - Vector3{ 0.0, 0.0, 0.5 }), 1e-9);
  }
}
