// SPDX-License-Identifier: BSD-3-Clause
// Labels, vectors and cones of an awkward mesh: the rays that the truth stops, and the places that it has in shadow.
#include "FilterChecks.h"

#include "Asking.h"
#include "SceneParts.h"

#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <random>
#include <vector>

namespace robustness
{

using namespace shadowcones;

namespace
{

/// The first value of a field array; -1 where there is none.
double FindValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : -1.0;
}

/// Does a proved set hold every place that the truth has in shadow?
Finding HoldsShadow(const Scene& scene, vtkPolyData* cones)
{
  if (FindValue(cones, "Certified") != 1.0)
  {
    return {};
  }
  vtkPointData* data = cones->GetPointData();
  for (std::size_t k = 0; k < scene.Seen.size(); ++k)
  {
    const Vector3 place = scene.Mesh.Place(scene.PlacesBefore[k]);
    bool held = scene.Seen[k] == 1.0;
    for (vtkIdType i = 0; !held && i < cones->GetNumberOfPoints(); ++i)
    {
      const Vector3 offset = place - PointOf(cones, i);
      const double height = Dot(offset, TupleOf(data->GetArray("Axis"), i));
      const double across = Length(offset - height * TupleOf(data->GetArray("Axis"), i));
      const double radius = ValueOf(data, "BaseRadius", i);
      held = height >= -1e-5 * scene.Mesh.Scale &&
        across <= (radius + height * std::tan(ValueOf(data, "HalfAngle", i))) * (1.0 + 1e-5) + 1e-6 * scene.Mesh.Scale;
    }
    if (!held)
    {
      return WrongOf("a place that sees ", scene.Seen[k], " of the lamp is in no proved cone");
    }
  }
  return { Verdict::Right, {} };
}

} // namespace

Finding AskLabels(const Scene& scene, int by)
{
  const auto filter = Made<vtkLabelOccluders>::New();
  filter->SetLabelBy(by);
  filter->SetInputDataObject(scene.Mesh.Data);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  // The same rays are stopped by what was given and by what came out.
  std::vector<Vector3> corners;
  vtkPolyData* output = filter->GetOutput();
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    output->GetCellPoints(cell, count, ids);
    for (int c = 0; c < 3; ++c)
    {
      corners.push_back(scene.Mesh.Unplace(PointOf(output, ids[c])));
    }
  }
  const PlainRays labelled(corners);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  const int rays = corners.size() > 100000 ? 20 : 400;
  int different = 0;
  for (int k = 0; k < rays; ++k)
  {
    const Vector3 a{ any(random), any(random), 3.0 };
    const Vector3 b{ any(random), any(random), -0.7 };
    different += labelled.Blocked(a, b) != scene.Rays.Blocked(a, b);
  }
  // At 1e9 coordinates are rounded to 1e-7 of the box.
  return different > (scene.Mesh.Name == "away-1e9" ? 1 : 0)
    ? WrongOf(different, " of ", rays, " rays are stopped by one of mesh and labels alone")
    : Finding{ Verdict::Right, {} };
}

Finding AskVectors(const Scene& scene, int storage, bool target)
{
  const auto filter = Made<vtkShadowVectorFilter>::New();
  filter->SetStorage(storage);
  filter->SetNumberOfPhotons(2000);
  filter->SetTargetNumberOfVectors(target ? 300 : 0);
  filter->SetInputData(scene.Labelled);
  filter->SetLightData(scene.Lamp);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkPolyData* paths = filter->GetOutput(1);
  const vtkIdType step = scene.Mesh.Corners.size() > 100000 ? paths->GetNumberOfPoints() / 20 + 1 : 1;
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < paths->GetNumberOfPoints(); i += step)
  {
    const Vector3 from = scene.Mesh.Unplace(TupleOf(paths->GetPointData()->GetArray("EmissionPoint"), i));
    const Vector3 along = TupleOf(paths->GetPointData()->GetArray("Direction"), i);
    const double nearest = scene.Rays.Nearest(from, along);
    const bool blocked = ValueOf(paths->GetPointData(), "PathState", i) == 1.0;
    const double length = Length(scene.Mesh.Unplace(PointOf(paths, i)) - from);
    different += blocked != std::isfinite(nearest) || (blocked && std::fabs(length - nearest) > 1e-4 * nearest);
  }
  // Directions are in single precision: a few pass an edge on its other side.
  if (200 * different > paths->GetNumberOfPoints() / step + 200)
  {
    return WrongOf(different, " of ", paths->GetNumberOfPoints() / step, " photon paths end elsewhere");
  }
  if (scene.Mesh.Casts() && filter->GetOutput()->GetNumberOfPoints() == 0)
  {
    return Wrong("no vector");
  }
  return { Verdict::Right, {} };
}

Finding AskCones(const Scene& scene, int tuning, int expansion, bool certify)
{
  const auto filter = ConesOf(scene, tuning, certify);
  filter->SetExpansion(expansion);
  if (!scene.Mesh.Refusal.empty() && !certify)
  {
    return {}; // nothing of that mesh reaches it
  }
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  return HoldsShadow(scene, filter->GetOutput());
}

Finding AskGeometry(const Scene& scene, int cut)
{
  const auto filter = Made<vtkConeSetGeometry>::New();
  filter->SetCut(cut);
  filter->SetInputData(scene.Cones());
  double bounds[6];
  PlaceBounds(scene.Mesh, bounds);
  filter->SetBoxBounds(bounds);
  const Vector3 ground = scene.Mesh.Place({ 0.0, 0.0, groundHeight });
  filter->SetPlaneOrigin(ground.X, ground.Y, ground.Z);
  filter->SetPlaneNormal(0.0, 0.0, 1.0);
  filter->SetLength(2.0 * scene.Mesh.Scale);
  return scene.Mesh.Refusal.empty() ? Ask(filter, scene) : Finding();
}

} // namespace robustness
