// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBlockedLight.h
 * @brief What occluders take from the medium term of a camera ray, by occlusion rays. Internal to Core.
 *
 * The unshadowed term I is known in 64 cells of the ray: see scLitProfile.h. What is blocked is the integral of U (1 - V)
 * over the stretches where cones allow for shadow. It is sampled at places spread evenly over the unshadowed light in
 * these stretches, each with a light point of its own: of the n places and light points every n-th part holds one, and
 * their weights hardly differ, so that a sample says little else than blocked or not.
 */
#ifndef scBlockedLight_h
#define scBlockedLight_h

#include "scExtinction.h"
#include "scLightSampler.h"
#include "scLitSums.h"
#include "scMediumDepth.h"
#include "scScatteringImage.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

class BlockedLight
{
public:
  BlockedLight(const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups);

  /**
   * Take as many samples as make the standard error RelativeErrorGoal of what is left of the light, MaximumSamples at
   * most. A first few tell how many these are and are not part of the result; the others are kept unless they turn out
   * one and a half times as wrong: stopping when all looks well is biased towards light, where samples miss a shadow.
   * @param lit up to where occlusion rays may start, @param litError its standard error; @param stretches ascending;
   * @param darkest what is left counts as no less than this; @param seed of the pixel.
   */
  void Estimate(const LitSums& lit, double litError, const std::vector<RayInterval>& stretches, double darkest,
    std::uint64_t seed);

  /// Results of the last estimate: per group, then of the mean over wavelengths.
  const std::vector<double>& Blocked() const { return this->Sums; }
  double Variance() const { return this->SquaredError; } ///< without that of the unshadowed light
  int NumberOfSamples() const { return this->Samples; }
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  /// A stretch in the unshadowed light: from where to where, and how much came in stretches before.
  struct Stretch
  {
    double Begin = 0.0;
    double Light = 0.0;
    double Before = 0.0;
  };
  void Sample(const LitSums& lit, double light, int count, std::uint64_t seed);

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  LightSampler Sampler;
  MediumDepth Depth;
  std::vector<Stretch> Stretches;
  std::vector<double> Sums;
  double SquaredError = 0.0;
  int Samples = 0;
  vtkIdType OcclusionRays = 0;
};

} // namespace shadowcones

#endif
