// SPDX-License-Identifier: BSD-3-Clause
#include "scRayCheck.h"

#include "scImageScene.h"
#include "scRandom.h"
#include "scScatteringOptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace shadowcones
{
namespace
{
constexpr std::uint32_t fewPixels = 64;
constexpr double looseGoal = 0.05;

/// Spread over the image, each by itself.
std::vector<std::array<int, 4>> SomePixels(const ScatteringOptions& options)
{
  std::vector<std::array<int, 4>> pixels;
  for (std::uint32_t k = 0; k < fewPixels; ++k)
  {
    const auto uv = SobolPoint(options.Seed, k);
    const int i = std::min(static_cast<int>(uv[0] * options.Width), options.Width - 1);
    const int j = std::min(static_cast<int>(uv[1] * options.Height), options.Height - 1);
    pixels.push_back({ i, i, j, j });
  }
  return pixels;
}

/// All wavelengths of a pixel together.
double LightOf(const ScatteringImage& image, std::size_t pixel)
{
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  const float* first = image.InScattering.data() + pixel * wavelengths;
  return std::accumulate(first, first + wavelengths, 0.0);
}
} // anonymous namespace

bool CheckByRays(ImageScene& scene, const ScatteringImage& image, const Monitor& monitor, RayCheck& check)
{
  const ScatteringOptions chosen = scene.Options;
  const bool asksNoRays = chosen.Mode == ScatteringMode::Fast || chosen.Mode == ScatteringMode::Soft;
  if (!asksNoRays || scene.Mesh->Mesh.Triangles.empty())
  {
    return true;
  }
  scene.Options.Mode = ScatteringMode::Guided;
  scene.Options.RelativeErrorGoal = looseGoal;
  scene.Options.NumberOfEdgeSamples = 1;
  scene.Options.NumberOfSurfaceLightSamples = 0;
  scene.Options.NumberOfPhotonPasses = 0;
  const bool hadCones = std::exchange(scene.HasCones, false);
  auto grids = std::exchange(scene.Grids, nullptr);
  auto photons = std::exchange(scene.Photons, nullptr);
  const std::vector<std::array<int, 4>> pixels = SomePixels(chosen);
  std::vector<ScatteringImage> found;
  const bool done = RenderScene(scene, pixels, monitor, found);
  scene.Options = chosen;
  scene.HasCones = hadCones;
  scene.Grids = std::move(grids);
  scene.Photons = std::move(photons);
  if (!done)
  {
    return false;
  }
  double shown = 0.0;
  double right = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < pixels.size(); ++k)
  {
    const auto pixel = static_cast<std::size_t>(pixels[k][2]) * static_cast<std::size_t>(chosen.Width) +
      static_cast<std::size_t>(pixels[k][0]);
    const double is = LightOf(image, pixel);
    const double be = LightOf(found[k], 0);
    shown += is;
    right += be;
    squares += (is - be) * (is - be);
  }
  if (right > 0.0)
  {
    const auto count = static_cast<double>(pixels.size());
    check.Mode = chosen.Mode == ScatteringMode::Fast ? "Fast" : "Soft";
    check.Pixels = static_cast<int>(pixels.size());
    check.Light = shown / right;
    check.Error = std::sqrt(squares / count) / (right / count);
  }
  return true;
}

} // namespace shadowcones
