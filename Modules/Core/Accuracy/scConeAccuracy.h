// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeAccuracy.h
 * @brief How far a cone set, or another prediction of shadow, is to be trusted: held against the mesh at sample points.
 *
 * Four steps: DrawSamplePoints, MeasureTruth by rays, ClassifyByCones (or another classifier), TallyAccuracy.
 */
#ifndef scConeAccuracy_h
#define scConeAccuracy_h

#include "ShadowConesCoreModule.h"
#include "scConeSet.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace shadowcones
{

/// Points that fill the box evenly, an Owen-scrambled Sobol sequence; none in an empty box. @return false if aborted.
SHADOWCONESCORE_EXPORT bool DrawSamplePoints(
  const Box& bounds, vtkIdType count, std::uint64_t seed, const Monitor& monitor, std::vector<Vector3>& points);

/// What the mesh does to the light at a sample point.
struct SampleTruth
{
  int Emitting = 0;              ///< light points that shine towards the sample
  int Blocked = 0;               ///< those of them that the mesh hides
  int OccluderId = -1;           ///< the one that most blocked light passed last; -1: none is blocked
  double OccluderDistance = 0.0; ///< mean distance to that occluder towards the light

  int Lit() const { return this->Emitting - this->Blocked; }
  bool Shadowed() const { return this->Blocked > 0; }
  bool Umbra() const { return this->Blocked > 0 && this->Blocked == this->Emitting; }
  /// Visible fraction of the light; 1 where it does not shine to.
  double Visibility() const
  {
    return this->Emitting > 0 ? static_cast<double>(this->Lit()) / static_cast<double>(this->Emitting) : 1.0;
  }
};

/**
 * Look from each point to @p lightSamples points of the light, stratified and turned from point to point: a pure
 * function of the seed and the point's index. Every triangle blocks: leave receivers out of the scene.
 * @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool MeasureTruth(const std::vector<Vector3>& points, const OccluderScene& scene,
  const Light& light, int lightSamples, std::uint64_t seed, const Monitor& monitor, std::vector<SampleTruth>& truth);

/// The same for several lights, as seen from the same samples: all points for the first light, then all for the next
/// one.
SHADOWCONESCORE_EXPORT bool MeasureTruth(const std::vector<Vector3>& points, const OccluderScene& scene,
  const std::vector<Light>& lights, int lightSamples, std::uint64_t seed, const Monitor& monitor,
  std::vector<SampleTruth>& truth);

/// What is predicted for a sample point.
struct SamplePrediction
{
  unsigned char Class = 0; ///< 0 lit, 1 penumbra, 2 umbra
  int ConeId = -1;         ///< the first cone that holds it
  double Height = 0.0;     ///< above that cone's base

  bool Inside() const { return this->Class > 0; }
};

/// A 95 % confidence interval; a value that is not defined (0 / 0) is NaN in [0, 1].
struct Estimate
{
  double Value = std::numeric_limits<double>::quiet_NaN();
  double Low = 0.0;
  double High = 1.0;
};

/// A proportion of counts, with the interval of Wilson (1927).
SHADOWCONESCORE_EXPORT Estimate EstimateProportion(std::int64_t part, std::int64_t whole);

/// Sums of y and x over samples, for the ratio of both. Integers: the same for any order of adding.
struct RatioSums
{
  std::int64_t Y = 0;
  std::int64_t X = 0;
  std::int64_t YY = 0;
  std::int64_t XY = 0;
  std::int64_t XX = 0;

  void Add(std::int64_t y, std::int64_t x)
  {
    this->Y += y;
    this->X += x;
    this->YY += y * y;
    this->XY += x * y;
    this->XX += x * x;
  }
};

/**
 * Sum of y over sum of x where 0 <= y <= x in each sample. Wilson's interval for as many samples as give a proportion
 * the standard error of the ratio estimate (Cochran 1977, section 6.4); at the values 0 and 1, whose estimate is 0, for
 * (sum x)^2 / sum x^2 samples (Kish 1965).
 */
SHADOWCONESCORE_EXPORT Estimate EstimateShare(const RatioSums& sums);
/// Sum of y over sum of x, 1.96 standard errors of the ratio estimate to either side.
SHADOWCONESCORE_EXPORT Estimate EstimateRatio(const RatioSums& sums);

/// Counts of samples; those that the light does not shine to are left out.
struct AccuracyTally
{
  std::int64_t TrueNegatives = 0;
  std::int64_t TruePositives = 0;
  std::int64_t FalsePositives = 0;
  std::int64_t FalseNegatives = 0;
  std::int64_t Umbra = 0; ///< samples in full shadow
  std::int64_t PredictedUmbra = 0;
  std::int64_t BothUmbra = 0;
  RatioSums BlockedOutside; ///< y: blocked light outside, x: blocked light
  RatioSums LitInside;      ///< y: lit light inside, x: lit light
  RatioSums BlockedInside;  ///< y: blocked light inside, x: all light inside
  RatioSums Volume;         ///< y: inside, x: shadowed

  SHADOWCONESCORE_EXPORT void Add(const SampleTruth& truth, const SamplePrediction& prediction);

  std::int64_t Samples() const
  {
    return this->TrueNegatives + this->TruePositives + this->FalsePositives + this->FalseNegatives;
  }
  /// TP / (TP + FN): the share of the shadowed samples that are predicted.
  Estimate Recall() const
  {
    return EstimateProportion(this->TruePositives, this->TruePositives + this->FalseNegatives);
  }
  /// TP / (TP + FP): the share of the predicted samples that are shadowed.
  Estimate Precision() const
  {
    return EstimateProportion(this->TruePositives, this->TruePositives + this->FalsePositives);
  }
  /// TP / (TP + FP + FN): intersection over union of the predicted and the true shadow.
  Estimate IoU() const
  {
    return EstimateProportion(this->TruePositives, this->TruePositives + this->FalsePositives + this->FalseNegatives);
  }
  /// Blocked light outside over all blocked light.
  Estimate Leak() const { return EstimateShare(this->BlockedOutside); }
  /// Lit light inside over all lit light, of @p all samples: Lost of groups adds up to that of all.
  SHADOWCONESCORE_EXPORT Estimate Lost(const AccuracyTally& all) const;
  Estimate Lost() const { return this->Lost(*this); }
  /// The blocked share of the light at samples inside.
  Estimate LightPrecision() const { return EstimateShare(this->BlockedInside); }
  /// Predicted over true volume - 1.
  SHADOWCONESCORE_EXPORT Estimate VolumeError() const;
  Estimate UmbraPrecision() const { return EstimateProportion(this->BothUmbra, this->PredictedUmbra); }
  Estimate UmbraRecall() const { return EstimateProportion(this->BothUmbra, this->Umbra); }
};

/// What one cone holds.
struct ConeTally
{
  std::int64_t Samples = 0;
  std::int64_t Shadowed = 0;
  std::int64_t Lit = 0; ///< light that is not blocked

  Estimate Precision() const { return EstimateProportion(this->Shadowed, this->Samples); }
  /// Lit light inside this cone over all lit light.
  double Lost(const AccuracyTally& all) const
  {
    return all.LitInside.X > 0 ? static_cast<double>(this->Lit) / static_cast<double>(all.LitInside.X) : 0.0;
  }
};

/**
 * Predict by cones: inside any cone is shadow, inside the inner cone of one that holds the point is umbra. @p truth has
 * one entry a point, @p tallies receives one a cone. Cost: one query of a tree a point. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ClassifyByCones(const std::vector<Vector3>& points, const std::vector<SampleTruth>& truth,
  const std::vector<Cone>& cones, const Monitor& monitor, std::vector<SamplePrediction>& predictions,
  std::vector<ConeTally>& tallies);

/**
 * The same for the truth of several lights: each is predicted by its own cones (LightId). Predictions are in the order
 * of @p truth, and name cones by their index in @p cones.
 */
SHADOWCONESCORE_EXPORT bool ClassifyByCones(std::size_t lights, const std::vector<Vector3>& points,
  const std::vector<SampleTruth>& truth, const std::vector<Cone>& cones, const Monitor& monitor,
  std::vector<SamplePrediction>& predictions, std::vector<ConeTally>& tallies);

/// The occluder that a sample is counted for: the one that blocks most, else that of the cone that holds it, else -1.
SHADOWCONESCORE_EXPORT int CountedOccluder(
  const SampleTruth& truth, const SamplePrediction& prediction, const std::vector<Cone>& cones);
/// Distance from the base: of the cone that holds the sample, else from the occluder that shadows it, else -1.
SHADOWCONESCORE_EXPORT double CountedDepth(const SampleTruth& truth, const SamplePrediction& prediction);

struct OccluderTally : AccuracyTally
{
  int OccluderId = -1;
};

struct DepthTally : AccuracyTally
{
  double Low = 0.0; ///< depths from Low to below High; the last one to High
  double High = 0.0;
};

/// True negatives belong to no occluder and to no depth; all other samples belong to one of each.
struct AccuracyReport
{
  AccuracyTally All;
  std::vector<OccluderTally> Occluders; ///< ascending ids
  std::vector<DepthTally> Depths;       ///< bins of one width from 0 to the largest depth
};

SHADOWCONESCORE_EXPORT AccuracyReport TallyAccuracy(const std::vector<SampleTruth>& truth,
  const std::vector<SamplePrediction>& predictions, const std::vector<Cone>& cones, int depthBins);

} // namespace shadowcones

#endif
