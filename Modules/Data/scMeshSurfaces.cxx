// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshSurfaces.h"

#include "scCellPoints.h"
#include "scGhosts.h"
#include "scSentence.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{

constexpr const char* originalCells = "vtkOriginalCellIds";

/// 1 for each cell that is there; nullptr where all are.
vtkSmartPointer<vtkUnsignedCharArray> CellsThatAreThere(vtkDataSet* data)
{
  const Ghosts cells(data->GetCellData());
  const Ghosts points(data->GetPointData());
  if (!cells.Any() && !points.Any())
  {
    return nullptr;
  }
  auto there = vtkSmartPointer<vtkUnsignedCharArray>::New();
  there->SetName("IsThere");
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    const bool hidden = cells.IsCellHidden(cell) || cells.IsCellDuplicate(cell) ||
      std::any_of(corners->begin(), corners->end(), [&points](vtkIdType id) { return points.IsPointHidden(id); });
    there->InsertNextValue(hidden ? 0 : 1);
  }
  return there;
}

/// The cells that are there, alone.
vtkSmartPointer<vtkDataSet> WithoutGhosts(vtkDataSet* data)
{
  const auto there = CellsThatAreThere(data);
  if (!there)
  {
    return data;
  }
  vtkSmartPointer<vtkDataSet> marked = vtk::TakeSmartPointer(data->NewInstance());
  marked->ShallowCopy(data);
  // Marks may not make anything else out of the cells that are left.
  marked->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  marked->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  marked->GetCellData()->AddArray(there);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(marked);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, there->GetName());
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
  threshold->SetLowerThreshold(0.5);
  threshold->SetUpperThreshold(1.5);
  threshold->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  threshold->Update();
  threshold->GetOutput()->GetCellData()->RemoveArray(there->GetName());
  return threshold->GetOutput();
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataSet* data)
{
  vtkSmartPointer<vtkDataSet> numbered = vtk::TakeSmartPointer(data->NewInstance());
  numbered->ShallowCopy(data);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(originalCells);
  ids->SetNumberOfValues(data->GetNumberOfCells());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), 0);
  numbered->GetCellData()->AddArray(ids);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(WithoutGhosts(numbered));
  // What it delegates to orders faces by threads.
  surface->DelegationOff();
  surface->Update();
  return surface->GetOutput();
}

/// The poly data of one data set, which may be it itself.
vtkSmartPointer<vtkPolyData> PolyDataOf(vtkDataSet* data, vtkIdType& extracted)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    return polyData;
  }
  ++extracted;
  return SurfaceOf(data);
}

/// Blocks in the same places, surfaces for data sets. What is none is left for others to complain of.
vtkSmartPointer<vtkDataObject> SurfacesOfTree(vtkDataObjectTree* tree, vtkIdType& extracted)
{
  auto surfaces = vtk::TakeSmartPointer(tree->NewInstance());
  surfaces->CopyStructure(tree);
  auto iterator = vtk::TakeSmartPointer(tree->NewIterator());
  const vtkIdType before = extracted;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* block = iterator->GetCurrentDataObject();
    auto* data = vtkDataSet::SafeDownCast(block);
    const vtkSmartPointer<vtkPolyData> surface = data ? PolyDataOf(data, extracted) : nullptr;
    surfaces->SetDataSet(iterator, surface ? surface.Get() : block);
  }
  return extracted > before ? vtkSmartPointer<vtkDataObject>(surfaces) : vtkSmartPointer<vtkDataObject>(tree);
}

/// Grids that refine each other, as blocks one after the other.
vtkSmartPointer<vtkDataObject> SurfacesOfGrids(vtkCompositeDataSet* grids, vtkIdType& extracted)
{
  vtkNew<vtkMultiBlockDataSet> surfaces;
  auto iterator = vtk::TakeSmartPointer(grids->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* data = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    const vtkSmartPointer<vtkPolyData> surface = data ? PolyDataOf(data, extracted) : nullptr;
    if (surface && surface->GetNumberOfCells() > 0)
    {
      surfaces->SetBlock(surfaces->GetNumberOfBlocks(), surface);
    }
  }
  return surfaces.Get();
}

} // anonymous namespace

void AcceptDataSets(vtkInformation* portInformation)
{
  portInformation->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

vtkSmartPointer<vtkDataObject> SurfacesOf(vtkDataObject* input, vtkIdType& extracted, std::string& error)
{
  extracted = 0;
  if (!CheckCellPoints(input, error))
  {
    return nullptr;
  }
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    return PolyDataOf(data, extracted);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    return SurfacesOfTree(tree, extracted);
  }
  if (auto* grids = vtkCompositeDataSet::SafeDownCast(input))
  {
    return SurfacesOfGrids(grids, extracted);
  }
  error = input ? Sentence("A ", input->GetClassName(), " is no mesh: give a data set, or blocks of them.")
                : std::string("There is no mesh.");
  return nullptr;
}

} // namespace shadowcones
