// SPDX-License-Identifier: BSD-3-Clause
// Do samples that lie denser at the ends of cone intervals pay (Hougs and Day, section 3.3.1)?
//
// The medium term of small images, by the modes that take samples inside cone intervals: Medium, with the halving of steps
// and without, and Guided where it samples places. "Rays" are those that give the error of the middle row of even samples,
// read off each share's own curve, over those that even samples take for it: below 1 denser ends pay. The error is the root of
// the mean square over pixels and seeds, over the mean of a reference by places with thousands of samples a pixel.
#include "BenchmarkScene.h"
#include "ErrorCurve.h"
#include "ProgramOptions.h"

#include <cmath>
#include <cstdio>
#include <exception>

using namespace shadowcones;

namespace
{
struct Setting
{
  int Size = 64;
  int Samples = 4096; ///< of the reference, a pixel
  int Seeds = 4;      ///< of Guided
  double LampRadius = 0.5;
  std::string Cones = "bounds";
  std::vector<double> Shares = { 0.0, 1e-9, 0.25, 0.5, 0.75 };
};

/// A way to render, and the numbers of samples or steps that make its curve.
struct Way
{
  const char* Name;
  ScatteringMode Mode;
  int Halvings;
  std::vector<int> Knobs;
};

/// Below 64 samples a pixel Guided asks for no whole lines, which have no places to choose.
const std::vector<Way>& Ways()
{
  static const std::vector<Way> ways = {
    { "Guided", ScatteringMode::Guided, 0, { 8, 16, 32, 63 } },
    { "Medium", ScatteringMode::Medium, 3, { 8, 16, 32, 64, 128 } },
    { "Medium, no halving", ScatteringMode::Medium, 0, { 8, 16, 32, 64, 128 } },
  };
  return ways;
}

std::vector<double> MeansOf(const ScatteringImage& image)
{
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  std::vector<double> means(image.SampleCount.size(), 0.0);
  for (std::size_t k = 0; k < means.size() * wavelengths; ++k)
  {
    means[k / wavelengths] += static_cast<double>(image.InScattering[k]) / static_cast<double>(wavelengths);
  }
  return means;
}

ConeParameters ParametersOf(const std::string& name, const Setting& setting)
{
  ConeParameters parameters = NamedParameters(setting.Cones);
  parameters.Vectors = name == "tree" ? 20000 : 5800;
  return parameters;
}

class Comparison
{
public:
  Comparison(const std::string& name, const Setting& setting)
    : Scene(name, { RoomLamp().Center, setting.LampRadius })
    , Settings(setting)
    , Cones(this->Scene.MakeConesOf(ParametersOf(name, setting)))
    , Tree(this->Cones, this->Scene.Medium.Bounds)
  {
    this->Scene.BuildRoom();
    ScatteringOptions options = this->Scene.Options(ScatteringMode::Guided, setting.Size);
    options.RelativeErrorGoal = 0.0;
    options.MaximumSamples = setting.Samples;
    options.Sampling = LightSampling::SolidAngle; // by places, not by lines
    options.Seed = 1000;
    ScatteringImage image;
    this->Scene.Render(options, nullptr, nullptr, image); // nor by cones
    this->Truth = MeansOf(image);
    for (const double value : this->Truth)
    {
      this->Mean += value / static_cast<double>(this->Truth.size());
    }
  }

  void Print() const
  {
    ScatteringImage image;
    this->Scene.Render(this->Scene.Options(ScatteringMode::Guided, this->Settings.Size), &this->Tree, nullptr, image);
    std::printf("# %s: %zu cones; Guided with its defaults takes %.0f %% of its samples by lines\n",
      this->Scene.Name.c_str(), this->Cones.size(),
      1600.0 * static_cast<double>(image.NumberOfShadowLines) / static_cast<double>(image.NumberOfOcclusionRays));
    for (const Way& way : Ways())
    {
      std::vector<CurvePoint> even;
      for (const double share : this->Settings.Shares)
      {
        const std::vector<CurvePoint> curve = this->CurveOf(way, share);
        even = even.empty() ? curve : even;
        this->PrintRow(way, share, curve, even);
      }
    }
  }

private:
  /// Rays instead of seconds.
  std::vector<CurvePoint> CurveOf(const Way& way, double share) const
  {
    ScatteringOptions options = this->Scene.Options(way.Mode, this->Settings.Size);
    options.ShareNearEnds = share;
    options.MaximumHalvings = way.Halvings;
    options.RelativeErrorGoal = 0.0;
    const int seeds = way.Mode == ScatteringMode::Guided ? this->Settings.Seeds : 1;
    std::vector<CurvePoint> curve;
    for (const int knob : way.Knobs)
    {
      options.NumberOfSteps = knob;
      options.MaximumSamples = knob;
      double squares = 0.0;
      double rays = 0.0;
      for (int seed = 1; seed <= seeds; ++seed)
      {
        options.Seed = static_cast<std::uint64_t>(seed);
        ScatteringImage image;
        this->Scene.Render(options, &this->Tree, nullptr, image);
        const std::vector<double> values = MeansOf(image);
        for (std::size_t k = 0; k < values.size(); ++k)
        {
          squares += std::pow(values[k] - this->Truth[k], 2.0);
        }
        rays += static_cast<double>(image.NumberOfOcclusionRays) / seeds;
      }
      const double count = static_cast<double>(this->Truth.size()) * seeds;
      curve.push_back({ rays, std::sqrt(squares / count) / this->Mean });
    }
    return curve;
  }

  void PrintRow(const Way& way, double share, const std::vector<CurvePoint>& curve, const std::vector<CurvePoint>& even) const
  {
    const CurvePoint& middle = even[even.size() / 2];
    const TimeAtError there = TimeAt(curve, middle.Error);
    std::printf("%-7s %-19s %8.2g ", this->Scene.Name.c_str(), way.Name, share);
    there.IsKnown() ? std::printf("%6.2f ", there.Seconds / middle.Seconds) : std::printf("%6s ", "-");
    for (const CurvePoint& point : curve)
    {
      std::printf("  %.4f (%.2f)", point.Error, 1e-6 * point.Seconds);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  BenchmarkScene Scene;
  const Setting& Settings;
  std::vector<Cone> Cones;
  ConeHierarchy Tree;
  std::vector<double> Truth;
  double Mean = 0.0;
};
} // anonymous namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Samples denser at the ends of cone intervals against even ones, at equal error.");
  Setting setting;
  std::vector<std::string> scenes = { "chair", "tree", "blob", "blinds" };
  commandLine.Add("--scene", scenes, "chair, tree, blob, blinds, canopy, holes, colonnade, or a mesh file");
  commandLine.AddPositive("--size", setting.Size, "width and height in pixels");
  commandLine.AddPositive("--samples", setting.Samples, "samples a pixel of the reference");
  commandLine.AddPositive("--seeds", setting.Seeds, "images of Guided");
  commandLine.AddPositive("--light-radius", setting.LampRadius, "of the disc lamp");
  commandLine.Add("--set", setting.Cones, "cones: bounds, conservative or paper");
  commandLine.Add("--share", setting.Shares, "of the samples near ends, below 1; even ones first");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  try
  {
    std::printf("# %d x %d pixels; share of the samples near the ends (0: even over the whole ray; 1e-9: even in each interval), "
                "rays at equal error, and the curve: error (millions of rays)\n",
      setting.Size, setting.Size);
    for (const std::string& scene : scenes)
    {
      Comparison(scene, setting).Print();
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "interval-ends: %s\n", failure.what());
    return 1;
  }
  return 0;
}
