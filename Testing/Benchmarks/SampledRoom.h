// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledRoom.h
 * @brief How well cones bound a shadow: by samples drawn evenly in the room.
 */
#ifndef SampledRoom_h
#define SampledRoom_h

#include "BenchmarkScene.h"

#include "scAccuracyTally.h"
#include "scClassifyByCones.h"
#include "scConeAccuracy.h"
#include "scConeTally.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Samples in the room and what the mesh does to the light there.
struct SampledRoom
{
  std::vector<Vector3> Points;
  std::vector<SampleTruth> Truth;

  SampledRoom(const BenchmarkScene& scene, int points, int lightPoints, int seed)
  {
    const auto word = static_cast<std::uint64_t>(seed);
    DrawSamplePoints(RoomBounds(), points, word, {}, this->Points);
    MeasureTruth(this->Points, *scene.Fast, scene.Light, lightPoints, word, {}, this->Truth);
  }
  AccuracyTally Measure(const std::vector<Cone>& cones) const
  {
    std::vector<SamplePrediction> predictions;
    std::vector<ConeTally> tallies;
    ClassifyByCones(this->Points, this->Truth, cones, {}, predictions, tallies);
    return TallyAccuracy(this->Truth, predictions, cones, 0).All;
  }
};

} // namespace shadowcones

#endif
