// SPDX-License-Identifier: BSD-3-Clause
#include "scTerminal.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace
{
volatile std::sig_atomic_t interrupted = 0;

void TakeNote(int signal)
{
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}
} // namespace

namespace shadowcones
{
double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void WatchInterrupt()
{
  std::signal(SIGINT, TakeNote);
  std::signal(SIGTERM, TakeNote);
}

bool IsInterrupted()
{
  return interrupted != 0;
}

ProgressBar::ProgressBar(const std::string& step, bool quiet)
  : Step(step)
  , Quiet(quiet)
  , Terminal(isatty(STDERR_FILENO) != 0)
  , Start(Now())
{
  if (!this->Quiet && !this->Terminal)
  {
    std::fprintf(stderr, "%s ...\n", this->Step.c_str());
  }
  this->Show(0.0);
}

ProgressBar::~ProgressBar()
{
  if (!this->Quiet && this->Terminal)
  {
    std::fprintf(stderr, "\r%70s\r", "");
  }
}

void ProgressBar::Show(double fraction)
{
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (this->Quiet || !this->Terminal || percent == this->Shown)
  {
    return;
  }
  this->Shown = percent;
  char bar[31] = {};
  std::fill(bar, bar + 30, ' ');
  std::fill(bar, bar + percent * 30 / 100, '#');
  std::fprintf(stderr, "\r%-24.24s [%s] %3d %%", this->Step.c_str(), bar, percent);
  std::fflush(stderr);
}

void ProgressBar::Finish()
{
  if (!this->Quiet && !this->Terminal)
  {
    std::fprintf(stderr, "%s: %.2f s\n", this->Step.c_str(), Now() - this->Start);
  }
}
} // namespace shadowcones
