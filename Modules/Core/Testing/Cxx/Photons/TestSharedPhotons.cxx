// SPDX-License-Identifier: BSD-3-Clause
// Photons shared by processes: the bytes of one alone, and a share of the work for each.
#include "TestLights.h"
#include "TestMeshes.h"
#include "ThreadTeam.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// A large box and small ones, which have to be aimed at.
TestMesh Boxes()
{
  TestMesh mesh;
  mesh.AddBox({ -2.0, -2.0, 0.0 }, { 2.0, 2.0, 0.5 }, 0);
  for (int k = 0; k < 5; ++k)
  {
    mesh.AddBox({ 2.5 + 0.3 * k, -2.0, 0.0 }, { 2.52 + 0.3 * k, -1.98, 0.1 }, k + 1);
  }
  return mesh;
}

void ExpectSame(const ShadowVectorResult& a, const ShadowVectorResult& b)
{
  EXPECT_EQ(a.Vectors.Points, b.Vectors.Points);
  EXPECT_EQ(a.Vectors.Directions, b.Vectors.Directions);
  EXPECT_EQ(a.Vectors.OccluderIds, b.Vectors.OccluderIds);
  EXPECT_EQ(a.Vectors.PathLengths, b.Vectors.PathLengths);
  EXPECT_EQ(a.Vectors.PhotonIndices, b.Vectors.PhotonIndices);
  EXPECT_EQ(a.Paths.Points, b.Paths.Points);
  EXPECT_EQ(a.Paths.Powers, b.Paths.Powers);
  EXPECT_EQ(a.Paths.PhotonIndices, b.Paths.PhotonIndices);
  EXPECT_EQ(a.Photons.Points, b.Photons.Points);
  EXPECT_EQ(a.Photons.Powers, b.Photons.Powers);
  EXPECT_EQ(a.Photons.ReceiverIds, b.Photons.ReceiverIds);
  EXPECT_EQ(a.NumberOfPhotons, b.NumberOfPhotons);
  EXPECT_EQ(a.NumberOfAimedPhotons, b.NumberOfAimedPhotons);
  EXPECT_EQ(a.MeanSolidAngle, b.MeanSolidAngle);
  EXPECT_EQ(a.NumberOfScarce, b.NumberOfScarce);
  EXPECT_EQ(a.PhotonsForScarce, b.PhotonsForScarce);
}
} // anonymous namespace

TEST(SharedPhotons, AreThoseOfOneProcess)
{
  const TestMesh mesh = Boxes();
  const OccluderScene scene(mesh.View());
  const std::vector<Light> lights{ DiscLight({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, -1.0 }, 0.5) };
  for (const vtkIdType target : { 0, 1500 })
  {
    for (const int minimum : { 0, 32 })
    {
      ShadowVectorOptions options;
      options.NumberOfPhotons = 6000;
      options.TargetNumberOfVectors = target;
      options.MinimumVectorsPerOccluder = minimum;
      ShadowVectorResult alone;
      ASSERT_TRUE(TraceShadowVectors(scene, lights, options, {}, alone));
      ASSERT_GT(alone.Vectors.OccluderIds.size(), 500u);
      EXPECT_EQ(alone.NumberOfAimedPhotons > 0, minimum > 0);
      for (const int size : { 2, 3 })
      {
        std::array<vtkIdType, 3> items{};
        RunAsTeam(size,
          [&](ThreadTeam& team)
          {
            ShadowVectorOptions shared = options;
            shared.Workers = &team;
            ShadowVectorResult result;
            EXPECT_TRUE(TraceShadowVectors(scene, lights, shared, {}, result));
            ExpectSame(result, alone);
            items[static_cast<std::size_t>(team.GetRank())] = team.Items;
          });
        vtkIdType all = 0;
        for (const vtkIdType of : items)
        {
          all += of;
        }
        for (int rank = 0; rank < size; ++rank)
        {
          // Ranges are whole thousands of photons.
          EXPECT_NEAR(static_cast<double>(items[static_cast<std::size_t>(rank)]), static_cast<double>(all) / size, 2100.0);
        }
      }
    }
  }
}

TEST(SharedPhotons, PiecesOfATeamJoinToThoseOfOneProcess)
{
  const TestMesh mesh = Boxes();
  const OccluderScene scene(mesh.View());
  const std::vector<Light> lights{ DiscLight({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, -1.0 }, 0.5) };
  for (const vtkIdType target : { 0, 1500 })
  {
    ShadowVectorOptions options;
    options.NumberOfPhotons = 6000;
    options.TargetNumberOfVectors = target;
    options.MinimumVectorsPerOccluder = 32;
    ShadowVectorResult alone;
    ASSERT_TRUE(TraceShadowVectors(scene, lights, options, {}, alone));
    std::array<std::vector<vtkIdType>, 3> indices;
    RunAsTeam(3,
      [&](ThreadTeam& team)
      {
        ShadowVectorOptions shared = options;
        shared.Workers = &team;
        shared.Piece = team.GetRank();
        shared.NumberOfPieces = 3;
        ShadowVectorResult result;
        EXPECT_TRUE(TraceShadowVectors(scene, lights, shared, {}, result));
        indices[static_cast<std::size_t>(team.GetRank())] = result.Vectors.PhotonIndices;
      });
    std::vector<vtkIdType> joined;
    for (const std::vector<vtkIdType>& part : indices)
    {
      joined.insert(joined.end(), part.begin(), part.end());
    }
    EXPECT_EQ(joined, alone.Vectors.PhotonIndices);
  }
}
