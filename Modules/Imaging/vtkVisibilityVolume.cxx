// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityVolume.h"

#include "scArrivingLightData.h"
#include "scCone.h"
#include "scConeData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scPreparedInputs.h"
#include "scPreparedScene.h"
#include "scRanks.h"
#include "scSceneLights.h"
#include "scSentence.h"
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
#include <cstdint>
#include <exception>
#include <memory>
#include <string>

using namespace shadowcones;

vtkStandardNewMacro(vtkVisibilityVolume);
scDefineGuardedRequests(vtkVisibilityVolume);

namespace
{
constexpr int lightPort = 1;
constexpr int meshPort = 2;
} // anonymous namespace

struct vtkVisibilityVolume::Scene
{
  std::vector<Cone> Cones;
  bool Proved = false; ///< the cone set, for this mesh and these lights
  SceneLights Lights;
  std::shared_ptr<const PreparedMesh> Mesh; ///< its casters; without one an empty mesh
  Box Bounds;                               ///< empty: there is nothing
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> CastersFingerprints;
  Warnings Said;

  /// Of the mesh, or without one of the cones: what automatic bounds go around.
  Box Inside() const
  {
    Box inside = this->Mesh->Bounds;
    for (const Cone& cone : this->Cones)
    {
      if (this->Mesh->Bounds.Empty())
      {
        inside.Add(cone.Center);
      }
    }
    return inside;
  }
};

vtkVisibilityVolume::vtkVisibilityVolume()
  : Prepared(std::make_unique<PreparedUser>())
{
  this->SetNumberOfInputPorts(3);
}

vtkVisibilityVolume::~vtkVisibilityVolume() = default;

scDefinePreparedScene(vtkVisibilityVolume);
scDefineInputPort(vtkVisibilityVolume, Mesh, meshPort);
scDefineLightPort(vtkVisibilityVolume, lightPort);

int vtkVisibilityVolume::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, "vtkPolyData", info);
  return 1;
}

int vtkVisibilityVolume::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  const std::string error = CheckDimensions("Dimensions", this->Dimensions);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    EmptyOutputs(outputVector); // no run will do it
    return 0;
  }
  // What is announced here is what RequestData delivers, at every time.
  const double* bounds = this->Bounds;
  if (AreUnsetBounds(this->Bounds))
  {
    UpdateInputs(this, inputVector);
    this->FindAutomaticBounds(inputVector);
    bounds = this->AutomaticBounds;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  OfferImage(info, this->Dimensions, bounds);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  return 1;
}

int vtkVisibilityVolume::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkVisibilityVolume::CheckParameters() const
{
  const std::string fault = FirstOutOfRange({ OneOf("Method", this->Method, { "Exact", "Soft" }),
    InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples),
    InRange("BrickParts", this->BrickParts, 1, 32),
    { "RefinementThreshold", this->RefinementThreshold,
      this->RefinementThreshold >= 0.0 && this->RefinementThreshold <= 1.0, "in 0..1" } });
  return fault.empty() ? CheckDimensions("Dimensions", this->Dimensions) : fault;
}

bool vtkVisibilityVolume::ReadInputs(vtkInformationVector** inputs, Scene& scene, std::string& error)
{
  vtkPolyData* cones = vtkPolyData::GetData(inputs[0]);
  vtkDataObject* mesh = vtkDataObject::GetData(inputs[meshPort]);
  const auto fail = [&error](const std::string& sentence)
  {
    error = sentence;
    return false;
  };
  if (inputs[lightPort]->GetNumberOfInformationObjects() == 0)
  {
    return fail("There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().");
  }
  if (this->Method == Exact && !mesh)
  {
    return fail("Exact needs the mesh: connect it with SetMeshConnection(), or use SetMethodToSoft().");
  }
  if ((cones || this->Method == Soft) && !ReadConeSet(cones, scene.Cones, error))
  {
    return fail("Cone set (input port 0): " + error);
  }
  if (!ReadLights(inputs[lightPort], scene.Lights, error))
  {
    return fail("Light (input port 1): " + error);
  }
  scene.Mesh = PrepareMesh(*this->Prepared, mesh, error);
  if (!scene.Mesh)
  {
    return fail("Mesh (input port 2): " + error);
  }
  if (this->Method == Exact && scene.Mesh->Mesh.Triangles.empty() && scene.Mesh->Mesh.NumberOfCells > 0)
  {
    return fail(Sentence("The mesh on input port 2 has ", scene.Mesh->Mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use SetMethodToSoft()."));
  }
  vtkNew<vtkFieldData> none;
  vtkFieldData* coneData = cones ? cones->GetFieldData() : none.Get();
  scene.OccluderNames = mesh ? scene.Mesh->Mesh.OccluderNames : ReadOccluderNames(coneData);
  scene.CastersFingerprints = ReadFingerprints(castersFingerprint, coneData);
  if (mesh)
  {
    scene.CastersFingerprints = { CompareCasters(
      scene.Mesh->CastersFingerprint, meshPort, coneData, "The cone set on input port 0", scene.Said) };
  }
  scene.Mesh = PrepareCasters(*this->Prepared, scene.Mesh);
  if (cones && this->Method == Exact)
  {
    const auto proof = PrepareProof(*this->Prepared, { cones, scene.Cones, "The cone set on input port 0" }, *scene.Mesh,
      scene.Lights.Lights, StampsOf(inputs + lightPort, 1));
    scene.Proved = proof->Proved;
    scene.Said.Add(proof->Changed);
  }
  if (this->Method == Soft)
  {
    UndoCosineCorrection(coneData, scene.Cones);
  }
  if (cones)
  {
    AssignCones(cones, scene.Lights, scene.Cones);
  }
  return true;
}

void vtkVisibilityVolume::FindAutomaticBounds(vtkInformationVector** inputs)
{
  std::fill_n(this->AutomaticBounds, 6, 0.0);
  vtkDataObject* mesh = vtkDataObject::GetData(inputs[meshPort]);
  Scene scene;
  std::string fault; // RequestData reports it
  Box around;
  scene.Mesh = PrepareMesh(*this->Prepared, mesh, fault);
  if (scene.Mesh && inputs[lightPort]->GetNumberOfInformationObjects() > 0 &&
    ReadLights(inputs[lightPort], scene.Lights, fault) &&
    ReadConeSet(vtkPolyData::GetData(inputs[0]), scene.Cones, fault))
  {
    if (BoundsAround(scene.Inside(), scene.Lights.Bounds, around))
    {
      const double found[6] = { around.Min.X, around.Max.X, around.Min.Y, around.Max.Y, around.Min.Z, around.Max.Z };
      std::copy_n(found, 6, this->AutomaticBounds);
    }
  }
}

bool vtkVisibilityVolume::FindBounds(Scene& scene, std::string& error) const
{
  const bool automatic = AreUnsetBounds(this->Bounds);
  const double* b = automatic ? this->AutomaticBounds : this->Bounds;
  if (automatic && !(b[0] < b[1]))
  {
    if (!scene.Cones.empty())
    {
      error = "Bounds are not set, and cone set, mesh and light have no extent to take them from.";
    }
    return scene.Cones.empty();
  }
  if (!ReadSolidBounds("Bounds", b, scene.Bounds, error))
  {
    return false;
  }
  Box joint = scene.Bounds;
  joint.Add(scene.Inside());
  if (automatic && (Length(joint.Min - scene.Bounds.Min) > 0.0 || Length(joint.Max - scene.Bounds.Max) > 0.0))
  {
    scene.Said.Add(OutOfFirstBounds(joint));
  }
  return true;
}

/// A grid for each light, by all of the team. @return false where aborted.
bool vtkVisibilityVolume::FillGrids(
  const Scene& scene, const int extent[6], Team* team, std::vector<VisibilityGrid>& grids)
{
  VisibilityGridOptions options;
  options.Method = static_cast<VisibilityMethod>(this->Method);
  std::copy_n(this->Dimensions, 3, options.Dimensions.begin());
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.BrickParts = this->BrickParts;
  options.RefinementThreshold = this->RefinementThreshold;
  options.Fluence = this->ComputeFluenceRate;
  options.Workers = team;
  std::copy(extent, extent + 6, options.Extent.begin());
  const std::vector<Light>& lights = scene.Lights.Lights;
  const std::shared_ptr<const PreparedOccluders> occluders = PrepareOccluders(*this->Prepared, scene.Mesh);
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(scene.Cones, lights.size());
  return FillVisibilityGrids(
    conesOf, lights, this->Method == Exact ? &occluders->Scene : nullptr, scene.Bounds, options, MonitorOf(this), grids);
}

int vtkVisibilityVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    return run.Fail(error);
  }
  int extent[6];
  if (!RequestedExtent(outInfo, extent))
  {
    return 1; // a piece with no points
  }
  const PreparedRun prepared(*this->Prepared);
  Scene scene;
  error = this->CheckParameters();
  if (!error.empty() || !this->ReadInputs(inputVector, scene, error) || !this->FindBounds(scene, error))
  {
    return run.Fail(error);
  }
  if (scene.Bounds.Empty())
  {
    return 1; // no cones, and nowhere to be lit
  }
  vtkPolyData* cones = vtkPolyData::GetData(inputVector[0]);
  vtkNew<vtkFieldData> none;
  vtkFieldData* coneData = cones ? cones->GetFieldData() : none.Get();
  const std::size_t lights = scene.Lights.Lights.size();
  if (!cones)
  {
    scene.Cones = ConesEverywhere(scene.Bounds, lights);
  }
  else if (this->Method == Exact)
  {
    scene.Cones = ConesFor(scene.Bounds, lights, ReadCertifiedBounds(coneData), scene.Cones);
  }
  std::vector<VisibilityGrid> grids;
  try
  {
    // Processes that ask for an extent each have their own share.
    const bool isWhole = RequestedPiece(request, outputVector).NumberOfPieces == 1;
    if (!this->FillGrids(scene, extent, isWhole ? run.GetTeam() : nullptr, grids))
    {
      return 1; // aborted: no output
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Filling the volume failed: ", ReasonOf(exception), "."));
  }

  vtkIdType rays = 0;
  for (const VisibilityGrid& grid : grids)
  {
    rays += grid.NumberOfOcclusionRays;
    WorkOfThisProcess().Rays += grid.NumberOfOwnRays;
  }
  WriteVisibilityGrids(grids, extent, output);
  WriteFluenceRate(grids, scene.Lights.Lights, extent, output);
  vtkFieldData* field = output->GetFieldData();
  WriteOccluderNames(scene.OccluderNames, field);
  WriteFingerprints(castersFingerprint, scene.CastersFingerprints, field);
  AddIntArray(field, "Method", 1, { this->Method });
  AddIntArray(field, "NumberOfLightSamples", 1, { this->NumberOfLightSamples });
  AddDoubleArray(field, "RefinementThreshold", 1, { this->RefinementThreshold });
  AddIntArray(field, "Seed", 1, { this->Seed });
  AddIdArray(field, "NumberOfOcclusionRays", { rays });
  AddIntArray(field, "Certified", 1, { scene.Proved || (!cones && this->Method == Exact) ? 1 : 0 });
  WriteLightFingerprints(scene.Lights.Lights, output);
  this->Warn(grids, coneData, scene, output->GetNumberOfPoints());
  return 1;
}

/// Say what may be wrong with a filled grid, of which so many points were asked for.
void vtkVisibilityVolume::Warn(
  const std::vector<VisibilityGrid>& grids, vtkFieldData* coneField, const Scene& scene, vtkIdType points)
{
  Warnings warnings = scene.Said;
  warnings.Add(scene.Lights.Warnings);
  const auto numberOfCones = static_cast<vtkIdType>(scene.Cones.size());
  warnings.Add(
    EmptyConeSet(numberOfCones, this->Method == Exact ? static_cast<vtkIdType>(scene.Mesh->Mesh.Triangles.size() / 3) : 0));
  warnings.Add(this->Method == Exact ? TooManyDiscarded(coneField, scene.Proved) : std::string());
  for (const VisibilityGrid& grid : grids)
  {
    warnings.Add(TooCoarse(grid, "Raise Dimensions or BrickParts, or take a smaller box."));
  }
  if (points == static_cast<vtkIdType>(grids.front().ShadowClasses.size()))
  {
    vtkIdType shadowed = 0; // from some light
    vtkIdType lit = 0;      // by some light
    for (std::size_t i = 0; i < grids.front().ShadowClasses.size(); ++i)
    {
      const auto isOf = [i](ShadowClass kind) {
        return [i, kind](const VisibilityGrid& grid)
        { return grid.ShadowClasses[i] == static_cast<unsigned char>(kind); };
      };
      shadowed += std::all_of(grids.begin(), grids.end(), isOf(ShadowClass::Lit)) ? 0 : 1;
      lit += std::all_of(grids.begin(), grids.end(), isOf(ShadowClass::Umbra)) ? 0 : 1;
    }
    warnings.Add(NoPlaceInShadow("points", points, shadowed, numberOfCones));
    warnings.Add(NoPlaceLit("points", points, lit));
  }
  warnings.Say(this);
}

void vtkVisibilityVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == Exact ? "Exact" : this->Method == Soft ? "Soft" : "invalid") << "\n";
  os << indent << "Dimensions: " << Listed(this->Dimensions, 3) << "\n";
  os << indent << "Bounds: " << Listed(this->Bounds, 6) << "\n";
  os << indent << "AutomaticBounds: " << Listed(this->AutomaticBounds, 6) << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "BrickParts: " << this->BrickParts << "\n";
  os << indent << "RefinementThreshold: " << this->RefinementThreshold << "\n";
  os << indent << "ComputeFluenceRate: " << (this->ComputeFluenceRate ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfPreparations: " << this->GetNumberOfPreparations() << "\n";
  os << indent << "PreparedScene: " << this->GetPreparedScene() << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << "\n";
}
