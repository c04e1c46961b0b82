// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPixelRay.h
 * @brief A camera ray, and the fraction of its pixel that it stands for. Internal to Core.
 */
#ifndef scPixelRay_h
#define scPixelRay_h

#include "scPrimaryHit.h"
#include "scRay.h"

namespace shadowcones
{

/// A camera ray, and the fraction of its pixel that it stands for.
struct PixelRay
{
  double I = 0.0; ///< where it pierces the image, in pixels
  double J = 0.0;
  Ray Line;
  PrimaryHit Hit;
  double Fraction = 1.0;
};

} // namespace shadowcones

#endif
