// SPDX-License-Identifier: BSD-3-Clause
// The same bytes of every mode for any number of threads and any split of the image, in clear and uneven fog.
#include "ImageTestScene.h"
#include "SampledDensity.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace shadowcones;

namespace
{
constexpr int Width = 41;
constexpr int Height = 35;

/// A disc light and two discs that hide it.
struct BytesScene : ImageTestScene
{
  DensityGrid Density = SampleDensity({ { 9, 9, 9 } }, { -2.0, -2.0, 0.0 }, UnitAxes({ 0.5, 0.5, 0.5 }),
    [](const Vector3& p) { return 1.0 + 0.8 * std::sin(3.0 * p.X) * std::cos(2.0 * p.Y + p.Z); });

  BytesScene()
  {
    this->SetLight(LightShape::Disc, {}, { 0.0, 0.0, 1.0 }, 0.4, { 1.0, 2.0, 3.0 });
    this->SetMedium({ 0.1, 0.2, 0.3 }, { 0.2, 0.1, 0.1 }, { -2.0, -2.0, 0.3 }, { 2.0, 2.0, 4.0 });
    this->AddDisc({ 0.2, 0.1, 1.0 }, 0.3, { 0.0, 0.0, 1.0 }, closedforms::DiscPenumbraHalfAngle(0.7, 0.3, 1.0));
    this->AddDisc({ -0.5, 0.4, 1.8 }, 0.4, { 0.0, 0.0, 1.0 }, closedforms::DiscPenumbraHalfAngle(1.0, 0.4, 1.8));
    this->Eye = LookAt({ -3.0, 1.0, 4.5 }, { 0.3, 0.0, 1.8 }, 0.4);
    this->SetSize(Width, Height);
    this->Options.NumberOfSteps = 8;
    this->Options.MaximumDepth = 2;
    this->Options.NumberOfLightSamples = 4;
    this->Options.NumberOfSurfaceLightSamples = 4;
    this->Options.RelativeErrorGoal = 0.05;
    this->Options.MaximumSamples = 256;
    this->GridOptions.Dimensions = { 17, 17, 17 };
  }
};

/// The parts of the whole image that @p extent names.
template <typename Value>
std::vector<Value> Cut(const std::vector<Value>& whole, const std::array<int, 4>& extent)
{
  const std::size_t components = whole.size() / (Width * Height);
  std::vector<Value> part;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    const auto row = whole.begin() + static_cast<std::ptrdiff_t>(components) * (j * Width);
    part.insert(part.end(), row + static_cast<std::ptrdiff_t>(components) * extent[0],
      row + static_cast<std::ptrdiff_t>(components) * (extent[1] + 1));
  }
  return part;
}

void ExpectPart(const ScatteringImage& part, const ScatteringImage& whole, const std::array<int, 4>& extent)
{
  EXPECT_TRUE(part.Radiance == Cut(whole.Radiance, extent));
  EXPECT_TRUE(part.InScattering == Cut(whole.InScattering, extent));
  EXPECT_TRUE(part.SurfaceRadiance == Cut(whole.SurfaceRadiance, extent));
  EXPECT_TRUE(part.Transmittance == Cut(whole.Transmittance, extent));
  EXPECT_TRUE(part.Depth == Cut(whole.Depth, extent));
  EXPECT_TRUE(part.RelativeError == Cut(whole.RelativeError, extent));
  EXPECT_TRUE(part.SampleCount == Cut(whole.SampleCount, extent));
}

class ImageBytes : public testing::TestWithParam<std::tuple<ScatteringMode, bool>>
{
protected:
  void SetUp() override
  {
    const auto [mode, dense] = this->GetParam();
    this->Mode = mode;
    this->Scene.Fog.Density = dense ? &this->Scene.Density : nullptr;
  }
  BytesScene Scene;
  ScatteringMode Mode = ScatteringMode::BruteForce;
};
} // namespace

TEST_P(ImageBytes, AnyNumberOfThreads)
{
  const std::array<int, 4> all = this->Scene.Options.Extent;
  const int before = vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkSMPTools::Initialize(1);
  const ScatteringImage one = this->Scene.Render(this->Mode);
  for (const int threads : { 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    SCOPED_TRACE(threads);
    ExpectPart(this->Scene.Render(this->Mode), one, all);
  }
  vtkSMPTools::Initialize(before);
}

TEST_P(ImageBytes, AnySplit)
{
  const ScatteringImage whole = this->Scene.Render(this->Mode);
  const std::array<int, 4> pieces[] = { { 0, Width - 1, 11, 11 }, { 33, 33, 0, Height - 1 }, { 7, 7, 5, 5 },
    { 13, 38, 3, 33 }, { 5, 30, 31, 33 } };
  for (const std::array<int, 4>& piece : pieces)
  {
    this->Scene.Options.Extent = piece;
    SCOPED_TRACE(testing::PrintToString(piece));
    ExpectPart(this->Scene.Render(this->Mode), whole, piece);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, ImageBytes,
  testing::Values(ImageBytes::ParamType{ ScatteringMode::BruteForce, false },
    ImageBytes::ParamType{ ScatteringMode::Medium, false }, ImageBytes::ParamType{ ScatteringMode::Fast, false },
    ImageBytes::ParamType{ ScatteringMode::Guided, false }, ImageBytes::ParamType{ ScatteringMode::Guided, true },
    ImageBytes::ParamType{ ScatteringMode::Soft, false }, ImageBytes::ParamType{ ScatteringMode::Volume, false },
    ImageBytes::ParamType{ ScatteringMode::Volume, true }, ImageBytes::ParamType{ ScatteringMode::Medium, true }),
  [](const testing::TestParamInfo<ImageBytes::ParamType>& info)
  { return std::string(NameOf(std::get<0>(info.param))) + (std::get<1>(info.param) ? "Density" : ""); });
