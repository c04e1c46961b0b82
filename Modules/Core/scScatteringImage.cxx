// SPDX-License-Identifier: BSD-3-Clause
#include "scScatteringImage.h"

#include "scRayMarcher.h"
#include "scVisibleLight.h"

#include <algorithm>
#include <atomic>

namespace shadowcones
{

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Length of the ray's part [0, tMax] inside the box.
double LengthInside(const Box& box, const Vector3& origin, const Vector3& direction, double tMax)
{
  double from = 0.0;
  double to = tMax;
  return box.Clip(origin, direction, from, to) ? to - from : 0.0;
}

/// Renders single pixels; one renderer a thread.
class PixelRenderer
{
public:
  PixelRenderer(const MarchScene& scene, const LightStrata& surfaceStrata, const VisibleLight& visibleLight)
    : Scene(scene)
    , SurfaceStrata(surfaceStrata)
    , Visible(visibleLight)
    , Marcher(scene)
  {
  }

  /// Compute pixel (i, j) and write its values at @p index of the image.
  void Render(const Camera& camera, int i, int j, std::size_t index, ScatteringImage& image)
  {
    const ScatteringOptions& options = this->Scene.Options;
    const auto pixel =
      static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(options.Width) + static_cast<std::uint64_t>(i);
    const Camera::Ray ray = camera.PixelRay(i, j, options.Width, options.Height);
    const std::size_t wavelengths = this->Scene.Groups.GroupOf.size();
    float* inScattering = image.InScattering.data() + index * wavelengths;
    float* surfaceRadiance = image.SurfaceRadiance.data() + index * wavelengths;
    float* transmittance = image.Transmittance.data() + index * wavelengths;
    float* radiance = image.Radiance.data() + index * wavelengths;

    RayHit hit;
    const bool hasSurface = this->Scene.Occluders.Intersect(ray.Origin, ray.Direction, 0.0, HUGE_VAL, hit);
    const double tSurface = hasSurface ? hit.T : HUGE_VAL;
    image.Depth[index] = hasSurface ? static_cast<float>(hit.T) : -1.0f;

    double tBegin = 0.0;
    double tEnd = tSurface;
    const bool crossesMedium = this->Scene.Fog.Bounds.Clip(ray.Origin, ray.Direction, tBegin, tEnd);
    this->CameraLeg = crossesMedium ? tEnd - tBegin : 0.0;
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      transmittance[k] = static_cast<float>(TransmittanceOver(this->SigmaT(k), this->CameraLeg));
    }

    if (crossesMedium && this->Scene.Groups.Scatters())
    {
      this->Marcher.March(ray, tBegin, this->EndOfMarch(ray, hasSurface, hit, tBegin, tEnd), pixel);
      this->OcclusionRays += this->Marcher.NumberOfOcclusionRays();
      image.SampleCount[index] = this->Marcher.SampleCount();
      image.RelativeError[index] = this->WriteInScattering(inScattering);
    }
    if (hasSurface)
    {
      this->ShadeSurface(ray, hit, pixel, surfaceRadiance);
    }
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      radiance[k] = inScattering[k] + surfaceRadiance[k];
    }
    if (options.LightVisible)
    {
      this->AddLight(ray, tSurface, radiance);
    }
  }

  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  double SigmaT(std::size_t k) const
  {
    return this->Scene.Groups.SigmaT[static_cast<std::size_t>(this->Scene.Groups.GroupOf[k])];
  }

  /// The march ends a little before a surface, where an occlusion ray would start on the wrong side of it.
  double EndOfMarch(const Camera::Ray& ray, bool hasSurface, const RayHit& hit, double tBegin, double tEnd) const
  {
    if (!hasSurface || tEnd < hit.T)
    {
      return tEnd;
    }
    const double cosine = std::fabs(Dot(ray.Direction, this->Scene.Occluders.TriangleNormal(hit.Triangle)));
    const double gap = 4.0 * this->Scene.Occluders.Epsilon() / std::max(cosine, 0.01);
    return std::max(tEnd - gap, 0.5 * (tBegin + tEnd));
  }

  float WriteInScattering(float* inScattering) const
  {
    const ExtinctionGroups& groups = this->Scene.Groups;
    double mean = 0.0;
    for (std::size_t k = 0; k < groups.Source.size(); ++k)
    {
      const double value = groups.Source[k] * this->Marcher.Integrals()[static_cast<std::size_t>(groups.GroupOf[k])];
      inScattering[k] = static_cast<float>(value);
      mean += value / static_cast<double>(groups.Source.size());
    }
    if (this->Scene.Strata.Count() < 2)
    {
      return -1.0f;
    }
    return mean > 0.0 ? static_cast<float>(std::sqrt(this->Marcher.Variance()) / mean) : 0.0f;
  }

  /// Does Fast see the surface in shadow? Cones of the surface's own occluder do not count: their bases lie on it.
  bool InForeignCone(const Camera::Ray& ray, const RayHit& hit)
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

  /// Direct light on a Lambertian surface, both sides alike, seen through the medium.
  void ShadeSurface(const Camera::Ray& ray, const RayHit& hit, std::uint64_t pixel, float* surfaceRadiance)
  {
    const MarchScene& scene = this->Scene;
    const ScatteringOptions& options = scene.Options;
    const int count = this->SurfaceStrata.Count();
    const bool fast = options.Mode == ScatteringMode::Fast;
    if (count == 0 || (fast && this->InForeignCone(ray, hit)))
    {
      return;
    }
    Vector3 normal = scene.Occluders.TriangleNormal(hit.Triangle);
    normal = Dot(normal, ray.Direction) > 0.0 ? -normal : normal;
    const double epsilon = scene.Occluders.Epsilon();
    const Vector3 point = ray.Origin + hit.T * ray.Direction + epsilon * normal;

    const int groups = scene.Groups.Count();
    this->Sums.assign(static_cast<std::size_t>(groups), 0.0);
    // Keys of march nodes end in 16 bits below the number of steps: this one is no node's.
    RandomStream random(HashSeed(options.Seed, pixel), ~std::uint64_t{ 0 });
    for (int s = 0; s < count; ++s)
    {
      const LightStrata::Point uv = this->SurfaceStrata.Draw(s, random);
      const IncidentSample sample = SampleIncidentLight(scene.LightSource, point, uv.U, uv.V, options.Sampling);
      const double cosine = Dot(sample.Direction, normal);
      if (!(sample.Weight > 0.0) || cosine <= 0.0)
      {
        continue;
      }
      this->OcclusionRays += fast ? 0 : 1;
      if (!fast && scene.Occluders.Occluded(point, sample.Direction, epsilon, sample.Distance - epsilon))
      {
        continue;
      }
      const double lightLeg = LengthInside(scene.Fog.Bounds, point, sample.Direction, sample.Distance);
      for (int g = 0; g < groups; ++g)
      {
        const double transmittance =
          TransmittanceOver(scene.Groups.SigmaT[static_cast<std::size_t>(g)], this->CameraLeg + lightLeg);
        this->Sums[static_cast<std::size_t>(g)] += sample.Weight * cosine * transmittance;
      }
    }
    for (std::size_t k = 0; k < scene.Groups.GroupOf.size(); ++k)
    {
      const double irradiance =
        scene.LightSource.Spectrum[k] * this->Sums[static_cast<std::size_t>(scene.Groups.GroupOf[k])] / count;
      surfaceRadiance[k] = static_cast<float>(this->Reflectance(hit.Triangle, k) / pi * irradiance);
    }
  }

  double Reflectance(vtkIdType triangle, std::size_t wavelength) const
  {
    const ScatteringOptions& options = this->Scene.Options;
    if (options.SurfaceReflectance.empty())
    {
      return options.Reflectance;
    }
    const auto components = static_cast<std::size_t>(options.ReflectanceComponents);
    return options
      .SurfaceReflectance[static_cast<std::size_t>(triangle) * components + (components > 1 ? wavelength : 0)];
  }

  void AddLight(const Camera::Ray& ray, double tSurface, float* radiance) const
  {
    double t = 0.0;
    double scale = 0.0;
    // A mesh that is both lamp and occluder is a surface at the very same place.
    if (!this->Visible.Intersect(ray.Origin, ray.Direction, tSurface + this->Scene.Occluders.Epsilon(), t, scale))
    {
      return;
    }
    const double length = LengthInside(this->Scene.Fog.Bounds, ray.Origin, ray.Direction, t);
    for (std::size_t k = 0; k < this->Scene.Groups.GroupOf.size(); ++k)
    {
      radiance[k] +=
        static_cast<float>(scale * this->Scene.LightSource.Spectrum[k] * TransmittanceOver(this->SigmaT(k), length));
    }
  }

  const MarchScene& Scene;
  const LightStrata& SurfaceStrata;
  const VisibleLight& Visible;
  RayMarcher Marcher;
  double CameraLeg = 0.0; ///< inside the medium, to the first surface
  vtkIdType OcclusionRays = 0;
  std::vector<double> Sums;
  std::vector<RayInterval> Intervals;
};

} // namespace

bool RenderScattering(const OccluderScene& scene, const Light& light, const Medium& medium, const Camera& camera,
  const ConeHierarchy* cones, const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image)
{
  const ExtinctionGroups groups(light.Spectrum, medium);
  const LightStrata strata(options.NumberOfLightSamples);
  const LightStrata surfaceStrata(options.NumberOfSurfaceLightSamples);
  const VisibleLight visibleLight(light);
  const MarchScene march{ scene, light, medium, cones, options, groups, strata };

  const int columns = options.Extent[1] - options.Extent[0] + 1;
  const int rows = options.Extent[3] - options.Extent[2] + 1;
  const auto pixels = static_cast<vtkIdType>(columns) * rows;
  const std::size_t values = static_cast<std::size_t>(pixels) * light.Spectrum.size();
  image.NumberOfWavelengths = static_cast<int>(light.Spectrum.size());
  image.Radiance.assign(values, 0.0f);
  image.InScattering.assign(values, 0.0f);
  image.SurfaceRadiance.assign(values, 0.0f);
  image.Transmittance.assign(values, 1.0f);
  image.Depth.assign(static_cast<std::size_t>(pixels), -1.0f);
  image.RelativeError.assign(static_cast<std::size_t>(pixels), 0.0f);
  image.SampleCount.assign(static_cast<std::size_t>(pixels), 0);

  std::atomic<vtkIdType> occlusionRays{ 0 };
  const bool finished = ParallelFor(pixels, monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      PixelRenderer renderer(march, surfaceStrata, visibleLight);
      for (vtkIdType index = begin; index < end; ++index)
      {
        const int i = options.Extent[0] + static_cast<int>(index % columns);
        const int j = options.Extent[2] + static_cast<int>(index / columns);
        renderer.Render(camera, i, j, static_cast<std::size_t>(index), image);
      }
      occlusionRays += renderer.NumberOfOcclusionRays();
    });
  image.NumberOfOcclusionRays = occlusionRays;
  return finished;
}

} // namespace shadowcones
