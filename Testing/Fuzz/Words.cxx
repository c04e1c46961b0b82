// SPDX-License-Identifier: BSD-3-Clause
// Texts of strangers: lamps in words.
#include "Bytes.h"
#include "Harnesses.h"

#include "scLightGrammar.h"
#include "scLightText.h"

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
    const std::string words = TextOf(lamp);
    std::vector<shadowcones::Lamp> again;
    Check(shadowcones::ParseLamps(words, {}, again, fault) && again.size() == 1, "what is written is read again: " + words);
    Check(TextOf(again[0]) == words, "and is the same: " + words);
  }
}

const Entry entry("words", LightWords);

} // namespace
} // namespace fuzz
