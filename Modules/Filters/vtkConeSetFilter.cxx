// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetFilter.h"

#include "scConeData.h"
#include "scConeIntervals.h"
#include "scConeProof.h"
#include "scConeTuning.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scLightData.h"
#include "scMeshBlocks.h"
#include "scMeshData.h"
#include "scSceneLights.h"
#include "scVectorData.h"
#include "scWarnings.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using namespace shadowcones;

/// The emission points of the vectors of one light; of all where the vectors do not tell.
std::vector<double> EmissionPointsOf(const ShadowVectorArrays& vectors, int light)
{
  if (vectors.LightIds.empty())
  {
    return vectors.EmissionPoints;
  }
  std::vector<double> points;
  for (std::size_t i = 0; i < vectors.LightIds.size() && !vectors.EmissionPoints.empty(); ++i)
  {
    if (vectors.LightIds[i] == light)
    {
      const auto first = vectors.EmissionPoints.begin() + static_cast<std::ptrdiff_t>(3 * i);
      points.insert(points.end(), first, first + 3);
    }
  }
  return points;
}

/// How many of these points cannot lie on the light; a Sun's may lie anywhere.
vtkIdType PointsOffLight(const std::vector<double>& points, const Light& light)
{
  constexpr double roundingOfFloats = 1e-5;
  Vector3 center;
  double radius = 0.0;
  LightBoundingSphere(light, center, radius);
  vtkIdType off = 0;
  for (std::size_t i = 0; i < points.size() && !IsAtInfinity(light); i += 3)
  {
    const Vector3 point{ points[i], points[i + 1], points[i + 2] };
    off += Length(point - center) > 1.001 * radius + roundingOfFloats * Length(point);
  }
  return off;
}

/// The extents of the lights that vectors come from: of exact shapes in the field data, else of the emission points.
bool ReadLightExtents(const ShadowVectorArrays& vectors, const std::vector<Light>& shapes,
  std::vector<LightExtent>& extents, std::string& warning, std::string& error)
{
  const auto last = std::max_element(vectors.LightIds.begin(), vectors.LightIds.end());
  const std::size_t named = last == vectors.LightIds.end() ? 1 : static_cast<std::size_t>(*last) + 1;
  if (!shapes.empty() && shapes.size() < named)
  {
    error = "The shadow-vector input has the \"LightId\" " + std::to_string(named - 1) +
      " and its field data tell of " + std::to_string(shapes.size()) + " lights.";
    return false;
  }
  extents.clear();
  for (std::size_t k = 0; k < std::max(named, shapes.size()); ++k)
  {
    const std::vector<double> points = EmissionPointsOf(vectors, static_cast<int>(k));
    const bool hasShape = k < shapes.size() && shapes[k].Shape != LightShape::Mesh;
    const vtkIdType off = hasShape ? PointsOffLight(points, shapes[k]) : 0;
    if (off > 0)
    {
      warning = std::to_string(off) + " of " + std::to_string(points.size() / 3) + " vectors of light " +
        std::to_string(k) + " left a point that is not on it, as the field data tell of it: its extent is taken from "
        "the points instead. Connect all lights to one vtkShadowVectorFilter instead of joining what several made.";
    }
    const bool believed = hasShape && off == 0;
    extents.push_back(believed ? LightExtentOf(shapes[k])
                               : LightExtentOf(points.data(), static_cast<vtkIdType>(points.size() / 3)));
  }
  return true;
}

/// What the filter reads.
struct Inputs
{
  ShadowVectorArrays Vectors;
  PhotonPathArrays Paths;
  std::vector<LightExtent> Extents;
  TriangleMesh Mesh;
  std::vector<Light> Lights; ///< to prove the set for
  Warnings Said;
};

/// Mesh and lights, where they are connected; else lights as the vectors tell of them.
bool ReadScene(vtkInformationVector** inputVector, const std::vector<Light>& shapes, Inputs& inputs, std::string& error)
{
  vtkDataObject* mesh = vtkDataObject::GetData(inputVector[2]);
  if (mesh && !ReadTriangles(mesh, inputs.Mesh, error))
  {
    return false;
  }
  if (inputVector[3]->GetNumberOfInformationObjects() > 0)
  {
    SceneLights lights;
    if (!ReadLights(inputVector[3], lights, error))
    {
      return false;
    }
    inputs.Lights = lights.Lights;
    for (const std::string& warning : lights.Warnings)
    {
      inputs.Said.Add(warning);
    }
  }
  // The faces of a mesh light do not travel with the vectors.
  else if (inputs.Said.GetSentences().empty() &&
    std::none_of(shapes.begin(), shapes.end(), [](const Light& light) { return light.Shape == LightShape::Mesh; }))
  {
    inputs.Lights = shapes;
  }
  return true;
}

/// Everything that is there.
bool ReadInputs(vtkInformationVector** inputVector, Inputs& inputs, std::string& error)
{
  vtkPolyData* vectors = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* paths = vtkPolyData::GetData(inputVector[1]);
  std::vector<Light> shapes;
  std::string warning;
  const auto isMesh = [](const Light& light) { return light.Shape == LightShape::Mesh; };
  if (!ReadLightShapes(vectors->GetFieldData(), shapes, error) ||
    !ReadShadowVectors(
      vectors, inputs.Vectors, error, shapes.empty() || std::any_of(shapes.begin(), shapes.end(), isMesh)) ||
    !CheckAttributes(vectors->GetPointData(), vectors->GetNumberOfPoints(), "point", error) ||
    (paths && !ReadPhotonPaths(paths, inputs.Paths, error)) ||
    (vectors->GetNumberOfPoints() > 0 && !ReadLightExtents(inputs.Vectors, shapes, inputs.Extents, warning, error)))
  {
    return false;
  }
  inputs.Said.Add(warning);
  if (inputs.Extents.size() > 1 && paths && paths->GetNumberOfPoints() > 0 && inputs.Paths.LightIds.empty())
  {
    error = "The photon paths have no \"LightId\" and the vectors are of " + std::to_string(inputs.Extents.size()) +
      " lights: connect output port 1 of the vtkShadowVectorFilter that made the vectors.";
    return false;
  }
  return ReadScene(inputVector, shapes, inputs, error);
}

/// Prove the cones, or with @p choose take cones around parts of the mesh where they are tighter. @return false where aborted.
bool Prove(const Inputs& inputs, bool choose, const Monitor& monitor, std::vector<Cone>& cones, ConeProof& proof,
  std::string& choice)
{
  const TriangleMeshView mesh = inputs.Mesh.View();
  ConeProofOptions options;
  // Receivers are the room; without any the casters' own bounds say where shadow matters.
  if (std::any_of(inputs.Mesh.OccluderIds.begin(), inputs.Mesh.OccluderIds.end(), [](int id) { return id < 0; }))
  {
    options.Region = MeshBounds(mesh);
  }
  if (!ProveConeSet(mesh, inputs.Lights, cones, options, monitor.Part(0.0, choose ? 0.5 : 1.0), proof))
  {
    return false;
  }
  if (choose)
  {
    ConeProof parts;
    if (!ProveConeSet(mesh, inputs.Lights, {}, options, monitor.Part(0.5, 1.0), parts))
    {
      return false;
    }
    const bool takeParts = IsTighter(parts, proof);
    std::ostringstream text;
    text << (takeParts ? " Cones around parts of the mesh were taken: " : " Fitted cones were taken: ")
         << parts.Cones.size() << " around parts hold " << parts.Volume << " cubic units, " << proof.Cones.size()
         << " fitted ones, once proved, hold " << proof.Volume << '.';
    choice += text.str();
    if (takeParts)
    {
      proof = parts;
    }
  }
  cones = proof.Cones;
  return true;
}

/// Vectors that no base took, and all where no cone was fitted, belong to the first cone of their light that holds them.
void AssignVectors(const ShadowVectorArrays& vectors, ConeSet& set)
{
  const bool all =
    std::none_of(set.Cones.begin(), set.Cones.end(), [](const Cone& cone) { return cone.Origin != ConeOrigin::Added; });
  set.NumberOfDiscarded = 0;
  for (std::size_t i = 0; i < set.ConeIds.size(); ++i)
  {
    vtkIdType& id = set.ConeIds[i];
    if (all || id < 0)
    {
      const Vector3 point{ vectors.Points[3 * i], vectors.Points[3 * i + 1], vectors.Points[3 * i + 2] };
      const auto found =
        std::find_if(set.Cones.begin(), set.Cones.end(), [&](const Cone& cone) {
          return (vectors.LightIds.empty() || cone.LightId == vectors.LightIds[i]) && ConeContains(cone, point);
        });
      id = found != set.Cones.end() ? static_cast<vtkIdType>(found - set.Cones.begin()) : -1;
      set.NumberOfDiscarded += id < 0 ? 1 : 0;
      if (id >= 0 && set.Cones[id].Origin == ConeOrigin::Added)
      {
        ++set.Cones[id].VectorCount;
      }
    }
  }
}

/// What tuning chose, as a sentence.
std::string ChoiceOf(const ConeTuningResult& tuning, const char* name)
{
  std::ostringstream text;
  const ConeSetOptions& o = tuning.Options;
  text << name << ": of " << tuning.NumberOfFits << " sets of parameters NumberOfNeighbors " << o.NumberOfNeighbors
       << ", PointsPerRing " << o.PointsPerRing << ", MinimumVectorsPerCone " << o.MinimumVectorsPerCone
       << ", VarianceThreshold " << o.VarianceThreshold << " did best on the photons held out: " << 100.0 * tuning.Leak
       << " % of the blocked light outside the cones.";
  return text.str();
}

std::vector<Cone> SliceOf(const std::vector<Cone>& cones, const PieceRequest& piece)
{
  const auto count = static_cast<vtkIdType>(cones.size());
  return { cones.begin() + piece.Begin(count), cones.begin() + piece.End(count) };
}

/// The vectors [begin, end) of the input with all their arrays, and the cone of each.
void WriteLabelledVectors(
  vtkPolyData* input, const std::vector<vtkIdType>& coneIds, const PieceRequest& piece, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(coneIds.size());
  const vtkIdType begin = piece.Begin(count);
  const vtkIdType end = piece.End(count);
  std::vector<double> points(static_cast<std::size_t>(3 * (end - begin)));
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(input->GetPointData(), end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    input->GetPoint(i, &points[3 * (i - begin)]);
    data->CopyData(input->GetPointData(), i, i - begin);
  }
  SetVertices(output, points);
  AddIdArray(data, "ConeId", { coneIds.begin() + begin, coneIds.begin() + end });
}
/// The parameters as they are set.
ConeSetOptions OptionsOf(vtkConeSetFilter* filter)
{
  ConeSetOptions options;
  options.NumberOfNeighbors = filter->GetNumberOfNeighbors();
  options.NumberOfSectors = filter->GetNumberOfSectors();
  options.PointsPerRing = filter->GetPointsPerRing();
  options.MinimumVectorsPerCone = filter->GetMinimumVectorsPerCone();
  options.VarianceThreshold = filter->GetVarianceThreshold();
  options.PlanarityThreshold = filter->GetPlanarityThreshold();
  options.CosineCorrection = filter->GetCosineCorrection();
  options.Expansion = static_cast<ConeExpansion>(filter->GetExpansion());
  options.ExpansionFraction = filter->GetExpansionFraction();
  options.RadiusScale = filter->GetRadiusScale();
  options.MaximumOverspill = filter->GetMaximumOverspill();
  options.Overlap = filter->GetOverlap();
  options.Leftovers = static_cast<ConeLeftovers>(filter->GetLeftovers());
  return options;
}

/// What the filter made.
struct Outcome
{
  ConeSetOptions Options;
  ConeTuningResult Tuning;
  ConeSet Set;
  ConeProof Proof;
  std::string Choice; ///< for people
  bool Tuned = false;

  void Describe(ConeTuning kind, bool tune, bool automatic)
  {
    static const char* const names[] = { "Manual", "Conservative", "Preview", "Soft" };
    const std::string name = std::string(automatic ? "Automatic, " : "") + names[static_cast<int>(kind)];
    if (tune && this->Tuning.Lacking.empty())
    {
      this->Choice = ChoiceOf(this->Tuning, name.c_str());
    }
    else if (tune || automatic)
    {
      this->Choice = (automatic ? "Automatic: bounds from the light's geometry, because " : "Bounds from the light's geometry, because ") +
        (tune ? this->Tuning.Lacking : std::string("no photon paths are connected")) + ".";
    }
  }

  void Write(const Inputs& inputs, int tuning, const PieceRequest& piece, vtkPolyData* vectors, vtkPolyData* coneOutput,
    vtkPolyData* vectorOutput) const
  {
    WriteConeSet(SliceOf(this->Set.Cones, piece), coneOutput);
    WriteLabelledVectors(vectors, this->Set.ConeIds, piece, vectorOutput);
    vtkFieldData* data = coneOutput->GetFieldData();
    data->PassData(vectors->GetFieldData());
    vectorOutput->GetFieldData()->PassData(vectors->GetFieldData());
    if (this->Proof.Certified)
    {
      WriteLightFingerprints(inputs.Lights, coneOutput);
    }
    AddIntArray(data, "Tuning", 1, { tuning });
    WriteConeSetOptions(this->Options, data);
    if (this->Tuned)
    {
      WriteConeTuning(this->Tuning, data);
    }
    vtkNew<vtkStringArray> choice;
    choice->SetName("TuningChoice");
    choice->InsertNextValue(this->Choice);
    data->AddArray(choice);
    const auto numberOfVectors = static_cast<vtkIdType>(this->Set.ConeIds.size());
    AddIdArray(data, "NumberOfVectors", { numberOfVectors });
    AddIdArray(data, "NumberOfCones", { static_cast<vtkIdType>(this->Set.Cones.size()) });
    AddIdArray(data, "NumberOfDiscarded", { this->Set.NumberOfDiscarded });
    AddDoubleArray(data, "DiscardedFraction", 1,
      { numberOfVectors > 0 ? static_cast<double>(this->Set.NumberOfDiscarded) / static_cast<double>(numberOfVectors)
                            : 0.0 });
    ConeCertificate certificate;
    certificate.Certified = this->Proof.Certified;
    certificate.Bounds = this->Proof.CertifiedBounds;
    certificate.NumberOfProvedParts = this->Proof.NumberOfProvedParts;
    certificate.NumberOfGrownCones = this->Proof.NumberOfGrownCones;
    certificate.NumberOfAddedCones = this->Proof.NumberOfAddedCones;
    certificate.NumberOfOccludersWithoutCone = this->Proof.NumberOfOccludersWithoutCone;
    certificate.Hash =
      certificate.Certified ? CertificateHash(this->Set.Cones, inputs.Mesh.View(), inputs.Lights) : 0;
    WriteConeCertificate(certificate, data);
  }
};
} // anonymous namespace

vtkStandardNewMacro(vtkConeSetFilter);

vtkConeSetFilter::vtkConeSetFilter()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

void vtkConeSetFilter::SetPhotonPathConnection(vtkAlgorithmOutput* paths)
{
  this->SetInputConnection(1, paths);
}

void vtkConeSetFilter::SetPhotonPathData(vtkDataObject* paths)
{
  this->SetInputData(1, paths);
}

void vtkConeSetFilter::SetMeshConnection(vtkAlgorithmOutput* mesh)
{
  this->SetInputConnection(2, mesh);
}

void vtkConeSetFilter::SetMeshData(vtkDataObject* mesh)
{
  this->SetInputData(2, mesh);
}

void vtkConeSetFilter::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(3, light);
}

void vtkConeSetFilter::SetLightData(vtkDataObject* light)
{
  this->SetInputData(3, light);
}

void vtkConeSetFilter::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(3, light);
}

void vtkConeSetFilter::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(3, light);
}

void vtkConeSetFilter::RemoveAllLights()
{
  this->RemoveAllInputConnections(3);
}

void vtkConeSetFilter::SetToPaper()
{
  this->SetTuningToManual();
  this->SetNumberOfNeighbors(100);
  this->SetNumberOfSectors(20);
  this->SetPointsPerRing(16);
  this->SetMinimumVectorsPerCone(20);
  this->SetVarianceThreshold(1.6);
  this->SetPlanarityThreshold(0.0);
  this->CosineCorrectionOn();
  this->SetExpansionToMaximumDeviation();
  this->SetExpansionFraction(1.0);
  this->SetRadiusScale(1.0);
  this->SetMaximumOverspill(1.0);
  this->OverlapOff();
  this->SetLeftoversToDiscard();
  this->CertifyOff();
}

int vtkConeSetFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 3)
  {
    FillLightPortInformation(info);
  }
  else if (port == 2)
  {
    AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  return 1;
}

int vtkConeSetFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkConeSetFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  RequestWholeInputs(this, inputVector);
  return 1;
}

std::string vtkConeSetFilter::ParametersNotUsed() const
{
  const ConeSetOptions standard;
  std::string names;
  const auto add = [&names](bool differs, const char* name) {
    names += differs ? std::string(names.empty() ? "" : ", ") + name : "";
  };
  add(this->NumberOfNeighbors != standard.NumberOfNeighbors, "NumberOfNeighbors");
  add(this->PointsPerRing != standard.PointsPerRing, "PointsPerRing");
  add(this->MinimumVectorsPerCone != standard.MinimumVectorsPerCone, "MinimumVectorsPerCone");
  add(this->VarianceThreshold != standard.VarianceThreshold, "VarianceThreshold");
  add(this->CosineCorrection != standard.CosineCorrection, "CosineCorrection");
  add(this->Expansion != static_cast<int>(standard.Expansion), "Expansion");
  add(this->ExpansionFraction != standard.ExpansionFraction, "ExpansionFraction");
  add(this->RadiusScale != standard.RadiusScale, "RadiusScale");
  add(this->MaximumOverspill != standard.MaximumOverspill, "MaximumOverspill");
  add(this->Overlap != standard.Overlap, "Overlap");
  return this->Tuning == MANUAL ? "" : names;
}

bool vtkConeSetFilter::CheckRequest(bool hasPaths)
{
  if (this->Tuning < MANUAL || this->Tuning > AUTOMATIC)
  {
    vtkErrorMacro("Tuning is " << this->Tuning
                               << "; it must be 0 (Manual), 1 (Conservative), 2 (Preview), 3 (Soft) or 4 (Automatic).");
  }
  else if (this->Tuning != MANUAL && this->Tuning != AUTOMATIC && !hasPaths)
  {
    vtkErrorMacro("Tuning learns from photon paths and input port 1 has none: connect output port 1 of "
                  "vtkShadowVectorFilter with SetPhotonPathConnection, or use SetTuningToAutomatic or SetTuningToManual.");
  }
  else if (this->MaximumOverspill < 1.0 && !hasPaths)
  {
    vtkErrorMacro("MaximumOverspill is " << this->MaximumOverspill
      << " and input port 1 has no photon paths to see lit light by: connect output port 1 of vtkShadowVectorFilter with "
         "SetPhotonPathConnection, or set MaximumOverspill to 1.");
  }
  else if (const char* fault = CheckConeSetOptions(OptionsOf(this)))
  {
    vtkErrorMacro(<< fault << ".");
  }
  else
  {
    const std::string unused = this->ParametersNotUsed();
    if (!unused.empty())
    {
      vtkWarningMacro("Tuning chooses these parameters, and what they were set to is not used: "
        << unused << ". Use SetTuningToManual to fit with them.");
    }
    return true;
  }
  return false;
}

int vtkConeSetFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  vtkPolyData* vectorInput = vtkPolyData::GetData(inputVector[0]);
  const bool hasPaths = vtkPolyData::GetData(inputVector[1]) != nullptr;
  const bool hasMesh = vtkDataObject::GetData(inputVector[2]) != nullptr;
  Inputs inputs;
  if (!this->CheckRequest(hasPaths))
  {
    return 0;
  }
  if (!ReadInputs(inputVector, inputs, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  const bool empty = vectorInput->GetNumberOfPoints() == 0 && !hasMesh;
  const bool automatic = this->Tuning == AUTOMATIC;
  const bool provable = this->Tuning == MANUAL || this->Tuning == CONSERVATIVE || automatic;
  const bool prove = this->Certify && hasMesh && provable && !inputs.Lights.empty();
  const bool tune = this->Tuning != MANUAL && !inputs.Vectors.Points.empty() && !inputs.Paths.Points.empty();
  if (this->Certify && hasMesh && provable && !empty && inputs.Lights.empty())
  {
    inputs.Said.Add("The cone set is not proved: the shadow vectors do not carry the exact shape of the light. Connect the light "
                    "with SetLightConnection, or set Certify off.");
  }
  Outcome outcome;
  const Monitor monitor = MonitorOf(this);
  const double fitted = prove ? 0.7 : 1.0;
  try
  {
    const auto kind = automatic ? ConeTuning::Conservative : static_cast<ConeTuning>(this->Tuning);
    const ConeSetOptions options = automatic ? BoundsOptions(OptionsOf(this)) : OptionsOf(this);
    if (tune &&
      !TuneConeSet(inputs.Vectors.View(), inputs.Paths.View(), inputs.Extents, kind, options, monitor.Part(0.0, 0.8 * fitted),
        outcome.Tuning))
    {
      return 1; // aborted: the outputs stay empty
    }
    outcome.Options = tune ? outcome.Tuning.Options : options;
    if (!FitConeSet(inputs.Vectors.View(), inputs.Paths.View(), inputs.Extents, outcome.Options,
          monitor.Part(tune ? 0.8 * fitted : 0.0, fitted), outcome.Set))
    {
      return 1; // aborted: the outputs stay empty
    }
    outcome.Describe(kind, tune, automatic);
    if (prove && !Prove(inputs, automatic, monitor.Part(fitted, 1.0), outcome.Set.Cones, outcome.Proof, outcome.Choice))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Fitting cones failed: " << exception.what());
    return 0;
  }
  if (tune && !outcome.Tuning.Lacking.empty())
  {
    inputs.Said.Add("Tuning found too little to learn from: " + outcome.Tuning.Lacking +
      ". Cones are bounds from the light's geometry instead; more photons, or a mesh and a light to prove them with, make "
      "them better.");
  }
  if (prove)
  {
    AssignVectors(inputs.Vectors, outcome.Set);
  }
  outcome.Tuned = tune && outcome.Tuning.Lacking.empty();
  const PieceRequest piece = RequestedPiece(request, outputVector);
  outcome.Write(inputs, this->Tuning, piece, vectorInput, vtkPolyData::GetData(outputVector, 0),
    vtkPolyData::GetData(outputVector, 1));
  if (piece.Piece == 0) // every piece fits the whole set
  {
    const auto numberOfVectors = static_cast<vtkIdType>(outcome.Set.ConeIds.size());
    inputs.Said.Add(NoCones(static_cast<vtkIdType>(outcome.Set.Cones.size()), numberOfVectors));
    inputs.Said.Add(OccludersWithoutCone(inputs.Vectors.OccluderIds, outcome.Set.ConeIds));
    const bool bounds = outcome.Tuned && !prove && (automatic || this->Tuning == CONSERVATIVE);
    inputs.Said.Add(bounds ? ConesLeak(outcome.Tuning.Leak) : std::string());
    inputs.Said.Say(this);
  }
  return 1;
}

void vtkConeSetFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const expansions[] = { "MaximumDeviation", "RadiusRatio", "LightGeometry" };
  static const char* const tunings[] = { "Manual", "Conservative", "Preview", "Soft", "Automatic" };
  os << indent << "Tuning: " << (this->Tuning >= 0 && this->Tuning <= 4 ? tunings[this->Tuning] : "invalid") << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "NumberOfSectors: " << this->NumberOfSectors << "\n";
  os << indent << "PointsPerRing: " << this->PointsPerRing << "\n";
  os << indent << "MinimumVectorsPerCone: " << this->MinimumVectorsPerCone << "\n";
  os << indent << "VarianceThreshold: " << this->VarianceThreshold << "\n";
  os << indent << "PlanarityThreshold: " << this->PlanarityThreshold << "\n";
  os << indent << "CosineCorrection: " << (this->CosineCorrection ? "on" : "off") << "\n";
  os << indent << "Expansion: "
     << (this->Expansion >= 0 && this->Expansion <= 2 ? expansions[this->Expansion] : "invalid") << "\n";
  os << indent << "ExpansionFraction: " << this->ExpansionFraction << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "MaximumOverspill: " << this->MaximumOverspill << "\n";
  os << indent << "Overlap: " << (this->Overlap ? "on" : "off") << "\n";
  os << indent << "Leftovers: " << (this->Leftovers == DISCARD ? "Discard" : this->Leftovers == COVER ? "Cover" : "invalid")
     << "\n";
  os << indent << "Certify: " << (this->Certify ? "on" : "off") << "\n";
}
