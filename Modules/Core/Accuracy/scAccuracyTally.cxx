// SPDX-License-Identifier: BSD-3-Clause
#include "scAccuracyTally.h"

#include <limits>

namespace shadowcones
{

void AccuracyTally::Add(const SampleTruth& truth, const SamplePrediction& prediction)
{
  if (truth.Emitting == 0)
  {
    return;
  }
  const bool inside = prediction.Inside();
  const bool shadowed = truth.Shadowed();
  const bool umbra = truth.Umbra();
  const bool predictedUmbra = prediction.Class == 2;
  this->TrueNegatives += !shadowed && !inside;
  this->TruePositives += shadowed && inside;
  this->FalsePositives += !shadowed && inside;
  this->FalseNegatives += shadowed && !inside;
  this->Umbra += umbra;
  this->PredictedUmbra += predictedUmbra;
  this->BothUmbra += umbra && predictedUmbra;
  this->BlockedOutside.Add(inside ? 0 : truth.Blocked, truth.Blocked);
  this->LitInside.Add(inside ? truth.Lit() : 0, truth.Lit());
  this->BlockedInside.Add(inside ? truth.Blocked : 0, inside ? truth.Emitting : 0);
  this->Volume.Add(inside, shadowed);
}

Estimate AccuracyTally::Lost(const AccuracyTally& all) const
{
  // Of this tally's samples y is what they are, of all others 0.
  RatioSums sums = this->LitInside;
  sums.X = all.LitInside.X;
  sums.XX = all.LitInside.XX;
  return EstimateFraction(sums);
}

Estimate AccuracyTally::VolumeError() const
{
  const Estimate ratio = EstimateRatio(this->Volume);
  return this->Volume.X > 0 ? Estimate{ ratio.Value - 1.0, ratio.Low - 1.0, ratio.High - 1.0 }
                            : Estimate{ ratio.Value, -1.0, std::numeric_limits<double>::infinity() };
}

} // namespace shadowcones
