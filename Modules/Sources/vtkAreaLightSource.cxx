// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightSource.h"

#include "scFieldArrays.h"
#include "scGuardedRequest.h"
#include "scLightData.h"
#include "scParameterRanges.h"
#include "scSentence.h"
#include "scSpectrum.h"
#include "scSpectrumSamples.h"

#include "scFrame.h"
#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace
{

using namespace shadowcones;

vtkIdType InsertPoint(vtkPoints* points, const Vector3& p)
{
  return points->InsertNextPoint(p.X, p.Y, p.Z);
}

// The part of up in the plane of the unit normal; another axis where nothing is left of it.
Vector3 InPlaneUp(const Vector3& normal, const Vector3& up)
{
  const Vector3 unit = Normalized(up);
  const Vector3 inPlane = unit - Dot(unit, normal) * normal;
  if (Length(inPlane) > 1e-6)
  {
    return Normalized(inPlane);
  }
  const double x = std::fabs(normal.X);
  const double y = std::fabs(normal.Y);
  const double z = std::fabs(normal.Z);
  const Vector3 axis = x <= y && x <= z ? Vector3{ 1.0, 0.0, 0.0 }
    : y <= z                            ? Vector3{ 0.0, 1.0, 0.0 }
                                        : Vector3{ 0.0, 0.0, 1.0 };
  return Normalized(axis - Dot(axis, normal) * normal);
}

void TessellateDisc(const Light& light, int resolution, vtkPoints* points, vtkCellArray* polygons)
{
  const Frame frame = FrameAround(light.Normal);
  polygons->InsertNextCell(resolution);
  for (int i = 0; i < resolution; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / resolution;
    polygons->InsertCellPoint(InsertPoint(
      points, light.Center + (light.Radius * std::cos(angle)) * frame.U + (light.Radius * std::sin(angle)) * frame.V));
  }
}

void TessellateRectangle(const Light& light, vtkPoints* points, vtkCellArray* polygons)
{
  const Vector3& u = light.AxisU;
  const Vector3& v = light.AxisV;
  polygons->InsertNextCell(4);
  for (const Vector3& corner : { -u - v, u - v, u + v, v - u })
  {
    polygons->InsertCellPoint(InsertPoint(points, light.Center + corner));
  }
}

void TessellateSphere(const Light& light, int resolution, vtkPoints* points, vtkCellArray* polygons)
{
  const int rings = resolution / 2 + 1; // from pole to pole
  const vtkIdType north = InsertPoint(points, light.Center + Vector3{ 0.0, 0.0, light.Radius });
  const vtkIdType south = InsertPoint(points, light.Center - Vector3{ 0.0, 0.0, light.Radius });
  const auto id = [&](int ring, int i) -> vtkIdType
  { return 2 + static_cast<vtkIdType>(ring - 1) * resolution + i % resolution; };
  for (int ring = 1; ring < rings; ++ring)
  {
    const double polar = vtkMath::Pi() * ring / rings;
    for (int i = 0; i < resolution; ++i)
    {
      const double azimuth = 2.0 * vtkMath::Pi() * i / resolution;
      const Vector3 normal{ std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar) };
      InsertPoint(points, light.Center + light.Radius * normal);
    }
  }
  for (int i = 0; i < resolution; ++i)
  {
    polygons->InsertNextCell({ north, id(1, i), id(1, i + 1) });
    for (int ring = 1; ring + 1 < rings; ++ring)
    {
      polygons->InsertNextCell({ id(ring, i), id(ring + 1, i), id(ring + 1, i + 1), id(ring, i + 1) });
    }
    polygons->InsertNextCell({ south, id(rings - 1, i + 1), id(rings - 1, i) });
  }
}

/// The mesh that shows a light with a place.
void WriteMesh(const Light& light, int resolution, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  switch (light.Shape)
  {
    case LightShape::Disc:
      TessellateDisc(light, resolution, points, cells);
      break;
    case LightShape::Rectangle:
      TessellateRectangle(light, points, cells);
      break;
    case LightShape::Sphere:
      TessellateSphere(light, resolution, points, cells);
      break;
    default:
      cells->InsertNextCell({ InsertPoint(points, light.Center) });
      break;
  }
  output->SetPoints(points);
  if (light.Shape == LightShape::Point)
  {
    output->SetVerts(cells);
  }
  else
  {
    output->SetPolys(cells);
  }
}

} // namespace

vtkStandardNewMacro(vtkAreaLightSource);
scDefineGuardedRequests(vtkAreaLightSource);

vtkAreaLightSource::vtkAreaLightSource()
{
  this->SetNumberOfInputPorts(0);
}

scDefineSpectrum(vtkAreaLightSource, Radiance);

int vtkAreaLightSource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // Every piece needs the whole light.
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

std::string vtkAreaLightSource::CheckParameters() const
{
  std::string fault =
    FirstOutOfRange({ OneOf("Shape", this->Shape, { "Disc", "Rectangle", "Sphere", "Point", "Sun" }),
      InRange("NumberOfWavelengths", this->NumberOfWavelengths, 1, 1000),
      InRange("Resolution", this->Resolution, 3, 4096) });
  const auto areFinite = [](const double* x) { return IsFinite({ x[0], x[1], x[2] }); };
  const auto isSize = [](double x) { return std::isfinite(x) && x > 0.0; };
  if (!fault.empty())
  {
    return fault;
  }
  if (!areFinite(this->Center))
  {
    return "Center must be finite.";
  }
  if (this->Shape == Rectangle && !(isSize(this->Width) && isSize(this->Height)))
  {
    return Sentence(
      "Width and Height must be finite and larger than 0; they are ", this->Width, " and ", this->Height, ".");
  }
  return this->Shape == Rectangle && !areFinite(this->Up) ? "Up must be finite." : "";
}

bool vtkAreaLightSource::MakeLight(Light& light, std::string& error) const
{
  light.Shape = static_cast<LightShape>(this->Shape);
  light.Center = { this->Center[0], this->Center[1], this->Center[2] };
  light.Normal = Normalized({ this->Normal[0], this->Normal[1], this->Normal[2] });
  light.Radius = this->Shape == Sun ? vtkMath::RadiansFromDegrees(0.5 * this->AngularDiameter) : this->Radius;
  if (this->Shape == Rectangle)
  {
    const Vector3 upward = InPlaneUp(light.Normal, { this->Up[0], this->Up[1], this->Up[2] });
    light.AxisU = 0.5 * this->Width * Cross(upward, light.Normal);
    light.AxisV = 0.5 * this->Height * upward;
  }
  if (!ReadSpectrum(
        "Radiance", this->RadianceSpectrum, this->Radiance, this->NumberOfWavelengths, light.Spectrum, error))
  {
    return false;
  }
  const char* const fault = PrepareLight(light);
  error = fault ? fault : "";
  return error.empty();
}

int vtkAreaLightSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  std::string error = this->CheckParameters();
  Light light;
  if (!error.empty() || !this->MakeLight(light, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  if (this->Shape == Sun)
  {
    WriteSun(light, output);
  }
  else
  {
    WriteMesh(light, this->Resolution, output);
    WriteLightFieldData(light, output);
  }
  AddDoubleArray(output->GetFieldData(), "LightWavelengths", 1, DefaultWavelengths(this->NumberOfWavelengths));
  return 1;
}

void vtkAreaLightSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Center: " << Listed(this->Center, 3) << "\n";
  os << indent << "Normal: " << Listed(this->Normal, 3) << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Up: " << Listed(this->Up, 3) << "\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
  os << indent << "Radiance: " << this->Radiance << "\n";
  os << indent << "RadianceSpectrum: " << TextOf(this->RadianceSpectrum) << "\n";
  os << indent << "NumberOfWavelengths: " << this->NumberOfWavelengths << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
