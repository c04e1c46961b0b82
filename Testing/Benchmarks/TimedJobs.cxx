// SPDX-License-Identifier: BSD-3-Clause
#include "TimedJobs.h"

#include "BenchmarkScene.h"
#include "ErrorCurve.h"

#include "vtkSMPTools.h"

#include <cstdio>
#include <ctime>
#include <unistd.h>

namespace shadowcones
{

//------------------------------------------------------------------------------
TimedJobs::Job TimedJobs::Add(
  const std::string& name, int threads, const std::function<void()>& run, const std::function<void()>& after)
{
  this->Entries.push_back({ name, threads, run, after, {}, {}, 0.0 });
  return this->Entries.size() - 1;
}

//------------------------------------------------------------------------------
void TimedJobs::RunOnce(Entry& entry)
{
  vtkSMPTools::Initialize(entry.Threads);
  const std::clock_t processor = std::clock();
  const double start = Now();
  entry.Call();
  const double seconds = Now() - start;
  entry.ProcessorSeconds.push_back(static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
  entry.Seconds.push_back(seconds);
  entry.Sum += seconds;
  if (entry.After && entry.Seconds.size() == 1)
  {
    entry.After();
  }
}

//------------------------------------------------------------------------------
void TimedJobs::Run(int repeats, double enough)
{
  const bool terminal = isatty(STDERR_FILENO) != 0; // a log gets plain lines
  for (int repeat = 0; repeat < repeats; ++repeat)
  {
    if (!terminal)
    {
      std::fprintf(stderr, "%d of %d: %d jobs\n", repeat + 1, repeats, static_cast<int>(this->Entries.size()));
    }
    for (std::size_t k = 0; k < this->Entries.size(); ++k)
    {
      Entry& entry = this->Entries[repeat % 2 == 0 ? k : this->Entries.size() - 1 - k];
      if (repeat < 2 || entry.Sum < enough)
      {
        if (terminal)
        {
          std::fprintf(stderr, "\r%d of %d: %-60s", repeat + 1, repeats, entry.Name.c_str());
        }
        RunOnce(entry);
      }
    }
  }
  if (terminal)
  {
    std::fprintf(stderr, "\r%-72s\r", "");
  }
}

//------------------------------------------------------------------------------
JobTime TimedJobs::Of(Job job) const
{
  const Entry& entry = this->Entries[job];
  return { Median(entry.Seconds), Median(entry.ProcessorSeconds), static_cast<int>(entry.Seconds.size()) };
}

} // namespace shadowcones
