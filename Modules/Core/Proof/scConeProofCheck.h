// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeProofCheck.h
 * @brief Is a cone set proved? Decided from mesh, light and cones alone; shares nothing with what makes such sets.
 */
#ifndef scConeProofCheck_h
#define scConeProofCheck_h

#include "ShadowConesCoreModule.h"
#include "scCone.h"
#include "scLight.h"
#include "scParallel.h"
#include "scTriangleMesh.h"

#include <array>
#include <vector>

namespace shadowcones
{

struct ConeProofCheck
{
  bool Proved = false;
  vtkIdType NumberOfPairs = 0; ///< of a part of a triangle and a part of the light, that were looked at
  /// The first pair that no cone holds, in the mesh's order.
  vtkIdType Triangle = -1;
  int LightFace = -1; ///< of a mesh light; -1: the whole light
  std::array<Vector3, 3> Part;
};

/**
 * Look for a part of a casting triangle, before a convex part of the light, that no cone holds with all its shadow. Triangles
 * are cut at the middle of their longest edge, no shorter than a thousandth of the mesh. The cones' values are taken as they
 * are: round them first (StoredCone) to ask for what is stored. Parts inside @p heldBox need no cone of their own where one
 * cone holds that box (CertifiedBounds); pass an empty box otherwise. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool CheckConeProof(const TriangleMeshView& mesh, const Light& light, const std::vector<Cone>& cones,
  const Box& heldBox, const Monitor& monitor, ConeProofCheck& check);

} // namespace shadowcones

#endif
