// SPDX-License-Identifier: BSD-3-Clause
#include "scLoopRecorder.h"

#include "scBlockSize.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

namespace shadowcones
{
namespace
{
std::atomic<LoopRecorder*> active{ nullptr };

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The thread that is free first goes on.
class FreeThreads
{
public:
  explicit FreeThreads(int threads)
  {
    for (int thread = 0; thread < threads; ++thread)
    {
      this->Queue.push({ 0.0, thread });
    }
  }
  /// The next one and its time, taken out.
  std::pair<double, int> Pop()
  {
    const auto next = this->Queue.top();
    this->Queue.pop();
    return next;
  }
  void Push(double time, int thread)
  {
    this->Queue.push({ time, thread });
    this->Last = std::max(this->Last, time);
  }
  bool Empty() const { return this->Queue.empty(); }
  double End() const { return this->Last; }

private:
  using FreeAt = std::pair<double, int>;
  std::priority_queue<FreeAt, std::vector<FreeAt>, std::greater<FreeAt>> Queue;
  double Last = 0.0;
};

double ReplayBlocks(const std::vector<double>& items, int threads, double overhead)
{
  FreeThreads free(threads);
  std::vector<FinishedBlock> last(static_cast<std::size_t>(threads));
  const auto count = static_cast<vtkIdType>(items.size());
  for (vtkIdType next = 0; next < count;)
  {
    const auto [time, thread] = free.Pop();
    FinishedBlock& block = last[static_cast<std::size_t>(thread)];
    const vtkIdType size = NextBlockSize(count - next, threads, block);
    block = { size, 0.0 };
    for (vtkIdType i = next; i < next + size; ++i)
    {
      block.Seconds += items[static_cast<std::size_t>(i)];
    }
    next += size;
    free.Push(time + overhead + block.Seconds, thread);
  }
  return free.End();
}

/// Threads that take groups and help each other, as in ParallelForGroups().
class GroupReplay
{
public:
  GroupReplay(const LoopRecorder::Loop& loop, int threads)
    : Loop(loop)
    , Threads(threads)
    , Left(static_cast<std::size_t>(threads), { 0, 0 })
    , GroupOf(static_cast<std::size_t>(threads), 0)
    , Prepared(static_cast<std::size_t>(threads), -1)
  {
    const std::vector<vtkIdType>& groups = loop.Groups;
    double all = 0.0;
    for (const double seconds : loop.Items)
    {
      all += seconds;
    }
    for (std::size_t group = 0; group + 1 < groups.size(); ++group)
    {
      this->MeanFirst += loop.Items[static_cast<std::size_t>(groups[group])];
    }
    const auto others = static_cast<double>(loop.Items.size()) - static_cast<double>(groups.size() - 1);
    this->MeanOther = others > 0.0 ? (all - this->MeanFirst) / others : 0.0;
    this->MeanFirst /= static_cast<double>(groups.size() - 1);
  }

  double Run(double overhead)
  {
    FreeThreads free(this->Threads);
    while (!free.Empty())
    {
      const auto [time, thread] = free.Pop();
      const double seconds = this->Next(static_cast<std::size_t>(thread));
      if (seconds >= 0.0)
      {
        free.Push(time + overhead + seconds, thread);
      }
    }
    return free.End();
  }

private:
  /// Seconds of the thread's next item; below 0: there is none.
  double Next(std::size_t thread)
  {
    std::pair<vtkIdType, vtkIdType>& own = this->Left[thread];
    if (own.first == own.second && this->NextGroup + 1 < this->Loop.Groups.size())
    {
      own = { this->Loop.Groups[this->NextGroup], this->Loop.Groups[this->NextGroup + 1] };
      this->GroupOf[thread] = static_cast<std::ptrdiff_t>(this->NextGroup++);
    }
    if (own.first < own.second)
    {
      return this->SecondsOf(thread, this->GroupOf[thread], own.first++);
    }
    std::size_t richest = thread;
    const auto size = [this](std::size_t t) { return this->Left[t].second - this->Left[t].first; };
    for (std::size_t other = 0; other < this->Left.size(); ++other)
    {
      richest = size(other) > size(richest) ? other : richest;
    }
    const vtkIdType taken = NumberToTakeOver(size(richest), this->MeanFirst - this->MeanOther, this->MeanOther);
    if (taken == 0)
    {
      return -1.0;
    }
    const vtkIdType end = this->Left[richest].second;
    this->Left[richest].second = end - taken;
    own = { end - taken + 1, end };
    this->GroupOf[thread] = this->GroupOf[richest];
    return this->SecondsOf(thread, this->GroupOf[thread], end - taken);
  }

  double SecondsOf(std::size_t thread, std::ptrdiff_t group, vtkIdType item)
  {
    const vtkIdType first = this->Loop.Groups[static_cast<std::size_t>(group)];
    double seconds = this->Loop.Items[static_cast<std::size_t>(item)];
    if (item != first && this->Prepared[thread] != group)
    {
      seconds += this->PreparationOf(static_cast<std::size_t>(group));
    }
    this->Prepared[thread] = group;
    return seconds;
  }

  double PreparationOf(std::size_t group) const
  {
    const auto first = this->Loop.Items.begin() + this->Loop.Groups[group];
    std::vector<double> others(first + 1, this->Loop.Items.begin() + this->Loop.Groups[group + 1]);
    std::sort(others.begin(), others.end());
    return others.empty() ? 0.0 : std::max(0.0, *first - others[others.size() / 2]);
  }

  const LoopRecorder::Loop& Loop;
  const int Threads;
  std::vector<std::pair<vtkIdType, vtkIdType>> Left; ///< of each thread's group
  std::vector<std::ptrdiff_t> GroupOf;
  std::vector<std::ptrdiff_t> Prepared; ///< the group that the thread has prepared last
  std::size_t NextGroup = 0;
  double MeanFirst = 0.0; ///< seconds of items with the preparation of their group
  double MeanOther = 0.0;
};
} // anonymous namespace

LoopRecorder::LoopRecorder()
  : End(Now())
{
  active = this;
}

LoopRecorder::~LoopRecorder()
{
  active = nullptr;
}

double LoopRecorder::Rest() const
{
  return Now() - this->End;
}

LoopRecorder* LoopRecorder::Active()
{
  return active;
}

void LoopRecorder::Run(vtkIdType count, const std::function<void(vtkIdType begin, vtkIdType end)>& body,
  const std::vector<vtkIdType>& groups)
{
  if (this->InsideItem)
  {
    body(0, count);
    return;
  }
  this->InsideItem = true;
  Loop loop;
  loop.Groups = groups;
  double start = Now();
  loop.Before = start - this->End;
  loop.Items.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    body(i, i + 1);
    const double end = Now();
    loop.Items.push_back(end - start);
    start = end;
  }
  this->Recorded.push_back(std::move(loop));
  this->InsideItem = false;
  this->End = Now();
}

double LoopRecorder::Replay(const Loop& loop, int threads, double overhead)
{
  return loop.Groups.empty() ? ReplayBlocks(loop.Items, threads, overhead) : GroupReplay(loop, threads).Run(overhead);
}

} // namespace shadowcones
