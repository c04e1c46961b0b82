// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTerminal.h
 * @brief What the user sees while a command works, and how Ctrl-C reaches it.
 */
#ifndef scTerminal_h
#define scTerminal_h

#include <string>

namespace shadowcones
{
/// Seconds of a clock that never goes back.
double Now();

/// Take note of Ctrl-C from here on; a second one ends the program at once.
void WatchInterrupt();
/// Whether Ctrl-C came.
bool IsInterrupted();

/// Progress of one step on standard error: a bar on a terminal, else a line when the step begins and one when it is done.
class ProgressBar
{
public:
  ProgressBar(const std::string& step, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param fraction  how much is done, 0 to 1
  void Show(double fraction);
  /// The step is whole.
  void Finish();

private:
  std::string Step;
  bool Quiet;
  bool Terminal;
  double Start;
  int Shown = -1;
};
} // namespace shadowcones

#endif
