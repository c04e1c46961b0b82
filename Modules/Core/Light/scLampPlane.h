// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLampPlane.h
 * @brief Is a light flat, and in what plane does it lie?
 */
#ifndef scLampPlane_h
#define scLampPlane_h

#include "ShadowConesCoreModule.h"
#include "scFlatFace.h"
#include "scLight.h"

namespace shadowcones
{

/// The plane of discs, rectangles and meshes whose triangles all face the same way in one plane; else not flat.
SHADOWCONESCORE_EXPORT FlatFace FlatFaceOf(const Light& light);

} // namespace shadowcones

#endif
