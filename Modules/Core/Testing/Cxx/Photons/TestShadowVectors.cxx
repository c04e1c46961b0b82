// SPDX-License-Identifier: BSD-3-Clause
// What photons leave behind: exact exits of boxes and sheets, receivers, and which occluders are closed.
#include "PhotonTesting.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scShadowVectors.h"
#include "scTriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace testsupport;
using namespace photontesting;

TEST(ShadowVectors, LeaveABoxAtItsExactExit)
{
  TestMesh mesh;
  const Box box{ { -0.5, -0.4, -0.3 }, { 0.6, 0.7, 0.2 } };
  mesh.AddBox(box.Min, box.Max, 3);
  const Light light = DiscLight({ 0.3, -0.2, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectorResult result = Trace(mesh, light, Photons(4000));
  const ShadowVectors& vectors = result.Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 1500u);
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 start = At(vectors.EmissionPoints, i);
    const Vector3 end = At(vectors.Points, i);
    const Vector3 direction = Normalized(end - start);
    double entry = 0.0;
    double exit = HUGE_VAL;
    ASSERT_TRUE(box.Clip(start, direction, entry, exit));
    EXPECT_NEAR(Length(end - start), exit, 1e-9);
    EXPECT_NEAR(vectors.PathLengths[i], exit, 1e-6);
    EXPECT_NEAR(vectors.Thicknesses[i], exit - entry, 1e-6);
    EXPECT_LT(Length(At(vectors.Directions, i) - direction), 1e-6);
    EXPECT_EQ(vectors.OccluderIds[i], 3);
    EXPECT_NEAR(start.Z, 3.0, 1e-12);
    EXPECT_LE(Length(start - light.Center), 0.5 + 1e-12);
    // Outward where the light would come out: the box's face through the point.
    const Vector3 normal = At(vectors.Normals, i);
    EXPECT_GT(Dot(normal, direction), 0.0);
    const Vector3 outside = end + 1e-6 * normal;
    EXPECT_FALSE(box.Contains(outside));
    EXPECT_TRUE(box.Contains(end - 1e-6 * normal - 1e-6 * direction));
  }
}

TEST(ShadowVectors, HitPointStoresTheEntry)
{
  TestMesh mesh;
  const Box box{ { -0.5, -0.4, -0.3 }, { 0.6, 0.7, 0.2 } };
  mesh.AddBox(box.Min, box.Max, 3);
  const Light light = PointLight({ 2.0, -1.0, 3.0 });
  const ShadowVectorResult back = Trace(mesh, light, Photons(2000));
  const ShadowVectorResult hit = Trace(mesh, light, Photons(2000, VectorStorage::HitPoint));
  ASSERT_EQ(back.Vectors.PhotonIndices, hit.Vectors.PhotonIndices);
  ASSERT_GT(hit.Vectors.OccluderIds.size(), 500u);
  for (std::size_t i = 0; i < hit.Vectors.OccluderIds.size(); ++i)
  {
    const Vector3 start = At(hit.Vectors.EmissionPoints, i);
    const Vector3 point = At(hit.Vectors.Points, i);
    const Vector3 direction = Normalized(point - start);
    double entry = 0.0;
    double exit = HUGE_VAL;
    ASSERT_TRUE(box.Clip(start, direction, entry, exit));
    EXPECT_NEAR(Length(point - start), entry, 1e-9);
    EXPECT_EQ(hit.Vectors.Thicknesses[i], back.Vectors.Thicknesses[i]);
    EXPECT_LT(Dot(At(hit.Vectors.Normals, i), direction), 0.0);
  }
}

TEST(ShadowVectors, StayOnAnOpenSheet)
{
  TestMesh mesh = Sheet(1.0);
  for (const double side : { 2.0, -2.0 }) // lit on its front and on its back
  {
    const Light light = DiscLight({ 0.0, 0.0, side }, { 0.0, 0.0, -side }, 0.3);
    for (const VectorStorage storage : { VectorStorage::BackSide, VectorStorage::HitPoint })
    {
      const ShadowVectors vectors = Trace(mesh, light, Photons(1000, storage)).Vectors;
      ASSERT_GT(vectors.OccluderIds.size(), 900u);
      for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
      {
        EXPECT_NEAR(vectors.Points[3 * i + 2], 0.0, 1e-12);
        EXPECT_EQ(vectors.Thicknesses[i], 0.0f);
        const double along = Dot(At(vectors.Normals, i), At(vectors.Directions, i));
        EXPECT_EQ(along > 0.0, storage == VectorStorage::BackSide);
      }
    }
  }
}

TEST(ShadowVectors, EveryOccluderOnThePathStoresOne)
{
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.2 }, 5);
  mesh.AddBox({ -1.0, -1.0, 1.0 }, { 1.0, 1.0, 1.2 }, 8);
  // One occluder in two parts, met twice: still one vector, at the exit of the part that is met first.
  mesh.AddBox({ -1.0, -1.0, 2.0 }, { 1.0, 1.0, 2.2 }, 9);
  mesh.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, -0.8 }, 9);
  const Light light = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  const ShadowVectorResult result = Trace(mesh, light, Photons(500));
  std::map<vtkIdType, std::vector<std::pair<double, int>>> found;
  for (std::size_t i = 0; i < result.Vectors.OccluderIds.size(); ++i)
  {
    found[result.Vectors.PhotonIndices[i]].emplace_back(
      result.Vectors.Points[3 * i + 2], result.Vectors.OccluderIds[i]);
  }
  ASSERT_GT(found.size(), 450u);
  for (const auto& [photon, vectors] : found)
  {
    ASSERT_EQ(vectors.size(), 3u) << photon;
    EXPECT_EQ(vectors[0].second, 9);
    EXPECT_NEAR(vectors[0].first, 2.0, 1e-9);
    EXPECT_EQ(vectors[1].second, 8);
    EXPECT_NEAR(vectors[1].first, 1.0, 1e-9);
    EXPECT_EQ(vectors[2].second, 5);
    EXPECT_NEAR(vectors[2].first, 0.0, 1e-9);
  }
  // The path ends at the first of them, and its shadow photon lies on the next.
  ASSERT_EQ(result.Photons.OccluderIds.size(), found.size());
  for (std::size_t i = 0; i < result.Photons.OccluderIds.size(); ++i)
  {
    EXPECT_EQ(result.Photons.OccluderIds[i], 9);
    EXPECT_EQ(result.Photons.ReceiverIds[i], 8);
    EXPECT_NEAR(result.Photons.Points[3 * i + 2], 1.2, 1e-9);
    EXPECT_GT(result.Photons.Normals[3 * i + 2], 0.99f);
  }
}

TEST(ShadowVectors, ReceiversEndPathsAndCatchShadowPhotons)
{
  TestMesh mesh;
  mesh.AddBox({ -0.5, -0.5, 1.0 }, { 0.5, 0.5, 1.4 }, 0);
  mesh.AddSheet({ -9.0, -9.0, 0.0 }, { 18.0, 0.0, 0.0 }, { 0.0, 18.0, 0.0 }, -1); // the floor
  mesh.AddBox({ -0.4, -0.4, -2.0 }, { 0.4, 0.4, -1.0 }, 1);                       // below it: no light gets there
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectorResult result = Trace(mesh, light, Photons(8000));

  std::map<vtkIdType, std::size_t> pathOf;
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
  {
    pathOf[result.Paths.PhotonIndices[i]] = i;
    blocked += result.Paths.States[i];
    EXPECT_EQ(result.Paths.OccluderIds[i], result.Paths.States[i] ? 0 : -1);
    const double z = result.Paths.Points[3 * i + 2];
    EXPECT_TRUE(result.Paths.States[i] ? z > 1.0 - 1e-9 : std::abs(z) < 1e-9) << z;
  }
  EXPECT_GT(blocked, 1000u);
  EXPECT_LT(blocked, result.Paths.States.size());

  ASSERT_EQ(result.Vectors.OccluderIds.size(), blocked);
  EXPECT_EQ(std::set<int>(result.Vectors.OccluderIds.begin(), result.Vectors.OccluderIds.end()), std::set<int>{ 0 });

  ASSERT_EQ(result.Photons.OccluderIds.size(), blocked);
  for (std::size_t i = 0; i < blocked; ++i)
  {
    EXPECT_EQ(result.Photons.ReceiverIds[i], -1);
    EXPECT_EQ(result.Photons.OccluderIds[i], 0);
    EXPECT_NEAR(result.Photons.Points[3 * i + 2], 0.0, 1e-9);
    const std::size_t path = pathOf.at(result.Photons.PhotonIndices[i]);
    EXPECT_EQ(result.Photons.Powers[i], -result.Paths.Powers[path]);
    // On the line of its photon.
    const Vector3 line = Normalized(At(result.Photons.Points, i) - At(result.Paths.EmissionPoints, path));
    EXPECT_LT(Length(line - At(result.Paths.Directions, path)), 1e-6);
  }
}

TEST(ShadowVectors, ASolidThatStandsOnOrInAReceiverIsLeftBelow)
{
  for (const double bottom : { 0.0, -0.1 })
  {
    TestMesh mesh;
    mesh.AddBox({ -0.2, -0.2, bottom }, { 0.2, 0.2, 1.0 }, 0);
    mesh.AddSheet({ -9.0, -9.0, 0.0 }, { 18.0, 0.0, 0.0 }, { 0.0, 18.0, 0.0 }, -1);
    const Light light = DiscLight({ 1.0, 0.5, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
    const ShadowVectors vectors = Trace(mesh, light, Photons(2000)).Vectors;
    ASSERT_GT(vectors.OccluderIds.size(), 500u);
    std::size_t through = 0;
    for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
    {
      EXPECT_GT(Dot(At(vectors.Normals, i), At(vectors.Directions, i)), 0.0);
      EXPECT_GE(vectors.Points[3 * i + 2], bottom - 1e-9);
      through += vectors.Points[3 * i + 2] < bottom + 1e-9;
    }
    EXPECT_GT(through, 10u); // some leave by the bottom
  }
}

TEST(ShadowVectors, PointOutwardBehindClosedSolidsEvenAtEdges)
{
  // A fine sphere: photons that hit edges must not be taken to have entered twice.
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 100, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectors vectors = Trace(mesh, light, Photons(100000)).Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 40000u);
  double shallow = 0;
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 point = At(vectors.Points, i);
    ASSERT_GT(Dot(At(vectors.Normals, i), At(vectors.Directions, i)), 0.0);
    // Entry and exit of the sphere itself, up to its tessellation.
    const Vector3 direction = At(vectors.Directions, i);
    const double chord = 2.0 * std::max(0.0, Dot(point, direction));
    shallow += std::abs(vectors.Thicknesses[i] - chord) > 0.1;
  }
  EXPECT_EQ(shallow, 0);
}

TEST(ShadowVectors, AnEdgeIsCrossedOnce)
{
  // A top of small squares, closed below by a pyramid. Beside the large floor it is so small that single precision leaves only
  // some 30,000 places on it: one photon in a hundred meets an edge exactly, and Embree reports both of its triangles.
  const int n = 64;
  TestMesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.AddPoint({ 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 0.0 });
    }
  }
  const vtkIdType tip = mesh.AddPoint({ 0.0, 0.0, -1.0 });
  const auto at = [n](int i, int j) { return static_cast<vtkIdType>(j * (n + 1) + i); };
  for (int k = 0; k < n; ++k)
  {
    mesh.AddTriangle(at(k + 1, 0), at(k, 0), tip, 0);
    mesh.AddTriangle(at(k, n), at(k + 1, n), tip, 0);
    mesh.AddTriangle(at(0, k), at(0, k + 1), tip, 0);
    mesh.AddTriangle(at(n, k + 1), at(n, k), tip, 0);
    for (int i = 0; i < n; ++i)
    {
      mesh.AddTriangle(at(i, k), at(i + 1, k), at(i + 1, k + 1), 0);
      mesh.AddTriangle(at(i, k), at(i + 1, k + 1), at(i, k + 1), 0);
    }
  }
  mesh.AddSheet({ -500.0, -600.0, -300.0 }, { 1000.0, 0.0, 0.0 }, { 0.0, 1000.0, 0.0 }, -1);
  const ShadowVectors vectors = Trace(mesh, SunLight({ 0.0, 0.0, -1.0 }, 0.0), Photons(20000)).Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 19000u);
  int shallow = 0;
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 p = At(vectors.Points, i);
    const double thickness = 1.0 - std::max(std::abs(p.X), std::abs(p.Y));
    shallow += std::abs(vectors.Thicknesses[i] - thickness) > 1e-3;
  }
  EXPECT_EQ(shallow, 0);
}

TEST(ShadowVectors, ALightInsideASolidIsStoppedByItsFarSide)
{
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 }, 0);
  const ShadowVectorResult result = Trace(mesh, PointLight({ 0.1, 0.2, 0.3 }), Photons(500));
  ASSERT_EQ(result.Vectors.OccluderIds.size(), 500u);
  for (std::size_t i = 0; i < 500u; ++i)
  {
    EXPECT_EQ(result.Vectors.Thicknesses[i], 0.0f);
    EXPECT_GT(Dot(At(result.Vectors.Normals, i), At(result.Vectors.Directions, i)), 0.0);
    const Vector3 p = At(result.Vectors.Points, i);
    EXPECT_NEAR(std::max({ std::abs(p.X), std::abs(p.Y), std::abs(p.Z) }), 1.0, 1e-9);
  }
}

TEST(ShadowVectors, DirectionsAndIndicesAreThoseOfTheirPaths)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 0.7, 12, 2);
  const ShadowVectorResult result = Trace(mesh, SphereLight({ 0.0, 1.0, 3.0 }, 0.4), Photons(3000));
  std::set<vtkIdType> blocked;
  for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
  {
    ASSERT_NEAR(Length(At(result.Paths.Directions, i)), 1.0, 1e-6);
    ASSERT_GT(result.Paths.Powers[i], 0.0f);
    if (result.Paths.States[i])
    {
      blocked.insert(result.Paths.PhotonIndices[i]);
    }
  }
  const std::set<vtkIdType> stored(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end());
  EXPECT_EQ(stored, blocked);
  EXPECT_TRUE(std::is_sorted(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end()));
  EXPECT_EQ(result.NumberOfPhotons, 3000);
}

TEST(ShadowVectors, LitPathsEndAtTheBoundsOfMeshAndLight)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 12, 0);
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 2.0);
  const PhotonPaths paths = Trace(mesh, light, Photons(2000)).Paths;
  int lit = 0;
  for (std::size_t i = 0; i < paths.States.size(); ++i)
  {
    if (paths.States[i] == 0)
    {
      ++lit;
      const Vector3 p = At(paths.Points, i);
      EXPECT_TRUE(
        std::abs(std::abs(p.X) - 2.0) < 1e-6 || std::abs(std::abs(p.Y) - 2.0) < 1e-6 || std::abs(p.Z + 1.0) < 1e-6);
    }
  }
  EXPECT_GT(lit, 100);
}

TEST(ShadowVectors, ALightThatFacesAwayLeavesNothing)
{
  const ShadowVectorResult result =
    Trace(Sheet(1.0), DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 0.5), Photons(500));
  EXPECT_TRUE(result.Vectors.OccluderIds.empty());
  EXPECT_TRUE(result.Paths.States.empty());
  EXPECT_EQ(result.NumberOfPhotons, 500);
}

TEST(ShadowVectors, ARoofThatReceivesShadesFromTheSunHoweverHigh)
{
  for (const double height : { 3.0, 300.0 })
  {
    TestMesh mesh = Sheet(1.0);
    mesh.AddSheet({ -5.0, -5.0, height }, { 10.0, 0.0, 0.0 }, { 0.0, 10.0, 0.0 }, -1);
    const ShadowVectorResult result = Trace(mesh, SunLight({ 0.0, 0.0, -1.0 }, 0.001), Photons(500));
    EXPECT_TRUE(result.Vectors.OccluderIds.empty()) << height;
  }
}

TEST(ClosedOccluders, NeedEveryEdgeBothWays)
{
  TestMesh mesh;
  mesh.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 7);
  mesh.AddSheet({ 5.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 3);
  mesh.AddSphere({ 9.0, 0.0, 0.0 }, 1.0, 6, -2);
  std::vector<bool> closed = ClosedOccluders(mesh.View());
  for (std::size_t t = 0; t < closed.size(); ++t)
  {
    EXPECT_EQ(closed[t], mesh.OccluderIds[t] != 3) << t;
  }
  // Corners of their own for every triangle, as where normals differ, change nothing.
  TestMesh apart = mesh;
  apart.Points.clear();
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const auto corner = mesh.Points.begin() + 3 * mesh.Triangles[i];
    apart.Points.insert(apart.Points.end(), corner, corner + 3);
    apart.Triangles[i] = static_cast<vtkIdType>(i);
  }
  EXPECT_EQ(ClosedOccluders(apart.View()), closed);
  // One triangle turned round opens its occluder and no other.
  std::swap(mesh.Triangles[0], mesh.Triangles[1]);
  closed = ClosedOccluders(mesh.View());
  EXPECT_FALSE(closed[0]);
  EXPECT_FALSE(closed[11]);
  EXPECT_TRUE(closed.back());
}
