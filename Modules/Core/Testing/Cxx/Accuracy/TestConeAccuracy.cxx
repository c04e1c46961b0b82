// SPDX-License-Identifier: BSD-3-Clause
// Accuracy: intervals that hold what they promise, truth that is known in closed form, and counts that add up.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scAccuracyTally.h"
#include "scClassifyByCones.h"
#include "scCone.h"
#include "scConeAccuracy.h"
#include "scConeTally.h"
#include "scEstimate.h"
#include "scLightExtent.h"
#include "scRandom.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{

TestMesh DiscMesh(const Vector3& center, double radius, int sides, int occluder = 0)
{
  TestMesh mesh;
  mesh.AddDisc(center, radius, sides, occluder);
  return mesh;
}

/// The one cone that bounds the shadow of a disc below a coaxial disc light.
Cone ConeBelow(const Light& light, const Vector3& center, double radius)
{
  Cone cone;
  cone.Center = center;
  cone.Axis = { 0.0, 0.0, -1.0 };
  cone.Normal = cone.Axis;
  cone.BaseRadius = radius;
  cone.OccluderId = 0;
  PenumbraAngles(LightExtentOf(light), center, cone.Axis, radius, cone.HalfAngle, cone.InnerHalfAngle);
  return cone;
}

std::vector<Vector3> Draw(const Box& box, vtkIdType count, std::uint64_t seed = 1)
{
  std::vector<Vector3> points;
  EXPECT_TRUE(DrawSamplePoints(box, count, seed, {}, points));
  return points;
}

std::vector<Cone> RandomCones(int count)
{
  std::vector<Cone> cones;
  RandomStream random(3, 0);
  for (int i = 0; i < count; ++i)
  {
    Cone cone;
    cone.Center = { 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0 };
    cone.Axis = Normalized({ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 });
    cone.BaseRadius = 0.05 + 0.4 * random.Next();
    cone.HalfAngle = 0.6 * random.Next() - 0.2;
    cone.InnerHalfAngle = cone.HalfAngle - 0.3 * random.Next();
    cone.OccluderId = i % 5;
    cones.push_back(cone);
  }
  return cones;
}

} // namespace

TEST(ConeAccuracy, ProportionsHaveWilsonsInterval)
{
  // Known values: 8 of 10 and 0 of 10.
  const Estimate most = EstimateProportion(8, 10);
  EXPECT_DOUBLE_EQ(most.Value, 0.8);
  EXPECT_NEAR(most.Low, 0.4902, 5e-5);
  EXPECT_NEAR(most.High, 0.9433, 5e-5);
  const Estimate none = EstimateProportion(0, 10);
  EXPECT_EQ(none.Value, 0.0);
  EXPECT_EQ(none.Low, 0.0);
  EXPECT_NEAR(none.High, 0.2775, 5e-5);
  const Estimate undefined = EstimateProportion(0, 0);
  EXPECT_TRUE(std::isnan(undefined.Value));
  EXPECT_EQ(undefined.Low, 0.0);
  EXPECT_EQ(undefined.High, 1.0);
}

TEST(ConeAccuracy, ASharesIntervalOfEqualWeightsIsWilsons)
{
  RatioSums sums;
  for (int i = 0; i < 10; ++i)
  {
    sums.Add(i < 8 ? 7 : 0, 7);
  }
  const Estimate share = EstimateFraction(sums);
  const Estimate proportion = EstimateProportion(8, 10);
  EXPECT_DOUBLE_EQ(share.Value, proportion.Value);
  EXPECT_NEAR(share.Low, proportion.Low, 1e-12);
  EXPECT_NEAR(share.High, proportion.High, 1e-12);
}

TEST(ConeAccuracy, IntervalsHoldTheTruth95TimesInAHundred)
{
  // Weights 1..16; the heavier an item, the rarer it is outside: E[y] / E[x] is known.
  double whole = 0.0;
  double part = 0.0;
  for (int w = 1; w <= 16; ++w)
  {
    whole += w;
    part += w * 0.5 / w;
  }
  const double truth = part / whole;
  constexpr int trials = 4000;
  int heldByShare = 0;
  int heldByRatio = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    RandomStream random(11, static_cast<std::uint64_t>(trial));
    RatioSums sums;
    for (int i = 0; i < 400; ++i)
    {
      const int weight = 1 + static_cast<int>(16.0 * random.Next());
      sums.Add(random.Next() < 0.5 / weight ? weight : 0, weight);
    }
    const Estimate share = EstimateFraction(sums);
    const Estimate ratio = EstimateRatio(sums);
    heldByShare += share.Low <= truth && truth <= share.High;
    heldByRatio += ratio.Low <= truth && truth <= ratio.High;
  }
  // Four standard errors of a count of 4,000 trials are 1.4 %.
  EXPECT_NEAR(heldByShare / double(trials), 0.95, 0.02);
  EXPECT_NEAR(heldByRatio / double(trials), 0.95, 0.02);
}

TEST(ConeAccuracy, SamplesFillTheBoxEvenly)
{
  const Box box{ { 1.0, -2.0, 1e6 }, { 3.0, -1.0, 1e6 + 4.0 } };
  const std::vector<Vector3> points = Draw(box, 4096);
  int cells[8][8][8] = {};
  for (const Vector3& p : points)
  {
    ASSERT_TRUE(box.Contains(p));
    const Vector3 u = p - box.Min;
    ++cells[int(u.X / 2.0 * 8.0)][int(u.Y * 8.0)][int(u.Z / 4.0 * 8.0)];
  }
  int most = 0;
  for (const auto& plane : cells)
  {
    for (const auto& row : plane)
    {
      for (const int count : row)
      {
        most = std::max(most, count);
      }
    }
  }
  // Independent points would put about 20 into one of 512 cells.
  EXPECT_LE(most, 16);
  EXPECT_TRUE(Draw(Box(), 10).empty());
}

TEST(ConeAccuracy, TruthOfADiscIsItsClosedForm)
{
  // Light radius 0.5 at height 4, occluder radius 0.25 at height 3: on the axis at depth d below it the shadow covers a
  // disc of radius 0.25 (1 + d) / d ... of the light: visible is 1 - (0.25 (1 + d) / d / 0.5)^2 where that is positive.
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const TestMesh mesh = DiscMesh({ 0.0, 0.0, 3.0 }, 0.25, 512, 4);
  const OccluderScene scene(mesh.View());
  std::vector<Vector3> points;
  for (const double depth : { 0.5, 0.9, 1.5, 3.0 })
  {
    points.push_back({ 0.0, 0.0, 3.0 - depth });
  }
  points.push_back({ 2.0, 0.0, 2.9 });
  points.push_back({ 0.0, 0.0, 5.0 });
  std::vector<SampleTruth> truth;
  ASSERT_TRUE(MeasureTruth(points, scene, light, 4096, 1, {}, truth));
  EXPECT_TRUE(truth[0].Umbra());
  EXPECT_TRUE(truth[1].Umbra());
  for (int k = 2; k < 4; ++k)
  {
    const double depth = 3.0 - points[k].Z;
    const double radius = 0.25 * (1.0 + depth) / depth;
    EXPECT_NEAR(truth[k].Visibility(), 1.0 - radius * radius / 0.25, 0.004) << "depth " << depth;
    EXPECT_EQ(truth[k].OccluderId, 4);
    // Slanted rays are a little longer than the depth.
    EXPECT_GE(truth[k].OccluderDistance, depth);
    EXPECT_LT(truth[k].OccluderDistance, 1.02 * depth);
  }
  EXPECT_EQ(truth[4].Emitting, 4096);
  EXPECT_EQ(truth[4].Blocked, 0);
  EXPECT_EQ(truth[4].OccluderId, -1);
  // Behind the light nothing is emitted, and nothing counts.
  EXPECT_EQ(truth[5].Emitting, 0);
  EXPECT_EQ(truth[5].Visibility(), 1.0);
  AccuracyTally tally;
  tally.Add(truth[5], {});
  EXPECT_EQ(tally.Samples(), 0);
}

TEST(ConeAccuracy, TheOccluderThatBlocksMostIsNamed)
{
  // Two sheets side by side below the light; the second hides three quarters of it.
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 1.0);
  TestMesh mesh;
  mesh.AddSheet({ -3.0, -3.0, 2.0 }, { 2.8, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, 7);
  mesh.AddSheet({ -0.2, -3.0, 2.0 }, { 3.2, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, 9);
  const OccluderScene scene(mesh.View());
  std::vector<SampleTruth> truth;
  ASSERT_TRUE(MeasureTruth({ { 0.0, 0.0, 0.0 }, { -0.6, 0.0, 0.0 } }, scene, light, 256, 1, {}, truth));
  EXPECT_EQ(truth[0].OccluderId, 9);
  EXPECT_EQ(truth[1].OccluderId, 7);
  EXPECT_TRUE(truth[0].Umbra());
}

TEST(ConeAccuracy, TheExactConeOfADiscIsFoundExact)
{
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const Vector3 center{ 0.0, 0.0, 2.0 };
  const TestMesh mesh = DiscMesh(center, 1.0, 256);
  const OccluderScene scene(mesh.View());
  const std::vector<Vector3> points = Draw({ { -4.5, -4.5, 0.0 }, { 4.5, 4.5, 3.0 } }, 16000);
  std::vector<SampleTruth> truth;
  ASSERT_TRUE(MeasureTruth(points, scene, light, 256, 1, {}, truth));

  const auto report = [&](const Cone& cone)
  {
    std::vector<SamplePrediction> predictions;
    std::vector<ConeTally> tallies;
    EXPECT_TRUE(ClassifyByCones(points, truth, { cone }, {}, predictions, tallies));
    EXPECT_EQ(tallies[0].Samples, TallyAccuracy(truth, predictions, { cone }, 4).All.Volume.Y);
    return TallyAccuracy(truth, predictions, { cone }, 4);
  };
  const Cone exact = ConeBelow(light, center, 1.0);
  const AccuracyTally best = report(exact).All;
  EXPECT_EQ(best.FalseNegatives, 0);
  // Samples of which less than 1 / 256 is hidden count as lit.
  EXPECT_GT(best.Precision().Value, 0.97);
  EXPECT_EQ(best.Leak().Value, 0.0);
  EXPECT_GT(best.Leak().High, 0.0);
  EXPECT_GT(best.UmbraRecall().Value, 0.97);
  EXPECT_GT(best.UmbraPrecision().Value, 0.97);
  EXPECT_EQ(best.Samples(), 16000);

  // A cone of the right base and half of its angle leaks; one of twice the angle loses light.
  Cone narrow = exact;
  narrow.HalfAngle *= 0.5;
  const AccuracyTally leaking = report(narrow).All;
  EXPECT_GT(leaking.Precision().Value, 0.999);
  EXPECT_GT(leaking.Leak().Low, 0.0);
  EXPECT_LT(leaking.VolumeError().High, 0.0);
  // Light leaks less than volume: it is the faint border that is cut off.
  EXPECT_LT(leaking.Leak().Value, 1.0 - leaking.Recall().Value);
  Cone wide = exact;
  wide.HalfAngle = std::atan(2.0 * std::tan(exact.HalfAngle));
  const AccuracyTally losing = report(wide).All;
  EXPECT_EQ(losing.FalseNegatives, 0);
  EXPECT_GT(losing.Lost().Low, best.Lost().High);
  EXPECT_GT(losing.VolumeError().Low, 0.2);

  // The volume error is that of the closed form, frusta of the height 2.
  const auto frustum = [](const Cone& cone)
  {
    const double end = 1.0 + 2.0 * std::tan(cone.HalfAngle);
    return 1.0 + end + end * end;
  };
  const Estimate error = losing.VolumeError();
  const double expected = frustum(wide) / frustum(exact) - 1.0;
  EXPECT_NEAR(error.Value, expected, 0.05 * (1.0 + expected));
}

TEST(ConeAccuracy, ClassesAreThoseOfALinearScan)
{
  const std::vector<Cone> cones = RandomCones(60);
  std::vector<Vector3> points = Draw({ { -3.0, -3.0, -3.0 }, { 3.0, 3.0, 3.0 } }, 5000);
  // On the axis of a cone, where its slices meet.
  for (int i = 0; i <= 64; ++i)
  {
    points.push_back(cones[0].Center + (i / 16.0) * cones[0].Axis);
  }
  std::vector<SampleTruth> truth(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    truth[k].Emitting = 10;
    truth[k].Blocked = static_cast<int>(k % 11);
    truth[k].OccluderId = k % 11 > 0 ? 2 : -1;
  }
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  ASSERT_TRUE(ClassifyByCones(points, truth, cones, {}, predictions, tallies));

  std::vector<ConeTally> expected(cones.size());
  int umbra = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    int first = -1;
    int shadow = 0;
    for (std::size_t i = 0; i < cones.size(); ++i)
    {
      if (!ConeContains(cones[i], points[k]))
      {
        continue;
      }
      Cone inner = cones[i];
      inner.HalfAngle = inner.InnerHalfAngle;
      shadow = std::max(shadow, ConeContains(inner, points[k]) ? 2 : 1);
      first = first < 0 ? static_cast<int>(i) : first;
      ++expected[i].Samples;
      expected[i].Shadowed += truth[k].Shadowed();
      expected[i].Lit += truth[k].Lit();
    }
    ASSERT_EQ(predictions[k].ConeId, first) << "point " << k;
    ASSERT_EQ(static_cast<int>(predictions[k].Class), shadow) << "point " << k;
    umbra += shadow == 2;
  }
  EXPECT_GT(umbra, 100);
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    EXPECT_EQ(tallies[i].Samples, expected[i].Samples) << "cone " << i;
    EXPECT_EQ(tallies[i].Shadowed, expected[i].Shadowed) << "cone " << i;
    EXPECT_EQ(tallies[i].Lit, expected[i].Lit) << "cone " << i;
  }
}

TEST(ConeAccuracy, GroupsAddUpToAll)
{
  const std::vector<Cone> cones = RandomCones(40);
  const std::vector<Vector3> points = Draw({ { -3.0, -3.0, -3.0 }, { 3.0, 3.0, 3.0 } }, 4000);
  std::vector<SampleTruth> truth(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    truth[k].Emitting = k % 97 == 0 ? 0 : 16;
    truth[k].Blocked = k % 97 == 0 || k % 3 == 0 ? 0 : static_cast<int>(k % 17);
    truth[k].OccluderId = truth[k].Blocked > 0 ? static_cast<int>(k % 6) : -1;
    truth[k].OccluderDistance = truth[k].Blocked > 0 ? 0.001 * static_cast<double>(k % 500) : 0.0;
  }
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  ASSERT_TRUE(ClassifyByCones(points, truth, cones, {}, predictions, tallies));
  const AccuracyReport report = TallyAccuracy(truth, predictions, cones, 7);

  const auto check = [&](const auto& groups)
  {
    AccuracyTally sum;
    double lost = 0.0;
    for (const auto& group : groups)
    {
      EXPECT_EQ(group.TrueNegatives, 0);
      sum.TruePositives += group.TruePositives;
      sum.FalsePositives += group.FalsePositives;
      sum.FalseNegatives += group.FalseNegatives;
      sum.BlockedOutside.Y += group.BlockedOutside.Y;
      sum.BlockedOutside.X += group.BlockedOutside.X;
      lost += group.AccuracyTally::Lost(report.All).Value;
    }
    EXPECT_EQ(sum.TruePositives, report.All.TruePositives);
    EXPECT_EQ(sum.FalsePositives, report.All.FalsePositives);
    EXPECT_EQ(sum.FalseNegatives, report.All.FalseNegatives);
    EXPECT_EQ(sum.BlockedOutside.Y, report.All.BlockedOutside.Y);
    EXPECT_EQ(sum.BlockedOutside.X, report.All.BlockedOutside.X);
    EXPECT_NEAR(lost, report.All.Lost().Value, 1e-12);
  };
  EXPECT_GT(report.All.FalsePositives, 100);
  EXPECT_GT(report.All.FalseNegatives, 100);
  ASSERT_EQ(report.Depths.size(), 7u);
  ASSERT_EQ(report.Occluders.size(), 6u);
  check(report.Occluders);
  check(report.Depths);
  EXPECT_EQ(report.Depths.front().Low, 0.0);
  EXPECT_EQ(report.Depths[2].High, report.Depths[3].Low);
}

TEST(ConeAccuracy, NoConesAndNoSamplesAreValid)
{
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  std::vector<SampleTruth> truth(1);
  truth[0].Emitting = 4;
  truth[0].Blocked = 1;
  ASSERT_TRUE(ClassifyByCones({ {} }, truth, {}, {}, predictions, tallies));
  EXPECT_EQ(TallyAccuracy(truth, predictions, {}, 3).All.FalseNegatives, 1);
  ASSERT_TRUE(ClassifyByCones({}, {}, RandomCones(2), {}, predictions, tallies));
  EXPECT_EQ(tallies.size(), 2u);
  const AccuracyReport report = TallyAccuracy({}, predictions, {}, 3);
  EXPECT_TRUE(std::isnan(report.All.Recall().Value));
  EXPECT_TRUE(std::isnan(report.All.VolumeError().Value));
  EXPECT_EQ(report.Depths.size(), 3u);
}
