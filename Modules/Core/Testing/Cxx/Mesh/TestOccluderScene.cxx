// SPDX-License-Identifier: BSD-3-Clause
// Ray queries against a loop over all triangles in double precision, near the origin, far away and tiny.
#include "TestMeshes.h"
#include "scOccluderScene.h"
#include "scRandom.h"
#include "scTriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace shadowcones;
using namespace testsupport;

namespace
{

struct PlainHits
{
  std::vector<RayHit> Hits; ///< ascending
  bool NearEdge = false;    ///< some triangle was hit or missed so narrowly that single precision may differ
};

/// All hits by the plane and the three edge functions of every triangle.
PlainHits EveryTriangle(const TriangleMeshView& mesh, const Vector3& origin, const Vector3& direction)
{
  PlainHits result;
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    const Vector3 a = mesh.Corner(t, 0) - origin;
    const Vector3 b = mesh.Corner(t, 1) - origin;
    const Vector3 c = mesh.Corner(t, 2) - origin;
    const Vector3 normal = Cross(b - a, c - a);
    const double slope = Dot(normal, direction);
    const double u = Dot(Cross(b, c), direction) / slope;
    const double v = Dot(Cross(c, a), direction) / slope;
    const double w = Dot(Cross(a, b), direction) / slope;
    const double least = std::min({ u, v, w });
    result.NearEdge = result.NearEdge || !(std::abs(least) > 1e-4) || std::abs(slope) < 1e-4 * Length(normal);
    if (least > 0.0 && Dot(normal, a) / slope > 0.0)
    {
      RayHit hit;
      hit.T = Dot(normal, a) / slope;
      hit.Triangle = t;
      hit.FrontFacing = slope < 0.0;
      result.Hits.push_back(hit);
    }
  }
  std::sort(result.Hits.begin(), result.Hits.end(), [](const RayHit& x, const RayHit& y) { return x.T < y.T; });
  return result;
}

TestMesh Clutter(double scale, const Vector3& offset)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 8, 0);
  mesh.AddBox({ 1.1, -0.4, -0.7 }, { 1.9, 0.8, 0.3 }, 1);
  mesh.AddSheet({ -2.0, -1.5, 1.3 }, { 3.0, 0.2, 0.1 }, { 0.1, 3.0, -0.2 }, 2);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    mesh.Points[i] = scale * mesh.Points[i] + offset[static_cast<int>(i % 3)];
  }
  return mesh;
}

Vector3 RandomDirection(RandomStream& random)
{
  const double z = 2.0 * random.Next() - 1.0;
  const double phi = 2.0 * Pi * random.Next();
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(phi), r * std::sin(phi), z };
}

struct Place
{
  const char* Name;
  double Scale;
  Vector3 Offset;
};

class OccluderScenePlaces : public testing::TestWithParam<Place>
{
};

} // namespace

TEST_P(OccluderScenePlaces, HitsAreThoseOfALoopOverAllTriangles)
{
  const Place& place = GetParam();
  const TestMesh mesh = Clutter(place.Scale, place.Offset);
  const TriangleMeshView view = mesh.View();
  const OccluderScene scene(view);
  RandomStream random(7, 0);
  std::vector<RayHit> all;
  int compared = 0;
  int withHits = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Vector3 local{ 6.0 * random.Next() - 3.0, 6.0 * random.Next() - 3.0, 6.0 * random.Next() - 3.0 };
    const Vector3 origin = place.Scale * local + place.Offset;
    // Half of the rays go near the sphere, the others anywhere.
    const Vector3 direction = i % 2 ? RandomDirection(random) : Normalized(0.5 * RandomDirection(random) - local);
    const PlainHits truth = EveryTriangle(view, origin, direction);
    if (truth.NearEdge)
    {
      continue;
    }
    ++compared;
    withHits += !truth.Hits.empty();
    scene.IntersectAll(origin, direction, 0.0, HUGE_VAL, all);
    ASSERT_EQ(all.size(), truth.Hits.size());
    RayHit nearest;
    ASSERT_EQ(scene.Intersect(origin, direction, 0.0, HUGE_VAL, nearest), !truth.Hits.empty());
    ASSERT_EQ(scene.Occluded(origin, direction, 0.0, HUGE_VAL), !truth.Hits.empty());
    // Distances are as good as the mesh's own coordinates, far better than single precision.
    const double tolerance = 1e-11 * place.Scale + 1e-15 * Length(place.Offset);
    for (std::size_t k = 0; k < all.size(); ++k)
    {
      ASSERT_EQ(all[k].Triangle, truth.Hits[k].Triangle);
      ASSERT_NEAR(all[k].T, truth.Hits[k].T, tolerance * 1e3);
      ASSERT_EQ(all[k].FrontFacing, truth.Hits[k].FrontFacing);
    }
    if (!all.empty())
    {
      ASSERT_EQ(nearest.Triangle, all[0].Triangle);
      ASSERT_EQ(nearest.T, all[0].T);
      ASSERT_EQ(nearest.FrontFacing, all[0].FrontFacing);
    }
  }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(withHits, 1000);
}

TEST_P(OccluderScenePlaces, RangesCutHitsOff)
{
  const Place& place = GetParam();
  TestMesh mesh;
  for (int i = 1; i <= 3; ++i)
  {
    mesh.AddSheet(place.Scale * Vector3{ -1.0, -1.0, 1.0 * i } + place.Offset, { 2.0 * place.Scale, 0.0, 0.0 },
      { 0.0, 2.0 * place.Scale, 0.0 }, i);
  }
  const OccluderScene scene(mesh.View());
  const Vector3 origin = place.Scale * Vector3{ 0.3, 0.1, 0.0 } + place.Offset;
  const Vector3 up{ 0.0, 0.0, 1.0 };
  const double unit = place.Scale;
  std::vector<RayHit> hits;
  const auto count = [&](double tMin, double tMax)
  {
    scene.IntersectAll(origin, up, tMin * unit, tMax * unit, hits);
    return hits.size();
  };
  EXPECT_EQ(count(0.0, 4.0), 3u);
  EXPECT_EQ(count(1.001, 4.0), 2u);
  EXPECT_EQ(count(0.0, 2.999), 2u);
  EXPECT_EQ(count(1.001, 1.999), 0u);
  EXPECT_TRUE(scene.Occluded(origin, up, 1.001 * unit, HUGE_VAL));
  EXPECT_FALSE(scene.Occluded(origin, up, 1.001 * unit, 1.999 * unit));
  EXPECT_FALSE(scene.Occluded(origin, up, 3.001 * unit, HUGE_VAL));
  EXPECT_FALSE(scene.Occluded(origin, -up, 0.0, HUGE_VAL));
  RayHit hit;
  ASSERT_TRUE(scene.Intersect(origin, up, 1.001 * unit, HUGE_VAL, hit));
  EXPECT_NEAR(hit.T, 2.0 * unit, 1e-9 * unit + 1e-15 * Length(place.Offset));
  EXPECT_FALSE(hit.FrontFacing); // the sheets face up, like the ray
  EXPECT_EQ(scene.Mesh().OccluderId(hit.Triangle), 2);
}

INSTANTIATE_TEST_SUITE_P(Places, OccluderScenePlaces,
  testing::Values(Place{ "AtTheOrigin", 1.0, {} }, Place{ "FarAway", 1.0, { 1e6, -1e6, 1e6 } },
    Place{ "Tiny", 1e-3, {} }, Place{ "Huge", 1e9, {} }),
  [](const testing::TestParamInfo<Place>& info) { return std::string(info.param.Name); });

TEST(OccluderScene, AGrazingRayHasOneDistanceInBothQueries)
{
  // A large floor met at less than a thousandth of a radian: the centre of the triangle is units away from the hit.
  TestMesh mesh;
  mesh.AddSheet({ -50.0, -50.0, 0.0 }, { 100.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 }, 0);
  mesh.AddBox({ -1.0, -1.0, 5.0 }, { 1.0, 1.0, 6.0 }, 1);
  const OccluderScene scene(mesh.View());
  for (const double slope : { 9e-4, 4e-4, 1e-4 })
  {
    const Vector3 direction = Normalized({ 1.0, 0.1, -slope });
    const Vector3 origin{ -30.0, 7.0, 10.0 * slope };
    RayHit nearest;
    std::vector<RayHit> all;
    ASSERT_TRUE(scene.Intersect(origin, direction, 0.0, HUGE_VAL, nearest));
    scene.IntersectAll(origin, direction, 0.0, HUGE_VAL, all);
    ASSERT_EQ(all.size(), 1u);
    const double truth = 10.0 * slope / -direction.Z;
    EXPECT_NEAR(nearest.T, truth, 1e-2 * truth) << slope;
    EXPECT_NEAR(all[0].T, truth, 1e-2 * truth) << slope;
  }
}

TEST(OccluderScene, AnswersForAnEmptyMesh)
{
  const OccluderScene scene{ TriangleMeshView() };
  RayHit hit;
  std::vector<RayHit> hits(3);
  EXPECT_FALSE(scene.Intersect({}, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL, hit));
  EXPECT_FALSE(scene.Occluded({}, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL));
  scene.IntersectAll({}, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL, hits);
  EXPECT_TRUE(hits.empty());
  EXPECT_TRUE(scene.Bounds().Empty());
}

TEST(OccluderScene, SurvivesTrianglesWithoutArea)
{
  TestMesh mesh;
  const vtkIdType a = mesh.AddPoint({ 0.2, 0.2, 0.5 });
  const vtkIdType b = mesh.AddPoint({ 0.4, 0.2, 0.5 });
  mesh.AddTriangle(a, a, a, 0);
  mesh.AddTriangle(a, b, a, 0);
  mesh.AddSheet({ -1.0, -1.0, 1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 1);
  const OccluderScene scene(mesh.View());
  std::vector<RayHit> hits;
  scene.IntersectAll({ 0.2, 0.1, 0.0 }, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL, hits);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].T, 1.0, 1e-12);
  RayHit hit;
  scene.Intersect({ 0.2, 0.2, 0.0 }, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL, hit); // straight through the degenerate ones
  EXPECT_TRUE(std::isfinite(hit.T));
}

TEST_P(OccluderScenePlaces, PacketsFindWhatSingleRaysFind)
{
  const Place& place = GetParam();
  const TestMesh mesh = Clutter(place.Scale, place.Offset);
  const OccluderScene scene(mesh.View());
  int found = 0;
  for (std::uint64_t packet = 0; packet < 500; ++packet)
  {
    RandomStream random(11, packet);
    Vector3 origins[OccluderScene::PacketSize];
    Vector3 directions[OccluderScene::PacketSize];
    RayHit hits[OccluderScene::PacketSize];
    const Vector3 eye = place.Scale * 6.0 * RandomDirection(random) + place.Offset;
    const Vector3 ahead = Normalized(place.Offset - eye);
    const int count = 1 + static_cast<int>(packet % OccluderScene::PacketSize);
    for (int k = 0; k < count; ++k)
    {
      origins[k] = eye;
      directions[k] = Normalized(ahead + 0.3 * RandomDirection(random));
    }
    scene.IntersectPacket(origins, directions, count, hits);
    for (int k = 0; k < count; ++k)
    {
      if (EveryTriangle(mesh.View(), origins[k], directions[k]).NearEdge)
      {
        continue;
      }
      RayHit single;
      const bool expected = scene.Intersect(origins[k], directions[k], 0.0, HUGE_VAL, single);
      ASSERT_EQ(hits[k].Triangle, expected ? single.Triangle : -1) << "packet " << packet << ", ray " << k;
      if (expected)
      {
        ++found;
        EXPECT_EQ(hits[k].T, single.T);
        EXPECT_EQ(hits[k].FrontFacing, single.FrontFacing);
      }
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(OccluderScene, SurvivesRaysThatAreNotNumbers)
{
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 }, 0);
  const OccluderScene scene(mesh.View());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<RayHit> hits;
  scene.IntersectAll({ nan, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 0.0, HUGE_VAL, hits);
  EXPECT_TRUE(hits.empty());
  scene.IntersectAll({ 0.0, 0.0, 0.0 }, { nan, nan, nan }, 0.0, HUGE_VAL, hits);
  EXPECT_TRUE(hits.empty());
  const Vector3 origins[2] = { { nan, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  const Vector3 directions[2] = { { 0.0, 0.0, 1.0 }, { 0.0, 0.6, 0.8 } };
  RayHit packet[2];
  scene.IntersectPacket(origins, directions, 2, packet);
  EXPECT_EQ(packet[0].Triangle, -1);
  EXPECT_GE(packet[1].Triangle, 0);
  const OccluderScene empty(TestMesh().View());
  empty.IntersectPacket(origins, directions, 2, packet);
  EXPECT_EQ(packet[1].Triangle, -1);
}

TEST(OccluderScene, NormalsAndBoundsAreThoseOfTheMesh)
{
  TestMesh mesh;
  mesh.AddBox({ 1.0, 2.0, 3.0 }, { 4.0, 6.0, 9.0 }, 0);
  const OccluderScene scene(mesh.View());
  EXPECT_EQ(scene.Bounds().Min.X, 1.0);
  EXPECT_EQ(scene.Bounds().Max.Z, 9.0);
  const Vector3 center = scene.Bounds().Center();
  for (vtkIdType t = 0; t < 12; ++t)
  {
    const Vector3 normal = scene.TriangleNormal(t);
    EXPECT_NEAR(Length(normal), 1.0, 1e-12);
    EXPECT_GT(Dot(normal, mesh.View().Corner(t, 0) - center), 0.0);
  }
}
