// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeAccuracy.h
 * @brief How far a cone set, or another prediction of shadow, is to be trusted: held against the mesh at sample points.
 *
 * Four steps: DrawSamplePoints and MeasureTruth by rays (scSampleTruth.h), ClassifyByCones (scClassifyByCones.h) or another
 * classifier, TallyAccuracy.
 */
#ifndef scConeAccuracy_h
#define scConeAccuracy_h

#include "ShadowConesCoreModule.h"
#include "scAccuracyTally.h"
#include "scCone.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <vector>

namespace shadowcones
{

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
