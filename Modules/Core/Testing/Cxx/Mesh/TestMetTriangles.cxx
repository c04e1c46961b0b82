// SPDX-License-Identifier: BSD-3-Clause
// All triangles that packets of rays from one point meet are those that single rays meet.
#include "scOccluderScene.h"

#include "scRandom.h"

#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{
using Met = std::vector<std::pair<int, vtkIdType>>;

/// @param scale of the small sphere: tiny ones cut space into cells.
void CompareWithSingleRays(double scale, const Vector3& from, bool infinity)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 12, 0);
  mesh.AddSphere({ 0.4, 0.1, 2.5 }, 0.7, 8, 1);
  mesh.AddSphere({ 0.0, 0.0, 4.0 }, scale, 6, 2);
  const OccluderScene scene(mesh.View());
  double x[64];
  double y[64];
  double z[64];
  RandomStream random(7, 1);
  for (int k = 0; k < 64; ++k)
  {
    const Vector3 to = Vector3{ 3.0 * random.Next() - 1.5, 3.0 * random.Next() - 1.5, 5.0 } - from;
    const double length = infinity ? Length(to) : 1.0;
    x[k] = to.X / length;
    y[k] = to.Y / length;
    z[k] = to.Z / length;
  }
  const std::uint64_t wanted = 0xF0F1FFFF12345677ull;
  std::vector<OccluderScene::MetTriangle> found;
  scene.TrianglesFrom(from, x, y, z, wanted, infinity, found);
  Met met;
  for (const OccluderScene::MetTriangle& triangle : found)
  {
    met.emplace_back(triangle.Ray, triangle.Triangle);
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());

  Met expected;
  std::uint64_t occluded = 0;
  std::vector<RayHit> hits;
  for (int k = 0; k < 64; ++k)
  {
    const Vector3 to{ x[k], y[k], z[k] };
    if ((wanted >> k) & 1u)
    {
      scene.IntersectAll(from, (1.0 / Length(to)) * to, 0.0, infinity ? HUGE_VAL : Length(to), hits);
      for (const RayHit& hit : hits)
      {
        expected.emplace_back(k, hit.Triangle);
        occluded |= std::uint64_t(1) << k;
      }
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(met, expected);
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(scene.OccludedFrom(from, x, y, z, wanted, infinity), occluded);
}
} // namespace

TEST(MetTriangles, OfPacketsAreThoseOfSingleRays)
{
  for (const bool infinity : { false, true })
  {
    CompareWithSingleRays(0.3, { 0.1, 0.2, -1.7 }, infinity);
    CompareWithSingleRays(0.3, { 0.1, 0.2, -40.0 }, infinity); // far away
    CompareWithSingleRays(1e-7, { 0.1, 0.2, -1.7 }, infinity); // in several cells
  }
}

TEST(MetTriangles, AnEmptySceneAndAPointThatIsNoneHaveNone)
{
  const double x[64] = {};
  std::vector<OccluderScene::MetTriangle> met{ { 1, 2 } };
  OccluderScene(TestMesh().View()).TrianglesFrom({}, x, x, x, ~std::uint64_t(0), false, met);
  EXPECT_TRUE(met.empty());
  TestMesh mesh;
  mesh.AddDisc({}, 1.0);
  OccluderScene(mesh.View()).TrianglesFrom({ HUGE_VAL, 0.0, 0.0 }, x, x, x, ~std::uint64_t(0), false, met);
  EXPECT_TRUE(met.empty());
}
