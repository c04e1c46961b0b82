// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scImageScene.h
 * @brief The inputs of a scattering image as Core sees them. Internal to Imaging.
 */
#ifndef scImageScene_h
#define scImageScene_h

#include "scCamera.h"
#include "scInputStamp.h"
#include "scMedium.h"
#include "scPhotonData.h"
#include "scPreparedInputs.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scSceneLights.h"
#include "scVisibilityGrid.h"
#include "scWarnings.h"

#include "vtkNew.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkCamera;
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
  vtkInformationVector* PhotonMaps; ///< the port's connections
};

/// All that is rendered.
struct ImageScene
{
  /// @param prepared what is kept from one image to the next.
  explicit ImageScene(PreparedUser& prepared);
  ~ImageScene();
  ImageScene(const ImageScene&) = delete;
  ImageScene& operator=(const ImageScene&) = delete;

  PreparedUser& Prepared;
  std::shared_ptr<const PreparedMesh> Mesh; ///< without one an empty mesh
  SceneLights Lights;
  bool HasCones = false;
  bool ConesProved = false; ///< of Medium and Guided: all that is hidden lies in the cones, as a fact
  Box CertifiedBounds;      ///< the box in which the cones hold, whoever proved them; empty: everywhere, or not proved
  std::vector<Cone> Cones;
  std::shared_ptr<const PreparedGrids> Grids; ///< one a light; Volume: as read; Soft: filled by RenderScene()
  std::shared_ptr<const PreparedDensity> Density;
  std::shared_ptr<const PreparedPhotons> Photons; ///< nullptr where no photon map is connected
  std::vector<InputStamp> LightStamps;
  std::vector<InputStamp> ConeStamps; ///< of all that the lights' cones are made from
  shadowcones::Medium Medium;
  shadowcones::Camera Camera;
  vtkNew<vtkCamera> UsedCamera; ///< as written to the field data
  ScatteringOptions Options;
  VisibilityGridOptions Soft; ///< of the grids that Soft fills: Dimensions and NumberOfLightSamples
  double ConeLength = 0.0;    ///< from their base, up to which cones count; 0: not cut
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> CastersFingerprints;
  Warnings Said; ///< of the inputs
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

/**
 * Read and prepare photon maps, where any is connected; the medium is known. @return false, with a sentence in @p error, or
 * without one where aborted.
 */
bool ReadPhotons(
  const ImageInputs& inputs, int neighbours, const Monitor& monitor, ImageScene& scene, std::string& error);

/**
 * The camera to render with: @p given, or one that looks at the front of the mesh, or without one at the medium.
 * @return false, with a sentence in @p error.
 */
bool ChooseCamera(vtkCamera* given, const int resolution[2], ImageScene& scene, std::string& error);

/// Render extents of the image: i from, to, j from, to. In Soft its grids are filled first. @return false where aborted.
bool RenderScene(ImageScene& scene, const std::vector<std::array<int, 4>>& extents, const Monitor& monitor,
  std::vector<ScatteringImage>& images);

} // namespace shadowcones

#endif
