// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDensityData.h
 * @brief The density of a medium as image data.
 */
#ifndef scDensityData_h
#define scDensityData_h

#include "ShadowConesDataModule.h"
#include "scDensityGrid.h"

#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;

namespace shadowcones
{

/**
 * The point array that SetInputArrayToProcess of a filter chooses on @p port, where it chooses one; nullptr: the usual one.
 * @return false, with a sentence in @p error, where the choice is of another port, of cells, or not there.
 */
SHADOWCONESDATA_EXPORT bool ChooseDensity(
  vtkAlgorithm* filter, int port, vtkImageData* density, vtkDataArray*& values, std::string& error);

/**
 * Read a density and prepare it: the point array @p chosen, or where it is null the point array "Density", else the active point scalars, else the first point array; one
 * component, relative to SigmaS and SigmaA. Any origin, spacing, extent and direction matrix; along an axis with a single
 * point the density is constant. @return false, with a sentence in @p error that names what is missing or the point whose
 * value is negative or not finite.
 */
SHADOWCONESDATA_EXPORT bool ReadDensity(
  vtkImageData* input, vtkDataArray* chosen, DensityGrid& grid, std::string& error);

} // namespace shadowcones

#endif
