// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScatteringImageFilter.h"

#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scFingerprints.h"
#include "scImageOutput.h"
#include "scImageReport.h"
#include "scImageScene.h"
#include "scKeptImage.h"
#include "scLightData.h"
#include "scMediumData.h"
#include "scOccluderNames.h"
#include "scSentence.h"
#include "scViewCamera.h"
#include "scToneMap.h"
#include "scVisibilityGrid.h"
#include "scWarnings.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// A grid for each light. @return false where aborted.
bool FillSoftGrids(const std::vector<std::vector<shadowcones::Cone>>& conesOf,
  const shadowcones::VisibilityGridOptions& options, const shadowcones::Monitor& monitor,
  shadowcones::ImageScene& scene)
{
  const auto count = static_cast<double>(conesOf.size());
  for (std::size_t k = 0; k < conesOf.size(); ++k)
  {
    const auto done = static_cast<double>(k);
    if (!shadowcones::FillVisibilityGrid(conesOf[k], scene.Lights.Lights[k], nullptr, scene.Fog.Bounds, options,
          monitor.Part(done / count, (done + 1.0) / count), scene.Visibility[k]))
    {
      return false;
    }
  }
  return true;
}

} // namespace

struct vtkScatteringImageFilter::Scene : shadowcones::ImageScene
{
  vtkNew<vtkCamera> UsedCamera; ///< as written to the field data
  vtkDataArray* DensityValues = nullptr; ///< chosen by its name
  std::string Discarded;    ///< what is to be said of the cone set's discarded vectors
  std::vector<std::array<int, 4>> Extents; ///< to render: i from, to, j from, to
  std::vector<shadowcones::ScatteringImage> Images;
};

vtkScatteringImageFilter::vtkScatteringImageFilter()
  : Kept(std::make_unique<shadowcones::KeptImage>())
{
  this->SetNumberOfInputPorts(5);
  this->GetInformation()->Remove(INPUT_ARRAYS_TO_PROCESS()); // the superclass chooses scalars of the mesh
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

void vtkScatteringImageFilter::AddLightConnection(vtkAlgorithmOutput* light)
{
  this->AddInputConnection(lightPort, light);
}

void vtkScatteringImageFilter::AddLightData(vtkDataObject* light)
{
  this->AddInputDataInternal(lightPort, light);
}

void vtkScatteringImageFilter::RemoveAllLights()
{
  this->RemoveAllInputConnections(lightPort);
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

void vtkScatteringImageFilter::Modified()
{
  this->SceneTime.Modified();
  this->Superclass::Modified();
}

void vtkScatteringImageFilter::SetAutoExposure(vtkTypeBool automatic)
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

vtkMTimeType vtkScatteringImageFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

int vtkScatteringImageFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == lightPort)
  {
    shadowcones::FillLightPortInformation(info);
    return 1;
  }
  const bool isImage = port == visibilityVolumePort || port == densityPort;
  if (port == meshPort)
  {
    shadowcones::AcceptBlocks(info);
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isImage ? "vtkImageData" : "vtkPolyData");
  }
  // Which are needed depends on the mode: RequestData says what to connect.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkScatteringImageFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  shadowcones::OfferTimes(this, inputVector, outputVector);
  if (this->Resolution[0] < 1 || this->Resolution[1] < 1 || this->Resolution[0] > VTK_INT_MAX / this->Resolution[1])
  {
    vtkErrorMacro("Resolution is " << this->Resolution[0] << " x " << this->Resolution[1]
                                   << ": both must be at least 1, and their product at most 2^31 - 1.");
    shadowcones::EmptyOutput(vtkDataObject::GetData(outputVector)); // no run will do it
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
    { "NumberOfLightSamples", this->NumberOfLightSamples * 1.0,
      this->NumberOfLightSamples >= 1 && this->NumberOfLightSamples <= mostLightSamples, "in 1..65536" },
    { "NumberOfSurfaceLightSamples", this->NumberOfSurfaceLightSamples * 1.0,
      this->NumberOfSurfaceLightSamples >= 0 && this->NumberOfSurfaceLightSamples <= mostLightSamples, "in 0..65536" },
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

bool vtkScatteringImageFilter::ChooseDensity(vtkImageData* density, vtkDataArray*& values, std::string& error)
{
  vtkInformationVector* choices = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* choice = choices ? choices->GetInformationObject(0) : nullptr;
  const std::string name =
    choice && choice->Has(vtkDataObject::FIELD_NAME()) ? choice->Get(vtkDataObject::FIELD_NAME()) : "(automatic)";
  const bool byAttribute = choice && choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  if (!density || !choice || (!byAttribute && (name.empty() || name == "(automatic)")))
  {
    return true; // the usual one
  }
  const int association = choice->Get(vtkDataObject::FIELD_ASSOCIATION());
  vtkPointData* points = density->GetPointData();
  if (choice->Get(INPUT_PORT()) != densityPort)
  {
    error = shadowcones::Sentence("SetInputArrayToProcess chooses an array of input port ", choice->Get(INPUT_PORT()),
      ": the only one to be chosen is the density's, of input port ", densityPort, ".");
  }
  else if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    association != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    error = "SetInputArrayToProcess chooses a density that is not point data: run vtkCellDataToPointData first.";
  }
  else if (!byAttribute)
  {
    values = points->GetArray(name.c_str());
    std::string others;
    for (int i = 0; i < points->GetNumberOfArrays(); ++i)
    {
      const char* other = points->GetArrayName(i);
      others += (i == 0 ? "\"" : ", \"") + std::string(other ? other : "") + "\"";
    }
    error = values ? ""
                   : shadowcones::Sentence("The density on input port 4 has no point array \"", name,
                       "\", which SetInputArrayToProcess chooses: it has ", others.empty() ? "none" : others, ".");
  }
  else
  {
    values = points->GetAttribute(choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
    error = values ? "" : "The density on input port 4 lacks the attribute that SetInputArrayToProcess chooses.";
  }
  return error.empty();
}

bool vtkScatteringImageFilter::ReadScene(vtkInformationVector** inputs, Scene& scene, std::string& error) const
{
  const shadowcones::ImageInputs data{ vtkDataObject::GetData(inputs[meshPort]), inputs[lightPort],
    vtkPolyData::GetData(inputs[coneSetPort]), vtkImageData::GetData(inputs[visibilityVolumePort]),
    vtkImageData::GetData(inputs[densityPort]), scene.DensityValues };
  if (!shadowcones::CheckInputs(data, scene.Options.Mode, error) || !shadowcones::ReadInputs(data, scene, error))
  {
    return false;
  }
  if (data.Cones)
  {
    scene.Discarded = shadowcones::TooManyDiscarded(data.Cones->GetFieldData());
  }
  const std::size_t wavelengths = scene.Lights.Wavelengths.size();
  shadowcones::Medium& medium = scene.Fog;
  medium.Phase.Kind = static_cast<shadowcones::PhaseFunctionKind>(this->PhaseFunction);
  medium.Phase.Lobes = { this->PhaseLobes[0], this->PhaseLobes[1], this->PhaseLobes[2] };
  medium.Phase.Asymmetry = this->PhaseAsymmetry;
  if (!shadowcones::ReadCoefficient("SigmaS", this->SigmaSSpectrum, this->SigmaS, wavelengths, medium.SigmaS, error) ||
    !shadowcones::ReadCoefficient("SigmaA", this->SigmaASpectrum, this->SigmaA, wavelengths, medium.SigmaA, error) ||
    !shadowcones::FindMediumBounds(this->MediumBounds, scene, error))
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
  constexpr double shareOfSoft = 0.4; // of the progress: filling its grids
  shadowcones::Monitor monitor = shadowcones::MonitorOf(this);
  const shadowcones::OccluderScene occluders(scene.Mesh.View());
  const std::vector<shadowcones::Light>& lights = scene.Lights.Lights;
  const std::vector<std::vector<shadowcones::Cone>> conesOf = shadowcones::ConesOfLights(scene.Cones, lights.size());
  if (this->Mode == Soft)
  {
    shadowcones::VisibilityGridOptions options;
    options.Method = shadowcones::VisibilityMethod::Soft;
    std::copy_n(this->SoftDimensions, 3, options.Dimensions.begin());
    options.NumberOfLightSamples = this->NumberOfSoftLightSamples;
    options.Seed = scene.Options.Seed;
    if (!FillSoftGrids(conesOf, options, monitor.Part(0.0, shareOfSoft), scene))
    {
      return false;
    }
    monitor = monitor.Part(shareOfSoft, 1.0);
  }
  // Surfaces outside the medium lie in shadow too.
  shadowcones::Box bounds = scene.Fog.Bounds;
  bounds.Add(scene.MeshBounds);
  const double length = this->ConeLength > 0.0 ? this->ConeLength : HUGE_VAL;
  const bool usesGrid = this->Mode == Soft || this->Mode == Volume;
  std::vector<std::unique_ptr<shadowcones::ConeHierarchy>> cones(lights.size());
  std::vector<shadowcones::ScatteringScene> scenes;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    if (scene.HasCones && this->Mode != Soft)
    {
      cones[k] = std::make_unique<shadowcones::ConeHierarchy>(conesOf[k], bounds, length);
    }
    scenes.push_back({ occluders, lights[k], scene.Fog, scene.Eye, cones[k].get(),
      usesGrid ? &scene.Visibility[k] : nullptr });
  }
  return shadowcones::RenderScattering(scenes, scene.Options, scene.Extents, monitor, scene.Images);
}

bool vtkScatteringImageFilter::IsWhole(const int extent[6]) const
{
  return extent[0] == 0 && extent[2] == 0 && extent[1] == this->Resolution[0] - 1 &&
    extent[3] == this->Resolution[1] - 1;
}

/// The extent that is asked for, unless it is kept, then those that the exposure of the whole image is found from.
void vtkScatteringImageFilter::ChooseExtents(const int extent[6], Scene& scene) const
{
  if (!this->Kept->HoldsPixels(extent))
  {
    scene.Extents.push_back({ extent[0], extent[1], extent[2], extent[3] });
  }
  if (this->AutoExposure && this->Kept->Exposure == 0.0 && !this->IsWhole(extent))
  {
    const auto squares = shadowcones::ExposureSquares(this->Resolution[0], this->Resolution[1]);
    scene.Extents.insert(scene.Extents.end(), squares.begin(), squares.end());
  }
}

/// Render what is not kept yet. @return false after an error, or where aborted: nothing is kept then.
bool vtkScatteringImageFilter::RenderMissing(
  vtkInformationVector** inputVector, const int extent[6], shadowcones::Warnings& warnings, int& result)
{
  Scene scene;
  std::string error;
  this->SetOptions(extent, scene);
  this->ChooseExtents(extent, scene);
  result = 0;
  if (!this->ChooseDensity(vtkImageData::GetData(inputVector[densityPort]), scene.DensityValues, error) ||
    !this->ReadScene(inputVector, scene, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  const auto start = std::chrono::steady_clock::now();
  try
  {
    if (!this->Render(scene))
    {
      result = 1; // aborted: no output
      return false;
    }
  }
  catch (const std::exception& exception)
  {
    vtkErrorMacro("Rendering failed: " << exception.what() << ".");
    return false;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  this->Kept->Wavelengths = scene.Lights.Wavelengths;
  std::size_t first = 0;
  if (!this->Kept->HoldsPixels(extent))
  {
    this->KeepPixels(scene, extent, seconds);
    warnings.Add(scene.Warning);
    for (const std::string& warning : scene.Warnings)
    {
      warnings.Add(warning);
    }
    for (const std::string& warning : scene.Lights.Warnings)
    {
      warnings.Add(warning);
    }
    this->AddWarnings(scene, extent, warnings);
    first = 1;
  }
  if (scene.Extents.size() > first)
  {
    const std::vector<double> weights = shadowcones::LuminanceWeights(scene.Lights.Wavelengths);
    std::vector<double> luminances;
    for (std::size_t k = first; k < scene.Extents.size(); ++k)
    {
      const shadowcones::ScatteringImage& image = scene.Images[k];
      shadowcones::AppendLuminances(scene.Extents[k], scene.Extents[k], image.InScattering.data(),
        image.SurfaceRadiance.data(), weights, luminances);
    }
    this->Kept->Exposure = shadowcones::ExposureOf(std::move(luminances));
  }
  return true;
}

void vtkScatteringImageFilter::KeepPixels(const Scene& scene, const int extent[6], double seconds)
{
  auto pixels = vtkSmartPointer<vtkImageData>::New();
  int whole[6];
  std::copy_n(extent, 6, whole);
  pixels->SetExtent(whole);
  const shadowcones::ScatteringImage& image = scene.Images.front();
  shadowcones::WritePixels(image, pixels->GetPointData());
  vtkFieldData* field = pixels->GetFieldData();
  shadowcones::AddIntArray(field, "Mode", 1, { this->Mode });
  shadowcones::AddIntArray(field, "Seed", 1, { this->Seed });
  shadowcones::AddDoubleArray(field, "RelativeErrorGoal", 1, { this->RelativeErrorGoal });
  shadowcones::AddIdArray(field, "NumberOfOcclusionRays", { image.NumberOfOcclusionRays });
  shadowcones::AddDoubleArray(field, "RenderSeconds", 1, { seconds });
  shadowcones::AddDoubleArray(field, "LightWavelengths", 1, scene.Lights.Wavelengths);
  shadowcones::WriteCamera(scene.UsedCamera, field);
  shadowcones::WriteMedium(scene.Fog, field);
  shadowcones::WriteOccluderNames(scene.OccluderNames, field);
  if (!scene.CastersFingerprints.empty())
  {
    shadowcones::WriteFingerprints(shadowcones::castersFingerprint, scene.CastersFingerprints, field);
  }
  shadowcones::WriteLightFingerprints(scene.Lights.Lights, pixels);
  this->Kept->Pixels = pixels;
}

void vtkScatteringImageFilter::AddWarnings(
  const Scene& scene, const int extent[6], shadowcones::Warnings& warnings) const
{
  const shadowcones::ScatteringImage& image = scene.Images.front();
  const shadowcones::PixelCounts counts = shadowcones::CountPixels(image, scene.Options);
  if (scene.HasCones)
  {
    warnings.Add(shadowcones::EmptyConeSet(
      static_cast<vtkIdType>(scene.Cones.size()), shadowcones::CountCasters(scene.Mesh)));
    if (this->Mode == Medium || this->Mode == Guided || this->Mode == Volume)
    {
      warnings.Add(scene.Discarded);
    }
  }
  if (this->Mode == Volume)
  {
    warnings.Add(shadowcones::MediumBeyondVolume(shadowcones::ShareBeyond(scene.Fog.Bounds, scene.Visibility.front())));
  }
  if (this->Mode == Soft)
  {
    for (const shadowcones::VisibilityGrid& grid : scene.Visibility)
    {
      warnings.Add(shadowcones::TooCoarse(grid,
      "Raise SoftDimensions, or take a vtkVisibilityVolume of Method Soft, which refines such cells, and Mode Volume."));
    }
  }
  if (this->Mode == Guided && this->RelativeErrorGoal > 0.0)
  {
    warnings.Add(shadowcones::GoalNotMet(
      counts.InMedium, counts.Missed, this->RelativeErrorGoal, counts.WorstError, this->MaximumSamples));
  }
  warnings.Add(shadowcones::ThickSteps(image.NumberOfThickRays, static_cast<vtkIdType>(image.Depth.size()),
    image.MarchOpticalDepth, this->NumberOfSteps));
  if (this->IsWhole(extent))
  {
    const bool attenuates = shadowcones::Attenuates(scene.Fog);
    warnings.Add(shadowcones::MediumNotSeen(attenuates ? counts.Pixels : 0, counts.InMedium));
    warnings.Add(shadowcones::NothingSeen(counts.Pixels, counts.Bright));
  }
}

int vtkScatteringImageFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const shadowcones::FilterRun run(this, request, inputVector, outputVector);
  shadowcones::EmptyOutput(output); // the executive keeps the last image's scalars
  std::string error;
  if (!run.AreInputsWhole(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  int extent[6];
  if (!shadowcones::RequestedExtent(outInfo, extent))
  {
    return 1; // a piece with no pixels
  }
  if (!this->CheckParameters(error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  shadowcones::KeptImage& kept = *this->Kept;
  const vtkMTimeType sceneTime = this->SceneTime.GetMTime();
  kept.DropIfOld(inputVector, this->GetNumberOfInputPorts(),
    this->Camera ? std::max(sceneTime, this->Camera->GetMTime()) : sceneTime);
  shadowcones::Warnings warnings;
  const bool needsExposure = this->AutoExposure && kept.Exposure == 0.0 && !this->IsWhole(extent);
  if (!kept.HoldsPixels(extent) || needsExposure)
  {
    int result = 0;
    if (!this->RenderMissing(inputVector, extent, warnings, result))
    {
      kept.Drop();
      return result;
    }
  }
  if (this->AutoExposure && kept.Exposure == 0.0)
  {
    kept.Exposure = shadowcones::FindExposure(kept.Pixels, kept.Wavelengths);
  }
  const double exposure = this->AutoExposure ? kept.Exposure : this->Exposure;
  output->ShallowCopy(kept.Pixels);
  shadowcones::WriteRgb(kept.Pixels, kept.Wavelengths, exposure, output);
  warnings.Add(this->AutoExposure ? shadowcones::UnusedExposure(this->Exposure) : std::string());
  warnings.Say(this);
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
  os << indent << "AutoExposure: " << (this->AutoExposure ? "On" : "Off") << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
