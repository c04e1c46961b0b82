// SPDX-License-Identifier: BSD-3-Clause
#include "scRegularGrid.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

RegularGrid GridOver(const Box& box, int resolution)
{
  RegularGrid grid;
  const Vector3 size = box.Size();
  if (!(size.X > 0.0 && size.Y > 0.0 && size.Z > 0.0) || resolution < 1)
  {
    return grid;
  }
  const double cell = std::max({ size.X, size.Y, size.Z }) / resolution;
  std::array<double, 3> spacing{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = std::clamp(std::round(size[axis] / cell), 1.0, static_cast<double>(resolution));
    spacing[axis] = size[axis] / cells;
    grid.Dimensions[axis] = static_cast<int>(cells) + 2;
  }
  grid.Spacing = { spacing[0], spacing[1], spacing[2] };
  grid.Origin = box.Min - 0.5 * grid.Spacing;
  return grid;
}

} // namespace shadowcones
