// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scFreeFlight.h
 * @brief How far a photon flies in a medium before it collides. Internal to Core.
 */
#ifndef scFreeFlight_h
#define scFreeFlight_h

#include "scMedium.h"
#include "scRandom.h"
#include "scRay.h"
#include "scRayInterval.h"

namespace shadowcones
{

/// Draws distances with the density sigma_t rho(t) exp(-sigma_t integral of rho). The medium must outlive it; safe from many threads.
class FreeFlight
{
public:
  explicit FreeFlight(const Medium& medium);

  /**
   * Where a photon collides in a medium of this sigma_t, times the density, along the part @p inside of a ray; infinity: it
   * gets through. In a density by delta tracking (Woodcock et al. 1965): collisions of a medium as dense as the densest
   * place, of which each is a real one in proportion to the density.
   */
  double Sample(double sigmaT, const Ray& ray, const RayInterval& inside, RandomStream& random) const;
  /// Optical depth in units of sigma_t over a part of the ray that lies in the medium's bounds.
  double OpticalDepth(const Ray& ray, const RayInterval& part) const;

private:
  const DensityGrid* Density;
  double Densest = 1.0;
};

} // namespace shadowcones

#endif
