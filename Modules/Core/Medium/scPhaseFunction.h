// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhaseFunction.h
 * @brief Phase functions: the density of scattered directions. Each integrates to 1 over the sphere.
 */
#ifndef scPhaseFunction_h
#define scPhaseFunction_h

#include "ShadowConesCoreModule.h"

namespace shadowcones
{

enum class PhaseFunctionKind : int
{
  Isotropic = 0,
  BlasiSchlick = 1,     ///< w S(k1) + (1 - w) S(k2), S(k) = (1 - k^2) / (4 pi (1 - k cos)^2)
  HenyeyGreenstein = 2, ///< Henyey and Greenstein 1941, asymmetry g
  Rayleigh = 3          ///< 3 (1 + cos^2) / (16 pi)
};

/// Two-lobe parameters of Blasi, Le Saec and Schlick (1993).
struct SchlickLobes
{
  double Weight = 1.0; ///< of the first lobe, 0..1
  double K1 = 0.0;     ///< in (-1, 1), positive: forward
  double K2 = 0.0;
};

/// Named presets for BlasiSchlick.
SHADOWCONESCORE_EXPORT SchlickLobes SchlickRayleigh();
SHADOWCONESCORE_EXPORT SchlickLobes SchlickHazyMie();
SHADOWCONESCORE_EXPORT SchlickLobes SchlickMurkyMie();

struct PhaseFunction
{
  PhaseFunctionKind Kind = PhaseFunctionKind::Isotropic;
  SchlickLobes Lobes;     ///< BlasiSchlick
  double Asymmetry = 0.0; ///< HenyeyGreenstein g in (-1, 1), positive: forward
};

/// Per steradian. @p cosine between the light's way of travel and the scattered direction: 1 is forward.
SHADOWCONESCORE_EXPORT double EvaluatePhaseFunction(const PhaseFunction& phase, double cosine);

/// The cosine, in exact proportion to the phase function, of a uniform @p u in [0, 1): each by the inverse of its integral.
SHADOWCONESCORE_EXPORT double SamplePhaseCosine(const PhaseFunction& phase, double u);

} // namespace shadowcones

#endif
