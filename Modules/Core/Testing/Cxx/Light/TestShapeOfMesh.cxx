// SPDX-License-Identifier: BSD-3-Clause
// Exact shapes against meshes that are theirs, or are not.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scFrame.h"
#include "scShapeOfMesh.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
using Triangles = std::vector<std::array<Vector3, 3>>;

constexpr double tolerance = 1e-9;

/// A fan of the sector from corner @p first to corner @p last of a regular polygon with @p count corners.
Triangles Fan(const Light& disc, int count, int first, int last)
{
  const Frame frame = FrameAround(disc.Normal);
  const auto corner = [&](int k)
  {
    const double angle = 2.0 * Pi * k / count;
    return disc.Center + disc.Radius * (std::cos(angle) * frame.U + std::sin(angle) * frame.V);
  };
  Triangles triangles;
  for (int k = first; k < last; ++k)
  {
    triangles.push_back({ disc.Center, corner(k), corner(k + 1) });
  }
  return triangles;
}

Triangles TrianglesOf(const TestMesh& mesh)
{
  Triangles triangles;
  const TriangleMeshView view = mesh.View();
  for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
  {
    triangles.push_back({ view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2) });
  }
  return triangles;
}

Light Panel(const Vector3& center, double halfWidth, double halfHeight)
{
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = center;
  light.Normal = { 0.0, 0.0, 1.0 };
  light.AxisU = { halfWidth, 0.0, 0.0 };
  light.AxisV = { 0.0, halfHeight, 0.0 };
  return Prepared(light);
}

Triangles Sheet(const Vector3& corner, const Vector3& u, const Vector3& v)
{
  TestMesh mesh;
  mesh.AddSheet(corner, u, v, 0);
  return TrianglesOf(mesh);
}

bool Fits(const Light& shape, const Triangles& triangles)
{
  return IsFit(shape, MisfitOf(shape, triangles, tolerance), tolerance);
}

Triangles Moved(Triangles triangles, double scale, const Vector3& by)
{
  for (auto& triangle : triangles)
  {
    for (Vector3& corner : triangle)
    {
      corner = scale * corner + by;
    }
  }
  return triangles;
}
} // anonymous namespace

TEST(ShapeOfMesh, DiscsFitPolygonsWithTheirCornersOnTheRim)
{
  const Light disc = DiscLight({ 1.0, 2.0, 3.0 }, { 1.0, -2.0, 0.5 }, 0.7);
  for (const int count : { 3, 4, 7, 24, 500 })
  {
    EXPECT_TRUE(Fits(disc, Fan(disc, count, 0, count))) << count;
  }
}

TEST(ShapeOfMesh, APartOfADiscIsNoDisc)
{
  const Light disc = DiscLight({ 1.0, 2.0, 3.0 }, { 1.0, -2.0, 0.5 }, 0.7);
  for (const int last : { 12, 16, 23 })
  {
    const ShapeMisfit misfit = MisfitOf(disc, Fan(disc, 24, 0, last), tolerance);
    EXPECT_LT(misfit.Distance, 1e-12);
    EXPECT_LT(misfit.Fraction, 0.99 * last / 23.0);
    EXPECT_FALSE(IsFit(disc, misfit, tolerance)) << last;
  }
  // Half of it: a fan of 12 of 24 corners has half of the polygon's area, 12 / 2 sin(15 deg) r^2, of pi r^2.
  const ShapeMisfit half = MisfitOf(disc, Fan(disc, 24, 0, 12), tolerance);
  EXPECT_NEAR(half.Fraction, 6.0 * std::sin(Pi / 12.0) / Pi, 1e-9);
}

TEST(ShapeOfMesh, TwoOfThemAreNoneOfThem)
{
  const Light a = DiscLight({ -3.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.2);
  const Light b = DiscLight({ 3.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.2);
  Triangles both = Fan(a, 24, 0, 24);
  const Triangles more = Fan(b, 24, 0, 24);
  both.insert(both.end(), more.begin(), more.end());
  EXPECT_NEAR(MisfitOf(a, both, tolerance).Distance, 6.0, 1e-9);
  EXPECT_FALSE(Fits(a, both));
  Light found = a;
  EXPECT_FALSE(FindShape(both, tolerance, found));
  // The same one twice lies where it should and shines twice.
  Triangles twice = Fan(a, 24, 0, 24);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 24);
  EXPECT_NEAR(MisfitOf(a, twice, tolerance).Fraction, 2.0, 1e-9);
  EXPECT_FALSE(Fits(a, twice));
  EXPECT_FALSE(FindShape(twice, tolerance, found));
}

TEST(ShapeOfMesh, InsideOutIsNoFit)
{
  const Light disc = DiscLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, 0.5);
  Triangles triangles = Fan(disc, 12, 0, 12);
  for (auto& triangle : triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_NEAR(MisfitOf(disc, triangles, tolerance).Fraction, -1.0, 1e-9);
  EXPECT_FALSE(Fits(disc, triangles));
}

TEST(ShapeOfMesh, RectanglesFitHoweverTheyAreCut)
{
  const Light panel = Panel({ 1.0, 1.0, 2.0 }, 2.0, 0.5);
  Triangles whole = Sheet({ -1.0, 0.5, 2.0 }, { 1.5, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  EXPECT_FALSE(Fits(panel, whole));
  const Triangles rest = Sheet({ 0.5, 0.5, 2.0 }, { 2.5, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  whole.insert(whole.end(), rest.begin(), rest.end());
  EXPECT_TRUE(Fits(panel, whole));
  EXPECT_FALSE(Fits(Panel({ 1.0, 1.0, 2.0 }, 2.0, 0.6), whole));
  EXPECT_FALSE(Fits(Panel({ 1.0, 1.0, 2.1 }, 2.0, 0.5), whole));
}

TEST(ShapeOfMesh, SpheresFitClosedMeshes)
{
  const Light sphere = SphereLight({ 1.0, -1.0, 0.5 }, 0.4);
  TestMesh mesh;
  mesh.AddSphere(sphere.Center, sphere.Radius, 5, 0);
  Triangles triangles = TrianglesOf(mesh);
  EXPECT_TRUE(Fits(sphere, triangles));
  EXPECT_FALSE(Fits(SphereLight({ 1.0, -1.0, 0.6 }, 0.4), triangles));
  triangles.resize(triangles.size() / 2);
  EXPECT_FALSE(Fits(sphere, triangles));
}

TEST(ShapeOfMesh, AMeshMovedAsAWholeTakesItsShapeAlong)
{
  Light disc = DiscLight({ 1.0, 2.0, 3.0 }, { 1.0, -2.0, 0.5 }, 0.7);
  const Triangles polygon = Fan(disc, 24, 0, 24);
  Triangles rim; // without the corner in the middle
  for (int k = 1; k < 23; ++k)
  {
    rim.push_back({ polygon[0][1], polygon[static_cast<std::size_t>(k)][1], polygon[static_cast<std::size_t>(k)][2] });
  }
  const Vector3 by{ -5.0, 0.0, 9.0 };
  ASSERT_TRUE(FindShape(Moved(rim, 2.0, by), tolerance, disc));
  EXPECT_LT(Length(disc.Center - (Vector3{ 2.0, 4.0, 6.0 } + by)), 1e-12);
  EXPECT_NEAR(disc.Radius, 1.4, 1e-12);
  EXPECT_LT(Length(disc.Normal - Normalized({ 1.0, -2.0, 0.5 })), 1e-12);

  Light panel = Panel({ 1.0, 1.0, 2.0 }, 2.0, 0.5);
  ASSERT_TRUE(FindShape(Sheet({ 0.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, { 0.0, 0.0, 3.0 }), tolerance, panel));
  EXPECT_LT(Length(panel.Normal - Vector3{ 1.0, 0.0, 0.0 }), 1e-12);
  EXPECT_NEAR(LightArea(panel), 6.0, 1e-12);

  Light sphere = SphereLight({}, 1.0);
  TestMesh mesh;
  mesh.AddSphere({ 3.0, 4.0, 5.0 }, 0.25, 6, 0);
  ASSERT_TRUE(FindShape(TrianglesOf(mesh), tolerance, sphere));
  EXPECT_LT(Length(sphere.Center - Vector3{ 3.0, 4.0, 5.0 }), 1e-12);
  EXPECT_NEAR(sphere.Radius, 0.25, 1e-12);
}

TEST(ShapeOfMesh, AStretchedMeshHasNoShape)
{
  Light panel = Panel({ 1.0, 1.0, 2.0 }, 2.0, 0.5);
  EXPECT_FALSE(FindShape(Sheet({}, { 2.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }), tolerance, panel));
  Light disc = DiscLight({}, { 0.0, 0.0, 1.0 }, 0.7);
  Triangles triangles = Fan(disc, 24, 0, 24);
  for (auto& triangle : triangles)
  {
    for (Vector3& corner : triangle)
    {
      corner.X *= 1.2;
    }
  }
  EXPECT_FALSE(FindShape(triangles, tolerance, disc));
}

TEST(ShapeOfMesh, FingerprintsTellLightsApartAndNotTheirBrightness)
{
  const Light disc = DiscLight({ 0.0, 2.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.7);
  Light dimmed = disc;
  dimmed.Spectrum.assign(3, 0.1);
  dimmed.AxisU = { 9.0, 9.0, 9.0 };
  EXPECT_EQ(FingerprintOf(dimmed), FingerprintOf(disc));
  EXPECT_EQ(FingerprintOf(DiscLight({ -0.0, 2.0, 3.0 }, { -0.0, 0.0, -1.0 }, 0.7)), FingerprintOf(disc));
  EXPECT_NE(FingerprintOf(DiscLight({ 0.0, 2.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.71)), FingerprintOf(disc));
  EXPECT_NE(FingerprintOf(DiscLight({ 0.0, 3.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.7)), FingerprintOf(disc));
  EXPECT_NE(FingerprintOf(SphereLight({ 0.0, 2.0, 3.0 }, 0.7)), FingerprintOf(disc));
  EXPECT_NE(FingerprintOf(SunLight({ 0.0, 0.0, -1.0 }, 0.01)), FingerprintOf(SunLight({ 0.0, 0.1, -1.0 }, 0.01)));
}
