// SPDX-License-Identifier: BSD-3-Clause
#include "scRenderScattering.h"

#include "scDensityGrid.h"
#include "scIndirectLight.h"
#include "scLightLegsChoice.h"
#include "scMediumSum.h"
#include "scMediumTerm.h"
#include "scMediumTerms.h"
#include "scPhotonEstimates.h"
#include "scPhotonMap.h"
#include "scPrimaryHits.h"
#include "scRandom.h"
#include "scRenderContext.h"
#include "scShadingScene.h"
#include "scSurfaceShader.h"
#include "scTileRange.h"
#include "scVisibleLight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace shadowcones
{
namespace
{
/// Of the progress of an image: a varying density is looked at before.
constexpr double shareOfPreparing = 0.1;
/// Of the progress of a light's medium term: every pixel is looked at before.
constexpr double shareOfLook = 0.5;
/// What a table of the density towards the light may bring into marches, which err by more.
constexpr LightLegsTolerance marchTolerance{ 2e-3, 4e-3 };

/// Before anything is found.
void SetPixels(std::size_t begin, std::size_t end, ScatteringImage& image)
{
  const auto fill = [](auto& values, std::size_t from, std::size_t to, auto value)
  { std::fill(values.begin() + from, values.begin() + to, value); };
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  for (PixelArray<float>* values : { &image.Radiance, &image.InScattering, &image.SurfaceRadiance })
  {
    fill(*values, begin * wavelengths, end * wavelengths, 0.0f);
  }
  fill(image.Transmittance, begin * wavelengths, end * wavelengths, 1.0f);
  fill(image.Depth, begin, end, -1.0f);
  for (PixelArray<float>* values : { &image.RelativeError, &image.MediumError, &image.SurfaceRelativeError })
  {
    fill(*values, begin, end, 0.0f);
  }
  fill(image.SampleCount, begin, end, 0);
}

/// Arrays of the right size are there at once; all threads set their values. @return false where aborted.
bool Allocate(
  const std::array<int, 4>& extent, std::size_t wavelengths, const Monitor& monitor, ScatteringImage& image)
{
  const auto columns = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto rows = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t pixels = columns * rows;
  image.Extent = extent;
  image.NumberOfWavelengths = static_cast<int>(wavelengths);
  for (PixelArray<float>* values :
    { &image.Radiance, &image.InScattering, &image.SurfaceRadiance, &image.Transmittance })
  {
    values->Resize(pixels * wavelengths);
  }
  for (PixelArray<float>* values :
    { &image.Depth, &image.RelativeError, &image.MediumError, &image.SurfaceRelativeError })
  {
    values->Resize(pixels);
  }
  image.SampleCount.Resize(pixels);
  for (PixelArray<float>* values : { &image.MultipleScattering, &image.IndirectSurface, &image.PhotonError })
  {
    values->Resize(0);
  }
  image.NumberOfOcclusionRays = 0;
  image.NumberOfShadowLines = 0;
  image.NumberOfThickRays = 0;
  image.MarchOpticalDepth = 0.0;
  image.NumberOfShortPixels = 0;
  image.WorstSurfaceError = 0.0;
  return ParallelFor(static_cast<vtkIdType>(pixels), monitor, [&image](vtkIdType begin, vtkIdType end)
    { SetPixels(static_cast<std::size_t>(begin), static_cast<std::size_t>(end), image); });
}

/// The pixels that are looked at for those of an extent.
std::array<int, 4> LookedExtent(const std::array<int, 4>& extent, const ScatteringOptions& options)
{
  return LitMinusBlocked::MayLookAround(options)
    ? LookedPixels::ExtentFor(
        LookedPixels::NumberOfLevels(options.Width, options.Height) - 1, extent, options.Width, options.Height)
    : extent;
}

/// One a light; none where the camera is not to see them.
std::vector<VisibleLight> VisibleLights(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options)
{
  std::vector<VisibleLight> lights;
  for (std::size_t k = 0; options.LightVisible && k < scenes.size(); ++k)
  {
    lights.emplace_back(scenes[k].Light);
  }
  return lights;
}

/// A medium whose density is the same all over its bounds is a homogeneous one: @p media keeps these.
std::vector<ScatteringScene> WithPlainMedia(const std::vector<ScatteringScene>& scenes, std::vector<Medium>& media)
{
  std::vector<ScatteringScene> plain;
  media.reserve(scenes.size()); // scenes refer to its items
  for (const ScatteringScene& scene : scenes)
  {
    double density = 0.0;
    if (!scene.Medium.Density || !IsConstantIn(*scene.Medium.Density, scene.Medium.Bounds, density))
    {
      plain.push_back(scene);
      continue;
    }
    media.push_back(scene.Medium);
    Medium& medium = media.back();
    medium.Density = nullptr;
    for (std::vector<double>* sigmas : { &medium.SigmaS, &medium.SigmaA })
    {
      std::for_each(sigmas->begin(), sigmas->end(), [density](double& sigma) { sigma *= density; });
    }
    plain.push_back({ scene.Occluders, scene.Light, medium, scene.Camera, scene.Cones, scene.Visibility, scene.Layout,
      scene.Photons, scene.Casters });
  }
  return plain;
}

/// Renders parts of an image; what they share is prepared once. Safe from many threads.
class ImageRenderer
{
public:
  /// Everything is referred to and must outlive the renderer.
  ImageRenderer(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options)
    : Scenes(WithPlainMedia(scenes, Media))
    , Options(options)
    , Visible(VisibleLights(Scenes, options))
    , Shading(Scenes, options, Visible)
    , Kept(Scenes.size())
  {
    for (const ScatteringScene& scene : this->Scenes)
    {
      this->Contexts.push_back(std::make_unique<RenderContext>(scene, options));
    }
  }

  /// Keep what costs a look at the whole image: it pays where more than one part is rendered.
  void PrepareForMany()
  {
    for (std::size_t light = 0; light < this->Scenes.size(); ++light)
    {
      this->Kept[light] = this->Prepare(light, {});
    }
  }

  /// All but what photons say. @param hits gets what the camera sees of the extent. @return false where aborted.
  bool Render(const std::array<int, 4>& extent, const Monitor& monitor, ScatteringImage& image,
    std::unique_ptr<const PrimaryHits>& hits) const;

  /// Does any light come from photons?
  bool HasIndirect() const { return this->Scenes.front().Photons || this->Options.NumberOfPhotonPasses > 0; }
  /// Add what photons say to images that are finished otherwise. @return false where aborted.
  bool AddIndirect(const std::vector<std::unique_ptr<const PrimaryHits>>& hits, const Monitor& monitor,
    std::vector<ScatteringImage>& images) const;

private:
  /// What the medium term of a light takes from a look at the whole image.
  struct Prepared
  {
    std::unique_ptr<LitMinusBlockedScene> Lit;
    std::unique_ptr<const LightLegs> Legs; ///< of marches
    MediumTerm::Shared Shared() const { return { this->Lit.get(), this->Legs.get() }; }
  };
  std::unique_ptr<Prepared> Prepare(std::size_t light, const Monitor& monitor) const;
  bool LookAround(
    MediumTerms& terms, const std::array<int, 4>& extent, const Monitor& monitor, LookedPixels& looked) const;
  bool RenderMedium(std::size_t light, const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const;
  bool RenderMedia(const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const;
  bool Shade(const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const;
  bool TracePass(int pass, const Monitor& monitor, PhotonEstimates& estimates) const;

  std::vector<Medium> Media; ///< those that were made plain
  const std::vector<ScatteringScene> Scenes;
  const ScatteringOptions& Options;
  const std::vector<VisibleLight> Visible;
  const ShadingScene Shading;
  std::vector<std::unique_ptr<RenderContext>> Contexts;   ///< one a light
  std::vector<std::unique_ptr<Prepared>> Kept;            ///< one a light, where kept
};

std::unique_ptr<ImageRenderer::Prepared> ImageRenderer::Prepare(std::size_t light, const Monitor& monitor) const
{
  const RenderContext& context = *this->Contexts[light];
  auto prepared = std::make_unique<Prepared>();
  if (!context.Groups.Scatters())
  {
    return prepared;
  }
  if (!IsMarched(this->Options.Mode))
  {
    prepared->Lit = std::make_unique<LitMinusBlockedScene>(context, monitor);
  }
  else if (context.Scene.Medium.Density)
  {
    const LitQuadrature quadrature(context.Scene.Light, context.Scene.Medium, context.Groups);
    prepared->Legs = ChooseLightLegs(quadrature, context.Scene.Camera, this->Options, marchTolerance, monitor);
  }
  return prepared;
}

/// First at few pixels, then at more of them where these do not tell what lies between. @return false where aborted.
bool ImageRenderer::LookAround(
  MediumTerms& terms, const std::array<int, 4>& extent, const Monitor& monitor, LookedPixels& looked) const
{
  for (int level = looked.Levels() - 1; level >= 0; --level)
  {
    const double done = 1.0 - (level + 1.0) / looked.Levels();
    // Who judges a coarse block reads all of its pixels: no other writes them meanwhile.
    if (!terms.ForTiles(LookedPixels::ExtentFor(level, extent, this->Options.Width, this->Options.Height),
          lookLevels[looked.Levels() - 1].Side, monitor.Part(done, done + 1.0 / looked.Levels()),
          [&looked, level](MediumTerm& term, const TileRange& tile) { term.LookAtTile(tile, level, looked); }))
    {
      return false;
    }
  }
  return true;
}

/// The medium term of one light: "InScattering", "RelativeError", "SampleCount" of an image of the right size.
bool ImageRenderer::RenderMedium(
  std::size_t light, const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const
{
  const RenderContext& context = *this->Contexts[light];
  if (!context.Groups.Scatters())
  {
    return true;
  }
  const double prepared = context.Scene.Medium.Density && !this->Kept[light] ? shareOfPreparing : 0.0;
  const std::unique_ptr<Prepared> own =
    this->Kept[light] ? nullptr : this->Prepare(light, monitor.Part(0.0, prepared));
  const MediumTerm::Shared shared = (own ? own : this->Kept[light])->Shared();
  MediumTerms terms(context, shared, hits, image);
  Monitor rest = monitor.Part(prepared, 1.0);
  std::unique_ptr<LookedPixels> looked;
  if (shared.Lit && LitMinusBlocked::LooksAround(*shared.Lit))
  {
    looked = std::make_unique<LookedPixels>(LookedExtent(image.Extent, this->Options),
      LookedPixels::NumberOfLevels(this->Options.Width, this->Options.Height), context.Groups.Count());
    terms.AskNeighbours(*looked);
    if (!LookAround(terms, image.Extent, rest.Part(0.0, shareOfLook), *looked))
    {
      return false;
    }
    rest = rest.Part(shareOfLook, 1.0);
  }
  const bool finished =
    terms.ForTiles(image.Extent, rest, [](MediumTerm& term, const TileRange& tile) { term.RenderTile(tile); });
  terms.AddCounts();
  return finished;
}

/// The medium terms of all lights.
bool ImageRenderer::RenderMedia(const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const
{
  if (this->Scenes.size() == 1)
  {
    return this->RenderMedium(0, hits, monitor, image);
  }
  constexpr double shareOfSetting = 0.03; // of a light's progress, and adding as much
  MediumSum sum;
  ScatteringImage term;
  const auto count = static_cast<double>(this->Scenes.size());
  for (std::size_t light = 0; light < this->Scenes.size(); ++light)
  {
    const auto done = static_cast<double>(light);
    const Monitor part = monitor.Part(done / (count + shareOfSetting), (done + 1.0) / (count + shareOfSetting));
    if (!Allocate(image.Extent, this->Scenes[light].Light.Spectrum.size(), part.Part(0.0, shareOfSetting), term) ||
      !this->RenderMedium(light, hits, part.Part(shareOfSetting, 1.0 - shareOfSetting), term) ||
      !sum.Add(term, part.Part(1.0 - shareOfSetting, 1.0)))
    {
      return false;
    }
  }
  return sum.Write(monitor.Part(count / (count + shareOfSetting), 1.0), image);
}

/// Surfaces, what is seen of the lights, and the sum of all.
bool ImageRenderer::Shade(const PrimaryHits& hits, const Monitor& monitor, ScatteringImage& image) const
{
  std::mutex gathering;
  const int columns = image.Extent[1] - image.Extent[0] + 1;
  const bool finished = ParallelFor(static_cast<vtkIdType>(image.Depth.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      SurfaceShader shader(this->Shading, hits, image);
      for (vtkIdType index = begin; index < end; ++index)
      {
        const auto i = image.Extent[0] + static_cast<int>(index % columns);
        const auto j = image.Extent[2] + static_cast<int>(index / columns);
        shader.Shade(i, j);
      }
      const std::lock_guard<std::mutex> lock(gathering);
      image.NumberOfOcclusionRays += shader.NumberOfOcclusionRays();
      image.NumberOfShortPixels += shader.NumberOfShortPixels();
      image.WorstSurfaceError = std::max(image.WorstSurfaceError, shader.WorstError());
    });
  return finished;
}

/// Photons of a pass, ready to be asked: those of another pass are independent of them.
bool ImageRenderer::TracePass(int pass, const Monitor& monitor, PhotonEstimates& estimates) const
{
  constexpr double shareOfTracing = 0.6; // of the progress
  constexpr std::uint64_t passStream = 0x706173736573ull;
  std::vector<Light> lights;
  std::transform(this->Scenes.begin(), this->Scenes.end(), std::back_inserter(lights),
    [](const ScatteringScene& scene) { return scene.Light; });
  PhotonMapOptions options;
  options.NumberOfPhotons = this->Options.NumberOfPhotonsPerPass;
  options.Reflectance = this->Options.Reflectance;
  options.SurfaceReflectance = this->Options.SurfaceReflectance;
  options.ReflectanceComponents = this->Options.ReflectanceComponents;
  options.Seed = HashSeed(HashSeed(this->Options.Seed, passStream), static_cast<std::uint64_t>(pass));
  const ScatteringScene& scene = this->Scenes.front();
  PhotonMap map;
  return TracePhotonMap({ scene.Occluders, lights, scene.Medium }, options, monitor.Part(0.0, shareOfTracing), map) &&
    PreparePhotonEstimates(std::move(map.Surface), std::move(map.Volume), this->Options.PhotonNeighbours,
      this->Options.NumberOfPhotonPasses, monitor.Part(shareOfTracing, 1.0), estimates);
}

bool ImageRenderer::AddIndirect(const std::vector<std::unique_ptr<const PrimaryHits>>& hits, const Monitor& monitor,
  std::vector<ScatteringImage>& images) const
{
  struct Item
  {
    std::size_t Image;
    TileRange Tile;
  };
  std::vector<Item> items;
  for (std::size_t k = 0; k < images.size(); ++k)
  {
    ScatteringImage& image = images[k];
    for (PixelArray<float>* values : { &image.MultipleScattering, &image.IndirectSurface })
    {
      values->Resize(image.Radiance.size());
      std::fill(values->begin(), values->end(), 0.0f);
    }
    image.PhotonError.Resize(image.Depth.size());
    std::fill(image.PhotonError.begin(), image.PhotonError.end(), 0.0f);
    for (const TileRange& tile : TilesOf(image.Extent, IndirectLight::TileSide))
    {
      items.push_back({ k, tile });
    }
  }
  const ScatteringScene& scene = this->Scenes.front();
  const int passes = scene.Photons ? 1 : this->Options.NumberOfPhotonPasses;
  const double traced = scene.Photons ? 0.0 : 0.5; // of a pass
  for (int pass = 0; pass < passes; ++pass)
  {
    const Monitor part = monitor.Part(static_cast<double>(pass) / passes, (pass + 1.0) / passes);
    PhotonEstimates own; // only for this pass
    if (!scene.Photons && !this->TracePass(pass, part.Part(0.0, traced), own))
    {
      return false;
    }
    const IndirectPass now{ scene.Photons ? *scene.Photons : own, pass, passes };
    const bool added = ParallelFor(static_cast<vtkIdType>(items.size()), part.Part(traced, 1.0),
      [&](vtkIdType begin, vtkIdType end)
      {
        IndirectLight indirect(scene, this->Options, this->Shading.Groups, now);
        for (vtkIdType k = begin; k < end; ++k)
        {
          const Item& item = items[static_cast<std::size_t>(k)];
          indirect.Add(item.Tile, *hits[item.Image], images[item.Image]);
        }
      });
    if (!added)
    {
      return false;
    }
  }
  for (ScatteringImage& image : images)
  {
    FinishIndirect(passes, 0, image.Depth.size(), image);
  }
  return true;
}

bool ImageRenderer::Render(const std::array<int, 4>& extent, const Monitor& monitor, ScatteringImage& image,
  std::unique_ptr<const PrimaryHits>& hits) const
{
  auto traced = std::make_unique<PrimaryHits>(this->Scenes.front(), this->Options, LookedExtent(extent, this->Options), this->Visible);
  const bool finished = Allocate(extent, this->Scenes.front().Light.Spectrum.size(), monitor.Part(0.0, 0.01), image) &&
    traced->Trace(monitor.Part(0.01, 0.05)) && this->RenderMedia(*traced, monitor.Part(0.05, 0.8), image) &&
    this->Shade(*traced, monitor.Part(0.8, 1.0), image);
  hits = this->HasIndirect() ? std::move(traced) : nullptr; // no other asks for them
  return finished;
}

void ThrowWhereWrong(const ScatteringOptions& options)
{
  if (const char* fault = CheckScatteringOptions(options))
  {
    throw std::invalid_argument(fault);
  }
}
} // anonymous namespace

bool RenderScattering(
  const ScatteringScene& scene, const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image)
{
  return RenderScattering(std::vector<ScatteringScene>{ scene }, options, monitor, image);
}

bool RenderScattering(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const Monitor& monitor, ScatteringImage& image)
{
  std::vector<ScatteringImage> images(1);
  std::swap(images.front(), image); // its memory is used again
  const bool finished = RenderScattering(scenes, options, { options.Extent }, monitor, images);
  std::swap(images.front(), image);
  return finished;
}

bool RenderScattering(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const std::vector<std::array<int, 4>>& extents, const Monitor& monitor, std::vector<ScatteringImage>& images)
{
  images.resize(extents.size());
  if (extents.empty())
  {
    return true;
  }
  ScatteringOptions whole = options;
  for (const std::array<int, 4>& extent : extents)
  {
    whole.Extent = extent;
    ThrowWhereWrong(whole);
  }
  constexpr double pixelsOfSquare = 1024.0;
  const auto pixels = [](const std::array<int, 4>& e) { return (e[1] - e[0] + 1.0) * (e[3] - e[2] + 1.0); };
  double all = 0.0;
  std::vector<std::size_t> squares;
  for (std::size_t k = 0; k < extents.size(); ++k)
  {
    all += pixels(extents[k]);
    if (extents.size() > 1 && pixels(extents[k]) <= pixelsOfSquare)
    {
      squares.push_back(k);
    }
  }
  ImageRenderer renderer(scenes, whole);
  if (extents.size() > 1)
  {
    renderer.PrepareForMany();
  }
  const double shareOfDirect = !renderer.HasIndirect() ? 1.0 : scenes.front().Photons ? 0.85 : 0.4;
  const Monitor direct = monitor.Part(0.0, shareOfDirect);
  std::vector<std::unique_ptr<const PrimaryHits>> hits(extents.size());
  double done = 0.0;
  for (std::size_t k = 0; k < extents.size(); ++k)
  {
    const double size = pixels(extents[k]);
    if (extents.size() == 1 || size > pixelsOfSquare)
    {
      if (!renderer.Render(extents[k], direct.Part(done / all, (done + size) / all), images[k], hits[k]))
      {
        return false;
      }
      done += size;
    }
  }
  // A small part has no tiles for several threads: these are shared out whole.
  const bool finished = squares.empty() ||
    ParallelFor(static_cast<vtkIdType>(squares.size()), direct.Part(done / all, 1.0),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::size_t k = squares[static_cast<std::size_t>(i)];
          renderer.Render(extents[k], {}, images[k], hits[k]);
        }
      });
  return finished && (!renderer.HasIndirect() || renderer.AddIndirect(hits, monitor.Part(shareOfDirect, 1.0), images));
}

} // namespace shadowcones
