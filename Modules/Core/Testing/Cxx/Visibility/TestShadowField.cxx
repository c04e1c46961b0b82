// SPDX-License-Identifier: BSD-3-Clause
// What of space is in penumbra and in umbra: against closed forms, and gaps that light passes.
#include "TestCones.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scConvexGap.h"
#include "scInnerConeProof.h"
#include "scProjectedShadow.h"
#include "scReference.h"
#include "scShadowField.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// Radii of umbra and penumbra at a depth z behind a disc r at L, under a coaxial disc light R at 0: closed form 1 of the guide.
double UmbraRadius(double R, double r, double L, double z)
{
  return r - (R - r) * (z - L) / L;
}
double PenumbraRadius(double R, double r, double L, double z)
{
  return r + (R + r) * (z - L) / L;
}

double VolumeOf(const ProjectedShadow& shadow)
{
  double volume = 0.0;
  for (const auto& t : shadow.Triangles)
  {
    volume += Dot(shadow.Points[t[0]], Cross(shadow.Points[t[1]], shadow.Points[t[2]])) / 6.0;
  }
  return volume;
}

ProjectedShadow Project(const TestMesh& mesh, const Light& light, const Box& bounds)
{
  ProjectedShadow shadow;
  std::string error;
  EXPECT_TRUE(ProjectShadow(mesh.View(), light, bounds, shadow, error)) << error;
  return shadow;
}

InnerConeProof Prove(const TestMesh& mesh, const Light& light, const std::vector<Cone>& cones)
{
  const OccluderScene scene(mesh.View());
  InnerConeProof proof;
  EXPECT_TRUE(ProveInnerCones(scene, { light }, cones, {}, proof));
  return proof;
}

/// A cone across z whose inner one is what its base disc alone hides of a hard Sun.
Cone DownCone(const Vector3& center, double radius)
{
  Cone cone = MakeCone(center, { 0.0, 0.0, -1.0 }, radius, 0.0, 0);
  cone.InnerHalfAngle = 0.0;
  return cone;
}
} // namespace

TEST(ConvexGap, BoxesAndTriangles)
{
  // A gap along a diagonal, which no axis of the world shows.
  const BoxBody box(Box{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } });
  const auto triangle = [](double s) {
    return PointHull<3>{ { Vector3{ s, 0.0, 0.0 }, { 0.0, s, 0.0 }, { 0.0, 0.0, s } } };
  };
  EXPECT_TRUE(AreApart(box, triangle(3.001)));
  EXPECT_FALSE(AreApart(box, triangle(2.999)));
  EXPECT_FALSE(AreApart(box, triangle(0.5)));
  // Random pairs of triangles: a plane between them, or a common point, by construction.
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto point = [&] { return Vector3{ uniform(random), uniform(random), uniform(random) }; };
  for (int k = 0; k < 2000; ++k)
  {
    const Vector3 normal = Normalized(point());
    const auto onSide = [&](double side)
    {
      const Vector3 p = point();
      const double height = Dot(p, normal);
      return p + (side * (std::fabs(height) + 1e-6) - height) * normal;
    };
    const PointHull<3> above{ { onSide(1.0), onSide(1.0), onSide(1.0) } };
    const PointHull<3> below{ { onSide(-1.0), onSide(-1.0), onSide(-1.0) } };
    EXPECT_TRUE(AreApart(above, below)) << k;
    // Turned so that it passes through the middle of the other one.
    const Vector3 middle = (1.0 / 3.0) * (above.Points[0] + above.Points[1] + above.Points[2]);
    const Vector3 u = point();
    const Vector3 v = point();
    const PointHull<3> through{ { middle + u, middle + v, middle - u - v } };
    EXPECT_FALSE(AreApart(above, through)) << k;
  }
}

TEST(ShadowField, DiscBehindDisc)
{
  for (const double R : { 0.2, 0.5 })
  {
    const double r = 0.3;
    const double L = 2.0;
    TestMesh mesh;
    mesh.AddDisc({ 0.0, 0.0, L }, r, 512);
    const OccluderScene scene(mesh.View());
    const Light light = DiscLight({}, { 0.0, 0.0, 1.0 }, R);
    const ShadowField field(scene, light, 64);
    for (const double z : { 2.2, 2.5, 3.0 })
    {
      const double penumbra = PenumbraRadius(R, r, L, z);
      const double umbra = UmbraRadius(R, r, L, z);
      for (int k = 0; k < 24; ++k)
      {
        const double angle = 0.1 + 2.0 * Pi * k / 24;
        const auto at = [&](double radius) { return Vector3{ radius * std::cos(angle), radius * std::sin(angle), z }; };
        // The outer bound is of the light's own shape; the inner one of a polygon around it, half a per cent wider.
        EXPECT_TRUE(field.Contains(at(0.9995 * penumbra), ShadowBound::Outer));
        EXPECT_FALSE(field.Contains(at(1.0005 * penumbra), ShadowBound::Outer));
        EXPECT_FALSE(field.Contains(at(umbra + 0.001), ShadowBound::Inner));
        EXPECT_TRUE(umbra < 0.02 || field.Contains(at(umbra - 0.006 * R - 0.001), ShadowBound::Inner));
      }
    }
    EXPECT_FALSE(field.Contains({ 0.0, 0.0, 1.5 }, ShadowBound::Outer));  // before it
    EXPECT_FALSE(field.Contains({ 0.0, 0.0, -3.0 }, ShadowBound::Outer)); // the light does not shine there
  }
}

TEST(ShadowField, SquareBehindASquareLampOfTriangles)
{
  // The same closed forms along an axis of both squares, whatever triangles the lamp is cut into: 2; more than are looked at one by one; and
  // so many that the outer bound is that of the ball around the lamp.
  const double R = 0.5;
  const double r = 0.3;
  const double L = 2.0;
  TestMesh mesh;
  mesh.AddSheet({ -r, -r, L }, { 2.0 * r, 0.0, 0.0 }, { 0.0, 2.0 * r, 0.0 });
  const OccluderScene scene(mesh.View());
  for (const int parts : { 1, 7, 20 })
  {
    Light light;
    light.Shape = LightShape::Mesh;
    const double side = 2.0 * R / parts;
    for (int k = 0; k < parts * parts; ++k)
    {
      const Vector3 a{ -R + side * (k % parts), -R + side * (k / parts), 0.0 };
      const Vector3 b = a + Vector3{ side, 0.0, 0.0 };
      const Vector3 c = a + Vector3{ side, side, 0.0 };
      light.Triangles.push_back({ a, b, c });
      light.Triangles.push_back({ a, c, a + Vector3{ 0.0, side, 0.0 } });
    }
    light = Prepared(light);
    const ShadowField field(scene, light, 64);
    for (const double z : { 2.2, 2.5, 3.0 })
    {
      const double penumbra = PenumbraRadius(R, r, L, z);
      const double umbra = UmbraRadius(R, r, L, z);
      for (const double turn : { 1.0, -1.0 })
      {
        EXPECT_TRUE(field.Contains({ turn * 0.9995 * penumbra, 0.03, z }, ShadowBound::Outer)) << parts;
        EXPECT_EQ(field.Contains({ 0.03, turn * 1.0005 * penumbra, z }, ShadowBound::Outer), parts == 20) << parts;
        EXPECT_TRUE(umbra < 0.002 || field.Contains({ turn * (umbra - 0.001), 0.0, z }, ShadowBound::Inner)) << parts;
        EXPECT_FALSE(field.Contains({ 0.0, turn * (umbra + 0.001), z }, ShadowBound::Inner)) << parts;
      }
    }
    EXPECT_FALSE(field.Contains({ 0.0, 0.0, -3.0 }, ShadowBound::Outer)) << "the lamp does not shine there";
  }
}

TEST(ShadowField, OuterBoundSeesWhatIsSmallerThanAnySample)
{
  // A speck that hides a millionth of the light.
  TestMesh mesh;
  mesh.AddSheet({ 0.1, 0.1, 1.0 }, { 1e-3, 0.0, 0.0 }, { 0.0, 1e-3, 0.0 });
  const OccluderScene scene(mesh.View());
  for (const Light& light :
    { DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5), SphereLight({ 0.0, 0.0, 2.0 }, 0.5),
      SunLight({ 0.0, 0.0, -1.0 }, 0.4), RectangleLight({ 0.0, 0.0, 2.0 }, { 0.5, 0.0, 0.0 }, { 0.0, -0.5, 0.0 }) })
  {
    const ShadowField field(scene, light, 64);
    EXPECT_TRUE(field.Contains({ 0.2, 0.2, 0.0 }, ShadowBound::Outer));
    EXPECT_FALSE(field.Contains({ 0.2, 0.2, 0.0 }, ShadowBound::Inner));
    EXPECT_FALSE(field.Contains({ 3.0, 0.2, 0.0 }, ShadowBound::Outer));
  }
}

TEST(ShadowField, BlocksAndPointsAgree)
{
  // What blocks decide as a whole is what each of their points sees, by plain rays.
  TestMesh mesh;
  mesh.AddSphere({ 0.1, 0.0, 1.0 }, 0.4, 12);
  mesh.AddSheet({ -1.0, -1.0, 0.5 }, { 0.8, 0.0, 0.1 }, { 0.0, 2.0, 0.0 });
  const ReferenceScene reference(mesh.View());
  const OccluderScene scene(mesh.View());
  const Light light = PointLight({ 0.2, 0.1, 3.0 });
  const ShadowField field(scene, light, 16);
  const RegularGrid grid = GridOver({ { -1.7, -1.6, -1.0 }, { 1.5, 1.6, 1.6 } }, 40);
  std::vector<unsigned char> inside(static_cast<std::size_t>(grid.NumberOfPoints()));
  ASSERT_TRUE(field.Classify(grid, ShadowBound::Outer, {}, inside.data()));
  int hidden = 0;
  for (int k = 1; k + 1 < grid.Dimensions[2]; ++k)
  {
    for (int j = 1; j + 1 < grid.Dimensions[1]; ++j)
    {
      for (int i = 1; i + 1 < grid.Dimensions[0]; ++i)
      {
        const Vector3 place = grid.Point(i, j, k);
        const Vector3 to = light.Center - place;
        const bool blocked = reference.Blocked(place, Normalized(to), 0.0, Length(to));
        const vtkIdType id = i + grid.Dimensions[0] * (j + static_cast<vtkIdType>(grid.Dimensions[1]) * k);
        ASSERT_EQ(inside[id] != 0, blocked) << i << " " << j << " " << k;
        hidden += blocked ? 1 : 0;
      }
    }
  }
  EXPECT_GT(hidden, 5000);
}

TEST(ShadowField, LightBetweenPointsOfTheGridIsSeen)
{
  // A slit of a quarter of a cell, in the middle between two rows of the grid.
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 1.0 }, { 0.995, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  mesh.AddSheet({ 0.005, -1.0, 1.0 }, { 0.995, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  const OccluderScene scene(mesh.View());
  const ShadowField field(scene, SunLight({ 0.0, 0.0, -1.0 }, 0.0), 1);
  const RegularGrid grid = GridOver({ { -0.8, -0.8, 0.0 }, { 0.8, 0.8, 0.8 } }, 40);
  std::vector<unsigned char> inside(static_cast<std::size_t>(grid.NumberOfPoints()));
  ASSERT_TRUE(field.Classify(grid, ShadowBound::Inner, {}, inside.data()));
  const auto at = [&](int i)
  { return inside[i + grid.Dimensions[0] * (10 + static_cast<vtkIdType>(grid.Dimensions[1]) * 10)]; };
  EXPECT_NE(at(19), 0);
  EXPECT_EQ(at(20), 0); // its neighbour 21 is in shadow too, and the slit between them is not
  EXPECT_NE(at(21), 0);
}

TEST(ProjectedShadow, BoxUnderASlantedSun)
{
  TestMesh mesh;
  mesh.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 10.0, 20.0 });
  const Light sun = SunLight(Normalized({ 1.0, 0.0, -1.0 }), 0.0);
  const ProjectedShadow shadow = Project(mesh, sun, { { 10.0, -5.0, 0.0 }, { 45.0, 15.0, 20.0 } });
  EXPECT_NEAR(VolumeOf(shadow), 2000.0, 1e-8); // a prism over half a square of side 20
  EXPECT_EQ(shadow.NumberOfSolids, 1);
  // With the house itself.
  EXPECT_NEAR(VolumeOf(Project(mesh, sun, { { -5.0, -5.0, 0.0 }, { 45.0, 15.0, 30.0 } })), 4000.0, 1e-8);
}

TEST(ProjectedShadow, SquareUnderAPoint)
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 2.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  const Light lamp = PointLight({ 0.0, 0.0, 4.0 });
  // A frustum of a pyramid from area 4 to area 16 over a height of 2.
  const double frustum = 2.0 / 3.0 * (4.0 + 16.0 + std::sqrt(4.0 * 16.0));
  EXPECT_NEAR(VolumeOf(Project(mesh, lamp, { { -9.0, -9.0, 0.0 }, { 9.0, 9.0, 5.0 } })), frustum, 1e-10);
  // Wound the other way, and cut through the middle.
  std::swap(mesh.Triangles[0], mesh.Triangles[1]);
  std::swap(mesh.Triangles[3], mesh.Triangles[4]);
  EXPECT_NEAR(VolumeOf(Project(mesh, lamp, { { 0.0, -9.0, 0.0 }, { 9.0, 9.0, 5.0 } })), 0.5 * frustum, 1e-10);
  // Edge-on it casts nothing.
  EXPECT_EQ(Project(mesh, PointLight({ 4.0, 0.0, 2.0 }), { { -9.0, -9.0, 0.0 }, { 9.0, 9.0, 5.0 } }).NumberOfSolids, 0);
}

TEST(ProjectedShadow, WhatIsNotConvexIsRefused)
{
  TestMesh ring;
  ring.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  ring.Points[3 * 7] = 0.4; // a corner pushed in
  ring.Points[3 * 7 + 1] = 0.4;
  ring.Points[3 * 7 + 2] = 0.4;
  ProjectedShadow shadow;
  std::string error;
  EXPECT_FALSE(ProjectShadow(
    ring.View(), PointLight({ 0.0, 0.0, 5.0 }), { { -3.0, -3.0, -3.0 }, { 3.0, 3.0, 3.0 } }, shadow, error));
  EXPECT_NE(error.find("neither a closed convex body"), std::string::npos) << error;
  TestMesh box;
  box.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  EXPECT_FALSE(ProjectShadow(
    box.View(), PointLight({ 0.5, 0.5, 0.5 }), { { -3.0, -3.0, -3.0 }, { 3.0, 3.0, 3.0 } }, shadow, error));
  EXPECT_NE(error.find("has the light inside"), std::string::npos) << error;
}

TEST(InnerConeProof, DiscsOnASquare)
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  const Light sun = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  const InnerConeProof proof = Prove(mesh, sun,
    { DownCone({ 0.0, 0.0, 0.0 }, 0.99), DownCone({ 0.5, 0.0, 0.0 }, 0.8), DownCone({ 1.5, 0.0, 0.0 }, 0.4) });
  EXPECT_EQ(proof.Whole, 1);
  EXPECT_EQ(proof.Shrunk, 1);  // to the edge
  EXPECT_EQ(proof.Dropped, 1); // beside it
  ASSERT_EQ(proof.Cones.size(), 2u);
  EXPECT_NEAR(proof.Cones[0].BaseRadius, 0.99, 1e-9);
  EXPECT_NEAR(proof.Cones[1].BaseRadius, 0.5, 0.02);
  EXPECT_LE(proof.Cones[1].BaseRadius, 0.5);
  EXPECT_LT(proof.Cones[1].Center.Z, 0.0);
}

TEST(InnerConeProof, SoftLightNeedsMoreOfTheFaceThanTheDisc)
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  Cone cone = DownCone({ 0.0, 0.0, -0.5 }, 0.9); // half a unit behind the face
  const double spread = 0.2;
  cone.InnerHalfAngle = cone.HalfAngle = -spread;
  const InnerConeProof proof = Prove(mesh, SunLight({ 0.0, 0.0, -1.0 }, spread), { cone });
  ASSERT_EQ(proof.Cones.size(), 1u);
  const Cone& proved = proof.Cones[0];
  // From the disc's rim the Sun is seen through the face while radius + depth tan(spread) is at most 1.
  EXPECT_LE(proved.BaseRadius - proved.Center.Z * std::tan(spread), 1.0);
  EXPECT_GT(proved.BaseRadius - proved.Center.Z * std::tan(spread), 0.95);
  EXPECT_NEAR(proved.InnerHalfAngle, -spread, 1e-9);
}

TEST(InnerConeProof, HolesAndBends)
{
  // A sheet with a hole of 0.2: a disc over it is dropped. A roof of two faces that both turn to the light is one.
  TestMesh holed;
  const double hole = 0.1;
  const double x[4] = { -1.0, -hole, hole, 1.0 };
  for (int i = 0; i < 16; ++i)
  {
    holed.AddPoint({ x[i % 4], x[i / 4], 0.0 });
  }
  for (int i = 0; i < 9; ++i)
  {
    const vtkIdType a = i % 3 + 4 * (i / 3);
    if (i != 4)
    {
      holed.AddTriangle(a, a + 1, a + 5, 0);
      holed.AddTriangle(a, a + 5, a + 4, 0);
    }
  }
  const Light sun = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  EXPECT_EQ(Prove(holed, sun, { DownCone({}, 0.9) }).Dropped, 1);
  const InnerConeProof beside = Prove(holed, sun, { DownCone({ 0.5, 0.0, 0.0 }, 0.5) });
  ASSERT_EQ(beside.Cones.size(), 1u);
  EXPECT_NEAR(beside.Cones[0].BaseRadius, 0.4, 0.02);

  TestMesh roof;
  for (const double side : { -1.0, 0.0, 1.0 })
  {
    roof.AddPoint({ side, -1.0, -0.3 * std::fabs(side) });
    roof.AddPoint({ side, 1.0, -0.3 * std::fabs(side) });
  }
  for (const vtkIdType a : { 0, 2 })
  {
    roof.AddTriangle(a, a + 2, a + 3, 0);
    roof.AddTriangle(a, a + 3, a + 1, 0);
  }
  const InnerConeProof over = Prove(roof, sun, { DownCone({ 0.0, 0.0, 0.0 }, 0.9) });
  ASSERT_EQ(over.Cones.size(), 1u);
  EXPECT_NEAR(over.Cones[0].BaseRadius, 0.9, 1e-6);
}
