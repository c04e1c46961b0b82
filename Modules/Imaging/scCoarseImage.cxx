// SPDX-License-Identifier: BSD-3-Clause
#include "scCoarseImage.h"

#include "scImageScene.h"
#include "scParallel.h"
#include "scScatteringOptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace shadowcones
{
namespace
{
/// A picture of so many pixels is there within a moment.
constexpr double fewPixels = 4096.0;
/// A finer picture than this would cost too large a share of the image itself.
constexpr int finestScale = 4;
constexpr double looseGoal = 0.05;
constexpr vtkIdType fewPhotons = 20000;

/// Where pixels of the whole lie between those of a coarse picture along one axis.
struct Between
{
  std::size_t Low;
  std::size_t High;
  float Fraction;
};

std::vector<Between> PlacesAlong(int pixels, int coarse)
{
  std::vector<Between> places;
  for (int i = 0; i < pixels; ++i)
  {
    const double at = std::clamp((i + 0.5) * coarse / pixels - 0.5, 0.0, coarse - 1.0);
    const auto low = static_cast<std::size_t>(at);
    places.push_back({ low, std::min<std::size_t>(low + 1, static_cast<std::size_t>(coarse) - 1),
      static_cast<float>(at - static_cast<double>(low)) });
  }
  return places;
}

/// The places of all pixels of a coarse picture among those of the whole.
struct Enlarger
{
  std::vector<Between> Columns;
  std::vector<Between> Rows;
  std::size_t Stride; ///< pixels of a coarse row

  void Linear(int row, const PixelArray<float>& coarse, std::size_t components, PixelArray<float>& values) const
  {
    const Between& j = this->Rows[static_cast<std::size_t>(row)];
    float* value = values.data() + static_cast<std::size_t>(row) * this->Columns.size() * components;
    for (const Between& i : this->Columns)
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        const auto at = [&](std::size_t line, std::size_t column)
        { return coarse[(line * this->Stride + column) * components + c]; };
        const float below = at(j.Low, i.Low) + i.Fraction * (at(j.Low, i.High) - at(j.Low, i.Low));
        const float above = at(j.High, i.Low) + i.Fraction * (at(j.High, i.High) - at(j.High, i.Low));
        *value++ = below + j.Fraction * (above - below);
      }
    }
  }
  template <typename T>
  void Nearest(int row, const PixelArray<T>& coarse, PixelArray<T>& values) const
  {
    const auto nearest = [](const Between& b) { return b.Fraction < 0.5f ? b.Low : b.High; };
    const std::size_t line = nearest(this->Rows[static_cast<std::size_t>(row)]) * this->Stride;
    T* value = values.data() + static_cast<std::size_t>(row) * this->Columns.size();
    for (const Between& i : this->Columns)
    {
      *value++ = coarse[line + nearest(i)];
    }
  }
};

/// @return false where aborted.
bool Enlarge(
  const ScatteringImage& coarse, const std::array<int, 4>& extent, const Monitor& monitor, ScatteringImage& image)
{
  using Floats = PixelArray<float> ScatteringImage::*;
  constexpr Floats spectra[] = { &ScatteringImage::Radiance, &ScatteringImage::InScattering,
    &ScatteringImage::SurfaceRadiance, &ScatteringImage::Transmittance, &ScatteringImage::MultipleScattering,
    &ScatteringImage::IndirectSurface };
  constexpr Floats numbers[] = { &ScatteringImage::Depth, &ScatteringImage::RelativeError,
    &ScatteringImage::MediumError, &ScatteringImage::SurfaceRelativeError, &ScatteringImage::PhotonError };
  const int width = coarse.Extent[1] + 1;
  const int height = coarse.Extent[3] + 1;
  const Enlarger enlarger{ PlacesAlong(extent[1] + 1, width), PlacesAlong(extent[3] + 1, height),
    static_cast<std::size_t>(width) };
  const auto wavelengths = static_cast<std::size_t>(coarse.NumberOfWavelengths);
  const std::size_t pixels = enlarger.Columns.size() * enlarger.Rows.size();
  image.Extent = extent;
  image.NumberOfWavelengths = coarse.NumberOfWavelengths;
  image.NumberOfOcclusionRays = coarse.NumberOfOcclusionRays;
  for (const Floats values : spectra)
  {
    (image.*values).Resize((coarse.*values).empty() ? 0 : pixels * wavelengths);
  }
  for (const Floats values : numbers)
  {
    (image.*values).Resize((coarse.*values).empty() ? 0 : pixels);
  }
  image.SampleCount.Resize(pixels);
  return ParallelFor(static_cast<vtkIdType>(enlarger.Rows.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
      {
        for (const Floats values : spectra)
        {
          if (!(image.*values).empty())
          {
            enlarger.Linear(row, coarse.*values, wavelengths, image.*values);
          }
        }
        for (const Floats values : numbers)
        {
          if (!(image.*values).empty())
          {
            enlarger.Nearest(row, coarse.*values, image.*values);
          }
        }
        enlarger.Nearest(row, coarse.SampleCount, image.SampleCount);
      }
    });
}
} // anonymous namespace

std::vector<int> CoarseScales(int width, int height)
{
  std::vector<int> scales;
  int scale = finestScale;
  while (1.0 * width * height / scale / scale > fewPixels)
  {
    scale *= 2;
  }
  for (; scale >= finestScale && std::min(width, height) >= 2 * scale; scale /= 4)
  {
    scales.push_back(scale);
  }
  return scales;
}

bool RenderCoarse(ImageScene& scene, int scale, const Monitor& monitor, ScatteringImage& image)
{
  const ScatteringOptions whole = scene.Options;
  ScatteringOptions& options = scene.Options;
  options.Width = (whole.Width + scale - 1) / scale;
  options.Height = (whole.Height + scale - 1) / scale;
  options.RelativeErrorGoal = std::max(whole.RelativeErrorGoal, looseGoal);
  options.NumberOfEdgeSamples = 1;
  options.NumberOfPhotonPasses = std::min(whole.NumberOfPhotonPasses, 1);
  options.NumberOfPhotonsPerPass = std::min(whole.NumberOfPhotonsPerPass, fewPhotons);
  const std::array<int, 4> extent{ 0, options.Width - 1, 0, options.Height - 1 };
  constexpr double shareOfRendering = 0.95; // of the progress
  std::vector<ScatteringImage> images;
  const bool done = RenderScene(scene, { extent }, monitor.Part(0.0, shareOfRendering), images);
  scene.Options = whole;
  return done &&
    Enlarge(images.front(), { 0, whole.Width - 1, 0, whole.Height - 1 }, monitor.Part(shareOfRendering, 1.0), image);
}

} // namespace shadowcones
