// SPDX-License-Identifier: BSD-3-Clause
// What Guided says of its own error, held against pixels of the slow reference.
#include "RoomTestScene.h"
#include "TruthImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// The differences of an image from the truth, over what the image claims.
struct Claims
{
  int Pixels = 0;
  int Held = 0; ///< within two claimed errors
  std::vector<double> Ratios;

  void Add(double difference, double claim)
  {
    this->Pixels += 1;
    this->Held += std::fabs(difference) <= 2.0 * claim;
    this->Ratios.push_back(std::fabs(difference) / claim);
  }
  double Share() const { return static_cast<double>(this->Held) / this->Pixels; }
  double Median()
  {
    std::nth_element(this->Ratios.begin(), this->Ratios.begin() + this->Pixels / 2, this->Ratios.end());
    return this->Ratios[static_cast<std::size_t>(this->Pixels / 2)];
  }
};

class ErrorClaims : public testing::TestWithParam<const char*>
{
};
} // namespace

TEST_P(ErrorClaims, HoldInNineteenOfTwentyPixels)
{
  ImageTestScene scene = RoomTestScene(GetParam());
  const int size = TruthImage::Side;
  scene.SetSize(size, size);
  const TruthImage truths(SHADOWCONES_TRUTH_DIR "/" + std::string(GetParam()) + ".txt");
  ASSERT_EQ(truths.Pixels.size(), static_cast<std::size_t>(size * size / (TruthImage::Step * TruthImage::Step)));
  const OccluderScene nothing{ TriangleMeshView() };
  ScatteringOptions unshadowed = scene.Options;
  unshadowed.Mode = ScatteringMode::Volume;
  ScatteringImage lit;
  ASSERT_TRUE(RenderScattering({ nothing, scene.Source, scene.Fog, scene.Eye }, unshadowed, {}, lit));
  double typical = 0.0;
  for (const float value : lit.InScattering)
  {
    typical += value / static_cast<double>(lit.InScattering.size());
  }

  scene.Options.MaximumSamples = 1024;
  const ConeHierarchy cones(scene.Bounds, scene.Fog.Bounds);
  for (const double goal : { 0.05, 0.02 })
  {
    scene.Options.RelativeErrorGoal = goal;
    scene.Options.Seed = 1;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, &cones, nullptr);
    Claims all;
    Claims reached;
    double sum = 0.0;
    double squares = 0.0;
    double truth = 0.0;
    float largest = 0.0f;
    for (const TruthPixel& pixel : truths.Pixels)
    {
      const auto k = static_cast<std::size_t>(pixel.J * size + pixel.I);
      const double difference = static_cast<double>(image.InScattering[k]) - pixel.Mean;
      // Of the difference the truth has its share.
      const double claim = std::hypot(static_cast<double>(image.RelativeError[k]) * image.InScattering[k], pixel.Error);
      if (image.InScattering[k] == 0.0f)
      {
        EXPECT_TRUE(pixel.Mean == 0.0 || image.RelativeError[k] == 1.0f) << "pixel " << k;
        continue;
      }
      all.Add(difference, claim);
      if (image.SampleCount[k] > 0)
      {
        reached.Add(difference, claim);
        sum += difference;
        squares += difference * difference;
        truth += pixel.Mean;
      }
    }
    for (std::size_t k = 0; k < image.InScattering.size(); ++k)
    {
      if (image.SampleCount[k] < scene.Options.MaximumSamples && image.InScattering[k] > 0.15 * typical)
      {
        largest = std::max(largest, image.RelativeError[k]);
      }
    }
    const double n = reached.Pixels;
    const double standardError = std::sqrt(squares / n / n);
    EXPECT_GT(n, truths.Pixels.size() / 5);
    EXPECT_GE(all.Share(), 0.95) << "goal " << goal;
    EXPECT_GE(reached.Share(), 0.95) << "goal " << goal;
    EXPECT_GT(reached.Median(), 0.25) << "goal " << goal << ": claims are far too large";
    EXPECT_LE(std::fabs(sum / n), 3.0 * standardError) << "goal " << goal << ", " << sum / truth << " of the mean";
    EXPECT_LE(largest, static_cast<float>(1.5001 * goal)) << "where sampling stopped by itself";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ErrorClaims, testing::Values("chair", "tree"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });
