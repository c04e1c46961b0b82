// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSentence.h
 * @brief Messages put together from words and numbers. Internal to the modules.
 */
#ifndef scSentence_h
#define scSentence_h

#include <exception>
#include <new>
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

inline constexpr const char* notEnoughMemory = "there is not enough memory; ask for less, or of less";

/// Why something failed, for the end of a sentence: an exception that says so itself, or memory that ended, which does not.
inline std::string ReasonOf(const std::exception& exception)
{
  return dynamic_cast<const std::bad_alloc*>(&exception) ? notEnoughMemory : exception.what();
}

} // namespace shadowcones

#endif
