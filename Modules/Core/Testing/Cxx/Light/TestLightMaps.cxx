// SPDX-License-Identifier: BSD-3-Clause
// Samples of lights: round trips of every map, and densities that integrate to 1.
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
#include <string>
#include <vector>

using namespace shadowcones;
using namespace lighttesting;

namespace
{

void ExpectAreaRoundTrip(const Light& light, double tolerance)
{
  for (std::uint32_t i = 0; i < 400; ++i)
  {
    const auto s = SobolPoint(7, i);
    const LightSurfaceSample sample = SampleLightArea(light, s[0], s[1]);
    const auto uv = InvertLightArea(light, sample.Position);
    ASSERT_NEAR(uv[0], s[0], tolerance) << "sample " << i;
    ASSERT_NEAR(uv[1], s[1], tolerance) << "sample " << i;
    EXPECT_NEAR(Length(sample.Normal), 1.0, 1e-12);
  }
}

// Integral of the density over the sphere, by a fine grid in a cone of directions that holds the light.
double DensityIntegral(const Light& light, const Vector3& from, const Vector3& axis, double oneMinusCosine)
{
  const Frame frame = FrameAround(axis);
  constexpr int n = 700;
  double sum = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const double c = 1.0 - oneMinusCosine * (i + 0.5) / n;
    const double s = std::sqrt(1.0 - c * c);
    for (int j = 0; j < n; ++j)
    {
      const double phi = 2.0 * Pi * (j + 0.5) / n;
      const Vector3 direction = c * axis + s * std::cos(phi) * frame.U + s * std::sin(phi) * frame.V;
      sum += LightSolidAnglePdf(light, from, direction);
    }
  }
  return sum * 2.0 * Pi * oneMinusCosine / (static_cast<double>(n) * n);
}

// Chi-square of solid-angle samples over 8 x 8 equal cells of the light, against cos / d^2 integrated over each cell.
double ChiSquare(const Light& light, const Vector3& from)
{
  constexpr int cells = 8;
  constexpr int fine = 24;
  std::vector<double> expected(cells * cells, 0.0);
  double total = 0.0;
  for (int i = 0; i < cells * fine; ++i)
  {
    for (int j = 0; j < cells * fine; ++j)
    {
      const double w = SampleIncidentLight(
        light, from, (i + 0.5) / (cells * fine), (j + 0.5) / (cells * fine), LightSampling::Area)
                         .Weight;
      expected[(i / fine) * cells + j / fine] += w;
      total += w;
    }
  }
  constexpr int count = 100000;
  std::vector<int> found(cells * cells, 0);
  RandomStream stream(1, 2);
  for (int k = 0; k < count; ++k)
  {
    const double u = stream.Next();
    const LightDirectionSample s = SampleLightSolidAngle(light, from, u, stream.Next());
    const auto uv = InvertLightArea(light, from + s.Distance * s.Direction);
    ++found[static_cast<int>(uv[0] * cells) * cells + static_cast<int>(uv[1] * cells)];
  }
  double sum = 0.0;
  for (int c = 0; c < cells * cells; ++c)
  {
    const double mean = count * expected[c] / total;
    sum += (found[c] - mean) * (found[c] - mean) / mean;
  }
  return sum;
}

constexpr double ChiSquareBound = 113.5; // 63 degrees of freedom, one in ten thousand

} // namespace

//------------------------------------------------------------------------------
TEST(Light, AreaMapsInvert)
{
  ExpectAreaRoundTrip(Disc(), 1e-12);
  ExpectAreaRoundTrip(Rectangle(), 1e-12);
  ExpectAreaRoundTrip(Sphere(), 1e-12);
  ExpectAreaRoundTrip(Sun(), 1e-9);
  ExpectAreaRoundTrip(Sun(170.0), 1e-12);
  ExpectAreaRoundTrip(Mesh(), 1e-9);
}

TEST(Light, AreaDensityIsOneOverTheArea)
{
  EXPECT_NEAR(SampleLightArea(Disc(), 0.2, 0.7).Pdf * Pi * 0.25, 1.0, 1e-14);
  EXPECT_NEAR(SampleLightArea(Rectangle(), 0.2, 0.7).Pdf * 0.6, 1.0, 1e-14);
  EXPECT_NEAR(SampleLightArea(Sphere(), 0.2, 0.7).Pdf * Pi, 1.0, 1e-14);
  EXPECT_NEAR(SampleLightArea(Mesh(), 0.2, 0.7).Pdf * LightArea(Mesh()), 1.0, 1e-14);
  EXPECT_NEAR(SampleLightArea(Sun(), 0.2, 0.7).Pdf * LightSolidAngle(Sun(), {}), 1.0, 1e-14);
  EXPECT_EQ(SampleLightArea(Point(), 0.2, 0.7).Pdf, 1.0);
  EXPECT_EQ(SampleLightArea(Vertices(), 0.2, 0.7).Pdf, 1.0 / 3.0);
}

TEST(Light, AreaSamplesAreUniform)
{
  // Second moments: R^2 / 4 on a disc, (edge)^2 / 12 on a rectangle, R^2 / 3 on a sphere.
  const Light lights[3] = { Disc(), Rectangle(), Sphere() };
  for (const Light& light : lights)
  {
    const Vector3 axis = light.Shape == LightShape::Rectangle ? Normalized(light.AxisU) : FrameAround(light.Normal).U;
    const double moment = light.Shape == LightShape::Disc ? 0.0625
      : light.Shape == LightShape::Rectangle             ? 1.0 / 12.0
                                                          : 0.25 / 3.0;
    double first = 0.0;
    double second = 0.0;
    constexpr std::uint32_t n = 1u << 14;
    for (std::uint32_t i = 0; i < n; ++i)
    {
      const auto s = SobolPoint(3, i);
      const double x = Dot(SampleLightArea(light, s[0], s[1]).Position - light.Center, axis);
      first += x / n;
      second += x * x / n;
    }
    EXPECT_NEAR(first, 0.0, 1e-4);
    EXPECT_NEAR(second / moment, 1.0, 1e-3);
  }
}

TEST(Light, MeshFacesAreDrawnByTheirAreaAndEmptyOnesNever)
{
  const Light light = Mesh();
  ASSERT_EQ(light.CumulativeArea.size(), 3u);
  EXPECT_EQ(light.CumulativeArea[0], light.CumulativeArea[1]);
  const double share = light.CumulativeArea[0] / light.CumulativeArea[2];
  int first = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 p = SampleLightArea(light, (i + 0.5) / 1000.0, 0.3).Position;
    ASSERT_TRUE(IsFinite(p));
    const auto uv = InvertLightArea(light, p);
    first += uv[0] < share ? 1 : 0;
  }
  EXPECT_NEAR(first, 1000.0 * share, 1.0);
}

//------------------------------------------------------------------------------
TEST(Light, SolidAngleMapsInvert)
{
  for (const double distance : { 0.55, 1.0, 3.0, 30.0 })
  {
    for (const double degrees : { 0.0, 20.0, 60.0, 85.0 })
    {
      SCOPED_TRACE("distance " + std::to_string(distance) + ", angle " + std::to_string(degrees));
      // The rounding of a direction grows in (u, v) as the light gets smaller.
      const double tolerance = 1e-9 * std::max(distance * distance, 1.0);
      ExpectSolidAngleRoundTrip(Disc(), Viewpoint(Disc(), distance, degrees), tolerance);
      ExpectSolidAngleRoundTrip(Rectangle(), Viewpoint(Rectangle(), distance, degrees), tolerance);
      ExpectSolidAngleRoundTrip(Sphere(), Viewpoint(Sphere(), distance, degrees), tolerance);
    }
  }
  ExpectSolidAngleRoundTrip(Sun(), { 4.0, 5.0, 6.0 }, 1e-9);
  ExpectSolidAngleRoundTrip(Mesh(), { 1.0, -3.0, 3.0 }, 1e-8);
}

TEST(Light, SolidAngleMapsInvertOnTheSurfaceOfTheLight)
{
  // Hardly above the face, near its middle and near its edge.
  for (const double height : { 1e-2, 1e-4, 1e-6 })
  {
    for (const double offset : { 0.0, 0.29, 0.45, 0.4999 })
    {
      SCOPED_TRACE("height " + std::to_string(height) + ", offset " + std::to_string(offset));
      const Light disc = Disc();
      const Vector3 above = disc.Center + height * disc.Normal;
      ExpectSolidAngleRoundTrip(disc, above + offset * FrameAround(disc.Normal).U, 1e-6);
      const Light rectangle = Rectangle();
      ExpectSolidAngleRoundTrip(rectangle, above + offset * Normalized(rectangle.AxisU), 1e-6);
    }
  }
}

TEST(Light, ThePointOfASolidAngleSampleIsOnTheLight)
{
  const Light disc = Disc();
  const Light rectangle = Rectangle();
  const Light sphere = Sphere();
  for (std::uint32_t i = 0; i < 500; ++i)
  {
    const auto s = SobolPoint(2, i);
    const Vector3 from = Viewpoint(disc, 0.6 + 3.0 * s[2], 80.0 * s[3]);
    LightDirectionSample sample = SampleLightSolidAngle(disc, from, s[0], s[1]);
    Vector3 offset = from + sample.Distance * sample.Direction - disc.Center;
    EXPECT_NEAR(Dot(offset, disc.Normal), 0.0, 1e-12);
    EXPECT_LE(Length(offset), 0.5 + 1e-9);
    sample = SampleLightSolidAngle(rectangle, from, s[0], s[1]);
    offset = from + sample.Distance * sample.Direction - rectangle.Center;
    EXPECT_NEAR(Dot(offset, rectangle.Normal), 0.0, 1e-12);
    EXPECT_LE(std::fabs(Dot(offset, Normalized(rectangle.AxisU))), 0.5 + 1e-12);
    EXPECT_LE(std::fabs(Dot(offset, Normalized(rectangle.AxisV))), 0.3 + 1e-12);
    sample = SampleLightSolidAngle(sphere, from, s[0], s[1]);
    offset = from + sample.Distance * sample.Direction - sphere.Center;
    EXPECT_NEAR(Length(offset), 0.5, 1e-9);
    EXPECT_LE(Dot(offset, sample.Direction), 1e-9); // the near side
  }
}

TEST(Light, DensitiesIntegrateToOne)
{
  const Light lights[3] = { Disc(), Rectangle(), Sphere() };
  for (const Light& light : lights)
  {
    for (const double degrees : { 0.0, 50.0 })
    {
      const Vector3 from = Viewpoint(light, 1.0, degrees);
      const Vector3 axis = Normalized(light.Center - from);
      EXPECT_NEAR(DensityIntegral(light, from, axis, 0.4), 1.0, 3e-3)
        << "shape " << static_cast<int>(light.Shape) << ", " << degrees;
    }
  }
  const Light far = Rectangle(0.02, 0.01); // below the limit of the spherical map
  const Vector3 from = Viewpoint(far, 1.5, 30.0);
  ASSERT_LT(LightSolidAngle(far, from), 1e-4);
  EXPECT_NEAR(DensityIntegral(far, from, Normalized(far.Center - from), 5e-5), 1.0, 5e-3);
  EXPECT_NEAR(DensityIntegral(Sun(20.0), {}, -Sun().Normal, 0.05), 1.0, 3e-3);
  const Light mesh = Mesh();
  const Vector3 below{ 1.0, 0.0, 3.0 };
  EXPECT_NEAR(DensityIntegral(mesh, below, { 0.0, 1.0, 0.0 }, 0.3), 1.0, 3e-3);
}

TEST(Light, SolidAngleSamplesAreUniform)
{
  for (const double degrees : { 0.0, 60.0 })
  {
    EXPECT_LT(ChiSquare(Disc(), Viewpoint(Disc(), 0.7, degrees)), ChiSquareBound);
    EXPECT_LT(ChiSquare(Rectangle(), Viewpoint(Rectangle(), 0.7, degrees)), ChiSquareBound);
  }
}

//------------------------------------------------------------------------------
TEST(Light, VisibleSamplesWeighOneOnTheBrightSide)
{
  for (const Light& light : { Disc(), Rectangle(), Sphere(), Mesh() })
  {
    const Vector3 from = light.Shape == LightShape::Mesh ? Vector3{ 1.0, -3.0, 3.0 } : Viewpoint(light, 1.7, 30.0);
    for (std::uint32_t i = 0; i < 64; ++i)
    {
      const auto s = SobolPoint(1, i);
      const IncidentSample sample = SampleVisibleLight(light, from, s[0], s[1]);
      EXPECT_EQ(sample.Weight, 1.0);
      EXPECT_GT(sample.Distance, 0.0);
    }
  }
}

TEST(Light, BoundingSpheresHoldTheLight)
{
  for (const Light& light : { Disc(), Rectangle(), Sphere(), Mesh(), Vertices(), Point() })
  {
    Vector3 center;
    double radius = -1.0;
    LightBoundingSphere(light, center, radius);
    for (std::uint32_t i = 0; i < 256; ++i)
    {
      const auto s = SobolPoint(4, i);
      EXPECT_LE(Length(SampleLightArea(light, s[0], s[1]).Position - center), radius + 1e-12);
    }
  }
}
