// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scGridBlock.h
 * @brief A block of the points of a grid, to be looked at as a whole and divided. Internal to Core.
 */
#ifndef scGridBlock_h
#define scGridBlock_h

#include "scRegularGrid.h"

#include <array>

namespace shadowcones
{

/// Points [Begin, End) of a grid.
struct GridBlock
{
  std::array<int, 3> Begin;
  std::array<int, 3> End;

  int Side(int axis) const { return this->End[axis] - this->Begin[axis]; }
  int Longest() const
  {
    const int axis = this->Side(0) >= this->Side(1) ? 0 : 1;
    return this->Side(axis) >= this->Side(2) ? axis : 2;
  }
  /// Around the points.
  Box Bounds(const RegularGrid& grid) const
  {
    return { grid.Point(this->Begin[0], this->Begin[1], this->Begin[2]),
      grid.Point(this->End[0] - 1, this->End[1] - 1, this->End[2] - 1) };
  }
  template <typename Visitor>
  void ForEachPoint(const RegularGrid& grid, Visitor&& visit) const
  {
    for (int k = this->Begin[2]; k < this->End[2]; ++k)
    {
      for (int j = this->Begin[1]; j < this->End[1]; ++j)
      {
        const vtkIdType row = (static_cast<vtkIdType>(k) * grid.Dimensions[1] + j) * grid.Dimensions[0];
        for (int i = this->Begin[0]; i < this->End[0]; ++i)
        {
          visit(row + i, grid.Point(i, j, k));
        }
      }
    }
  }
};

} // namespace shadowcones

#endif
