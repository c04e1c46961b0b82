// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfaceShader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shadowcones
{

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Points spread over the unit square around 0, no two in one row or column: four of them are the rotated grid.
std::vector<std::array<double, 2>> SpreadOffsets(int count)
{
  // A lattice whose step is coprime to count + 1 and nearest to the golden ratio of it.
  const int modulus = count + 1;
  const double wanted = 0.61803398874989485 * modulus;
  int step = 1;
  for (int candidate = 1; candidate < modulus; ++candidate)
  {
    if (std::gcd(candidate, modulus) == 1 && std::fabs(candidate - wanted) < std::fabs(step - wanted))
    {
      step = candidate;
    }
  }
  std::vector<std::array<double, 2>> offsets;
  for (int k = 1; k <= count; ++k)
  {
    const auto row = static_cast<int>(static_cast<long long>(step) * k % modulus);
    offsets.push_back({ (k - 0.5) / count - 0.5, (row - 0.5) / count - 0.5 });
  }
  return offsets;
}

/// So many light samples for each of several rays that together they are at least @p samples.
int ShareOf(int samples, int rays)
{
  return (samples + rays - 1) / rays;
}

} // namespace

ShadingScene::ShadingScene(const ScatteringScene& scene, const ScatteringOptions& options,
  const ExtinctionGroups& groups, const VisibleLight& visibleLight, const PrimaryHits& hits)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , Visible(visibleLight)
  , Hits(hits)
  , Occlusion(scene, options)
  , Strata(options.NumberOfSurfaceLightSamples)
  , EdgeStrata(ShareOf(options.NumberOfSurfaceLightSamples, std::max(options.NumberOfEdgeSamples, 1)))
  , EdgeOffsets(SpreadOffsets(std::max(options.NumberOfEdgeSamples, 1)))
  , UsesRule(options.Mode >= ScatteringMode::Guided && scene.Source.Shape != LightShape::Mesh)
  , Rule(scene.Source, 0)
  , NearRule(scene.Source, 2)
{
}

const LightRule& ShadingScene::RuleAt(const Vector3& point) const
{
  const bool planar = this->Scene.Source.Shape == LightShape::Disc || this->Scene.Source.Shape == LightShape::Rectangle;
  return planar && !this->Rule.IsByArea(point) ? this->NearRule : this->Rule;
}

SurfaceShader::SurfaceShader(const ShadingScene& shading, ScatteringImage& image)
  : Shading(shading)
  , Scene(shading.Scene)
  , Options(shading.Options)
  , Groups(shading.Groups)
  , Image(image)
  , Depth(shading.Scene.Fog)
  , Sampler(shading.Scene.Source, shading.Options.Sampling)
  , EdgeRays(shading.EdgeOffsets.size())
  , EdgeHits(shading.EdgeOffsets.size())
  , Surface(shading.Groups.GroupOf.size())
  , SeenLight(shading.Groups.GroupOf.size())
  , Sums(static_cast<std::size_t>(shading.Groups.Count()))
{
}

double SurfaceShader::SigmaT(std::size_t wavelength) const
{
  return this->Groups.SigmaT[static_cast<std::size_t>(this->Groups.GroupOf[wavelength])];
}

void SurfaceShader::Shade(int i, int j)
{
  const PrimaryHits& hits = this->Shading.Hits;
  const std::size_t index = IndexInExtent(this->Options, i, j);
  const std::uint64_t pixel = PixelIndex(this->Options, i, j);
  const Ray ray = hits.RayOf(i, j);
  const PrimaryHit& hit = hits.At(i, j);

  std::fill(this->Surface.begin(), this->Surface.end(), 0.0);
  std::fill(this->SeenLight.begin(), this->SeenLight.end(), 0.0);
  if (hits.IsEdge(i, j))
  {
    const std::size_t count = this->EdgeRays.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      this->EdgeRays[k] = hits.RayOf(i + this->Shading.EdgeOffsets[k][0], j + this->Shading.EdgeOffsets[k][1]);
    }
    hits.Find(this->EdgeRays.data(), static_cast<int>(count), this->EdgeHits.data());
    for (std::size_t k = 0; k < count; ++k)
    {
      this->AddRay(
        this->EdgeRays[k], this->EdgeHits[k], this->Shading.EdgeStrata, pixel, k + 1, 1.0 / static_cast<double>(count));
    }
  }
  else
  {
    this->AddRay(ray, hit, this->Shading.Strata, pixel, 0, 1.0);
  }

  this->Image.Depth[index] = hit.HasSurface() ? static_cast<float>(hit.T) : -1.0f;
  const double depth = this->Depth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    this->Sums[g] = TransmittanceOver(this->Groups.SigmaT[g], depth);
  }
  const std::size_t wavelengths = this->Groups.GroupOf.size();
  for (std::size_t k = 0; k < wavelengths; ++k)
  {
    const std::size_t place = index * wavelengths + k;
    this->Image.Transmittance[place] =
      static_cast<float>(this->Sums[static_cast<std::size_t>(this->Groups.GroupOf[k])]);
    this->Image.SurfaceRadiance[place] = static_cast<float>(this->Surface[k]);
    this->Image.Radiance[place] = this->Image.InScattering[place] + this->Image.SurfaceRadiance[place];
    this->Image.Radiance[place] += static_cast<float>(this->SeenLight[k]);
  }
}

void SurfaceShader::AddRay(const Ray& ray, const PrimaryHit& hit, const LightStrata& strata,
  std::uint64_t pixel, std::uint64_t key, double share)
{
  if (hit.HasSurface() && strata.Count() > 0)
  {
    // Keys of march nodes end in 16 bits below the number of steps: these are no node's.
    this->AddSurface(ray, hit, strata, RandomStream(HashSeed(this->Options.Seed, pixel), ~key), share);
  }
  if (hit.SeesLight)
  {
    this->AddLight(ray, hit, share);
  }
}

/// Direct light on a Lambertian surface, both sides alike, seen through the medium.
void SurfaceShader::AddSurface(
  const Ray& ray, const PrimaryHit& hit, const LightStrata& strata, RandomStream random, double share)
{
  const OccluderScene& occluders = this->Scene.Occluders;
  if (this->Options.Mode == ScatteringMode::Fast && this->InForeignCone(ray, hit))
  {
    return;
  }
  const Vector3 normal = NormalTowards(occluders, ray, hit);
  const Vector3 point = ray.Origin + hit.T * ray.Direction + occluders.Epsilon() * normal;
  const bool trace = this->Shading.Occlusion.NeedsRays(point);
  this->Point = point;
  this->PointInside = this->Scene.Fog.Bounds.Contains(point);
  this->CameraDepth = this->Depth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
  if (!trace && this->Shading.UsesRule)
  {
    this->AddRule(normal);
  }
  else
  {
    this->AddSamples(normal, strata, trace, random);
  }

  const double scale = share * this->Shading.Occlusion.VisibleFraction(point, normal) / pi;
  for (std::size_t k = 0; k < this->Surface.size(); ++k)
  {
    const double irradiance =
      this->Scene.Source.Spectrum[k] * this->Sums[static_cast<std::size_t>(this->Groups.GroupOf[k])];
    this->Surface[k] += scale * this->Reflectance(hit.Triangle, k) * irradiance;
  }
}

/// Add what a sample sends to the surface point, @p weight with the cosine to its normal; nothing is in the way.
void SurfaceShader::AddLit(const Vector3& direction, double distance, double weight)
{
  if (!(weight > 0.0))
  {
    return;
  }
  const double depth = this->CameraDepth +
    (this->PointInside ? this->Depth.Towards(this->Point, direction, distance)
                       : this->Depth.TowardsFromOutside(this->Point, direction, distance));
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    this->Sums[g] += weight * TransmittanceOver(this->Groups.SigmaT[g], depth);
  }
}

/// Add the light that nothing hides, without noise.
void SurfaceShader::AddRule(const Vector3& normal)
{
  const LightRule& rule = this->Shading.RuleAt(this->Point);
  if (!this->PointInside || !this->Depth.IsHomogeneous() || !rule.IsByArea(this->Point))
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
  LookAtLight(points, rule.ViewFrom(this->Point, normal, this->Scene.Fog.Bounds), weight, cosine, leg);
  for (std::size_t k = 0; k < count; ++k)
  {
    weight[k] *= std::max(cosine[k], 0.0f);
  }
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    const double sigmaT = this->Groups.SigmaT[g];
    const float sum = SumAttenuated(weight, leg, points.Count, static_cast<float>(sigmaT));
    this->Sums[g] += TransmittanceOver(sigmaT, this->CameraDepth) * static_cast<double>(sum);
  }
}

/// Add stratified samples of the light, those that the mesh hides left out where @p trace.
void SurfaceShader::AddSamples(const Vector3& normal, const LightStrata& strata, bool trace, RandomStream& random)
{
  this->Sampler.MoveTo(this->Point);
  const int count = strata.Count();
  const double inverse = 1.0 / count;
  for (int first = 0; first < count; first += LightBatch::Size)
  {
    const int size = std::min(count - first, LightBatch::Size);
    std::uint64_t seen = this->DrawBatch(normal, strata, first, size, random);
    if (trace)
    {
      seen &= ~this->Occluded(seen);
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
std::uint64_t SurfaceShader::DrawBatch(
  const Vector3& normal, const LightStrata& strata, int first, int size, RandomStream& random)
{
  LightBatch& batch = this->Batch;
  std::uint64_t lit = 0;
  for (int s = 0; s < size; ++s)
  {
    const LightStrata::Point uv = strata.Draw(first + s, random);
    const IncidentSample sample = this->Sampler.Sample(uv.U, uv.V);
    const double cosine = Dot(sample.Direction, normal);
    batch.Directions[s] = sample.Direction;
    batch.Distances[s] = sample.Distance;
    batch.Weights[s] = sample.Weight * cosine;
    lit |= static_cast<std::uint64_t>(sample.Weight > 0.0 && cosine > 0.0) << s;
  }
  return lit;
}

/// Which of the wanted samples of the batch does the mesh hide?
std::uint64_t SurfaceShader::Occluded(std::uint64_t wanted)
{
  LightBatch& batch = this->Batch;
  const bool infinity = IsAtInfinity(this->Scene.Source);
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
  return this->Scene.Occluders.OccludedFrom(this->Point, batch.X, batch.Y, batch.Z, wanted, infinity);
}

void SurfaceShader::AddLight(const Ray& ray, const PrimaryHit& hit, double share)
{
  double t = 0.0;
  double scale = 0.0;
  this->Shading.Visible.Intersect(ray.Origin, ray.Direction, hit.T + this->Scene.Occluders.Epsilon(), t, scale);
  const double depth = this->Depth.TowardsFromOutside(ray.Origin, ray.Direction, t);
  for (std::size_t k = 0; k < this->SeenLight.size(); ++k)
  {
    this->SeenLight[k] += share * scale * this->Scene.Source.Spectrum[k] * TransmittanceOver(this->SigmaT(k), depth);
  }
}

/// Does Fast see the surface in shadow? Cones of the surface's own occluder do not count: their bases lie on it.
bool SurfaceShader::InForeignCone(const Ray& ray, const PrimaryHit& hit)
{
  if (!this->Scene.Cones)
  {
    return false;
  }
  const OccluderScene& occluders = this->Scene.Occluders;
  const double probe = std::min(hit.T, 4.0 * occluders.Epsilon());
  this->Scene.Cones->Intersect(ray.Origin, ray.Direction, hit.T - probe, hit.T, this->Intervals, true);
  const int own = occluders.Mesh().OccluderId(hit.Triangle);
  return std::any_of(this->Intervals.begin(), this->Intervals.end(),
    [own](const RayInterval& interval) { return interval.OccluderId != own; });
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
