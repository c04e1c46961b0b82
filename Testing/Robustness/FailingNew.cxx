// SPDX-License-Identifier: BSD-3-Clause
#include "FailingNew.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include <execinfo.h>
#include <link.h>

namespace
{

struct Range
{
  std::uintptr_t Begin = 0;
  std::uintptr_t End = 0;
};

// Found before counting: a list of its own memory, since this is what gives memory.
std::array<Range, 32> ranges;
std::size_t numberOfRanges = 0;
std::atomic<bool> counting{ false };
std::atomic<long> calls{ 0 };
std::atomic<long> failingCall{ 0 };

int AddRanges(dl_phdr_info* info, std::size_t, void*)
{
  if (!info->dlpi_name || !std::strstr(info->dlpi_name, "libShadowCones"))
  {
    return 0;
  }
  for (int k = 0; k < info->dlpi_phnum && numberOfRanges < ranges.size(); ++k)
  {
    const auto& part = info->dlpi_phdr[k];
    if (part.p_type == PT_LOAD && (part.p_flags & PF_X))
    {
      const std::uintptr_t begin = info->dlpi_addr + part.p_vaddr;
      ranges[numberOfRanges++] = { begin, begin + part.p_memsz };
    }
  }
  return 0;
}

bool IsInRanges(const void* caller)
{
  const auto at = reinterpret_cast<std::uintptr_t>(caller);
  for (std::size_t k = 0; k < numberOfRanges; ++k)
  {
    if (at >= ranges[k].Begin && at < ranges[k].End)
    {
      return true;
    }
  }
  return false;
}

/// Templates of the standard library are shared by all libraries: a vector of VTK's may grow by a function in ours.
bool IsOurs(const void* caller)
{
  if (!IsInRanges(caller))
  {
    return false;
  }
  std::array<void*, 8> frames;
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  void* const* end = frames.data() + count;
  void* const* own = std::find_if(static_cast<void* const*>(frames.data()), end, [caller](void* at) { return at == caller; });
  return own != end && own + 1 != end && IsInRanges(own[1]);
}

void* Allocate(std::size_t size, const void* caller)
{
  if (counting && IsOurs(caller) && ++calls == failingCall)
  {
    throw std::bad_alloc();
  }
  void* memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

/// For those that ask for it so: std::stable_sort does with less.
void* AllocateOrNull(std::size_t size, const void* caller) noexcept
{
  try
  {
    return Allocate(size, caller);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

} // namespace

void* operator new(std::size_t size)
{
  return Allocate(size, __builtin_return_address(0));
}
void* operator new[](std::size_t size)
{
  return Allocate(size, __builtin_return_address(0));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return AllocateOrNull(size, __builtin_return_address(0));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return AllocateOrNull(size, __builtin_return_address(0));
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace robustness
{

void CountAllocations(long failing)
{
  if (numberOfRanges == 0)
  {
    dl_iterate_phdr(AddRanges, nullptr);
    std::array<void*, 2> frames;
    backtrace(frames.data(), 2); // it takes memory the first time
  }
  calls = 0;
  failingCall = failing;
  counting = true;
}

long NumberOfAllocations()
{
  counting = false;
  return calls;
}

} // namespace robustness
