// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scChildProcess.h
 * @brief Work that may crash, in a process of its own. Internal to the module.
 */
#ifndef scChildProcess_h
#define scChildProcess_h

#include <cstdint>
#include <functional>
#include <string>

namespace shadowcones
{

enum class ChildEnd
{
  Answered,
  Crashed,  ///< or it ran out of the memory that it may take
  TimedOut, ///< and was ended
  NotBegun  ///< the system starts no process
};

struct ChildLimits
{
  double Seconds = 60.0;
  std::int64_t Memory = 0; ///< bytes beyond what this process has; 0: all there is
};

/**
 * Run @p work in a copy of this process and take what it returns. It is alone there: threads of this process have no
 * copies, VTK works in one thread, and nothing that it prints is seen.
 */
ChildEnd RunInChild(const std::function<std::string()>& work, const ChildLimits& limits, std::string& answer);

} // namespace shadowcones

#endif
