// SPDX-License-Identifier: BSD-3-Clause
#include "scCoarseImage.h"

#include "scImageScene.h"
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

  std::vector<float> Linear(const std::vector<float>& coarse, std::size_t components) const
  {
    std::vector<float> values;
    values.reserve(this->Columns.size() * this->Rows.size() * components);
    for (const Between& j : this->Rows)
    {
      for (const Between& i : this->Columns)
      {
        for (std::size_t c = 0; c < components; ++c)
        {
          const auto at = [&](std::size_t row, std::size_t column)
          { return coarse[(row * this->Stride + column) * components + c]; };
          const float below = at(j.Low, i.Low) + i.Fraction * (at(j.Low, i.High) - at(j.Low, i.Low));
          const float above = at(j.High, i.Low) + i.Fraction * (at(j.High, i.High) - at(j.High, i.Low));
          values.push_back(below + j.Fraction * (above - below));
        }
      }
    }
    return values;
  }
  template <typename T>
  std::vector<T> Nearest(const std::vector<T>& coarse) const
  {
    const auto nearest = [](const Between& b) { return b.Fraction < 0.5f ? b.Low : b.High; };
    std::vector<T> values;
    values.reserve(this->Columns.size() * this->Rows.size());
    for (const Between& j : this->Rows)
    {
      for (const Between& i : this->Columns)
      {
        values.push_back(coarse[nearest(j) * this->Stride + nearest(i)]);
      }
    }
    return values;
  }
};

ScatteringImage Enlarge(const ScatteringImage& coarse, const std::array<int, 4>& extent)
{
  const int width = coarse.Extent[1] + 1;
  const int height = coarse.Extent[3] + 1;
  const Enlarger enlarger{ PlacesAlong(extent[1] + 1, width), PlacesAlong(extent[3] + 1, height),
    static_cast<std::size_t>(width) };
  const auto wavelengths = static_cast<std::size_t>(coarse.NumberOfWavelengths);
  ScatteringImage image = coarse;
  image.Extent = extent;
  for (std::vector<float> ScatteringImage::*values : { &ScatteringImage::Radiance, &ScatteringImage::InScattering,
         &ScatteringImage::SurfaceRadiance, &ScatteringImage::Transmittance,
         &ScatteringImage::MultipleScattering, &ScatteringImage::IndirectSurface })
  {
    image.*values = (coarse.*values).empty() ? std::vector<float>() : enlarger.Linear(coarse.*values, wavelengths);
  }
  image.Depth = enlarger.Nearest(coarse.Depth);
  image.RelativeError = enlarger.Nearest(coarse.RelativeError);
  image.MediumError = enlarger.Nearest(coarse.MediumError);
  image.SampleCount = enlarger.Nearest(coarse.SampleCount);
  image.PhotonError = coarse.PhotonError.empty() ? std::vector<float>() : enlarger.Nearest(coarse.PhotonError);
  return image;
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
  const std::array<int, 4> extent{ 0, options.Width - 1, 0, options.Height - 1 };
  std::vector<ScatteringImage> images;
  const bool done = RenderScene(scene, { extent }, monitor, images);
  scene.Options = whole;
  if (done)
  {
    image = Enlarge(images.front(), { 0, whole.Width - 1, 0, whole.Height - 1 });
  }
  return done;
}

} // namespace shadowcones
