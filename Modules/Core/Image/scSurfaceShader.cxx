// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfaceShader.h"

#include "scConstants.h"
#include "scLitKernel.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

SurfaceShader::SurfaceShader(const ShadingScene& shading, const PrimaryHits& hits, ScatteringImage& image)
  : Shading(shading)
  , Hits(hits)
  , Scene(shading.Scenes.front())
  , Options(shading.Options)
  , Groups(shading.Groups)
  , Image(image)
  , OpticalDepth(shading.Scenes.front().Medium)
  , Surface(shading.Groups.GroupOf.size())
  , SeenLight(shading.Groups.GroupOf.size())
  , Sums(static_cast<std::size_t>(shading.Groups.Count()))
{
  for (const ScatteringScene& scene : shading.Scenes)
  {
    this->Samplers.emplace_back(scene.Light, shading.Options.Sampling);
  }
}

double SurfaceShader::SigmaT(std::size_t wavelength) const
{
  return this->Groups.SigmaT[static_cast<std::size_t>(this->Groups.GroupOf[wavelength])];
}

void SurfaceShader::Shade(int i, int j)
{
  const std::size_t index = this->Image.IndexOf(i, j);
  const std::uint64_t pixel = PixelIndex(this->Options, i, j);
  const Ray ray = this->Hits.RayOf(i, j);
  const PrimaryHit& hit = this->Hits.At(i, j);

  std::fill(this->Surface.begin(), this->Surface.end(), 0.0);
  std::fill(this->SeenLight.begin(), this->SeenLight.end(), 0.0);
  this->Hits.RaysOf(i, j, this->Rays);
  const bool isEdge = this->Rays.size() > 1;
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const PixelRay& part = this->Rays[k];
    this->AddRay(part.Line, part.Hit, isEdge ? this->Shading.EdgeStrata : this->Shading.Strata, pixel,
      isEdge ? k + 1 : 0, part.Fraction);
  }

  this->Image.Depth[index] = hit.HasSurface() ? static_cast<float>(hit.T) : -1.0f;
  const double depth = this->OpticalDepth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    this->Sums[g] = TransmittanceOver(this->Groups.SigmaT[g], depth);
  }
  const std::size_t wavelengths = this->Groups.GroupOf.size();
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    const std::size_t value = index * wavelengths + k;
    this->Image.Transmittance[value] =
      static_cast<float>(this->Sums[static_cast<std::size_t>(this->Groups.GroupOf[k])]);
    this->Image.SurfaceRadiance[value] = static_cast<float>(this->Surface[k]);
    this->Image.Radiance[value] = this->Image.InScattering[value] + this->Image.SurfaceRadiance[value];
    this->Image.Radiance[value] += static_cast<float>(this->SeenLight[k]);
  }
}

void SurfaceShader::AddRay(const Ray& ray, const PrimaryHit& hit, const LightStrata& strata, std::uint64_t pixel,
  std::uint64_t key, double fraction)
{
  if (hit.HasSurface() && strata.Count() > 0)
  {
    // Keys of march nodes end in 16 bits below the number of steps: these are no node's.
    this->AddSurface(ray, hit, strata, RandomStream(HashSeed(this->Options.Seed, pixel), ~key), fraction);
  }
  if (hit.LightsSeen)
  {
    this->AddLight(ray, hit, fraction);
  }
}

/// Direct light on a Lambertian surface, both sides alike, seen through the medium.
void SurfaceShader::AddSurface(
  const Ray& ray, const PrimaryHit& hit, const LightStrata& strata, RandomStream random, double fraction)
{
  const OccluderScene& occluders = this->Scene.Occluders;
  const Vector3 normal = NormalTowards(occluders, ray, hit);
  this->Point = ray.Origin + hit.T * ray.Direction + RoundingAlong(ray.Origin, hit.T) * normal;
  this->PointInside = this->Scene.Medium.Bounds.Contains(this->Point);
  this->CameraOpticalDepth = this->OpticalDepth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  for (std::size_t light = 0; light < this->Shading.Lights.size(); ++light)
  {
    const ConeHierarchy* cones = this->Shading.Scenes[light].Cones;
    if (this->Options.Mode != ScatteringMode::Fast || !this->InForeignCone(cones, ray, hit))
    {
      this->AddSurfaceLight(light, normal, hit.Triangle, strata, random, fraction);
    }
  }
}

void SurfaceShader::AddSurfaceLight(std::size_t light, const Vector3& normal, vtkIdType triangle,
  const LightStrata& strata, RandomStream random, double fraction)
{
  const ShadingLight& shading = *this->Shading.Lights[light];
  const bool trace = shading.Occlusion.NeedsRays(this->Point);
  std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
  if (!trace && shading.UsesRule)
  {
    this->AddRule(shading.RuleAt(this->Point), normal);
  }
  else
  {
    this->AddSamples(light, normal, strata, trace, random);
  }

  const double scale = fraction * shading.Occlusion.VisibleFraction(this->Point, normal) / Pi;
  for (std::size_t k = 0; k < this->Surface.size(); ++k)
  {
    const double irradiance =
      shading.Scene.Light.Spectrum[k] * this->Sums[static_cast<std::size_t>(this->Groups.GroupOf[k])];
    this->Surface[k] += scale * this->Reflectance(triangle, k) * irradiance;
  }
}

/// Add what a sample sends to the surface point, @p weight with the cosine to its normal; nothing is in the way.
void SurfaceShader::AddLit(const Vector3& direction, double distance, double weight)
{
  if (!(weight > 0.0))
  {
    return;
  }
  const double depth = this->CameraOpticalDepth +
    (this->PointInside ? this->OpticalDepth.Towards(this->Point, direction, distance)
                       : this->OpticalDepth.TowardsFromOutside(this->Point, direction, distance));
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    this->Sums[g] += weight * TransmittanceOver(this->Groups.SigmaT[g], depth);
  }
}

/// Add the light that nothing hides, without noise.
void SurfaceShader::AddRule(const LightRule& rule, const Vector3& normal)
{
  if (!this->PointInside || !this->OpticalDepth.IsHomogeneous() || !rule.IsByArea(this->Point))
  {
    rule.ForEach(this->Point,
      [&](const IncidentSample& sample)
      { this->AddLit(sample.Direction, sample.Distance, sample.Weight * Dot(sample.Direction, normal)); });
    return;
  }
  const LightPoints points = rule.AreaPoints();
  const auto count = static_cast<std::size_t>(points.Count);
  this->RuleValues.resize(3 * count);
  float* weight = this->RuleValues.data();
  float* cosine = weight + count;
  float* leg = cosine + count;
  // Of the surface's normal the cosine is asked, not of a ray's direction.
  LookAtLight(points, rule.ViewFrom(this->Point, normal, this->Scene.Medium.Bounds), weight, cosine, leg);
  for (std::size_t k = 0; k < count; ++k)
  {
    weight[k] *= std::max(cosine[k], 0.0f);
  }
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    const double sigmaT = this->Groups.SigmaT[g];
    const float sum = SumAttenuated(weight, leg, points.Count, static_cast<float>(sigmaT));
    this->Sums[g] += TransmittanceOver(sigmaT, this->CameraOpticalDepth) * static_cast<double>(sum);
  }
}

/// Add stratified samples of the light, those that the mesh hides left out where @p trace.
void SurfaceShader::AddSamples(
  std::size_t light, const Vector3& normal, const LightStrata& strata, bool trace, RandomStream& random)
{
  LightSampler& sampler = this->Samplers[light];
  sampler.MoveTo(this->Point);
  const int count = strata.Count();
  const double inverse = 1.0 / count;
  for (int first = 0; first < count; first += LightBatch::Size)
  {
    const int size = std::min(count - first, LightBatch::Size);
    std::uint64_t seen = this->DrawBatch(sampler, normal, strata, first, size, random);
    if (trace)
    {
      seen &= ~this->Occluded(light, seen);
    }
    for (int s = 0; s < size; ++s)
    {
      if ((seen >> s) & 1u)
      {
        this->AddLit(this->Batch.Directions[s], this->Batch.Distances[s], inverse * this->Batch.Weights[s]);
      }
    }
  }
}

/// Fill the batch; the answer has a bit for each sample that sends light to the surface if nothing is in the way.
std::uint64_t SurfaceShader::DrawBatch(LightSampler& sampler, const Vector3& normal, const LightStrata& strata,
  int first, int size, RandomStream& random)
{
  LightBatch& batch = this->Batch;
  std::uint64_t lit = 0;
  for (int s = 0; s < size; ++s)
  {
    const LightStrata::Point uv = strata.Draw(first + s, random);
    const IncidentSample sample = sampler.Sample(uv.U, uv.V);
    const double cosine = Dot(sample.Direction, normal);
    batch.Directions[s] = sample.Direction;
    batch.Distances[s] = sample.Distance;
    batch.Weights[s] = sample.Weight * cosine;
    lit |= static_cast<std::uint64_t>(sample.Weight > 0.0 && cosine > 0.0) << s;
  }
  return lit;
}

/// Which of the wanted samples of the batch does the mesh hide?
std::uint64_t SurfaceShader::Occluded(std::size_t light, std::uint64_t wanted)
{
  LightBatch& batch = this->Batch;
  const bool infinity = IsAtInfinity(this->Shading.Scenes[light].Light);
  for (int s = 0; s < LightBatch::Size; ++s)
  {
    if ((wanted >> s) & 1u)
    {
      const Vector3 to = (infinity ? 1.0 : batch.Distances[s]) * batch.Directions[s];
      batch.X[s] = to.X;
      batch.Y[s] = to.Y;
      batch.Z[s] = to.Z;
      ++this->OcclusionRays;
    }
  }
  return this->Scene.Occluders.OccludedFrom(
    this->Point, batch.X, batch.Y, batch.Z, wanted, infinity, this->Shading.Lights[light]->Rules);
}

void SurfaceShader::AddLight(const Ray& ray, const PrimaryHit& hit, double fraction)
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
      this->SeenLight[k] += fraction * scale * spectrum[k] * TransmittanceOver(this->SigmaT(k), depth);
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
  const OccluderScene& occluders = this->Scene.Occluders;
  const double probe = 4e-6 * hit.T;
  cones->Intersect(ray.Origin, ray.Direction, hit.T - probe, hit.T, this->Intervals, true);
  const int own = occluders.Mesh().OccluderId(hit.Triangle);
  return std::any_of(this->Intervals.begin(), this->Intervals.end(),
    [own](const OccluderInterval& interval) { return interval.OccluderId != own; });
}

double SurfaceShader::Reflectance(vtkIdType triangle, std::size_t wavelength) const
{
  const ScatteringOptions& options = this->Options;
  if (options.SurfaceReflectance.empty())
  {
    return options.Reflectance;
  }
  const auto components = static_cast<std::size_t>(options.ReflectanceComponents);
  return options
    .SurfaceReflectance[static_cast<std::size_t>(triangle) * components + (components > 1 ? wavelength : 0)];
}

} // namespace shadowcones
