// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScatteringImageFilter.h"

#include "scAdapters.h"
#include "scLightData.h"
#include "scScatteringImage.h"
#include "scSpectrum.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <string>

vtkStandardNewMacro(vtkScatteringImageFilter);

namespace
{

constexpr int lightPort = 1;
constexpr int coneSetPort = 2;

shadowcones::Vector3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

/// Values of a coefficient at every wavelength: the spectrum's where it has one, else @p all.
std::vector<double> FillSpectrum(const std::vector<double>& spectrum, double all, std::size_t count)
{
  std::vector<double> values(count, all);
  for (std::size_t k = 0; k < std::min(count, spectrum.size()); ++k)
  {
    values[k] = std::isnan(spectrum[k]) ? all : spectrum[k];
  }
  return values;
}

void SetSample(std::vector<double>& spectrum, int index, double value)
{
  const auto k = static_cast<std::size_t>(index);
  if (k >= spectrum.size())
  {
    spectrum.resize(k + 1, std::numeric_limits<double>::quiet_NaN());
  }
  spectrum[k] = value;
}

double GetSample(const std::vector<double>& spectrum, int index, double all)
{
  const auto k = static_cast<std::size_t>(index);
  return index < 0 || k >= spectrum.size() || std::isnan(spectrum[k]) ? all : spectrum[k];
}

void AddInt(vtkFieldData* data, const char* name, int value)
{
  shadowcones::AddIntArray(data, name, 1, { value });
}

void AddDouble(vtkFieldData* data, const char* name, double value)
{
  shadowcones::AddDoubleArray(data, name, 1, { value });
}

/// The light's wavelengths in nm where it says so, else the default ones for its number of samples.
std::vector<double> ReadWavelengths(vtkPolyData* light, std::size_t count)
{
  vtkDataArray* array = light->GetFieldData()->GetArray("LightWavelengths");
  std::vector<double> wavelengths = shadowcones::DefaultWavelengths(static_cast<int>(count));
  if (array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == static_cast<vtkIdType>(count))
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      wavelengths[k] = array->GetComponent(static_cast<vtkIdType>(k), 0);
    }
  }
  return wavelengths;
}

/// Linear radiance of every pixel to sRGB bytes.
vtkSmartPointer<vtkUnsignedCharArray> ToneMap(
  const std::vector<float>& radiance, const std::vector<double>& wavelengthsInNm, double exposure)
{
  const auto matrix = shadowcones::SpectrumToLinearSrgb(wavelengthsInNm);
  const auto wavelengths = static_cast<int>(wavelengthsInNm.size());
  const auto pixels = static_cast<vtkIdType>(radiance.size() / static_cast<std::size_t>(wavelengths));
  auto rgb = vtkSmartPointer<vtkUnsignedCharArray>::New();
  rgb->SetName("RGB");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(pixels);
  unsigned char* bytes = rgb->GetPointer(0);
  vtkSMPTools::For(0, pixels,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float* spectrum = radiance.data() + i * wavelengths;
        for (int c = 0; c < 3; ++c)
        {
          double linear = 0.0;
          for (int k = 0; k < wavelengths; ++k)
          {
            linear += matrix[c][k] * spectrum[k];
          }
          bytes[3 * i + c] = shadowcones::EncodeSrgb(exposure * linear);
        }
      }
    });
  return rgb;
}

} // namespace

struct vtkScatteringImageFilter::Scene
{
  shadowcones::TriangleMesh Mesh;
  shadowcones::Box MeshBounds;
  shadowcones::Light Light;
  std::vector<double> Wavelengths; ///< nm
  std::vector<shadowcones::Cone> Cones;
  shadowcones::Medium Medium;
  shadowcones::Camera Camera;
  vtkNew<vtkCamera> UsedCamera; ///< as written to the field data
  shadowcones::ScatteringOptions Options;
  shadowcones::ScatteringImage Image;
};

vtkScatteringImageFilter::vtkScatteringImageFilter()
{
  this->SetNumberOfInputPorts(3);
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
  SetSample(this->SigmaSSpectrum, index, sigmaS);
  this->Modified();
}

double vtkScatteringImageFilter::GetSigmaSSpectrum(int index) const
{
  return GetSample(this->SigmaSSpectrum, index, this->SigmaS);
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
  SetSample(this->SigmaASpectrum, index, sigmaA);
  this->Modified();
}

double vtkScatteringImageFilter::GetSigmaASpectrum(int index) const
{
  return GetSample(this->SigmaASpectrum, index, this->SigmaA);
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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port != 0)
  {
    // The light too: RequestData has a better message for its absence than the executive.
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
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
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

bool vtkScatteringImageFilter::CheckParameters()
{
  const auto between = [](double value, double low, double high) { return value > low && value < high; };
  if (this->Mode < BruteForce || this->Mode > Fast)
  {
    vtkErrorMacro("Mode is " << this->Mode << ": it must be BruteForce (0), Medium (1) or Fast (2).");
  }
  else if (this->PhaseFunction < Isotropic || this->PhaseFunction > Rayleigh)
  {
    vtkErrorMacro(
      "PhaseFunction is " << this->PhaseFunction
                          << ": it must be Isotropic (0), BlasiSchlick (1), HenyeyGreenstein (2) or Rayleigh (3).");
  }
  else if (!(this->PhaseLobes[0] >= 0.0 && this->PhaseLobes[0] <= 1.0) || !between(this->PhaseLobes[1], -1.0, 1.0) ||
    !between(this->PhaseLobes[2], -1.0, 1.0))
  {
    vtkErrorMacro("PhaseLobes are " << this->PhaseLobes[0] << ", " << this->PhaseLobes[1] << ", " << this->PhaseLobes[2]
                                    << ": the weight must be in 0..1, k1 and k2 between -1 and 1.");
  }
  else if (!between(this->PhaseAsymmetry, -1.0, 1.0))
  {
    vtkErrorMacro("PhaseAsymmetry is " << this->PhaseAsymmetry << ": it must be between -1 and 1.");
  }
  else if (this->NumberOfSteps < 1 || this->NumberOfSteps > 1000000)
  {
    vtkErrorMacro("NumberOfSteps is " << this->NumberOfSteps << ": it must be in 1..1000000.");
  }
  else if (this->MaximumDepth < 0 || this->MaximumDepth > 16)
  {
    vtkErrorMacro("MaximumDepth is " << this->MaximumDepth << ": it must be in 0..16.");
  }
  else if (!(this->IntensityThreshold >= 0.0))
  {
    vtkErrorMacro("IntensityThreshold is " << this->IntensityThreshold << ": it must be 0 or above.");
  }
  else if (this->NumberOfLightSamples < 1)
  {
    vtkErrorMacro("NumberOfLightSamples is " << this->NumberOfLightSamples << ": it must be at least 1.");
  }
  else if (this->NumberOfSurfaceLightSamples < 0)
  {
    vtkErrorMacro("NumberOfSurfaceLightSamples is " << this->NumberOfSurfaceLightSamples << ": it must be 0 or above.");
  }
  else if (!(this->Reflectance >= 0.0 && this->Reflectance <= 1.0))
  {
    vtkErrorMacro("Reflectance is " << this->Reflectance << ": it must be in 0..1.");
  }
  else if (!(this->ConeLength >= 0.0))
  {
    vtkErrorMacro("ConeLength is " << this->ConeLength << ": it must be 0 (not cut) or above.");
  }
  else if (!(this->Exposure > 0.0) || std::isinf(this->Exposure))
  {
    vtkErrorMacro("Exposure is " << this->Exposure << ": it must be above 0 and finite.");
  }
  else
  {
    return true;
  }
  return false;
}

bool vtkScatteringImageFilter::ReadInputs(vtkInformationVector** inputs, Scene& scene)
{
  std::string error;
  if (!shadowcones::ReadTriangles(vtkPolyData::GetData(inputs[0]), scene.Mesh, error))
  {
    vtkErrorMacro("Mesh (input port 0): " << error);
    return false;
  }
  scene.MeshBounds = shadowcones::MeshBounds(scene.Mesh.View());

  vtkPolyData* light = vtkPolyData::GetData(inputs[lightPort]);
  if (!light)
  {
    vtkErrorMacro("There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().");
    return false;
  }
  if (!shadowcones::ReadLight(light, scene.Light, error))
  {
    vtkErrorMacro("Light (input port 1): " << error);
    return false;
  }
  scene.Wavelengths = ReadWavelengths(light, scene.Light.Spectrum.size());

  if (this->Mode != BruteForce)
  {
    vtkPolyData* cones = vtkPolyData::GetData(inputs[coneSetPort]);
    if (!cones)
    {
      vtkErrorMacro("Mode is " << (this->Mode == Medium ? "Medium" : "Fast")
                               << " but there is no cone set: connect a vtkConeSetFilter with "
                                  "SetConeSetConnection(), or use SetModeToBruteForce().");
      return false;
    }
    if (!shadowcones::ReadConeSet(cones, scene.Cones, error))
    {
      vtkErrorMacro("Cone set (input port 2): " << error);
      return false;
    }
  }
  return true;
}

bool vtkScatteringImageFilter::ReadReflectance(vtkInformationVector** inputs, Scene& scene)
{
  vtkDataArray* array = vtkPolyData::GetData(inputs[0])->GetCellData()->GetArray("Reflectance");
  if (!array)
  {
    return true;
  }
  const int components = array->GetNumberOfComponents();
  const auto wavelengths = static_cast<int>(scene.Light.Spectrum.size());
  if (components != 1 && components != wavelengths)
  {
    vtkErrorMacro("Cell array \"Reflectance\" of the mesh has "
      << components << " components: it must have 1, or " << wavelengths << " as the light has wavelength samples.");
    return false;
  }
  shadowcones::ScatteringOptions& options = scene.Options;
  options.ReflectanceComponents = components;
  options.SurfaceReflectance.reserve(scene.Mesh.SourceCells.size() * static_cast<std::size_t>(components));
  for (const vtkIdType cell : scene.Mesh.SourceCells)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = array->GetComponent(cell, c);
      if (!(value >= 0.0 && value <= 1.0))
      {
        vtkErrorMacro(
          "Cell array \"Reflectance\" of the mesh is " << value << " at cell " << cell << ": it must be in 0..1.");
        return false;
      }
      options.SurfaceReflectance.push_back(static_cast<float>(value));
    }
  }
  return true;
}

bool vtkScatteringImageFilter::ReadMedium(vtkInformationVector** inputs, Scene& scene)
{
  const std::size_t wavelengths = scene.Light.Spectrum.size();
  shadowcones::Medium& medium = scene.Medium;
  medium.SigmaS = FillSpectrum(this->SigmaSSpectrum, this->SigmaS, wavelengths);
  medium.SigmaA = FillSpectrum(this->SigmaASpectrum, this->SigmaA, wavelengths);
  for (const auto* values : { &medium.SigmaS, &medium.SigmaA })
  {
    const char* name = values == &medium.SigmaS ? "SigmaS" : "SigmaA";
    const std::size_t given = values == &medium.SigmaS ? this->SigmaSSpectrum.size() : this->SigmaASpectrum.size();
    if (given > wavelengths)
    {
      vtkErrorMacro("Set" << name << "Spectrum was given wavelength sample " << given - 1 << ", but the light has "
                          << wavelengths << " samples.");
      return false;
    }
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      if (!((*values)[k] >= 0.0) || std::isinf((*values)[k]))
      {
        vtkErrorMacro(<< name << " is " << (*values)[k] << " at wavelength sample " << k
                      << ": it must be 0 or above and finite.");
        return false;
      }
    }
  }
  medium.Phase.Kind = static_cast<shadowcones::PhaseFunctionKind>(this->PhaseFunction);
  medium.Phase.Lobes = { this->PhaseLobes[0], this->PhaseLobes[1], this->PhaseLobes[2] };
  medium.Phase.Asymmetry = this->PhaseAsymmetry;

  const double* b = this->MediumBounds;
  if (b[0] == 1.0 && b[1] == -1.0 && b[2] == 1.0 && b[3] == -1.0 && b[4] == 1.0 && b[5] == -1.0)
  {
    shadowcones::Box joint = scene.MeshBounds;
    vtkPolyData* light = vtkPolyData::GetData(inputs[lightPort]);
    if (!shadowcones::IsAtInfinity(scene.Light) && light->GetNumberOfPoints() > 0)
    {
      double bounds[6];
      light->GetBounds(bounds);
      joint.Add(shadowcones::Vector3{ bounds[0], bounds[2], bounds[4] });
      joint.Add(shadowcones::Vector3{ bounds[1], bounds[3], bounds[5] });
    }
    const double diagonal = joint.Diagonal();
    if (!(diagonal > 0.0))
    {
      vtkErrorMacro("MediumBounds are not set, and mesh and light have no bounds to take them from.");
      return false;
    }
    const shadowcones::Vector3 size = joint.Size();
    const auto half = [diagonal](double side) { return side > 0.0 ? 0.55 * side : 0.05 * diagonal; };
    const shadowcones::Vector3 reach{ half(size.X), half(size.Y), half(size.Z) };
    medium.Bounds = { joint.Center() - reach, joint.Center() + reach };
    return true;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(b[2 * axis] <= b[2 * axis + 1]) || !std::isfinite(b[2 * axis]) || !std::isfinite(b[2 * axis + 1]))
    {
      vtkErrorMacro("MediumBounds along "
        << "xyz"[axis] << " run from " << b[2 * axis] << " to " << b[2 * axis + 1]
        << ": they must be finite and in ascending order.");
      return false;
    }
  }
  medium.Bounds = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
  return true;
}

bool vtkScatteringImageFilter::ReadCamera(Scene& scene)
{
  vtkCamera* camera = scene.UsedCamera;
  if (this->Camera)
  {
    camera->DeepCopy(this->Camera);
  }
  else
  {
    const shadowcones::Box& box = scene.MeshBounds.Empty() ? scene.Medium.Bounds : scene.MeshBounds;
    const double distance = 0.5 * box.Diagonal() / std::sin(vtkMath::RadiansFromDegrees(15.0));
    const shadowcones::Vector3 center = box.Center();
    camera->SetViewAngle(30.0);
    camera->SetFocalPoint(center.X, center.Y, center.Z);
    camera->SetPosition(center.X, center.Y, center.Z + (distance > 0.0 ? distance : 1.0));
    camera->SetViewUp(0.0, 1.0, 0.0);
  }

  const shadowcones::Vector3 position = ToVector(camera->GetPosition());
  const shadowcones::Vector3 view = ToVector(camera->GetFocalPoint()) - position;
  const shadowcones::Vector3 forward = shadowcones::Normalized(view);
  const shadowcones::Vector3 right = shadowcones::Cross(forward, ToVector(camera->GetViewUp()));
  if (!shadowcones::IsFinite(view) || !shadowcones::IsFinite(right) || !(shadowcones::Length(view) > 0.0))
  {
    vtkErrorMacro("The camera's position and focal point must be finite and differ.");
    return false;
  }
  if (!(shadowcones::Length(right) > 1e-9 * shadowcones::Length(ToVector(camera->GetViewUp()))))
  {
    vtkErrorMacro("The camera's view up runs along its direction of view: choose another with SetViewUp().");
    return false;
  }
  shadowcones::Camera& used = scene.Camera;
  used.Position = position;
  used.Forward = forward;
  used.Right = shadowcones::Normalized(right);
  used.Up = shadowcones::Cross(used.Right, forward);
  used.Parallel = camera->GetParallelProjection() != 0;
  used.HalfHeight = camera->GetParallelScale();
  if (!used.Parallel)
  {
    used.HalfHeight = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    if (camera->GetUseHorizontalViewAngle())
    {
      used.HalfHeight *= static_cast<double>(this->Resolution[1]) / this->Resolution[0];
    }
  }
  if (!(used.HalfHeight > 0.0) || std::isinf(used.HalfHeight))
  {
    vtkErrorMacro("The camera's " << (used.Parallel ? "parallel scale" : "view angle") << " must be above 0.");
    return false;
  }
  return true;
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
  if (!this->CheckParameters() || !this->ReadInputs(inputVector, scene) || !this->ReadReflectance(inputVector, scene) ||
    !this->ReadMedium(inputVector, scene) || !this->ReadCamera(scene))
  {
    return 0;
  }

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
  options.LightVisible = this->LightVisible != 0;
  options.Reflectance = this->Reflectance;
  options.Seed = static_cast<std::uint64_t>(this->Seed);

  const auto start = std::chrono::steady_clock::now();
  try
  {
    const shadowcones::OccluderScene occluders(scene.Mesh.View());
    std::unique_ptr<shadowcones::ConeHierarchy> cones;
    if (this->Mode != BruteForce)
    {
      // Surfaces outside the medium lie in shadow too.
      shadowcones::Box bounds = scene.Medium.Bounds;
      if (!scene.MeshBounds.Empty())
      {
        bounds.Add(scene.MeshBounds);
      }
      const double length = this->ConeLength > 0.0 ? this->ConeLength : HUGE_VAL;
      cones = std::make_unique<shadowcones::ConeHierarchy>(scene.Cones, bounds, length);
    }
    if (!shadowcones::RenderScattering(occluders, scene.Light, scene.Medium, scene.Camera, cones.get(), options,
          shadowcones::MonitorOf(this), scene.Image))
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
  this->WriteOutput(scene, seconds, extent, output);
  return 1;
}

void vtkScatteringImageFilter::WriteOutput(
  const Scene& scene, double seconds, const int extent[6], vtkImageData* output)
{
  const shadowcones::ScatteringImage& image = scene.Image;
  const int wavelengths = image.NumberOfWavelengths;
  output->SetExtent(const_cast<int*>(extent));
  vtkPointData* points = output->GetPointData();
  shadowcones::AddFloatArray(points, "Radiance", wavelengths, image.Radiance);
  shadowcones::AddFloatArray(points, "InScattering", wavelengths, image.InScattering);
  shadowcones::AddFloatArray(points, "SurfaceRadiance", wavelengths, image.SurfaceRadiance);
  shadowcones::AddFloatArray(points, "Transmittance", wavelengths, image.Transmittance);
  shadowcones::AddFloatArray(points, "Depth", 1, image.Depth);
  shadowcones::AddFloatArray(points, "RelativeError", 1, image.RelativeError);
  shadowcones::AddIntArray(points, "SampleCount", 1, image.SampleCount);
  points->SetScalars(ToneMap(image.Radiance, scene.Wavelengths, this->Exposure));

  vtkFieldData* field = output->GetFieldData();
  AddInt(field, "Mode", this->Mode);
  AddInt(field, "Seed", this->Seed);
  shadowcones::AddIdArray(field, "NumberOfOcclusionRays", { image.NumberOfOcclusionRays });
  AddDouble(field, "RenderSeconds", seconds);
  vtkCamera* camera = scene.UsedCamera;
  const double* position = camera->GetPosition();
  const double* focalPoint = camera->GetFocalPoint();
  const double* viewUp = camera->GetViewUp();
  shadowcones::AddDoubleArray(field, "CameraPosition", 3, { position, position + 3 });
  shadowcones::AddDoubleArray(field, "CameraFocalPoint", 3, { focalPoint, focalPoint + 3 });
  shadowcones::AddDoubleArray(field, "CameraViewUp", 3, { viewUp, viewUp + 3 });
  AddDouble(field, "CameraViewAngle", camera->GetViewAngle());
  AddInt(field, "CameraParallelProjection", camera->GetParallelProjection());
  AddDouble(field, "CameraParallelScale", camera->GetParallelScale());
  shadowcones::AddDoubleArray(field, "SigmaS", wavelengths, scene.Medium.SigmaS);
  shadowcones::AddDoubleArray(field, "SigmaA", wavelengths, scene.Medium.SigmaA);
  const shadowcones::Box& box = scene.Medium.Bounds;
  shadowcones::AddDoubleArray(
    field, "MediumBounds", 6, { box.Min.X, box.Max.X, box.Min.Y, box.Max.Y, box.Min.Z, box.Max.Z });
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
  os << indent << "LightVisible: " << (this->LightVisible ? "On" : "Off") << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "ConeLength: " << this->ConeLength << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
