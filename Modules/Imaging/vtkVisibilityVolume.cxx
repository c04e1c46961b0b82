// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityVolume.h"

#include "scConeData.h"
#include "scConeIntervals.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scSceneLights.h"
#include "scVisibilityData.h"
#include "scWarnings.h"

#include "vtkAlgorithmOutput.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <string>

vtkStandardNewMacro(vtkVisibilityVolume);

namespace
{
constexpr int lightPort = 1;
constexpr int meshPort = 2;
constexpr int mostLightSamples = 65536;
constexpr int mostBrickParts = 32;
} // anonymous namespace

struct vtkVisibilityVolume::Scene
{
  std::vector<shadowcones::Cone> Cones;
  shadowcones::SceneLights Lights;
  shadowcones::TriangleMesh Mesh;
  shadowcones::Box MeshBounds; ///< with its receivers
  shadowcones::Box Bounds;     ///< empty: there is nothing
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> CastersFingerprints;

  /// Of the mesh, or without one of the cones: what automatic bounds go around.
  shadowcones::Box Inside() const
  {
    shadowcones::Box inside = this->MeshBounds;
    for (const shadowcones::Cone& cone : this->Cones)
    {
      if (this->MeshBounds.Empty())
      {
        inside.Add(cone.Center);
      }
    }
    return inside;
  }
};

vtkVisibilityVolume::vtkVisibilityVolume()
{
  this->SetNumberOfInputPorts(3);
}

void vtkVisibilityVolume::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(lightPort, light);
}

void vtkVisibilityVolume::SetLightData(vtkDataObject* light)
{
  this->SetInputData(lightPort, light);
}

void vtkVisibilityVolume::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(lightPort, light);
}

void vtkVisibilityVolume::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(lightPort, light);
}

void vtkVisibilityVolume::RemoveAllLights()
{
  this->RemoveAllInputConnections(lightPort);
}

void vtkVisibilityVolume::SetMeshConnection(vtkAlgorithmOutput* mesh)
{
  this->SetInputConnection(meshPort, mesh);
}

void vtkVisibilityVolume::SetMeshData(vtkDataObject* mesh)
{
  this->SetInputData(meshPort, mesh);
}

int vtkVisibilityVolume::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == lightPort)
  {
    shadowcones::FillLightPortInformation(info);
    return 1;
  }
  if (port == meshPort)
  {
    shadowcones::AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

bool vtkVisibilityVolume::CheckDimensions()
{
  constexpr double mostPoints = 2147483647.0;
  const int* n = this->Dimensions;
  if (std::min({ n[0], n[1], n[2] }) < 2 || static_cast<double>(n[0]) * n[1] * n[2] > mostPoints)
  {
    vtkErrorMacro("Dimensions are " << n[0] << ", " << n[1] << ", " << n[2]
                                    << ": each must be at least 2, and all together at most 2^31 - 1 points.");
    return false;
  }
  return true;
}

int vtkVisibilityVolume::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  shadowcones::OfferTimes(this, inputVector, outputVector);
  if (!this->CheckDimensions())
  {
    shadowcones::EmptyOutput(vtkDataObject::GetData(outputVector)); // no run will do it
    return 0;
  }
  // What is announced here is what RequestData delivers, at every time.
  const double* bounds = this->Bounds;
  if (shadowcones::AreUnsetBounds(this->Bounds))
  {
    shadowcones::UpdateInputs(this, inputVector);
    this->FindAutomaticBounds(inputVector);
    bounds = this->AutomaticBounds;
  }
  int whole[6];
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    whole[2 * axis] = 0;
    whole[2 * axis + 1] = this->Dimensions[axis] - 1;
    if (bounds[2 * axis] < bounds[2 * axis + 1])
    {
      origin[axis] = bounds[2 * axis];
      spacing[axis] = (bounds[2 * axis + 1] - origin[axis]) / whole[2 * axis + 1];
    }
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

int vtkVisibilityVolume::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  shadowcones::RequestWholeInputs(this, inputVector);
  return 1;
}

bool vtkVisibilityVolume::CheckParameters()
{
  if (this->Method != Exact && this->Method != Soft)
  {
    vtkErrorMacro("Method is " << this->Method << ": it must be Exact (0) or Soft (1).");
  }
  else if (this->NumberOfLightSamples < 1 || this->NumberOfLightSamples > mostLightSamples)
  {
    vtkErrorMacro(
      "NumberOfLightSamples is " << this->NumberOfLightSamples << ": it must be in 1.." << mostLightSamples << ".");
  }
  else if (this->BrickParts < 1 || this->BrickParts > mostBrickParts)
  {
    vtkErrorMacro("BrickParts is " << this->BrickParts << ": it must be in 1.." << mostBrickParts << ".");
  }
  else if (!(this->RefinementThreshold >= 0.0 && this->RefinementThreshold <= 1.0))
  {
    vtkErrorMacro("RefinementThreshold is " << this->RefinementThreshold << ": it must be in 0..1.");
  }
  else
  {
    return this->CheckDimensions();
  }
  return false;
}

bool vtkVisibilityVolume::ReadInputs(vtkInformationVector** inputs, Scene& scene)
{
  std::string error;
  vtkPolyData* cones = vtkPolyData::GetData(inputs[0]);
  vtkDataObject* mesh = vtkDataObject::GetData(inputs[meshPort]);
  if (inputs[lightPort]->GetNumberOfInformationObjects() == 0)
  {
    vtkErrorMacro("There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().");
  }
  else if (this->Method == Exact && !mesh)
  {
    vtkErrorMacro("Exact needs the mesh: connect it with SetMeshConnection(), or use SetMethodToSoft().");
  }
  else if ((cones || this->Method == Soft) && !shadowcones::ReadConeSet(cones, scene.Cones, error))
  {
    vtkErrorMacro("Cone set (input port 0): " << error);
  }
  else if (!shadowcones::ReadLights(inputs[lightPort], scene.Lights, error))
  {
    vtkErrorMacro("Light (input port 1): " << error);
  }
  else if (mesh && !shadowcones::ReadTriangles(mesh, scene.Mesh, error))
  {
    vtkErrorMacro("Mesh (input port 2): " << error);
  }
  else if (this->Method == Exact && scene.Mesh.Triangles.empty() && scene.Mesh.NumberOfCells > 0)
  {
    vtkErrorMacro("The mesh on input port 2 has "
      << scene.Mesh.NumberOfCells
      << " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use SetMethodToSoft().");
  }
  else
  {
    scene.MeshBounds = shadowcones::MeshBounds(scene.Mesh.View());
    vtkNew<vtkFieldData> none;
    vtkFieldData* coneData = cones ? cones->GetFieldData() : none.Get();
    scene.OccluderNames = mesh ? scene.Mesh.OccluderNames : shadowcones::ReadOccluderNames(coneData);
    scene.CastersFingerprints = shadowcones::ReadFingerprints(shadowcones::castersFingerprint, coneData);
    if (mesh)
    {
      const std::uint64_t own = shadowcones::CastersFingerprintOf(scene.Mesh);
      const std::string mismatch = shadowcones::CompareFingerprints(shadowcones::castersFingerprint,
        coneData, { own }, "The cone set on input port 0", "casters than those of the mesh on input port 2");
      scene.CastersFingerprints = { own };
      if (!mismatch.empty())
      {
        vtkWarningMacro(<< mismatch);
      }
    }
    shadowcones::DropReceivers(scene.Mesh);
    if (this->Method == Soft)
    {
      shadowcones::UndoCosineCorrection(cones->GetFieldData(), scene.Cones);
    }
    if (cones)
    {
      shadowcones::AssignCones(cones, scene.Lights, scene.Cones);
    }
    return true;
  }
  return false;
}

void vtkVisibilityVolume::FindAutomaticBounds(vtkInformationVector** inputs)
{
  std::fill_n(this->AutomaticBounds, 6, 0.0);
  vtkDataObject* mesh = vtkDataObject::GetData(inputs[meshPort]);
  Scene scene;
  std::string fault; // RequestData reports it
  shadowcones::Box around;
  if (inputs[lightPort]->GetNumberOfInformationObjects() > 0 &&
    shadowcones::ReadLights(inputs[lightPort], scene.Lights, fault) &&
    (!mesh || shadowcones::ReadTriangles(mesh, scene.Mesh, fault)) &&
    shadowcones::ReadConeSet(vtkPolyData::GetData(inputs[0]), scene.Cones, fault))
  {
    scene.MeshBounds = shadowcones::MeshBounds(scene.Mesh.View());
    if (shadowcones::BoundsAround(scene.Inside(), scene.Lights.Bounds, around))
    {
      const double found[6] = { around.Min.X, around.Max.X, around.Min.Y, around.Max.Y, around.Min.Z, around.Max.Z };
      std::copy_n(found, 6, this->AutomaticBounds);
    }
  }
}

bool vtkVisibilityVolume::FindBounds(Scene& scene)
{
  const bool automatic = shadowcones::AreUnsetBounds(this->Bounds);
  const double* b = automatic ? this->AutomaticBounds : this->Bounds;
  if (automatic && !(b[0] < b[1]))
  {
    if (!scene.Cones.empty())
    {
      vtkErrorMacro("Bounds are not set, and cone set, mesh and light have no extent to take them from.");
    }
    return scene.Cones.empty();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(b[2 * axis] < b[2 * axis + 1]) || !std::isfinite(b[2 * axis]) || !std::isfinite(b[2 * axis + 1]))
    {
      vtkErrorMacro("Bounds along "
        << "xyz"[axis] << " run from " << b[2 * axis] << " to " << b[2 * axis + 1]
        << ": they must be finite, and the first below the second.");
      return false;
    }
  }
  scene.Bounds = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
  shadowcones::Box joint = scene.Bounds;
  joint.Add(scene.Inside());
  if (automatic && (Length(joint.Min - scene.Bounds.Min) > 0.0 || Length(joint.Max - scene.Bounds.Max) > 0.0))
  {
    vtkWarningMacro("Bounds are not set, and at this time the scene reaches out of the box around it at the first time: from "
      << joint.Min.X << ", " << joint.Min.Y << ", " << joint.Min.Z << " to " << joint.Max.X << ", " << joint.Max.Y << ", "
      << joint.Max.Z << ". Set Bounds that hold all of it.");
  }
  return true;
}

int vtkVisibilityVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const shadowcones::FilterRun run(this, request, inputVector, outputVector);
  shadowcones::EmptyOutput(output); // nothing of the last volume is left after an error or an abort
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  int extent[6];
  if (!shadowcones::RequestedExtent(outInfo, extent))
  {
    return 1; // a piece with no points
  }
  Scene scene;
  if (!this->CheckParameters() || !this->ReadInputs(inputVector, scene) || !this->FindBounds(scene))
  {
    return 0;
  }
  if (scene.Bounds.Empty())
  {
    return 1; // no cones, and nowhere to be lit
  }
  vtkPolyData* cones = vtkPolyData::GetData(inputVector[0]);
  if (!cones)
  {
    scene.Cones = shadowcones::ConesEverywhere(scene.Bounds, scene.Lights.Lights.size());
  }
  else if (this->Method == Exact)
  {
    scene.Cones = shadowcones::ConesFor(
      scene.Bounds, scene.Lights.Lights.size(), cones->GetFieldData(), scene.Cones);
  }

  shadowcones::VisibilityGridOptions options;
  options.Method = static_cast<shadowcones::VisibilityMethod>(this->Method);
  options.Dimensions = { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] };
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.BrickParts = this->BrickParts;
  options.RefinementThreshold = this->RefinementThreshold;
  std::copy(extent, extent + 6, options.Extent.begin());
  const std::vector<shadowcones::Light>& lights = scene.Lights.Lights;
  std::vector<shadowcones::VisibilityGrid> grids(lights.size());
  vtkIdType rays = 0;
  try
  {
    const shadowcones::OccluderScene occluders(scene.Mesh.View());
    const std::vector<std::vector<shadowcones::Cone>> conesOf =
      shadowcones::ConesOfLights(scene.Cones, lights.size());
    const auto count = static_cast<double>(lights.size());
    for (std::size_t k = 0; k < lights.size(); ++k)
    {
      const auto done = static_cast<double>(k);
      if (!shadowcones::FillVisibilityGrid(conesOf[k], lights[k], this->Method == Exact ? &occluders : nullptr,
            scene.Bounds, options, shadowcones::MonitorOf(this).Part(done / count, (done + 1.0) / count), grids[k]))
      {
        return 1; // aborted: no output
      }
      rays += grids[k].NumberOfOcclusionRays;
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Filling the volume failed: " << exception.what() << ".");
    return 0;
  }

  shadowcones::WriteVisibilityGrids(grids, extent, output);
  vtkFieldData* field = output->GetFieldData();
  shadowcones::WriteOccluderNames(scene.OccluderNames, field);
  if (!scene.CastersFingerprints.empty())
  {
    shadowcones::WriteFingerprints(shadowcones::castersFingerprint, scene.CastersFingerprints, field);
  }
  shadowcones::AddIntArray(field, "Method", 1, { this->Method });
  shadowcones::AddIntArray(field, "NumberOfLightSamples", 1, { this->NumberOfLightSamples });
  shadowcones::AddDoubleArray(field, "RefinementThreshold", 1, { this->RefinementThreshold });
  shadowcones::AddIntArray(field, "Seed", 1, { this->Seed });
  shadowcones::AddIdArray(field, "NumberOfOcclusionRays", { rays });
  shadowcones::WriteLightFingerprints(lights, output);
  vtkNew<vtkFieldData> none;
  this->Warn(grids, cones ? cones->GetFieldData() : none.Get(), scene, output->GetNumberOfPoints());
  return 1;
}

/// Say what may be wrong with a filled grid, of which so many points were asked for.
void vtkVisibilityVolume::Warn(const std::vector<shadowcones::VisibilityGrid>& grids, vtkFieldData* coneField,
  const Scene& scene, vtkIdType points)
{
  shadowcones::Warnings warnings;
  for (const std::string& warning : scene.Lights.Warnings)
  {
    warnings.Add(warning);
  }
  const auto numberOfCones = static_cast<vtkIdType>(scene.Cones.size());
  warnings.Add(shadowcones::EmptyConeSet(
    numberOfCones, this->Method == Exact ? static_cast<vtkIdType>(scene.Mesh.Triangles.size() / 3) : 0));
  warnings.Add(this->Method == Exact ? shadowcones::TooManyDiscarded(coneField) : std::string());
  for (const shadowcones::VisibilityGrid& grid : grids)
  {
    warnings.Add(shadowcones::TooCoarse(grid, "Raise Dimensions or BrickParts, or take a smaller box."));
  }
  if (points == static_cast<vtkIdType>(grids.front().ShadowClasses.size()))
  {
    vtkIdType shadowed = 0; // from some light
    vtkIdType lit = 0;      // by some light
    for (std::size_t i = 0; i < grids.front().ShadowClasses.size(); ++i)
    {
      const auto isOf = [i](shadowcones::ShadowClass kind)
      {
        return [i, kind](const shadowcones::VisibilityGrid& grid)
        { return grid.ShadowClasses[i] == static_cast<unsigned char>(kind); };
      };
      shadowed += std::all_of(grids.begin(), grids.end(), isOf(shadowcones::ShadowClass::Lit)) ? 0 : 1;
      lit += std::all_of(grids.begin(), grids.end(), isOf(shadowcones::ShadowClass::Umbra)) ? 0 : 1;
    }
    warnings.Add(shadowcones::NoPlaceInShadow("points", points, shadowed, numberOfCones));
    warnings.Add(shadowcones::NoPlaceLit("points", points, lit));
  }
  warnings.Say(this);
}

void vtkVisibilityVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == Exact ? "Exact" : this->Method == Soft ? "Soft" : "invalid") << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << ", " << this->Dimensions[2]
     << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << ", " << this->Bounds[1] << ", " << this->Bounds[2] << ", "
     << this->Bounds[3] << ", " << this->Bounds[4] << ", " << this->Bounds[5] << "\n";
  const double* a = this->AutomaticBounds;
  os << indent << "AutomaticBounds: " << a[0] << ", " << a[1] << ", " << a[2] << ", " << a[3] << ", " << a[4] << ", "
     << a[5] << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "BrickParts: " << this->BrickParts << "\n";
  os << indent << "RefinementThreshold: " << this->RefinementThreshold << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
