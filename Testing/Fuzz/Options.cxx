// SPDX-License-Identifier: BSD-3-Clause
// Texts of strangers: command lines.
#include "Bytes.h"
#include "Harnesses.h"

#include "scCommandLine.h"
#include "scFailure.h"
#include "scPlaces.h"

#include <CLI/CLI.hpp>

namespace fuzz
{
namespace
{

/// The whole command line, whose commands do nothing.
CLI::App& Program()
{
  static const std::unique_ptr<CLI::App> program = []
  {
    auto made = shadowcones::MakeProgram();
    for (CLI::App* command : made->get_subcommands([](const CLI::App*) { return true; }))
    {
      // Its options were read by then, and it is not run.
      command->parse_complete_callback([] { throw CLI::Success(); });
    }
    return made;
  }();
  return *program;
}

void CommandLine(const std::uint8_t* bytes, std::size_t count)
{
  std::vector<std::string> words(1);
  for (std::size_t k = 0; k < count; ++k)
  {
    const char c = static_cast<char>(bytes[k]);
    if (c == ' ' || c == '\n')
    {
      words.emplace_back();
    }
    else if (c != '\0')
    {
      words.back() += c;
    }
  }
  for (const std::string& word : words)
  {
    try
    {
      for (const double value : shadowcones::ReadNumbers(word, 3, "--at"))
      {
        Check(std::isfinite(value), "coordinates are finite: " + word);
      }
    }
    catch (const shadowcones::Failure&)
    {
    }
  }
  std::reverse(words.begin(), words.end());
  try
  {
    Program().parse(std::move(words));
  }
  catch (const CLI::Error&)
  {
  }
  catch (const shadowcones::Failure&)
  {
  }
}

const Entry entry("options", CommandLine);

} // namespace
} // namespace fuzz
