// SPDX-License-Identifier: BSD-3-Clause
// What each shape of light brings to a point: closed forms of solid angles, and means of samples beside them.
#include "LightTesting.h"
#include "scConstants.h"
#include "scFrame.h"
#include "scLight.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace shadowcones;
using namespace lighttesting;

TEST(Light, DiscOnItsAxis)
{
  const Light light = Disc();
  for (const double h : { 1e-6, 1e-3, 0.1, 0.5, 2.0, 50.0 })
  {
    const double exact = 2.0 * Pi * 0.25 / (std::sqrt(h * h + 0.25) * (std::sqrt(h * h + 0.25) + h));
    EXPECT_NEAR(LightSolidAngle(light, light.Center + h * light.Normal) / exact, 1.0, 1e-10) << h;
  }
  const double h = 0.8;
  const Vector3 from = light.Center + h * light.Normal;
  const double exact = 2.0 * Pi * (1.0 - h / std::sqrt(h * h + 0.25));
  EXPECT_NEAR(MeanWeight(light, from, LightSampling::Area) / exact, 1.0, 1e-4);
  EXPECT_NEAR(MeanWeight(light, from, LightSampling::SolidAngle) / exact, 1.0, 1e-10);
  EXPECT_NEAR(MeanWeight(light, from, LightSampling::Auto) / exact, 1.0, 1e-10);
}

TEST(Light, DiscOffItsAxis)
{
  const Light light = Disc();
  for (const double distance : { 0.7, 1.5, 4.0 })
  {
    for (const double degrees : { 15.0, 45.0, 80.0 })
    {
      const Vector3 from = Viewpoint(light, distance, degrees);
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::Area, 1u << 16) / LightSolidAngle(light, from), 1.0, 3e-4)
        << distance << ", " << degrees;
    }
  }
}

TEST(Light, DiscSeenFromItsRimAndItsFace)
{
  const Light light = Disc();
  const Vector3 u = FrameAround(light.Normal).U;
  // Just above it, the face fills a half space; above the rim, half of that; beside it, nothing.
  EXPECT_NEAR(LightSolidAngle(light, light.Center + 1e-9 * light.Normal + 0.2 * u), 2.0 * Pi, 1e-7);
  EXPECT_NEAR(LightSolidAngle(light, light.Center + 1e-9 * light.Normal + 0.5 * u), Pi, 1e-3);
  EXPECT_NEAR(LightSolidAngle(light, light.Center + 1e-9 * light.Normal + 0.7 * u), 0.0, 1e-7);
}

TEST(Light, SphereIsASphericalCap)
{
  const Light light = Sphere();
  for (const double d : { 0.5, 0.6, 2.0, 100.0 })
  {
    const double exact = 2.0 * Pi * (1.0 - std::sqrt(1.0 - 0.25 / (d * d)));
    const Vector3 from = Viewpoint(light, d, 35.0);
    // At d = R rounding may leave the point inside by an ulp; step out by one in 1e12.
    EXPECT_NEAR(LightSolidAngle(light, Viewpoint(light, d * (1.0 + 1e-12), 35.0)) / exact, 1.0, 1e-5) << d;
    if (d > 0.5)
    {
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::SolidAngle) / exact, 1.0, 1e-9) << d;
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::Auto) / exact, 1.0, 1e-9) << d;
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::Area, 1u << 16) / exact, 1.0, 2e-3) << d;
    }
  }
}

TEST(Light, RectangleOnItsAxis)
{
  const Light light = Rectangle();
  for (const double h : { 1e-3, 0.1, 0.8, 5.0, 100.0 })
  {
    const double exact = 4.0 * std::asin(0.5 * 0.3 / std::sqrt((0.25 + h * h) * (0.09 + h * h)));
    const Vector3 from = light.Center + h * light.Normal;
    EXPECT_NEAR(LightSolidAngle(light, from) / exact, 1.0, 1e-9) << h;
    if (h >= 0.1)
    {
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::Area, 1u << 15) / exact, 1.0, 1e-3) << h;
      EXPECT_NEAR(MeanWeight(light, from, LightSampling::SolidAngle) / exact, 1.0, 1e-3) << h;
    }
  }
  const Vector3 aside = Viewpoint(light, 1.0, 50.0);
  EXPECT_NEAR(MeanWeight(light, aside, LightSampling::Area, 1u << 16) / LightSolidAngle(light, aside), 1.0, 3e-4);
}

TEST(Light, MeshOfTwoTrianglesIsTheirRectangle)
{
  const Light rectangle = Rectangle();
  const Vector3 c = rectangle.Center;
  const Vector3 u = rectangle.AxisU;
  const Vector3 v = rectangle.AxisV;
  Light light;
  light.Shape = LightShape::Mesh;
  light.Triangles = { { c - u - v, c + u - v, c + u + v }, { c - u - v, c + u + v, c - u + v } };
  light = Prepared(light);
  const Vector3 from = Viewpoint(rectangle, 1.3, 40.0);
  EXPECT_NEAR(LightArea(light), LightArea(rectangle), 1e-14);
  EXPECT_NEAR(LightSolidAngle(light, from) / LightSolidAngle(rectangle, from), 1.0, 1e-12);
  EXPECT_NEAR(
    MeanWeight(light, from, LightSampling::Auto, 1u << 16) / LightSolidAngle(rectangle, from), 1.0, 1e-3);
  EXPECT_EQ(LightSolidAngle(light, c - 1.3 * rectangle.Normal), 0.0);
}

TEST(Light, PointFallsOffWithTheSquareOfTheDistance)
{
  const Light light = Point();
  const Vector3 from = light.Center + Vector3{ 0.0, 4.0, 3.0 };
  const IncidentSample sample = SampleIncidentLight(light, from, 0.1, 0.9);
  EXPECT_DOUBLE_EQ(sample.Weight, 1.0 / 25.0);
  EXPECT_DOUBLE_EQ(sample.Distance, 5.0);
  EXPECT_NEAR(sample.Direction.Y, -0.8, 1e-15);
  EXPECT_EQ(SampleVisibleLight(light, from, 0.1, 0.9).Weight, 1.0);
  EXPECT_EQ(SampleIncidentLight(light, light.Center, 0.1, 0.9).Weight, 0.0);
}

TEST(Light, VerticesAddUp)
{
  const Light light = Vertices();
  const Vector3 from{ 0.0, 0.0, 2.0 };
  EXPECT_NEAR(MeanWeight(light, from, LightSampling::Auto, 3u << 10), 1.0 / 4.0 + 1.0 / 5.0 + 1.0 / 8.0, 1e-3);
  const LightDirectionSample sample = SampleLightSolidAngle(light, from, 0.5, 0.5);
  EXPECT_DOUBLE_EQ(sample.Pdf, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(LightSolidAnglePdf(light, from, sample.Direction), 1.0 / 3.0);
  EXPECT_NEAR(InvertLightSolidAngle(light, from, sample.Direction)[0], 0.5, 1e-15);
}

TEST(Light, SunKeepsItsIrradianceAndItsAngle)
{
  const Light light = Sun();
  const Vector3 from{ 1e6, -3.0, 2.0 };
  EXPECT_EQ(MeanWeight(light, from, LightSampling::Auto, 64), 1.0);
  EXPECT_NEAR(LightSolidAngle(light, from), 4.0 * Pi * std::pow(std::sin(0.25 * 0.533 * Pi / 180.0), 2), 1e-18);
  double largest = 0.0;
  for (std::uint32_t i = 0; i < 4096; ++i)
  {
    const auto s = SobolPoint(1, i);
    const IncidentSample sample = SampleVisibleLight(light, from, s[0], s[1]);
    EXPECT_EQ(sample.Weight, 1.0);
    EXPECT_TRUE(std::isinf(sample.Distance));
    largest = std::max(largest, Length(Cross(sample.Direction, light.Normal)));
  }
  EXPECT_NEAR(std::asin(largest) / (0.5 * 0.533 * Pi / 180.0), 1.0, 0.01);
}

TEST(Light, SunWithoutAnAngleIsOneDirection)
{
  const Light light = Sun(0.0);
  for (const double u : { 0.0, 0.3, 0.999 })
  {
    const IncidentSample sample = SampleIncidentLight(light, {}, u, 1.0 - u);
    EXPECT_NEAR(Length(sample.Direction + light.Normal), 0.0, 1e-15);
    EXPECT_EQ(sample.Weight, 1.0);
  }
  EXPECT_EQ(SampleLightSolidAngle(light, {}, 0.2, 0.2).Pdf, 1.0);
  EXPECT_EQ(LightSolidAnglePdf(light, {}, -light.Normal), 1.0);
}
