// SPDX-License-Identifier: BSD-3-Clause
#include "scLargePages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace shadowcones
{
namespace
{
constexpr std::size_t largePage = std::size_t(1) << 21;
/// What is smaller than half of one is not worth one.
constexpr std::size_t leastBytes = largePage / 2;
/// Of the allocator, before the memory.
constexpr std::size_t head = 4096;
} // anonymous namespace

void PreferLargePages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (memory && bytes >= leastBytes)
  {
    // The call wants whole small pages. It is advice alone: what else lies on the outer ones stays as it is.
    const auto smallPage = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory) / smallPage * smallPage;
    const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes + smallPage - 1) / smallPage * smallPage;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the number of a page
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

std::size_t FilledLargePages(std::size_t bytes)
{
  return bytes < leastBytes ? bytes : (bytes + head + largePage - 1) / largePage * largePage - head;
}

} // namespace shadowcones
