// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLargePages.h
 * @brief Memory that is taken at once, in few large pages instead of many small ones.
 */
#ifndef scLargePages_h
#define scLargePages_h

#include "ShadowConesCoreModule.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/**
 * Ask the system to back memory, before anything is written there, by large pages. The first touch of every small page is a call
 * of the system, and thousands of them take longer than what is written then. Does nothing where there is none of that.
 */
SHADOWCONESCORE_EXPORT void PreferLargePages(void* memory, std::size_t bytes);

/// So many bytes, or as many more as fill large pages: the system puts those at the border of one.
SHADOWCONESCORE_EXPORT std::size_t FilledLargePages(std::size_t bytes);

/// Make room for so many values in all, see PreferLargePages().
template <typename T>
void ReserveLarge(std::vector<T>& values, std::size_t count)
{
  if (count > values.capacity())
  {
    std::vector<T> larger;
    larger.reserve(FilledLargePages(count * sizeof(T)) / sizeof(T));
    PreferLargePages(larger.data(), larger.capacity() * sizeof(T));
    larger.insert(larger.end(), values.begin(), values.end());
    values.swap(larger);
  }
}

} // namespace shadowcones

#endif
