// SPDX-License-Identifier: BSD-3-Clause
// Lights: round trips of every map, densities that integrate to 1, and closed forms of solid angles.
// One file because every promise is asked of the same lights of all shapes.
#include "scFrame.h"
#include "scLight.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;

namespace
{

constexpr double Pi = 3.14159265358979323846;

Light Prepared(Light light)
{
  const char* error = PrepareLight(light);
  EXPECT_EQ(error, nullptr) << error;
  return light;
}

Light Disc(double radius = 0.5)
{
  Light light;
  light.Shape = LightShape::Disc;
  light.Center = { 1.0, 2.0, 3.0 };
  light.Normal = { 0.3, -2.0, 0.4 };
  light.Radius = radius;
  return Prepared(light);
}

Light Rectangle(double width = 1.0, double height = 0.6)
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

Light Sphere(double radius = 0.5)
{
  Light light = Disc(radius);
  light.Shape = LightShape::Sphere;
  return Prepared(light);
}

Light Point()
{
  Light light = Disc();
  light.Shape = LightShape::Point;
  return Prepared(light);
}

Light Sun(double degrees = 0.533)
{
  Light light;
  light.Shape = LightShape::Sun;
  light.Normal = { 0.3, -2.0, 0.4 };
  light.Radius = 0.5 * degrees * Pi / 180.0;
  return Prepared(light);
}

// A roof of two unequal triangles, one without an area between them.
Light Mesh()
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

Light Vertices()
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Vertices = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 } };
  return Prepared(light);
}

// A point at a distance from the centre, at an angle to the normal.
Vector3 Viewpoint(const Light& light, double distance, double degrees, double azimuth = 0.7)
{
  const Frame frame = FrameAround(light.Normal);
  const double angle = degrees * Pi / 180.0;
  return light.Center +
    distance *
    (std::cos(angle) * light.Normal +
      std::sin(angle) * (std::cos(azimuth) * frame.U + std::sin(azimuth) * frame.V));
}

double MeanWeight(const Light& light, const Vector3& from, LightSampling sampling, std::uint32_t count = 1u << 14)
{
  double sum = 0.0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const auto s = SobolPoint(11, i);
    sum += SampleIncidentLight(light, from, s[0], s[1], sampling).Weight;
  }
  return sum / count;
}

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

void ExpectSolidAngleRoundTrip(const Light& light, const Vector3& from, double tolerance)
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

//------------------------------------------------------------------------------
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

TEST(Light, ARectangleWithoutAnAreaIsNotSeen)
{
  Light light = Rectangle();
  light.AxisU = {};
  EXPECT_EQ(LightSolidAngle(light, light.Center + light.Normal), 0.0);
  EXPECT_EQ(SampleLightSolidAngle(light, light.Center + light.Normal, 0.1, 0.2).Pdf, 0.0);
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
