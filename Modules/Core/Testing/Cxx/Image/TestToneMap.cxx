// SPDX-License-Identifier: BSD-3-Clause
#include "scToneMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace shadowcones;

namespace
{
/// How often each pixel is taken.
std::vector<int> Taken(int width, int height)
{
  std::vector<int> taken(static_cast<std::size_t>(width) * height, 0);
  for (const auto& square : ExposureSquares(width, height))
  {
    for (int j = square[2]; j <= square[3]; ++j)
    {
      for (int i = square[0]; i <= square[1]; ++i)
      {
        ++taken.at(static_cast<std::size_t>(j) * width + i);
      }
    }
  }
  return taken;
}
} // namespace

TEST(ToneMap, FilmicIsThePublishedCurve)
{
  // By hand from (x (2.51 x + 0.03)) / (x (2.43 x + 0.59) + 0.14).
  EXPECT_NEAR(ApplyToneCurve(ToneCurve::Filmic, 1.0), 2.54 / 3.16, 1e-12);
  EXPECT_NEAR(ApplyToneCurve(ToneCurve::Filmic, 0.18), 0.086724 / 0.324932, 1e-12);
  EXPECT_NEAR(ApplyToneCurve(ToneCurve::Filmic, 4.0), 40.28 / 41.38, 1e-12);
  double before = 0.0;
  for (double x = 0.01; x < 7.2; x += 0.01)
  {
    const double value = ApplyToneCurve(ToneCurve::Filmic, x);
    EXPECT_GT(value, before);
    EXPECT_LT(value, 1.0) << "a lamp of " << x << " times white keeps its shape";
    before = value;
  }
  for (const ToneCurve curve : { ToneCurve::Linear, ToneCurve::Filmic })
  {
    EXPECT_EQ(ApplyToneCurve(curve, 7.3), 1.0);
    EXPECT_EQ(ApplyToneCurve(curve, std::numeric_limits<double>::infinity()), 1.0);
    EXPECT_EQ(ApplyToneCurve(curve, -1.0), 0.0);
    EXPECT_EQ(ApplyToneCurve(curve, std::numeric_limits<double>::quiet_NaN()), 0.0);
  }
  EXPECT_EQ(ApplyToneCurve(ToneCurve::Linear, 0.3), 0.3);
}

TEST(ToneMap, LuminanceOfEqualEnergyIsOne)
{
  for (const int count : { 1, 3, 7, 40 })
  {
    const auto weights = LuminanceWeights(DefaultWavelengths(count));
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12) << count;
  }
  // Luminance is the Y of the colour-matching functions, whatever the primaries: green is seen best.
  const auto weights = LuminanceWeights({ 450.0, 550.0, 650.0 });
  const double sum = CieXyz(450.0)[1] + CieXyz(550.0)[1] + CieXyz(650.0)[1];
  EXPECT_NEAR(weights[1], CieXyz(550.0)[1] / sum, 2e-3);
}

TEST(ToneMap, SmallImagesAreTakenWhole)
{
  for (const auto& size : { std::array<int, 2>{ 1, 1 }, { 20, 7 }, { 33, 64 }, { 64, 64 }, { 128, 16 } })
  {
    const auto taken = Taken(size[0], size[1]);
    EXPECT_TRUE(std::all_of(taken.begin(), taken.end(), [](int n) { return n == 1; })) << size[0] << " x " << size[1];
  }
  EXPECT_TRUE(ExposureSquares(0, 10).empty());
}

TEST(ToneMap, LargeImagesAreTakenInTheMiddleOfTheirTiles)
{
  const auto squares = ExposureSquares(256, 256);
  ASSERT_EQ(squares.size(), 64u);
  EXPECT_EQ(squares[9], (std::array<int, 4>{ 44, 51, 44, 51 })); // 32 + 12, eight pixels
  for (const auto& size : { std::array<int, 2>{ 257, 2 }, { 1920, 1080 }, { 1, 5000 }, { 700, 2000 } })
  {
    const auto taken = Taken(size[0], size[1]);
    EXPECT_LE(*std::max_element(taken.begin(), taken.end()), 1);
    const auto pixels = std::accumulate(taken.begin(), taken.end(), 0);
    EXPECT_LE(pixels, 4096);
    EXPECT_GE(pixels, 200) << size[0] << " x " << size[1];
  }
}

TEST(ToneMap, WhiteIsTheNinetyNinthPercentile)
{
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937(5));
  EXPECT_EQ(ExposureOf(values), 1.0 / 99.0);
  values.push_back(std::numeric_limits<double>::quiet_NaN());
  values.push_back(HUGE_VAL);
  EXPECT_EQ(ExposureOf(values), 1.0 / 99.0);
}

TEST(ToneMap, DarkImagesHaveAnExposureToo)
{
  std::vector<double> values(1000, 0.0);
  EXPECT_EQ(ExposureOf(values), 1.0);
  EXPECT_EQ(ExposureOf({}), 1.0);
  EXPECT_EQ(ExposureOf({ -1.0, -2.0 }), 1.0);
  values[500] = 0.25; // one in a thousand: the percentile is 0
  EXPECT_EQ(ExposureOf(values), 4.0);
}

TEST(ToneMap, LuminancesOfASquare)
{
  // Three columns, two rows, two wavelengths; the extent begins at pixel (4, 7).
  const std::vector<float> first{ 0, 0, 1, 2, 3, 4, 0, 0, 5, 6, 7, 8 };
  const std::vector<float> second{ 9, 9, 1, 1, 1, 1, 9, 9, 1, 1, 1, 1 };
  std::vector<double> luminances;
  AppendLuminances({ 4, 6, 7, 8 }, { 5, 6, 7, 8 }, { first.data(), second.data() }, { 0.25, 0.75 }, luminances);
  EXPECT_EQ(luminances, (std::vector<double>{ 2.75, 4.75, 6.75, 8.75 }));
  luminances.clear();
  AppendLuminances({ 4, 6, 7, 8 }, { 5, 5, 8, 8 }, { first.data() }, { 0.25, 0.75 }, luminances);
  EXPECT_EQ(luminances, (std::vector<double>{ 5.75 }));
}

TEST(ToneMap, BytesAreThoseOfSrgb)
{
  // By the curve of IEC 61966-2-1: 0.5 is 187.5 of 255, 0.18 is 117.6, 0.002 is 6.6.
  const std::vector<float> radiance{ 0.25f, 0.25f, 0.09f, 0.09f, 0.001f, 0.001f, 0.5f, 0.5f, 7.0f, 7.0f, -1.0f, -1.0f };
  std::vector<unsigned char> rgb(18);
  EXPECT_TRUE(ToneMap(radiance.data(), 6, { { 450.0, 600.0 }, 2.0, ToneCurve::Linear }, {}, rgb.data()));
  const unsigned char expected[6] = { 188, 118, 7, 255, 255, 0 };
  for (int i = 0; i < 18; ++i)
  {
    EXPECT_EQ(rgb[static_cast<std::size_t>(i)], expected[i / 3]) << i;
  }
}
