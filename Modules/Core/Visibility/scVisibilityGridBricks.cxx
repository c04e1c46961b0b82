// SPDX-License-Identifier: BSD-3-Clause
// Cells of a visibility grid that are refined.
#include "scVisibilityGridFiller.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Call visit(a, b, c) for every point of a cube of that side, @p step apart.
template <typename Visitor>
void ForEachPoint(const std::array<int, 3>& corner, int side, int step, Visitor&& visit)
{
  for (int c = corner[2]; c <= corner[2] + side; c += step)
  {
    for (int b = corner[1]; b <= corner[1] + side; b += step)
    {
      for (int a = corner[0]; a <= corner[0] + side; a += step)
      {
        visit(a, b, c);
      }
    }
  }
}

/// Where the parts of each brick begin among all, and their number: parts of one brick stand together.
std::vector<std::size_t> BricksOf(const std::vector<BrickPart>& parts)
{
  std::vector<std::size_t> begins;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    if (p == 0 || parts[p].Brick != parts[p - 1].Brick)
    {
      begins.push_back(p);
    }
  }
  begins.push_back(parts.size());
  return begins;
}

/// Call visit(brick, first, last) for the parts [first, last) of each brick, by several threads.
template <typename Visitor>
void ForEachBrick(const std::vector<std::size_t>& bricks, const Visitor& visit)
{
  ParallelFor(static_cast<vtkIdType>(bricks.size()) - 1, {},
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto brick = static_cast<std::size_t>(begin); brick < static_cast<std::size_t>(end); ++brick)
      {
        visit(brick, bricks[brick], bricks[brick + 1]);
      }
    });
}
} // anonymous namespace

bool VisibilityGridFiller::NeedsBrick(int i, int j, int k) const
{
  float least = 1.0f;
  float most = 0.0f;
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::size_t id = this->Grid.VertexIndex(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2));
    if (!this->Grid.Marked[id])
    {
      return false;
    }
    least = std::min(least, this->Grid.Visibility[id]);
    most = std::max(most, this->Grid.Visibility[id]);
  }
  return most - least > this->Options.RefinementThreshold;
}

/// List the cells to be refined, with the corners of their bricks; each brick is one part.
bool VisibilityGridFiller::FindBricks(const Monitor& monitor, std::vector<BrickPart>& parts)
{
  VisibilityGrid& grid = this->Grid;
  const vtkIdType rows = std::max(0, this->Last[1] - this->First[1]); // of cells in a layer
  const auto collect = [&](vtkIdType row, const auto& found)
  {
    const int j = this->First[1] + static_cast<int>(row % rows);
    const int k = this->First[2] + static_cast<int>(row / rows);
    for (int i = this->First[0]; i < this->Last[0]; ++i)
    {
      if (this->NeedsBrick(i, j, k))
      {
        found(grid.CellIndex(i, j, k));
      }
    }
  };
  if (!CollectRows(rows * std::max(0, this->Last[2] - this->First[2]), monitor, collect, grid.BrickCells))
  {
    return false;
  }
  if (grid.BrickCells.empty())
  {
    return true;
  }
  const int side = this->Options.BrickParts;
  const auto values = static_cast<std::size_t>(side) + 1;
  grid.BrickParts = side;
  grid.BrickVisibility.resize(grid.BrickCells.size() * values * values * values);
  for (std::size_t brick = 0; brick < grid.BrickCells.size(); ++brick)
  {
    parts.push_back({ brick, { 0, 0, 0 } });
  }
  ForEachBrick(BricksOf(parts),
    [&](std::size_t brick, std::size_t, std::size_t)
    {
      const auto [i, j, k] = this->CellAt(grid.BrickCells[brick]);
      ForEachPoint({ 0, 0, 0 }, side, side,
        [&, i = i, j = j, k = k](int a, int b, int c)
        {
          this->BrickValue(brick, a, b, c) = grid.Visibility[grid.VertexIndex(
            static_cast<int>(i) + a / side, static_cast<int>(j) + b / side, static_cast<int>(k) + c / side)];
        });
    });
  return true;
}

/// Call visit(point, value) for the points of a part that are @p smaller apart and not its corners. Points are counted on
/// the grid that all cells would have if they were bricks.
template <typename Visitor>
void VisibilityGridFiller::ForEachInside(const BrickPart& part, int step, int smaller, const Visitor& visit)
{
  const int side = this->Grid.BrickParts;
  const vtkIdType nx = static_cast<vtkIdType>(this->Grid.Dimensions[0] - 1) * side + 1;
  const vtkIdType ny = static_cast<vtkIdType>(this->Grid.Dimensions[1] - 1) * side + 1;
  const auto [i, j, k] = this->CellAt(this->Grid.BrickCells[part.Brick]);
  const vtkIdType first = i * side + nx * (j * side + ny * (k * side));
  ForEachPoint(part.Corner, step, smaller,
    [&](int a, int b, int c)
    {
      const bool corner =
        (a - part.Corner[0]) % step == 0 && (b - part.Corner[1]) % step == 0 && (c - part.Corner[2]) % step == 0;
      if (!corner)
      {
        visit(first + a + nx * (b + ny * c), this->BrickValue(part.Brick, a, b, c));
      }
    });
}

/// Ask at the points inside cubes of side @p step that are @p smaller apart, once where several share one.
bool VisibilityGridFiller::AskInside(const std::vector<BrickPart>& parts, int step, int smaller, const Monitor& monitor)
{
  const VisibilityGrid& grid = this->Grid;
  const int side = grid.BrickParts;
  const vtkIdType nx = static_cast<vtkIdType>(grid.Dimensions[0] - 1) * side + 1;
  const vtkIdType ny = static_cast<vtkIdType>(grid.Dimensions[1] - 1) * side + 1;
  const std::vector<std::size_t> bricks = BricksOf(parts);
  const auto along = static_cast<std::size_t>(step / smaller) + 1;
  const std::size_t inside = along * along * along - 8;
  std::vector<vtkIdType> points(inside * parts.size());
  ForEachBrick(bricks,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::size_t at = inside * first;
      for (std::size_t p = first; p < last; ++p)
      {
        this->ForEachInside(parts[p], step, smaller, [&](vtkIdType point, float&) { points[at++] = point; });
      }
    });
  vtkSMPTools::Sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<float> values(points.size(), 1.0f);
  const TeamShare share(this->Options.Workers, static_cast<vtkIdType>(points.size()), pointsPerBlock);
  TeamJoin join(this->Options.Workers);
  join.AddItems(values, share);
  const auto ask = [&](vtkIdType begin, vtkIdType end)
  {
    vtkIdType rays = 0;
    VisibilitySampler::Answer answer;
    for (vtkIdType p = begin; p < end; ++p)
    {
      const vtkIdType point = points[static_cast<std::size_t>(p)];
      const Vector3 place{ grid.Spacing.X * (static_cast<double>(point % nx) / side),
        grid.Spacing.Y * (static_cast<double>(point / nx % ny) / side),
        grid.Spacing.Z * (static_cast<double>(point / nx / ny) / side) };
      if (this->Asked.Ask(grid.Origin + place, answer, rays))
      {
        values[static_cast<std::size_t>(p)] = answer.Fraction;
      }
    }
    return rays;
  };
  const bool done = this->AskShare(share, join, monitor, ask);
  const auto valueOf = [&](vtkIdType point)
  { return values[static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin())]; };
  ForEachBrick(bricks,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        this->ForEachInside(parts[p], step, smaller, [&](vtkIdType point, float& value) { value = valueOf(point); });
      }
    });
  return done;
}

/// Cut a cube of side @p step into those of side @p smaller, filled from their corners; add those that need more.
void VisibilityGridFiller::SplitPart(const BrickPart& part, int step, int smaller, std::vector<BrickPart>& unresolved)
{
  ForEachPoint(part.Corner, step - smaller, smaller,
    [&](int a0, int b0, int c0)
    {
      float corners[8] = {};
      float* corner = corners;
      ForEachPoint({ a0, b0, c0 }, smaller, smaller,
        [&](int a, int b, int c) { *corner++ = this->BrickValue(part.Brick, a, b, c); });
      const auto range = std::minmax_element(corners, corners + 8);
      if (*range.second - *range.first > this->Options.RefinementThreshold)
      {
        unresolved.push_back({ part.Brick, { a0, b0, c0 } });
      }
      const auto within = [smaller](int from, int to)
      { return CellCoordinate(static_cast<double>(to - from) / smaller, 2); };
      ForEachPoint({ a0, b0, c0 }, smaller, 1,
        [&](int a, int b, int c)
        {
          this->BrickValue(part.Brick, a, b, c) =
            static_cast<float>(ValueAt(corners, 2, 2, within(a0, a), within(b0, b), within(c0, c)));
        });
    });
}

/// Split all cubes, those of a brick in their order.
void VisibilityGridFiller::Split(const std::vector<BrickPart>& parts, int step, int smaller, std::vector<BrickPart>& unresolved)
{
  const std::vector<std::size_t> bricks = BricksOf(parts);
  std::vector<std::vector<BrickPart>> found(bricks.size() - 1);
  ForEachBrick(bricks,
    [&](std::size_t brick, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        this->SplitPart(parts[p], step, smaller, found[brick]);
      }
    });
  unresolved.clear();
  for (const std::vector<BrickPart>& ofBrick : found)
  {
    unresolved.insert(unresolved.end(), ofBrick.begin(), ofBrick.end());
  }
}

bool VisibilityGridFiller::FillBricks(const Monitor& monitor)
{
  std::vector<BrickPart> parts;
  std::vector<BrickPart> unresolved;
  if (!this->FindBricks(monitor.Part(0.0, 0.05), parts))
  {
    return false;
  }
  // In halves, as long as the number of parts allows, so that points are asked for where values change only.
  double from = 0.05;
  for (int step = this->Options.BrickParts; step > 1 && !parts.empty();)
  {
    const int smaller = step % 2 == 0 ? step / 2 : 1;
    const double to = smaller == 1 ? 1.0 : 0.5 * (from + 1.0);
    if (!this->AskInside(parts, step, smaller, monitor.Part(from, to)))
    {
      return false;
    }
    this->Split(parts, step, smaller, unresolved);
    parts.swap(unresolved);
    step = smaller;
    from = to;
  }
  return true;
}

} // namespace shadowcones
