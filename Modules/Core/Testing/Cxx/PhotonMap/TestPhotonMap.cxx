// SPDX-License-Identifier: BSD-3-Clause
#include "scDensityGrid.h"
#include "scPhotonMap.h"

#include "PointSource.h"
#include "TestLights.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{

Medium MediumOf(std::vector<double> sigmaS, std::vector<double> sigmaA, double half)
{
  Medium medium;
  medium.SigmaS = std::move(sigmaS);
  medium.SigmaA = std::move(sigmaA);
  medium.Bounds = { { -half, -half, -half }, { half, half, half } };
  return medium;
}

/// The inside of a cube around the origin.
TestMesh RoomOf(double half)
{
  TestMesh mesh;
  const double h = half;
  const double edge = 2.0 * half;
  mesh.AddSheet({ -h, -h, -h }, { edge, 0, 0 }, { 0, edge, 0 });
  mesh.AddSheet({ -h, -h, h }, { 0, edge, 0 }, { edge, 0, 0 });
  mesh.AddSheet({ -h, -h, -h }, { 0, edge, 0 }, { 0, 0, edge });
  mesh.AddSheet({ h, -h, -h }, { 0, 0, edge }, { 0, edge, 0 });
  mesh.AddSheet({ -h, -h, -h }, { 0, 0, edge }, { edge, 0, 0 });
  mesh.AddSheet({ -h, h, -h }, { edge, 0, 0 }, { 0, 0, edge });
  return mesh;
}

PhotonMap Traced(
  const TestMesh& mesh, const std::vector<Light>& lights, const Medium& medium, const PhotonMapOptions& options)
{
  const OccluderScene scene(mesh.View());
  PhotonMap map;
  EXPECT_TRUE(TracePhotonMap({ scene, lights, medium }, options, {}, map));
  return map;
}

double Sum(const StoredPhotons& photons, std::size_t wavelength)
{
  double sum = 0.0;
  for (vtkIdType id = 0; id < photons.Count(); ++id)
  {
    sum += photons.Power(id)[wavelength];
  }
  return sum;
}

/// The integral of the exact fluence over a shell, and of what photons say of it: what they scatter over SigmaS.
void ExpectFluence(double albedo, vtkIdType photons, const std::vector<double>& shells, double tolerance)
{
  PhotonMapOptions options;
  options.NumberOfPhotons = photons;
  options.StoreDirect = true;
  const double sigmaS = 0.5 * albedo;
  const double sigmaT = 0.5; // lengths are in mean free paths of 2
  const std::vector<Light> lights = { PointLight({}, { 1.0 / (4.0 * Pi) }) };
  const PhotonMap map = Traced({}, lights, MediumOf({ sigmaS }, { sigmaT - sigmaS }, 400.0), options);
  for (std::size_t s = 0; s + 1 < shells.size(); ++s)
  {
    double found = 0.0;
    for (vtkIdType id = 0; id < map.Volume.Count(); ++id)
    {
      const double r = sigmaT * Length(map.Volume.Point(id));
      found += r >= shells[s] && r < shells[s + 1] ? map.Volume.Power(id)[0] / sigmaS : 0.0;
    }
    const int steps = 100;
    double exact = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      const double r = shells[s] + (shells[s + 1] - shells[s]) * (i + 0.5) / steps;
      exact += 4.0 * Pi * r * r * ExactFluence(albedo, r) * (shells[s + 1] - shells[s]) / steps / sigmaT;
    }
    EXPECT_NEAR(found / exact, 1.0, tolerance) << "albedo " << albedo << ", mean free paths " << shells[s];
  }
}
} // anonymous namespace

TEST(PhotonMap, FluenceOfAPointSourceIsExact)
{
  // The printed table: 0.9575, 0.5254, 0.1725.
  EXPECT_NEAR(InverseDiffusionLength(0.5), 0.9575, 5e-5);
  EXPECT_NEAR(InverseDiffusionLength(0.9), 0.5254, 5e-5);
  EXPECT_NEAR(InverseDiffusionLength(0.99), 0.1725, 5e-5);
  ExpectFluence(0.5, 200000, { 0.0, 0.5, 1.0, 2.0, 3.5 }, 0.01);
  ExpectFluence(0.9, 50000, { 0.0, 0.5, 1.0, 2.0, 4.0, 7.0 }, 0.02);
  ExpectFluence(0.99, 8000, { 0.0, 1.0, 3.0, 8.0, 16.0 }, 0.04);
}

TEST(PhotonMap, EveryWavelengthSpreadsAsIfItWereAlone)
{
  // The mean square distance of collisions is 2 / ((1 - albedo) sigma_t^2), by the same theory.
  const std::vector<double> sigmaS = { 0.5, 1.2, 0.9 };
  const std::vector<double> sigmaA = { 0.5, 0.3, 2.1 };
  PhotonMapOptions options;
  options.NumberOfPhotons = 100000;
  options.StoreDirect = true;
  const std::vector<Light> lights = { PointLight({}, { 1.0, 2.0, 0.5 }) };
  const PhotonMap map = Traced({}, lights, MediumOf(sigmaS, sigmaA, 200.0), options);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double emitted = 4.0 * Pi * lights[0].Spectrum[k];
    const double sigmaT = sigmaS[k] + sigmaA[k];
    const double albedo = sigmaS[k] / sigmaT;
    double sum = 0.0;
    double squares = 0.0;
    double most = 0.0;
    for (vtkIdType id = 0; id < map.Volume.Count(); ++id)
    {
      const double power = map.Volume.Power(id)[k];
      sum += power;
      squares += power * Dot(map.Volume.Point(id), map.Volume.Point(id));
      most = std::max(most, power);
    }
    EXPECT_NEAR(map.Account.Emitted[k] / emitted, 1.0, 1e-9);
    EXPECT_NEAR(map.Account.AbsorbedByMedium[k] / emitted, 1.0, 0.01) << k;
    EXPECT_NEAR(sum / (emitted * albedo / (1.0 - albedo)), 1.0, 0.015) << k;
    EXPECT_NEAR(squares / sum * (1.0 - albedo) * sigmaT * sigmaT / 2.0, 1.0, 0.04) << k;
    EXPECT_LT(most, 20.0 * emitted / static_cast<double>(options.NumberOfPhotons)) << k << ": weights are bounded";
  }
}

TEST(PhotonMap, EmittedIsAbsorbedOrEscapes)
{
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, -1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  mesh.AddSheet({ -0.3, -0.3, 0.1 }, { 0.5, 0.0, 0.2 }, { 0.0, 0.5, 0.0 });
  Medium medium = MediumOf({ 0.5, 3.0, 0.0, 1.0 }, { 0.2, 0.0, 0.0, 2.0 }, 1.0);
  medium.Phase = { PhaseFunctionKind::HenyeyGreenstein, {}, 0.6 };
  const std::vector<double> spectrum = { 1.0, 2.0, 3.0, 0.5 };
  const std::vector<Light> lights = { DiscLight({ 0.0, 0.0, 0.9 }, { 0.0, 0.0, -1.0 }, 0.2, spectrum),
    SphereLight({ 0.5, 0.4, 0.0 }, 0.1, spectrum) };
  PhotonMapOptions options;
  options.NumberOfPhotons = 200000;
  options.Reflectance = 0.7;
  for (const bool dense : { false, true })
  {
    DensityGrid density;
    density.Dimensions = { { 2, 3, 1 } };
    density.Values = { 0.5f, 0.0f, 1.0f, 3.0f, 0.2f, 1.0f };
    density.Origin = { -1.0, -1.0, 0.0 };
    density.Axes = { { { 2.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
    ASSERT_EQ(PrepareDensityGrid(density), nullptr);
    medium.Density = dense ? &density : nullptr;
    const PhotonAccount account = Traced(mesh, lights, medium, options).Account;
    for (std::size_t k = 0; k < spectrum.size(); ++k)
    {
      const double emitted = Pi * spectrum[k] * Pi * (0.2 * 0.2 + 4.0 * 0.1 * 0.1);
      EXPECT_NEAR(account.Emitted[k] / emitted, 1.0, 1e-6);
      const double gone = account.AbsorbedBySurfaces[k] + account.AbsorbedByMedium[k] + account.Escaped[k];
      EXPECT_NEAR(gone / emitted, 1.0, 0.005) << "wavelength " << k << (dense ? " in a density" : "");
      EXPECT_EQ(account.CutOff[k], 0.0);
    }
  }
}

TEST(PhotonMap, ADensityTakesFromStraightLightWhatItsIntegralSays)
{
  DensityGrid density;
  density.Dimensions = { { 3, 1, 1 } };
  density.Values = { 0.0f, 4.0f, 1.0f };
  density.Origin = { -1.0, 0.0, 0.0 };
  density.Axes = { { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  ASSERT_EQ(PrepareDensityGrid(density), nullptr);
  Medium medium = MediumOf({ 0.2, 0.0, 0.05 }, { 0.1, 0.4, 0.3 }, 1.0);
  medium.Density = &density;
  Light sun;
  sun.Shape = LightShape::Sun;
  sun.Normal = { 1.0, 0.0, 0.0 };
  sun.Radius = 0.0;
  sun.Spectrum = { 1.0, 1.0, 1.0 };
  PhotonMapOptions options;
  options.NumberOfPhotons = 200000;
  options.MaximumBounces = 0;
  const PhotonAccount account = Traced({}, { Prepared(sun) }, medium, options).Account;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // Optical depth: sigma_t times (2 + 2.5), the trapezia under the density. A rim of 0.1 per mille is aimed at in vain.
    const double passes = std::exp(-4.5 * (medium.SigmaS[k] + medium.SigmaA[k]));
    EXPECT_NEAR(account.Escaped[k] / account.Emitted[k], passes, 0.005) << k;
  }
}

TEST(PhotonMap, LightInAClosedRoomIsAGeometricSeries)
{
  const double reflectance = 0.8;
  PhotonMapOptions options;
  options.NumberOfPhotons = 100000;
  options.Reflectance = reflectance;
  const std::vector<Light> lights = { PointLight({ 0.2, -0.3, 0.1 }, { 2.0 }) };
  const PhotonMap map = Traced(RoomOf(1.0), lights, MediumOf({ 0.0 }, { 0.0 }, 1.0), options);
  const double emitted = 4.0 * Pi * 2.0;
  EXPECT_NEAR(Sum(map.Surface, 0) / (emitted * reflectance / (1.0 - reflectance)), 1.0, 0.01);
  EXPECT_NEAR(map.Account.AbsorbedBySurfaces[0] / emitted, 1.0, 0.01);
  EXPECT_LT(map.Account.Escaped[0] / emitted, 1e-4) << "walls leak";
  EXPECT_EQ(map.Volume.Count(), 0);
  for (vtkIdType id = 0; id < map.Surface.Count(); id += 97)
  {
    EXPECT_GE(map.Surface.Bounces[static_cast<std::size_t>(id)], 1) << "straight light is not stored";
    EXPECT_LT(Dot(map.Surface.Normal(id), map.Surface.Direction(id)), 0.0);
    EXPECT_LT(Dot(map.Surface.Normal(id), map.Surface.Point(id)), 0.0) << "normals point into the room";
  }
}

TEST(PhotonMap, BouncesEndAndTheRestIsCutOff)
{
  PhotonMapOptions options;
  options.NumberOfPhotons = 20000;
  options.Reflectance = 1.0;
  options.MaximumBounces = 3;
  const std::vector<Light> lights = { PointLight({}, { 1.0 }) };
  const PhotonMap map = Traced(RoomOf(1.0), lights, MediumOf({ 0.0 }, { 0.0 }, 1.0), options);
  EXPECT_EQ(map.Surface.Count(), 3 * options.NumberOfPhotons);
  EXPECT_NEAR(map.Account.CutOff[0] / map.Account.Emitted[0], 1.0, 1e-3);
}

TEST(PhotonMap, PiecesMakeTheWhole)
{
  PhotonMapOptions options;
  options.NumberOfPhotons = 3001;
  const std::vector<Light> lights = { PointLight({}, { 1.0, 1.0 }), SphereLight({ 0.3, 0.0, 0.0 }, 0.1, { 2.0, 1.0 }) };
  const Medium medium = MediumOf({ 1.0, 2.0 }, { 0.0, 0.5 }, 1.0);
  const PhotonMap whole = Traced(RoomOf(1.0), lights, medium, options);
  options.NumberOfPieces = 3;
  StoredPhotons joined;
  for (options.Piece = 0; options.Piece < 3; ++options.Piece)
  {
    joined.Append(Traced(RoomOf(1.0), lights, medium, options).Volume);
  }
  EXPECT_GT(joined.Count(), 1000);
  EXPECT_EQ(joined.Points, whole.Volume.Points);
  EXPECT_EQ(joined.Powers, whole.Volume.Powers);
}

TEST(PhotonMap, TooManyPhotonsAreRefused)
{
  PhotonMapOptions options;
  options.NumberOfPhotons = 1000;
  options.MaximumStored = 500;
  const std::vector<Light> lights = { PointLight({}, { 1.0 }) };
  const OccluderScene scene(TriangleMeshView{});
  const Medium medium = MediumOf({ 5.0 }, { 0.0 }, 1.0);
  PhotonMap map;
  EXPECT_THROW(TracePhotonMap({ scene, lights, medium }, options, {}, map), std::length_error);
}
