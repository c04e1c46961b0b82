// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVectorFilter.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scSceneLights.h"
#include "scShadowVectors.h"
#include "scVectorData.h"
#include "scWarnings.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
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

void vtkShadowVectorFilter::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(1, light);
}

void vtkShadowVectorFilter::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(1, light);
}

void vtkShadowVectorFilter::RemoveAllLights()
{
  this->RemoveAllInputConnections(1);
}

int vtkShadowVectorFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    FillLightPortInformation(info);
    return 1;
  }
  AcceptBlocks(info);
  return 1;
}

int vtkShadowVectorFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkShadowVectorFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

namespace
{

/// What is to be said of the photons of a whole run.
Warnings ReportPhotons(const TriangleMesh& mesh, const ShadowVectorOptions& options, const ShadowVectorResult& result)
{
  const auto& states = result.Paths.States;
  const auto paths = static_cast<vtkIdType>(states.size());
  const auto blocked = static_cast<vtkIdType>(std::count(states.begin(), states.end(), 1));
  const auto vectors = static_cast<vtkIdType>(result.Vectors.OccluderIds.size());
  const std::string few = TargetNotMet(vectors, options.TargetNumberOfVectors, result.NumberOfPhotons);
  // None is emitted where no light leaves towards an occluder.
  const vtkIdType photons = result.NumberOfPhotons > 0 ? result.NumberOfPhotons : options.NumberOfPhotons;
  Warnings warnings;
  warnings.Add(few.empty() && !mesh.Triangles.empty() ? NothingInShadow(photons, blocked) : few);
  warnings.Add(NothingLit(paths, blocked, result.MeanSolidAngle));
  warnings.Add(blocked > 0 ? OccludersWithoutVectors(mesh.OccluderIds, result.Vectors.OccluderIds) : std::string());
  return warnings;
}

} // namespace

int vtkShadowVectorFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  vtkDataObject* meshInput = vtkDataObject::GetData(inputVector[0]);

  TriangleMesh mesh;
  SceneLights lights;
  if (inputVector[1]->GetNumberOfInformationObjects() == 0)
  {
    vtkErrorMacro("No light on input port 1: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.");
    return 0;
  }
  if (!ReadLights(inputVector[1], lights, error) || !ReadTriangles(meshInput, mesh, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  if (mesh.Triangles.empty() && mesh.NumberOfCells > 0)
  {
    vtkErrorMacro("The mesh on input port 0 has " << mesh.NumberOfCells
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
    if (!mesh.Triangles.empty() && !TraceShadowVectors(scene, lights.Lights, options, MonitorOf(this), result))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Tracing photons failed: " << exception.what());
    return 0;
  }
  if (piece.NumberOfPieces == 1)
  {
    ReportPhotons(mesh, options, result).Say(this);
  }

  for (const std::string& warning : lights.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  const std::uint64_t fingerprint = CastersFingerprintOf(mesh);
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
    AddIdArray(output->GetFieldData(), "PhotonsOfLights", result.PhotonsOfLights);
    WriteOccluderNames(mesh.OccluderNames, output->GetFieldData());
    WriteFingerprints(castersFingerprint, { fingerprint }, output->GetFieldData());
    WriteLights(lights.Lights, output);
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
