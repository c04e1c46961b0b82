// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScatteringImageFilter.h"

#include "scCoarseImage.h"
#include "scDensityData.h"
#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scImageOutput.h"
#include "scImageReport.h"
#include "scImageScene.h"
#include "scRayCheck.h"
#include "scInputPorts.h"
#include "scKeptImage.h"
#include "scMediumData.h"
#include "scParameterRanges.h"
#include "scPreparedScene.h"
#include "scRanks.h"
#include "scSentence.h"
#include "scToneMap.h"
#include "scWarnings.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <vector>

using namespace shadowcones;

namespace
{
constexpr int meshPort = 0;
constexpr int lightPort = 1;
constexpr int coneSetPort = 2;
constexpr int visibilityVolumePort = 3;
constexpr int densityPort = 4;
constexpr int photonMapPort = 5;
constexpr double shareOfPhotons = 0.1; // of the progress, where photon maps are prepared
constexpr double shareOfCoarse = 0.1;  // of the rest, where coarse pictures come first

ToneMapping MappingBy(const std::vector<double>& wavelengths, double exposure, int curve)
{
  return { wavelengths, exposure, static_cast<ToneCurve>(curve) };
}
} // namespace

vtkStandardNewMacro(vtkScatteringImageFilter);
scDefineGuardedRequests(vtkScatteringImageFilter);

vtkScatteringImageFilter::vtkScatteringImageFilter()
  : Kept(std::make_unique<KeptImage>())
  , Prepared(std::make_unique<PreparedUser>())
{
  this->SetNumberOfInputPorts(6);
  this->GetInformation()->Remove(INPUT_ARRAYS_TO_PROCESS()); // the superclass chooses scalars of the mesh
}

vtkScatteringImageFilter::~vtkScatteringImageFilter() = default;

vtkCxxSetSmartPointerMacro(vtkScatteringImageFilter, Camera, vtkCamera);

vtkCamera* vtkScatteringImageFilter::GetCamera()
{
  return this->Camera;
}

scDefineLightPort(vtkScatteringImageFilter, lightPort);
scDefineInputPort(vtkScatteringImageFilter, ConeSet, coneSetPort);
scDefineInputPort(vtkScatteringImageFilter, VisibilityVolume, visibilityVolumePort);
scDefineInputPort(vtkScatteringImageFilter, Density, densityPort);
scDefineInputPort(vtkScatteringImageFilter, PhotonMap, photonMapPort);
scDefinePreparedScene(vtkScatteringImageFilter);
scDefineSpectrum(vtkScatteringImageFilter, SigmaS);
scDefineSpectrum(vtkScatteringImageFilter, SigmaA);
scDefinePhasePresets(vtkScatteringImageFilter);

void vtkScatteringImageFilter::AddPhotonMapConnection(vtkAlgorithmOutput* photons)
{
  this->AddInputConnection(photonMapPort, photons);
}

void vtkScatteringImageFilter::AddPhotonMapData(vtkDataObject* photons)
{
  this->AddInputDataInternal(photonMapPort, photons);
}

void vtkScatteringImageFilter::RemoveAllPhotonMaps()
{
  this->RemoveAllInputConnections(photonMapPort);
}

void vtkScatteringImageFilter::Modified()
{
  this->SceneTime.Modified();
  this->Superclass::Modified();
}

void vtkScatteringImageFilter::SetAutoExposure(bool automatic)
{
  if (this->AutoExposure != automatic)
  {
    this->AutoExposure = automatic;
    this->Superclass::Modified(); // the scene is as it was
  }
}

void vtkScatteringImageFilter::SetExposure(double exposure)
{
  if (this->Exposure != exposure)
  {
    this->Exposure = exposure;
    this->Superclass::Modified();
  }
}

void vtkScatteringImageFilter::SetToneCurve(int curve)
{
  if (this->ToneCurve != curve)
  {
    this->ToneCurve = curve;
    this->Superclass::Modified();
  }
}

void vtkScatteringImageFilter::SetProgressive(bool progressive)
{
  if (this->Progressive != progressive)
  {
    this->Progressive = progressive;
    this->Superclass::Modified(); // the image is as it was
  }
}

vtkMTimeType vtkScatteringImageFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

int vtkScatteringImageFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isPolyData = port == coneSetPort || port == photonMapPort;
  FillScenePortInformation(port, meshPort, lightPort, isPolyData ? "vtkPolyData" : "vtkImageData", info);
  if (port == photonMapPort)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkScatteringImageFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  if (this->Resolution[0] < 1 || this->Resolution[1] < 1 || this->Resolution[0] > VTK_INT_MAX / this->Resolution[1])
  {
    vtkErrorMacro("Resolution is " << this->Resolution[0] << " x " << this->Resolution[1]
                                   << ": both must be at least 1, and their product at most 2^31 - 1.");
    EmptyOutputs(outputVector); // no run will do it
    return 0;
  }
  const int dimensions[3] = { this->Resolution[0], this->Resolution[1], 1 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  OfferImage(info, dimensions, nullptr);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkScatteringImageFilter::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputVector)
{
  // Any part of the image needs all of the scene.
  RequestWholeInputs(this, request, inputs, outputVector);
  return 1;
}

std::string vtkScatteringImageFilter::CheckParameters() const
{
  const auto isBetween = [](double value, double low, double high) { return value > low && value < high; };
  std::string fault = FirstOutOfRange({
    OneOf("Mode", this->Mode, { "BruteForce", "Medium", "Fast", "Guided", "Soft", "Volume" }),
    { "RelativeErrorGoal", this->RelativeErrorGoal, this->RelativeErrorGoal >= 0.0, "0 or above" },
    { "MaximumSamples", this->MaximumSamples * 1.0, this->MaximumSamples >= 1, "at least 1" },
    InRange("NumberOfSoftLightSamples", this->NumberOfSoftLightSamples, 1, mostLightSamples),
    InRange("NumberOfSteps", this->NumberOfSteps, 1, 1000000),
    InRange("MaximumDepth", this->MaximumDepth, 0, 16),
    { "IntensityThreshold", this->IntensityThreshold, this->IntensityThreshold >= 0.0, "0 or above" },
    InRange("NumberOfLightSamples", this->NumberOfLightSamples, 1, mostLightSamples),
    InRange("NumberOfSurfaceLightSamples", this->NumberOfSurfaceLightSamples, 0, mostLightSamples),
    InRange("NumberOfEdgeSamples", this->NumberOfEdgeSamples, 1, 1024),
    { "Reflectance", this->Reflectance, this->Reflectance >= 0.0 && this->Reflectance <= 1.0, "in 0..1" },
    { "PhotonNeighbors", this->PhotonNeighbors * 1.0, this->PhotonNeighbors >= 0, "0 (automatic) or above" },
    { "NumberOfPhotonPasses", this->NumberOfPhotonPasses * 1.0, this->NumberOfPhotonPasses >= 0, "0 (no photons) or above" },
    { "NumberOfPhotonsPerPass", static_cast<double>(this->NumberOfPhotonsPerPass), this->NumberOfPhotonsPerPass >= 0,
      "0 or above" },
    { "ConeLength", this->ConeLength, this->ConeLength >= 0.0, "0 (not cut) or above" },
    OneOf("ToneCurve", this->ToneCurve, { "Linear", "Filmic" }),
    { "Exposure", this->Exposure, isBetween(this->Exposure, 0.0, HUGE_VAL), "above 0 and finite" },
  });
  if (fault.empty())
  {
    fault = CheckPhase(this->PhaseFunction, this->PhaseLobes, this->PhaseAsymmetry);
  }
  return fault.empty() ? CheckDimensions("SoftDimensions", this->SoftDimensions) : fault;
}

void vtkScatteringImageFilter::SetOptions(const int extent[6], ImageScene& scene) const
{
  ScatteringOptions& options = scene.Options;
  options.Mode = static_cast<ScatteringMode>(this->Mode);
  options.Width = this->Resolution[0];
  options.Height = this->Resolution[1];
  options.Extent = { extent[0], extent[1], extent[2], extent[3] };
  options.NumberOfSteps = this->NumberOfSteps;
  options.MaximumHalvings = this->MaximumDepth;
  options.IntensityThreshold = this->IntensityThreshold;
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.NumberOfSurfaceLightSamples = this->NumberOfSurfaceLightSamples;
  options.RelativeErrorGoal = this->RelativeErrorGoal;
  options.MaximumSamples = this->MaximumSamples;
  options.NumberOfEdgeSamples = this->NumberOfEdgeSamples;
  options.LightVisible = this->LightVisible;
  options.Reflectance = this->Reflectance;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.NumberOfPhotonPasses = this->NumberOfPhotonPasses;
  options.NumberOfPhotonsPerPass = this->NumberOfPhotonsPerPass;
  options.PhotonNeighbours = this->PhotonNeighbors;
  std::copy_n(this->SoftDimensions, 3, scene.Soft.Dimensions.begin());
  scene.Soft.NumberOfLightSamples = this->NumberOfSoftLightSamples;
  scene.ConeLength = this->ConeLength;
}

bool vtkScatteringImageFilter::ReadScene(vtkInformationVector** inputs, ImageScene& scene, std::string& error)
{
  ImageInputs data{ vtkDataObject::GetData(inputs[meshPort]), inputs[lightPort],
    vtkPolyData::GetData(inputs[coneSetPort]), vtkImageData::GetData(inputs[visibilityVolumePort]),
    vtkImageData::GetData(inputs[densityPort]), nullptr, inputs[photonMapPort] };
  const ParticleSettings particles{ this->SigmaSSpectrum, this->SigmaS, this->SigmaASpectrum, this->SigmaA,
    this->PhaseFunction, this->PhaseLobes, this->PhaseAsymmetry };
  const auto readParticles = [&]
  { return ReadParticles(particles, scene.Lights.Wavelengths.size(), scene.Medium, error); };
  const Monitor watch = MonitorOf(this).Part(0.0, shareOfPhotons);
  const auto readPhotons = [&] { return ReadPhotons(data, this->PhotonNeighbors, watch, scene, error); };
  return ChooseDensity(this, densityPort, data.Density, data.DensityValues, error) &&
    CheckInputs(data, scene.Options.Mode, error) && ReadInputs(data, scene, error) && readParticles() &&
    FindMediumBounds(this->MediumBounds, scene, error) && readPhotons() &&
    ChooseCamera(this->Camera, this->Resolution, scene, error);
}

vtkImageData* vtkScatteringImageFilter::GetPicture()
{
  return this->Picture;
}

/// Show the image at rising quality, before the image itself. @return false where aborted.
bool vtkScatteringImageFilter::ShowCoarse(ImageScene& scene, const Monitor& monitor)
{
  const std::vector<int> scales = CoarseScales(this->Resolution[0], this->Resolution[1]);
  double done = 0.0;
  for (std::size_t k = 0; k < scales.size(); ++k)
  {
    const double next = std::pow(16.0, static_cast<double>(k + 1) - static_cast<double>(scales.size()));
    ScatteringImage image;
    if (!RenderCoarse(scene, scales[k], monitor.Part(done, next), image))
    {
      return false;
    }
    this->NumberOfRaysSent += image.NumberOfOcclusionRays;
    done = next;
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(this->Resolution[0], this->Resolution[1], 1);
    WritePixels(image, picture->GetPointData());
    const std::vector<double>& wavelengths = scene.Lights.Wavelengths;
    const double exposure = this->AutoExposure ? FindExposure(picture, wavelengths) : this->Exposure;
    if (!WriteRgb(picture, MappingBy(wavelengths, exposure, this->ToneCurve), { {}, monitor.Aborted }, picture))
    {
      return false;
    }
    this->Picture = picture;
    this->InvokeEvent(vtkCommand::UpdateDataEvent);
  }
  return !monitor.IsAborted();
}

/// Render what is not kept yet. @return false after an error, or without one where aborted: nothing is kept then.
bool vtkScatteringImageFilter::RenderMissing(
  vtkInformationVector** inputs, const int extent[6], Warnings& warnings, std::string& error)
{
  const bool rendersPixels = !this->Kept->HoldsPixels(extent);
  const std::vector<std::array<int, 4>> extents =
    this->Kept->MissingExtents(extent, this->Resolution, this->AutoExposure);
  if (extents.empty())
  {
    return true;
  }
  if (rendersPixels)
  {
    this->Kept->Pixels = nullptr; // another tile's: there is to be room for one, not for two
  }
  const PreparedRun run(*this->Prepared);
  ImageScene scene(*this->Prepared);
  this->SetOptions(extent, scene);
  if (!this->ReadScene(inputs, scene, error))
  {
    return false;
  }
  std::vector<ScatteringImage> images;
  RayCheck check;
  const auto start = std::chrono::steady_clock::now();
  try
  {
    const Monitor monitor = MonitorOf(this).Part(scene.Photons ? shareOfPhotons : 0.0, 1.0);
    const bool rises = this->Progressive && rendersPixels && IsWhole(extent, this->Resolution);
    if ((rises && !this->ShowCoarse(scene, monitor.Part(0.0, shareOfCoarse))) ||
      !RenderScene(scene, extents, monitor.Part(rises ? shareOfCoarse : 0.0, 1.0), images) ||
      (rendersPixels && IsWhole(extent, this->Resolution) &&
        !CheckByRays(scene, images.front(), { nullptr, monitor.Aborted }, check)))
    {
      return false; // aborted
    }
  }
  catch (const std::exception& exception)
  {
    error = Sentence("Rendering failed: ", ReasonOf(exception), ".");
    return false;
  }
  for (const ScatteringImage& image : images)
  {
    this->NumberOfRaysSent += image.NumberOfOcclusionRays;
    WorkOfThisProcess().Rays += image.NumberOfOcclusionRays;
  }
  this->Kept->Wavelengths = scene.Lights.Wavelengths;
  if (rendersPixels)
  {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    warnings = scene.Said;
    warnings.Add(NotWhatRaysFind(check.Mode, check.Pixels, check.Light, check.Error));
    ReportImage(scene, images.front(), IsWhole(extent, this->Resolution), warnings);
    this->Kept->KeepPixels(images.front(), scene, extent, seconds.count());
  }
  this->Kept->KeepExposure(extents, images, rendersPixels ? 1 : 0);
  return true;
}

int vtkScatteringImageFilter::RequestData(
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
    return 1; // a piece with no pixels
  }
  error = this->CheckParameters();
  if (!error.empty())
  {
    return run.Fail(error);
  }
  KeptImage& kept = *this->Kept;
  const vtkMTimeType camera = this->Camera ? this->Camera->GetMTime() : 0;
  kept.DropIfOld(inputVector, this->GetNumberOfInputPorts(), std::max(this->SceneTime.GetMTime(), camera));
  Warnings warnings;
  if (!this->RenderMissing(inputVector, extent, warnings, error))
  {
    kept.Drop();
    return error.empty() ? 1 : run.Fail(error); // aborted: no output
  }
  if (this->AutoExposure && kept.Exposure == 0.0)
  {
    kept.Exposure = FindExposure(kept.Pixels, kept.Wavelengths);
  }
  output->ShallowCopy(kept.Pixels);
  const double exposure = this->AutoExposure ? kept.Exposure : this->Exposure;
  if (!WriteRgb(kept.Pixels, MappingBy(kept.Wavelengths, exposure, this->ToneCurve), { {}, MonitorOf(this).Aborted }, output))
  {
    EmptyOutput(output);
    return 1; // aborted
  }
  this->Picture = nullptr;
  if (this->Progressive && IsWhole(extent, this->Resolution))
  {
    this->Picture = vtkSmartPointer<vtkImageData>::New();
    this->Picture->ShallowCopy(output);
  }
  warnings.Add(this->AutoExposure ? UnusedExposure(this->Exposure) : std::string());
  warnings.Say(this);
  return 1;
}

void vtkScatteringImageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "RelativeErrorGoal: " << this->RelativeErrorGoal << "\n";
  os << indent << "MaximumSamples: " << this->MaximumSamples << "\n";
  os << indent << "SoftDimensions: " << Listed(this->SoftDimensions, 3) << "\n";
  os << indent << "NumberOfSoftLightSamples: " << this->NumberOfSoftLightSamples << "\n";
  os << indent << "SigmaS: " << this->SigmaS << "\n";
  os << indent << "SigmaSSpectrum: " << TextOf(this->SigmaSSpectrum) << "\n";
  os << indent << "SigmaA: " << this->SigmaA << "\n";
  os << indent << "SigmaASpectrum: " << TextOf(this->SigmaASpectrum) << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "PhaseLobes: " << Listed(this->PhaseLobes, 3) << "\n";
  os << indent << "PhaseAsymmetry: " << this->PhaseAsymmetry << "\n";
  os << indent << "MediumBounds: " << Listed(this->MediumBounds, 6) << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << "\n";
  os << indent << "IntensityThreshold: " << this->IntensityThreshold << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "NumberOfSurfaceLightSamples: " << this->NumberOfSurfaceLightSamples << "\n";
  os << indent << "NumberOfEdgeSamples: " << this->NumberOfEdgeSamples << "\n";
  os << indent << "LightVisible: " << (this->LightVisible ? "On" : "Off") << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "PhotonNeighbors: " << this->PhotonNeighbors << "\n";
  os << indent << "NumberOfPhotonPasses: " << this->NumberOfPhotonPasses << "\n";
  os << indent << "NumberOfPhotonsPerPass: " << this->NumberOfPhotonsPerPass << "\n";
  os << indent << "ConeLength: " << this->ConeLength << "\n";
  os << indent << "AutoExposure: " << (this->AutoExposure ? "On" : "Off") << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneCurve: " << this->ToneCurve << "\n";
  os << indent << "Progressive: " << (this->Progressive ? "On" : "Off") << "\n";
  os << indent << "Picture: " << this->Picture << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfRaysSent: " << this->NumberOfRaysSent << "\n";
  os << indent << "NumberOfPreparations: " << this->GetNumberOfPreparations() << "\n";
  os << indent << "PreparedScene: " << this->GetPreparedScene() << "\n";
  os << indent << "PreparedMemory: " << this->GetPreparedMemory() << "\n";
}
