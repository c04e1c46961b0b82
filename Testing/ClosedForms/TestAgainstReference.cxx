// SPDX-License-Identifier: BSD-3-Clause
// Every fast path against the slow, plain reference on chair, tree and blob.
#include "RoomTestScene.h"
#include "SampledVisibility.h"
#include "scConeIntervals.h"
#include "scReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{
struct Scene
{
  TriangleMesh Mesh;
  std::unique_ptr<OccluderScene> Fast;
  std::unique_ptr<ReferenceScene> Slow;
};

Scene Load(const std::string& name)
{
  Scene scene;
  scene.Mesh = RoomMesh(name);
  EXPECT_GT(scene.Mesh.View().NumberOfTriangles, 100);
  scene.Fast = std::make_unique<OccluderScene>(scene.Mesh.View());
  scene.Slow = std::make_unique<ReferenceScene>(scene.Mesh.View());
  return scene;
}

Vector3 RoomPoint(RandomStream& random)
{
  const double x = 5.5 * random.Next() - 2.75;
  const double y = 5.2 * random.Next();
  return { x, y, 5.5 * random.Next() - 2.75 };
}

class AgainstReference : public testing::TestWithParam<const char*>
{
};
} // namespace

TEST_P(AgainstReference, Rays)
{
  const Scene scene = Load(GetParam());
  const Vector3 center = scene.Fast->Bounds().Center();
  const double size = scene.Fast->Bounds().Diagonal();
  int hits = 0;
  for (int k = 0; k < 4000; ++k)
  {
    RandomStream random(11, static_cast<std::uint64_t>(k));
    const Vector3 origin = RoomPoint(random);
    const Vector3 aside{ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 };
    const Vector3 direction = Normalized(center + 0.4 * size * aside - origin);
    const double reach = 8.0 * random.Next();
    const double t = scene.Slow->Nearest(origin, direction, 0.0, reach);
    ASSERT_EQ(scene.Fast->Occluded(origin, direction, 0.0, reach), t < HUGE_VAL) << "ray " << k;
    RayHit hit;
    ASSERT_EQ(scene.Fast->Intersect(origin, direction, 0.0, reach, hit), t < HUGE_VAL) << "ray " << k;
    if (t < HUGE_VAL)
    {
      ++hits;
      EXPECT_NEAR(hit.T, t, 1e-9) << "ray " << k;
    }
  }
  EXPECT_GT(hits, 400);
}

TEST_P(AgainstReference, AllHits)
{
  const Scene scene = Load(GetParam());
  int total = 0;
  for (int k = 0; k < 200; ++k)
  {
    RandomStream random(12, static_cast<std::uint64_t>(k));
    const Vector3 origin = RoomPoint(random);
    const Vector3 direction = Normalized(scene.Fast->Bounds().Center() - origin);
    std::vector<RayHit> hits;
    scene.Fast->IntersectAll(origin, direction, 0.0, HUGE_VAL, hits);
    ASSERT_EQ(static_cast<int>(hits.size()), scene.Slow->CountHits(origin, direction, 0.0, HUGE_VAL)) << "ray " << k;
    for (std::size_t h = 1; h < hits.size(); ++h)
    {
      EXPECT_LE(hits[h - 1].T, hits[h].T);
    }
    total += static_cast<int>(hits.size());
  }
  EXPECT_GT(total, 100);
}

TEST_P(AgainstReference, Visibility)
{
  const Scene scene = Load(GetParam());
  const Light light = RoomLight({ 1.0 });
  const int samples = 60000;
  int partial = 0;
  for (std::uint64_t k = 0; partial < 6 && k < 5000; ++k)
  {
    RandomStream random(13, k);
    const Vector3 x = RoomPoint(random);
    const double coarse = ReferenceVisibility(*scene.Slow, light, x, 200, k);
    if (coarse < 0.1 || coarse > 0.9)
    {
      continue;
    }
    ++partial;
    const double expected = ReferenceVisibility(*scene.Slow, light, x, samples, k + 1);
    const double deviation = std::sqrt(expected * (1.0 - expected) / samples);
    EXPECT_NEAR(SampledVisibility(*scene.Fast, light, x), expected, 0.005 + 3.0 * deviation) << "point " << k;
  }
  EXPECT_EQ(partial, 6);
}

TEST_P(AgainstReference, Radiance)
{
  const Scene scene = Load(GetParam());
  const Light light = RoomLight({ 1.0 });
  const Medium medium = RoomMedium(1, 0.05);
  const Camera camera = LookAt({ 0.0, 2.75, 8.0 }, { 0.0, 2.75, 0.0 }, 0.5);
  const ConeHierarchy cones(BoundingCones(*scene.Fast, light), medium.Bounds);
  ASSERT_GT(cones.Cones().size(), 50u);
  ScatteringOptions options;
  options.Width = 64;
  options.Height = 64;
  options.NumberOfSteps = 96;
  options.NumberOfLightSamples = 64;
  options.NumberOfSurfaceLightSamples = 0;
  options.NumberOfEdgeSamples = 1; // the reference looks along the centres of the pixels
  for (const auto& pixel : { std::array<int, 2>{ 32, 16 }, { 20, 24 }, { 40, 30 }, { 30, 40 }, { 10, 50 } })
  {
    const ReferenceEstimate expected =
      ReferenceInScattering(*scene.Slow, light, medium, camera, pixel[0], pixel[1], 64, 64, 128000);
    EXPECT_LT(expected.StandardError[0], 0.005 * expected.Mean[0]);
    options.Extent = { pixel[0], pixel[0], pixel[1], pixel[1] };
    for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Medium })
    {
      options.Mode = mode;
      ScatteringImage image;
      ASSERT_TRUE(RenderScattering({ *scene.Fast, light, medium, camera, &cones }, options, Monitor(), image));
      ASSERT_EQ(image.InScattering.size(), 1u);
      EXPECT_NEAR(image.InScattering[0], expected.Mean[0], 0.01 * expected.Mean[0] + 3.0 * expected.StandardError[0])
        << "pixel " << pixel[0] << ", " << pixel[1] << ", mode " << static_cast<int>(mode);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AgainstReference, testing::Values("chair", "tree", "blob"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });

TEST(AgainstReferenceLights, FacesShineAsTheRectangleThatTheyMake)
{
  const Light whole = RectangleLight({ 0.0, 5.4, 0.0 }, { 0.6, 0.0, 0.0 }, { 0.0, 0.0, 0.4 }, { 1.0 });
  Light faces;
  faces.Shape = LightShape::Mesh;
  const Vector3 a{ -0.6, 5.4, -0.4 };
  const Vector3 b{ 0.6, 5.4, -0.4 };
  const Vector3 c{ 0.6, 5.4, 0.4 };
  const Vector3 d{ -0.6, 5.4, 0.4 };
  faces.Triangles = { { a, b, c }, { a, c, d } };
  faces.Spectrum = { 1.0 };
  faces = Prepared(faces);
  const Scene scene = Load("chair");
  const auto shine = [&](const Light& light) {
    return ReferenceInScattering(*scene.Slow, light, RoomMedium(1), RoomCamera(), 5, 6, 12, 12, 16384, 3);
  };
  const ReferenceEstimate one = shine(whole);
  const ReferenceEstimate other = shine(faces);
  ASSERT_GT(one.Mean[0], 0.0);
  EXPECT_LT(one.StandardError[0], 0.05 * one.Mean[0]);
  EXPECT_NEAR(other.Mean[0], one.Mean[0], 4.0 * std::hypot(one.StandardError[0], other.StandardError[0]));
}

TEST(AgainstReferenceCones, RaysThroughCones)
{
  int met = 0;
  for (std::uint64_t k = 0; k < 150; ++k)
  {
    RandomStream random(14, k);
    const auto direction = [&random] {
      return Normalized({ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 });
    };
    Cone cone;
    cone.Center = { random.Next(), random.Next(), random.Next() };
    cone.Axis = direction();
    cone.BaseRadius = 0.05 + 0.5 * random.Next();
    cone.HalfAngle = 1.2 * random.Next() - 0.4;
    const double length = k % 3 == 0 ? HUGE_VAL : 0.5 + 2.0 * random.Next();
    const Vector3 origin = Vector3{ random.Next(), random.Next(), random.Next() } - 2.0 * direction();
    const Vector3 ray = Normalized(cone.Center + 0.5 * (random.Next() + 1.0) * cone.Axis + 0.4 * direction() - origin);
    double begin = 0.0;
    double end = 0.0;
    const bool expected = ReferenceConeInterval(cone, length, origin, ray, 0.1, 6.0, begin, end, 6000);
    OccluderInterval interval;
    const bool found = IntersectCone(cone, length, { origin, ray }, { 0.1, 6.0 }, interval);
    if (expected)
    {
      ++met;
      ASSERT_TRUE(found) << "cone " << k;
      EXPECT_NEAR(interval.Begin, begin, 1e-9) << "cone " << k;
      EXPECT_NEAR(interval.End, end, 1e-9) << "cone " << k;
    }
    else
    {
      // The samples of the reference are 1e-3 apart: only a shorter stretch may have slipped between them.
      EXPECT_TRUE(!found || interval.End - interval.Begin < 1e-3) << "cone " << k;
    }
    for (int p = 0; p < 40; ++p)
    {
      const Vector3 x = cone.Center + 3.0 * random.Next() * direction();
      EXPECT_EQ(ConeContains(cone, x, length), ReferenceConeContains(cone, x, length)) << "cone " << k;
    }
  }
  EXPECT_GT(met, 75);
}
