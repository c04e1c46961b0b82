// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibilityGrid.h"

#include "scVisibilityGridFiller.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace shadowcones
{

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
  return VisibilityGridFiller(cones, light, scene, bounds, options, grid).Fill(bounds, monitor);
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
