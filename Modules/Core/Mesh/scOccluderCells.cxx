// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderCells.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// A cell's diagonal is at most so many times as long as the longest edge of each of its triangles.
constexpr double largestRatio = 16384.0;
/// Cells reach so far over their border, as a share of their diagonal.
constexpr double overlap = 1e-5;
constexpr std::size_t largestTree = 8192;
constexpr int largestDepth = 100;
/// Corners sharper than this, as the sine of half the angle, would reach too far out.
constexpr double sharpest = 0.002;

using Polygon = std::vector<Vector3>;

double WithComponent(Vector3& a, int axis, double value)
{
  return (axis == 0 ? a.X : axis == 1 ? a.Y : a.Z) = value;
}

Box Enlarged(const Box& box, double by)
{
  const Vector3 margin{ by, by, by };
  return { box.Min - margin, box.Max + margin };
}

double LongestEdge(const TriangleMeshView& mesh, vtkIdType triangle)
{
  const Vector3 a = mesh.Corner(triangle, 0);
  const Vector3 b = mesh.Corner(triangle, 1);
  const Vector3 c = mesh.Corner(triangle, 2);
  return std::max({ Length(b - a), Length(c - b), Length(a - c) });
}

/// What of a convex polygon lies in a box.
void CutOff(Polygon& polygon, const Box& box)
{
  Polygon kept;
  for (int side = 0; side < 6 && !polygon.empty(); ++side)
  {
    const int axis = side / 2;
    const double sign = side % 2 ? 1.0 : -1.0;
    const double limit = side % 2 ? box.Max[axis] : box.Min[axis];
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Vector3& p = polygon[i];
      const Vector3& q = polygon[(i + 1) % polygon.size()];
      const double outP = sign * (p[axis] - limit);
      const double outQ = sign * (q[axis] - limit);
      if (outP <= 0.0)
      {
        kept.push_back(p);
      }
      if ((outP < 0.0 && outQ > 0.0) || (outP > 0.0 && outQ < 0.0))
      {
        Vector3 cut = p + (outP / (outP - outQ)) * (q - p);
        WithComponent(cut, axis, limit);
        kept.push_back(cut);
      }
    }
    polygon.swap(kept);
  }
}

void AddPiece(OccluderCell& cell, vtkIdType triangle, bool exact, const Vector3& a, const Vector3& b, const Vector3& c)
{
  CellPiece piece;
  piece.Triangle = triangle;
  piece.Exact = exact;
  const Vector3 corners[3] = { a, b, c };
  for (std::size_t i = 0; i < 3; ++i)
  {
    piece.Corners[i] = { static_cast<float>(corners[i].X), static_cast<float>(corners[i].Y),
      static_cast<float>(corners[i].Z) };
  }
  cell.Pieces.push_back(piece);
}

/// The rectangle around a triangle, along its longest edge, as two pieces.
void AddRectangle(OccluderCell& cell, vtkIdType triangle, const Vector3 (&p)[3], const Vector3& normal)
{
  int longest = 0;
  for (int i = 1; i < 3; ++i)
  {
    longest = Length(p[(i + 1) % 3] - p[i]) > Length(p[(longest + 1) % 3] - p[longest]) ? i : longest;
  }
  const Vector3& start = p[longest];
  const Vector3 along = Normalized(p[(longest + 1) % 3] - start);
  const Vector3 across = Normalized(Cross(normal, along));
  double low[2] = { 0.0, 0.0 };
  double high[2] = { 0.0, 0.0 };
  for (const Vector3& corner : p)
  {
    const double at[2] = { Dot(corner - start, along), Dot(corner - start, across) };
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  const double m = OccluderCells::Margin;
  const auto corner = [&](double x, double y) { return start + x * along + y * across; };
  const Vector3 a = corner(low[0] - m, low[1] - m);
  const Vector3 c = corner(high[0] + m, high[1] + m);
  AddPiece(cell, triangle, false, a, corner(high[0] + m, low[1] - m), c);
  AddPiece(cell, triangle, false, a, c, corner(low[0] - m, high[1] + m));
}

/// A piece with its edges moved outward by the margin.
void AddEnlarged(OccluderCell& cell, vtkIdType triangle, const Vector3 (&p)[3], const Vector3& normal)
{
  Vector3 moved[3];
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 u = Normalized(p[(i + 1) % 3] - p[i]);
    const Vector3 v = Normalized(p[(i + 2) % 3] - p[i]);
    const Vector3 bisector = u + v;
    const double sine = 0.5 * Length(u - v); // of half the angle
    const double cosine = 0.5 * Length(bisector);
    if (!(sine > sharpest && cosine > sharpest))
    {
      AddRectangle(cell, triangle, p, normal);
      return;
    }
    moved[i] = p[i] - (0.5 * OccluderCells::Margin / (sine * cosine)) * bisector;
  }
  AddPiece(cell, triangle, true, moved[0], moved[1], moved[2]);
}

} // anonymous namespace

OccluderCells::OccluderCells(const TriangleMeshView& mesh)
{
  std::vector<vtkIdType> triangles;
  Box bounds;
  triangles.reserve(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    triangles.push_back(t);
    bounds.Add(mesh.BoundsOf(t));
  }
  if (!triangles.empty())
  {
    this->Root = this->Build(mesh, triangles, bounds, 0);
  }
}

int OccluderCells::Build(
  const TriangleMeshView& mesh, const std::vector<vtkIdType>& triangles, const Box& box, int depth)
{
  if (triangles.empty())
  {
    return -1;
  }
  const double diagonal = box.Diagonal();
  Box small;
  for (const vtkIdType t : triangles)
  {
    if (largestRatio * LongestEdge(mesh, t) < diagonal)
    {
      small.Add(Intersection(mesh.BoundsOf(t), box));
    }
  }
  if (small.Empty() || depth >= largestDepth || this->Nodes.size() >= largestTree)
  {
    return this->AddLeaf(mesh, triangles, box);
  }

  // Cut off the most of what holds nothing small; where that is little, halve.
  small = Enlarged(small, 0.05 * small.Diagonal());
  const Vector3 size = box.Size();
  int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
  double place = box.Center()[axis];
  double most = 0.25 * size[axis];
  for (int side = 0; side < 6; ++side)
  {
    const int other = side / 2;
    const double gap = side % 2 ? box.Max[other] - small.Max[other] : small.Min[other] - box.Min[other];
    if (gap > most)
    {
      most = gap;
      axis = other;
      place = side % 2 ? small.Max[other] : small.Min[other];
    }
  }
  Box halves[2] = { box, box };
  WithComponent(halves[0].Max, axis, place);
  WithComponent(halves[1].Min, axis, place);
  const auto index = static_cast<int>(this->Nodes.size());
  this->Nodes.emplace_back();
  int children[2];
  for (int half = 0; half < 2; ++half)
  {
    const Box wide = Enlarged(halves[half], overlap * halves[half].Diagonal());
    std::vector<vtkIdType> inside;
    Box tight;
    for (const vtkIdType t : triangles)
    {
      const Box part = Intersection(mesh.BoundsOf(t), wide);
      if (!part.Empty())
      {
        inside.push_back(t);
        tight.Add(Intersection(part, halves[half]));
      }
    }
    children[half] = tight.Empty() ? -1 : this->Build(mesh, inside, tight, depth + 1);
  }
  Node& node = this->Nodes[static_cast<std::size_t>(index)];
  node.Bounds = Enlarged(box, overlap * diagonal);
  node.Axis = axis;
  node.First = children[0];
  node.Second = children[1];
  return index;
}

int OccluderCells::AddLeaf(const TriangleMeshView& mesh, const std::vector<vtkIdType>& triangles, const Box& box)
{
  OccluderCell cell;
  const double diagonal = box.Diagonal();
  cell.Bounds = Enlarged(box, overlap * diagonal);
  cell.Center = box.Center();
  cell.Scale = diagonal > 0.0 ? 2.0 / diagonal : 1.0;
  cell.RayMargin = RayMargin / cell.Scale;
  cell.Reach = Reach / cell.Scale;
  const Box reach = Enlarged(box, 2.0 * overlap * diagonal);
  const bool whole = this->Nodes.empty();
  cell.Pieces.reserve(triangles.size());
  Polygon polygon;
  for (const vtkIdType t : triangles)
  {
    const Vector3 a = mesh.Corner(t, 0);
    const Vector3 normal = Cross(mesh.Corner(t, 1) - a, mesh.Corner(t, 2) - a);
    if (!(Dot(normal, normal) > 0.0))
    {
      continue; // nothing crosses it
    }
    polygon = { a, mesh.Corner(t, 1), mesh.Corner(t, 2) };
    if (!whole)
    {
      CutOff(polygon, reach);
    }
    for (Vector3& p : polygon)
    {
      p = cell.Scale * (p - cell.Center);
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      AddEnlarged(cell, t, { polygon[0], polygon[i - 1], polygon[i] }, normal);
    }
  }
  Node leaf;
  leaf.Bounds = cell.Bounds;
  leaf.Cell = static_cast<int>(this->Cells.size());
  this->Cells.push_back(std::move(cell));
  this->Nodes.push_back(leaf);
  return static_cast<int>(this->Nodes.size()) - 1;
}

} // namespace shadowcones
