// SPDX-License-Identifier: BSD-3-Clause
// Polygons as triangles: the shoelace formula gives the area, winding numbers say what is inside.
#include "scPolygonTriangulation.h"

#include "scFrame.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace shadowcones;

namespace
{

using Corner = std::array<double, 2>;
using Outline = std::vector<Corner>;

double Shoelace(const Outline& outline)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    sum += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * sum;
}

/// Sum of the angles under which the edges are seen from a point, in turns.
int Winding(const Outline& outline, const Corner& p)
{
  double angle = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    angle += std::remainder(std::atan2(b[1] - p[1], b[0] - p[0]) - std::atan2(a[1] - p[1], a[0] - p[0]), 2.0 * M_PI);
  }
  return static_cast<int>(std::lround(angle / (2.0 * M_PI)));
}

/// A plane, the way round and the first corner, all drawn from the seed.
struct Placement
{
  Frame Axes;
  Vector3 Origin;

  explicit Placement(RandomStream& random)
  {
    const Vector3 tilted = Normalized({ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.4 });
    const Vector3 normals[3] = { { 0.0, 0.0, 1.0 }, { -1.0, 0.0, 0.0 }, tilted };
    this->Axes = FrameAround(normals[static_cast<int>(3.0 * random.Next())]);
    this->Origin = random.Next() < 0.3 ? Vector3{ 1e6, -3e5, 2e5 } : Vector3{};
  }
  Vector3 At(const Corner& p) const { return this->Origin + p[0] * this->Axes.U + p[1] * this->Axes.V; }
};

void ExpectRight(Outline outline, RandomStream& random)
{
  if (random.Next() < 0.5)
  {
    std::reverse(outline.begin(), outline.end());
  }
  const auto first = static_cast<std::ptrdiff_t>(random.Next() * static_cast<double>(outline.size()));
  std::rotate(outline.begin(), outline.begin() + first, outline.end());
  const Placement placement(random);
  std::vector<Vector3> corners;
  Corner low = outline[0];
  Corner high = outline[0];
  for (const Corner& p : outline)
  {
    corners.push_back(placement.At(p));
    low = { std::min(low[0], p[0]), std::min(low[1], p[1]) };
    high = { std::max(high[0], p[0]), std::max(high[1], p[1]) };
  }
  std::vector<int> triangles;
  ASSERT_TRUE(TriangulatePolygon(corners, triangles));
  double area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const Vector3& a = corners[triangles[t]];
    area += 0.5 * Length(Cross(corners[triangles[t + 1]] - a, corners[triangles[t + 2]] - a));
  }
  const double size = std::hypot(high[0] - low[0], high[1] - low[1]);
  const double coordinates = Length(placement.Origin) + size;
  EXPECT_NEAR(area, std::abs(Shoelace(outline)), 1e-14 * coordinates * size * static_cast<double>(outline.size()));

  for (int k = 0; k < 20; ++k)
  {
    const Corner p{ low[0] + random.Next() * (high[0] - low[0]), low[1] + random.Next() * (high[1] - low[1]) };
    int inside = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3)
    {
      inside += std::abs(Winding({ outline[triangles[t]], outline[triangles[t + 1]], outline[triangles[t + 2]] }, p));
    }
    EXPECT_EQ(inside, std::abs(Winding(outline, p)));
  }
}

void ExpectRightAtMany(const Outline& outline)
{
  for (std::uint64_t k = 0; k < 8; ++k)
  {
    RandomStream random(1, k);
    ExpectRight(outline, random);
  }
}

bool IsRefused(const Outline& outline)
{
  std::vector<Vector3> corners;
  for (const Corner& p : outline)
  {
    corners.push_back({ p[0], 7.0, p[1] });
  }
  std::vector<int> triangles{ 1, 2, 3 };
  const bool refused = !TriangulatePolygon(corners, triangles);
  EXPECT_EQ(triangles.empty(), refused);
  return refused;
}

/// Around a point, at radii between 1 and 3: simple, with many corners that turn inward.
Outline Star(int count, RandomStream& random)
{
  Outline outline;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 2.0 * M_PI * (k + 0.8 * random.Next()) / count;
    const double radius = 1.0 + 2.0 * random.Next();
    outline.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return outline;
}

/// The border of unit cells that hang together like a tree, with a corner at each unit: its area is the number of cells.
Outline Maze(int side, RandomStream& random, int& cells)
{
  const int width = 2 * side + 1;
  std::set<std::pair<int, int>> filled{ { 1, 1 } };
  std::vector<std::pair<int, int>> path{ { 0, 0 } };
  constexpr int steps[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
  while (!path.empty())
  {
    const std::pair<int, int> at = path.back();
    std::vector<int> free;
    for (int d = 0; d < 4; ++d)
    {
      const int x = at.first + steps[d][0];
      const int y = at.second + steps[d][1];
      if (x >= 0 && x < side && y >= 0 && y < side && filled.count({ 2 * x + 1, 2 * y + 1 }) == 0)
      {
        free.push_back(d);
      }
    }
    if (free.empty())
    {
      path.pop_back();
      continue;
    }
    const int* step = steps[free[static_cast<std::size_t>(random.Next() * static_cast<double>(free.size()))]];
    path.push_back({ at.first + step[0], at.second + step[1] });
    filled.insert({ 2 * at.first + 1 + step[0], 2 * at.second + 1 + step[1] });
    filled.insert({ 2 * path.back().first + 1, 2 * path.back().second + 1 });
  }
  cells = static_cast<int>(filled.size());

  std::map<std::pair<int, int>, std::pair<int, int>> next;
  for (const std::pair<int, int>& cell : filled)
  {
    const int x = cell.first;
    const int y = cell.second;
    const auto border = [&](int dx, int dy, std::pair<int, int> from, std::pair<int, int> to)
    {
      if (filled.count({ x + dx, y + dy }) == 0)
      {
        next[from] = to;
      }
    };
    border(0, -1, { x, y }, { x + 1, y });
    border(1, 0, { x + 1, y }, { x + 1, y + 1 });
    border(0, 1, { x + 1, y + 1 }, { x, y + 1 });
    border(-1, 0, { x, y + 1 }, { x, y });
  }
  EXPECT_LT(static_cast<int>(next.size()), 4 * width * width);
  Outline outline;
  std::pair<int, int> p = next.begin()->first;
  for (std::size_t k = 0; k < next.size(); ++k)
  {
    outline.push_back({ static_cast<double>(p.first), static_cast<double>(p.second) });
    p = next[p];
  }
  return outline;
}

/// A square frame around @p side by @p side square holes, each joined by a bridge to the one below, the first to the frame.
Outline Courtyards(int side)
{
  Outline outline{ { 0.0, 0.0 } };
  for (int i = 0; i < side; ++i)
  {
    Outline back;
    for (int j = 0; j < side; ++j)
    {
      const double x = 2.0 * i + 1.0;
      const double y = 2.0 * j + 1.0;
      if (j == 0)
      {
        outline.push_back({ x, 0.0 });
        back.push_back({ x, 0.0 });
      }
      // Down to up along the left side; the rest of the hole on the way back.
      outline.push_back({ x, y });
      outline.push_back({ x, y + 1.0 });
      back.push_back({ x, y });
      back.push_back({ x + 1.0, y });
      back.push_back({ x + 1.0, y + 1.0 });
      back.push_back({ x, y + 1.0 });
    }
    outline.insert(outline.end(), back.rbegin() + 1, back.rend());
  }
  const double end = 2.0 * side + 1.0;
  outline.insert(outline.end(), { { end, 0.0 }, { end, end }, { 0.0, end } });
  return outline;
}

} // namespace

TEST(PolygonTriangulation, ConcaveOutlines)
{
  ExpectRightAtMany({ { 0, 0 }, { 2, 0 }, { 0.5, 0.5 }, { 0, 2 } });                           // an arrow
  ExpectRightAtMany({ { 0, 0 }, { 10, 0 }, { 10, 2 }, { 2, 2 }, { 2, 10 }, { 0, 10 } });       // an L
  ExpectRightAtMany({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 9, 0 }, { 9, 5 }, { 9, 9 }, { 0, 9 } }); // straight corners
  ExpectRightAtMany({ { 0, 0 }, { 5, 0 }, { 2.5, 2 }, { 0, 4 } }); // a flat corner of a quad
  ExpectRightAtMany({ { 0, 0 }, { 9, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 0, 9 }, { 0, 0 } }); // named again
  ExpectRightAtMany({ { 0, 0 }, { 3, 0 }, { 3, 4 }, { 7, 4 }, { 7, 0 }, { 10, 0 }, { 10, 10 }, { 7, 10 }, { 7, 6 },
    { 3, 6 }, { 3, 10 }, { 0, 10 }, { 0, 0 } }); // an H
  for (std::uint64_t k = 0; k < 100; ++k)
  {
    RandomStream random(2, k);
    ExpectRight(Star(4 + static_cast<int>(k % 40), random), random);
  }
}

TEST(PolygonTriangulation, MazesHaveTheAreaOfTheirCells)
{
  for (std::uint64_t k = 0; k < 20; ++k)
  {
    RandomStream random(3, k);
    int cells = 0;
    const Outline maze = Maze(2 + static_cast<int>(k % 6), random, cells);
    EXPECT_DOUBLE_EQ(Shoelace(maze), cells);
    ExpectRight(maze, random);
  }
}

TEST(PolygonTriangulation, HolesAreJoinedByBridges)
{
  ExpectRightAtMany({ { -10, -10 }, { 10, -10 }, { 10, 10 }, { -10, 10 }, { -10, -10 }, { -4, -4 }, { -4, 4 }, { 4, 4 },
    { 4, -4 }, { -4, -4 } });
  // Two holes on bridges from two corners; one more bridge that leads nowhere.
  ExpectRightAtMany({ { -10, -10 }, { 10, -10 }, { 10, 10 }, { 6, 6 }, { 6, 2 }, { 2, 2 }, { 2, 6 }, { 6, 6 },
    { 10, 10 }, { -10, 10 }, { -10, -10 }, { -8, -8 }, { -8, -2 }, { -2, -2 }, { -2, -8 }, { -8, -8 } });
  ExpectRightAtMany({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 0, 0 }, { 4, 5 } });
  for (int side = 1; side < 6; ++side)
  {
    const Outline outline = Courtyards(side);
    EXPECT_DOUBLE_EQ(Shoelace(outline), (2.0 * side + 1.0) * (2.0 * side + 1.0) - side * side);
    ExpectRightAtMany(outline);
  }
}

TEST(PolygonTriangulation, CornersOnStraightEdgesStayCorners)
{
  // Neighbours that use them leave no gap.
  std::vector<Vector3> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } };
  std::vector<int> triangles;
  ASSERT_TRUE(TriangulatePolygon(corners, triangles));
  std::set<int> used;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const Vector3& a = corners[triangles[t]];
    if (Length(Cross(corners[triangles[t + 1]] - a, corners[triangles[t + 2]] - a)) > 0.0)
    {
      used.insert(
        triangles.begin() + static_cast<std::ptrdiff_t>(t), triangles.begin() + static_cast<std::ptrdiff_t>(t) + 3);
    }
  }
  EXPECT_EQ(used.size(), corners.size());
}

TEST(PolygonTriangulation, WhatIsNotSimpleIsRefused)
{
  EXPECT_TRUE(IsRefused({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } })) << "a bow tie";
  EXPECT_TRUE(IsRefused({ { 0, 0 }, { 2, 1 }, { 2, 0 }, { 0, 1.5 } })) << "an uneven bow tie";
  Outline pentagram;
  Outline twice;
  for (int k = 0; k < 10; ++k)
  {
    const double angle = 0.8 * M_PI * k;
    twice.push_back({ std::cos(0.5 * angle), std::sin(0.5 * angle) });
    if (k < 5)
    {
      pentagram.push_back({ std::cos(angle), std::sin(angle) });
    }
  }
  EXPECT_TRUE(IsRefused(pentagram));
  EXPECT_TRUE(IsRefused(twice)) << "a pentagon walked twice";
  EXPECT_TRUE(
    IsRefused({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 0, 0 }, { 2, 2 }, { 4, 2 }, { 4, 4 }, { 2, 4 }, { 2, 2 } }))
    << "a hole that is walked the same way round";
}

TEST(PolygonTriangulation, WhatHasNoAreaIsAFan)
{
  for (const std::size_t count : { 0u, 1u, 2u, 3u, 4u, 6u })
  {
    std::vector<Vector3> corners;
    for (std::size_t k = 0; k < count; ++k)
    {
      corners.push_back({ 1.0 * static_cast<double>(k), 2.0 * static_cast<double>(k), 3.0 });
    }
    std::vector<int> triangles;
    EXPECT_TRUE(TriangulatePolygon(corners, triangles));
    EXPECT_EQ(triangles.size(), count < 3 ? 0u : 3 * (count - 2));
  }
}

TEST(PolygonTriangulation, EdgesThereAndBackHaveNoArea)
{
  const std::vector<std::vector<Vector3>> trees{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 } },
    { { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 } },
    { { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0 } } };
  for (const std::vector<Vector3>& corners : trees)
  {
    std::vector<int> triangles;
    EXPECT_TRUE(TriangulatePolygon(corners, triangles));
    for (std::size_t t = 0; t < triangles.size(); t += 3)
    {
      const Vector3& a = corners[triangles[t]];
      EXPECT_EQ(Length(Cross(corners[triangles[t + 1]] - a, corners[triangles[t + 2]] - a)), 0.0);
    }
  }
}

TEST(PolygonTriangulation, WarpedOutlinesAreSeenAlongTheirNormal)
{
  // Alternate corners of a hexagon lifted: the triangles still cover the plane hexagon once.
  std::vector<Vector3> corners;
  for (int k = 0; k < 6; ++k)
  {
    corners.push_back({ std::cos(M_PI * k / 3.0), std::sin(M_PI * k / 3.0), k % 2 ? 0.3 : 0.0 });
  }
  std::vector<int> triangles;
  ASSERT_TRUE(TriangulatePolygon(corners, triangles));
  double area = 0.0;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    const Vector3& a = corners[triangles[t]];
    const double part = 0.5 * Cross(corners[triangles[t + 1]] - a, corners[triangles[t + 2]] - a).Z;
    EXPECT_GT(part, 0.0);
    area += part;
  }
  EXPECT_NEAR(area, 1.5 * std::sqrt(3.0), 1e-12);
}
