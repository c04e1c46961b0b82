// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunHours.h"

#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scParameterRanges.h"
#include "scProbePoints.h"
#include "scSentence.h"
#include "scSunData.h"
#include "scSunHours.h"
#include "scWarnings.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <exception>

namespace
{
using namespace shadowcones;

constexpr int meshPort = 1;
constexpr int pathPort = 2;

} // anonymous namespace

/// What is asked, and with what.
struct vtkSunHours::Inputs
{
  ProbePoints Points;
  TriangleMesh Mesh;
  SunCourse Course;
  std::vector<std::uint64_t> Fingerprints; ///< of the casters
};

vtkStandardNewMacro(vtkSunHours);
scDefineGuardedRequests(vtkSunHours);

vtkSunHours::vtkSunHours()
{
  this->SetNumberOfInputPorts(3);
}

scDefineInputPort(vtkSunHours, Mesh, meshPort);
scDefineInputPort(vtkSunHours, Path, pathPort);

int vtkSunHours::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == meshPort)
  {
    AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == pathPort ? "vtkPolyData" : "vtkDataSet");
  }
  // RequestData says what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkSunHours::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector, pathPort);
  return 1;
}

int vtkSunHours::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The data set is asked for what is asked of the output; the rest is needed as a whole.
  RequestWholeInputs(this, request, inputVector, outputVector, 1);
  // The path is the same at every time: it is not to be made anew when the time changes.
  if (inputVector[pathPort]->GetNumberOfInformationObjects() > 0)
  {
    inputVector[pathPort]->GetInformationObject(0)->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  }
  return 1;
}

std::string vtkSunHours::CheckRequest(vtkDataObject* mesh, vtkDataObject* path) const
{
  const double altitude = this->MinimumAltitude;
  std::string fault =
    FirstOutOfRange({ { "MinimumAltitude", altitude, altitude >= -90.0 && altitude <= 90.0, "in -90..90" },
      OneOf("Association", this->Association, { "Points", "Cells" }),
      InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples) });
  if (!fault.empty())
  {
    return fault;
  }
  if (!mesh)
  {
    return "No mesh on input port 1: connect a vtkLabelOccluders or another mesh with SetMeshConnection.";
  }
  return path ? "" : "No path of the Sun on input port 2: connect a vtkSunPath with SetPathConnection.";
}

bool vtkSunHours::ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const
{
  vtkDataObject* meshInput = vtkDataObject::GetData(inputVector[meshPort]);
  vtkDataObject* pathInput = vtkDataObject::GetData(inputVector[pathPort]);
  error = this->CheckRequest(meshInput, pathInput);
  if (!error.empty() || !ReadSunPath(pathInput->GetFieldData(), this->MinimumAltitude, in.Course, error) ||
    !ReadTriangles(meshInput, in.Mesh, error) ||
    !ReadProbePoints(
      vtkDataSet::GetData(inputVector[0]), this->Association == Cells, this->UseNormals, in.Points, error))
  {
    return false;
  }
  if (in.Mesh.Triangles.empty() && in.Mesh.NumberOfCells > 0)
  {
    error = Sentence("The mesh on input port 1 has ", in.Mesh.NumberOfCells,
      " cells and no polygon: shadows need surfaces. Run vtkLabelOccluders on it first.");
    return false;
  }
  in.Fingerprints = { CastersFingerprintOf(in.Mesh) };
  DropReceivers(in.Mesh);
  return true;
}

bool vtkSunHours::Compute(const Inputs& in, Team* team, SunHoursResult& result)
{
  SunHoursOptions options;
  options.AngularRadius = in.Course.AngularRadius;
  options.Up = in.Course.Up;
  options.LowestAltitude = vtkMath::RadiansFromDegrees(std::min(this->MinimumAltitude, 0.0));
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.FindOccluders = this->ComputeOccluders;
  options.Workers = team;
  const OccluderScene scene(in.Mesh.View());
  const double* normals = in.Points.Normals.empty() ? nullptr : in.Points.Normals.data();
  return ComputeSunHours(
    scene, in.Course.Steps, in.Points.Points.data(), normals, in.Points.Count(), options, MonitorOf(this), result);
}

int vtkSunHours::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  Inputs in;
  if (!run.AreInputsWhole(error, 1) || !this->ReadInputs(inputVector, in, error))
  {
    return run.Fail(error);
  }
  SunHoursResult result;
  try
  {
    if (!this->Compute(in, run.GetTeamOn(0), result))
    {
      return 1; // aborted: the output stays empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Counting hours failed: ", ReasonOf(exception)));
  }

  const bool atCells = this->Association == Cells;
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  output->ShallowCopy(vtkDataSet::GetData(inputVector[0]));
  RemoveLightFieldData(output->GetFieldData()); // of a lamp that is asked
  WriteOccluderNames(in.Mesh.OccluderNames, output->GetFieldData());
  WriteFingerprints(castersFingerprint, in.Fingerprints, output->GetFieldData());
  WriteSunHours(result, in.Points.Items, in.Points.NumberOfItems,
    atCells ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData());

  Warnings warnings;
  warnings.Add(SunNeverUp(static_cast<vtkIdType>(in.Course.Steps.size()), this->MinimumAltitude, in.Course.Highest));
  if (warnings.GetSentences().empty() && RequestedPiece(request, outputVector).NumberOfPieces == 1)
  {
    const auto lit = std::count_if(result.Hours.begin(), result.Hours.end(), [](float hours) { return hours > 0.0f; });
    warnings.Add(NoPlaceLit(atCells ? "cells" : "points", in.Points.Count(), in.Course.Steps.empty() ? 1 : lit));
  }
  warnings.Say(this);
  return 1;
}

void vtkSunHours::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumAltitude: " << this->MinimumAltitude << "\n";
  os << indent << "Association: " << (this->Association == Cells ? "Cells" : "Points") << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "ComputeOccluders: " << (this->ComputeOccluders ? "on" : "off") << "\n";
  os << indent << "UseNormals: " << (this->UseNormals ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
