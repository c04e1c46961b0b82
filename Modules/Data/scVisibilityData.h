// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityData.h
 * @brief Visibility as arrays of points or cells, and on a grid as image data.
 */
#ifndef scVisibilityData_h
#define scVisibilityData_h

#include "ShadowConesDataModule.h"
#include "scVisibilityGrid.h"
#include "scVisibilityProbe.h"

#include <string>

class vtkDataSetAttributes;
class vtkImageData;

namespace shadowcones
{

/**
 * Read a visibility volume: the point array "Visibility" (one component, 0..1), and where they are there "Marked" and
 * "ShadowClass" (otherwise they follow from the values) and the bricks in the field data. Bricks of an image with other
 * dimensions, from which this one was made, are left out. At least two points along every axis, no rotation.
 * @return false, with a sentence in @p error that names what is missing or wrong.
 */
SHADOWCONESDATA_EXPORT bool ReadVisibilityGrid(vtkImageData* input, VisibilityGrid& grid, std::string& error);

/// Write what @p extent holds of a grid, with the bricks that were filled, as image data of that extent.
SHADOWCONESDATA_EXPORT void WriteVisibilityGrid(const VisibilityGrid& grid, const int extent[6], vtkImageData* output);

/// Add "Visibility", "ShadowClass", "OccluderId" and "VisibilityError", a value each for every point or cell.
SHADOWCONESDATA_EXPORT void WriteVisibility(const VisibilityResult& result, vtkDataSetAttributes* data);

} // namespace shadowcones

#endif
