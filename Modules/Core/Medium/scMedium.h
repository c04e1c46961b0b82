// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMedium.h
 * @brief A participating medium inside a box.
 */
#ifndef scMedium_h
#define scMedium_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scPhaseFunction.h"

#include <vector>

namespace shadowcones
{

struct DensityGrid;

/// SigmaS and SigmaA have one value per wavelength sample of the light, 1 / world unit, >= 0.
struct Medium
{
  std::vector<double> SigmaS;
  std::vector<double> SigmaA;
  PhaseFunction Phase;
  Box Bounds;
  const DensityGrid* Density = nullptr; ///< prepared; multiplies SigmaS and SigmaA inside Bounds. nullptr: 1 everywhere
};

} // namespace shadowcones

#endif
