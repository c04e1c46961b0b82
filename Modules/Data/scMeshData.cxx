// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshData.h"

#include "scFieldArrays.h"
#include "scSentence.h"
#include "scTuples.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{

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
      error = Sentence("Cell ", cell, " uses point ", id, ", but there are ", numberOfPoints, " points.");
      return false;
    }
    if (!std::isfinite(points[3 * id]) || !std::isfinite(points[3 * id + 1]) || !std::isfinite(points[3 * id + 2]))
    {
      error = Sentence("Point ", id, ", used by cell ", cell, ", has a coordinate that is not finite.");
      return false;
    }
  }
  return true;
}

} // namespace

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

bool ReadReflectance(vtkPolyData* mesh, const std::vector<vtkIdType>& sourceCells, std::size_t wavelengths,
  SurfaceReflectance& reflectance, std::string& error)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray("Reflectance");
  if (!array)
  {
    return true;
  }
  const int components = array->GetNumberOfComponents();
  if (components != 1 && components != static_cast<int>(wavelengths))
  {
    error = Sentence("Cell array \"Reflectance\" of the mesh has ", components, " components: it must have 1, or ",
      wavelengths, " as the light has wavelength samples.");
    return false;
  }
  if (array->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    error = Sentence("Cell array \"Reflectance\" of the mesh has ", array->GetNumberOfTuples(), " tuples for ",
      mesh->GetNumberOfCells(), " cells.");
    return false;
  }
  reflectance.Components = components;
  reflectance.Values.reserve(sourceCells.size() * static_cast<std::size_t>(components));
  for (const vtkIdType cell : sourceCells)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = array->GetComponent(cell, c);
      if (!(value >= 0.0 && value <= 1.0))
      {
        error =
          Sentence("Cell array \"Reflectance\" of the mesh is ", value, " at cell ", cell, ": it must be in 0..1.");
        return false;
      }
      reflectance.Values.push_back(static_cast<float>(value));
    }
  }
  return true;
}

} // namespace shadowcones
