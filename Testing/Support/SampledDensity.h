// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledDensity.h
 * @brief Density grids sampled from functions, for tests.
 */
#ifndef SampledDensity_h
#define SampledDensity_h

#include "scDensityGrid.h"
#include "scFrame.h"

#include <array>
#include <functional>
#include <stdexcept>

namespace shadowcones
{

/// Axes along x, y and z.
inline std::array<Vector3, 3> UnitAxes(const Vector3& spacing)
{
  return { { { spacing.X, 0.0, 0.0 }, { 0.0, spacing.Y, 0.0 }, { 0.0, 0.0, spacing.Z } } };
}

/// Axes at right angles that no coordinate plane holds.
inline std::array<Vector3, 3> TurnedAxes(const Vector3& spacing)
{
  const Vector3 axis = Normalized({ 1.0, 2.0, -2.0 });
  const Frame frame = FrameAround(axis);
  return { { spacing.X * frame.U, spacing.Y * frame.V, spacing.Z * axis } };
}

/// A prepared grid with the values of @p density at its points.
inline DensityGrid SampleDensity(const std::array<int, 3>& dimensions, const Vector3& origin,
  const std::array<Vector3, 3>& axes, const std::function<double(const Vector3&)>& density)
{
  DensityGrid grid;
  grid.Dimensions = dimensions;
  grid.Origin = origin;
  grid.Axes = axes;
  for (int k = 0; k < dimensions[2]; ++k)
  {
    for (int j = 0; j < dimensions[1]; ++j)
    {
      for (int i = 0; i < dimensions[0]; ++i)
      {
        const Vector3 point = origin + static_cast<double>(i) * axes[0] + static_cast<double>(j) * axes[1] +
          static_cast<double>(k) * axes[2];
        grid.Values.push_back(static_cast<float>(density(point)));
      }
    }
  }
  if (const char* fault = PrepareDensityGrid(grid))
  {
    throw std::invalid_argument(fault);
  }
  return grid;
}

} // namespace shadowcones

#endif
