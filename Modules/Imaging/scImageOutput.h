// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageOutput.h
 * @brief Pixels of a scattering image, their colours, and what they were seen with, as arrays. Internal to Imaging.
 */
#ifndef scImageOutput_h
#define scImageOutput_h

#include "scScatteringImage.h"
#include "scToneMap.h"

#include <vector>

class vtkCamera;
class vtkFieldData;
class vtkImageData;
class vtkPointData;

namespace shadowcones
{

/// Add every array of an image but "RGB": those of @p image itself, which loses them.
void WritePixels(ScatteringImage& image, vtkPointData* points);
/**
 * The exposure of an image that is there as a whole, from "InScattering" + "SurfaceRadiance" or, where one is missing, from
 * "Radiance"; with "MultipleScattering" + "IndirectSurface" where they are there. Slices along z count alike.
 */
double FindExposure(vtkImageData* image, const std::vector<double>& wavelengthsInNm);
/// Add "RGB", the active scalars, of the "Radiance" of an image to @p output, and field data "Exposure". @return false where
/// aborted: nothing is added.
bool WriteRgb(vtkImageData* image, const ToneMapping& mapping, const Monitor& monitor, vtkImageData* output);
void WriteCamera(vtkCamera* camera, vtkFieldData* field);

} // namespace shadowcones

#endif
