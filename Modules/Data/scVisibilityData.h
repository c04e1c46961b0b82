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
#include <vector>

class vtkDataSetAttributes;
class vtkImageData;

namespace shadowcones
{

/**
 * Read a visibility volume, a grid for each light: the point array "Visibility" (one component a light, 0..1), and where
 * they are there "ShadowClass" (as many) and "Marked" (one component; otherwise they follow from the values) and the bricks
 * in the field data, of light 0 where there is no "BrickLightId". Bricks count only where they were filled for these
 * dimensions, this origin and spacing and these values; @p warning says why others are left out. At least two points along
 * every axis, no rotation.
 * @return false, with a sentence in @p error that names what is missing or wrong.
 */
SHADOWCONESDATA_EXPORT bool ReadVisibilityGrids(
  vtkImageData* input, std::vector<VisibilityGrid>& grids, std::string& error, std::string& warning);

/// Write what @p extent holds of grids, one a light and all of one size, with the bricks that were filled, as image data of
/// that extent. "Marked" is 1 where a cone of any light reaches.
SHADOWCONESDATA_EXPORT void WriteVisibilityGrids(
  const std::vector<VisibilityGrid>& grids, const int extent[6], vtkImageData* output);

/// The same for one light: the first one of several.
SHADOWCONESDATA_EXPORT bool ReadVisibilityGrid(
  vtkImageData* input, VisibilityGrid& grid, std::string& error, std::string& warning);
SHADOWCONESDATA_EXPORT void WriteVisibilityGrid(const VisibilityGrid& grid, const int extent[6], vtkImageData* output);

/// "ShadowClass" of what is hidden.
constexpr unsigned char HiddenShadowClass = 255;

/**
 * Add "Visibility", "ShadowClass", "OccluderId" and "VisibilityError" of @p count points or cells, a component a light.
 * @p items are those that the results belong to, ascending; the others are hidden: they get NaN, 255, -1 and NaN.
 */
SHADOWCONESDATA_EXPORT void WriteVisibility(const VisibilityResult& result, int lights,
  const std::vector<vtkIdType>& items, vtkIdType count, vtkDataSetAttributes* data);

} // namespace shadowcones

#endif
