// SPDX-License-Identifier: BSD-3-Clause
// The visible fraction on a grid: against the probe, marks, bricks, extents, and packets of rays.
#include "scVisibilityGrid.h"

#include "TestMeshes.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
const Box room{ { -1.5, -1.4, -0.3 }, { 1.6, 1.5, 4.1 } };

Light MakeLight(LightShape shape)
{
  Light light;
  light.Shape = shape;
  light.Radius = shape == LightShape::Sun ? 0.1 : 0.4;
  light.AxisU = { 0.4, 0.0, 0.0 };
  light.AxisV = { 0.0, 0.3, 0.0 };
  light.Spectrum = { 1.0 };
  if (shape == LightShape::Mesh)
  {
    light.Triangles = { { Vector3{ -0.4, -0.4, 0.0 }, Vector3{ 0.4, -0.4, 0.0 }, Vector3{ 0.0, 0.4, 0.0 } } };
  }
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

/// A tilted sheet over the light, and a cone that holds its shadow.
struct Sheet
{
  Sheet()
  {
    this->Mesh.AddSheet({ -0.4, -0.3, 1.53 }, { 0.9, 0.0, 0.1 }, { 0.0, 0.7, 0.0 }, 3);
    Cone cone;
    cone.Center = { 0.05, 0.05, 1.5 };
    cone.Axis = { 0.0, 0.0, 1.0 };
    cone.Normal = cone.Axis;
    cone.BaseRadius = 0.7;
    cone.HalfAngle = std::atan(1.1 / 1.5);
    cone.OccluderId = 3;
    this->Cones = { cone };
  }
  VisibilityGrid Fill(const Light& light, VisibilityGridOptions options, const Box& bounds = room) const
  {
    const OccluderScene scene(this->Mesh.View());
    VisibilityGrid grid;
    EXPECT_TRUE(FillVisibilityGrid(
      this->Cones, light, options.Method == VisibilityMethod::Exact ? &scene : nullptr, bounds, options, {}, grid));
    return grid;
  }

  TestMesh Mesh;
  std::vector<Cone> Cones;
};

VisibilityGridOptions Options(int parts)
{
  VisibilityGridOptions options;
  options.Dimensions = { 17, 18, 25 };
  options.BrickParts = parts;
  return options;
}

/// Where the light sends nothing: behind it, or inside a sphere.
bool IsDark(const Light& light, const Vector3& point)
{
  const bool flat =
    light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle || light.Shape == LightShape::Mesh;
  return (flat && point.Z <= 0.0) || (light.Shape == LightShape::Sphere && Length(point) <= light.Radius);
}

void ExpectProbeAtVertices(const Sheet& sheet, const Light& light, VisibilityMethod method)
{
  VisibilityGridOptions options = Options(1);
  options.Method = method;
  const VisibilityGrid grid = sheet.Fill(light, options);
  const OccluderScene scene(sheet.Mesh.View());
  VisibilityOptions asked;
  asked.Method = method;
  asked.NumberOfLightSamples = options.NumberOfLightSamples;
  const VisibilityProbe probe(sheet.Cones, light, method == VisibilityMethod::Exact ? &scene : nullptr, room, asked);
  int shadowed = 0;
  int different = 0;
  for (int k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.Dimensions[0]; ++i)
      {
        const std::size_t id = grid.VertexIndex(i, j, k);
        const PointVisibility truth = probe.At(grid.Vertex(i, j, k));
        const bool behind = IsDark(light, grid.Vertex(i, j, k));
        EXPECT_FALSE(behind && grid.Marked[id]);
        if (!behind)
        {
          different += grid.Visibility[id] != static_cast<float>(truth.Fraction);
          different += grid.ShadowClasses[id] != static_cast<unsigned char>(truth.Class);
        }
        shadowed += grid.Visibility[id] < 1.0f;
      }
    }
  }
  EXPECT_EQ(different, 0) << "shape " << static_cast<int>(light.Shape);
  EXPECT_GT(shadowed, 100) << "shape " << static_cast<int>(light.Shape);
}

struct SavedBrick
{
  std::size_t Index;
  std::array<vtkIdType, 3> Cell;
};

std::vector<SavedBrick> BricksOf(const VisibilityGrid& grid)
{
  std::vector<SavedBrick> bricks;
  const vtkIdType nx = grid.Dimensions[0] - 1;
  const vtkIdType ny = grid.Dimensions[1] - 1;
  for (std::size_t b = 0; b < grid.BrickCells.size(); ++b)
  {
    const vtkIdType cell = grid.BrickCells[b];
    bricks.push_back({ b, { cell % nx, cell / nx % ny, cell / nx / ny } });
  }
  return bricks;
}
} // namespace

TEST(VisibilityGrid, VerticesHaveTheValuesOfTheProbe)
{
  const Sheet sheet;
  for (const LightShape shape : { LightShape::Disc, LightShape::Rectangle, LightShape::Sphere, LightShape::Point,
         LightShape::Sun, LightShape::Mesh })
  {
    ExpectProbeAtVertices(sheet, MakeLight(shape), VisibilityMethod::Exact);
  }
}

TEST(VisibilityGrid, SoftVerticesHaveTheValuesOfTheProbe)
{
  const Sheet sheet;
  for (const LightShape shape : { LightShape::Disc, LightShape::Sphere, LightShape::Sun })
  {
    ExpectProbeAtVertices(sheet, MakeLight(shape), VisibilityMethod::Soft);
  }
}

TEST(VisibilityGrid, SoftTakesTheAngleFromTheLight)
{
  // The cone's own angle may be made for something else.
  Sheet sheet;
  const VisibilityGridOptions options = []
  {
    VisibilityGridOptions soft = Options(1);
    soft.Method = VisibilityMethod::Soft;
    return soft;
  }();
  const VisibilityGrid wide = sheet.Fill(MakeLight(LightShape::Disc), options);
  sheet.Cones[0].HalfAngle = 0.0;
  EXPECT_EQ(sheet.Fill(MakeLight(LightShape::Disc), options).Visibility, wide.Visibility);
}

TEST(VisibilityGrid, OnlyCellsThatAConeReachesAreAskedFor)
{
  const Sheet sheet;
  const VisibilityGrid grid = sheet.Fill(MakeLight(LightShape::Disc), Options(1));
  const auto marked = std::count(grid.Marked.begin(), grid.Marked.end(), 1);
  EXPECT_GT(marked, 1000);
  EXPECT_LT(marked, static_cast<std::ptrdiff_t>(2 * grid.Marked.size() / 3));
  EXPECT_EQ(grid.NumberOfOcclusionRays, 16 * marked);
  for (std::size_t id = 0; id < grid.Marked.size(); ++id)
  {
    EXPECT_TRUE(grid.Marked[id] || (grid.Visibility[id] == 1.0f && grid.ShadowClasses[id] == 0));
  }
}

TEST(VisibilityGrid, ThinConesMarkTheCellsTheyPass)
{
  Sheet sheet;
  sheet.Cones[0].Center = { 0.04, 0.06, 1.5 };
  sheet.Cones[0].BaseRadius = 0.001;
  sheet.Cones[0].HalfAngle = 0.0;
  const VisibilityGrid grid = sheet.Fill(MakeLight(LightShape::Disc), Options(1));
  for (double z = 1.51; z < 4.0; z += 0.1)
  {
    const int i = static_cast<int>((0.04 - grid.Origin.X) / grid.Spacing.X);
    const int j = static_cast<int>((0.06 - grid.Origin.Y) / grid.Spacing.Y);
    const int k = static_cast<int>((z - grid.Origin.Z) / grid.Spacing.Z);
    for (int corner = 0; corner < 8; ++corner)
    {
      EXPECT_TRUE(grid.Marked[grid.VertexIndex(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2))]) << z;
    }
  }
}

TEST(VisibilityGrid, WithoutConesEverythingIsLit)
{
  Sheet sheet;
  sheet.Cones.clear();
  const VisibilityGrid grid = sheet.Fill(MakeLight(LightShape::Disc), Options(2));
  EXPECT_EQ(std::count(grid.Visibility.begin(), grid.Visibility.end(), 1.0f), 17 * 18 * 25);
  EXPECT_EQ(std::count(grid.Marked.begin(), grid.Marked.end(), 0), 17 * 18 * 25);
  EXPECT_EQ(grid.NumberOfOcclusionRays, 0);
  EXPECT_TRUE(grid.BrickCells.empty());
}

TEST(VisibilityGrid, BricksAreWhereCornersDiffer)
{
  const Sheet sheet;
  for (const int parts : { 2, 3, 4, 6 })
  {
    const VisibilityGrid grid = sheet.Fill(MakeLight(LightShape::Disc), Options(parts));
    const auto side = static_cast<std::size_t>(parts) + 1;
    ASSERT_GT(grid.BrickCells.size(), 50u);
    EXPECT_TRUE(std::is_sorted(grid.BrickCells.begin(), grid.BrickCells.end()));
    EXPECT_EQ(grid.BrickVisibility.size(), grid.BrickCells.size() * side * side * side);
    EXPECT_EQ(grid.BrickParts, parts);
    std::size_t found = 0;
    for (int k = 0; k + 1 < grid.Dimensions[2]; ++k)
    {
      for (int j = 0; j + 1 < grid.Dimensions[1]; ++j)
      {
        for (int i = 0; i + 1 < grid.Dimensions[0]; ++i)
        {
          float values[8];
          for (int corner = 0; corner < 8; ++corner)
          {
            values[corner] =
              grid.Visibility[grid.VertexIndex(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2))];
          }
          const bool refined =
            std::binary_search(grid.BrickCells.begin(), grid.BrickCells.end(), grid.CellIndex(i, j, k));
          EXPECT_EQ(refined, *std::max_element(values, values + 8) - *std::min_element(values, values + 8) > 0.5f);
          found += refined;
        }
      }
    }
    EXPECT_EQ(found, grid.BrickCells.size());
  }
}

TEST(VisibilityGrid, BrickValuesAreThoseOfTheirPoints)
{
  // Three parts have no halves to stop at: all points are asked for, those on faces get one value in both bricks.
  const Sheet sheet;
  const Light light = MakeLight(LightShape::Disc);
  const VisibilityGrid grid = sheet.Fill(light, Options(3));
  const OccluderScene scene(sheet.Mesh.View());
  VisibilityOptions asked;
  asked.NumberOfLightSamples = 16;
  const VisibilityProbe probe(sheet.Cones, light, &scene, room, asked);
  int different = 0;
  std::size_t v = 0;
  for (const SavedBrick& brick : BricksOf(grid))
  {
    for (int c = 0; c <= 3; ++c)
    {
      for (int b = 0; b <= 3; ++b)
      {
        for (int a = 0; a <= 3; ++a, ++v)
        {
          const Vector3 place{ grid.Spacing.X * ((3.0 * static_cast<double>(brick.Cell[0]) + a) / 3),
            grid.Spacing.Y * ((3.0 * static_cast<double>(brick.Cell[1]) + b) / 3),
            grid.Spacing.Z * ((3.0 * static_cast<double>(brick.Cell[2]) + c) / 3) };
          const Vector3 point = grid.Origin + place;
          different += grid.BrickVisibility[v] != static_cast<float>(probe.At(point).Fraction);
          // A point on a face may be read from the other side, where the cell need not be refined.
          if (std::min({ a, b, c }) > 0 && std::max({ a, b, c }) < 3)
          {
            EXPECT_NEAR(VisibilityAt(grid, point), grid.BrickVisibility[v], 1e-6);
          }
        }
      }
    }
  }
  EXPECT_EQ(v, grid.BrickVisibility.size());
  EXPECT_EQ(different, 0);
}

TEST(VisibilityGrid, HalvesStopWhereValuesAgree)
{
  const Sheet sheet;
  const VisibilityGrid halves = sheet.Fill(MakeLight(LightShape::Disc), Options(4));
  const VisibilityGrid all = sheet.Fill(MakeLight(LightShape::Disc), Options(5));
  EXPECT_EQ(halves.BrickCells, all.BrickCells);
  EXPECT_LT(halves.NumberOfOcclusionRays, all.NumberOfOcclusionRays / 2);
  // A threshold of 0 leaves nothing out that differs, and 1 refines nothing.
  VisibilityGridOptions options = Options(4);
  options.RefinementThreshold = 0.0;
  EXPECT_GT(sheet.Fill(MakeLight(LightShape::Disc), options).BrickCells.size(), 2 * halves.BrickCells.size());
  options.RefinementThreshold = 1.0;
  EXPECT_TRUE(sheet.Fill(MakeLight(LightShape::Disc), options).BrickCells.empty());
}

TEST(VisibilityGrid, ValuesBetweenVerticesAreTrilinear)
{
  VisibilityGrid grid;
  grid.Origin = { 1.0, 2.0, 3.0 };
  grid.Spacing = { 0.5, 1.0, 2.0 };
  grid.Dimensions = { 3, 2, 2 };
  for (int id = 0; id < 12; ++id)
  {
    grid.Visibility.push_back(0.05f * static_cast<float>(id));
  }
  EXPECT_NEAR(VisibilityAt(grid, { 1.75, 2.25, 4.5 }), 0.05 * (1.5 + 3 * 0.25 + 6 * 0.75), 1e-6);
  EXPECT_NEAR(VisibilityAt(grid, { 2.0, 3.0, 5.0 }), 0.55, 1e-6);
  EXPECT_EQ(VisibilityAt(grid, { 2.01, 2.5, 4.0 }), 1.0);
  EXPECT_EQ(VisibilityAt(grid, { 1.5, 1.99, 4.0 }), 1.0);
  EXPECT_EQ(VisibilityAt(grid, { 1.5, 2.5, std::nan("") }), 1.0);
  grid.BrickParts = 2;
  grid.BrickCells = { 1 };
  grid.BrickVisibility.assign(27, 0.25f);
  grid.BrickVisibility[13] = 0.75f;
  EXPECT_NEAR(VisibilityAt(grid, { 1.75, 2.5, 4.0 }), 0.75, 1e-6);
  EXPECT_NEAR(VisibilityAt(grid, { 1.625, 2.5, 4.0 }), 0.5, 1e-6);
  EXPECT_NEAR(VisibilityAt(grid, { 1.25, 2.25, 4.5 }), 0.05 * (0.5 + 3 * 0.25 + 6 * 0.75), 1e-6);
}

TEST(VisibilityGrid, ExtentsGiveWhatTheWholeGives)
{
  const Sheet sheet;
  const Light light = MakeLight(LightShape::Disc);
  const VisibilityGrid whole = sheet.Fill(light, Options(4));
  std::vector<vtkIdType> cells;
  for (const bool upper : { false, true })
  {
    VisibilityGridOptions options = Options(4);
    options.Extent = { 0, 16, 0, 17, upper ? 13 : 0, upper ? 24 : 13 };
    const VisibilityGrid part = sheet.Fill(light, options);
    const auto from = static_cast<std::ptrdiff_t>(whole.VertexIndex(0, 0, options.Extent[4]));
    const auto to = static_cast<std::ptrdiff_t>(whole.VertexIndex(0, 0, options.Extent[5] + 1));
    EXPECT_TRUE(
      std::equal(whole.Visibility.begin() + from, whole.Visibility.begin() + to, part.Visibility.begin() + from));
    EXPECT_TRUE(std::equal(whole.Marked.begin() + from, whole.Marked.begin() + to, part.Marked.begin() + from));
    EXPECT_LT(
      std::count(part.Marked.begin(), part.Marked.end(), 1), std::count(whole.Marked.begin(), whole.Marked.end(), 1));
    const std::size_t values = 125;
    const std::size_t first = cells.size();
    cells.insert(cells.end(), part.BrickCells.begin(), part.BrickCells.end());
    ASSERT_LE(values * cells.size(), whole.BrickVisibility.size());
    EXPECT_TRUE(std::equal(part.BrickVisibility.begin(), part.BrickVisibility.end(),
      whole.BrickVisibility.begin() + static_cast<std::ptrdiff_t>(values * first)));
  }
  EXPECT_EQ(cells, whole.BrickCells);
}

TEST(VisibilityGrid, BoundsWithoutVolumeAndExtremeOptionsAreRefused)
{
  const Sheet sheet;
  const OccluderScene scene(sheet.Mesh.View());
  VisibilityGrid grid;
  const auto fill = [&](const Box& bounds, const std::function<void(VisibilityGridOptions&)>& change)
  {
    VisibilityGridOptions options = Options(2);
    change(options);
    FillVisibilityGrid(sheet.Cones, MakeLight(LightShape::Disc), &scene, bounds, options, {}, grid);
  };
  const auto keep = [](VisibilityGridOptions&) {};
  Box flat = room;
  flat.Max.Y = flat.Min.Y;
  EXPECT_THROW(fill(flat, keep), std::invalid_argument);
  EXPECT_THROW(fill(Box(), keep), std::invalid_argument);
  for (const std::function<void(VisibilityGridOptions&)>& change :
    std::initializer_list<std::function<void(VisibilityGridOptions&)>>{
      [](auto& o) { o.Dimensions = { 1, 9, 9 }; }, [](auto& o) { o.Dimensions = { 65536, 65536, 2 }; },
      [](auto& o) { o.NumberOfLightSamples = 0; }, [](auto& o) { o.NumberOfLightSamples = 2147483647; },
      [](auto& o) { o.BrickParts = 2147483647; }, [](auto& o) { o.RefinementThreshold = std::nan(""); } })
  {
    EXPECT_THROW(fill(room, change), std::invalid_argument);
  }
}

TEST(VisibilityGrid, ItCanBeStopped)
{
  const Sheet sheet;
  const OccluderScene scene(sheet.Mesh.View());
  Monitor monitor;
  monitor.Aborted = [] { return true; };
  VisibilityGrid grid;
  EXPECT_FALSE(FillVisibilityGrid(sheet.Cones, MakeLight(LightShape::Disc), &scene, room, Options(2), monitor, grid));
}

TEST(VisibilityGrid, PacketsOfRaysHitWhatSingleRaysHit)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.1, 0.2, 0.3 }, 1.0, 12, 0);
  const OccluderScene scene(mesh.View());
  RandomStream random(3, 1);
  int hits = 0;
  for (const double distance : { 0.5, 2.0, 30.0, 1e5 })
  {
    for (int point = 0; point < 50; ++point)
    {
      const Vector3 from =
        distance * Normalized(Vector3{ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 });
      double x[64];
      double y[64];
      double z[64];
      for (int k = 0; k < 64; ++k)
      {
        // Towards and beyond the sphere, and some that stop before it.
        const Vector3 end{ 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0, 4.0 * random.Next() - 2.0 };
        x[k] = end.X - from.X;
        y[k] = end.Y - from.Y;
        z[k] = end.Z - from.Z;
      }
      const std::uint64_t wanted = random.NextWord();
      for (const bool infinity : { false, true })
      {
        std::uint64_t expected = 0;
        for (int k = 0; k < 64; ++k)
        {
          Vector3 to{ x[k], y[k], z[k] };
          const double length = Length(to);
          to = (1.0 / length) * to;
          const double end = infinity ? HUGE_VAL : length;
          const bool hit = ((wanted >> k) & 1u) && scene.Occluded(from, to, 0.0, end);
          expected |= static_cast<std::uint64_t>(hit) << k;
          x[k] = infinity ? to.X : x[k];
          y[k] = infinity ? to.Y : y[k];
          z[k] = infinity ? to.Z : z[k];
          hits += hit;
        }
        EXPECT_EQ(scene.OccludedFrom(from, x, y, z, wanted, infinity), expected) << distance;
      }
    }
  }
  EXPECT_GT(hits, 1000);
}
