// SPDX-License-Identifier: BSD-3-Clause
// With proved cones Medium has the bytes of BruteForce and Guided has no bias, whatever the light and wherever it stands.
#include "Scenes.h"

#include "scConeProof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
Light LampOfFaces(const std::vector<std::array<Vector3, 3>>& faces)
{
  Light light;
  light.Shape = LightShape::Mesh;
  light.Triangles = faces;
  return Prepared(light);
}

/// A one-sided lamp in a closed box, over a table.
void LampInClosedBox(ImageTestScene& scene)
{
  scene.Mesh.AddBox({ -1.2, -1.1, -0.9 }, { 1.2, 1.3, 1.6 }, 0);
  scene.Mesh.AddBox({ -0.5, -0.4, -0.2 }, { 0.4, 0.5, 0.1 }, 1);
  scene.Source = DiscLight({ 0.1, 0.0, 1.5 }, { 0.0, 0.0, -1.0 }, 0.3);
}

/// Each lamp shines towards the wall.
void LampsBesideAWall(ImageTestScene& scene)
{
  scene.Mesh.AddSheet({ 0.0, -0.8, -1.0 }, { 0.0, 1.4, 0.0 }, { 0.0, 0.0, 1.6 }, 0);
  scene.Source = LampOfFaces({ { { { -2.2, -0.4, -0.2 }, { -2.2, 0.4, -0.2 }, { -2.2, 0.0, 0.5 } } },
    { { { 2.2, -0.4, 0.0 }, { 2.2, 0.0, 0.7 }, { 2.2, 0.4, 0.0 } } } });
}

void MeshLampOverABall(ImageTestScene& scene)
{
  scene.Mesh.AddSphere({ 0.2, 0.1, 0.0 }, 0.5, 8, 0);
  scene.Mesh.AddSheet({ -1.5, -1.5, -1.2 }, { 3.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 }, 1);
  scene.Source = LampOfFaces({ { { { -0.4, -0.4, 2.1 }, { 0.4, 0.4, 2.0 }, { 0.4, -0.4, 2.2 } } },
    { { { -0.4, -0.4, 2.1 }, { -0.4, 0.4, 1.9 }, { 0.4, 0.4, 2.0 } } } });
}

void SunThroughSlats(ImageTestScene& scene)
{
  for (int strip = 0; strip < 4; ++strip)
  {
    scene.Mesh.AddSheet({ -0.9 + 0.5 * strip, -1.0, 0.4 }, { 0.3, 0.0, 0.0 }, { 0.0, 1.8, 0.0 }, strip);
  }
  scene.Source = SunLight({ 0.3, 0.1, -1.0 }, 0.05);
}

/// No cone holds what lies in the lamp: one holds a box around all.
void BallThatASheetTouches(ImageTestScene& scene)
{
  scene.Mesh.AddSheet({ -0.9, -0.8, 0.0 }, { 1.8, 0.0, 0.2 }, { 0.0, 1.5, 0.1 }, 0);
  scene.Source = SphereLight({ 0.2, 0.1, 0.25 }, 0.3);
}

struct ProvedScene
{
  const char* Name;
  std::function<void(ImageTestScene&)> Fill;
  bool InABox = false; ///< a cone holds all
};

ImageTestScene SceneOf(const ProvedScene& proved)
{
  ImageTestScene scene;
  proved.Fill(scene);
  scene.Source.Spectrum = { 1.0 };
  scene.Source = Prepared(scene.Source);
  scene.SetMedium({ 0.3 }, { 0.1 }, { -1.6, -1.6, -1.6 }, { 1.6, 1.6, 1.6 });
  // From inside the closed box something is to be seen too.
  scene.Eye = LookAt({ 0.9, -0.9, 0.4 }, { -0.3, 0.2, -0.2 }, 0.9);
  scene.SetSize(16, 14);
  scene.Options.NumberOfSteps = 24;
  scene.Options.MaximumHalvings = 1;
  scene.Options.NumberOfLightSamples = 4;
  scene.Options.NumberOfSurfaceLightSamples = 8;
  ConeProof proof;
  EXPECT_TRUE(ProveConeSet(scene.Mesh.View(), { scene.Source }, {}, {}, {}, proof));
  scene.Bounds = proof.Cones;
  return scene;
}

/// Cones that do not hold all of the shadow.
std::vector<Cone> Narrowed(std::vector<Cone> cones, double share)
{
  for (Cone& cone : cones)
  {
    cone.HalfAngle *= share;
    cone.BaseRadius *= share;
  }
  return cones;
}

/// By how many standard errors Guided with the cones differs, over all pixels, from Guided that asks everywhere.
double BiasInStandardErrors(ImageTestScene scene)
{
  constexpr int seeds = 8;
  scene.SetSize(8, 7);
  scene.Options.RelativeErrorGoal = 0.0; // as many samples everywhere
  scene.Options.MaximumSamples = 32;
  scene.Options.NumberOfSurfaceLightSamples = 0;
  const ConeHierarchy cones(scene.Bounds, scene.Fog.Bounds);
  std::vector<double> differences;
  double sum = 0.0;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    double difference = 0.0;
    for (const bool inside : { true, false })
    {
      scene.Options.Seed = static_cast<std::uint64_t>(inside ? seed : 1000 + seed);
      for (const float value : scene.Render(ScatteringMode::Guided, inside ? &cones : nullptr, nullptr).InScattering)
      {
        difference += inside ? value : -value;
      }
    }
    differences.push_back(difference);
    sum += difference / seeds;
  }
  double variance = 0.0;
  for (const double difference : differences)
  {
    variance += (difference - sum) * (difference - sum) / (seeds - 1.0);
  }
  return sum / std::sqrt(variance / seeds);
}

class ProvedImages : public testing::TestWithParam<ProvedScene>
{
};
} // namespace

TEST_P(ProvedImages, MediumHasTheBytesOfBruteForce)
{
  ImageTestScene scene = SceneOf(this->GetParam());
  const ScatteringImage truth = scene.Render(ScatteringMode::BruteForce);
  const ScatteringImage medium = scene.Render(ScatteringMode::Medium);
  EXPECT_EQ(medium.InScattering, truth.InScattering);
  EXPECT_EQ(medium.SurfaceRadiance, truth.SurfaceRadiance);
  EXPECT_EQ(medium.Radiance, truth.Radiance);
  EXPECT_TRUE(this->GetParam().InABox || medium.NumberOfOcclusionRays < truth.NumberOfOcclusionRays);
  scene.Bounds = Narrowed(scene.Bounds, 0.7);
  EXPECT_TRUE(this->GetParam().InABox || scene.Render(ScatteringMode::Medium).Radiance != truth.Radiance);
}

TEST_P(ProvedImages, GuidedHasNoBias)
{
  ImageTestScene scene = SceneOf(this->GetParam());
  EXPECT_LT(std::abs(BiasInStandardErrors(scene)), 4.0);
  scene.Bounds = Narrowed(scene.Bounds, 0.3);
  EXPECT_TRUE(this->GetParam().InABox || BiasInStandardErrors(scene) > 6.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProvedImages,
  testing::Values(ProvedScene{ "LampInClosedBox", LampInClosedBox }, ProvedScene{ "LampsBesideAWall", LampsBesideAWall },
    ProvedScene{ "MeshLampOverABall", MeshLampOverABall }, ProvedScene{ "SunThroughSlats", SunThroughSlats },
    ProvedScene{ "BallThatASheetTouches", BallThatASheetTouches, true }),
  [](const testing::TestParamInfo<ProvedScene>& info) { return std::string(info.param.Name); });
