// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scClassifyByCones.h
 * @brief Sample points predicted by cones.
 */
#ifndef scClassifyByCones_h
#define scClassifyByCones_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scConeTally.h"
#include "scParallel.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

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

} // namespace shadowcones

#endif
