// SPDX-License-Identifier: BSD-3-Clause
// How well cones bound the shadow: one line for each scene, number of vectors and set of parameters.
//
// A sample is a pair (x, y): x uniform in the room, y uniform on the light. It is *blocked* where the mesh cuts the
// segment from x to y, and *inside* where a cone holds x.
//   recall    = blocked and inside / blocked    share of the blocked light that lies inside cones
//   precision = blocked and inside / inside     share of the light at points inside cones that is blocked
//   leak      = blocked, not inside / blocked   1 - recall
//   lost      = lit and inside / lit            share of the unblocked light that lies inside cones
#include "BenchmarkScene.h"

#include "scConeIntervals.h"
#include "scRandom.h"

#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <tuple>

using namespace shadowcones;

namespace
{
/// The truth at sample points: how many of the light points each of them misses.
struct Truth
{
  std::vector<Vector3> Points;
  std::vector<int> Blocked;
  int LightPoints = 0;
};

Truth SampleTruth(const BenchmarkScene& scene, int points, int lightPoints, int seed)
{
  Truth truth;
  truth.LightPoints = lightPoints;
  truth.Points.resize(points);
  truth.Blocked.assign(points, 0);
  const Box room = RoomBounds();
  const Vector3 size = room.Size();
  vtkSMPTools::For(0, points,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        RandomStream random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(k));
        const double u = random.Next();
        const double v = random.Next();
        const double w = random.Next();
        const Vector3 x = room.Min + Vector3{ u * size.X, v * size.Y, w * size.Z };
        truth.Points[k] = x;
        for (int s = 0; s < lightPoints; ++s)
        {
          const double a = random.Next();
          const IncidentSample sample = SampleVisibleLight(scene.Source, x, a, random.Next());
          truth.Blocked[k] += scene.Fast->Occluded(x, sample.Direction, 0.0, sample.Distance);
        }
      }
    });
  return truth;
}

struct Accuracy
{
  double Recall = 0.0;
  double Precision = 0.0;
  double Lost = 0.0;
  double NanosecondsPerRay = 0.0; ///< for the merged intervals of a ray across the room
};

Accuracy Measure(const Truth& truth, const std::vector<Cone>& cones)
{
  const ConeHierarchy hierarchy(cones, RoomBounds());
  const auto count = static_cast<vtkIdType>(truth.Points.size());
  std::vector<unsigned char> inside(truth.Points.size());
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        inside[k] = hierarchy.Contains(truth.Points[k]);
      }
    });
  double blocked = 0.0;
  double blockedInside = 0.0;
  double allInside = 0.0;
  for (vtkIdType k = 0; k < count; ++k)
  {
    blocked += truth.Blocked[k];
    blockedInside += inside[k] ? truth.Blocked[k] : 0;
    allInside += inside[k] ? truth.LightPoints : 0;
  }
  const double all = static_cast<double>(count) * truth.LightPoints;
  Accuracy result;
  result.Recall = blocked > 0.0 ? blockedInside / blocked : 1.0;
  result.Precision = allInside > 0.0 ? blockedInside / allInside : 0.0;
  result.Lost = all > blocked ? (allInside - blockedInside) / (all - blocked) : 0.0;

  constexpr int rays = 20000;
  std::vector<RayInterval> intervals;
  const Vector3 eye{ 0.0, 2.6, 10.0 };
  const double start = Now();
  for (int k = 0; k < rays; ++k)
  {
    hierarchy.Intersect(eye, Normalized(truth.Points[k % count] - eye), 0.0, 20.0, intervals);
  }
  result.NanosecondsPerRay = (Now() - start) / rays * 1e9;
  return result;
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
  CLI::App app("How well do cones bound the shadow? Options that take several values are swept over all combinations.");
  std::vector<std::string> scenes = { "chair", "tree", "blob" };
  std::vector<std::string> meshes;
  std::vector<std::string> names = { "paper", "bounds" };
  std::vector<vtkIdType> vectors = { 5800, 50000 };
  std::vector<int> storage, p1, p2, p3, p4, expansion, cosine, overlap, seeds;
  std::vector<double> variance, planarity, fraction;
  int points = 200000;
  int lightPoints = 16;
  int truthSeed = 20240;
  std::string csv;
  const std::map<std::string, int> storages = { { "BackSide", 0 }, { "HitPoint", 1 } };
  const std::map<std::string, int> expansions = { { "MaximumDeviation", 0 }, { "RadiusRatio", 1 },
    { "LightGeometry", 2 } };
  app.add_option("--scene", scenes, "chair, tree, blob");
  app.add_option("--mesh", meshes, "mesh files to use as well, scaled to a height of 3 on the floor");
  app.add_option("--set", names, "starting values: paper, bounds");
  app.add_option("--vectors", vectors, "shadow vectors asked for");
  app.add_option("--storage", storage, "BackSide, HitPoint")->transform(CLI::CheckedTransformer(storages));
  app.add_option("--p1", p1, "neighbours");
  app.add_option("--p2", p2, "sectors");
  app.add_option("--p3", p3, "points in a ring");
  app.add_option("--p4", p4, "fewest vectors of a cone");
  app.add_option("--threshold", variance, "largest variance over mean of a ring");
  app.add_option("--planarity", planarity, "largest distance from the plane over the radius; 0: no test");
  app.add_option("--expansion", expansion, "MaximumDeviation, RadiusRatio, LightGeometry")
    ->transform(CLI::CheckedTransformer(expansions));
  app.add_option("--fraction", fraction, "expansion fraction");
  app.add_option("--cosine", cosine, "0, 1: cosine correction of the base radius");
  app.add_option("--overlap", overlap, "0, 1: cones may overlap");
  app.add_option("--seed", seeds, "seed of the photons");
  app.add_option("--points", points, "sample points in the room")->check(CLI::PositiveNumber);
  app.add_option("--light-points", lightPoints, "light points for each of them")->check(CLI::PositiveNumber);
  app.add_option("--truth-seed", truthSeed, "seed of the sample points");
  app.add_option("--csv", csv, "write the table to this file as well");
  CLI11_PARSE(app, argc, argv);
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
      std::fprintf(table, "scene,vectors,cones,discarded,recall,precision,leak,lost,trace_s,fit_s,ray_ns,parameters\n");
    }
    std::printf(
      "# samples: %d points in the room x %d light points; blocked: the mesh is between; inside: a cone holds the "
      "point\n"
      "# recall: blocked inside / blocked; precision: blocked inside / inside; leak: blocked outside / blocked; "
      "lost: lit inside / lit\n",
      points, lightPoints);
    std::printf("%-10s %8s %6s %9s %8s %9s %8s %8s %9s %7s %7s  parameters\n", "scene", "vectors", "cones", "discarded",
      "recall", "precision", "leak", "lost", "trace[s]", "fit[s]", "ray[ns]");
    for (const std::string& name : scenes)
    {
      const BenchmarkScene scene = LoadBenchmarkScene(name);
      const Truth truth = SampleTruth(scene, points, lightPoints, truthSeed);
      using Key = std::tuple<vtkIdType, int, int>;
      std::map<Key, VectorsOfScene> made;
      for (const ConeParameters& parameters : sets)
      {
        const Key key(parameters.Vectors, parameters.Storage, parameters.Seed);
        if (!made.count(key))
        {
          made[key] = MakeVectors(scene, parameters);
        }
        const VectorsOfScene& traced = made[key];
        const ConesOfScene cones = MakeCones(traced, parameters);
        const Accuracy accuracy = Measure(truth, cones.Cones);
        const long long count = traced.Vectors->GetNumberOfPoints();
        std::printf("%-10s %8lld %6zu %9.4f %8.5f %9.4f %8.5f %8.4f %9.3f %7.3f %7.0f  %s\n", scene.Name.c_str(), count,
          cones.Cones.size(), cones.Discarded, accuracy.Recall, accuracy.Precision, 1.0 - accuracy.Recall,
          accuracy.Lost, traced.Seconds, cones.Seconds, accuracy.NanosecondsPerRay, Describe(parameters).c_str());
        std::fflush(stdout);
        if (table)
        {
          std::fprintf(table, "%s,%lld,%zu,%.6f,%.6f,%.6f,%.6f,%.6f,%.4f,%.4f,%.0f,\"%s\"\n", scene.Name.c_str(), count,
            cones.Cones.size(), cones.Discarded, accuracy.Recall, accuracy.Precision, 1.0 - accuracy.Recall,
            accuracy.Lost, traced.Seconds, cones.Seconds, accuracy.NanosecondsPerRay, Describe(parameters).c_str());
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
