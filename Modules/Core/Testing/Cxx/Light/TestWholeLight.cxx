// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of what a whole light brings: configuration factors of the literature, and plain sums over its area.
#include "TestLights.h"
#include "scConstants.h"
#include "scLightSampling.h"
#include "scRandom.h"
#include "scWholeLight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// Howell's B-13: an element parallel to a disc of radius r at the height h, x beside its axis.
double ParallelToDisc(double r, double h, double x)
{
  const double H = h / x;
  const double R = r / x;
  const double Z = 1.0 + H * H + R * R;
  return 0.5 * (1.0 - (1.0 + H * H - R * R) / std::sqrt(Z * Z - 4.0 * R * R));
}

/// Howell's B-15: an element whose normal points at the disc's axis, in its plane of symmetry, and that sees all of it.
double AcrossDisc(double r, double h, double x)
{
  const double H = h / x;
  const double R = r / x;
  const double Z = 1.0 + H * H + R * R;
  return 0.5 * H * (Z / std::sqrt(Z * Z - 4.0 * R * R) - 1.0);
}

/// Howell's B-3: an element parallel to a rectangle a by b at the distance c, below one of its corners.
double ParallelToCorner(double a, double b, double c)
{
  const double A = a / c;
  const double B = b / c;
  return (A / std::sqrt(1.0 + A * A) * std::atan(B / std::sqrt(1.0 + A * A)) +
           B / std::sqrt(1.0 + B * B) * std::atan(A / std::sqrt(1.0 + B * B))) /
    (2.0 * Pi);
}

/// The cosine's integral as a plain sum over the light; the fluence where there is no normal.
double Summed(const Light& light, const Vector3& from, const Vector3* normal, int side = 700)
{
  double sum = 0.0;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const IncidentSample sample =
        SampleIncidentLight(light, from, (i + 0.5) / side, (j + 0.5) / side, LightSampling::Area);
      sum += sample.Weight * (normal ? std::max(Dot(*normal, sample.Direction), 0.0) : 1.0);
    }
  }
  return sum / (side * side);
}

Light TriangleLight()
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Triangles = { { Vector3{ -0.6, -0.4, 0.1 }, Vector3{ 0.1, 0.7, -0.1 }, Vector3{ 0.8, -0.3, 0.0 } } };
  return Prepared(light);
}

} // namespace

TEST(WholeLight, DiscsAndRectanglesAsInHowellsCatalogue)
{
  const Light disc = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.7);
  const Light panel = RectangleLight({ 1.0, 0.75, 2.0 }, { 1.0, 0.0, 0.0 }, { 0.0, -0.75, 0.0 });
  for (const double x : { 1e-3, 0.4, 2.0, 50.0 })
  {
    const Vector3 from{ x, 0.0, 0.0 };
    EXPECT_NEAR(WholeIrradiance(disc, from, { 0.0, 0.0, 1.0 }) / (Pi * ParallelToDisc(0.7, 3.0, x)), 1.0, 1e-8) << x;
    if (x > 0.7)
    {
      EXPECT_NEAR(WholeIrradiance(disc, from, { -1.0, 0.0, 0.0 }) / (Pi * AcrossDisc(0.7, 3.0, x)), 1.0, 1e-8) << x;
    }
  }
  EXPECT_NEAR(WholeIrradiance(panel, {}, { 0.0, 0.0, 1.0 }), Pi * ParallelToCorner(2.0, 1.5, 2.0), 1e-14);
  // On its axis the disc brings pi R^2 / (R^2 + h^2) and has the solid angle 2 pi (1 - cos).
  EXPECT_NEAR(WholeIrradiance(disc, {}, { 0.0, 0.0, 1.0 }), Pi * 0.49 / 9.49, 1e-14);
  EXPECT_NEAR(WholeFluence(disc, {}), TwoPi * (1.0 - 3.0 / std::sqrt(9.49)), 1e-12);
  EXPECT_EQ(WholeIrradiance(disc, { 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }), 0.0) << "its dark side";
  EXPECT_EQ(WholeIrradiance(disc, {}, { 0.0, 0.0, -1.0 }), 0.0) << "below the horizon";
}

TEST(WholeLight, SpheresSunsAndPoints)
{
  const Light ball = SphereLight({ 0.0, 0.0, 5.0 }, 2.0);
  const Vector3 leaning = Normalized({ 0.5, 0.2, 1.0 });
  EXPECT_NEAR(WholeIrradiance(ball, {}, leaning), Pi * 4.0 / 25.0 * leaning.Z, 1e-14);
  EXPECT_NEAR(WholeIrradiance(ball, {}, { 1.0, 0.0, 0.0 }), std::asin(0.4) - 0.4 * std::sqrt(1.0 - 0.16), 1e-14)
    << "half of it: the projection of half a cap";
  EXPECT_EQ(WholeIrradiance(ball, { 0.0, 0.0, 4.0 }, leaning), 0.0) << "inside";

  const double radius = 0.3;
  const Light sun = SunLight({ 0.0, 0.0, -1.0 }, radius);
  EXPECT_NEAR(WholeIrradiance(sun, {}, leaning), 0.5 * (1.0 + std::cos(radius)) * leaning.Z, 1e-14);
  EXPECT_EQ(WholeFluence(sun, {}), 1.0);
  const Light sky = SunLight({ 0.0, 0.0, -1.0 }, 0.5 * Pi);
  EXPECT_NEAR(WholeIrradiance(sky, {}, leaning), 0.25 * (1.0 + leaning.Z), 1e-12) << "a tilted plane under a sky";
  EXPECT_NEAR(WholeIrradiance(SunLight({ 0.0, 0.0, -1.0 }, 0.0), {}, leaning), leaning.Z, 1e-15);

  const Light point = PointLight({ 0.0, 0.0, 2.0 });
  EXPECT_NEAR(WholeIrradiance(point, {}, leaning), 0.25 * leaning.Z, 1e-15);
  EXPECT_NEAR(WholeFluence(point, {}), 0.25, 1e-15);
  Light vertices;
  vertices.Shape = LightShape::Mesh;
  vertices.Vertices = { { 0.0, 0.0, 2.0 }, { 3.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 } };
  vertices = Prepared(vertices);
  EXPECT_NEAR(WholeIrradiance(vertices, {}, { 0.0, 0.0, 1.0 }), 0.25 + 0.8 / 25.0, 1e-15);
  EXPECT_NEAR(WholeFluence(vertices, {}), 0.25 + 0.04 + 1.0, 1e-15);
}

TEST(WholeLight, IsThePlainSumWhereverTheHorizonCutsIt)
{
  const std::vector<Light> lights = { DiscLight({ 0.1, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, 0.8),
    RectangleLight({ 0.1, 0.0, 0.0 }, { 0.9, 0.0, 0.0 }, { 0.0, -0.5, 0.0 }), SphereLight({ 0.1, 0.0, 0.0 }, 0.5),
    TriangleLight(), SunLight(Normalized({ 0.3, 0.2, 1.0 }), 0.4) };
  RandomStream random(7, 0);
  for (const Light& light : lights)
  {
    for (int k = 0; k < 24; ++k)
    {
      const auto draw = [&random] { return 2.0 * random.Next() - 1.0; };
      const Vector3 from{ 1.5 * draw(), 1.5 * draw(), -0.8 - random.Next() };
      // Every third normal lies across the way to the light's middle, so that the horizon cuts it.
      Vector3 normal = Normalized({ draw(), draw(), draw() });
      const Vector3 axis = light.Shape == LightShape::Sun ? -light.Normal : Normalized(-from);
      normal = k % 3 == 0 ? Normalized(normal - 0.95 * Dot(normal, axis) * axis) : normal;
      EXPECT_NEAR(WholeIrradiance(light, from, normal), Summed(light, from, &normal), 2e-4)
        << static_cast<int>(light.Shape) << " " << k;
    }
  }
}

TEST(WholeLight, KeepsItsDigitsFarAway)
{
  // Cut by the horizon through its middle, a distant light's irradiance is that of half of it.
  for (const double distance : { 30.0, 3000.0, 30000.0 })
  {
    const Light disc = DiscLight({ distance, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, 1.0);
    // Half a disc: its first moment is 2/3.
    EXPECT_NEAR(WholeIrradiance(disc, {}, { 0.0, 0.0, 1.0 }) * std::pow(distance, 3) / (2.0 / 3.0), 1.0,
      2.0 / (distance * distance) + 1e-6)
      << distance;
    const Light panel = RectangleLight({ distance, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 });
    EXPECT_NEAR(
      WholeIrradiance(panel, {}, { 0.0, 0.0, 1.0 }) * std::pow(distance, 3), 1.0, 3.0 / (distance * distance) + 1e-6)
      << distance;
  }
}
