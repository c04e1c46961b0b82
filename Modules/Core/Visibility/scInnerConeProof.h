// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scInnerConeProof.h
 * @brief Inner cones of which it is a fact that no place in them sees any of the light.
 */
#ifndef scInnerConeProof_h
#define scInnerConeProof_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"

#include <vector>

namespace shadowcones
{

/// Inner cones that are proved, and what became of those that were given.
struct InnerConeProof
{
  std::vector<Cone> Cones; ///< Center, BaseRadius, HalfAngle and InnerHalfAngle of what is proved, in the given order
  vtkIdType Whole = 0;     ///< proved on their whole base
  vtkIdType Shrunk = 0;    ///< on a smaller disc of it
  vtkIdType Dropped = 0;   ///< on no disc around their axis of a twentieth of the radius or more
};

/**
 * Every ray from the light to a place in the inner cone of a disc passes through the disc. Where the mesh hides all of the light from
 * all of the disc the whole inner cone is thus in full shadow. It does so where no edge at which a surface ends for the
 * light reaches into the convex hull of disc and light, no surface into either, and one ray between them is hidden: rays are
 * then all alike. For a disc on a flat face that means that the face reaches around it, as far as the light's width
 * makes necessary; edges between faces that both turn to the light, or both away, do not count.
 *
 * A base disc lies on its surface or cuts it: it is moved along the axis, behind the surface, and shrunk about the axis to
 * where the proof holds, such that radius is worth most. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ProveInnerCones(const OccluderScene& scene, const std::vector<Light>& lights,
  const std::vector<Cone>& cones, const Monitor& monitor, InnerConeProof& proof);

} // namespace shadowcones

#endif
