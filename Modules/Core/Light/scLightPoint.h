// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightPoint.h
 * @brief A point of a light's faces with the area that it stands for. Internal to Core.
 */
#ifndef scLightPoint_h
#define scLightPoint_h

#include "scVector3.h"

namespace shadowcones
{

/// A point of a light's faces, and the area that it stands for.
struct LightPoint
{
  Vector3 Position;
  Vector3 Normal;
  double Area;
};

} // namespace shadowcones

#endif
