// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityVolume.h
 * @brief Between visibility volumes as image data and Core's grid, and the box that volumes and media fill.
 */
#ifndef scVisibilityVolume_h
#define scVisibilityVolume_h

#include "ShadowConesImagingModule.h"
#include "scLight.h"
#include "scVisibilityGrid.h"

#include <string>

class vtkImageData;
class vtkPolyData;

namespace shadowcones
{

/**
 * Read a visibility volume: the point array "Visibility" (one component, 0..1), and where they are there "Marked" and
 * "ShadowClass" (otherwise they follow from the values) and the bricks in the field data. Bricks of an image with other
 * dimensions, from which this one was made, are left out. At least two points along every axis, no rotation.
 * @return false, with a sentence in @p error that names what is missing or wrong.
 */
SHADOWCONESIMAGING_EXPORT bool ReadVisibilityGrid(vtkImageData* input, VisibilityGrid& grid, std::string& error);

/// Write what @p extent holds of a grid, with the bricks that were filled, as image data of that extent.
SHADOWCONESIMAGING_EXPORT void WriteVisibilityGrid(
  const VisibilityGrid& grid, const int extent[6], vtkImageData* output);

/// True where six bounds are as filters have them before they are set: 1, -1, 1, -1, 1, -1.
SHADOWCONESIMAGING_EXPORT bool AreUnsetBounds(const double bounds[6]);
/**
 * The box that a medium or a visibility volume fills unless it is told: @p bounds (of the mesh) and the points of the
 * light (not of a Sun), each side enlarged by 10 % about the centre; a flat side becomes 10 % of the diagonal.
 * @return false where there is nothing to take it from.
 */
SHADOWCONESIMAGING_EXPORT bool BoundsAround(const Box& bounds, vtkPolyData* lightData, const Light& light, Box& around);

} // namespace shadowcones

#endif
