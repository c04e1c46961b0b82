// SPDX-License-Identifier: BSD-3-Clause
// Lights that are easy to get wrong: seen from their dark side, tiny, far away; and a message for each fault.
#include "LightTesting.h"
#include "scConstants.h"
#include "scLight.h"
#include "scLightSampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace shadowcones;
using namespace lighttesting;

TEST(Light, DarkSidesSendNothing)
{
  for (const Light& light : { Disc(), Rectangle() })
  {
    for (const Vector3& from : { light.Center - 0.7 * light.Normal, Viewpoint(light, 0.9, 120.0), light.Center })
    {
      EXPECT_EQ(LightSolidAngle(light, from), 0.0);
      EXPECT_EQ(SampleLightSolidAngle(light, from, 0.3, 0.4).Pdf, 0.0);
      EXPECT_EQ(LightSolidAnglePdf(light, from, light.Normal), 0.0);
      for (const LightSampling sampling : { LightSampling::Auto, LightSampling::Area, LightSampling::SolidAngle })
      {
        const IncidentSample sample = SampleIncidentLight(light, from, 0.3, 0.4, sampling);
        EXPECT_EQ(sample.Weight, 0.0);
        EXPECT_TRUE(IsFinite(sample.Direction));
      }
      EXPECT_EQ(SampleVisibleLight(light, from, 0.3, 0.4).Weight, 0.0);
    }
  }
}

TEST(Light, TheInsideOfASphereIsDark)
{
  const Light light = Sphere();
  for (const Vector3& from : { light.Center, light.Center + Vector3{ 0.2, 0.3, 0.1 } })
  {
    EXPECT_EQ(LightSolidAngle(light, from), 0.0);
    EXPECT_EQ(SampleLightSolidAngle(light, from, 0.3, 0.4).Pdf, 0.0);
    EXPECT_EQ(LightSolidAnglePdf(light, from, light.Normal), 0.0);
    EXPECT_EQ(SampleIncidentLight(light, from, 0.3, 0.4).Weight, 0.0);
    EXPECT_EQ(SampleIncidentLight(light, from, 0.3, 0.4, LightSampling::Area).Weight, 0.0);
    EXPECT_EQ(SampleVisibleLight(light, from, 0.3, 0.4).Weight, 0.0);
  }
}

TEST(Light, ARectangleWithoutAnAreaIsNotSeen)
{
  Light light = Rectangle();
  light.AxisU = {};
  EXPECT_EQ(LightSolidAngle(light, light.Center + light.Normal), 0.0);
  EXPECT_EQ(SampleLightSolidAngle(light, light.Center + light.Normal, 0.1, 0.2).Pdf, 0.0);
}

//------------------------------------------------------------------------------
TEST(Light, TinyAndFarLightsKeepTheirDigits)
{
  for (const double ratio : { 1e-3, 1e-6, 1e-9 })
  {
    SCOPED_TRACE(ratio);
    const double d = 0.5 / ratio;
    Light disc = Disc();
    Light sphere = Sphere();
    Light rectangle = Rectangle();
    disc.Center = sphere.Center = rectangle.Center = {};
    const double squared = Pi * ratio * ratio;
    const double relative = 2.0 * ratio * ratio + 1e-12;
    EXPECT_NEAR(LightSolidAngle(disc, Viewpoint(disc, d, 0.0)) / squared, 1.0, relative);
    EXPECT_NEAR(LightSolidAngle(disc, Viewpoint(disc, d, 60.0)) / squared, 0.5, relative);
    EXPECT_NEAR(LightSolidAngle(sphere, Viewpoint(disc, d, 60.0)) / squared, 1.0, relative);
    EXPECT_NEAR(LightSolidAngle(rectangle, Viewpoint(disc, d, 60.0)) * d * d / 0.6, 0.5, relative);
    for (const Light& light : { disc, sphere, rectangle })
    {
      const Vector3 from = Viewpoint(light, d, 30.0);
      // A direction is a unit vector with 16 digits: those of its place on the light are what the ratio leaves.
      ExpectSolidAngleRoundTrip(light, from, 1e-14 / ratio);
      const double weight = MeanWeight(light, from, LightSampling::SolidAngle, 256);
      EXPECT_NEAR(weight / LightSolidAngle(light, from), 1.0, 1e-8 + ratio);
      const double area = MeanWeight(light, from, LightSampling::Area, 1u << 14);
      EXPECT_NEAR(area / LightSolidAngle(light, from), 1.0, light.Shape == LightShape::Sphere ? 1e-2 : 1e-5);
    }
  }
}

TEST(Light, TheSunAsASphereFarAway)
{
  Light sphere;
  sphere.Shape = LightShape::Sphere;
  sphere.Center = { 0.0, 1e9, 0.0 };
  sphere.Radius = 1e9 * std::sin(0.5 * 0.533 * Pi / 180.0);
  sphere = Prepared(sphere);
  Light sun = Sun();
  sun.Normal = { 0.0, -1.0, 0.0 };
  EXPECT_NEAR(LightSolidAngle(sphere, {}) / LightSolidAngle(sun, {}), 1.0, 1e-12);
  const Vector3 a = SampleVisibleLight(sphere, {}, 0.2, 0.9).Direction;
  const Vector3 b = SampleVisibleLight(sun, {}, 0.2, 0.9).Direction;
  EXPECT_NEAR(Length(a - b), 0.0, 1e-12);
}

TEST(Light, FarFromTheOrigin)
{
  Light light = Disc();
  light.Center = { 1e6, -1e6, 1e6 };
  const Vector3 from = Viewpoint(light, 0.8, 40.0);
  const double solidAngle = LightSolidAngle(Disc(), Viewpoint(Disc(), 0.8, 40.0));
  EXPECT_NEAR(LightSolidAngle(light, from) / solidAngle, 1.0, 1e-8);
  EXPECT_NEAR(MeanWeight(light, from, LightSampling::Auto) / solidAngle, 1.0, 1e-8);
}

//------------------------------------------------------------------------------
TEST(Light, EachFaultHasItsSentence)
{
  const double nan = std::nan("");
  const auto error = [](Light light) -> std::string {
    const char* text = PrepareLight(light);
    return text ? text : "";
  };
  Light light = Disc();
  light.Radius = 0.0;
  EXPECT_NE(error(light).find("radius must be finite and larger than 0"), std::string::npos);
  light.Radius = nan;
  EXPECT_NE(error(light).find("radius"), std::string::npos);
  light = Disc();
  light.Normal = {};
  EXPECT_NE(error(light).find("normal must be finite and longer than 0"), std::string::npos);
  light = Disc();
  light.Center.Y = nan;
  EXPECT_NE(error(light).find("center must be finite"), std::string::npos);
  light = Disc();
  light.Spectrum = { 1.0, -1.0 };
  EXPECT_NE(error(light).find("negative"), std::string::npos);
  light.Spectrum = { 1.0, nan };
  EXPECT_NE(error(light).find("not finite"), std::string::npos);

  light = Rectangle();
  light.AxisU = {};
  EXPECT_NE(error(light).find("zero area"), std::string::npos);
  light = Rectangle();
  light.AxisV = light.AxisV + 0.5 * light.AxisU;
  EXPECT_NE(error(light).find("right angles to each other"), std::string::npos);
  light = Rectangle();
  light.Normal = Normalized(light.Normal + light.AxisU);
  EXPECT_NE(error(light).find("normal of the rectangular light"), std::string::npos);

  light = Sun();
  light.Radius = -1.0;
  EXPECT_NE(error(light).find("0 to 180 degrees"), std::string::npos);
  light = Sun();
  light.Normal.X = HUGE_VAL;
  EXPECT_NE(error(light).find("normal"), std::string::npos);

  light = {};
  light.Shape = LightShape::Mesh;
  EXPECT_NE(error(light).find("neither polygons nor vertices"), std::string::npos);
  light.Triangles.resize(2);
  EXPECT_NE(error(light).find("zero area"), std::string::npos);
  light.Triangles[0][1].X = nan;
  EXPECT_NE(error(light).find("mesh is not finite"), std::string::npos);
  light.Triangles.clear();
  light.Vertices = { { nan, 0.0, 0.0 } };
  EXPECT_NE(error(light).find("vertex of the light is not finite"), std::string::npos);
}
