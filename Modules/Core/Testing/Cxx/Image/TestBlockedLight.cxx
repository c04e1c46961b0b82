// SPDX-License-Identifier: BSD-3-Clause
#include "scBlockedLight.h"

#include "LitScene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;

namespace
{
/// The sun shines down on a ray from x = 0 to 4; a plate hides it between 1 and 2. Nearly nothing is absorbed.
struct SunnyRay
{
  LitScene Scene{ smallmeshes::SunLight({ 0.0, -1.0, 0.0 }, 0.0), 1e-6 };
  smallmeshes::Mesh Plate;
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
    double Share; ///< of the light that is blocked
    double Error; ///< of it, as claimed
    int Samples;
    vtkIdType Rays;
  };
  Result Estimate(const std::vector<RayInterval>& stretches, std::uint64_t seed = 1) const
  {
    const OccluderScene occluders(this->Plate.View());
    const ScatteringScene scene{ occluders, this->Scene.Source, this->Scene.Fog, this->Scene.Eye };
    BlockedLight blocked(scene, this->Options, this->Scene.Groups);
    blocked.Estimate(this->Sums, 0.0, stretches, 0.0, seed);
    const double lit = this->Sums.Groups()[0];
    const double mean = this->Sums.Mean();
    return { blocked.Blocked()[0] / lit, std::sqrt(blocked.Variance()) / mean, blocked.NumberOfSamples(),
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
      const auto result = sunny.Estimate({ { 1.0, 5.0, -1 } }, seed);
      EXPECT_NEAR(result.Share, 0.25, 3.0 * result.Error);
      EXPECT_LE(result.Error, goal * 0.751);
      EXPECT_EQ(result.Rays, result.Samples);
    }
  }
}

TEST(BlockedLight, NarrowStretchesCostLess)
{
  SunnyRay sunny;
  const auto whole = sunny.Estimate({ { 1.0, 5.0, -1 } });
  const auto around = sunny.Estimate({ { 1.9, 2.2, -1 }, { 2.3, 3.1, -1 } });
  // From 2.2 to 2.3 nobody looks.
  EXPECT_NEAR(around.Share, 0.25 * 0.9, 3.0 * around.Error);
  EXPECT_LT(around.Samples, whole.Samples);
}

TEST(BlockedLight, WithoutStretchesNothingIsAsked)
{
  const SunnyRay sunny;
  for (const std::vector<RayInterval>& stretches : { std::vector<RayInterval>{}, { { 6.0, 9.0, -1 } } })
  {
    const auto result = sunny.Estimate(stretches);
    EXPECT_EQ(result.Share, 0.0);
    EXPECT_EQ(result.Samples, 0);
    EXPECT_EQ(result.Rays, 0);
    EXPECT_EQ(result.Error, 0.0);
  }
}

TEST(BlockedLight, AllOrNothing)
{
  const SunnyRay sunny;
  EXPECT_EQ(sunny.Estimate({ { 3.1, 4.9, -1 } }).Share, 0.0);
  EXPECT_NEAR(sunny.Estimate({ { 2.1, 2.6, -1 } }).Share, 0.5 / 4.0, 1e-4);
}

TEST(BlockedLight, StopsAtTheMaximumAndDependsOnTheSeedAlone)
{
  SunnyRay sunny;
  sunny.Options.RelativeErrorGoal = 0.0;
  sunny.Options.MaximumSamples = 77;
  const auto first = sunny.Estimate({ { 1.0, 5.0, -1 } }, 3);
  EXPECT_EQ(first.Samples, 77);
  EXPECT_EQ(sunny.Estimate({ { 1.0, 5.0, -1 } }, 3).Share, first.Share);
  EXPECT_NE(sunny.Estimate({ { 1.0, 5.0, -1 } }, 4).Share, first.Share);
}

TEST(LitSums, PlacesAndDistancesAreInverse)
{
  const LitScene scene(smallmeshes::PointLight({ 1.0, 1.6, 0.2 }));
  const LitPixel pixel = scene.PixelOf(8, 8, 17);
  LitSums sums(scene.Groups);
  sums.Add(pixel, 4.0);
  sums.Accumulate();
  for (const double t : { 1.0, 1.3, 2.71, 3.999, 4.9 })
  {
    EXPECT_NEAR(sums.DistanceOf(sums.PlaceOf(t)), t, 1e-5);
  }
  EXPECT_NEAR(sums.DistanceOf(sums.End()), 4.0, 1e-5);
  EXPECT_EQ(sums.SumUpTo(sums.PlaceOf(0.5)), 0.0);
  EXPECT_LT(sums.SumUpTo(sums.End()), sums.SumUpTo(sums.PlaceOf(5.0)));
  // The mean over wavelengths is the group's value times its mean source.
  EXPECT_NEAR(sums.SumUpTo(sums.End()) / sums.Mean(), 1.0, 1e-6);
  EXPECT_NEAR(sums.Mean() / (sums.Groups()[0] * scene.Groups.MeanSource[0]), 1.0, 1e-6);
}
