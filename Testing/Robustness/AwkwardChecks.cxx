// SPDX-License-Identifier: BSD-3-Clause
// The scene of a mesh, and the list of checks: the columns of the table.
#include "AwkwardChecks.h"

#include "FilterChecks.h"
#include "Messages.h"
#include "SceneParts.h"

#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"
#include "vtkVisibilityVolume.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <random>
#include <utility>

namespace robustness
{

using namespace shadowcones;

Scene::Scene(const AwkwardMesh& mesh)
  : Mesh(mesh)
  , Rays(mesh.Corners)
  , Lamp(LampOf(mesh))
  , Places(vtkSmartPointer<vtkPolyData>::New())
{
  const bool large = mesh.Corners.size() > 100000;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < (large ? 12 : 64); ++k)
  {
    const bool low = k % 4 != 3;
    const Vector3 place{ 4.0 * any(random) - 2.0, 4.0 * any(random) - 2.0, low ? groundHeight : 3.0 * any(random) };
    const Vector3 placed = mesh.Place(place);
    points->InsertNextPoint(placed.X, placed.Y, placed.Z);
    this->PlacesBefore.push_back(place);
    this->Seen.push_back(ShareSeen(*this, place, large ? 3 : 7));
  }
  this->Places->SetPoints(points);

  vtkNew<vtkLabelOccluders> labels;
  labels->SetInputDataObject(mesh.Data);
  testsupport::Messages messages(labels);
  labels->Update();
  auto* plain = vtkPolyData::SafeDownCast(mesh.Data);
  this->Labelled = messages.Errors.empty() || !plain ? Take(labels) : vtkSmartPointer<vtkPolyData>(plain);
}

vtkPolyData* Scene::Vectors() const
{
  if (!this->MadeVectors)
  {
    vtkNew<vtkShadowVectorFilter> filter;
    filter->SetInputData(this->Labelled);
    filter->SetLightData(this->Lamp);
    filter->SetTargetNumberOfVectors(1500);
    testsupport::Messages messages(filter);
    filter->Update();
    this->MadeVectors = Take(filter);
    this->MadePaths = Take(filter, 1);
  }
  return this->MadeVectors;
}

vtkPolyData* Scene::Paths() const
{
  this->Vectors();
  return this->MadePaths;
}

vtkPolyData* Scene::Cones() const
{
  if (!this->MadeCones)
  {
    const auto filter = ConesOf(*this, vtkConeSetFilter::Automatic, this->Mesh.Refusal.empty());
    testsupport::Messages messages(filter);
    filter->Update();
    this->MadeCones = Take(filter);
  }
  return this->MadeCones;
}

const std::vector<Check>& AllChecks()
{
  static const std::vector<Check> checks = []
  {
    std::vector<Check> all;
    const auto add = [&](const char* filter, const char* mode, std::function<Finding(const Scene&)> ask)
    { all.push_back({ filter, mode, std::move(ask) }); };
    add("labels", "automatic", [](const Scene& s) { return AskLabels(s, vtkLabelOccluders::Automatic); });
    add("labels", "component", [](const Scene& s) { return AskLabels(s, vtkLabelOccluders::Component); });
    add("labels", "block", [](const Scene& s) { return AskLabels(s, vtkLabelOccluders::Block); });
    add("labels", "whole", [](const Scene& s) { return AskLabels(s, vtkLabelOccluders::Whole); });
    add("vectors", "hit", [](const Scene& s) { return AskVectors(s, vtkShadowVectorFilter::HitPoint, false); });
    add("vectors", "back", [](const Scene& s) { return AskVectors(s, vtkShadowVectorFilter::BackSide, true); });
    const char* tunings[] = { "manual", "conservative", "preview", "soft", "automatic" };
    for (int tuning = 0; tuning < 5; ++tuning)
    {
      for (const bool certify : { false, true })
      {
        add("cones", (std::string(tunings[tuning]) + (certify ? "+proof" : "")).c_str(),
          [=](const Scene& s) { return AskCones(s, tuning, vtkConeSetFilter::LightGeometry, certify); });
      }
    }
    add("cones", "deviation", [](const Scene& s) { return AskCones(s, 0, vtkConeSetFilter::MaximumDeviation, false); });
    add("cones", "ratio", [](const Scene& s) { return AskCones(s, 0, vtkConeSetFilter::RadiusRatio, false); });
    add("geometry", "length", [](const Scene& s) { return AskGeometry(s, vtkConeSetGeometry::CutLength); });
    add("geometry", "plane", [](const Scene& s) { return AskGeometry(s, vtkConeSetGeometry::CutPlane); });
    add("geometry", "box", [](const Scene& s) { return AskGeometry(s, vtkConeSetGeometry::CutBox); });
    add("probe", "exact", [](const Scene& s) { return AskProbe(s, vtkConeSetProbe::Exact, false, false, true); });
    add("probe", "in cones", [](const Scene& s) { return AskProbe(s, vtkConeSetProbe::Exact, true, false, false); });
    add("probe", "unlabelled", [](const Scene& s) { return AskProbe(s, vtkConeSetProbe::Exact, false, true, false); });
    add("probe", "soft", [](const Scene& s) { return AskProbe(s, vtkConeSetProbe::Soft, true, false, true); });
    add("accuracy", "", AskAccuracy);
    add("solids", "inner", [](const Scene& s) { return AskSolids(s, vtkShadowVolume::Cones, vtkShadowVolume::InnerCones); });
    add("solids", "discs", [](const Scene& s) { return AskSolids(s, vtkShadowVolume::Cones, vtkShadowVolume::BaseDiscs); });
    add("solids", "visibility", [](const Scene& s) { return AskSolids(s, vtkShadowVolume::Visibility, 0); });
    add("solids", "projection", [](const Scene& s) { return AskSolids(s, vtkShadowVolume::Projection, 0); });
    add("volume", "exact", [](const Scene& s) { return AskVolume(s, vtkVisibilityVolume::Exact); });
    add("volume", "soft", [](const Scene& s) { return AskVolume(s, vtkVisibilityVolume::Soft); });
    const std::pair<const char*, int> modes[] = { { "brute", vtkScatteringImageFilter::BruteForce },
      { "medium", vtkScatteringImageFilter::Medium }, { "fast", vtkScatteringImageFilter::Fast },
      { "guided", vtkScatteringImageFilter::Guided }, { "soft", vtkScatteringImageFilter::Soft },
      { "volume", vtkScatteringImageFilter::Volume } };
    for (const auto& [name, mode] : modes)
    {
      add("image", name, [mode = mode](const Scene& s) { return AskImage(s, mode); });
    }
    add("tone map", "", AskToneMap);
    add("sun hours", "hard", [](const Scene& s) { return AskSunHours(s, 0.0); });
    add("sun hours", "disc", [](const Scene& s) { return AskSunHours(s, 0.533); });
    add("widths", "", AskWidths);
    add("footprints", "", [](const Scene& s) { return AskFootprints(s, false); });
    add("footprints", "written", [](const Scene& s) { return AskFootprints(s, true); });
    add("page", "", AskPage);
    return all;
  }();
  return checks;
}

} // namespace robustness
