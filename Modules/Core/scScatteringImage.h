// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringImage.h
 * @brief Light shafts along camera rays: the ray marcher of Hougs and Day, section 4.3, in its three settings.
 */
#ifndef scScatteringImage_h
#define scScatteringImage_h

#include "ShadowConesCoreModule.h"
#include "scCamera.h"
#include "scConeIntervals.h"
#include "scLight.h"
#include "scMedium.h"
#include "scOccluderScene.h"
#include "scParallel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

enum class ScatteringMode : int
{
  BruteForce = 0, ///< occlusion rays from every march sample
  Medium = 1,     ///< occlusion rays only inside cone intervals; where cones bound the shadow, the bytes of BruteForce
  Fast = 2        ///< no occlusion ray at all: lit outside cone intervals, nothing inside
};

struct ScatteringOptions
{
  ScatteringMode Mode = ScatteringMode::BruteForce;
  int Width = 256;
  int Height = 256;
  std::array<int, 4> Extent{ 0, 255, 0, 255 }; ///< pixels to compute: i from, to, j from, to (inclusive)
  int NumberOfSteps = 32;         ///< march intervals along the part of a ray inside the medium, at least 1
  int MaximumDepth = 3;           ///< times an interval may be halved, 0..16
  double IntensityThreshold = 0.1; ///< halve where the ends differ by more than this share of the ray's largest intensity
  int NumberOfLightSamples = 16;  ///< fresh stratified light points per march sample, at least 1
  int NumberOfSurfaceLightSamples = 16; ///< per surface point; 0: surfaces are black
  bool LightVisible = true;       ///< the camera sees the light itself
  LightSampling Sampling = LightSampling::Auto;
  double Reflectance = 0.5;       ///< of diffuse surfaces where SurfaceReflectance is empty, 0..1
  std::vector<float> SurfaceReflectance; ///< per triangle, ReflectanceComponents values each (1 or one per wavelength)
  int ReflectanceComponents = 1;
  std::uint64_t Seed = 1;
};

/// Pixels of the extent, i fastest; NumberOfWavelengths values each where named "per wavelength".
struct ScatteringImage
{
  int NumberOfWavelengths = 0;
  std::vector<float> Radiance;        ///< per wavelength: InScattering + SurfaceRadiance (+ the light where seen)
  std::vector<float> InScattering;    ///< per wavelength: the medium term alone, W m^-2 sr^-1
  std::vector<float> SurfaceRadiance; ///< per wavelength: as seen through the medium
  std::vector<float> Transmittance;   ///< per wavelength: to the first surface, or through the medium
  std::vector<float> Depth;           ///< to the first surface; -1 where there is none
  std::vector<float> RelativeError;   ///< one standard error of InScattering over its value (mean over wavelengths)
  std::vector<int> SampleCount;       ///< light samples taken for the medium term
  vtkIdType NumberOfOcclusionRays = 0; ///< rays towards the light, medium and surfaces together
};

/**
 * Render. @p cones is used by Medium and Fast and may be nullptr for BruteForce; its bounds must hold the medium's.
 * The light spectrum, SigmaS and SigmaA have one length. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool RenderScattering(const OccluderScene& scene, const Light& light, const Medium& medium,
  const Camera& camera, const ConeHierarchy* cones, const ScatteringOptions& options, const Monitor& monitor,
  ScatteringImage& image);

} // namespace shadowcones

#endif
