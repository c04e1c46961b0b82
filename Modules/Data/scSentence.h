// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSentence.h
 * @brief Messages put together from words and numbers. Internal to the modules.
 */
#ifndef scSentence_h
#define scSentence_h

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
