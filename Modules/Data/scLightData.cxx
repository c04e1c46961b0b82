// SPDX-License-Identifier: BSD-3-Clause
#include "scLightData.h"

#include "scCellPoints.h"
#include "scFieldArrays.h"
#include "scGhosts.h"
#include "scMeshData.h"
#include "scSentence.h"
#include "scShapeOfMesh.h"
#include "scSpectrum.h"
#include "scSunData.h"
#include "scTuples.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeUInt64Array.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace shadowcones
{
namespace
{

// All values of a field array; count 0: at least one.
bool ReadField(vtkFieldData* data, const char* name, vtkIdType count, std::vector<double>& values, std::string& error)
{
  const std::string quoted = "The light's field array \"" + std::string(name) + "\"";
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    error = quoted + " is missing.";
    return false;
  }
  const vtkIdType size = array->GetNumberOfValues();
  if (count > 0 && size != count)
  {
    error = quoted + " has " + std::to_string(size) + " values; it must have " + std::to_string(count) + ".";
    return false;
  }
  if (size == 0)
  {
    error = quoted + " is empty.";
    return false;
  }
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < size; ++i)
  {
    values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
    if (std::fabs(values.back()) > LargestRadiance)
    {
      error = Sentence(quoted, " holds ", values.back(), ", which is beyond 1e30.");
      return false;
    }
  }
  return true;
}

// The same of one of several lights, @p size values each.
bool ReadField(vtkFieldData* data, const char* name, vtkIdType index, vtkIdType count, vtkIdType size,
  std::vector<double>& values, std::string& error)
{
  std::vector<double> all;
  if (!ReadField(data, name, count * size, all, error))
  {
    return false;
  }
  values.assign(all.begin() + index * size, all.begin() + (index + 1) * size);
  return true;
}

bool ReadVector(
  vtkFieldData* data, const char* name, vtkIdType index, vtkIdType count, Vector3& vector, std::string& error)
{
  std::vector<double> values;
  if (!ReadField(data, name, index, count, 3, values, error))
  {
    return false;
  }
  vector = { values[0], values[1], values[2] };
  return true;
}

bool ReadShapeKind(double value, Light& light, std::string& error)
{
  constexpr int last = static_cast<int>(LightShape::Mesh);
  if (!(value >= 0 && value <= last && value == std::floor(value)))
  {
    error = "The light's field array \"LightShape\" must be a whole number from 0 to " + std::to_string(last) + ".";
    return false;
  }
  light.Shape = static_cast<LightShape>(static_cast<int>(value));
  return true;
}

// The arrays that the shape of one of several lights uses; others may be missing.
bool ReadShape(vtkFieldData* data, vtkIdType index, vtkIdType count, Light& light, std::string& error)
{
  const LightShape shape = light.Shape;
  if (shape != LightShape::Sun && !ReadVector(data, "LightCenter", index, count, light.Center, error))
  {
    return false;
  }
  const bool hasNormal = shape == LightShape::Disc || shape == LightShape::Rectangle || shape == LightShape::Sun;
  if (hasNormal && !ReadVector(data, "LightNormal", index, count, light.Normal, error))
  {
    return false;
  }
  std::vector<double> values;
  if (shape == LightShape::Rectangle)
  {
    if (!ReadField(data, "LightAxes", index, count, 6, values, error))
    {
      return false;
    }
    light.AxisU = { values[0], values[1], values[2] };
    light.AxisV = { values[3], values[4], values[5] };
  }
  else if (shape != LightShape::Point)
  {
    if (!ReadField(data, "LightRadius", index, count, 1, values, error))
    {
      return false;
    }
    light.Radius = values[0];
  }
  std::vector<double> spectra;
  if (!ReadField(data, "LightSpectrum", 0, spectra, error))
  {
    return false;
  }
  const auto size = static_cast<std::ptrdiff_t>(spectra.size()) / count;
  light.Spectrum.assign(spectra.begin() + index * size, spectra.begin() + (index + 1) * size);
  return true;
}

bool Prepare(Light& light, std::string& error)
{
  const char* fault = PrepareLight(light);
  error = fault ? fault : "";
  return !fault;
}

Vector3 PointAt(vtkPoints* points, vtkIdType id)
{
  double x[3];
  points->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

/// The polygons and strips of the mesh that are there.
bool AddTriangles(vtkPolyData* input, Light& light, std::string& error)
{
  TriangleMesh mesh;
  if (!ReadSurface(input, mesh, error))
  {
    error = "The light: " + error;
    return false;
  }
  const TriangleMeshView view = mesh.View();
  for (vtkIdType t = 0; t < view.NumberOfTriangles; ++t)
  {
    light.Triangles.push_back({ view.Corner(t, 0), view.Corner(t, 1), view.Corner(t, 2) });
  }
  return true;
}

/// The vertices of the mesh that are there.
void AddVertices(vtkPolyData* input, Light& light)
{
  const Ghosts cells(input->GetCellData());
  const Ghosts points(input->GetPointData());
  vtkIdType id = 0;
  auto cell = vtk::TakeSmartPointer(input->GetVerts()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell(), ++id)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const bool there = !cells.IsCellHidden(id) && !cells.IsCellDuplicate(id);
    for (vtkIdType i = 0; i < size && there; ++i)
    {
      if (!points.IsPointHidden(ids[i]) && !points.IsPointDuplicate(ids[i]))
      {
        light.Vertices.push_back(PointAt(input->GetPoints(), ids[i]));
      }
    }
  }
}

bool ReadMesh(vtkPolyData* input, Light& light, std::string& error)
{
  light.Shape = LightShape::Mesh;
  const vtkIdType numberOfFaces = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  const double altitude = AltitudeBelowHorizon(input->GetFieldData());
  if (numberOfFaces == 0 && altitude < 0.0)
  {
    error = Sentence("The Sun is below the horizon, at an altitude of ", altitude,
      " degrees: there is no light at this time. Ask for another time of the vtkSunPath.");
    return false;
  }
  if (numberOfFaces == 0 && input->GetNumberOfVerts() == 0)
  {
    error = "The light is empty: it has neither polygons nor vertices.";
    return false;
  }
  const Ghosts hidden(input->GetPointData());
  for (vtkIdType id = 0; id < input->GetNumberOfPoints(); ++id)
  {
    const char* fault = FaultOf(PointAt(input->GetPoints(), id));
    if (fault && !hidden.IsPointHidden(id))
    {
      error = Sentence("Point ", id, " of the light ", fault, ".");
      return false;
    }
  }
  if (numberOfFaces > 0)
  {
    if (!AddTriangles(input, light, error))
    {
      return false;
    }
    if (light.Triangles.empty())
    {
      error = "The light's mesh has zero area.";
      return false;
    }
  }
  else if (CheckCellPoints(input, error))
  {
    AddVertices(input, light);
  }
  else
  {
    error = "The light: " + error;
    return false;
  }
  if (input->GetFieldData()->GetArray("LightSpectrum"))
  {
    return ReadField(input->GetFieldData(), "LightSpectrum", 0, light.Spectrum, error);
  }
  light.Spectrum.assign(DefaultNumberOfWavelengths, 1.0);
  return true;
}

// By how much the light's points may be off: rounding of their type, and of files that are text.
double PointTolerance(vtkPolyData* input, const Light& light)
{
  const bool isDouble = input->GetPoints()->GetDataType() == VTK_DOUBLE;
  const double* b = input->GetBounds();
  const double largest = std::max(
    { std::fabs(b[0]), std::fabs(b[1]), std::fabs(b[2]), std::fabs(b[3]), std::fabs(b[4]), std::fabs(b[5]) });
  const double size = light.Shape == LightShape::Rectangle
    ? std::min(Length(light.AxisU), Length(light.AxisV))
    : light.Radius;
  const double rounding = (isDouble ? 1e-15 : 3e-7) * largest;
  const double text = (isDouble ? 1e-10 : 1e-5) * largest;
  constexpr double largestShare = 1e-3;
  return light.Shape == LightShape::Point ? text : std::max(rounding, std::min(text, largestShare * size));
}

const char* NameOf(LightShape shape)
{
  constexpr const char* names[] = { "Disc", "Rectangle", "Sphere", "Point", "Sun", "Mesh" };
  return names[static_cast<int>(shape)];
}

// Take the direction of the normal of a Sun's vertex, which transforms turn. @return false where it has none.
bool TurnSun(vtkPolyData* input, Light& sun)
{
  constexpr double rounding = 1e-6; // of normals in single precision
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  if (!normals || normals->GetNumberOfTuples() != 1)
  {
    return false;
  }
  const Vector3 normal =
    Normalized({ normals->GetComponent(0, 0), normals->GetComponent(0, 1), normals->GetComponent(0, 2) });
  if (!(Dot(normal, normal) > 0.5))
  {
    return false;
  }
  sun.Normal = Length(normal - sun.Normal) > rounding ? normal : sun.Normal;
  return true;
}

// Points and suns are a vertex; polygons cannot stand for them.
bool FitVertex(vtkPolyData* input, const Light& mesh, double tolerance, Light& light, std::string& error,
  std::string* warning)
{
  const char* name = NameOf(light.Shape);
  if (!mesh.Triangles.empty() || mesh.Vertices.empty() ||
    (light.Shape == LightShape::Sun && mesh.Vertices.size() != 1))
  {
    error = Sentence("The light's \"LightShape\" is ", name, ", which is one vertex, and the light has ",
      mesh.Triangles.size(), " triangles and ", mesh.Vertices.size(),
      " vertices: connect every lamp by itself with AddLightConnection().");
    return false;
  }
  const double distance = Length(mesh.Vertices.front() - light.Center);
  if (light.Shape == LightShape::Point && mesh.Vertices.size() == 1 && distance <= tolerance)
  {
    return true;
  }
  if (light.Shape == LightShape::Sun)
  {
    if (!TurnSun(input, light) && distance > tolerance && warning)
    {
      *warning = Sentence("The vertex of the light, a Sun, lies ", distance,
        " from where it was made: a Sun has a direction and no place, and does not turn with its vertex. Turn the "
        "vtkAreaLightSource itself.");
    }
    return true;
  }
  // A point that was moved is a point still.
  if (mesh.Vertices.size() == 1)
  {
    light.Center = mesh.Vertices.front();
    return true;
  }
  if (warning)
  {
    *warning = Sentence("The light's \"LightShape\" is Point and it has ", mesh.Vertices.size(),
      " vertices: each is a point light of the one intensity in the field data. Connect every lamp by itself with "
      "AddLightConnection().");
  }
  light = mesh;
  return true;
}

// An exact shape is believed where it fits the mesh.
bool FitShape(vtkPolyData* input, Light& light, std::string& error, std::string* warning)
{
  if (input->GetNumberOfPoints() == 0 ||
    input->GetNumberOfPolys() + input->GetNumberOfStrips() + input->GetNumberOfVerts() == 0)
  {
    return true; // there is nothing to hold it against
  }
  Light mesh;
  if (!ReadMesh(input, mesh, error) || !Prepare(mesh, error))
  {
    return false;
  }
  mesh.Spectrum = light.Spectrum;
  if (light.Shape == LightShape::Sun)
  {
    // Its center is read to tell whether it was moved.
    ReadVector(input->GetFieldData(), "LightCenter", 0, 1, light.Center, error);
    light.Center = error.empty() ? light.Center : mesh.Vertices.empty() ? Vector3() : mesh.Vertices.front();
    error.clear();
  }
  const double tolerance = PointTolerance(input, light);
  if (light.Shape == LightShape::Point || light.Shape == LightShape::Sun)
  {
    const bool fits = FitVertex(input, mesh, tolerance, light, error, warning);
    light.Center = light.Shape == LightShape::Sun ? Vector3() : light.Center;
    return fits;
  }
  if (mesh.Triangles.empty())
  {
    error = Sentence("The light's \"LightShape\" is ", NameOf(light.Shape), " and the light has no polygon.");
    return false;
  }
  const ShapeMisfit misfit = MisfitOf(light, mesh.Triangles, tolerance);
  if (IsFit(light, misfit, tolerance) || FindShape(mesh.Triangles, tolerance, light))
  {
    return true;
  }
  if (warning)
  {
    *warning = Sentence("The light's \"LightShape\" is ", NameOf(light.Shape),
      " and does not fit its mesh, which lies up to ", misfit.Distance, " away from it and has ", misfit.Fraction,
      " of its area: the polygons shine instead. Move and scale the vtkAreaLightSource itself, and connect every lamp "
      "by itself with AddLightConnection().");
  }
  light = mesh;
  return true;
}

} // namespace

//------------------------------------------------------------------------------
void WriteLightFieldData(const Light& light, vtkDataObject* output)
{
  vtkNew<vtkIntArray> shape;
  shape->SetName("LightShape");
  shape->InsertNextValue(static_cast<int>(light.Shape));
  vtkFieldData* data = output->GetFieldData();
  data->AddArray(shape);
  AddDoubleArray(data, "LightCenter", 3, { light.Center.X, light.Center.Y, light.Center.Z });
  AddDoubleArray(data, "LightNormal", 3, { light.Normal.X, light.Normal.Y, light.Normal.Z });
  AddDoubleArray(
    data, "LightAxes", 3, { light.AxisU.X, light.AxisU.Y, light.AxisU.Z, light.AxisV.X, light.AxisV.Y, light.AxisV.Z });
  AddDoubleArray(data, "LightRadius", 1, { light.Radius });
  AddDoubleArray(data, "LightSpectrum", 1, light.Spectrum);
}

//------------------------------------------------------------------------------
void WriteSun(const Light& sun, vtkPolyData* output)
{
  SetVertices(output, { sun.Center.X, sun.Center.Y, sun.Center.Z });
  // Transforms turn normals: what is left of a Sun's direction when it was turned as data.
  AddDoubleArray(output->GetPointData(), "Normals", 3, { sun.Normal.X, sun.Normal.Y, sun.Normal.Z });
  output->GetPointData()->SetActiveNormals("Normals");
  WriteLightFieldData(sun, output);
}

//------------------------------------------------------------------------------
void WriteLightFingerprints(const std::vector<Light>& lights, vtkDataObject* output)
{
  vtkNew<vtkTypeUInt64Array> fingerprints;
  fingerprints->SetName("LightFingerprint");
  for (const Light& light : lights)
  {
    fingerprints->InsertNextValue(FingerprintOf(light));
  }
  output->GetFieldData()->AddArray(fingerprints);
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> ReadLightFingerprints(vtkFieldData* data)
{
  std::vector<std::uint64_t> fingerprints;
  vtkAbstractArray* array = data->GetAbstractArray("LightFingerprint");
  for (vtkIdType k = 0; array && k < array->GetNumberOfValues(); ++k)
  {
    fingerprints.push_back(array->GetVariantValue(k).ToTypeUInt64());
  }
  return fingerprints;
}

//------------------------------------------------------------------------------
void RemoveLightFieldData(vtkFieldData* data)
{
  for (const char* name : { "LightShape", "LightCenter", "LightNormal", "LightAxes", "LightRadius", "LightSpectrum",
         "LightWavelengths", "LightFingerprint" })
  {
    data->RemoveArray(name);
  }
}

//------------------------------------------------------------------------------
void WriteLights(const std::vector<Light>& lights, vtkDataObject* output)
{
  vtkFieldData* data = output->GetFieldData();
  RemoveLightFieldData(data); // of a lamp that is an occluder
  WriteLightFingerprints(lights, output);
  if (lights.size() == 1 && lights.front().Shape != LightShape::Mesh)
  {
    WriteLightFieldData(lights.front(), output);
  }
  if (lights.size() < 2)
  {
    return;
  }
  std::vector<int> shapes;
  std::vector<double> centers, normals, axes, radii, spectra;
  const auto append = [](std::vector<double>& values, const Vector3& v)
  { values.insert(values.end(), { v.X, v.Y, v.Z }); };
  for (const Light& light : lights)
  {
    shapes.push_back(static_cast<int>(light.Shape));
    append(centers, light.Center);
    append(normals, light.Normal);
    append(axes, light.AxisU);
    append(axes, light.AxisV);
    radii.push_back(light.Radius);
    spectra.insert(spectra.end(), light.Spectrum.begin(), light.Spectrum.end());
  }
  AddIntArray(data, "LightShape", 1, shapes);
  AddDoubleArray(data, "LightCenter", 3, centers);
  AddDoubleArray(data, "LightNormal", 3, normals);
  AddDoubleArray(data, "LightAxes", 6, axes);
  AddDoubleArray(data, "LightRadius", 1, radii);
  AddDoubleArray(data, "LightSpectrum", static_cast<int>(lights.front().Spectrum.size()), spectra);
}

//------------------------------------------------------------------------------
bool ReadLightShapes(vtkFieldData* data, std::vector<Light>& lights, std::string& error)
{
  lights.clear();
  error.clear();
  vtkDataArray* shapes = data->GetArray("LightShape");
  const vtkIdType count = shapes ? shapes->GetNumberOfValues() : 0;
  std::vector<double> kinds;
  if (count > 0 && !ReadField(data, "LightShape", count, kinds, error))
  {
    return false;
  }
  for (vtkIdType k = 0; k < count; ++k)
  {
    Light light;
    if (!ReadShapeKind(kinds[k], light, error))
    {
      return false;
    }
    if (light.Shape != LightShape::Mesh)
    {
      if (!ReadShape(data, k, count, light, error))
      {
        return false;
      }
      if (const char* fault = PrepareLight(light))
      {
        error = fault;
        return false;
      }
    }
    lights.push_back(std::move(light));
  }
  return true;
}

//------------------------------------------------------------------------------
bool ReadLight(vtkPolyData* input, Light& light, std::string& error, std::string* warning)
{
  light = {};
  error.clear();
  if (!input)
  {
    error = "There is no light.";
    return false;
  }
  if (input->GetFieldData()->HasArray("LightShape"))
  {
    std::vector<double> values;
    if (!ReadField(input->GetFieldData(), "LightShape", 1, values, error) || !ReadShapeKind(values[0], light, error))
    {
      return false;
    }
    if (light.Shape != LightShape::Mesh)
    {
      return ReadShape(input->GetFieldData(), 0, 1, light, error) && Prepare(light, error) &&
        FitShape(input, light, error, warning);
    }
  }
  return ReadMesh(input, light, error) && Prepare(light, error);
}

//------------------------------------------------------------------------------
bool ReadWavelengths(vtkDataObject* data, std::size_t count, std::vector<double>& wavelengths, std::string& error)
{
  vtkDataArray* array = data->GetFieldData()->GetArray("LightWavelengths");
  wavelengths = DefaultWavelengths(static_cast<int>(count));
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != static_cast<vtkIdType>(count))
  {
    return true;
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    wavelengths[k] = array->GetComponent(static_cast<vtkIdType>(k), 0);
    if (!(wavelengths[k] > 0.0) || FaultOf(wavelengths[k]))
    {
      error = Sentence("The field array \"LightWavelengths\" holds ", wavelengths[k],
        ": wavelengths are numbers above 0, in nanometres.");
      return false;
    }
  }
  return true;
}

} // namespace shadowcones
