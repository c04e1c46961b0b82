// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scArrivingLightData.h
 * @brief Light that arrives, as arrays of points, cells and grids: irradiance, fluence rate, illuminance.
 */
#ifndef scArrivingLightData_h
#define scArrivingLightData_h

#include "ShadowConesDataModule.h"
#include "scVisibilityGrid.h"
#include "scVisibilityProbe.h"

#include <vector>

class vtkDataSetAttributes;
class vtkImageData;

namespace shadowcones
{

/// Which arrays are asked for.
struct ArrivingLightRequest
{
  bool Irradiance = false;
  bool FluenceRate = false;
  bool Illuminance = false;
  std::vector<double> Efficacy; ///< lm/W, one a wavelength; for Illuminance
};

/**
 * Add what arrives from all lights together: "Irradiance" and "FluenceRate" (a component a wavelength, W m^-2), "Illuminance"
 * (lux), each with its standard error "...Error". @p items are those that the results belong to; the others are hidden and
 * get NaN, as do items without a normal where one is needed.
 */
SHADOWCONESDATA_EXPORT void WriteArrivingLight(const VisibilityResult& result, const std::vector<Light>& lights,
  const ArrivingLightRequest& request, const std::vector<vtkIdType>& items, vtkIdType count,
  vtkDataSetAttributes* data);

/// Add "FluenceRate" and "FluenceRateError" of what @p extent holds of grids, one a light, where they have it.
SHADOWCONESDATA_EXPORT void WriteFluenceRate(const std::vector<VisibilityGrid>& grids, const std::vector<Light>& lights,
  const int extent[6], vtkImageData* output);

/// Luminous efficacy of radiation (lm/W) at wavelengths in nm: 683 times the CIE's V, at the middle of each band.
SHADOWCONESDATA_EXPORT std::vector<double> LuminousEfficacyAt(const std::vector<double>& wavelengths);

} // namespace shadowcones

#endif
