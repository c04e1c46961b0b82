// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonEstimates.h"

#include "scRandom.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

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

/// A medium that takes nothing away.
Medium ClearMedium()
{
  Medium medium;
  medium.SigmaS = { 0.0 };
  medium.SigmaA = { 0.0 };
  medium.Bounds = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  return medium;
}

/// The power per area around a ray, of a part of it that ends at surfaces which face it, in a medium that scatters evenly.
double Gathered(const PhotonDiscs& discs, const Ray& ray, const RayInterval& part, const Medium& medium = ClearMedium(),
  const std::function<double(double)>& depthAlong = {})
{
  DiscPacket packet(medium);
  packet.Clear(discs.Origin());
  const Ray moved{ ray.Origin + part.Begin * ray.Direction, ray.Direction };
  packet.Add({ moved, { 0.0, part.End - part.Begin }, -ray.Direction }, depthAlong);
  discs.Gather(packet);
  return 4.0 * Pi * packet.Radiance(0, 0);
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

TEST(PhotonEstimates, PhaseFunctionsWeighThePhotons)
{
  // Photons fly down; light goes back along the ray, so that the cosine is that between the ray and up.
  PhotonDiscs discs;
  ASSERT_TRUE(discs.Build(Spread(20000, false), 64, {}));
  const RayInterval part{ 3.2, 3.6 };
  for (const double slant : { 0.0, 0.4, 1.2 })
  {
    const Vector3 along = Normalized({ slant, 0.0, 1.0 });
    const Ray ray{ Vector3{ 0.5, 0.5, 0.5 } - 3.4 * along, along };
    const double cosine = along.Z;
    const double evenly = Gathered(discs, ray, part);
    ASSERT_GT(evenly, 0.1);
    Medium medium = ClearMedium();
    medium.Phase.Kind = PhaseFunctionKind::Rayleigh;
    EXPECT_NEAR(Gathered(discs, ray, part, medium) / evenly, 0.75 * (1.0 + cosine * cosine), 1e-5);
    for (const double g : { 0.6, -0.3 })
    {
      medium.Phase = { PhaseFunctionKind::HenyeyGreenstein, {}, g };
      EXPECT_NEAR(Gathered(discs, ray, part, medium) / evenly, (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5), 1e-5);
    }
  }
}

TEST(PhotonEstimates, ADensityTakesFromTheRayWhatItsIntegralSays)
{
  // Depths grow as the square of the way: they are read from a table of the ray. All photons lie in a plane across it.
  StoredPhotons plane = Spread(20000, true);
  PhotonDiscs discs;
  ASSERT_TRUE(discs.Build(plane, 64, {}));
  const Ray ray{ { 0.5, 0.5, -2.0 }, { 0.0, 0.0, 1.0 } };
  const double clear = Gathered(discs, ray, { 0.0, 4.0 });
  ASSERT_GT(clear, 0.5);
  Medium medium = ClearMedium();
  medium.SigmaA = { 0.3 };
  EXPECT_NEAR(Gathered(discs, ray, { 0.0, 4.0 }, medium) / clear, std::exp(-0.3 * 2.0), 1e-4) << "homogeneous";
  const DensityGrid density;
  medium.Density = &density;
  EXPECT_NEAR(Gathered(discs, ray, { 0.0, 4.0 }, medium, [](double t) { return t * t; }) / clear, std::exp(-0.3 * 4.0), 2e-3);
}

TEST(PhotonEstimates, IrradianceOfAFloorCountsTheSideThatIsAsked)
{
  SurfacePhotons floor;
  ASSERT_TRUE(floor.Build(Spread(20000, true), 400, {}));
  SurfacePacket packet;
  packet.Add({ 0.5, 0.5, 0.0 }, { 0.0, 0.0, 1.0 });
  packet.Add({ 0.5, 0.5, 0.0 }, { 1.0, 0.0, 0.0 });
  floor.Estimate(packet);
  EXPECT_NEAR(packet.Irradiance(0, 0), 0.5, 0.03) << "half of the photons lie on that side";
  EXPECT_GT(packet.Variance(0), 0.0);
  EXPECT_EQ(packet.Irradiance(1, 0), 0.0) << "no surface faces that way";
}

// Rays and points that ask together find what each finds alone, to the bit: images do not depend on their tiles.
TEST(PhotonEstimates, TogetherAsAlone)
{
  PhotonDiscs discs;
  ASSERT_TRUE(discs.Build(Spread(5000, false), 16, {}));
  SurfacePhotons floor;
  ASSERT_TRUE(floor.Build(Spread(5000, true), 40, {}));
  const Medium medium = ClearMedium();
  DiscPacket rays(medium);
  DiscPacket one(medium);
  rays.Clear(discs.Origin());
  SurfacePacket points;
  SurfacePacket point;
  std::vector<GatheringRay> all;
  for (int k = 0; k < 37; ++k)
  {
    const Vector3 to{ 0.02 * k, 0.9 - 0.01 * k, 0.5 };
    const Vector3 from{ 0.1, 0.2, -4.0 };
    all.push_back({ { from, Normalized(to - from) }, { 3.9, 4.0 + 0.02 * k }, k % 2 ? Vector3{ 0.0, 0.6, -0.8 } : Vector3{} });
    rays.Add(all.back(), {});
    points.Add({ to.X, to.Y, 0.0 }, { 0.0, 0.0, 1.0 });
  }
  discs.Gather(rays);
  floor.Estimate(points);
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    one.Clear(discs.Origin());
    one.Add(all[k], {});
    discs.Gather(one);
    EXPECT_EQ(one.Radiance(0, 0), rays.Radiance(k, 0)) << k;
    EXPECT_EQ(one.Variance(0), rays.Variance(k)) << k;
    point.Clear();
    point.Add({ 0.02 * static_cast<double>(k), 0.9 - 0.01 * static_cast<double>(k), 0.0 }, { 0.0, 0.0, 1.0 });
    floor.Estimate(point);
    EXPECT_EQ(point.Irradiance(0, 0), points.Irradiance(k, 0)) << k;
  }
}

TEST(PhotonEstimates, NoPhotonsIsNoLight)
{
  PhotonEstimates none;
  ASSERT_TRUE(PreparePhotonEstimates({}, {}, 0, 1, {}, none));
  EXPECT_TRUE(none.Surface.Empty());
  EXPECT_TRUE(none.Volume.Empty());
  PhotonEstimates one;
  ASSERT_TRUE(PreparePhotonEstimates(Spread(1, true), Spread(1, false), 0, 4, {}, one));
  SurfacePacket packet;
  packet.Add({ 0.5, 0.5, 0.0 }, { 0.0, 0.0, 1.0 });
  one.Surface.Estimate(packet);
  EXPECT_TRUE(std::isfinite(packet.Irradiance(0, 0)));
}
