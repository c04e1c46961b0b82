// SPDX-License-Identifier: BSD-3-Clause
// Texts of strangers: lamps in words, and command lines.
#include "Bytes.h"
#include "Harnesses.h"

#include "scCommandLine.h"
#include "scFailure.h"
#include "scLightGrammar.h"
#include "scLightText.h"
#include "scPlaces.h"

#include <CLI/CLI.hpp>

namespace fuzz
{
namespace
{

bool IsFinite(const shadowcones::Lamp& lamp)
{
  const auto finite = [](const shadowcones::Vector3& v)
  { return std::isfinite(v.X) && std::isfinite(v.Y) && std::isfinite(v.Z); };
  return finite(lamp.Center) && finite(lamp.Normal) && finite(lamp.Up) && std::isfinite(lamp.Radius) &&
    std::isfinite(lamp.Width) && std::isfinite(lamp.Height) && std::isfinite(lamp.AngularDiameter) &&
    std::isfinite(lamp.Total) &&
    std::all_of(lamp.Spectrum.begin(), lamp.Spectrum.end(), [](double value) { return std::isfinite(value); });
}

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

} // namespace

void LightWords(const std::uint8_t* bytes, std::size_t count)
{
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  std::vector<shadowcones::Lamp> lamps;
  shadowcones::LightFault fault;
  if (!shadowcones::ParseLamps(text, {}, lamps, fault))
  {
    Check(!fault.Sentence.empty() && fault.Line >= 1 && fault.Column >= 1, "a fault has a sentence and a place");
    return;
  }
  for (const shadowcones::Lamp& lamp : lamps)
  {
    Check(IsFinite(lamp), "every number of a lamp is finite");
    if (lamp.Shape == shadowcones::LightShape::Mesh || lamp.Unit != shadowcones::LightUnit::None)
    {
      continue; // files and totals are not written again
    }
    const std::string words = TextOf(lamp);
    std::vector<shadowcones::Lamp> again;
    Check(shadowcones::ParseLamps(words, {}, again, fault) && again.size() == 1, "what is written is read again: " + words);
    Check(TextOf(again[0]) == words, "and is the same: " + words);
  }
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

} // namespace fuzz
