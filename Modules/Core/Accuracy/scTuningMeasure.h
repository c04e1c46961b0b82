// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTuningMeasure.h
 * @brief How good the cones of a parameter set are, on photons that were held out. Internal to Core.
 */
#ifndef scTuningMeasure_h
#define scTuningMeasure_h

#include "scBox.h"
#include "scConeTuning.h"
#include "scTuningData.h"

#include <vector>

namespace shadowcones
{

/// What validating a kind of tuning needs again and again.
struct TuningValidation
{
  TuningValidation(const ShadowVectorView& vectors, const PhotonPathView& paths, std::size_t lights, ConeTuning tuning,
    vtkIdType largestNumberOfVectors);

  TuningData Data;
  std::size_t Lights;              ///< their number
  Box Region;                      ///< where light counts
  std::vector<PathSample> Samples; ///< Preview
};

/**
 * Fit with the options in the result, measure as ConeTuning says, and set what balances.
 * @return false where aborted: nothing was measured.
 */
bool MeasureFit(const TuningValidation& validation, const std::vector<LightExtent>& lights, ConeTuning tuning,
  const Monitor& monitor, ConeTuningResult& result);

} // namespace shadowcones

#endif
