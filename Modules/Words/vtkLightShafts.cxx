// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightShafts.h"

#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scInnerFilter.h"
#include "scInputPorts.h"
#include "scMeshBlocks.h"
#include "scMeshSurfaces.h"
#include "scOptionalBounds.h"
#include "scParameterRanges.h"
#include "scSceneLights.h"
#include "scSentence.h"
#include "vtkAreaLightSource.h"
#include "vtkLabelOccluders.h"
#include "vtkSceneDefaults.h"
#include "vtkScatteringImageFilter.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;

vtkStandardNewMacro(vtkLightShafts);
scDefineGuardedRequests(vtkLightShafts);

namespace
{
constexpr int lightPort = 1;
constexpr int lampOutput = 1;
constexpr int imageOutput = 2;

/// The data of an input, for a filter inside that must not touch the original.
vtkSmartPointer<vtkDataObject> Borrow(vtkDataObject* data)
{
  auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

/// Let defaults know the lights of a port; those without a polygon, such as the Sun at night, say nothing.
bool AddLights(vtkInformationVector* port, vtkSceneDefaults* defaults, std::string& error)
{
  for (int k = 0; k < port->GetNumberOfInformationObjects(); ++k)
  {
    std::vector<MeshBlock> blocks;
    if (!CollectBlocks(vtkDataObject::GetData(port, k), blocks, error))
    {
      return false;
    }
    for (const MeshBlock& block : blocks)
    {
      if (block.Data->GetNumberOfCells() > 0)
      {
        defaults->AddLight(block.Data);
      }
    }
  }
  return true;
}

/// Right, above and half the height of what a camera sees at its focal point.
struct FocalFrame
{
  double Center[3];
  double Right[3];
  double Above[3];
  double HalfHeight;
};

FocalFrame FrameOf(vtkCamera* camera, double aspect)
{
  FocalFrame frame;
  double view[3];
  camera->GetFocalPoint(frame.Center);
  camera->GetDirectionOfProjection(view);
  vtkMath::Cross(view, camera->GetViewUp(), frame.Right);
  vtkMath::Normalize(frame.Right);
  vtkMath::Cross(frame.Right, view, frame.Above);
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) * camera->GetDistance();
  frame.HalfHeight = camera->GetParallelProjection() ? camera->GetParallelScale()
    : camera->GetUseHorizontalViewAngle()            ? half / aspect
                                                     : half;
  return frame;
}

/// One quad a pixel, in the plane through the camera's focal point.
void PlacePicture(vtkImageData* image, vtkCamera* camera, vtkPolyData* picture)
{
  const vtkIdType width = image->GetDimensions()[0];
  const vtkIdType height = image->GetDimensions()[1];
  const FocalFrame frame = FrameOf(camera, static_cast<double>(width) / static_cast<double>(height));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints((width + 1) * (height + 1));
  for (vtkIdType j = 0; j <= height; ++j)
  {
    const double above = frame.HalfHeight * static_cast<double>(2 * j - height) / static_cast<double>(height);
    for (vtkIdType i = 0; i <= width; ++i)
    {
      const double right = frame.HalfHeight * static_cast<double>(2 * i - width) / static_cast<double>(height);
      double p[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = frame.Center[axis] + right * frame.Right[axis] + above * frame.Above[axis];
      }
      points->SetPoint(j * (width + 1) + i, p);
    }
  }
  vtkNew<vtkIdTypeArray> corners;
  vtkNew<vtkIdTypeArray> offsets;
  corners->SetNumberOfValues(4 * width * height);
  offsets->SetNumberOfValues(width * height + 1);
  for (vtkIdType pixel = 0; pixel <= width * height; ++pixel)
  {
    offsets->SetValue(pixel, 4 * pixel);
    if (pixel < width * height)
    {
      const vtkIdType first = pixel / width * (width + 1) + pixel % width;
      const vtkIdType quad[4] = { first, first + 1, first + width + 2, first + width + 1 };
      std::copy(quad, quad + 4, corners->GetPointer(4 * pixel));
    }
  }
  vtkNew<vtkCellArray> quads;
  quads->SetData(offsets, corners);
  picture->SetPoints(points);
  picture->SetPolys(quads);
  picture->GetCellData()->ShallowCopy(image->GetPointData());
  picture->GetFieldData()->ShallowCopy(image->GetFieldData());
}
} // anonymous namespace

vtkLightShafts::vtkLightShafts()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkLightShafts::~vtkLightShafts() = default;

vtkCxxSetSmartPointerMacro(vtkLightShafts, Camera, vtkCamera);

vtkCamera* vtkLightShafts::GetCamera()
{
  return this->Camera;
}

scDefineLightPort(vtkLightShafts, lightPort);

vtkMTimeType vtkLightShafts::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

int vtkLightShafts::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == lightPort)
  {
    FillLightPortInformation(info);
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  else
  {
    AcceptDataSets(info);
  }
  return 1;
}

int vtkLightShafts::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == imageOutput ? "vtkImageData" : "vtkPolyData");
  return 1;
}

std::string vtkLightShafts::CheckParameters() const
{
  if (this->Resolution[0] < 1 || this->Resolution[1] < 1 || this->Resolution[0] > VTK_INT_MAX / this->Resolution[1])
  {
    return Sentence("Resolution is ", this->Resolution[0], " x ", this->Resolution[1],
      ": both must be at least 1, and their product at most 2^31 - 1.");
  }
  return FirstOutOfRange({
    OneOf("Up", this->Up, { "Automatic", "X", "Y", "Z" }),
    { "RelativeErrorGoal", this->RelativeErrorGoal, this->RelativeErrorGoal > 0.0, "above 0" },
    { "OpticalDepth", this->OpticalDepth, this->OpticalDepth >= 0.0 && !std::isinf(this->OpticalDepth),
      "0 or above and finite" },
  }); // vtkScatteringImageFilter checks the others, which have its names
}

int vtkLightShafts::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  OfferTimes(this, inputVector, outputVector);
  const std::string fault = this->CheckParameters();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    EmptyOutputs(outputVector); // no run will do it
    return 0;
  }
  const int dimensions[3] = { this->Resolution[0], this->Resolution[1], 1 };
  vtkInformation* info = outputVector->GetInformationObject(imageOutput);
  OfferImage(info, dimensions, nullptr);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkLightShafts::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestWholeInputs(this, request, inputVector, outputVector);
  return 1;
}

void vtkLightShafts::SetUpImage(vtkSceneDefaults* defaults, vtkScatteringImageFilter* image) const
{
  vtkSmartPointer<vtkCamera> camera = this->Camera;
  if (!camera)
  {
    camera = vtkSmartPointer<vtkCamera>::New();
    defaults->PlaceCamera(camera, static_cast<double>(this->Resolution[0]) / this->Resolution[1]);
  }
  double bounds[6];
  defaults->GetMediumBounds(bounds);
  if (!AreUnsetBounds(this->MediumBounds))
  {
    std::copy(this->MediumBounds, this->MediumBounds + 6, bounds);
  }
  const double longest = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  image->SetCamera(camera);
  image->SetResolution(this->Resolution[0], this->Resolution[1]);
  image->SetRelativeErrorGoal(this->RelativeErrorGoal);
  image->SetMediumBounds(bounds);
  image->SetSigmaS(longest > 0.0 ? this->OpticalDepth / longest : 0.0); // else its box is a fault, which the image tells
  image->SetPhaseFunctionToHenyeyGreenstein();
  image->SetPhaseAsymmetry(this->PhaseAsymmetry);
  image->SetReflectance(this->Reflectance);
  image->SetLightVisible(this->LightVisible);
  image->SetAutoExposure(this->AutoExposure);
  image->SetExposure(this->Exposure);
  image->SetToneCurve(this->ToneCurve);
  image->SetSeed(this->Seed);
}

int vtkLightShafts::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const FilterRun run(this, request, inputVector, outputVector);
  std::string error;
  vtkNew<vtkSceneDefaults> defaults;
  if (!run.AreInputsWhole(error) || !AddLights(inputVector[lightPort], defaults, error))
  {
    return run.Fail(error);
  }
  InnerRun inner;
  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputDataObject(0, Borrow(vtkDataObject::GetData(inputVector[0])));
  UpdateInside(occluders, this, 0.0, 0.1, inner);
  if (!inner.IsDone() || occluders->GetOutput()->GetNumberOfCells() == 0)
  {
    return inner.Error.empty() ? 1 : run.Fail(inner.Error);
  }

  defaults->SetUp(this->Up);
  defaults->SetMesh(occluders->GetOutput());
  if (!defaults->Find())
  {
    return run.Fail(defaults->GetError());
  }
  vtkNew<vtkScatteringImageFilter> image;
  vtkNew<vtkAreaLightSource> lamp;
  image->SetInputConnection(occluders->GetOutputPort());
  const int given = inputVector[lightPort]->GetNumberOfInformationObjects();
  for (int k = 0; k < given; ++k)
  {
    image->AddLightData(Borrow(vtkDataObject::GetData(inputVector[lightPort], k)));
  }
  if (given == 0)
  {
    defaults->PlaceLight(lamp);
    image->SetLightConnection(lamp->GetOutputPort());
  }
  this->SetUpImage(defaults, image);
  UpdateInside(image, this, 0.1, 1.0, inner);
  if (!inner.IsDone())
  {
    return inner.Error.empty() ? 1 : run.Fail(inner.Error);
  }

  PlacePicture(image->GetOutput(), image->GetCamera(), vtkPolyData::GetData(outputVector, 0));
  vtkImageData::GetData(outputVector, imageOutput)->ShallowCopy(image->GetOutput());
  if (given == 0)
  {
    vtkPolyData::GetData(outputVector, lampOutput)->ShallowCopy(lamp->GetOutput());
  }
  inner.Said.Say(this);
  return 1;
}

void vtkLightShafts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera << "\n";
  os << indent << "Up: " << this->Up << "\n";
  os << indent << "Resolution: " << Listed(this->Resolution, 2) << "\n";
  os << indent << "RelativeErrorGoal: " << this->RelativeErrorGoal << "\n";
  os << indent << "OpticalDepth: " << this->OpticalDepth << "\n";
  os << indent << "PhaseAsymmetry: " << this->PhaseAsymmetry << "\n";
  os << indent << "MediumBounds: " << Listed(this->MediumBounds, 6) << "\n";
  os << indent << "Reflectance: " << this->Reflectance << "\n";
  os << indent << "LightVisible: " << this->LightVisible << "\n";
  os << indent << "AutoExposure: " << this->AutoExposure << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneCurve: " << this->ToneCurve << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
