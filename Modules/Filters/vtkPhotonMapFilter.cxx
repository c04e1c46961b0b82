// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPhotonMapFilter.h"

#include "scDensityData.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scGuardedRequest.h"
#include "scInputPorts.h"
#include "scLightData.h"
#include "scMediumData.h"
#include "scOccluderNames.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scPhotonData.h"
#include "scPhotonMap.h"
#include "scPreparedInputs.h"
#include "scPreparedScene.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "scSpectrumSamples.h"
#include "scWarnings.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

using namespace shadowcones;

namespace shadowcones
{
/// What photons fly in, as it was read.
struct PhotonInputs
{
  std::shared_ptr<const PreparedMesh> Mesh;
  std::shared_ptr<const PreparedDensity> Density;
  SceneLights Lights;
  shadowcones::Medium Medium;
  PhotonMapOptions Options;
};
} // namespace shadowcones

namespace
{
constexpr int meshPort = 0;
constexpr int lightPort = 1;
constexpr int densityPort = 2;

/// What is to be said of a whole run.
Warnings ReportPhotons(const PhotonMapOptions& options, const PhotonMap& map)
{
  Warnings warnings;
  double share = 0.0;
  for (std::size_t k = 0; k < map.Account.Emitted.size(); ++k)
  {
    share = std::max(share, map.Account.Emitted[k] > 0.0 ? map.Account.CutOff[k] / map.Account.Emitted[k] : 0.0);
  }
  // Without a bounce the rest is left out on purpose.
  warnings.Add(options.MaximumBounces > 0 ? LightCutOff(share, options.MaximumBounces) : std::string());
  const bool isEmpty = map.Surface.Count() == 0 && map.Volume.Count() == 0;
  const bool wantsAny = options.NumberOfPhotons > 0 && (options.MaximumBounces > 0 || options.StoreDirect);
  warnings.Add(isEmpty && wantsAny ? NoPhotonStored(options.NumberOfPhotons) : std::string());
  return warnings;
}
} // namespace

vtkStandardNewMacro(vtkPhotonMapFilter);
scDefineGuardedRequests(vtkPhotonMapFilter);

vtkPhotonMapFilter::vtkPhotonMapFilter()
  : Prepared(std::make_unique<PreparedUser>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

vtkPhotonMapFilter::~vtkPhotonMapFilter() = default;

scDefinePreparedScene(vtkPhotonMapFilter);
scDefineLightPort(vtkPhotonMapFilter, lightPort);
scDefineInputPort(vtkPhotonMapFilter, Density, densityPort);
scDefineSpectrum(vtkPhotonMapFilter, SigmaS);
scDefineSpectrum(vtkPhotonMapFilter, SigmaA);
scDefinePhasePresets(vtkPhotonMapFilter);

int vtkPhotonMapFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  FillScenePortInformation(port, meshPort, lightPort, "vtkImageData", info);
  return 1;
}

int vtkPhotonMapFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  HandlePieces(outputVector);
  return 1;
}

int vtkPhotonMapFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

std::string vtkPhotonMapFilter::CheckParameters() const
{
  const std::string fault = FirstOutOfRange({
    { "NumberOfPhotons", static_cast<double>(this->NumberOfPhotons), this->NumberOfPhotons >= 0, "0 or above" },
    { "MaximumBounces", this->MaximumBounces * 1.0, this->MaximumBounces >= 0, "0 or above" },
    { "MaximumStoredPhotons", static_cast<double>(this->MaximumStoredPhotons), this->MaximumStoredPhotons >= 1,
      "at least 1" },
    { "Reflectance", this->Reflectance, this->Reflectance >= 0.0 && this->Reflectance <= 1.0, "in 0..1" },
  });
  return fault.empty() ? CheckPhase(this->PhaseFunction, this->PhaseLobes, this->PhaseAsymmetry) : fault;
}

bool vtkPhotonMapFilter::ReadMedium(PhotonInputs& read, std::string& error) const
{
  shadowcones::Medium& medium = read.Medium;
  medium.Density = read.Density ? &read.Density->Density : nullptr;
  const ParticleSettings particles{ this->SigmaSSpectrum, this->SigmaS, this->SigmaASpectrum, this->SigmaA,
    this->PhaseFunction, this->PhaseLobes, this->PhaseAsymmetry };
  if (!ReadParticles(particles, read.Lights.Wavelengths.size(), medium, error))
  {
    return false;
  }
  if (!AreUnsetBounds(this->MediumBounds))
  {
    return ReadBounds("MediumBounds", this->MediumBounds, medium.Bounds, error);
  }
  if (!BoundsAround(read.Mesh->Bounds, read.Lights.Bounds, medium.Bounds))
  {
    error = "MediumBounds are not set, and mesh and light have no bounds to take them from.";
  }
  return error.empty();
}

bool vtkPhotonMapFilter::ReadInputs(vtkInformationVector** inputs, PhotonInputs& read, std::string& error)
{
  if (inputs[lightPort]->GetNumberOfInformationObjects() == 0)
  {
    error = "No light on input port 1: connect a vtkAreaLightSource or a polygon mesh with SetLightConnection.";
    return false;
  }
  vtkImageData* density = vtkImageData::GetData(inputs[densityPort]);
  vtkDataArray* values = nullptr;
  if (!ReadLights(inputs[lightPort], read.Lights, error) ||
    !(read.Mesh = PrepareMesh(*this->Prepared, vtkDataObject::GetData(inputs[meshPort]), error)) ||
    !ChooseDensity(this, densityPort, density, values, error) ||
    (density && !(read.Density = PrepareDensity(*this->Prepared, density, values, error))))
  {
    return false;
  }
  const std::shared_ptr<const PreparedReflectance> reflectance =
    PrepareReflectance(*this->Prepared, *read.Mesh, read.Lights.Wavelengths.size(), this->Reflectance, error);
  error = reflectance ? this->CheckParameters() : error;
  if (!error.empty() || !this->ReadMedium(read, error))
  {
    return false;
  }
  PhotonMapOptions& options = read.Options;
  options.NumberOfPhotons = this->NumberOfPhotons;
  options.MaximumBounces = this->MaximumBounces;
  options.MaximumStored = this->MaximumStoredPhotons;
  options.StoreDirect = this->StoreDirect;
  options.Reflectance = this->Reflectance;
  options.SurfaceReflectance = reflectance->Reflectance.Values;
  options.ReflectanceComponents = std::max(reflectance->Reflectance.Components, 1);
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  return true;
}

int vtkPhotonMapFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  const PreparedRun keeping(*this->Prepared);
  std::string error;
  PhotonInputs read;
  if (!run.AreInputsWhole(error) || !this->ReadInputs(inputVector, read, error))
  {
    return run.Fail(error);
  }
  const PieceRequest piece = RequestedPiece(request, outputVector);
  read.Options.Piece = piece.Piece;
  read.Options.NumberOfPieces = piece.NumberOfPieces;
  PhotonMap map;
  try
  {
    const std::shared_ptr<const PreparedOccluders> occluders = PrepareOccluders(*this->Prepared, read.Mesh);
    if (!TracePhotonMap({ occluders->Scene, read.Lights.Lights, read.Medium }, read.Options, MonitorOf(this), map))
    {
      return 1; // aborted: the outputs stay empty
    }
  }
  catch (const std::length_error& exception)
  {
    return run.Fail(Sentence("Tracing photons failed: ", ReasonOf(exception),
      ". Lower NumberOfPhotons or MaximumBounces, or raise MaximumStoredPhotons where there is memory."));
  }
  catch (const std::exception& exception)
  {
    return run.Fail(Sentence("Tracing photons failed: ", ReasonOf(exception)));
  }

  WritePhotons(map.Surface, PhotonMapKind::Surface, vtkPolyData::GetData(outputVector, 0));
  WritePhotons(map.Volume, PhotonMapKind::Volume, vtkPolyData::GetData(outputVector, 1));
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* output = vtkPolyData::GetData(outputVector, port);
    WritePhotonAccount(map.Account, output->GetFieldData());
    this->WriteField(read, output);
  }
  Warnings warnings = piece.NumberOfPieces == 1 ? ReportPhotons(read.Options, map) : Warnings();
  warnings.Add(read.Lights.Warnings);
  warnings.Say(this);
  return 1;
}

void vtkPhotonMapFilter::WriteField(const PhotonInputs& read, vtkPolyData* output) const
{
  vtkFieldData* field = output->GetFieldData();
  AddIdArray(field, "NumberOfPhotons", { this->NumberOfPhotons });
  AddIntArray(field, "Seed", 1, { this->Seed });
  AddIntArray(field, "MaximumBounces", 1, { this->MaximumBounces });
  WriteMedium(read.Medium, field);
  WritePhase(read.Medium, field);
  WriteOccluderNames(read.Mesh->Mesh.OccluderNames, field);
  WriteFingerprints(castersFingerprint, { read.Mesh->CastersFingerprint }, field);
  WriteLights(read.Lights.Lights, output);
}

void vtkPhotonMapFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPhotons: " << this->NumberOfPhotons << "\n";
  os << indent << "MaximumBounces: " << this->MaximumBounces << "\n";
  os << indent << "MaximumStoredPhotons: " << this->MaximumStoredPhotons << "\n";
  os << indent << "StoreDirect: " << (this->StoreDirect ? "On" : "Off") << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "MediumBounds: " << Listed(this->MediumBounds, 6) << "\n";
  os << indent << "SigmaS: " << this->SigmaS << "\n";
  os << indent << "SigmaA: " << this->SigmaA << "\n";
  os << indent << "SigmaSSpectrum: " << TextOf(this->SigmaSSpectrum) << "\n";
  os << indent << "SigmaASpectrum: " << TextOf(this->SigmaASpectrum) << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "PhaseAsymmetry: " << this->PhaseAsymmetry << "\n";
  os << indent << "PhaseLobes: " << Listed(this->PhaseLobes, 3) << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfPreparations: " << this->GetNumberOfPreparations() << "\n";
  os << indent << "PreparedScene: " << this->GetPreparedScene() << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << "\n";
}
