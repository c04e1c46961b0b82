// SPDX-License-Identifier: BSD-3-Clause
#include "scIndirectLight.h"

#include "scMediumInterval.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

IndirectLight::IndirectLight(const ScatteringScene& scene, const ScatteringOptions& options,
  const ExtinctionGroups& groups, const IndirectPass& pass)
  : Scene(scene)
  , Options(options)
  , Pass(pass)
  , Points(scene, options, groups)
  , OpticalDepth(scene.Medium)
  , InMedium(scene.Medium)
  , Medium(groups.GroupOf.size())
  , Surface(groups.GroupOf.size())
{
}

void IndirectLight::Add(const TileRange& tile, const PrimaryHits& hits, ScatteringImage& image)
{
  this->InMedium.Clear(this->Pass.Photons.Volume.Origin());
  this->OnSurfaces.Clear();
  this->Rays.clear();
  this->Throughputs.clear();
  for (int j = tile.J0; j <= tile.J1; ++j)
  {
    for (int i = tile.I0; i <= tile.I1; ++i)
    {
      hits.RaysOf(i, j, this->PixelRays);
      for (const PixelRay& ray : this->PixelRays)
      {
        this->Rays.push_back({ ray, image.IndexOf(i, j) });
        this->AddRay(this->Rays.back());
      }
    }
  }
  this->Pass.Photons.Volume.Gather(this->InMedium);
  this->Pass.Photons.Surface.Estimate(this->OnSurfaces);
  for (std::size_t begin = 0; begin < this->Rays.size();)
  {
    std::size_t end = begin;
    while (end < this->Rays.size() && this->Rays[end].Pixel == this->Rays[begin].Pixel)
    {
      ++end;
    }
    this->AddRaysOf(this->Rays[begin].Pixel, begin, end, image);
    begin = end;
  }
}

/// To the packets.
void IndirectLight::AddRay(TileRay& ray)
{
  const PixelRay& part = ray.Ray;
  const OccluderScene& occluders = this->Scene.Occluders;
  const MediumInterval interval = MediumIntervalOf(this->Scene.Medium.Bounds, occluders, part.Line, part.Hit);
  if (!this->Pass.Photons.Volume.Empty() && interval.Crosses)
  {
    // Photons lie inside the medium: beyond where the ray leaves it there are none but those of a slanted border.
    const bool ends = part.Hit.HasSurface() && interval.End >= part.Hit.T;
    this->OpticalDepth.SetRay(part.Line.Origin, part.Line.Direction, interval.Begin, interval.End);
    ray.InMedium = this->InMedium.Count();
    this->InMedium.Add(
      { part.Line, interval, ends ? NormalTowards(occluders, part.Line, part.Hit) : Vector3{} },
      [this](double t) { return this->OpticalDepth.Along(t); });
  }
  if (!this->Pass.Photons.Surface.Empty() && part.Hit.HasSurface() && this->Options.NumberOfSurfaceLightSamples > 0)
  {
    this->Points.Find(part.Line, part.Hit, this->Point);
    ray.OnSurface = this->OnSurfaces.Count();
    this->OnSurfaces.Add(this->Point.Position, this->Point.Facet);
    for (const double throughput : this->Point.Throughput)
    {
      this->Throughputs.push_back(throughput);
      ray.Throughput += throughput / static_cast<double>(this->Surface.size());
    }
  }
}

/// What the rays of a pixel have found.
void IndirectLight::AddRaysOf(std::size_t pixel, std::size_t begin, std::size_t end, ScatteringImage& image)
{
  const std::size_t wavelengths = this->Medium.size();
  std::fill(this->Medium.begin(), this->Medium.end(), 0.0);
  std::fill(this->Surface.begin(), this->Surface.end(), 0.0);
  double variance = 0.0;
  for (std::size_t r = begin; r < end; ++r)
  {
    const TileRay& ray = this->Rays[r];
    const double fraction = ray.Ray.Fraction;
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      this->Medium[k] += ray.InMedium == none ? 0.0 : fraction * this->InMedium.Radiance(ray.InMedium, k);
      this->Surface[k] += ray.OnSurface == none
        ? 0.0
        : fraction * this->Throughputs[ray.OnSurface * wavelengths + k] * this->OnSurfaces.Irradiance(ray.OnSurface, k);
    }
    // Rays of a pixel gather the same photons: their errors add up, at most.
    variance += ray.InMedium == none ? 0.0 : fraction * this->InMedium.Variance(ray.InMedium);
    variance += ray.OnSurface == none
      ? 0.0
      : fraction * ray.Throughput * ray.Throughput * this->OnSurfaces.Variance(ray.OnSurface);
  }
  const double share = 1.0 / this->Pass.Count;
  double mean = 0.0;
  double before = 0.0;
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    float& medium = image.MultipleScattering[pixel * wavelengths + k];
    float& surface = image.IndirectSurface[pixel * wavelengths + k];
    before += static_cast<double>(medium) + static_cast<double>(surface);
    medium += static_cast<float>(share * this->Medium[k]);
    surface += static_cast<float>(share * this->Surface[k]);
    mean += (this->Medium[k] + this->Surface[k]) / static_cast<double>(wavelengths);
  }
  float& error = image.PhotonError[pixel];
  if (this->Pass.Count == 1)
  {
    error = static_cast<float>(variance);
    return;
  }
  before *= this->Pass.Number > 0 ? 1.0 / (share * this->Pass.Number * static_cast<double>(wavelengths)) : 0.0;
  const double difference = this->Pass.Number > 0 ? mean - before : 0.0;
  error += static_cast<float>(difference * difference * this->Pass.Number / (this->Pass.Number + 1.0));
}

void FinishIndirect(int passes, std::size_t begin, std::size_t end, ScatteringImage& image)
{
  const auto wavelengths = static_cast<std::size_t>(image.NumberOfWavelengths);
  const double share = passes > 1 ? 1.0 / (passes * (passes - 1.0)) : 1.0;
  for (std::size_t pixel = begin; pixel < end; ++pixel)
  {
    double mean = 0.0;
    for (std::size_t k = pixel * wavelengths; k < (pixel + 1) * wavelengths; ++k)
    {
      const float found = image.MultipleScattering[k] + image.IndirectSurface[k];
      image.Radiance[k] += found;
      mean += static_cast<double>(found) / static_cast<double>(wavelengths);
    }
    float& error = image.PhotonError[pixel];
    error = mean > 0.0 ? static_cast<float>(std::sqrt(share * static_cast<double>(error)) / mean) : 0.0f;
  }
}

} // namespace shadowcones
