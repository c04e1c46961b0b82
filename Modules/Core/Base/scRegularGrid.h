// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRegularGrid.h
 * @brief Points in rows along the axes, and such a grid over a box.
 */
#ifndef scRegularGrid_h
#define scRegularGrid_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "vtkType.h"

#include <array>

namespace shadowcones
{

/// A regular grid of points, x fastest.
struct RegularGrid
{
  Vector3 Origin;
  Vector3 Spacing;
  std::array<int, 3> Dimensions{ 0, 0, 0 };

  vtkIdType NumberOfPoints() const
  {
    return static_cast<vtkIdType>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
  Vector3 Point(int i, int j, int k) const
  {
    return this->Origin + Vector3{ i * this->Spacing.X, j * this->Spacing.Y, k * this->Spacing.Z };
  }
};

/**
 * Points at the centres of the cells of a box, @p resolution cells along its longest side and as many of nearly that
 * size along the others, and one layer of points around it: a field that is clipped to the box changes sign exactly at
 * its faces. A box without volume has no cells: all dimensions are 0.
 */
SHADOWCONESCORE_EXPORT RegularGrid GridOver(const Box& box, int resolution);

} // namespace shadowcones

#endif
