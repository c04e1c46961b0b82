// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkScene.h"

#include "DarkScenes.h"
#include "scConeData.h"
#include "scLightData.h"
#include "scMeshData.h"
#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkSTLReader.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <stdexcept>

namespace shadowcones
{
namespace
{
template <class Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> Read(const std::string& file)
{
  const std::string ending = file.substr(std::min(file.size(), file.find_last_of('.')));
  vtkSmartPointer<vtkPolyData> mesh;
  if (ending == ".vtp")
  {
    mesh = ReadWith<vtkXMLPolyDataReader>(file);
  }
  else if (ending == ".obj")
  {
    mesh = ReadWith<vtkOBJReader>(file);
  }
  else if (ending == ".ply")
  {
    mesh = ReadWith<vtkPLYReader>(file);
  }
  else if (ending == ".stl")
  {
    mesh = ReadWith<vtkSTLReader>(file);
  }
  if (!mesh || mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(
      "No polygons in '" + file + "': give chair, tree, blob, blinds, canopy, holes, colonnade, or a .vtp, .obj, .ply or .stl file.");
  }
  return mesh;
}

/// Three high, centred, on the floor.
vtkSmartPointer<vtkPolyData> StandInRoom(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const double scale = 3.0 / (bounds[3] - bounds[2]);
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  transform->Translate(-0.5 * (bounds[0] + bounds[1]), -bounds[2], -0.5 * (bounds[4] + bounds[5]));
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

/// Set the parameters that tuning chose, so that the filter fits again without tuning.
void UseChosen(vtkConeSetFilter* filter)
{
  vtkSmartPointer<vtkFieldData> chosen = filter->GetOutput()->GetFieldData();
  const auto value = [&](const char* name) { return chosen->GetArray(name)->GetComponent(0, 0); };
  filter->SetTuningToManual();
  filter->SetNumberOfNeighbors(static_cast<int>(value("NumberOfNeighbors")));
  filter->SetPointsPerRing(static_cast<int>(value("PointsPerRing")));
  filter->SetMinimumVectorsPerCone(static_cast<int>(value("MinimumVectorsPerCone")));
  filter->SetVarianceThreshold(value("VarianceThreshold"));
  filter->SetCosineCorrection(value("CosineCorrection") != 0.0);
  filter->SetExpansion(static_cast<int>(value("Expansion")));
  filter->SetExpansionFraction(value("ExpansionFraction"));
  filter->SetRadiusScale(value("RadiusScale"));
  filter->SetMaximumOverspill(value("MaximumOverspill"));
  filter->SetOverlap(value("Overlap") != 0.0);
}
} // namespace

//------------------------------------------------------------------------------
double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

//------------------------------------------------------------------------------
ConeParameters NamedParameters(const std::string& set)
{
  ConeParameters parameters;
  parameters.Set = set;
  if (set == "paper")
  {
    parameters.Storage = 0;
    parameters.Variance = 1.6;
    parameters.Planarity = 0.0;
    parameters.Expansion = 0;
    parameters.Cosine = true;
    parameters.Overlap = false;
  }
  else if (set == "conservative" || set == "preview" || set == "soft")
  {
    parameters.Tuning = set == "conservative" ? 1 : set == "preview" ? 2 : 3;
  }
  else if (set != "bounds")
  {
    throw std::runtime_error("No parameter set '" + set + "': give paper, bounds, conservative, preview or soft.");
  }
  return parameters;
}

//------------------------------------------------------------------------------
std::string Describe(const ConeParameters& parameters)
{
  static const char* const expansions[3] = { "max", "ratio", "light" };
  std::ostringstream text;
  if (parameters.Tuning != 0)
  {
    text << parameters.Set << ' ' << (parameters.Storage ? "hit" : "back") << " seed=" << parameters.Seed;
    return text.str();
  }
  text << parameters.Set << ' ' << (parameters.Storage ? "hit" : "back") << " p=" << parameters.P1 << ','
       << parameters.P2 << ',' << parameters.P3 << ',' << parameters.P4 << " t=" << parameters.Variance
       << " flat=" << parameters.Planarity << ' ' << expansions[parameters.Expansion] << '*' << parameters.Fraction
       << (parameters.Cosine ? " cos" : "") << (parameters.Overlap ? " overlap" : "") << " seed=" << parameters.Seed;
  return text.str();
}

//------------------------------------------------------------------------------
ConesOfScene MakeCones(const VectorsOfScene& vectors, const ConeParameters& parameters)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(vectors.Vectors);
  filter->SetPhotonPathData(vectors.Paths);
  filter->SetNumberOfNeighbors(parameters.P1);
  filter->SetNumberOfSectors(parameters.P2);
  filter->SetPointsPerRing(parameters.P3);
  filter->SetMinimumVectorsPerCone(parameters.P4);
  filter->SetVarianceThreshold(parameters.Variance);
  filter->SetPlanarityThreshold(parameters.Planarity);
  filter->SetExpansion(parameters.Expansion);
  filter->SetExpansionFraction(parameters.Fraction);
  filter->SetCosineCorrection(parameters.Cosine);
  filter->SetOverlap(parameters.Overlap);
  ConesOfScene result;
  if (parameters.Tuning != 0)
  {
    filter->SetTuning(parameters.Tuning);
    const double tuningStart = Now();
    filter->Update();
    result.TuningSeconds = Now() - tuningStart;
    UseChosen(filter);
  }
  const double start = Now();
  filter->Update();
  result.Seconds = Now() - start;
  result.TuningSeconds = std::max(0.0, result.TuningSeconds - result.Seconds);
  std::string error;
  if (!ReadConeSet(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), result.Cones, error))
  {
    throw std::runtime_error(error);
  }
  vtkPolyData* labelled = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  vtkDataArray* ids = labelled->GetPointData()->GetArray("ConeId");
  if (!ids || ids->GetNumberOfTuples() == 0)
  {
    throw std::runtime_error("The cone set filter gave no labelled vectors.");
  }
  vtkIdType discarded = 0;
  for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
  {
    discarded += ids->GetTuple1(k) < 0.0;
  }
  result.Discarded = static_cast<double>(discarded) / ids->GetNumberOfTuples();
  return result;
}

//------------------------------------------------------------------------------
BenchmarkScene::BenchmarkScene(const std::string& nameOrFile, const RoomLamp& lamp)
{
  const bool dark = IsDarkScene(nameOrFile);
  const DarkScene own = dark ? MakeDarkScene(nameOrFile) : DarkScene();
  const bool named = dark || nameOrFile == "chair" || nameOrFile == "tree" || nameOrFile == "blob";
  vtkSmartPointer<vtkPolyData> mesh = dark ? own.Mesh
    : named                                ? Read(SHADOWCONES_DATA_DIR "/" + nameOrFile + ".vtp") : StandInRoom(Read(nameOrFile));
  this->Name = named ? nameOrFile : nameOrFile.substr(nameOrFile.find_last_of('/') + 1);
  vtkNew<vtkLabelOccluders> label;
  label->SetInputData(mesh);
  label->Update();
  this->Occluders = label->GetOutput();

  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(lamp.Center.X, lamp.Center.Y, lamp.Center.Z);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(lamp.Radius);
  light->SetRadiance(1.0);
  light->Update();
  this->LightData = dark ? own.Light.Get() : light->GetOutput();

  std::string error;
  if (!ReadLight(this->LightData, this->Light, error) || !ReadTriangles(this->Occluders, this->Mesh, error))
  {
    throw std::runtime_error(error);
  }
  this->Fast = std::make_unique<OccluderScene>(this->Mesh.View());
  if (dark)
  {
    this->Medium = own.Medium;
    this->Medium.SigmaS.resize(this->Light.Spectrum.size(), own.Medium.SigmaS.front());
    this->Medium.SigmaA.resize(this->Light.Spectrum.size(), own.Medium.SigmaA.front());
    this->Camera = own.Camera;
    this->Room = this->Mesh;
    this->Reflectance.assign(this->Room.Triangles.size() / 3 * this->Light.Spectrum.size(), 0.5f);
    return;
  }
  this->Medium = testsupport::RoomMedium(this->Light.Spectrum.size());
  this->Camera = testsupport::RoomCamera();
  this->AddWalls();
}

//------------------------------------------------------------------------------
void BenchmarkScene::AddWalls()
{
  const vtkSmartPointer<vtkPolyData> data = Read(SHADOWCONES_DATA_DIR "/cornell-box.vtp");
  TriangleMesh walls;
  std::string error;
  if (!ReadTriangles(data, walls, error))
  {
    throw std::runtime_error(error);
  }
  const std::size_t wavelengths = this->Light.Spectrum.size();
  TriangleMesh& room = this->Room;
  room = this->Mesh;
  room.OccluderIds.resize(room.Triangles.size() / 3, 0);
  this->Reflectance.assign(room.OccluderIds.size() * wavelengths, 0.5f);
  const auto offset = static_cast<vtkIdType>(room.Points.size() / 3);
  room.Points.insert(room.Points.end(), walls.Points.begin(), walls.Points.end());
  for (const vtkIdType id : walls.Triangles)
  {
    room.Triangles.push_back(id + offset);
  }
  room.OccluderIds.resize(room.Triangles.size() / 3, -1);
  vtkDataArray* reflectance = data->GetCellData()->GetArray("Reflectance");
  for (const vtkIdType cell : walls.SourceCells)
  {
    for (std::size_t k = 0; k < wavelengths; ++k)
    {
      this->Reflectance.push_back(static_cast<float>(reflectance->GetComponent(cell, static_cast<int>(k))));
    }
  }
}

//------------------------------------------------------------------------------
VectorsOfScene BenchmarkScene::MakeVectors(const ConeParameters& parameters) const
{
  vtkNew<vtkShadowVectorFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(this->Occluders);
  filter->SetLightData(this->LightData);
  filter->SetTargetNumberOfVectors(parameters.Vectors);
  filter->SetSeed(parameters.Seed);
  filter->SetStorage(parameters.Storage);
  const double start = Now();
  filter->Update();
  VectorsOfScene result;
  result.Seconds = Now() - start;
  result.Vectors = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  result.Paths = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  return result;
}

//------------------------------------------------------------------------------
void BenchmarkScene::TraceVectors(vtkIdType vectors)
{
  ConeParameters parameters = NamedParameters("bounds");
  parameters.Vectors = vectors > 0 ? vectors : this->Name == "tree" ? 20000 : 5800;
  this->Traced = this->MakeVectors(parameters);
}

//------------------------------------------------------------------------------
VisibilityGrid BenchmarkScene::FillGrid(int dimensions, int lightSamples, int brickParts) const
{
  VisibilityGridOptions options;
  options.Dimensions = { dimensions, dimensions, dimensions };
  options.NumberOfLightSamples = lightSamples;
  options.BrickParts = brickParts;
  VisibilityGrid grid;
  FillVisibilityGrid(this->Fitted.Cones, this->Light, this->Fast.get(), this->Medium.Bounds, options, Monitor(), grid);
  return grid;
}

//------------------------------------------------------------------------------
ScatteringOptions BenchmarkScene::Options(ScatteringMode mode, int size) const
{
  ScatteringOptions options;
  options.Mode = mode;
  options.Width = size;
  options.Height = size;
  options.Extent = { 0, size - 1, 0, size - 1 };
  options.NumberOfSurfaceLightSamples = 0;
  options.NumberOfEdgeSamples = 1;
  options.LightVisible = false;
  return options;
}

//------------------------------------------------------------------------------
vtkIdType BenchmarkScene::NumberOfPhotons() const
{
  vtkDataArray* photons = this->Traced.Vectors->GetFieldData()->GetArray("NumberOfPhotons");
  return photons ? static_cast<vtkIdType>(photons->GetTuple1(0)) : 0;
}

} // namespace shadowcones
