// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageInputs.h
 * @brief Cameras, coefficients and reflectances as Core sees them. Internal to Imaging.
 */
#ifndef scImageInputs_h
#define scImageInputs_h

#include "scCamera.h"
#include "scScatteringImage.h"
#include "scVector3.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkCamera;
class vtkPolyData;

namespace shadowcones
{

/// A coefficient of one value and, where a wavelength sample has its own, of those: NaN where it has none.
void SetSample(std::vector<double>& spectrum, int index, double value);
double GetSample(const std::vector<double>& spectrum, int index, double all);
/// Its values at every wavelength. @return false, with a sentence in @p error, where one is not valid or not used.
bool ReadCoefficient(const char* name, const std::vector<double>& spectrum, double all, std::size_t wavelengths,
  std::vector<double>& values, std::string& error);

/// Six bounds as a box. @return false, with a sentence in @p error, where they do not ascend or are not finite.
bool ReadBounds(const char* name, const double bounds[6], Box& box, std::string& error);

/// Set a camera to look along -z at the sphere around a box, with a view angle of 30 degrees.
void LookAtFront(const Box& box, vtkCamera* camera);
/// Read a camera for an image of that size. @return false, with a sentence in @p error.
bool ReadCamera(vtkCamera* camera, const int resolution[2], Camera& used, std::string& error);

/**
 * Read the mesh's optional cell array "Reflectance" for triangles that come from @p sourceCells.
 * @return false, with a sentence in @p error that names the wrong size or the cell whose value is not in 0..1.
 */
bool ReadReflectance(vtkPolyData* mesh, const std::vector<vtkIdType>& sourceCells, std::size_t wavelengths,
  ScatteringOptions& options, std::string& error);

} // namespace shadowcones

#endif
