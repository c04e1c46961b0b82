// SPDX-License-Identifier: BSD-3-Clause
#include "DarkSpeed.h"

#include "BenchmarkScene.h"
#include "ErrorCurve.h"
#include "ReferencePixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace shadowcones
{
namespace
{
struct DarkRow
{
  const char* Scene;
  int Size;
  double Errors[2]; ///< at which a time is wanted
};

/// The shortest of three.
double SecondsOfPicture(const BenchmarkScene& scene, const ScatteringOptions& options, ScatteringImage& image)
{
  double shortest = HUGE_VAL;
  for (int k = 0; k < 3; ++k)
  {
    const double start = Now();
    scene.Render(options, nullptr, nullptr, image);
    shortest = std::min(shortest, Now() - start);
  }
  return shortest;
}

double ErrorOfPicture(const ScatteringImage& image, const std::vector<PixelTruth>& truth, int size)
{
  std::vector<double> values;
  for (const PixelTruth& pixel : truth)
  {
    values.push_back(MeanOfPixel(image, static_cast<std::size_t>(pixel.J) * size + pixel.I));
  }
  const ImageError error = Compare(values, truth);
  return std::max(error.Rms, error.Smallest);
}

void MeasureRow(const DarkRow& row, const std::string& folder)
{
  BenchmarkScene scene(row.Scene);
  scene.BuildRoom();
  const std::vector<PixelTruth> truth = ReferencePixels(scene, row.Size, 512, 65536, folder);
  ScatteringImage image;
  std::vector<CurvePoint> curve;
  for (const double goal : { 0.2, 0.1, 0.05, 0.02, 0.01 })
  {
    ScatteringOptions options = scene.Options(ScatteringMode::Guided, row.Size);
    options.RelativeErrorGoal = goal;
    const double seconds = SecondsOfPicture(scene, options, image);
    curve.push_back({ seconds, ErrorOfPicture(image, truth, row.Size) });
    std::printf("dark: %s, %d x %d, Guided, goal %g: %.3f s, error %.2f %%\n", row.Scene, row.Size, row.Size, goal, seconds,
      100.0 * curve.back().Error);
  }
  ScatteringOptions march = scene.Options(ScatteringMode::BruteForce, row.Size);
  march.NumberOfSteps = 128;
  march.NumberOfLightSamples = 4;
  const double seconds = SecondsOfPicture(scene, march, image);
  std::printf("dark: %s, %d x %d, BruteForce, 128 steps, 4 light points: %.3f s, error %.2f %%\n", row.Scene, row.Size, row.Size,
    seconds, 100.0 * ErrorOfPicture(image, truth, row.Size));
  for (const double error : row.Errors)
  {
    const TimeAtError time = TimeAt(curve, error);
    std::printf("dark: %s, %d x %d, Guided errs by %g %% after %.3f s%s\n", row.Scene, row.Size, row.Size, 100.0 * error, time.Seconds,
      time.Is == TimeAtError::AtMost      ? " or less"
        : time.Is == TimeAtError::NotReached ? ": not reached"
                                             : "");
  }
  std::fflush(stdout);
}
} // anonymous namespace

void MeasureDark(const std::string& folder)
{
  MeasureRow({ "blinds", 127, { 0.025, 0.01 } }, folder);
  MeasureRow({ "canopy", 83, { 0.015, 0.007 } }, folder);
  BenchmarkScene scene("blinds");
  scene.BuildRoom();
  ScatteringOptions options = scene.Options(ScatteringMode::Guided, 506);
  options.RelativeErrorGoal = 0.02;
  ScatteringImage image;
  std::printf("dark: blinds, 506 x 506, Guided, goal .02: %.3f s\n", SecondsOfPicture(scene, options, image));
  std::fflush(stdout);
}

} // namespace shadowcones
