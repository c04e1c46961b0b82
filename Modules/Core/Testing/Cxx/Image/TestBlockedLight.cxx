// SPDX-License-Identifier: BSD-3-Clause
#include "scBlockedLight.h"
#include "scEndDensity.h"
#include "scRandom.h"
#include "scSampleColumns.h"

#include "LitScene.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// The sun shines down on a ray from x = 0 to 4; a plate hides it between 1 and 2. Nearly nothing is absorbed.
struct SunnyRay
{
  LitScene Scene{ SunLight({ 0.0, -1.0, 0.0 }, 0.0), 1e-6 };
  TestMesh Plate;
  LitPixel Pixel = Scene.PixelOf(8, 8, 17);
  LitSums Sums{ Scene.Groups };
  ScatteringOptions Options;

  SunnyRay()
  {
    this->Plate.AddSheet({ 1.0, 2.0, -3.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 6.0 }, 0);
    this->Sums.Add(this->Pixel, 5.0);
    this->Sums.Accumulate();
  }
  struct Result
  {
    double Fraction; ///< of the light that is blocked
    double Error; ///< of it, as claimed
    int Samples;
    vtkIdType Rays;
  };
  Result Estimate(const std::vector<RayInterval>& intervals, std::uint64_t seed = 1) const
  {
    const OccluderScene occluders(this->Plate.View());
    const ScatteringScene scene{ occluders, this->Scene.Source, this->Scene.Fog, this->Scene.Eye };
    const RenderContext context(scene, this->Options);
    BlockedLight blocked(context);
    blocked.Look(this->Sums, intervals, {}, seed);
    blocked.Estimate(this->Options.MaximumSamples);
    const double lit = this->Sums.Groups()[0];
    const double mean = this->Sums.Mean();
    return { 1.0 - blocked.Left()[0] / lit, std::sqrt(blocked.Variance()) / mean, blocked.NumberOfSamples(),
      blocked.NumberOfOcclusionRays() };
  }
};
} // namespace

TEST(BlockedLight, APlateTakesItsShare)
{
  SunnyRay sunny;
  for (const double goal : { 0.05, 0.01, 0.002 })
  {
    sunny.Options.RelativeErrorGoal = goal;
    sunny.Options.MaximumSamples = 1 << 16;
    for (std::uint64_t seed = 1; seed < 6; ++seed)
    {
      const auto result = sunny.Estimate({ { 1.0, 5.0 } }, seed);
      EXPECT_NEAR(result.Fraction, 0.25, 3.0 * result.Error);
      EXPECT_LE(result.Error, goal * 0.751);
      EXPECT_EQ(result.Rays, result.Samples);
    }
  }
}

TEST(BlockedLight, NarrowIntervalsCostLess)
{
  SunnyRay sunny;
  const auto whole = sunny.Estimate({ { 1.0, 5.0 } });
  const auto around = sunny.Estimate({ { 1.9, 2.2 }, { 2.3, 3.1 } });
  // From 2.2 to 2.3 nobody looks.
  EXPECT_NEAR(around.Fraction, 0.25 * 0.9, 3.0 * around.Error);
  EXPECT_LT(around.Samples, whole.Samples);
}

TEST(BlockedLight, WithoutIntervalsNothingIsAsked)
{
  const SunnyRay sunny;
  for (const std::vector<RayInterval>& intervals : { std::vector<RayInterval>{}, { { 6.0, 9.0 } } })
  {
    const auto result = sunny.Estimate(intervals);
    EXPECT_EQ(result.Fraction, 0.0);
    EXPECT_EQ(result.Samples, 0);
    EXPECT_EQ(result.Rays, 0);
    EXPECT_EQ(result.Error, 0.0);
  }
}

TEST(BlockedLight, AllOrNothing)
{
  const SunnyRay sunny;
  EXPECT_EQ(sunny.Estimate({ { 3.1, 4.9 } }).Fraction, 0.0);
  EXPECT_NEAR(sunny.Estimate({ { 2.1, 2.6 } }).Fraction, 0.5 / 4.0, 1e-4);
}

TEST(BlockedLight, StopsAtTheMaximumAndDependsOnTheSeedAlone)
{
  SunnyRay sunny;
  sunny.Options.RelativeErrorGoal = 0.0;
  sunny.Options.MaximumSamples = 77;
  const auto first = sunny.Estimate({ { 1.0, 5.0 } }, 3);
  EXPECT_EQ(first.Samples, 77);
  EXPECT_EQ(sunny.Estimate({ { 1.0, 5.0 } }, 3).Fraction, first.Fraction);
  EXPECT_NE(sunny.Estimate({ { 1.0, 5.0 } }, 4).Fraction, first.Fraction);
}

TEST(LitSums, CellsAndDistancesAreInverse)
{
  const LitScene scene(PointLight({ 1.0, 1.6, 0.2 }));
  const LitPixel pixel = scene.PixelOf(8, 8, 17);
  LitSums sums(scene.Groups);
  sums.Add(pixel, 4.0);
  sums.Accumulate();
  for (const double t : { 1.0, 1.3, 2.71, 3.999, 4.9 })
  {
    EXPECT_NEAR(sums.DistanceOf(sums.CellAt(t)), t, 1e-5);
  }
  EXPECT_NEAR(sums.DistanceOf(sums.CellAt(sums.End())), 4.0, 1e-5);
  EXPECT_EQ(sums.SumUpTo(sums.CellAt(0.5)), 0.0);
  EXPECT_LT(sums.SumUpTo(sums.CellAt(sums.End())), sums.SumUpTo(sums.CellAt(5.0)));
  // The mean over wavelengths is the group's value times its mean source.
  sums.Add(pixel, 5.0);
  EXPECT_NEAR(sums.SumUpTo(sums.CellAt(sums.End())) / sums.Mean(), 1.0, 1e-6);
  EXPECT_NEAR(sums.Mean() / (sums.Groups()[0] * scene.Groups.MeanScatteredRadiance[0]), 1.0, 1e-6);
}

TEST(LitSums, PartsOfARayAreThoseOfAPointLight)
{
  // Nothing is absorbed: the light scattered between two places is the angle between them as seen from the light.
  const LitScene scene(PointLight({ 1.0, 1.6, 0.2 }), 1e-9);
  const LitPixel pixel = scene.PixelOf(8, 8, 17);
  const double distance = std::hypot(1.6, 0.2);
  const auto angle = [&](double t) { return std::atan((t - 2.0) / distance); };
  LitSums sums(scene.Groups);
  sums.Add(pixel, 5.0);
  const double perAngle = sums.Groups()[0] / (angle(5.0) - angle(1.0));
  for (const double end : { 1.001, 1.7, 2.4, 3.3, 4.99, 5.0 })
  {
    sums.Add(pixel, end);
    EXPECT_NEAR(sums.Groups()[0] / perAngle, angle(end) - angle(1.0), 2e-6) << end;
    std::vector<double> part(1, 0.0);
    sums.AddBetween(1.3, 2.9, part);
    const double expected = end > 1.3 ? angle(std::min(end, 2.9)) - angle(1.3) : 0.0;
    EXPECT_NEAR(part[0] / perAngle, expected, 3e-6) << end;
    part[0] = 0.0;
    sums.AddBetween(0.0, end, part);
    EXPECT_EQ(part[0], sums.Groups()[0]) << end;
  }
}

TEST(BlockedLight, NothingIsLeftWhereAllIsBlockedAndAllWhereNoneIs)
{
  // Exactly, from any number of samples: the same unshadowed light stands on both sides.
  for (const double begin : { 1.0, 1.3 })
  {
    for (const int samples : { 1, 7, 100 })
    {
      SunnyRay sunny;
      sunny.Plate = TestMesh();
      sunny.Plate.AddSheet({ -0.5, 2.0, -3.0 }, { 5.0, 0.0, 0.0 }, { 0.0, 0.0, 6.0 }, 0);
      const OccluderScene plate(sunny.Plate.View());
      const OccluderScene nothing{ TriangleMeshView() };
      sunny.Options.RelativeErrorGoal = 0.0;
      sunny.Options.MaximumSamples = samples;
      const std::vector<RayInterval> intervals{ { begin, 2.25 }, { 2.25, 5.0 } };
      for (const OccluderScene* occluders : { &plate, &nothing })
      {
        const ScatteringScene scene{ *occluders, sunny.Scene.Source, sunny.Scene.Fog, sunny.Scene.Eye };
        const RenderContext context(scene, sunny.Options);
        BlockedLight light(context);
        light.Look(sunny.Sums, intervals, {}, 5);
        light.Estimate(samples);
        const double lit = sunny.Sums.Groups()[0];
        if (occluders == &nothing)
        {
          EXPECT_EQ(light.Left()[0], lit);
          continue;
        }
        EXPECT_NEAR(light.Left()[0] / lit, 0.25 * (begin - 1.0), 1e-6);
        if (begin == 1.0)
        {
          EXPECT_LE(std::fabs(light.Left()[0]), 1e-15 * lit);
        }
      }
    }
  }
}

TEST(BlockedLight, NearlySpentSamplesSpoilNothing)
{
  // Whatever the last pass may still take, an error is not above that of two thirds of all samples at a shadow's edges.
  SunnyRay sunny;
  sunny.Options.RelativeErrorGoal = 1e-5;
  for (int most = 40; most < 400; most += 7)
  {
    sunny.Options.MaximumSamples = most;
    const auto result = sunny.Estimate({ { 1.0, 5.0 } }, static_cast<std::uint64_t>(most));
    EXPECT_EQ(result.Samples, most);
    EXPECT_NEAR(result.Fraction, 0.25, 3.0 / most);
    EXPECT_LT(result.Error, 3.0 / most);
  }
}

TEST(BlockedLight, DenserEndsChangeNoMean)
{
  SunnyRay sunny;
  sunny.Options.RelativeErrorGoal = 0.0;
  sunny.Options.MaximumSamples = 32;
  for (const double share : { 0.25, 0.75 })
  {
    sunny.Options.ShareNearEnds = share;
    double sum = 0.0;
    double squares = 0.0;
    constexpr int seeds = 400;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
      const double fraction = sunny.Estimate({ { 1.6, 3.9 } }, seed).Fraction;
      sum += fraction;
      squares += fraction * fraction;
    }
    const double mean = sum / seeds;
    const double error = std::sqrt((squares / seeds - mean * mean) / seeds);
    EXPECT_NEAR(mean, 0.25, 3.0 * error);
    EXPECT_LT(error, 3e-3);
  }
}

namespace
{
/// Of n samples of a room of place along the ray and light point, how many see light, and what is said of that number.
struct CountOfSamples
{
  double Visible = 0.0;
  SampleColumns::Error Error;

  template <class IsVisible>
  CountOfSamples(int n, std::uint64_t seed, IsVisible&& isVisible)
  {
    RandomStream random(seed, 0);
    SampleColumns columns;
    columns.Begin(n);
    for (int k = 0; k < n; ++k)
    {
      const auto uv = SobolPoint(seed, static_cast<std::uint32_t>(k));
      const double visible = isVisible((k + random.Next()) / n, uv[0], uv[1]) ? 1.0 : 0.0;
      columns.Add(1.0, visible, static_cast<std::uint32_t>(0x1p32 * uv[0]), static_cast<std::uint32_t>(0x1p32 * uv[1]));
      this->Visible += visible;
    }
    this->Error = SampleColumns::ErrorOf(columns.Sums(), n, this->Visible / n, 1.0);
  }
};
} // namespace

TEST(SampleColumns, NoiseHasTheVarianceOfIndependentSamples)
{
  constexpr int n = 512;
  double variance = 0.0;
  double roughness = 0.0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    RandomStream coin(seed, 7);
    const CountOfSamples count(n, seed, [&](double, double, double) { return coin.Next() < 0.3; });
    variance += count.Error.Variance / 50.0;
    roughness += count.Error.Roughness / 50.0;
  }
  EXPECT_NEAR(variance / (n * 0.3 * 0.7), 1.0, 0.08);
  EXPECT_GT(roughness, 0.85);
}

TEST(SampleColumns, LoneEdgesOfAPointOfLightHaveASixthEach)
{
  // An edge anywhere in a part: x (1 - x) on average. Half the square of the step, one for each edge, is three times that.
  constexpr int n = 1000;
  constexpr int edges = 40;
  double variance = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    RandomStream random(seed, 7);
    const double shift = random.Next();
    const CountOfSamples count(
      n, seed, [&](double t, double, double) { return static_cast<int>(edges * t + shift) % 2 == 0; });
    EXPECT_LT(count.Error.Roughness, 0.1);
    variance += count.Error.Variance / 20.0;
  }
  EXPECT_GT(variance, 1.0 * edges / 6.0);
  EXPECT_LT(variance, 1.5 * edges / 6.0);
}

TEST(SampleColumns, PenumbraFallsFasterThanIndependentSamples)
{
  // The shadow of a straight edge under a large lamp: what is said is more than what many of such numbers scatter by, and not by much.
  for (const int n : { 64, 512, 4096 })
  {
    double sum = 0.0;
    double squares = 0.0;
    double variance = 0.0;
    constexpr int seeds = 200;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
      const CountOfSamples count(
        n, seed, [](double t, double u, double v) { return t + 0.5 * u + 0.31 * v < 0.83; });
      sum += count.Visible / seeds;
      squares += count.Visible * count.Visible / seeds;
      variance += count.Error.Variance / seeds;
    }
    const double scatter = squares - sum * sum;
    EXPECT_GT(variance, scatter) << n;
    EXPECT_LT(variance, 4.0 * scatter) << n;
  }
}

TEST(EndDensity, PlacesFollowTheDensity)
{
  for (const double share : { 0.0, 1e-9, 0.3, 0.95 })
  {
    const EndDensity ends(share);
    double part = 0.0;
    constexpr int steps = 1000;
    for (int k = 0; k < steps; ++k)
    {
      // Simpson's rule is exact for a parabola.
      const double from = static_cast<double>(k) / steps;
      part += (ends.Density(from) + 4.0 * ends.Density(from + 0.5 / steps) + ends.Density(from + 1.0 / steps)) / (6.0 * steps);
      EXPECT_NEAR(ends.Place(part), from + 1.0 / steps, 1e-9);
    }
    EXPECT_EQ(ends.Place(0.5), 0.5);
    EXPECT_NEAR(part, 1.0, 1e-12);
  }
}
