// SPDX-License-Identifier: BSD-3-Clause
// Scenes that are easy to get wrong, in every mode: no value is NaN, and all modes find the image of brute force.
#include "ClosedForms.h"
#include "Scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr ScatteringMode AllModes[] = { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast,
  ScatteringMode::Guided, ScatteringMode::Soft, ScatteringMode::Volume };

/// A disc under a disc light, seen from the side.
ImageTestScene Plain(const Placement& place = Placements()[0])
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Disc, place({}), { 0.0, 0.0, 1.0 }, 0.5 * place.Scale, { 1.0, 2.0 });
  scene.SetMedium({ 0.1 / place.Scale, 0.2 / place.Scale }, { 0.05 / place.Scale, 0.0 }, place({ -2.0, -2.0, 0.3 }),
    place({ 2.0, 2.0, 4.0 }));
  scene.AddDisc(place({ 0.0, 0.0, 1.5 }), 0.6 * place.Scale, { 0.0, 0.0, 1.0 },
    closedforms::DiscPenumbraHalfAngle(0.5, 0.6, 1.5));
  scene.Eye = LookAt(place({ -7.0, 0.3, 2.4 }), place({ 0.0, 0.0, 2.2 }), 0.35);
  scene.SetSize(11, 9);
  scene.Options.NumberOfSteps = 32;
  scene.Options.MaximumHalvings = 4;
  scene.Options.NumberOfLightSamples = 64;
  scene.Options.NumberOfSurfaceLightSamples = 16;
  scene.Options.RelativeErrorGoal = 0.005;
  scene.Options.MaximumSamples = 1 << 14;
  scene.GridOptions.Dimensions = { 33, 33, 33 };
  return scene;
}

void ExpectSound(const ScatteringImage& image, const std::string& what)
{
  const auto sound = [](float value) { return std::isfinite(value) && value >= 0.0f; };
  for (const auto* values : { &image.Radiance, &image.InScattering, &image.SurfaceRadiance, &image.Transmittance })
  {
    EXPECT_TRUE(std::all_of(values->begin(), values->end(), sound)) << what;
  }
  for (const auto* values : { &image.Depth, &image.RelativeError })
  {
    EXPECT_TRUE(std::all_of(
      values->begin(), values->end(), [](float value) { return std::isfinite(value) && value >= -1.0f; }))
      << what;
  }
  EXPECT_TRUE(std::all_of(image.SampleCount.begin(), image.SampleCount.end(), [](int n) { return n >= 0; })) << what;
}

double Sum(const std::vector<float>& values)
{
  double sum = 0.0;
  for (const float value : values)
  {
    sum += value;
  }
  return sum;
}

/// Sum of differences over the sum.
double Difference(const std::vector<float>& a, const std::vector<float>& b)
{
  double difference = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    difference += std::fabs(static_cast<double>(a[k]) - b[k]);
  }
  return difference / Sum(b);
}

/// All modes are sound, and all but Fast agree in the mean within @p bound (Soft and Volume: within @p gridBound).
void ExpectAgreement(const ImageTestScene& scene, double bound = 0.01, double gridBound = 0.02)
{
  const ScatteringImage brute = scene.Render(ScatteringMode::BruteForce);
  ASSERT_GT(Sum(brute.InScattering), 0.0);
  for (const ScatteringMode mode : AllModes)
  {
    const ScatteringImage image = scene.Render(mode);
    ExpectSound(image, NameOf(mode));
    const bool grid = mode == ScatteringMode::Soft || mode == ScatteringMode::Volume;
    if (mode != ScatteringMode::Fast)
    {
      EXPECT_LT(Difference(image.InScattering, brute.InScattering), grid ? gridBound : bound) << NameOf(mode);
    }
  }
}

/// Nothing in the medium scatters any light.
void ExpectNothing(const ImageTestScene& scene)
{
  for (const ScatteringMode mode : AllModes)
  {
    const ScatteringImage image = scene.Render(mode);
    ExpectSound(image, NameOf(mode));
    EXPECT_EQ(Sum(image.InScattering), 0.0) << NameOf(mode);
    EXPECT_LE(Sum(image.RelativeError), 0.0) << NameOf(mode);
  }
}
} // namespace

TEST(AwkwardImages, PlainScene)
{
  ExpectAgreement(Plain());
}

TEST(AwkwardImages, EmptyMesh)
{
  ImageTestScene scene = Plain();
  scene.Mesh = TestMesh();
  scene.Discs.clear();
  ExpectAgreement(scene);
}

TEST(AwkwardImages, NoCones)
{
  // Without bounds no shadow is looked for; without a hierarchy it is looked for everywhere.
  ImageTestScene scene = Plain();
  const ScatteringImage right = scene.Render(ScatteringMode::Guided);
  const ScatteringImage whole = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
  EXPECT_LT(Difference(whole.InScattering, right.InScattering), 0.01);
  scene.Bounds.clear();
  scene.Discs.clear();
  const ScatteringImage open = scene.Render(ScatteringMode::Guided);
  EXPECT_EQ(std::count(open.SampleCount.begin(), open.SampleCount.end(), 0), 99);
  for (const ScatteringMode mode : AllModes)
  {
    ExpectSound(scene.Render(mode), NameOf(mode));
  }
  EXPECT_EQ(scene.Render(ScatteringMode::Volume).InScattering, open.InScattering);
  EXPECT_EQ(scene.Render(ScatteringMode::Soft).InScattering, open.InScattering);
  EXPECT_EQ(scene.Render(ScatteringMode::Volume, nullptr, nullptr).InScattering, open.InScattering);
  EXPECT_GT(Sum(open.InScattering), 1.05 * Sum(right.InScattering));
}

TEST(AwkwardImages, NoScattering)
{
  ImageTestScene scene = Plain();
  scene.Fog.SigmaS = { 0.0, 0.0 };
  ExpectNothing(scene);
}

TEST(AwkwardImages, NoRayMeetsTheMedium)
{
  ImageTestScene scene = Plain();
  scene.Eye = LookAt({ -7.0, 0.3, 2.4 }, { -14.0, 0.0, 2.2 }, 0.35);
  ExpectNothing(scene);
}

TEST(AwkwardImages, TheLightFacesAway)
{
  ImageTestScene scene = Plain();
  scene.Source.Normal = { 0.0, 0.0, -1.0 };
  ExpectNothing(scene);
  // And in the middle of the medium: one half is lit.
  scene.Source.Center = { 0.0, 0.0, 1.0 };
  scene.Mesh = TestMesh();
  scene.AddNothing();
  scene.Bounds.clear();
  scene.Discs.clear();
  ExpectAgreement(scene);
}

TEST(AwkwardImages, ACameraInTheMedium)
{
  ImageTestScene scene = Plain();
  scene.Eye = LookAt({ -1.1, 0.2, 2.4 }, { 1.0, 0.0, 2.2 }, 0.8);
  // So near the light its parts do not shine alike, as the visible fraction of its area has it.
  ExpectAgreement(scene, 0.01, 0.03);
  scene.Eye = LookAt({ 0.0, 0.0, 3.5 }, { 0.1, 0.2, 0.0 }, 0.8);
  ExpectAgreement(scene);
}

TEST(AwkwardImages, AParallelCamera)
{
  ImageTestScene scene = Plain();
  scene.Eye = LookAt({ -7.0, 0.3, 2.4 }, { 0.0, 0.3, 2.4 }, 1.7, true);
  ExpectAgreement(scene);
}

TEST(AwkwardImages, FarAwayAndTiny)
{
  const ScatteringImage here = Plain().Render(ScatteringMode::Guided);
  for (const Placement& place : { Placement{ "far away", 1.0, { 1e6, -1e6, 1e6 } }, Placement{ "tiny", 1e-6, {} },
         Placement{ "huge", 1e6, {} } })
  {
    SCOPED_TRACE(place.Name);
    const ImageTestScene scene = Plain(place);
    ExpectAgreement(scene);
    // sigma times length stays the same, and so does the radiance.
    EXPECT_LT(Difference(scene.Render(ScatteringMode::Guided).InScattering, here.InScattering), 0.01);
  }
}

TEST(AwkwardImages, ThreeExtinctions)
{
  ImageTestScene scene = Plain();
  scene.Source.Spectrum = { 1.0, 10.0, 0.1 };
  scene.Fog.SigmaS = { 0.1, 1.0, 0.02 };
  scene.Fog.SigmaA = { 0.0, 2.0, 0.0 };
  ExpectAgreement(scene);
  // One at a time gives what all together do.
  const ScatteringImage together = scene.Render(ScatteringMode::Volume);
  for (std::size_t k = 0; k < 3; ++k)
  {
    ImageTestScene single = Plain();
    single.Source.Spectrum = { scene.Source.Spectrum[k] };
    single.Fog.SigmaS = { scene.Fog.SigmaS[k] };
    single.Fog.SigmaA = { scene.Fog.SigmaA[k] };
    const ScatteringImage alone = single.Render(ScatteringMode::Volume);
    double worst = 0.0;
    for (std::size_t pixel = 0; pixel < alone.InScattering.size(); ++pixel)
    {
      const double value = alone.InScattering[pixel];
      worst = std::max(worst, value > 0.0 ? std::fabs(together.InScattering[3 * pixel + k] / value - 1.0) : 0.0);
    }
    EXPECT_LT(worst, 0.005) << "wavelength " << k;
  }
}

TEST(AwkwardImages, AMeshLightOfManyTriangles)
{
  ImageTestScene scene = Plain();
  // A wavy sheet of 2,048 triangles that shines down.
  scene.Source.Shape = LightShape::Mesh;
  constexpr int side = 32;
  const auto at = [](int i, int j)
  {
    const double x = 1.2 * (static_cast<double>(i) / side - 0.5);
    const double y = 1.2 * (static_cast<double>(j) / side - 0.5);
    return Vector3{ x, y, 0.05 * std::sin(9.0 * x) * std::cos(7.0 * y) };
  };
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      scene.Source.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      scene.Source.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  ASSERT_EQ(PrepareLight(scene.Source), nullptr);
  scene.Bounds[0].HalfAngle = closedforms::DiscPenumbraHalfAngle(0.9, 0.6, 1.4);
  ExpectAgreement(scene);
}

TEST(AwkwardImages, VertexLights)
{
  ImageTestScene scene = Plain();
  scene.Source.Shape = LightShape::Mesh;
  scene.Source.Vertices = { { -0.4, 0.0, 0.0 }, { 0.3, 0.2, 0.0 }, { 0.1, -0.4, 0.1 } };
  ASSERT_EQ(PrepareLight(scene.Source), nullptr);
  scene.Options.NumberOfLightSamples = 48;
  ExpectAgreement(scene, 0.015, 0.03);
}

TEST(AwkwardImages, AGridThatCoversAPartOfTheMedium)
{
  // Beyond the grid all is lit.
  ImageTestScene scene = Plain();
  const OccluderScene occluders(scene.Mesh.View());
  const Box whole = scene.Fog.Bounds;
  scene.Fog.Bounds.Max.Z = 2.5;
  const VisibilityGrid part = scene.FillGrid(ScatteringMode::Volume, occluders);
  scene.Fog.Bounds = whole;
  const double shadowed = Sum(scene.Render(ScatteringMode::Volume).InScattering);
  const ScatteringImage image = scene.Render(ScatteringMode::Volume, nullptr, &part);
  ExpectSound(image, "part");
  EXPECT_GT(Sum(image.InScattering), 1.005 * shadowed);
  EXPECT_LT(Sum(image.InScattering), Sum(scene.Render(ScatteringMode::Volume, nullptr, nullptr).InScattering));
}
