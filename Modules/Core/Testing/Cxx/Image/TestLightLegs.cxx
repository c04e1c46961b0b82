// SPDX-License-Identifier: BSD-3-Clause
#include "LitScene.h"
#include "SampledDensity.h"
#include "TestLights.h"
#include "scLightLegsChoice.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Sigma = 0.2;

Light LampOf(LightShape shape)
{
  Light light;
  light.Shape = shape;
  light.Center = { 2.0, 0.7, 0.1 }; // in the medium, as all of it is
  light.Normal = Normalized({ 0.1, -1.0, 0.2 });
  light.AxisU = Normalized(Cross(light.Normal, { 1.0, 0.0, 0.0 }));
  light.AxisV = 0.5 * Cross(light.Normal, light.AxisU);
  light.AxisU = 0.4 * light.AxisU;
  light.Radius = 0.3;
  light.Spectrum = { 1.0 };
  return Prepared(light);
}

/// Over the bounds of LitScene.
DensityGrid DensityOf(int points, double (*density)(const Vector3&))
{
  const double n = points - 1;
  return SampleDensity(
    { { points, points, points } }, { 0.0, -1.0, -1.0 }, UnitAxes({ 4.0 / n, 2.0 / n, 2.0 / n }), density);
}

/// Call visit(point, sample) for ways from points all over the medium to points of the light.
template <typename Visitor>
void ForWays(const LitScene& scene, Visitor&& visit)
{
  RandomStream random(5, 0);
  for (int k = 0; k < 400; ++k)
  {
    const Vector3 point{ 4.0 * random.Next(), 2.0 * random.Next() - 1.0, 2.0 * random.Next() - 1.0 };
    const double u = random.Next();
    const IncidentSample sample = SampleIncidentLight(scene.Source, point, u, random.Next(), LightSampling::Area);
    if (sample.Weight > 0.0)
    {
      visit(point, sample);
    }
  }
}
} // namespace

TEST(LightLegs, ALinearDensityIsExact)
{
  // Its mean on a way is that of the ends, which is linear in both of them.
  const auto density = [](const Vector3& p) { return 1.0 + 0.1 * p.X + 0.2 * p.Y - 0.15 * p.Z; };
  const DensityGrid grid = DensityOf(5, density);
  for (const LightShape shape : { LightShape::Disc, LightShape::Rectangle, LightShape::Point })
  {
    LitScene scene(LampOf(shape), Sigma);
    scene.Fog.Density = &grid;
    LightLegs legs(scene.Source, scene.Fog, 1.0);
    ASSERT_TRUE(legs.Fill({}));
    const MediumOpticalDepth depths(scene.Fog);
    ForWays(scene,
      [&](const Vector3& point, const IncidentSample& sample)
      {
        const Vector3 lamp = point + sample.Distance * sample.Direction;
        const double depth = 0.5 * sample.Distance * (density(point) + density(lamp));
        EXPECT_NEAR(DepthTowards(&legs, depths, point, sample.Direction, sample.Distance), depth, 1e-5 * depth);
      });
  }
}

TEST(LightLegs, AWayTowardsTheSunEndsAtTheBounds)
{
  Light sun = LampOf(LightShape::Sun);
  sun.Radius = 0.05;
  LitScene scene(Prepared(sun), Sigma);
  const DensityGrid grid = DensityOf(5, [](const Vector3&) { return 0.7; });
  scene.Fog.Density = &grid;
  LightLegs legs(scene.Source, scene.Fog, 2.0);
  ASSERT_TRUE(legs.Fill({}));
  const MediumOpticalDepth depths(scene.Fog);
  ForWays(scene,
    [&](const Vector3& point, const IncidentSample& sample)
    {
      const double depth = 0.7 * ExitDistance(scene.Fog.Bounds, point, sample.Direction);
      EXPECT_NEAR(DepthTowards(&legs, depths, point, sample.Direction, HUGE_VAL), depth, 1e-5);
    });
}

TEST(LightLegs, WhatATableErrsByIsWhatItSays)
{
  const DensityGrid grid = DensityOf(13,
    [](const Vector3& p) { return std::max(1.0 + std::sin(2.5 * p.X) * std::cos(4.0 * p.Y + 3.0 * p.Z), 0.3); });
  LitScene scene(LampOf(LightShape::Disc), Sigma);
  scene.Fog.Density = &grid;
  ScatteringOptions options;
  const std::unique_ptr<const LightLegs> legs =
    ChooseLightLegs(scene.Quadrature, scene.Eye, options, { 2e-3, 5e-3 }, {});
  ASSERT_TRUE(legs);
  EXPECT_LE(legs->ErrorOfRays, 2e-3);
  EXPECT_LE(legs->ErrorOfLegs, 5e-3);
  EXPECT_GT(legs->ErrorOfLegs, 0.0);
  const MediumOpticalDepth depths(scene.Fog);
  double squares = 0.0;
  double weights = 0.0;
  ForWays(scene,
    [&](const Vector3& point, const IncidentSample& sample)
    {
      const double depth = depths.Towards(point, sample.Direction, sample.Distance);
      const double difference = depth - DepthTowards(legs.get(), depths, point, sample.Direction, sample.Distance);
      squares += std::pow(std::expm1(Sigma * difference), 2.0) * std::exp(-Sigma * depth);
      weights += std::exp(-Sigma * depth);
    });
  EXPECT_LT(std::sqrt(squares / weights), 2.0 * legs->ErrorOfLegs);
  EXPECT_GT(std::sqrt(squares / weights), 0.3 * legs->ErrorOfLegs);
  // What is asked for in vain, what does not pay, and what has no two coordinates goes by integrals.
  EXPECT_FALSE(ChooseLightLegs(scene.Quadrature, scene.Eye, options, { 1e-9, 5e-3 }, {}));
  options.Width = 2;
  options.Height = 2;
  EXPECT_FALSE(ChooseLightLegs(scene.Quadrature, scene.Eye, options, { 2e-3, 5e-3 }, {}));
  EXPECT_FALSE(LightLegs::Fit(LampOf(LightShape::Sphere)));
}
