// SPDX-License-Identifier: BSD-3-Clause
// Where pixels ask their neighbours for shadow, claims hold in penumbrae and at hard edges, and pieces have the whole's bytes.
#include "PlainTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Size = 256;
constexpr int FirstI = 180; ///< of the part that is rendered: the edge of the shadow crosses it
constexpr int FirstJ = 40;
constexpr int Side = 32;

/// A sphere of so many triangles that lines cost more than samples.
ImageTestScene SphereUnderADisc(double radius)
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Disc, { 0.0, 5.49, 0.0 }, { 0.0, -1.0, 0.0 }, radius, { 1.0 });
  scene.SetMedium({ 0.05 }, { 0.0 }, { -2.75, 0.0, -2.75 }, { 2.75, 5.2, 2.75 });
  scene.Mesh.AddSphere({ 0.0, 2.5, 0.0 }, 1.0, 130);
  scene.Eye = LookAt({ 0.0, 2.65, 10.0 }, { 0.0, 2.65, 0.0 }, 0.268);
  scene.SetSize(Size, Size);
  scene.Options.Extent = { FirstI, FirstI + Side - 1, FirstJ, FirstJ + Side - 1 };
  scene.Options.RelativeErrorGoal = 0.01;
  scene.Options.MaximumSamples = 1024;
  return scene;
}

class NeighbourClaims : public testing::TestWithParam<double>
{
};
} // namespace

TEST_P(NeighbourClaims, Hold)
{
  const ImageTestScene scene = SphereUnderADisc(GetParam());
  const OccluderScene occluders(scene.Mesh.View());
  const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
  std::vector<PlainTruth> truths;
  std::vector<std::size_t> pixels;
  for (int k = 0; k < 64; ++k)
  {
    const int i = FirstI + 1 + 4 * (k % 8);
    const int j = FirstJ + 2 + 4 * (k / 8);
    truths.push_back(PlainInScattering(scene, occluders, i, j, 1 << 10, 5));
    pixels.push_back(image.IndexOf(i, j));
  }
  const ClaimsHeld held = JudgeClaims(image, pixels, truths);
  EXPECT_GE(held.WithinTwo, 61);
  EXPECT_LE(held.Root, 1.0);
  EXPECT_LE(std::fabs(held.Mean), 0.35) << "too bright or too dark";
  // On its own a pixel in penumbra takes some 700.
  EXPECT_GT(std::count_if(image.SampleCount.begin(), image.SampleCount.end(), [](int samples) { return samples < 300; }),
    Side * Side / 3)
    << "neighbours are asked";
}

INSTANTIATE_TEST_SUITE_P(Lamps, NeighbourClaims, testing::Values(0.5, 0.01));

class NeighbourPieces : public testing::TestWithParam<int>
{
};

TEST_P(NeighbourPieces, HaveTheBytesOfTheWhole)
{
  const int size = GetParam();
  const int firstI = std::min(FirstI * size / Size, size - 38);
  const int firstJ = FirstJ * size / Size;
  ImageTestScene scene = SphereUnderADisc(0.5);
  scene.SetSize(size, size);
  scene.Options.Extent = { firstI, firstI + 37, firstJ, firstJ + 10 };
  const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
  scene.Options.Extent = { firstI + 25, firstI + 37, firstJ + 9, firstJ + 10 };
  const ScatteringImage piece = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
  for (int j = firstJ + 9; j <= firstJ + 10; ++j)
  {
    for (int i = firstI + 25; i <= firstI + 37; ++i)
    {
      EXPECT_EQ(piece.InScattering[piece.IndexOf(i, j)], image.InScattering[image.IndexOf(i, j)]);
      EXPECT_EQ(piece.RelativeError[piece.IndexOf(i, j)], image.RelativeError[image.IndexOf(i, j)]);
      EXPECT_EQ(piece.SampleCount[piece.IndexOf(i, j)], image.SampleCount[image.IndexOf(i, j)]);
    }
  }
}

// With one, two and three levels of looks.
INSTANTIATE_TEST_SUITE_P(Sizes, NeighbourPieces, testing::Values(96, Size, 1024));
