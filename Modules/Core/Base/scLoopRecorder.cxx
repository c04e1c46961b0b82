// SPDX-License-Identifier: BSD-3-Clause
#include "scLoopRecorder.h"

#include "scBlockSize.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
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

/// Items to time together after so many took so long: where one takes less than the clock can tell, it would be the clock that is timed.
vtkIdType NextTogether(vtkIdType items, double seconds)
{
  constexpr double enough = 1e-5;
  return seconds < enough ? 2 * items : (seconds > 4.0 * enough ? std::max<vtkIdType>(1, items / 2) : items);
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

/// Threads that take blocks of items and help with the loops inside of them once there are no more. Help is shared out evenly,
/// and no loop ends before its longest item could.
class NestedReplay
{
public:
  NestedReplay(const LoopRecorder::Loop& loop, int threads, double overhead)
    : Loop(loop)
    , Threads(threads)
    , Overhead(overhead)
  {
  }

  double Run()
  {
    std::vector<Block> running;
    std::vector<FinishedBlock> last(static_cast<std::size_t>(this->Threads));
    std::vector<std::size_t> idle;
    for (std::size_t thread = last.size(); thread-- > 0;)
    {
      idle.push_back(thread);
    }
    double now = 0.0;
    for (;;)
    {
      while (!idle.empty() && this->Next < this->Count())
      {
        running.push_back(this->Take(idle.back(), last[idle.back()], now));
        idle.pop_back();
      }
      if (running.empty())
      {
        return now;
      }
      double step = HUGE_VAL;
      const std::vector<double> rates = RatesOf(running, static_cast<double>(idle.size()));
      for (std::size_t k = 0; k < running.size(); ++k)
      {
        step = std::min(step, running[k].Left() / rates[k]);
      }
      now += step;
      for (std::size_t k = running.size(); k-- > 0;)
      {
        if (running[k].Advance(step * rates[k]))
        {
          last[running[k].Thread] = { running[k].Items, now - running[k].Begin };
          idle.push_back(running[k].Thread);
          running.erase(running.begin() + static_cast<std::ptrdiff_t>(k));
        }
      }
    }
  }

private:
  /// Work that so many threads can share at most.
  struct Segment
  {
    double Seconds;
    double Most;
  };
  struct Block
  {
    std::size_t Thread = 0;
    vtkIdType Items = 0;
    double Begin = 0.0;
    std::vector<Segment> Segments;
    std::size_t At = 0;

    double Left() const { return this->Segments[this->At].Seconds; }
    double Most() const { return this->Segments[this->At].Most; }
    /// @return is it done?
    bool Advance(double work)
    {
      constexpr double nothing = 1e-12;
      this->Segments[this->At].Seconds -= work;
      while (this->At < this->Segments.size() && this->Segments[this->At].Seconds <= nothing)
      {
        this->At += 1;
      }
      return this->At == this->Segments.size();
    }
  };

  vtkIdType Count() const { return static_cast<vtkIdType>(this->Loop.Items.size()); }

  Block Take(std::size_t thread, const FinishedBlock& last, double now)
  {
    Block block;
    block.Thread = thread;
    block.Items = NextBlockSize(this->Count() - this->Next, this->Threads, last);
    block.Begin = now;
    block.Segments.push_back({ this->Overhead, 1.0 });
    for (vtkIdType item = this->Next; item < this->Next + block.Items; ++item)
    {
      double alone = this->Loop.Items[static_cast<std::size_t>(item)];
      for (const LoopRecorder::Loop& inner : this->Loop.Inner[static_cast<std::size_t>(item)])
      {
        const double work = std::accumulate(inner.Items.begin(), inner.Items.end(), 0.0);
        const double longest = *std::max_element(inner.Items.begin(), inner.Items.end());
        block.Segments.push_back({ inner.Before, 1.0 });
        block.Segments.push_back({ work, work / std::max(longest, 1e-9) });
        alone -= inner.Before + work;
      }
      block.Segments.push_back({ std::max(0.0, alone), 1.0 });
    }
    this->Next += block.Items;
    return block;
  }

  /// Threads that are at each block: its own, and its share of those that help.
  static std::vector<double> RatesOf(const std::vector<Block>& running, double helpers)
  {
    std::vector<double> rates(running.size(), 1.0);
    const auto open = std::count_if(running.begin(), running.end(), [](const Block& b) { return b.Most() > 1.0; });
    for (std::size_t k = 0; k < running.size() && open > 0; ++k)
    {
      rates[k] = std::clamp(1.0 + helpers / static_cast<double>(open), 1.0, std::max(1.0, running[k].Most()));
    }
    return rates;
  }

  const LoopRecorder::Loop& Loop;
  const int Threads;
  const double Overhead;
  vtkIdType Next = 0;
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
  if (this->InsideInner)
  {
    body(0, count);
    return;
  }
  const bool isInner = this->OfItem != nullptr;
  Loop loop;
  loop.Groups = groups;
  double start = Now();
  loop.Before = start - (isInner ? this->InnerEnd : this->End);
  loop.Items.reserve(static_cast<std::size_t>(count));
  loop.Inner.reserve(static_cast<std::size_t>(count));
  this->InsideInner = isInner;
  vtkIdType together = 1;
  for (vtkIdType begin = 0; begin < count;)
  {
    const vtkIdType end = std::min(begin + together, count);
    std::vector<Loop> inner;
    start = Now();
    if (!isInner)
    {
      this->OfItem = &inner;
      this->InnerEnd = start;
    }
    body(begin, end);
    const double seconds = Now() - start;
    const bool isPlain = groups.empty() && inner.empty();
    loop.Items.insert(loop.Items.end(), static_cast<std::size_t>(end - begin), seconds / static_cast<double>(end - begin));
    loop.Inner.push_back(std::move(inner));
    loop.Inner.resize(loop.Items.size());
    together = isPlain ? NextTogether(end - begin, seconds) : 1;
    begin = end;
  }
  this->InsideInner = false;
  if (isInner)
  {
    this->OfItem->push_back(std::move(loop));
    this->InnerEnd = Now();
    return;
  }
  this->OfItem = nullptr;
  this->Recorded.push_back(std::move(loop));
  this->End = Now();
}

double LoopRecorder::Replay(const Loop& loop, int threads, double overhead)
{
  const bool nested = std::any_of(
    loop.Inner.begin(), loop.Inner.end(), [](const std::vector<Loop>& inner) { return !inner.empty(); });
  return !loop.Groups.empty() ? GroupReplay(loop, threads).Run(overhead)
    : nested                  ? NestedReplay(loop, threads, overhead).Run()
                              : ReplayBlocks(loop.Items, threads, overhead);
}

} // namespace shadowcones
