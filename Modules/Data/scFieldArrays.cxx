// SPDX-License-Identifier: BSD-3-Clause
#include "scFieldArrays.h"

#include "scHandOver.h"
#include "scLargePages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace shadowcones
{
namespace
{

/// Room for so many tuples, not touched yet.
template <typename ArrayT>
void MakeRoom(ArrayT* array, vtkIdType tuples)
{
  array->SetNumberOfTuples(tuples);
  const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
  PreferLargePages(array->GetPointer(0), values * sizeof(*array->GetPointer(0)));
}

template <typename ArrayT, typename T>
void AddArray(vtkFieldData* data, const char* name, int components, const std::vector<T>& values)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  MakeRoom(array.Get(), static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

} // namespace

bool FindArray(vtkFieldData* data, const char* owner, const char* name, int components, vtkIdType tuples, Need need,
  vtkDataArray*& array, std::string& error)
{
  array = data->GetArray(name);
  if (!array && data->GetAbstractArray(name))
  {
    error = std::string("The array \"") + name + "\" of the " + owner + " is not numeric.";
    return false;
  }
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
    error = std::string("The array \"") + name + "\" of the " + owner + " has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples where " + std::to_string(tuples) + " are needed.";
    return false;
  }
  return true;
}

bool CheckAttributes(vtkDataSetAttributes* data, vtkIdType count, const char* what, std::string& error)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const vtkIdType tuples = data->GetAbstractArray(i)->GetNumberOfTuples();
    if (tuples < count)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      error = std::string("The ") + what + " array \"" + (name ? name : "") + "\" has " + std::to_string(tuples) +
        " tuples where " + std::to_string(count) + " are needed.";
      return false;
    }
  }
  return true;
}

void CheckSinglePrecision(const char* name, const std::vector<float>& values)
{
  if (std::any_of(values.begin(), values.end(), [](float value) { return std::isinf(value); }))
  {
    throw std::overflow_error(std::string("a number of \"") + name +
      "\" is beyond 3.4e38, the most that single precision holds; choose another unit of length or of radiance.");
  }
}

void AddFloatArray(vtkFieldData* data, const char* name, int components, const std::vector<float>& values)
{
  CheckSinglePrecision(name, values);
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

void AddIdArray(vtkFieldData* data, const char* name, const std::vector<vtkIdType>& values, int components)
{
  AddArray<vtkIdTypeArray>(data, name, components, values);
}

void AddByteArray(vtkFieldData* data, const char* name, const std::vector<unsigned char>& values, int components)
{
  AddArray<vtkUnsignedCharArray>(data, name, components, values);
}

void SetVertices(vtkPolyData* output, const std::vector<double>& points)
{
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  MakeRoom(coordinates.Get(), count);
  std::copy(points.begin(), points.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkpoints->SetData(coordinates);
  output->SetPoints(vtkpoints);
  output->SetVerts(VerticesOf(count));
}

vtkSmartPointer<vtkCellArray> VerticesOf(vtkIdType count)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  MakeRoom(offsets.Get(), count + 1);
  MakeRoom(connectivity.Get(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetValue(i, i);
    connectivity->SetValue(i, i);
  }
  offsets->SetValue(count, count);
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(offsets, connectivity);
  return vertices;
}

} // namespace shadowcones
