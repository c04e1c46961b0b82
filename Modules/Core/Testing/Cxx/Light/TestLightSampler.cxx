// SPDX-License-Identifier: BSD-3-Clause
#include "scLightSampler.h"
#include "scLightStrata.h"

#include <gtest/gtest.h>

#include <vector>

using namespace shadowcones;

namespace
{

Light MakeLight(LightShape shape)
{
  Light light;
  light.Shape = shape;
  light.Center = { 0.3, 2.0, -0.4 };
  light.Normal = Normalized({ 0.1, -1.0, 0.2 });
  light.Radius = 0.6;
  const Frame frame = FrameAround(light.Normal);
  light.AxisU = 0.5 * frame.U;
  light.AxisV = 0.9 * frame.V;
  light.Spectrum = { 1.0 };
  if (shape == LightShape::Mesh)
  {
    light.Triangles = { { Vector3{ 0.0, 2.0, 0.0 }, Vector3{ 1.0, 2.0, 0.0 }, Vector3{ 0.0, 2.0, 1.0 } } };
  }
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

} // namespace

TEST(LightSampler, GivesWhatSampleIncidentLightGives)
{
  const Vector3 points[] = { { 0.2, 1.5, -0.3 }, { 2.0, -1.0, 3.0 }, { 0.0, 3.0, 0.0 }, { -9.0, -40.0, 7.0 } };
  for (const LightShape shape : { LightShape::Disc, LightShape::Rectangle, LightShape::Sphere, LightShape::Point,
         LightShape::Sun, LightShape::Mesh })
  {
    const Light light = MakeLight(shape);
    for (const LightSampling sampling : { LightSampling::Auto, LightSampling::Area, LightSampling::SolidAngle })
    {
      LightSampler sampler(light, sampling);
      for (const Vector3& from : points)
      {
        sampler.MoveTo(from);
        RandomStream random(7, static_cast<std::uint64_t>(shape));
        for (int k = 0; k < 50; ++k)
        {
          const double u = k == 0 ? 0.5 : random.Next();
          const double v = k == 0 ? 0.5 : random.Next();
          const IncidentSample expected = SampleIncidentLight(light, from, u, v, sampling);
          const IncidentSample sample = sampler.Sample(u, v);
          EXPECT_NEAR(sample.Weight, expected.Weight, 1e-11 * (1.0 + expected.Weight));
          if (expected.Weight > 0.0)
          {
            EXPECT_NEAR(Length(sample.Direction - expected.Direction), 0.0, 1e-11);
            EXPECT_TRUE(sample.Distance == expected.Distance ||
              std::fabs(sample.Distance - expected.Distance) < 1e-10 * expected.Distance);
          }
        }
      }
    }
  }
}

TEST(LightStrata, AnyCountCoversTheSquareEvenly)
{
  for (const int count : { 1, 2, 3, 5, 7, 9, 16, 17, 32, 100 })
  {
    const LightStrata strata(count);
    ASSERT_EQ(strata.Count(), count);
    // The mean of a linear function over the strata is exact but for the jitter, which many seeds average out.
    double sumU = 0.0;
    double sumV = 0.0;
    double sumUV = 0.0;
    const int seeds = 4000;
    for (int seed = 0; seed < seeds; ++seed)
    {
      RandomStream random(1, static_cast<std::uint64_t>(seed));
      for (int k = 0; k < count; ++k)
      {
        const LightStrata::Point p = strata.Draw(k, random);
        ASSERT_TRUE(p.U >= 0.0 && p.U < 1.0 && p.V >= 0.0 && p.V < 1.0);
        sumU += p.U;
        sumV += p.V;
        sumUV += p.U * p.V;
      }
    }
    const double samples = static_cast<double>(seeds) * count;
    const double bound = 4.0 * 0.29 / std::sqrt(samples);
    EXPECT_NEAR(sumU / samples, 0.5, bound) << count;
    EXPECT_NEAR(sumV / samples, 0.5, bound) << count;
    EXPECT_NEAR(sumUV / samples, 0.25, bound) << count;
  }
}

TEST(LightStrata, VarianceOfMeanIsTheSpreadOverSeeds)
{
  for (const int count : { 4, 9, 16, 32 })
  {
    const LightStrata strata(count);
    std::vector<double> values(static_cast<std::size_t>(count));
    double sum = 0.0;
    double squares = 0.0;
    double claimed = 0.0;
    const int seeds = 4000;
    for (int seed = 0; seed < seeds; ++seed)
    {
      RandomStream random(2, static_cast<std::uint64_t>(seed));
      double mean = 0.0;
      for (int k = 0; k < count; ++k)
      {
        const LightStrata::Point p = strata.Draw(k, random);
        values[static_cast<std::size_t>(k)] = 1.0 + 2.0 * p.U - 3.0 * p.V;
        mean += values[static_cast<std::size_t>(k)] / count;
      }
      sum += mean;
      squares += mean * mean;
      claimed += strata.VarianceOfMean(values.data());
    }
    const double variance = squares / seeds - (sum / seeds) * (sum / seeds);
    EXPECT_NEAR(claimed / seeds / variance, 1.0, 0.15) << count;
  }
}

TEST(LightStrata, OneSampleHasNoVariance)
{
  const std::vector<double> values(4, 3.0);
  EXPECT_EQ(LightStrata(1).VarianceOfMean(values.data()), 0.0);
  EXPECT_EQ(LightStrata(0).Count(), 0);
}
