// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadReplay.h"

#include "BenchmarkScene.h"

#include "scConeTuning.h"
#include "scLoopRecorder.h"
#include "scVectorData.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace shadowcones
{
namespace
{
constexpr double secondsOfBlock = 2e-6; ///< to take one, and to begin it

double MedianSeconds(int threads, const std::function<void()>& run)
{
  vtkSMPTools::Initialize(threads);
  constexpr double enough = 2.0; // seconds
  const double begin = Now();
  std::vector<double> seconds;
  while (seconds.size() < 5 && (seconds.empty() || Now() - begin < enough))
  {
    const double start = Now();
    run();
    seconds.push_back(Now() - start);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// How the loops of a stage would share so many threads.
struct Replayed
{
  double Busy = 0.0;   ///< share of all threads' time inside loops
  double Faster = 0.0; ///< than one thread, with what is between loops
  double Serial = 0.0; ///< share of one thread's time between loops
};

Replayed Replay(int threads, const std::function<void()>& run)
{
  vtkSMPTools::Initialize(threads);
  const LoopRecorder recorder;
  run();
  double serial = recorder.Rest();
  double work = 0.0;
  double took = 0.0;
  for (const LoopRecorder::Loop& loop : recorder.Loops())
  {
    serial += loop.Before;
    work += std::accumulate(loop.Items.begin(), loop.Items.end(), 0.0);
    took += LoopRecorder::Replay(loop, threads, secondsOfBlock);
  }
  Replayed replayed;
  replayed.Busy = took > 0.0 ? work / (threads * took) : 1.0;
  replayed.Faster = (serial + work) / (serial + took);
  replayed.Serial = serial / (serial + work);
  return replayed;
}

void PrintStage(const char* name, const std::function<void()>& run)
{
  const double one = MedianSeconds(1, run);
  const double two = MedianSeconds(2, run);
  std::printf("  %-12s %9.4f %9.4f %7.2f  ", name, one, two, one / two);
  for (const int threads : { 2, 16, 64 })
  {
    const Replayed replayed = Replay(threads, run);
    std::printf("%s%5.0f %% %6.1f x", threads == 2 ? "" : " |", 100.0 * replayed.Busy, replayed.Faster);
    if (threads == 64)
    {
      std::printf(" | %5.1f %%", 100.0 * replayed.Serial);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}
} // namespace

void MeasureThreads(const std::string& name, int size, const std::vector<std::string>& stages)
{
  const auto measure = [&stages](const char* stage, const std::function<void()>& run)
  {
    if (std::find(stages.begin(), stages.end(), stage) != stages.end())
    {
      PrintStage(stage, run);
    }
  };
  BenchmarkScene scene(name);
  scene.BuildRoom();
  scene.TraceVectors(0);
  scene.FitCones();
  scene.BuildHierarchy();
  VisibilityGrid grid = scene.FillGrid(65, 16, 2);
  ScatteringImage image;
  const VectorsOfScene made = scene.MakeVectors(NamedParameters("bounds"));
  ShadowVectorArrays vectors;
  PhotonPathArrays paths;
  std::string error;
  if (!ReadShadowVectors(made.Vectors, vectors, error) || !ReadPhotonPaths(made.Paths, paths, error))
  {
    throw std::runtime_error(error);
  }
  std::printf("threads: %s, %d x %d: seconds on one and two threads; then of the threads' time inside loops what is "
              "work, and how much faster the whole is than on one thread, replayed on 2 | 16 | 64; share outside loops\n",
    scene.Name.c_str(), size, size);
  measure("Guided",
    [&] { scene.Render(scene.Options(ScatteringMode::Guided, size), scene.Hierarchy(), nullptr, image); });
  measure(
    "Volume", [&] { scene.Render(scene.Options(ScatteringMode::Volume, size), nullptr, &grid, image); });
  measure("BruteForce",
    [&] { scene.Render(scene.Options(ScatteringMode::BruteForce, size / 2), nullptr, nullptr, image); });
  measure("fill", [&] { grid = scene.FillGrid(65, 16, 2); });
  measure("vectors", [&] { scene.TraceVectors(0); });
  measure("cones", [&] { scene.FitCones(); });
  measure("tuning",
    [&]
    {
      ConeTuningResult chosen;
      TuneConeSet(vectors.View(), paths.View(), { LightExtentOf(scene.Light) }, ConeTuning::Conservative, {}, {}, chosen);
    });
  vtkSMPTools::Initialize(0);
}

} // namespace shadowcones
