// SPDX-License-Identifier: BSD-3-Clause
#include "scLightData.h"

#include "scFieldArrays.h"
#include "scSpectrum.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

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
  }
  return true;
}

bool ReadVector(vtkFieldData* data, const char* name, Vector3& vector, std::string& error)
{
  std::vector<double> values;
  if (!ReadField(data, name, 3, values, error))
  {
    return false;
  }
  vector = { values[0], values[1], values[2] };
  return true;
}

// The arrays that the shape uses; others may be missing.
bool ReadShape(vtkFieldData* data, Light& light, std::string& error)
{
  const LightShape shape = light.Shape;
  if (shape != LightShape::Sun && !ReadVector(data, "LightCenter", light.Center, error))
  {
    return false;
  }
  const bool hasNormal = shape == LightShape::Disc || shape == LightShape::Rectangle || shape == LightShape::Sun;
  if (hasNormal && !ReadVector(data, "LightNormal", light.Normal, error))
  {
    return false;
  }
  std::vector<double> values;
  if (shape == LightShape::Rectangle)
  {
    if (!ReadField(data, "LightAxes", 6, values, error))
    {
      return false;
    }
    light.AxisU = { values[0], values[1], values[2] };
    light.AxisV = { values[3], values[4], values[5] };
  }
  else if (shape != LightShape::Point)
  {
    if (!ReadField(data, "LightRadius", 1, values, error))
    {
      return false;
    }
    light.Radius = values[0];
  }
  return ReadField(data, "LightSpectrum", 0, light.Spectrum, error);
}

Vector3 PointAt(vtkPoints* points, vtkIdType id)
{
  double x[3];
  points->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

void AddPolygons(vtkPolyData* input, Light& light)
{
  vtkPoints* points = input->GetPoints();
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners;
  polygon->GetPoints()->SetDataTypeToDouble();
  auto cell = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* cellIds = nullptr;
    cell->GetCurrentCell(size, cellIds);
    if (size == 3)
    {
      light.Triangles.push_back(
        { PointAt(points, cellIds[0]), PointAt(points, cellIds[1]), PointAt(points, cellIds[2]) });
    }
    else if (size > 3)
    {
      // A polygon may be concave: a fan would count area twice.
      polygon->Initialize(static_cast<int>(size), cellIds, points);
      polygon->Triangulate(0, ids, corners);
      for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
      {
        light.Triangles.push_back(
          { PointAt(points, ids->GetId(i)), PointAt(points, ids->GetId(i + 1)), PointAt(points, ids->GetId(i + 2)) });
      }
    }
  }
}

void AddStrips(vtkPolyData* input, Light& light)
{
  vtkPoints* points = input->GetPoints();
  auto cell = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      // Every second triangle of a strip runs the other way round.
      const vtkIdType flip = i % 2;
      light.Triangles.push_back(
        { PointAt(points, ids[i]), PointAt(points, ids[i + 1 + flip]), PointAt(points, ids[i + 2 - flip]) });
    }
  }
}

bool ReadMesh(vtkPolyData* input, Light& light, std::string& error)
{
  light.Shape = LightShape::Mesh;
  const vtkIdType numberOfFaces = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  if (numberOfFaces == 0 && input->GetNumberOfVerts() == 0)
  {
    error = "The light is empty: it has neither polygons nor vertices.";
    return false;
  }
  for (vtkIdType id = 0; id < input->GetNumberOfPoints(); ++id)
  {
    if (!IsFinite(PointAt(input->GetPoints(), id)))
    {
      error = "Point " + std::to_string(id) + " of the light is not finite.";
      return false;
    }
  }
  if (numberOfFaces > 0)
  {
    AddPolygons(input, light);
    AddStrips(input, light);
    if (light.Triangles.empty())
    {
      error = "The light's mesh has zero area.";
      return false;
    }
  }
  else
  {
    auto cell = vtk::TakeSmartPointer(input->GetVerts()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        light.Vertices.push_back(PointAt(input->GetPoints(), ids[i]));
      }
    }
  }
  if (input->GetFieldData()->GetArray("LightSpectrum"))
  {
    return ReadField(input->GetFieldData(), "LightSpectrum", 0, light.Spectrum, error);
  }
  light.Spectrum.assign(DefaultNumberOfWavelengths, 1.0);
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
bool ReadLight(vtkPolyData* input, Light& light, std::string& error)
{
  light = {};
  error.clear();
  if (!input)
  {
    error = "There is no light.";
    return false;
  }
  std::vector<double> shape;
  constexpr int last = static_cast<int>(LightShape::Mesh);
  bool read = false;
  if (!input->GetFieldData()->HasArray("LightShape"))
  {
    read = ReadMesh(input, light, error);
  }
  else if (ReadField(input->GetFieldData(), "LightShape", 1, shape, error))
  {
    if (!(shape[0] >= 0 && shape[0] <= last))
    {
      error = "The light's field array \"LightShape\" must be from 0 to " + std::to_string(last) + ".";
      return false;
    }
    light.Shape = static_cast<LightShape>(static_cast<int>(shape[0]));
    read =
      light.Shape == LightShape::Mesh ? ReadMesh(input, light, error) : ReadShape(input->GetFieldData(), light, error);
  }
  if (!read)
  {
    return false;
  }
  const char* fault = PrepareLight(light);
  if (fault)
  {
    error = fault;
  }
  return !fault;
}

//------------------------------------------------------------------------------
std::vector<double> ReadWavelengths(vtkPolyData* light, std::size_t count)
{
  vtkDataArray* array = light->GetFieldData()->GetArray("LightWavelengths");
  std::vector<double> wavelengths = DefaultWavelengths(static_cast<int>(count));
  if (array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == static_cast<vtkIdType>(count))
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      wavelengths[k] = array->GetComponent(static_cast<vtkIdType>(k), 0);
    }
  }
  return wavelengths;
}

} // namespace shadowcones
