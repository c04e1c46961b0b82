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
 * Photons of an estimate of so many photons unless told otherwise. Bias falls with r^2 and noise with 1 / sqrt(N r^2), both on
 * surfaces and, where a ray gathers discs, in the medium: r in proportion to N^(-1/6) makes them fall alike, with N^(-1/3). So
 * k grows with N r^2 on surfaces and with N r^3 in the medium.
 */
SHADOWCONESCORE_EXPORT double NeighboursOnSurfaces(double photons);
SHADOWCONESCORE_EXPORT double NeighboursInMedium(double photons);

/**
 * @param neighbours 0: as many as the functions above say. @param passes of as many photons each, of which this is one: all of
 * them together have the neighbours. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool PreparePhotonEstimates(StoredPhotons surface, StoredPhotons volume, int neighbours,
  int passes, const Monitor& monitor, PhotonEstimates& estimates);

} // namespace shadowcones

#endif
