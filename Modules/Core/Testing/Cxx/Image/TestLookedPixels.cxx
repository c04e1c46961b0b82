// SPDX-License-Identifier: BSD-3-Clause
// Which pixels are looked at, and what these tell of the others: shadows of known shape with known noise.
#include "scLookedPixels.h"
#include "scRandom.h"
#include "scSmoothShadow.h"
#include "scTileRange.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

using namespace shadowcones;

namespace
{
constexpr int Size = 128;
constexpr double Goal = 0.01;
using Shape = std::function<double(double i, double j)>; ///< hidden share at a pixel

double Normal(RandomStream& random)
{
  return std::sqrt(-2.0 * std::log(1.0 - random.Next())) * std::cos(6.283185307179586 * random.Next());
}

/// Pixels of light 1 that a level looks at, with this noise of a look.
LookedPixels Look(int level, const Shape& hidden, double noise)
{
  LookedPixels looked({ 0, Size - 1, 0, Size - 1 }, level + 1, 1);
  RandomStream random(7, static_cast<std::uint64_t>(level));
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      LookedPixel& pixel = looked.At(i, j);
      pixel = LookedPixel();
      pixel.Kind = 0;
      pixel.Inside = 1.0f;
      pixel.Whole = 1.0f;
      *looked.LightOf(i, j) = 1.0f;
      *looked.HiddenOf(i, j) = 1.0f;
      if (lookLevels[level].Has(i, j))
      {
        pixel.Samples = lookLevels[level].Fewest;
        pixel.Visible = -1;
        pixel.Shown = static_cast<float>(1.0 - hidden(i, j) + noise * Normal(random));
        *looked.HiddenOf(i, j) = 1.0f - pixel.Shown;
      }
    }
  }
  return looked;
}

struct Told
{
  int Known = 0;
  int WithinTwo = 0;
  double Squares = 0.0; ///< of errors over claims
};
Told Ask(int level, const Shape& hidden, double noise)
{
  const LookedPixels looked = Look(level, hidden, noise);
  SmoothShadow smooth(looked, level, nullptr, { Goal, 0.01 });
  Told told;
  for (const TileRange& block : TilesOf({ 0, Size - 1, 0, Size - 1 }, lookLevels[level].Side))
  {
    smooth.MoveTo(block.I0, block.J0);
    for (int pixel = 0; pixel < lookLevels[level].Side * lookLevels[level].Side; ++pixel)
    {
      const int i = block.I0 + pixel % lookLevels[level].Side;
      const int j = block.J0 + pixel / lookLevels[level].Side;
      if (const SmoothShadow::Answer* answer = smooth.Of(i, j))
      {
        const double ratio = (answer->Left[0] - (1.0 - hidden(i, j))) / std::sqrt(answer->Variance);
        told.Known += 1;
        told.WithinTwo += std::fabs(ratio) < 2.0 ? 1 : 0;
        told.Squares += ratio * ratio;
      }
    }
  }
  return told;
}

class LookedLevels : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(LookedLevels, EachLineHasAsManyPixels)
{
  const LookLevel& level = lookLevels[GetParam()];
  for (int from = 0; from < level.Period; ++from)
  {
    std::array<int, 4> counts{};
    for (int k = 0; k < level.Period; ++k)
    {
      counts[0] += level.Has(k, from) ? 1 : 0;
      counts[1] += level.Has(from, k) ? 1 : 0;
      counts[2] += level.Has(from + k, k) ? 1 : 0;
      counts[3] += level.Has(from + level.Period - k, k) ? 1 : 0;
      if (level.Has(from, k) && from >= 4 && k >= 4)
      {
        EXPECT_TRUE(level.Has(from + level.Along[0], k + level.Along[1]));
        EXPECT_TRUE(level.Has(from + level.Across[0], k + level.Across[1]));
        EXPECT_TRUE(GetParam() == 0 || lookLevels[GetParam() - 1].Has(from, k));
      }
    }
    for (const int count : counts)
    {
      EXPECT_EQ(count, 1);
    }
  }
}

TEST_P(LookedLevels, SmoothShadowsAreToldWithinTheirClaims)
{
  // A cubic in windows, and somewhat more.
  const auto hidden = [](double i, double j) { return 0.4 + 0.2 * std::sin(0.02 * i + 0.01 * j) + 0.1 * std::cos(0.025 * j); };
  const Told told = Ask(GetParam(), hidden, 2.0 * Goal * 0.5);
  EXPECT_GT(told.Known, Size * Size * 7 / 10);
  EXPECT_GE(told.WithinTwo, told.Known * 97 / 100);
  EXPECT_LE(std::sqrt(told.Squares / told.Known), 1.0);
  EXPECT_GE(std::sqrt(told.Squares / told.Known), 0.2) << "claims much too large are of no use";
}

TEST_P(LookedLevels, AnEdgeIsNotToldAcross)
{
  const auto hidden = [](double i, double j) { return i + 0.5 * j < 0.75 * Size + 0.3 ? 0.2 : 0.6; };
  const Told told = Ask(GetParam(), hidden, 2.0 * Goal * 0.5);
  EXPECT_GT(told.Known, Size * Size / 10) << "away from it";
  EXPECT_LT(told.Known, Size * Size * 95 / 100);
  EXPECT_GE(told.WithinTwo, told.Known * 97 / 100);
}

TEST_P(LookedLevels, ThinLinesAreSeen)
{
  // One pixel wide, over all of the image: of no block that it crosses is any pixel told where it is.
  const auto hidden = [](double i, double j) { return 0.3 + (std::fabs(i - j) < 0.5 ? 0.5 : 0.0); };
  const LookedPixels looked = Look(GetParam(), hidden, 0.5 * Goal);
  SmoothShadow smooth(looked, GetParam(), nullptr, { Goal, 0.01 });
  for (int i = 0; i < Size; ++i)
  {
    smooth.MoveTo(i, i);
    EXPECT_FALSE(smooth.Of(i, i)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, LookedLevels, testing::Values(0, 1, 2));

TEST(LookedPixels, PartsAskWholeBlocksAroundThem)
{
  const std::array<int, 4> part{ 300, 310, 5, 40 };
  for (int level = 0; level < 3; ++level)
  {
    const int side = lookLevels[level].Side;
    const std::array<int, 4> asked = LookedPixels::ExtentFor(level, part, 1000, 900);
    EXPECT_EQ(asked[0] % side, 0);
    EXPECT_EQ((asked[1] + 1) % side, 0);
    EXPECT_LE(asked[0], part[0] - lookLevels[level].Margins[1]);
    EXPECT_GE(asked[1], part[1] + lookLevels[level].Margins[1]);
    EXPECT_EQ(asked[2], 0);
  }
  EXPECT_EQ(LookedPixels::ExtentFor(2, { 990, 999, 890, 899 }, 1000, 900)[1], 999);
  const int most = 2147483647;
  EXPECT_EQ(LookedPixels::ExtentFor(2, { most - 2, most - 1, 0, 0 }, most, most)[1], most - 1);
}
