// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DarkScenes.h
 * @brief Scenes where most of the air is in shadow: what light shafts are looked at for.
 */
#ifndef DarkScenes_h
#define DarkScenes_h

#include "scCamera.h"
#include "scMedium.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace shadowcones
{

/// A scene with a light, a medium and a camera of its own; nothing is added to its mesh.
struct DarkScene
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Light;
  shadowcones::Medium Medium;
  shadowcones::Camera Camera;
};

/**
 * "blinds": sun through the blinds of a closed room. "canopy": 4,000 leaves under the sun. "holes": a lamp behind a plate with 36 holes
 * in a closed room. "colonnade": a hall that the sun looks into between columns.
 */
const std::vector<std::string>& DarkSceneNames();
bool IsDarkScene(const std::string& name);
DarkScene MakeDarkScene(const std::string& name);

} // namespace shadowcones

#endif
