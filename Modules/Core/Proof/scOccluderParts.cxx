// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderParts.h"

#include "scLampPlane.h"

#include <algorithm>
#include <cstdint>

namespace shadowcones
{
namespace
{
constexpr vtkIdType trianglesPerLeaf = 8;
constexpr vtkIdType fanOut = 4;
constexpr vtkIdType mostRoots = 2048; ///< nodes that are searched side by side
/// Occluders are cut to edges of the square root of this share of their area, so that few large triangles make enough parts.
constexpr double areaFraction = 1.0 / 3000.0;
/// The area of slivers says nothing of their length: they are cut into so many pieces in all, and as many more a triangle.
constexpr double mostPieces = 30000.0;
constexpr double mostPiecesOfTriangle = 81.0;
/// log2(3): a needle is cut into three of half its length.
constexpr double piecesOfNeedle = 1.585;
/// Where cones hold a part of a triangle, edges are cut to this share of the largest base radius there.
constexpr double radiusFraction = 0.35;
/// Parts near a light are cut to this share of their distance from it, and no finer than nearestFraction of the light's radius.
constexpr double distanceFraction = 0.5;
constexpr double nearestFraction = 1.0 / 64.0;
/// No part is cut finer than this share of what is fine enough far from the light.
constexpr double smallestFraction = 1.0 / 1024.0;
/// A part of the light is halved before occluders that come nearer than this share of its radius.
constexpr double halvingFraction = 0.5;

/// Every third bit of a word is one of @p x's 21.
std::uint64_t SpreadBits(std::uint64_t x)
{
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFFull;
  x = (x | x << 16) & 0x1F0000FF0000FFull;
  x = (x | x << 8) & 0x100F00F00F00F00Full;
  x = (x | x << 4) & 0x10C30C30C30C30C3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

std::array<Vector3, 3> CornersOf(const TriangleMeshView& mesh, vtkIdType triangle)
{
  return { mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2) };
}

/// Squared length of the edge from corner i to the next.
double SquaredEdge(const std::array<Vector3, 3>& corners, int i)
{
  const Vector3 edge = corners[(i + 1) % 3] - corners[i];
  return Dot(edge, edge);
}

/// The longest edge, the first of those.
int LongestEdge(const std::array<Vector3, 3>& corners)
{
  int longest = 0;
  for (int i = 1; i < 3; ++i)
  {
    longest = SquaredEdge(corners, i) > SquaredEdge(corners, longest) ? i : longest;
  }
  return longest;
}
} // anonymous namespace

/// Descends the nodes over the triangles with the cones that may hold a part of what is there.
class OccluderParts::Search
{
public:
  Search(const OccluderParts& parts, const std::vector<Cone>& cones)
    : Parts(parts)
  {
    for (const Cone& cone : cones)
    {
      this->Cones.emplace_back(cone);
      this->Radii.push_back(cone.BaseRadius);
    }
  }

  std::vector<OccluderPart> Unproved;
  vtkIdType Proved = 0;

  void Node(std::size_t level, vtkIdType index, int light, const std::vector<int>& candidates)
  {
    const OccluderParts::Node& node = this->Parts.Levels[level][index];
    const Vector3 center = node.Bounds.Center();
    const double radius = 0.5 * node.Bounds.Diagonal();
    const LightPart& part = this->Parts.Lights[light];
    if (part.OneSided && Dot(center - part.Center, part.Normal) + radius <= 0.0)
    {
      return;
    }
    if (this->TakeHalves(part, center, radius))
    {
      for (const int half : part.Halves)
      {
        this->Node(level, index, half, candidates);
      }
      return;
    }
    std::vector<int> left;
    if (this->Filter(part, center, radius, candidates, left))
    {
      this->Proved += node.End - node.Begin;
      return;
    }
    if (level == 0)
    {
      for (vtkIdType i = node.Begin; i < node.End; ++i)
      {
        const vtkIdType triangle = this->Parts.Order[i];
        const auto corners = CornersOf(this->Parts.View, triangle);
        if (!IsFlush(this->Parts.Face, corners[0], corners[1], corners[2]))
        {
          this->Piece({ corners, triangle, light }, left);
        }
      }
      return;
    }
    const auto below = static_cast<vtkIdType>(this->Parts.Levels[level - 1].size());
    for (vtkIdType child = fanOut * index; child < std::min(below, fanOut * (index + 1)); ++child)
    {
      this->Node(level - 1, child, light, left);
    }
  }

private:
  bool TakeHalves(const LightPart& part, const Vector3& center, double radius) const
  {
    return part.Halves[0] >= 0 && part.Distance(center) - radius < halvingFraction * part.Radius;
  }

  /// The cones that may hold a point of the ball. @return true where one holds all of it.
  bool Filter(const LightPart& part, const Vector3& center, double radius, const std::vector<int>& candidates,
    std::vector<int>& left) const
  {
    const double margin = this->Parts.Margin.At(center) + this->Parts.Margin.Relative * radius;
    for (const int k : candidates)
    {
      const BoundingCone& cone = this->Cones[k];
      const double depth = cone.Depth(center);
      if (std::min(depth, cone.ShadowDepthAtMost(part, center)) + radius < 0.0)
      {
        continue;
      }
      if (std::min(depth, cone.ShadowDepthAtLeast(part, center)) - radius >= margin)
      {
        return true;
      }
      left.push_back(k);
    }
    return false;
  }

  bool Held(const LightPart& part, const Polygon& polygon, int k) const
  {
    return std::all_of(polygon.begin(), polygon.end(),
      [&](const Vector3& p) { return this->Cones[k].Holds(part, p, this->Parts.Margin.At(p)); });
  }

  /// How long an edge may stay that no cone holds.
  double LargestEdge(const LightPart& part, const Vector3& center, double radius, const std::vector<int>& candidates) const
  {
    double largest = this->Parts.LargestEdge;
    double base = 0.0;
    for (const int k : candidates)
    {
      base = std::max(base, this->Radii[k]);
    }
    if (base > 0.0)
    {
      largest = std::min(largest, std::max(radiusFraction * base, 0.1 * largest));
    }
    const double distance = std::max(0.0, part.Distance(center) - radius);
    const double least = std::max({ nearestFraction * part.Radius, smallestFraction * this->Parts.LargestEdge,
      8.0 * this->Parts.Margin.At(center) });
    return std::max(least, std::min(largest, distanceFraction * distance));
  }

  void Piece(const OccluderPart& piece, const std::vector<int>& candidates)
  {
    const LightPart& part = this->Parts.Lights[piece.Light];
    const Polygon polygon = InFrontOf(part, piece.Corners);
    if (polygon.Count == 0)
    {
      return;
    }
    const Vector3 center = (1.0 / 3.0) * (piece.Corners[0] + piece.Corners[1] + piece.Corners[2]);
    double radius = 0.0;
    for (const Vector3& corner : piece.Corners)
    {
      radius = std::max(radius, Length(corner - center));
    }
    if (this->TakeHalves(part, center, radius))
    {
      for (const int half : part.Halves)
      {
        this->Piece({ piece.Corners, piece.Triangle, half }, candidates);
      }
      return;
    }
    std::vector<int> left;
    if (this->Filter(part, center, radius, candidates, left) ||
      std::any_of(left.begin(), left.end(), [&](int k) { return this->Held(part, polygon, k); }))
    {
      ++this->Proved;
      return;
    }
    const int edge = LongestEdge(piece.Corners);
    if (SquaredEdge(piece.Corners, edge) <= std::pow(this->LargestEdge(part, center, radius, left), 2.0))
    {
      this->Unproved.push_back(piece);
      return;
    }
    const Vector3 middle = 0.5 * (piece.Corners[edge] + piece.Corners[(edge + 1) % 3]);
    for (const int replaced : { (edge + 1) % 3, edge })
    {
      OccluderPart half = piece;
      half.Corners[replaced] = middle;
      this->Piece(half, left);
    }
  }

  const OccluderParts& Parts;
  std::vector<BoundingCone> Cones;
  std::vector<double> Radii;
};

OccluderParts::OccluderParts(const TriangleMeshView& mesh, const Light& light, const ProofMargins& margins)
  : View(mesh)
  , Lights(LightPartsOf(light))
  , Face(FlatFaceOf(light))
  , Margin(margins)
{
  double area = 0.0;
  double needles = 0.0; // pieces of length 1, if all were needles
  for (vtkIdType i = 0; i < mesh.NumberOfTriangles; ++i)
  {
    const auto corners = CornersOf(mesh, i);
    area += 0.5 * Length(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    needles += std::pow(SquaredEdge(corners, LongestEdge(corners)), 0.5 * piecesOfNeedle);
  }
  const double pieces = mostPieces + mostPiecesOfTriangle * static_cast<double>(mesh.NumberOfTriangles);
  this->LargestEdge = std::max(std::sqrt(areaFraction * area), std::pow(needles / pieces, 1.0 / piecesOfNeedle));
  this->BuildNodes();
}

void OccluderParts::BuildNodes()
{
  const Box bounds = MeshBounds(this->View);
  const double scale = bounds.Diagonal() > 0.0 ? 2097151.0 / bounds.Diagonal() : 0.0;
  std::vector<std::pair<std::uint64_t, vtkIdType>> codes;
  codes.reserve(static_cast<std::size_t>(this->View.NumberOfTriangles));
  for (vtkIdType i = 0; i < this->View.NumberOfTriangles; ++i)
  {
    if (this->View.OccluderId(i) >= 0)
    {
      const auto c = CornersOf(this->View, i);
      const Vector3 p = (scale / 3.0) * (c[0] + c[1] + c[2]) - scale * bounds.Min;
      const auto bits = [](double x) { return SpreadBits(static_cast<std::uint64_t>(std::max(0.0, x))); };
      codes.push_back({ bits(p.X) | bits(p.Y) << 1 | bits(p.Z) << 2, i });
    }
  }
  std::sort(codes.begin(), codes.end());
  this->Order.reserve(codes.size());
  for (const auto& code : codes)
  {
    this->Order.push_back(code.second);
  }
  const auto count = static_cast<vtkIdType>(codes.size());
  codes = {};
  this->Levels.emplace_back();
  this->Levels[0].reserve(static_cast<std::size_t>((count + trianglesPerLeaf - 1) / trianglesPerLeaf));
  for (vtkIdType begin = 0; begin < count; begin += trianglesPerLeaf)
  {
    Node leaf{ {}, begin, std::min(count, begin + trianglesPerLeaf) };
    for (vtkIdType i = leaf.Begin; i < leaf.End; ++i)
    {
      for (const Vector3& corner : CornersOf(this->View, this->Order[i]))
      {
        leaf.Bounds.Add(corner);
      }
    }
    this->Levels[0].push_back(leaf);
  }
  while (static_cast<vtkIdType>(this->Levels.back().size()) > mostRoots)
  {
    std::vector<Node> level;
    const std::vector<Node>& below = this->Levels.back();
    for (std::size_t first = 0; first < below.size(); first += static_cast<std::size_t>(fanOut))
    {
      Node node{ {}, below[first].Begin, 0 };
      for (std::size_t i = first; i < std::min<std::size_t>(below.size(), first + fanOut); ++i)
      {
        node.Bounds.Add(below[i].Bounds);
        node.End = below[i].End;
      }
      level.push_back(node);
    }
    this->Levels.push_back(std::move(level));
  }
}

std::vector<HeldPoint> OccluderParts::CastingPoints(const OccluderPart& part) const
{
  std::vector<HeldPoint> points;
  for (const Vector3& p : InFrontOf(this->Lights[part.Light], part.Corners))
  {
    points.push_back({ p, part.Light, this->Margin.At(p) });
  }
  return points;
}

bool OccluderParts::FindUnproved(const std::vector<Cone>& cones, const Monitor& monitor,
  std::vector<OccluderPart>& unproved, vtkIdType& proved) const
{
  unproved.clear();
  proved = 0;
  std::vector<int> all;
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    all.push_back(static_cast<int>(i));
  }
  const std::size_t top = this->Levels.size() - 1;
  const auto roots = static_cast<vtkIdType>(this->Levels[top].size());
  std::vector<std::vector<OccluderPart>> found(static_cast<std::size_t>(roots));
  std::vector<vtkIdType> counts(static_cast<std::size_t>(roots), 0);
  const bool finished = ParallelFor(roots, monitor, [&](vtkIdType first, vtkIdType last) {
    Search search(*this, cones);
    for (vtkIdType root = first; root < last; ++root)
    {
      search.Proved = 0;
      search.Node(top, root, 0, all);
      counts[root] = search.Proved;
      found[root].swap(search.Unproved);
    }
  });
  std::size_t size = 0;
  for (const std::vector<OccluderPart>& ofRoot : found)
  {
    size += ofRoot.size();
  }
  unproved.reserve(finished ? size : 0);
  for (vtkIdType root = 0; finished && root < roots; ++root)
  {
    proved += counts[root];
    unproved.insert(unproved.end(), found[root].begin(), found[root].end());
    found[root] = {};
  }
  return finished;
}

} // namespace shadowcones
