// SPDX-License-Identifier: BSD-3-Clause
#include "scImageScene.h"

#include "scCone.h"
#include "scConeData.h"
#include "scConeHierarchy.h"
#include "scDensityData.h"
#include "scFingerprints.h"
#include "scImageOutput.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scViewCamera.h"
#include "scVisibilityData.h"

#include "scRenderScattering.h"
#include "scScatteringScene.h"
#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace shadowcones
{
namespace
{
const char* const modeNames[] = { "BruteForce", "Medium", "Fast", "Guided", "Soft", "Volume" };

/// Keep the names and the fingerprint of the mesh or else of what stands for it, and warn where they were made from others.
void CompareCasters(const ImageInputs& inputs, ImageScene& scene)
{
  const struct
  {
    vtkDataObject* Data;
    const char* Name;
  } made[] = { { scene.HasCones ? inputs.Cones : nullptr, "The cone set on input port 2" },
    { scene.Options.Mode == ScatteringMode::Volume ? inputs.Visibility : nullptr,
      "The visibility volume on input port 3" } };
  if (inputs.Mesh)
  {
    scene.OccluderNames = scene.Mesh.OccluderNames;
    scene.CastersFingerprints = { CastersFingerprintOf(scene.Mesh) };
  }
  for (const auto& input : made)
  {
    if (input.Data && !inputs.Mesh)
    {
      scene.OccluderNames = ReadOccluderNames(input.Data->GetFieldData());
      scene.CastersFingerprints = ReadFingerprints(castersFingerprint, input.Data->GetFieldData());
    }
    else if (input.Data)
    {
      scene.Said.Add(CompareFingerprints(castersFingerprint, input.Data->GetFieldData(), scene.CastersFingerprints,
        input.Name, "casters than those of the mesh on input port 0"));
    }
  }
}

/// What is to be said of the cones, before any is used.
void WarnOfCones(const ImageInputs& inputs, ImageScene& scene)
{
  const ScatteringMode mode = scene.Options.Mode;
  scene.Said.Add(EmptyConeSet(static_cast<vtkIdType>(scene.Cones.size()), CountCasters(scene.Mesh)));
  if (mode == ScatteringMode::Medium || mode == ScatteringMode::Guided || mode == ScatteringMode::Volume)
  {
    scene.Said.Add(TooManyDiscarded(inputs.Cones->GetFieldData()));
  }
}
} // anonymous namespace

ImageScene::ImageScene() = default;
ImageScene::~ImageScene() = default;

vtkIdType CountCasters(const TriangleMesh& mesh)
{
  if (mesh.OccluderIds.empty()) // without ids there are no receivers
  {
    return static_cast<vtkIdType>(mesh.Triangles.size() / 3);
  }
  return std::count_if(mesh.OccluderIds.begin(), mesh.OccluderIds.end(), [](auto id) { return id >= 0; });
}

bool CheckInputs(const ImageInputs& inputs, ScatteringMode mode, std::string& error)
{
  const std::string chosen = std::string("Mode is ") + modeNames[static_cast<int>(mode)];
  const bool needsMesh =
    mode == ScatteringMode::BruteForce || mode == ScatteringMode::Medium || mode == ScatteringMode::Guided;
  const bool needsCones =
    mode == ScatteringMode::Medium || mode == ScatteringMode::Fast || mode == ScatteringMode::Soft;
  if (inputs.Lights->GetNumberOfInformationObjects() == 0)
  {
    error = "There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().";
  }
  else if (needsMesh && !inputs.Mesh)
  {
    error = chosen +
      " but there is no mesh: connect a vtkLabelOccluders or another poly data, which may be empty, with "
      "SetInputConnection(). Fast, Soft and Volume work without a mesh.";
  }
  else if (needsCones && !inputs.Cones)
  {
    error = chosen +
      " but there is no cone set: connect a vtkConeSetFilter with SetConeSetConnection(), or use SetModeToGuided() or "
      "SetModeToBruteForce(), which work without.";
  }
  else if (mode == ScatteringMode::Volume && !inputs.Visibility)
  {
    error = chosen +
      " but there is no visibility volume: connect a vtkVisibilityVolume with SetVisibilityVolumeConnection(), or use "
      "SetModeToGuided().";
  }
  return error.empty();
}

bool ReadInputs(const ImageInputs& inputs, ImageScene& scene, std::string& error)
{
  const ScatteringMode mode = scene.Options.Mode;
  if (!ReadLights(inputs.Lights, scene.Lights, error))
  {
    error = "Light (input port 1): " + error;
    return false;
  }
  const std::size_t wavelengths = scene.Lights.Wavelengths.size();

  if (inputs.Mesh && !ReadTriangles(inputs.Mesh, scene.Mesh, error))
  {
    error = "Mesh (input port 0): " + error;
    return false;
  }
  scene.MeshBounds = MeshBounds(scene.Mesh.View());
  SurfaceReflectance reflectance;
  if (!ReadReflectance(scene.Mesh, wavelengths, scene.Options.Reflectance, reflectance, error))
  {
    return false;
  }
  if (reflectance.Components > 0)
  {
    scene.Options.ReflectanceComponents = reflectance.Components;
    scene.Options.SurfaceReflectance = std::move(reflectance.Values);
  }

  scene.HasCones = inputs.Cones && mode != ScatteringMode::BruteForce;
  if (scene.HasCones && !ReadConeSet(inputs.Cones, scene.Cones, error))
  {
    error = "Cone set (input port 2): " + error;
    return false;
  }
  if (scene.HasCones && mode == ScatteringMode::Soft)
  {
    UndoCosineCorrection(inputs.Cones->GetFieldData(), scene.Cones);
  }
  if (scene.HasCones)
  {
    AssignCones(inputs.Cones, scene.Lights, scene.Cones);
  }
  scene.Visibility.resize(scene.Lights.Lights.size());
  std::string bricks;
  if (mode == ScatteringMode::Volume &&
    (!ReadVisibilityGrids(inputs.Visibility, scene.Visibility, error, bricks) ||
      !AssignGrids(inputs.Visibility->GetFieldData(), scene.Lights, scene.Visibility, error)))
  {
    error = "Visibility volume (input port 3): " + error;
    return false;
  }
  if (inputs.Density && !ReadDensity(inputs.Density, inputs.DensityValues, scene.Density, error))
  {
    error = "Density (input port 4): " + error;
    return false;
  }
  scene.Said.Add(bricks);
  CompareCasters(inputs, scene);
  scene.Said.Add(scene.Lights.Warnings);
  if (scene.HasCones)
  {
    WarnOfCones(inputs, scene);
  }
  scene.Medium.Density = inputs.Density ? &scene.Density : nullptr;
  return true;
}

bool FindMediumBounds(const double bounds[6], ImageScene& scene, std::string& error)
{
  Box& box = scene.Medium.Bounds;
  if (AreUnsetBounds(bounds))
  {
    Box inside = scene.MeshBounds;
    if (inside.Empty())
    {
      std::for_each(scene.Cones.begin(), scene.Cones.end(), [&inside](const auto& cone) { inside.Add(cone.Center); });
    }
    const VisibilityGrid& grid = scene.Visibility.front();
    if (inside.Empty() && !grid.Visibility.empty())
    {
      const std::array<int, 3>& n = grid.Dimensions;
      box = { grid.Origin, grid.Vertex(n[0] - 1, n[1] - 1, n[2] - 1) };
    }
    else if (!BoundsAround(inside, scene.Lights.Bounds, box))
    {
      error = "MediumBounds are not set, and mesh and light have no bounds to take them from.";
    }
  }
  else if (ReadBounds("MediumBounds", bounds, box, error))
  {
    const Vector3 size = box.Size();
    if (scene.Options.Mode == ScatteringMode::Soft && !(std::min({ size.X, size.Y, size.Z }) > 0.0))
    {
      error = "Mode is Soft and MediumBounds are flat: its grid needs a box with a volume.";
    }
  }
  return error.empty();
}

bool ChooseCamera(vtkCamera* given, const int resolution[2], ImageScene& scene, std::string& error)
{
  if (given)
  {
    scene.UsedCamera->DeepCopy(given);
  }
  else
  {
    LookAtFront(scene.MeshBounds.Empty() ? scene.Medium.Bounds : scene.MeshBounds, scene.UsedCamera);
  }
  return ReadCamera(scene.UsedCamera, resolution, scene.Camera, error);
}

bool RenderScene(ImageScene& scene, const std::vector<std::array<int, 4>>& extents, const Monitor& monitor,
  std::vector<ScatteringImage>& images)
{
  constexpr double shareOfSoft = 0.4; // of the progress: filling its grids
  const bool isSoft = scene.Options.Mode == ScatteringMode::Soft;
  const OccluderScene occluders(scene.Mesh.View());
  const std::vector<Light>& lights = scene.Lights.Lights;
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(scene.Cones, lights.size());
  scene.Soft.Method = VisibilityMethod::Soft;
  scene.Soft.Seed = scene.Options.Seed;
  if (isSoft &&
    !FillVisibilityGrids(
      conesOf, lights, nullptr, scene.Medium.Bounds, scene.Soft, monitor.Part(0.0, shareOfSoft), scene.Visibility))
  {
    return false;
  }
  // Surfaces outside the medium lie in shadow too.
  Box bounds = scene.Medium.Bounds;
  bounds.Add(scene.MeshBounds);
  const double length = scene.ConeLength > 0.0 ? scene.ConeLength : HUGE_VAL;
  const bool usesGrid = isSoft || scene.Options.Mode == ScatteringMode::Volume;
  std::vector<std::unique_ptr<ConeHierarchy>> cones(lights.size());
  std::vector<ScatteringScene> scenes;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    if (scene.HasCones && !isSoft)
    {
      cones[k] = std::make_unique<ConeHierarchy>(conesOf[k], bounds, length);
    }
    scenes.push_back(
      { occluders, lights[k], scene.Medium, scene.Camera, cones[k].get(), usesGrid ? &scene.Visibility[k] : nullptr });
  }
  return RenderScattering(scenes, scene.Options, extents, monitor.Part(isSoft ? shareOfSoft : 0.0, 1.0), images);
}

} // namespace shadowcones
