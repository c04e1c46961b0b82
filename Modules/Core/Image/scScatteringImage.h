// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringImage.h
 * @brief Light shafts along camera rays, by the ray marcher of Hougs and Day (section 4.3) and by faster estimators.
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
  Fast = 2,       ///< no occlusion ray at all: lit outside cone intervals, nothing inside
  Guided = 3,     ///< lit minus blocked, the blocked part sampled inside cone intervals until RelativeErrorGoal is met
  Soft = 4,       ///< Volume with a grid that was filled from the cones alone: surfaces ask no ray either
  Volume = 5      ///< lit minus blocked, the blocked part read from a grid
};

/// Do samples of the whole term along every ray make the image? The others take unshadowed light, known without noise,
/// and subtract what is blocked.
inline bool IsMarched(ScatteringMode mode)
{
  return mode == ScatteringMode::BruteForce || mode == ScatteringMode::Medium || mode == ScatteringMode::Fast;
}

struct ScatteringOptions
{
  ScatteringMode Mode = ScatteringMode::BruteForce;
  int Width = 256;  ///< pixels of the whole image; Width times Height at most 2^31 - 1
  int Height = 256;
  std::array<int, 4> Extent{ 0, 255, 0, 255 }; ///< pixels to compute: i from, to, j from, to (inclusive)
  int NumberOfSteps = 32; ///< BruteForce, Medium, Fast: march intervals over a ray's part in the medium, 1..1000000
  int MaximumDepth = 3;           ///< times an interval may be halved, 0..16
  double IntensityThreshold = 0.1; ///< halve where the ends differ by more than this share of the ray's largest value
  int NumberOfLightSamples = 16;   ///< fresh stratified light points per march sample, 1..65536
  /// Per surface point, shared by the rays of a pixel at an edge, 0..65536; 0: surfaces are black. Guided, Soft and
  /// Volume integrate light that nothing can hide by a fixed rule instead, which has no noise.
  int NumberOfSurfaceLightSamples = 16;
  /// Guided: a pixel takes as many samples as make its "RelativeError" about this, at most 1.5 times; one that is darker
  /// than a tenth of what the image shows on average, as many as that tenth would. 0: MaximumSamples for every pixel.
  double RelativeErrorGoal = 0.01;
  int MaximumSamples = 1024;      ///< Guided: light samples of a pixel, at most; at least 1
  /// 16 times so many camera rays find the surfaces of a pixel at an edge, 1..1024; 1: no smoothing.
  int NumberOfEdgeSamples = 4;
  bool LightVisible = true;       ///< the camera sees the light itself
  LightSampling Sampling = LightSampling::Auto;
  double Reflectance = 0.5;       ///< of diffuse surfaces where SurfaceReflectance is empty, 0..1
  std::vector<float> SurfaceReflectance; ///< per triangle, ReflectanceComponents values each (1 or one per wavelength)
  int ReflectanceComponents = 1;
  std::uint64_t Seed = 1;
};

/**
 * Pixels of the extent, i fastest; NumberOfWavelengths values each where named "per wavelength". At edges
 * InScattering, SurfaceRadiance and the seen light are means over the pixel; Depth and Transmittance are of the ray
 * through its centre.
 */
struct ScatteringImage
{
  int NumberOfWavelengths = 0;
  std::vector<float> Radiance;        ///< per wavelength: InScattering + SurfaceRadiance (+ the light where seen)
  std::vector<float> InScattering;    ///< per wavelength: the medium term alone, W m^-2 sr^-1
  std::vector<float> SurfaceRadiance; ///< per wavelength: as seen through the medium
  std::vector<float> Transmittance;   ///< per wavelength: to the first surface, or through the medium
  std::vector<float> Depth;           ///< to the first surface; -1 where there is none
  std::vector<float> RelativeError;   ///< one standard error of InScattering over its value (mean over wavelengths); -1: not known
  std::vector<float> MediumError;     ///< the same, not over its value, which may be 0; -1: not known
  std::vector<int> SampleCount;       ///< light samples taken for the medium term
  vtkIdType NumberOfOcclusionRays = 0; ///< rays towards the light, medium and surfaces together
  /// BruteForce, Medium and Fast: rays that optically thick steps may make too bright by more than half a per cent, and
  /// the largest optical depth of such a step.
  vtkIdType NumberOfThickRays = 0;
  double MarchOpticalDepth = 0.0;
};

struct VisibilityGrid;

/// What is rendered in the light of one light; nothing is owned. The light spectrum, SigmaS and SigmaA have one length.
struct ScatteringScene
{
  const OccluderScene& Occluders;
  const Light& Source;
  const Medium& Fog;
  const Camera& Eye;
  /// Medium, Fast and Guided; Volume: for its surfaces. Bounds must hold the medium's. To Guided and Volume nullptr
  /// means that shadow may be anywhere.
  const ConeHierarchy* Cones = nullptr;
  const VisibilityGrid* Visibility = nullptr; ///< Soft, Volume
};

/// nullptr, or what is wrong with the options.
SHADOWCONESCORE_EXPORT const char* CheckScatteringOptions(const ScatteringOptions& options);

/**
 * Render the extent in the light of several lights: one scene each, which differ in Source, Cones and Visibility alone.
 * What the lights send adds up; samples and options count for each of them. Every light takes the random numbers that
 * it would take alone, so that images of single lights add up to the image of all. "RelativeError" adds the lights'
 * errors as if they were the same ones, and is no less than what they are together. A lamp hides no other.
 *
 * Guided without cones samples the whole of every ray. @return false where aborted. Throws std::invalid_argument where
 * the options are wrong.
 */
SHADOWCONESCORE_EXPORT bool RenderScattering(const std::vector<ScatteringScene>& scenes,
  const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image);
/// The same for one light.
SHADOWCONESCORE_EXPORT bool RenderScattering(
  const ScatteringScene& scene, const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image);

/**
 * The same for several parts of the image: image k is that of extents[k] (i from, to, j from, to, inclusive), with the
 * values that it has in the whole. Options.Extent is not used.
 */
SHADOWCONESCORE_EXPORT bool RenderScattering(const std::vector<ScatteringScene>& scenes,
  const ScatteringOptions& options, const std::vector<std::array<int, 4>>& extents, const Monitor& monitor,
  std::vector<ScatteringImage>& images);

/// The number of pixel (i, j) in the whole image: what its random numbers depend on.
inline std::uint64_t PixelIndex(const ScatteringOptions& options, int i, int j)
{
  return static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(options.Width) + static_cast<std::uint64_t>(i);
}
/// Its place in the arrays of an image of the extent.
inline std::size_t IndexInExtent(const ScatteringOptions& options, int i, int j)
{
  const auto columns = static_cast<std::size_t>(options.Extent[1] - options.Extent[0] + 1);
  return static_cast<std::size_t>(j - options.Extent[2]) * columns + static_cast<std::size_t>(i - options.Extent[0]);
}

} // namespace shadowcones

#endif
