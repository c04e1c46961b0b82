// SPDX-License-Identifier: BSD-3-Clause
#include "scAdapters.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{
namespace
{

std::string Number(vtkIdType value)
{
  return std::to_string(value);
}

void CopyPoints(vtkPolyData* input, std::vector<double>& points)
{
  const vtkIdType count = input->GetNumberOfPoints();
  points.resize(3 * static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, points.data() + 3 * i);
  }
}

/// Triangles of one polygon, as indices into its corners.
class PolygonTriangulator
{
public:
  void Triangulate(const double* points, vtkIdType count, const vtkIdType* ids, std::vector<int>& triangles)
  {
    triangles.clear();
    if (count == 3)
    {
      triangles = { 0, 1, 2 };
    }
    else if (count == 4)
    {
      this->TriangulateQuad(points, ids, triangles);
    }
    else if (count > 4)
    {
      this->CutEars(points, count, ids, triangles);
    }
  }

private:
  static Vector3 At(const double* points, vtkIdType id)
  {
    return { points[3 * id], points[3 * id + 1], points[3 * id + 2] };
  }

  static void TriangulateQuad(const double* points, const vtkIdType* ids, std::vector<int>& triangles)
  {
    const Vector3 origin = At(points, ids[0]);
    const Vector3 corner[4] = { {}, At(points, ids[1]) - origin, At(points, ids[2]) - origin,
      At(points, ids[3]) - origin };
    const auto agreement = [&corner](int a, int b, int c, int d)
    {
      const Vector3 first = Cross(corner[b] - corner[a], corner[c] - corner[a]);
      const Vector3 second = Cross(corner[c] - corner[a], corner[d] - corner[a]);
      return Dot(first, second);
    };
    // A diagonal outside a concave quad gives two triangles that face opposite ways; else the shorter one is the
    // better.
    const double even = agreement(0, 1, 2, 3);
    const double odd = agreement(1, 2, 3, 0);
    const bool evenValid = even > 0.0;
    const bool oddValid = odd > 0.0;
    const bool oddShorter = Length(corner[1] - corner[3]) < Length(corner[0] - corner[2]);
    if (oddValid && (!evenValid || oddShorter))
    {
      triangles = { 1, 2, 3, 1, 3, 0 };
    }
    else
    {
      triangles = { 0, 1, 2, 0, 2, 3 };
    }
  }

  void CutEars(const double* points, vtkIdType count, const vtkIdType* ids, std::vector<int>& triangles)
  {
    // Centred and scaled, because vtkPolygon's tolerances suit coordinates near the origin.
    const Vector3 origin = At(points, ids[0]);
    double size = 0.0;
    for (vtkIdType i = 1; i < count; ++i)
    {
      size = std::max(size, Length(At(points, ids[i]) - origin));
    }
    const double scale = size > 0.0 ? 1.0 / size : 1.0;
    this->Polygon->Points->SetDataTypeToDouble();
    this->Polygon->Points->SetNumberOfPoints(count);
    this->Polygon->PointIds->SetNumberOfIds(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const Vector3 p = scale * (At(points, ids[i]) - origin);
      this->Polygon->Points->SetPoint(i, p.X, p.Y, p.Z);
      this->Polygon->PointIds->SetId(i, i);
    }
    if (size > 0.0 && this->Polygon->EarCutTriangulation(this->Corners) &&
      this->Corners->GetNumberOfIds() == 3 * (count - 2))
    {
      for (vtkIdType i = 0; i < this->Corners->GetNumberOfIds(); ++i)
      {
        triangles.push_back(static_cast<int>(this->Corners->GetId(i)));
      }
      return;
    }
    // Degenerate or self-intersecting: a fan keeps its outline.
    for (int i = 1; i + 1 < count; ++i)
    {
      triangles.insert(triangles.end(), { 0, i, i + 1 });
    }
  }

  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
};

/// The cell's points are there and finite; else a sentence.
bool CheckCell(
  const std::vector<double>& points, vtkIdType cell, vtkIdType count, const vtkIdType* ids, std::string& error)
{
  const auto numberOfPoints = static_cast<vtkIdType>(points.size() / 3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType id = ids[i];
    if (id < 0 || id >= numberOfPoints)
    {
      error =
        "Cell " + Number(cell) + " uses point " + Number(id) + ", but there are " + Number(numberOfPoints) + " points.";
      return false;
    }
    if (!std::isfinite(points[3 * id]) || !std::isfinite(points[3 * id + 1]) || !std::isfinite(points[3 * id + 2]))
    {
      error = "Point " + Number(id) + ", used by cell " + Number(cell) + ", has a coordinate that is not finite.";
      return false;
    }
  }
  return true;
}

enum class Need
{
  Required,
  Optional
};

/// Find a numeric array of the right shape. @return false where it is missing but required, or has the wrong size.
bool FindArray(vtkFieldData* data, const char* owner, const char* name, int components, vtkIdType tuples, Need need,
  vtkDataArray*& array, std::string& error)
{
  array = data->GetArray(name);
  if (!array)
  {
    if (need == Need::Required)
    {
      error = std::string("The ") + owner + " has no array \"" + name + "\".";
      return false;
    }
    return true;
  }
  if (array->GetNumberOfComponents() != components)
  {
    error = std::string("The array \"") + name + "\" of the " + owner + " has " +
      std::to_string(array->GetNumberOfComponents()) + " components where " + std::to_string(components) +
      " are needed.";
    return false;
  }
  if (array->GetNumberOfTuples() != tuples)
  {
    error = std::string("The array \"") + name + "\" of the " + owner + " has " + Number(array->GetNumberOfTuples()) +
      " tuples where " + Number(tuples) + " are needed.";
    return false;
  }
  return true;
}

void CopyInts(vtkDataArray* array, std::vector<int>& values)
{
  values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values[i] = static_cast<int>(array->GetComponent(i, 0));
  }
}

/// Finite triples; @p item names one of them in messages.
template <typename T>
bool CopyTriples(vtkDataArray* array, const char* item, std::vector<T>& values, std::string& error)
{
  values.resize(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = array->GetComponent(i, c);
      if (!std::isfinite(value))
      {
        error = std::string("The \"") + array->GetName() + "\" of " + item + " " + Number(i) + " is not finite.";
        return false;
      }
      values[3 * i + c] = static_cast<T>(value);
    }
  }
  return true;
}

/// Lengths this close to 1 are rounding, and are put right.
constexpr double UnitTolerance = 1e-3;

bool ReadUnitVector(vtkDataArray* array, const char* item, vtkIdType i, Vector3& vector, std::string& error)
{
  vector = { array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
  const double length = Length(vector);
  if (!(std::abs(length - 1.0) <= UnitTolerance))
  {
    error = std::string("The \"") + array->GetName() + "\" of " + item + " " + Number(i) +
      (std::isfinite(length) ? " has the length " + std::to_string(length) + ", not 1." : " is not finite.");
    return false;
  }
  vector = Normalized(vector);
  return true;
}

/// Directions that already are unit in single precision keep their bytes.
bool CopyDirections(vtkDataArray* array, const char* item, std::vector<float>& directions, std::string& error)
{
  constexpr double singlePrecision = 1e-6;
  directions.resize(3 * static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    Vector3 unit;
    if (!ReadUnitVector(array, item, i, unit, error))
    {
      return false;
    }
    const Vector3 given{ array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2) };
    const Vector3& kept = std::abs(Length(given) - 1.0) < singlePrecision ? given : unit;
    for (int c = 0; c < 3; ++c)
    {
      directions[3 * i + c] = static_cast<float>(kept[c]);
    }
  }
  return true;
}

bool CopyFinitePoints(vtkPolyData* input, const char* item, std::vector<double>& points, std::string& error)
{
  CopyPoints(input, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::isfinite(points[i]))
    {
      error = std::string("The position of ") + item + " " + std::to_string(i / 3) + " is not finite.";
      return false;
    }
  }
  return true;
}

bool CheckCone(const Cone& cone, vtkIdType i, std::string& error)
{
  const std::string ofCone = " of cone " + Number(i);
  if (!IsFinite(cone.Center))
  {
    error = "The position" + ofCone + " is not finite.";
  }
  else if (!std::isfinite(cone.BaseRadius) || cone.BaseRadius < 0.0)
  {
    error = "The \"BaseRadius\"" + ofCone + " is " + std::to_string(cone.BaseRadius) +
      ": it must be finite and not negative.";
  }
  else if (!(std::abs(cone.HalfAngle) < std::acos(0.0)))
  {
    error =
      "The \"HalfAngle\"" + ofCone + " is " + std::to_string(cone.HalfAngle) + ": it must lie between -pi/2 and pi/2.";
  }
  else if (!(std::abs(cone.InnerHalfAngle) < std::acos(0.0)))
  {
    error = "The \"InnerHalfAngle\"" + ofCone + " is " + std::to_string(cone.InnerHalfAngle) +
      ": it must lie between -pi/2 and pi/2.";
  }
  else if (!std::isfinite(cone.Planarity) || !std::isfinite(cone.Overspill))
  {
    error = "The \"Planarity\" or \"Overspill\"" + ofCone + " is not finite.";
  }
  else
  {
    return true;
  }
  return false;
}

template <typename ArrayT, typename T>
void AddArray(vtkFieldData* data, const char* name, int components, const std::vector<T>& values)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

} // namespace

Monitor MonitorOf(vtkAlgorithm* algorithm)
{
  Monitor monitor;
  monitor.Progress = [algorithm](double share) { algorithm->UpdateProgress(share); };
  monitor.Aborted = [algorithm]() { return algorithm->GetAbortExecute() != 0; };
  return monitor;
}

TriangleMeshView TriangleMesh::View() const
{
  TriangleMeshView view;
  view.Points = this->Points.data();
  view.NumberOfPoints = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Triangles = this->Triangles.data();
  view.NumberOfTriangles = static_cast<vtkIdType>(this->Triangles.size() / 3);
  view.OccluderIds = this->OccluderIds.empty() ? nullptr : this->OccluderIds.data();
  return view;
}

bool ReadTriangles(vtkPolyData* input, TriangleMesh& mesh, std::string& error)
{
  mesh = TriangleMesh();
  if (!input)
  {
    error = "There is no mesh.";
    return false;
  }
  CopyPoints(input, mesh.Points);
  const auto addTriangle = [&mesh](vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    mesh.Triangles.insert(mesh.Triangles.end(), { a, b, c });
    mesh.SourceCells.push_back(cell);
  };
  mesh.Triangles.reserve(3 * static_cast<std::size_t>(input->GetNumberOfPolys()));
  mesh.SourceCells.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));

  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  PolygonTriangulator triangulator;
  std::vector<int> corners;
  auto polys = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell(), ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCurrentCell(count, ids);
    if (!CheckCell(mesh.Points, cell, count, ids, error))
    {
      return false;
    }
    triangulator.Triangulate(mesh.Points.data(), count, ids, corners);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    {
      addTriangle(cell, ids[corners[i]], ids[corners[i + 1]], ids[corners[i + 2]]);
    }
  }
  auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    strips->GetCurrentCell(count, ids);
    if (!CheckCell(mesh.Points, cell, count, ids, error))
    {
      return false;
    }
    for (vtkIdType i = 0; i + 2 < count; ++i)
    {
      addTriangle(cell, ids[i], ids[i % 2 ? i + 2 : i + 1], ids[i % 2 ? i + 1 : i + 2]);
    }
  }

  vtkDataArray* occluderIds = nullptr;
  if (!FindArray(
        input->GetCellData(), "mesh", "OccluderId", 1, input->GetNumberOfCells(), Need::Optional, occluderIds, error))
  {
    return false;
  }
  if (occluderIds)
  {
    std::vector<int> perCell;
    CopyInts(occluderIds, perCell);
    mesh.OccluderIds.reserve(mesh.SourceCells.size());
    for (const vtkIdType source : mesh.SourceCells)
    {
      mesh.OccluderIds.push_back(perCell[source]);
    }
  }
  return true;
}

bool ReadConeSet(vtkPolyData* input, std::vector<Cone>& cones, std::string& error)
{
  cones.clear();
  if (!input)
  {
    error = "There is no cone set.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  const auto find = [&](const char* name, int components, Need need, vtkDataArray*& array)
  { return FindArray(data, "cone set", name, components, count, need, array, error); };

  vtkDataArray *axes, *radii, *angles, *innerAngles, *normals, *occluderIds, *vectorCounts, *planarities, *overspills;
  if (!find("Axis", 3, Need::Required, axes) || !find("BaseRadius", 1, Need::Required, radii) ||
    !find("HalfAngle", 1, Need::Required, angles) || !find("InnerHalfAngle", 1, Need::Optional, innerAngles) ||
    !find("Normal", 3, Need::Optional, normals) || !find("OccluderId", 1, Need::Optional, occluderIds) ||
    !find("VectorCount", 1, Need::Optional, vectorCounts) || !find("Planarity", 1, Need::Optional, planarities) ||
    !find("Overspill", 1, Need::Optional, overspills))
  {
    return false;
  }

  std::vector<Cone> read(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    Cone& cone = read[i];
    double center[3];
    input->GetPoint(i, center);
    cone.Center = { center[0], center[1], center[2] };
    if (!ReadUnitVector(axes, "cone", i, cone.Axis, error) ||
      (normals && !ReadUnitVector(normals, "cone", i, cone.Normal, error)))
    {
      return false;
    }
    cone.Normal = normals ? cone.Normal : cone.Axis;
    cone.BaseRadius = radii->GetComponent(i, 0);
    cone.HalfAngle = angles->GetComponent(i, 0);
    cone.InnerHalfAngle = innerAngles ? innerAngles->GetComponent(i, 0) : -std::abs(cone.HalfAngle);
    cone.OccluderId = occluderIds ? static_cast<int>(occluderIds->GetComponent(i, 0)) : 0;
    cone.VectorCount = vectorCounts ? static_cast<int>(vectorCounts->GetComponent(i, 0)) : 0;
    cone.Planarity = planarities ? planarities->GetComponent(i, 0) : 0.0;
    cone.Overspill = overspills ? overspills->GetComponent(i, 0) : -1.0;
    if (!CheckCone(cone, i, error))
    {
      return false;
    }
  }
  cones = std::move(read);
  return true;
}

void DropReceivers(TriangleMesh& mesh)
{
  if (mesh.OccluderIds.empty())
  {
    return;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.OccluderIds.size(); ++i)
  {
    if (mesh.OccluderIds[i] >= 0)
    {
      std::copy_n(mesh.Triangles.begin() + 3 * i, 3, mesh.Triangles.begin() + 3 * kept);
      mesh.SourceCells[kept] = mesh.SourceCells[i];
      mesh.OccluderIds[kept++] = mesh.OccluderIds[i];
    }
  }
  mesh.OccluderIds.resize(kept);
  mesh.SourceCells.resize(kept);
  mesh.Triangles.resize(3 * kept);
}

void UndoCosineCorrection(vtkFieldData* parameters, std::vector<Cone>& cones)
{
  constexpr double smallestCosine = 0.05;
  vtkDataArray* correction = parameters->GetArray("CosineCorrection");
  if (!correction || correction->GetNumberOfTuples() < 1 || correction->GetComponent(0, 0) == 0.0)
  {
    return;
  }
  for (Cone& cone : cones)
  {
    cone.BaseRadius /= std::max(std::abs(Dot(cone.Axis, cone.Normal)), smallestCosine);
  }
}

void WriteConeSet(const std::vector<Cone>& cones, vtkPolyData* output)
{
  std::vector<double> centers;
  std::vector<float> axes, radii, angles, innerAngles, normals, planarities, overspills;
  std::vector<int> occluderIds, vectorCounts;
  for (const Cone& cone : cones)
  {
    for (int c = 0; c < 3; ++c)
    {
      centers.push_back(cone.Center[c]);
      axes.push_back(static_cast<float>(cone.Axis[c]));
      normals.push_back(static_cast<float>(cone.Normal[c]));
    }
    radii.push_back(static_cast<float>(cone.BaseRadius));
    angles.push_back(static_cast<float>(cone.HalfAngle));
    innerAngles.push_back(static_cast<float>(cone.InnerHalfAngle));
    occluderIds.push_back(cone.OccluderId);
    vectorCounts.push_back(cone.VectorCount);
    planarities.push_back(static_cast<float>(cone.Planarity));
    overspills.push_back(static_cast<float>(cone.Overspill));
  }
  SetVertices(output, centers);
  vtkPointData* data = output->GetPointData();
  AddFloatArray(data, "Axis", 3, axes);
  AddFloatArray(data, "BaseRadius", 1, radii);
  AddFloatArray(data, "HalfAngle", 1, angles);
  AddFloatArray(data, "InnerHalfAngle", 1, innerAngles);
  AddFloatArray(data, "Normal", 3, normals);
  AddIntArray(data, "OccluderId", 1, occluderIds);
  AddIntArray(data, "VectorCount", 1, vectorCounts);
  AddFloatArray(data, "Planarity", 1, planarities);
  AddFloatArray(data, "Overspill", 1, overspills);
}

ShadowVectorView ShadowVectorArrays::View() const
{
  ShadowVectorView view;
  view.Count = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Points = this->Points.data();
  view.Directions = this->Directions.data();
  view.EmissionPoints = this->EmissionPoints.empty() ? nullptr : this->EmissionPoints.data();
  view.OccluderIds = this->OccluderIds.empty() ? nullptr : this->OccluderIds.data();
  return view;
}

bool ReadShadowVectors(vtkPolyData* input, ShadowVectorArrays& vectors, std::string& error, bool needEmissionPoints)
{
  vectors = ShadowVectorArrays();
  if (!input)
  {
    error = "There are no shadow vectors.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  const Need emission = needEmissionPoints ? Need::Required : Need::Optional;
  vtkDataArray *directions, *emissionPoints, *occluderIds;
  if (!FindArray(data, "shadow-vector input", "Direction", 3, count, Need::Required, directions, error) ||
    !FindArray(data, "shadow-vector input", "EmissionPoint", 3, count, emission, emissionPoints, error) ||
    !FindArray(data, "shadow-vector input", "OccluderId", 1, count, Need::Optional, occluderIds, error))
  {
    return false;
  }
  ShadowVectorArrays read;
  if (!CopyFinitePoints(input, "shadow vector", read.Points, error) ||
    !CopyDirections(directions, "shadow vector", read.Directions, error) ||
    (emissionPoints && !CopyTriples(emissionPoints, "shadow vector", read.EmissionPoints, error)))
  {
    return false;
  }
  if (occluderIds)
  {
    CopyInts(occluderIds, read.OccluderIds);
  }
  vectors = std::move(read);
  return true;
}

PhotonPathView PhotonPathArrays::View() const
{
  PhotonPathView view;
  view.Count = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Points = this->Points.data();
  view.EmissionPoints = this->EmissionPoints.data();
  view.Directions = this->Directions.data();
  view.States = this->States.data();
  return view;
}

bool ReadPhotonPaths(vtkPolyData* input, PhotonPathArrays& paths, std::string& error)
{
  paths = PhotonPathArrays();
  if (!input)
  {
    error = "There are no photon paths.";
    return false;
  }
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  vtkPointData* data = input->GetPointData();
  vtkDataArray *states, *emissionPoints, *directions;
  if (!FindArray(data, "photon-path input", "PathState", 1, count, Need::Required, states, error) ||
    !FindArray(data, "photon-path input", "EmissionPoint", 3, count, Need::Required, emissionPoints, error) ||
    !FindArray(data, "photon-path input", "Direction", 3, count, Need::Required, directions, error))
  {
    return false;
  }
  PhotonPathArrays read;
  if (!CopyFinitePoints(input, "photon path", read.Points, error) ||
    !CopyTriples(emissionPoints, "photon path", read.EmissionPoints, error) ||
    !CopyDirections(directions, "photon path", read.Directions, error))
  {
    return false;
  }
  CopyInts(states, read.States);
  const auto wrong =
    std::find_if(read.States.begin(), read.States.end(), [](int state) { return state != 0 && state != 1; });
  if (wrong != read.States.end())
  {
    error = "The \"PathState\" of photon path " + std::to_string(wrong - read.States.begin()) + " is " +
      std::to_string(*wrong) + ": it must be 0 (lit) or 1 (blocked).";
    return false;
  }
  paths = std::move(read);
  return true;
}

bool CheckPointArrays(vtkPolyData* input, std::string& error)
{
  vtkPointData* data = input->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const vtkIdType tuples = data->GetAbstractArray(i)->GetNumberOfTuples();
    if (tuples < input->GetNumberOfPoints())
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      error = std::string("The point array \"") + (name ? name : "") + "\" has " + Number(tuples) + " tuples where " +
        Number(input->GetNumberOfPoints()) + " are needed.";
      return false;
    }
  }
  return true;
}

void AddFloatArray(vtkFieldData* data, const char* name, int components, const std::vector<float>& values)
{
  AddArray<vtkFloatArray>(data, name, components, values);
}

void AddDoubleArray(vtkFieldData* data, const char* name, int components, const std::vector<double>& values)
{
  AddArray<vtkDoubleArray>(data, name, components, values);
}

void AddIntArray(vtkFieldData* data, const char* name, int components, const std::vector<int>& values)
{
  AddArray<vtkIntArray>(data, name, components, values);
}

void AddIdArray(vtkFieldData* data, const char* name, const std::vector<vtkIdType>& values)
{
  AddArray<vtkIdTypeArray>(data, name, 1, values);
}

void SetVertices(vtkPolyData* output, const std::vector<double>& points)
{
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  std::copy(points.begin(), points.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkpoints->SetData(coordinates);

  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(count + 1);
  connectivity->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetValue(i, i);
    connectivity->SetValue(i, i);
  }
  offsets->SetValue(count, count);
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, connectivity);
  output->SetPoints(vtkpoints);
  output->SetVerts(vertices);
}

} // namespace shadowcones
