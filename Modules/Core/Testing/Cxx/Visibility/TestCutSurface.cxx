// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that are cut stay whole: the same area, every side shared by two triangles or on the border.
#include "TestMeshes.h"
#include "scCutSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
double AreaOf(const CutSurface& surface)
{
  double area = 0.0;
  for (const CutSurface::Triangle& t : surface.Triangles)
  {
    const Vector3& a = surface.Points[static_cast<std::size_t>(t[0])];
    area += 0.5 *
      Length(Cross(
        surface.Points[static_cast<std::size_t>(t[1])] - a, surface.Points[static_cast<std::size_t>(t[2])] - a));
  }
  return area;
}

/// Length of the sides of one triangle only, and the longest side of all.
void Measure(const CutSurface& surface, double& border, double& longest)
{
  std::map<std::uint64_t, int> uses;
  std::map<std::uint64_t, double> lengths;
  for (const CutSurface::Triangle& t : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint64_t key = CutSurface::KeyOf(t[k], t[(k + 1) % 3]);
      ++uses[key];
      lengths[key] = Length(
        surface.Points[static_cast<std::size_t>(t[(k + 1) % 3])] - surface.Points[static_cast<std::size_t>(t[k])]);
    }
  }
  border = 0.0;
  longest = 0.0;
  for (const auto& [key, count] : uses)
  {
    EXPECT_LE(count, 2);
    border += count == 1 ? lengths[key] : 0.0;
    longest = std::max(longest, lengths[key]);
  }
}
} // namespace

TEST(CutSurface, KeepsItsAreaAndItsBorder)
{
  // Two sheets that meet in an edge, one of them long and thin; their common points stand twice.
  TestMesh mesh;
  mesh.AddSheet({ 0.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 0.25, 0.0 }, 0);
  mesh.AddSheet({ 0.0, 0.25, 0.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 0);
  CutSurface surface(mesh.View(), nullptr);
  EXPECT_EQ(surface.Points.size(), 6u) << "equal points are one";
  double border = 0.0;
  double longest = 0.0;
  surface.CutTo(0.2);
  Measure(surface, border, longest);
  EXPECT_NEAR(border, 2.0 * (3.0 + 2.25), 1e-6) << "a gap would have a border of its own";
  EXPECT_NEAR(AreaOf(surface), 3.0 * 2.25, 1e-6);
  EXPECT_LE(longest, 0.2);
  EXPECT_GT(longest, 0.05);

  // A few triangles are cut in four, their neighbours follow.
  std::vector<unsigned char> marked(surface.Triangles.size(), 0);
  const std::size_t before = marked.size();
  for (std::size_t k = 0; k < before; k += 7)
  {
    marked[k] = 1;
  }
  surface.CutMarked(marked);
  Measure(surface, border, longest);
  EXPECT_NEAR(border, 2.0 * (3.0 + 2.25), 1e-6);
  EXPECT_NEAR(AreaOf(surface), 3.0 * 2.25, 1e-6);
  EXPECT_GT(surface.Triangles.size(), before + 3 * (before / 7));
}

TEST(CutSurface, PointsWithUnlikeNormalsStayApart)
{
  TestMesh mesh;
  mesh.AddSheet({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0);
  mesh.AddSheet({ 0.0, 1.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 0);
  std::vector<double> normals;
  for (int k = 0; k < 8; ++k)
  {
    normals.insert(normals.end(), { 0.0, k < 4 ? 0.0 : -2.0, k < 4 ? 3.0 : 0.0 });
  }
  CutSurface surface(mesh.View(), normals.data());
  EXPECT_EQ(surface.Points.size(), 8u);
  surface.CutTo(0.6);
  for (const Vector3& normal : surface.Normals)
  {
    EXPECT_DOUBLE_EQ(Length(normal), 1.0);
  }
}
