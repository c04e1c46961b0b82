// SPDX-License-Identifier: BSD-3-Clause
#include "scHandOver.h"

#include <mutex>
#include <unordered_map>

namespace shadowcones
{
namespace
{
struct Kept
{
  std::mutex Mutex;
  std::unordered_map<void*, std::shared_ptr<void>> Values;
};

/// Never destroyed: arrays may be freed when the program ends.
Kept& AllKept()
{
  static auto* const kept = new Kept;
  return *kept;
}
} // anonymous namespace

void KeepUntilFreed(void* place, std::shared_ptr<void> values)
{
  Kept& kept = AllKept();
  const std::lock_guard<std::mutex> lock(kept.Mutex);
  kept.Values[place] = std::move(values);
}

void FreeKept(void* place)
{
  Kept& kept = AllKept();
  std::shared_ptr<void> values; // freed when nobody waits
  const std::lock_guard<std::mutex> lock(kept.Mutex);
  const auto found = kept.Values.find(place);
  if (found != kept.Values.end())
  {
    values = std::move(found->second);
    kept.Values.erase(found);
  }
}

} // namespace shadowcones
