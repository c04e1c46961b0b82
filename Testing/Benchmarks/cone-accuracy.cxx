// SPDX-License-Identifier: BSD-3-Clause
// How well cones bound the shadow: one line for each scene, number of vectors and set of parameters. The quantities are
// those of vtkConeSetAccuracy, by samples drawn evenly in the room.
#include "ProgramOptions.h"
#include "SampledRoom.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scOccluderInterval.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <tuple>

using namespace shadowcones;

namespace
{
/// For the merged intervals of a ray across the room.
double NanosecondsPerRay(const SampledRoom& room, const std::vector<Cone>& cones)
{
  const ConeHierarchy hierarchy(cones, RoomBounds());
  constexpr int rays = 20000;
  std::vector<OccluderInterval> intervals;
  const Vector3 eye{ 0.0, 2.6, 10.0 };
  const double start = Now();
  for (std::size_t k = 0; k < rays; ++k)
  {
    hierarchy.Intersect(eye, Normalized(room.Points[k % room.Points.size()] - eye), 0.0, 20.0, intervals);
  }
  return (Now() - start) / rays * 1e9;
}

/// Replace each set of parameters by one copy for every value that was given; none given: leave it.
template <class Value, class Member>
void Sweep(std::vector<ConeParameters>& sets, const std::vector<Value>& values, Member member)
{
  if (values.empty())
  {
    return;
  }
  std::vector<ConeParameters> result;
  for (const ConeParameters& set : sets)
  {
    for (const Value& value : values)
    {
      result.push_back(set);
      result.back().*member = value;
    }
  }
  sets = std::move(result);
}
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("How well do cones bound the shadow? Options that take several values are swept over all combinations.");
  std::vector<std::string> scenes = { "chair", "tree", "blob", "bunny" };
  std::vector<std::string> meshes;
  std::vector<std::string> names = { "paper", "bounds" };
  std::vector<vtkIdType> vectors = { 5800, 50000 };
  std::vector<int> storage, p1, p2, p3, p4, expansion, cosine, overlap, seeds;
  std::vector<double> variance, planarity, fraction;
  int points = 50000;
  int lightPoints = 64;
  int truthSeed = 20240;
  std::string csv;
  const std::map<std::string, int> storages = { { "BackSide", 0 }, { "HitPoint", 1 } };
  const std::map<std::string, int> expansions = { { "MaximumDeviation", 0 }, { "RadiusRatio", 1 },
    { "LightGeometry", 2 } };
  commandLine.Add("--scene", scenes, "chair, tree, blob, and bunny where Debian's glmark2-data is installed");
  commandLine.Add("--mesh", meshes, "mesh files to use as well, scaled to a height of 3 on the floor");
  commandLine.Add("--set", names, "starting values: paper, bounds, conservative, preview, soft");
  commandLine.Add("--vectors", vectors, "shadow vectors asked for");
  commandLine.AddNamed("--storage", storage, "BackSide, HitPoint", storages);
  commandLine.Add("--p1", p1, "neighbours");
  commandLine.Add("--p2", p2, "sectors");
  commandLine.Add("--p3", p3, "points in a ring");
  commandLine.Add("--p4", p4, "fewest vectors of a cone");
  commandLine.Add("--threshold", variance, "largest variance over mean of a ring");
  commandLine.Add("--planarity", planarity, "largest distance from the plane over the radius; 0: no test");
  commandLine.AddNamed("--expansion", expansion, "MaximumDeviation, RadiusRatio, LightGeometry", expansions);
  commandLine.Add("--fraction", fraction, "expansion fraction");
  commandLine.Add("--cosine", cosine, "0, 1: cosine correction of the base radius");
  commandLine.Add("--overlap", overlap, "0, 1: cones may overlap");
  commandLine.Add("--seed", seeds, "seed of the photons");
  commandLine.AddPositive("--points", points, "sample points in the room");
  commandLine.AddPositive("--light-points", lightPoints, "light points for each of them");
  commandLine.Add("--truth-seed", truthSeed, "seed of the sample points");
  commandLine.Add("--csv", csv, "write the table to this file as well");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  const std::string bunny = "/usr/share/glmark2/models/bunny.obj";
  const bool hasBunny = std::ifstream(bunny).good();
  scenes.erase(
    std::remove_if(scenes.begin(), scenes.end(), [&](const std::string& s) { return s == "bunny" && !hasBunny; }),
    scenes.end());
  std::replace(scenes.begin(), scenes.end(), std::string("bunny"), bunny);
  scenes.insert(scenes.end(), meshes.begin(), meshes.end());

  try
  {
    std::vector<ConeParameters> sets;
    for (const std::string& name : names)
    {
      sets.push_back(NamedParameters(name));
    }
    // The outermost loops first, so that lines with the same vectors follow each other.
    Sweep(sets, vectors, &ConeParameters::Vectors);
    Sweep(sets, storage, &ConeParameters::Storage);
    Sweep(sets, seeds, &ConeParameters::Seed);
    Sweep(sets, p1, &ConeParameters::P1);
    Sweep(sets, p2, &ConeParameters::P2);
    Sweep(sets, p3, &ConeParameters::P3);
    Sweep(sets, p4, &ConeParameters::P4);
    Sweep(sets, variance, &ConeParameters::Variance);
    Sweep(sets, planarity, &ConeParameters::Planarity);
    Sweep(sets, expansion, &ConeParameters::Expansion);
    Sweep(sets, fraction, &ConeParameters::Fraction);
    const std::vector<bool> cosines(cosine.begin(), cosine.end());
    const std::vector<bool> overlaps(overlap.begin(), overlap.end());
    Sweep(sets, cosines, &ConeParameters::Cosine);
    Sweep(sets, overlaps, &ConeParameters::Overlap);

    std::FILE* table = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
    if (!csv.empty() && !table)
    {
      throw std::runtime_error("Cannot write '" + csv + "'.");
    }
    if (table)
    {
      std::fprintf(table,
        "scene,vectors,cones,discarded,recall,precision,iou,leak,lost,light_precision,umbra_precision,"
        "umbra_recall,vectors_s,tuning_s,fit_s,ray_ns,parameters\n");
    }
    std::printf(
      "# %d samples in the room x %d light points. By volume: recall, precision, IoU, umbra precision, recall.\n"
      "# By light: leak, blocked outside / all blocked; lost, lit inside / all lit; light-p, blocked inside / "
      "all inside.\n",
      points, lightPoints);
    std::printf("%-10s %8s %6s %9s %8s %9s %8s %8s %8s %8s %8s %8s %10s %9s %7s %7s  parameters\n", "scene", "vectors",
      "cones", "discarded", "recall", "precision", "IoU", "leak", "lost", "light-p", "umbra-p", "umbra-r", "vectors[s]",
      "tuning[s]", "fit[s]", "ray[ns]");
    for (const std::string& name : scenes)
    {
      const BenchmarkScene scene(name);
      const SampledRoom room(scene, points, lightPoints, truthSeed);
      using Key = std::tuple<vtkIdType, int, int>;
      std::map<Key, VectorsOfScene> made;
      for (const ConeParameters& parameters : sets)
      {
        const Key key(parameters.Vectors, parameters.Storage, parameters.Seed);
        if (!made.count(key))
        {
          made[key] = scene.MakeVectors(parameters);
        }
        const VectorsOfScene& traced = made[key];
        const ConesOfScene cones = MakeCones(traced, parameters);
        const AccuracyTally found = room.Measure(cones.Cones);
        const double rayTime = NanosecondsPerRay(room, cones.Cones);
        const long long count = traced.Vectors->GetNumberOfPoints();
        const auto print = [&](std::FILE* file, const char* format)
        {
          std::fprintf(file, format, scene.Name.c_str(), count, cones.Cones.size(), cones.Discarded,
            found.Recall().Value, found.Precision().Value, found.IoU().Value, found.Leak().Value, found.Lost().Value,
            found.LightPrecision().Value, found.UmbraPrecision().Value, found.UmbraRecall().Value, traced.Seconds,
            cones.TuningSeconds, cones.Seconds, rayTime, Describe(parameters).c_str());
        };
        print(stdout,
          "%-10s %8lld %6zu %9.4f %8.5f %9.4f %8.4f %8.5f %8.4f %8.4f %8.4f %8.4f %10.3f %9.3f %7.3f %7.0f  %s\n");
        std::fflush(stdout);
        if (table)
        {
          print(table, "%s,%lld,%zu,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.4f,%.4f,%.4f,%.0f,\"%s\"\n");
        }
      }
    }
    if (table)
    {
      std::fclose(table);
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "cone-accuracy: %s\n", failure.what());
    return 1;
  }
  return 0;
}
