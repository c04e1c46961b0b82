// SPDX-License-Identifier: BSD-3-Clause
// One file because it is one list.
#include "AwkwardMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace robustness
{
namespace
{

using shadowcones::Vector3;
using Ids = std::vector<vtkIdType>;

constexpr double pi = 3.14159265358979323846;

/// Points, cells and the triangles that they are.
struct Builder
{
  std::vector<Vector3> Points;
  std::vector<Ids> Polygons;
  std::vector<Ids> Strips;
  std::vector<Ids> Lines;
  std::vector<Ids> Vertices;
  std::vector<Vector3> Corners;

  vtkIdType Add(const Vector3& p)
  {
    this->Points.push_back(p);
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }
  void Truly(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    for (const vtkIdType id : { a, b, c })
    {
      this->Corners.push_back(this->Points[static_cast<std::size_t>(id)]);
    }
  }
  /// A convex flat polygon.
  void Face(const Ids& ids)
  {
    this->Polygons.push_back(ids);
    for (std::size_t k = 2; k < ids.size(); ++k)
    {
      this->Truly(ids[0], ids[k - 1], ids[k]);
    }
  }
  /// Any polygon, and the triangles that it is.
  void Face(const Ids& ids, const std::vector<std::array<int, 3>>& triangles)
  {
    this->Polygons.push_back(ids);
    for (const auto& t : triangles)
    {
      this->Truly(ids[t[0]], ids[t[1]], ids[t[2]]);
    }
  }
  void Triangle(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const vtkIdType first = this->Add(a);
    this->Add(b);
    this->Add(c);
    this->Face({ first, first + 1, first + 2 });
  }
  void Strip(const Ids& ids)
  {
    this->Strips.push_back(ids);
    for (std::size_t k = 2; k < ids.size(); ++k)
    {
      this->Truly(ids[k - 2], ids[k - 1], ids[k]);
    }
  }
  /// A box of quads, outward.
  void Box(const Vector3& low, const Vector3& high)
  {
    const auto f = static_cast<vtkIdType>(this->Points.size());
    for (int i = 0; i < 8; ++i)
    {
      this->Add({ i & 1 ? high.X : low.X, i & 2 ? high.Y : low.Y, i & 4 ? high.Z : low.Z });
    }
    constexpr int quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
      { 4, 5, 7, 6 } };
    for (const auto& q : quads)
    {
      this->Face({ f + q[0], f + q[1], f + q[2], f + q[3] });
    }
  }
  void Sheet(double low, double high, double z)
  {
    const vtkIdType f = this->Add({ low, low, z });
    this->Add({ high, low, z });
    this->Add({ high, high, z });
    this->Add({ low, high, z });
    this->Face({ f, f + 1, f + 2, f + 3 });
  }
};

vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<Ids>& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const Ids& ids : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return array;
}

AwkwardMesh Finish(const std::string& name, Builder builder, double scale = 1.0, const Vector3& offset = {},
  int pointType = VTK_DOUBLE)
{
  AwkwardMesh mesh;
  mesh.Name = name;
  mesh.Scale = scale;
  mesh.Offset = offset;
  const auto round = [&](Vector3& p)
  {
    p = { static_cast<float>(p.X), static_cast<float>(p.Y), static_cast<float>(p.Z) };
  };
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (Vector3& p : builder.Points)
  {
    const Vector3 placed = mesh.Place(p);
    points->InsertNextPoint(placed.X, placed.Y, placed.Z);
  }
  if (pointType == VTK_FLOAT)
  {
    for (Vector3& p : builder.Corners)
    {
      round(p);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(CellsOf(builder.Vertices));
  data->SetLines(CellsOf(builder.Lines));
  data->SetPolys(CellsOf(builder.Polygons));
  data->SetStrips(CellsOf(builder.Strips));
  mesh.Data = data;
  mesh.Corners = std::move(builder.Corners);
  return mesh;
}

vtkPolyData* DataOf(const AwkwardMesh& mesh)
{
  return vtkPolyData::SafeDownCast(mesh.Data);
}

Builder PlainBox()
{
  Builder b;
  b.Box({ -0.6, -0.5, 0.3 }, { 0.5, 0.6, 1.1 });
  return b;
}

AwkwardMesh Moebius()
{
  Builder b;
  constexpr int steps = 32;
  for (int i = 0; i < steps; ++i)
  {
    const double u = 2.0 * pi * i / steps;
    for (const double v : { -0.3, 0.3 })
    {
      const double r = 0.9 + v * std::cos(0.5 * u);
      b.Add({ r * std::cos(u), r * std::sin(u), 0.8 + v * std::sin(0.5 * u) });
    }
  }
  for (int i = 0; i < steps; ++i)
  {
    const vtkIdType a = 2 * i;
    const bool last = i + 1 == steps;
    const vtkIdType c = last ? 1 : a + 2;
    const vtkIdType d = last ? 0 : a + 3;
    b.Face({ a, a + 1, d });
    b.Face({ a, d, c });
  }
  return Finish("moebius", b);
}

AwkwardMesh Hourglass()
{
  Builder b;
  const vtkIdType pinch = b.Add({ 0.0, 0.0, 0.8 });
  for (const double z : { 0.2, 1.4 })
  {
    const auto f = static_cast<vtkIdType>(b.Points.size());
    for (int k = 0; k < 8; ++k)
    {
      b.Add({ 0.8 * std::cos(pi * k / 4), 0.8 * std::sin(pi * k / 4), z });
    }
    Ids lid;
    for (int k = 0; k < 8; ++k)
    {
      b.Face({ pinch, f + k, f + (k + 1) % 8 });
      lid.push_back(f + k);
    }
    b.Face(lid);
  }
  return Finish("hourglass", b);
}

AwkwardMesh Fan()
{
  Builder b;
  const vtkIdType low = b.Add({ 0.0, -0.7, 0.8 });
  const vtkIdType high = b.Add({ 0.0, 0.7, 0.8 });
  for (const double angle : { 0.1, 1.3, 2.4, 3.9, 5.0 })
  {
    const vtkIdType f = b.Add({ 0.8 * std::cos(angle), -0.7, 0.8 + 0.8 * std::sin(angle) });
    b.Add({ 0.8 * std::cos(angle), 0.7, 0.8 + 0.8 * std::sin(angle) });
    b.Face({ low, high, f + 1, f });
  }
  return Finish("fan", b);
}

AwkwardMesh Crossing()
{
  Builder b = PlainBox();
  b.Box({ -0.2, -0.9, 0.5 }, { 0.9, 0.2, 1.5 });
  b.Sheet(-0.9, 0.9, 0.7);
  return Finish("crossing", b);
}

AwkwardMesh DuplicateFaces()
{
  Builder b = PlainBox();
  const std::vector<Ids> once = b.Polygons;
  for (std::size_t k = 0; k < once.size(); ++k)
  {
    Ids again = once[k];
    if (k % 2 == 0)
    {
      again = { again[3], again[2], again[1], again[0] };
    }
    b.Face(again);
  }
  b.Polygons[2] = { once[2][3], once[2][2], once[2][1], once[2][0] };
  return Finish("duplicate-faces", b);
}

AwkwardMesh Slivers()
{
  Builder b;
  const vtkIdType tip = b.Add({ -0.9, -0.8, 0.6 });
  constexpr int count = 300;
  for (int k = 0; k <= count; ++k)
  {
    b.Add({ 0.9, -0.8 + 0.004 * k, 0.6 + 0.2 * std::sin(0.02 * k) });
    if (k > 0)
    {
      b.Face({ tip, tip + k, tip + k + 1 });
    }
  }
  // And one that is a millionth as wide as long.
  b.Triangle({ -0.9, 0.9, 1.0 }, { 0.9, 0.9, 1.0 }, { 0.0, 0.9 + 1.8e-6, 1.0 });
  return Finish("slivers", b);
}

AwkwardMesh Strips()
{
  Builder b;
  Ids ids;
  for (int k = 0; k < 9; ++k)
  {
    for (const double y : { -0.6, 0.5 })
    {
      ids.push_back(b.Add({ -0.8 + 0.2 * k, y, 0.7 + 0.1 * std::sin(2.0 * k) }));
    }
  }
  b.Strip(ids);
  return Finish("strips", b);
}

AwkwardMesh Keyhole()
{
  // A square with a square hole, joined by a bridge that is walked there and back.
  Builder b;
  Ids ids;
  for (const auto& [x, y] : { std::pair<double, double>{ -0.9, -0.9 }, { 0.9, -0.9 }, { 0.9, 0.9 }, { -0.9, 0.9 } })
  {
    ids.push_back(b.Add({ x, y, 0.8 }));
  }
  for (const auto& [x, y] : { std::pair<double, double>{ -0.4, -0.4 }, { -0.4, 0.4 }, { 0.4, 0.4 }, { 0.4, -0.4 } })
  {
    ids.push_back(b.Add({ x, y, 0.8 }));
  }
  const Ids walk = { 0, 1, 2, 3, 0, 4, 5, 6, 7, 4 };
  b.Face(walk,
    { { 0, 1, 8 }, { 0, 8, 5 }, { 1, 2, 7 }, { 1, 7, 8 }, { 2, 3, 6 }, { 2, 6, 7 }, { 3, 0, 5 }, { 3, 5, 6 } });
  return Finish("keyhole", b);
}

AwkwardMesh Star()
{
  Builder b;
  Ids ids;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < 10; ++k)
  {
    const double r = k % 2 == 0 ? 0.95 : 0.35;
    ids.push_back(b.Add({ r * std::cos(pi * k / 5), r * std::sin(pi * k / 5), 0.9 }));
  }
  for (int k = 0; k < 5; ++k)
  {
    triangles.push_back({ 2 * k, 2 * k + 1, (2 * k + 9) % 10 });
  }
  triangles.insert(triangles.end(), { { 1, 3, 5 }, { 1, 5, 7 }, { 1, 7, 9 } });
  b.Face(ids, triangles);
  return Finish("star", b);
}

AwkwardMesh VerticesOnly()
{
  Builder b;
  for (int k = 0; k < 5; ++k)
  {
    b.Vertices.push_back({ b.Add({ 0.1 * k, 0.0, 1.0 }) });
  }
  return Finish("vertices-only", b);
}

AwkwardMesh LinesOnly()
{
  Builder b;
  b.Lines.push_back({ b.Add({ -1.0, 0.0, 1.0 }), b.Add({ 1.0, 0.0, 1.0 }), b.Add({ 1.0, 1.0, 1.0 }) });
  return Finish("lines-only", b);
}

AwkwardMesh NoArea()
{
  Builder b;
  b.Polygons.push_back({ b.Add({ 0.0, 0.0, 1.0 }), b.Add({ 0.5, 0.0, 1.0 }), b.Add({ 1.0, 0.0, 1.0 }) });
  b.Polygons.push_back({ 0, 1, 0 });
  b.Polygons.push_back({ 2, 2, 2 });
  b.Polygons.push_back({ 0, 1 });
  return Finish("no-area", b);
}

AwkwardMesh Degenerate()
{
  Builder b = PlainBox();
  b.Polygons.push_back({ 0, 0, 1 });
  b.Polygons.push_back({ 0, 1 });
  b.Polygons.push_back({ 3 });
  b.Polygons.emplace_back();
  b.Polygons.push_back({ 0, 1, 3, 2, 2, 0 });
  return Finish("degenerate-cells", b);
}

AwkwardMesh MixedCells()
{
  Builder b = PlainBox();
  b.Vertices.push_back({ 0 });
  b.Lines.push_back({ 0, 7, 3 });
  const vtkIdType f = b.Add({ -0.9, 0.7, 1.4 });
  b.Add({ -0.9, 0.95, 1.4 });
  b.Add({ 0.0, 0.7, 1.4 });
  b.Add({ 0.0, 0.95, 1.4 });
  b.Add({ 0.9, 0.7, 1.4 });
  b.Strip({ f, f + 1, f + 2, f + 3, f + 4 });
  return Finish("mixed-cells", b);
}

/// A tetrahedron, a hexahedron and a wedge, with a line and a polygon.
AwkwardMesh Volumes()
{
  Builder b;
  b.Box({ -0.8, -0.8, 0.5 }, { 0.0, 0.0, 1.0 });
  const vtkIdType f = b.Add({ 0.2, 0.2, 0.4 });
  b.Add({ 0.9, 0.2, 0.4 });
  b.Add({ 0.2, 0.9, 0.4 });
  b.Add({ 0.3, 0.3, 1.2 });
  for (const Ids& face : { Ids{ f, f + 2, f + 1 }, { f, f + 1, f + 3 }, { f + 1, f + 2, f + 3 }, { f + 2, f, f + 3 } })
  {
    b.Face(face);
  }
  const vtkIdType s = b.Add({ -0.9, 0.3, 1.3 });
  b.Add({ -0.3, 0.3, 1.3 });
  b.Add({ -0.3, 0.9, 1.3 });
  b.Face({ s, s + 1, s + 2 });
  AwkwardMesh mesh = Finish("volumes", b);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(DataOf(mesh)->GetPoints());
  const vtkIdType hexahedron[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
  const vtkIdType tetrahedron[4] = { f, f + 1, f + 2, f + 3 };
  grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  const vtkIdType triangle[3] = { s, s + 1, s + 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  const vtkIdType line[2] = { 0, s };
  grid->InsertNextCell(VTK_LINE, 2, line);
  mesh.Data = grid;
  return mesh;
}

AwkwardMesh NarrowIds()
{
  AwkwardMesh mesh = Finish("ids-of-32-bits", PlainBox());
  DataOf(mesh)->GetPolys()->ConvertTo32BitStorage();
  return mesh;
}

AwkwardMesh WideIds()
{
  AwkwardMesh mesh = Finish("ids-of-64-bits", PlainBox(), 1.0, {}, VTK_FLOAT);
  DataOf(mesh)->GetPolys()->ConvertTo64BitStorage();
  return mesh;
}

/// A box, with a sheet that is hidden, one of another rank and one with a hidden point.
AwkwardMesh GhostCells()
{
  Builder b = PlainBox();
  const std::size_t truth = b.Corners.size();
  b.Sheet(-1.0, -0.7, 1.2);
  b.Sheet(0.7, 1.0, 1.2);
  b.Triangle({ -1.0, 0.7, 1.2 }, { -0.7, 0.7, 1.2 }, { -0.7, 1.0, 1.2 });
  b.Corners.resize(truth);
  AwkwardMesh mesh = Finish("ghost-cells", b);
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName(vtkDataSetAttributes::GhostArrayName());
  cells->SetNumberOfTuples(9);
  cells->FillValue(0);
  cells->SetValue(6, vtkDataSetAttributes::HIDDENCELL);
  cells->SetValue(7, vtkDataSetAttributes::DUPLICATECELL);
  DataOf(mesh)->GetCellData()->AddArray(cells);
  vtkNew<vtkUnsignedCharArray> points;
  points->SetName(vtkDataSetAttributes::GhostArrayName());
  points->SetNumberOfTuples(DataOf(mesh)->GetNumberOfPoints());
  points->FillValue(0);
  points->SetValue(DataOf(mesh)->GetNumberOfPoints() - 1, vtkDataSetAttributes::HIDDENPOINT);
  DataOf(mesh)->GetPointData()->AddArray(points);
  return mesh;
}

AwkwardMesh NotFinite(const std::string& name, double value)
{
  AwkwardMesh mesh = Finish(name, PlainBox());
  DataOf(mesh)->GetPoints()->SetPoint(5, 0.0, value, 1.0);
  mesh.Refusal = "finite";
  return mesh;
}

AwkwardMesh TooLarge()
{
  AwkwardMesh mesh = Finish("size-1e20", PlainBox(), 1e20);
  mesh.Refusal = "beyond 1e18";
  return mesh;
}

/// Only a point that no cell uses is not a number.
AwkwardMesh UnusedNotFinite()
{
  Builder b = PlainBox();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  b.Add({ nan, nan, nan });
  return Finish("unused-nan", b);
}

AwkwardMesh WrongIds(const std::string& name, vtkIdType id)
{
  Builder b = PlainBox();
  b.Polygons.push_back({ 0, 1, id });
  AwkwardMesh mesh = Finish(name, b);
  mesh.Refusal = "point";
  return mesh;
}

AwkwardMesh SelfCrossingPolygon()
{
  Builder b;
  b.Polygons.push_back({ b.Add({ -0.8, -0.8, 1.0 }), b.Add({ 0.8, 0.8, 1.0 }), b.Add({ 0.8, -0.8, 1.0 }),
    b.Add({ -0.8, 0.8, 1.0 }), b.Add({ 0.0, 1.0, 1.0 }) });
  AwkwardMesh mesh = Finish("polygon-crosses-itself", b);
  mesh.Refusal = "crosses itself";
  return mesh;
}

/// Blocks in blocks, and some that are not there.
AwkwardMesh Blocks()
{
  AwkwardMesh mesh = Crossing();
  mesh.Name = "blocks";
  Builder one = PlainBox();
  Builder two;
  two.Box({ -0.2, -0.9, 0.5 }, { 0.9, 0.2, 1.5 });
  two.Sheet(-0.9, 0.9, 0.7);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, nullptr);
  inner->SetBlock(1, Finish("", two).Data);
  auto outer = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  outer->SetBlock(0, Finish("", one).Data);
  outer->SetBlock(1, nullptr);
  outer->SetBlock(2, inner);
  outer->SetBlock(3, vtkSmartPointer<vtkPolyData>::New());
  mesh.Data = outer;
  return mesh;
}

AwkwardMesh Million()
{
  Builder b;
  constexpr int edge = 707;
  for (int j = 0; j <= edge; ++j)
  {
    for (int i = 0; i <= edge; ++i)
    {
      b.Add({ -0.9 + 1.8 * i / edge, -0.9 + 1.8 * j / edge, 0.8 + 0.2 * std::sin(0.05 * i) * std::cos(0.04 * j) });
    }
  }
  for (vtkIdType j = 0; j < edge; ++j)
  {
    for (vtkIdType i = 0; i < edge; ++i)
    {
      const vtkIdType a = j * (edge + 1) + i;
      b.Face({ a, a + 1, a + edge + 2 });
      b.Face({ a, a + edge + 2, a + edge + 1 });
    }
  }
  AwkwardMesh mesh = Finish("million", b);
  mesh.When = Run::Long;
  return mesh;
}

AwkwardMesh OneTriangle()
{
  Builder b;
  b.Triangle({ -0.7, -0.6, 0.9 }, { 0.8, -0.5, 1.0 }, { 0.0, 0.9, 1.1 });
  return Finish("one-triangle", b);
}

AwkwardMesh OpenSheets()
{
  Builder b;
  b.Sheet(-0.9, 0.3, 0.5);
  b.Sheet(-0.2, 0.8, 1.0);
  return Finish("open-sheets", b);
}

AwkwardMesh Nested()
{
  Builder b;
  for (const double half : { 0.7, 0.4, 0.1 })
  {
    b.Box({ -half, -half, 0.8 - half }, { half, half, 0.8 + half });
  }
  return Finish("nested-solids", b);
}

/// Every face has corners of its own.
AwkwardMesh Soup()
{
  const Builder box = PlainBox();
  Builder b;
  for (std::size_t k = 0; k < box.Corners.size(); k += 3)
  {
    b.Triangle(box.Corners[k], box.Corners[k + 1], box.Corners[k + 2]);
  }
  return Finish("soup", b);
}

/// A pin on a ground that is a million times as wide.
AwkwardMesh Contrast()
{
  Builder b;
  b.Box({ -0.3, -0.3, 0.2 }, { 0.3, 0.3, 1.2 });
  b.Sheet(-1e6, 1e6, -1.0);
  return Finish("wide-ground", b);
}

AwkwardMesh PlacedBox(const std::string& name, double scale, const Vector3& offset, Run run = Run::Quick)
{
  AwkwardMesh mesh = Finish(name, PlainBox(), scale, offset);
  mesh.When = run;
  return mesh;
}

} // namespace

std::vector<AwkwardMesh> AwkwardMeshes(Run run, const std::string& name)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<AwkwardMesh> all = { Moebius(), Hourglass(), Fan(), Crossing(), DuplicateFaces(), OpenSheets(), Nested(),
    Slivers(), PlacedBox("size-1e-7", 1e-7, {}), PlacedBox("size-1e7", 1e7, {}),
    PlacedBox("away-1e9", 1.0, { 1e9, -1e9, 1e9 }), PlacedBox("size-1e-20", 1e-20, {}, Run::Long),
    PlacedBox("size-1e17", 1e17, {}, Run::Long), TooLarge(), OneTriangle(), Strips(), Finish("quads", PlainBox()), Keyhole(), Star(),
    VerticesOnly(), LinesOnly(), NoArea(), Finish("empty", Builder()), Degenerate(), MixedCells(), Volumes(), NarrowIds(),
    WideIds(), Finish("float-points", PlainBox(), 1.0, {}, VTK_FLOAT), GhostCells(), NotFinite("nan-point", nan),
    NotFinite("inf-point", infinite), UnusedNotFinite(), WrongIds("id-too-large", 99), WrongIds("id-negative", -1),
    SelfCrossingPolygon(), Blocks(), Soup(), Contrast() };
  if (run == Run::Long)
  {
    all.push_back(Million());
  }
  std::vector<AwkwardMesh> chosen;
  for (AwkwardMesh& mesh : all)
  {
    if (name.empty() ? (run == Run::Long || mesh.When == Run::Quick) : mesh.Name == name)
    {
      chosen.push_back(std::move(mesh));
    }
  }
  return chosen;
}

} // namespace robustness
