// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageScene.h
 * @brief The inputs of a scattering image as Core sees them. Internal to Imaging.
 */
#ifndef scImageScene_h
#define scImageScene_h

#include "scCamera.h"
#include "scDensityGrid.h"
#include "scLight.h"
#include "scMedium.h"
#include "scMeshData.h"
#include "scScatteringImage.h"
#include "scVisibilityGrid.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace shadowcones
{

/// What is connected; nullptr where nothing is.
struct ImageInputs
{
  vtkPolyData* Mesh;
  vtkPolyData* Light;
  vtkPolyData* Cones;
  vtkImageData* Visibility;
  vtkImageData* Density;
};

/// All that is rendered. It is not to be moved: the medium points to the density.
struct ImageScene
{
  TriangleMesh Mesh;
  Box MeshBounds;
  Light Source;
  std::vector<double> Wavelengths; ///< nm
  bool HasCones = false;
  std::vector<Cone> Cones;
  VisibilityGrid Visibility; ///< Volume: as read; Soft: to be filled
  DensityGrid Density;
  Medium Fog;
  Camera Eye;
  ScatteringOptions Options;

  ImageScene() = default;
  ImageScene(const ImageScene&) = delete;
  ImageScene& operator=(const ImageScene&) = delete;
};

/// Is everything connected that the mode needs? @return false, with a sentence in @p error that says what to connect.
bool CheckInputs(const ImageInputs& inputs, ScatteringMode mode, std::string& error);

/**
 * Read what the mode, in the scene's options, uses of the inputs; reflectances go to the options.
 * @return false, with a sentence in @p error that names the input and what is wrong with it.
 */
bool ReadInputs(const ImageInputs& inputs, ImageScene& scene, std::string& error);

/**
 * The box of the medium, from @p bounds or, where these are not set, from what there is in the scene.
 * @return false, with a sentence in @p error.
 */
bool FindMediumBounds(const double bounds[6], vtkPolyData* light, ImageScene& scene, std::string& error);

} // namespace shadowcones

#endif
