// SPDX-License-Identifier: BSD-3-Clause
#include "scLampPlane.h"

#include "scLightShapes.h"

namespace shadowcones
{

FlatFace FlatFaceOf(const Light& light)
{
  return VisitShape(light, [&](auto shape) { return shape.Face(light); });
}

} // namespace shadowcones
