// SPDX-License-Identifier: BSD-3-Clause
// Would a rough visibility, of which the mean is known, make samples of blocked light better? For pixels of a scene: the rms error of
// the visible share of the light along the ray by so many stratified samples of place and light point, as it is and minus a control
// variate whose exact mean is added back: the visible fraction in a grid, and the discs of cones as the only occluders.
#include "BenchmarkScene.h"
#include "ProgramOptions.h"
#include "ReferencePixels.h"

#include "scLightSampling.h"
#include "scParallel.h"
#include "scRandom.h"

#include "vtkObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <vector>

using namespace shadowcones;

namespace
{
constexpr int numberOfSeeds = 16;
constexpr int variates = 3; ///< none, grid, discs

struct Setting
{
  int Pixels = 96;
  int Exact = 65536;
  std::vector<int> Samples{ 64, 256, 1024 };
};

/// What a sample sees, and what is predicted of it.
struct Look
{
  double Visible = 0.0;
  double Grid = 0.0;
  double Discs = 0.0;
};

class Looker
{
public:
  explicit Looker(BenchmarkScene& scene)
    : Scene(scene)
  {
    scene.BuildRoom();
    scene.TraceVectors(0);
    scene.FitCones();
    this->Grid = scene.FillGrid(65, 64, 2);
    this->Discs = scene.MakeConesOf(NamedParameters("soft"));
  }

  Look At(const Ray& ray, double t, double u, double v) const
  {
    const Vector3 from = ray.Origin + t * ray.Direction;
    const Vector3 to = SampleLightArea(this->Scene.Light, u, v).Position - from;
    const double distance = Length(to);
    const Vector3 direction = (1.0 / distance) * to;
    const bool visible = !this->Scene.Fast->Occluded(from, direction, 0.0, distance);
    return { visible ? 1.0 : 0.0, VisibilityAt(this->Grid, from), this->IsHidden(from, direction, distance) ? 0.0 : 1.0 };
  }

private:
  bool IsHidden(const Vector3& from, const Vector3& direction, double distance) const
  {
    return std::any_of(this->Discs.begin(), this->Discs.end(),
      [&](const Cone& disc)
      {
        const double t = Dot(disc.Center - from, disc.Axis) / Dot(direction, disc.Axis);
        const Vector3 off = from + t * direction - disc.Center;
        return t > 0.0 && t < distance && Dot(off, off) <= disc.BaseRadius * disc.BaseRadius;
      });
  }

  BenchmarkScene& Scene;
  VisibilityGrid Grid;
  std::vector<Cone> Discs;
};

/// Sums of squares over pixels and seeds.
struct Tally
{
  double Squares[variates] = {};
  double Different[variates] = {}; ///< mean square of a sample minus its variate, over all
  double Visible = 0.0;
  int Pixels = 0;
};

/// By scrambled Sobol points.
Look MeanOf(const Looker& looker, const Ray& ray, double begin, double end, int count, std::uint64_t seed, Tally* tally)
{
  Look mean;
  for (int k = 0; k < count; ++k)
  {
    const std::array<double, 4> at = SobolPoint(seed, static_cast<std::uint32_t>(k));
    const Look look = looker.At(ray, begin + at[0] * (end - begin), at[1], at[2]);
    mean.Visible += look.Visible / count;
    mean.Grid += look.Grid / count;
    mean.Discs += look.Discs / count;
    if (tally)
    {
      tally->Different[1] += (look.Visible - look.Grid) * (look.Visible - look.Grid) / count;
      tally->Different[2] += (look.Visible - look.Discs) * (look.Visible - look.Discs) / count;
    }
  }
  return mean;
}

/// One pixel: errors for each number of samples.
std::vector<Tally> MeasurePixel(const BenchmarkScene& scene, const Looker& looker, const PixelTruth& pixel, const Setting& setting)
{
  std::vector<Tally> tallies(setting.Samples.size());
  const Ray ray = scene.Camera.PixelRay(pixel.I, pixel.J, 128, 128);
  double begin = 0.0;
  double end = 100.0;
  if (!scene.Medium.Bounds.Clip(ray.Origin, ray.Direction, begin, end))
  {
    return tallies;
  }
  Tally whole;
  const Look exact = MeanOf(looker, ray, begin, end, setting.Exact, 0, &whole);
  if (exact.Visible > 0.999)
  {
    return tallies;
  }
  for (std::size_t n = 0; n < tallies.size(); ++n)
  {
    Tally& tally = tallies[n];
    std::copy(whole.Different, whole.Different + variates, tally.Different);
    tally.Different[0] = exact.Visible * (1.0 - exact.Visible);
    tally.Visible = exact.Visible;
    tally.Pixels = 1;
    for (int k = 0; k < numberOfSeeds; ++k)
    {
      const auto word = static_cast<std::uint64_t>(pixel.J) * 128 + static_cast<std::uint64_t>(pixel.I);
      const Look mean = MeanOf(looker, ray, begin, end, setting.Samples[n], HashSeed(word, static_cast<std::uint64_t>(k + 1)), nullptr);
      const double errors[variates] = { mean.Visible - exact.Visible, mean.Visible - mean.Grid + exact.Grid - exact.Visible,
        mean.Visible - mean.Discs + exact.Discs - exact.Visible };
      for (int variate = 0; variate < variates; ++variate)
      {
        tally.Squares[variate] += errors[variate] * errors[variate] / numberOfSeeds;
      }
    }
  }
  return tallies;
}

void MeasureScene(const std::string& name, const Setting& setting)
{
  BenchmarkScene scene(name);
  const Looker looker(scene);
  const std::vector<PixelTruth> pixels = SpreadPixels(128, setting.Pixels);
  std::vector<std::vector<Tally>> found(pixels.size());
  ParallelFor(static_cast<vtkIdType>(pixels.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType k = first; k < last; ++k)
      {
        found[k] = MeasurePixel(scene, looker, pixels[k], setting);
      }
    });
  for (std::size_t n = 0; n < setting.Samples.size(); ++n)
  {
    Tally all;
    for (const std::vector<Tally>& one : found)
    {
      all.Pixels += one[n].Pixels;
      all.Visible += one[n].Visible;
      for (int variate = 0; variate < variates; ++variate)
      {
        all.Squares[variate] += one[n].Squares[variate];
        all.Different[variate] += one[n].Different[variate];
      }
    }
    const double count = std::max(all.Pixels, 1);
    const auto error = [&](int variate) { return 100.0 * std::sqrt(all.Squares[variate] / count) / (all.Visible / count); };
    std::printf("%s, %d pixels in shadow, %d samples: error %.2f %%, with the grid %.2f %%, with the discs %.2f %%; mean squares of what is "
                "sampled %.4f, %.4f, %.4f\n",
      name.c_str(), all.Pixels, setting.Samples[n], error(0), error(1), error(2), all.Different[0] / count, all.Different[1] / count,
      all.Different[2] / count);
    std::fflush(stdout);
  }
}
} // anonymous namespace

int main(int argc, char* argv[])
{
  ProgramOptions commandLine("Errors of samples of visibility, alone and minus a rough visibility of which the mean is known.");
  Setting setting;
  std::vector<std::string> scenes{ "tree" };
  commandLine.Add("--scene", scenes, "chair, tree, blob or mesh files");
  commandLine.AddPositive("--pixels", setting.Pixels, "pixels of 128 x 128, spread evenly");
  commandLine.AddPositive("--exact", setting.Exact, "samples that count as exact");
  commandLine.Add("--samples", setting.Samples, "samples a pixel");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }
  vtkObject::GlobalWarningDisplayOff(); // vectors and cones are to be rough
  try
  {
    for (const std::string& scene : scenes)
    {
      MeasureScene(scene, setting);
    }
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "control-variates: %s\n", failure.what());
    return 1;
  }
  return 0;
}
