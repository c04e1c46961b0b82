// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfaceShader.h
 * @brief Direct light on the surfaces of a scattering image, and the light itself where it is seen. Internal to Core.
 */
#ifndef scSurfaceShader_h
#define scSurfaceShader_h

#include "scExtinctionGroups.h"
#include "scLightRule.h"
#include "scLightSampler.h"
#include "scLightStrata.h"
#include "scMediumOpticalDepth.h"
#include "scOccluderInterval.h"
#include "scPixelRay.h"
#include "scPrimaryHit.h"
#include "scPrimaryHits.h"
#include "scRandom.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scShadingScene.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/**
 * Writes "SurfaceRadiance", "Transmittance", "Depth" and, from the finished medium term, "Radiance"; one a thread. A
 * pixel at an edge takes surface and seen light from several rays, depth and transmittance from the one through its
 * centre.
 */
class SurfaceShader
{
public:
  /// The image's arrays have their size; everything must outlive the shader.
  SurfaceShader(const ShadingScene& shading, const PrimaryHits& hits, ScatteringImage& image);

  void Shade(int i, int j);

  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  double SigmaT(std::size_t wavelength) const;
  /// Add @p fraction of what the ray sees; @p key tells the random numbers of a pixel's rays apart.
  void AddRay(const Ray& ray, const PrimaryHit& hit, const LightStrata& strata, std::uint64_t pixel, std::uint64_t key,
    double fraction);
  void AddSurface(
    const Ray& ray, const PrimaryHit& hit, const LightStrata& strata, RandomStream random, double fraction);
  /// The same for the light of this index, at the point on the surface.
  void AddSurfaceLight(std::size_t light, const Vector3& normal, vtkIdType triangle, const LightStrata& strata,
    RandomStream random, double fraction);
  void AddLit(const Vector3& direction, double distance, double weight);
  void AddRule(const LightRule& rule, const Vector3& normal);
  void AddSamples(
    std::size_t light, const Vector3& normal, const LightStrata& strata, bool trace, RandomStream& random);
  std::uint64_t DrawBatch(LightSampler& sampler, const Vector3& normal, const LightStrata& strata, int first, int size,
    RandomStream& random);
  std::uint64_t Occluded(std::size_t light, std::uint64_t wanted);
  void AddLight(const Ray& ray, const PrimaryHit& hit, double fraction);
  bool InForeignCone(const ConeHierarchy* cones, const Ray& ray, const PrimaryHit& hit);
  double Reflectance(vtkIdType triangle, std::size_t wavelength) const;

  /// Light samples of one point that are traced together.
  struct LightBatch
  {
    static constexpr int Size = 64;
    Vector3 Directions[Size];
    double Distances[Size] = {};
    double Weights[Size] = {};
    double X[Size] = {}; ///< to the samples, for those that are traced
    double Y[Size] = {};
    double Z[Size] = {};
  };

  const ShadingScene& Shading;
  const PrimaryHits& Hits;
  const ScatteringScene& Scene; ///< of the first light: what all lights share
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  ScatteringImage& Image;
  const MediumOpticalDepth OpticalDepth;
  std::vector<LightSampler> Samplers; ///< one a light
  LightBatch Batch;
  Vector3 Point; ///< on the surface that is shaded, a little above it
  bool PointInside = false;
  double CameraOpticalDepth = 0.0;
  vtkIdType OcclusionRays = 0;
  std::vector<PixelRay> Rays;    ///< of the pixel
  std::vector<double> Surface;   ///< of the pixel, per wavelength
  std::vector<double> SeenLight; ///< of the pixel, per wavelength
  std::vector<double> Sums;      ///< of one ray, per extinction group
  std::vector<float> RuleValues; ///< weight, cosine and length in the medium of each point of a light rule
  std::vector<OccluderInterval> Intervals;
};

} // namespace shadowcones

#endif
