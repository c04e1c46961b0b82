// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTriangleSides.h
 * @brief Sides of triangles by number. Internal to Core.
 */
#ifndef scTriangleSides_h
#define scTriangleSides_h

#include "vtkType.h"

namespace shadowcones
{

/// Side k of triangle t is number 3 t + k; it runs from corner k to the next one.
inline vtkIdType NextSide(vtkIdType side)
{
  return side % 3 == 2 ? side - 2 : side + 1;
}

} // namespace shadowcones

#endif
