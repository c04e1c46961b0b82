// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonTracer.h
 * @brief Follows photons through a scene and writes down what they leave behind. Internal to Core.
 */
#ifndef scPhotonTracer_h
#define scPhotonTracer_h

#include "scPhotonEmission.h"
#include "scShadowVectors.h"

#include <vector>

namespace shadowcones
{

class PhotonTracer
{
public:
  PhotonTracer(const OccluderScene& scene, const std::vector<Light>& lights, VectorStorage storage);

  /// Follow photon @p index, of this light. Powers are those of the photon alone.
  void Trace(const EmittedPhoton& emitted, int light, vtkIdType index, ShadowVectorResult& result) const;

private:
  struct TracedPhoton : EmittedPhoton
  {
    int LightId = 0;
  };
  struct Passage
  {
    RayHit Entry;
    RayHit Exit;
  };

  int OccluderOf(const RayHit& hit) const { return this->Scene.Mesh().OccluderId(hit.Triangle); }
  bool RepeatsCrossing(
    const EmittedPhoton& photon, const std::vector<RayHit>& hits, std::size_t entry, std::size_t i) const;
  Passage PassageFrom(const EmittedPhoton& photon, const std::vector<RayHit>& hits, std::size_t entry) const;
  void StorePath(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits, std::size_t end,
    PhotonPaths& paths) const;
  void StoreVectors(const TracedPhoton& photon, vtkIdType index, const std::vector<RayHit>& hits, std::size_t end,
    ShadowVectorResult& result) const;
  void StoreVector(const TracedPhoton& photon, vtkIdType index, const Passage& passage, ShadowVectors& vectors) const;
  void StoreShadowPhoton(const TracedPhoton& photon, vtkIdType index, const Passage& passage,
    const std::vector<RayHit>& hits, ShadowPhotons& photons) const;

  const OccluderScene& Scene;
  const VectorStorage Storage;
  const std::vector<bool> Closed;
  std::vector<RayRules> Rules; ///< one a light: for what is flush with it
  Box Whole;
};

} // namespace shadowcones

#endif
