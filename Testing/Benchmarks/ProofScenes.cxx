// SPDX-License-Identifier: BSD-3-Clause
#include "ProofScenes.h"

#include "BenchmarkScene.h"
#include "RealMeshes.h"
#include "TestMeshes.h"
#include "TestPolyData.h"

#include "scConeData.h"
#include "scLightData.h"
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPlaneSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shadowcones
{
namespace
{
using testsupport::Model;
using testsupport::TestMesh;

const char* const bodies[] = { "chair", "tree", "blob", "bunny", "horse", "cat", "slats", "cube" };
const char* const others[] = { "lamp in a box", "lamps and wall", "ring", "dome", "cable", "sign and hall", "two houses" };
const char* const lightNames[] = { "disc", "rectangle", "sphere", "point", "sun", "mesh" };

const char* ModelOf(const std::string& name)
{
  return name == "bunny" ? "bunny.obj" : name == "horse" ? "horse.3ds" : name == "cat" ? "cat.3ds" : nullptr;
}

/// Three high, centred, on the floor.
vtkSmartPointer<vtkPolyData> StandInRoom(vtkPolyData* mesh)
{
  double b[6];
  mesh->GetBounds(b);
  const double scale = 3.0 / (b[3] - b[2]);
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->Translate(-0.5 * (b[0] + b[1]), -b[2], -0.5 * (b[4] + b[5]));
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> ReadModel(const char* file)
{
  const std::string path = Model(file);
  if (path.empty())
  {
    throw std::runtime_error(std::string(file) + " is not installed: it comes with Debian's glmark2-data");
  }
  if (path.substr(path.size() - 4) == ".3ds")
  {
    return testsupport::Import3DS(path);
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// A ring of sheets around the room's lamp.
TestMesh Ring()
{
  TestMesh mesh;
  constexpr int sheets = 48;
  const auto at = [](int k)
  {
    const double angle = 2.0 * testsupport::Pi * k / sheets;
    return Vector3{ 1.5 * std::cos(angle), 4.0, 1.5 * std::sin(angle) };
  };
  for (int k = 0; k < sheets; ++k)
  {
    mesh.AddSheet(at(k), at(k + 1) - at(k), { 0.0, 1.0, 0.0 }, 0);
  }
  return mesh;
}

TestMesh MadeMesh(const std::string& name)
{
  TestMesh mesh;
  if (name == "slats")
  {
    for (int k = 0; k < 7; ++k)
    {
      mesh.AddBox({ -1.5 + 0.45 * k, 2.9, -1.5 }, { -1.25 + 0.45 * k, 2.93, 1.5 }, k);
    }
  }
  else if (name == "cube")
  {
    mesh.AddBox({ -0.75, 0.0, -0.75 }, { 0.75, 1.5, 0.75 }, 0);
  }
  else if (name == "lamps and wall")
  {
    mesh.AddSheet({ 0.0, 0.0, -2.0 }, { 0.0, 0.0, 4.0 }, { 0.0, 3.0, 0.0 }, 0);
  }
  else if (name == "ring")
  {
    mesh = Ring();
  }
  else if (name == "dome")
  {
    mesh.AddSphere({ 0.0, 5.4, 0.0 }, 1.5, 24, 0);
  }
  else if (name == "cable")
  {
    mesh.AddBox({ -50.0, 2.0, -0.05 }, { 50.0, 2.1, 0.05 }, 0);
  }
  else if (name == "sign and hall")
  {
    mesh.AddBox({ 0.0, 0.0, 0.0 }, { 100.0, 20.0, 50.0 }, 0);
    mesh.AddBox({ 110.0, 2.0, 10.0 }, { 110.05, 2.5, 10.5 }, 1);
  }
  else if (name == "two houses")
  {
    mesh.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 8.0, 10.0 }, 0);
    mesh.AddBox({ 10000.0, 0.0, 0.0 }, { 10010.0, 8.0, 10.0 }, 1);
  }
  else
  {
    throw std::runtime_error("There is no scene '" + name + "'.");
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> MeshOf(const std::string& name)
{
  if (name == "chair" || name == "tree" || name == "blob")
  {
    return testsupport::ReadData(name + ".vtp");
  }
  if (name == "lamp in a box")
  {
    const auto walls = testsupport::ReadData("cornell-box.vtp");
    walls->GetCellData()->RemoveArray("OccluderId"); // here they cast shadows
    return walls;
  }
  return ModelOf(name) ? StandInRoom(ReadModel(ModelOf(name))) : testsupport::ToPolyData(MadeMesh(name));
}

/// The light of a name, where the room has its lamp.
vtkSmartPointer<vtkPolyData> NamedLight(const std::string& name)
{
  vtkNew<vtkAreaLightSource> lamp;
  lamp->SetCenter(0.0, 5.4, 0.0);
  lamp->SetNormal(0.0, -1.0, 0.0);
  lamp->SetRadius(0.5);
  if (name == "rectangle")
  {
    lamp->SetShapeToRectangle();
    lamp->SetWidth(1.2);
    lamp->SetHeight(0.6);
  }
  else if (name == "sphere")
  {
    lamp->SetShapeToSphere();
    lamp->SetRadius(0.3);
  }
  else if (name == "point")
  {
    lamp->SetShapeToPoint();
  }
  else if (name == "sun")
  {
    lamp->SetShapeToSun();
    lamp->SetNormal(0.5, -1.0, 0.3);
  }
  else if (name == "mesh")
  {
    vtkNew<vtkPlaneSource> plane; // 4 x 4 tilted faces, no exact shape
    plane->SetOrigin(-0.5, 5.3, -0.4);
    plane->SetPoint1(0.5, 5.4, -0.4);
    plane->SetPoint2(-0.5, 5.3, 0.4);
    plane->SetXResolution(4);
    plane->SetYResolution(4);
    plane->Update();
    return plane->GetOutput();
  }
  else if (name != "disc")
  {
    throw std::runtime_error("There is no light '" + name + "'.");
  }
  lamp->Update();
  return lamp->GetOutput();
}

/// Two lamps, each of which shines towards the wall between them.
vtkSmartPointer<vtkPolyData> LampsBesideTheWall()
{
  TestMesh lamps;
  lamps.AddSheet({ -2.0, 1.5, -0.4 }, { 0.0, 0.8, 0.0 }, { 0.0, 0.0, 0.8 });
  lamps.AddSheet({ 2.0, 1.5, -0.4 }, { 0.0, 0.0, 0.8 }, { 0.0, 0.8, 0.0 });
  lamps.OccluderIds.clear();
  return testsupport::ToPolyData(lamps);
}

std::string OwnLight(const std::string& name)
{
  return name == "lamps and wall" ? "two lamps" : name == "sign and hall" || name == "two houses" ? "sun" : "disc";
}

Box RegionOf(const ProofScene& scene)
{
  const bool inRoom = std::find(std::begin(bodies), std::end(bodies), scene.Name) != std::end(bodies);
  // Ten kilometres of air hold next to no shadow.
  const Box casters = scene.Name == "two houses" ? Box{ {}, { 10.0, 8.0, 10.0 } } : CasterBounds(scene.Mesh.View());
  const double margin = 0.5 * casters.Diagonal();
  const Vector3 around{ margin, margin, margin };
  return inRoom ? RoomBounds() : Box{ casters.Min - around, casters.Max + around };
}
} // anonymous namespace

std::vector<std::string> ProofSceneNames()
{
  std::vector<std::string> names;
  for (const char* name : bodies)
  {
    if (!ModelOf(name) || !Model(ModelOf(name)).empty())
    {
      names.push_back(name);
    }
  }
  names.insert(names.end(), std::begin(others), std::end(others));
  return names;
}

std::vector<std::string> ProofLightNames()
{
  return { std::begin(lightNames), std::end(lightNames) };
}

ProofScene MakeProofScene(const std::string& name, const std::string& light)
{
  ProofScene scene;
  scene.Name = name;
  scene.LightName = light.empty() ? OwnLight(name) : light;
  vtkNew<vtkLabelOccluders> label;
  label->SetInputData(MeshOf(name));
  label->Update();
  scene.Occluders = label->GetOutput();
  scene.LightData = scene.LightName == "two lamps" ? LampsBesideTheWall() : NamedLight(scene.LightName);
  std::string error;
  if (!ReadLight(scene.LightData, scene.Light, error) || !ReadTriangles(scene.Occluders, scene.Mesh, error))
  {
    throw std::runtime_error(name + ": " + error);
  }
  scene.Region = RegionOf(scene);
  return scene;
}

ProofSceneCones MakeCones(const ProofScene& scene, vtkIdType vectors, const ConesOfProof& how)
{
  vtkNew<vtkShadowVectorFilter> tracer;
  tracer->SetInputData(scene.Occluders);
  tracer->SetLightData(scene.LightData);
  tracer->SetTargetNumberOfVectors(vectors);
  vtkNew<vtkConeSetFilter> filter;
  filter->SetInputConnection(tracer->GetOutputPort());
  filter->SetTuning(how.Tuning);
  if (how.Paths)
  {
    filter->SetPhotonPathConnection(tracer->GetOutputPort(1));
  }
  if (how.Proved)
  {
    filter->SetMeshData(scene.Occluders);
    filter->SetLightData(scene.LightData);
  }
  const double start = Now();
  filter->Update();
  ProofSceneCones result;
  result.Seconds = Now() - start;
  vtkPolyData* output = filter->GetOutput();
  vtkFieldData* field = output->GetFieldData();
  std::string error;
  if (!ReadConeSet(output, result.Cones, error) || !field->GetAbstractArray("TuningChoice"))
  {
    throw std::runtime_error(scene.Name + ": no cones. " + error);
  }
  result.CertifiedBounds = ReadCertifiedBounds(field);
  result.Certified = field->GetArray("Certified")->GetComponent(0, 0) != 0.0;
  result.Choice = field->GetAbstractArray("TuningChoice")->GetVariantValue(0).ToString();
  return result;
}

} // namespace shadowcones
