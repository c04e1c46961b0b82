// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonEstimates.h
 * @brief Photon maps, ready to be asked by every pixel.
 */
#ifndef scPhotonEstimates_h
#define scPhotonEstimates_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scPhotonDiscs.h"
#include "scSurfacePhotons.h"

#include <cstdint>

namespace shadowcones
{

struct PhotonEstimates
{
  SurfacePhotons Surface; ///< without photons: no indirect light on surfaces
  PhotonDiscs Volume;     ///< without photons: no multiple scattering

  std::int64_t Memory() const { return this->Surface.Memory() + this->Volume.Memory(); }
};

/**
 * Photons of an estimate of so many photons unless told otherwise. Both grow slower than the map, so that radius and noise
 * shrink together as it grows. In the medium a ray gathers ever more discs of the same number of neighbours.
 */
SHADOWCONESCORE_EXPORT int NeighboursOnSurfaces(vtkIdType photons);
constexpr int NeighboursInMedium = 64;

/// @param neighbours 0: as many as the functions above say. @return false where aborted.
SHADOWCONESCORE_EXPORT bool PreparePhotonEstimates(StoredPhotons surface, StoredPhotons volume, int neighbours,
  const Monitor& monitor, PhotonEstimates& estimates);

} // namespace shadowcones

#endif
