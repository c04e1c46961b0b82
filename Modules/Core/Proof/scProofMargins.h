// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scProofMargins.h
 * @brief By how much the ray engine may see a mesh in other places than it is. Internal to Core.
 */
#ifndef scProofMargins_h
#define scProofMargins_h

#include "scBox.h"
#include "scVector3.h"

namespace shadowcones
{

/// What the ray engine may see of a mesh in other places than it is.
struct ProofMargins
{
  Vector3 Center;        ///< of the mesh's bounds
  double Relative = 0.0; ///< share of a point's largest distance from Center along an axis
  double Least = 0.0;    ///< world units

  double At(const Vector3& point) const;
};

/// Margins for rays on a mesh within the bounds.
ProofMargins ProofMarginsOf(const Box& bounds);

} // namespace shadowcones

#endif
