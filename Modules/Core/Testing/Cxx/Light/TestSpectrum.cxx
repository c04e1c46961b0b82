// SPDX-License-Identifier: BSD-3-Clause
#include "scSpectrum.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;

TEST(Spectrum, DefaultWavelengthsAreCentresOfEqualBins)
{
  const auto wavelengths = DefaultWavelengths();
  ASSERT_EQ(wavelengths.size(), 7u);
  EXPECT_NEAR(wavelengths.front(), 400.0 + 150.0 / 7.0, 1e-9);
  EXPECT_NEAR(wavelengths[3], 550.0, 1e-9);
  EXPECT_NEAR(wavelengths.back(), 700.0 - 150.0 / 7.0, 1e-9);
  EXPECT_TRUE(DefaultWavelengths(0).empty());
}

TEST(Spectrum, LuminosityPeaksNear555)
{
  double best = 0.0;
  double at = 0.0;
  for (double wavelength = 380.0; wavelength <= 780.0; wavelength += 1.0)
  {
    const double y = CieXyz(wavelength)[1];
    if (y > best)
    {
      best = y;
      at = wavelength;
    }
  }
  EXPECT_NEAR(best, 1.0, 0.02);
  EXPECT_NEAR(at, 555.0, 5.0);
}

TEST(Spectrum, MatchingFunctionsAreNearTheTables)
{
  // CIE 1931 tables: 450, 550 and 600 nm.
  const double table[3][4] = { { 450.0, 0.3362, 0.0380, 1.7721 }, { 550.0, 0.4334, 0.9950, 0.0087 },
    { 600.0, 1.0622, 0.6310, 0.0008 } };
  for (const auto& row : table)
  {
    const auto xyz = CieXyz(row[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(xyz[axis], row[axis + 1], 0.03) << row[0] << " nm, axis " << axis;
    }
  }
}

TEST(Spectrum, TheThreeMatchingFunctionsHoldTheSameArea)
{
  double area[3] = {};
  for (double wavelength = 350.0; wavelength <= 850.0; wavelength += 0.5)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      area[axis] += 0.5 * CieXyz(wavelength)[axis];
    }
  }
  EXPECT_NEAR(area[0] / area[1], 1.0, 0.01);
  EXPECT_NEAR(area[2] / area[1], 1.0, 0.01);
}

TEST(Spectrum, EqualEnergyIsWhiteForAnyNumberOfSamples)
{
  for (const int count : { 1, 2, 3, 7, 31 })
  {
    const auto matrix = SpectrumToLinearSrgb(DefaultWavelengths(count));
    for (const auto& row : matrix)
    {
      ASSERT_EQ(row.size(), static_cast<std::size_t>(count));
      double sum = 0.0;
      for (const double value : row)
      {
        sum += value;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12) << count << " samples";
    }
  }
}

TEST(Spectrum, WavesThatNobodySeesHaveNoColour)
{
  // exp(-t^2 / 2) passes through the smallest numbers that there are on its way to 0.
  for (double wavelength = 1.0; wavelength < 3000.0; wavelength += 0.25)
  {
    double sum = 0.0;
    for (const auto& row : SpectrumToLinearSrgb({ wavelength }))
    {
      ASSERT_TRUE(std::isfinite(row.front())) << wavelength << " nm";
      sum += std::fabs(row.front());
    }
    EXPECT_TRUE(wavelength < 2500.0 || sum == 0.0) << wavelength << " nm";
  }
}

TEST(Spectrum, ShortWavesAreBlueAndLongOnesRed)
{
  const auto matrix = SpectrumToLinearSrgb(DefaultWavelengths());
  EXPECT_GT(matrix[2][1], matrix[0][1]);
  EXPECT_GT(matrix[2][1], matrix[1][1]);
  EXPECT_GT(matrix[0][5], matrix[1][5]);
  EXPECT_GT(matrix[0][5], matrix[2][5]);
}

TEST(Spectrum, SrgbCurve)
{
  EXPECT_EQ(EncodeSrgb(0.0), 0);
  EXPECT_EQ(EncodeSrgb(-1.0), 0);
  EXPECT_EQ(EncodeSrgb(std::nan("")), 0);
  EXPECT_EQ(EncodeSrgb(1.0), 255);
  EXPECT_EQ(EncodeSrgb(HUGE_VAL), 255);
  EXPECT_EQ(EncodeSrgb(0.5), 188);
  EXPECT_EQ(EncodeSrgb(0.18), 118);
  EXPECT_EQ(EncodeSrgb(0.002), 7);
}
