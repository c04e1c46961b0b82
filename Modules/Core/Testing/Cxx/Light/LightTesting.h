// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LightTesting.h
 * @brief A light of each shape, places from which to look at it, and what is asked of it in several files.
 */
#ifndef LightTesting_h
#define LightTesting_h

#include "scConstants.h"
#include "scFrame.h"
#include "scLight.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace lighttesting
{

using namespace shadowcones;

inline Light Prepared(Light light)
{
  const char* error = PrepareLight(light);
  EXPECT_EQ(error, nullptr) << error;
  return light;
}

inline Light Disc(double radius = 0.5)
{
  Light light;
  light.Shape = LightShape::Disc;
  light.Center = { 1.0, 2.0, 3.0 };
  light.Normal = { 0.3, -2.0, 0.4 };
  light.Radius = radius;
  return Prepared(light);
}

inline Light Rectangle(double width = 1.0, double height = 0.6)
{
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = { 1.0, 2.0, 3.0 };
  light.Normal = Normalized({ 0.3, -2.0, 0.4 });
  const Frame frame = FrameAround(light.Normal);
  light.AxisU = 0.5 * width * frame.U;
  light.AxisV = 0.5 * height * frame.V;
  return Prepared(light);
}

inline Light Sphere(double radius = 0.5)
{
  Light light = Disc(radius);
  light.Shape = LightShape::Sphere;
  return Prepared(light);
}

inline Light Point()
{
  Light light = Disc();
  light.Shape = LightShape::Point;
  return Prepared(light);
}

inline Light Sun(double degrees = 0.533)
{
  Light light;
  light.Shape = LightShape::Sun;
  light.Normal = { 0.3, -2.0, 0.4 };
  light.Radius = 0.5 * degrees * Pi / 180.0;
  return Prepared(light);
}

// A roof of two unequal triangles, one without an area between them.
inline Light Mesh()
{
  Light light;
  light.Shape = LightShape::Mesh;
  const Vector3 a{ 0.5, 2.0, 3.0 };
  const Vector3 b{ 1.5, 2.0, 3.2 };
  const Vector3 c{ 1.0, 2.1, 2.4 };
  const Vector3 d{ 1.1, 2.4, 4.0 };
  light.Triangles = { { a, b, c }, { a, a, b }, { a, d, b } };
  // Both faces emit downwards.
  for (auto& t : light.Triangles)
  {
    if (Cross(t[1] - t[0], t[2] - t[0]).Y > 0.0)
    {
      std::swap(t[1], t[2]);
    }
  }
  return Prepared(light);
}

inline Light Vertices()
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Vertices = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 } };
  return Prepared(light);
}

// A point at a distance from the centre, at an angle to the normal.
inline Vector3 Viewpoint(const Light& light, double distance, double degrees, double azimuth = 0.7)
{
  const Frame frame = FrameAround(light.Normal);
  const double angle = degrees * Pi / 180.0;
  return light.Center +
    distance *
    (std::cos(angle) * light.Normal +
      std::sin(angle) * (std::cos(azimuth) * frame.U + std::sin(azimuth) * frame.V));
}

inline double MeanWeight(const Light& light, const Vector3& from, LightSampling sampling, std::uint32_t count = 1u << 14)
{
  double sum = 0.0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const auto s = SobolPoint(11, i);
    sum += SampleIncidentLight(light, from, s[0], s[1], sampling).Weight;
  }
  return sum / count;
}

inline void ExpectSolidAngleRoundTrip(const Light& light, const Vector3& from, double tolerance)
{
  for (std::uint32_t i = 0; i < 400; ++i)
  {
    const auto s = SobolPoint(7, i);
    const LightDirectionSample sample = SampleLightSolidAngle(light, from, s[0], s[1]);
    ASSERT_GT(sample.Pdf, 0.0);
    ASSERT_NEAR(Length(sample.Direction), 1.0, 1e-12);
    const auto uv = InvertLightSolidAngle(light, from, sample.Direction);
    ASSERT_NEAR(uv[0], s[0], tolerance) << "sample " << i << " (" << s[0] << ", " << s[1] << ")";
    ASSERT_NEAR(uv[1], s[1], tolerance) << "sample " << i << " (" << s[0] << ", " << s[1] << ")";
    const double density = LightSolidAnglePdf(light, from, sample.Direction);
    ASSERT_NEAR(density / sample.Pdf, 1.0, 1e-6) << "sample " << i << " (" << s[0] << ", " << s[1] << ")";
  }
}

} // namespace lighttesting

#endif
