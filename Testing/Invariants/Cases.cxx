// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

#include "TestPolyData.h"

#include "scFieldArrays.h"
#include "vtkAreaLightSource.h"
#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkLightShafts.h"
#include "vtkPenumbraWidth.h"
#include "vtkPhotonMapFilter.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowFootprints.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"
#include "vtkSunHours.h"
#include "vtkSunPath.h"
#include "vtkToneMapRadiance.h"
#include "vtkVisibilityVolume.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace invariants
{
namespace
{

using namespace shadowcones::testsupport;

/// Copy of an output, without its pipeline.
vtkSmartPointer<vtkPolyData> Take(vtkAlgorithm* filter, int port = 0)
{
  filter->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutputDataObject(port));
  return copy;
}

/// The chair with its labels, in the room whose walls receive.
vtkPolyData* Room()
{
  static const vtkSmartPointer<vtkPolyData> room = [] {
    vtkNew<vtkAppendPolyData> append;
    const auto chair = LabelledMesh(ReadData("chair.vtp"));
    const auto walls = ReadData("cornell-box.vtp");
    append->AddInputData(chair);
    append->AddInputData(walls);
    return Take(append);
  }();
  return room;
}

vtkPolyData* Lamp()
{
  static const vtkSmartPointer<vtkPolyData> lamp = RoomLamp();
  return lamp;
}

/// Shadow vectors (output 0) and photon paths (output 1) in the room.
vtkPolyData* Vectors(vtkIdType target, int output)
{
  static std::map<std::pair<vtkIdType, int>, vtkSmartPointer<vtkPolyData>> made;
  auto& data = made[{ target, output }];
  if (!data)
  {
    vtkNew<vtkShadowVectorFilter> filter;
    filter->SetToPaper();
    filter->SetInputData(Room());
    filter->SetLightData(Lamp());
    filter->SetTargetNumberOfVectors(target);
    data = Take(filter, output);
  }
  return data;
}

vtkPolyData* Cones();

/// Two lamps as blocks of one input: that of the room, and a panel beside it.
vtkSmartPointer<vtkMultiBlockDataSet> TwoLamps()
{
  vtkNew<vtkAreaLightSource> panel;
  panel->SetShapeToRectangle();
  panel->SetCenter(1.5, 5.3, -0.4);
  panel->SetNormal(-0.2, -1.0, 0.0);
  panel->SetWidth(0.8);
  panel->SetHeight(0.3);
  panel->SetRadiance(40.0);
  auto lamps = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  lamps->SetBlock(0, Lamp());
  lamps->SetBlock(1, Take(panel));
  return lamps;
}

/// Shadow vectors (output 0) and photon paths (output 1) of two lamps in the room.
vtkPolyData* VectorsOfTwo(int output)
{
  static const vtkSmartPointer<vtkShadowVectorFilter> made = [] {
    auto filter = vtkSmartPointer<vtkShadowVectorFilter>::New();
    filter->SetInputData(Room());
    filter->SetLightData(TwoLamps());
    filter->SetTargetNumberOfVectors(1500);
    filter->Update();
    return filter;
  }();
  return made->GetOutput(output);
}

vtkPolyData* ConesOfTwo()
{
  static const vtkSmartPointer<vtkPolyData> cones = [] {
    vtkNew<vtkConeSetFilter> filter;
    filter->SetInputData(VectorsOfTwo(0));
    filter->SetOverlap(true);
    filter->SetExpansionToLightGeometry();
    return Take(filter);
  }();
  return cones;
}

/// The same with two lamps and their cones, and what was made from them.
Setting OfTwoLamps(Setting setting)
{
  for (auto& [port, data] : setting.Inputs)
  {
    if (data == Lamp())
    {
      data = TwoLamps();
    }
    else if (data == Cones())
    {
      data = ConesOfTwo();
    }
  }
  return setting;
}

vtkPolyData* Cones()
{
  static const vtkSmartPointer<vtkPolyData> cones = [] {
    vtkNew<vtkConeSetFilter> filter;
    filter->SetToPaper();
    filter->SetInputData(Vectors(3000, 0));
    filter->SetOverlap(true);
    filter->SetExpansionToLightGeometry();
    return Take(filter);
  }();
  return cones;
}

/// More cones than any scene has.
vtkSmartPointer<vtkPolyData> ManyCones(int count)
{
  std::vector<shadowcones::Cone> cones(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    shadowcones::Cone& cone = cones[static_cast<std::size_t>(i)];
    cone.Center = { 0.1 * (i % 100), 0.1 * (i / 100 % 100), 0.1 * (i / 10000) };
    cone.Axis = shadowcones::Normalized({ 0.2 * std::sin(i), 0.2 * std::cos(i), -1.0 });
    cone.Normal = cone.Axis;
    cone.BaseRadius = 0.05;
    cone.HalfAngle = 0.1 * std::sin(0.1 * i);
    cone.OccluderId = i % 7;
  }
  return ConeSetOf(cones);
}

Setting AreaLight(Size)
{
  auto source = vtkSmartPointer<vtkAreaLightSource>::New();
  source->SetShapeToSphere();
  return { source, {} };
}

Setting SunPath(Size)
{
  auto source = vtkSmartPointer<vtkSunPath>::New();
  source->SetStart("2024-06-21T12:00:00Z");
  return { source, {} };
}

Setting LabelOccluders(Size size)
{
  auto filter = vtkSmartPointer<vtkLabelOccluders>::New();
  if (size == Size::Small)
  {
    return { filter, { { 0, ReadData("tree.vtp") } } };
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(700);
  sphere->SetPhiResolution(700);
  return { filter, { { 0, Take(sphere) } } };
}

Setting ShadowVectors(Size size, bool target, bool hitPoint)
{
  auto filter = vtkSmartPointer<vtkShadowVectorFilter>::New();
  filter->SetToPaper();
  filter->SetStorage(hitPoint ? vtkShadowVectorFilter::HitPoint : vtkShadowVectorFilter::BackSide);
  const vtkIdType count = size == Size::Small ? 40000 : 1000000;
  filter->SetNumberOfPhotons(count);
  filter->SetTargetNumberOfVectors(target ? count / 4 : 0);
  return { filter, { { 0, Room() }, { 1, Lamp() } } };
}

Setting ConeSet(Size size, bool overlap, bool paths)
{
  auto filter = vtkSmartPointer<vtkConeSetFilter>::New();
  filter->SetToPaper();
  filter->SetOverlap(overlap);
  const vtkIdType count = size == Size::Small ? 3000 : 60000;
  Setting setting{ filter, { { 0, Vectors(count, 0) } } };
  if (paths)
  {
    setting.Inputs.emplace_back(1, Vectors(count, 1));
  }
  return setting;
}

/// Tuning fits some forty cone sets: few vectors are enough.
Setting ConeSetTuned(Size size, int tuning)
{
  auto filter = vtkSmartPointer<vtkConeSetFilter>::New();
  filter->SetToPaper();
  filter->SetTuning(tuning);
  const vtkIdType count = size == Size::Small ? 500 : 60000;
  return { filter, { { 0, Vectors(count, 0) }, { 1, Vectors(count, 1) } } };
}

Setting ConeSetGeometry(Size size)
{
  auto filter = vtkSmartPointer<vtkConeSetGeometry>::New();
  filter->SetResolution(size == Size::Small ? 6 : 24);
  return { filter, { { 0, ManyCones(size == Size::Small ? 3500 : 150000) } } };
}

Setting ConeSetAccuracy(Size size)
{
  auto filter = vtkSmartPointer<vtkConeSetAccuracy>::New();
  filter->SetNumberOfSamples(size == Size::Small ? 8000 : 400000);
  filter->SetNumberOfLightSamples(32);
  filter->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  return { filter, { { 1, Cones() }, { 2, Room() }, { 3, Lamp() } } };
}

Setting ShadowVolume(Size size, int umbra)
{
  auto filter = vtkSmartPointer<vtkShadowVolume>::New();
  filter->SetUmbra(umbra);
  filter->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  filter->SetResolution(size == Size::Small ? 12 : 150);
  return { filter, { { 0, Cones() } } };
}

/// Solids of what is truly seen, of the chair in the room.
Setting SeenShadowVolume(Size size)
{
  auto filter = vtkSmartPointer<vtkShadowVolume>::New();
  filter->SetMethodToVisibility();
  filter->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  filter->SetResolution(size == Size::Small ? 10 : 100);
  filter->SetNumberOfLightSamples(size == Size::Small ? 16 : 64);
  return { filter, { { 2, Room() }, { 3, Lamp() } } };
}

/// Silhouettes of many balls under a point.
Setting ProjectedShadowVolume(Size size)
{
  auto filter = vtkSmartPointer<vtkShadowVolume>::New();
  filter->SetMethodToProjection();
  filter->SetBounds(-2.75, 2.75, -3.0, 5.2, -2.75, 2.75);
  vtkNew<vtkAppendPolyData> balls;
  const int edge = size == Size::Small ? 3 : 8;
  for (int k = 0; k < edge * edge; ++k)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(3.0 * (k % edge) / edge - 1.5, 2.0, 3.0 * (k / edge) / edge - 1.5);
    ball->SetRadius(1.0 / edge);
    ball->SetThetaResolution(size == Size::Small ? 8 : 60);
    ball->SetPhiResolution(size == Size::Small ? 6 : 50);
    ball->Update();
    balls->AddInputData(ball->GetOutput());
  }
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToPoint();
  light->SetCenter(0.3, 6.0, 0.2);
  return { filter, { { 2, LabelledMesh(Take(balls)) }, { 3, Take(light) } } };
}

/// A grid in the room, so many points along each edge.
vtkSmartPointer<vtkPolyData> PointsOfRoom(int edge)
{
  std::vector<double> points;
  for (int k = 0; k < edge * edge * edge; ++k)
  {
    points.insert(points.end(),
      { 5.0 * (k % edge) / edge - 2.5, 5.0 * (k / edge % edge) / edge, 5.0 * (k / edge / edge) / edge - 2.5 });
  }
  return PointsAt(points);
}

/// Asks at points of a grid in the room.
Setting ConeSetProbe(Size size, int method)
{
  auto filter = vtkSmartPointer<vtkConeSetProbe>::New();
  filter->SetMethod(method);
  const int edge = size == Size::Small ? 16 : 90;
  return { filter, { { 0, PointsOfRoom(edge) }, { 1, Cones() }, { 2, Lamp() }, { 3, Room() } } };
}

/// Asks at points of a grid in the room along a day; the Sun comes in by the open front.
Setting SunHours(Size size, double angularDiameter)
{
  vtkNew<vtkSunPath> path;
  path->SetLatitude(35.0);
  path->SetUp(0.0, 1.0, 0.0);
  path->SetNorth(0.0, 0.0, -1.0);
  path->SetStart("2024-12-21");
  path->SetEnd("2024-12-22");
  path->SetStep(20.0);
  path->SetAngularDiameter(angularDiameter);
  auto filter = vtkSmartPointer<vtkSunHours>::New();
  filter->SetNumberOfLightSamples(20);
  filter->SetComputeOccluders(true);
  const int edge = size == Size::Small ? 10 : angularDiameter > 0.0 ? 50 : 110;
  return { filter, { { 0, PointsOfRoom(edge) }, { 1, Room() }, { 2, Take(path) } } };
}

/// The floor of the room, with normals that point up.
vtkSmartPointer<vtkPolyData> Floor(int points)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.5, 0.01, -2.5);
  plane->SetPoint1(-2.5, 0.01, 2.5);
  plane->SetPoint2(2.5, 0.01, -2.5);
  plane->SetResolution(points - 1, points - 1);
  return Take(plane);
}

Setting ArrivingLight(Size size)
{
  auto filter = vtkSmartPointer<vtkConeSetProbe>::New();
  filter->ComputeIrradianceOn();
  filter->ComputeFluenceRateOn();
  filter->ComputeIlluminanceOn();
  return { filter, { { 0, Floor(size == Size::Small ? 40 : 500) }, { 1, Cones() }, { 2, Lamp() }, { 3, Room() } } };
}

Setting PenumbraWidth(Size size)
{
  auto filter = vtkSmartPointer<vtkPenumbraWidth>::New();
  filter->SetNumberOfLightSamples(size == Size::Small ? 32 : 256);
  return { filter, { { 0, Floor(size == Size::Small ? 24 : 200) }, { 1, Lamp() }, { 2, Room() } } };
}

Setting Footprints(Size size)
{
  auto filter = vtkSmartPointer<vtkShadowFootprints>::New();
  filter->SetNumberOfLightSamples(64);
  filter->SetSpacing(size == Size::Small ? 0.3 : 0.015);
  filter->SetRefinements(1);
  return { filter, { { 0, Floor(2) }, { 1, Lamp() }, { 2, Room() } } };
}

Setting VisibilityVolume(Size size, int method)
{
  auto filter = vtkSmartPointer<vtkVisibilityVolume>::New();
  filter->SetMethod(method);
  const int edge = size == Size::Small ? 18 : 150;
  filter->SetDimensions(edge, edge + 3, edge + 1);
  filter->SetBrickParts(4);
  filter->SetComputeFluenceRate(method == vtkVisibilityVolume::Exact);
  filter->SetNumberOfLightSamples(size == Size::Small ? 16 : 64);
  filter->SetBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  return { filter, { { 0, Cones() }, { 1, Lamp() }, { 2, Room() } } };
}

/// A visibility volume of the room.
vtkImageData* Shadow()
{
  static const vtkSmartPointer<vtkImageData> volume = [] {
    Setting setting = VisibilityVolume(Size::Small, vtkVisibilityVolume::Exact);
    setting.Connect();
    setting.Filter->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(setting.Filter->GetOutputDataObject(0));
    return copy;
  }();
  return volume;
}

/// Fog that thins out upwards.
vtkSmartPointer<vtkImageData> Fog()
{
  auto fog = vtkSmartPointer<vtkImageData>::New();
  fog->SetDimensions(4, 9, 5);
  fog->SetOrigin(-2.75, 0.0, -2.75);
  fog->SetSpacing(5.5 / 3.0, 0.6, 5.5 / 4.0);
  std::vector<float> density;
  for (vtkIdType i = 0; i < fog->GetNumberOfPoints(); ++i)
  {
    density.push_back(static_cast<float>(std::max(0.0, 2.0 - 0.5 * fog->GetPoint(i)[1])));
  }
  shadowcones::AddFloatArray(fog->GetPointData(), "Density", 1, density);
  return fog;
}

Setting ScatteringImage(Size size, int mode, bool inFog = false)
{
  auto filter = vtkSmartPointer<vtkScatteringImageFilter>::New();
  filter->SetMode(mode);
  const bool small = size == Size::Small;
  const bool fast = mode == vtkScatteringImageFilter::Soft || mode == vtkScatteringImageFilter::Volume;
  const int pixels = small ? 36 : (fast ? 1200 : 600);
  filter->SetResolution(pixels, pixels - 3);
  filter->SetRelativeErrorGoal(small ? 0.01 : 0.002);
  const int edge = small ? 20 : 129;
  filter->SetSoftDimensions(edge, edge + 2, edge - 3);
  filter->SetSigmaS(0.12);
  filter->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 2.75, 12.5);
  camera->SetFocalPoint(0.0, 2.75, 0.0);
  camera->SetViewAngle(32.0);
  filter->SetCamera(camera);
  Setting setting{ filter, { { 0, Room() }, { 1, Lamp() } } };
  if (mode != vtkScatteringImageFilter::BruteForce)
  {
    setting.Inputs.emplace_back(2, Cones());
  }
  if (mode == vtkScatteringImageFilter::Volume)
  {
    setting.Inputs.emplace_back(3, Shadow());
  }
  if (inFog)
  {
    setting.Inputs.emplace_back(4, Fog());
  }
  return setting;
}

Setting LightShafts(Size size)
{
  auto filter = vtkSmartPointer<vtkLightShafts>::New();
  const int pixels = size == Size::Small ? 32 : 600;
  filter->SetResolution(pixels, pixels - 3);
  filter->SetRelativeErrorGoal(size == Size::Small ? 0.05 : 0.002);
  return { filter, { { 0, Room() }, { 1, Lamp() } } };
}

/// A haze in which wavelengths fade in two ways.
template <typename Filter>
void SetHaze(Filter* filter)
{
  filter->SetSigmaS(0.2);
  filter->SetSigmaASpectrum(1, 0.4);
  filter->SetPhasePresetToHazyMie();
  filter->SetMediumBounds(-2.75, 2.75, 0.0, 5.2, -2.75, 2.75);
}

Setting PhotonMap(Size size)
{
  auto filter = vtkSmartPointer<vtkPhotonMapFilter>::New();
  filter->SetNumberOfPhotons(size == Size::Small ? 3000 : 400000);
  SetHaze(filter.GetPointer());
  return { filter, { { 0, Room() }, { 1, Lamp() } } };
}

Setting ScatteringWithPhotons(Size size)
{
  static const vtkSmartPointer<vtkPolyData> photons = [] {
    Setting setting = PhotonMap(Size::Small);
    setting.Connect();
    return Take(setting.Filter, 1);
  }();
  Setting setting = ScatteringImage(size, vtkScatteringImageFilter::Fast);
  SetHaze(vtkScatteringImageFilter::SafeDownCast(setting.Filter));
  setting.Inputs.emplace_back(5, photons);
  return setting;
}

Setting ToneMap(Size)
{
  static const vtkSmartPointer<vtkImageData> image = []
  {
    Setting setting = ScatteringImage(Size::Small, vtkScatteringImageFilter::Fast);
    setting.Connect();
    setting.Filter->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(setting.Filter->GetOutputDataObject(0));
    copy->GetPointData()->RemoveArray("RGB");
    return copy;
  }();
  return { vtkSmartPointer<vtkToneMapRadiance>::New(), { { 0, image } } };
}

} // namespace

void Setting::Connect()
{
  for (const auto& [port, data] : this->Inputs)
  {
    this->Filter->SetInputDataObject(port, data);
  }
}

const std::vector<Case>& AllCases()
{
  static const std::vector<Case> cases = {
    { "AreaLight", AreaLight, false, false },
    { "SunPath", SunPath, false, false },
    { "LabelOccluders", LabelOccluders },
    { "ShadowVectorsOfPhotons", [](Size size) { return ShadowVectors(size, false, false); } },
    { "ShadowVectorsToATarget", [](Size size) { return ShadowVectors(size, true, true); } },
    { "ConeSet", [](Size size) { return ConeSet(size, false, true); } },
    { "ConeSetOverlap", [](Size size) { return ConeSet(size, true, false); } },
    { "ConeSetTunedConservative", [](Size size) { return ConeSetTuned(size, vtkConeSetFilter::Conservative); } },
    { "ConeSetTunedSoft", [](Size size) { return ConeSetTuned(size, vtkConeSetFilter::Soft); } },
    { "ConeSetGeometry", ConeSetGeometry },
    { "ConeSetAccuracy", ConeSetAccuracy },
    { "ShadowVolumeInnerCones", [](Size size) { return ShadowVolume(size, vtkShadowVolume::InnerCones); } },
    { "ShadowVolumeBaseDiscs", [](Size size) { return ShadowVolume(size, vtkShadowVolume::BaseDiscs); } },
    { "ShadowVolumeVisibility", SeenShadowVolume },
    { "ShadowVolumeProjection", ProjectedShadowVolume },
    { "ConeSetProbeExact", [](Size size) { return ConeSetProbe(size, vtkConeSetProbe::Exact); }, true, false },
    { "ConeSetProbeSoft", [](Size size) { return ConeSetProbe(size, vtkConeSetProbe::Soft); }, true, false },
    { "ConeSetProbeArrivingLight", ArrivingLight, true, false },
    { "PenumbraWidth", PenumbraWidth, true, false },
    { "ShadowFootprints", Footprints, true, false },
    { "SunHoursHard", [](Size size) { return SunHours(size, 0.0); }, true, false, 2 },
    { "SunHoursDisc", [](Size size) { return SunHours(size, 0.533); }, true, false, 2 },
    { "VisibilityVolumeExact", [](Size size) { return VisibilityVolume(size, vtkVisibilityVolume::Exact); } },
    { "VisibilityVolumeSoft", [](Size size) { return VisibilityVolume(size, vtkVisibilityVolume::Soft); } },
    { "ScatteringBruteForce", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::BruteForce); } },
    { "ScatteringMedium", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Medium); } },
    { "ScatteringFast", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Fast); } },
    { "ScatteringGuided", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Guided); } },
    { "ScatteringSoft", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Soft); } },
    { "ScatteringVolume", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Volume); } },
    { "ScatteringGuidedFog", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Guided, true); } },
    { "ShadowVectorsOfTwoLamps", [](Size size) { return OfTwoLamps(ShadowVectors(size, true, true)); } },
    { "ConeSetOfTwoLamps",
      [](Size)
      {
        return Setting{ vtkSmartPointer<vtkConeSetFilter>::New(), { { 0, VectorsOfTwo(0) }, { 1, VectorsOfTwo(1) } } };
      },
      false },
    { "ConeSetProbeOfTwoLamps",
      [](Size size) { return OfTwoLamps(ConeSetProbe(size, vtkConeSetProbe::Exact)); }, false, false },
    { "VisibilityVolumeOfTwoLamps",
      [](Size size) { return OfTwoLamps(VisibilityVolume(size, vtkVisibilityVolume::Exact)); }, false },
    { "ScatteringGuidedOfTwoLamps",
      [](Size size) { return OfTwoLamps(ScatteringImage(size, vtkScatteringImageFilter::Guided)); } },
    { "ScatteringSoftOfTwoLamps",
      [](Size size) { return OfTwoLamps(ScatteringImage(size, vtkScatteringImageFilter::Soft)); }, false },
    { "LightShafts", LightShafts, true, false },
    { "ToneMapRadiance", ToneMap, false },
    { "PhotonMap", PhotonMap },
    { "ScatteringWithPhotons", ScatteringWithPhotons },
    { "ScatteringVolumeFog", [](Size size) { return ScatteringImage(size, vtkScatteringImageFilter::Volume, true); } },
  };
  return cases;
}

vtkSmartPointer<vtkPolyData> LabelledMesh(vtkPolyData* input)
{
  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputData(input);
  return Take(labels);
}

vtkSmartPointer<vtkPolyData> RoomLamp(double scale, double offset)
{
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(offset, 5.49 * scale + offset, offset);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.5 * scale);
  light->SetRadiance(60.0);
  return Take(light);
}

} // namespace invariants
