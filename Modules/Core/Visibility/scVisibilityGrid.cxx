// SPDX-License-Identifier: BSD-3-Clause
// One file because marking, filling and refining are steps of one grid and ask by one sampler.
#include "scVisibilityGrid.h"

#include "scConeHierarchy.h"
#include "scSurfelVisibility.h"
#include "scTrilinear.h"
#include "scVisibilitySampler.h"
#include "scWholeLight.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace shadowcones
{
namespace
{
/// Where along an axis of a grid, or brick, a coordinate lies: the vertex before it and the fraction of the way to the next.
struct CellCoordinate
{
  int Index;
  double Fraction;

  CellCoordinate(double coordinate, int vertices)
    : Index(std::clamp(static_cast<int>(coordinate), 0, vertices - 2))
    , Fraction(std::clamp(coordinate - this->Index, 0.0, 1.0))
  {
  }
};

/// @param values of a grid with @p nx, @p ny vertices along x and y.
double ValueAt(const float* values, std::size_t nx, std::size_t ny, const CellCoordinate& x, const CellCoordinate& y,
  const CellCoordinate& z)
{
  const auto at = [](const CellCoordinate& c) { return static_cast<std::size_t>(c.Index); };
  return Trilinear(values + (at(z) * ny + at(y)) * nx + at(x), 1, nx, nx * ny, x.Fraction, y.Fraction, z.Fraction);
}

/// The whole shadow of a base disc; of a disc next to the light, as wide as can be.
Cone WidePenumbraOf(const Cone& disc, const Light& light, const LightExtent& extent)
{
  constexpr double widest = 1.5;
  Cone penumbra;
  if (!PenumbraOf(disc, light, extent, penumbra))
  {
    penumbra.HalfAngle = widest;
  }
  return penumbra;
}

/// A cube inside a brick: its first corner in the brick's own grid. Its side is that of all cubes of the same round.
struct Part
{
  std::size_t Brick;
  std::array<int, 3> Corner;
};

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
std::vector<std::size_t> BricksOf(const std::vector<Part>& parts)
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

/// What collect(k, found) finds in layers first..last - 1, in their order. @return false where aborted.
template <typename Collector>
bool CollectLayers(int first, int last, const Monitor& monitor, const Collector& collect, std::vector<vtkIdType>& all)
{
  std::vector<std::vector<vtkIdType>> found(static_cast<std::size_t>(std::max(0, last - first)));
  if (!ParallelFor(static_cast<vtkIdType>(found.size()), monitor,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType layer = begin; layer < end; ++layer)
          {
            collect(first + static_cast<int>(layer), found[static_cast<std::size_t>(layer)]);
          }
        }))
  {
    return false;
  }
  for (const std::vector<vtkIdType>& layer : found)
  {
    all.insert(all.end(), layer.begin(), layer.end());
  }
  return true;
}

/// The steps of FillVisibilityGrid.
class Filler
{
public:
  Filler(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityGridOptions& options, VisibilityGrid& grid)
    : Cones(cones)
    , Lamp(light)
    , Options(options)
    , Grid(grid)
    , Asked(cones, light, scene, bounds, options)
  {
    grid = {};
    grid.Dimensions = options.Dimensions;
    grid.Origin = bounds.Min;
    const Vector3 size = bounds.Size();
    grid.Spacing = { size.X / (options.Dimensions[0] - 1), size.Y / (options.Dimensions[1] - 1),
      size.Z / (options.Dimensions[2] - 1) };
    const std::size_t count = grid.VertexIndex(0, 0, options.Dimensions[2]);
    grid.Visibility.assign(count, 1.0f);
    grid.ShadowClasses.assign(count, static_cast<unsigned char>(ShadowClass::Lit));
    grid.Marked.assign(count, 0);
    grid.Fluence.assign(options.Fluence ? count : 0, 0.0f);
    grid.FluenceErrors.assign(grid.Fluence.size(), 0.0f);
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool all = options.Extent[2 * axis] > options.Extent[2 * axis + 1];
      this->First[axis] = all ? 0 : std::max(0, options.Extent[2 * axis]);
      this->Last[axis] =
        all ? options.Dimensions[axis] - 1 : std::min(options.Dimensions[axis] - 1, options.Extent[2 * axis + 1]);
    }
  }

  bool Fill(const Box& bounds, const Monitor& monitor)
  {
    return this->Mark(bounds, monitor.Part(0.0, 0.1)) && this->FillVertices(monitor.Part(0.1, 0.5)) &&
      (this->Options.BrickParts < 2 || this->FillBricks(monitor.Part(0.5, 1.0)));
  }

private:
  bool Mark(const Box& bounds, const Monitor& monitor);
  bool FillWholeFluence(const Monitor& monitor);
  bool FillVertices(const Monitor& monitor);
  bool FillBricks(const Monitor& monitor);
  bool FindBricks(const Monitor& monitor, std::vector<Part>& parts);
  bool NeedsBrick(int i, int j, int k) const;
  template <typename Visitor>
  void ForEachInside(const Part& part, int step, int smaller, const Visitor& visit);
  bool AskInside(const std::vector<Part>& parts, int step, int smaller, const Monitor& monitor);
  void SplitPart(const Part& part, int step, int smaller, std::vector<Part>& unresolved);
  void Split(const std::vector<Part>& parts, int step, int smaller, std::vector<Part>& unresolved);
  std::array<vtkIdType, 3> CellAt(vtkIdType cell) const
  {
    const vtkIdType nx = this->Grid.Dimensions[0] - 1;
    const vtkIdType ny = this->Grid.Dimensions[1] - 1;
    return { cell % nx, cell / nx % ny, cell / nx / ny };
  }
  /// The value at a place of a brick's own grid.
  float& BrickValue(std::size_t brick, int a, int b, int c)
  {
    const auto side = static_cast<std::size_t>(this->Grid.BrickParts) + 1;
    const std::size_t row = (brick * side + static_cast<std::size_t>(c)) * side + static_cast<std::size_t>(b);
    return this->Grid.BrickVisibility[row * side + static_cast<std::size_t>(a)];
  }

  const std::vector<Cone>& Cones;
  const Light& Lamp;
  const VisibilityGridOptions& Options;
  VisibilityGrid& Grid;
  VisibilitySampler Asked;
  std::array<int, 3> First{};
  std::array<int, 3> Last{};
};

bool Filler::Mark(const Box& bounds, const Monitor& monitor)
{
  // Cones thinner than a cell are widened until they hold a vertex of every cell they pass.
  const double least = 0.5 * Length(this->Grid.Spacing);
  const LightExtent extent = LightExtentOf(this->Lamp);
  std::vector<Cone> reach;
  for (const Cone& cone : this->Cones)
  {
    reach.push_back(this->Options.Method == VisibilityMethod::Soft ? WidePenumbraOf(cone, this->Lamp, extent) : cone);
    reach.back().BaseRadius = std::max(reach.back().BaseRadius, least);
  }
  // Vertices on the faces of the box belong to it, whatever the rounding.
  const Vector3 margin = 0.5 * this->Grid.Spacing;
  const ConeHierarchy hierarchy(reach, { bounds.Min - margin, bounds.Max + margin });
  std::vector<unsigned char>& marks = this->Grid.Marked;
  if (!hierarchy.MarkGrid(this->Grid.Origin, this->Grid.Spacing, this->Grid.Dimensions, monitor, marks.data()))
  {
    return false;
  }
  // A vertex next to a cone belongs to a cell that the cone reaches: one more along each axis.
  std::vector<unsigned char> wide;
  std::size_t stride = 1;
  for (const int dimension : this->Grid.Dimensions)
  {
    wide = marks;
    const std::size_t line = stride * static_cast<std::size_t>(dimension);
    for (std::size_t begin = 0; begin < marks.size(); begin += line)
    {
      for (std::size_t id = begin; id + stride < begin + line; ++id)
      {
        wide[id] |= marks[id + stride];
        wide[id + stride] |= marks[id];
      }
    }
    marks.swap(wide);
    stride = line;
  }
  return true;
}

/// The fluence at all wanted vertices as if nothing were in the way, where it is asked for.
bool Filler::FillWholeFluence(const Monitor& monitor)
{
  VisibilityGrid& grid = this->Grid;
  const vtkIdType rows = this->Last[1] - this->First[1] + 1;
  const vtkIdType layers = this->Last[2] - this->First[2] + 1;
  return grid.Fluence.empty() ||
    ParallelFor(rows * layers, monitor,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const int j = this->First[1] + static_cast<int>(row % rows);
          const int k = this->First[2] + static_cast<int>(row / rows);
          for (int i = this->First[0]; i <= this->Last[0]; ++i)
          {
            grid.Fluence[grid.VertexIndex(i, j, k)] =
              static_cast<float>(WholeFluence(this->Lamp, grid.Vertex(i, j, k)));
          }
        }
      });
}

bool Filler::FillVertices(const Monitor& monitor)
{
  VisibilityGrid& grid = this->Grid;
  const int nx = grid.Dimensions[0];
  const int ny = grid.Dimensions[1];
  std::vector<vtkIdType> wanted;
  if (!this->FillWholeFluence(monitor.Part(0.0, 0.02)))
  {
    return false;
  }
  const auto collect = [&](int k, std::vector<vtkIdType>& found)
  {
    for (int j = 0; j < ny; ++j)
    {
      for (int i = 0; i < nx; ++i)
      {
        const std::size_t id = grid.VertexIndex(i, j, k);
        const bool inside = i >= this->First[0] && i <= this->Last[0] && j >= this->First[1] && j <= this->Last[1] &&
          k >= this->First[2] && k <= this->Last[2];
        grid.Marked[id] = inside ? grid.Marked[id] : 0;
        if (grid.Marked[id])
        {
          found.push_back(static_cast<vtkIdType>(id));
        }
      }
    }
  };
  if (!CollectLayers(0, grid.Dimensions[2], monitor.Part(0.02, 0.05), collect, wanted))
  {
    return false;
  }
  std::atomic<vtkIdType> sent{ 0 };
  const bool done = ParallelFor(static_cast<vtkIdType>(wanted.size()), monitor.Part(0.05, 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType rays = 0;
      for (vtkIdType w = begin; w < end; ++w)
      {
        const auto id = static_cast<std::size_t>(wanted[static_cast<std::size_t>(w)]);
        const auto i = static_cast<int>(id % nx);
        const auto j = static_cast<int>(id / nx % ny);
        const auto k = static_cast<int>(id / nx / ny);
        VisibilitySampler::Answer answer;
        grid.Marked[id] = this->Asked.Ask(grid.Vertex(i, j, k), answer, rays) ? 1 : 0;
        grid.Visibility[id] = answer.Fraction;
        grid.ShadowClasses[id] = static_cast<unsigned char>(answer.Class);
        if (!grid.Fluence.empty() && grid.Marked[id])
        {
          grid.Fluence[id] = static_cast<float>(answer.Fluence.Factor);
          grid.FluenceErrors[id] = static_cast<float>(answer.Fluence.Error);
        }
      }
      sent += rays;
    });
  grid.NumberOfOcclusionRays += sent;
  return done;
}

bool Filler::NeedsBrick(int i, int j, int k) const
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
bool Filler::FindBricks(const Monitor& monitor, std::vector<Part>& parts)
{
  VisibilityGrid& grid = this->Grid;
  const auto collect = [&](int k, std::vector<vtkIdType>& found)
  {
    for (int j = this->First[1]; j < this->Last[1]; ++j)
    {
      for (int i = this->First[0]; i < this->Last[0]; ++i)
      {
        if (this->NeedsBrick(i, j, k))
        {
          found.push_back(grid.CellIndex(i, j, k));
        }
      }
    }
  };
  if (!CollectLayers(this->First[2], this->Last[2], monitor, collect, grid.BrickCells))
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
void Filler::ForEachInside(const Part& part, int step, int smaller, const Visitor& visit)
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
bool Filler::AskInside(const std::vector<Part>& parts, int step, int smaller, const Monitor& monitor)
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
  std::atomic<vtkIdType> sent{ 0 };
  const bool done = ParallelFor(static_cast<vtkIdType>(points.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
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
      sent += rays;
    });
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
  this->Grid.NumberOfOcclusionRays += sent;
  return done;
}

/// Cut a cube of side @p step into those of side @p smaller, filled from their corners; add those that need more.
void Filler::SplitPart(const Part& part, int step, int smaller, std::vector<Part>& unresolved)
{
  ForEachPoint(part.Corner, step - smaller, smaller,
    [&](int a0, int b0, int c0)
    {
      float corners[8];
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
void Filler::Split(const std::vector<Part>& parts, int step, int smaller, std::vector<Part>& unresolved)
{
  const std::vector<std::size_t> bricks = BricksOf(parts);
  std::vector<std::vector<Part>> found(bricks.size() - 1);
  ForEachBrick(bricks,
    [&](std::size_t brick, std::size_t first, std::size_t last)
    {
      for (std::size_t p = first; p < last; ++p)
      {
        this->SplitPart(parts[p], step, smaller, found[brick]);
      }
    });
  unresolved.clear();
  for (const std::vector<Part>& ofBrick : found)
  {
    unresolved.insert(unresolved.end(), ofBrick.begin(), ofBrick.end());
  }
}

bool Filler::FillBricks(const Monitor& monitor)
{
  std::vector<Part> parts;
  std::vector<Part> unresolved;
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
} // anonymous namespace

double VisibilityAt(const VisibilityGrid& grid, const Vector3& point)
{
  double at[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] = (point[axis] - grid.Origin[axis]) / grid.Spacing[axis];
    if (!(at[axis] >= 0.0 && at[axis] <= grid.Dimensions[axis] - 1))
    {
      return 1.0;
    }
  }
  const CellCoordinate x(at[0], grid.Dimensions[0]);
  const CellCoordinate y(at[1], grid.Dimensions[1]);
  const CellCoordinate z(at[2], grid.Dimensions[2]);
  const vtkIdType cell = grid.CellIndex(x.Index, y.Index, z.Index);
  const auto found = std::lower_bound(grid.BrickCells.begin(), grid.BrickCells.end(), cell);
  if (found == grid.BrickCells.end() || *found != cell)
  {
    return ValueAt(grid.Visibility.data(), static_cast<std::size_t>(grid.Dimensions[0]),
      static_cast<std::size_t>(grid.Dimensions[1]), x, y, z);
  }
  const auto side = static_cast<std::size_t>(grid.BrickParts) + 1;
  const float* brick =
    grid.BrickVisibility.data() + static_cast<std::size_t>(found - grid.BrickCells.begin()) * side * side * side;
  const int vertices = grid.BrickParts + 1;
  return ValueAt(brick, side, side, CellCoordinate(x.Fraction * grid.BrickParts, vertices),
    CellCoordinate(y.Fraction * grid.BrickParts, vertices), CellCoordinate(z.Fraction * grid.BrickParts, vertices));
}

const char* CheckVisibilityGridOptions(const VisibilityGridOptions& options)
{
  const std::array<int, 3>& n = options.Dimensions;
  if (std::min({ n[0], n[1], n[2] }) < 2 || static_cast<double>(n[0]) * n[1] * n[2] > std::numeric_limits<int>::max())
  {
    return "Dimensions must each be at least 2, and all together at most 2^31 - 1 points";
  }
  if (options.NumberOfLightSamples < 1 || options.NumberOfLightSamples > 65536)
  {
    return "NumberOfLightSamples must lie in 1..65536";
  }
  if (options.BrickParts < 1 || options.BrickParts > 32)
  {
    return "BrickParts must lie in 1..32";
  }
  return options.RefinementThreshold >= 0.0 && options.RefinementThreshold <= 1.0
    ? nullptr
    : "RefinementThreshold must lie in 0..1";
}

bool FillVisibilityGrid(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene,
  const Box& bounds, const VisibilityGridOptions& options, const Monitor& monitor, VisibilityGrid& grid)
{
  if (const char* fault = CheckVisibilityGridOptions(options))
  {
    throw std::invalid_argument(fault);
  }
  const Vector3 size = bounds.Size();
  if (!(size.X > 0.0 && size.Y > 0.0 && size.Z > 0.0 && IsFinite(size)))
  {
    throw std::invalid_argument("the bounds of a visibility grid must have a finite volume");
  }
  return Filler(cones, light, scene, bounds, options, grid).Fill(bounds, monitor);
}

bool FillVisibilityGrids(const std::vector<std::vector<Cone>>& conesOf, const std::vector<Light>& lights,
  const OccluderScene* scene, const Box& bounds, const VisibilityGridOptions& options, const Monitor& monitor,
  std::vector<VisibilityGrid>& grids)
{
  const auto count = static_cast<double>(lights.size());
  grids.resize(lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    const auto done = static_cast<double>(k);
    if (!FillVisibilityGrid(
          conesOf[k], lights[k], scene, bounds, options, monitor.Part(done / count, (done + 1.0) / count), grids[k]))
    {
      return false;
    }
  }
  return true;
}

} // namespace shadowcones
