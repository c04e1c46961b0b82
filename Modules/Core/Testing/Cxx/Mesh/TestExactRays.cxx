// SPDX-License-Identifier: BSD-3-Clause
// Rays through corners and edges, next to huge triangles, along a lamp's plane; memory that runs out.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scLampPlane.h"
#include "scLightSampling.h"
#include "scOccluderScene.h"
#include "scRandom.h"
#include "scTriangleCrossing.h"
#include "scTriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// Turned by two angles about z and x, then moved.
Vector3 Turned(const Vector3& p, double a, double b, const Vector3& offset)
{
  const double x = std::cos(a) * p.X - std::sin(a) * p.Y;
  const double y = std::sin(a) * p.X + std::cos(a) * p.Y;
  return Vector3{ x, std::cos(b) * y - std::sin(b) * p.Z, std::sin(b) * y + std::cos(b) * p.Z } + offset;
}

void Turn(TestMesh& mesh, double a, double b, const Vector3& offset)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    const Vector3 p = Turned({ mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2] }, a, b, offset);
    mesh.Points[i] = p.X;
    mesh.Points[i + 1] = p.Y;
    mesh.Points[i + 2] = p.Z;
  }
}

/// A closed box around the origin, half as long as @p half, each side a grid of n x n quads with shared corners.
TestMesh GridBox(const Vector3& half, int n)
{
  TestMesh mesh;
  std::vector<vtkIdType> ids(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
  const auto point = [&](int i, int j, int k)
  {
    vtkIdType& id = ids[static_cast<std::size_t>((k * (n + 1) + j) * (n + 1) + i)];
    if (id < 0)
    {
      id = mesh.AddPoint({ half.X * (2.0 * i / n - 1.0), half.Y * (2.0 * j / n - 1.0), half.Z * (2.0 * k / n - 1.0) });
    }
    return id;
  };
  for (int u = 0; u < n; ++u)
  {
    for (int v = 0; v < n; ++v)
    {
      for (int side = 0; side < 6; ++side)
      {
        const int w = side % 2 ? n : 0;
        const auto at = [&](int a, int b) {
          return side < 2 ? point(w, a, b) : side < 4 ? point(a, w, b) : point(a, b, w);
        };
        mesh.AddTriangle(at(u, v), at(u + 1, v), at(u + 1, v + 1), 0);
        mesh.AddTriangle(at(u, v), at(u + 1, v + 1), at(u, v + 1), 0);
      }
    }
  }
  return mesh;
}

/// From inside a closed convex surface, rays through every corner and the middle of every edge: how many get out?
int Leaks(const TestMesh& mesh, const Vector3& origin)
{
  const TriangleMeshView view = mesh.View();
  const OccluderScene scene(view);
  int leaks = 0;
  double x[64];
  double y[64];
  double z[64];
  int filled = 0;
  const auto ask = [&](const Vector3& target)
  {
    const Vector3 direction = Normalized(target - origin);
    RayHit hit;
    leaks += !scene.Occluded(origin, direction, 0.0, HUGE_VAL);
    leaks += !scene.Intersect(origin, direction, 0.0, HUGE_VAL, hit);
    x[filled] = direction.X;
    y[filled] = direction.Y;
    z[filled] = direction.Z;
    if (++filled == 64)
    {
      leaks += scene.OccludedFrom(origin, x, y, z, ~std::uint64_t(0), true) != ~std::uint64_t(0);
      filled = 0;
    }
  };
  for (vtkIdType i = 0; i < view.NumberOfPoints; ++i)
  {
    ask(view.Point(i));
  }
  for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      ask(0.5 * (view.Corner(t, k) + view.Corner(t, (k + 1) % 3)));
    }
  }
  return leaks;
}

/// Does a segment that avoids the triangle's edges by a wide margin cross it? By signed volumes.
int Crosses(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto volume = [](const Vector3& o, const Vector3& u, const Vector3& v, const Vector3& w)
  { return Dot(Cross(u - o, v - o), w - o); };
  const bool sides = volume(a, b, c, p) * volume(a, b, c, q) < 0.0;
  const double u = volume(p, q, a, b);
  const double v = volume(p, q, b, c);
  const double w = volume(p, q, c, a);
  return sides && ((u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0));
}

} // namespace

TEST(ExactRays, NothingLeaksThroughCornersAndEdges)
{
  for (int turn = 0; turn < 2; ++turn)
  {
    const Vector3 offset = turn ? Vector3{ 1000.0, -300.0, 50.0 } : Vector3();
    TestMesh box = GridBox({ 1.0, 0.7, 1.3 }, 40);
    Turn(box, 0.7 + turn, 0.4, offset);
    EXPECT_EQ(Leaks(box, offset), 0) << turn;
    EXPECT_EQ(Leaks(box, offset + Vector3{ 0.31, 0.12, -0.27 }), 0) << turn;
    TestMesh sphere;
    sphere.AddSphere({}, 1.0, 40, 0);
    Turn(sphere, 0.3, 1.1 + turn, offset);
    EXPECT_EQ(Leaks(sphere, offset), 0) << turn;
    EXPECT_EQ(Leaks(sphere, offset + Vector3{ 0.4, -0.2, 0.5 }), 0) << turn;
  }
}

TEST(ExactRays, NeedlesAreClosedToo)
{
  // A fan of needles around two poles: a thousandth wide at most.
  TestMesh mesh;
  constexpr int count = 3000;
  const vtkIdType low = mesh.AddPoint({ 0.0, 0.0, -1.0 });
  const vtkIdType high = mesh.AddPoint({ 0.0, 0.0, 1.0 });
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    mesh.AddPoint({ std::cos(angle), std::sin(angle), 0.0 });
  }
  for (int i = 0; i < count; ++i)
  {
    mesh.AddTriangle(low, 2 + i, 2 + (i + 1) % count, 0);
    mesh.AddTriangle(high, 2 + i, 2 + (i + 1) % count, 0);
  }
  Turn(mesh, 0.2, 0.9, {});
  EXPECT_EQ(Leaks(mesh, { 0.05, 0.02, 0.1 }), 0);
}

TEST(ExactRays, OneLargeTriangleThatSharesEdgesWithSmallOnesHasNoSeam)
{
  // A floor of ratio x 1 whose one long side is cut into small triangles; rays straight down onto the seam and beside it.
  for (const double ratio : { 1e2, 1e4, 1e6, 1e7 })
  {
    TestMesh mesh;
    constexpr int parts = 16;
    const vtkIdType far = mesh.AddPoint({ 0.3, -ratio, 0.0 });
    const vtkIdType left = mesh.AddPoint({ -ratio, 0.0, 0.0 });
    const vtkIdType right = mesh.AddPoint({ ratio, 0.0, 0.0 });
    std::vector<vtkIdType> seam;
    for (int i = 0; i <= parts; ++i)
    {
      seam.push_back(mesh.AddPoint({ -0.5 + 1.0 * i / parts, 0.0, 0.0 }));
    }
    mesh.AddTriangle(far, seam.front(), left, 0);
    mesh.AddTriangle(far, right, seam.back(), 0);
    mesh.AddTriangle(far, seam.back(), seam.front(), 0); // the large one, along all of the seam
    for (int i = 0; i < parts; ++i)
    {
      const vtkIdType tip = mesh.AddPoint({ -0.5 + (i + 0.5) / parts, 0.1, 0.0 });
      mesh.AddTriangle(seam[i], seam[i + 1], tip, 0);
    }
    Turn(mesh, 0.7, 0.4, {});
    const OccluderScene scene(mesh.View());
    const Vector3 down = Turned({ 0.0, 0.0, -1.0 }, 0.7, 0.4, {});
    int leaks = 0;
    for (int i = 1; i < 1000; ++i)
    {
      const double x = -0.5 + 0.001 * i;
      // On the seam, and so near to it on the side of the large triangle that nothing else is met.
      for (const double y : { 0.0, -1e-9, -1e-4, -0.05 })
      {
        const Vector3 from = Turned({ x, y, 0.03 }, 0.7, 0.4, {});
        leaks += !scene.Occluded(from, down, 0.0, HUGE_VAL);
        leaks += scene.Occluded(from, down, 0.0, 0.029);
        leaks += scene.Occluded(from, -down, 0.0, HUGE_VAL);
      }
    }
    EXPECT_EQ(leaks, 0) << ratio;
    EXPECT_LT(scene.NumberOfCells(), 100) << ratio;
  }
}

TEST(ExactRays, SmallThingsOnAHugeGround)
{
  // A plate of 2 mm above a turned ground; short segments near it, against every triangle by signed volumes.
  for (const double ground : { 10.0, 1e4, 1e6, 1e7 })
  {
    TestMesh mesh;
    mesh.AddSheet({ -ground, -0.7 * ground, 0.0 }, { 2.0 * ground, 0.0, 0.0 }, { 0.0, 2.0 * ground, 0.0 }, 0);
    mesh.AddBox({ -0.2, -0.2, 0.02 }, { 0.2, 0.2, 0.022 }, 1);
    mesh.AddSphere({ 1.0, 0.3, 0.3 }, 0.25, 6, 2);
    Turn(mesh, 0.7, 0.4, {});
    const TriangleMeshView view = mesh.View();
    const OccluderScene scene(view);
    int wrong = 0;
    int blocked = 0;
    std::vector<RayHit> hits;
    for (std::uint64_t i = 0; i < 1500; ++i)
    {
      RandomStream random(5, i);
      const Vector3 p = Turned({ 2.0 * random.Next() - 0.5, random.Next() - 0.5, 0.05 * random.Next() }, 0.7, 0.4, {});
      const Vector3 q =
        Turned({ 2.0 * random.Next() - 0.5, random.Next() - 0.5, 0.5 * random.Next() - 0.1 }, 0.7, 0.4, {});
      std::size_t crossings = 0;
      for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
      {
        crossings += Crosses(p, q, view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2));
      }
      const double length = Length(q - p);
      const Vector3 direction = (1.0 / length) * (q - p);
      scene.IntersectAll(p, direction, 0.0, length, hits);
      wrong += hits.size() != crossings;
      wrong += scene.Occluded(p, direction, 0.0, length) != (crossings > 0);
      RayHit nearest;
      wrong += scene.Intersect(p, direction, 0.0, length, nearest) != (crossings > 0);
      wrong += crossings > 0 && !hits.empty() && std::fabs(nearest.T - hits[0].T) > 1e-9;
      blocked += crossings > 0;
    }
    EXPECT_EQ(wrong, 0) << ground;
    EXPECT_GT(blocked, 200) << ground;
  }
}

TEST(ExactRays, EveryKindOfQueryDecidesAsTheRuleDoes)
{
  // Rays that pass edges, and end at planes, by all orders of magnitude from rounding to what nobody doubts.
  TestMesh mesh;
  mesh.AddSphere({}, 1.0, 12, 0);
  mesh.AddSheet({ -1.0, -1.2, -0.9 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 1.8 }, 1);
  const vtkIdType first = mesh.AddPoint({ -1.3, 0.2, 0.1 });
  mesh.AddPoint({ 1.4, 0.21, 0.1 });
  mesh.AddPoint({ 0.3, 0.2, 0.13 });
  mesh.AddTriangle(first, first + 1, first + 2, 2);
  Turn(mesh, 0.7, 0.4, { 3.0, -2.0, 5.0 });
  const TriangleMeshView view = mesh.View();
  const OccluderScene scene(view);
  int wrong[6] = {};
  struct
  {
    Vector3 Origins[8];
    Vector3 Directions[8];
    double Ends[8] = {};
    unsigned int Crossed = 0;
    int Count = 0;
  } packet; // of rays from anywhere
  int blocked = 0;
  constexpr std::uint64_t count = 6000;
  std::vector<RayHit> all;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    RandomStream random(11, i);
    const auto power = [&random](double low, double high)
    { return std::pow(10.0, low + (high - low) * random.Next()); };
    const auto sign = [&random]() { return random.Next() < 0.5 ? -1.0 : 1.0; };
    const auto triangle = static_cast<vtkIdType>(random.Next() * static_cast<double>(view.NumberOfTriangles));
    const Vector3 a = view.Corner(triangle, 0);
    const Vector3 b = view.Corner(triangle, 1);
    const Vector3 c = view.Corner(triangle, 2);
    const Vector3 normal = Normalized(Cross(b - a, c - a));
    const Vector3 along = Normalized(b - a);
    const Vector3 onEdge = a + random.Next() * (b - a);
    const Vector3 target = onEdge + sign() * power(-9.0, -3.0) * Cross(normal, along);
    const double turn = 2.0 * Pi * random.Next();
    const Vector3 direction = Normalized(std::cos(turn) * along + std::sin(turn) * Cross(normal, along) +
      sign() * power(-0.3, 1.0) * normal); // not along planes: see OccluderScene
    const double before = power(-6.0, 1.0);
    const Vector3 origin = target - before * direction;
    const double end = before + sign() * std::min(power(-9.0, 1.0), 0.9 * before);

    std::size_t crossed = 0;
    std::size_t crossedUnending = 0;
    for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
    {
      RayStretch ray{ origin, direction, 0.0, end };
      crossed += shadowcones::Crosses(ray, view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2));
      ray.End = HUGE_VAL;
      crossedUnending += shadowcones::Crosses(ray, view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2));
    }
    blocked += crossed > 0;
    RayHit hit;
    wrong[0] += scene.Occluded(origin, direction, 0.0, end) != (crossed > 0);
    wrong[1] += scene.Intersect(origin, direction, 0.0, end, hit) != (crossed > 0);
    scene.IntersectAll(origin, direction, 0.0, end, all);
    wrong[2] += all.size() != crossed;
    packet.Origins[packet.Count] = origin;
    packet.Directions[packet.Count] = direction;
    packet.Ends[packet.Count] = end;
    packet.Crossed |= crossed > 0 ? 1u << packet.Count : 0u;
    if (++packet.Count == 8)
    {
      wrong[5] += scene.OccludedPacket(packet.Origins, packet.Directions, packet.Ends, 8) != packet.Crossed;
      wrong[5] += scene.OccludedPacket(packet.Origins, packet.Directions, packet.Ends, 3) != (packet.Crossed & 7u);
      packet.Crossed = 0;
      packet.Count = 0;
    }
    Vector3 origins[8];
    Vector3 directions[8];
    RayHit hits[8];
    std::fill_n(origins, 8, origin);
    std::fill_n(directions, 8, direction);
    scene.IntersectPacket(origins, directions, 8, hits);
    double x[64];
    double y[64];
    double z[64];
    std::fill_n(x, 64, direction.X);
    std::fill_n(y, 64, direction.Y);
    std::fill_n(z, 64, direction.Z);
    const std::uint64_t asked = 0x8000000100ff0001;
    wrong[4] += scene.OccludedFrom(origin, x, y, z, asked, true) != (crossedUnending > 0 ? asked : 0);
    for (const RayHit& one : hits)
    {
      wrong[3] += (one.Triangle >= 0) != (crossedUnending > 0);
    }
  }
  for (const int number : wrong)
  {
    EXPECT_EQ(number, 0) << "kind " << (&number - wrong);
  }
  EXPECT_GT(blocked, 1000);
  EXPECT_LT(blocked, 5000);
}

TEST(ExactRays, WhatLiesInALampsPlaneIsPassedBy)
{
  // A ceiling of 20 x 20 quads in single precision, turned, with a round lamp in it: nothing is between them and the room.
  for (const double half : { 2.5, 50.0 })
  {
    TestMesh mesh;
    for (int i = 0; i < 20; ++i)
    {
      for (int j = 0; j < 20; ++j)
      {
        mesh.AddSheet({ half * (0.1 * i - 1.0), half * (0.1 * j - 1.0), 5.5 }, { 0.1 * half, 0.0, 0.0 },
          { 0.0, 0.1 * half, 0.0 }, 0);
      }
    }
    mesh.AddBox({ -0.5, -0.5, 3.0 }, { 0.5, 0.5, 3.1 }, 1);
    Turn(mesh, 0.7, 0.4, {});
    for (double& x : mesh.Points)
    {
      x = static_cast<float>(x);
    }
    const OccluderScene scene(mesh.View());
    const Vector3 center = Turned({ 0.013, 0.027, 5.5 }, 0.7, 0.4, {});
    const Light lamp = DiscLight(center, Turned({ 0.0, 0.0, -1.0 }, 0.7, 0.4, {}), 0.3);
    const FlatFace face = FlatFaceOf(lamp);
    ASSERT_TRUE(face.IsFlat);
    const RayRules rules = scene.RulesFor(face);
    int wrong = 0;
    for (std::uint64_t i = 0; i < 4000; ++i)
    {
      RandomStream random(3, i);
      const double depth = std::pow(10.0, -4.0 + 4.0 * random.Next());
      const Vector3 from =
        Turned({ half * (2.0 * random.Next() - 1.0), half * (2.0 * random.Next() - 1.0), 5.5 - depth }, 0.7, 0.4, {});
      const Vector3 to = SampleLightArea(lamp, random.Next(), random.Next()).Position - from;
      wrong += scene.Occluded(from, Normalized(to), 0.0, Length(to), rules);
    }
    EXPECT_EQ(wrong, 0) << half;
    // What hangs below the ceiling still hides the lamp, and rays from elsewhere still meet the ceiling.
    const Vector3 below = Turned({ 0.0, 0.0, 1.0 }, 0.7, 0.4, {});
    EXPECT_TRUE(scene.Occluded(below, Normalized(center - below), 0.0, Length(center - below), rules));
    EXPECT_TRUE(scene.Occluded(
      below, Normalized(2.0 * half * Turned({ 0.4, 0.0, 0.0 }, 0.7, 0.4, {}) + center - below), 0.0, HUGE_VAL));
  }
}

TEST(ExactRays, ALampOfTrianglesInOnePlaneIsFlat)
{
  Light lamp;
  lamp.Shape = LightShape::Mesh;
  lamp.Triangles.push_back({ Vector3{ 0, 0, 1 }, Vector3{ 0, 1, 1 }, Vector3{ 1, 0, 1 } });
  lamp.Triangles.push_back({ Vector3{ 5, 0, 1 }, Vector3{ 5, 1, 1 }, Vector3{ 6, 0, 1 } });
  lamp = Prepared(lamp);
  EXPECT_TRUE(FlatFaceOf(lamp).IsFlat);
  EXPECT_NEAR(FlatFaceOf(lamp).Normal.Z, -1.0, 1e-15);
  lamp.Triangles[1][2].Z = 1.001;
  EXPECT_FALSE(FlatFaceOf(Prepared(lamp)).IsFlat);
}

TEST(ExactRays, MemoryThatRunsOutIsSaid)
{
  TestMesh mesh;
  mesh.AddSphere({}, 1.0, 40, 0);
  OccluderSceneOptions options;
  options.MemoryLimit = 100000; // bytes; the points of 6,240 triangles alone take 225,000
  EXPECT_THROW(OccluderScene(mesh.View(), options), std::runtime_error);
  options.MemoryLimit = 1000000000;
  EXPECT_NO_THROW(OccluderScene(mesh.View(), options));
}
