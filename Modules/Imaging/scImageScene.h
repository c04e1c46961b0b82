// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageScene.h
 * @brief The inputs of a scattering image as Core sees them. Internal to Imaging.
 */
#ifndef scImageScene_h
#define scImageScene_h

#include "scCamera.h"
#include "scDensityGrid.h"
#include "scMedium.h"
#include "scMeshData.h"
#include "scScatteringImage.h"
#include "scSceneLights.h"
#include "scVisibilityGrid.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;
class vtkInformationVector;
class vtkPolyData;

namespace shadowcones
{

/// What is connected; nullptr where nothing is.
struct ImageInputs
{
  vtkDataObject* Mesh;
  vtkInformationVector* Lights; ///< the port's connections
  vtkPolyData* Cones;
  vtkImageData* Visibility;
  vtkImageData* Density;
  vtkDataArray* DensityValues; ///< the one that was chosen; nullptr: the usual one
};

/// All that is rendered. It is not to be moved: the medium points to the density.
struct ImageScene
{
  TriangleMesh Mesh;
  Box MeshBounds;
  SceneLights Lights;
  bool HasCones = false;
  std::vector<Cone> Cones;
  std::vector<VisibilityGrid> Visibility; ///< one a light; Volume: as read; Soft: to be filled
  DensityGrid Density;
  Medium Fog;
  Camera Eye;
  ScatteringOptions Options;
  std::string Warning; ///< of the inputs; empty where all is well
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> CastersFingerprints;
  std::vector<std::string> Warnings; ///< inputs that do not belong together

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
bool FindMediumBounds(const double bounds[6], ImageScene& scene, std::string& error);

} // namespace shadowcones

#endif
