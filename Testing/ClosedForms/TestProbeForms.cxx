// SPDX-License-Identifier: BSD-3-Clause
// The probe against closed forms 1 to 4, Exact and Soft, and the Earth's shadow: far away and under tiny angles.
#include "Chain.h"
#include "ClosedForms.h"
#include "TestMeshes.h"

#include "scShadowClass.h"
#include "scVisibilityProbe.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <memory>
#include <utility>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double ExactTolerance = 0.01;
constexpr double SoftTolerance = 0.02;

Light MakeLight(LightShape shape, double radius, const Placement& place)
{
  Light light;
  light.Shape = shape;
  light.Center = place({});
  light.Normal = { 0.0, 0.0, 1.0 };
  light.AxisU = { 0.6 * place.Scale, 0.0, 0.0 };
  light.AxisV = { 0.0, 0.3 * place.Scale, 0.0 };
  light.Radius = radius * place.Scale;
  light.Spectrum = { 1.0 };
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

Cone Disc(const Vector3& center, const Vector3& normal, double radius)
{
  Cone disc;
  disc.Center = center;
  disc.Normal = normal;
  disc.Axis = normal;
  disc.BaseRadius = radius;
  return disc;
}

/// Small discs that tile the part of the plane z = height where @p inside holds.
std::vector<Cone> Tiles(double height, const Box& box, const std::function<bool(double, double)>& inside)
{
  constexpr double step = 0.0125;
  std::vector<Cone> discs;
  for (double x = box.Min.X + 0.5 * step; x < box.Max.X; x += step)
  {
    for (double y = box.Min.Y + 0.5 * step; y < box.Max.Y; y += step)
    {
      if (inside(x, y))
      {
        discs.push_back(Disc({ x, y, height }, { 0.0, 0.0, 1.0 }, std::sqrt(0.5) * step));
      }
    }
  }
  return discs;
}

/// Small discs on a sphere, on a lattice with steps of the golden angle.
std::vector<Cone> TilesOfSphere(const Vector3& center, double radius)
{
  constexpr int count = 20000;
  std::vector<Cone> discs;
  for (int k = 0; k < count; ++k)
  {
    const double z = 1.0 - (2.0 * k + 1.0) / count;
    const double angle = 2.39996322972865332 * k;
    const double ring = std::sqrt(1.0 - z * z);
    const Vector3 normal{ ring * std::cos(angle), ring * std::sin(angle), z };
    discs.push_back(Disc(center + radius * normal, normal, 1.3 * radius * std::sqrt(4.0 / count)));
  }
  return discs;
}

/// Exact with bounds fitted to the mesh, Soft with the occluder finely sampled by discs, at the same points.
class Scene
{
public:
  Scene(TestMesh mesh, std::vector<Cone> discs, const Light& light, const Placement& place)
    : Mesh(std::move(mesh))
    , Source(light)
    , Place(place)
    , Discs(std::move(discs))
  {
    this->Mesh.Place(place);
    this->Occluders = std::make_unique<OccluderScene>(this->Mesh.View());
    this->Bounds = BoundingCones(*this->Occluders, light);
    for (Cone& disc : this->Discs)
    {
      disc.Center = place(disc.Center);
      disc.BaseRadius *= place.Scale;
    }
  }

  void Compare(const std::vector<Vector3>& points, const std::function<double(const Vector3&)>& closedForm)
  {
    Box box;
    for (const Vector3& point : points)
    {
      box.Add(this->Place(point));
    }
    VisibilityOptions options;
    options.NumberOfLightSamples = 1024;
    const VisibilityProbe exact(this->Bounds, this->Source, this->Occluders.get(), box, options);
    options.Method = VisibilityMethod::Soft;
    const VisibilityProbe soft(this->Discs, this->Source, nullptr, box, options);
    int partial = 0;
    for (const Vector3& point : points)
    {
      const double expected = closedForm(point);
      partial += expected > 0.01 && expected < 0.99;
      EXPECT_NEAR(exact.At(this->Place(point)).Fraction, expected, ExactTolerance)
        << this->Place.Name << " " << point.X << " " << point.Y << " " << point.Z;
      EXPECT_NEAR(soft.At(this->Place(point)).Fraction, expected, SoftTolerance)
        << "soft " << this->Place.Name << " " << point.X << " " << point.Y << " " << point.Z;
    }
    EXPECT_GT(partial, 8);
  }

private:
  TestMesh Mesh;
  Light Source;
  Placement Place;
  std::unique_ptr<OccluderScene> Occluders;
  std::vector<Cone> Discs;
  std::vector<Cone> Bounds;
};

std::vector<Vector3> Across(std::initializer_list<double> depths, const std::function<double(double)>& width)
{
  std::vector<Vector3> points;
  for (const double z : depths)
  {
    for (int k = 0; k <= 10; ++k)
    {
      points.push_back({ 0.12 * k * width(z), 0.0, z });
    }
  }
  return points;
}
} // namespace

TEST(ProbeForms, DiscBehindDisc)
{
  const double R = 0.5;
  const double L = 2.0;
  const double r = 0.6;
  for (const Placement& place : Placements())
  {
    TestMesh mesh;
    mesh.AddDisc({ 0.0, 0.0, L }, r);
    Scene scene(mesh,
      Tiles(L, { { -r, -r, L }, { r, r, L } }, [&](double x, double y) { return x * x + y * y < r * r; }),
      MakeLight(LightShape::Disc, R, place), place);
    scene.Compare(Across({ 2.5, 4.0, 8.0 }, [&](double z) { return closedforms::DiscPenumbraRadius(R, r, L, z); }),
      [&](const Vector3& x) { return closedforms::DiscVisibility(R, r, L, x.Z, x.X); });
  }
}

TEST(ProbeForms, SphereBehindSphere)
{
  const double R = 1.0;
  const double D = 6.0;
  const double r = 1.0;
  for (const Placement& place : Placements())
  {
    TestMesh mesh;
    mesh.AddSphere({ 0.0, 0.0, D }, r);
    Scene scene(mesh, TilesOfSphere({ 0.0, 0.0, D }, r), MakeLight(LightShape::Sphere, R, place), place);
    scene.Compare(Across({ 9.0, 14.0 }, [&](double z) { return 1.5 * r * z / D; }),
      [&](const Vector3& x) {
        return closedforms::SphereVisibility(R, r, { 0.0, 0.0, D }, x);
      });
  }
}

TEST(ProbeForms, RectangleBehindRectangle)
{
  const double L = 2.0;
  for (const Placement& place : Placements())
  {
    TestMesh mesh;
    mesh.AddSheet({ -0.5, -0.4, L }, { 1.0, 0.0, 0.0 }, { 0.0, 0.8, 0.0 });
    Scene scene(mesh, Tiles(L, { { -0.5, -0.4, L }, { 0.5, 0.4, L } }, [](double, double) { return true; }),
      MakeLight(LightShape::Rectangle, 1.0, place), place);
    scene.Compare(Across({ 3.0, 6.0 }, [&](double z) { return 0.5 + 0.55 * (z - L); }),
      [&](const Vector3& x) { return closedforms::RectangleVisibility(0.6, 0.3, 0.5, 0.4, L, x.X, x.Y, x.Z); });
  }
}

TEST(ProbeForms, StraightEdge)
{
  // A half plane as far as the light's shadow at these depths reaches.
  const double R = 0.5;
  const double L = 2.0;
  for (const Placement& place : Placements())
  {
    TestMesh mesh;
    mesh.AddSheet({ -1.5, -1.0, L }, { 1.5, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
    Scene scene(mesh, Tiles(L, { { -1.5, -1.0, L }, { 0.0, 1.0, L } }, [](double, double) { return true; }),
      MakeLight(LightShape::Disc, R, place), place);
    std::vector<Vector3> points;
    for (const double z : { 2.5, 3.0, 4.0 })
    {
      for (int k = -6; k <= 6; ++k)
      {
        points.push_back({ 0.2 * k * R * (z - L) / L, 0.0, z });
      }
    }
    scene.Compare(points, [&](const Vector3& x) { return closedforms::EdgeVisibility(R, L, x.Z, x.X); });
  }
}

TEST(ProbeForms, SunAndEarth)
{
  // Kilometres, the Sun at the origin, and the same far from the origin: the angles are a quarter of a degree.
  const double R = 695700.0;
  const double r = 6371.0;
  const double D = 149597870.7;
  const double umbra = closedforms::SphereUmbraLength(R, r, D);
  for (const Vector3& offset : { Vector3{}, Vector3{ 1e9, -2e9, 3e9 } })
  {
    const Placement place{ "in space", 1.0, offset };
    const Light light = MakeLight(LightShape::Sphere, R, place);
    TestMesh mesh;
    mesh.AddSphere({ 0.0, 0.0, D }, r);
    mesh.Place(place);
    const OccluderScene scene(mesh.View());
    Cone earth;
    earth.Center = place({ 0.0, 0.0, D });
    earth.Axis = { 0.0, 0.0, 1.0 };
    earth.Normal = earth.Axis;
    earth.BaseRadius = r;
    earth.OccluderId = 3;
    PenumbraAngles(LightExtentOf(light), earth.Center, earth.Axis, r, earth.HalfAngle, earth.InnerHalfAngle);
    EXPECT_NEAR(earth.HalfAngle, closedforms::SpherePenumbraHalfAngle(R, r, D), 1e-3 * earth.HalfAngle);
    EXPECT_NEAR(-earth.InnerHalfAngle, closedforms::SphereUmbraHalfAngle(R, r, D), 1e-3 * earth.HalfAngle);

    std::vector<Vector3> points;
    for (const double along : { 0.98, 1.2, 2.0, 5.0 })
    {
      points.push_back({ 0.0, 0.0, D + along * umbra });
    }
    for (int k = 0; k <= 10; ++k)
    {
      // Where the Moon goes.
      points.push_back({ 900.0 * k, 0.0, D + 384400.0 });
    }
    Box box;
    for (const Vector3& point : points)
    {
      box.Add(place(point));
    }
    VisibilityOptions options;
    options.NumberOfLightSamples = 16384;
    const VisibilityProbe exact({ earth }, light, &scene, box, options);
    options.Method = VisibilityMethod::Soft;
    const VisibilityProbe soft({ earth }, light, nullptr, box, options);
    int partial = 0;
    for (const Vector3& point : points)
    {
      const double expected = closedforms::SphereVisibility(R, r, { 0.0, 0.0, D }, point);
      partial += expected > 0.01 && expected < 0.99;
      EXPECT_NEAR(exact.At(place(point)).Fraction, expected, 1e-3)
        << point.X << " km off the axis, " << point.Z - D << " km behind";
      EXPECT_NEAR(soft.At(place(point)).Fraction, expected, 1e-3)
        << point.X << " km off the axis, " << point.Z - D << " km behind";
    }
    EXPECT_GT(partial, 5);
    // Before the tip of the umbra the Sun is gone, behind it its rim shows.
    EXPECT_EQ(soft.At(place({ 0.0, 0.0, D + 0.98 * umbra })).Class, ShadowClass::Umbra);
    EXPECT_EQ(exact.At(place({ 0.0, 0.0, D + 0.98 * umbra })).Class, ShadowClass::Umbra);
    EXPECT_EQ(exact.At(place({ 0.0, 0.0, D + 1.2 * umbra })).Class, ShadowClass::Penumbra);
  }
}
