// SPDX-License-Identifier: BSD-3-Clause
// The visible fraction of the light against closed forms 1 to 4, at the origin, 1e6 away and 1e-3 small.
#include "ClosedForms.h"
#include "SampledVisibility.h"
#include "TestLights.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Tolerance = 0.005;

Light DiscLight(double radius, const Placement& place)
{
  return testsupport::DiscLight(place({}), { 0.0, 0.0, 1.0 }, radius * place.Scale, { 1.0 });
}
} // namespace

TEST(Visibility, DiscBehindDisc)
{
  const double R = 0.5;
  const double L = 2.0;
  for (const Placement& place : Placements())
  {
    const Light light = DiscLight(R, place);
    for (const double r : { 0.2, 0.5, 0.8 })
    {
      TestMesh mesh;
      mesh.AddDisc({ 0.0, 0.0, L }, r);
      mesh.Place(place);
      const OccluderScene scene(mesh.View());
      int partial = 0;
      for (const double z : { 2.5, 4.0, 8.0 })
      {
        for (int k = 0; k <= 10; ++k)
        {
          const double x = 0.12 * k * closedforms::DiscPenumbraRadius(R, r, L, z);
          const double expected = closedforms::DiscVisibility(R, r, L, z, x);
          partial += expected > 0.01 && expected < 0.99;
          EXPECT_NEAR(SampledVisibility(scene, light, place({ x, 0.0, z })), expected, Tolerance)
            << place.Name << ", r " << r << ", z " << z << ", x " << x;
        }
      }
      EXPECT_GE(partial, 10);
    }
  }
}

TEST(Visibility, ScrambledSobolPoints)
{
  const double R = 0.5;
  const double r = 0.3;
  const double L = 2.0;
  const Light light = DiscLight(R, Placements().front());
  TestMesh mesh;
  mesh.AddDisc({ 0.0, 0.0, L }, r);
  const OccluderScene scene(mesh.View());
  constexpr int scrambles = 32;
  for (const double x : { 0.0, 0.2, 0.4, 0.6, 0.9 })
  {
    const double expected = closedforms::DiscVisibility(R, r, L, 4.0, x);
    double mean = 0.0;
    double squares = 0.0;
    for (int seed = 0; seed < scrambles; ++seed)
    {
      const double difference = SobolVisibility(scene, light, { x, 0.0, 4.0 }, seed) - expected;
      mean += difference / scrambles;
      squares += difference * difference / scrambles;
    }
    EXPECT_LT(std::abs(mean), 0.001) << "x " << x;
    EXPECT_LT(std::sqrt(squares), 0.003) << "x " << x;
  }
}

TEST(Visibility, DiscUmbraAndPenumbraEdges)
{
  const double R = 0.5;
  const double r = 0.3;
  const double L = 2.0;
  const Placement place = Placements().front();
  const Light light = DiscLight(R, place);
  TestMesh mesh;
  mesh.AddDisc({ 0.0, 0.0, L }, r, 4096);
  const OccluderScene scene(mesh.View());

  EXPECT_DOUBLE_EQ(closedforms::DiscUmbraLength(R, r, L), 3.0);
  EXPECT_NEAR(closedforms::DiscUmbraRadius(R, r, L, L + 3.0), 0.0, 1e-15);
  const double z = 3.0;
  const double umbra = closedforms::DiscUmbraRadius(R, r, L, z);
  const double penumbra = closedforms::DiscPenumbraRadius(R, r, L, z);
  EXPECT_NEAR(penumbra, r + (z - L) * std::tan(closedforms::DiscPenumbraHalfAngle(R, r, L)), 1e-15);
  EXPECT_EQ(SampledVisibility(scene, light, { 0.99 * umbra, 0.0, z }), 0.0);
  EXPECT_GT(SampledVisibility(scene, light, { umbra + 0.05, 0.0, z }), 0.0);
  EXPECT_LT(SampledVisibility(scene, light, { penumbra - 0.05, 0.0, z }), 1.0);
  EXPECT_EQ(SampledVisibility(scene, light, { 1.01 * penumbra, 0.0, z }), 1.0);
  EXPECT_EQ(SampledVisibility(scene, light, { 0.0, 0.0, L + 2.9 }), 0.0);
  EXPECT_GT(SampledVisibility(scene, light, { 0.0, 0.0, L + 3.2 }), 0.0);
}

TEST(Visibility, PolygonsAsALightMatchTheRectangle)
{
  const double A = 0.6;
  const double B = 0.3;
  const double L = 2.0;
  TestMesh mesh;
  mesh.AddSheet({ -0.2, -0.2, L }, { 0.4, 0.0, 0.0 }, { 0.0, 0.4, 0.0 });
  const OccluderScene scene(mesh.View());
  Light light;
  light.Shape = LightShape::Mesh;
  light.Spectrum = { 1.0 };
  light.Triangles = { { Vector3{ -A, -B, 0.0 }, Vector3{ A, -B, 0.0 }, Vector3{ A, B, 0.0 } },
    { Vector3{ -A, -B, 0.0 }, Vector3{ A, B, 0.0 }, Vector3{ -A, B, 0.0 } } };
  ASSERT_EQ(PrepareLight(light), nullptr);
  EXPECT_NEAR(LightArea(light), 4.0 * A * B, 1e-12);
  for (int k = 0; k <= 8; ++k)
  {
    const double x = 0.2 * k;
    EXPECT_NEAR(SampledVisibility(scene, light, { x, 0.1, 4.0 }),
      closedforms::RectangleVisibility(A, B, 0.2, 0.2, L, x, 0.1, 4.0), Tolerance)
      << "x " << x;
  }
}

TEST(Visibility, SphereBehindSphere)
{
  const double R = 1.0;
  const double D = 6.0;
  for (const Placement& place : Placements())
  {
    const Light light = SphereLight(place({}), R * place.Scale, { 1.0 });
    for (const double r : { 0.4, 1.0, 1.5 })
    {
      TestMesh mesh;
      mesh.AddSphere({ 0.0, 0.0, D }, r);
      mesh.Place(place);
      const OccluderScene scene(mesh.View());
      int partial = 0;
      for (const double z : { 9.0, 14.0 })
      {
        for (int k = 0; k <= 8; ++k)
        {
          const Vector3 x{ 0.2 * k * r * z / D, 0.1 * k, z };
          const double expected = closedforms::SphereVisibility(R, r, { 0.0, 0.0, D }, x);
          partial += expected > 0.01 && expected < 0.99;
          EXPECT_NEAR(SampledVisibility(scene, light, place(x)), expected, Tolerance)
            << place.Name << ", r " << r << ", z " << z << ", k " << k;
        }
      }
      EXPECT_GE(partial, 4);
    }
  }
}

TEST(Visibility, SunBehindSphere)
{
  Light light;
  light.Shape = LightShape::Sun;
  light.Normal = { 0.0, 0.0, 1.0 };
  light.Radius = 0.5 * 0.533 * closedforms::Pi / 180.0;
  light.Spectrum = { 1.0 };
  ASSERT_EQ(PrepareLight(light), nullptr);
  const double r = 0.5;
  TestMesh mesh;
  mesh.AddSphere({}, r);
  const OccluderScene scene(mesh.View());
  for (const double distance : { 20.0, 200.0 })
  {
    for (int k = 0; k <= 8; ++k)
    {
      const Vector3 x{ r + (0.25 * k - 1.0) * distance * light.Radius, 0.0, distance };
      const double between = std::atan2(x.X, distance);
      const double sine = std::sin(0.5 * light.Radius);
      const double overlap = closedforms::CapOverlap(light.Radius, std::asin(r / Length(x)), between);
      EXPECT_NEAR(SampledVisibility(scene, light, x), 1.0 - overlap / (4.0 * closedforms::Pi * sine * sine), Tolerance)
        << "distance " << distance << ", k " << k;
    }
  }
}

TEST(Visibility, SunAndEarth)
{
  // Kilometres: radius of the Sun, mean radius of the Earth, one astronomical unit.
  const double R = 695700.0;
  const double r = 6371.0;
  const double D = 149597870.7;
  const double degrees = 180.0 / closedforms::Pi;
  EXPECT_NEAR(closedforms::SphereUmbraHalfAngle(R, r, D) * degrees, 0.2640, 5e-5);
  EXPECT_NEAR(closedforms::SpherePenumbraHalfAngle(R, r, D) * degrees, 0.2689, 5e-5);
  const double umbra = closedforms::SphereUmbraLength(R, r, D);
  EXPECT_NEAR(umbra, 1382632.0, 1.0);

  const Light light = SphereLight({}, R, { 1.0 });
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, D }, r);
  const OccluderScene scene(mesh.View());
  // On the axis the umbra ends at its tip; behind it the Sun is a ring.
  EXPECT_EQ(SampledVisibility(scene, light, { 0.0, 0.0, D + 0.98 * umbra }), 0.0);
  for (const double along : { 1.2, 2.0, 5.0 })
  {
    const Vector3 x{ 0.0, 0.0, D + along * umbra };
    EXPECT_NEAR(SampledVisibility(scene, light, x), closedforms::SphereVisibility(R, r, { 0.0, 0.0, D }, x), Tolerance);
  }
  // Where the Moon goes, 384,400 km behind the Earth, across the penumbra.
  for (int k = 0; k <= 10; ++k)
  {
    const Vector3 x{ 900.0 * k, 0.0, D + 384400.0 };
    EXPECT_NEAR(SampledVisibility(scene, light, x), closedforms::SphereVisibility(R, r, { 0.0, 0.0, D }, x), Tolerance)
      << 900 * k << " km off the axis";
  }
}

TEST(Visibility, RectangleBehindRectangle)
{
  const double A = 0.6;
  const double B = 0.3;
  const double L = 2.0;
  for (const Placement& place : Placements())
  {
    Light light;
    light.Shape = LightShape::Rectangle;
    light.Center = place({});
    light.Normal = { 0.0, 0.0, 1.0 };
    light.AxisU = { A * place.Scale, 0.0, 0.0 };
    light.AxisV = { 0.0, B * place.Scale, 0.0 };
    light.Spectrum = { 1.0 };
    ASSERT_EQ(PrepareLight(light), nullptr);
    const double a = 0.25;
    const double b = 0.4;
    TestMesh mesh;
    mesh.AddSheet({ -a, -b, L }, { 2.0 * a, 0.0, 0.0 }, { 0.0, 2.0 * b, 0.0 });
    mesh.Place(place);
    const OccluderScene scene(mesh.View());
    int partial = 0;
    for (const double z : { 3.0, 6.0 })
    {
      for (int k = 0; k <= 8; ++k)
      {
        const Vector3 x{ 0.15 * k * z / L, 0.1 * k, z };
        const double expected = closedforms::RectangleVisibility(A, B, a, b, L, x.X, x.Y, z);
        partial += expected > 0.01 && expected < 0.99;
        EXPECT_NEAR(SampledVisibility(scene, light, place(x)), expected, Tolerance)
          << place.Name << ", z " << z << ", k " << k;
      }
    }
    EXPECT_GE(partial, 6);
  }
}

TEST(Visibility, StraightEdge)
{
  const double R = 0.5;
  const double L = 2.0;
  for (const Placement& place : Placements())
  {
    const Light light = DiscLight(R, place);
    TestMesh mesh;
    mesh.AddSheet({ -50.0, -50.0, L }, { 50.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
    mesh.Place(place);
    const OccluderScene scene(mesh.View());
    for (const double z : { 2.2, 3.0, 6.0 })
    {
      const double width = R * (z - L) / L;
      for (int k = -6; k <= 6; ++k)
      {
        const double x = 0.2 * k * width;
        EXPECT_NEAR(
          SampledVisibility(scene, light, place({ x, 0.0, z })), closedforms::EdgeVisibility(R, L, z, x), Tolerance)
          << place.Name << ", z " << z << ", k " << k;
      }
    }
  }
}

TEST(Visibility, DarkSideOfADisc)
{
  const Light light = DiscLight(0.5, Placements().front());
  TestMesh mesh;
  mesh.AddDisc({ 0.0, 0.0, 2.0 }, 0.1);
  const OccluderScene scene(mesh.View());
  EXPECT_EQ(SampledVisibility(scene, light, { 0.0, 0.0, -1.0 }), 0.0);
}
