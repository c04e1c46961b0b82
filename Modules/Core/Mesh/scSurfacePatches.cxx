// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfacePatches.h"

#include "scDisjointSets.h"
#include "scTriangleSides.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace shadowcones
{
namespace
{
using Ids = std::vector<vtkIdType>;

/// Half-edges of consistently wound triangles; tells which patches have a border.
class HalfEdgeSurface
{
public:
  HalfEdgeSurface(const OccluderTopology& topology, const Ids& opposite, const SurfacePatches& patches)
  {
    DisjointSets fans = FansOf(topology, opposite);
    const std::size_t numberOfTriangles = topology.InputTriangles.size();
    this->Mesh.reserve(numberOfTriangles / 2, 3 * numberOfTriangles / 2, numberOfTriangles);
    this->Vertices.resize(topology.Triangles.size());
    this->Sides.resize(topology.Triangles.size());
    this->Faces.resize(numberOfTriangles);
    const Ids partners = PartnersOf(opposite, patches, fans);
    for (const vtkIdType triangle : patches.Order)
    {
      this->AddTriangle(triangle, patches.Flip[triangle] != 0, partners, fans);
    }
  }

  bool HasBorder(vtkIdType triangle) const { return this->Mesh.is_boundary(this->Faces[triangle]); }

private:
  /// A vertex is a fan of corners that are joined over edges, so that surfaces that only touch are taken apart.
  static DisjointSets FansOf(const OccluderTopology& topology, const Ids& opposite)
  {
    DisjointSets fans(static_cast<vtkIdType>(topology.Triangles.size()));
    for (vtkIdType side = 0; side < static_cast<vtkIdType>(opposite.size()); ++side)
    {
      const vtkIdType other = opposite[side];
      if (other > side)
      {
        const bool sameDirection = topology.Triangles[side] == topology.Triangles[other];
        fans.Unite(side, sameDirection ? other : NextSide(other));
        fans.Unite(NextSide(side), sameDirection ? NextSide(other) : other);
      }
    }
    return fans;
  }

  /// Linked by hand: OpenMesh would look for each side all around its corners.
  void AddTriangle(vtkIdType triangle, bool flip, const Ids& partners, DisjointSets& fans)
  {
    OpenMesh::HalfedgeHandle around[3];
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType side = 3 * triangle + k;
      OpenMesh::VertexHandle ends[2] = { this->Vertex(fans.Root(side)), this->Vertex(fans.Root(NextSide(side))) };
      if (flip)
      {
        std::swap(ends[0], ends[1]);
      }
      const vtkIdType other = partners[side];
      const bool known = other >= 0 && this->Sides[other].is_valid();
      this->Sides[side] =
        known ? this->Mesh.opposite_halfedge_handle(this->Sides[other]) : this->Mesh.new_edge(ends[0], ends[1]);
      around[flip ? 2 - k : k] = this->Sides[side];
    }
    const OpenMesh::FaceHandle face = this->Mesh.new_face();
    this->Mesh.set_halfedge_handle(face, around[0]);
    for (int k = 0; k < 3; ++k)
    {
      this->Mesh.set_face_handle(around[k], face);
      this->Mesh.set_next_halfedge_handle(around[k], around[(k + 1) % 3]);
    }
    this->Faces[triangle] = face;
  }

  /**
   * The side across each side's edge. Where more than two triangles meet the surfaces have been taken apart: sides that run
   * between the same two vertices, one each way, belong together.
   */
  static Ids PartnersOf(const Ids& opposite, const SurfacePatches& patches, DisjointSets& fans)
  {
    struct LooseSide
    {
      vtkIdType Low;
      vtkIdType High;
      bool Forward;
      vtkIdType Side;
    };
    std::vector<LooseSide> loose;
    for (const vtkIdType triangle : patches.Order)
    {
      for (vtkIdType side = 3 * triangle; side < 3 * triangle + 3; ++side)
      {
        if (opposite[side] < 0)
        {
          const vtkIdType a = fans.Root(side);
          const vtkIdType b = fans.Root(NextSide(side));
          loose.push_back({ std::min(a, b), std::max(a, b), (a < b) != (patches.Flip[triangle] != 0), side });
        }
      }
    }
    std::sort(loose.begin(), loose.end(),
      [](const LooseSide& a, const LooseSide& b)
      { return std::tie(a.Low, a.High, a.Side) < std::tie(b.Low, b.High, b.Side); });
    Ids partners = opposite;
    for (std::size_t first = 0; first < loose.size();)
    {
      std::size_t end = first;
      const LooseSide* ways[2] = { nullptr, nullptr };
      for (; end < loose.size() && loose[end].Low == loose[first].Low && loose[end].High == loose[first].High; ++end)
      {
        const LooseSide*& way = ways[loose[end].Forward ? 1 : 0];
        way = way ? way : &loose[end];
      }
      if (ways[0] && ways[1])
      {
        partners[ways[0]->Side] = ways[1]->Side;
        partners[ways[1]->Side] = ways[0]->Side;
      }
      first = end;
    }
    return partners;
  }

  OpenMesh::VertexHandle Vertex(vtkIdType fan)
  {
    OpenMesh::VertexHandle& vertex = this->Vertices[fan];
    vertex = vertex.is_valid() ? vertex : OpenMesh::VertexHandle(this->Mesh.add_vertex());
    return vertex;
  }

  OpenMesh::TriConnectivity Mesh;
  std::vector<OpenMesh::VertexHandle> Vertices;
  std::vector<OpenMesh::HalfedgeHandle> Sides;
  std::vector<OpenMesh::FaceHandle> Faces;
};

/// Does the first triangle of a patch have to be flipped? Closed: for a positive volume; open: where most others say
/// so.
bool FlipsFirst(const TriangleMeshView& mesh, const UnitFrame& frame, const OccluderTopology& topology,
  const SurfacePatches& patches, std::size_t patch, bool closed)
{
  const vtkIdType* begin = patches.Order.data() + patches.Begin[patch];
  const vtkIdType* end = patches.Order.data() + patches.Begin[patch + 1];
  if (closed)
  {
    const vtkIdType origin = mesh.Triangles[3 * topology.InputTriangles[*begin]];
    double volume = 0.0;
    double magnitude = 0.0;
    for (const vtkIdType* triangle = begin; triangle != end; ++triangle)
    {
      Vector3 corner[3];
      for (int k = 0; k < 3; ++k)
      {
        corner[k] = frame.Between(origin, topology.Points[topology.Triangles[3 * *triangle + k]]);
      }
      const double term = Dot(corner[0], Cross(corner[1], corner[2]));
      volume += patches.Flip[*triangle] ? -term : term;
      magnitude += std::abs(term);
    }
    if (std::abs(volume) > 1e-12 * magnitude)
    {
      return volume < 0.0;
    }
  }
  const vtkIdType flipped =
    std::count_if(begin, end, [&patches](vtkIdType triangle) { return patches.Flip[triangle] != 0; });
  return 2 * flipped > end - begin;
}
} // anonymous namespace

std::vector<vtkIdType> PairSides(OccluderTopology& topology)
{
  const Ids& corners = topology.Triangles;
  const auto numberOfSides = static_cast<vtkIdType>(corners.size());
  const auto low = [&](vtkIdType side) { return std::min(corners[side], corners[NextSide(side)]); };
  const auto high = [&](vtkIdType side) { return std::max(corners[side], corners[NextSide(side)]); };

  // Counting sort by the lower point, then each point's few sides by the higher one.
  Ids begin(topology.Points.size() + 1, 0);
  Ids sides;
  for (vtkIdType side = 0; side < numberOfSides; ++side)
  {
    begin[low(side) + 1] += topology.OccluderIds[side / 3] >= 0;
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  sides.resize(static_cast<std::size_t>(begin.back()));
  Ids fill(begin.begin(), begin.end() - 1);
  for (vtkIdType side = 0; side < numberOfSides; ++side)
  {
    if (topology.OccluderIds[side / 3] >= 0)
    {
      sides[fill[low(side)]++] = side;
    }
  }

  Ids opposite(corners.size(), -1);
  for (std::size_t point = 0; point < topology.Points.size(); ++point)
  {
    const auto first = sides.begin() + begin[point];
    const auto last = sides.begin() + begin[point + 1];
    std::sort(first, last, [&](vtkIdType a, vtkIdType b) { return high(a) != high(b) ? high(a) < high(b) : a < b; });
    for (auto edge = first; edge != last;)
    {
      auto end = edge;
      while (end != last && high(*end) == high(*edge))
      {
        ++end;
      }
      if (end - edge == 1)
      {
        ++topology.BoundaryEdges;
      }
      else if (end - edge == 2)
      {
        opposite[edge[0]] = edge[1];
        opposite[edge[1]] = edge[0];
      }
      else
      {
        ++topology.NonManifoldEdges;
      }
      edge = end;
    }
  }
  return opposite;
}

SurfacePatches SpreadWinding(const OccluderTopology& topology, std::vector<vtkIdType>& opposite)
{
  const std::size_t count = topology.InputTriangles.size();
  SurfacePatches patches;
  patches.Flip.assign(count, 0);
  std::vector<unsigned char> visited(count, 0);
  for (std::size_t seed = 0; seed < count; ++seed)
  {
    if (visited[seed] || topology.OccluderIds[seed] < 0)
    {
      continue;
    }
    patches.Begin.push_back(static_cast<vtkIdType>(patches.Order.size()));
    visited[seed] = 1;
    patches.Order.push_back(static_cast<vtkIdType>(seed));
    for (std::size_t head = patches.Order.size() - 1; head < patches.Order.size(); ++head)
    {
      const vtkIdType triangle = patches.Order[head];
      for (vtkIdType side = 3 * triangle; side < 3 * triangle + 3; ++side)
      {
        const vtkIdType other = opposite[side];
        if (other < 0)
        {
          continue;
        }
        // Neighbours that agree run along their edge in opposite directions.
        const bool sameDirection = topology.Triangles[side] == topology.Triangles[other];
        const auto flip =
          static_cast<unsigned char>(patches.Flip[triangle] ^ static_cast<unsigned char>(sameDirection));
        if (!visited[other / 3])
        {
          visited[other / 3] = 1;
          patches.Flip[other / 3] = flip;
          patches.Order.push_back(other / 3);
        }
        else if (patches.Flip[other / 3] != flip)
        {
          opposite[side] = -1;
          opposite[other] = -1;
        }
      }
    }
  }
  patches.Begin.push_back(static_cast<vtkIdType>(patches.Order.size()));
  return patches;
}

std::vector<unsigned char> ClosedPatches(
  const OccluderTopology& topology, const std::vector<vtkIdType>& opposite, const SurfacePatches& patches)
{
  const HalfEdgeSurface surface(topology, opposite, patches);
  std::vector<unsigned char> closed;
  for (std::size_t patch = 0; patch < patches.Count(); ++patch)
  {
    const auto begin = patches.Order.begin() + patches.Begin[patch];
    const auto end = patches.Order.begin() + patches.Begin[patch + 1];
    const bool hasBorder =
      std::any_of(begin, end, [&surface](vtkIdType triangle) { return surface.HasBorder(triangle); });
    closed.push_back(hasBorder ? 0 : 1);
  }
  return closed;
}

void OrientPatches(const TriangleMeshView& mesh, const UnitFrame& frame, const std::vector<unsigned char>& closed,
  SurfacePatches& patches, OccluderTopology& topology)
{
  for (std::size_t patch = 0; patch < patches.Count(); ++patch)
  {
    const bool flipFirst = FlipsFirst(mesh, frame, topology, patches, patch, closed[patch] != 0);
    for (vtkIdType i = patches.Begin[patch]; i < patches.Begin[patch + 1]; ++i)
    {
      patches.Flip[patches.Order[i]] ^= static_cast<unsigned char>(flipFirst);
    }
  }
  for (std::size_t t = 0; t < patches.Flip.size(); ++t)
  {
    if (patches.Flip[t])
    {
      std::swap(topology.Triangles[3 * t + 1], topology.Triangles[3 * t + 2]);
      ++topology.FlippedTriangles;
    }
  }
}

} // namespace shadowcones
