// SPDX-License-Identifier: BSD-3-Clause
#include "scDataFingerprint.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

namespace shadowcones
{
namespace
{
void AddText(const char* text, Fingerprint& fingerprint)
{
  fingerprint.AddBytes(text ? text : "", text ? std::strlen(text) : 0);
}

void AddArrays(vtkFieldData* data, Fingerprint& fingerprint)
{
  fingerprint.AddWord(static_cast<std::uint64_t>(data->GetNumberOfArrays()));
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    AddText(data->GetAbstractArray(i)->GetName(), fingerprint);
    AddArray(data->GetAbstractArray(i), fingerprint);
  }
}

/// Cells by their points, whatever way they are stored.
void AddCells(vtkCellArray* cells, Fingerprint& fingerprint)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  fingerprint.AddWord(static_cast<std::uint64_t>(cells->GetNumberOfCells()));
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(count, ids);
    fingerprint.AddBytes(ids, static_cast<std::size_t>(count) * sizeof(vtkIdType));
  }
}

void AddSet(vtkDataSet* set, Fingerprint& fingerprint)
{
  auto* points = vtkPointSet::SafeDownCast(set);
  if (points && points->GetPoints())
  {
    AddArray(points->GetPoints()->GetData(), fingerprint);
  }
  if (auto* image = vtkImageData::SafeDownCast(set))
  {
    fingerprint.AddBytes(image->GetExtent(), 6 * sizeof(int));
    fingerprint.AddBytes(image->GetOrigin(), 3 * sizeof(double));
    fingerprint.AddBytes(image->GetSpacing(), 3 * sizeof(double));
  }
  else if (auto* poly = vtkPolyData::SafeDownCast(set))
  {
    for (vtkCellArray* cells : { poly->GetVerts(), poly->GetLines(), poly->GetPolys(), poly->GetStrips() })
    {
      AddCells(cells, fingerprint);
    }
  }
  else
  {
    vtkSmartPointer<vtkIdList> ids = vtkSmartPointer<vtkIdList>::New();
    fingerprint.AddWord(static_cast<std::uint64_t>(set->GetNumberOfCells()));
    for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
    {
      set->GetCellPoints(cell, ids);
      fingerprint.AddWord(static_cast<std::uint64_t>(set->GetCellType(cell)));
      fingerprint.AddBytes(ids->GetPointer(0), static_cast<std::size_t>(ids->GetNumberOfIds()) * sizeof(vtkIdType));
    }
  }
  AddArrays(set->GetPointData(), fingerprint);
  AddArrays(set->GetCellData(), fingerprint);
}
} // anonymous namespace

void AddArray(vtkAbstractArray* array, Fingerprint& fingerprint)
{
  fingerprint.AddWord(static_cast<std::uint64_t>(array->GetDataType()));
  fingerprint.AddWord(static_cast<std::uint64_t>(array->GetNumberOfComponents()));
  if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
    {
      AddText(texts->GetValue(i).c_str(), fingerprint);
    }
    return;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers && numbers->HasStandardMemoryLayout() && numbers->GetDataType() != VTK_BIT)
  {
    fingerprint.AddBytes(numbers->GetVoidPointer(0),
      static_cast<std::size_t>(numbers->GetNumberOfValues()) * static_cast<std::size_t>(numbers->GetDataTypeSize()));
    return;
  }
  const vtkIdType tuples = numbers ? numbers->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      fingerprint.AddNumber(numbers->GetComponent(i, c));
    }
  }
}

void AddData(vtkDataObject* data, Fingerprint& fingerprint)
{
  AddText(data ? data->GetClassName() : "", fingerprint);
  if (!data)
  {
    return;
  }
  AddArrays(data->GetFieldData(), fingerprint);
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    auto leaves = vtk::TakeSmartPointer(tree->NewTreeIterator());
    leaves->SkipEmptyNodesOff();
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      AddData(leaves->GetCurrentDataObject(), fingerprint);
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    AddSet(set, fingerprint);
  }
}

} // namespace shadowcones
