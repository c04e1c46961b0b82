// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSceneDefaults.h"

#include "scLightData.h"
#include "scMeshData.h"
#include "scSceneShape.h"
#include "scSentence.h"
#include "vtkAreaLightSource.h"

#include "vtkCamera.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace shadowcones
{

struct FoundScene
{
  SceneShape Shape = LookAtMesh(TriangleMeshView(), {}, -1);
  std::vector<Light> Lights; // given, or the default lamp
  Box Medium = Shape.Bounds;
};

} // namespace shadowcones

vtkStandardNewMacro(vtkSceneDefaults);

vtkSceneDefaults::vtkSceneDefaults()
  : Found(new shadowcones::FoundScene)
{
}

vtkSceneDefaults::~vtkSceneDefaults() = default;

void vtkSceneDefaults::SetMesh(vtkDataObject* mesh)
{
  this->Mesh = mesh;
  this->Modified();
}

void vtkSceneDefaults::AddLight(vtkDataObject* light)
{
  this->Lights.emplace_back(light);
  this->Modified();
}

void vtkSceneDefaults::RemoveAllLights()
{
  this->Lights.clear();
  this->Modified();
}

bool vtkSceneDefaults::Find()
{
  using namespace shadowcones;
  this->Error.clear();
  TriangleMesh mesh;
  std::vector<Light> lights;
  if (this->Up < Automatic || this->Up > Z)
  {
    this->Error = Sentence("Up is ", this->Up, ": it must be 0 (Automatic), 1 (X), 2 (Y) or 3 (Z).");
  }
  else if (this->Mesh)
  {
    ReadTriangles(this->Mesh, mesh, this->Error);
  }
  for (const auto& data : this->Lights)
  {
    Light light;
    if (this->Error.empty() && ReadLight(vtkPolyData::SafeDownCast(data), light, this->Error))
    {
      lights.push_back(light);
    }
  }
  if (!this->Error.empty())
  {
    return false;
  }
  try
  {
    this->Found->Shape = LookAtMesh(mesh.View(), lights, this->Up - 1);
    if (lights.empty())
    {
      lights.push_back(DefaultLamp(this->Found->Shape));
    }
    this->Found->Medium = DefaultMedium(this->Found->Shape, lights);
    this->Found->Lights.swap(lights);
  }
  catch (const std::exception& fault)
  {
    this->Error = Sentence("The mesh cannot be looked at: ", fault.what());
  }
  return this->Error.empty();
}

int vtkSceneDefaults::GetFoundUp()
{
  return this->Found->Shape.Up + 1;
}

bool vtkSceneDefaults::IsRoom()
{
  return this->Found->Shape.Room;
}

void vtkSceneDefaults::PlaceLight(vtkAreaLightSource* light)
{
  const shadowcones::Light lamp = shadowcones::DefaultLamp(this->Found->Shape);
  light->SetShapeToDisc();
  light->SetCenter(lamp.Center.X, lamp.Center.Y, lamp.Center.Z);
  light->SetNormal(lamp.Normal.X, lamp.Normal.Y, lamp.Normal.Z);
  light->SetRadius(lamp.Radius);
  light->SetRadiance(1.0);
}

void vtkSceneDefaults::PlaceCamera(vtkCamera* camera, double aspect)
{
  const double usable = std::isfinite(aspect) && aspect > 0.0 ? aspect : 1.0;
  const shadowcones::CameraPlace place =
    shadowcones::DefaultCamera(this->Found->Shape, this->Found->Lights, usable);
  camera->SetParallelProjection(0);
  camera->SetUseHorizontalViewAngle(0);
  camera->SetPosition(place.Position.X, place.Position.Y, place.Position.Z);
  camera->SetFocalPoint(place.FocalPoint.X, place.FocalPoint.Y, place.FocalPoint.Z);
  camera->SetViewUp(place.ViewUp.X, place.ViewUp.Y, place.ViewUp.Z);
  camera->SetViewAngle(place.ViewAngle);
}

void vtkSceneDefaults::GetMediumBounds(double bounds[6])
{
  const shadowcones::Box& box = this->Found->Medium;
  const double values[6] = { box.Min.X, box.Max.X, box.Min.Y, box.Max.Y, box.Min.Z, box.Max.Z };
  std::copy(values, values + 6, bounds);
}

double vtkSceneDefaults::GetSigmaS()
{
  return shadowcones::DefaultSigmaS(this->Found->Medium);
}

void vtkSceneDefaults::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Up: " << this->Up << "\n";
  os << indent << "NumberOfLights: " << this->Lights.size() << "\n";
  os << indent << "FoundUp: " << this->GetFoundUp() << "\n";
  os << indent << "Room: " << this->IsRoom() << "\n";
  os << indent << "Error: " << this->Error << "\n";
}
