// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scAccuracyTally.h
 * @brief Counts of samples by truth and prediction, and the figures that follow from them.
 */
#ifndef scAccuracyTally_h
#define scAccuracyTally_h

#include "ShadowConesCoreModule.h"
#include "scEstimate.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <cstdint>

namespace shadowcones
{

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
  /// TP / (TP + FN): the fraction of the shadowed samples that are predicted.
  Estimate Recall() const
  {
    return EstimateProportion(this->TruePositives, this->TruePositives + this->FalseNegatives);
  }
  /// TP / (TP + FP): the fraction of the predicted samples that are shadowed.
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
  Estimate Leak() const { return EstimateFraction(this->BlockedOutside); }
  /// Lit light inside over all lit light, of @p all samples: Lost of groups adds up to that of all.
  SHADOWCONESCORE_EXPORT Estimate Lost(const AccuracyTally& all) const;
  Estimate Lost() const { return this->Lost(*this); }
  /// The blocked fraction of the light at samples inside.
  Estimate LightPrecision() const { return EstimateFraction(this->BlockedInside); }
  /// Predicted over true volume - 1.
  SHADOWCONESCORE_EXPORT Estimate VolumeError() const;
  Estimate UmbraPrecision() const { return EstimateProportion(this->BothUmbra, this->PredictedUmbra); }
  Estimate UmbraRecall() const { return EstimateProportion(this->BothUmbra, this->Umbra); }
};

} // namespace shadowcones

#endif
