// SPDX-License-Identifier: BSD-3-Clause
// What tracing vectors and fitting cones cost, in seconds and memory, for growing numbers of vectors.
//
// Exponents are slopes of log(time) over log(vectors) against the row above. Memory is the process's largest resident set so
// far, so rows must grow.
#include "BenchmarkScene.h"
#include "Chain.h"
#include "ProgramOptions.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <exception>

using namespace shadowcones;

namespace
{
double PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}
} // anonymous namespace

int main(int argc, char** argv)
{
  std::string name = "chair";
  std::vector<vtkIdType> numbers{ 10000, 100000, 1000000 };
  bool overlap = true;
  ProgramOptions commandLine("What tracing vectors and fitting cones cost");
  commandLine.Add("--scene", name, "chair, tree, blob or a mesh file");
  commandLine.Add("--vectors", numbers, "shadow vectors, ascending; 10000000 takes some 8 GB");
  commandLine.Add("--overlap", overlap, "bounds (1) or the paper's disjoint cones (0)");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    const BenchmarkScene scene(name);
    std::printf("%10s %8s %10s %10s %8s %10s %8s %10s\n", "vectors", "cones", "trace s", "fit s", "exponent", "us/vector",
      "all exp.", "peak MB");
    double lastFit = 0.0;
    double lastAll = 0.0;
    double lastNumber = 1.0;
    for (const vtkIdType number : numbers)
    {
      ShadowVectorOptions tracing;
      tracing.TargetNumberOfVectors = number;
      tracing.Storage = VectorStorage::HitPoint;
      const double start = Now();
      const ShadowVectorResult traced = testsupport::Trace(*scene.Fast, scene.Light, tracing);
      const double middle = Now();
      ConeSetOptions options;
      options.Overlap = overlap;
      options.VarianceThreshold = overlap ? 1.8 : 1.6;
      options.CosineCorrection = !overlap;
      options.Expansion = overlap ? ConeExpansion::LightGeometry : ConeExpansion::MaximumDeviation;
      const ConeSet set = testsupport::Fit(traced, scene.Light, options);
      const double end = Now();
      const double count = static_cast<double>(traced.Vectors.OccluderIds.size());
      const auto exponent = [&](double last, double now) {
        return last > 0.0 ? std::log(now / last) / std::log(count / lastNumber) : 0.0;
      };
      std::printf("%10lld %8zu %10.2f %10.2f %8.2f %10.2f %8.2f %10.0f\n",
        static_cast<long long>(traced.Vectors.OccluderIds.size()), set.Cones.size(), middle - start, end - middle,
        exponent(lastFit, end - middle), 1e6 * (end - middle) / count, exponent(lastAll, end - start), PeakMegabytes());
      std::fflush(stdout);
      lastFit = end - middle;
      lastAll = end - start;
      lastNumber = count;
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  return 0;
}
