// SPDX-License-Identifier: BSD-3-Clause
#include "scUmbraField.h"

#include "scConstants.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{
/// Points on the light, beside those that span it.
constexpr int pointsInside = 32;
constexpr int pointsOnSphere = 256;
constexpr int pointsOnRim = 32;
/// Points of a block see the same discs.
constexpr int blockSide = 4;
/// The grid is divided into at most this many parts a side that look at every disc.
constexpr int coarseBlocks = 16;

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

double UmbraField::Value(const Vector3& point, const std::vector<int>& candidates, double largest) const
{
  double value = -largest;
  for (const PointOfLight& lit : this->Points)
  {
    const Vector3 toLight = lit.Position - lit.Scale * point;
    double nearest = largest;
    for (const int index : candidates)
    {
      const Disc& disc = this->Discs[index];
      const Vector3 offset = point - disc.Center;
      const double height = Dot(offset, disc.Axis);
      const double slope = -Dot(toLight, disc.Axis);
      if (!(slope > 0.0) || lit.Scale * height > slope)
      {
        continue; // the light's point is not on the other side of the disc
      }
      const Vector3 crossing = offset + std::max(0.0, height / slope) * toLight;
      const double distance = std::max({ Length(crossing) - disc.Radius, -height, height - disc.Height });
      nearest = std::min(nearest, distance);
      if (nearest <= value)
      {
        break; // this point of the light is not the one that decides
      }
    }
    value = std::max(value, nearest);
    if (value >= largest)
    {
      break;
    }
  }
  return value;
}

double UmbraField::Value(const Vector3& point) const
{
  std::vector<int> all(this->Discs.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = static_cast<int>(i);
  }
  return this->Value(point, all, HUGE_VAL);
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

void UmbraField::SampleBlocks(const RegularGrid& grid, const Box& region, const Blocks& blocks,
  const std::vector<int>& candidates, float* values) const
{
  const double largest = 2.0 * Length(grid.Spacing);
  const std::array<int, 3> first = blocks.FirstPoint();
  const std::array<int, 3> last = blocks.LastPoint(grid);
  const Vector3 low = grid.Point(first[0], first[1], first[2]);
  const Vector3 high = grid.Point(last[0], last[1], last[2]);
  const int longest = blocks.Longest();
  const bool isLeaf = blocks.Side(longest) == 1;
  // Grown by what counts, so that values near 0 are continuous across blocks. What reaches a block is not farther from
  // the middle of any that holds it than that one is long.
  const double reach = (isLeaf ? 0.5 : 1.0) * Length(high - low) + largest;
  std::vector<int> near;
  for (const int index : candidates)
  {
    if (this->Penumbrae[index].Distance(0.5 * (low + high)) <= reach)
    {
      near.push_back(index);
    }
  }
  if (!isLeaf && !near.empty())
  {
    Blocks half = blocks;
    half.End[longest] = blocks.Begin[longest] + blocks.Side(longest) / 2;
    this->SampleBlocks(grid, region, half, near, values);
    half.Begin[longest] = half.End[longest];
    half.End[longest] = blocks.End[longest];
    this->SampleBlocks(grid, region, half, near, values);
    return;
  }
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
          static_cast<float>(std::max(outside, this->Value(point, near, largest)));
      }
    }
  }
}

bool UmbraField::Sample(const RegularGrid& grid, const Box& region, const Monitor& monitor, float* values) const
{
  // Each coarse block looks at every disc, those inside at what is left: discs cost where they are.
  std::vector<int> all(this->Discs.size());
  std::iota(all.begin(), all.end(), 0);
  std::array<vtkIdType, 3> blocks{};
  std::array<vtkIdType, 3> coarse{};
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = (grid.Dimensions[axis] + blockSide - 1) / blockSide;
    coarse[axis] = std::min<vtkIdType>(blocks[axis], coarseBlocks);
  }
  return ParallelFor(coarse[0] * coarse[1] * coarse[2], monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        const vtkIdType index[3] = { b % coarse[0], b / coarse[0] % coarse[1], b / coarse[0] / coarse[1] };
        Blocks part{};
        for (int axis = 0; axis < 3; ++axis)
        {
          part.Begin[axis] = static_cast<int>(PieceBound(blocks[axis], index[axis], coarse[axis]));
          part.End[axis] = static_cast<int>(PieceBound(blocks[axis], index[axis] + 1, coarse[axis]));
        }
        this->SampleBlocks(grid, region, part, all, values);
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
