// SPDX-License-Identifier: BSD-3-Clause
// The probe under the whole sky, on surfaces in single precision, and under a lamp that is flush with a ceiling.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scVisibilityProbe.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// One cone that holds all points near the origin, so that rays are asked for everywhere.
std::vector<Cone> Everywhere()
{
  Cone cone;
  cone.Center = { 0.0, 0.0, 1000.0 };
  cone.Axis = { 0.0, 0.0, -1.0 };
  cone.Normal = cone.Axis;
  cone.BaseRadius = 1000.0;
  return { cone };
}

const Box nearby{ { -100.0, -100.0, -100.0 }, { 100.0, 100.0, 100.0 } };

} // namespace

TEST(VisibilityProbe, AWallUnderTheWholeSkyHidesItsSolidAngle)
{
  // From the middle of its foot, a wall of 2 x 2 at distance 1: twice atan(a b / (d sqrt(a^2 + b^2 + d^2))), a = 1, b = 2.
  TestMesh wall;
  wall.AddSheet({ -1.0, 1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }, 0);
  const OccluderScene scene(wall.View());
  const Light sky = SunLight({ 0.0, 0.0, -1.0 }, 0.5 * Pi);
  VisibilityOptions options;
  options.NumberOfLightSamples = 16384;
  const VisibilityProbe probe(Everywhere(), sky, &scene, nearby, options);
  const double solidAngle = 2.0 * std::atan(2.0 / std::sqrt(6.0));
  EXPECT_NEAR(probe.At({}).Fraction, 1.0 - solidAngle / (2.0 * Pi), 2e-3);
}

TEST(VisibilityProbe, ASurfaceInSinglePrecisionCastsNoShadowOnItself)
{
  // Points of a turned floor far from the origin, rounded to single precision like its corners: on it, up to rounding.
  TestMesh mesh;
  const auto turned = [](double x, double y, double z)
  {
    const Vector3 p{ 300.0 + 0.8 * x - 0.6 * z, 700.0 + y, 0.6 * x + 0.8 * z };
    return Vector3{ static_cast<float>(p.X), static_cast<float>(p.Y), static_cast<float>(p.Z) };
  };
  const vtkIdType a = mesh.AddPoint(turned(-3.0, -3.0, 0.0));
  mesh.AddPoint(turned(3.0, -3.0, 0.0));
  mesh.AddPoint(turned(3.0, 3.0, 0.0));
  mesh.AddTriangle(a, a + 1, a + 2, 0);
  // A roof 0.05 above one half hides all of the light there.
  const vtkIdType b = mesh.AddPoint(turned(-3.0, -3.0, 0.05));
  mesh.AddPoint(turned(3.0, -3.0, 0.05));
  mesh.AddPoint(turned(3.0, 0.0, 0.05));
  mesh.AddTriangle(b, b + 1, b + 2, 1);
  const OccluderScene scene(mesh.View());
  const Light light = SunLight(Normalized({ 0.6, 0.0, -0.8 }), 0.001);
  VisibilityOptions options;
  options.NumberOfLightSamples = 4;
  Cone cone = Everywhere()[0];
  cone.Center = { 300.0, 700.0, 1000.0 };
  const VisibilityProbe probe({ cone }, light, &scene, { { 0.0, 0.0, -100.0 }, { 1000.0, 1000.0, 100.0 } }, options);
  for (int i = 0; i < 20; ++i)
  {
    const double x = 2.9 - 0.1 * i;
    EXPECT_EQ(probe.At(turned(x, x - 0.1, 0.0)).Fraction, 1.0) << x;
    EXPECT_EQ(probe.At(turned(x, 0.5 * x - 1.6, 0.0)).Fraction, 0.0) << x;
  }
}

TEST(VisibilityProbe, ALampFlushWithACeilingIsSeenFromEverywhere)
{
  for (const double turn : { 0.0, 0.4 })
  {
    const auto turned = [turn](double x, double y, double z)
    { return Vector3{ x, std::cos(turn) * y - std::sin(turn) * z, std::sin(turn) * y + std::cos(turn) * z }; };
    TestMesh mesh;
    mesh.AddSheet(turned(-50.0, -50.0, 5.5), turned(100.0, 0.0, 0.0), turned(0.0, 100.0, 0.0), 0);
    const OccluderScene scene(mesh.View());
    const Light lamp = DiscLight(turned(0.013, 0.027, 5.5), turned(0.0, 0.0, -1.0), 0.3);
    VisibilityOptions options;
    options.NumberOfLightSamples = 16;
    const VisibilityProbe probe(Everywhere(), lamp, &scene, nearby, options);
    for (int i = 1; i <= 40; ++i)
    {
      const double depth = std::pow(10.0, -0.15 * i);
      EXPECT_EQ(probe.At(turned(40.0 - 2.0 * i, i, 5.5 - depth)).Fraction, 1.0) << depth;
    }
  }
}
