// SPDX-License-Identifier: BSD-3-Clause
// Which photons a run traces: targets, pieces, seeds and indices beyond 2^32; its progress, and that it stops.
#include "PhotonTesting.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scPhotonEmission.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;
using namespace photontesting;

namespace
{

/// Every array of a result, by name, as bytes.
std::map<std::string, std::string> Bytes(const ShadowVectorResult& r)
{
  std::map<std::string, std::string> bytes;
  const auto add = [&bytes](const char* name, const auto& values)
  { bytes[name].assign(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])); };
  add("Vectors.Points", r.Vectors.Points);
  add("Vectors.Directions", r.Vectors.Directions);
  add("Vectors.Normals", r.Vectors.Normals);
  add("Vectors.OccluderIds", r.Vectors.OccluderIds);
  add("Vectors.EmissionPoints", r.Vectors.EmissionPoints);
  add("Vectors.PathLengths", r.Vectors.PathLengths);
  add("Vectors.Thicknesses", r.Vectors.Thicknesses);
  add("Vectors.PhotonIndices", r.Vectors.PhotonIndices);
  add("Paths.Points", r.Paths.Points);
  add("Paths.States", r.Paths.States);
  add("Paths.OccluderIds", r.Paths.OccluderIds);
  add("Paths.EmissionPoints", r.Paths.EmissionPoints);
  add("Paths.Directions", r.Paths.Directions);
  add("Paths.Powers", r.Paths.Powers);
  add("Paths.PhotonIndices", r.Paths.PhotonIndices);
  add("Photons.Points", r.Photons.Points);
  add("Photons.Normals", r.Photons.Normals);
  add("Photons.Directions", r.Photons.Directions);
  add("Photons.Powers", r.Photons.Powers);
  add("Photons.OccluderIds", r.Photons.OccluderIds);
  add("Photons.ReceiverIds", r.Photons.ReceiverIds);
  add("Photons.PhotonIndices", r.Photons.PhotonIndices);
  return bytes;
}

} // namespace

TEST(ShadowVectorTarget, IsMetUpToTheLastPhotons)
{
  TestMesh mesh;
  mesh.AddBox({ -0.5, -0.5, 0.0 }, { 0.5, 0.5, 0.2 }, 0);
  mesh.AddBox({ -0.5, -0.5, 1.0 }, { 0.5, 0.5, 1.2 }, 1);
  mesh.AddBox({ 2.0, 2.0, 1.0 }, { 2.5, 2.5, 1.2 }, 2); // lowers the yield
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  for (const vtkIdType target : { 1, 7, 1000, 5800 })
  {
    ShadowVectorOptions options = Photons(1);
    options.TargetNumberOfVectors = target;
    const ShadowVectorResult result = Trace(mesh, light, options);
    const auto stored = static_cast<vtkIdType>(result.Vectors.OccluderIds.size());
    const vtkIdType last = result.Vectors.PhotonIndices.back();
    const auto ofLast = std::count(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end(), last);
    EXPECT_GE(stored, target);
    EXPECT_LT(stored - ofLast, target);          // without the last photon it would not be met
    EXPECT_EQ(result.NumberOfPhotons, last + 1); // and that is the last one emitted
    // The same as asking for that many photons.
    EXPECT_EQ(Bytes(result), Bytes(Trace(mesh, light, Photons(result.NumberOfPhotons))));
  }
}

TEST(ShadowVectorTarget, GivesUpWhereNoLightArrives)
{
  ShadowVectorOptions options;
  options.TargetNumberOfVectors = 10;
  const ShadowVectorResult result = Trace(Sheet(1.0), DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 0.5), options);
  EXPECT_EQ(result.NumberOfPhotons, 10000);
  EXPECT_TRUE(result.Vectors.OccluderIds.empty());
}

TEST(ShadowVectorPieces, JoinToTheWhole)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  for (const vtkIdType target : { 0, 3000 })
  {
    ShadowVectorOptions options = Photons(5003); // no multiple of the pieces
    options.TargetNumberOfVectors = target;
    const auto whole = Bytes(Trace(mesh, light, options));
    for (const int pieces : { 2, 4, 7 })
    {
      std::map<std::string, std::string> joined;
      options.NumberOfPieces = pieces;
      for (options.Piece = 0; options.Piece < pieces; ++options.Piece)
      {
        for (const auto& [name, bytes] : Bytes(Trace(mesh, light, options)))
        {
          joined[name] += bytes;
        }
      }
      EXPECT_TRUE(joined == whole) << pieces << " pieces";
      options.Piece = 0;
      options.NumberOfPieces = 1;
    }
  }
}

TEST(ShadowVectorSeed, ChoosesThePhotons)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  ShadowVectorOptions options = Photons(1000);
  const auto first = Bytes(Trace(mesh, light, options));
  EXPECT_TRUE(first == Bytes(Trace(mesh, light, options)));
  options.Seed = 2;
  EXPECT_FALSE(first == Bytes(Trace(mesh, light, options)));
}

TEST(ShadowVectorMonitor, AbortStopsAndProgressOnlyGrows)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  mesh.AddBox({ 20.0, 20.0, 0.0 }, { 21.0, 21.0, 1.0 }, 1); // aims most photons beside the sphere
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const OccluderScene scene(mesh.View());
  for (const vtkIdType target : { 0, 40000 })
  {
    ShadowVectorOptions options = Photons(200000);
    options.TargetNumberOfVectors = target;
    std::vector<double> seen;
    Monitor monitor;
    monitor.Progress = [&seen](double share) { seen.push_back(share); };
    ShadowVectorResult result;
    ASSERT_TRUE(TraceShadowVectors(scene, light, options, monitor, result));
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_GE(std::set<double>(seen.begin(), seen.end()).size(), 3u);
    EXPECT_NEAR(seen.back(), 1.0, 1e-12) << target << " " << testing::PrintToString(seen) << result.NumberOfPhotons;

    monitor.Aborted = [&seen] { return seen.size() >= 2; };
    seen.clear();
    EXPECT_FALSE(TraceShadowVectors(scene, light, options, monitor, result));
    EXPECT_LE(seen.size(), 3u);
  }
}

TEST(PhotonEmission, PhotonsBeyondTheFirstFourThousandMillionAreOthers)
{
  // The index has more bits than the Sobol sequence: 2^32 photons later nothing may repeat.
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0);
  const Light light = DiscLight({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const PhotonEmission emission(light, mesh.View());
  for (const vtkIdType later : { vtkIdType(1) << 32, vtkIdType(1) << 40 })
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const EmittedPhoton first = emission.Emit(1, i);
      const EmittedPhoton other = emission.Emit(1, i + later);
      EXPECT_GT(Length(first.Origin - other.Origin) + Length(first.Direction - other.Direction), 1e-3) << later;
    }
  }
}
