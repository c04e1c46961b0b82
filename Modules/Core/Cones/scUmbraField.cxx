// SPDX-License-Identifier: BSD-3-Clause
#include "scUmbraField.h"

#include "scConstants.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

namespace shadowcones
{
namespace
{
/// Points on the light, beside those that span it.
constexpr int pointsInside = 32;
constexpr int pointsOnSphere = 256;
constexpr int pointsOnRim = 32;
/// Values farther than so many cells from 0 are cut off.
constexpr double largestCells = 2.0;
/// Of so few discs the one that was nearest last is remembered, of more those that are nearest to the middle of the block.
constexpr std::size_t fewDiscs = 48;
/// Points of a block see the same discs.
constexpr int blockSide = 4;
/// The grid is divided into at most this many parts a side that look at every disc, and each of these again.
constexpr int partsOfSide = 4;

Vector3 OnCircle(const Vector3& axis, double radius, int k)
{
  const Frame frame = FrameAround(axis);
  const double angle = 2.0 * Pi * k / pointsOnRim;
  return radius * (std::cos(angle) * frame.U + std::sin(angle) * frame.V);
}
} // anonymous namespace

UmbraField::UmbraField(const std::vector<Cone>& cones, const Light& light, double length, const Box& bounds)
{
  const LightExtent extent = LightExtentOf(light);
  for (const Vector3& extreme : extent.Extremes)
  {
    this->Points.push_back({ extreme, 1.0 });
  }
  if (extent.AtInfinity)
  {
    for (int k = 0; k < pointsOnRim; ++k)
    {
      const Vector3 rim = -std::cos(light.Radius) * light.Normal + OnCircle(light.Normal, std::sin(light.Radius), k);
      this->Points.push_back({ rim, 0.0 });
    }
  }
  const int samples = extent.Extremes.empty() && !extent.AtInfinity ? pointsOnSphere : pointsInside;
  for (int k = 0; k < samples; ++k)
  {
    const auto point = SobolPoint(1, static_cast<std::uint32_t>(k));
    this->Points.push_back({ SampleLightArea(light, point[0], point[1]).Position, extent.AtInfinity ? 0.0 : 1.0 });
  }

  for (Cone cone : cones)
  {
    PenumbraAngles(extent, cone.Center, cone.Axis, cone.BaseRadius, cone.HalfAngle, cone.InnerHalfAngle);
    ConeDistanceField penumbra({ cone }, ConeBound::Outer, length, bounds);
    if (cone.BaseRadius > 0.0 && !penumbra.Region().Empty())
    {
      this->Discs.push_back({ cone.Center, cone.Axis, cone.BaseRadius, length });
      this->Extent.Add(penumbra.Region());
      this->Penumbrae.push_back(std::move(penumbra));
    }
  }
}

/// Of where the segment to a point of the light crosses the disc's plane; infinite where it does not.
double UmbraField::DistanceFromRim(const Vector3& point, const PointOfLight& lit, const Disc& disc)
{
  const Vector3 toLight = lit.Position - lit.Scale * point;
  const Vector3 offset = point - disc.Center;
  const double height = Dot(offset, disc.Axis);
  const double slope = -Dot(toLight, disc.Axis);
  if (!(slope > 0.0) || lit.Scale * height > slope)
  {
    return HUGE_VAL; // the light's point is not on the other side of the disc
  }
  const Vector3 crossing = offset + std::max(0.0, height / slope) * toLight;
  return std::max({ Length(crossing) - disc.Radius, -height, height - disc.Height });
}

/// Of many discs the few that are nearest to the middle of a block are those that hide a point of the light from its points.
void UmbraField::Remember(const Vector3& middle, const std::vector<int>& candidates, Memory& memory) const
{
  Memory::Nearest none;
  none.fill(-1);
  memory.PointOfLight = 0;
  memory.Discs.assign(this->Points.size(), none);
  if (candidates.size() <= fewDiscs)
  {
    return;
  }
  std::array<double, std::tuple_size<Memory::Nearest>::value> distances{};
  for (std::size_t k = 0; k < this->Points.size(); ++k)
  {
    Memory::Nearest& discs = memory.Discs[k];
    distances.fill(HUGE_VAL);
    for (const int index : candidates)
    {
      const double distance = DistanceFromRim(middle, this->Points[k], this->Discs[static_cast<std::size_t>(index)]);
      std::size_t at = distances.size();
      for (; at > 0 && distance < distances[at - 1]; --at)
      {
        if (at < distances.size())
        {
          distances[at] = distances[at - 1];
          discs[at] = discs[at - 1];
        }
      }
      if (at < distances.size())
      {
        distances[at] = distance;
        discs[at] = index;
      }
    }
  }
}

/// A point of the light is left as soon as it is not the one that decides: what decided before is looked at first.
double UmbraField::Value(
  const Vector3& point, const std::vector<int>& candidates, double largest, Memory& memory) const
{
  double value = -largest;
  const std::size_t first = memory.PointOfLight;
  for (std::size_t step = 0; step <= this->Points.size() && value < largest; ++step)
  {
    const std::size_t k = step == 0 ? first : step - 1;
    if (step > 0 && k == first)
    {
      continue;
    }
    const PointOfLight& lit = this->Points[k];
    Memory::Nearest& remembered = memory.Discs[k];
    double nearest = largest;
    int best = remembered[0];
    const auto look = [&](int index)
    {
      const double distance = DistanceFromRim(point, lit, this->Discs[static_cast<std::size_t>(index)]);
      best = distance < nearest ? index : best;
      nearest = std::min(nearest, distance);
    };
    for (std::size_t i = 0; i < remembered.size() && remembered[i] >= 0 && nearest > value; ++i)
    {
      look(remembered[i]);
      if (nearest <= value)
      {
        std::swap(remembered[0], remembered[i]); // it hides this point of the light from the next point too, mostly
      }
    }
    for (std::size_t i = 0; i < candidates.size() && nearest > value; ++i)
    {
      look(candidates[i]);
    }
    remembered[0] = candidates.size() <= fewDiscs ? best : remembered[0];
    if (nearest > value)
    {
      value = nearest;
      memory.PointOfLight = k;
    }
  }
  return value;
}

double UmbraField::Value(const Vector3& point) const
{
  std::vector<int> all(this->Discs.size());
  std::iota(all.begin(), all.end(), 0);
  Memory memory;
  this->Remember(point, all, memory);
  return this->Value(point, all, HUGE_VAL, memory);
}

/// Blocks [Begin, End) of a grid, of blockSide points a side.
struct UmbraField::Blocks
{
  std::array<int, 3> Begin;
  std::array<int, 3> End;

  int Side(int axis) const { return this->End[axis] - this->Begin[axis]; }
  int Longest() const
  {
    const bool first = this->Side(0) >= this->Side(1) && this->Side(0) >= this->Side(2);
    return first ? 0 : this->Side(1) >= this->Side(2) ? 1 : 2;
  }
  bool IsLeaf() const { return this->Side(this->Longest()) == 1; }
  /// Part @p index of @p parts along each axis.
  Blocks Part(const std::array<vtkIdType, 3>& index, const std::array<vtkIdType, 3>& parts) const
  {
    Blocks part{};
    for (int axis = 0; axis < 3; ++axis)
    {
      part.Begin[axis] = this->Begin[axis] + static_cast<int>(PieceBound(this->Side(axis), index[axis], parts[axis]));
      part.End[axis] = this->Begin[axis] + static_cast<int>(PieceBound(this->Side(axis), index[axis] + 1, parts[axis]));
    }
    return part;
  }
  /// At most so many parts along each axis.
  std::array<vtkIdType, 3> PartsOf(vtkIdType most) const
  {
    return { std::min<vtkIdType>(this->Side(0), most), std::min<vtkIdType>(this->Side(1), most),
      std::min<vtkIdType>(this->Side(2), most) };
  }
  /// First and last point along each axis.
  std::array<int, 3> FirstPoint() const
  {
    return { this->Begin[0] * blockSide, this->Begin[1] * blockSide, this->Begin[2] * blockSide };
  }
  std::array<int, 3> LastPoint(const RegularGrid& grid) const
  {
    std::array<int, 3> last{};
    for (int axis = 0; axis < 3; ++axis)
    {
      last[axis] = std::min(this->End[axis] * blockSide, grid.Dimensions[axis]) - 1;
    }
    return last;
  }
};

/// The candidates that reach the blocks.
std::vector<int> UmbraField::Near(const RegularGrid& grid, const Blocks& blocks, const std::vector<int>& candidates) const
{
  const std::array<int, 3> first = blocks.FirstPoint();
  const std::array<int, 3> last = blocks.LastPoint(grid);
  const Vector3 low = grid.Point(first[0], first[1], first[2]);
  const Vector3 high = grid.Point(last[0], last[1], last[2]);
  // Grown by what counts, so that values near 0 are continuous across blocks. What reaches a block is not farther from
  // the middle of any that holds it than that one is long.
  const double reach = (blocks.IsLeaf() ? 0.5 : 1.0) * Length(high - low) + largestCells * Length(grid.Spacing);
  const Vector3 middle = 0.5 * (low + high);
  const auto isNear = [&](const ConeDistanceField& penumbra)
  {
    const Vector3 below = penumbra.Region().Min - middle;
    const Vector3 above = middle - penumbra.Region().Max;
    return std::max({ below.X, below.Y, below.Z, above.X, above.Y, above.Z }) <= reach &&
      penumbra.Distance(middle) <= reach;
  };
  std::vector<int> near;
  for (const int index : candidates)
  {
    if (isNear(this->Penumbrae[static_cast<std::size_t>(index)]))
    {
      near.push_back(index);
    }
  }
  return near;
}

void UmbraField::SampleBlocks(const RegularGrid& grid, const Box& region, const Blocks& blocks,
  const std::vector<int>& candidates, float* values) const
{
  const double largest = largestCells * Length(grid.Spacing);
  const std::array<int, 3> first = blocks.FirstPoint();
  const std::array<int, 3> last = blocks.LastPoint(grid);
  const int longest = blocks.Longest();
  const std::vector<int> near = this->Near(grid, blocks, candidates);
  if (!blocks.IsLeaf() && !near.empty())
  {
    Blocks half = blocks;
    half.End[longest] = blocks.Begin[longest] + blocks.Side(longest) / 2;
    this->SampleBlocks(grid, region, half, near, values);
    half.Begin[longest] = half.End[longest];
    half.End[longest] = blocks.End[longest];
    this->SampleBlocks(grid, region, half, near, values);
    return;
  }
  thread_local Memory memory;
  this->Remember(
    0.5 * (grid.Point(first[0], first[1], first[2]) + grid.Point(last[0], last[1], last[2])), near, memory);
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        const Vector3 point = grid.Point(i, j, k);
        const Vector3 below = region.Min - point;
        const Vector3 above = point - region.Max;
        const double outside = std::max({ below.X, below.Y, below.Z, above.X, above.Y, above.Z });
        values[(static_cast<vtkIdType>(k) * grid.Dimensions[1] + j) * grid.Dimensions[0] + i] =
          static_cast<float>(std::max(outside, this->Value(point, near, largest, memory)));
      }
    }
  }
}

bool UmbraField::Sample(const RegularGrid& grid, const Box& region, const Monitor& monitor, float* values) const
{
  // Large parts look at every disc, those inside at what is left: discs cost where they are.
  std::vector<int> all(this->Discs.size());
  std::iota(all.begin(), all.end(), 0);
  Blocks whole{};
  for (int axis = 0; axis < 3; ++axis)
  {
    whole.End[axis] = (grid.Dimensions[axis] + blockSide - 1) / blockSide;
  }
  struct Part
  {
    Blocks Inside;
    std::vector<int> Near;
  };
  const auto forEachPart = [](const Blocks& blocks, auto&& visit)
  {
    const std::array<vtkIdType, 3> parts = blocks.PartsOf(partsOfSide);
    for (vtkIdType k = 0; k < parts[0] * parts[1] * parts[2]; ++k)
    {
      visit(blocks.Part({ k % parts[0], k / parts[0] % parts[1], k / parts[0] / parts[1] }, parts));
    }
  };
  std::vector<Part> large;
  forEachPart(whole, [&large](const Blocks& blocks) { large.push_back({ blocks, {} }); });
  constexpr double shareOfLarge = 0.05; // of the progress
  if (!ParallelFor(static_cast<vtkIdType>(large.size()), monitor.Part(0.0, shareOfLarge),
        [&](vtkIdType begin, vtkIdType end)
        {
          for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
          {
            large[p].Near = this->Near(grid, large[p].Inside, all);
          }
        }))
  {
    return false;
  }
  std::vector<std::pair<const Part*, Blocks>> parts;
  for (const Part& part : large)
  {
    forEachPart(part.Inside, [&](const Blocks& blocks) { parts.emplace_back(&part, blocks); });
  }
  return ParallelFor(static_cast<vtkIdType>(parts.size()), monitor.Part(shareOfLarge, 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      {
        this->SampleBlocks(grid, region, parts[p].second, parts[p].first->Near, values);
      }
    });
}

Box UmbraField::Find(const Box& region, int resolution, const Monitor& monitor) const
{
  const RegularGrid grid = GridOver(region, resolution);
  std::vector<float> values(static_cast<std::size_t>(grid.NumberOfPoints()));
  Box found;
  if (!this->Sample(grid, region, monitor, values.data()))
  {
    return found;
  }
  vtkIdType id = 0;
  for (int k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.Dimensions[0]; ++i, ++id)
      {
        if (values[id] < 0.0f)
        {
          found.Add(grid.Point(i, j, k) - grid.Spacing);
          found.Add(grid.Point(i, j, k) + grid.Spacing);
        }
      }
    }
  }
  if (!found.Empty())
  {
    found.Min = { std::max(found.Min.X, region.Min.X), std::max(found.Min.Y, region.Min.Y),
      std::max(found.Min.Z, region.Min.Z) };
    found.Max = { std::min(found.Max.X, region.Max.X), std::min(found.Max.Y, region.Max.Y),
      std::min(found.Max.Z, region.Max.Z) };
  }
  return found;
}

} // namespace shadowcones
