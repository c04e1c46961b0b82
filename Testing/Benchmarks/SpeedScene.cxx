// SPDX-License-Identifier: BSD-3-Clause
#include "SpeedScene.h"

#include "scLightData.h"
#include "vtkAreaLightSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <stdexcept>

namespace shadowcones
{
namespace
{
void UseLight(const DiscLight& disc, BenchmarkScene& scene)
{
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(disc.Center.X, disc.Center.Y, disc.Center.Z);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(disc.Radius);
  light->SetRadiance(1.0);
  light->Update();
  scene.LightData = light->GetOutput();
  std::string error;
  if (!ReadLight(scene.LightData, scene.Source, error))
  {
    throw std::runtime_error(error);
  }
}
} // namespace

//------------------------------------------------------------------------------
SpeedScene::SpeedScene(const std::string& nameOrFile, const DiscLight& light, vtkIdType vectors)
  : Scene(LoadBenchmarkScene(nameOrFile))
  , Eye(RoomCamera())
  , Parameters(NamedParameters("bounds"))
{
  UseLight(light, this->Scene);
  this->Surroundings = BuildRoom(this->Scene, this->Scene.Source.Spectrum.size());
  this->Fog = RoomMedium(this->Scene.Source);
  this->Parameters.Vectors = vectors > 0 ? vectors : nameOrFile == "tree" ? 20000 : 5800;
}

//------------------------------------------------------------------------------
void SpeedScene::BuildOccluders()
{
  this->Occluders = std::make_unique<OccluderScene>(this->Surroundings.Mesh.View());
}

//------------------------------------------------------------------------------
void SpeedScene::TraceVectors()
{
  this->Traced = MakeVectors(this->Scene, this->Parameters);
}

//------------------------------------------------------------------------------
void SpeedScene::FitCones()
{
  this->Fitted = MakeCones(this->Traced, this->Parameters);
}

//------------------------------------------------------------------------------
void SpeedScene::BuildHierarchy()
{
  this->Tree = std::make_unique<ConeHierarchy>(this->Fitted.Cones, this->Fog.Bounds);
}

//------------------------------------------------------------------------------
VisibilityGrid SpeedScene::FillGrid(int dimensions, int lightSamples, int brickParts) const
{
  VisibilityGridOptions options;
  options.Dimensions = { dimensions, dimensions, dimensions };
  options.NumberOfLightSamples = lightSamples;
  options.BrickParts = brickParts;
  VisibilityGrid grid;
  FillVisibilityGrid(
    this->Fitted.Cones, this->Scene.Source, this->Scene.Fast.get(), this->Fog.Bounds, options, Monitor(), grid);
  return grid;
}

//------------------------------------------------------------------------------
ScatteringOptions SpeedScene::Options(ScatteringMode mode, int size) const
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
void SpeedScene::Render(const ScatteringOptions& options, const ConeHierarchy* cones, const VisibilityGrid* grid,
  ScatteringImage& image) const
{
  RenderScattering(this->View(cones, grid), options, Monitor(), image);
}

//------------------------------------------------------------------------------
vtkIdType SpeedScene::NumberOfVectors() const
{
  return this->Traced.Vectors->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
vtkIdType SpeedScene::NumberOfPhotons() const
{
  vtkDataArray* photons = this->Traced.Vectors->GetFieldData()->GetArray("NumberOfPhotons");
  return photons ? static_cast<vtkIdType>(photons->GetTuple1(0)) : 0;
}

} // namespace shadowcones
