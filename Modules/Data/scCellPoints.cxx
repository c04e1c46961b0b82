// SPDX-License-Identifier: BSD-3-Clause
#include "scCellPoints.h"

#include "scSentence.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace shadowcones
{
namespace
{

/// @param first  cells of the data set that come before these
template <typename Offsets, typename Ids>
bool CheckCells(Offsets* offsets, Ids* ids, vtkIdType points, vtkIdType first, std::string& error)
{
  const vtkIdType size = ids->GetNumberOfValues();
  for (vtkIdType i = 0; i + 1 < offsets->GetNumberOfValues(); ++i)
  {
    const vtkIdType begin = offsets->GetValue(i);
    const vtkIdType end = offsets->GetValue(i + 1);
    if (begin < 0 || end < begin || end > size)
    {
      error = Sentence("Cell ", first + i, " is said to go from ", begin, " to ", end, " in a list of ", size, " points.");
      return false;
    }
    for (vtkIdType k = begin; k < end; ++k)
    {
      const vtkIdType id = ids->GetValue(k);
      if (id < 0 || id >= points)
      {
        error = Sentence("Cell ", first + i, " uses point ", id, ", but there are ", points, " points.");
        return false;
      }
    }
  }
  return true;
}

bool CheckCells(vtkCellArray* cells, vtkIdType points, vtkIdType& first, std::string& error)
{
  if (!cells)
  {
    return true;
  }
  const bool right = cells->IsStorage64Bit()
    ? CheckCells(cells->GetOffsetsArray64(), cells->GetConnectivityArray64(), points, first, error)
    : CheckCells(cells->GetOffsetsArray32(), cells->GetConnectivityArray32(), points, first, error);
  first += cells->GetNumberOfCells();
  return right;
}

} // namespace

bool CheckCellPoints(vtkDataObject* data, std::string& error)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      if (!CheckCellPoints(leaves->GetCurrentDataObject(), error))
      {
        return false;
      }
    }
    return true;
  }
  vtkIdType first = 0;
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    const vtkIdType points = mesh->GetNumberOfPoints();
    return CheckCells(mesh->GetVerts(), points, first, error) && CheckCells(mesh->GetLines(), points, first, error) &&
      CheckCells(mesh->GetPolys(), points, first, error) && CheckCells(mesh->GetStrips(), points, first, error);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  return !grid || CheckCells(grid->GetCells(), grid->GetNumberOfPoints(), first, error);
}

} // namespace shadowcones
