// SPDX-License-Identifier: BSD-3-Clause
#include "scIndirectLight.h"

#include "scMediumInterval.h"
#include "scPhaseFunction.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

IndirectLight::IndirectLight(const ScatteringScene& scene, const ScatteringOptions& options,
  const ExtinctionGroups& groups, const PrimaryHits& hits, ScatteringImage& image)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , Hits(hits)
  , Image(image)
  , Points(scene, options, groups)
  , OpticalDepth(scene.Medium)
  , Medium(groups.GroupOf.size())
  , Surface(groups.GroupOf.size())
  , Transmittance(groups.SigmaT.size())
{
}

void IndirectLight::Add(int i, int j)
{
  std::fill(this->Medium.begin(), this->Medium.end(), 0.0);
  std::fill(this->Surface.begin(), this->Surface.end(), 0.0);
  this->Variance = 0.0;
  this->Hits.RaysOf(i, j, this->Rays);
  for (const PixelRay& part : this->Rays)
  {
    this->AddMedium(part);
    this->AddSurface(part);
  }
  const std::size_t wavelengths = this->Medium.size();
  const std::size_t index = this->Image.IndexOf(i, j);
  double mean = 0.0;
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    const std::size_t value = index * wavelengths + k;
    this->Image.MultipleScattering[value] = static_cast<float>(this->Medium[k]);
    this->Image.IndirectSurface[value] = static_cast<float>(this->Surface[k]);
    this->Image.Radiance[value] += static_cast<float>(this->Medium[k] + this->Surface[k]);
    mean += (this->Medium[k] + this->Surface[k]) / static_cast<double>(wavelengths);
  }
  this->Image.PhotonError[index] = mean > 0.0 ? static_cast<float>(std::sqrt(this->Variance) / mean) : 0.0f;
}

void IndirectLight::AddMedium(const PixelRay& part)
{
  const PhotonDiscs& discs = this->Scene.Photons->Volume;
  const MediumInterval interval =
    MediumIntervalOf(this->Scene.Medium.Bounds, this->Scene.Occluders, part.Line, part.Hit);
  if (discs.Empty() || !interval.Crosses)
  {
    return;
  }
  this->OpticalDepth.SetRay(part.Line.Origin, part.Line.Direction, interval.Begin, interval.End);
  const StoredPhotons& photons = discs.Photons();
  const double fraction = part.Fraction / static_cast<double>(this->Medium.size());
  // Photons lie inside the medium: beyond where the ray leaves it there are none but those of a slanted border.
  const bool endsOnSurface = part.Hit.HasSurface() && interval.End >= part.Hit.T;
  const Vector3 facet = endsOnSurface ? NormalTowards(this->Scene.Occluders, part.Line, part.Hit) : Vector3{};
  const Vector3 end = part.Line.Origin + interval.End * part.Line.Direction;
  const double cosine = std::max(std::fabs(Dot(part.Line.Direction, facet)), 0.1);
  const double slant = std::sqrt(1.0 - std::min(cosine, 1.0) * std::min(cosine, 1.0)) / cosine;
  discs.ForEachPierced(part.Line, { 0.0, endsOnSurface ? interval.End : HUGE_VAL }, slant,
    [&](const PhotonDiscs::Pierced& pierced)
    {
      if (endsOnSurface && Dot(photons.Point(pierced.Photon) - end, facet) < 0.0)
      {
        return; // behind the surface
      }
      const double depth = this->OpticalDepth.Along(pierced.T);
      const double turn = -Dot(photons.Direction(pierced.Photon), part.Line.Direction);
      const double scattered = pierced.Kernel * EvaluatePhaseFunction(this->Scene.Medium.Phase, turn);
      for (std::size_t group = 0; group < this->Transmittance.size(); ++group)
      {
        this->Transmittance[group] = scattered * TransmittanceOver(this->Groups.SigmaT[group], depth);
      }
      const float* power = photons.Power(pierced.Photon);
      double mean = 0.0;
      for (std::size_t k = 0; k < this->Medium.size(); ++k)
      {
        const double value = power[k] * this->Transmittance[static_cast<std::size_t>(this->Groups.GroupOf[k])];
        this->Medium[k] += part.Fraction * value;
        mean += fraction * value;
      }
      this->Variance += mean * mean;
    });
}

void IndirectLight::AddSurface(const PixelRay& part)
{
  const SurfacePhotons& photons = this->Scene.Photons->Surface;
  if (photons.Empty() || !part.Hit.HasSurface() || this->Options.NumberOfSurfaceLightSamples == 0)
  {
    return;
  }
  this->Points.Find(part.Line, part.Hit, this->Point);
  photons.Estimate(this->Point.Position, this->Point.Facet, this->Query);
  double throughput = 0.0;
  for (std::size_t k = 0; k < this->Surface.size(); ++k)
  {
    this->Surface[k] += part.Fraction * this->Point.Throughput[k] * this->Query.Irradiance[k];
    throughput += part.Fraction * this->Point.Throughput[k] / static_cast<double>(this->Surface.size());
  }
  this->Variance += throughput * throughput * this->Query.Variance;
}

} // namespace shadowcones
