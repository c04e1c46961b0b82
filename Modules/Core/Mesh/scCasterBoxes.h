// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCasterBoxes.h
 * @brief A box around each occluder of a mesh.
 */
#ifndef scCasterBoxes_h
#define scCasterBoxes_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scTriangleMesh.h"

#include <vector>

namespace shadowcones
{

/// The ids of a mesh's casters, ascending, and their boxes; receivers have none.
struct CasterBoxes
{
  std::vector<int> Ids;
  std::vector<Box> Boxes;
};
SHADOWCONESCORE_EXPORT CasterBoxes BoxesOfCasters(const TriangleMeshView& mesh);

} // namespace shadowcones

#endif
