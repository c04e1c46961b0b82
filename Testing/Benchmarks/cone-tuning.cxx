// SPDX-License-Identifier: BSD-3-Clause
// What tuning chooses, beside random sets of parameters: one line for each scene, number of vectors and kind of tuning.
//
//   objective   what the kind of tuning minimises, on the photons held out (scConeTuning.h)
//   best, median of the random sets' objectives, and the choice over the best
#include "BenchmarkScene.h"
#include "ProgramOptions.h"

#include "scConeTuning.h"
#include "scRandom.h"
#include "scVectorData.h"

#include <algorithm>
#include <cstdio>
#include <exception>

using namespace shadowcones;

namespace
{
ConeSetOptions RandomOptions(const ConeSetOptions& chosen, std::uint64_t seed, int index)
{
  RandomStream random(seed, static_cast<std::uint64_t>(index));
  ConeSetOptions options = chosen;
  options.NumberOfNeighbors = 20 + static_cast<int>(230.0 * random.Next());
  options.NumberOfSectors = 6 + static_cast<int>(20.0 * random.Next());
  options.PointsPerRing = 6 + static_cast<int>(20.0 * random.Next());
  options.MinimumVectorsPerCone = std::min(options.NumberOfNeighbors, 5 + static_cast<int>(30.0 * random.Next()));
  options.VarianceThreshold = 1.1 + 2.0 * random.Next();
  return options;
}
} // anonymous namespace

int main(int argc, char** argv)
{
  std::vector<std::string> scenes{ "chair", "tree", "blob" };
  std::vector<vtkIdType> numbers{ 5800 };
  int sets = 64;
  int seed = 1;
  ProgramOptions commandLine("What tuning chooses, beside random sets of parameters");
  commandLine.Add("--scenes", scenes, "chair, tree, blob or mesh files");
  commandLine.Add("--vectors", numbers, "shadow vectors");
  commandLine.Add("--sets", sets, "random sets of parameters");
  commandLine.Add("--seed", seed, "of the photons");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }

  try
  {
    std::printf("%-8s %8s %-13s %5s %5s %5s %5s %6s %8s %7s %9s %8s %8s %6s %8s\n", "scene", "vectors", "tuning", "p1", "p3",
      "p4", "var", "fits", "fraction", "scale", "objective", "best", "median", "ratio", "seconds");
    for (const std::string& name : scenes)
    {
      const BenchmarkScene scene(name);
      for (const vtkIdType number : numbers)
      {
        ConeParameters parameters = NamedParameters("bounds");
        parameters.Vectors = number;
        parameters.Seed = seed;
        const VectorsOfScene made = scene.MakeVectors(parameters);
        ShadowVectorArrays vectors;
        PhotonPathArrays paths;
        std::string error;
        if (!ReadShadowVectors(made.Vectors, vectors, error) || !ReadPhotonPaths(made.Paths, paths, error))
        {
          throw std::runtime_error(error);
        }
        const LightExtent extent = LightExtentOf(scene.Light);
        const char* const kinds[] = { "Manual", "Conservative", "Preview", "Soft" };
        for (int kind = 1; kind <= 3; ++kind)
        {
          const auto tuning = static_cast<ConeTuning>(kind);
          ConeTuningResult chosen;
          const double start = Now();
          TuneConeSet(vectors.View(), paths.View(), extent, tuning, {}, {}, chosen);
          const double seconds = Now() - start;
          std::vector<double> objectives;
          for (int i = 0; i < sets; ++i)
          {
            ConeTuningResult random;
            MeasureTuning(vectors.View(), paths.View(), extent, tuning,
              RandomOptions(chosen.Options, static_cast<std::uint64_t>(seed), i), {}, random);
            objectives.push_back(random.Objective);
          }
          std::sort(objectives.begin(), objectives.end());
          const double best = objectives.empty() ? 0.0 : objectives.front();
          const double median = objectives.empty() ? 0.0 : objectives[objectives.size() / 2];
          const ConeSetOptions& o = chosen.Options;
          std::printf("%-8s %8lld %-13s %5d %5d %5d %5.2f %6d %8.3f %7.3f %9.5f %8.5f %8.5f %6.3f %8.2f\n",
            scene.Name.c_str(), static_cast<long long>(number), kinds[kind], o.NumberOfNeighbors, o.PointsPerRing,
            o.MinimumVectorsPerCone, o.VarianceThreshold, chosen.NumberOfFits, o.ExpansionFraction, o.RadiusScale,
            chosen.Objective, best, median, best > 0.0 ? chosen.Objective / best : 0.0, seconds);
          std::fflush(stdout);
        }
      }
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
