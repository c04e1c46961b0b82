// SPDX-License-Identifier: BSD-3-Clause
#include "scLoopRecorder.h"

#include "scBlockSize.h"

#include <algorithm>
#include <atomic>
#include <chrono>
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

void LoopRecorder::Run(vtkIdType count, const std::function<void(vtkIdType begin, vtkIdType end)>& body)
{
  if (this->InsideItem)
  {
    body(0, count);
    return;
  }
  this->InsideItem = true;
  Loop loop;
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

double LoopRecorder::Replay(const std::vector<double>& items, int threads, double overhead)
{
  // The thread that is free first takes the next block.
  using FreeAt = std::pair<double, int>;
  std::priority_queue<FreeAt, std::vector<FreeAt>, std::greater<FreeAt>> queue;
  std::vector<FinishedBlock> last(static_cast<std::size_t>(threads));
  for (int thread = 0; thread < threads; ++thread)
  {
    queue.push({ 0.0, thread });
  }
  double end = 0.0;
  const auto count = static_cast<vtkIdType>(items.size());
  for (vtkIdType next = 0; next < count;)
  {
    const auto [time, thread] = queue.top();
    queue.pop();
    FinishedBlock& block = last[static_cast<std::size_t>(thread)];
    const vtkIdType size = NextBlockSize(count - next, threads, block);
    block = { size, 0.0 };
    for (vtkIdType i = next; i < next + size; ++i)
    {
      block.Seconds += items[static_cast<std::size_t>(i)];
    }
    next += size;
    end = std::max(end, time + overhead + block.Seconds);
    queue.push({ time + overhead + block.Seconds, thread });
  }
  return end;
}

} // namespace shadowcones
