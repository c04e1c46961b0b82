// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityGridSampler.h"

#include "LitScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr std::uint64_t everywhere = ~std::uint64_t(0);

/// Values of a function of place at the vertices, one unit apart, from the origin's plane on: 5 x 3 x 3.
VisibilityGrid SampleGrid(const std::function<double(const Vector3&)>& visibility)
{
  VisibilityGrid grid;
  grid.Origin = { 0.0, -1.0, -1.0 };
  grid.Spacing = { 1.0, 1.0, 1.0 };
  grid.Dimensions = { 5, 3, 3 };
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 5; ++i)
      {
        grid.Visibility.push_back(static_cast<float>(visibility(grid.Vertex(i, j, k))));
      }
    }
  }
  grid.ShadowClasses.assign(grid.Visibility.size(), 0);
  grid.Marked.assign(grid.Visibility.size(), 1);
  return grid;
}

/// A ray along x through the middle of the grid in even light: the hidden fraction is the mean of 1 - visibility.
struct EvenRay
{
  LitScene Scene{ SunLight({ 0.0, -1.0, 0.0 }, 0.0), 1e-6 };
  LitPixel Pixel = Scene.PixelOf(8, 8, 17);
  LitSums Sums{ Scene.Groups };

  double HiddenFraction(const VisibilityGrid& grid, double end = 5.0, std::uint64_t wanted = everywhere)
  {
    this->Sums.Add(this->Pixel, 5.0);
    const double all = this->Sums.Groups()[0];
    this->Sums.Add(this->Pixel, end);
    std::vector<double> hidden(1, 0.0);
    const VisibilityGridSampler sampler(grid);
    EXPECT_GE(sampler.Walk(this->Sums, wanted, hidden), 0);
    return hidden[0] / all;
  }
  std::uint64_t CellsInShadow(const VisibilityGrid& grid) const
  {
    return VisibilityGridSampler(grid).CellsInShadow({ { this->Pixel, this->Pixel, this->Pixel, this->Pixel } });
  }
};
} // namespace

TEST(VisibilityGridSampler, AllLitHidesNothing)
{
  EvenRay even;
  const VisibilityGrid grid = SampleGrid([](const Vector3&) { return 1.0; });
  EXPECT_EQ(even.HiddenFraction(grid), 0.0);
  EXPECT_EQ(even.CellsInShadow(grid), 0u);
}

TEST(VisibilityGridSampler, ReadsBetweenVertices)
{
  EvenRay even;
  // 1 up to x = 1, falling to 1/2 at x = 2, then 1/2.
  const VisibilityGrid grid = SampleGrid([](const Vector3& p) { return 1.0 - 0.5 * std::clamp(p.X - 1.0, 0.0, 1.0); });
  EXPECT_NEAR(even.HiddenFraction(grid), (0.25 + 2.0 * 0.5) / 4.0, 1e-4);
  EXPECT_NEAR(even.HiddenFraction(grid, 3.0), 0.25 / 4.0, 1e-4) << "up to x = 2";
  EXPECT_NEAR(even.HiddenFraction(grid, 2.0), 0.0, 1e-6) << "up to x = 1";
}

TEST(VisibilityGridSampler, AMaskSkipsLitCellsOnly)
{
  EvenRay even;
  VisibilityGrid grid = SampleGrid([](const Vector3&) { return 1.0; });
  grid.Visibility[grid.VertexIndex(4, 1, 1)] = 0.2f;
  const std::uint64_t mask = even.CellsInShadow(grid);
  EXPECT_NE(mask, 0u);
  EXPECT_EQ(even.HiddenFraction(grid, 5.0, mask), even.HiddenFraction(grid));
  EXPECT_GT(even.HiddenFraction(grid), 0.0);
  EXPECT_EQ(even.HiddenFraction(grid, 5.0, 0), 0.0);
}

TEST(VisibilityGridSampler, BeyondTheGridAllIsLit)
{
  EvenRay even;
  VisibilityGrid grid = SampleGrid([](const Vector3&) { return 0.0; });
  grid.Origin.X = 2.0; // from 2 to 6, of which the medium ends at 4
  EXPECT_NEAR(even.HiddenFraction(grid), 0.5, 0.01);
  grid.Origin.Y = 5.0;
  EXPECT_EQ(even.HiddenFraction(grid), 0.0);
  EXPECT_EQ(even.CellsInShadow(grid), 0u);
}

TEST(VisibilityGridSampler, BricksTakeThePlaceOfTheirCells)
{
  EvenRay even;
  VisibilityGrid grid = SampleGrid([](const Vector3&) { return 1.0; });
  // The four cells around the ray from x = 1 to 2 are hidden from the brick's vertex at 1.75 on.
  grid.BrickParts = 4;
  for (int cell = 0; cell < 4; ++cell)
  {
    grid.BrickCells.push_back(grid.CellIndex(1, cell % 2, cell / 2));
    for (int place = 0; place < 125; ++place)
    {
      grid.BrickVisibility.push_back(place % 5 >= 3 ? 0.0f : 1.0f);
    }
  }
  // From 1.5 to 1.75 it falls to 0: 3/8 of a unit is hidden in all.
  EXPECT_NEAR(even.HiddenFraction(grid), 0.375 / 4.0, 1e-3);
  EXPECT_NE(even.CellsInShadow(grid), 0u);
  EXPECT_EQ(even.HiddenFraction(grid, 5.0, even.CellsInShadow(grid)), even.HiddenFraction(grid));
}

TEST(VisibilityGridSampler, AgreesWithVisibilityAt)
{
  EvenRay even;
  const VisibilityGrid grid =
    SampleGrid([](const Vector3& p) { return 0.5 + 0.4 * std::sin(1.3 * p.X + p.Y) * std::cos(0.9 * p.Z); });
  constexpr int steps = 4000;
  double expected = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    expected += (1.0 - VisibilityAt(grid, { 4.0 * (k + 0.5) / steps, 0.0, 0.0 })) / steps;
  }
  EXPECT_NEAR(even.HiddenFraction(grid), expected, 1e-4);
}
