// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVectorFilter.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scOccluderNames.h"
#include "scParameterRanges.h"
#include "scPreparedInputs.h"
#include "scPreparedScene.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "scShadowVectors.h"
#include "scVectorData.h"
#include "scWarnings.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <memory>

using namespace shadowcones;

namespace
{
constexpr int lightPort = 1;

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
  warnings.Add(TooFewVectors(result.NumberOfScarce, result.MinimumVectors, result.PhotonsForScarce));
  warnings.Add(blocked > 0 ? OccludersWithoutVectors(mesh.OccluderIds, result.Vectors.OccluderIds) : std::string());
  return warnings;
}

} // namespace

vtkStandardNewMacro(vtkShadowVectorFilter);
scDefineGuardedRequests(vtkShadowVectorFilter);

vtkShadowVectorFilter::vtkShadowVectorFilter()
  : Prepared(std::make_unique<PreparedUser>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkShadowVectorFilter::~vtkShadowVectorFilter() = default;

scDefinePreparedScene(vtkShadowVectorFilter);
scDefineLightPort(vtkShadowVectorFilter, lightPort);

int vtkShadowVectorFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == lightPort)
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
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkShadowVectorFilter::CheckParameters() const
{
  if (this->NumberOfPhotons < 0 || this->TargetNumberOfVectors < 0)
  {
    return Sentence("NumberOfPhotons (", this->NumberOfPhotons, ") and TargetNumberOfVectors (",
      this->TargetNumberOfVectors, ") must be 0 or more.");
  }
  return FirstOutOfRange({ { "MinimumVectorsPerOccluder", this->MinimumVectorsPerOccluder * 1.0,
                             this->MinimumVectorsPerOccluder >= 0, "0 or above" },
    OneOf("Storage", this->Storage, { "BackSide", "HitPoint" }) });
}

bool vtkShadowVectorFilter::ReadInputs(vtkInformationVector** inputVector,
  std::shared_ptr<const PreparedMesh>& prepared, SceneLights& lights, std::string& error)
{
  if (inputVector[lightPort]->GetNumberOfInformationObjects() == 0)
  {
    error = "No light on input port 1: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.";
    return false;
  }
  if (!ReadLights(inputVector[lightPort], lights, error) ||
    !(prepared = PrepareMesh(*this->Prepared, vtkDataObject::GetData(inputVector[0]), error)))
  {
    return false;
  }
  const TriangleMesh& mesh = prepared->Mesh;
  if (mesh.Triangles.empty() && mesh.NumberOfCells > 0)
  {
    error = Sentence("The mesh on input port 0 has ", mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter, or triangulate, before "
      "vtkLabelOccluders.");
    return false;
  }
  if (mesh.OccluderIds.empty() && !mesh.Triangles.empty())
  {
    error = "The mesh on input port 0 has no cell array \"OccluderId\": run vtkLabelOccluders on it first.";
    return false;
  }
  error = this->CheckParameters();
  return error.empty();
}

int vtkShadowVectorFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  const PreparedRun keeping(*this->Prepared);
  std::string error;
  std::shared_ptr<const PreparedMesh> prepared;
  SceneLights lights;
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, prepared, lights, error))
  {
    return run.Fail(error);
  }
  const TriangleMesh& mesh = prepared->Mesh;
  ShadowVectorOptions options;
  options.NumberOfPhotons = this->NumberOfPhotons;
  options.TargetNumberOfVectors = mesh.Triangles.empty() ? 0 : this->TargetNumberOfVectors;
  options.MinimumVectorsPerOccluder = this->MinimumVectorsPerOccluder;
  options.Storage = static_cast<VectorStorage>(this->Storage);
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  const PieceRequest piece = RequestedPiece(request, outputVector);
  options.Piece = piece.Piece;
  options.NumberOfPieces = piece.NumberOfPieces;
  options.Workers = run.GetTeam();
  ShadowVectorResult result;
  try
  {
    const std::shared_ptr<const PreparedOccluders> occluders = PrepareOccluders(*this->Prepared, prepared);
    if (!mesh.Triangles.empty() && !TraceShadowVectors(occluders->Scene, lights.Lights, options, MonitorOf(this), result))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Tracing photons failed: ", ReasonOf(exception)));
  }

  Warnings warnings = piece.NumberOfPieces == 1 ? ReportPhotons(mesh, options, result) : Warnings();
  WriteShadowVectors(result.Vectors, vtkPolyData::GetData(outputVector, 0));
  WritePhotonPaths(result.Paths, vtkPolyData::GetData(outputVector, 1));
  WriteShadowPhotons(result.Photons, vtkPolyData::GetData(outputVector, 2));
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = vtkPolyData::GetData(outputVector, port);
    vtkFieldData* field = output->GetFieldData();
    AddIdArray(field, "NumberOfPhotons", { result.NumberOfPhotons });
    AddDoubleArray(field, "MeanSolidAngle", 1, { result.MeanSolidAngle });
    AddIntArray(field, "Seed", 1, { this->Seed });
    AddIntArray(field, "Storage", 1, { this->Storage });
    AddIdArray(field, "NumberOfAimedPhotons", { result.NumberOfAimedPhotons });
    AddIdArray(field, "PhotonsOfLights", result.PhotonsOfLights);
    WriteOccluderNames(mesh.OccluderNames, field);
    WriteFingerprints(castersFingerprint, { prepared->CastersFingerprint }, field);
    WriteLights(lights.Lights, output);
  }
  warnings.Add(lights.Warnings);
  warnings.Say(this);
  return 1;
}

void vtkShadowVectorFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPhotons: " << this->NumberOfPhotons << "\n";
  os << indent << "TargetNumberOfVectors: " << this->TargetNumberOfVectors << "\n";
  os << indent << "MinimumVectorsPerOccluder: " << this->MinimumVectorsPerOccluder << "\n";
  os << indent << "Storage: " << (this->Storage == BackSide ? "BackSide" : "HitPoint") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfPreparations: " << this->GetNumberOfPreparations() << "\n";
  os << indent << "PreparedScene: " << this->GetPreparedScene() << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << "\n";
}
