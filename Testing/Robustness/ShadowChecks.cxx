// SPDX-License-Identifier: BSD-3-Clause
// The shapes of shadows: solids that are closed and hold what is dark, widths of penumbras, areas of footprints.
#include "FilterChecks.h"

#include "Asking.h"
#include "SceneParts.h"

#include "vtkPenumbraWidth.h"
#include "vtkShadowFootprintWriter.h"
#include "vtkShadowFootprints.h"
#include "vtkShadowVolume.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace robustness
{

using namespace shadowcones;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A square under the mesh, in quads.
vtkSmartPointer<vtkPolyData> GroundOf(const AwkwardMesh& mesh, int edge)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  for (int j = 0; j <= edge; ++j)
  {
    for (int i = 0; i <= edge; ++i)
    {
      const Vector3 p = mesh.Place({ -2.0 + 4.0 * i / edge, -2.0 + 4.0 * j / edge, groundHeight });
      points->InsertNextPoint(p.X, p.Y, p.Z);
      if (i < edge && j < edge)
      {
        const vtkIdType a = j * (edge + 1) + i;
        quads->InsertNextCell({ a, a + 1, a + edge + 2, a + edge + 1 });
      }
    }
  }
  auto ground = vtkSmartPointer<vtkPolyData>::New();
  ground->SetPoints(points);
  ground->SetPolys(quads);
  return ground;
}

/// Every edge is walked as often one way as the other.
Finding IsClosed(vtkPolyData* solid)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (vtkIdType cell = 0; cell < solid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    solid->GetCellPoints(cell, count, ids);
    for (vtkIdType k = 0; k < count; ++k)
    {
      const vtkIdType a = ids[k];
      const vtkIdType b = ids[(k + 1) % count];
      edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  const bool closed = std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
  return closed ? Finding() : Wrong("a solid is not closed");
}

double AreaOf(vtkPolyData* data)
{
  double area = 0.0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data->GetCellPoints(cell, count, ids);
    Vector3 sum;
    for (vtkIdType k = 2; k < count; ++k)
    {
      sum += Cross(PointOf(data, ids[k - 1]) - PointOf(data, ids[0]), PointOf(data, ids[k]) - PointOf(data, ids[0]));
    }
    area += 0.5 * Length(sum);
  }
  return area;
}

} // namespace

Finding AskSolids(const Scene& scene, int method, int umbra)
{
  const auto filter = Made<vtkShadowVolume>::New();
  filter->SetMethod(method);
  filter->SetUmbra(umbra);
  filter->SetResolution(16);
  filter->SetNumberOfLightSamples(16);
  double bounds[6];
  PlaceBounds(scene.Mesh, bounds);
  filter->SetBounds(bounds);
  const bool projected = method == vtkShadowVolume::Projection;
  if (method == vtkShadowVolume::Cones)
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
    filter->SetLightData(projected ? LampOf(scene.Mesh, true) : scene.Lamp);
  }
  Finding asked = Ask(filter, scene, projected ? "Visibility" : "");
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  asked = IsClosed(filter->GetOutput(0));
  asked = asked.Kind == Verdict::Lost ? asked : IsClosed(filter->GetOutput(1));
  if (asked.Kind == Verdict::Lost || !projected)
  {
    return asked;
  }
  // A projected solid holds what a point does not see, exactly: count its walls along a ray.
  std::vector<Vector3> walls;
  vtkPolyData* solid = filter->GetOutput(0);
  for (vtkIdType cell = 0; cell < solid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    solid->GetCellPoints(cell, count, ids);
    for (int c = 0; c < 3; ++c)
    {
      walls.push_back(scene.Mesh.Unplace(PointOf(solid, ids[c])));
    }
  }
  for (const Vector3& place : scene.PlacesBefore)
  {
    const bool inside = PlainRays(walls).Winding(place, { 0.372, 0.2161, 0.9035 }) != 0;
    const bool blocked = scene.Rays.Blocked(place, { 0.0, 0.0, lampHeight });
    const bool within = scene.Rays.Hits(place, { 0.11, 0.23, 0.97 }).size() % 2 == 1;
    if (inside != blocked && !within)
    {
      return Wrong("a projected solid holds a place that is lit, or leaves out one that is dark");
    }
  }
  return { Verdict::Right, {} };
}

Finding AskWidths(const Scene& scene)
{
  const auto filter = Made<vtkPenumbraWidth>::New();
  filter->SetInputData(GroundOf(scene.Mesh, 12));
  filter->SetLightData(scene.Lamp);
  filter->SetMeshData(scene.Labelled);
  filter->SetNumberOfLightSamples(48);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  std::vector<Vector3> places;
  std::vector<double> truth;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double width = ValueOf(output->GetPointData(), "PenumbraWidth", i);
    if (!(std::isnan(width) || (width > 0.0 && width < 10.0 * scene.Mesh.Scale)))
    {
      return WrongOf("a penumbra is ", width, " wide");
    }
    if (i % 11 == 3 && scene.Mesh.Corners.size() < 100000)
    {
      places.push_back(scene.Mesh.Unplace(PointOf(output, i)));
      truth.push_back(ShareSeen(scene, places.back(), 6));
      const double seen = ValueOf(output->GetPointData(), "Visibility", i);
      if (std::fabs(seen - truth.back()) > 0.3)
      {
        return WrongOf("sees ", seen, " in place of ", truth.back());
      }
    }
  }
  return { places.empty() ? Verdict::Sound : Verdict::Right, {} };
}

Finding AskFootprints(const Scene& scene, bool write)
{
  const auto filter = Made<vtkShadowFootprints>::New();
  filter->SetInputData(GroundOf(scene.Mesh, 1));
  filter->SetLightData(scene.Lamp);
  filter->SetMeshData(scene.Labelled);
  filter->SetPerOccluder(false);
  filter->SetSpacing(0.2 * scene.Mesh.Scale);
  filter->SetRefinements(2);
  filter->SetNumberOfLightSamples(32);
  const Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  if (write)
  {
    const std::string file =
      (std::filesystem::temp_directory_path() / ("awkward-" + std::to_string(getpid()) + ".geojson")).string();
    const auto writer = Made<vtkShadowFootprintWriter>::New();
    writer->SetInputData(filter->GetOutputDataObject(0));
    writer->SetFileName(file.c_str());
    testsupport::Messages messages(writer);
    writer->Write();
    std::remove(file.c_str());
    return messages.Errors.empty() ? Finding() : Wrong(messages.Errors);
  }
  if (scene.Mesh.Corners.size() > 100000)
  {
    return {};
  }
  const double area = AreaOf(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))) / scene.Mesh.Scale / scene.Mesh.Scale;
  // Where any of the lamp is hidden, some of its rim or its inside is.
  std::vector<Vector3> lamp = PointsOfDisc({ 0.0, 0.0, lampHeight }, lampRadius, 3);
  for (int k = 0; k < 40; ++k)
  {
    lamp.push_back({ lampRadius * std::cos(0.05 * Pi * k), lampRadius * std::sin(0.05 * Pi * k), lampHeight });
  }
  constexpr int edge = 40;
  double truth = 0.0;
  for (int k = 0; k < edge * edge; ++k)
  {
    const Vector3 place{ 4.0 * (k % edge + 0.5) / edge - 2.0, 4.0 * (k / edge + 0.5) / edge - 2.0, groundHeight };
    const bool dark =
      std::any_of(lamp.begin(), lamp.end(), [&](const Vector3& q) { return scene.Rays.Blocked(place, q); });
    truth += dark ? 16.0 / (edge * edge) : 0.0;
  }
  if (std::fabs(area - truth) > 0.08 * truth + 0.05)
  {
    return WrongOf("footprints of ", area, " in place of ", truth);
  }
  return { Verdict::Right, {} };
}

} // namespace robustness
