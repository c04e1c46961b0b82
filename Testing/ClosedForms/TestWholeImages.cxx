// SPDX-License-Identifier: BSD-3-Clause
// Whole small images of the fast modes, with everything in them at once, against the slow reference.
#include "SampledDensity.h"
#include "Scenes.h"
#include "scReference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Side = 12;
constexpr double Reflectance = 0.5;
/// What fixed rules, grids and surfels may err by, of a pixel.
constexpr double Tolerance = 0.01;

/// A lamp over two discs and a floor; two wavelengths, forward scattering, a density image on request.
struct Shafts : ImageTestScene
{
  DensityGrid Density;

  explicit Shafts(bool dense)
    : Density(SampleDensity({ { 9, 9, 9 } }, { -2.0, -2.0, -2.0 }, UnitAxes({ 0.5, 0.5, 0.5 }),
        [](const Vector3& p) { return 1.0 + 0.7 * std::sin(2.0 * p.X) * std::cos(p.Y - 1.5 * p.Z); }))
  {
    this->SetLight(LightShape::Disc, { 0.0, 0.0, 2.3 }, { 0.0, 0.0, -1.0 }, 0.5, { 1.0, 2.0 });
    this->SetMedium({ 0.4, 0.15 }, { 0.1, 0.3 }, { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 });
    this->Fog.Phase.Kind = PhaseFunctionKind::HenyeyGreenstein;
    this->Fog.Phase.Asymmetry = 0.6;
    this->Fog.Density = dense ? &this->Density : nullptr;
    // Half angles that hold the shadow also beside the axis.
    this->AddDisc({ 0.3, 0.0, 0.8 }, 0.5, { 0.0, 0.0, -1.0 }, std::atan((0.5 + 0.5 + 0.3) / 1.5));
    this->AddDisc({ -0.7, 0.3, -0.2 }, 0.35, { 0.0, 0.0, -1.0 }, std::atan((0.5 + 0.35 + 0.8) / 2.5));
    this->Mesh.AddSheet({ -2.0, -2.0, -1.9 }, { 4.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 });
    this->Eye = LookAt({ 0.2, -7.0, 1.1 }, { 0.0, 0.0, 0.0 }, 0.3);
    this->SetSize(Side, Side);
    this->Options.NumberOfSurfaceLightSamples = 256;
    this->Options.NumberOfEdgeSamples = 1; // the reference looks along the centres of the pixels
    this->Options.LightVisible = false;
    this->Options.Reflectance = Reflectance;
    this->Options.RelativeErrorGoal = 0.005;
    this->GridOptions.Dimensions = { 49, 49, 49 };
    this->GridOptions.NumberOfLightSamples = 64;
  }
};

/// All pixels, wavelength by wavelength.
struct Truth
{
  std::vector<double> Mean;
  std::vector<double> Error;

  void Add(const ReferenceEstimate& estimate)
  {
    this->Mean.insert(this->Mean.end(), estimate.Mean.begin(), estimate.Mean.end());
    this->Error.insert(this->Error.end(), estimate.StandardError.begin(), estimate.StandardError.end());
  }
};

class WholeImages : public testing::TestWithParam<bool>
{
};

/// Pixels differ from the truth by what both claim, and have no bias beyond @p tolerance.
void ExpectTruth(const std::vector<float>& values, const Truth& truth, double tolerance, const char* what)
{
  ASSERT_EQ(values.size(), truth.Mean.size());
  double sum = 0.0;
  double expected = 0.0;
  double variance = 0.0;
  double squares = 0.0;
  double worst = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const double difference = values[k] - truth.Mean[k];
    const double deviation = std::hypot(truth.Error[k], tolerance * truth.Mean[k]);
    sum += difference;
    expected += truth.Mean[k];
    variance += truth.Error[k] * truth.Error[k];
    if (deviation > 0.0)
    {
      squares += difference * difference / (deviation * deviation) / static_cast<double>(values.size());
      worst = std::max(worst, std::fabs(difference) / deviation);
    }
    else
    {
      EXPECT_EQ(values[k], 0.0f) << what << ", value " << k;
    }
  }
  EXPECT_GT(expected, 0.0);
  EXPECT_LT(std::fabs(sum), 3.5 * std::sqrt(variance) + 0.5 * tolerance * expected) << what << ": " << sum / expected;
  EXPECT_LT(squares, 1.4) << what;
  EXPECT_LT(worst, 5.5) << what;
}
} // namespace

TEST_P(WholeImages, AreThoseOfTheReference)
{
  const Shafts scene(GetParam());
  const ReferenceScene slow(scene.Mesh.View());
  Truth air;
  Truth surfaces;
  for (int j = 0; j < Side; ++j)
  {
    for (int i = 0; i < Side; ++i)
    {
      air.Add(ReferenceInScattering(
        slow, scene.Source, scene.Fog, scene.Eye, i, j, Side, Side, GetParam() ? 1024 : 4096));
      surfaces.Add(
        ReferenceSurface(slow, scene.Source, scene.Fog, scene.Eye, i, j, Side, Side, Reflectance, 1024));
    }
  }
  const ConeHierarchy cones(scene.Bounds, scene.Fog.Bounds);
  for (const ConeHierarchy* bounds : { &cones, static_cast<const ConeHierarchy*>(nullptr) })
  {
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, bounds, nullptr);
    ExpectTruth(image.InScattering, air, scene.Options.RelativeErrorGoal, bounds ? "cones" : "no cones");
    ExpectTruth(image.SurfaceRadiance, surfaces, Tolerance, "surfaces");
  }
  for (const ScatteringMode mode : { ScatteringMode::Volume, ScatteringMode::Soft })
  {
    ExpectTruth(scene.Render(mode).InScattering, air, Tolerance, NameOf(mode));
  }
}

TEST_P(WholeImages, TransmittanceToTheFirstSurface)
{
  Shafts scene(GetParam());
  scene.Options.MaximumSamples = 8;
  const ScatteringImage image = scene.Render(ScatteringMode::Guided);
  const ReferenceScene slow(scene.Mesh.View());
  for (int j = 0; j < Side; ++j)
  {
    for (int i = 0; i < Side; ++i)
    {
      const Ray ray = scene.PixelRay(i, j);
      const double t = std::min(slow.Nearest(ray.Origin, ray.Direction, 0.0, HUGE_VAL), 100.0);
      const double depth = ReferenceDepth(scene.Fog, ray.Origin, ray.Origin + t * ray.Direction);
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double expected = std::exp(-(scene.Fog.SigmaS[k] + scene.Fog.SigmaA[k]) * depth);
        EXPECT_NEAR(image.Transmittance[2 * static_cast<std::size_t>(j * Side + i) + k], expected, 2e-3 * expected);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Media, WholeImages, testing::Bool(),
  [](const testing::TestParamInfo<bool>& info) { return info.param ? "Density" : "Homogeneous"; });
