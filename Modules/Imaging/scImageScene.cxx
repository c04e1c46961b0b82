// SPDX-License-Identifier: BSD-3-Clause
#include "scImageScene.h"

#include "scCone.h"
#include "scConeData.h"
#include "scFingerprints.h"
#include "scImageOutput.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scViewCamera.h"

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
    scene.OccluderNames = scene.Mesh->Mesh.OccluderNames;
    scene.CastersFingerprints = { scene.Mesh->CastersFingerprint };
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

/// Modes that ask for shadow inside the cones, and take all outside for lit.
bool TakesBounds(ScatteringMode mode)
{
  return mode == ScatteringMode::Medium || mode == ScatteringMode::Guided;
}

/// What is to be said of the cones, before any is used.
void WarnOfCones(const ImageInputs& inputs, ImageScene& scene)
{
  const ScatteringMode mode = scene.Options.Mode;
  scene.Said.Add(EmptyConeSet(static_cast<vtkIdType>(scene.Cones.size()), scene.Mesh->NumberOfCasters));
  if (TakesBounds(mode) || mode == ScatteringMode::Volume)
  {
    scene.Said.Add(TooManyDiscarded(inputs.Cones->GetFieldData(), scene.ConesProved));
  }
}

/// Soft: what the discs hide, on a grid for each light. @return false where aborted.
bool FillSoftGrids(const std::vector<std::vector<Cone>>& conesOf, const Monitor& monitor, ImageScene& scene)
{
  VisibilityGridOptions& soft = scene.Soft;
  soft.Method = VisibilityMethod::Soft;
  soft.Seed = scene.Options.Seed;
  PreparedKey key(PreparedKind::SoftGrids);
  key.Add(scene.ConeStamps).Add(scene.Medium.Bounds).Add(soft.Seed);
  for (const int number : { soft.Dimensions[0], soft.Dimensions[1], soft.Dimensions[2], soft.NumberOfLightSamples })
  {
    key.Add(static_cast<std::uint64_t>(number));
  }
  scene.Grids = scene.Prepared.Get<PreparedGrids>(key,
    [&]() -> std::shared_ptr<const PreparedGrids>
    {
      auto made = std::make_shared<PreparedGrids>();
      if (!FillVisibilityGrids(
            conesOf, scene.Lights.Lights, nullptr, scene.Medium.Bounds, soft, monitor, made->Grids))
      {
        return nullptr;
      }
      made->LayOut();
      return made;
    });
  return scene.Grids != nullptr;
}

/// Do the certificate's cones, as they were read, stand for this scene, and where?
void ReadProof(const ImageInputs& inputs, ImageScene& scene)
{
  scene.CertifiedBounds = ReadCertifiedBounds(inputs.Cones->GetFieldData());
  const auto proof = PrepareProof(scene.Prepared, { inputs.Cones, scene.Cones, "The cone set on input port 2" },
    *scene.Mesh, scene.Lights.Lights, scene.LightStamps);
  scene.Said.Add(proof->Changed);
  scene.ConesProved = proof->Proved && scene.ConeLength == 0.0;
}
} // anonymous namespace

ImageScene::ImageScene(PreparedUser& prepared)
  : Prepared(prepared)
{
}

ImageScene::~ImageScene() = default;

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

  scene.Mesh = PrepareMesh(scene.Prepared, inputs.Mesh, error);
  if (!scene.Mesh)
  {
    error = "Mesh (input port 0): " + error;
    return false;
  }
  const std::shared_ptr<const PreparedReflectance> reflectance =
    PrepareReflectance(scene.Prepared, *scene.Mesh, wavelengths, scene.Options.Reflectance, error);
  if (!reflectance)
  {
    return false;
  }
  if (reflectance->Reflectance.Components > 0)
  {
    scene.Options.ReflectanceComponents = reflectance->Reflectance.Components;
    scene.Options.SurfaceReflectance = reflectance->Reflectance.Values;
  }

  const std::shared_ptr<const PreparedNormals> normals = PrepareNormals(scene.Prepared, *scene.Mesh, error);
  if (!normals)
  {
    return false;
  }
  scene.Options.SurfaceNormals = normals->Normals;

  scene.LightStamps = StampsOf(&inputs.Lights, 1);
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
  if (scene.HasCones && TakesBounds(mode))
  {
    ReadProof(inputs, scene);
  }
  if (scene.HasCones)
  {
    AssignCones(inputs.Cones, scene.Lights, scene.Cones);
  }
  scene.ConeStamps = { StampOf(inputs.Cones) };
  scene.ConeStamps.insert(scene.ConeStamps.end(), scene.LightStamps.begin(), scene.LightStamps.end());
  if (mode == ScatteringMode::Volume)
  {
    scene.Grids = PrepareGrids(scene.Prepared, inputs.Visibility, scene.LightStamps, scene.Lights, error);
    if (!scene.Grids)
    {
      error = "Visibility volume (input port 3): " + error;
      return false;
    }
    scene.Said.Add(scene.Grids->SaidOfBricks);
    scene.Lights.Warnings.insert(
      scene.Lights.Warnings.end(), scene.Grids->SaidOfLights.begin(), scene.Grids->SaidOfLights.end());
  }
  if (inputs.Density)
  {
    scene.Density = PrepareDensity(scene.Prepared, inputs.Density, inputs.DensityValues, error);
    if (!scene.Density)
    {
      error = "Density (input port 4): " + error;
      return false;
    }
  }
  CompareCasters(inputs, scene);
  scene.Said.Add(scene.Lights.Warnings);
  if (scene.HasCones)
  {
    WarnOfCones(inputs, scene);
  }
  scene.Medium.Density = scene.Density ? &scene.Density->Density : nullptr;
  return true;
}

bool FindMediumBounds(const double bounds[6], ImageScene& scene, std::string& error)
{
  Box& box = scene.Medium.Bounds;
  if (AreUnsetBounds(bounds))
  {
    Box inside = scene.Mesh->Bounds;
    if (inside.Empty())
    {
      std::for_each(scene.Cones.begin(), scene.Cones.end(), [&inside](const auto& cone) { inside.Add(cone.Center); });
    }
    if (inside.Empty() && scene.Grids)
    {
      const VisibilityGrid& grid = scene.Grids->Grids.front();
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

bool ReadPhotons(
  const ImageInputs& inputs, int neighbours, const Monitor& monitor, ImageScene& scene, std::string& error)
{
  if (inputs.PhotonMaps->GetNumberOfInformationObjects() == 0)
  {
    return true;
  }
  scene.Photons = PreparePhotons(
    scene.Prepared, inputs.PhotonMaps, scene.Lights.Wavelengths.size(), neighbours, monitor, error);
  if (!scene.Photons)
  {
    error = error.empty() ? error : "Photon map (input port 5): " + error;
    return false;
  }
  std::vector<std::uint64_t> lights;
  for (const Light& light : scene.Lights.Lights)
  {
    lights.push_back(FingerprintOf(light));
  }
  scene.Said.Add(scene.Options.NumberOfPhotonPasses > 0
      ? "NumberOfPhotonPasses is not used: photon maps are connected on input port 5, and their light is taken. Call "
        "RemoveAllPhotonMaps() to trace photons in passes."
      : std::string());
  ComparePhotonMaps(inputs.PhotonMaps, scene.Medium, lights, scene.CastersFingerprints, scene.Said);
  return true;
}

bool ChooseCamera(vtkCamera* given, const int resolution[2], ImageScene& scene, std::string& error)
{
  if (given)
  {
    scene.UsedCamera->DeepCopy(given);
  }
  else
  {
    LookAtFront(scene.Mesh->Bounds.Empty() ? scene.Medium.Bounds : scene.Mesh->Bounds, scene.UsedCamera);
  }
  return ReadCamera(scene.UsedCamera, resolution, scene.Camera, error);
}

bool RenderScene(ImageScene& scene, const std::vector<std::array<int, 4>>& extents, const Monitor& monitor,
  std::vector<ScatteringImage>& images)
{
  constexpr double shareOfSoft = 0.4; // of the progress: filling its grids
  const bool isSoft = scene.Options.Mode == ScatteringMode::Soft;
  const std::shared_ptr<const PreparedOccluders> occluders = PrepareOccluders(scene.Prepared, scene.Mesh);
  const std::shared_ptr<const PreparedOccluders> casters =
    PrepareOccluders(scene.Prepared, PrepareCasters(scene.Prepared, scene.Mesh));
  const std::vector<Light>& lights = scene.Lights.Lights;
  // Surfaces outside the medium lie in shadow too.
  Box bounds = scene.Medium.Bounds;
  bounds.Add(scene.Mesh->Bounds);
  // Cones that are cut on purpose stay so.
  const bool cut = scene.ConeLength > 0.0;
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(
    ConesFor(bounds, lights.size(), cut ? Box{} : scene.CertifiedBounds, scene.Cones), lights.size());
  if (isSoft && !FillSoftGrids(conesOf, monitor.Part(0.0, shareOfSoft), scene))
  {
    return false;
  }
  std::shared_ptr<const PreparedCones> cones;
  if (scene.HasCones && !isSoft)
  {
    cones = PrepareCones(scene.Prepared, scene.ConeStamps, conesOf, bounds, cut ? scene.ConeLength : HUGE_VAL);
  }
  std::vector<ScatteringScene> scenes;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    scenes.push_back({ occluders->Scene, lights[k], scene.Medium, scene.Camera, cones ? cones->OfLights[k].get() : nullptr,
      scene.Grids ? &scene.Grids->Grids[k] : nullptr, scene.Grids ? scene.Grids->Layouts[k].get() : nullptr,
      scene.Photons ? &scene.Photons->Estimates : nullptr, &casters->Scene });
  }
  return RenderScattering(scenes, scene.Options, extents, monitor.Part(isSoft ? shareOfSoft : 0.0, 1.0), images);
}

} // namespace shadowcones
