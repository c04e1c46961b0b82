// SPDX-License-Identifier: BSD-3-Clause
// The table of faults: a row a filter in a mode, a column a kind of fault.
//   inject-faults               all of them: every progress event, 400 allocations a case, limits of memory
//   inject-faults --quick       some of each
//   inject-faults --case NAME   one case; large: requests that need more memory than there is
// Where memory ends within another library, that may end the process: such ends are counted apart, with the library's name.
#include "Cases.h"
#include "ChildProcess.h"
#include "DataBytes.h"
#include "FailingNew.h"
#include "LargeRequests.h"
#include "Messages.h"
#include "TimeLimit.h"

#include "vtkOutputWindow.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

using namespace invariants;
using namespace shadowcones::testsupport;

namespace
{

/// How much of everything is tried.
struct Amount
{
  long FirstAllocations = 200;
  long SpreadAllocations = 200;
  int Aborts = 40;
  int Limits = 12;
  int NextRuns = 20; ///< one in so many faults is followed by a whole run
};

/// A filter that has run once, and what it gave.
struct Known
{
  Setting Set;
  NamedBytes Whole;

  explicit Known(const Case& one)
    : Set(one.Make(Size::Small))
  {
    this->Set.Connect();
    this->Set.Filter->Update();
    this->Whole = BytesOfOutputs(this->Set.Filter);
  }
  /// Once more, from the start.
  void Again() const
  {
    this->Set.Filter->SetAbortExecute(0);
    this->Set.Filter->Modified();
    this->Set.Filter->Update();
  }
  /// Empty where @p said or not whole.
  std::string AfterFault(const std::string& errors, bool mustSay) const
  {
    if (AreOutputsEmpty(this->Set.Filter))
    {
      return mustSay && errors.empty() ? "empty without a message" : "";
    }
    if (!errors.empty())
    {
      return "a message, and outputs that are not empty: " + errors;
    }
    const std::string different = Difference(this->Whole, BytesOfOutputs(this->Set.Filter));
    return different.empty() ? "" : "outputs neither empty nor whole: " + different;
  }
  std::string NextRun() const
  {
    Messages messages(this->Set.Filter);
    this->Again();
    return !messages.Errors.empty() ? "the next run: " + messages.Errors
                                    : Difference(this->Whole, BytesOfOutputs(this->Set.Filter));
  }
};

using Report = std::function<void(const std::string& kind, const std::string& fault, const std::string& lost)>;

void AbortEverywhere(const Case& one, const Amount& amount, const Report& report)
{
  const Known known(one);
  int events = 0;
  {
    OnProgress count(known.Set.Filter, [&](vtkAlgorithm*) { ++events; });
    known.Again();
  }
  std::set<int> places;
  for (int k = 0; k < std::min(events, amount.Aborts); ++k)
  {
    places.insert(events <= amount.Aborts ? k : static_cast<int>(1.0 * k * events / amount.Aborts));
  }
  for (const int place : places)
  {
    int event = 0;
    std::string lost;
    {
      OnProgress stop(known.Set.Filter,
        [&](vtkAlgorithm* filter)
        {
          if (event++ == place)
          {
            filter->SetAbortExecute(1);
          }
        });
      Messages messages(known.Set.Filter);
      known.Again();
      lost = messages.Errors.empty() ? known.AfterFault("", false) : messages.Errors;
    }
    lost = lost.empty() ? known.NextRun() : lost;
    report("abort", "at event " + std::to_string(place) + " of " + std::to_string(events), lost);
  }
}

void FailAllocations(const Case& one, const Amount& amount, long from, const Report& report)
{
  vtkSMPTools::SetBackend("Sequential");
  const Known known(one);
  robustness::CountAllocations(0);
  known.Again();
  const long all = robustness::NumberOfAllocations();
  std::set<long> failing;
  for (long k = 1; k <= std::min(all, amount.FirstAllocations); ++k)
  {
    failing.insert(k);
  }
  for (long k = 1; k <= amount.SpreadAllocations && all > amount.FirstAllocations; ++k)
  {
    const double share = static_cast<double>(k) / static_cast<double>(amount.SpreadAllocations);
    failing.insert(std::lround(amount.FirstAllocations * std::pow(1.0 * all / amount.FirstAllocations, share)));
  }
  long tried = 0;
  for (const long call : failing)
  {
    if (call < from)
    {
      continue;
    }
    report("begin", std::to_string(call), "");
    std::string lost;
    {
      Messages messages(known.Set.Filter);
      robustness::CountAllocations(call);
      try
      {
        known.Again();
        robustness::NumberOfAllocations();
        lost = known.AfterFault(messages.Errors, true);
      }
      catch (const std::exception& exception)
      {
        robustness::NumberOfAllocations();
        lost = std::string("an exception left the filter: ") + exception.what();
      }
    }
    if (lost.empty() && ++tried % amount.NextRuns == 0)
    {
      lost = known.NextRun();
    }
    report("allocation", "call " + std::to_string(call) + " of " + std::to_string(all), lost);
  }
}

/// The library that the deepest call lies in, apart from those of the languages themselves.
std::string LibraryAtWork()
{
  std::array<void*, 64> frames;
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  for (int k = 0; k < count; ++k)
  {
    Dl_info info;
    const std::string name = dladdr(frames[static_cast<std::size_t>(k)], &info) != 0 && info.dli_fname ? info.dli_fname : "";
    const std::string file = name.substr(name.rfind('/') + 1);
    const auto isOf = [&file](const char* library) { return file.rfind(library, 0) == 0; };
    if (!file.empty() && !isOf("inject-faults") && !isOf("libc.") && !isOf("libstdc++.") && !isOf("libgomp."))
    {
      return file;
    }
  }
  return "inject-faults";
}

const Report* reportOfEnd = nullptr;

/// The process ends: there is memory again, for a last line.
void TellWhoEnds(int signal)
{
  std::signal(signal, SIG_DFL);
  robustness::LimitAddresses();
  (*reportOfEnd)("ended", LibraryAtWork(), "");
  std::raise(signal);
}

/// In a process of its own: less memory than it takes.
void LimitMemory(const Case& one, std::int64_t bytes, const Report& report)
{
  vtkSMPTools::SetBackend("Sequential");
  Setting setting = one.Make(Size::Small);
  setting.Connect();
  report("begin", std::to_string(bytes), "");
  std::array<void*, 2> frames;
  backtrace(frames.data(), 2); // it takes memory the first time
  reportOfEnd = &report;
  std::signal(SIGABRT, TellWhoEnds);
  std::signal(SIGSEGV, TellWhoEnds);
  robustness::LimitAddresses(bytes);
  std::string lost;
  {
    Messages messages(setting.Filter);
    try
    {
      setting.Filter->Update();
      lost = AreOutputsEmpty(setting.Filter) && messages.Errors.empty() ? "empty without a message" : "";
    }
    catch (const std::exception& exception)
    {
      lost = std::string("an exception left the filter: ") + exception.what();
    }
  }
  report("memory", std::to_string(bytes), lost);
}

struct Row
{
  std::map<std::string, int> Injected;
  int Lost = 0;
  int Elsewhere = 0; ///< ended by another library
};

void Print(const std::string& name, const std::string& kind, const std::string& fault, const std::string& end)
{
  std::cout << "  " << name << ", " << kind << " " << fault << ": " << end.substr(0, 400) << "\n" << std::flush;
}

/// Run something in a process of its own. @return the fault that it was at where it crashed; empty: it ended.
std::string InProcess(const Case& one, Row& row, const std::string& kind, const std::function<void(const Report&)>& work)
{
  const robustness::ChildEnd end = robustness::RunInChild(
    [&](const robustness::Tell& tell)
    {
      alarm(static_cast<unsigned>(TimeLimit(500.0)));
      vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
      work([&](const std::string& what, const std::string& fault, const std::string& lost) { tell({ what, fault, lost }); });
    });
  std::string at = "the beginning";
  std::string library;
  for (const robustness::Line& line : end.Lines)
  {
    if (line[0] == "begin")
    {
      at = line[1];
      continue;
    }
    if (line[0] == "ended")
    {
      library = line[1];
      continue;
    }
    ++row.Injected[line[0]];
    if (line.size() > 2)
    {
      ++row.Lost;
      Print(one.Name, line[0], line[1], "LOST " + line[2]);
    }
  }
  if (!end.Crashed())
  {
    return {};
  }
  ++row.Injected[kind];
  const bool elsewhere = !library.empty() && library != "inject-faults" && library.find("ShadowCones") == std::string::npos;
  ++(elsewhere ? row.Elsewhere : row.Lost);
  Print(one.Name, kind, at, elsewhere ? "ended by " + library : "LOST " + end.Why() + " " + library);
  return at;
}

void InjectAll(const Case& one, const Amount& amount, Row& row)
{
  if (amount.Aborts > 0)
  {
    InProcess(one, row, "abort", [&](const Report& report) { AbortEverywhere(one, amount, report); });
  }
  long from = 1;
  for (int crashes = 0; crashes < 20; ++crashes)
  {
    const std::string at =
      InProcess(one, row, "allocation", [&](const Report& report) { FailAllocations(one, amount, from, report); });
    if (at.empty() || at == "the beginning")
    {
      break;
    }
    from = std::atol(at.c_str()) + 1;
  }
  for (int k = 0; k < amount.Limits; ++k)
  {
    const std::int64_t bytes = (std::int64_t{ 1 } << 26) >> k;
    InProcess(one, row, "memory", [&](const Report& report) { LimitMemory(one, bytes, report); });
  }
}

} // namespace

int main(int argc, char** argv)
{
  const std::string option = argc > 1 ? argv[1] : "";
  const std::string value = argc > 2 ? argv[2] : "";
  const bool quick = option == "--quick";
  if (!(option.empty() || quick || (option == "--case" && !value.empty())))
  {
    std::cerr << "inject-faults [--quick | --case NAME]\n";
    return 2;
  }
  Amount amount;
  if (quick)
  {
    amount = { 2, 3, 2, 1, 4 };
  }
  const std::vector<std::string> kinds = { "abort", "allocation", "memory" };
  Row sum;
  std::cout << "| filter |";
  for (const std::string& kind : kinds)
  {
    std::cout << " " << kind << " |";
  }
  std::cout << " ended elsewhere | lost |\n|---|---|---|---|---|---|\n";
  const std::vector<Case>& cases = AllCases();
  if (!value.empty() && value != "large" && std::none_of(cases.begin(), cases.end(), [&value](const Case& one) { return one.Name == value; }))
  {
    std::cerr << "there is no case " << value << "\n";
    return 2;
  }
  for (std::size_t k = 0; k < cases.size(); ++k)
  {
    // In a quick run every third case.
    if ((!value.empty() && cases[k].Name != value) || (quick && k % 3 != 0))
    {
      continue;
    }
    Row row;
    InjectAll(cases[k], amount, row);
    std::cout << "| " << cases[k].Name << " |";
    for (const std::string& kind : kinds)
    {
      std::cout << " " << row.Injected[kind] << " |";
      sum.Injected[kind] += row.Injected[kind];
    }
    std::cout << " " << row.Elsewhere << " | " << row.Lost << " |\n" << std::flush;
    sum.Elsewhere += row.Elsewhere;
    sum.Lost += row.Lost;
  }
  std::cout << "\n";
  sum.Lost += value.empty() || value == "large" ? robustness::TryLargeRequests() : 0;
  std::cout << "faults injected:";
  for (const std::string& kind : kinds)
  {
    std::cout << " " << kind << " " << sum.Injected[kind] << ",";
  }
  std::cout << " ended elsewhere: " << sum.Elsewhere << ", lost: " << sum.Lost << "\n";
  return sum.Lost > 0 ? 1 : 0;
}
