// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneParts.h
 * @brief What the checks share: lamp, bounds and cones of a scene, the truth at a place, points and values of data.
 */
#ifndef SceneParts_h
#define SceneParts_h

#include "AwkwardChecks.h"
#include "PlainRays.h"

#include "vtkAreaLightSource.h"
#include "vtkConeSetFilter.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace robustness
{

constexpr double lampHeight = 4.0;
constexpr double lampRadius = 0.5;
constexpr double groundHeight = -0.45;

template <typename Filter>
using Made = vtkSmartPointer<Filter>;

inline vtkSmartPointer<vtkPolyData> Take(vtkAlgorithm* filter, int port = 0)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutputDataObject(port));
  return copy;
}

inline shadowcones::Vector3 PointOf(vtkDataSet* data, vtkIdType i)
{
  double p[3];
  data->GetPoint(i, p);
  return { p[0], p[1], p[2] };
}

inline shadowcones::Vector3 TupleOf(vtkDataArray* array, vtkIdType i)
{
  double p[3];
  array->GetTuple(i, p);
  return { p[0], p[1], p[2] };
}

inline double ValueOf(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  return data->GetArray(name)->GetComponent(i, 0);
}

/// What is left where it was before: bounds of the places and media of all scenes.
inline void PlaceBounds(const AwkwardMesh& mesh, double (&bounds)[6])
{
  const shadowcones::Vector3 low = mesh.Place({ -2.0, -2.0, -0.9 });
  const shadowcones::Vector3 high = mesh.Place({ 2.0, 2.0, 3.9 });
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = low[axis];
    bounds[2 * axis + 1] = high[axis];
  }
}

inline vtkSmartPointer<vtkPolyData> LampOf(const AwkwardMesh& mesh, bool point = false)
{
  vtkNew<vtkAreaLightSource> lamp;
  const shadowcones::Vector3 center = mesh.Place({ 0.0, 0.0, lampHeight });
  lamp->SetShape(point ? vtkAreaLightSource::Point : vtkAreaLightSource::Disc);
  lamp->SetCenter(center.X, center.Y, center.Z);
  lamp->SetNormal(0.0, 0.0, -1.0);
  lamp->SetRadius(lampRadius * mesh.Scale);
  lamp->SetNumberOfWavelengths(1);
  lamp->Update();
  return Take(lamp);
}

inline double ShareSeen(const Scene& scene, const shadowcones::Vector3& place, int rings)
{
  const std::vector<shadowcones::Vector3> lamp = PointsOfDisc({ 0.0, 0.0, lampHeight }, lampRadius, rings);
  const auto seen = std::count_if(
    lamp.begin(), lamp.end(), [&](const shadowcones::Vector3& q) { return !scene.Rays.Blocked(place, q); });
  return static_cast<double>(seen) / static_cast<double>(lamp.size());
}

inline vtkSmartPointer<vtkConeSetFilter> ConesOf(const Scene& scene, int tuning, bool certify)
{
  auto filter = Made<vtkConeSetFilter>::New();
  filter->SetTuning(tuning);
  filter->SetCertify(certify);
  filter->SetInputData(scene.Vectors());
  filter->SetPhotonPathData(scene.Paths());
  if (certify)
  {
    filter->SetMeshData(scene.Labelled);
    filter->SetLightData(scene.Lamp);
  }
  return filter;
}

} // namespace robustness

#endif
