// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFailure.h
 * @brief Why a command ends without a result, and the code that it ends with.
 */
#ifndef scFailure_h
#define scFailure_h

#include <stdexcept>
#include <string>

namespace shadowcones
{
/// The codes that the program ends with.
enum ExitCode
{
  ExitDone = 0,
  ExitFailed = 1,       ///< a file cannot be read or written, or a filter says what is wrong
  ExitUsage = 2,        ///< the command line is not understood
  ExitInterrupted = 130 ///< Ctrl-C
};

/// A sentence for the user.
class Failure : public std::runtime_error
{
public:
  explicit Failure(const std::string& sentence, ExitCode code = ExitFailed)
    : std::runtime_error(sentence)
    , Code(code)
  {
  }
  ExitCode Code;
};
} // namespace shadowcones

#endif
