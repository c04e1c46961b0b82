// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetAccuracy.h"

#include "scAccuracyData.h"
#include "scCasterBoxes.h"
#include "scConeData.h"
#include "scConeProofCheck.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "scWarnings.h"

#include "scClassifyByCones.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cstddef>
#include <cstdint>
#include <exception>

namespace
{
using namespace shadowcones;

constexpr int coneSetPort = 1;
constexpr int meshPort = 2;
constexpr int lightPort = 3;

/// A closed box around each occluder.
TriangleMesh BoxesAround(const TriangleMesh& mesh)
{
  const CasterBoxes casters = BoxesOfCasters(mesh.View());
  TriangleMesh result;
  constexpr int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } };
  for (std::size_t k = 0; k < casters.Ids.size(); ++k)
  {
    const auto first = static_cast<vtkIdType>(result.Points.size() / 3);
    const Box& b = casters.Boxes[k];
    for (int i = 0; i < 8; ++i)
    {
      result.Points.insert(
        result.Points.end(), { i & 1 ? b.Max.X : b.Min.X, i & 2 ? b.Max.Y : b.Min.Y, i & 4 ? b.Max.Z : b.Min.Z });
    }
    for (const auto& f : faces)
    {
      result.Triangles.insert(
        result.Triangles.end(), { first + f[0], first + f[1], first + f[2], first + f[0], first + f[2], first + f[3] });
      result.OccluderIds.insert(result.OccluderIds.end(), 2, casters.Ids[k]);
    }
  }
  return result;
}

/// @return false where aborted.
bool MeasureOthers(const TriangleMesh& mesh, const std::vector<Light>& lights, const std::vector<Vector3>& points,
  const std::vector<SampleTruth>& truth, int lightSamples, std::uint64_t seed, const Monitor& monitor,
  OtherBounds& others)
{
  ConeProof parts;
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  if (!ProveConeSet(mesh.View(), lights, {}, {}, monitor.Part(0.0, 0.3), parts) ||
    !ClassifyByCones(lights.size(), points, truth, parts.Cones, monitor.Part(0.3, 0.5), predictions, tallies))
  {
    return false;
  }
  others.Clusters = static_cast<vtkIdType>(parts.Cones.size());
  others.OfClusters = TallyAccuracy(truth, predictions, parts.Cones, 0).All;
  const TriangleMesh boxes = BoxesAround(mesh);
  const OccluderScene scene(boxes.View());
  std::vector<SampleTruth> swept;
  if (!MeasureTruth(points, scene, lights, lightSamples, seed, monitor.Part(0.5, 1.0), swept))
  {
    return false;
  }
  predictions.assign(swept.size(), {});
  for (std::size_t i = 0; i < swept.size(); ++i)
  {
    predictions[i].Class = swept[i].Umbra() ? 2 : swept[i].Shadowed() ? 1 : 0;
  }
  others.OfBoxes = TallyAccuracy(truth, predictions, {}, 0).All;
  return true;
}

/// Has each light cones of its own that the independent check finds proved? @return false where aborted.
bool IsProved(const TriangleMesh& mesh, const std::vector<Light>& lights, const std::vector<Cone>& cones,
  const Box& held, const Monitor& monitor, bool& proved)
{
  const std::vector<std::vector<Cone>> own = ConesOfLights(cones, lights.size());
  proved = true;
  for (std::size_t k = 0; k < lights.size() && proved; ++k)
  {
    const double share = 1.0 / static_cast<double>(lights.size());
    const double begin = static_cast<double>(k) * share;
    ConeProofCheck check;
    if (!CheckConeProof(mesh.View(), lights[k], own[k], held, monitor.Part(begin, begin + share), check))
    {
      return false;
    }
    proved = check.Proved;
  }
  return true;
}

std::string MissingInput(vtkInformationVector** inputVector)
{
  if (!vtkPolyData::GetData(inputVector[coneSetPort]))
  {
    return "No cone set on input port 1: connect a vtkConeSetFilter with SetConeSetConnection.";
  }
  if (!vtkDataObject::GetData(inputVector[meshPort]))
  {
    return "No mesh on input port 2: connect a vtkLabelOccluders with SetMeshConnection.";
  }
  return inputVector[lightPort]->GetNumberOfInformationObjects() == 0
    ? "No light on input port 3: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection."
    : "";
}
} // anonymous namespace

/// What is measured, with what.
struct vtkConeSetAccuracy::Inputs
{
  AccuracySamples Samples;
  std::vector<Cone> Cones;
  TriangleMesh Mesh;
  SceneLights Lights;
  Box Bounds; ///< in which samples are drawn where none are given
  vtkPolyData* ConeSet = nullptr;
  std::uint64_t Fingerprint = 0; ///< of the casters
  Warnings Said;
};

/// What was found.
struct vtkConeSetAccuracy::Outcome
{
  std::vector<SampleTruth> Truth;
  std::vector<SamplePrediction> Predictions;
  std::vector<ConeTally> Tallies;
  OtherBounds Others;
  bool Proved = false;
};

vtkStandardNewMacro(vtkConeSetAccuracy);
scDefineGuardedRequests(vtkConeSetAccuracy);

vtkConeSetAccuracy::vtkConeSetAccuracy()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(5);
}

scDefineInputPort(vtkConeSetAccuracy, ConeSet, coneSetPort);
scDefineInputPort(vtkConeSetAccuracy, Mesh, meshPort);
scDefineLightPort(vtkConeSetAccuracy, lightPort);

int vtkConeSetAccuracy::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, port == 0 ? "vtkDataSet" : "vtkPolyData", info);
  return 1;
}

int vtkConeSetAccuracy::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 || port == 4 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkConeSetAccuracy::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkConeSetAccuracy::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkConeSetAccuracy::CheckParameters() const
{
  return FirstOutOfRange({ InRange("NumberOfSamples", this->NumberOfSamples, 0, 1000000000),
    InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples),
    InRange("NumberOfDepthBins", this->NumberOfDepthBins, 1, 100000) });
}

bool vtkConeSetAccuracy::ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const
{
  in.Samples.Input = vtkDataSet::GetData(inputVector[0]);
  in.ConeSet = vtkPolyData::GetData(inputVector[coneSetPort]);
  error = MissingInput(inputVector);
  if (error.empty())
  {
    error = this->CheckParameters();
  }
  const bool hasBounds = !AreUnsetBounds(this->Bounds);
  if (!error.empty() || (hasBounds && !ReadBounds("Bounds", this->Bounds, in.Bounds, error)) ||
    !ReadConeSet(in.ConeSet, in.Cones, error) ||
    !ReadTriangles(vtkDataObject::GetData(inputVector[meshPort]), in.Mesh, error) ||
    !ReadLights(inputVector[lightPort], in.Lights, error) ||
    (in.Samples.Input && !ReadSamples(in.Samples.Input, in.Lights.Lights.size(), in.Samples, error)))
  {
    return false;
  }
  if (!hasBounds)
  {
    in.Bounds = in.Lights.Bounds;
    in.Bounds.Add(MeshBounds(in.Mesh.View()));
  }
  in.Fingerprint =
    CompareCasters(CastersFingerprintOf(in.Mesh), meshPort, in.ConeSet->GetFieldData(), "The cone set on input port 1", in.Said);
  DropReceivers(in.Mesh);
  AssignCones(in.ConeSet, in.Lights, in.Cones);
  in.Said.Add(in.Lights.Warnings);
  if (static_cast<vtkIdType>(in.Cones.size()) != in.ConeSet->GetNumberOfPoints())
  {
    error = Sentence("The cone set has no \"LightId\" and ", in.Lights.Lights.size(),
      " lights are connected: accuracy is that of each light's own cones. Make them with vtkShadowVectorFilter and "
      "vtkConeSetFilter from all of the lights.");
  }
  return error.empty();
}

bool vtkConeSetAccuracy::Measure(Inputs& in, Outcome& out)
{
  const Monitor monitor = MonitorOf(this);
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  const std::vector<Light>& lights = in.Lights.Lights;
  std::vector<Vector3>& points = in.Samples.Points;
  const OccluderScene scene(in.Mesh.View());
  return (in.Samples.Input ||
           DrawSamplePoints(in.Bounds, this->NumberOfSamples, seed, monitor.Part(0.0, 0.02), points)) &&
    MeasureTruth(points, scene, lights, this->NumberOfLightSamples, seed, monitor.Part(0.02, 0.8), out.Truth) &&
    ClassifyByCones(
      lights.size(), points, out.Truth, in.Cones, monitor.Part(0.8, 0.85), out.Predictions, out.Tallies) &&
    (!this->CompareBounds ||
      MeasureOthers(
        in.Mesh, lights, points, out.Truth, this->NumberOfLightSamples, seed, monitor.Part(0.85, 0.95), out.Others)) &&
    IsProved(in.Mesh, lights, in.Cones, ReadCertifiedBounds(in.ConeSet->GetFieldData()),
      monitor.Part(this->CompareBounds ? 0.95 : 0.85, 1.0), out.Proved);
}

int vtkConeSetAccuracy::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  Inputs in;
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, in, error))
  {
    return run.Fail(error);
  }
  Outcome out;
  try
  {
    if (!this->Measure(in, out))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Measuring the accuracy failed: ", ReasonOf(exception)));
  }

  const AccuracyReport report = TallyAccuracy(out.Truth, out.Predictions, in.Cones, this->NumberOfDepthBins);
  const PieceRequest piece = RequestedPiece(request, outputVector);
  const auto count = static_cast<vtkIdType>(in.Samples.Points.size());
  vtkPolyData* sampleOutput = vtkPolyData::GetData(outputVector, 0);
  WriteSamples(in.Samples, out.Truth, out.Predictions, in.Cones, piece.Begin(count), piece.End(count), sampleOutput);
  WriteLightFingerprints(in.Lights.Lights, sampleOutput);
  const auto coneCount = static_cast<vtkIdType>(in.Cones.size());
  WriteConeTallies(in.Cones, in.ConeSet, out.Tallies, report.All, piece.Begin(coneCount), piece.End(coneCount),
    vtkPolyData::GetData(outputVector, 4));
  if (piece.Piece == 0)
  {
    WriteSummary(report.All, out.Truth, in.Samples.Classes, out.Proved, out.Others, vtkTable::GetData(outputVector, 1));
    WriteOccluders(report, vtkTable::GetData(outputVector, 2));
    WriteDepths(report, vtkTable::GetData(outputVector, 3));
    const auto inShadow = static_cast<vtkIdType>(report.All.TruePositives + report.All.FalseNegatives);
    in.Said.Add(NoPlaceInShadow("samples", count, inShadow, coneCount));
    in.Said.Add(NoPlaceLit("samples", count, count - static_cast<vtkIdType>(report.All.Umbra)));
    in.Said.Add(TooManyDiscarded(in.ConeSet->GetFieldData(), out.Proved));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkFieldData* field = vtkDataObject::GetData(outputVector, port)->GetFieldData();
    WriteOccluderNames(in.Mesh.OccluderNames, field);
    WriteFingerprints(castersFingerprint, { in.Fingerprint }, field);
  }
  in.Said.Say(this);
  return 1;
}

void vtkConeSetAccuracy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "Bounds: " << Listed(this->Bounds, 6) << "\n";
  os << indent << "NumberOfDepthBins: " << this->NumberOfDepthBins << "\n";
  os << indent << "CompareBounds: " << (this->CompareBounds ? "on" : "off") << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
