// SPDX-License-Identifier: BSD-3-Clause
// Occluder topology on hand-made meshes: every count, winding and label is known in advance.
#include "TestMeshes.h"
#include "scOccluderTopology.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

struct Mesh : TestMesh
{
  std::vector<int> Blocks;

  vtkIdType Add(double x, double y, double z) { return this->AddPoint({ x, y, z }); }
  void Face(vtkIdType a, vtkIdType b, vtkIdType c) { this->AddTriangle(a, b, c); }
  void Flip(std::size_t t) { std::swap(this->Triangles[3 * t + 1], this->Triangles[3 * t + 2]); }
  std::size_t Count() const { return this->Triangles.size() / 3; }
};

/// A cube of 12 outward triangles on 8 points.
void AddCube(Mesh& mesh, double x, double y, double z, double size = 1.0)
{
  vtkIdType p[8];
  for (int i = 0; i < 8; ++i)
  {
    p[i] = mesh.Add(x + size * (i & 1), y + size * ((i >> 1) & 1), z + size * (i >> 2));
  }
  const int quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 } };
  for (const auto& q : quads)
  {
    mesh.Face(p[q[0]], p[q[1]], p[q[2]]);
    mesh.Face(p[q[0]], p[q[2]], p[q[3]]);
  }
}

OccluderTopology Build(const Mesh& mesh, const OccluderTopologyOptions& options = {})
{
  OccluderTopology result;
  EXPECT_TRUE(
    BuildOccluderTopology(mesh.View(), mesh.Blocks.empty() ? nullptr : mesh.Blocks.data(), options, Monitor(), result));
  return result;
}

double Volume(const Mesh& mesh, const OccluderTopology& topology)
{
  double volume = 0.0;
  const Vector3 origin = mesh.View().Point(topology.Points[0]);
  for (std::size_t t = 0; t < topology.InputTriangles.size(); ++t)
  {
    Vector3 p[3];
    for (int k = 0; k < 3; ++k)
    {
      p[k] = mesh.View().Point(topology.Points[topology.Triangles[3 * t + k]]) - origin;
    }
    volume += Dot(p[0], Cross(p[1], p[2])) / 6.0;
  }
  return volume;
}

/// A grid of quads around a ring; with @p twist its ends are joined upside down: a Moebius strip.
Mesh Strip(int segments, bool twist)
{
  Mesh mesh;
  for (int i = 0; i < segments; ++i)
  {
    const double a = 2.0 * Pi * i / segments;
    const double half = twist ? 0.5 * a : 0.0;
    for (const double s : { -0.3, 0.3 })
    {
      const double r = 1.0 + s * std::cos(half);
      mesh.Add(r * std::cos(a), r * std::sin(a), s * std::sin(half) + (twist ? 0.0 : s));
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    const bool last = i + 1 == segments;
    const vtkIdType a = 2 * i;
    const vtkIdType b = a + 1;
    const vtkIdType c = last ? (twist ? 1 : 0) : a + 2;
    const vtkIdType d = last ? (twist ? 0 : 1) : a + 3;
    mesh.Face(a, c, b);
    mesh.Face(b, c, d);
  }
  return mesh;
}

} // namespace

TEST(OccluderTopology, CubeIsLeftAlone)
{
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.Triangles, mesh.Triangles);
  EXPECT_EQ(topology.OccluderIds, std::vector<int>(12, 0));
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 });
  EXPECT_EQ(topology.WeldedPoints, 0);
  EXPECT_EQ(topology.DegenerateTriangles, 0);
  EXPECT_EQ(topology.DuplicateTriangles, 0);
  EXPECT_EQ(topology.FlippedTriangles, 0);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.BoundaryEdges, 0);
}

TEST(OccluderTopology, FlipsWhatIsWoundInward)
{
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  for (const std::size_t t : { 0, 3, 7 })
  {
    mesh.Flip(t);
  }
  OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.FlippedTriangles, 3);
  EXPECT_NEAR(Volume(mesh, topology), 1.0, 1e-14);

  for (std::size_t t = 0; t < 12; ++t)
  {
    mesh.Flip(t);
  }
  topology = Build(mesh);
  EXPECT_EQ(topology.FlippedTriangles, 9);
  EXPECT_NEAR(Volume(mesh, topology), 1.0, 1e-14);

  OccluderTopologyOptions options;
  options.Orient = false;
  topology = Build(mesh, options);
  EXPECT_EQ(topology.FlippedTriangles, 0);
  EXPECT_EQ(topology.Triangles, mesh.Triangles);
  EXPECT_EQ(topology.Closed[0], 1) << "closedness is a matter of edges, not of winding";
}

TEST(OccluderTopology, OpenSheetFlipsTheFewest)
{
  Mesh mesh = Strip(12, false);
  mesh.Flip(5);
  mesh.Flip(20);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.FlippedTriangles, 2);
  EXPECT_EQ(topology.BoundaryEdges, 24);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 0 });
}

TEST(OccluderTopology, MoebiusStripIsOpenAndDoesNotCrash)
{
  const OccluderTopology topology = Build(Strip(15, true));
  EXPECT_EQ(topology.InputTriangles.size(), 30u);
  EXPECT_EQ(topology.BoundaryEdges, 30);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 0 });
}

TEST(OccluderTopology, WeldsASoupOfTriangles)
{
  Mesh cube;
  AddCube(cube, 0, 0, 0);
  Mesh soup;
  for (std::size_t i = 0; i < cube.Triangles.size(); ++i)
  {
    const Vector3 p = cube.View().Point(cube.Triangles[i]);
    // Zero of either sign is the same place.
    soup.Add(p.X == 0.0 && i % 2 ? -0.0 : p.X, p.Y, p.Z);
  }
  for (vtkIdType t = 0; t < 12; ++t)
  {
    soup.Face(3 * t, 3 * t + 1, 3 * t + 2);
  }
  for (const double tolerance : { 0.0, 1e-9, 1e-3 })
  {
    OccluderTopologyOptions options;
    options.WeldTolerance = tolerance;
    const OccluderTopology topology = Build(soup, options);
    EXPECT_EQ(topology.WeldedPoints, 28) << tolerance;
    EXPECT_EQ(topology.Points.size(), 8u) << tolerance;
    EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 }) << tolerance;
    EXPECT_NEAR(Volume(soup, topology), 1.0, 1e-14) << tolerance;
  }
}

TEST(OccluderTopology, WeldToleranceIsAShareOfTheShortestEdgeAnywhere)
{
  // Pairs of corners at 0.9 and 1.1 tolerances: welded or not, wherever the grid's cells lie, of all sizes side by side.
  for (const double far : { 0.0, 1e6 })
  {
    const double tolerance = 1e-4;
    Mesh mesh;
    for (std::uint64_t i = 0; i < 500; ++i)
    {
      RandomStream random(7, i);
      const double edge = std::pow(10.0, 2.0 * random.Next());
      const double x = far + 1000.0 * random.Next();
      const double y = far + 1000.0 * random.Next();
      const double angle = 6.28 * random.Next();
      const double distance = (i % 2 ? 1.1 : 0.9) * tolerance * edge;
      const vtkIdType first = mesh.Add(x, y, far);
      mesh.Add(x + edge, y, far);
      mesh.Add(x, y + 2.0 * edge, far);
      // The other triangle is larger: the smaller edge of the two counts.
      const vtkIdType second = mesh.Add(x + distance * std::cos(angle), y + distance * std::sin(angle), far);
      mesh.Add(x - 30.0 * edge, y, far);
      mesh.Add(x, y - 40.0 * edge, far);
      mesh.Face(first, first + 1, first + 2);
      mesh.Face(second, second + 1, second + 2);
    }
    OccluderTopologyOptions options;
    options.WeldTolerance = tolerance;
    const OccluderTopology topology = Build(mesh, options);
    EXPECT_EQ(topology.DegenerateTriangles, 0) << far;
    EXPECT_EQ(topology.WeldedPoints, 250) << far;
  }
}

TEST(OccluderTopology, NothingSmallIsLostNextToSomethingLarge)
{
  // A unit cube, a plate of 2 mm and 2 um beside a ground of 1e7: 12 triangles each, and 2.
  for (const double ground : { 1e4, 1e6, 1e7 })
  {
    Mesh mesh;
    AddCube(mesh, 0, 0, 0.5);
    for (const double thickness : { 2e-3, 2e-6 })
    {
      Mesh plate;
      AddCube(plate, 0, 0, 0);
      const auto first = static_cast<vtkIdType>(mesh.Points.size() / 3);
      for (std::size_t i = 0; i < plate.Points.size(); i += 3)
      {
        mesh.Add(3.0 + plate.Points[i], plate.Points[i + 1] + (thickness < 1e-3 ? 3.0 : 0.0), 0.5 + thickness * plate.Points[i + 2]);
      }
      for (std::size_t i = 0; i < plate.Triangles.size(); i += 3)
      {
        mesh.Face(first + plate.Triangles[i], first + plate.Triangles[i + 1], first + plate.Triangles[i + 2]);
      }
    }
    const vtkIdType corner = mesh.Add(-ground, -ground, 0.0);
    mesh.Add(ground, -ground, 0.0);
    mesh.Add(ground, ground, 0.0);
    mesh.Add(-ground, ground, 0.0);
    mesh.Face(corner, corner + 1, corner + 2);
    mesh.Face(corner, corner + 2, corner + 3);
    const OccluderTopology topology = Build(mesh);
    EXPECT_EQ(topology.InputTriangles.size(), 38u) << ground;
    EXPECT_EQ(topology.WeldedPoints, 0) << ground;
    EXPECT_EQ(topology.Closed, (std::vector<unsigned char>{ 1, 1, 1, 0 })) << ground;
  }
}

TEST(OccluderTopology, FansTakeLinearTime)
{
  // Looking around the hub for every triangle would take 150,000^2 steps, minutes.
  constexpr vtkIdType count = 150000;
  Mesh mesh;
  mesh.Add(0.0, 0.0, 0.0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * static_cast<double>(i) / count;
    mesh.Add(std::cos(angle), std::sin(angle), 0.0);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    mesh.Face(0, 1 + i, 1 + (i + 1) % count);
  }
  const std::clock_t start = std::clock();
  const OccluderTopology topology = Build(mesh);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10.0);
  EXPECT_EQ(topology.InputTriangles.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(topology.BoundaryEdges, count);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 0 });
}

TEST(OccluderTopology, DropsDegenerateAndDuplicateTriangles)
{
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  const vtkIdType middle = mesh.Add(0.5, 0, 0); // on the edge from point 0 to point 1
  mesh.Add(9, 9, 9);
  mesh.Face(0, 0, 1);
  mesh.Face(0, 1, middle);
  mesh.Face(mesh.Triangles[1], mesh.Triangles[2], mesh.Triangles[0]);
  mesh.Face(mesh.Triangles[0], mesh.Triangles[2], mesh.Triangles[1]);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.DegenerateTriangles, 2);
  EXPECT_EQ(topology.DuplicateTriangles, 2);
  EXPECT_EQ(topology.InputTriangles.size(), 12u);
  EXPECT_EQ(topology.InputTriangles.back(), 11);
  EXPECT_EQ(topology.Points.size(), 8u);
  EXPECT_EQ(topology.WeldedPoints, 0);
  EXPECT_EQ(topology.Closed[0], 1);
}

TEST(OccluderTopology, ThinTrianglesAreKept)
{
  Mesh mesh;
  mesh.Add(0, 0, 0);
  mesh.Add(1, 0, 0);
  mesh.Add(0.5, 1e-7, 0);
  mesh.Face(0, 1, 2);
  EXPECT_EQ(Build(mesh).DegenerateTriangles, 0);
}

TEST(OccluderTopology, FinOnACube)
{
  // A triangle stands on an edge of a cube wound inward: the cube is mended, the fin keeps its winding.
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  for (std::size_t t = 0; t < 12; ++t)
  {
    mesh.Flip(t);
  }
  const vtkIdType tip = mesh.Add(0.5, -1, -1);
  mesh.Face(0, 1, tip);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.NonManifoldEdges, 1);
  EXPECT_EQ(topology.BoundaryEdges, 2);
  EXPECT_EQ(topology.FlippedTriangles, 12);
  EXPECT_EQ(topology.Triangles[36], 0);
  EXPECT_EQ(topology.Triangles[37], 1);
  EXPECT_EQ(topology.OccluderIds, std::vector<int>(13, 0));
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 0 });
}

TEST(OccluderTopology, CubesThatTouchAreOrientedEach)
{
  // Two cubes that share an edge, and a third that shares a point with the second; the middle one is wound inward.
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  AddCube(mesh, 1, 1, 0);
  AddCube(mesh, 2, 2, 1);
  for (std::size_t t = 12; t < 24; ++t)
  {
    mesh.Flip(t);
  }
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.WeldedPoints, 3);
  EXPECT_EQ(topology.NonManifoldEdges, 1);
  EXPECT_EQ(topology.BoundaryEdges, 0);
  EXPECT_EQ(topology.FlippedTriangles, 12);
  EXPECT_NEAR(Volume(mesh, topology), 3.0, 1e-14);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 }) << "they share points: one occluder";
}

TEST(OccluderTopology, LabelsFollowTheFirstTriangle)
{
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  AddCube(mesh, 3, 0, 0);
  AddCube(mesh, 6, 0, 0);
  // The second cube's first triangle leads.
  for (int k = 0; k < 3; ++k)
  {
    std::swap(mesh.Triangles[k], mesh.Triangles[36 + k]);
  }
  mesh.Blocks.assign(36, 4);
  std::fill(mesh.Blocks.begin() + 24, mesh.Blocks.end(), 2);

  OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.Closed.size(), 3u);
  EXPECT_EQ(topology.OccluderIds[0], 0);
  EXPECT_EQ(topology.OccluderIds[1], 1);
  EXPECT_EQ(topology.OccluderIds[12], 1);
  EXPECT_EQ(topology.OccluderIds[13], 0);
  EXPECT_EQ(topology.OccluderIds[24], 2);

  OccluderTopologyOptions options;
  options.LabelBy = OccluderLabel::Block;
  topology = Build(mesh, options);
  EXPECT_EQ(topology.Closed, (std::vector<unsigned char>{ 1, 1 }));
  EXPECT_EQ(topology.OccluderIds[0], 0);
  EXPECT_EQ(topology.OccluderIds[35], 1);

  options.LabelBy = OccluderLabel::Whole;
  topology = Build(mesh, options);
  EXPECT_EQ(topology.OccluderIds, std::vector<int>(36, 0));
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 });
}

TEST(OccluderTopology, BlocksAreNotWelded)
{
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  AddCube(mesh, 1, 0, 0);
  mesh.Blocks.assign(12, 0);
  mesh.Blocks.resize(24, 1);
  OccluderTopologyOptions options;
  options.LabelBy = OccluderLabel::Block;
  const OccluderTopology blocks = Build(mesh, options);
  EXPECT_EQ(blocks.WeldedPoints, 0);
  EXPECT_EQ(blocks.NonManifoldEdges, 0);
  EXPECT_EQ(blocks.Closed, (std::vector<unsigned char>{ 1, 1 }));

  options.LabelBy = OccluderLabel::Component;
  const OccluderTopology components = Build(mesh, options);
  EXPECT_EQ(components.WeldedPoints, 4);
  EXPECT_EQ(components.NonManifoldEdges, 4) << "the wall between the cubes is there in both, on other diagonals";
  EXPECT_EQ(components.Closed.size(), 1u);
}

TEST(OccluderTopology, ReceiversAreNoOccluders)
{
  // A floor under a cube, on the cube's own points: neither joins the other.
  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  mesh.OccluderIds.assign(12, 5);
  const vtkIdType corner = mesh.Add(0.5, -4, 0);
  mesh.Face(0, 1, corner);
  mesh.OccluderIds.push_back(-3);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.OccluderIds.back(), -1);
  EXPECT_EQ(topology.OccluderIds.front(), 0);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.BoundaryEdges, 0);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 });
}

TEST(OccluderTopology, SizeAndPlaceDoNotMatter)
{
  const Mesh reference = []
  {
    Mesh mesh;
    AddCube(mesh, 0, 0, 0);
    mesh.Flip(2);
    return mesh;
  }();
  const OccluderTopology expected = Build(reference);
  for (const double scale : { 1e-3, 1e-120, 1e120 })
  {
    for (const double far : { 0.0, 1e6, -3e8 })
    {
      Mesh mesh = reference;
      for (double& x : mesh.Points)
      {
        x = scale * (x + far);
      }
      const OccluderTopology topology = Build(mesh);
      EXPECT_EQ(topology.Triangles, expected.Triangles) << scale << " " << far;
      EXPECT_EQ(topology.Closed, expected.Closed) << scale << " " << far;
      EXPECT_EQ(topology.DegenerateTriangles, 0) << scale << " " << far;
    }
  }
}

TEST(OccluderTopology, SmallFarAwayMeshKeepsItsTriangles)
{
  Mesh mesh;
  AddCube(mesh, 1e6, 1e6, 1e6, 1e-3);
  const OccluderTopology topology = Build(mesh);
  EXPECT_EQ(topology.InputTriangles.size(), 12u);
  EXPECT_EQ(topology.WeldedPoints, 0);
  EXPECT_EQ(topology.Closed, std::vector<unsigned char>{ 1 });
}

TEST(OccluderTopology, BoundsThatOverflowAreRefused)
{
  Mesh mesh;
  mesh.Add(-1.5e308, 0, 0);
  mesh.Add(1.5e308, 0, 0);
  mesh.Add(0, 1, 0);
  mesh.Face(0, 1, 2);
  OccluderTopology topology;
  EXPECT_THROW(
    BuildOccluderTopology(mesh.View(), nullptr, OccluderTopologyOptions(), Monitor(), topology), std::runtime_error);
}

TEST(OccluderTopology, RandomSoupsDoNotCrash)
{
  // Few points, many triangles: every kind of non-manifold meeting. Edges must add up.
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    RandomStream random(seed, 0);
    Mesh mesh;
    const int points = 4 + static_cast<int>(8 * random.Next());
    for (int i = 0; i < points; ++i)
    {
      mesh.Add(random.Next(), random.Next(), random.Next());
    }
    for (int t = 0; t < 40; ++t)
    {
      const auto pick = [&] { return static_cast<vtkIdType>(points * random.Next()); };
      const vtkIdType a = pick();
      const vtkIdType b = pick();
      mesh.Face(a, b, pick());
    }
    const OccluderTopology topology = Build(mesh);
    EXPECT_EQ(static_cast<vtkIdType>(topology.InputTriangles.size()) + topology.DegenerateTriangles +
        topology.DuplicateTriangles,
      40);
    EXPECT_EQ(topology.Triangles.size(), 3 * topology.InputTriangles.size());
    const OccluderTopology again = [&]
    {
      Mesh second;
      for (const vtkIdType id : topology.Points)
      {
        const Vector3 p = mesh.View().Point(id);
        second.Add(p.X, p.Y, p.Z);
      }
      second.Triangles = topology.Triangles;
      return Build(second);
    }();
    EXPECT_EQ(again.Triangles, topology.Triangles) << "a second pass finds nothing to mend, seed " << seed;
    EXPECT_EQ(again.OccluderIds, topology.OccluderIds);
    EXPECT_EQ(again.FlippedTriangles, 0);
  }
}

TEST(OccluderTopology, EmptyMeshAndAbort)
{
  const OccluderTopology empty = Build(Mesh());
  EXPECT_TRUE(empty.Points.empty());
  EXPECT_TRUE(empty.Closed.empty());

  Mesh mesh;
  AddCube(mesh, 0, 0, 0);
  Monitor monitor;
  double progress = -1.0;
  monitor.Progress = [&progress](double share)
  {
    EXPECT_GE(share, progress);
    progress = share;
  };
  OccluderTopology topology;
  EXPECT_TRUE(BuildOccluderTopology(mesh.View(), nullptr, OccluderTopologyOptions(), monitor, topology));
  EXPECT_EQ(progress, 1.0);
  monitor.Aborted = [] { return true; };
  progress = -1.0;
  EXPECT_FALSE(BuildOccluderTopology(mesh.View(), nullptr, OccluderTopologyOptions(), monitor, topology));
}
