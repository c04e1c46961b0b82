// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonTracing.h
 * @brief Ranges of photons traced in parallel, joined in their order. Internal to Core.
 */
#ifndef scPhotonTracing_h
#define scPhotonTracing_h

#include "scParallel.h"
#include "scPhotonBundles.h"
#include "scPhotonTracer.h"
#include "scShadowVectors.h"
#include "scTeam.h"

#include <vector>

namespace shadowcones
{

/// What photons are traced with.
struct PhotonTracing
{
  const PhotonTracer& Tracer;
  PhotonBundles& Bundles;
  Team* Workers = nullptr; ///< who trace a range together

  /// Trace one photon, which is to have this index.
  void Trace(const PhotonBundles::BundlePhoton& photon, vtkIdType index, ShadowVectorResult& result) const
  {
    this->Tracer.Trace(
      this->Bundles.Emit(photon.Bundle, photon.Index), this->Bundles.LightOf(photon.Bundle), index, result);
  }
  /// Trace photons [begin, end). @return false where aborted.
  bool TraceRange(vtkIdType begin, vtkIdType end, const Monitor& monitor, ShadowVectorResult& result) const;
};

/// What is one item in arrays of a result: a vector, a path or a shadow photon.
constexpr int numberOfPhotonItems = 3;

/// Call visit(item, components, array of a, array of b) for all arrays of two results.
template <typename A, typename B, typename Visitor>
void ForEachArray(A& a, B& b, const Visitor& visit)
{
  visit(0, 3, a.Vectors.Points, b.Vectors.Points);
  visit(0, 3, a.Vectors.Directions, b.Vectors.Directions);
  visit(0, 3, a.Vectors.Normals, b.Vectors.Normals);
  visit(0, 1, a.Vectors.OccluderIds, b.Vectors.OccluderIds);
  visit(0, 3, a.Vectors.EmissionPoints, b.Vectors.EmissionPoints);
  visit(0, 1, a.Vectors.PathLengths, b.Vectors.PathLengths);
  visit(0, 1, a.Vectors.Thicknesses, b.Vectors.Thicknesses);
  visit(0, 1, a.Vectors.PhotonIndices, b.Vectors.PhotonIndices);
  visit(0, 1, a.Vectors.LightIds, b.Vectors.LightIds);
  visit(1, 3, a.Paths.Points, b.Paths.Points);
  visit(1, 1, a.Paths.States, b.Paths.States);
  visit(1, 1, a.Paths.OccluderIds, b.Paths.OccluderIds);
  visit(1, 3, a.Paths.EmissionPoints, b.Paths.EmissionPoints);
  visit(1, 3, a.Paths.Directions, b.Paths.Directions);
  visit(1, 1, a.Paths.Powers, b.Paths.Powers);
  visit(1, 1, a.Paths.PhotonIndices, b.Paths.PhotonIndices);
  visit(1, 1, a.Paths.LightIds, b.Paths.LightIds);
  visit(2, 3, a.Photons.Points, b.Photons.Points);
  visit(2, 3, a.Photons.Normals, b.Photons.Normals);
  visit(2, 3, a.Photons.Directions, b.Photons.Directions);
  visit(2, 1, a.Photons.Powers, b.Photons.Powers);
  visit(2, 1, a.Photons.OccluderIds, b.Photons.OccluderIds);
  visit(2, 1, a.Photons.ReceiverIds, b.Photons.ReceiverIds);
  visit(2, 1, a.Photons.PhotonIndices, b.Photons.PhotonIndices);
  visit(2, 1, a.Photons.LightIds, b.Photons.LightIds);
}

/// Append the results of ranges that follow each other, and free them.
void AppendAll(ShadowVectorResult& result, const std::vector<ShadowVectorResult*>& ranges);
/// Each process of the team has found about as much as this one: make room for that of all, behind what is there.
void MakeRoomForAll(const Team& team, const ShadowVectorResult& own, ShadowVectorResult& all);
/// Join all that photons left behind in each process behind what is there, but for sums.
void AddPhotons(TeamJoin& join, ShadowVectorResult& own, ShadowVectorResult& all);

} // namespace shadowcones

#endif
