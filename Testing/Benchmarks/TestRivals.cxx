// SPDX-License-Identifier: BSD-3-Clause
// Every rival against closed forms: a square plate over a point, and over a square light (design: parallel rectangles).
#include "Rivals/ConesAround.h"
#include "Rivals/DeepShadowMaps.h"
#include "Rivals/LampRays.h"
#include "Rivals/ProjectedSolids.h"
#include "Rivals/RivalMarch.h"
#include "Rivals/RivalReference.h"
#include "Rivals/ShadowBuffers.h"
#include "Rivals/ShadowPhotonMap.h"
#include "Rivals/VisibilityOctree.h"
#include "Rivals/VisibilityVoxels.h"

#include "scReference.h"

#include "TestLights.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double LightHeight = 4.0;
constexpr double PlateHeight = 2.0;
constexpr double HalfPlate = 0.5;
constexpr double HalfLight = 0.4;

/// A square plate at y = 2 across the axis; the light is at y = 4, the medium x, z in +-2, y in 0..3.
struct PlateScene
{
  TestMesh Mesh;
  Light Lamp;
  Box Bounds{ { -2.0, 0.0, -2.0 }, { 2.0, 3.0, 2.0 } };
  std::unique_ptr<OccluderScene> Rays;

  explicit PlateScene(bool square)
  {
    const double h = HalfPlate;
    this->Mesh.Points = { -h, PlateHeight, -h, h, PlateHeight, -h, h, PlateHeight, h, -h, PlateHeight, h };
    this->Mesh.Triangles = { 0, 1, 2, 0, 2, 3 };
    this->Lamp = square ? Light() : PointLight({ 0.0, LightHeight, 0.0 }, { 1.0 });
    if (square)
    {
      this->Lamp.Shape = LightShape::Rectangle;
      this->Lamp.Center = { 0.0, LightHeight, 0.0 };
      this->Lamp.Normal = { 0.0, -1.0, 0.0 };
      this->Lamp.AxisU = { HalfLight, 0.0, 0.0 };
      this->Lamp.AxisV = { 0.0, 0.0, HalfLight };
      this->Lamp.Spectrum = { 1.0 };
      this->Lamp = Prepared(this->Lamp);
    }
    this->Rays = std::make_unique<OccluderScene>(this->Mesh.View());
  }
  /// Where the square light shows the plate's outline: its image through a point at height y, of the light's own square.
  double BlockedShare(const Vector3& x) const
  {
    if (x.Y >= PlateHeight)
    {
      return 0.0;
    }
    const double s = (LightHeight - x.Y) / (PlateHeight - x.Y);
    const auto covered = [s](double place)
    {
      const double low = std::max(-HalfLight, place + s * (-HalfPlate - place));
      const double high = std::min(HalfLight, place + s * (HalfPlate - place));
      return std::max(0.0, high - low) / (2.0 * HalfLight);
    };
    return covered(x.X) * covered(x.Z);
  }
};

RivalRay LevelRay(double y, double z, int cells)
{
  RivalRay ray;
  ray.Line = { { -2.0, y, z }, { 1.0, 0.0, 0.0 } };
  for (int k = 0; k <= cells; ++k)
  {
    ray.Cuts.push_back(4.0 * k / cells);
  }
  for (int k = 0; k < cells; ++k)
  {
    ray.Places.push_back(4.0 * (k + 0.5) / cells);
  }
  ray.Key = 7;
  return ray;
}

double BlockedLength(const Rival& rival, const RivalRay& ray)
{
  std::vector<double> blocked;
  rival.BlockedAlong(ray, blocked);
  double sum = 0.0;
  for (std::size_t k = 0; k < blocked.size(); ++k)
  {
    sum += blocked[k] * (ray.Cuts[k + 1] - ray.Cuts[k]);
  }
  return sum;
}

struct Candidate
{
  const char* Name;
  std::function<std::unique_ptr<Rival>(const PlateScene&)> Make;
  double Hard; ///< largest error of the length in shadow, of 1.5, under the point light
  double Soft; ///< root of the mean square error of the share under the square light
  double Elsewhere = 0.0; ///< largest length in shadow of rays that are lit
};

template <class Type, class Options>
std::function<std::unique_ptr<Rival>(const PlateScene&)> OfMesh(const Options& options)
{
  return [options](const PlateScene& s) { return std::make_unique<Type>(s.Mesh.View(), s.Lamp, options); };
}

/// Cell widths and noise bound the errors: a ray of 256 cells alone makes one of 0.016.
const std::vector<Candidate>& Candidates()
{
  static const Cone cone = ConeAroundBox({ { -2.0, 0.0, -2.0 }, { 2.0, 2.5, 2.0 } });
  static const ConeHierarchy cones({ cone }, { { -2.0, 0.0, -2.0 }, { 2.0, 3.0, 2.0 } });
  static const std::vector<Candidate> all = {
    { "shadow buffers", OfMesh<ShadowBuffers>(ShadowBufferOptions{ 32, 128 }), 0.02, 0.04 },
    { "one buffer, soft", OfMesh<ShadowBuffers>(ShadowBufferOptions{ 1, 128, 1e-3, true }), 0.02, 0.25 },
    { "deep shadow maps", OfMesh<DeepShadowMaps>(DeepShadowMapOptions{ 32, 40, 4, 0.02 }), 0.04, 0.04 },
    { "projected solids",
      [](const PlateScene& s) { return std::make_unique<ProjectedSolids>(s.Mesh.View(), s.Lamp, s.Bounds, 16); }, 1e-9, 0.04 },
    { "voxels", [](const PlateScene& s) { return std::make_unique<VisibilityVoxels>(*s.Rays, s.Lamp, s.Bounds, 25, 8); }, 0.06, 0.05 },
    { "octree",
      [](const PlateScene& s)
      { return std::make_unique<VisibilityOctree>(*s.Rays, s.Lamp, s.Bounds, VisibilityOctreeOptions{ 2, 5, 0.1, 16 }); },
      0.06, 0.04 },
    { "shadow photons",
      [](const PlateScene& s)
      { return std::make_unique<ShadowPhotonMap>(*s.Rays, s.Lamp, s.Bounds, ShadowPhotonOptions{ 8000, 4, 16, 0 }); }, 0.12, 0.12, 0.15 },
    { "shadow photons and rays",
      [](const PlateScene& s)
      { return std::make_unique<ShadowPhotonMap>(*s.Rays, s.Lamp, s.Bounds, ShadowPhotonOptions{ 3000, 4, 16, 32 }); }, 0.02, 0.04 },
    { "rays", [](const PlateScene& s) { return std::make_unique<LampRays>(*s.Rays, s.Lamp, 32); }, 0.02, 0.04 },
    { "cones with buffers inside",
      [](const PlateScene& s)
      {
        return std::make_unique<ConesAround>(
          cones, std::make_unique<ShadowBuffers>(s.Mesh.View(), s.Lamp, ShadowBufferOptions{ 32, 128 }));
      },
      0.02, 0.04 } };
  return all;
}
} // namespace

TEST(Rivals, FindTheHardShadowOfAPlate)
{
  const PlateScene scene(false);
  const RivalRay behind = LevelRay(1.0, 0.1, 256);
  const RivalRay before = LevelRay(2.3, 0.1, 32);
  const RivalRay beside = LevelRay(1.0, 0.9, 32);
  for (const Candidate& candidate : Candidates())
  {
    const std::unique_ptr<Rival> rival = candidate.Make(scene);
    EXPECT_NEAR(BlockedLength(*rival, behind), 2.0 * HalfPlate * 1.5, candidate.Hard) << candidate.Name;
    EXPECT_LE(BlockedLength(*rival, before), candidate.Elsewhere) << candidate.Name;
    EXPECT_LE(BlockedLength(*rival, beside), candidate.Elsewhere) << candidate.Name;
    EXPECT_GT(rival->Memory(), 0) << candidate.Name;
  }
}

TEST(Rivals, FindTheSoftShadowOfAPlate)
{
  const PlateScene scene(true);
  const RivalRay ray = LevelRay(0.7, 0.3, 128);
  for (const Candidate& candidate : Candidates())
  {
    std::vector<double> blocked;
    candidate.Make(scene)->BlockedAlong(ray, blocked);
    double squares = 0.0;
    for (std::size_t k = 0; k < blocked.size(); ++k)
    {
      squares += std::pow(blocked[k] - scene.BlockedShare(ray.Place(k)), 2);
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(blocked.size())), candidate.Soft) << candidate.Name;
  }
}

// A single buffer has no penumbra: a point is as good as the light to it, and only more points make it right.
TEST(Rivals, ManyBuffersCloseInOnAnAreaLight)
{
  const PlateScene scene(true);
  const RivalRay ray = LevelRay(0.7, 0.3, 128);
  double before = HUGE_VAL;
  for (const int points : { 1, 4, 16, 64 })
  {
    const ShadowBuffers buffers(scene.Mesh.View(), scene.Lamp, { points, 128 });
    std::vector<double> blocked;
    buffers.BlockedAlong(ray, blocked);
    double error = 0.0;
    for (std::size_t k = 0; k < blocked.size(); ++k)
    {
      error += std::fabs(blocked[k] - scene.BlockedShare(ray.Place(k))) / static_cast<double>(blocked.size());
    }
    EXPECT_LT(error, 0.8 * before) << points;
    before = error;
  }
}

TEST(Rivals, DeepShadowMapsStayWithinTheirTolerance)
{
  std::vector<float> depths;
  RandomStream random(1, 1);
  for (int k = 0; k < 12; ++k)
  {
    depths.push_back(static_cast<float>(1.0 + random.Next()));
  }
  depths[4] = depths[3];
  std::sort(depths.begin(), depths.end());
  for (const double tolerance : { 0.01, 0.1, 0.3 })
  {
    std::vector<DepthNode> nodes;
    CompressSteps(depths, 16, tolerance, nodes);
    EXPECT_LE(nodes.size(), 2u * depths.size() + 1u);
    for (int k = 0; k < 400; ++k)
    {
      const auto depth = static_cast<float>(0.9 + 1.2 * random.Next());
      const auto steps = std::upper_bound(depths.begin(), depths.end(), depth) - depths.begin();
      EXPECT_NEAR(BlockedAtDepth(nodes.data(), nodes.data() + nodes.size(), depth), steps / 16.0, tolerance + 1e-3) << depth;
    }
  }
  std::vector<DepthNode> coarse;
  CompressSteps(depths, 16, 0.3, coarse);
  EXPECT_LT(coarse.size(), 8u);
}

// Light of a point, thin medium: sigma_s I / (4 pi D) (atan(b / D) - atan(a / D)) of every lit part of a ray at distance D.
TEST(Rivals, MarcherReferenceAndPathTracingGiveTheAirlightOfAPoint)
{
  const PlateScene scene(false);
  Medium medium;
  medium.SigmaS = { 1e-6 };
  medium.SigmaA = { 0.0 };
  medium.Bounds = scene.Bounds;
  Camera camera;
  camera.Position = { 0.03, 1.0, 5.0 };
  camera.Parallel = true;
  camera.HalfHeight = 0.001;
  const RivalMarch march({ *scene.Rays, scene.Lamp, medium, camera }, 1, 1, 256);
  const double d = std::hypot(3.0, 0.03);
  const double length = std::atan(2.0 / d) - std::atan(0.75 / d);
  const double truth = 2.0 * 1e-6 / (4.0 * testsupport::Pi * d) * length;
  ASSERT_NEAR(march.Lit()[0], 2.0 * 1e-6 / (4.0 * testsupport::Pi * d) * std::atan(2.0 / d), 1e-3 * truth);
  std::vector<double> image;
  march.Render(ProjectedSolids(scene.Mesh.View(), scene.Lamp, scene.Bounds, 1), image);
  EXPECT_NEAR(image[0], truth, 2e-3 * truth);
  march.Render(LampRays(*scene.Rays, scene.Lamp, 1), image);
  EXPECT_NEAR(image[0], truth, 0.01 * truth);
  const HiddenLight hidden = ReferenceHiddenLight(march, ReferenceScene(scene.Mesh.View()), 0, 4096);
  EXPECT_NEAR(march.Lit()[0] - hidden.Mean, truth, 2e-3 * truth);
  EXPECT_LT(hidden.StandardError, 2e-3 * truth);
  for (const bool evenAngle : { false, true })
  {
    march.TracePaths(20000, evenAngle, image);
    EXPECT_NEAR(image[0], truth, 0.03 * truth) << evenAngle;
  }
}
