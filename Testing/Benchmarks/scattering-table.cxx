// SPDX-License-Identifier: BSD-3-Clause
// Seconds, error and occlusion rays of each mode: Hougs and Day's Table 1 with measured errors.
//
// The scene is the room with coloured side walls and a black back wall (Data/cornell-box.vtp). The error is that of the
// medium term: root of the mean square over pixels, over the mean, of the mean over wavelengths. The truth is
// Testing/Reference at random pixels, with independent random light points; its own noise is known and taken off.
#include "ProgramOptions.h"
#include "ReferencePixels.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

using namespace shadowcones;

namespace
{
struct Setting
{
  int Size = 256;
  int Pixels = 2048;
  int Samples = 65536;
  int LightSamples = 16;
  int Steps = 32;
  int Depth = 3;
  double Threshold = 0.1;
  int Repeats = 3;
};

std::vector<double> MediumTerm(const ScatteringImage& image, const std::vector<PixelTruth>& truth, int size)
{
  std::vector<double> values;
  for (const PixelTruth& pixel : truth)
  {
    const std::size_t at = (static_cast<std::size_t>(pixel.J) * size + pixel.I) * image.NumberOfWavelengths;
    double value = 0.0;
    for (int k = 0; k < image.NumberOfWavelengths; ++k)
    {
      value += image.InScattering[at + k] / static_cast<double>(image.NumberOfWavelengths);
    }
    values.push_back(value);
  }
  return values;
}
} // namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Seconds, error and occlusion rays of each mode of the scattering image.");
  Setting setting;
  std::vector<std::string> scenes = { "chair", "tree" };
  std::string folder = ".";
  vtkIdType vectors = 5800;
  int threads = 1;
  commandLine.Add("--scene", scenes, "chair, tree, blob, or a mesh file");
  commandLine.Add("--vectors", vectors, "shadow vectors asked for");
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels that are compared with the reference");
  commandLine.AddPositive("--samples", setting.Samples, "samples of the reference for each of them");
  commandLine.AddPositive("--light-samples", setting.LightSamples, "light points for each march sample");
  commandLine.AddPositive("--steps", setting.Steps, "march intervals along a ray");
  commandLine.Add("--depth", setting.Depth, "times an interval may be halved");
  commandLine.Add("--threshold", setting.Threshold, "difference that halves an interval");
  commandLine.AddPositive("--repeats", setting.Repeats, "the best time of so many runs");
  commandLine.Add("--threads", threads, "threads for the images; the reference takes all");
  commandLine.Add("--cache", folder, "folder that keeps the reference from one run to the next");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }

  try
  {
    std::printf(
      "# %d x %d pixels, %d thread(s), steps %d, depth %d, threshold %g, %d light points a march sample, best of %d "
      "runs\n# seconds: of processor time; they and the rays include surfaces, shaded with 16 light points\n"
      "# error and bias: of the medium term at %d pixels, over its mean, the reference's noise taken off; speed: "
      "BruteForce = 1\n",
      setting.Size, setting.Size, threads, setting.Steps, setting.Depth, setting.Threshold, setting.LightSamples,
      setting.Repeats, setting.Pixels);
    std::printf(
      "%-8s %-26s %7s %8s %7s %8s %8s %12s\n", "scene", "mode", "cones", "seconds", "speed", "error", "bias", "rays");
    for (const std::string& name : scenes)
    {
      const BenchmarkScene scene(name);
      vtkSMPTools::Initialize(0);
      const std::vector<PixelTruth> truth =
        ReferencePixels(scene, setting.Size, setting.Pixels, setting.Samples, folder);

      const auto conesOf = [&](const std::string& set, double fraction)
      {
        ConeParameters parameters = NamedParameters(set);
        parameters.Vectors = vectors;
        parameters.Fraction = fraction;
        return scene.MakeConesOf(parameters);
      };
      struct Row
      {
        std::string Name;
        ScatteringMode Mode;
        std::vector<Cone> Cones;
      };
      const std::vector<Row> rows = { { "BruteForce", ScatteringMode::BruteForce, {} },
        { "Medium, paper", ScatteringMode::Medium, conesOf("paper", 1.0) },
        { "Medium, bounds", ScatteringMode::Medium, conesOf("bounds", 1.0) },
        { "Fast, paper", ScatteringMode::Fast, conesOf("paper", 1.0) },
        { "Fast, paper, angle x 0.25", ScatteringMode::Fast, conesOf("paper", 0.25) },
        { "no shadow", ScatteringMode::Fast, {} } };

      vtkSMPTools::Initialize(threads);
      const OccluderScene occluders(scene.Room.View());
      double brute = 0.0;
      ImageError error;
      for (const Row& row : rows)
      {
        const ConeHierarchy cones(row.Cones, scene.Medium.Bounds);
        ScatteringOptions options;
        options.Mode = row.Mode;
        options.Width = setting.Size;
        options.Height = setting.Size;
        options.Extent = { 0, setting.Size - 1, 0, setting.Size - 1 };
        options.NumberOfSteps = setting.Steps;
        options.MaximumHalvings = setting.Depth;
        options.IntensityThreshold = setting.Threshold;
        options.NumberOfLightSamples = setting.LightSamples;
        options.LightVisible = false;
        options.SurfaceReflectance = scene.Reflectance;
        options.ReflectanceComponents = static_cast<int>(scene.Light.Spectrum.size());
        ScatteringImage image;
        double seconds = HUGE_VAL;
        for (int run = 0; run < setting.Repeats; ++run)
        {
          const std::clock_t start = std::clock();
          RenderScattering({ occluders, scene.Light, scene.Medium, scene.Camera, &cones }, options, Monitor(), image);
          seconds = std::min(seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
        }
        brute = row.Mode == ScatteringMode::BruteForce ? seconds : brute;
        error = Compare(MediumTerm(image, truth, setting.Size), truth);
        std::printf("%-8s %-26s %7zu %8.3f %7.2f %8.4f %8.4f %12lld\n", scene.Name.c_str(), row.Name.c_str(),
          row.Cones.size(), seconds, brute / seconds, error.Rms, error.Bias,
          static_cast<long long>(image.NumberOfOcclusionRays));
        std::fflush(stdout);
      }
      std::printf("# %s: noise of the reference %.4f of the mean a pixel\n", scene.Name.c_str(), error.Reference);
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "scattering-table: %s\n", failure.what());
    return 1;
  }
  return 0;
}
