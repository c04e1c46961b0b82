// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBlockSize.h
 * @brief How many items of a loop a thread takes at once. Internal to Core.
 */
#ifndef scBlockSize_h
#define scBlockSize_h

#include "vtkType.h"

#include <algorithm>

namespace shadowcones
{

/// What a thread did last.
struct FinishedBlock
{
  vtkIdType Items = 0; ///< 0: nothing yet
  double Seconds = 0.0;
};

/**
 * Items for a thread to take of the @p left ones of a loop. Blocks grow to some milliseconds, so that taking them costs
 * nothing, and shrink at the end, so that no thread has much left when the others have nothing: to a share of what is
 * left, but not below a fortieth of a millisecond.
 */
inline vtkIdType NextBlockSize(vtkIdType left, int threads, const FinishedBlock& last)
{
  constexpr double wantedSeconds = 4e-3;
  constexpr double leastSeconds = 2.5e-5;
  constexpr double growth = 8.0;
  if (last.Items == 0)
  {
    return 1; // an item may be a thousand photons
  }
  const double rate = static_cast<double>(last.Items) / std::max(last.Seconds, 1e-9);
  const double wanted = std::min(wantedSeconds * rate, growth * static_cast<double>(last.Items));
  const double share = static_cast<double>(left) / (2.0 * threads);
  const double size = std::min(wanted, std::max(share, leastSeconds * rate));
  return std::max<vtkIdType>(1, static_cast<vtkIdType>(std::min(size, static_cast<double>(left))));
}

/**
 * Items for a thread without a group to take from one that has @p left of them: half, unless preparing the group once more
 * would take longer than they do. @param preparation seconds of that; @param item seconds of an item.
 */
inline vtkIdType NumberToTakeOver(vtkIdType left, double preparation, double item)
{
  const vtkIdType half = (left + 1) / 2;
  return static_cast<double>(half) * item > preparation ? half : 0;
}

} // namespace shadowcones

#endif
