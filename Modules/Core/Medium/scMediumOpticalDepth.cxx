// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumOpticalDepth.h"

namespace shadowcones
{

void MediumOpticalDepth::Tabulate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd)
{
  const DensityGrid& grid = *this->Density;
  this->Table.assign(1, Entry());
  this->TableBegin = tBegin;
  this->StepsPerLength = 0.0;
  const Vector3 from = grid.IndexPoint(origin);
  const Vector3 along = grid.IndexDirection(direction);
  if (grid.Support.Empty() || !grid.Support.Clip(from, along, tBegin, tEnd))
  {
    return;
  }
  // Half a cell: between two entries the density is all but linear. A whole number of cells takes no step more.
  constexpr double mostSteps = 1 << 24; // a limit of memory: no grid is that fine
  const int steps =
    static_cast<int>(std::clamp(std::ceil(2.0 * Length(along) * (tEnd - tBegin) - 1e-4), 1.0, mostSteps));
  const double step = (tEnd - tBegin) / steps;
  this->TableBegin = tBegin;
  this->StepsPerLength = 1.0 / step;
  this->Table.resize(static_cast<std::size_t>(steps) + 1);
  double before = 0.0;
  double depth = 0.0;
  for (int k = 0; k <= steps; ++k)
  {
    const double density = grid.ValueAt(from + (tBegin + k * step) * along);
    depth += k > 0 ? 0.5 * step * (before + density) : 0.0;
    this->Table[static_cast<std::size_t>(k)] = { depth, density };
    before = density;
  }
}

} // namespace shadowcones
