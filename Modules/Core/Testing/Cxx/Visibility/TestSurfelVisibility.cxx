// SPDX-License-Identifier: BSD-3-Clause
// The visible fraction at points: discs against rays and the slow reference, surfaces, classes and errors.
#include "TestMeshes.h"
#include "scShadowClass.h"
#include "scVisibilityProbe.h"

#include "scFrame.h"
#include "scRandom.h"
#include "scReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double pi = 3.14159265358979323846;
const Box room{ { -3.0, -3.0, -1.0 }, { 3.0, 3.0, 8.0 } };

Light MakeLight(LightShape shape)
{
  Light light;
  light.Shape = shape;
  light.Normal = { 0.0, 0.0, 1.0 };
  light.AxisU = { 0.4, 0.1, 0.0 };
  light.AxisV = { -0.05, 0.2, 0.0 };
  light.Radius = shape == LightShape::Sun ? 0.1 : 0.4;
  light.Spectrum = { 1.0 };
  if (shape == LightShape::Mesh)
  {
    // A roof of two faces: from the side only one of them is seen.
    light.Triangles = { { Vector3{ -0.5, -0.4, 0.0 }, Vector3{ 0.0, 0.4, 0.3 }, Vector3{ 0.0, -0.4, 0.3 } },
      { Vector3{ 0.5, -0.4, 0.0 }, Vector3{ 0.0, -0.4, 0.3 }, Vector3{ 0.0, 0.4, 0.3 } } };
    for (auto& triangle : light.Triangles)
    {
      if (Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]).Z < 0.0)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
  }
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

Cone Disc(const Vector3& center, const Vector3& normal, double radius, int occluderId = 0)
{
  Cone cone;
  cone.Center = center;
  cone.Normal = Normalized(normal);
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.BaseRadius = radius;
  cone.OccluderId = occluderId;
  return cone;
}

/// Discs as triangle fans.
TestMesh MeshOf(const std::vector<Cone>& discs, int corners = 256)
{
  TestMesh mesh;
  for (const Cone& disc : discs)
  {
    const Frame frame = FrameAround(disc.Normal);
    mesh.AddDisc(disc.Center, disc.BaseRadius, frame.U, frame.V, corners, disc.OccluderId);
  }
  return mesh;
}

std::vector<Cone> TiltedDiscs()
{
  return { Disc({ 0.0, 0.1, 2.0 }, { 0.3, 0.1, 1.0 }, 0.3, 4), Disc({ 0.5, 0.0, 3.0 }, { 1.0, 0.0, 0.2 }, 0.4, 2),
    Disc({ -0.6, -0.4, 1.2 }, { -1.0, 1.0, 1.0 }, 0.35, 7), Disc({ -0.2, 0.6, 2.5 }, { 0.0, 1.0, 0.0 }, 0.5, 4),
    Disc({ 0.9, 0.9, 0.6 }, { 0.5, 0.5, -1.0 }, 0.3, 1) };
}

std::vector<Vector3> RandomPoints(int count, const Box& box)
{
  RandomStream random(11, 3);
  std::vector<Vector3> points;
  for (int k = 0; k < count; ++k)
  {
    const double x = random.Next();
    const double y = random.Next();
    const double z = random.Next();
    points.push_back({ box.Min.X + x * box.Size().X, box.Min.Y + y * box.Size().Y, box.Min.Z + z * box.Size().Z });
  }
  return points;
}

/// A cone that holds all of the box.
std::vector<Cone> Everywhere(const Box& box)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  cone.Center = box.Center() - Vector3{ 0.0, 0.0, box.Diagonal() };
  cone.BaseRadius = 2.0 * box.Diagonal();
  return { cone };
}

VisibilityOptions Options(VisibilityMethod method, int samples)
{
  VisibilityOptions options;
  options.Method = method;
  options.NumberOfLightSamples = samples;
  return options;
}
} // namespace

class VisibilityOfLight : public testing::TestWithParam<LightShape>
{
};

// Discs and their fans are the same occluders: both methods take the same samples, and only round-off may part them.
TEST_P(VisibilityOfLight, SoftAndExactAgreeOnDiscs)
{
  const Light light = MakeLight(GetParam());
  const std::vector<Cone> discs = TiltedDiscs();
  const TestMesh mesh = MeshOf(discs, 4096);
  const OccluderScene scene(mesh.View());
  for (const int samples : { 1, 64, 100 })
  {
    const VisibilityProbe soft(discs, light, nullptr, room, Options(VisibilityMethod::Soft, samples));
    const VisibilityProbe exact(Everywhere(room), light, &scene, room, Options(VisibilityMethod::Exact, samples));
    int partial = 0;
    int different = 0;
    for (const Vector3& point : RandomPoints(1500, room))
    {
      const PointVisibility a = soft.At(point);
      const PointVisibility b = exact.At(point);
      partial += b.Fraction > 0.0 && b.Fraction < 1.0;
      different += a.Fraction != b.Fraction || a.OccluderId != b.OccluderId;
      EXPECT_NEAR(a.Fraction, b.Fraction, samples == 1 ? 1.0 : 2.01 / samples);
    }
    EXPECT_LE(different, 4) << samples;
    if (samples > 1 && GetParam() != LightShape::Point)
    {
      EXPECT_GT(partial, 25);
    }
  }
}

// Held against independent random light points and a plain ray caster.
TEST_P(VisibilityOfLight, ErrorsAreAsStated)
{
  const Light light = MakeLight(GetParam());
  const std::vector<Cone> discs = TiltedDiscs();
  const TestMesh mesh = MeshOf(discs);
  const ReferenceScene reference(mesh.View());
  const VisibilityProbe soft(discs, light, nullptr, room, Options(VisibilityMethod::Soft, 64));
  double squares = 0.0;
  double stated = 0.0;
  int sampled = 0;
  for (const Vector3& point : RandomPoints(200, room))
  {
    const PointVisibility found = soft.At(point);
    const double expected = ReferenceVisibility(reference, light, point, 2000);
    EXPECT_NEAR(found.Fraction, expected, 0.1) << point.X << " " << point.Y << " " << point.Z;
    if (found.Error > 0.0)
    {
      squares += (found.Fraction - expected) * (found.Fraction - expected);
      stated += found.Error * found.Error;
      ++sampled;
    }
  }
  if (GetParam() == LightShape::Point)
  {
    EXPECT_EQ(sampled, 0);
    return;
  }
  EXPECT_GT(sampled, 10);
  EXPECT_LT(std::sqrt(squares), std::sqrt(stated));
  EXPECT_GT(std::sqrt(squares), 0.1 * std::sqrt(stated));
}

INSTANTIATE_TEST_SUITE_P(Visibility, VisibilityOfLight,
  testing::Values(
    LightShape::Disc, LightShape::Rectangle, LightShape::Sphere, LightShape::Point, LightShape::Sun, LightShape::Mesh));

// Big discs right at the light, edge on to it or around it, have no penumbra cone and must still be found.
TEST(SurfelVisibility, DiscsNextToTheLight)
{
  const Light light = MakeLight(LightShape::Disc);
  const std::vector<Cone> discs = { Disc({ 0.3, 0.0, 0.2 }, { 1.0, 0.0, 0.1 }, 1.0),
    Disc({ 0.0, 0.5, 0.05 }, { 0.0, 0.2, 1.0 }, 0.5) };
  const TestMesh mesh = MeshOf(discs, 4096);
  const OccluderScene scene(mesh.View());
  const VisibilityProbe soft(discs, light, nullptr, room, Options(VisibilityMethod::Soft, 64));
  const VisibilityProbe exact(Everywhere(room), light, &scene, room, Options(VisibilityMethod::Exact, 64));
  int hidden = 0;
  for (const Vector3& point : RandomPoints(1000, room))
  {
    const double expected = exact.At(point).Fraction;
    hidden += point.Z > 0.0 && expected < 1.0;
    EXPECT_NEAR(soft.At(point).Fraction, expected, 2.01 / 64);
  }
  EXPECT_GT(hidden, 300);
}

TEST(SurfelVisibility, ManyDiscsThroughTheTree)
{
  // Discs of a plate: what the tree finds is what all discs one by one hide.
  const Light light = MakeLight(LightShape::Disc);
  std::vector<Cone> discs;
  RandomStream random(5, 5);
  for (int k = 0; k < 300; ++k)
  {
    const double x = 2.0 * random.Next() - 1.0;
    const double y = 2.0 * random.Next() - 1.0;
    const Vector3 tilt{ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 };
    discs.push_back(Disc({ x, y, 1.0 + 3.0 * random.Next() }, tilt, 0.03 + 0.05 * random.Next(), k));
  }
  const VisibilityOptions options = Options(VisibilityMethod::Soft, 64);
  const VisibilityProbe together(discs, light, nullptr, room, options);
  std::vector<std::unique_ptr<VisibilityProbe>> single;
  for (const Cone& disc : discs)
  {
    single.push_back(std::make_unique<VisibilityProbe>(std::vector<Cone>{ disc }, light, nullptr, room, options));
  }
  for (const Vector3& point : RandomPoints(60, { { -1.0, -1.0, 2.0 }, { 1.0, 1.0, 6.0 } }))
  {
    double most = 0.0;
    int occluder = -1;
    double sum = 0.0;
    for (std::size_t k = 0; k < discs.size(); ++k)
    {
      const double hidden = 1.0 - single[k]->At(point).Fraction;
      sum += hidden;
      occluder = hidden > most ? static_cast<int>(k) : occluder;
      most = std::max(most, hidden);
    }
    const PointVisibility found = together.At(point);
    EXPECT_EQ(found.OccluderId, occluder);
    EXPECT_LE(1.0 - found.Fraction, sum + 1e-12);
    EXPECT_GE(1.0 - found.Fraction, most);
  }
}

TEST(SurfelVisibility, ClassesAndOccluders)
{
  const Light light = MakeLight(LightShape::Disc);
  const VisibilityProbe probe(
    { Disc({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 1.0, 6), Disc({ 0.0, 0.0, 1.9 }, { 0.0, 0.0, 1.0 }, 1.0, 3) }, light,
    nullptr, room, Options(VisibilityMethod::Soft, 64));
  const PointVisibility umbra = probe.At({ 0.0, 0.0, 2.5 });
  EXPECT_EQ(umbra.Fraction, 0.0);
  EXPECT_EQ(umbra.Class, ShadowClass::Umbra);
  EXPECT_EQ(umbra.OccluderId, 3); // both hide all of it: the smaller id
  EXPECT_GT(umbra.Error, 0.0);
  const PointVisibility penumbra = probe.At({ 1.25, 0.0, 2.5 });
  EXPECT_EQ(penumbra.Class, ShadowClass::Penumbra);
  EXPECT_NE(penumbra.OccluderId, -1);
  const PointVisibility lit = probe.At({ 2.9, 0.0, 2.5 });
  EXPECT_EQ(lit.Fraction, 1.0);
  EXPECT_EQ(lit.Class, ShadowClass::Lit);
  EXPECT_EQ(lit.OccluderId, -1);
  EXPECT_EQ(lit.Error, 0.0);
  const PointVisibility before = probe.At({ 0.0, 0.0, 1.5 });
  EXPECT_EQ(before.Class, ShadowClass::Lit);
  const PointVisibility dark = probe.At({ 0.0, 0.0, -0.5 });
  EXPECT_EQ(dark.Fraction, 0.0);
  EXPECT_EQ(dark.Class, ShadowClass::Umbra);
  EXPECT_EQ(dark.OccluderId, -1);
}

TEST(VisibilityProbe, ExactTracesInsideConesOnly)
{
  const Light light = MakeLight(LightShape::Disc);
  const TestMesh mesh = MeshOf({ Disc({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 1.0) });
  const OccluderScene scene(mesh.View());
  Cone cone = Disc({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, 1.0 }, 0.25);
  cone.HalfAngle = 0.1;
  const VisibilityProbe probe({ cone }, light, &scene, room, Options(VisibilityMethod::Exact, 64));
  EXPECT_EQ(probe.At({ 0.0, 0.0, 3.5 }).Fraction, 0.0);
  EXPECT_EQ(probe.At({ 0.0, 0.0, 2.8 }).Fraction, 0.0) << "less than a base radius before the base";
  EXPECT_EQ(probe.At({ 0.0, 0.0, 2.7 }).Fraction, 1.0) << "outside the cone";
  EXPECT_EQ(probe.At({ 0.6, 0.0, 3.5 }).Fraction, 1.0) << "outside the cone";
  EXPECT_EQ(probe.At({ 0.6, 0.0, 3.5 }).Error, 0.0);
}

TEST(VisibilityProbe, SurfacesDoNotHideThemselves)
{
  const Light light = MakeLight(LightShape::Disc);
  // A bumpy height field: points on it see the light unless another part of it is in the way.
  const int n = 40;
  std::vector<double> points;
  std::vector<vtkIdType> triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = 2.0 * i / n - 1.0;
      const double y = 2.0 * j / n - 1.0;
      points.insert(points.end(), { x, y, 3.0 + 0.02 * std::sin(3.0 * x) * std::cos(4.0 * y) });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i;
      triangles.insert(triangles.end(), { a, a + 1, a + n + 2, a, a + n + 2, a + n + 1 });
    }
  }
  for (const double far : { 0.0, 1e6 })
  {
    std::vector<double> moved = points;
    for (double& coordinate : moved)
    {
      coordinate += far;
    }
    const Vector3 offset{ far, far, far };
    Light there = light;
    there.Center = offset;
    ASSERT_EQ(PrepareLight(there), nullptr);
    const TriangleMeshView view{ moved.data(), static_cast<vtkIdType>(moved.size() / 3), triangles.data(),
      static_cast<vtkIdType>(triangles.size() / 3), nullptr };
    const OccluderScene scene(view);
    const Box box = MeshBounds(view);
    const VisibilityProbe exact(Everywhere(box), there, &scene, box, Options(VisibilityMethod::Exact, 64));
    for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
    {
      const Vector3 center = (1.0 / 3.0) * (view.Corner(t, 0) + view.Corner(t, 1) + view.Corner(t, 2));
      EXPECT_EQ(exact.At(center).Fraction, 1.0) << "triangle " << t << ", " << far;
    }
    for (vtkIdType p = 0; p < view.NumberOfPoints; ++p)
    {
      EXPECT_EQ(exact.At(view.Point(p)).Fraction, 1.0) << "point " << p << ", " << far;
    }
  }

  // Discs fitted to the same surface: flat ones never, curved ones within three rms distances.
  Cone disc = Disc({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, 1.0 }, 0.5);
  disc.Planarity = 0.02;
  VisibilityOptions options = Options(VisibilityMethod::Soft, 64);
  const VisibilityProbe inSpace({ disc }, light, nullptr, room, options);
  options.OnSurfaces = true;
  const VisibilityProbe onSurface({ disc }, light, nullptr, room, options);
  EXPECT_EQ(inSpace.At({ 0.1, 0.0, 3.0 }).Fraction, 1.0);
  EXPECT_EQ(inSpace.At({ 0.1, 0.0, 3.02 }).Fraction, 0.0);
  EXPECT_EQ(onSurface.At({ 0.1, 0.0, 3.02 }).Fraction, 1.0);
  EXPECT_EQ(onSurface.At({ 0.1, 0.0, 3.04 }).Fraction, 0.0);
}

TEST(VisibilityProbe, NormalsHideLightFromBelow)
{
  for (const LightShape shape : { LightShape::Disc, LightShape::Sphere, LightShape::Sun })
  {
    const Light light = MakeLight(shape);
    const VisibilityProbe probe({}, light, nullptr, room, Options(VisibilityMethod::Soft, 4096));
    const Vector3 point{ 0.0, 0.0, 3.0 };
    const Vector3 towards{ 0.0, 0.0, -1.0 };
    const Vector3 away{ 0.0, 0.0, 1.0 };
    const Vector3 across{ 1.0, 0.0, 0.0 };
    EXPECT_EQ(probe.At(point, &towards).Fraction, 1.0);
    EXPECT_EQ(probe.At(point, &towards).Error, 0.0);
    const PointVisibility turned = probe.At(point, &away);
    EXPECT_EQ(turned.Fraction, 0.0);
    EXPECT_EQ(turned.Class, ShadowClass::Umbra);
    EXPECT_EQ(turned.OccluderId, -1);
    EXPECT_NEAR(probe.At(point, &across).Fraction, 0.5, 0.005);
    EXPECT_EQ(probe.At(point, &across).Class, ShadowClass::Penumbra);
  }
}

TEST(VisibilityProbe, SamplesFollowSeedAndPlace)
{
  const Light light = MakeLight(LightShape::Disc);
  const std::vector<Cone> discs = { Disc({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 0.3) };
  VisibilityOptions options = Options(VisibilityMethod::Soft, 64);
  const VisibilityProbe a(discs, light, nullptr, room, options);
  const VisibilityProbe again(discs, light, nullptr, room, options);
  options.Seed = 2;
  const VisibilityProbe b(discs, light, nullptr, room, options);
  int differentSeed = 0;
  int differentPlace = 0;
  for (int k = 0; k < 100; ++k)
  {
    // Turned about the axis: the truth stays.
    const double angle = 2.0 * pi * k / 100;
    const Vector3 point{ 0.5 * std::cos(angle), 0.5 * std::sin(angle), 4.0 };
    EXPECT_EQ(a.At(point).Fraction, again.At(point).Fraction);
    differentSeed += a.At(point).Fraction != b.At(point).Fraction;
    differentPlace += a.At(point).Fraction != a.At({ 0.5, 0.0, 4.0 }).Fraction;
  }
  EXPECT_GT(differentSeed, 30);
  EXPECT_GT(differentPlace, 30);
}

TEST(VisibilityProbe, StopsWhenAsked)
{
  const Light light = MakeLight(LightShape::Disc);
  const VisibilityProbe probe(TiltedDiscs(), light, nullptr, room, Options(VisibilityMethod::Soft, 64));
  const std::vector<double> points(300, 1.0);
  VisibilityResult result;
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  EXPECT_FALSE(ProbeVisibility(probe, points.data(), nullptr, 100, monitor, result));
  EXPECT_TRUE(ProbeVisibility(probe, nullptr, nullptr, 0, {}, result));
  EXPECT_TRUE(result.Visibility.empty());
}
