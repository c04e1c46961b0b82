// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowCasters.h"

#include "scConvexGap.h"
#include "scPointWelding.h"
#include "scSurfacePatches.h"
#include "scTriangleSides.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
constexpr vtkIdType leafTriangles = 4;
/// A gap to a box that takes longer to find is not worth it: its triangles are looked at.
constexpr int stepsForBox = 10;

PointHull<3> HullOf(const TriangleMeshView& mesh, vtkIdType triangle)
{
  return { { mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2) } };
}
} // anonymous namespace

ShadowCasters::ShadowCasters(
  const TriangleMeshView& mesh, const unsigned char* ignored, const std::vector<LightBody>& light)
  : Mesh(mesh)
  , AtLight(static_cast<std::size_t>(mesh.NumberOfTriangles), 0)
{
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    if (mesh.OccluderId(t) < 0 || (ignored && ignored[t]))
    {
      continue;
    }
    this->Order.push_back(t);
    this->Extent.Add(mesh.BoundsOf(t));
    const PointHull<3> hull = HullOf(mesh, t);
    this->AtLight[t] = std::any_of(light.begin(), light.end(),
      [&hull](const LightBody& body) { return !body.AtInfinity() && !AreApart(body, hull); });
  }
  this->FindNeighbors();
  if (!this->Order.empty())
  {
    this->Nodes.reserve(this->Order.size());
    this->Build(0, static_cast<vtkIdType>(this->Order.size()));
  }
}

void ShadowCasters::Build(vtkIdType begin, vtkIdType end)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Box bounds;
  Box middles;
  const auto middle = [this](vtkIdType t)
  { return this->Mesh.Corner(t, 0) + this->Mesh.Corner(t, 1) + this->Mesh.Corner(t, 2); };
  for (vtkIdType i = begin; i < end; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      bounds.Add(this->Mesh.Corner(this->Order[i], corner));
    }
    middles.Add(middle(this->Order[i]));
  }
  this->Nodes[index].Bounds = bounds;
  this->BoundNormals(begin, end, this->Nodes[index]);
  if (end - begin <= leafTriangles)
  {
    this->Nodes[index].Begin = begin;
    this->Nodes[index].End = end;
    return;
  }
  const Vector3 size = middles.Size();
  const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : (size.Y >= size.Z ? 1 : 2);
  const vtkIdType half = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + half, this->Order.begin() + end,
    [&](vtkIdType a, vtkIdType b)
    {
      const double x = middle(a)[axis];
      const double y = middle(b)[axis];
      return x != y ? x < y : a < b;
    });
  this->Build(begin, half);
  this->Nodes[index].Second = static_cast<vtkIdType>(this->Nodes.size());
  this->Build(half, end);
}

void ShadowCasters::FindNeighbors()
{
  // Points in one place are one: a mesh from a file of triangles has neighbours too.
  OccluderTopology topology;
  const std::vector<vtkIdType> kept = WeldPoints(this->Mesh, nullptr, 0.0);
  topology.Points.resize(static_cast<std::size_t>(this->Mesh.NumberOfPoints));
  for (vtkIdType i = 0; i < 3 * this->Mesh.NumberOfTriangles; ++i)
  {
    topology.Triangles.push_back(kept[this->Mesh.Triangles[i]]);
  }
  topology.OccluderIds.assign(static_cast<std::size_t>(this->Mesh.NumberOfTriangles), -1);
  for (const vtkIdType t : this->Order)
  {
    topology.OccluderIds[t] = 0;
  }
  this->Opposite = PairSides(topology);
  this->SameWay.resize(this->Opposite.size());
  for (std::size_t side = 0; side < this->Opposite.size(); ++side)
  {
    const vtkIdType other = this->Opposite[side];
    this->SameWay[side] = other >= 0 && topology.Triangles[side] == topology.Triangles[other];
  }
}

Vector3 ShadowCasters::NormalOf(vtkIdType triangle) const
{
  const Vector3 a = this->Mesh.Corner(triangle, 0);
  return Cross(this->Mesh.Corner(triangle, 1) - a, this->Mesh.Corner(triangle, 2) - a);
}

void ShadowCasters::BoundNormals(vtkIdType begin, vtkIdType end, Node& node) const
{
  const auto visit = [&](auto&& call)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType t = this->Order[i];
      call(Normalized(this->NormalOf(t)));
      for (vtkIdType side = 3 * t; side < 3 * t + 3 && this->Opposite[side] >= 0; ++side)
      {
        call(Normalized(this->NormalOf(this->Opposite[side] / 3)));
      }
    }
  };
  Vector3 sum;
  visit([&sum](const Vector3& normal) { sum += normal; });
  node.Normal = Normalized(sum);
  visit([&node](const Vector3& normal) { node.Spread = std::max(node.Spread, Length(normal - node.Normal)); });
  for (vtkIdType i = begin; i < end; ++i)
  {
    const vtkIdType t = this->Order[i];
    node.HasEnds = node.HasEnds || this->AtLight[t];
    for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
    {
      node.HasEnds = node.HasEnds || this->Opposite[side] < 0 || this->SameWay[side];
    }
  }
}

bool ShadowCasters::IsAlike(const Shaft& shaft, const Node& node)
{
  return !node.HasEnds && shaft.SideOf(node.Normal, node.Spread) != 0 && AreApart(shaft.Start(), BoxBody(node.Bounds));
}

template <typename Skip, typename Visitor>
bool ShadowCasters::Visit(const Shaft& shaft, Skip&& skip, Visitor&& visit) const
{
  vtkIdType stack[128];
  int waiting = 0;
  Vector3 across; // what parts the shaft from one node often does so from the next
  for (vtkIdType next = this->Nodes.empty() ? -1 : 0; next >= 0; next = waiting > 0 ? stack[--waiting] : -1)
  {
    const Node& node = this->Nodes[next];
    if (AreApart(shaft, BoxBody(node.Bounds), across, stepsForBox))
    {
      continue;
    }
    if (skip(node))
    {
      continue;
    }
    if (node.End == 0)
    {
      stack[waiting++] = node.Second;
      stack[waiting++] = next + 1;
      continue;
    }
    for (vtkIdType i = node.Begin; i < node.End; ++i)
    {
      if (!AreApart(shaft, HullOf(this->Mesh, this->Order[i]), across) && visit(this->Order[i]))
      {
        return true;
      }
    }
  }
  return false;
}

bool ShadowCasters::Meets(const Shaft& shaft) const
{
  return this->Visit(
    shaft, [](const Node&) { return false; }, [](vtkIdType) { return true; });
}

bool ShadowCasters::EndsInside(const Shaft& shaft, vtkIdType triangle) const
{
  if (this->AtLight[triangle] || !AreApart(shaft.Start(), HullOf(this->Mesh, triangle)))
  {
    return true;
  }
  const int side = shaft.SideOf(this->NormalOf(triangle));
  for (int k = 0; k < 3; ++k)
  {
    const vtkIdType own = 3 * triangle + k;
    const vtkIdType other = this->Opposite[own];
    if (other >= 0 && side != 0)
    {
      const int beyond = shaft.SideOf(this->NormalOf(other / 3));
      if ((this->SameWay[own] ? -beyond : beyond) == side)
      {
        continue;
      }
    }
    const PointHull<2> edge{ { this->Mesh.Corner(triangle, k), this->Mesh.Corner(triangle, (k + 1) % 3) } };
    if (!AreApart(shaft, edge))
    {
      return true;
    }
  }
  return false;
}

ShaftFinding ShadowCasters::Look(const Shaft& shaft) const
{
  bool met = false;
  const auto isAlike = [&](const Node& node)
  {
    const bool alike = IsAlike(shaft, node);
    met = met || alike;
    return alike;
  };
  const auto isEnd = [&](vtkIdType triangle)
  {
    met = true;
    return this->EndsInside(shaft, triangle);
  };
  return this->Visit(shaft, isAlike, isEnd) ? ShaftFinding::Mixed : (met ? ShaftFinding::Alike : ShaftFinding::Clear);
}

} // namespace shadowcones
