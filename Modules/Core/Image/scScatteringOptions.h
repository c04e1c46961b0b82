// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringOptions.h
 * @brief How a scattering image is rendered.
 */
#ifndef scScatteringOptions_h
#define scScatteringOptions_h

#include "ShadowConesCoreModule.h"
#include "scLightSampling.h"
#include "vtkType.h"

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
  int Width = 256; ///< pixels of the whole image; Width times Height at most 2^31 - 1
  int Height = 256;
  std::array<int, 4> Extent{ 0, 255, 0, 255 }; ///< pixels to compute: i from, to, j from, to (inclusive)
  int NumberOfSteps = 32;  ///< BruteForce, Medium, Fast: march intervals over a ray's part in the medium, 1..1000000
  int MaximumHalvings = 3; ///< times an interval may be halved, 0..16
  double IntensityThreshold = 0.1; ///< halve where the ends differ by more than this share of the ray's largest value
  /// Medium, and Guided where it samples places: this share of the samples in a cone interval lies near its ends
  /// (Hougs and Day, section 3.3.1); 0 and above, below 1. With 0 Medium takes the very samples of BruteForce.
  double ShareNearEnds = 0.0;
  int NumberOfLightSamples = 16;   ///< fresh stratified light points per march sample, 1..65536
  /// Fewest light points for a surface, half of them in a look that decides on more, 0..65536; 0: surfaces are black.
  /// Light that nothing can hide takes none: it comes from a rule, which has no noise.
  int NumberOfSurfaceLightSamples = 16;
  /// Guided: a pixel takes as many samples as make its "RelativeError" about this, at most 1.5 times; one that is darker
  /// than a tenth of what the image shows on average, as many as that tenth would. In all modes that trace the shadows
  /// of surfaces the same holds for their "SurfaceRelativeError"; a surface that is all dark may err by as much as if it
  /// were lit. 0: MaximumSamples for every pixel.
  double RelativeErrorGoal = 0.01;
  int MaximumSamples = 1024; ///< light samples of a pixel, at most, for the medium (Guided) and for surfaces; at least 1
  /// 16 times so many camera rays find the surfaces of a pixel at an edge, 1..1024; 1: no smoothing.
  int NumberOfEdgeSamples = 4;
  bool LightVisible = true; ///< the camera sees the light itself
  LightSampling Sampling = LightSampling::Auto;
  double Reflectance = 0.5;              ///< of diffuse surfaces where SurfaceReflectance is empty, 0..1
  std::vector<float> SurfaceReflectance; ///< per triangle, ReflectanceComponents values each (1 or one per wavelength)
  int ReflectanceComponents = 1;
  std::vector<float> SurfaceNormals; ///< per point of the mesh, 3 values each, any length; empty, or 0: the triangles'
  std::uint64_t Seed = 1;
  /// Without photon maps in the scene: trace photons in so many passes, each anew, and take the mean of what they say; 0: none.
  int NumberOfPhotonPasses = 0;
  vtkIdType NumberOfPhotonsPerPass = 100000; ///< emitted by all lights together, at least 0
  int PhotonNeighbours = 0; ///< of the photons of all passes together, see PreparePhotonEstimates
};

/// nullptr, or what is wrong with the options.
SHADOWCONESCORE_EXPORT const char* CheckScatteringOptions(const ScatteringOptions& options);

/// The number of pixel (i, j) in the whole image: what its random numbers depend on.
inline std::uint64_t PixelIndex(const ScatteringOptions& options, int i, int j)
{
  return static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(options.Width) + static_cast<std::uint64_t>(i);
}

} // namespace shadowcones

#endif
