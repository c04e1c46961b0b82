// SPDX-License-Identifier: BSD-3-Clause
#include "scMeshData.h"

#include "scFieldArrays.h"
#include "scGhosts.h"
#include "scOccluderNames.h"
#include "scPolygonTriangulation.h"
#include "scSentence.h"
#include "scTuples.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shadowcones
{
namespace
{

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
    if (const char* fault = FaultOf({ points[3 * id], points[3 * id + 1], points[3 * id + 2] }))
    {
      error = Sentence("Point ", id, ", used by cell ", cell, ", has a coordinate that ", fault, ".");
      return false;
    }
  }
  return true;
}

/// Adds the triangles of one poly data to a mesh.
class TriangleReader
{
public:
  TriangleReader(const MeshBlock& block, TriangleMesh& mesh)
    : Block(block)
    , CellGhosts(block.Data->GetCellData())
    , PointGhosts(block.Data->GetPointData())
    , Mesh(mesh)
  {
    CopyPoints(block.Data, this->Points);
  }

  bool Read(std::string& error)
  {
    vtkPolyData* data = this->Block.Data;
    vtkIdType cell = 0;
    for (; cell < data->GetNumberOfVerts() + data->GetNumberOfLines(); ++cell)
    {
      this->Mesh.NumberOfCells += this->IsThere(cell, 0, nullptr);
    }
    const auto addPolygon = [this, &error](vtkIdType polygon, vtkIdType count, const vtkIdType* ids)
    { return this->AddPolygon(polygon, count, ids, error); };
    const auto addStrip = [this](vtkIdType strip, vtkIdType count, const vtkIdType* ids)
    { return this->AddStrip(strip, count, ids); };
    const bool read = this->ForEachCell(data->GetPolys(), cell, addPolygon, error) &&
      this->ForEachCell(data->GetStrips(), cell, addStrip, error);
    this->Mesh.Points.insert(this->Mesh.Points.end(), this->Points.begin(), this->Points.end());
    return read;
  }

private:
  bool IsThere(vtkIdType cell, vtkIdType count, const vtkIdType* ids) const
  {
    return !this->CellGhosts.IsCellHidden(cell) && !this->CellGhosts.IsCellDuplicate(cell) &&
      std::none_of(ids, ids + count, [this](vtkIdType id) { return this->PointGhosts.IsPointHidden(id); });
  }

  template <typename Add>
  bool ForEachCell(vtkCellArray* cells, vtkIdType& cell, const Add& add, std::string& error)
  {
    auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(count, ids);
      if (this->IsThere(cell, count, ids))
      {
        ++this->Mesh.NumberOfCells;
        if (!CheckCell(this->Points, cell, count, ids, error) || !add(cell, count, ids))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool AddPolygon(vtkIdType cell, vtkIdType count, const vtkIdType* ids, std::string& error)
  {
    this->Corners.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* p = this->Points.data() + 3 * ids[i];
      this->Corners.push_back({ p[0], p[1], p[2] });
    }
    if (!TriangulatePolygon(this->Corners, this->Triangles))
    {
      error = Sentence("Cell ", cell, ", a polygon of ", count,
        " corners, crosses itself or goes round a place twice: it has no one area. Cut it into simple polygons.");
      return false;
    }
    for (std::size_t i = 0; i + 2 < this->Triangles.size(); i += 3)
    {
      this->AddTriangle(cell, ids[this->Triangles[i]], ids[this->Triangles[i + 1]], ids[this->Triangles[i + 2]]);
    }
    return true;
  }

  /// Every second triangle of a strip runs the other way round.
  bool AddStrip(vtkIdType cell, vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i + 2 < count; ++i)
    {
      this->AddTriangle(cell, ids[i], ids[i % 2 ? i + 2 : i + 1], ids[i % 2 ? i + 1 : i + 2]);
    }
    return true;
  }

  void AddTriangle(vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const vtkIdType first = this->Block.FirstPoint;
    this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), { first + a, first + b, first + c });
    this->Mesh.SourceCells.push_back(this->Block.FirstCell + cell);
  }

  const MeshBlock& Block;
  Ghosts CellGhosts;
  Ghosts PointGhosts;
  TriangleMesh& Mesh;
  std::vector<double> Points;
  std::vector<Vector3> Corners;
  std::vector<int> Triangles;
};

/// Gives the triangles of blocks, one after the other, their occluders.
class OccluderReader
{
public:
  OccluderReader(TriangleMesh& mesh, bool onePerBlock)
    : Mesh(mesh)
    , OnePerBlock(onePerBlock)
  {
  }

  /// Triangles from the first that has no occluder yet are those of the block.
  bool Read(const MeshBlock& block, std::string& error)
  {
    vtkPolyData* data = block.Data;
    vtkDataArray* array = nullptr;
    if (!FindArray(
          data->GetCellData(), "mesh", "OccluderId", 1, data->GetNumberOfCells(), Need::Optional, array, error))
    {
      return false;
    }
    if (!array)
    {
      if (this->OnePerBlock)
      {
        const int id = this->Numbers.Of(
          "block " + std::to_string(block.Number), block.Name.empty() ? std::to_string(block.Number) : block.Name);
        this->Mesh.OccluderIds.resize(this->Mesh.SourceCells.size(), id);
      }
      return true;
    }
    std::vector<GivenId> given;
    if (!ReadGivenIds(array, "cell", given, error))
    {
      return false;
    }
    this->Add(block, given, ReadOccluderNames(data->GetFieldData()));
    return true;
  }

  std::vector<std::string> TakeNames() { return std::move(this->Numbers.Names); }

private:
  void Add(const MeshBlock& block, const std::vector<GivenId>& given, const std::vector<std::string>& names)
  {
    const bool named = !names.empty() &&
      std::all_of(given.begin(), given.end(),
        [&names](const GivenId& id) { return id.Receiver || (id.Rest == 0.0 && id.Whole < names.size()); });
    const bool asTheyAre = named && this->Mesh.Blocks.size() == 1;
    if (asTheyAre)
    {
      this->Numbers.Names = names;
    }
    std::map<GivenId, int> ids;
    this->Mesh.OccluderIds.reserve(this->Mesh.SourceCells.capacity());
    for (std::size_t t = this->Mesh.OccluderIds.size(); t < this->Mesh.SourceCells.size(); ++t)
    {
      const GivenId& id = given[static_cast<std::size_t>(this->Mesh.SourceCells[t] - block.FirstCell)];
      this->Mesh.OccluderIds.push_back(id.Receiver ? -1
          : asTheyAre                              ? static_cast<int>(id.Whole)
                                                   : this->Of(id, named, names, ids));
    }
  }

  int Of(const GivenId& id, bool named, const std::vector<std::string>& names, std::map<GivenId, int>& ids)
  {
    const auto found = ids.emplace(id, -1);
    if (found.second)
    {
      const std::string text = id.Text();
      const std::string& name = named ? names[static_cast<std::size_t>(id.Whole)] : text;
      found.first->second = this->Numbers.Of("id " + text + " " + name, name);
    }
    return found.first->second;
  }

  TriangleMesh& Mesh;
  bool OnePerBlock;
  OccluderNumbers Numbers;
};

/// Read one block after those that are there already; without @p occluders its ids are left alone.
bool ReadBlock(const MeshBlock& block, OccluderReader* occluders, TriangleMesh& mesh, std::string& error)
{
  const vtkIdType cells = mesh.NumberOfCells;
  const std::size_t triangles = mesh.SourceCells.size();
  if (!TriangleReader(block, mesh).Read(error) || (occluders && !occluders->Read(block, error)))
  {
    return false;
  }
  if (mesh.Blocks.size() > 1 && mesh.SourceCells.size() == triangles && mesh.NumberOfCells > cells)
  {
    error = Sentence("It has ", mesh.NumberOfCells - cells, " cells and no polygon, and is no surface: take it out.");
    return false;
  }
  return true;
}

/// Make room for all blocks at once: what grows by doubling would keep up to twice what it takes.
void MakeRoom(TriangleMesh& mesh)
{
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const MeshBlock& block : mesh.Blocks)
  {
    points += static_cast<std::size_t>(block.Data->GetNumberOfPoints());
    for (vtkCellArray* cells : { block.Data->GetPolys(), block.Data->GetStrips() })
    {
      const vtkIdType corners = cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
      triangles += static_cast<std::size_t>(std::max<vtkIdType>(corners, 0));
    }
  }
  mesh.Points.reserve(3 * points);
  mesh.Triangles.reserve(3 * triangles);
  mesh.SourceCells.reserve(triangles);
}

/// Read the blocks that the mesh is to consist of.
bool ReadBlocks(bool composite, OccluderReader* occluders, TriangleMesh& mesh, std::string& error)
{
  MakeRoom(mesh);
  for (const MeshBlock& block : mesh.Blocks)
  {
    if (!ReadBlock(block, occluders, mesh, error))
    {
      error.insert(0, composite ? "Block " + block.Label() + ": " : "");
      return false;
    }
  }
  return true;
}

/// The "Reflectance" of a block, which may have none. @return false where it does not fit.
bool FindReflectance(vtkPolyData* data, std::size_t wavelengths, vtkDataArray*& array, std::string& error)
{
  array = data->GetCellData()->GetArray("Reflectance");
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
  if (array->GetNumberOfTuples() != data->GetNumberOfCells())
  {
    error = Sentence("Cell array \"Reflectance\" of the mesh has ", array->GetNumberOfTuples(), " tuples for ",
      data->GetNumberOfCells(), " cells.");
    return false;
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

std::size_t TriangleMesh::BlockOfPoint(vtkIdType point) const
{
  const auto next = std::upper_bound(this->Blocks.begin(), this->Blocks.end(), point,
    [](vtkIdType id, const MeshBlock& block) { return id < block.FirstPoint; });
  return static_cast<std::size_t>(next - this->Blocks.begin()) - 1;
}

std::size_t TriangleMesh::BlockOfCell(vtkIdType cell) const
{
  const auto next = std::upper_bound(this->Blocks.begin(), this->Blocks.end(), cell,
    [](vtkIdType id, const MeshBlock& block) { return id < block.FirstCell; });
  return static_cast<std::size_t>(next - this->Blocks.begin()) - 1;
}

bool ReadTriangles(vtkDataObject* input, TriangleMesh& mesh, std::string& error)
{
  mesh = TriangleMesh();
  if (!input)
  {
    error = "There is no mesh.";
    return false;
  }
  if (!CollectBlocks(input, mesh.Blocks, error))
  {
    return false;
  }
  const bool composite = vtkPolyData::SafeDownCast(input) == nullptr;
  OccluderReader occluders(mesh, composite);
  if (!ReadBlocks(composite, &occluders, mesh, error))
  {
    return false;
  }
  mesh.OccluderNames = occluders.TakeNames();
  return true;
}

bool ReadSurface(vtkPolyData* input, TriangleMesh& mesh, std::string& error)
{
  mesh = TriangleMesh();
  return CollectBlocks(input, mesh.Blocks, error) && ReadBlocks(false, nullptr, mesh, error);
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

bool ReadReflectance(const TriangleMesh& mesh, std::size_t wavelengths, double missing, SurfaceReflectance& reflectance,
  std::string& error)
{
  std::vector<vtkDataArray*> arrays(mesh.Blocks.size(), nullptr);
  int most = 0;
  for (std::size_t b = 0; b < arrays.size(); ++b)
  {
    if (!FindReflectance(mesh.Blocks[b].Data, wavelengths, arrays[b], error))
    {
      return false;
    }
    most = std::max(most, arrays[b] ? arrays[b]->GetNumberOfComponents() : 0);
  }
  reflectance.Components = most;
  reflectance.Values.reserve(most > 0 ? mesh.SourceCells.size() * static_cast<std::size_t>(most) : 0);
  for (std::size_t t = 0; t < mesh.SourceCells.size() && most > 0; ++t)
  {
    const std::size_t block = mesh.BlockOfCell(mesh.SourceCells[t]);
    const vtkIdType cell = mesh.SourceCells[t] - mesh.Blocks[block].FirstCell;
    vtkDataArray* array = arrays[block];
    for (int c = 0; c < most; ++c)
    {
      const double value = array ? array->GetComponent(cell, array->GetNumberOfComponents() > 1 ? c : 0) : missing;
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

bool ReadPointNormals(const TriangleMesh& mesh, std::vector<float>& normals, std::string& error)
{
  normals.clear();
  for (const MeshBlock& block : mesh.Blocks)
  {
    vtkPointData* data = block.Data->GetPointData();
    vtkDataArray* named = data->GetArray("Normals");
    vtkDataArray* array = named ? named : data->GetNormals();
    if (!array)
    {
      continue;
    }
    const vtkIdType points = block.Data->GetNumberOfPoints();
    if (array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != points)
    {
      error = Sentence("Point array \"Normals\" of the mesh has ", array->GetNumberOfTuples(), " tuples of ",
        array->GetNumberOfComponents(), " components for ", points,
        " points: it must have 3 components and one tuple a point.");
      return false;
    }
    normals.resize(mesh.Points.size(), 0.0f);
    for (vtkIdType point = 0; point < points; ++point)
    {
      for (int c = 0; c < 3; ++c)
      {
        const auto value = static_cast<float>(array->GetComponent(point, c));
        if (!std::isfinite(value))
        {
          error = Sentence("Point array \"Normals\" of the mesh is not finite at point ", point, ".");
          return false;
        }
        normals[static_cast<std::size_t>(3 * (block.FirstPoint + point) + c)] = value;
      }
    }
  }
  return true;
}

} // namespace shadowcones
