// SPDX-License-Identifier: BSD-3-Clause
#include "scLabelData.h"

#include "scFieldArrays.h"
#include "scGhosts.h"
#include "scLightData.h"
#include "scOccluderNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace shadowcones
{

namespace
{

/// What an occluder is called where nothing was given.
std::string NumberAsName(int id)
{
  return std::to_string(id);
}

void CountCells(vtkPolyData* input, GivenMesh& given)
{
  const Ghosts ghosts(input->GetCellData());
  vtkIdType cell = 0;
  const auto isThere = [&ghosts](vtkIdType id) { return !ghosts.IsCellHidden(id) && !ghosts.IsCellDuplicate(id); };
  for (; cell < input->GetNumberOfVerts() + input->GetNumberOfLines(); ++cell)
  {
    given.IgnoredCells += isThere(cell);
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPolys(); ++i, ++cell)
  {
    const vtkIdType corners = input->GetPolys()->GetCellSize(i);
    given.TriangulatedPolygons += isThere(cell) && corners > 3;
    given.DroppedPolygons += isThere(cell) && corners < 3;
  }
  for (vtkIdType i = 0; i < input->GetNumberOfStrips(); ++i, ++cell)
  {
    const vtkIdType corners = input->GetStrips()->GetCellSize(i);
    given.TriangulatedPolygons += isThere(cell) && corners >= 3;
    given.DroppedPolygons += isThere(cell) && corners < 3;
  }
}

/// Triangles of different labels share no point.
void SplitPoints(GivenMesh& given)
{
  TriangleMesh& mesh = given.Mesh;
  std::map<std::pair<vtkIdType, int>, vtkIdType> split;
  std::vector<double> points;
  for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
  {
    const vtkIdType source = mesh.Triangles[corner];
    const auto found = split.emplace(
      std::make_pair(source, given.Labels[corner / 3]), static_cast<vtkIdType>(given.SourcePoints.size()));
    if (found.second)
    {
      given.SourcePoints.push_back(source);
      points.insert(points.end(), mesh.Points.begin() + 3 * source, mesh.Points.begin() + 3 * source + 3);
    }
    mesh.Triangles[corner] = found.first->second;
  }
  mesh.Points = std::move(points);
}

/// Attributes that all blocks with cells have, ready to be copied.
class SharedAttributes
{
public:
  template <typename GetAttributes>
  SharedAttributes(
    const std::vector<MeshBlock>& blocks, GetAttributes get, vtkIdType count, vtkDataSetAttributes* output)
    : Output(output)
  {
    for (const MeshBlock& block : blocks)
    {
      this->Inputs.push_back(get(block.Data));
      this->Numbers.push_back(this->Count);
      if (block.Data->GetNumberOfCells() > 0)
      {
        this->Fields.IntersectFieldList(this->Inputs.back());
        ++this->Count;
      }
    }
    output->CopyNormalsOff();
    output->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
    output->CopyFieldOff("Normals");
    output->CopyAllocate(this->Fields, count);
    output->CopyNormalsOn();
  }

  void Copy(std::size_t block, vtkIdType from, vtkIdType to)
  {
    this->Output->CopyData(this->Fields, this->Inputs[block], this->Numbers[block], from, to);
  }

private:
  vtkDataSetAttributes* Output;
  vtkDataSetAttributes::FieldList Fields;
  std::vector<vtkDataSetAttributes*> Inputs;
  std::vector<int> Numbers; ///< of each block among those with cells
  int Count = 0;
};

/// The normals of the points of all blocks, as floats; nullptr where a block with cells has none.
class PointNormals
{
public:
  explicit PointNormals(const GivenMesh& given)
    : Given(given)
  {
    for (const MeshBlock& block : given.Mesh.Blocks)
    {
      vtkPointData* data = block.Data->GetPointData();
      vtkDataArray* named = data->GetArray("Normals");
      vtkDataArray* array = named ? named : data->GetNormals();
      const bool fits = array && array->GetNumberOfComponents() == 3;
      this->Arrays.push_back(fits ? array : nullptr);
      this->All = this->All && (fits || block.Data->GetNumberOfCells() == 0);
      this->Some = this->Some || fits;
    }
  }

  bool Any() const { return this->All && this->Some; }
  std::array<float, 3> At(vtkIdType point, bool turned) const
  {
    const vtkIdType source = this->Given.SourcePoint(point);
    const std::size_t block = this->Given.Mesh.BlockOfPoint(source);
    double normal[3];
    this->Arrays[block]->GetTuple(source - this->Given.Mesh.Blocks[block].FirstPoint, normal);
    const float sign = turned ? -1.0f : 1.0f;
    return { sign * static_cast<float>(normal[0]), sign * static_cast<float>(normal[1]),
      sign * static_cast<float>(normal[2]) };
  }

private:
  const GivenMesh& Given;
  std::vector<vtkDataArray*> Arrays;
  bool All = true;
  bool Some = false;
};

/// Where the corners of an output triangle come from in the input: welding and turning move them.
std::array<vtkIdType, 3> SourceCorners(
  const TriangleMesh& mesh, const OccluderTopology& topology, vtkIdType triangle, bool& turned)
{
  const auto at = [&mesh](vtkIdType id) {
    return Vector3{ mesh.Points[3 * id], mesh.Points[3 * id + 1], mesh.Points[3 * id + 2] };
  };
  const vtkIdType* source = mesh.Triangles.data() + 3 * topology.InputTriangles[triangle];
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };
  double least = std::numeric_limits<double>::infinity();
  std::array<vtkIdType, 3> corners{ source[0], source[1], source[2] };
  turned = false;
  for (int k = 0; k < 6; ++k)
  {
    double distance = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      distance += Length(at(source[orders[k][c]]) - at(topology.Points[topology.Triangles[3 * triangle + c]]));
    }
    if (distance < least)
    {
      least = distance;
      corners = { source[orders[k][0]], source[orders[k][1]], source[orders[k][2]] };
      turned = k > 2;
    }
  }
  return corners;
}

/// Points of the output: those of the topology that are used, once for each normal.
class OutputPoints
{
public:
  OutputPoints(std::size_t count, bool hasNormals)
    : Heads(count, -1)
    , HasNormals(hasNormals)
  {
  }

  /// The entry of a topology point with that normal.
  vtkIdType Add(vtkIdType point, const std::array<float, 3>& normal)
  {
    vtkIdType* link = &this->Heads[static_cast<std::size_t>(point)];
    while (*link >= 0 && this->HasNormals && this->Entries[static_cast<std::size_t>(*link)].Normal != normal)
    {
      link = &this->Entries[static_cast<std::size_t>(*link)].Next;
    }
    if (*link < 0)
    {
      const auto added = static_cast<vtkIdType>(this->Entries.size());
      *link = added;
      this->Entries.push_back({ normal, -1, -1 });
      return added;
    }
    return *link;
  }

  /// Number the entries in the order of the topology's points, and hand each to @p write.
  template <typename Write>
  void Finish(const Write& write)
  {
    vtkIdType count = 0;
    for (std::size_t point = 0; point < this->Heads.size(); ++point)
    {
      for (vtkIdType k = this->Heads[point]; k >= 0; k = this->Entries[static_cast<std::size_t>(k)].Next)
      {
        Entry& entry = this->Entries[static_cast<std::size_t>(k)];
        entry.Number = count++;
        write(static_cast<vtkIdType>(point), entry.Number, entry.Normal);
      }
    }
  }
  vtkIdType Number(vtkIdType entry) const { return this->Entries[static_cast<std::size_t>(entry)].Number; }

private:
  struct Entry
  {
    std::array<float, 3> Normal;
    vtkIdType Next;
    vtkIdType Number;
  };
  std::vector<vtkIdType> Heads;
  std::vector<Entry> Entries;
  bool HasNormals;
};

/// Points of triangles [begin, end) with their attributes; @p corners gets the point of each corner.
void WritePoints(const GivenMesh& given, const OccluderTopology& topology, vtkIdType begin, vtkIdType end,
  vtkIdTypeArray* corners, vtkPolyData* output)
{
  const TriangleMesh& mesh = given.Mesh;
  const PointNormals normals(given);
  OutputPoints entries(topology.Points.size(), normals.Any());
  for (vtkIdType t = begin; t < end; ++t)
  {
    bool turned = false;
    std::array<vtkIdType, 3> sources{};
    if (normals.Any())
    {
      sources = SourceCorners(mesh, topology, t, turned);
    }
    for (int c = 0; c < 3; ++c)
    {
      const std::array<float, 3> normal =
        normals.Any() ? normals.At(sources[static_cast<std::size_t>(c)], turned) : std::array<float, 3>{};
      corners->SetValue(3 * (t - begin) + c, entries.Add(topology.Triangles[3 * t + c], normal));
    }
  }

  SharedAttributes shared(
    mesh.Blocks, [](vtkPolyData* data) { return data->GetPointData(); }, 3 * (end - begin), output->GetPointData());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> outputNormals;
  outputNormals->SetName("Normals");
  outputNormals->SetNumberOfComponents(3);
  entries.Finish(
    [&](vtkIdType point, vtkIdType number, const std::array<float, 3>& normal)
    {
      const vtkIdType welded = topology.Points[point];
      const vtkIdType source = given.SourcePoint(welded);
      const std::size_t block = mesh.BlockOfPoint(source);
      points->InsertNextPoint(mesh.Points.data() + 3 * welded);
      outputNormals->InsertNextTypedTuple(normal.data());
      shared.Copy(block, source - mesh.Blocks[block].FirstPoint, number);
    });
  for (vtkIdType corner = 0; corner < corners->GetNumberOfValues(); ++corner)
  {
    corners->SetValue(corner, entries.Number(corners->GetValue(corner)));
  }
  output->SetPoints(points);
  if (normals.Any())
  {
    output->GetPointData()->SetNormals(outputNormals);
  }
}

/// Triangles [begin, end) with their points and the attributes that came with them.
void WriteTriangles(
  const GivenMesh& given, const OccluderTopology& topology, vtkIdType begin, vtkIdType end, vtkPolyData* output)
{
  const TriangleMesh& mesh = given.Mesh;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(end - begin + 1);
  connectivity->SetNumberOfValues(3 * (end - begin));
  WritePoints(given, topology, begin, end, connectivity, output);

  SharedAttributes shared(
    mesh.Blocks, [](vtkPolyData* data) { return data->GetCellData(); }, end - begin, output->GetCellData());
  std::vector<int> occluderIds;
  for (vtkIdType t = begin; t < end; ++t)
  {
    const vtkIdType cell = mesh.SourceCells[topology.InputTriangles[t]];
    const std::size_t block = mesh.BlockOfCell(cell);
    offsets->SetValue(t - begin, 3 * (t - begin));
    occluderIds.push_back(topology.OccluderIds[t]);
    shared.Copy(block, cell - mesh.Blocks[block].FirstCell, t - begin);
  }
  offsets->SetValue(end - begin, 3 * (end - begin));
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, connectivity);
  output->SetPolys(triangles);
  AddIntArray(output->GetCellData(), "OccluderId", 1, occluderIds);
}

/// What was given to the triangles of each occluder, or else its number.
std::vector<std::string> NamesOf(const GivenMesh& given, const OccluderTopology& topology)
{
  constexpr std::size_t most = 4; // names of one occluder
  std::vector<std::vector<int>> labels(topology.Closed.size());
  for (std::size_t t = 0; t < topology.OccluderIds.size() && !given.Labels.empty(); ++t)
  {
    const int id = topology.OccluderIds[t];
    const int label = given.Labels[static_cast<std::size_t>(topology.InputTriangles[t])];
    if (id >= 0 && label >= 0)
    {
      std::vector<int>& own = labels[static_cast<std::size_t>(id)];
      if (own.size() <= most && std::find(own.begin(), own.end(), label) == own.end())
      {
        own.push_back(label);
      }
    }
  }
  std::vector<std::string> names;
  for (const std::vector<int>& own : labels)
  {
    std::string name = own.empty() ? NumberAsName(static_cast<int>(names.size())) : std::string();
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      name += (k > 0 ? ", " : "") + (k < most ? given.Names[static_cast<std::size_t>(own[k])] : std::string("..."));
    }
    names.push_back(name);
  }
  return names;
}

void WriteReport(const GivenMesh& given, const OccluderTopology& topology, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  const auto add = [data](const char* name, vtkIdType value) { AddIdArray(data, name, { value }); };
  add("NumberOfOccluders", static_cast<vtkIdType>(topology.Closed.size()));
  add("ExtractedSurfaces", given.ExtractedSurfaces);
  add("TriangulatedPolygons", given.TriangulatedPolygons);
  add("WeldedPoints", topology.WeldedPoints);
  add("DroppedCells", topology.DegenerateTriangles + topology.DuplicateTriangles + given.DroppedPolygons);
  add("IgnoredCells", given.IgnoredCells);
  add("FlippedTriangles", topology.FlippedTriangles);
  add("NonManifoldEdges", topology.NonManifoldEdges);
  add("BoundaryEdges", topology.BoundaryEdges);
  AddByteArray(data, "OccluderClosed", topology.Closed);
  WriteOccluderNames(NamesOf(given, topology), data);
  RemoveLightFieldData(data);
}

} // namespace

bool ReadGivenMesh(vtkDataObject* input, GivenMesh& given, std::string& error)
{
  if (!ReadTriangles(input, given.Mesh, error))
  {
    return false;
  }
  for (const MeshBlock& block : given.Mesh.Blocks)
  {
    if (!CheckAttributes(block.Data->GetPointData(), block.Data->GetNumberOfPoints(), "point", error) ||
      !CheckAttributes(block.Data->GetCellData(), block.Data->GetNumberOfCells(), "cell", error))
    {
      error.insert(0, given.Mesh.Blocks.size() > 1 ? "Block " + block.Label() + ": " : "");
      return false;
    }
    CountCells(block.Data, given);
    given.HasCells = given.HasCells || block.Data->GetNumberOfCells() > 0;
  }
  return true;
}

void LabelByGiven(GivenMesh& given)
{
  given.Labels = given.Mesh.OccluderIds;
  given.Names = given.Mesh.OccluderNames;
}

void LabelByBlock(GivenMesh& given)
{
  OccluderNumbers numbers;
  for (const vtkIdType cell : given.Mesh.SourceCells)
  {
    const MeshBlock& block = given.Mesh.Blocks[given.Mesh.BlockOfCell(cell)];
    given.Labels.push_back(
      numbers.Of(std::to_string(block.Number), block.Name.empty() ? std::to_string(block.Number) : block.Name));
  }
  given.Names = std::move(numbers.Names);
}

bool LabelByArray(const std::string& name, GivenMesh& given, std::string& error)
{
  TriangleMesh& mesh = given.Mesh;
  std::vector<std::vector<GivenId>> ids(mesh.Blocks.size());
  for (std::size_t b = 0; b < ids.size(); ++b)
  {
    vtkPolyData* data = mesh.Blocks[b].Data;
    vtkDataArray* array = nullptr;
    if (data->GetNumberOfCells() > 0 &&
      (!FindArray(
         data->GetCellData(), "mesh", name.c_str(), 1, data->GetNumberOfCells(), Need::Required, array, error) ||
        !ReadGivenIds(array, "cell", ids[b], error)))
    {
      error.insert(0, "LabelBy is Array: ");
      return false;
    }
  }
  const bool named = name == "OccluderId" && !mesh.OccluderNames.empty();
  OccluderNumbers numbers;
  mesh.OccluderIds.resize(mesh.SourceCells.size(), 0);
  for (std::size_t t = 0; t < mesh.SourceCells.size(); ++t)
  {
    const std::size_t block = mesh.BlockOfCell(mesh.SourceCells[t]);
    const GivenId& id = ids[block][static_cast<std::size_t>(mesh.SourceCells[t] - mesh.Blocks[block].FirstCell)];
    mesh.OccluderIds[t] = id.Receiver || mesh.OccluderIds[t] < 0 ? -1 : mesh.OccluderIds[t];
    const std::string text = id.Text();
    const std::string& called =
      named && mesh.OccluderIds[t] >= 0 ? mesh.OccluderNames[static_cast<std::size_t>(mesh.OccluderIds[t])] : text;
    given.Labels.push_back(
      mesh.OccluderIds[t] < 0 ? -1 : numbers.Of(named ? std::to_string(mesh.OccluderIds[t]) : text, called));
  }
  given.Names = std::move(numbers.Names);
  SplitPoints(given);
  return true;
}

void WriteLabelledMesh(
  const GivenMesh& given, const OccluderTopology& topology, vtkIdType begin, vtkIdType end, vtkPolyData* output)
{
  WriteTriangles(given, topology, begin, end, output);
  WriteReport(given, topology, output);
}

} // namespace shadowcones
