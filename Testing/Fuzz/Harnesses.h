// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Harnesses.h
 * @brief What any bytes are given to: a function for each entry by which data of strangers come in.
 */
#ifndef Harnesses_h
#define Harnesses_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fuzz
{

/// Ends the process where something that was promised does not hold.
using Function = void (*)(const std::uint8_t* bytes, std::size_t count);

struct Harness
{
  const char* Name;
  Function Run;
};

/// All that are linked.
inline std::vector<Harness>& Harnesses()
{
  static std::vector<Harness> all;
  return all;
}

/// Is every input to go all the way? Else what takes long is left out of most of them.
inline bool& GoesAllTheWay()
{
  static bool all = false;
  return all;
}

/// One more of them: a constant of the file that defines it.
struct Entry
{
  Entry(const char* name, Function run) { Harnesses().push_back({ name, run }); }
};

} // namespace fuzz

#endif
