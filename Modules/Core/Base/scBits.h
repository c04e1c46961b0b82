// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBits.h
 * @brief Words of 64 bits: how many are set, which is the first, and the bits of a number. Internal to Core.
 */
#ifndef scBits_h
#define scBits_h

#include <bitset>
#include <cstdint>
#include <cstring>

namespace shadowcones
{

inline int CountBits(std::uint64_t word)
{
  return static_cast<int>(std::bitset<64>(word).count());
}

/// The lowest bit that is set; at least one must be.
inline int LowestBit(std::uint64_t word)
{
  int bit = 0;
  while (!(word & 0xFF))
  {
    word >>= 8;
    bit += 8;
  }
  while (!(word & 1))
  {
    word >>= 1;
    ++bit;
  }
  return bit;
}

/// The bits of a number; those of 0 where it is -0.
inline std::uint64_t BitsOf(double value)
{
  value += 0.0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

} // namespace shadowcones

#endif
