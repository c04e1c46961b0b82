// SPDX-License-Identifier: BSD-3-Clause
#include "scScatteringImage.h"

#include "scMediumTerm.h"
#include "scPrimaryHits.h"
#include "scSurfaceShader.h"
#include "scVisibleLight.h"

#include <atomic>
#include <memory>

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
  image.SampleCount.assign(pixels, 0);
}

} // namespace

bool RenderScattering(const ScatteringScene& scene, const ScatteringOptions& options, const Monitor& monitor,
  ScatteringImage& image)
{
  const ExtinctionGroups groups(scene.Source.Spectrum, scene.Fog);
  const LightStrata strata(options.NumberOfLightSamples);
  const VisibleLight visibleLight(scene.Source);
  Allocate(options, scene.Source.Spectrum.size(), image);
  std::atomic<vtkIdType> occlusionRays{ 0 };

  PrimaryHits hits(scene, options, options.LightVisible ? &visibleLight : nullptr);
  if (!hits.Trace(monitor.Part(0.0, 0.05)))
  {
    return false;
  }

  std::unique_ptr<LitMinusBlockedScene> lit;
  if (options.Mode == ScatteringMode::Guided || options.Mode == ScatteringMode::Soft ||
    options.Mode == ScatteringMode::Volume)
  {
    lit = std::make_unique<LitMinusBlockedScene>(scene, options, groups);
  }
  const std::vector<TileRange> tiles = TilesOf(options.Extent, MediumTerm::TileSide(options.Mode));
  const auto renderTiles = [&](vtkIdType begin, vtkIdType end)
  {
    MediumTerm term(scene, options, groups, strata, lit.get(), hits, image);
    for (vtkIdType tile = begin; tile < end; ++tile)
    {
      term.RenderTile(tiles[static_cast<std::size_t>(tile)]);
    }
    occlusionRays += term.NumberOfOcclusionRays();
  };
  if (groups.Scatters() && !ParallelFor(static_cast<vtkIdType>(tiles.size()), monitor.Part(0.05, 0.8), renderTiles))
  {
    return false;
  }

  const ShadingScene shading(scene, options, groups, visibleLight, hits);
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
  image.NumberOfOcclusionRays = occlusionRays;
  return finished;
}

} // namespace shadowcones
