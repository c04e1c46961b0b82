// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLoopRecorder.h
 * @brief How long each item of each parallel loop takes: what a machine with more threads would do with them.
 */
#ifndef scLoopRecorder_h
#define scLoopRecorder_h

#include "ShadowConesCoreModule.h"
#include "vtkType.h"

#include <functional>
#include <vector>

namespace shadowcones
{

/**
 * While one is there, ParallelFor() runs item after item on the calling thread and notes the seconds of each;
 * items that are too short for the clock are timed some at a time, and share the seconds evenly. Loops
 * inside of an item are part of it, and noted too; those inside of these are not. For programs that measure; one at a time.
 */
class SHADOWCONESCORE_EXPORT LoopRecorder
{
public:
  struct Loop
  {
    double Before = 0.0; ///< seconds since the end of the last loop, or since the recorder was made, or the item began
    std::vector<double> Items;
    std::vector<vtkIdType> Groups; ///< of ParallelForGroups(); empty: of ParallelFor()
    std::vector<std::vector<Loop>> Inner; ///< of each item the loops inside of it
  };

  LoopRecorder();
  ~LoopRecorder();
  LoopRecorder(const LoopRecorder&) = delete;
  LoopRecorder& operator=(const LoopRecorder&) = delete;

  const std::vector<Loop>& Loops() const { return this->Recorded; }
  /// Seconds since the end of the last loop.
  double Rest() const;

  /**
   * Seconds that a loop would take on so many threads that take its items as those of ParallelFor() do, with @p overhead
   * seconds for each block. What the first item of a group takes longer than the others' median is counted again
   * for every thread that helps with the group. Threads without an item of a loop help with the loops inside of the others'
   * items, as those of TBB do.
   */
  static double Replay(const Loop& loop, int threads, double overhead);

  /// The one that is there, or nullptr. @{ For ParallelFor().
  static LoopRecorder* Active();
  void Run(vtkIdType count, const std::function<void(vtkIdType begin, vtkIdType end)>& body,
    const std::vector<vtkIdType>& groups = {});
  /// @}

private:
  std::vector<Loop> Recorded;
  double End = 0.0;
  std::vector<Loop>* OfItem = nullptr; ///< the loops of the item that is being run
  double InnerEnd = 0.0;               ///< of the last of these, or when the item began
  bool InsideInner = false;
};

} // namespace shadowcones

#endif
