// SPDX-License-Identifier: BSD-3-Clause
// A light in the middle of the medium, in view: Guided against closed form 5 and the reference, with smaller goals.
#include "ClosedForms.h"
#include "Scenes.h"
#include "scReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Size = 8;
constexpr const char* ShapeNames[] = { "Disc", "Rectangle", "Sphere", "Point" };

/// A plate beside the light, and a camera that has both in view.
ImageTestScene SceneAround(LightShape shape)
{
  ImageTestScene scene;
  scene.Source.AxisU = { 0.3, 0.0, 0.0 };
  scene.Source.AxisV = { 0.0, 0.06, 0.18 };
  scene.Source.Shape = shape;
  scene.Source.Normal = { 0.0, -3.0, 1.0 };
  scene.Source.Radius = 0.25;
  scene.Source.Spectrum = { 2.0, 1.0 };
  EXPECT_EQ(PrepareLight(scene.Source), nullptr);
  scene.SetMedium({ 0.15, 0.25 }, { 0.05, 0.15 }, { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 });
  scene.Mesh.AddSheet({ -0.5, -0.6, -0.5 }, { 0.9, 0.1, 0.0 }, { 0.0, 0.1, 0.9 });
  scene.Eye = LookAt({ 0.4, -0.3, 5.0 }, { 0.0, -0.2, 0.0 }, 0.3);
  scene.SetSize(Size, Size);
  scene.Options.MaximumSamples = 1 << 17;
  return scene;
}

class LightInMedium : public testing::TestWithParam<LightShape>
{
};
} // namespace

TEST_P(LightInMedium, GuidedApproachesTheReference)
{
  ImageTestScene scene = SceneAround(GetParam());
  const ReferenceScene slow(scene.Mesh.View());
  const int pixels[][2] = { { 3, 1 }, { 4, 1 }, { 4, 2 }, { 2, 2 }, { 3, 3 }, { 4, 4 }, { 5, 4 }, { 6, 3 } };
  std::vector<ReferenceEstimate> truth;
  for (const auto& pixel : pixels)
  {
    truth.push_back(ReferenceInScattering(
      slow, scene.Source, scene.Fog, scene.Eye, pixel[0], pixel[1], Size, Size, 200000));
  }
  for (const double goal : { 0.04, 0.02, 0.01 })
  {
    scene.Options.RelativeErrorGoal = goal;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
    for (std::size_t p = 0; p < truth.size(); ++p)
    {
      const auto index = static_cast<std::size_t>(pixels[p][1] * Size + pixels[p][0]);
      double value = 0.0;
      double expected = 0.0;
      double noise = 0.0;
      for (std::size_t k = 0; k < 2; ++k)
      {
        value += 0.5 * image.InScattering[2 * index + k];
        expected += 0.5 * truth[p].Mean[k];
        noise += 0.5 * truth[p].StandardError[k];
      }
      const double claim = std::hypot(image.RelativeError[index] * value, noise);
      EXPECT_NEAR(value, expected, 3.0 * claim)
        << "goal " << goal << ", pixel " << pixels[p][0] << ", " << pixels[p][1];
      EXPECT_LT(image.RelativeError[index], 1.5001 * goal) << "pixel " << pixels[p][0] << ", " << pixels[p][1];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, LightInMedium,
  testing::Values(LightShape::Disc, LightShape::Rectangle, LightShape::Sphere, LightShape::Point),
  [](const testing::TestParamInfo<LightShape>& info) { return std::string(ShapeNames[static_cast<int>(info.param)]); });

TEST(LightInMediumForms, APointLightIsClosedFormFive)
{
  ImageTestScene scene = SceneAround(LightShape::Point);
  scene.SetMedium({ 0.15, 0.25 }, { 0.0, 0.0 }, { -9.0, -9.0, -9.0 }, { 9.0, 9.0, 9.0 });
  scene.Mesh = TestMesh();
  scene.AddNothing();
  // One ray passes close to the light.
  scene.Eye = LookAt({ 0.4, -0.3, 5.0 }, {}, 0.3);
  scene.SetSize(9, 9);
  scene.Eye.Position = scene.Eye.Position + 0.03 * scene.Eye.Right;
  for (const double goal : { 0.04, 0.01 })
  {
    scene.Options.RelativeErrorGoal = goal;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
    for (int pixel = 0; pixel < 81; pixel += 4)
    {
      const Ray ray = scene.PixelRay(pixel % 9, pixel / 9);
      double begin = 0.0;
      double end = HUGE_VAL;
      ASSERT_TRUE(scene.Fog.Bounds.Clip(ray.Origin, ray.Direction, begin, end));
      const Vector3 toLight = scene.Source.Center - ray.Origin;
      const double gamma = std::acos(Dot(toLight, ray.Direction) / Length(toLight));
      for (std::size_t k = 0; k < 2; ++k)
      {
        const double expected =
          closedforms::Airlight(scene.Source.Spectrum[k], scene.Fog.SigmaS[k], Length(toLight), gamma, end);
        EXPECT_NEAR(image.InScattering[2 * static_cast<std::size_t>(pixel) + k] / expected, 1.0, 0.005)
          << "pixel " << pixel << ", wavelength " << k << ", goal " << goal;
      }
    }
  }
}
