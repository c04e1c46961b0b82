// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSampleTruth.h
 * @brief What a mesh does to the light at sample points, by rays.
 */
#ifndef scSampleTruth_h
#define scSampleTruth_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scShadowClass.h"

#include <cstdint>
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
  SeenSamples Seen() const { return { this->Emitting, this->Lit() }; }
  bool Shadowed() const { return this->Blocked > 0; }
  bool Umbra() const { return this->Seen().Class() == ShadowClass::Umbra; }
  /// Visible fraction of the light; 1 where it does not shine to.
  double Visibility() const { return this->Seen().Fraction(); }
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

} // namespace shadowcones

#endif
