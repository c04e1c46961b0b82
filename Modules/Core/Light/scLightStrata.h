// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightStrata.h
 * @brief Stratified points on the unit square, for any number of points. Internal to Core.
 */
#ifndef scLightStrata_h
#define scLightStrata_h

#include "scRandom.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shadowcones
{

/**
 * The unit square cut into cells of equal area, one random point in each: a grid where the count has a factor near its
 * root, else rows of unequal length. The cells run row by row like a snake, so that neighbours in the list touch.
 */
class LightStrata
{
public:
  explicit LightStrata(int count)
  {
    const int rows = ChooseRows(count);
    this->Columns = rows > 0 && count % rows == 0 ? count / rows : 0;
    this->Cells.reserve(static_cast<std::size_t>(count));
    for (int row = 0; row < rows; ++row)
    {
      const auto begin = static_cast<int>(static_cast<long long>(count) * row / rows);
      const auto end = static_cast<int>(static_cast<long long>(count) * (row + 1) / rows);
      const int inRow = end - begin;
      for (int k = 0; k < inRow; ++k)
      {
        const int column = row % 2 == 0 ? k : inRow - 1 - k;
        this->Cells.push_back({ static_cast<double>(column) / inRow, static_cast<double>(begin) / count,
          0x1p-32 / inRow, 0x1p-32 * inRow / count });
      }
    }
  }

  int Count() const { return static_cast<int>(this->Cells.size()); }

  struct Point
  {
    double U;
    double V;
  };
  /// A random point of cell @p index, in [0, 1)^2.
  Point Draw(int index, RandomStream& random) const
  {
    constexpr double belowOne = 1.0 - 0x1p-53;
    const Cell& cell = this->Cells[static_cast<std::size_t>(index)];
    const std::uint64_t word = random.NextWord();
    return { std::min(cell.U + cell.StepU * static_cast<double>(word >> 32), belowOne),
      std::min(cell.V + cell.StepV * static_cast<double>(word & 0xFFFFFFFFu), belowOne) };
  }

  /// Squared standard error of the mean of one value a cell: see VarianceOfGrid().
  double VarianceOfMean(const double* values) const
  {
    const int count = this->Count();
    const int columns = this->Columns > 0 ? this->Columns : count;
    return VarianceOfGrid(values, columns > 0 ? count / columns : 0, columns);
  }

  /**
   * Squared standard error of the mean of one value for each cell of a grid, in the order of a snake. From mixed
   * differences of 2 x 2 cells, which see neither a level nor a slope; of a single row or column from differences of
   * neighbours, which overrate slopes. 0 for fewer than two cells.
   */
  static double VarianceOfGrid(const double* values, int rows, int columns)
  {
    const int count = rows * columns;
    double squares = 0.0;
    if (rows < 2 || columns < 2)
    {
      for (int k = 1; k < count; ++k)
      {
        squares += (values[k] - values[k - 1]) * (values[k] - values[k - 1]);
      }
      return count > 1 ? squares / (2.0 * (count - 1) * count) : 0.0;
    }
    for (int row = 0; row + 1 < rows; ++row)
    {
      // A snake: the cell above the k-th of a row is as many cells behind the turn as that one is ahead of it.
      const double* here = values + row * columns;
      const double* above = values + (row + 2) * columns - 1;
      for (int k = 0; k + 1 < columns; ++k)
      {
        const double mixed = here[k] - here[k + 1] - above[-k] + above[-k - 1];
        squares += mixed * mixed;
      }
    }
    return squares / (4.0 * (rows - 1) * (columns - 1) * count);
  }

private:
  /// The largest factor up to the root, unless cells would be more than four times as wide as high.
  static int ChooseRows(int count)
  {
    const int root = static_cast<int>(std::sqrt(static_cast<double>(count > 0 ? count : 0)) + 1e-9);
    for (int rows = root; 2 * rows >= root && rows > 0; --rows)
    {
      if (count % rows == 0)
      {
        return rows;
      }
    }
    return root;
  }

  struct Cell
  {
    double U;
    double V;
    double StepU; ///< width / 2^32
    double StepV; ///< height / 2^32
  };
  std::vector<Cell> Cells;
  int Columns = 0; ///< 0 where rows differ in length
};

} // namespace shadowcones

#endif
