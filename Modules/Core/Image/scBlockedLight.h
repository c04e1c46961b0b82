// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBlockedLight.h
 * @brief What occluders leave of the medium term of a camera ray, by occlusion rays. Internal to Core.
 *
 * The unshadowed term is known in 64 cells of the ray: see scLitProfileLayout.h. Where cones allow for shadow, samples are
 * taken at places spread evenly over the unshadowed light in these intervals (or denser at their ends, where ShareNearEnds
 * asks for that), each with a light point of its own: of
 * the n places and light points every n-th part holds one. What is left of the light is a ratio: see scVisibleRatio.h.
 */
#ifndef scBlockedLight_h
#define scBlockedLight_h

#include "scEndDensity.h"
#include "scIntervalLight.h"
#include "scLightLegs.h"
#include "scLightSampler.h"
#include "scLitSums.h"
#include "scMediumOpticalDepth.h"
#include "scOccluderScene.h"
#include "scRayInterval.h"
#include "scRenderContext.h"
#include "scSampleColumns.h"
#include "scVisibleRatio.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

class BlockedLight
{
public:
  /// @param legs a table of the density towards the light, nullptr where there is none; it must outlive this.
  explicit BlockedLight(const RenderContext& context, const LightLegs* legs = nullptr);

  /// Against what errors are measured, means over wavelengths.
  struct Yardstick
  {
    double Darkest = 0.0;  ///< what is left counts as no less than this
    double LitError = 0.0; ///< standard error of the unshadowed term up to any place
  };
  /**
   * A first look at a ray, which tells how many samples it needs and is not part of the result: stopping when all looks
   * well is biased towards light, where samples miss a shadow.
   * @param lit up to where occlusion rays may start; @param intervals ascending; @param seed of the pixel. The sums
   * must live until Estimate().
   */
  void Look(
    const LitSums& lit, const std::vector<RayInterval>& intervals, const Yardstick& yardstick, std::uint64_t seed);
  /// Is there an estimate to be made, and did the look see no light in the intervals?
  bool LooksDark() const { return this->Wanted > 0.0 && this->Ratio.Ratio() == 0.0; }
  /// Did any sample see the lamp?
  bool SeesLight() const { return !this->Passes.empty() && this->Ratio.Ratio() > 0.0; }
  /// Did any not?
  bool SeesShadow() const { return !this->Passes.empty() && this->Ratio.Ratio() < 1.0; }
  /// Samples that the look asks for.
  double NumberOfWantedSamples() const { return this->Wanted; }
  /**
   * After a look: take as many samples as make the standard error RelativeErrorGoal of what is left of the light,
   * MaximumSamples at most, and @p most if that is less. They are pooled by their numbers; more are taken where the
   * error turns out one and a half times as large as wanted.
   */
  void Estimate(int most);
  /// No samples: the unshadowed light in the intervals alone, per group. @return nullptr where there is none.
  const std::vector<double>* FindInside(const LitSums& lit, const std::vector<RayInterval>& intervals)
  {
    return this->Begin(lit, intervals) ? &this->Intervals.Inside() : nullptr;
  }
  /// The same from this many samples.
  void EstimateFrom(int count, const LitSums& lit, const std::vector<RayInterval>& intervals, std::uint64_t seed);

  /// Results of the last estimate: what is left of every group, and of the mean over wavelengths its squared error.
  const std::vector<double>& Left() const { return this->Ratio.Left(); }
  double Variance() const { return this->SquaredError; }
  double MeanLeft() const { return this->Ratio.MeanLeft(); } ///< over wavelengths
  double MeanInside() const { return this->Passes.empty() ? 0.0 : this->Intervals.MeanInside(); }
  int NumberOfSamples() const { return this->Samples; }
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }
  vtkIdType NumberOfLines() const { return 0; }

private:
  /// Samples of one pass.
  struct Pass
  {
    int Count = 0;
    int NumberOfLit = 0; ///< by the lamp, were it not for occluders
    int NumberOfVisible = 0;
    double Weight = 0.0; ///< among the passes
    SampleColumns::Levels Differences; ///< of means over wavelengths
  };
  /// Squared error of one pass.
  struct PassError
  {
    double Edges = 0.0;  ///< from what its samples show; falls as n^-3/2
    double Unseen = 0.0; ///< from what they may have missed; falls as n^-2
  };
  struct Packet;
  struct Draws;
  bool Begin(const LitSums& lit, const std::vector<RayInterval>& intervals);
  void Draw(const LitSums& lit, int first, int count, Draws& draws, Packet& packet);
  void Add(const LitSums& lit, Packet& packet, double spacing, Pass& pass);
  void Sample(const LitSums& lit, int count, std::uint64_t seed);
  void Forget();
  void Conclude(double litError);
  /// Squared error that samples may have.
  double Allowed() const;
  PassError ErrorOf(const Pass& pass) const;
  /// Number of samples of one more pass, so that all passes together have this variance.
  double SamplesFor(double variance) const;

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  LightSampler Sampler;
  MediumOpticalDepth OpticalDepth;
  const LightLegs* Legs;
  const RayRules Rules; ///< for what is flush with the light
  const EndDensity Ends;
  const LitSums* Lit = nullptr;
  Yardstick Measure;
  std::uint64_t Seed = 0;
  double Wanted = 0.0; ///< samples of the next pass; 0: nothing to do
  IntervalLight Intervals;
  std::vector<Pass> Passes;
  SampleColumns Columns; ///< of the pass at hand
  double SumOfWeights = 0.0;
  VisibleRatio Ratio;
  double SampledVariance = 0.0;
  double SquaredError = 0.0; ///< with that of the unshadowed light
  int Samples = 0;
  vtkIdType OcclusionRays = 0;
};

} // namespace shadowcones

#endif
