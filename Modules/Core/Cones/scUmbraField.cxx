// SPDX-License-Identifier: BSD-3-Clause
#include "scUmbraField.h"

#include "scConstants.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>

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

bool UmbraField::Sample(const RegularGrid& grid, const Box& region, const Monitor& monitor, float* values) const
{
  const double largest = 2.0 * Length(grid.Spacing);
  vtkIdType blocks[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = (grid.Dimensions[axis] + blockSide - 1) / blockSide;
  }
  return ParallelFor(blocks[0] * blocks[1] * blocks[2], monitor,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<int> candidates;
      for (vtkIdType b = first; b < last; ++b)
      {
        const int begin[3] = { static_cast<int>(b % blocks[0]) * blockSide,
          static_cast<int>(b / blocks[0] % blocks[1]) * blockSide,
          static_cast<int>(b / blocks[0] / blocks[1]) * blockSide };
        int end[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          end[axis] = std::min(begin[axis] + blockSide, grid.Dimensions[axis]);
        }
        const Vector3 low = grid.Point(begin[0], begin[1], begin[2]);
        const Vector3 high = grid.Point(end[0] - 1, end[1] - 1, end[2] - 1);
        candidates.clear();
        for (std::size_t i = 0; i < this->Discs.size(); ++i)
        {
          // Grown by what counts, so that values near 0 are continuous across blocks.
          if (this->Penumbrae[i].Distance(0.5 * (low + high)) <= 0.5 * Length(high - low) + largest)
          {
            candidates.push_back(static_cast<int>(i));
          }
        }
        for (int k = begin[2]; k < end[2]; ++k)
        {
          for (int j = begin[1]; j < end[1]; ++j)
          {
            for (int i = begin[0]; i < end[0]; ++i)
            {
              const Vector3 point = grid.Point(i, j, k);
              const Vector3 below = region.Min - point;
              const Vector3 above = point - region.Max;
              const double outside = std::max({ below.X, below.Y, below.Z, above.X, above.Y, above.Z });
              values[(static_cast<vtkIdType>(k) * grid.Dimensions[1] + j) * grid.Dimensions[0] + i] =
                static_cast<float>(std::max(outside, this->Value(point, candidates, largest)));
            }
          }
        }
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
