// SPDX-License-Identifier: BSD-3-Clause
// What places see of the lamp, from the probe to the volume, and their hours in the Sun: held against rays one by one.
#include "FilterChecks.h"

#include "Asking.h"
#include "SceneParts.h"

#include "vtkConeSetAccuracy.h"
#include "vtkConeSetProbe.h"
#include "vtkSunHours.h"
#include "vtkSunPath.h"
#include "vtkVisibilityVolume.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

namespace robustness
{

using namespace shadowcones;

namespace
{

/// Shares of places as they were asked, against the truth.
Finding CompareSeen(const Scene& scene, const std::vector<Vector3>& places, const std::vector<double>& truth,
  vtkDataArray* found, int samples)
{
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const double value = found->GetComponent(static_cast<vtkIdType>(k), 0);
    const double p = (samples * truth[k] + 0.5) / (samples + 1);
    if (std::fabs(value - truth[k]) > 4.0 * std::sqrt(p * (1.0 - p) / samples) + 0.03)
    {
      const Vector3& at = places[k];
      return WrongOf("sees ", value, " in place of ", truth[k], " at (", at.X, ", ", at.Y, ", ", at.Z, ") of ",
        scene.Mesh.Name);
    }
  }
  return { Verdict::Right, {} };
}

} // namespace

Finding AskProbe(const Scene& scene, int method, bool cones, bool raw, bool arriving)
{
  const auto filter = Made<vtkConeSetProbe>::New();
  filter->SetMethod(method);
  filter->SetInputData(scene.Places);
  filter->SetLightData(scene.Lamp);
  filter->SetComputeFluenceRate(arriving);
  filter->SetNumberOfLightSamples(64);
  if (cones)
  {
    filter->SetConeSetData(scene.Cones());
  }
  if (method == vtkConeSetProbe::Exact)
  {
    filter->SetMeshData(raw ? scene.Mesh.Data : vtkSmartPointer<vtkDataObject>(scene.Labelled));
  }
  else if (!scene.Mesh.Refusal.empty())
  {
    return {};
  }
  const bool surface = !raw || !scene.Mesh.Data->IsA("vtkUnstructuredGrid");
  if (!surface)
  {
    return {}; // the port takes surfaces: the pipeline says so itself
  }
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound || method == vtkConeSetProbe::Soft)
  {
    return asked;
  }
  vtkPointData* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  return CompareSeen(scene, scene.PlacesBefore, scene.Seen, data->GetArray("Visibility"), 64);
}

Finding AskAccuracy(const Scene& scene)
{
  const auto filter = Made<vtkConeSetAccuracy>::New();
  filter->SetInputData(scene.Places);
  filter->SetConeSetData(scene.Cones());
  filter->SetMeshData(scene.Labelled);
  filter->SetLightData(scene.Lamp);
  filter->SetNumberOfLightSamples(64);
  filter->SetCompareBounds(true);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  if (filter->GetOutput()->GetNumberOfPoints() == 0)
  {
    return {};
  }
  return CompareSeen(
    scene, scene.PlacesBefore, scene.Seen, filter->GetOutput()->GetPointData()->GetArray("Truth"), 64);
}

Finding AskVolume(const Scene& scene, int method)
{
  const auto filter = Made<vtkVisibilityVolume>::New();
  filter->SetMethod(method);
  filter->SetDimensions(5, 5, 5);
  filter->SetNumberOfLightSamples(64);
  filter->SetComputeFluenceRate(true);
  double bounds[6];
  PlaceBounds(scene.Mesh, bounds);
  filter->SetBounds(bounds);
  filter->SetLightData(scene.Lamp);
  const bool soft = method == vtkVisibilityVolume::Soft;
  if (soft)
  {
    filter->SetInputData(scene.Cones());
    if (!scene.Mesh.Refusal.empty())
    {
      return {};
    }
  }
  else
  {
    filter->SetMeshData(scene.Labelled);
  }
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound || soft || scene.Mesh.Corners.size() > 100000)
  {
    return asked;
  }
  vtkImageData* image = filter->GetOutput();
  std::vector<Vector3> places;
  std::vector<double> truth;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    places.push_back(scene.Mesh.Unplace(PointOf(image, i)));
    truth.push_back(ShareSeen(scene, places.back(), 5));
  }
  return CompareSeen(scene, places, truth, image->GetPointData()->GetArray("Visibility"), 64);
}

Finding AskSunHours(const Scene& scene, double diameter)
{
  vtkNew<vtkSunPath> path;
  path->SetLatitude(40.0);
  path->SetStart("2024-06-21");
  path->SetEnd("2024-06-22");
  path->SetStep(60.0);
  path->SetAngularDiameter(diameter);
  path->Update();
  const auto filter = Made<vtkSunHours>::New();
  filter->SetInputData(scene.Places);
  filter->SetMeshData(scene.Labelled);
  filter->SetPathData(path->GetOutput());
  filter->SetComputeOccluders(true);
  filter->SetNumberOfLightSamples(16);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkFieldData* course = path->GetOutput()->GetFieldData();
  vtkPointData* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  int different = 0;
  for (std::size_t k = 0; k < scene.PlacesBefore.size(); ++k)
  {
    double hours = 0.0;
    for (vtkIdType step = 0; step < course->GetArray("SunStepLength")->GetNumberOfTuples(); ++step)
    {
      const bool up = course->GetArray("SunStepAltitude")->GetComponent(step, 0) > 0.0;
      const Vector3 sun = TupleOf(course->GetArray("SunStepDirection"), step);
      if (up && !std::isfinite(scene.Rays.Nearest(scene.PlacesBefore[k], sun)))
      {
        hours += course->GetArray("SunStepLength")->GetComponent(step, 0) / 3600.0;
      }
    }
    const double found = ValueOf(data, "SunHours", static_cast<vtkIdType>(k));
    different += std::fabs(found - hours) > (diameter > 0.0 ? 1.1 : 1e-3);
  }
  // A ray through an edge may pass on either side of it.
  return different > 1 ? WrongOf(different, " places have other hours in the Sun") : Finding{ Verdict::Right, {} };
}

} // namespace robustness
