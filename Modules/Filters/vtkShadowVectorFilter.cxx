// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVectorFilter.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scShadowVectors.h"
#include "scVectorData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <exception>

using namespace shadowcones;

vtkStandardNewMacro(vtkShadowVectorFilter);

vtkShadowVectorFilter::vtkShadowVectorFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

void vtkShadowVectorFilter::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(1, light);
}

void vtkShadowVectorFilter::SetLightData(vtkDataObject* light)
{
  this->SetInputData(1, light);
}

int vtkShadowVectorFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // A missing light is reported by RequestData, which can say what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1 ? 1 : 0);
  return 1;
}

int vtkShadowVectorFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  HandlePieces(outputVector);
  return 1;
}

int vtkShadowVectorFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

int vtkShadowVectorFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* meshInput = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* lightInput = vtkPolyData::GetData(inputVector[1]);

  TriangleMesh mesh;
  Light light;
  std::string error;
  if (!lightInput)
  {
    vtkErrorMacro("No light on input port 1: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.");
    return 0;
  }
  if (!ReadLight(lightInput, light, error) || !ReadTriangles(meshInput, mesh, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (mesh.Triangles.empty() && meshInput->GetNumberOfCells() > 0)
  {
    vtkErrorMacro("The mesh on input port 0 has " << meshInput->GetNumberOfCells()
      << " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter, or triangulate, before vtkLabelOccluders.");
    return 0;
  }
  if (mesh.OccluderIds.empty() && !mesh.Triangles.empty())
  {
    vtkErrorMacro("The mesh on input port 0 has no cell array \"OccluderId\": run vtkLabelOccluders on it first.");
    return 0;
  }
  if (this->NumberOfPhotons < 0 || this->TargetNumberOfVectors < 0)
  {
    vtkErrorMacro("NumberOfPhotons (" << this->NumberOfPhotons << ") and TargetNumberOfVectors ("
      << this->TargetNumberOfVectors << ") must be 0 or more.");
    return 0;
  }
  if (this->Storage != BACK_SIDE && this->Storage != HIT_POINT)
  {
    vtkErrorMacro("Storage is " << this->Storage << "; it must be 0 (BackSide) or 1 (HitPoint).");
    return 0;
  }

  ShadowVectorOptions options;
  options.NumberOfPhotons = this->NumberOfPhotons;
  options.TargetNumberOfVectors = mesh.Triangles.empty() ? 0 : this->TargetNumberOfVectors;
  options.Storage = static_cast<VectorStorage>(this->Storage);
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  const PieceRequest piece = RequestedPiece(request, outputVector);
  options.Piece = piece.Piece;
  options.NumberOfPieces = piece.NumberOfPieces;

  ShadowVectorResult result;
  try
  {
    const OccluderScene scene(mesh.View());
    if (!mesh.Triangles.empty() && !TraceShadowVectors(scene, light, options, MonitorOf(this), result))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Tracing photons failed: " << exception.what());
    return 0;
  }
  if (piece.NumberOfPieces == 1 &&
    static_cast<vtkIdType>(result.Vectors.OccluderIds.size()) < options.TargetNumberOfVectors)
  {
    vtkWarningMacro("Only " << result.Vectors.OccluderIds.size() << " of " << options.TargetNumberOfVectors
      << " vectors were stored by " << result.NumberOfPhotons
      << " photons: hardly any light meets an occluder. Check where the light is and which way it faces.");
  }

  WriteShadowVectors(result.Vectors, vtkPolyData::GetData(outputVector, 0));
  WritePhotonPaths(result.Paths, vtkPolyData::GetData(outputVector, 1));
  WriteShadowPhotons(result.Photons, vtkPolyData::GetData(outputVector, 2));
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = vtkPolyData::GetData(outputVector, port);
    AddIdArray(output->GetFieldData(), "NumberOfPhotons", { result.NumberOfPhotons });
    AddDoubleArray(output->GetFieldData(), "MeanSolidAngle", 1, { result.MeanSolidAngle });
    AddIntArray(output->GetFieldData(), "Seed", 1, { this->Seed });
    AddIntArray(output->GetFieldData(), "Storage", 1, { this->Storage });
    if (light.Shape != LightShape::Mesh)
    {
      WriteLightFieldData(light, output);
    }
  }
  return 1;
}

void vtkShadowVectorFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPhotons: " << this->NumberOfPhotons << "\n";
  os << indent << "TargetNumberOfVectors: " << this->TargetNumberOfVectors << "\n";
  os << indent << "Storage: " << (this->Storage == BACK_SIDE ? "BackSide" : "HitPoint") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
