// SPDX-License-Identifier: BSD-3-Clause
// Photons of several lights: shares by power, and the power that they stand for.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scLightShares.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace shadowcones;
using namespace testsupport;

namespace
{
ShadowVectorResult Trace(const TestMesh& mesh, const std::vector<Light>& lights, const ShadowVectorOptions& options)
{
  const OccluderScene scene(mesh.View());
  ShadowVectorResult result;
  EXPECT_TRUE(TraceShadowVectors(scene, lights, options, {}, result));
  return result;
}

/// A square sheet, x and y within -half..half, at z = 0.
TestMesh Square(double half)
{
  TestMesh mesh;
  mesh.AddSheet({ -half, -half, 0.0 }, { 2.0 * half, 0.0, 0.0 }, { 0.0, 2.0 * half, 0.0 }, 0);
  return mesh;
}

Light Point(double height, double intensity)
{
  Light light = PointLight({ 0.0, 0.0, height });
  light.Spectrum.assign(7, intensity);
  return light;
}

/// A square of side 2 half seen from above its middle.
double SolidAngle(double half, double height)
{
  return 4.0 * std::asin(half * half / (half * half + height * height));
}

/// Power of the blocked paths of one light.
double BlockedPower(const PhotonPaths& paths, int light)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < paths.Powers.size(); ++i)
  {
    sum += paths.States[i] && paths.LightIds[i] == light ? paths.Powers[i] : 0.0;
  }
  return sum;
}
} // anonymous namespace

TEST(LightShares, PhotonsAreSharedByPower)
{
  const LightShares shares({ 3.0, 0.0, 1.0 });
  EXPECT_EQ(shares.Counts(1024), (std::vector<vtkIdType>{ 768, 0, 256 }));
  std::vector<vtkIdType> dealt(3, 0);
  for (vtkIdType photon = 0; photon < 3000; ++photon)
  {
    EXPECT_EQ(shares.Counts(photon), dealt);
    const LightShares::LightPhoton place = shares.At(photon);
    EXPECT_EQ(place.Index, dealt[static_cast<std::size_t>(place.Light)]++);
    // Any stretch from the first photon on holds the same shares, to a photon.
    EXPECT_NEAR(static_cast<double>(dealt[0]), 0.75 * static_cast<double>(photon + 1), 1.0);
  }
}

TEST(LightShares, AFaintLightHasAnEighthOfAnEqualShare)
{
  const LightShares shares({ 1e6, 1.0 });
  EXPECT_NEAR(static_cast<double>(shares.Counts(100000)[1]), 100000.0 / 16.0 / (1.0 + 1.0 / 16.0), 100.0);
  EXPECT_EQ(LightShares({ 0.0, 0.0 }).Counts(2048), (std::vector<vtkIdType>{ 1024, 1024 }));
  EXPECT_EQ(LightShares({ 5.0 }).At(12345).Index, 12345);
}

TEST(LightShares, PowersAreThoseOfTheLights)
{
  // pi A L, 4 pi I, and E times the 2 x 2 that the square shows to a sun overhead: 8, 4 and 4 are as 2 to 1 to 1.
  Light disc = DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  disc.Spectrum.assign(7, 8.0 / (Pi * Pi * 0.25));
  const Light point = Point(3.0, 1.0 / Pi);
  Light sun = SunLight({ 0.0, 0.0, -1.0 }, 0.01);
  ShadowVectorOptions options;
  options.NumberOfPhotons = 4096;
  const ShadowVectorResult result = Trace(Square(1.0), { disc, point, sun }, options);
  ASSERT_EQ(result.PhotonsOfLights.size(), 3u);
  EXPECT_EQ(result.NumberOfPhotons, 4096);
  // The margin around the bounds adds a little to what the sun sees.
  EXPECT_NEAR(static_cast<double>(result.PhotonsOfLights[0]), 2048.0, 8.0);
  EXPECT_NEAR(static_cast<double>(result.PhotonsOfLights[1]), 1024.0, 8.0);
  EXPECT_NEAR(static_cast<double>(result.PhotonsOfLights[2]), 1024.0, 8.0);
}

TEST(LightShares, BlockedPowerIsIntensityTimesSolidAngle)
{
  ShadowVectorOptions options;
  options.NumberOfPhotons = 20000;
  const std::vector<Light> lights = { Point(1.0, 2.0), Point(3.0, 0.1), Point(2.0, 7.0) };
  const ShadowVectorResult result = Trace(Square(0.7), lights, options);
  EXPECT_NEAR(BlockedPower(result.Paths, 0), 2.0 * SolidAngle(0.7, 1.0), 2e-3 * 2.0 * SolidAngle(0.7, 1.0));
  EXPECT_NEAR(BlockedPower(result.Paths, 1), 0.1 * SolidAngle(0.7, 3.0), 2e-3 * 0.1 * SolidAngle(0.7, 3.0));
  EXPECT_NEAR(BlockedPower(result.Paths, 2), 7.0 * SolidAngle(0.7, 2.0), 2e-3 * 7.0 * SolidAngle(0.7, 2.0));
}

TEST(LightShares, EveryLightHasThePhotonsThatItHasAlone)
{
  const std::vector<Light> lights = { DiscLight({ -1.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.3),
    DiscLight({ 1.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5) };
  ShadowVectorOptions options;
  options.TargetNumberOfVectors = 1500;
  const ShadowVectorResult both = Trace(Square(0.7), lights, options);
  EXPECT_EQ(both.Vectors.LightIds.size(), both.Vectors.OccluderIds.size());
  EXPECT_EQ(both.Photons.LightIds.size(), both.Photons.OccluderIds.size());
  for (int light = 0; light < 2; ++light)
  {
    ShadowVectorOptions alone;
    alone.NumberOfPhotons = both.PhotonsOfLights[static_cast<std::size_t>(light)];
    const ShadowVectorResult one = Trace(Square(0.7), { lights[static_cast<std::size_t>(light)] }, alone);
    std::vector<double> points;
    std::vector<float> powers;
    for (std::size_t i = 0; i < both.Paths.LightIds.size(); ++i)
    {
      if (both.Paths.LightIds[i] == light)
      {
        points.insert(points.end(), both.Paths.Points.begin() + 3 * i, both.Paths.Points.begin() + 3 * i + 3);
        powers.push_back(both.Paths.Powers[i]);
      }
    }
    EXPECT_EQ(powers, one.Paths.Powers);
    // Where a lit path leaves the bounds of mesh and lights depends on the other light.
    EXPECT_EQ(points.size(), one.Paths.Points.size());
    EXPECT_EQ(one.Paths.LightIds, std::vector<int>(one.Paths.States.size(), 0));
  }
}

TEST(LightShares, PiecesTogetherAreTheWhole)
{
  const std::vector<Light> lights = { Point(1.0, 2.0), Point(3.0, 1.0) };
  for (const vtkIdType target : { 0, 700 })
  {
    ShadowVectorOptions options;
    options.NumberOfPhotons = 3001;
    options.TargetNumberOfVectors = target;
    const ShadowVectorResult whole = Trace(Square(0.7), lights, options);
    std::vector<int> lightIds;
    std::vector<float> powers;
    options.NumberOfPieces = 4;
    for (options.Piece = 0; options.Piece < 4; ++options.Piece)
    {
      const ShadowVectorResult piece = Trace(Square(0.7), lights, options);
      lightIds.insert(lightIds.end(), piece.Paths.LightIds.begin(), piece.Paths.LightIds.end());
      powers.insert(powers.end(), piece.Paths.Powers.begin(), piece.Paths.Powers.end());
      EXPECT_EQ(piece.PhotonsOfLights, whole.PhotonsOfLights);
    }
    EXPECT_EQ(lightIds, whole.Paths.LightIds);
    EXPECT_EQ(powers, whole.Paths.Powers);
  }
}
