// SPDX-License-Identifier: BSD-3-Clause
// The same bytes of every mode for any split of the image, in clear and uneven fog.
#include "ClosedForms.h"
#include "SampledDensity.h"
#include "Scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Width = 41;
constexpr int Height = 35;

/// A disc light and two discs that hide it.
struct BytesScene : ImageTestScene
{
  DensityGrid Density = SampleDensity({ { 5, 5, 5 } }, { -2.0, -2.0, 0.0 }, UnitAxes({ 1.0, 1.0, 1.0 }),
    [](const Vector3& p) { return 1.0 + 0.4 * std::sin(p.X) * std::cos(p.Y + 0.5 * p.Z); });

  BytesScene()
  {
    this->SetLight(LightShape::Disc, {}, { 0.0, 0.0, 1.0 }, 0.4, { 1.0, 2.0, 3.0 });
    this->SetMedium({ 0.1, 0.2, 0.3 }, { 0.2, 0.1, 0.1 }, { -2.0, -2.0, 0.3 }, { 2.0, 2.0, 4.0 });
    this->AddDisc({ 0.2, 0.1, 1.0 }, 0.3, { 0.0, 0.0, 1.0 }, closedforms::DiscPenumbraHalfAngle(0.7, 0.3, 1.0));
    this->AddDisc({ -0.5, 0.4, 1.8 }, 0.4, { 0.0, 0.0, 1.0 }, closedforms::DiscPenumbraHalfAngle(1.0, 0.4, 1.8));
    this->Eye = LookAt({ -3.0, 1.0, 4.5 }, { 0.3, 0.0, 1.8 }, 0.4);
    this->SetSize(Width, Height);
    this->Options.NumberOfSteps = 8;
    this->Options.MaximumHalvings = 2;
    this->Options.NumberOfLightSamples = 4;
    this->Options.NumberOfSurfaceLightSamples = 4;
    this->Options.RelativeErrorGoal = 0.05;
    this->Options.MaximumSamples = 256;
    this->GridOptions.Dimensions = { 17, 17, 17 };
  }
};

using Extent = std::array<int, 4>;

int PixelsOf(const Extent& extent)
{
  return (extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1);
}

/// The part of the values of @p whole that @p extent names.
template <typename Value>
std::vector<Value> Cut(const PixelArray<Value>& values, const Extent& whole, const Extent& extent)
{
  const auto components = static_cast<std::ptrdiff_t>(values.size()) / PixelsOf(whole);
  std::vector<Value> part;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    const auto row = values.begin() + components * (j - whole[2]) * (whole[1] - whole[0] + 1);
    part.insert(part.end(), row + components * (extent[0] - whole[0]), row + components * (extent[1] + 1 - whole[0]));
  }
  return part;
}

void ExpectPart(const ScatteringImage& part, const Extent& extent, const ScatteringImage& image, const Extent& whole)
{
  EXPECT_TRUE(part.Radiance == Cut(image.Radiance, whole, extent));
  EXPECT_TRUE(part.InScattering == Cut(image.InScattering, whole, extent));
  EXPECT_TRUE(part.SurfaceRadiance == Cut(image.SurfaceRadiance, whole, extent));
  EXPECT_TRUE(part.Transmittance == Cut(image.Transmittance, whole, extent));
  EXPECT_TRUE(part.Depth == Cut(image.Depth, whole, extent));
  EXPECT_TRUE(part.RelativeError == Cut(image.RelativeError, whole, extent));
  EXPECT_TRUE(part.SurfaceRelativeError == Cut(image.SurfaceRelativeError, whole, extent));
  EXPECT_TRUE(part.SampleCount == Cut(image.SampleCount, whole, extent));
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

TEST_P(ImageBytes, AnySplit)
{
  // Uneven fog takes long, tile by tile of 32 pixels: there the image is a strip across one border of tiles.
  const bool dense = this->Scene.Fog.Density != nullptr;
  const bool tall = this->Mode == ScatteringMode::Volume;
  const Extent whole = !dense ? Extent{ 0, Width - 1, 0, Height - 1 }
    : tall                    ? Extent{ 0, 3, 0, 34 }
                              : Extent{ 0, 34, 0, 3 };
  const std::vector<Extent> pieces = !dense ? std::vector<Extent>{ { 0, Width - 1, 11, 11 }, { 33, 33, 0, Height - 1 },
    { 7, 7, 5, 5 }, { 13, 38, 3, 33 }, { 5, 30, 31, 33 } }
    : tall                                  ? std::vector<Extent>{ { 2, 2, 7, 7 }, { 1, 2, 29, 34 } }
                                            : std::vector<Extent>{ { 33, 33, 0, 3 }, { 29, 34, 1, 2 } };
  this->Scene.SetSize(whole[1] + 1, whole[3] + 1);
  this->Scene.Eye.HalfHeight *= (whole[3] + 1.0) / Height; // pixels of one size
  const ScatteringImage image = this->Scene.Render(this->Mode);
  EXPECT_EQ(image.Depth.size(), static_cast<std::size_t>(PixelsOf(whole)));
  for (const Extent& piece : pieces)
  {
    this->Scene.Options.Extent = piece;
    SCOPED_TRACE(testing::PrintToString(piece));
    ExpectPart(this->Scene.Render(this->Mode), piece, image, whole);
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
