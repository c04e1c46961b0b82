// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TimedJobs.h
 * @brief Times that may be compared with one another: jobs take turns, there and back, and the medians count.
 */
#ifndef TimedJobs_h
#define TimedJobs_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace shadowcones
{

enum class Clock
{
  Wall,
  Processor ///< of all threads together
};

struct JobTime
{
  double Seconds = 0.0;          ///< by the wall clock, median
  double ProcessorSeconds = 0.0; ///< of all threads, median
  int Runs = 0;

  double By(Clock clock) const { return clock == Clock::Wall ? this->Seconds : this->ProcessorSeconds; }
};

class TimedJobs
{
public:
  using Job = std::size_t;

  /// @param run is timed, with so many @p threads of vtkSMPTools; @param after follows its first run and is not timed.
  Job Add(const std::string& name, int threads, const std::function<void()>& run,
    const std::function<void()>& after = std::function<void()>());

  /**
   * Run all jobs in the order given, then in the opposite one, and so on. A job is left out once its runs have taken
   * @p enough seconds together, but never from its first two (one where @p repeats is 1).
   */
  void Run(int repeats, double enough);

  JobTime Of(Job job) const;

private:
  struct Entry
  {
    std::string Name;
    int Threads;
    std::function<void()> Call;
    std::function<void()> After;
    std::vector<double> Seconds;
    std::vector<double> ProcessorSeconds;
    double Sum = 0.0;
  };
  static void RunOnce(Entry& entry);

  std::vector<Entry> Entries;
};

} // namespace shadowcones

#endif
