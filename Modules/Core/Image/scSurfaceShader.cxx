// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfaceShader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{

SurfaceShader::SurfaceShader(const ShadingScene& shading, const PrimaryHits& hits, ScatteringImage& image)
  : Shading(shading)
  , Hits(hits)
  , Options(shading.Options)
  , Groups(shading.Groups)
  , Image(image)
  , OpticalDepth(shading.Scenes.front().Medium)
  , Points(shading.Scenes.front(), shading.Options, shading.Groups)
  , Surface(shading.Groups.GroupOf.size())
  , SeenLight(shading.Groups.GroupOf.size())
{
  for (const std::unique_ptr<const ShadingLight>& light : shading.Lights)
  {
    this->Lights.push_back(std::make_unique<SurfaceLight>(*light, this->Options, this->Groups));
    this->Darkest += light->Darkest;
  }
}

vtkIdType SurfaceShader::NumberOfOcclusionRays() const
{
  return std::accumulate(this->Lights.begin(), this->Lights.end(), vtkIdType(0),
    [](vtkIdType sum, const std::unique_ptr<SurfaceLight>& light) { return sum + light->NumberOfOcclusionRays(); });
}

void SurfaceShader::Shade(int i, int j)
{
  std::fill(this->Surface.begin(), this->Surface.end(), 0.0);
  std::fill(this->SeenLight.begin(), this->SeenLight.end(), 0.0);
  this->StopsShort = false;
  this->Hits.RaysOf(i, j, this->Rays);
  this->FindParts();
  double error = 0.0;
  const PixelShift shift(i, j);
  for (std::size_t light = 0; light < this->Lights.size(); ++light)
  {
    // The lights' samples are the same ones, and so may be their errors.
    error += this->AddSurfaces(light, shift);
  }
  for (const PixelRay& part : this->Rays)
  {
    if (part.Hit.LightsSeen)
    {
      this->AddSeenLight(part.Line, part.Hit, part.Fraction);
    }
  }
  this->Write(this->Image.IndexOf(i, j), this->Hits.RayOf(i, j), this->Hits.At(i, j), error);
}

/// List the surfaces of the pixel's rays.
void SurfaceShader::FindParts()
{
  this->NumberOfParts = 0;
  if (this->Options.NumberOfSurfaceLightSamples == 0)
  {
    return;
  }
  this->Parts.resize(std::max(this->Parts.size(), this->Rays.size()));
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const PixelRay& ray = this->Rays[k];
    if (ray.Hit.HasSurface())
    {
      Part& part = this->Parts[this->NumberOfParts++];
      part.Fraction = ray.Fraction;
      part.Key = k;
      part.Source = &ray;
      this->Points.Find(ray.Line, ray.Hit, part.Point);
    }
  }
}

double SurfaceShader::AddSurfaces(std::size_t light, const PixelShift& shift)
{
  SurfaceLight& lamp = *this->Lights[light];
  const ShadingLight& shading = *this->Shading.Lights[light];
  const int samples = (this->Options.NumberOfSurfaceLightSamples + 1) / 2;
  double shown = 0.0;
  for (std::size_t k = 0; k < this->NumberOfParts; ++k)
  {
    Part& part = this->Parts[k];
    part.Lit = this->Options.Mode != ScatteringMode::Fast ||
      !this->InForeignCone(shading.Scene.Cones, part.Source->Line, part.Source->Hit);
    if (part.Lit)
    {
      lamp.Look(part.Point, samples, part.Key, shift, part.Estimate);
      shown += part.Fraction * part.Estimate.Mean;
    }
  }

  const double goal = this->Options.RelativeErrorGoal;
  const double wanted = goal * std::max(shown, shading.Darkest);
  double variance = 0.0;
  for (std::size_t k = 0; k < this->NumberOfParts; ++k)
  {
    Part& part = this->Parts[k];
    if (!part.Lit)
    {
      continue;
    }
    // Of the pixel's squared error every surface has its share; dark ones may err as much as if they were lit.
    const double inTheDark = goal * part.Estimate.MeanLit;
    lamp.Finish(part.Point, wanted * wanted / part.Fraction, inTheDark * inTheDark / part.Fraction, part.Key, shift,
      part.Estimate);
    this->AddPart(light, part);
    this->StopsShort = this->StopsShort || part.Estimate.StopsShort;
    variance += part.Fraction * part.Fraction * part.Estimate.Variance;
  }
  return std::sqrt(variance);
}

void SurfaceShader::AddPart(std::size_t light, const Part& part)
{
  const ShadingLight& shading = *this->Shading.Lights[light];
  const double scale = part.Fraction * shading.Occlusion.VisibleFraction(part.Point.Position, part.Point.Facet);
  for (std::size_t k = 0; k < this->Surface.size(); ++k)
  {
    this->Surface[k] += scale * part.Point.Throughput[k] * shading.Scene.Light.Spectrum[k] *
      part.Estimate.Irradiance[static_cast<std::size_t>(this->Groups.GroupOf[k])];
  }
}

void SurfaceShader::AddSeenLight(const Ray& ray, const PrimaryHit& hit, double fraction)
{
  const double end = hit.T + RoundingAlong(ray.Origin, hit.T);
  for (std::size_t light = 0; light < this->Shading.Visible.size(); ++light)
  {
    double t = 0.0;
    double scale = 0.0;
    if (!this->Shading.Visible[light].Intersect(ray.Origin, ray.Direction, end, t, scale))
    {
      continue;
    }
    const std::vector<double>& spectrum = this->Shading.Scenes[light].Light.Spectrum;
    const double depth = this->OpticalDepth.TowardsFromOutside(ray.Origin, ray.Direction, t);
    for (std::size_t k = 0; k < this->SeenLight.size(); ++k)
    {
      const double sigmaT = this->Groups.SigmaT[static_cast<std::size_t>(this->Groups.GroupOf[k])];
      this->SeenLight[k] += fraction * scale * spectrum[k] * TransmittanceOver(sigmaT, depth);
    }
  }
}

/// Does Fast see the surface in shadow? Cones of the surface's own occluder do not count: their bases lie on it.
bool SurfaceShader::InForeignCone(const ConeHierarchy* cones, const Ray& ray, const PrimaryHit& hit)
{
  if (!cones)
  {
    return false;
  }
  const double probe = 4e-6 * hit.T;
  cones->Intersect(ray.Origin, ray.Direction, hit.T - probe, hit.T, this->Intervals, true);
  const int own = this->Shading.Scenes.front().Occluders.Mesh().OccluderId(hit.Triangle);
  return std::any_of(this->Intervals.begin(), this->Intervals.end(),
    [own](const OccluderInterval& interval) { return interval.OccluderId != own; });
}

/// The pixel, whose centre's ray hits this; @p error of the surfaces' mean over wavelengths.
void SurfaceShader::Write(std::size_t index, const Ray& ray, const PrimaryHit& hit, double error)
{
  ScatteringImage& image = this->Image;
  image.Depth[index] = hit.HasSurface() ? static_cast<float>(hit.T) : -1.0f;
  const double depth = this->OpticalDepth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  const std::size_t wavelengths = this->Surface.size();
  double mean = 0.0;
  double radiance = 0.0;
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    const std::size_t value = index * wavelengths + k;
    const double sigmaT = this->Groups.SigmaT[static_cast<std::size_t>(this->Groups.GroupOf[k])];
    image.Transmittance[value] = static_cast<float>(TransmittanceOver(sigmaT, depth));
    image.SurfaceRadiance[value] = static_cast<float>(this->Surface[k]);
    image.Radiance[value] = image.InScattering[value] + image.SurfaceRadiance[value];
    image.Radiance[value] += static_cast<float>(this->SeenLight[k]);
    mean += this->Surface[k] / static_cast<double>(wavelengths);
    radiance += image.Radiance[value] / static_cast<double>(wavelengths);
  }
  // An estimate of nothing may stand for something: it is wrong by all of it.
  const double relative = mean > 0.0 ? error / mean : (error > 0.0 ? 1.0 : 0.0);
  const bool isKnown = this->NumberOfParts == 0 ||
    (this->Options.Mode != ScatteringMode::Fast && this->Options.Mode != ScatteringMode::Soft);
  image.SurfaceRelativeError[index] = isKnown ? static_cast<float>(relative) : -1.0f;
  this->CountIfShort(radiance, error);
}

void SurfaceShader::CountIfShort(double radiance, double error)
{
  constexpr double slack = 1.5;
  const double relative = error / std::max({ radiance, this->Darkest, 1e-300 });
  if (this->StopsShort && relative > slack * this->Options.RelativeErrorGoal)
  {
    ++this->ShortPixels;
    this->Worst = std::max(this->Worst, relative);
  }
}

} // namespace shadowcones
