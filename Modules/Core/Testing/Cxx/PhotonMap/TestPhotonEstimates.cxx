// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonEstimates.h"

#include "scRandom.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{

/// Photons of 1 W over their number, spread evenly over the cube [0, 1]^3, or over its floor.
StoredPhotons Spread(int count, bool onFloor)
{
  StoredPhotons photons;
  photons.NumberOfWavelengths = 1;
  for (int i = 0; i < count; ++i)
  {
    const auto u = SobolPoint(5, static_cast<std::uint32_t>(i));
    photons.Points.insert(photons.Points.end(), { u[0], u[1], onFloor ? 0.0 : u[2] });
    photons.Directions.insert(photons.Directions.end(), { 0.0f, 0.0f, -1.0f });
    photons.Normals.insert(photons.Normals.end(), { 0.0f, 0.0f, i % 2 ? 1.0f : -1.0f });
    photons.Powers.push_back(1.0f / static_cast<float>(count));
    photons.Bounces.push_back(1);
  }
  return photons;
}

double Gathered(const PhotonDiscs& discs, const Ray& ray, const RayInterval& part)
{
  double sum = 0.0;
  discs.ForEachPierced(ray, part, 0.0,
    [&](const PhotonDiscs::Pierced& pierced)
    { sum += pierced.Kernel * static_cast<double>(*discs.Photons().Power(pierced.Photon)); });
  return sum;
}
} // anonymous namespace

TEST(PhotonEstimates, ARayGathersTheColumnOfPhotons)
{
  PhotonDiscs discs;
  ASSERT_TRUE(discs.Build(Spread(60000, false), 64, {}));
  // 64 photons in a ball of 60000 in a cube.
  EXPECT_NEAR(discs.MeanRadius(), std::cbrt(64.0 * 3.0 / (4.0 * Pi * 60000.0)), 0.1 * 0.063);
  EXPECT_NEAR(Gathered(discs, { { 0.4, 0.5, -3.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 10.0 }), 1.0, 0.05);
  EXPECT_NEAR(Gathered(discs, { { 0.4, 0.5, -3.0 }, { 0.0, 0.0, 1.0 } }, { 3.25, 3.75 }), 0.5, 0.04);
  const Vector3 diagonal = Normalized({ 1.0, 1.0, 1.0 });
  EXPECT_NEAR(Gathered(discs, { {}, diagonal }, { 0.5, 1.2 }), 0.7, 0.04);
  EXPECT_EQ(Gathered(discs, { { 2.0, 0.5, -3.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 10.0 }), 0.0);
}

TEST(PhotonEstimates, DiscsAddUpToThePowerOfTheirPhotons)
{
  // The integral over parallel rays, whatever the radii.
  PhotonDiscs discs;
  ASSERT_TRUE(discs.Build(Spread(50, false), 8, {}));
  double sum = 0.0;
  const int rays = 400;
  for (int i = 0; i < rays * rays; ++i)
  {
    const double x = -1.0 + 3.0 * (i % rays + 0.5) / rays;
    const double y = -1.0 + 3.0 * (i / rays + 0.5) / rays;
    sum += Gathered(discs, { { x, y, -3.0 }, { 0.0, 0.0, 1.0 } }, { 0.0, 10.0 }) * 9.0 / rays / rays;
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(PhotonEstimates, IrradianceOfAFloorCountsTheSideThatIsAsked)
{
  const SurfacePhotons floor(Spread(20000, true), 400);
  SurfaceQuery query;
  floor.Estimate({ 0.5, 0.5, 0.0 }, { 0.0, 0.0, 1.0 }, query);
  EXPECT_NEAR(query.Irradiance[0], 0.5, 0.03) << "half of the photons lie on that side";
  EXPECT_GT(query.Variance, 0.0);
  floor.Estimate({ 0.5, 0.5, 0.0 }, { 1.0, 0.0, 0.0 }, query);
  EXPECT_EQ(query.Irradiance[0], 0.0) << "no surface faces that way";
}

TEST(PhotonEstimates, NoPhotonsIsNoLight)
{
  PhotonEstimates none;
  ASSERT_TRUE(PreparePhotonEstimates({}, {}, 0, {}, none));
  EXPECT_TRUE(none.Surface.Empty());
  EXPECT_TRUE(none.Volume.Empty());
  PhotonEstimates one;
  ASSERT_TRUE(PreparePhotonEstimates(Spread(1, true), Spread(1, false), 0, {}, one));
  SurfaceQuery query;
  one.Surface.Estimate({ 0.5, 0.5, 0.0 }, { 0.0, 0.0, 1.0 }, query);
  EXPECT_TRUE(std::isfinite(query.Irradiance[0]));
}
