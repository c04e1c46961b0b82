// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScatteringImageFilter.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scImageOutput.h"
#include "scImageScene.h"
#include "scMediumData.h"
#include "scViewCamera.h"
#include "scVisibilityGrid.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkScatteringImageFilter);

namespace
{

constexpr int meshPort = 0;
constexpr int lightPort = 1;
constexpr int coneSetPort = 2;
constexpr int visibilityVolumePort = 3;
constexpr int densityPort = 4;
constexpr int mostLightSamples = 65536;
constexpr int mostEdgeSamples = 1024;

/// A value of a parameter, whether it is valid, and which are.
struct Ranged
{
  const char* Name;
  double Value;
  bool Valid;
  const char* Range;
};

bool IsBetween(double value, double low, double high)
{
  return value > low && value < high;
}

} // namespace

struct vtkScatteringImageFilter::Scene : shadowcones::ImageScene
{
  vtkNew<vtkCamera> UsedCamera; ///< as written to the field data
  shadowcones::ScatteringImage Image;
};

vtkScatteringImageFilter::vtkScatteringImageFilter()
{
  this->SetNumberOfInputPorts(5);
}

vtkScatteringImageFilter::~vtkScatteringImageFilter()
{
  this->SetCamera(nullptr);
}

vtkCxxSetObjectMacro(vtkScatteringImageFilter, Camera, vtkCamera);

void vtkScatteringImageFilter::SetLightConnection(vtkAlgorithmOutput* light)
{
  this->SetInputConnection(lightPort, light);
}

void vtkScatteringImageFilter::SetLightData(vtkDataObject* light)
{
  this->SetInputData(lightPort, light);
}

void vtkScatteringImageFilter::SetConeSetConnection(vtkAlgorithmOutput* cones)
{
  this->SetInputConnection(coneSetPort, cones);
}

void vtkScatteringImageFilter::SetConeSetData(vtkDataObject* cones)
{
  this->SetInputData(coneSetPort, cones);
}

void vtkScatteringImageFilter::SetVisibilityVolumeConnection(vtkAlgorithmOutput* volume)
{
  this->SetInputConnection(visibilityVolumePort, volume);
}

void vtkScatteringImageFilter::SetVisibilityVolumeData(vtkDataObject* volume)
{
  this->SetInputData(visibilityVolumePort, volume);
}

void vtkScatteringImageFilter::SetDensityConnection(vtkAlgorithmOutput* density)
{
  this->SetInputConnection(densityPort, density);
}

void vtkScatteringImageFilter::SetDensityData(vtkDataObject* density)
{
  this->SetInputData(densityPort, density);
}

void vtkScatteringImageFilter::SetSigmaS(double sigmaS)
{
  if (this->SigmaS != sigmaS || !this->SigmaSSpectrum.empty())
  {
    this->SigmaS = sigmaS;
    this->SigmaSSpectrum.clear();
    this->Modified();
  }
}

void vtkScatteringImageFilter::SetSigmaSSpectrum(int index, double sigmaS)
{
  if (index < 0)
  {
    vtkErrorMacro("SetSigmaSSpectrum: the index is " << index << "; wavelength samples count from 0.");
    return;
  }
  shadowcones::SetSample(this->SigmaSSpectrum, index, sigmaS);
  this->Modified();
}

double vtkScatteringImageFilter::GetSigmaSSpectrum(int index) const
{
  return shadowcones::GetSample(this->SigmaSSpectrum, index, this->SigmaS);
}

void vtkScatteringImageFilter::SetSigmaA(double sigmaA)
{
  if (this->SigmaA != sigmaA || !this->SigmaASpectrum.empty())
  {
    this->SigmaA = sigmaA;
    this->SigmaASpectrum.clear();
    this->Modified();
  }
}

void vtkScatteringImageFilter::SetSigmaASpectrum(int index, double sigmaA)
{
  if (index < 0)
  {
    vtkErrorMacro("SetSigmaASpectrum: the index is " << index << "; wavelength samples count from 0.");
    return;
  }
  shadowcones::SetSample(this->SigmaASpectrum, index, sigmaA);
  this->Modified();
}

double vtkScatteringImageFilter::GetSigmaASpectrum(int index) const
{
  return shadowcones::GetSample(this->SigmaASpectrum, index, this->SigmaA);
}

void vtkScatteringImageFilter::SetPhasePresetToRayleigh()
{
  const shadowcones::SchlickLobes lobes = shadowcones::SchlickRayleigh();
  this->SetPhaseFunctionToBlasiSchlick();
  this->SetPhaseLobes(lobes.Weight, lobes.K1, lobes.K2);
}

void vtkScatteringImageFilter::SetPhasePresetToHazyMie()
{
  const shadowcones::SchlickLobes lobes = shadowcones::SchlickHazyMie();
  this->SetPhaseFunctionToBlasiSchlick();
  this->SetPhaseLobes(lobes.Weight, lobes.K1, lobes.K2);
}

void vtkScatteringImageFilter::SetPhasePresetToMurkyMie()
{
  const shadowcones::SchlickLobes lobes = shadowcones::SchlickMurkyMie();
  this->SetPhaseFunctionToBlasiSchlick();
  this->SetPhaseLobes(lobes.Weight, lobes.K1, lobes.K2);
}

vtkMTimeType vtkScatteringImageFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

int vtkScatteringImageFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isImage = port == visibilityVolumePort || port == densityPort;
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isImage ? "vtkImageData" : "vtkPolyData");
  // Which are needed depends on the mode: RequestData says what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkScatteringImageFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (this->Resolution[0] < 1 || this->Resolution[1] < 1)
  {
    vtkErrorMacro(
      "Resolution is " << this->Resolution[0] << " x " << this->Resolution[1] << ": both must be at least 1.");
    return 0;
  }
  const int whole[6] = { 0, this->Resolution[0] - 1, 0, this->Resolution[1] - 1, 0, 0 };
  const double spacing[3] = { 1.0, 1.0, 1.0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkScatteringImageFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Any part of the image needs all of the scene.
  shadowcones::RequestWholeInputs(this, inputVector);
  for (const int port : { visibilityVolumePort, densityPort })
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
      {
        info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
          info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
      }
    }
  }
  return 1;
}

bool vtkScatteringImageFilter::CheckParameters(std::string& error) const
{
  const double* lobes = this->PhaseLobes;
  const int* n = this->SoftDimensions;
  const Ranged parameters[] = {
    { "Mode", this->Mode * 1.0, this->Mode >= BruteForce && this->Mode <= Volume,
      "BruteForce (0), Medium (1), Fast (2), Guided (3), Soft (4) or Volume (5)" },
    { "PhaseFunction", this->PhaseFunction * 1.0, this->PhaseFunction >= Isotropic && this->PhaseFunction <= Rayleigh,
      "Isotropic (0), BlasiSchlick (1), HenyeyGreenstein (2) or Rayleigh (3)" },
    { "PhaseAsymmetry", this->PhaseAsymmetry, IsBetween(this->PhaseAsymmetry, -1.0, 1.0), "between -1 and 1" },
    { "RelativeErrorGoal", this->RelativeErrorGoal, this->RelativeErrorGoal >= 0.0, "0 or above" },
    { "MaximumSamples", this->MaximumSamples * 1.0, this->MaximumSamples >= 1, "at least 1" },
    { "NumberOfSoftLightSamples", this->NumberOfSoftLightSamples * 1.0,
      this->NumberOfSoftLightSamples >= 1 && this->NumberOfSoftLightSamples <= mostLightSamples, "in 1..65536" },
    { "NumberOfSteps", this->NumberOfSteps * 1.0, this->NumberOfSteps >= 1 && this->NumberOfSteps <= 1000000,
      "in 1..1000000" },
    { "MaximumDepth", this->MaximumDepth * 1.0, this->MaximumDepth >= 0 && this->MaximumDepth <= 16, "in 0..16" },
    { "IntensityThreshold", this->IntensityThreshold, this->IntensityThreshold >= 0.0, "0 or above" },
    { "NumberOfLightSamples", this->NumberOfLightSamples * 1.0, this->NumberOfLightSamples >= 1, "at least 1" },
    { "NumberOfSurfaceLightSamples", this->NumberOfSurfaceLightSamples * 1.0, this->NumberOfSurfaceLightSamples >= 0,
      "0 or above" },
    { "NumberOfEdgeSamples", this->NumberOfEdgeSamples * 1.0,
      this->NumberOfEdgeSamples >= 1 && this->NumberOfEdgeSamples <= mostEdgeSamples, "in 1..1024" },
    { "Reflectance", this->Reflectance, this->Reflectance >= 0.0 && this->Reflectance <= 1.0, "in 0..1" },
    { "ConeLength", this->ConeLength, this->ConeLength >= 0.0, "0 (not cut) or above" },
    { "Exposure", this->Exposure, IsBetween(this->Exposure, 0.0, HUGE_VAL), "above 0 and finite" },
  };
  std::ostringstream text;
  text.precision(10);
  const auto* fault =
    std::find_if(std::begin(parameters), std::end(parameters), [](const Ranged& one) { return !one.Valid; });
  if (fault != std::end(parameters))
  {
    text << fault->Name << " is " << fault->Value << ": it must be " << fault->Range << ".";
  }
  else if (!(lobes[0] >= 0.0 && lobes[0] <= 1.0) || !IsBetween(lobes[1], -1.0, 1.0) || !IsBetween(lobes[2], -1.0, 1.0))
  {
    text << "PhaseLobes are " << lobes[0] << ", " << lobes[1] << ", " << lobes[2]
         << ": the weight must be in 0..1, k1 and k2 between -1 and 1.";
  }
  else if (std::min({ n[0], n[1], n[2] }) < 2 || static_cast<double>(n[0]) * n[1] * n[2] > VTK_INT_MAX)
  {
    text << "SoftDimensions are " << n[0] << ", " << n[1] << ", " << n[2]
         << ": each must be at least 2, and all together at most 2^31 - 1 points.";
  }
  error = text.str();
  return error.empty();
}

bool vtkScatteringImageFilter::ReadScene(vtkInformationVector** inputs, Scene& scene, std::string& error) const
{
  const shadowcones::ImageInputs data{ vtkPolyData::GetData(inputs[meshPort]), vtkPolyData::GetData(inputs[lightPort]),
    vtkPolyData::GetData(inputs[coneSetPort]), vtkImageData::GetData(inputs[visibilityVolumePort]),
    vtkImageData::GetData(inputs[densityPort]) };
  if (!shadowcones::CheckInputs(data, scene.Options.Mode, error) || !shadowcones::ReadInputs(data, scene, error))
  {
    return false;
  }
  const std::size_t wavelengths = scene.Source.Spectrum.size();
  shadowcones::Medium& medium = scene.Fog;
  medium.Phase.Kind = static_cast<shadowcones::PhaseFunctionKind>(this->PhaseFunction);
  medium.Phase.Lobes = { this->PhaseLobes[0], this->PhaseLobes[1], this->PhaseLobes[2] };
  medium.Phase.Asymmetry = this->PhaseAsymmetry;
  if (!shadowcones::ReadCoefficient("SigmaS", this->SigmaSSpectrum, this->SigmaS, wavelengths, medium.SigmaS, error) ||
    !shadowcones::ReadCoefficient("SigmaA", this->SigmaASpectrum, this->SigmaA, wavelengths, medium.SigmaA, error) ||
    !shadowcones::FindMediumBounds(this->MediumBounds, data.Light, scene, error))
  {
    return false;
  }
  if (this->Camera)
  {
    scene.UsedCamera->DeepCopy(this->Camera);
  }
  else
  {
    shadowcones::LookAtFront(scene.MeshBounds.Empty() ? medium.Bounds : scene.MeshBounds, scene.UsedCamera);
  }
  return shadowcones::ReadCamera(scene.UsedCamera, this->Resolution, scene.Eye, error);
}

void vtkScatteringImageFilter::SetOptions(const int extent[6], Scene& scene) const
{
  shadowcones::ScatteringOptions& options = scene.Options;
  options.Mode = static_cast<shadowcones::ScatteringMode>(this->Mode);
  options.Width = this->Resolution[0];
  options.Height = this->Resolution[1];
  options.Extent = { extent[0], extent[1], extent[2], extent[3] };
  options.NumberOfSteps = this->NumberOfSteps;
  options.MaximumDepth = this->MaximumDepth;
  options.IntensityThreshold = this->IntensityThreshold;
  options.NumberOfLightSamples = this->NumberOfLightSamples;
  options.NumberOfSurfaceLightSamples = this->NumberOfSurfaceLightSamples;
  options.RelativeErrorGoal = this->RelativeErrorGoal;
  options.MaximumSamples = this->MaximumSamples;
  options.NumberOfEdgeSamples = this->NumberOfEdgeSamples;
  options.LightVisible = this->LightVisible != 0;
  options.Reflectance = this->Reflectance;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
}

/// @return false where aborted.
bool vtkScatteringImageFilter::Render(Scene& scene)
{
  constexpr double shareOfSoft = 0.4; // of the progress: filling its grid
  shadowcones::Monitor monitor = shadowcones::MonitorOf(this);
  const shadowcones::OccluderScene occluders(scene.Mesh.View());
  std::unique_ptr<shadowcones::ConeHierarchy> cones;
  if (this->Mode == Soft)
  {
    shadowcones::VisibilityGridOptions options;
    options.Method = shadowcones::VisibilityMethod::Soft;
    std::copy_n(this->SoftDimensions, 3, options.Dimensions.begin());
    options.NumberOfLightSamples = this->NumberOfSoftLightSamples;
    options.Seed = scene.Options.Seed;
    if (!shadowcones::FillVisibilityGrid(scene.Cones, scene.Source, nullptr, scene.Fog.Bounds, options,
          monitor.Part(0.0, shareOfSoft), scene.Visibility))
    {
      return false;
    }
    monitor = monitor.Part(shareOfSoft, 1.0);
  }
  else if (scene.HasCones)
  {
    // Surfaces outside the medium lie in shadow too.
    shadowcones::Box bounds = scene.Fog.Bounds;
    bounds.Add(scene.MeshBounds);
    const double length = this->ConeLength > 0.0 ? this->ConeLength : HUGE_VAL;
    cones = std::make_unique<shadowcones::ConeHierarchy>(scene.Cones, bounds, length);
  }
  const bool usesGrid = this->Mode == Soft || this->Mode == Volume;
  return shadowcones::RenderScattering(
    { occluders, scene.Source, scene.Fog, scene.Eye, cones.get(), usesGrid ? &scene.Visibility : nullptr },
    scene.Options, monitor, scene.Image);
}

int vtkScatteringImageFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  output->Initialize(); // the executive keeps the last image's scalars: none are left after an error or an abort
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1; // a piece with no pixels
  }

  Scene scene;
  std::string error;
  this->SetOptions(extent, scene);
  if (!this->CheckParameters(error) || !this->ReadScene(inputVector, scene, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  const auto start = std::chrono::steady_clock::now();
  try
  {
    if (!this->Render(scene))
    {
      return 1; // aborted: no output
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Rendering failed: " << exception.what() << ".");
    return 0;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  output->SetExtent(extent);
  shadowcones::WritePixels(scene.Image, scene.Wavelengths, this->Exposure, output->GetPointData());
  vtkFieldData* field = output->GetFieldData();
  shadowcones::AddIntArray(field, "Mode", 1, { this->Mode });
  shadowcones::AddIntArray(field, "Seed", 1, { this->Seed });
  shadowcones::AddDoubleArray(field, "RelativeErrorGoal", 1, { this->RelativeErrorGoal });
  shadowcones::AddIdArray(field, "NumberOfOcclusionRays", { scene.Image.NumberOfOcclusionRays });
  shadowcones::AddDoubleArray(field, "RenderSeconds", 1, { seconds });
  shadowcones::WriteCamera(scene.UsedCamera, field);
  shadowcones::WriteMedium(scene.Fog, field);
  return 1;
}

void vtkScatteringImageFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printSpectrum = [&](const char* name, const std::vector<double>& spectrum)
  {
    os << indent << name << ":";
    for (const double value : spectrum)
    {
      os << ' ' << value;
    }
    os << (spectrum.empty() ? " (none)\n" : "\n");
  };
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "Resolution: " << this->Resolution[0] << " x " << this->Resolution[1] << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "RelativeErrorGoal: " << this->RelativeErrorGoal << "\n";
  os << indent << "MaximumSamples: " << this->MaximumSamples << "\n";
  os << indent << "SoftDimensions: " << this->SoftDimensions[0] << ", " << this->SoftDimensions[1] << ", "
     << this->SoftDimensions[2] << "\n";
  os << indent << "NumberOfSoftLightSamples: " << this->NumberOfSoftLightSamples << "\n";
  os << indent << "SigmaS: " << this->SigmaS << "\n";
  printSpectrum("SigmaSSpectrum", this->SigmaSSpectrum);
  os << indent << "SigmaA: " << this->SigmaA << "\n";
  printSpectrum("SigmaASpectrum", this->SigmaASpectrum);
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "PhaseLobes: " << this->PhaseLobes[0] << ", " << this->PhaseLobes[1] << ", " << this->PhaseLobes[2]
     << "\n";
  os << indent << "PhaseAsymmetry: " << this->PhaseAsymmetry << "\n";
  os << indent << "MediumBounds: " << this->MediumBounds[0] << ", " << this->MediumBounds[1] << ", "
     << this->MediumBounds[2] << ", " << this->MediumBounds[3] << ", " << this->MediumBounds[4] << ", "
     << this->MediumBounds[5] << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << "\n";
  os << indent << "IntensityThreshold: " << this->IntensityThreshold << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "NumberOfSurfaceLightSamples: " << this->NumberOfSurfaceLightSamples << "\n";
  os << indent << "NumberOfEdgeSamples: " << this->NumberOfEdgeSamples << "\n";
  os << indent << "LightVisible: " << (this->LightVisible ? "On" : "Off") << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "ConeLength: " << this->ConeLength << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
