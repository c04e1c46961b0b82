// SPDX-License-Identifier: BSD-3-Clause
// The covering of section 3.2.1 against a plain one: which vectors get a cone, which are discarded, and options.
#include "ConeSetTesting.h"
#include "scCone.h"
#include "scConeSet.h"
#include "scConstants.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace conesettesting;

namespace
{

/// A random square patch at z = 0, some of it twice as dense, lit from above with a spread of directions.
Vectors RandomPatch(int count)
{
  Vectors vectors;
  RandomStream random(11, 0);
  for (int i = 0; i < count; ++i)
  {
    const double side = i % 3 ? 1.0 : 0.4;
    const Vector3 p{ side * (2.0 * random.Next() - 1.0), side * (2.0 * random.Next() - 1.0), 0.0 };
    vectors.Add(p, { 0.2 + 0.2 * random.Next(), 0.2 * random.Next(), -1.0 }, p.X > 0.1 ? 2 : 1);
  }
  return vectors;
}

/// The covering in its plainest form, for vectors in the plane z = 0 lit from above.
ConeSet PlainCovering(const Vectors& vectors, const ConeSetOptions& options)
{
  const vtkIdType count = vectors.Count();
  std::vector<bool> alive(count, true);
  std::vector<bool> covered(count, false);
  ConeSet set;
  set.ConeIds.assign(count, -1);
  const Frame frame = FrameAround({ 0.0, 0.0, -1.0 });
  for (vtkIdType seed = 0; seed < count; ++seed)
  {
    if (covered[seed])
    {
      continue;
    }
    std::vector<std::pair<double, vtkIdType>> living;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (alive[i])
      {
        living.emplace_back(Length(vectors.Point(i) - vectors.Point(seed)), i);
      }
    }
    std::sort(living.begin(), living.end());
    living.resize(std::min<std::size_t>(living.size(), options.NumberOfNeighbors));
    std::size_t accepted = 1; // the seed
    while (accepted + options.PointsPerRing <= living.size())
    {
      std::vector<int> sectors(options.NumberOfSectors, 0);
      for (int i = 0; i < options.PointsPerRing; ++i)
      {
        const Vector3 offset = vectors.Point(living[accepted + i].second) - vectors.Point(seed);
        const double angle = std::atan2(Dot(offset, frame.V), Dot(offset, frame.U));
        ++sectors[std::min(
          options.NumberOfSectors - 1, static_cast<int>((angle / (2.0 * Pi) + 0.5) * options.NumberOfSectors))];
      }
      const double mean = static_cast<double>(options.PointsPerRing) / options.NumberOfSectors;
      double squares = 0.0;
      for (const int c : sectors)
      {
        squares += (c - mean) * (c - mean);
      }
      if (squares / options.NumberOfSectors / mean > options.VarianceThreshold)
      {
        break;
      }
      accepted += options.PointsPerRing;
    }
    if (accepted == 1 || static_cast<int>(accepted) < options.MinimumVectorsPerCone)
    {
      continue;
    }
    Cone cone;
    cone.Center = vectors.Point(seed);
    cone.BaseRadius = living[accepted - 1].first;
    cone.VectorCount = static_cast<int>(accepted);
    Vector3 sum;
    int ones = 0;
    for (std::size_t i = 0; i < accepted; ++i)
    {
      sum += vectors.Direction(living[i].second);
      ones += vectors.OccluderIds[living[i].second] == 1;
    }
    cone.Axis = Normalized(sum);
    cone.OccluderId = 2 * ones >= static_cast<int>(accepted) ? 1 : 2;
    for (std::size_t i = 0; i < accepted; ++i)
    {
      const vtkIdType id = living[i].second;
      cone.HalfAngle = std::max(cone.HalfAngle, std::acos(std::min(1.0, Dot(vectors.Direction(id), cone.Axis))));
      covered[id] = true;
      alive[id] = options.Overlap;
      if (set.ConeIds[id] < 0)
      {
        set.ConeIds[id] = static_cast<vtkIdType>(set.Cones.size());
      }
    }
    set.Cones.push_back(cone);
  }
  set.NumberOfDiscarded = std::count(set.ConeIds.begin(), set.ConeIds.end(), -1);
  return set;
}

} // namespace

TEST(ConeSetCovering, IsThatOfAPlainLoop)
{
  const Vectors vectors = RandomPatch(3000);
  for (const bool overlap : { false, true })
  {
    for (const ConeSetOptions& base : { Options(100, 20, 16, 20), Options(60, 8, 6, 7), Options(33, 20, 16, 33) })
    {
      ConeSetOptions options = base;
      options.Overlap = overlap;
      options.CosineCorrection = false;
      const ConeSet truth = PlainCovering(vectors, options);
      const ConeSet found = Fit(vectors, options);
      ASSERT_GT(truth.Cones.size(), 5u);
      ASSERT_EQ(found.Cones.size(), truth.Cones.size());
      EXPECT_EQ(found.ConeIds, truth.ConeIds);
      EXPECT_EQ(found.NumberOfDiscarded, truth.NumberOfDiscarded);
      EXPECT_TRUE(overlap || truth.NumberOfDiscarded > 0);
      for (std::size_t i = 0; i < truth.Cones.size(); ++i)
      {
        const Cone& a = found.Cones[i];
        const Cone& b = truth.Cones[i];
        EXPECT_EQ(Length(a.Center - b.Center), 0.0);
        EXPECT_EQ(a.VectorCount, b.VectorCount);
        EXPECT_EQ(a.OccluderId, b.OccluderId);
        EXPECT_NEAR(a.BaseRadius, b.BaseRadius, 1e-12);
        EXPECT_LT(Length(a.Axis - b.Axis), 1e-12);
        EXPECT_NEAR(a.HalfAngle, b.HalfAngle, 1e-6);
        EXPECT_LT(Length(a.Normal - Vector3{ 0.0, 0.0, -1.0 }), 1e-9);
        EXPECT_NEAR(a.Planarity, 0.0, 1e-9);
        EXPECT_EQ(a.Overspill, -1.0);
      }
    }
  }
}

TEST(ConeSetCovering, WithoutOverlapEveryVectorIsInOneConeAtMost)
{
  const Vectors vectors = RandomPatch(3000);
  ConeSetOptions options = Options(100, 20, 16, 20);
  const ConeSet apart = Fit(vectors, options);
  int sum = 0;
  for (const Cone& cone : apart.Cones)
  {
    sum += cone.VectorCount;
  }
  EXPECT_EQ(sum + apart.NumberOfDiscarded, vectors.Count());

  options.Overlap = true;
  const ConeSet overlapping = Fit(vectors, options);
  sum = 0;
  for (const Cone& cone : overlapping.Cones)
  {
    sum += cone.VectorCount;
  }
  EXPECT_GT(sum + overlapping.NumberOfDiscarded, vectors.Count());
  EXPECT_LT(overlapping.NumberOfDiscarded, apart.NumberOfDiscarded);
}

TEST(ConeSetDiscards, FewVectorsMakeNoCone)
{
  Vectors vectors = Sunflower(97, 1.0);
  for (int i = 0; i < 10; ++i) // a cluster far away, smaller than p4
  {
    vectors.Add({ 50.0 + 0.1 * i, 0.01 * (i % 3), 0.0 }, { 0.0, 0.0, -1.0 });
  }
  const ConeSet set = Fit(vectors, Options(97, 8, 16, 20));
  ASSERT_EQ(set.Cones.size(), 1u);
  EXPECT_EQ(set.NumberOfDiscarded, 10);
  for (vtkIdType i = 0; i < vectors.Count(); ++i)
  {
    EXPECT_EQ(set.ConeIds[i], i < 97 ? 0 : -1);
  }
  EXPECT_TRUE(Fit(vectors, Options(10, 8, 16, 5)).Cones.empty()); // not even one ring among ten neighbours
}

TEST(ConeSetDiscards, NoVectorsGiveNoCones)
{
  const ConeSet set = Fit({}, ConeSetOptions());
  EXPECT_TRUE(set.Cones.empty());
  EXPECT_TRUE(set.ConeIds.empty());
  EXPECT_EQ(set.NumberOfDiscarded, 0);
}

TEST(ConeSetDiscards, CoincidentAndCollinearVectorsAreHarmless)
{
  Vectors vectors;
  for (int i = 0; i < 200; ++i)
  {
    vectors.Add({ 1.0, 2.0, 3.0 }, { 0.0, 0.0, -1.0 });
  }
  for (int i = 0; i < 200; ++i)
  {
    vectors.Add({ 5.0 + 0.01 * i, 2.0, 3.0 }, { 0.0, 0.0, -1.0 });
  }
  for (int i = 0; i < 200; ++i) // directions without a mean
  {
    vectors.Add({ 9.0 + 0.1 * (i % 15), 0.1 * (i / 15), 3.0 }, { 0.0, 0.0, i % 2 ? 1.0 : -1.0 });
  }
  const ConeSet set = Fit(vectors, ConeSetOptions());
  for (const Cone& cone : set.Cones)
  {
    EXPECT_TRUE(IsFinite(cone.Center) && IsFinite(cone.Axis) && std::isfinite(cone.BaseRadius + cone.HalfAngle));
  }
  for (vtkIdType i = 0; i < 400; ++i)
  {
    EXPECT_EQ(set.ConeIds[i], -1); // neither a point nor a line covers the sectors
  }
}

TEST(ConeSetLeftovers, EveryVectorOfACableGetsACone)
{
  // Along a line the sectors are never even: the paper discards all of it.
  Vectors cable;
  for (int i = 0; i < 100; ++i)
  {
    cable.Add({ 0.1 * i, 0.0, 0.0 }, { 0.0, 0.0, -1.0 });
  }
  cable.Add({ 5.0, 400.0, 0.0 }, { 0.0, 0.0, -1.0 });
  cable.Add({ 5.0, 0.05, 0.0 }, { 0.0, 0.0, -1.0 }, 7);
  ConeSetOptions options = Options(20, 20, 8, 10);
  EXPECT_EQ(Fit(cable, options).NumberOfDiscarded, cable.Count());
  options.Leftovers = ConeLeftovers::Cover;
  const ConeSet set = Fit(cable, options);
  EXPECT_EQ(set.NumberOfDiscarded, 0);
  ASSERT_GE(set.Cones.size(), 12u);
  EXPECT_LE(set.Cones.size(), 24u);
  for (vtkIdType i = 0; i < cable.Count(); ++i)
  {
    ASSERT_GE(set.ConeIds[i], 0) << i;
    const Cone& cone = set.Cones[set.ConeIds[i]];
    const Vector3 offset = cable.Point(i) - cone.Center;
    EXPECT_GE(offset.Z, -1e-12 - 1e-7) << i;
    EXPECT_LE(std::hypot(offset.X, offset.Y), cone.BaseRadius + 1e-9) << i;
    // Ten neighbours on a line reach half a unit to a side, or 0.9 at an end; none reaches across the gap of 400.
    EXPECT_LE(cone.BaseRadius, 0.91) << i;
  }
  EXPECT_EQ(set.Cones[set.ConeIds[100]].BaseRadius, 0.0);
  EXPECT_EQ(set.Cones[set.ConeIds[101]].OccluderId, 7);
}

TEST(ConeSetMonitor, AbortStopsAndProgressGrowsToOne)
{
  const Vectors vectors = RandomPatch(20000);
  std::vector<double> seen;
  Monitor monitor;
  monitor.Progress = [&](double share) { seen.push_back(share); };
  ConeSet set;
  ASSERT_TRUE(FitConeSet(vectors.View(), {}, LightExtent(), ConeSetOptions(), monitor, set));
  EXPECT_GT(seen.size(), 5u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
  seen.clear();
  monitor.Aborted = [&] { return seen.size() >= 2; };
  EXPECT_FALSE(FitConeSet(vectors.View(), {}, LightExtent(), ConeSetOptions(), monitor, set));
  EXPECT_EQ(seen.size(), 2u);
}

TEST(ConeSetOptions, AreCheckedOneByOne)
{
  EXPECT_EQ(CheckConeSetOptions({}), nullptr);
  const auto fault = [](auto change)
  {
    ConeSetOptions options;
    change(options);
    const char* text = CheckConeSetOptions(options);
    return std::string(text ? text : "");
  };
  const double nan = std::nan("");
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 2; }).find("NumberOfNeighbors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfSectors = 0; }).find("NumberOfSectors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 0; }).find("PointsPerRing"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.MinimumVectorsPerCone = 0; }).find("MinimumVectorsPerCone"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 19; }).find("p1"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfNeighbors = 536870912; }).find("3..1000000"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.NumberOfSectors = 2147483647; }).find("1..65536"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.RadiusScale = HUGE_VAL; }).find("finite"), std::string::npos);
  // A ring of 99 fits beside the seed among 100 neighbours, one of 100 does not.
  EXPECT_EQ(fault([](auto& o) { o.PointsPerRing = 99; }), "");
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 100; }).find("must be below NumberOfNeighbors"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PointsPerRing = 2147483647; }).find("must be below"), std::string::npos);
  // One ring of 60 and the seed are 61 vectors; a second ring does not fit.
  const auto sixty = [&](int least)
  { return fault([least](auto& o) { o.PointsPerRing = 60, o.MinimumVectorsPerCone = least; }); };
  EXPECT_EQ(sixty(61), "");
  EXPECT_NE(sixty(62).find("no cone could ever hold enough vectors"), std::string::npos);
  EXPECT_NE(fault([=](auto& o) { o.VarianceThreshold = nan; }).find("VarianceThreshold"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.PlanarityThreshold = -0.1; }).find("PlanarityThreshold"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.ExpansionFraction = 1.1; }).find("ExpansionFraction"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.Leftovers = static_cast<ConeLeftovers>(2); }).find("Leftovers"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.Expansion = static_cast<ConeExpansion>(3); }).find("Expansion"), std::string::npos);
}
