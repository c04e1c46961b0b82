// SPDX-License-Identifier: BSD-3-Clause
#include "scParameterRanges.h"

#include "scSentence.h"

#include <algorithm>
#include <cstdint>

namespace shadowcones
{

ParameterRange InRange(const char* name, int value, int least, int most)
{
  return { name, static_cast<double>(value), value >= least && value <= most, Sentence("in ", least, "..", most) };
}

ParameterRange OneOf(const char* name, int value, std::initializer_list<const char*> names)
{
  const auto count = static_cast<int>(names.size());
  std::string range;
  int k = 0;
  for (const char* one : names)
  {
    range += Sentence(k == 0 ? "" : k + 1 == count ? " or " : ", ", one, " (", k, ")");
    ++k;
  }
  return { name, static_cast<double>(value), value >= 0 && value < count, range };
}

std::string FirstOutOfRange(std::initializer_list<ParameterRange> parameters)
{
  const auto* fault =
    std::find_if(parameters.begin(), parameters.end(), [](const ParameterRange& one) { return !one.Valid; });
  if (fault == parameters.end())
  {
    return {};
  }
  std::ostringstream text;
  text.precision(10);
  text << fault->Name << " is " << fault->Value << ": it must be " << fault->Range << ".";
  return text.str();
}

std::string CheckDimensions(const char* name, const int n[3])
{
  constexpr double mostPoints = 2147483647.0;
  const bool valid = std::min({ n[0], n[1], n[2] }) >= 2 && static_cast<double>(n[0]) * n[1] * n[2] <= mostPoints;
  return valid ? std::string()
               : Sentence(name, " are ", n[0], ", ", n[1], ", ", n[2],
                   ": each must be at least 2, and all together at most 2^31 - 1 points.");
}

} // namespace shadowcones
