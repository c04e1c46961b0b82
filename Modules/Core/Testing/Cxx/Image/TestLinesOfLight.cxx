// SPDX-License-Identifier: BSD-3-Clause
#include "scLinesOfLight.h"

#include "LitScene.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// The sun shines down on a ray from x = 0 to 4; plates above it hide it. Nearly nothing is absorbed.
struct SunnyRay
{
  LitScene Scene;
  TestMesh Plates;
  LitPixel Pixel;
  LitSums Sums;
  ScatteringOptions Options;

  explicit SunnyRay(double sunRadius)
    : Scene(SunLight({ 0.0, -1.0, 0.0 }, sunRadius), 1e-6)
    , Pixel(Scene.PixelOf(8, 8, 17))
    , Sums(Scene.Groups)
  {
    this->Sums.Add(this->Pixel, 5.0);
    this->Sums.Accumulate();
  }
  /// From x to x, as distances along the ray.
  void AddPlate(double begin, double end, double height = 2.0)
  {
    this->Plates.AddSheet({ begin - 1.0, height, -3.0 }, { end - begin, 0.0, 0.0 }, { 0.0, 0.0, 6.0 }, 0);
  }
  struct Result
  {
    double Fraction; ///< of the light that is left
    double Error;    ///< of it, as claimed
    int Samples;
    vtkIdType Lines;
  };
  Result Estimate(std::uint64_t seed = 1)
  {
    const OccluderScene occluders(this->Plates.View());
    const LineShadows shadows(this->Plates.View());
    const ScatteringScene scene{ occluders, this->Scene.Source, this->Scene.Fog, this->Scene.Eye };
    const RenderContext context(scene, this->Options);
    EXPECT_TRUE(LinesOfLight::Fit(context));
    LinesOfLight lines(context, shadows);
    EXPECT_TRUE(lines.Fit(this->Pixel));
    lines.Look(this->Sums, { { 1.0, 5.0 } }, {}, seed);
    lines.Estimate(this->Options.MaximumSamples);
    return { lines.Left()[0] / this->Sums.Groups()[0], std::sqrt(lines.Variance()) / this->Sums.Mean(),
      lines.NumberOfSamples(), lines.NumberOfLines() };
  }
};
} // namespace

TEST(LinesOfLight, AHardSunIsExactThroughTheFinestSlits)
{
  SunnyRay sunny(0.0);
  double open = 1.0; // before the first plate
  for (int k = 0; k < 100; ++k)
  {
    sunny.AddPlate(2.0 + 0.03 * k, 2.0 + 0.03 * k + (k < 99 ? 0.029 : 0.03));
    open += k < 99 ? 0.001 : 0.0;
  }
  for (std::uint64_t seed = 1; seed < 6; ++seed)
  {
    const auto result = sunny.Estimate(seed);
    EXPECT_NEAR(result.Fraction, open / 4.0, 2e-6);
    EXPECT_LE(result.Error, 1e-5);
    EXPECT_EQ(result.Lines, 1) << "all points of the light are the same";
  }
}

TEST(LinesOfLight, ASoftSunKeepsItsClaims)
{
  for (const double goal : { 0.05, 0.01, 0.002 })
  {
    SunnyRay sunny(0.1);
    sunny.AddPlate(2.0, 2.5); // both penumbrae lie in the ray, and take and give as much
    sunny.AddPlate(3.0, 3.5, 1.5);
    sunny.Options.RelativeErrorGoal = goal;
    sunny.Options.MaximumSamples = 1 << 16;
    for (std::uint64_t seed = 1; seed < 9; ++seed)
    {
      const auto result = sunny.Estimate(seed);
      EXPECT_NEAR(result.Fraction, 0.75, 3.0 * result.Error);
      EXPECT_LE(result.Error, 1.5 * goal * result.Fraction);
      EXPECT_EQ(result.Samples % LinesOfLight::SamplesOfLine, 0);
    }
  }
}

TEST(LinesOfLight, AllOrNothing)
{
  SunnyRay sunny(0.1);
  auto result = sunny.Estimate();
  EXPECT_EQ(result.Fraction, 1.0);
  sunny.AddPlate(-9.0, 19.0);
  result = sunny.Estimate();
  EXPECT_EQ(result.Fraction, 0.0);
  EXPECT_GT(result.Error, 0.0) << "light that fell between the points of the lamp is not ruled out";
}

TEST(LinesOfLight, StopAtTheMaximumAndKnowWhereTheyFit)
{
  SunnyRay sunny(0.1);
  sunny.AddPlate(2.0, 2.5);
  sunny.Options.RelativeErrorGoal = 1e-6;
  for (const int most : { 64, 100, 128, 1000 })
  {
    sunny.Options.MaximumSamples = most;
    const auto result = sunny.Estimate();
    EXPECT_EQ(result.Samples, most / LinesOfLight::SamplesOfLine * LinesOfLight::SamplesOfLine);
    EXPECT_NEAR(result.Fraction, 0.875, 3.0 * result.Error);
  }
  const OccluderScene nothing{ TriangleMeshView() };
  const auto fit = [&](const Light& light)
  {
    const ScatteringScene scene{ nothing, light, sunny.Scene.Fog, sunny.Scene.Eye };
    const RenderContext context(scene, sunny.Options);
    return LinesOfLight::Fit(context);
  };
  EXPECT_FALSE(fit(MakeLight(LightShape::Sphere, { 0.0, 5.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3, { 1.0 })));
  EXPECT_TRUE(fit(MakeLight(LightShape::Disc, { 0.0, 5.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3, { 1.0 })));
  sunny.Options.MaximumSamples = 63;
  EXPECT_FALSE(fit(sunny.Scene.Source)) << "too few";
  // A ray towards the sun, or past the lamp, sees every point of it along another way.
  sunny.Options.MaximumSamples = 1024;
  const LineShadows shadows{ TriangleMeshView() };
  const Light along = SunLight({ -1.0, 0.0, 0.0 }, 0.1);
  const Light lamp = MakeLight(LightShape::Disc, { 2.0, 0.5, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3, { 1.0 });
  for (const Light* light : { &along, &lamp })
  {
    const ScatteringScene scene{ nothing, *light, sunny.Scene.Fog, sunny.Scene.Eye };
    const RenderContext context(scene, sunny.Options);
    EXPECT_FALSE(LinesOfLight(context, shadows).Fit(sunny.Pixel));
  }
}
