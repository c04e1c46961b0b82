// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightData.h
 * @brief Lights as poly data: the field arrays that carry the exact shape, written and read.
 */
#ifndef scLightData_h
#define scLightData_h

#include "ShadowConesDataModule.h"
#include "scLight.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace shadowcones
{

/**
 * Add the exact shape to the field data of @p output: "LightShape" (int 1), "LightCenter", "LightNormal" (double 3),
 * "LightAxes" (double, two tuples of 3: Rectangle's half edges), "LightRadius" (double 1), "LightSpectrum" (double, one a
 * wavelength sample).
 */
SHADOWCONESDATA_EXPORT void WriteLightFieldData(const Light& light, vtkDataObject* output);

/**
 * Read a light and prepare it for sampling: from the field data where "LightShape" is there, else every polygon of the mesh
 * emits along its normal, and without polygons every vertex is a point light. A mesh's spectrum is its field array
 * "LightSpectrum", or 1 at each of seven samples. @return false, with a sentence in @p error, where there is no light:
 * null or empty input, zero area, a value that is not finite, a field array missing or of the wrong size.
 */
SHADOWCONESDATA_EXPORT bool ReadLight(vtkPolyData* input, Light& light, std::string& error);

/// The light's wavelengths in nm where it says so, else the default ones for its number of samples.
SHADOWCONESDATA_EXPORT std::vector<double> ReadWavelengths(vtkPolyData* light, std::size_t count);

} // namespace shadowcones

#endif
