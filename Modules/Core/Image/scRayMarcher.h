// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRayMarcher.h
 * @brief The adaptive march along one camera ray (Hougs and Day, section 4.3). Internal to Core.
 */
#ifndef scRayMarcher_h
#define scRayMarcher_h

#include "scEndDensity.h"
#include "scLightLegs.h"
#include "scLightSampler.h"
#include "scMediumOpticalDepth.h"
#include "scOccluderInterval.h"
#include "scRay.h"
#include "scRayInterval.h"
#include "scRenderContext.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/**
 * Marches rays, one after the other; one marcher a thread. Random numbers are a pure function of (Seed, pixel, node),
 * where a node's key is its dyadic place on the ray: Medium takes the very samples of BruteForce.
 */
class RayMarcher
{
public:
  /// @param legs a table of the density towards the light, nullptr where there is none; it must outlive this.
  explicit RayMarcher(const RenderContext& context, const LightLegs* legs = nullptr);

  /// Integrate over [tBegin, tEnd], the part of the ray inside the medium; @p pixel counts over the whole image.
  void March(const Ray& ray, double tBegin, double tEnd, std::uint64_t pixel);

  /// Integral of W p(cos) T V density dt for each extinction group, to be multiplied by sigma_s L.
  const std::vector<double>& Integrals() const { return this->Sums; }
  /// Squared standard error of the mean over wavelengths of the in-scattered radiance.
  double Variance() const;
  vtkIdType SampleCount() const { return this->Samples; }
  /**
   * The share of the integral by which steps may be too bright that light hardly passes: exp(-2 x) over a step of
   * optical depth x is too large by x / tanh(x) where its ends stand for all of it.
   */
  double Excess() const { return this->SumOfLeaves > 0.0 ? this->SumOfExcess / this->SumOfLeaves : 0.0; }
  /// Optical depth of the step that adds most to that.
  double OpticalDepthOfStep() const { return this->WorstOpticalDepth; }
  vtkIdType NumberOfOcclusionRays() const { return this->OcclusionRays; }

private:
  struct Node
  {
    double T = 0.0;
    std::uint64_t Key = 0;
    double Intensity = 0.0; ///< mean over wavelengths of the integrand, but for the density
    double Variance = 0.0;  ///< of Intensity
    std::size_t Slot = 0;   ///< index into Values, in groups
  };
  /// A part of the ray that is marched over.
  struct MarchInterval : RayInterval
  {
    std::size_t FirstNode = 0;
    int NumberOfSteps = 1;
    bool InCones = false; ///< Medium with ShareNearEnds: nodes lie denser near both ends
  };

  void FindIntervals(double tBegin, double tEnd);
  void CutAtCones(const RayInterval& whole);
  void AddInterval(const RayInterval& whole, double begin, double end, bool inCones);
  std::size_t NumberOfNodes() const;
  void PlaceNodes();
  void Evaluate(Node& node);
  void EvaluateBaseNodes();
  bool NeedsOcclusionRays(double t) const;
  void Refine(const Node& a, const Node& b, int depth);
  void Add(const Node& node, double weight);
  void RateStep(const Node& a, const Node& b, double density);

  const RenderContext& Context;
  const ScatteringScene& Scene;
  const ExtinctionGroups& Groups;
  const int NumberOfGroups;
  LightSampler Sampler;
  MediumOpticalDepth OpticalDepth;
  const LightLegs* Legs;
  LightLegs::Place Place; ///< of the node at hand
  const RayRules Rules; ///< for what is flush with the light
  const EndDensity Ends;
  std::vector<double> Intensities; ///< of the light samples of one node
  Ray CameraRay;
  std::uint64_t PixelSeed = 0;
  double Threshold = 0.0;     ///< absolute, of this ray
  double PendingWeight = 0.0; ///< of the node at the left end of the next leaf interval

  std::vector<OccluderInterval> InCones;
  std::vector<MarchInterval> Intervals;
  std::vector<Node> Nodes;
  std::vector<double> Values; ///< NumberOfGroups a slot: one slot a base node, then one a level of halving
  std::vector<double> Sums;
  double SumOfVariances = 0.0;
  double LargestSigmaT = 0.0;
  double SumOfLeaves = 0.0; ///< intensities times lengths of steps
  double SumOfExcess = 0.0;
  double WorstExcess = 0.0;
  double WorstOpticalDepth = 0.0;
  vtkIdType Samples = 0;
  vtkIdType OcclusionRays = 0;
};

} // namespace shadowcones

#endif
