// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scParallel.h
 * @brief Progress, abort and parallel loops: the one place where Core meets threads.
 */
#ifndef scParallel_h
#define scParallel_h

#include "ShadowConesCoreModule.h"
#include "vtkType.h"

#include <functional>
#include <vector>

namespace shadowcones
{

/**
 * What a long computation tells its caller. Both functions are called on the calling thread only, some ten times a
 * second; either may be empty.
 */
struct Monitor
{
  /// Receives the finished share, 0..1.
  std::function<void(double)> Progress;
  /// Answers true where the computation is to stop soon.
  std::function<bool()> Aborted;

  /// The same monitor seen by a part of the work: 0..1 of the part is [from, to] of the whole.
  SHADOWCONESCORE_EXPORT Monitor Part(double from, double to) const;
  SHADOWCONESCORE_EXPORT bool IsAborted() const;
};

/**
 * Run body(begin, end) over [0, count) in parallel with vtkSMPTools. Threads take blocks of some milliseconds one after
 * the other, without waiting for each other; the calling thread serves the monitor between its own. The body must depend
 * on its indices only. @return false where the monitor asked to stop: results are then incomplete and to be dropped. An
 * exception of the body is thrown again here, on the calling thread, whatever the backend of vtkSMPTools; the rest of the
 * range is then left out.
 */
SHADOWCONESCORE_EXPORT bool ParallelFor(
  vtkIdType count, const Monitor& monitor, const std::function<void(vtkIdType begin, vtkIdType end)>& body);

/// What a thread does with an item.
using ItemBody = std::function<void(vtkIdType item)>;

/**
 * The same for items that are done faster together: @p groups has the first item of each group of them, ascending, and at
 * its end their number. A thread takes a group at a time; one that finds none any more takes over half of another's.
 * makeBody() is called once a thread, by that thread, for the body of all of its items.
 */
SHADOWCONESCORE_EXPORT bool ParallelForGroups(
  const std::vector<vtkIdType>& groups, const Monitor& monitor, const std::function<ItemBody()>& makeBody);

/// First of @p count items that belong to @p piece of @p pieces: pieces are ranges whose union is the whole.
inline vtkIdType PieceBound(vtkIdType count, vtkIdType piece, vtkIdType pieces)
{
  return count / pieces * piece + count % pieces * piece / pieces;
}

} // namespace shadowcones

#endif
