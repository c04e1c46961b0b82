// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderTopology.h"

#include "scRandom.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace shadowcones
{
namespace
{

using Ids = std::vector<vtkIdType>;
constexpr double Epsilon = std::numeric_limits<double>::epsilon();

/// Disjoint sets; the root is the smallest member, so that labels do not depend on the order of unions.
class DisjointSets
{
public:
  explicit DisjointSets(vtkIdType count)
    : Parents(static_cast<std::size_t>(count))
  {
    std::iota(this->Parents.begin(), this->Parents.end(), vtkIdType(0));
  }
  vtkIdType Root(vtkIdType item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }
  void Unite(vtkIdType a, vtkIdType b)
  {
    a = this->Root(a);
    b = this->Root(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  Ids Parents;
};

/// Differences of the mesh's points, over the diagonal of its bounds: no size is too large or too small to be multiplied.
class UnitFrame
{
public:
  explicit UnitFrame(const TriangleMeshView& mesh)
    : Mesh(mesh)
  {
    const Box bounds = MeshBounds(mesh);
    if (bounds.Empty())
    {
      return;
    }
    const Vector3 size = bounds.Size();
    const double diagonal = std::hypot(size.X, size.Y, size.Z);
    if (!std::isfinite(diagonal))
    {
      throw std::runtime_error("The mesh's bounds are too large to be measured.");
    }
    this->Diagonal = diagonal > 0.0 ? diagonal : 1.0;
  }
  Vector3 Between(vtkIdType from, vtkIdType to) const
  {
    const Vector3 d = this->Mesh.Point(to) - this->Mesh.Point(from);
    return { d.X / this->Diagonal, d.Y / this->Diagonal, d.Z / this->Diagonal };
  }
  /// What rounding of a point's coordinates alone can make.
  double Rounding(vtkIdType id) const { return RoundingOf(this->Mesh.Point(id)) / this->Diagonal; }

  static double RoundingOf(const Vector3& p)
  {
    return 4.0 * Epsilon * std::max({ std::abs(p.X), std::abs(p.Y), std::abs(p.Z) });
  }

private:
  const TriangleMeshView& Mesh;
  double Diagonal = 1.0;
};

std::uint64_t Bits(double value)
{
  std::uint64_t bits = 0;
  value += 0.0; // -0 and 0 are the same place
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

/// Side k of triangle t is number 3 t + k; it runs from corner k to the next one.
vtkIdType NextSide(vtkIdType side)
{
  return side % 3 == 2 ? side - 2 : side + 1;
}

/// How far from each point another one is the same; points that no triangle uses get 0.
std::vector<double> WeldDistances(const TriangleMeshView& mesh, double share)
{
  std::vector<double> shortest(static_cast<std::size_t>(mesh.NumberOfPoints), HUGE_VAL);
  for (vtkIdType side = 0; side < 3 * mesh.NumberOfTriangles; ++side)
  {
    const vtkIdType a = mesh.Triangles[side];
    const vtkIdType b = mesh.Triangles[NextSide(side)];
    const Vector3 edge = mesh.Point(b) - mesh.Point(a);
    const double length = std::hypot(edge.X, edge.Y, edge.Z);
    // Ends that are the same place are no edge.
    if (length > std::max(UnitFrame::RoundingOf(mesh.Point(a)), UnitFrame::RoundingOf(mesh.Point(b))))
    {
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  }
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    const double rounding = UnitFrame::RoundingOf(mesh.Point(i));
    const double edge = std::isfinite(shortest[i]) ? shortest[i] : 0.0;
    shortest[i] = share > 0.0 ? std::max(share * edge, rounding) : 0.0;
  }
  return shortest;
}

/**
 * Points that are kept, in hashed grids: one grid for each power of two that is just above a point's distance, with cells
 * of four times that, so that a query looks into 1 to 8 cells of each grid. Distance 0: cells are the very coordinates.
 */
class WeldGrids
{
public:
  WeldGrids(const TriangleMeshView& mesh, const std::vector<int>& blocks, const std::vector<double>& distances)
    : Mesh(mesh)
    , Blocks(blocks)
    , Distances(distances)
    , Next(distances.size(), -1)
  {
    std::size_t numberOfBuckets = 16;
    while (numberOfBuckets < 2 * distances.size())
    {
      numberOfBuckets *= 2;
    }
    this->Heads.assign(numberOfBuckets, -1);
  }

  /// The earliest kept point of the same block, no farther than the smaller of both points' distances; else @p id.
  vtkIdType Find(vtkIdType id) const
  {
    vtkIdType found = id;
    const Vector3 p = this->Mesh.Point(id);
    for (const double reach : this->Reaches)
    {
      const double distance = std::min(reach, this->Distances[id]);
      double low[3];
      double high[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = Cell(p[axis] - distance, reach);
        high[axis] = Cell(p[axis] + distance, reach);
      }
      for (int corner = 0; corner < 8; ++corner)
      {
        const bool x = corner & 1;
        const bool y = corner & 2;
        const bool z = corner & 4;
        if ((x && low[0] == high[0]) || (y && low[1] == high[1]) || (z && low[2] == high[2]))
        {
          continue;
        }
        const std::size_t bucket =
          this->Bucket(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2], reach, this->Blocks[id]);
        for (vtkIdType j = this->Heads[bucket]; j >= 0; j = this->Next[j])
        {
          found = j < found && this->AreOne(id, j) ? j : found;
        }
      }
    }
    return found;
  }

  void Add(vtkIdType id)
  {
    const double reach = Reach(this->Distances[id]);
    if (std::find(this->Reaches.begin(), this->Reaches.end(), reach) == this->Reaches.end())
    {
      this->Reaches.push_back(reach);
    }
    const Vector3 p = this->Mesh.Point(id);
    vtkIdType& head = this->Heads[this->Bucket(
      Cell(p.X, reach), Cell(p.Y, reach), Cell(p.Z, reach), reach, this->Blocks[id])];
    this->Next[id] = head;
    head = id;
  }

private:
  static double Reach(double distance) { return distance > 0.0 ? std::ldexp(1.0, std::ilogb(distance) + 1) : 0.0; }
  static double Cell(double x, double reach) { return reach > 0.0 ? std::floor(x / (4.0 * reach)) : x; }
  std::size_t Bucket(double x, double y, double z, double reach, int block) const
  {
    const std::uint64_t xy = Mix64(Mix64(Bits(x)) + Bits(y) * 0x9E3779B97F4A7C15ull);
    const std::uint64_t all = Mix64(Mix64(xy + Bits(z)) + Bits(reach));
    return Mix64(all + static_cast<std::uint64_t>(block)) & (this->Heads.size() - 1);
  }
  bool AreOne(vtkIdType i, vtkIdType j) const
  {
    const Vector3 d = this->Mesh.Point(i) - this->Mesh.Point(j);
    return this->Blocks[i] == this->Blocks[j] &&
      std::hypot(d.X, d.Y, d.Z) <= std::min(this->Distances[i], this->Distances[j]);
  }

  const TriangleMeshView& Mesh;
  const std::vector<int>& Blocks;
  const std::vector<double>& Distances;
  std::vector<double> Reaches;
  Ids Heads;
  Ids Next;
};

/// For each point the earliest kept point that is one with it; points that no triangle uses get -1.
Ids WeldPoints(const TriangleMeshView& mesh, const int* blocks, double share)
{
  Ids kept(static_cast<std::size_t>(mesh.NumberOfPoints), -1);
  std::vector<int> blockOf(kept.size(), 0);
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    kept[mesh.Triangles[i]] = mesh.Triangles[i];
    blockOf[mesh.Triangles[i]] = blocks ? blocks[i / 3] : 0;
  }
  const std::vector<double> distances = WeldDistances(mesh, share);
  WeldGrids grids(mesh, blockOf, distances);
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    if (kept[i] < 0)
    {
      continue;
    }
    kept[i] = grids.Find(i);
    if (kept[i] == i)
    {
      grids.Add(i);
    }
  }
  return kept;
}

/// No area: the height above the longest edge is a matter of rounding.
bool IsDegenerate(const UnitFrame& frame, vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (a == b || b == c || c == a)
  {
    return true;
  }
  const Vector3 u = frame.Between(a, b);
  const Vector3 v = frame.Between(a, c);
  const double longest = std::max({ Length(u), Length(v), Length(u - v) });
  const double rounding = std::max({ frame.Rounding(a), frame.Rounding(b), frame.Rounding(c) });
  return !(Length(Cross(u, v)) > rounding * longest);
}

/// Fill Triangles (of input point ids) and SourceTriangles with what is neither degenerate nor there twice.
void KeepProperTriangles(
  const TriangleMeshView& mesh, const UnitFrame& frame, const Ids& weld, OccluderTopology& result)
{
  struct Face
  {
    std::array<vtkIdType, 3> Sorted;
    bool Receiver;
    vtkIdType Source;
  };
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles; ++t)
  {
    const vtkIdType* ids = mesh.Triangles + 3 * t;
    std::array<vtkIdType, 3> sorted{ weld[ids[0]], weld[ids[1]], weld[ids[2]] };
    if (IsDegenerate(frame, sorted[0], sorted[1], sorted[2]))
    {
      ++result.DegenerateTriangles;
      continue;
    }
    std::sort(sorted.begin(), sorted.end());
    faces.push_back({ sorted, mesh.OccluderId(t) < 0, t });
  }
  std::sort(faces.begin(), faces.end(),
    [](const Face& a, const Face& b)
    {
      return a.Sorted != b.Sorted  ? a.Sorted < b.Sorted
        : a.Receiver != b.Receiver ? a.Receiver < b.Receiver
                                   : a.Source < b.Source;
    });
  const auto last = std::unique(faces.begin(), faces.end(),
    [](const Face& a, const Face& b) { return a.Sorted == b.Sorted && a.Receiver == b.Receiver; });
  result.DuplicateTriangles = static_cast<vtkIdType>(faces.end() - last);
  faces.erase(last, faces.end());

  result.SourceTriangles.reserve(faces.size());
  for (const Face& face : faces)
  {
    result.SourceTriangles.push_back(face.Source);
  }
  std::sort(result.SourceTriangles.begin(), result.SourceTriangles.end());
  result.Triangles.reserve(3 * faces.size());
  for (const vtkIdType source : result.SourceTriangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles.push_back(weld[mesh.Triangles[3 * source + k]]);
    }
  }
}

/// Renumber the triangles' points from 0, in input order.
void CompactPoints(vtkIdType numberOfPoints, OccluderTopology& result)
{
  Ids numbers(static_cast<std::size_t>(numberOfPoints), -1);
  for (const vtkIdType id : result.Triangles)
  {
    numbers[id] = 0;
  }
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    if (numbers[i] == 0)
    {
      numbers[i] = static_cast<vtkIdType>(result.Points.size());
      result.Points.push_back(i);
    }
  }
  for (vtkIdType& id : result.Triangles)
  {
    id = numbers[id];
  }
}

/// For each side the one other side on the same edge, or -1 where there is none or more than one. Counts the edges.
Ids PairSides(OccluderTopology& result)
{
  const Ids& corners = result.Triangles;
  const auto numberOfSides = static_cast<vtkIdType>(corners.size());
  const auto low = [&](vtkIdType side) { return std::min(corners[side], corners[NextSide(side)]); };
  const auto high = [&](vtkIdType side) { return std::max(corners[side], corners[NextSide(side)]); };

  // Counting sort by the lower point, then each point's few sides by the higher one.
  Ids begin(result.Points.size() + 1, 0);
  Ids sides;
  for (vtkIdType side = 0; side < numberOfSides; ++side)
  {
    begin[low(side) + 1] += result.OccluderIds[side / 3] >= 0;
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  sides.resize(static_cast<std::size_t>(begin.back()));
  Ids fill(begin.begin(), begin.end() - 1);
  for (vtkIdType side = 0; side < numberOfSides; ++side)
  {
    if (result.OccluderIds[side / 3] >= 0)
    {
      sides[fill[low(side)]++] = side;
    }
  }

  Ids opposite(corners.size(), -1);
  for (std::size_t point = 0; point < result.Points.size(); ++point)
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
        ++result.BoundaryEdges;
      }
      else if (end - edge == 2)
      {
        opposite[edge[0]] = edge[1];
        opposite[edge[1]] = edge[0];
      }
      else
      {
        ++result.NonManifoldEdges;
      }
      edge = end;
    }
  }
  return opposite;
}

/// Triangles that winding can spread over.
struct Patches
{
  Ids Order;                       ///< triangles, patch after patch, each next to an earlier one of its patch
  Ids Begin;                       ///< of each patch in Order, and the end
  std::vector<unsigned char> Flip; ///< for each triangle: wound against the first one of its patch
};

/// Spread winding; sides where it contradicts itself (a surface that cannot be oriented) are taken apart.
Patches SpreadWinding(const OccluderTopology& topology, Ids& opposite)
{
  const std::size_t count = topology.SourceTriangles.size();
  Patches patches;
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

/// Half-edges of consistently wound triangles; tells which patches have a border.
class HalfEdgeSurface
{
public:
  HalfEdgeSurface(const OccluderTopology& topology, const Ids& opposite, const Patches& patches)
  {
    // A vertex is a fan of corners that are joined over edges, so that surfaces that only touch are taken apart.
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
    const std::size_t numberOfTriangles = topology.SourceTriangles.size();
    this->Mesh.reserve(numberOfTriangles / 2, 3 * numberOfTriangles / 2, numberOfTriangles);
    std::vector<OpenMesh::VertexHandle> vertices(topology.Triangles.size());
    std::vector<OpenMesh::HalfedgeHandle> sides(topology.Triangles.size());
    const Ids partners = PartnersOf(topology, opposite, patches, fans);
    this->Faces.resize(numberOfTriangles);
    for (const vtkIdType triangle : patches.Order)
    {
      // Linked by hand: OpenMesh would look for each side all around its corners.
      OpenMesh::HalfedgeHandle around[3];
      for (int k = 0; k < 3; ++k)
      {
        const vtkIdType side = 3 * triangle + k;
        OpenMesh::VertexHandle ends[2] = { this->Vertex(vertices, fans.Root(side)),
          this->Vertex(vertices, fans.Root(NextSide(side))) };
        if (patches.Flip[triangle])
        {
          std::swap(ends[0], ends[1]);
        }
        const vtkIdType other = partners[side];
        const bool known = other >= 0 && sides[other].is_valid();
        sides[side] = known ? this->Mesh.opposite_halfedge_handle(sides[other]) : this->Mesh.new_edge(ends[0], ends[1]);
        around[patches.Flip[triangle] ? 2 - k : k] = sides[side];
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
  }

  bool HasBorder(vtkIdType triangle) const { return this->Mesh.is_boundary(this->Faces[triangle]); }

private:
  /**
   * The side across each side's edge. Where more than two triangles meet the surfaces have been taken apart: sides that run
   * between the same two vertices, one each way, belong together.
   */
  static Ids PartnersOf(
    const OccluderTopology& topology, const Ids& opposite, const Patches& patches, DisjointSets& fans)
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

  OpenMesh::VertexHandle Vertex(std::vector<OpenMesh::VertexHandle>& vertices, vtkIdType fan)
  {
    OpenMesh::VertexHandle& vertex = vertices[fan];
    vertex = vertex.is_valid() ? vertex : OpenMesh::VertexHandle(this->Mesh.add_vertex());
    return vertex;
  }

  OpenMesh::TriConnectivity Mesh;
  std::vector<OpenMesh::FaceHandle> Faces;
};

/// Does the first triangle of a patch have to be flipped? Closed: for a positive volume; open: where most others say
/// so.
bool FlipsFirst(const TriangleMeshView& mesh, const UnitFrame& frame, const OccluderTopology& topology,
  const Patches& patches, std::size_t patch, bool closed)
{
  const vtkIdType* begin = patches.Order.data() + patches.Begin[patch];
  const vtkIdType* end = patches.Order.data() + patches.Begin[patch + 1];
  if (closed)
  {
    const vtkIdType origin = mesh.Triangles[3 * topology.SourceTriangles[*begin]];
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

/// OccluderIds from 0 in order of the first triangle; receivers stay negative. @return the number of occluders.
int LabelOccluders(const int* blocks, OccluderLabel labelBy, OccluderTopology& result)
{
  const auto count = static_cast<vtkIdType>(result.SourceTriangles.size());
  DisjointSets components(labelBy == OccluderLabel::Component ? static_cast<vtkIdType>(result.Points.size()) : 0);
  vtkIdType numberOfKeys = 1;
  if (labelBy == OccluderLabel::Component)
  {
    numberOfKeys = static_cast<vtkIdType>(result.Points.size());
    for (vtkIdType t = 0; t < count; ++t)
    {
      if (result.OccluderIds[t] >= 0)
      {
        components.Unite(result.Triangles[3 * t], result.Triangles[3 * t + 1]);
        components.Unite(result.Triangles[3 * t], result.Triangles[3 * t + 2]);
      }
    }
  }
  else if (labelBy == OccluderLabel::Block)
  {
    for (vtkIdType t = 0; t < count; ++t)
    {
      numberOfKeys = std::max<vtkIdType>(numberOfKeys, blocks[result.SourceTriangles[t]] + 1);
    }
  }
  std::vector<int> labels(static_cast<std::size_t>(numberOfKeys), -1);
  int numberOfOccluders = 0;
  for (vtkIdType t = 0; t < count; ++t)
  {
    if (result.OccluderIds[t] < 0)
    {
      continue;
    }
    const vtkIdType key = labelBy == OccluderLabel::Component ? components.Root(result.Triangles[3 * t])
      : labelBy == OccluderLabel::Block                       ? blocks[result.SourceTriangles[t]]
                                                              : 0;
    labels[key] = labels[key] < 0 ? numberOfOccluders++ : labels[key];
    result.OccluderIds[t] = labels[key];
  }
  return numberOfOccluders;
}

} // namespace

bool BuildOccluderTopology(const TriangleMeshView& mesh, const int* blocks, const OccluderTopologyOptions& options,
  const Monitor& monitor, OccluderTopology& result)
{
  result = OccluderTopology();
  const auto report = [&monitor](double share)
  {
    if (monitor.Progress)
    {
      monitor.Progress(share);
    }
    return !monitor.IsAborted();
  };
  if (!report(0.0))
  {
    return false;
  }
  const int* weldBlocks = options.LabelBy == OccluderLabel::Block ? blocks : nullptr;
  const UnitFrame frame(mesh);
  const Ids weld = WeldPoints(mesh, weldBlocks, options.WeldTolerance);
  for (vtkIdType i = 0; i < mesh.NumberOfPoints; ++i)
  {
    result.WeldedPoints += weld[i] >= 0 && weld[i] != i;
  }
  if (!report(0.3))
  {
    return false;
  }
  KeepProperTriangles(mesh, frame, weld, result);
  CompactPoints(mesh.NumberOfPoints, result);
  for (const vtkIdType source : result.SourceTriangles)
  {
    result.OccluderIds.push_back(mesh.OccluderId(source) < 0 ? -1 : 0);
  }
  result.Closed.assign(static_cast<std::size_t>(LabelOccluders(blocks, options.LabelBy, result)), 1);
  if (!report(0.5))
  {
    return false;
  }
  Ids opposite = PairSides(result);
  Patches patches = SpreadWinding(result, opposite);
  if (!report(0.7))
  {
    return false;
  }
  const HalfEdgeSurface surface(result, opposite, patches);
  for (std::size_t patch = 0; patch + 1 < patches.Begin.size(); ++patch)
  {
    const auto begin = patches.Order.begin() + patches.Begin[patch];
    const auto end = patches.Order.begin() + patches.Begin[patch + 1];
    const bool closed =
      std::none_of(begin, end, [&surface](vtkIdType triangle) { return surface.HasBorder(triangle); });
    unsigned char& occluderClosed = result.Closed[result.OccluderIds[*begin]];
    occluderClosed = occluderClosed && closed;
    const bool flipFirst = FlipsFirst(mesh, frame, result, patches, patch, closed);
    for (auto triangle = begin; triangle != end && options.Orient; ++triangle)
    {
      patches.Flip[*triangle] ^= static_cast<unsigned char>(flipFirst);
    }
  }
  for (std::size_t t = 0; t < patches.Flip.size() && options.Orient; ++t)
  {
    if (patches.Flip[t])
    {
      std::swap(result.Triangles[3 * t + 1], result.Triangles[3 * t + 2]);
      ++result.FlippedTriangles;
    }
  }
  return report(1.0);
}

} // namespace shadowcones
