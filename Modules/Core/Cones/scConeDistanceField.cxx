// SPDX-License-Identifier: BSD-3-Clause
#include "scConeDistanceField.h"

#include "scGridBlock.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Blocks of points with sides up to this long are not divided any more.
constexpr int leafSide = 4;
/// The grid is divided into at most this many blocks a side that see every cone.
constexpr int coarseBlocks = 8;
} // anonymous namespace

ConeDistanceField::ConeDistanceField(const std::vector<Cone>& cones, ConeBound bound, double length, const Box& bounds)
{
  for (const Cone& cone : cones)
  {
    const double tangent = std::tan(bound == ConeBound::Outer ? cone.HalfAngle : cone.InnerHalfAngle);
    Body body;
    body.Center = cone.Center;
    body.Axis = cone.Axis;
    body.BaseRadius = cone.BaseRadius;
    body.Height = bounds.Empty() ? length : std::min(length, HighestCorner(cone, bounds));
    body.Height = std::min(body.Height, TipHeight(cone.BaseRadius, tangent));
    body.EndRadius = RadiusAt(cone.BaseRadius, tangent, body.Height);
    if (!(body.Height > 0.0) || !(body.BaseRadius + body.EndRadius > 0.0))
    {
      continue;
    }
    const double side = std::hypot(body.EndRadius - body.BaseRadius, body.Height);
    body.Side = { (body.EndRadius - body.BaseRadius) / side, body.Height / side, side };
    this->Bodies.push_back(body);

    const Vector3 end = body.Center + body.Height * body.Axis;
    const Vector3 baseExtent = DiscExtent(body.Axis, body.BaseRadius);
    const Vector3 endExtent = DiscExtent(body.Axis, body.EndRadius);
    this->Extent.Add(body.Center - baseExtent);
    this->Extent.Add(body.Center + baseExtent);
    this->Extent.Add(end - endExtent);
    this->Extent.Add(end + endExtent);
  }
  if (!bounds.Empty() && !this->Extent.Empty())
  {
    this->Extent = Intersection(this->Extent, bounds);
    const Vector3 size = this->Extent.Size();
    this->Extent = std::min({ size.X, size.Y, size.Z }) > 0.0 ? this->Extent : Box();
  }
}

double ConeDistanceField::DistanceTo(const Body& body, const Vector3& point)
{
  const Vector3 offset = point - body.Center;
  const double h = Dot(offset, body.Axis);
  const double r = Length(offset - h * body.Axis);
  const double above = h - body.Height;
  const double fromRim = r - body.BaseRadius;
  const double beside = fromRim * body.Side.Y - h * body.Side.X;
  const double inside = std::max({ -h, above, beside });
  if (inside <= 0.0)
  {
    return inside;
  }
  // The nearest of the three edges of the profile in the half plane (r, h).
  const double along = std::clamp(fromRim * body.Side.X + h * body.Side.Y, 0.0, body.Side.Z);
  const double sideR = fromRim - along * body.Side.X;
  const double sideH = h - along * body.Side.Y;
  const double baseR = std::max(0.0, fromRim);
  const double endR = std::max(0.0, r - body.EndRadius);
  return std::sqrt(std::min({ sideR * sideR + sideH * sideH, baseR * baseR + h * h, endR * endR + above * above }));
}

double ConeDistanceField::Clip(const Vector3& point, double distance) const
{
  const Vector3 below = this->Extent.Min - point;
  const Vector3 above = point - this->Extent.Max;
  return std::max({ distance, below.X, below.Y, below.Z, above.X, above.Y, above.Z });
}

double ConeDistanceField::Distance(const Vector3& point) const
{
  double distance = HUGE_VAL;
  for (const Body& body : this->Bodies)
  {
    distance = std::min(distance, DistanceTo(body, point));
  }
  return this->Clip(point, distance);
}

struct ConeDistanceField::Block : GridBlock
{
};

void ConeDistanceField::SampleBlock(
  const RegularGrid& grid, const Block& block, const std::vector<int>& candidates, float* values) const
{
  const Vector3 low = grid.Point(block.Begin[0], block.Begin[1], block.Begin[2]);
  const Vector3 high = grid.Point(block.End[0] - 1, block.End[1] - 1, block.End[2] - 1);
  const Vector3 center = 0.5 * (low + high);
  const double radius = 0.5 * Length(high - low);

  std::vector<double> distances(candidates.size());
  double nearest = HUGE_VAL;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    distances[c] = DistanceTo(this->Bodies[candidates[c]], center);
    nearest = std::min(nearest, distances[c]);
  }
  const double field = this->Clip(center, nearest);
  if (std::abs(field) > radius + Length(grid.Spacing))
  {
    block.ForEachPoint(grid, [&](vtkIdType id, const Vector3&) { values[id] = static_cast<float>(field); });
    return;
  }

  // Over the block a distance changes by at most the radius: the others are nowhere the nearest.
  std::vector<int> near;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    if (distances[c] <= nearest + 2.0 * radius)
    {
      near.push_back(candidates[c]);
    }
  }
  const int longest = block.Longest();
  if (block.Side(longest) > leafSide)
  {
    Block first = block;
    Block second = block;
    first.End[longest] = second.Begin[longest] = block.Begin[longest] + block.Side(longest) / 2;
    this->SampleBlock(grid, first, near, values);
    this->SampleBlock(grid, second, near, values);
    return;
  }
  block.ForEachPoint(grid,
    [&](vtkIdType id, const Vector3& point)
    {
      double distance = HUGE_VAL;
      for (const int body : near)
      {
        distance = std::min(distance, DistanceTo(this->Bodies[body], point));
      }
      values[id] = static_cast<float>(this->Clip(point, distance));
    });
}

bool ConeDistanceField::Sample(const RegularGrid& grid, const Monitor& monitor, float* values) const
{
  std::vector<int> all(this->Bodies.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = static_cast<int>(i);
  }
  std::array<int, 3> blocks{};
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = std::clamp(grid.Dimensions[axis] / leafSide, 1, coarseBlocks);
  }
  const vtkIdType count = static_cast<vtkIdType>(blocks[0]) * blocks[1] * blocks[2];
  return ParallelFor(count, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        const vtkIdType index[3] = { b % blocks[0], b / blocks[0] % blocks[1], b / blocks[0] / blocks[1] };
        Block block;
        for (int axis = 0; axis < 3; ++axis)
        {
          block.Begin[axis] = static_cast<int>(PieceBound(grid.Dimensions[axis], index[axis], blocks[axis]));
          block.End[axis] = static_cast<int>(PieceBound(grid.Dimensions[axis], index[axis] + 1, blocks[axis]));
        }
        this->SampleBlock(grid, block, all, values);
      }
    });
}

} // namespace shadowcones
