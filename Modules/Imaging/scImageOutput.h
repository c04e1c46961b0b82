// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageOutput.h
 * @brief Pixels of a scattering image, their colours, and what they were seen with, as arrays. Internal to Imaging.
 */
#ifndef scImageOutput_h
#define scImageOutput_h

#include "scScatteringImage.h"

#include <vector>

class vtkCamera;
class vtkFieldData;
class vtkPointData;

namespace shadowcones
{

/// Add every array of an image, and "RGB": its radiance times @p exposure as sRGB, the active scalars.
void WritePixels(
  const ScatteringImage& image, const std::vector<double>& wavelengthsInNm, double exposure, vtkPointData* points);
void WriteCamera(vtkCamera* camera, vtkFieldData* field);

} // namespace shadowcones

#endif
