// SPDX-License-Identifier: BSD-3-Clause
#include "scFootprintData.h"

#include "scCellPoints.h"
#include "scFieldArrays.h"
#include "scSentence.h"
#include "scTuples.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace shadowcones
{
namespace
{
/// Cells of one kind with what is known of each.
struct LabelledCells
{
  vtkNew<vtkCellArray> Cells;
  std::vector<unsigned char> Classes;
  std::vector<int> OccluderIds;
  std::vector<int> LightIds;

  template <typename Item>
  void Add(const Item& item, vtkIdType firstPoint, std::size_t light, bool closed)
  {
    this->Cells->InsertNextCell(static_cast<int>(item.Points.size()) + (closed ? 1 : 0));
    for (const vtkIdType point : item.Points)
    {
      this->Cells->InsertCellPoint(firstPoint + point);
    }
    if (closed)
    {
      this->Cells->InsertCellPoint(firstPoint + item.Points.front());
    }
    this->Classes.push_back(static_cast<unsigned char>(item.Class));
    this->OccluderIds.push_back(item.OccluderId);
    this->LightIds.push_back(static_cast<int>(light));
  }

  void WriteTo(vtkPolyData* output) const
  {
    AddByteArray(output->GetCellData(), "ShadowClass", this->Classes);
    AddIntArray(output->GetCellData(), "OccluderId", 1, this->OccluderIds);
    AddIntArray(output->GetCellData(), "LightId", 1, this->LightIds);
  }
};

/// The points that cells use, in the order of their use.
class UsedPoints
{
public:
  explicit UsedPoints(const std::vector<double>& all)
    : All(all)
    , Ids(all.size() / 3, -1)
  {
  }
  template <typename Item>
  Item Take(Item item, std::vector<double>& points)
  {
    for (vtkIdType& id : item.Points)
    {
      vtkIdType& used = this->Ids[static_cast<std::size_t>(id)];
      if (used < 0)
      {
        used = this->Count++;
        points.insert(points.end(), this->All.begin() + 3 * id, this->All.begin() + 3 * id + 3);
      }
      id = used;
    }
    return item;
  }

private:
  const std::vector<double>& All;
  std::vector<vtkIdType> Ids;
  vtkIdType Count = 0;
};
} // anonymous namespace

void WriteFootprints(const std::vector<ShadowFootprints>& footprints, vtkPolyData* outlines, vtkPolyData* areas)
{
  LabelledCells lines;
  LabelledCells polygons;
  std::vector<double> linePoints;
  std::vector<double> polygonPoints;
  for (std::size_t light = 0; light < footprints.size(); ++light)
  {
    const ShadowFootprints& found = footprints[light];
    const auto firstOfLines = static_cast<vtkIdType>(linePoints.size() / 3);
    const auto firstOfPolygons = static_cast<vtkIdType>(polygonPoints.size() / 3);
    UsedPoints ofLines(found.Points);
    UsedPoints ofPolygons(found.Points);
    for (const FootprintOutline& outline : found.Outlines)
    {
      lines.Add(ofLines.Take(outline, linePoints), firstOfLines, light, outline.Closed);
    }
    for (const FootprintPolygon& polygon : found.Polygons)
    {
      polygons.Add(ofPolygons.Take(polygon, polygonPoints), firstOfPolygons, light, false);
    }
  }
  SetVertices(outlines, linePoints);
  outlines->SetVerts(nullptr);
  outlines->SetLines(lines.Cells);
  lines.WriteTo(outlines);
  SetVertices(areas, polygonPoints);
  areas->SetVerts(nullptr);
  areas->SetPolys(polygons.Cells);
  polygons.WriteTo(areas);
}

bool ReadOutlines(vtkPolyData* input, std::vector<OutlineRing>& outlines, std::string& error)
{
  outlines.clear();
  vtkDataArray* classes = nullptr;
  vtkDataArray* occluders = nullptr;
  vtkDataArray* lights = nullptr;
  const vtkIdType cells = input->GetNumberOfCells();
  if (!CheckCellPoints(input, error) ||
    !FindArray(input->GetCellData(), "outlines", "ShadowClass", 1, cells, Need::Optional, classes, error) ||
    !FindArray(input->GetCellData(), "outlines", "OccluderId", 1, cells, Need::Optional, occluders, error) ||
    !FindArray(input->GetCellData(), "outlines", "LightId", 1, cells, Need::Optional, lights, error))
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  vtkIdType cell = input->GetNumberOfVerts();
  vtkCellArray* lines = input->GetLines();
  for (lines->InitTraversal(); lines->GetNextCell(ids); ++cell)
  {
    OutlineRing ring;
    const auto read = [cell, &error](vtkDataArray* array, const WholeRange& range, int& value)
    { return !array || ReadWholeNumber(array, "outlines' cell", cell, range, value, error); };
    if (!read(classes, { 0, 2, "0, 1 or 2" }, ring.ShadowClass) || !read(occluders, {}, ring.OccluderId) ||
      !read(lights, {}, ring.LightId))
    {
      return false;
    }
    const vtkIdType count = ids->GetNumberOfIds();
    ring.Closed = count > 1 && ids->GetId(0) == ids->GetId(count - 1);
    for (vtkIdType k = 0; k < count - (ring.Closed ? 1 : 0); ++k)
    {
      double p[3];
      input->GetPoint(ids->GetId(k), p);
      ring.Points.push_back({ p[0], p[1], p[2] });
      if (const char* fault = FaultOf(ring.Points.back()))
      {
        error = Sentence("Point ", ids->GetId(k), " of the outlines has a coordinate that ", fault, ".");
        return false;
      }
    }
    outlines.push_back(std::move(ring));
  }
  return true;
}

} // namespace shadowcones
