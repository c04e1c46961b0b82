// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetProbe.h"

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
#include "scParameterRanges.h"
#include "scPreparedInputs.h"
#include "scPreparedScene.h"
#include "scProbePoints.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "scShadowClass.h"
#include "scSpectrumSamples.h"
#include "scVisibilityData.h"
#include "scVisibilityProbe.h"
#include "scWarnings.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>

namespace
{
using namespace shadowcones;

constexpr int coneSetPort = 1;
constexpr int lightPort = 2;
constexpr int meshPort = 3;

} // anonymous namespace

/// What is asked, and with what.
struct vtkConeSetProbe::Inputs
{
  ProbePoints Points;
  std::vector<Cone> Cones;
  bool Proved = false; ///< the cone set, for this mesh and these lights
  SceneLights Lights;
  std::shared_ptr<const PreparedMesh> Mesh; ///< Exact: its casters; else an empty one
  std::vector<std::string> OccluderNames;
  std::vector<std::uint64_t> Fingerprints; ///< of the casters
  ArrivingLightRequest Arriving;
  Warnings Said;
};

vtkStandardNewMacro(vtkConeSetProbe);
scDefineGuardedRequests(vtkConeSetProbe);

vtkConeSetProbe::vtkConeSetProbe()
  : Prepared(std::make_unique<PreparedUser>())
{
  this->SetNumberOfInputPorts(4);
}

vtkConeSetProbe::~vtkConeSetProbe() = default;

scDefinePreparedScene(vtkConeSetProbe);
scDefineInputPort(vtkConeSetProbe, ConeSet, coneSetPort);
scDefineInputPort(vtkConeSetProbe, Mesh, meshPort);
scDefineLightPort(vtkConeSetProbe, lightPort);

void vtkConeSetProbe::SetLuminousEfficacySpectrum(int index, double efficacy)
{
  if (SetSample(this->LuminousEfficacySpectrum, index, efficacy))
  {
    this->Modified();
  }
}

void vtkConeSetProbe::SetLuminousEfficacySpectrum(vtkDataArray* efficacies)
{
  if (SetSamples(this->LuminousEfficacySpectrum, efficacies))
  {
    this->Modified();
  }
}

void vtkConeSetProbe::ClearLuminousEfficacySpectrum()
{
  this->SetLuminousEfficacySpectrum(nullptr);
}

double vtkConeSetProbe::GetLuminousEfficacySpectrum(int index)
{
  return GetSample(this->LuminousEfficacySpectrum, index, -1.0);
}

int vtkConeSetProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, port == 0 ? "vtkDataSet" : "vtkPolyData", info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkConeSetProbe::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  return 1;
}

int vtkConeSetProbe::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The data set is asked for what is asked of the output; the rest is needed as a whole.
  RequestWholeInputs(this, request, inputVector, outputVector, 1);
  return 1;
}

std::string vtkConeSetProbe::CheckRequest(vtkDataObject* cones, bool hasLight, vtkDataObject* mesh) const
{
  std::string fault = FirstOutOfRange({ OneOf("Method", this->Method, { "Exact", "Soft" }),
    OneOf("Association", this->Association, { "Points", "Cells" }),
    InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples) });
  if (!fault.empty())
  {
    return fault;
  }
  if (!hasLight)
  {
    return "No light on input port 2: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.";
  }
  if (this->Method == Exact && !mesh)
  {
    return "Exact needs the mesh on input port 3: connect it with SetMeshConnection, or use Soft.";
  }
  return cones || this->Method == Exact
    ? ""
    : "No cone set on input port 1: connect a vtkConeSetFilter with SetConeSetConnection, or connect the mesh and use "
      "Exact.";
}

bool vtkConeSetProbe::ReadInputs(
  vtkInformationVector** inputVector, vtkFieldData* coneData, Inputs& in, std::string& error)
{
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[coneSetPort]);
  vtkDataObject* meshInput = vtkDataObject::GetData(inputVector[meshPort]);
  const bool exact = this->Method == Exact;
  error = this->CheckRequest(coneInput, inputVector[lightPort]->GetNumberOfInformationObjects() > 0, meshInput);
  if (!error.empty() || (coneInput && !ReadConeSet(coneInput, in.Cones, error)) ||
    !ReadLights(inputVector[lightPort], in.Lights, error) ||
    !(in.Mesh = PrepareMesh(*this->Prepared, exact ? meshInput : nullptr, error)) ||
    !ReadProbePoints(
      vtkDataSet::GetData(inputVector[0]), this->Association == Cells, this->UseNormals, in.Points, error))
  {
    return false;
  }
  if (exact && in.Mesh->Mesh.Triangles.empty() && in.Mesh->Mesh.NumberOfCells > 0)
  {
    error = Sentence("The mesh on input port 3 has ", in.Mesh->Mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkDataSetSurfaceFilter first, or use Soft.");
    return false;
  }
  if (!this->ReadArrivingLight(in, error))
  {
    return false;
  }
  in.OccluderNames = exact ? in.Mesh->Mesh.OccluderNames : ReadOccluderNames(coneData);
  in.Fingerprints = ReadFingerprints(castersFingerprint, coneData);
  if (exact)
  {
    in.Fingerprints = { CompareCasters(
      in.Mesh->CastersFingerprint, meshPort, coneData, "The cone set on input port 1", in.Said) };
    in.Mesh = PrepareCasters(*this->Prepared, in.Mesh);
  }
  else
  {
    UndoCosineCorrection(coneData, in.Cones);
  }
  const std::size_t lights = in.Lights.Lights.size();
  if (coneInput && exact)
  {
    const auto proof = PrepareProof(*this->Prepared, { coneInput, in.Cones, "The cone set on input port 1" }, *in.Mesh,
      in.Lights.Lights, StampsOf(inputVector + lightPort, 1));
    in.Proved = proof->Proved;
    in.Said.Add(proof->Changed);
  }
  if (coneInput)
  {
    AssignCones(coneInput, in.Lights, in.Cones);
  }
  if (exact)
  {
    in.Cones = coneInput ? ConesFor(in.Points.Bounds, lights, ReadCertifiedBounds(coneData), in.Cones)
                         : ConesEverywhere(in.Points.Bounds, lights);
  }
  return true;
}

bool vtkConeSetProbe::ReadArrivingLight(Inputs& in, std::string& error) const
{
  in.Arriving.Irradiance = this->ComputeIrradiance;
  in.Arriving.FluenceRate = this->ComputeFluenceRate;
  in.Arriving.Illuminance = this->ComputeIlluminance;
  const bool needsNormals = this->ComputeIrradiance || this->ComputeIlluminance;
  if (needsNormals && in.Points.Normals.empty() && in.Points.NumberOfItems > 0)
  {
    error = this->UseNormals
      ? Sentence("Irradiance and illuminance need the active normals of the ",
          this->Association == Cells ? "cells" : "points",
          " of the data set on input port 0, and there are none: run vtkPolyDataNormals, or call SetActiveNormals().")
      : "Irradiance and illuminance need normals: turn UseNormals on.";
    return false;
  }
  in.Arriving.Efficacy = LuminousEfficacyAt(in.Lights.Wavelengths);
  for (const auto& [index, efficacy] : this->LuminousEfficacySpectrum)
  {
    const auto count = static_cast<int>(in.Arriving.Efficacy.size());
    if (index < 0 || index >= count || !(efficacy >= 0.0) || std::isinf(efficacy))
    {
      error = Sentence("LuminousEfficacySpectrum is ", efficacy, " at index ", index,
        ": the index must be that of one of the ", count, " wavelengths, the value 0 or above and finite.");
      return false;
    }
    in.Arriving.Efficacy[static_cast<std::size_t>(index)] = efficacy;
  }
  return true;
}

bool vtkConeSetProbe::Probe(const Inputs& in, Team* team, VisibilityResult& result)
{
  VisibilityOptions options;
  options.Method = static_cast<VisibilityMethod>(this->Method);
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.OnSurfaces = in.Points.OnSurfaces;
  options.Irradiance = in.Arriving.Irradiance || in.Arriving.Illuminance;
  options.Fluence = in.Arriving.FluenceRate;
  const std::vector<Light>& lights = in.Lights.Lights;
  const std::shared_ptr<const PreparedOccluders> occluders = PrepareOccluders(*this->Prepared, in.Mesh);
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(in.Cones, lights.size());
  std::vector<std::unique_ptr<const VisibilityProbe>> probes;
  std::vector<const VisibilityProbe*> asked;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    probes.push_back(std::make_unique<const VisibilityProbe>(
      conesOf[k], lights[k], options.Method == VisibilityMethod::Exact ? &occluders->Scene : nullptr, in.Points.Bounds, options));
    asked.push_back(probes.back().get());
  }
  const double* normals = in.Points.Normals.empty() ? nullptr : in.Points.Normals.data();
  return ProbeVisibility(asked, in.Points.Points.data(), normals, in.Points.Count(), MonitorOf(this), result, team);
}

int vtkConeSetProbe::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  const PreparedRun prepared(*this->Prepared);
  vtkPolyData* coneInput = vtkPolyData::GetData(inputVector[coneSetPort]);
  vtkNew<vtkFieldData> none;
  vtkFieldData* coneData = coneInput ? coneInput->GetFieldData() : none.Get();
  std::string error;
  Inputs in;
  if (!run.AreInputsWhole(error, 1) || !this->ReadInputs(inputVector, coneData, in, error))
  {
    return run.Fail(error);
  }
  VisibilityResult result;
  try
  {
    if (!this->Probe(in, run.GetTeamOn(0), result))
    {
      return 1; // aborted: the output stays empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Probing failed: ", ReasonOf(exception)));
  }

  const bool atCells = this->Association == Cells;
  const std::size_t lights = in.Lights.Lights.size();
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  output->ShallowCopy(vtkDataSet::GetData(inputVector[0]));
  WriteLightFingerprints(in.Lights.Lights, output);
  WriteOccluderNames(in.OccluderNames, output->GetFieldData());
  WriteFingerprints(castersFingerprint, in.Fingerprints, output->GetFieldData());
  AddIntArray(output->GetFieldData(), "Certified", 1, { in.Proved || (!coneInput && this->Method == Exact) ? 1 : 0 });
  vtkDataSetAttributes* data = atCells ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData();
  WriteVisibility(result, static_cast<int>(lights), in.Points.Items, in.Points.NumberOfItems, data);
  WriteArrivingLight(result, in.Lights.Lights, in.Arriving, in.Points.Items, in.Points.NumberOfItems, data);
  const auto numberOfCones = static_cast<vtkIdType>(in.Cones.size());
  in.Said.Add(in.Lights.Warnings);
  in.Said.Add(EmptyConeSet(numberOfCones, static_cast<vtkIdType>(in.Mesh->Mesh.Triangles.size() / 3)));
  in.Said.Add(this->Method == Exact ? TooManyDiscarded(coneData, in.Proved) : std::string());
  if (RequestedPiece(request, outputVector).NumberOfPieces == 1)
  {
    const char* const what = atCells ? "cells" : "points";
    const vtkIdType asked = in.Points.Count();
    const vtkIdType inShadow = asked - CountOfClass(result, lights, ShadowClass::Lit);
    in.Said.Add(NoPlaceInShadow(what, asked, inShadow, numberOfCones));
    in.Said.Add(NoPlaceLit(what, asked, asked - CountOfClass(result, lights, ShadowClass::Umbra)));
  }
  in.Said.Say(this);
  return 1;
}

void vtkConeSetProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == Exact ? "Exact" : this->Method == Soft ? "Soft" : "invalid") << "\n";
  os << indent << "Association: "
     << (this->Association == Points     ? "Points"
            : this->Association == Cells ? "Cells"
                                         : "invalid")
     << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "ComputeIrradiance: " << (this->ComputeIrradiance ? "on" : "off") << "\n";
  os << indent << "ComputeFluenceRate: " << (this->ComputeFluenceRate ? "on" : "off") << "\n";
  os << indent << "ComputeIlluminance: " << (this->ComputeIlluminance ? "on" : "off") << "\n";
  os << indent << "LuminousEfficacySpectrum: " << TextOf(this->LuminousEfficacySpectrum) << "\n";
  os << indent << "UseNormals: " << (this->UseNormals ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfPreparations: " << this->GetNumberOfPreparations() << "\n";
  os << indent << "PreparedScene: " << this->GetPreparedScene() << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << "\n";
}
