// SPDX-License-Identifier: BSD-3-Clause
// What Guided says of its error where very little is asked for, against samples that share no light rule with it.
#include "PlainTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Size = 160;
constexpr int FirstI = 104; ///< of the part that is rendered: where the rays pass near the lamp and through its shadow
constexpr int FirstJ = 40;
constexpr int Side = 16;

/// Things under a disc in a room of fog, cut by the image's pixels at even distances.
struct GoalScene : ImageTestScene
{
  explicit GoalScene(const std::string& name)
  {
    this->SetLight(LightShape::Disc, { 0.4, 3.6, -0.2 }, { 0.1, -1.0, 0.05 }, 0.4, { 1.0 });
    this->SetMedium({ 0.2 }, { 0.1 }, { -2.0, 0.0, -2.0 }, { 2.0, 4.0, 2.0 }); // the lamp in it
    this->Eye = LookAt({ 0.5, 1.5, 7.0 }, { 0.0, 1.3, 0.0 }, 0.5);
    this->SetSize(Size, Size);
    this->Options.Extent = { FirstI, FirstI + Side - 1, FirstJ, FirstJ + Side - 1 };
    this->Options.MaximumSamples = 1 << 15;
    if (name == "slats")
    {
      for (int k = 0; k < 9; ++k)
      {
        this->Mesh.AddSheet({ -1.2 + 0.27 * k, 1.9, -1.3 }, { 0.13, 0.06, 0.0 }, { 0.0, 0.1, 2.6 });
      }
    }
    else if (name == "box")
    {
      this->Mesh.AddBox({ -0.7, 0.6, -0.6 }, { 0.9, 1.7, 0.5 });
    }
    else // "terrain"
    {
      const auto height = [](double x, double z) { return 0.5 + 0.35 * std::sin(3.0 * x) * std::cos(2.3 * z + x); };
      for (int a = 0; a < 24; ++a)
      {
        for (int b = 0; b < 24; ++b)
        {
          const double x = -1.9 + 3.8 * a / 24;
          const double z = -1.9 + 3.8 * b / 24;
          const double h = 3.8 / 24;
          const vtkIdType corner = this->Mesh.AddPoint({ x, height(x, z), z });
          const vtkIdType along = this->Mesh.AddPoint({ x + h, height(x + h, z), z });
          const vtkIdType across = this->Mesh.AddPoint({ x, height(x, z + h), z + h });
          const vtkIdType opposite = this->Mesh.AddPoint({ x + h, height(x + h, z + h), z + h });
          this->Mesh.AddTriangle(corner, across, along, 0);
          this->Mesh.AddTriangle(opposite, along, across, 0);
        }
      }
      this->Mesh.AddBox({ -1.0, 1.6, -1.0 }, { -0.2, 1.7, 0.9 });
    }
  }
};

class SmallGoals : public testing::TestWithParam<const char*>
{
};
} // namespace

TEST_P(SmallGoals, ClaimsHoldDownToATenthOfAPerCent)
{
  GoalScene scene(GetParam());
  const OccluderScene occluders(scene.Mesh.View());
  const OccluderScene nothing{ TriangleMeshView() };
  struct Pixel
  {
    int I;
    int J;
    PlainTruth Truth;
  };
  std::vector<Pixel> pixels;
  for (int j = FirstJ; j < FirstJ + Side; j += 2)
  {
    for (int i = FirstI; i < FirstI + Side; i += 2)
    {
      const PlainTruth coarse = PlainInScattering(scene, occluders, i, j, 64, 3, 1);
      const PlainTruth open = PlainInScattering(scene, nothing, i, j, 64, 3, 1);
      if (coarse.Mean > 0.05 * open.Mean && coarse.Mean < 0.99 * open.Mean)
      {
        pixels.push_back({ i, j, PlainInScattering(scene, occluders, i, j, 1 << 13, 5) });
      }
    }
  }
  ASSERT_GT(pixels.size(), 20u);
  for (const double goal : { 0.003, 0.001 })
  {
    scene.Options.RelativeErrorGoal = goal;
    int held = 0;
    double sum = 0.0;
    double squares = 0.0;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
    for (const Pixel& pixel : pixels)
    {
      const auto index = static_cast<std::size_t>((pixel.J - FirstJ) * Side + pixel.I - FirstI);
      const double claim = static_cast<double>(image.RelativeError[index]) * image.InScattering[index];
      const double difference = image.InScattering[index] - pixel.Truth.Mean;
      held += std::fabs(difference) <= 2.0 * std::hypot(claim, pixel.Truth.Error);
      const double ratio = difference / std::hypot(claim, pixel.Truth.Error);
      sum += ratio;
      squares += ratio * ratio;
    }
    const auto count = static_cast<double>(pixels.size());
    EXPECT_GE(held / count, 0.95) << "goal " << goal;
    // Errors of the unshadowed light are alike in neighbouring pixels: not all of them may lean to one side.
    EXPECT_LE(std::fabs(sum) / count, 0.25) << "goal " << goal << ": too bright or too dark";
    EXPECT_LE(std::sqrt(squares / count), 1.0) << "goal " << goal;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SmallGoals, testing::Values("slats", "box", "terrain"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });
