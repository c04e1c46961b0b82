// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightLegsChoice.h
 * @brief Whether a table of densities towards the light serves an image, and how fine it is. Internal to Core.
 */
#ifndef scLightLegsChoice_h
#define scLightLegsChoice_h

#include "scCamera.h"
#include "scLightLegs.h"
#include "scLitQuadrature.h"
#include "scParallel.h"
#include "scScatteringOptions.h"

#include <memory>

namespace shadowcones
{

/// Standard errors that a table may bring into an image: see LightLegs.
struct LightLegsTolerance
{
  double OfRays = 0.0;
  double OfLegs = 0.0;
};

/**
 * The coarsest table that errs by no more along rays all over the image, whatever part of it is asked for; filled. nullptr
 * where none does, or none pays: integrals then. The quadrature's light and medium must outlive it.
 */
std::unique_ptr<const LightLegs> ChooseLightLegs(const LitQuadrature& quadrature, const Camera& camera,
  const ScatteringOptions& options, const LightLegsTolerance& tolerance, const Monitor& monitor);

} // namespace shadowcones

#endif
