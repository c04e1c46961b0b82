// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scViewCamera.h
 * @brief VTK's camera as Core sees it. Internal to Imaging.
 */
#ifndef scViewCamera_h
#define scViewCamera_h

#include "scBox.h"
#include "scCamera.h"

#include <string>

class vtkCamera;

namespace shadowcones
{

/// Set a camera to look along -z at the sphere around a box, with a view angle of 30 degrees.
void LookAtFront(const Box& box, vtkCamera* camera);
/// Read a camera for an image of that size. @return false, with a sentence in @p error.
bool ReadCamera(vtkCamera* camera, const int resolution[2], Camera& used, std::string& error);

} // namespace shadowcones

#endif
