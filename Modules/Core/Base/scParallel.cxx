// SPDX-License-Identifier: BSD-3-Clause
#include "scParallel.h"

#include "scBlockSize.h"
#include "scLoopRecorder.h"

#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace shadowcones
{
namespace
{
using Body = std::function<void(vtkIdType begin, vtkIdType end)>;
using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Carries an exception out of worker threads, in which none may escape: that of the first range, if several throw.
class FirstException
{
public:
  void Guard(vtkIdType first, vtkIdType last, const Body& body)
  {
    try
    {
      body(first, last);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->What || first < this->First)
      {
        this->What = std::current_exception();
        this->First = first;
      }
      this->Thrown = true;
    }
  }
  bool IsThrown() const { return this->Thrown; }
  void Rethrow() const
  {
    if (this->What)
    {
      std::rethrow_exception(this->What);
    }
  }

private:
  std::atomic<bool> Thrown{ false };
  std::mutex Mutex;
  std::exception_ptr What;
  vtkIdType First = 0;
};

/// What the threads of a loop share, whatever they do.
class LoopState
{
public:
  LoopState(vtkIdType count, const Monitor& monitor)
    : Count(count)
    , TheMonitor(monitor)
  {
  }

  /// On the calling thread. The first answers come at once: a short loop is seen too.
  void Serve()
  {
    constexpr double pause = 0.05;
    constexpr int atOnce = 2;
    if (this->Stopped || (this->Served >= atOnce && SecondsSince(this->LastServed) < pause))
    {
      return;
    }
    this->Stopped = this->TheMonitor.IsAborted();
    this->Served += 1;
    this->LastServed = Clock::now();
    const vtkIdType done = this->Done;
    if (this->TheMonitor.Progress && !this->Stopped && done < this->Count)
    {
      this->TheMonitor.Progress(static_cast<double>(done) / static_cast<double>(this->Count));
    }
  }

  /// After all threads. @return false where the loop was stopped.
  bool Finish() const
  {
    this->Exception.Rethrow();
    if (this->Stopped || this->TheMonitor.IsAborted())
    {
      return false;
    }
    if (this->TheMonitor.Progress)
    {
      this->TheMonitor.Progress(1.0);
    }
    return !this->TheMonitor.IsAborted();
  }

protected:
  bool GoesOn() const { return !this->Stopped && !this->Exception.IsThrown(); }
  void Finished(vtkIdType items)
  {
    this->Done += items;
    if (std::this_thread::get_id() == this->Caller)
    {
      this->Serve();
    }
  }

  const vtkIdType Count;
  FirstException Exception;

private:
  const Monitor& TheMonitor;
  const std::thread::id Caller = std::this_thread::get_id();
  std::atomic<vtkIdType> Done{ 0 };
  std::atomic<bool> Stopped{ false };
  int Served = 0;
  Clock::time_point LastServed;
};

/// Items of which any number of threads take blocks.
class BlockLoop : public LoopState
{
public:
  BlockLoop(vtkIdType count, int threads, const Monitor& monitor, const Body& body)
    : LoopState(count, monitor)
    , Threads(threads)
    , TheBody(body)
  {
  }

  /// Take blocks until nothing is left; the calling thread serves the monitor.
  void Work()
  {
    FinishedBlock last;
    vtkIdType begin = 0;
    vtkIdType end = 0;
    while (this->GoesOn() && this->Take(last, begin, end))
    {
      const auto start = Clock::now();
      this->Exception.Guard(begin, end, this->TheBody);
      last = { end - begin, SecondsSince(start) };
      this->Finished(last.Items);
    }
  }

private:
  bool Take(const FinishedBlock& last, vtkIdType& begin, vtkIdType& end)
  {
    begin = this->Next;
    do
    {
      if (begin >= this->Count)
      {
        return false;
      }
      end = begin + NextBlockSize(this->Count - begin, this->Threads, last);
    } while (!this->Next.compare_exchange_weak(begin, end));
    return true;
  }

  const int Threads;
  const Body& TheBody;
  std::atomic<vtkIdType> Next{ 0 };
};

/// Groups of items, of which threads take one each and help each other at the end.
class GroupLoop : public LoopState
{
public:
  GroupLoop(const std::vector<vtkIdType>& groups, int threads, const Monitor& monitor,
    const std::function<ItemBody()>& makeBody)
    : LoopState(groups.back(), monitor)
    , Groups(groups)
    , MakeBody(makeBody)
    , Left(static_cast<std::size_t>(threads))
  {
  }

  void Work()
  {
    const auto own = static_cast<std::size_t>(this->NextThread++);
    if (own >= this->Left.size())
    {
      return;
    }
    ItemBody body;
    this->Exception.Guard(0, 0, [&](vtkIdType, vtkIdType) { body = this->MakeBody(); });
    vtkIdType item = 0;
    bool isFirst = false;
    while (this->GoesOn() && this->Take(own, item, isFirst))
    {
      const auto start = Clock::now();
      this->Exception.Guard(item, item + 1, [&](vtkIdType, vtkIdType) { body(item); });
      (isFirst ? this->Firsts : this->Others).Add(SecondsSince(start));
      this->Finished(1);
    }
  }

private:
  /// First item in the upper half, end in the lower.
  using Range = std::uint64_t;
  static Range RangeOf(vtkIdType begin, vtkIdType end)
  {
    return static_cast<Range>(begin) << 32 | static_cast<Range>(end);
  }
  static vtkIdType BeginOf(Range range) { return static_cast<vtkIdType>(range >> 32); }
  static vtkIdType EndOf(Range range) { return static_cast<vtkIdType>(range & 0xFFFFFFFFu); }
  static vtkIdType SizeOf(Range range) { return EndOf(range) - BeginOf(range); }

  /// Of items that took so long.
  class MeanSeconds
  {
  public:
    void Add(double seconds)
    {
      this->Nanoseconds += static_cast<std::int64_t>(1e9 * seconds);
      this->Count += 1;
    }
    double Value() const
    {
      return 1e-9 * static_cast<double>(this->Nanoseconds) / static_cast<double>(std::max<std::int64_t>(this->Count, 1));
    }

  private:
    std::atomic<std::int64_t> Nanoseconds{ 0 };
    std::atomic<std::int64_t> Count{ 0 };
  };

  bool Take(std::size_t own, vtkIdType& item, bool& isFirst)
  {
    isFirst = false;
    if (this->TakeFirst(this->Left[own], item))
    {
      return true;
    }
    isFirst = true;
    const auto group = static_cast<std::size_t>(this->NextGroup++);
    if (group + 1 < this->Groups.size())
    {
      item = this->Groups[group];
      this->Left[own] = RangeOf(item + 1, this->Groups[group + 1]);
      return true;
    }
    return this->TakeOver(own, item);
  }

  static bool TakeFirst(std::atomic<Range>& left, vtkIdType& item)
  {
    Range range = left;
    while (SizeOf(range) > 0)
    {
      if (left.compare_exchange_weak(range, RangeOf(BeginOf(range) + 1, EndOf(range))))
      {
        item = BeginOf(range);
        return true;
      }
    }
    return false;
  }

  /// The last half of what is left to whoever has most.
  bool TakeOver(std::size_t own, vtkIdType& item)
  {
    for (;;)
    {
      std::atomic<Range>* richest = nullptr;
      Range range = 0;
      for (std::atomic<Range>& other : this->Left)
      {
        const Range found = other;
        if (SizeOf(found) > SizeOf(range))
        {
          richest = &other;
          range = found;
        }
      }
      const double each = this->Others.Value();
      const vtkIdType taken = NumberToTakeOver(SizeOf(range), this->Firsts.Value() - each, each);
      if (taken == 0)
      {
        return false;
      }
      const vtkIdType end = EndOf(range);
      if (richest->compare_exchange_strong(range, RangeOf(BeginOf(range), end - taken)))
      {
        item = end - taken;
        this->Left[own] = RangeOf(item + 1, end);
        return true;
      }
    }
  }

  const std::vector<vtkIdType>& Groups;
  const std::function<ItemBody()>& MakeBody;
  std::vector<std::atomic<Range>> Left; ///< of each thread's group
  std::atomic<int> NextThread{ 0 };
  std::atomic<vtkIdType> NextGroup{ 0 };
  MeanSeconds Firsts; ///< items with the preparation of their group
  MeanSeconds Others;
};

/// With some backends of vtkSMPTools the calling thread does nothing but wait.
bool DoesCallerWait()
{
  const char* backend = vtkSMPTools::GetBackend();
  return backend && std::strcmp(backend, "STDThread") == 0;
}

/// Does this thread run the body of a loop of ours?
thread_local bool isInLoop = false;

/// Does this thread run the body of a loop, ours or another's? Before 9.3 VTK knew only whether any thread does.
bool IsInLoop()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return isInLoop || vtkSMPTools::IsParallelScope();
#else
  return isInLoop;
#endif
}

template <typename Loop>
void RunOnThreads(Loop& loop, int threads)
{
  vtkSMPTools::For(0, threads, 1,
    [&loop](vtkIdType, vtkIdType)
    {
      const bool before = isInLoop;
      isInLoop = true;
      loop.Work();
      isInLoop = before;
    });
}

/// The loop runs elsewhere while the calling thread serves the monitor.
template <typename Loop>
void ServeWhileOthersWork(Loop& loop, int threads)
{
  std::mutex mutex;
  std::condition_variable ended;
  bool isEnded = false;
  std::thread others(
    [&]
    {
      RunOnThreads(loop, threads);
      const std::lock_guard<std::mutex> lock(mutex);
      isEnded = true;
      ended.notify_one();
    });
  std::unique_lock<std::mutex> lock(mutex);
  while (!ended.wait_for(lock, std::chrono::milliseconds(5), [&isEnded] { return isEnded; }))
  {
    lock.unlock();
    loop.Serve();
    lock.lock();
  }
  lock.unlock();
  others.join();
}

int ThreadsFor(vtkIdType count)
{
  return static_cast<int>(std::clamp<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(), 1, count));
}

/// @return false where the monitor asked to stop.
template <typename Loop>
bool Run(Loop& loop, int threads, const Monitor& monitor)
{
  if (monitor.Progress)
  {
    monitor.Progress(0.0);
  }
  if (threads == 1)
  {
    loop.Work();
  }
  else if ((monitor.Progress || monitor.Aborted) && DoesCallerWait() && !IsInLoop())
  {
    // Not within a loop: from another thread VTK does not know the loop as a part of it, and since 9.3 would wait for threads
    // that wait for this one.
    ServeWhileOthersWork(loop, threads);
  }
  else
  {
    RunOnThreads(loop, threads);
  }
  return loop.Finish();
}
} // anonymous namespace

Monitor Monitor::Part(double from, double to) const
{
  Monitor part;
  part.Aborted = this->Aborted;
  if (this->Progress)
  {
    part.Progress = [from, to, whole = this->Progress](double fraction) { whole(from + (to - from) * fraction); };
  }
  return part;
}

bool Monitor::IsAborted() const
{
  return this->Aborted && this->Aborted();
}

bool ParallelFor(
  vtkIdType count, const Monitor& monitor, const std::function<void(vtkIdType begin, vtkIdType end)>& body)
{
  if (monitor.IsAborted())
  {
    return false;
  }
  if (count <= 0)
  {
    return true;
  }
  if (LoopRecorder* recorder = LoopRecorder::Active())
  {
    recorder->Run(count, body);
    return true;
  }
  const int threads = ThreadsFor(count);
  BlockLoop loop(count, threads, monitor, body);
  return Run(loop, threads, monitor);
}

bool ParallelForGroups(
  const std::vector<vtkIdType>& groups, const Monitor& monitor, const std::function<ItemBody()>& makeBody)
{
  if (monitor.IsAborted())
  {
    return false;
  }
  if (groups.empty() || groups.back() <= 0)
  {
    return true;
  }
  if (groups.back() >= std::numeric_limits<std::int32_t>::max())
  {
    throw std::length_error("a loop over groups holds at most 2^31 - 2 items");
  }
  if (LoopRecorder* recorder = LoopRecorder::Active())
  {
    const ItemBody body = makeBody();
    recorder->Run(groups.back(), [&body](vtkIdType begin, vtkIdType end) {
      for (vtkIdType item = begin; item < end; ++item)
      {
        body(item);
      }
    }, groups);
    return true;
  }
  const int threads = ThreadsFor(groups.back());
  GroupLoop loop(groups, threads, monitor, makeBody);
  return Run(loop, threads, monitor);
}

} // namespace shadowcones
