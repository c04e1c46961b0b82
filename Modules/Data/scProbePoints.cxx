// SPDX-License-Identifier: BSD-3-Clause
#include "scProbePoints.h"

#include "scCellPoints.h"
#include "scGhosts.h"
#include "scSentence.h"
#include "scTuples.h"

#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace shadowcones
{

namespace
{

/// The points or cells that are not hidden.
std::vector<vtkIdType> VisibleItems(vtkDataSet* data, bool atCells)
{
  const Ghosts cells(data->GetCellData());
  const Ghosts points(data->GetPointData());
  const vtkIdType count = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  std::vector<vtkIdType> items;
  items.reserve(static_cast<std::size_t>(count));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < count; ++i)
  {
    bool hidden = atCells ? cells.IsCellHidden(i) : points.IsPointHidden(i);
    if (atCells && points.Any())
    {
      data->GetCellPoints(i, corners);
      hidden = hidden ||
        std::any_of(corners->begin(), corners->end(), [&points](vtkIdType id) { return points.IsPointHidden(id); });
    }
    if (!hidden)
    {
      items.push_back(i);
    }
  }
  return items;
}

} // namespace

bool ReadProbePoints(vtkDataSet* data, bool atCells, bool useNormals, ProbePoints& points, std::string& error)
{
  if (atCells && !CheckCellPoints(data, error))
  {
    return false;
  }
  points.NumberOfItems = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  points.Items = VisibleItems(data, atCells);
  points.Points.resize(3 * points.Items.size());
  vtkNew<vtkDoubleArray> centers;
  if (atCells && points.NumberOfItems > 0)
  {
    centers->SetNumberOfComponents(3);
    centers->SetNumberOfTuples(points.NumberOfItems);
    vtkCellCenters::ComputeCellCenters(data, centers);
  }
  for (std::size_t k = 0; k < points.Items.size(); ++k)
  {
    double* p = points.Points.data() + 3 * k;
    if (atCells)
    {
      centers->GetTypedTuple(points.Items[k], p);
    }
    else
    {
      data->GetPoint(points.Items[k], p);
    }
    const Vector3 point{ p[0], p[1], p[2] };
    if (const char* fault = FaultOf(point))
    {
      error = Sentence(atCells ? "The centre of cell " : "Point ", points.Items[k],
        " of the data set on input port 0 has a coordinate that ", fault, ".");
      return false;
    }
    points.Bounds.Add(point);
  }

  vtkDataSetAttributes* attributes =
    atCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  vtkDataArray* normals = useNormals ? attributes->GetNormals() : nullptr;
  if (normals && normals->GetNumberOfTuples() == points.NumberOfItems)
  {
    points.Normals.resize(points.Points.size());
    for (std::size_t k = 0; k < points.Items.size(); ++k)
    {
      normals->GetTuple(points.Items[k], points.Normals.data() + 3 * k);
    }
  }
  vtkPolyData* surface = vtkPolyData::SafeDownCast(data);
  points.OnSurfaces =
    !points.Normals.empty() || (surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0);
  return true;
}

vtkIdType CountOfClass(const VisibilityResult& result, std::size_t lights, ShadowClass kind)
{
  const auto step = static_cast<std::ptrdiff_t>(lights);
  vtkIdType count = 0;
  for (auto at = result.ShadowClasses.begin(); at != result.ShadowClasses.end(); at += step)
  {
    count += std::count(at, at + step, static_cast<unsigned char>(kind)) == step;
  }
  return count;
}

} // namespace shadowcones
