// SPDX-License-Identifier: BSD-3-Clause
// Photons aimed at occluders that the bounds of all would hide: counts, powers by closed forms, pieces.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scAimedBoxes.h"
#include "scPhotonBundles.h"
#include "scScarceOccluders.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace
{
using namespace shadowcones;
using namespace testsupport;

ShadowVectorOptions Aimed(vtkIdType target, int minimum = 32)
{
  ShadowVectorOptions options;
  options.TargetNumberOfVectors = target;
  options.MinimumVectorsPerOccluder = minimum;
  options.Storage = VectorStorage::HitPoint;
  return options;
}

ShadowVectorResult Trace(const TestMesh& mesh, const std::vector<Light>& lights, const ShadowVectorOptions& options)
{
  const OccluderScene scene(mesh.View());
  ShadowVectorResult result;
  EXPECT_TRUE(TraceShadowVectors(scene, lights, options, {}, result));
  return result;
}

std::map<int, vtkIdType> VectorsOf(const ShadowVectorResult& result, int light = 0)
{
  std::map<int, vtkIdType> counts;
  for (std::size_t i = 0; i < result.Vectors.OccluderIds.size(); ++i)
  {
    counts[result.Vectors.OccluderIds[i]] += result.Vectors.LightIds[i] == light ? 1 : 0;
  }
  return counts;
}

/// Flux that paths bring to an occluder that they meet first; -1: to all.
double PowerOn(const ShadowVectorResult& result, int occluder)
{
  double power = 0.0;
  for (std::size_t i = 0; i < result.Paths.Powers.size(); ++i)
  {
    const bool counts = occluder < 0 ? result.Paths.States[i] == 1 : result.Paths.OccluderIds[i] == occluder;
    power += counts ? result.Paths.Powers[i] : 0.0;
  }
  return power;
}

Light Sun()
{
  Light light;
  light.Shape = LightShape::Sun;
  light.Normal = { 0.0, 0.0, -1.0 };
  light.Radius = 0.00465;
  light.Spectrum = { 1000.0 };
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}

/// Two houses so far apart that hardly any photon aimed at both meets one.
TestMesh FarHouses(double distance)
{
  TestMesh mesh;
  mesh.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 10.0, 8.0 }, 0);
  mesh.AddBox({ distance, distance, 0.0 }, { distance + 10.0, distance + 10.0, 8.0 }, 1);
  return mesh;
}
} // namespace

TEST(ScarceOccluders, ASignBesideAHallHasItsVectorsAndItsFlux)
{
  for (const double side : { 5.0, 0.5, 0.05 })
  {
    TestMesh mesh;
    mesh.AddBox({ 0.0, 0.0, 0.0 }, { 100.0, 60.0, 20.0 }, 0);
    mesh.AddSheet({ 140.0, 30.0, 3.0 }, { side, 0.0, 0.0 }, { 0.0, side, 0.0 }, 1);
    const ShadowVectorResult result = Trace(mesh, { Sun() }, Aimed(5800));
    std::map<int, vtkIdType> vectors = VectorsOf(result);
    EXPECT_GE(vectors[1], 32) << side;
    EXPECT_GE(vectors[0], 5000) << side;
    EXPECT_EQ(result.NumberOfScarce, 0);
    EXPECT_NEAR(PowerOn(result, 1) / (1000.0 * side * side), 1.0, 0.05) << "irradiance times area, " << side;
    EXPECT_NEAR(PowerOn(result, 0) / (1000.0 * 6000.0), 1.0, 0.02) << side;
  }
}

TEST(ScarceOccluders, PowersOfManySeedsAverageToTheFlux)
{
  // A disc of light, and a small square far to its side: cosine laws on both faces, nothing in between.
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0);
  mesh.AddSheet({ 8.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.1, 0.0 }, 1);
  const double height = 4.0;
  const Light light = DiscLight({ 0.0, 0.0, height }, { 0.0, 0.0, -1.0 }, 0.1);
  const double area = Pi * 0.01;
  const double square = 0.01;
  const double distance2 = 8.05 * 8.05 + 0.05 * 0.05 + height * height;
  const double exact = light.Spectrum[0] * area * square * height * height / (distance2 * distance2);
  double sum = 0.0;
  constexpr int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    ShadowVectorOptions options = Aimed(1000);
    options.Seed = static_cast<std::uint64_t>(seed);
    const ShadowVectorResult result = Trace(mesh, { light }, options);
    EXPECT_GE(VectorsOf(result)[1], 32);
    sum += PowerOn(result, 1) / exact;
  }
  EXPECT_NEAR(sum / seeds, 1.0, 0.01) << "stopping at the 32nd vector would show";
}

TEST(ScarceOccluders, HousesFarApartShareThePhotons)
{
  for (const double distance : { 3e3, 1e4, 1e6 })
  {
    const ShadowVectorResult result = Trace(FarHouses(distance), { Sun() }, Aimed(5800));
    std::map<int, vtkIdType> vectors = VectorsOf(result);
    EXPECT_GE(vectors[0], 2900) << distance;
    EXPECT_GE(vectors[1], 2900) << distance;
    EXPECT_LT(result.NumberOfPhotons, 40000) << distance;
    EXPECT_NEAR(PowerOn(result, -1) / (1000.0 * 200.0), 1.0, 0.02) << distance;
    const auto lit = std::count(result.Paths.States.begin(), result.Paths.States.end(), 0);
    EXPECT_GT(lit, result.NumberOfPhotons / 20) << "some light passes beside them";
  }
}

TEST(ScarceOccluders, TheyAreTakenOutOfTheNumberOfPhotons)
{
  ShadowVectorOptions options = Aimed(0);
  options.NumberOfPhotons = 20000;
  const ShadowVectorResult result = Trace(FarHouses(200.0), { Sun() }, options);
  EXPECT_EQ(result.NumberOfPhotons, 20000);
  EXPECT_GT(result.NumberOfAimedPhotons, 0);
  EXPECT_LE(result.NumberOfAimedPhotons, 18000);
  EXPECT_GE(VectorsOf(result)[0], 32);
  EXPECT_GE(VectorsOf(result)[1], 32);
}

TEST(ScarceOccluders, ThePhotonsThatAreNeededAreEnough)
{
  ShadowVectorOptions options = Aimed(0);
  TestMesh mesh = FarHouses(200.0);
  mesh.AddSheet({ 100.0, 0.0, 2.0 }, { 0.05, 0.0, 0.0 }, { 0.0, 30.0, 0.0 }, 2); // far thinner than the margins around it
  options.NumberOfPhotons = 600;
  const ShadowVectorResult few = Trace(mesh, { Sun() }, options);
  ASSERT_GT(few.NumberOfScarce, 0);
  ASSERT_GT(few.PhotonsForScarce, options.NumberOfPhotons);
  // Who does as it says is there at once, or after one more time.
  options.NumberOfPhotons = few.PhotonsForScarce;
  ShadowVectorResult enough = Trace(mesh, { Sun() }, options);
  if (enough.NumberOfScarce > 0)
  {
    EXPECT_GT(enough.PhotonsForScarce, options.NumberOfPhotons);
    options.NumberOfPhotons = enough.PhotonsForScarce;
    enough = Trace(mesh, { Sun() }, options);
  }
  EXPECT_EQ(enough.NumberOfScarce, 0);
  EXPECT_EQ(enough.PhotonsForScarce, 0);
  EXPECT_LT(options.NumberOfPhotons, 100000);
  // With a target the photons are as many as it takes.
  EXPECT_EQ(Trace(mesh, { Sun() }, Aimed(100)).PhotonsForScarce, 0);
}

TEST(ScarceOccluders, AnEvenShareIsTheMost)
{
  TestMesh mesh;
  mesh.AddBox({ -50.0, -50.0, 0.0 }, { 50.0, 50.0, 1.0 }, 0);
  for (int i = 1; i < 10; ++i)
  {
    mesh.AddBox({ 55.0 + 5.0 * i, 0.0, 0.0 }, { 55.2 + 5.0 * i, 0.2, 1.0 }, i);
  }
  const ShadowVectorResult result = Trace(mesh, { Sun() }, Aimed(50, 32));
  EXPECT_EQ(result.MinimumVectors, 5);
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_GE(VectorsOf(result)[i], 5) << i;
  }
}

TEST(ScarceOccluders, EachLightHasItsOwn)
{
  TestMesh mesh;
  mesh.AddBox({ -5.0, -5.0, 0.0 }, { 5.0, 5.0, 1.0 }, 0);
  mesh.AddBox({ 8.0, 0.0, 0.0 }, { 8.1, 0.1, 0.1 }, 1);
  const std::vector<Light> lights{ DiscLight({ 0.0, 0.0, 9.0 }, { 0.0, 0.0, -1.0 }, 0.5),
    DiscLight({ 3.0, 0.0, 9.0 }, { 0.0, 0.0, -1.0 }, 0.2), DiscLight({ 0.0, 0.0, 9.0 }, { 0.0, 0.0, 1.0 }, 0.5) };
  const ShadowVectorResult result = Trace(mesh, lights, Aimed(3000));
  EXPECT_GE(VectorsOf(result, 0)[1], 32);
  EXPECT_GE(VectorsOf(result, 1)[1], 32);
  EXPECT_EQ(VectorsOf(result, 2)[1], 0) << "it faces away";
  EXPECT_EQ(result.NumberOfScarce, 0);
}

TEST(ScarceOccluders, WhatNoLightReachesCostsLittle)
{
  TestMesh mesh;
  mesh.AddBox({ -5.0, -5.0, 0.0 }, { 5.0, 5.0, 1.0 }, 0);
  mesh.AddBox({ 19.0, -1.0, 0.0 }, { 21.0, 1.0, 2.0 }, -1); // a receiver, and in it an occluder
  mesh.AddBox({ 19.9, -0.1, 0.9 }, { 20.1, 0.1, 1.1 }, 1);
  const ShadowVectorResult result = Trace(mesh, { Sun() }, Aimed(2000));
  EXPECT_EQ(VectorsOf(result)[1], 0);
  EXPECT_LT(result.NumberOfPhotons, 20000);
  EXPECT_NEAR(PowerOn(result, 0) / 1e5, 1.0, 0.02);
}

TEST(ScarceOccluders, PiecesJoinToTheWhole)
{
  for (const vtkIdType target : { 0, 3000 })
  {
    ShadowVectorOptions options = Aimed(target);
    options.NumberOfPhotons = 5003; // no multiple of the pieces
    const ShadowVectorResult whole = Trace(FarHouses(150.0), { Sun() }, options);
    ASSERT_GT(whole.NumberOfAimedPhotons, 0);
    std::vector<double> points;
    std::vector<float> powers;
    std::vector<vtkIdType> indices;
    options.NumberOfPieces = 4;
    for (options.Piece = 0; options.Piece < 4; ++options.Piece)
    {
      const ShadowVectorResult part = Trace(FarHouses(150.0), { Sun() }, options);
      points.insert(points.end(), part.Vectors.Points.begin(), part.Vectors.Points.end());
      powers.insert(powers.end(), part.Paths.Powers.begin(), part.Paths.Powers.end());
      indices.insert(indices.end(), part.Paths.PhotonIndices.begin(), part.Paths.PhotonIndices.end());
    }
    EXPECT_EQ(points, whole.Vectors.Points);
    EXPECT_EQ(powers, whole.Paths.Powers);
    EXPECT_EQ(indices, whole.Paths.PhotonIndices);
    EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
  }
}

TEST(ScarceOccluders, NobodyIsAimedAtWhereAllHaveEnough)
{
  TestMesh mesh;
  mesh.AddBox({ -0.5, -0.5, 0.0 }, { 0.5, 0.5, 0.2 }, 0);
  mesh.AddBox({ -0.5, -0.5, 1.0 }, { 0.5, 0.5, 1.2 }, 1);
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectorResult with = Trace(mesh, { light }, Aimed(5800));
  const ShadowVectorResult without = Trace(mesh, { light }, Aimed(5800, 0));
  EXPECT_EQ(with.NumberOfAimedPhotons, 0);
  EXPECT_EQ(with.Vectors.Points, without.Vectors.Points);
  EXPECT_EQ(with.Paths.Powers, without.Paths.Powers);
}

TEST(ScarceOccluders, ManyAreAimedAtInGroups)
{
  CasterBoxes casters;
  for (int i = 0; i < 1000; ++i)
  {
    casters.Ids.push_back(i);
    casters.Boxes.push_back(
      { { 3.0 * (i % 40), 3.0 * (i / 40), 0.0 }, { 3.0 * (i % 40) + 1.0, 3.0 * (i / 40) + 1.0, 1.0 } });
  }
  std::vector<bool> scarce(1000, true);
  scarce[17] = false;
  const std::vector<ScarceOccluders> groups = BoxesToAimAt(casters, scarce, 64);
  ASSERT_EQ(groups.size(), 64u);
  std::vector<int> ids;
  for (const ScarceOccluders& group : groups)
  {
    EXPECT_LT(group.Bounds.Diagonal(), 40.0) << "neighbours";
    ids.insert(ids.end(), group.Ids.begin(), group.Ids.end());
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids.size(), 999u);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), 17), 0);
  EXPECT_TRUE(std::unique(ids.begin(), ids.end()) == ids.end());
}

TEST(AimedBoxes, TheFirstThatARayMeetsIsThatOfAskingOneAfterTheOther)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto vector = [&] { return Vector3{ place(random), place(random), place(random) }; };
  for (const std::size_t count : { 0, 1, 2, 3, 64, 200 })
  {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < count; ++k)
    {
      const Vector3 middle = vector();
      const double half = k % 7 == 0 ? 0.0 : 0.1 * (1.0 + place(random)); // flat ones too
      boxes.push_back({ middle - Vector3{ half, 0.05, half }, middle + Vector3{ half, 0.05, half } });
    }
    const AimedBoxes aimed(boxes);
    const auto counts = [](std::size_t k) { return k % 5 != 0; };
    for (int ray = 0; ray < 2000; ++ray)
    {
      const Vector3 origin = 2.0 * vector();
      Vector3 direction = vector();
      direction.X = ray % 3 == 0 ? 0.0 : direction.X;
      direction.Z = ray % 9 == 0 ? 0.0 : direction.Z;
      std::size_t first = 0;
      for (double from = 0.0, to = HUGE_VAL;
           first < count && !(counts(first) && boxes[first].Clip(origin, direction, from, to)); from = 0.0, to = HUGE_VAL)
      {
        ++first;
      }
      ASSERT_EQ(aimed.FirstMet(origin, direction, counts), first) << count << " boxes, ray " << ray;
    }
  }
}
