// SPDX-License-Identifier: BSD-3-Clause
#include "scParallel.h"

#include "scBlockSize.h"
#include "scLoopRecorder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
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

/// The items of a loop, of which any number of threads take blocks.
class SharedLoop
{
public:
  SharedLoop(vtkIdType count, int threads, const Monitor& monitor, const Body& body)
    : Count(count)
    , Threads(threads)
    , TheMonitor(monitor)
    , TheBody(body)
  {
  }

  /// Take blocks until nothing is left; the calling thread serves the monitor.
  void Work()
  {
    const bool serves = std::this_thread::get_id() == this->Caller;
    FinishedBlock last;
    vtkIdType begin = 0;
    vtkIdType end = 0;
    while (!this->Stopped && !this->Exception.IsThrown() && this->Take(last, begin, end))
    {
      const auto start = Clock::now();
      this->Exception.Guard(begin, end, this->TheBody);
      last = { end - begin, SecondsSince(start) };
      this->Done += last.Items;
      if (serves)
      {
        this->Serve();
      }
    }
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
    if (!this->Stopped && this->TheMonitor.Progress)
    {
      this->TheMonitor.Progress(1.0);
    }
    return !this->Stopped && !this->TheMonitor.IsAborted();
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

  const vtkIdType Count;
  const int Threads;
  const Monitor& TheMonitor;
  const Body& TheBody;
  const std::thread::id Caller = std::this_thread::get_id();
  FirstException Exception;
  std::atomic<vtkIdType> Next{ 0 };
  std::atomic<vtkIdType> Done{ 0 };
  std::atomic<bool> Stopped{ false };
  int Served = 0;
  Clock::time_point LastServed;
};

/// With some backends of vtkSMPTools the calling thread does nothing but wait.
bool DoesCallerWait()
{
  const char* backend = vtkSMPTools::GetBackend();
  return backend && std::strcmp(backend, "STDThread") == 0;
}

void RunOnThreads(SharedLoop& loop, int threads)
{
  vtkSMPTools::For(0, threads, 1, [&loop](vtkIdType, vtkIdType) { loop.Work(); });
}

/// The loop runs elsewhere while the calling thread serves the monitor.
void ServeWhileOthersWork(SharedLoop& loop, int threads)
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
  const vtkIdType threads = std::clamp<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(), 1, count);
  SharedLoop loop(count, static_cast<int>(threads), monitor, body);
  if (monitor.Progress)
  {
    monitor.Progress(0.0);
  }
  if (threads == 1)
  {
    loop.Work();
  }
  else if ((monitor.Progress || monitor.Aborted) && DoesCallerWait())
  {
    ServeWhileOthersWork(loop, static_cast<int>(threads));
  }
  else
  {
    RunOnThreads(loop, static_cast<int>(threads));
  }
  return loop.Finish();
}

} // namespace shadowcones
