// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityVolume.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOptionalBounds.h"
#include "scVisibilityData.h"

#include "vtkAlgorithmOutput.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
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
  shadowcones::Light Light;
  shadowcones::TriangleMesh Mesh;
  shadowcones::Box MeshBounds; ///< with its receivers
  shadowcones::Box Bounds;     ///< empty: there is nothing
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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // What is missing is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
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

int vtkVisibilityVolume::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->CheckDimensions())
  {
    return 0;
  }
  int whole[6];
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    whole[2 * axis] = 0;
    whole[2 * axis + 1] = this->Dimensions[axis] - 1;
    // Bounds that are not set follow from the inputs, and with them the final values.
    if (this->Bounds[2 * axis] < this->Bounds[2 * axis + 1])
    {
      origin[axis] = this->Bounds[2 * axis];
      spacing[axis] = (this->Bounds[2 * axis + 1] - origin[axis]) / whole[2 * axis + 1];
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
  vtkPolyData* light = vtkPolyData::GetData(inputs[lightPort]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[meshPort]);
  if (!light)
  {
    vtkErrorMacro("There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().");
  }
  else if (this->Method == Exact && !mesh)
  {
    vtkErrorMacro("Exact needs the mesh: connect it with SetMeshConnection(), or use SetMethodToSoft().");
  }
  else if (!shadowcones::ReadConeSet(cones, scene.Cones, error))
  {
    vtkErrorMacro("Cone set (input port 0): " << error);
  }
  else if (!shadowcones::ReadLight(light, scene.Light, error))
  {
    vtkErrorMacro("Light (input port 1): " << error);
  }
  else if (mesh && !shadowcones::ReadTriangles(mesh, scene.Mesh, error))
  {
    vtkErrorMacro("Mesh (input port 2): " << error);
  }
  else if (this->Method == Exact && scene.Mesh.Triangles.empty() && mesh->GetNumberOfCells() > 0)
  {
    vtkErrorMacro("The mesh on input port 2 has "
      << mesh->GetNumberOfCells()
      << " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use SetMethodToSoft().");
  }
  else
  {
    scene.MeshBounds = shadowcones::MeshBounds(scene.Mesh.View());
    shadowcones::DropReceivers(scene.Mesh);
    if (this->Method == Soft)
    {
      shadowcones::UndoCosineCorrection(cones->GetFieldData(), scene.Cones);
    }
    return true;
  }
  return false;
}

bool vtkVisibilityVolume::FindBounds(vtkInformationVector** inputs, Scene& scene)
{
  const double* b = this->Bounds;
  if (shadowcones::AreUnsetBounds(b))
  {
    shadowcones::Box bounds = scene.MeshBounds;
    for (const shadowcones::Cone& cone : scene.Cones)
    {
      if (scene.MeshBounds.Empty())
      {
        bounds.Add(cone.Center);
      }
    }
    if (!shadowcones::BoundsAround(bounds, vtkPolyData::GetData(inputs[lightPort]), scene.Light, scene.Bounds) &&
      !scene.Cones.empty())
    {
      vtkErrorMacro("Bounds are not set, and cone set, mesh and light have no extent to take them from.");
      return false;
    }
    return true;
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
  return true;
}

int vtkVisibilityVolume::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  output->Initialize(); // nothing of the last volume is left after an error or an abort
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece with no points
  }
  Scene scene;
  if (!this->CheckParameters() || !this->ReadInputs(inputVector, scene) || !this->FindBounds(inputVector, scene))
  {
    return 0;
  }
  if (scene.Bounds.Empty())
  {
    return 1; // no cones, and nowhere to be lit
  }

  shadowcones::VisibilityGridOptions options;
  options.Method = static_cast<shadowcones::VisibilityMethod>(this->Method);
  options.Dimensions = { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] };
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.BrickParts = this->BrickParts;
  options.RefinementThreshold = this->RefinementThreshold;
  std::copy(extent, extent + 6, options.Extent.begin());
  shadowcones::VisibilityGrid grid;
  try
  {
    const shadowcones::OccluderScene occluders(scene.Mesh.View());
    if (!shadowcones::FillVisibilityGrid(scene.Cones, scene.Light, this->Method == Exact ? &occluders : nullptr,
          scene.Bounds, options, shadowcones::MonitorOf(this), grid))
    {
      return 1; // aborted: no output
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Filling the volume failed: " << exception.what() << ".");
    return 0;
  }

  shadowcones::WriteVisibilityGrid(grid, extent, output);
  vtkFieldData* field = output->GetFieldData();
  shadowcones::AddIntArray(field, "Method", 1, { this->Method });
  shadowcones::AddIntArray(field, "NumberOfLightSamples", 1, { this->NumberOfLightSamples });
  shadowcones::AddDoubleArray(field, "RefinementThreshold", 1, { this->RefinementThreshold });
  shadowcones::AddIntArray(field, "Seed", 1, { this->Seed });
  shadowcones::AddIdArray(field, "NumberOfOcclusionRays", { grid.NumberOfOcclusionRays });
  return 1;
}

void vtkVisibilityVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == Exact ? "Exact" : this->Method == Soft ? "Soft" : "invalid") << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << ", " << this->Dimensions[2]
     << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << ", " << this->Bounds[1] << ", " << this->Bounds[2] << ", "
     << this->Bounds[3] << ", " << this->Bounds[4] << ", " << this->Bounds[5] << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "BrickParts: " << this->BrickParts << "\n";
  os << indent << "RefinementThreshold: " << this->RefinementThreshold << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
