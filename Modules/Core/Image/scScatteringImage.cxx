// SPDX-License-Identifier: BSD-3-Clause
#include "scScatteringImage.h"

#include "scMediumTerm.h"
#include "scPrimaryHits.h"
#include "scSurfaceShader.h"
#include "scVisibleLight.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace shadowcones
{

namespace
{

void Allocate(const ScatteringOptions& options, std::size_t wavelengths, ScatteringImage& image)
{
  const auto columns = static_cast<std::size_t>(options.Extent[1] - options.Extent[0] + 1);
  const auto rows = static_cast<std::size_t>(options.Extent[3] - options.Extent[2] + 1);
  const std::size_t pixels = columns * rows;
  image.NumberOfWavelengths = static_cast<int>(wavelengths);
  image.Radiance.assign(pixels * wavelengths, 0.0f);
  image.InScattering.assign(pixels * wavelengths, 0.0f);
  image.SurfaceRadiance.assign(pixels * wavelengths, 0.0f);
  image.Transmittance.assign(pixels * wavelengths, 1.0f);
  image.Depth.assign(pixels, -1.0f);
  image.RelativeError.assign(pixels, 0.0f);
  image.MediumError.assign(pixels, 0.0f);
  image.SampleCount.assign(pixels, 0);
  image.NumberOfOcclusionRays = 0;
  image.NumberOfThickRays = 0;
  image.MarchOpticalDepth = 0.0;
}

/// What is wrong with numbers of the image and of samples.
const char* CheckCounts(const ScatteringOptions& options)
{
  constexpr int mostSamples = 65536;
  if (options.Width < 1 || options.Height < 1 || options.Width > std::numeric_limits<int>::max() / options.Height)
  {
    return "Width and Height must be at least 1, and their product at most 2^31 - 1";
  }
  if (options.NumberOfSteps < 1 || options.NumberOfSteps > 1000000)
  {
    return "NumberOfSteps must lie in 1..1000000";
  }
  if (options.MaximumDepth < 0 || options.MaximumDepth > 16)
  {
    return "MaximumDepth must lie in 0..16";
  }
  if (options.NumberOfLightSamples < 1 || options.NumberOfLightSamples > mostSamples)
  {
    return "NumberOfLightSamples must lie in 1..65536";
  }
  if (options.NumberOfSurfaceLightSamples < 0 || options.NumberOfSurfaceLightSamples > mostSamples)
  {
    return "NumberOfSurfaceLightSamples must lie in 0..65536";
  }
  if (options.NumberOfEdgeSamples < 1 || options.NumberOfEdgeSamples > 1024)
  {
    return "NumberOfEdgeSamples must lie in 1..1024";
  }
  return options.MaximumSamples < 1 ? "MaximumSamples must be at least 1" : nullptr;
}

/// One a light; none where the camera is not to see them.
std::vector<VisibleLight> VisibleLights(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options)
{
  std::vector<VisibleLight> lights;
  for (std::size_t k = 0; options.LightVisible && k < scenes.size(); ++k)
  {
    lights.emplace_back(scenes[k].Source);
  }
  return lights;
}

/// The medium term of one light: "InScattering", "RelativeError", "SampleCount" of an image of the right size.
bool RenderMedium(const ScatteringScene& scene, const ScatteringOptions& options, const PrimaryHits& hits,
  const Monitor& monitor, ScatteringImage& image)
{
  const ExtinctionGroups groups(scene.Source.Spectrum, scene.Fog);
  if (!groups.Scatters())
  {
    return true;
  }
  const LightStrata strata(options.NumberOfLightSamples);
  std::unique_ptr<LitMinusBlockedScene> lit;
  if (!IsMarched(options.Mode))
  {
    lit = std::make_unique<LitMinusBlockedScene>(scene, options, groups);
  }
  const std::vector<TileRange> tiles = TilesOf(options.Extent, MediumTerm::TileSide(options.Mode));
  std::mutex gathering;
  const bool finished = ParallelFor(static_cast<vtkIdType>(tiles.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      MediumTerm term(scene, options, groups, strata, lit.get(), hits, image);
      for (vtkIdType tile = begin; tile < end; ++tile)
      {
        term.RenderTile(tiles[static_cast<std::size_t>(tile)]);
      }
      const std::lock_guard<std::mutex> lock(gathering);
      image.NumberOfOcclusionRays += term.NumberOfOcclusionRays();
      image.NumberOfThickRays += term.NumberOfThickRays();
      image.MarchOpticalDepth = std::max(image.MarchOpticalDepth, term.MarchOpticalDepth());
    });
  return finished;
}

/// Adds up the medium terms of lights.
class MediumSum
{
public:
  void Add(const ScatteringImage& term)
  {
    const std::size_t pixels = term.RelativeError.size();
    const auto wavelengths = static_cast<std::size_t>(term.NumberOfWavelengths);
    this->InScattering.resize(pixels * wavelengths, 0.0);
    this->Errors.resize(pixels, 0.0);
    this->Samples.resize(pixels, 0);
    std::transform(this->InScattering.begin(), this->InScattering.end(), term.InScattering.begin(),
      this->InScattering.begin(), [](double sum, float value) { return sum + value; });
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    {
      const double error = term.MediumError[pixel];
      this->Errors[pixel] = error < 0.0 ? HUGE_VAL : this->Errors[pixel] + error;
      this->Samples[pixel] += term.SampleCount[pixel];
    }
    this->OcclusionRays += term.NumberOfOcclusionRays;
    this->ThickRays += term.NumberOfThickRays;
    this->OpticalDepth = std::max(this->OpticalDepth, term.MarchOpticalDepth);
  }

  void Write(ScatteringImage& image) const
  {
    const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
    std::copy(this->Samples.begin(), this->Samples.end(), image.SampleCount.begin());
    for (std::size_t pixel = 0; pixel < this->Errors.size(); ++pixel)
    {
      double mean = 0.0;
      for (std::size_t k = pixel * wavelengths; k < (pixel + 1) * wavelengths; ++k)
      {
        image.InScattering[k] = static_cast<float>(this->InScattering[k]);
        mean += this->InScattering[k] / static_cast<double>(wavelengths);
      }
      const double error = this->Errors[pixel];
      const double relative = mean > 0.0 ? error / mean : (error > 0.0 ? 1.0 : 0.0);
      image.RelativeError[pixel] = error == HUGE_VAL ? -1.0f : static_cast<float>(relative);
      image.MediumError[pixel] = error == HUGE_VAL ? -1.0f : static_cast<float>(error);
    }
    image.NumberOfOcclusionRays += this->OcclusionRays;
    image.NumberOfThickRays += this->ThickRays;
    image.MarchOpticalDepth = std::max(image.MarchOpticalDepth, this->OpticalDepth);
  }

private:
  std::vector<double> InScattering;
  std::vector<double> Errors; ///< of means over wavelengths; HUGE_VAL: not known
  std::vector<int> Samples;
  vtkIdType OcclusionRays = 0;
  vtkIdType ThickRays = 0; ///< summed over lights
  double OpticalDepth = 0.0;
};

/// The medium terms of all lights.
bool RenderMedia(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image)
{
  if (scenes.size() == 1)
  {
    return RenderMedium(scenes.front(), options, hits, monitor, image);
  }
  MediumSum sum;
  ScatteringImage term;
  const auto count = static_cast<double>(scenes.size());
  for (std::size_t light = 0; light < scenes.size(); ++light)
  {
    Allocate(options, scenes[light].Source.Spectrum.size(), term);
    const auto done = static_cast<double>(light);
    if (!RenderMedium(scenes[light], options, hits, monitor.Part(done / count, (done + 1.0) / count), term))
    {
      return false;
    }
    sum.Add(term);
  }
  sum.Write(image);
  return true;
}

} // namespace

const char* CheckScatteringOptions(const ScatteringOptions& options)
{
  if (const char* fault = CheckCounts(options))
  {
    return fault;
  }
  if (options.Mode < ScatteringMode::BruteForce || options.Mode > ScatteringMode::Volume)
  {
    return "Mode must be 0 (BruteForce), 1 (Medium), 2 (Fast), 3 (Guided), 4 (Soft) or 5 (Volume)";
  }
  if (options.Extent[0] < 0 || options.Extent[2] < 0)
  {
    return "Extent must begin at pixel 0 or above";
  }
  if (!(options.IntensityThreshold >= 0.0))
  {
    return "IntensityThreshold must be 0 or above";
  }
  if (!(options.RelativeErrorGoal >= 0.0))
  {
    return "RelativeErrorGoal must be 0 or above";
  }
  if (!(options.Reflectance >= 0.0 && options.Reflectance <= 1.0))
  {
    return "Reflectance must lie in 0..1";
  }
  return nullptr;
}

bool RenderScattering(const ScatteringScene& scene, const ScatteringOptions& options, const Monitor& monitor,
  ScatteringImage& image)
{
  return RenderScattering(std::vector<ScatteringScene>{ scene }, options, monitor, image);
}

bool RenderScattering(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const Monitor& monitor, ScatteringImage& image)
{
  if (const char* fault = CheckScatteringOptions(options))
  {
    throw std::invalid_argument(fault);
  }
  const std::vector<VisibleLight> visibleLights = VisibleLights(scenes, options);
  Allocate(options, scenes.front().Source.Spectrum.size(), image);
  PrimaryHits hits(scenes.front(), options, visibleLights);
  if (!hits.Trace(monitor.Part(0.0, 0.05)) || !RenderMedia(scenes, options, hits, monitor.Part(0.05, 0.8), image))
  {
    return false;
  }

  const ShadingScene shading(scenes, options, visibleLights, hits);
  std::atomic<vtkIdType> occlusionRays{ 0 };
  const int columns = options.Extent[1] - options.Extent[0] + 1;
  const bool finished = ParallelFor(static_cast<vtkIdType>(image.Depth.size()), monitor.Part(0.8, 1.0),
    [&](vtkIdType begin, vtkIdType end)
    {
      SurfaceShader shader(shading, image);
      for (vtkIdType index = begin; index < end; ++index)
      {
        const auto i = options.Extent[0] + static_cast<int>(index % columns);
        const auto j = options.Extent[2] + static_cast<int>(index / columns);
        shader.Shade(i, j);
      }
      occlusionRays += shader.NumberOfOcclusionRays();
    });
  image.NumberOfOcclusionRays += occlusionRays;
  return finished;
}

bool RenderScattering(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const std::vector<std::array<int, 4>>& extents, const Monitor& monitor, std::vector<ScatteringImage>& images)
{
  constexpr double pixelsOfSquare = 1024.0;
  const auto pixels = [](const std::array<int, 4>& e) { return (e[1] - e[0] + 1.0) * (e[3] - e[2] + 1.0); };
  double all = 0.0;
  std::vector<std::size_t> squares;
  images.resize(extents.size());
  for (std::size_t k = 0; k < extents.size(); ++k)
  {
    all += pixels(extents[k]);
    if (pixels(extents[k]) <= pixelsOfSquare)
    {
      squares.push_back(k);
    }
  }
  const auto render = [&](std::size_t k, const Monitor& part)
  {
    ScatteringOptions partly = options;
    partly.Extent = extents[k];
    return RenderScattering(scenes, partly, part, images[k]);
  };
  double done = 0.0;
  for (std::size_t k = 0; k < extents.size(); ++k)
  {
    const double size = pixels(extents[k]);
    if (size > pixelsOfSquare)
    {
      if (!render(k, monitor.Part(done / all, (done + size) / all)))
      {
        return false;
      }
      done += size;
    }
  }
  // A small part has no tiles for several threads: these are shared out whole.
  return squares.empty() ||
    ParallelFor(static_cast<vtkIdType>(squares.size()), monitor.Part(done / all, 1.0),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          render(squares[static_cast<std::size_t>(i)], {});
        }
      });
}

} // namespace shadowcones
