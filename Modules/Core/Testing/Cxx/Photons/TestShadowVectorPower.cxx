// SPDX-License-Identifier: BSD-3-Clause
// The power that photons carry: form factors, solid angles and projected areas in closed form.
#include "PhotonTesting.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace shadowcones;
using namespace testsupport;
using namespace photontesting;

namespace
{

double Sum(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double BlockedPower(const PhotonPaths& paths)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < paths.Powers.size(); ++i)
  {
    sum += paths.States[i] ? paths.Powers[i] : 0.0;
  }
  return sum;
}

/// Cosine-weighted solid angle over a polygon seen from the origin, times the normal: Lambert's formula.
double Irradiance(const std::vector<Vector3>& corners, const Vector3& normal)
{
  Vector3 sum;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3 a = Normalized(corners[i]);
    const Vector3 b = Normalized(corners[(i + 1) % corners.size()]);
    const Vector3 edge = Cross(a, b);
    sum += std::atan2(Length(edge), Dot(a, b)) * Normalized(edge);
  }
  return 0.5 * std::abs(Dot(sum, normal));
}

/// Directions within a sheet x, y in [-half, half] at z = 0 from a point above it.
std::vector<Vector3> SheetSeenFrom(const Vector3& point, double half)
{
  return { Vector3{ -half, -half, 0.0 } - point, Vector3{ half, -half, 0.0 } - point,
    Vector3{ half, half, 0.0 } - point, Vector3{ -half, half, 0.0 } - point };
}

} // namespace

TEST(ShadowVectorPower, RectangleOverRectangleIsTheFormFactor)
{
  // Opposed equal squares, 2 by 2, 1 apart: the textbook form factor.
  const double x = 2.0;
  const double y = 2.0;
  const double xx = 1.0 + x * x;
  const double yy = 1.0 + y * y;
  const double factor = 2.0 / (Pi * x * y) *
    (std::log(std::sqrt(xx * yy / (1.0 + x * x + y * y))) + x * std::sqrt(yy) * std::atan(x / std::sqrt(yy)) +
      y * std::sqrt(xx) * std::atan(y / std::sqrt(xx)) - x * std::atan(x) - y * std::atan(y));
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = { 0.0, 0.0, 1.0 };
  light.Normal = { 0.0, 0.0, -1.0 };
  light.AxisU = { 1.0, 0.0, 0.0 };
  light.AxisV = { 0.0, -1.0, 0.0 };
  light.Spectrum.assign(7, 3.0);
  light = Prepared(light);
  const ShadowVectorResult result = Trace(Sheet(1.0), light, Photons(40000));
  const double flux = 3.0 * Pi * 4.0 * factor;
  EXPECT_NEAR(BlockedPower(result.Paths), flux, 2e-3 * flux);
  // Photons are aimed at the bounds, which the sheet fills but for its margin.
  EXPECT_NEAR(Sum(result.Paths.Powers), flux, 4e-3 * flux);
  EXPECT_GE(Sum(result.Paths.Powers), BlockedPower(result.Paths));
}

TEST(ShadowVectorPower, DiscOverSquareIsTheIntegralOverTheDisc)
{
  const double radius = 0.8;
  const double height = 1.5;
  const double half = 0.6;
  // Midpoints of rings and sectors; the integrand is smooth.
  double flux = 0.0;
  const int rings = 60;
  const int sectors = 120;
  for (int i = 0; i < rings; ++i)
  {
    for (int k = 0; k < sectors; ++k)
    {
      const double r = radius * (i + 0.5) / rings;
      const double phi = 2.0 * Pi * (k + 0.5) / sectors;
      const Vector3 point{ 0.3 + r * std::cos(phi), r * std::sin(phi), height };
      const double area = r * (radius / rings) * (2.0 * Pi / sectors);
      flux += area * Irradiance(SheetSeenFrom(point, half), { 0.0, 0.0, 1.0 });
    }
  }
  const ShadowVectorResult result =
    Trace(Sheet(half), DiscLight({ 0.3, 0.0, height }, { 0.0, 0.0, -1.0 }, radius), Photons(40000));
  EXPECT_NEAR(BlockedPower(result.Paths), flux, 2e-3 * flux);
}

TEST(ShadowVectorPower, IsTheMeanOverTheSpectrum)
{
  Light light = DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const double one = Sum(Trace(Sheet(1.0), light, Photons(1000)).Paths.Powers);
  light.Spectrum = { 1.0, 2.0, 6.0 };
  EXPECT_NEAR(Sum(Trace(Sheet(1.0), light, Photons(1000)).Paths.Powers), 3.0 * one, 1e-4 * one);
  light.Spectrum = { 0.0, 0.0 };
  EXPECT_EQ(
    Trace(Sheet(1.0), light, Photons(1000)).Vectors.OccluderIds.size(), 0u); // a light that is off casts no shadow
}

TEST(ShadowVectorPower, PointLightIsIntensityTimesSolidAngle)
{
  // A square of half width a at distance h under a point light.
  const double a = 0.7;
  const double h = 1.3;
  const double solidAngle = 4.0 * std::asin(a * a / (a * a + h * h));
  const ShadowVectorResult result = Trace(Sheet(a), PointLight({ 0.0, 0.0, h }), Photons(20000));
  EXPECT_NEAR(BlockedPower(result.Paths), solidAngle, 2e-3 * solidAngle);
  EXPECT_NEAR(result.MeanSolidAngle, solidAngle, 5e-3 * solidAngle);
}

TEST(ShadowVectorPower, SunIsIrradianceTimesProjectedArea)
{
  // Spectrum of a Sun is the irradiance of a plane that faces it; at 30 degrees a 2 x 2 sheet catches half of 4.
  for (const double angular : { 0.0, 0.00465, 0.05 })
  {
    const Light sun = SunLight({ std::cos(Pi / 6.0), 0.0, -std::sin(Pi / 6.0) }, angular);
    const ShadowVectorResult result = Trace(Sheet(1.0), sun, Photons(40000));
    EXPECT_NEAR(BlockedPower(result.Paths), 2.0, 0.01) << angular;
    double widest = 0.0;
    for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
    {
      const Vector3 d = At(result.Paths.Directions, i);
      widest = std::max(widest, std::atan2(Length(Cross(d, sun.Normal)), Dot(d, sun.Normal)));
    }
    EXPECT_NEAR(widest, angular, 1e-3 * angular + 1e-6);
  }
}

TEST(ShadowVectorPower, SphereLightOverASheetIsThatOfAPoint)
{
  // Outside a Lambertian sphere every direction sees pi R^2 of radiance: an intensity of pi R^2, whatever the direction. For
  // a sheet wholly below it the flux through it is that intensity's, because both are fields without divergence.
  const double radius = 0.4;
  const ShadowVectorResult result = Trace(Sheet(1.0), SphereLight({ 0.0, 0.0, 1.0 }, radius), Photons(60000));
  const double solidAngle = 4.0 * std::asin(1.0 / 2.0);
  EXPECT_NEAR(BlockedPower(result.Paths), Pi * radius * radius * solidAngle, 6e-3 * Pi * radius * radius * solidAngle);
}

TEST(ShadowVectorPower, ALightInsideTheBoundsSendsAllItsFlux)
{
  // Inside a closed room every photon is blocked: the whole flux of a Lambertian disc, pi times its area.
  TestMesh mesh;
  mesh.AddBox({ -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 }, 0);
  const ShadowVectorResult result = Trace(mesh, DiscLight({ 0.0, 0.0, 1.0 }, { 0.3, 0.1, -1.0 }, 0.5), Photons(5000));
  EXPECT_NEAR(BlockedPower(result.Paths), Pi * Pi * 0.25, 1e-4);
  EXPECT_EQ(BlockedPower(result.Paths), Sum(result.Paths.Powers));
}
