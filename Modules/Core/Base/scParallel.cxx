// SPDX-License-Identifier: BSD-3-Clause
#include "scParallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>

namespace shadowcones
{
namespace
{
/// Carries an exception out of worker threads, in which none may escape: that of the first range, if several throw.
class FirstException
{
public:
  template <typename Body>
  void Guard(vtkIdType first, vtkIdType last, const Body& body)
  {
    if (this->Thrown)
    {
      return;
    }
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
  using Clock = std::chrono::steady_clock;
  constexpr double blockSeconds = 0.05;

  // Few at first where progress is shown: an item may be a thousand photons.
  vtkIdType block = std::min<vtkIdType>(count, monitor.Progress ? 4 : 64);
  for (vtkIdType begin = 0; begin < count;)
  {
    if (monitor.IsAborted())
    {
      return false;
    }
    const vtkIdType end = std::min(count, begin + block);
    const auto start = Clock::now();
    FirstException exception;
    vtkSMPTools::For(begin, end, [&](vtkIdType first, vtkIdType last) { exception.Guard(first, last, body); });
    exception.Rethrow();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();

    begin = end;
    if (monitor.Progress)
    {
      monitor.Progress(static_cast<double>(begin) / static_cast<double>(count));
    }
    // The block size follows the clock, the results do not: the body sees its indices only.
    const double factor = std::clamp(blockSeconds / std::max(seconds, 1e-6), 0.25, 4.0);
    block = std::max<vtkIdType>(1, static_cast<vtkIdType>(static_cast<double>(block) * factor));
  }
  return !monitor.IsAborted();
}

} // namespace shadowcones
