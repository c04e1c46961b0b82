// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkScene.h"
#include "PlainMarch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

using namespace shadowcones;

namespace
{
struct MarchedChair
{
  BenchmarkScene Scene{ "chair" };
  ScatteringOptions Options = Scene.Options(ScatteringMode::BruteForce, 24);
  ScatteringImage Image;

  MarchedChair()
  {
    this->Scene.BuildRoom();
    this->Scene.Render(this->Options, nullptr, nullptr, this->Image);
  }
  double At(int pixel) const
  {
    double sum = 0.0;
    for (int k = 0; k < this->Image.NumberOfWavelengths; ++k)
    {
      sum += this->Image.InScattering[static_cast<std::size_t>(pixel * this->Image.NumberOfWavelengths + k)];
    }
    return sum / this->Image.NumberOfWavelengths;
  }
};
} // namespace

TEST(PlainMarch, WithEmbreeIsBruteForce)
{
  const MarchedChair chair;
  const PlainImage plain = MarchWithEmbree(chair.Scene.View(), chair.Options, 1);
  EXPECT_EQ(plain.NumberOfOcclusionRays, chair.Image.NumberOfOcclusionRays);
  ASSERT_EQ(plain.Pixels.size(), 24u * 24u);
  int lit = 0;
  for (std::size_t k = 0; k < plain.Pixels.size(); ++k)
  {
    const double value = chair.At(plain.Pixels[k]);
    EXPECT_NEAR(plain.Values[k], value, 2e-6 * value) << plain.Pixels[k];
    EXPECT_EQ(plain.Samples[k], chair.Image.SampleCount[k]) << plain.Pixels[k];
    lit += value > 0.0;
  }
  EXPECT_GT(lit, 300);
}

TEST(PlainMarch, WithTheLocatorAgreesOnItsPixels)
{
  const MarchedChair chair;
  const LocatorScene locator(chair.Scene.Room.View());
  const PlainImage plain = MarchWithLocator(chair.Scene.View(), locator, chair.Options, 4);
  ASSERT_EQ(plain.Pixels.size(), 36u);
  EXPECT_EQ(plain.Pixels[7], 4 + 24 * 4);
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < plain.Pixels.size(); ++k)
  {
    difference += std::abs(plain.Values[k] - chair.At(plain.Pixels[k]));
    sum += chair.At(plain.Pixels[k]);
  }
  // Rays that graze an edge may go either way.
  EXPECT_LT(difference, 1e-3 * sum);
}
