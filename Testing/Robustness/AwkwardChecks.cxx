// SPDX-License-Identifier: BSD-3-Clause
// One file because every filter is asked in the same few words; the list at its end is the columns of the table.
#include "AwkwardChecks.h"

#include "Asking.h"
#include "TruthOfImage.h"

#include "vtkAreaLightSource.h"
#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetGeometry.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkPenumbraWidth.h"
#include "vtkScatteringImageFilter.h"
#include "vtkShadowFootprintWriter.h"
#include "vtkShadowFootprints.h"
#include "vtkShadowPage.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"
#include "vtkSunHours.h"
#include "vtkSunPath.h"
#include "vtkToneMapRadiance.h"
#include "vtkVisibilityVolume.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>
#include <utility>

#include <unistd.h>

namespace robustness
{
namespace
{

using namespace shadowcones;

constexpr double Pi = 3.14159265358979323846;
constexpr double lampHeight = 4.0;
constexpr double lampRadius = 0.5;
constexpr double groundHeight = -0.45;

template <typename Filter>
using Made = vtkSmartPointer<Filter>;

vtkSmartPointer<vtkPolyData> Take(vtkAlgorithm* filter, int port = 0)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutputDataObject(port));
  return copy;
}

Vector3 PointOf(vtkDataSet* data, vtkIdType i)
{
  double p[3];
  data->GetPoint(i, p);
  return { p[0], p[1], p[2] };
}

Vector3 TupleOf(vtkDataArray* array, vtkIdType i)
{
  double p[3];
  array->GetTuple(i, p);
  return { p[0], p[1], p[2] };
}

double ValueOf(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  return data->GetArray(name)->GetComponent(i, 0);
}

/// The first value of a field array; -1 where there is none.
double FindValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : -1.0;
}

/// What is left where it was before: bounds of the places and media of all scenes.
void PlaceBounds(const AwkwardMesh& mesh, double (&bounds)[6])
{
  const Vector3 low = mesh.Place({ -2.0, -2.0, -0.9 });
  const Vector3 high = mesh.Place({ 2.0, 2.0, 3.9 });
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = low[axis];
    bounds[2 * axis + 1] = high[axis];
  }
}

vtkSmartPointer<vtkPolyData> LampOf(const AwkwardMesh& mesh, bool point = false)
{
  vtkNew<vtkAreaLightSource> lamp;
  const Vector3 center = mesh.Place({ 0.0, 0.0, lampHeight });
  lamp->SetShape(point ? vtkAreaLightSource::Point : vtkAreaLightSource::Disc);
  lamp->SetCenter(center.X, center.Y, center.Z);
  lamp->SetNormal(0.0, 0.0, -1.0);
  lamp->SetRadius(lampRadius * mesh.Scale);
  lamp->SetNumberOfWavelengths(1);
  lamp->Update();
  return Take(lamp);
}

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

double ShareSeen(const Scene& scene, const Vector3& place, int rings)
{
  const std::vector<Vector3> lamp = PointsOfDisc({ 0.0, 0.0, lampHeight }, lampRadius, rings);
  const auto seen = std::count_if(
    lamp.begin(), lamp.end(), [&](const Vector3& q) { return !scene.Rays.Blocked(place, q); });
  return static_cast<double>(seen) / static_cast<double>(lamp.size());
}

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

vtkSmartPointer<vtkConeSetFilter> ConesOf(const Scene& scene, int tuning, bool certify)
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

vtkSmartPointer<vtkScatteringImageFilter> ImageOf(const Scene& scene, int mode)
{
  auto filter = Made<vtkScatteringImageFilter>::New();
  const AwkwardMesh& mesh = scene.Mesh;
  filter->SetMode(mode);
  filter->SetResolution(truthWidth, truthHeight);
  double bounds[6];
  PlaceBounds(mesh, bounds);
  filter->SetMediumBounds(bounds);
  filter->SetSigmaS(truthSigmaS / mesh.Scale);
  filter->SetNumberOfSteps(128);
  filter->SetNumberOfLightSamples(32);
  filter->SetSoftDimensions(17, 17, 17);
  vtkNew<vtkCamera> camera;
  const Vector3 eye = mesh.Place(truthEye);
  const Vector3 focus = mesh.Place(truthFocus);
  camera->SetPosition(eye.X, eye.Y, eye.Z);
  camera->SetFocalPoint(focus.X, focus.Y, focus.Z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(truthViewAngle);
  filter->SetCamera(camera);
  filter->SetInputData(scene.Labelled);
  filter->SetLightData(scene.Lamp);
  if (mode != vtkScatteringImageFilter::BruteForce)
  {
    filter->SetConeSetData(scene.Cones());
  }
  if (mode == vtkScatteringImageFilter::Volume)
  {
    vtkNew<vtkVisibilityVolume> volume;
    volume->SetDimensions(9, 9, 9);
    volume->SetBounds(bounds);
    volume->SetLightData(scene.Lamp);
    volume->SetMeshData(scene.Labelled);
    testsupport::Messages messages(volume);
    volume->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(volume->GetOutput());
    filter->SetVisibilityVolumeData(copy);
  }
  return filter;
}

Finding AskImage(const Scene& scene, int mode)
{
  const auto filter = ImageOf(scene, mode);
  Finding asked = Ask(filter, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkPointData* data = filter->GetOutput()->GetPointData();
  const bool exact = mode == vtkScatteringImageFilter::BruteForce || mode == vtkScatteringImageFilter::Guided ||
    mode == vtkScatteringImageFilter::Medium;
  int compared = 0;
  for (int pixel = 0; pixel < truthWidth * truthHeight; ++pixel)
  {
    const int i = pixel % truthWidth;
    const int j = pixel / truthWidth;
    const double nearest = scene.Rays.Nearest(truthEye, PixelDirection(i, j));
    const double depth = ValueOf(data, "Depth", pixel);
    const bool agrees =
      std::isfinite(nearest) ? std::fabs(depth / scene.Mesh.Scale - nearest) < 1e-4 * nearest : depth == -1.0;
    if (!agrees)
    {
      return WrongOf("pixel ", i, ", ", j, " is ", depth, " deep in place of ", nearest * scene.Mesh.Scale);
    }
    if (!exact || pixel % 17 != 5 || scene.Mesh.Corners.size() > 100000)
    {
      continue;
    }
    ++compared;
    const double truth = TrueInScattering(scene.Rays, i, j, lampHeight, lampRadius);
    const double value = ValueOf(data, "InScattering", pixel);
    if (std::fabs(value - truth) > 0.06 * truth + 2e-4)
    {
      return WrongOf("pixel ", i, ", ", j, " scatters ", value, " in place of ", truth);
    }
  }
  return { compared > 0 ? Verdict::Right : Verdict::Sound, {} };
}

Finding AskToneMap(const Scene& scene)
{
  const auto image = ImageOf(scene, vtkScatteringImageFilter::Guided);
  Finding asked = Ask(image, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(image->GetOutput());
  copy->GetPointData()->RemoveArray("RGB");
  const auto filter = Made<vtkToneMapRadiance>::New();
  filter->SetInputData(copy);
  asked = Ask(filter, scene);
  vtkDataArray* now = filter->GetOutput()->GetPointData()->GetArray("RGB");
  vtkDataArray* then = image->GetOutput()->GetPointData()->GetArray("RGB");
  for (vtkIdType k = 0; asked.Kind == Verdict::Sound && k < then->GetNumberOfTuples(); ++k)
  {
    if (!now || now->GetComponent(k, 1) != then->GetComponent(k, 1))
    {
      return Wrong("other colours than those of the image");
    }
    asked.Kind = k + 1 == then->GetNumberOfTuples() ? Verdict::Right : asked.Kind;
  }
  return asked;
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

Finding AskPage(const Scene& scene)
{
  vtkNew<vtkShadowPage> page;
  if (!scene.Mesh.Refusal.empty())
  {
    return {};
  }
  if (scene.Labelled->GetNumberOfPoints() > 0)
  {
    page->AddMesh(scene.Labelled, "mesh");
  }
  if (scene.Cones()->GetNumberOfPoints() > 0)
  {
    page->AddCones(scene.Cones());
  }
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputData(scene.Places);
  probe->SetLightData(scene.Lamp);
  probe->SetMeshData(scene.Labelled);
  const Finding asked = Ask(probe, scene);
  if (asked.Kind != Verdict::Sound)
  {
    return asked;
  }
  page->AddAnswer(vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0)), "Visibility");
  return page->GetPage().find("Visibility") == std::string::npos ? Wrong("a page without the answer") : Finding();
}

} // namespace

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
