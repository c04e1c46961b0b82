// SPDX-License-Identifier: BSD-3-Clause
// Has Guided with proved cones any bias? A line for each scene: the mean difference of the medium term from the slow reference,
// over its pixels and several seeds, in standard errors of that mean. Where there is none, 19 of 20 scenes lie within 2, and
// the mean over all scenes is near 0.
#include "ProgramOptions.h"
#include "ProofScenes.h"
#include "ReferencePixels.h"

#include "scConeData.h"
#include "scConeHierarchy.h"
#include "scOccluderScene.h"
#include "scReference.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"

#include "vtkObject.h"

#include <cmath>
#include <cstdio>
#include <exception>

using namespace shadowcones;

namespace
{
struct Setting
{
  int Size = 24;
  int Pixels = 192;
  int Samples = 4096;
  int Seeds = 8;
  double Goal = 0.02;
};

/// Looks at the region from above one of its upper edges, from inside where the casters enclose the light.
Camera CameraOf(const ProofScene& scene)
{
  const Vector3 size = scene.Region.Size();
  const bool inside = scene.Name == "lamp in a box" || scene.Name == "dome";
  const Vector3 middle = inside ? MeshBounds(scene.Mesh.View()).Center() : scene.Region.Center();
  Camera camera;
  camera.Position = middle + (inside ? 0.15 : 1.1) * Vector3{ 0.4 * size.X, 0.5 * size.Y, size.Z };
  camera.Forward = Normalized(middle - camera.Position);
  camera.Right = Normalized(Cross(camera.Forward, { 0.0, 1.0, 0.0 }));
  camera.Up = Cross(camera.Right, camera.Forward);
  camera.HalfHeight = inside ? 0.7 : 0.45;
  return camera;
}

/// Thin enough that light passes all of it.
Medium MediumOf(const ProofScene& scene)
{
  Medium medium;
  medium.SigmaS.assign(scene.Light.Spectrum.size(), 0.6 / scene.Region.Diagonal());
  medium.SigmaA.assign(scene.Light.Spectrum.size(), 0.0);
  medium.Bounds = scene.Region;
  return medium;
}

double MeanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value / static_cast<double>(values.size());
  }
  return sum;
}

/// Means over the pixels, with the square of their standard error.
struct Measured
{
  double Mean = 0.0;
  double Variance = 0.0;
};

Measured MeasureReference(const ProofScene& scene, const Camera& camera, const Setting& setting,
  const std::vector<PixelTruth>& pixels, std::uint64_t seed)
{
  const ReferenceScene slow(scene.Mesh.View());
  const Medium medium = MediumOf(scene);
  std::vector<Measured> found(pixels.size());
  ParallelFor(static_cast<vtkIdType>(pixels.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType k = first; k < last; ++k)
      {
        const ReferenceEstimate one = ReferenceInScattering(slow, scene.Light, medium, camera, pixels[k].I, pixels[k].J,
          setting.Size, setting.Size, setting.Samples, seed + static_cast<std::uint64_t>(k));
        found[k] = { MeanOf(one.Mean), std::pow(MeanOf(one.StandardError), 2.0) };
      }
    });
  Measured all;
  const auto count = static_cast<double>(pixels.size());
  for (const Measured& one : found)
  {
    all.Mean += one.Mean / count;
    all.Variance += one.Variance / (count * count);
  }
  return all;
}

Measured MeasureGuided(const ProofScene& scene, const std::vector<Cone>& cones, const Camera& camera,
  const Setting& setting, const std::vector<PixelTruth>& pixels, std::uint64_t seed)
{
  const OccluderScene occluders(scene.Mesh.View());
  const Medium medium = MediumOf(scene);
  const ConeHierarchy tree(cones, medium.Bounds);
  ScatteringOptions options;
  options.Mode = ScatteringMode::Guided;
  options.Width = setting.Size;
  options.Height = setting.Size;
  options.Extent = { 0, setting.Size - 1, 0, setting.Size - 1 };
  options.RelativeErrorGoal = setting.Goal;
  options.NumberOfSurfaceLightSamples = 0;
  options.NumberOfEdgeSamples = 1;
  options.LightVisible = false;
  std::vector<double> means;
  for (int k = 0; k < setting.Seeds; ++k)
  {
    options.Seed = seed + static_cast<std::uint64_t>(k);
    ScatteringImage image;
    RenderScattering({ occluders, scene.Light, medium, camera, &tree }, options, {}, image);
    double sum = 0.0;
    const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
    for (const PixelTruth& pixel : pixels)
    {
      const auto at = static_cast<std::ptrdiff_t>(
        (static_cast<std::size_t>(pixel.J) * static_cast<std::size_t>(setting.Size) + static_cast<std::size_t>(pixel.I)) *
        wavelengths);
      sum += MeanOf({ image.InScattering.begin() + at, image.InScattering.begin() + at + image.NumberOfWavelengths });
    }
    means.push_back(sum / static_cast<double>(pixels.size()));
  }
  Measured all{ MeanOf(means), 0.0 };
  const double seeds = setting.Seeds;
  for (const double mean : means)
  {
    all.Variance += (mean - all.Mean) * (mean - all.Mean) / ((seeds - 1.0) * seeds);
  }
  return all;
}

/// Print a line. @return the bias in standard errors.
double PrintRow(const ProofScene& scene, const Setting& setting, int row)
{
  // No two scenes share random numbers: their errors are independent.
  const auto seed = static_cast<std::uint64_t>(1 + 100000 * row);
  const ProofSceneCones cones = MakeCones(scene, 5800, {});
  const Camera camera = CameraOf(scene);
  const std::vector<PixelTruth> pixels = SpreadPixels(setting.Size, setting.Pixels);
  const Measured truth = MeasureReference(scene, camera, setting, pixels, seed);
  const Measured guided = MeasureGuided(
    scene, ConesFor(scene.Region, 1, cones.CertifiedBounds, cones.Cones), camera, setting, pixels, seed);
  const double error = std::sqrt(truth.Variance + guided.Variance);
  const double bias = (guided.Mean - truth.Mean) / error;
  std::printf("%-14s %-9s %6zu %12.5g %10.5f %10.5f %10.5f %8.2f\n", scene.Name.c_str(), scene.LightName.c_str(),
    cones.Cones.size(), truth.Mean, (guided.Mean - truth.Mean) / truth.Mean, std::sqrt(guided.Variance) / truth.Mean,
    std::sqrt(truth.Variance) / truth.Mean, bias);
  std::fflush(stdout);
  return bias;
}
} // anonymous namespace

int main(int argc, char** argv)
{
  Setting setting;
  std::vector<std::string> scenes;
  ProgramOptions commandLine("The bias of Guided with proved cones, in standard errors");
  commandLine.Add("--scene", scenes, "some of the scenes of proof-table; all of them where none is named");
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels that are compared");
  commandLine.Add("--samples", setting.Samples, "samples of the reference for each of them");
  commandLine.AddWithin("--seeds", setting.Seeds, "images of Guided", 2, 1000);
  commandLine.Add("--goal", setting.Goal, "RelativeErrorGoal");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  vtkObject::GlobalWarningDisplayOff();
  double sum = 0.0;
  int rows = 0;
  int beyond = 0;
  try
  {
    std::printf("%-14s %-9s %6s %12s %10s %10s %10s %8s\n", "scene", "light", "cones", "reference", "bias", "error",
      "ref. error", "errors");
    for (const std::string& name : scenes.empty() ? ProofSceneNames() : scenes)
    {
      const bool allLights = scenes.empty() && name == "chair";
      for (const std::string& light : allLights ? ProofLightNames() : std::vector<std::string>{ "" })
      {
        const double bias = PrintRow(MakeProofScene(name, light), setting, rows);
        sum += bias;
        beyond += std::abs(bias) > 2.0 ? 1 : 0;
        ++rows;
      }
    }
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "error: %s\n", exception.what());
    return 1;
  }
  std::printf("%d scenes: %d beyond 2 standard errors, mean %.2f\n", rows, beyond, sum / rows);
  return 0;
}
