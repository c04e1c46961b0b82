// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSentence.h
 * @brief Messages put together from words and numbers. Internal to the modules.
 */
#ifndef scSentence_h
#define scSentence_h

#include <charconv>
#include <sstream>
#include <string>

namespace shadowcones
{

template <typename... Parts>
std::string Sentence(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// The shortest text that reads back as the same number: 1234567, 0.5, 1e+15, nan.
inline std::string ShortestText(double value)
{
  char text[32];
  return { text, std::to_chars(text, text + sizeof(text), value).ptr };
}

/// So many values, separated by commas.
template <typename Value>
std::string Listed(const Value* values, int count)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? ", " : "") << values[i];
  }
  return text.str();
}

} // namespace shadowcones

#endif
