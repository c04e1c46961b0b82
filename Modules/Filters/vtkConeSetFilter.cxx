// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConeSetFilter.h"

#include "scConeData.h"
#include "scConeSetInputs.h"
#include "scConeTuning.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scParameterRanges.h"
#include "scProvedSet.h"
#include "scSceneLights.h"
#include "scSentence.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <exception>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using namespace shadowcones;

constexpr int pathPort = 1;
constexpr int meshPort = 2;
constexpr int lightPort = 3;

/// What tuning chose and why, as a sentence.
std::string ChoiceOf(const ConeTuningResult& tuning, ConeTuning kind, const std::string& name)
{
  std::ostringstream text;
  const ConeSetOptions& o = tuning.Options;
  const double held = 1.0 - tuning.Leak;
  text << name << ": of " << tuning.NumberOfFits << " sets of parameters NumberOfNeighbors " << o.NumberOfNeighbors
       << ", PointsPerRing " << o.PointsPerRing << ", MinimumVectorsPerCone " << o.MinimumVectorsPerCone
       << ", VarianceThreshold " << o.VarianceThreshold << " did best on the photons held out: ";
  if (kind == ConeTuning::Tight)
  {
    text << 100.0 * held / (held + tuning.Lost) << " % of the light inside the cones is blocked, and the "
         << 100.0 * tuning.Leak << " % of the blocked light outside them is left to the proof.";
  }
  else
  {
    text << 100.0 * tuning.Leak << " % of the blocked light outside the cones.";
  }
  return text.str();
}

/// Where the parameters of the cones came from, as a sentence; empty where they were set.
std::string ChoiceOf(const ConeTuningResult& tuning, ConeTuning kind, bool tune, bool automatic)
{
  static const char* const names[] = { "Manual", "Conservative", "Preview", "Soft", "Conservative" };
  if (tune && tuning.Lacking.empty())
  {
    return ChoiceOf(tuning, kind, std::string(automatic ? "Automatic, " : "") + names[static_cast<int>(kind)]);
  }
  return tune || automatic
    ? Sentence(automatic ? "Automatic: bounds" : "Bounds", " from the light's geometry, because ",
        tune ? tuning.Lacking : "no photon paths are connected", ".")
    : std::string();
}

std::string ChoiceOf(const ProofChoice& choice)
{
  return Sentence(
    choice.TakesParts ? " Cones around parts of the mesh were taken, which are tighter: " : " Fitted cones were taken: ",
    choice.NumberOfPartCones, " around parts hold ", choice.PartVolume, " cubic units, ", choice.NumberOfFittedCones,
    choice.FittedProved ? " fitted ones, once proved, hold " : " fitted ones, even before a proof, hold ",
    choice.FittedVolume, ".");
}

std::vector<Cone> SliceOf(const std::vector<Cone>& cones, const PieceRequest& piece)
{
  const auto count = static_cast<vtkIdType>(cones.size());
  return { cones.begin() + piece.Begin(count), cones.begin() + piece.End(count) };
}
} // anonymous namespace

/// What the filter made.
struct vtkConeSetFilter::Outcome
{
  ConeSetOptions Options;
  ConeTuningResult Tuning;
  ConeSet Set;
  ConeProof Proof;
  std::string Choice; ///< for people
  bool Tuned = false; ///< its parameters were learned from photons

  double DiscardedFraction() const
  {
    const auto vectors = static_cast<double>(this->Set.ConeIds.size());
    return vectors > 0.0 ? static_cast<double>(this->Set.NumberOfDiscarded) / vectors : 0.0;
  }
};

vtkStandardNewMacro(vtkConeSetFilter);
scDefineGuardedRequests(vtkConeSetFilter);

vtkConeSetFilter::vtkConeSetFilter()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(2);
}

scDefineInputPort(vtkConeSetFilter, PhotonPath, pathPort);
scDefineInputPort(vtkConeSetFilter, Mesh, meshPort);
scDefineLightPort(vtkConeSetFilter, lightPort);

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
  FillScenePortInformation(port, meshPort, lightPort, "vtkPolyData", info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
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
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkConeSetFilter::ParametersNotUsed() const
{
  const ConeSetOptions standard;
  std::string names;
  const auto add = [&names](bool differs, const char* name)
  { names += differs ? std::string(names.empty() ? "" : ", ") + name : ""; };
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
  return this->Tuning == Manual ? "" : names;
}

ConeSetOptions vtkConeSetFilter::Options() const
{
  ConeSetOptions options;
  options.NumberOfNeighbors = this->NumberOfNeighbors;
  options.NumberOfSectors = this->NumberOfSectors;
  options.PointsPerRing = this->PointsPerRing;
  options.MinimumVectorsPerCone = this->MinimumVectorsPerCone;
  options.VarianceThreshold = this->VarianceThreshold;
  options.PlanarityThreshold = this->PlanarityThreshold;
  options.CosineCorrection = this->CosineCorrection;
  options.Expansion = static_cast<ConeExpansion>(this->Expansion);
  options.ExpansionFraction = this->ExpansionFraction;
  options.RadiusScale = this->RadiusScale;
  options.MaximumOverspill = this->MaximumOverspill;
  options.Overlap = this->Overlap;
  options.Leftovers = static_cast<ConeLeftovers>(this->Leftovers);
  return options;
}

std::string vtkConeSetFilter::CheckRequest(bool hasPaths) const
{
  std::string fault =
    FirstOutOfRange({ OneOf("Tuning", this->Tuning, { "Manual", "Conservative", "Preview", "Soft", "Automatic" }) });
  if (!fault.empty())
  {
    return fault;
  }
  if (this->Tuning != Manual && this->Tuning != Automatic && !hasPaths)
  {
    return "Tuning learns from photon paths and input port 1 has none: connect output port 1 of vtkShadowVectorFilter "
           "with "
           "SetPhotonPathConnection, or use SetTuningToAutomatic or SetTuningToManual.";
  }
  if (this->MaximumOverspill < 1.0 && !hasPaths)
  {
    return Sentence("MaximumOverspill is ", this->MaximumOverspill,
      " and input port 1 has no photon paths to see lit light by: connect output port 1 of vtkShadowVectorFilter with "
      "SetPhotonPathConnection, or set MaximumOverspill to 1.");
  }
  const char* const option = CheckConeSetOptions(this->Options());
  return option ? Sentence(option, ".") : std::string();
}

void vtkConeSetFilter::WriteCones(const Outcome& outcome, const ConeSetInputs& inputs, const PieceRequest& piece,
  vtkFieldData* inputData, vtkPolyData* output) const
{
  WriteConeSet(SliceOf(outcome.Set.Cones, piece), output);
  vtkFieldData* data = output->GetFieldData();
  data->PassData(inputData);
  if (outcome.Proof.Certified)
  {
    WriteLightFingerprints(inputs.Lights, output);
  }
  AddIntArray(data, "Tuning", 1, { this->Tuning });
  WriteConeSetOptions(outcome.Options, data);
  if (outcome.Tuned)
  {
    WriteConeTuning(outcome.Tuning, data);
  }
  vtkNew<vtkStringArray> choice;
  choice->SetName("TuningChoice");
  choice->InsertNextValue(outcome.Choice);
  data->AddArray(choice);
  AddIdArray(data, "NumberOfVectors", { static_cast<vtkIdType>(outcome.Set.ConeIds.size()) });
  AddIdArray(data, "NumberOfCones", { static_cast<vtkIdType>(outcome.Set.Cones.size()) });
  AddIdArray(data, "NumberOfDiscarded", { outcome.Set.NumberOfDiscarded });
  AddDoubleArray(data, "DiscardedFraction", 1, { outcome.DiscardedFraction() });
  WriteConeCertificate(CertificateOf(outcome.Proof, outcome.Set.Cones, inputs.Mesh.View(), inputs.Lights), data);
}

bool vtkConeSetFilter::Fit(const ConeSetInputs& inputs, bool prove, Team* team, Outcome& outcome)
{
  const bool automatic = this->Tuning == Automatic;
  const bool tune = this->Tuning != Manual && !inputs.Vectors.Points.empty() && !inputs.Paths.Points.empty();
  const bool bounds = automatic || this->Tuning == Conservative;
  const auto kind = !bounds ? static_cast<ConeTuning>(this->Tuning)
    : prove                 ? ConeTuning::Tight
                            : ConeTuning::Conservative;
  const Monitor monitor = MonitorOf(this);
  const double fitted = prove ? 0.7 : 1.0;
  const double tuned = tune ? 0.8 * fitted : 0.0;
  outcome.Options = automatic ? BoundsOptions(this->Options()) : this->Options();
  if (tune)
  {
    if (!TuneConeSet(inputs.Vectors.View(), inputs.Paths.View(), inputs.Extents, kind, outcome.Options,
          monitor.Part(0.0, tuned), outcome.Tuning, team))
    {
      return false;
    }
    outcome.Options = outcome.Tuning.Options;
    outcome.Tuned = outcome.Tuning.Lacking.empty();
  }
  if (!FitConeSet(inputs.Vectors.View(), inputs.Paths.View(), inputs.Extents, outcome.Options,
        monitor.Part(tuned, fitted), outcome.Set, team))
  {
    return false;
  }
  outcome.Choice = ChoiceOf(outcome.Tuning, kind, tune, automatic);
  ProofChoice choice;
  if (prove &&
    !ProveFittedSet(inputs.Mesh.View(), inputs.Lights, inputs.Vectors.View(), automatic, monitor.Part(fitted, 1.0),
      outcome.Set, outcome.Proof, choice))
  {
    return false;
  }
  outcome.Choice += prove && automatic ? ChoiceOf(choice) : std::string();
  return true;
}

int vtkConeSetFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    return run.Fail(error);
  }
  vtkPolyData* vectorInput = vtkPolyData::GetData(inputVector[0]);
  const bool hasPaths = vtkPolyData::GetData(inputVector[pathPort]) != nullptr;
  const bool hasMesh = vtkDataObject::GetData(inputVector[meshPort]) != nullptr;
  error = this->CheckRequest(hasPaths);
  ConeSetInputs inputs;
  if (!error.empty() || !ReadConeSetInputs(inputVector, inputs, error))
  {
    return run.Fail(error);
  }
  const bool areBounds = this->Tuning == Automatic || this->Tuning == Conservative;
  const bool certify = this->Certify && hasMesh && (areBounds || this->Tuning == Manual);
  const bool prove = certify && !inputs.Lights.empty();
  Outcome outcome;
  try
  {
    if (!this->Fit(inputs, prove, run.GetTeam(), outcome))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Fitting cones failed: ", ReasonOf(exception)));
  }

  const PieceRequest piece = RequestedPiece(request, outputVector);
  this->WriteCones(outcome, inputs, piece, vectorInput->GetFieldData(), vtkPolyData::GetData(outputVector, 0));
  vtkPolyData* vectorOutput = vtkPolyData::GetData(outputVector, 1);
  WriteLabelledVectors(vectorInput, outcome.Set.ConeIds, piece, vectorOutput);
  vectorOutput->GetFieldData()->PassData(vectorInput->GetFieldData());
  if (piece.Piece == 0) // every piece fits the whole set
  {
    const auto vectors = static_cast<vtkIdType>(outcome.Set.ConeIds.size());
    const bool unproved = certify && !prove;
    inputs.Said.Add(UnusedParameters(this->ParametersNotUsed()));
    inputs.Said.Add(unproved ? NotProved() : std::string());
    inputs.Said.Add(NothingToLearnFrom(outcome.Tuning.Lacking));
    inputs.Said.Add(NoCones(static_cast<vtkIdType>(outcome.Set.Cones.size()), vectors));
    inputs.Said.Add(OccludersWithoutCone(inputs.Vectors.OccluderIds, outcome.Set.ConeIds));
    inputs.Said.Add(outcome.Tuned && areBounds && !prove ? ConesLeak(outcome.Tuning.Leak) : std::string());
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
  os << indent
     << "Expansion: " << (this->Expansion >= 0 && this->Expansion <= 2 ? expansions[this->Expansion] : "invalid")
     << "\n";
  os << indent << "ExpansionFraction: " << this->ExpansionFraction << "\n";
  os << indent << "RadiusScale: " << this->RadiusScale << "\n";
  os << indent << "MaximumOverspill: " << this->MaximumOverspill << "\n";
  os << indent << "Overlap: " << (this->Overlap ? "on" : "off") << "\n";
  os << indent << "Leftovers: "
     << (this->Leftovers == Discard    ? "Discard"
            : this->Leftovers == Cover ? "Cover"
                                       : "invalid")
     << "\n";
  os << indent << "Certify: " << (this->Certify ? "on" : "off") << "\n";
}
