// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFingerprint.h
 * @brief A word that tells data apart: equal bytes in equal order have equal words, others differ but for one in 2^64.
 */
#ifndef scFingerprint_h
#define scFingerprint_h

#include "scRandom.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace shadowcones
{

class Fingerprint
{
public:
  void AddWord(std::uint64_t word) { this->State = Mix64(this->State * 3 + word + 0x9E3779B97F4A7C15ull); }

  /// Their number is part of it: two parts differ from the same bytes in one.
  void AddBytes(const void* bytes, std::size_t size)
  {
    const auto* at = static_cast<const unsigned char*>(bytes);
    this->AddWord(size);
    for (; size > 0;)
    {
      std::uint64_t word = 0;
      const std::size_t part = size < sizeof(word) ? size : sizeof(word);
      std::memcpy(&word, at, part);
      this->AddWord(word);
      at += part;
      size -= part;
    }
  }

  /// By its bits, but for zero, which has one sign.
  void AddNumber(double value)
  {
    const double number = value == 0.0 ? 0.0 : value;
    std::uint64_t word = 0;
    std::memcpy(&word, &number, sizeof(word));
    this->AddWord(word);
  }

  std::uint64_t Value() const { return this->State; }

private:
  std::uint64_t State = 0;
};

} // namespace shadowcones

#endif
