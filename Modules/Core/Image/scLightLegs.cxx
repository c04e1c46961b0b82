// SPDX-License-Identifier: BSD-3-Clause
#include "scLightLegs.h"

#include "scCellIndex.h"
#include "scFrame.h"
#include "scLightSampling.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Nodes stand at -1, 0 and 1 times this along both coordinates on the light.
constexpr double nodePlace = 0.8;
/// Every axis has at least so many steps: also a density that does not vary along it shades along slanted ways.
constexpr double fewestSteps = 8.0;
constexpr double mostSteps = 1024.0;

/// Weights of the three nodes along one coordinate.
std::array<float, 3> WeightsAlong(double coordinate)
{
  const double z = coordinate / nodePlace;
  return { { static_cast<float>(0.5 * z * (z - 1.0)), static_cast<float>(1.0 - z * z),
    static_cast<float>(0.5 * z * (z + 1.0)) } };
}

/// sums[k] += factor values[k]
SHADOWCONES_WIDE void AddProducts(float factor, const float* values, int count, float* sums)
{
  for (int k = 0; k < count; ++k)
  {
    sums[k] += factor * values[k];
  }
}

/// World distance along an axis of the world in which the nearest of the grid's axes goes on by a cell.
double CellAlong(const DensityGrid& grid, int axis)
{
  double cell = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double perLength = std::fabs(grid.ToIndex[k][axis]);
    cell = perLength > 1e-9 * Length(grid.ToIndex[k]) ? std::min(cell, 1.0 / perLength) : cell;
  }
  return cell;
}

/// The part of the bounds where there may be any density.
Box RegionOf(const Medium& medium)
{
  const DensityGrid& grid = *medium.Density;
  Box region = medium.Bounds;
  if (std::find(grid.Dimensions.begin(), grid.Dimensions.end(), 1) != grid.Dimensions.end())
  {
    return region; // no limit along that axis
  }
  Box support;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 index{ (corner & 1 ? grid.Support.Max : grid.Support.Min).X,
      (corner & 2 ? grid.Support.Max : grid.Support.Min).Y, (corner & 4 ? grid.Support.Max : grid.Support.Min).Z };
    support.Add(grid.Origin + index.X * grid.Axes[0] + index.Y * grid.Axes[1] + index.Z * grid.Axes[2]);
  }
  const Vector3& low = support.Min;
  const Vector3& high = support.Max;
  region.Min = { std::max(region.Min.X, low.X), std::max(region.Min.Y, low.Y), std::max(region.Min.Z, low.Z) };
  region.Max = { std::min(region.Max.X, high.X), std::min(region.Max.Y, high.Y), std::min(region.Max.Z, high.Z) };
  return region;
}
} // anonymous namespace

bool LightLegs::Fit(const Light& light)
{
  return light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle || light.Shape == LightShape::Sun ||
    light.Shape == LightShape::Point;
}

LightLegs::LightLegs(const Light& light, const Medium& medium, double cells)
  : Air(medium)
  , AtInfinity(IsAtInfinity(light))
  , Center(AtInfinity ? -light.Normal : light.Center)
  , Region(RegionOf(medium))
{
  if (light.Shape == LightShape::Rectangle)
  {
    this->U = light.AxisU;
    this->V = light.AxisV;
  }
  else if (light.Shape != LightShape::Point)
  {
    const Frame frame = FrameAround(light.Normal);
    const double radius = this->AtInfinity ? std::sin(light.Radius) : light.Radius;
    this->U = radius * frame.U;
    this->V = radius * frame.V;
  }
  const double squaredU = Dot(this->U, this->U);
  const double squaredV = Dot(this->V, this->V);
  this->PerU = squaredU > 0.0 ? (1.0 / squaredU) * this->U : Vector3();
  this->PerV = squaredV > 0.0 ? (1.0 / squaredV) * this->V : Vector3();
  const Vector3 size = this->Region.Size();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double steps = std::ceil(size[axis] / (cells * CellAlong(*medium.Density, axis)) - 1e-6);
    const double used = std::clamp(steps, fewestSteps, mostSteps);
    this->Dimensions[static_cast<std::size_t>(axis)] = 1 + static_cast<int>(used);
    this->PerLength[static_cast<std::size_t>(axis)] = used / size[axis];
  }
}

float LightLegs::MeanTowards(const Vector3& point, int node) const
{
  const double u = nodePlace * (node % 3 - 1);
  const double v = nodePlace * (node / 3 - 1);
  const Vector3 on = this->Center + u * this->U + v * this->V;
  const Vector3 to = this->AtInfinity ? on : on - point;
  const double distance = Length(to);
  const DensityGrid& grid = *this->Air.Density;
  const Vector3 direction = distance > 0.0 ? (1.0 / distance) * to : Vector3{ 1.0, 0.0, 0.0 };
  const double length =
    std::min(this->AtInfinity ? HUGE_VAL : distance, ExitDistance(this->Air.Bounds, point, direction));
  const Vector3 from = grid.IndexPoint(point);
  const Vector3 along = grid.IndexDirection(direction);
  double begin = 0.0;
  double end = length;
  if (!(length > 0.0))
  {
    return static_cast<float>(grid.At(point));
  }
  if (!grid.Support.Clip(from, along, begin, end))
  {
    return 0.0f;
  }
  // A value in the middle of every cell's length: the sum is as good as the values where they vary smoothly.
  const int steps = static_cast<int>(std::clamp(std::ceil(Length(along) * (end - begin)), 1.0, 1e6));
  const double step = (end - begin) / steps;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    sum += grid.ValueAt(from + (begin + (k + 0.5) * step) * along);
  }
  return static_cast<float>(sum * step / length);
}

bool LightLegs::Fill(const Monitor& monitor)
{
  this->Values.assign(static_cast<std::size_t>(this->NumberOfPlaces()) * NumberOfNodes, 0.0f);
  const bool single = Length(this->PerU) + Length(this->PerV) == 0.0;
  return ParallelFor(this->NumberOfPlaces(), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType place = begin; place < end; ++place)
      {
        const vtkIdType row = place / this->Dimensions[0];
        const Vector3 at{ static_cast<double>(place % this->Dimensions[0]),
          static_cast<double>(row % this->Dimensions[1]), static_cast<double>(row / this->Dimensions[1]) };
        const Vector3 point = this->Region.Min +
          Vector3{ at.X / this->PerLength[0], at.Y / this->PerLength[1], at.Z / this->PerLength[2] };
        float* means = this->Values.data() + place * NumberOfNodes;
        for (int node = 0; node < NumberOfNodes; ++node)
        {
          means[node] = single && node > 0 ? means[0] : this->MeanTowards(point, node);
        }
      }
    });
}

void LightLegs::LookAt(const Vector3& point, Place& place) const
{
  place.Point = point;
  place.InTable = this->Region.Contains(point);
  if (!place.InTable)
  {
    return;
  }
  std::size_t first = 0;
  std::size_t strides[3];
  float upper[3];
  std::size_t stride = NumberOfNodes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int dimension = this->Dimensions[static_cast<std::size_t>(axis)];
    const double x = (point[axis] - this->Region.Min[axis]) * this->PerLength[static_cast<std::size_t>(axis)];
    const int cell = CellIndex(x, dimension - 2);
    upper[axis] = static_cast<float>(x - cell);
    strides[axis] = stride;
    first += static_cast<std::size_t>(cell) * stride;
    stride *= static_cast<std::size_t>(dimension);
  }
  place.Means.fill(0.0f);
  for (int corner = 0; corner < 8; ++corner)
  {
    const float weight = (corner & 1 ? upper[0] : 1.0f - upper[0]) * (corner & 2 ? upper[1] : 1.0f - upper[1]) *
      (corner & 4 ? upper[2] : 1.0f - upper[2]);
    const float* means = this->Values.data() + first + (corner & 1 ? strides[0] : 0) + (corner & 2 ? strides[1] : 0) +
      (corner & 4 ? strides[2] : 0);
    for (std::size_t node = 0; node < NumberOfNodes; ++node)
    {
      place.Means[node] += weight * means[node];
    }
  }
}

std::array<float, LightLegs::NumberOfNodes> LightLegs::WeightsOf(const Vector3& offset) const
{
  const std::array<float, 3> u = WeightsAlong(Dot(offset, this->PerU));
  const std::array<float, 3> v = WeightsAlong(Dot(offset, this->PerV));
  std::array<float, NumberOfNodes> weights;
  for (std::size_t node = 0; node < NumberOfNodes; ++node)
  {
    weights[node] = u[node % 3] * v[node / 3];
  }
  return weights;
}

void LightLegs::MultiplyByMeans(const Place& place, const float* weights, int count, float* legs)
{
  constexpr int block = 64;
  float means[block];
  for (int first = 0; first < count; first += block)
  {
    const int size = std::min(block, count - first);
    std::fill_n(means, size, 0.0f);
    for (int node = 0; node < NumberOfNodes; ++node)
    {
      AddProducts(place.Means[static_cast<std::size_t>(node)], weights + node * count + first, size, means);
    }
    for (int k = 0; k < size; ++k)
    {
      legs[first + k] *= std::max(means[k], 0.0f);
    }
  }
}

std::vector<float> LightLegs::WeightsOf(const LightRule& rule) const
{
  const LightPoints points = rule.AreaPoints();
  const auto count = static_cast<std::size_t>(points.Count);
  std::vector<float> result(NumberOfNodes * count);
  for (std::size_t k = 0; k < count; ++k)
  {
    // Of flat lights the points' offsets count from their centre.
    const std::array<float, NumberOfNodes> weights =
      this->WeightsOf(Vector3{ static_cast<double>(points.X[k]), static_cast<double>(points.Y[k]),
        static_cast<double>(points.Z[k]) });
    for (std::size_t node = 0; node < NumberOfNodes; ++node)
    {
      result[node * count + k] = weights[node];
    }
  }
  return result;
}

} // namespace shadowcones
