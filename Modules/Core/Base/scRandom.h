// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRandom.h
 * @brief Random numbers as pure functions of (Seed, item index), so that results do not depend on threads or pieces.
 */
#ifndef scRandom_h
#define scRandom_h

#include <array>
#include <cstdint>

namespace shadowcones
{

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection of 64 bits that passes as random.
constexpr std::uint64_t Mix64(std::uint64_t x)
{
  x ^= x >> 30;
  x *= 0xBF58476D1CE4E5B9ull;
  x ^= x >> 27;
  x *= 0x94D049BB133111EBull;
  x ^= x >> 31;
  return x;
}

/// One well-mixed word for (seed, item).
constexpr std::uint64_t HashSeed(std::uint64_t seed, std::uint64_t item)
{
  return Mix64(Mix64(seed + 0x9E3779B97F4A7C15ull) ^ (item * 0xD1B54A32D192ED03ull + 0x8CB92BA72F3D8DD7ull));
}

/// SplitMix64 started at (seed, item): a small stream of its own for each item.
class RandomStream
{
public:
  constexpr RandomStream(std::uint64_t seed, std::uint64_t item)
    : State(HashSeed(seed, item))
  {
  }
  constexpr std::uint64_t NextWord() { return Mix64(this->State += 0x9E3779B97F4A7C15ull); }
  /// Uniform in [0, 1), 53 bits.
  constexpr double Next() { return static_cast<double>(this->NextWord() >> 11) * 0x1p-53; }

private:
  std::uint64_t State;
};

/// Reverse the order of 32 bits.
constexpr std::uint32_t ReverseBits32(std::uint32_t x)
{
  x = (x >> 16) | (x << 16);
  x = ((x & 0xFF00FF00u) >> 8) | ((x & 0x00FF00FFu) << 8);
  x = ((x & 0xF0F0F0F0u) >> 4) | ((x & 0x0F0F0F0Fu) << 4);
  x = ((x & 0xCCCCCCCCu) >> 2) | ((x & 0x33333333u) << 2);
  x = ((x & 0xAAAAAAAAu) >> 1) | ((x & 0x55555555u) << 1);
  return x;
}

/// Owen scrambling by hashing (Laine and Karras 2011, with the constants of Burley, JCGT 2020).
constexpr std::uint32_t OwenScramble(std::uint32_t x, std::uint32_t seed)
{
  x = ReverseBits32(x);
  x ^= x * 0x3D20ADEAu;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526C56u;
  x ^= x * 0x53A22864u;
  return ReverseBits32(x);
}

/// Direction numbers of the Sobol sequence by Joe and Kuo (2008), dimensions 2 to 4, for 32 bits of the index.
struct SobolDirections
{
  std::uint32_t Values[3][32] = {};

  constexpr SobolDirections()
  {
    // Degree, polynomial, first numbers.
    constexpr int degree[3] = { 1, 2, 3 };
    constexpr std::uint32_t polynomial[3] = { 0, 1, 1 };
    constexpr std::uint32_t first[3][3] = { { 1, 0, 0 }, { 1, 3, 0 }, { 1, 3, 1 } };
    for (int d = 0; d < 3; ++d)
    {
      const int s = degree[d];
      std::uint32_t* v = this->Values[d];
      for (int k = 0; k < 32; ++k)
      {
        if (k < s)
        {
          v[k] = first[d][k] << (31 - k);
          continue;
        }
        v[k] = v[k - s] ^ (v[k - s] >> s);
        for (int j = 1; j < s; ++j)
        {
          v[k] ^= ((polynomial[d] >> (s - 1 - j)) & 1u) * v[k - j];
        }
      }
    }
  }
};

/// The index-th point of the four-dimensional Sobol sequence, Owen-scrambled by @p seed; each coordinate in [0, 1).
inline std::array<double, 4> SobolPoint(std::uint64_t seed, std::uint32_t index)
{
  static constexpr SobolDirections directions;
  std::uint32_t bits[4] = { ReverseBits32(index), 0, 0, 0 };
  for (int k = 0; index != 0; ++k, index >>= 1)
  {
    const std::uint32_t mask = 0u - (index & 1u);
    bits[1] ^= mask & directions.Values[0][k];
    bits[2] ^= mask & directions.Values[1][k];
    bits[3] ^= mask & directions.Values[2][k];
  }
  std::array<double, 4> point{};
  for (int d = 0; d < 4; ++d)
  {
    const auto scramble = static_cast<std::uint32_t>(HashSeed(seed, static_cast<std::uint64_t>(d)));
    point[d] = OwenScramble(bits[d], scramble) * 0x1p-32;
  }
  return point;
}

} // namespace shadowcones

#endif
