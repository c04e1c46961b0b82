// SPDX-License-Identifier: BSD-3-Clause
// Random numbers: streams that do not depend on order, Sobol points that are stratified, scrambling by seed.
#include "scRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

using namespace shadowcones;

namespace
{

// Is each of the first 2^k points alone in its interval of every division into 2^a x 2^(k-a) boxes?
bool IsStratified(std::uint64_t seed, int k, int first, int second)
{
  const std::uint32_t count = 1u << k;
  for (int a = 0; a <= k; ++a)
  {
    std::set<std::pair<int, int>> boxes;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const auto point = SobolPoint(seed, i);
      boxes.emplace(static_cast<int>(std::ldexp(point[first], a)), static_cast<int>(std::ldexp(point[second], k - a)));
    }
    if (boxes.size() != count)
    {
      return false;
    }
  }
  return true;
}

} // namespace

TEST(Random, SobolPointsFillEveryElementaryIntervalOnce)
{
  for (const std::uint64_t seed : { 0ull, 1ull, 0xFFFFFFFFFFFFFFFFull })
  {
    for (int k = 1; k <= 8; ++k)
    {
      EXPECT_TRUE(IsStratified(seed, k, 0, 1)) << "seed " << seed << ", 2^" << k << " points";
    }
  }
}

TEST(Random, EverySobolCoordinateIsStratifiedAlone)
{
  for (int d = 0; d < 4; ++d)
  {
    std::set<int> cells;
    for (std::uint32_t i = 0; i < 1024; ++i)
    {
      const double x = SobolPoint(5, i)[d];
      ASSERT_GE(x, 0.0);
      ASSERT_LT(x, 1.0);
      cells.insert(static_cast<int>(x * 1024.0));
    }
    EXPECT_EQ(cells.size(), 1024u) << "coordinate " << d;
  }
}

TEST(Random, LaterPairsOfCoordinatesIntegrateSmoothFunctions)
{
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 4096; ++i)
  {
    const auto p = SobolPoint(9, i);
    sum += p[0] * p[1] * p[2] * p[3];
  }
  EXPECT_NEAR(sum / 4096.0, 1.0 / 16.0, 1e-4);
}

TEST(Random, ScramblingDependsOnTheSeed)
{
  int same = 0;
  for (std::uint32_t i = 0; i < 256; ++i)
  {
    const auto a = SobolPoint(1, i);
    const auto b = SobolPoint(2, i);
    for (int d = 0; d < 4; ++d)
    {
      same += a[d] == b[d] ? 1 : 0;
    }
  }
  EXPECT_EQ(same, 0);
}

TEST(Random, OwenScramblingIsABijectionOfTheUpperBits)
{
  // A prefix decides the scrambled prefix: points that share 8 bits still share them.
  for (std::uint32_t prefix = 0; prefix < 256; ++prefix)
  {
    const std::uint32_t a = OwenScramble(prefix << 24, 77u) >> 24;
    const std::uint32_t b = OwenScramble((prefix << 24) | 0x00FFFFFFu, 77u) >> 24;
    EXPECT_EQ(a, b);
  }
}

TEST(Random, StreamsDoNotDependOnTheOrderOfItems)
{
  std::vector<double> forward;
  for (std::uint64_t item = 0; item < 100; ++item)
  {
    RandomStream stream(3, item);
    stream.Next();
    forward.push_back(stream.Next());
  }
  for (std::uint64_t item = 100; item-- > 0;)
  {
    RandomStream stream(3, item);
    stream.Next();
    EXPECT_EQ(stream.Next(), forward[item]);
  }
}

TEST(Random, NeighbouringSeedsAndItemsAreUnrelated)
{
  std::set<std::uint64_t> words;
  double sum = 0.0;
  double products = 0.0;
  constexpr int n = 200;
  for (std::uint64_t seed = 0; seed < n; ++seed)
  {
    for (std::uint64_t item = 0; item < n; ++item)
    {
      RandomStream stream(seed, item);
      words.insert(HashSeed(seed, item));
      const double x = stream.Next();
      ASSERT_GE(x, 0.0);
      ASSERT_LT(x, 1.0);
      sum += x;
      products += (x - 0.5) * (RandomStream(seed, item + 1).Next() - 0.5);
    }
  }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(n * n));
  // Five standard errors of a mean of 40,000 uniform numbers, and of their products.
  EXPECT_NEAR(sum / (n * n), 0.5, 5.0 * std::sqrt(1.0 / 12.0) / n);
  EXPECT_NEAR(products / (n * n), 0.0, 5.0 / 12.0 / n);
}
