// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCellIndex.h
 * @brief From a place among cells to one of them. Internal to Core.
 */
#ifndef scCellIndex_h
#define scCellIndex_h

#include <algorithm>

namespace shadowcones
{

/**
 * The cell of a place in cells along an axis: its whole part, at least 0 and at most @p last; 0 of what is no number. The place
 * is brought into the range before it becomes a whole number, which could not hold any place.
 */
inline int CellIndex(double place, int last)
{
  return static_cast<int>(std::min(std::max(0.0, place), static_cast<double>(last)));
}

} // namespace shadowcones

#endif
