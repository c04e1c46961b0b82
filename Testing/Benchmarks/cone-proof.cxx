// SPDX-License-Identifier: BSD-3-Clause
// What proving a cone set costs: a line for the fitted cones, for the same after the proof, and for cones around parts of the
// occluders alone. Recall and the share of the cones' volume in shadow are by samples drawn evenly in the room.
#include "ConeAdversary.h"
#include "ProgramOptions.h"
#include "SampledRoom.h"

#include "scConeProof.h"
#include "scConeProofCheck.h"

#include <cstdio>
#include <exception>
#include <fstream>

using namespace shadowcones;

namespace
{
void PrintRow(const char* name, const BenchmarkScene& scene, const SampledRoom& room, const ConeProof& proof, double seconds)
{
  const AccuracyTally tally = room.Measure(proof.Cones);
  ConeProofCheck check;
  const double start = Now();
  CheckConeProof(scene.Mesh.View(), scene.Light, proof.Cones, proof.CertifiedBounds, {}, check);
  std::printf("%-12s %9zu %-10s %6zu %6lld %6lld %8lld %8.5f %8.4f %8.3f %7s %8.2f %6.2f\n", scene.Name.c_str(),
    scene.Mesh.Triangles.size() / 3, name, proof.Cones.size(), static_cast<long long>(proof.NumberOfGrownCones),
    static_cast<long long>(proof.NumberOfAddedCones), static_cast<long long>(proof.NumberOfProvedParts),
    tally.Recall().Value, tally.Precision().Value, seconds, check.Proved ? "yes" : "no", Now() - start, proof.Volume);
  std::fflush(stdout);
}

/// Look for a point in shadow and outside every cone.
void SearchLeaks(const BenchmarkScene& scene, const std::vector<Cone>& cones, long long tries)
{
  const double start = Now();
  const AdversaryResult result = ConeAdversary(scene.Mesh.View(), scene.Light, cones).Search(tries, 1);
  std::printf("  %lld tries: %lld points inside cones, %lld outside looked at by rays, %lld leaks; %.0f s\n", tries,
    result.Inside, result.Outside, result.Leaks, Now() - start);
  std::fflush(stdout);
}

void Measure(const BenchmarkScene& scene, const ConeParameters& parameters, int points, long long tries)
{
  const SampledRoom room(scene, points, 64, 20240);
  ConeProof fitted;
  const double start = Now();
  fitted.Cones = scene.MakeConesOf(parameters);
  PrintRow("fitted", scene, room, fitted, Now() - start);
  ConeProofOptions options;
  options.Region = RoomBounds();
  for (const bool withFitted : { true, false })
  {
    ConeProof proof;
    const double begin = Now();
    ProveConeSet(
      scene.Mesh.View(), { scene.Light }, withFitted ? fitted.Cones : std::vector<Cone>(), options, {}, proof);
    PrintRow(withFitted ? "proved" : "clusters", scene, room, proof, Now() - begin);
    if (tries > 0)
    {
      SearchLeaks(scene, proof.Cones, tries);
    }
  }
}
} // anonymous namespace

int main(int argc, char** argv)
{
  std::vector<std::string> scenes = { "chair", "tree", "blob" };
  std::string set = "conservative";
  vtkIdType vectors = 5800;
  int points = 50000;
  long long tries = 0;
  ProgramOptions commandLine("What proving a cone set costs");
  commandLine.Add("--scene", scenes, "chair, tree, blob, or mesh files, which are scaled to a height of 3");
  commandLine.Add("--set", set, "paper, bounds, conservative");
  commandLine.Add("--vectors", vectors, "shadow vectors asked for");
  commandLine.AddPositive("--points", points, "sample points in the room");
  commandLine.Add("--tries", tries, "search so often for a point in shadow and outside every cone");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    std::printf("%-12s %9s %-10s %6s %6s %6s %8s %8s %8s %8s %7s %8s %6s\n", "scene", "triangles", "set", "cones", "grown",
      "added", "parts", "recall", "shadow", "seconds", "proved", "check s", "volume");
    for (const std::string& name : scenes)
    {
      ConeParameters parameters = NamedParameters(set);
      parameters.Vectors = vectors;
      Measure(BenchmarkScene(name), parameters, points, tries);
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
