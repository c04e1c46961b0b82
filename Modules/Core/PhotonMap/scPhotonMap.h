// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonMap.h
 * @brief Photon maps of surfaces and of the medium (Jensen and Christensen, SIGGRAPH 1998), per wavelength.
 *
 * **What is estimated.** A photon leaves a lamp with the flux Phi_k (W) at each wavelength k, the powers of all photons of a
 * lamp adding up to its flux into the scene. Along its path the flux that is still there is
 *
 *     Phi_k f_k,   f_k = product over flights of exp(-sigma_k tau), times over collisions sigma_k rho albedo_k,
 *                        times over reflections rho_k; directions are drawn in exact proportion and cancel
 *
 * with sigma_k the extinction, albedo_k = SigmaS / (SigmaS + SigmaA) and tau the integral of the density rho. A collision
 * stores the flux that the medium scatters there, so that photons in a volume V tell its scattered radiance,
 * L_k = sum of p(cos) Power_k / V; a surface stores the flux that arrives, so that those on an area A tell the irradiance
 * sum of Power_k / A.
 *
 * **Wavelengths.** Where the extinctions differ one free flight cannot be drawn for all. Each photon has a hero wavelength h,
 * uniform, in turn, whose extinction draws its flights: the path has the density p_h, p_j = product of exp(-sigma_j tau)
 * and of sigma_j rho. Its weight is that of the balance heuristic over all heroes (Wilkie et al. 2014):
 *
 *     W_k = Phi_k f_k / (mean over j of p_j)
 *
 * which is unbiased, and at most Phi_k times the number of wavelengths since f_k <= p_k. Two numbers a wavelength are kept:
 * W_k and p_k / mean p; a flight multiplies both by a_k / (mean over j of a_j p_j / mean p), a_k = exp(-(sigma_k - sigma_h) tau),
 * at a collision times sigma_k / sigma_h. With one extinction for all this is 1 and W_k stays Phi_k f_k / p_k.
 *
 * **Russian roulette.** At each collision and reflection the photon goes on with the probability q = sum of W_k after over
 * sum of W_k before (the albedo, weighted), and W_k / q: powers stay alike, and nothing is lost in the mean. q depends on
 * the path alone, not on the hero, and so cancels in the weights.
 *
 * **Account.** Emitted = absorbed by surfaces + absorbed by the medium + escaped + cut off (what was left at
 * MaximumBounces), in the mean.
 */
#ifndef scPhotonMap_h
#define scPhotonMap_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"
#include "scMedium.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scStoredPhotons.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// What photons fly in; nothing is owned. The lights' spectra, SigmaS and SigmaA have one length.
struct PhotonMapScene
{
  const OccluderScene& Occluders;
  const std::vector<Light>& Lights;
  const shadowcones::Medium& Medium;
};

struct PhotonMapOptions
{
  vtkIdType NumberOfPhotons = 100000; ///< emitted by all lights together, at least 0
  int MaximumBounces = 1000;          ///< no photon is stored after more, at least 0
  bool StoreDirect = false;           ///< photons straight from a light too
  vtkIdType MaximumStored = 20000000; ///< photons of a kind
  double Reflectance = 0.5;           ///< see TriangleReflectance
  std::vector<float> SurfaceReflectance;
  int ReflectanceComponents = 1;
  std::uint64_t Seed = 1;
  int Piece = 0; ///< this piece traces photons [N piece / pieces, N (piece + 1) / pieces)
  int NumberOfPieces = 1;
};

/// W, one value a wavelength each: of the photons that were traced.
struct PhotonAccount
{
  std::vector<double> Emitted; ///< into the scene: lights outside the bounds of mesh and medium send at these alone
  std::vector<double> AbsorbedBySurfaces;
  std::vector<double> AbsorbedByMedium;
  std::vector<double> Escaped;
  std::vector<double> CutOff; ///< at MaximumBounces

  explicit PhotonAccount(std::size_t wavelengths = 0)
    : Emitted(wavelengths)
    , AbsorbedBySurfaces(wavelengths)
    , AbsorbedByMedium(wavelengths)
    , Escaped(wavelengths)
    , CutOff(wavelengths)
  {
  }
};

struct PhotonMap
{
  StoredPhotons Surface;
  StoredPhotons Volume;
  PhotonAccount Account;
};

/**
 * Trace photons. Photon i is a pure function of (Seed, i): the emission of a scrambled Sobol sequence, then a random stream
 * of its own. Lights share photons by power, see LightShares. Surfaces are diffuse and alike on both sides; lamps are no
 * bodies. @return false where aborted. Throws std::length_error where more than MaximumStored photons of a kind are to be
 * stored.
 */
SHADOWCONESCORE_EXPORT bool TracePhotonMap(
  const PhotonMapScene& scene, const PhotonMapOptions& options, const Monitor& monitor, PhotonMap& map);

} // namespace shadowcones

#endif
