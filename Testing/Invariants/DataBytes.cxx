// SPDX-License-Identifier: BSD-3-Clause
#include "DataBytes.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <set>

namespace invariants
{
namespace
{

/// Field data that tell how long or how much work it was, not what came out.
const std::set<std::string> Volatile = { "RenderSeconds" };

template <typename T>
void Append(std::string& bytes, const T* values, vtkIdType count)
{
  bytes.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(T));
}

std::string Bytes(vtkAbstractArray* array)
{
  std::string bytes;
  for (const int head : { array->GetDataType(), array->GetNumberOfComponents() })
  {
    Append(bytes, &head, 1);
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      bytes += strings->GetValue(i) + '\0';
    }
  }
  else if (array->GetDataTypeSize() > 0)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues()) * static_cast<std::size_t>(array->GetDataTypeSize()));
  }
  return bytes;
}

void AddArrays(vtkFieldData* data, const std::string& prefix, NamedBytes& named)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : std::to_string(i);
    if (Volatile.count(name) == 0)
    {
      named[prefix + name] = Bytes(array);
    }
  }
}

void AddTimes(vtkFieldData* data, const std::string& prefix, std::map<std::string, vtkMTimeType>& times)
{
  times[prefix] = data->GetMTime();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    times[prefix + std::to_string(i)] = data->GetAbstractArray(i)->GetMTime();
  }
}

/// Values of one tuple of each array, behind what is there.
void AddTuples(vtkFieldData* data, vtkIdType tuple, const std::string& prefix, NamedBytes& named)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const auto size = static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize());
    const char* values = static_cast<const char*>(array->GetVoidPointer(0)) + static_cast<std::size_t>(tuple) * size;
    named[prefix + array->GetName()].append(values, size);
  }
}

} // namespace

NamedBytes BytesOf(vtkDataObject* data)
{
  NamedBytes named;
  AddArrays(data->GetFieldData(), "field ", named);
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    AddArrays(table->GetRowData(), "row ", named);
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    return named;
  }
  AddArrays(set->GetPointData(), "point ", named);
  AddArrays(set->GetCellData(), "cell ", named);
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    Append(named["extent"], image->GetExtent(), 6);
    Append(named["spacing"], image->GetSpacing(), 3);
    Append(named["origin"], image->GetOrigin(), 3);
    return named;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
  {
    set->GetCellPoints(cell, ids);
    const vtkIdType type = set->GetCellType(cell);
    Append(named["cells"], &type, 1);
    Append(named["cells"], ids->GetPointer(0), ids->GetNumberOfIds());
  }
  for (vtkIdType point = 0; point < set->GetNumberOfPoints(); ++point)
  {
    double p[3];
    set->GetPoint(point, p);
    Append(named["points"], p, 3);
  }
  return named;
}

NamedBytes CellSoup(vtkDataObject* data)
{
  NamedBytes named;
  auto* set = vtkDataSet::SafeDownCast(data);
  const bool image = vtkImageData::SafeDownCast(data) != nullptr;
  vtkNew<vtkIdList> ids;
  const vtkIdType count = image ? set->GetNumberOfPoints() : set->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    if (image)
    {
      ids->SetNumberOfIds(1);
      ids->SetId(0, cell);
    }
    else
    {
      set->GetCellPoints(cell, ids);
      AddTuples(set->GetCellData(), cell, "cell ", named);
    }
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      double p[3];
      set->GetPoint(ids->GetId(k), p);
      Append(named["points"], p, 3);
      AddTuples(set->GetPointData(), ids->GetId(k), "point ", named);
    }
    const vtkIdType size = ids->GetNumberOfIds();
    Append(named["sizes"], &size, 1);
  }
  return named;
}

NamedBytes BytesOfOutputs(vtkAlgorithm* filter)
{
  NamedBytes all;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    for (const auto& [name, bytes] : BytesOf(filter->GetOutputDataObject(port)))
    {
      all["output " + std::to_string(port) + " " + name] = bytes;
    }
  }
  return all;
}

std::map<std::string, vtkMTimeType> TimesOf(vtkDataObject* data)
{
  std::map<std::string, vtkMTimeType> times{ { "object", data->GetMTime() } };
  AddTimes(data->GetFieldData(), "field ", times);
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    AddTimes(set->GetPointData(), "point ", times);
    AddTimes(set->GetCellData(), "cell ", times);
  }
  if (auto* poly = vtkPolyData::SafeDownCast(data))
  {
    times["points"] = poly->GetPoints() ? poly->GetPoints()->GetMTime() : 0;
    times["polys"] = poly->GetPolys()->GetMTime();
    times["verts"] = poly->GetVerts()->GetMTime();
  }
  return times;
}

std::string Difference(const NamedBytes& a, const NamedBytes& b)
{
  std::string names;
  for (const auto& [name, bytes] : a)
  {
    const auto other = b.find(name);
    if (other == b.end() || other->second != bytes)
    {
      names += name + "; ";
    }
  }
  for (const auto& [name, bytes] : b)
  {
    names += a.count(name) == 0 ? name + " (new); " : "";
  }
  return names;
}

bool IsEmpty(vtkDataObject* data)
{
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    return table->GetNumberOfRows() == 0;
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    return true;
  }
  if (vtkImageData::SafeDownCast(data))
  {
    return set->GetPointData()->GetNumberOfArrays() == 0;
  }
  return set->GetNumberOfPoints() == 0 && set->GetNumberOfCells() == 0;
}

bool AreOutputsEmpty(vtkAlgorithm* filter)
{
  bool empty = true;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    empty = empty && IsEmpty(filter->GetOutputDataObject(port));
  }
  return empty;
}

} // namespace invariants
