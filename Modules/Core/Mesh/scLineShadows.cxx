// SPDX-License-Identifier: BSD-3-Clause
#include "scLineShadows.h"

#include "scOccluderScene.h"
#include "scWideLoops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{
namespace
{
/// In units of rounding: intervals that are nearer to each other than this have no gap between them.
constexpr double joinedWithin = 16.0;
thread_local std::int64_t groupsLookedAt = 0;

} // anonymous namespace

/**
 * The plane of a query, from a point of the line: a corner's height over the plane, its place along the line, and its
 * place on the way to the light, of which the light is 1 (at infinity: a distance). In front of and behind the three edges
 * of the triangle, or strip, and within a slab about the plane: four tests of boxes.
 */
struct LineShadows::Plane
{
  double Origin[3];
  double Normal[3];
  double Along[3];          ///< place on the line of what projects on it along the other axis
  double Towards[3];        ///< place on the way to the light
  double Perspective = 0.0; ///< 1, for a light at infinity 0
  double Nearest = 0.0;     ///< place on the way to the light: what is nearer to the line, or the light, hides nothing
  double Farthest = 0.0;
  double Begin = 0.0; ///< along the line
  double End = 0.0;
  float Tests[4][4]; ///< unit normal, and offset from the mesh's centre with a margin; the first one has two sides
  float Slab = 0.0f;
};

struct LineShadows::Crossings
{
  alignas(32) double Begin[Width];
  alignas(32) double End[Width];
};

LineShadows::LineShadows(const TriangleMeshView& mesh)
{
  const Box bounds = MeshBounds(mesh);
  if (bounds.Empty())
  {
    return;
  }
  this->Center = bounds.Center();
  this->Extent = 0.5 * bounds.Diagonal();
  std::vector<Piece> pieces;
  pieces.reserve(static_cast<std::size_t>(mesh.NumberOfTriangles));
  for (vtkIdType triangle = 0; triangle < mesh.NumberOfTriangles; ++triangle)
  {
    pieces.push_back({ mesh.BoundsOf(triangle), static_cast<unsigned int>(triangle) });
  }
  this->Root = this->Build(mesh, pieces.data(), pieces.data() + pieces.size());
  this->Nodes.shrink_to_fit();
  this->Groups.shrink_to_fit();
}

std::int64_t LineShadows::Memory() const
{
  return static_cast<std::int64_t>(this->Nodes.capacity() * sizeof(Node) + this->Groups.capacity() * sizeof(Group));
}

std::int64_t LineShadows::GroupsLookedAt()
{
  return groupsLookedAt;
}

int LineShadows::AddGroup(const TriangleMeshView& mesh, const Piece* first, const Piece* last)
{
  Group group;
  for (auto& lanes : group.Corners)
  {
    std::fill(lanes, lanes + Width, std::numeric_limits<double>::quiet_NaN());
  }
  std::fill(group.Triangles, group.Triangles + Width, 0u);
  for (int lane = 0; first + lane < last; ++lane)
  {
    group.Triangles[lane] = first[lane].Triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vector3 p = mesh.Corner(first[lane].Triangle, corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        group.Corners[3 * corner + axis][lane] = p[axis];
      }
    }
  }
  this->Groups.push_back(group);
  return ~static_cast<int>(this->Groups.size() - 1);
}

void LineShadows::SetBox(Node& node, int lane, const Box& box) const
{
  const Vector3 center = box.Center() - this->Center;
  const Vector3 half = 0.5 * box.Size();
  const double rounding = 0x1p-22 * this->Extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Center[axis][lane] = static_cast<float>(center[axis]);
    node.Half[axis][lane] = static_cast<float>((half[axis] + rounding) * (1.0 + 0x1p-22));
  }
}

/// Of the box of the middles of boxes, twice.
Vector3 LineShadows::SizeOfMiddles(const Piece* begin, const Piece* end)
{
  double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const Piece* piece = begin; piece != end; ++piece)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = piece->Bounds.Min[axis] + piece->Bounds.Max[axis];
      low[axis] = x < low[axis] ? x : low[axis];
      high[axis] = x > high[axis] ? x : high[axis];
    }
  }
  return { high[0] - low[0], high[1] - low[1], high[2] - low[2] };
}

/// Halves three times, by the middle of the longest axis of the middles of boxes: eight children.
int LineShadows::Build(const TriangleMeshView& mesh, Piece* first, Piece* last)
{
  if (last - first <= Width)
  {
    return this->AddGroup(mesh, first, last);
  }
  std::array<Piece*, Width + 1> ends{ { first, last } };
  int parts = 1;
  for (int level = 0; level < 3; ++level)
  {
    std::array<Piece*, Width + 1> finer{};
    for (int part = 0; part < parts; ++part)
    {
      Piece* const begin = ends[static_cast<std::size_t>(part)];
      Piece* const end = ends[static_cast<std::size_t>(part) + 1];
      Piece* const middle = begin + (end - begin) / 2;
      const Vector3 size = SizeOfMiddles(begin, end);
      const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
      std::nth_element(begin, middle, end,
        [axis](const Piece& a, const Piece& b)
        {
          const double x = a.Bounds.Min[axis] + a.Bounds.Max[axis];
          const double y = b.Bounds.Min[axis] + b.Bounds.Max[axis];
          return x != y ? x < y : a.Triangle < b.Triangle;
        });
      finer[static_cast<std::size_t>(2 * part)] = begin;
      finer[static_cast<std::size_t>(2 * part) + 1] = middle;
    }
    parts *= 2;
    finer[static_cast<std::size_t>(parts)] = last;
    ends = finer;
  }
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node{};
  for (int lane = 0; lane < Width; ++lane)
  {
    Piece* const begin = ends[static_cast<std::size_t>(lane)];
    Piece* const end = ends[static_cast<std::size_t>(lane) + 1];
    Box box;
    std::for_each(begin, end, [&box](const Piece& piece) { box.Add(piece.Bounds); });
    if (box.Empty())
    {
      for (auto& half : node.Half)
      {
        half[lane] = -std::numeric_limits<float>::infinity();
      }
      continue;
    }
    this->SetBox(node, lane, box);
    node.Child[lane] = this->Build(mesh, begin, end);
  }
  this->Nodes[index] = node;
  return static_cast<int>(index);
}

bool LineShadows::PlaneOf(const LineAndLight& query, Plane& plane) const
{
  // From the middle of the part: far cameras cost no digits.
  const double middle = 0.5 * (query.Begin + query.End);
  const double half = 0.5 * (query.End - query.Begin);
  const Vector3& d = query.Line.Direction;
  const Vector3 origin = query.Line.Origin + middle * d;
  const Vector3 e = query.AtInfinity ? query.Light : query.Light - origin;
  const double along = Dot(d, e);
  const double squared = Dot(e, e);
  const Vector3 across = e - along * d;
  const double determinant = Dot(across, across);
  if (!(determinant > 1e-16 * squared) || !(half > 0.0))
  {
    return false;
  }
  const double height = std::sqrt(determinant);
  const Vector3 up = (1.0 / height) * across; // unit, from the line towards the light
  const Vector3 normal = Cross(d, up);
  const Vector3 towards = (1.0 / height) * up;
  const Vector3 place = d - along * towards;
  const double rounding = RoundingAlong(query.Line.Origin, std::fabs(query.Begin) + std::fabs(query.End));
  plane.Perspective = query.AtInfinity ? 0.0 : 1.0;
  plane.Nearest = 4.0 * rounding / height;
  plane.Farthest = query.AtInfinity ? HUGE_VAL : 1.0 - plane.Nearest;
  plane.Begin = -half;
  plane.End = half;
  const Vector3* const vectors[4] = { &origin, &normal, &place, &towards };
  double* const lists[4] = { plane.Origin, plane.Normal, plane.Along, plane.Towards };
  for (int k = 0; k < 4; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lists[k][axis] = (*vectors[k])[axis];
    }
  }

  // Edges: the line, and what leads from its ends to the light.
  const auto inwards = [&](double t, double sign)
  {
    const Vector3 edge = query.AtInfinity ? e : e - t * d;
    const double a = Dot(edge, d);
    const double b = Dot(edge, up);
    return (sign / std::hypot(a, b)) * (b * d - a * up);
  };
  const Vector3 normals[4] = { normal, up, inwards(-half, 1.0), inwards(half, -1.0) };
  const double starts[4] = { 0.0, 0.0, -half, half };
  const Vector3 toOrigin = origin - this->Center;
  const double slack = 1e-6 * (this->Extent + Length(toOrigin) + half);
  for (int k = 0; k < 4; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      plane.Tests[k][axis] = static_cast<float>(normals[k][axis]);
    }
    const double offset = Dot(normals[k], toOrigin + starts[k] * d);
    plane.Tests[k][3] = static_cast<float>(k == 0 ? offset : offset - slack);
  }
  plane.Slab = static_cast<float>(slack);
  return true;
}

/// Bits of the boxes that the triangle, or strip, may touch.
SHADOWCONES_WIDE unsigned int LineShadows::Touched(const Node& node, const Plane& plane)
{
  int touched[Width];
  for (int k = 0; k < Width; ++k)
  {
    const float x = node.Center[0][k];
    const float y = node.Center[1][k];
    const float z = node.Center[2][k];
    const float hx = node.Half[0][k];
    const float hy = node.Half[1][k];
    const float hz = node.Half[2][k];
    const float(&t)[4][4] = plane.Tests;
    const float height = t[0][0] * x + t[0][1] * y + t[0][2] * z - t[0][3];
    const float reach = std::fabs(t[0][0]) * hx + std::fabs(t[0][1]) * hy + std::fabs(t[0][2]) * hz + plane.Slab;
    const float a = (t[1][0] * x + std::fabs(t[1][0]) * hx) + (t[1][1] * y + std::fabs(t[1][1]) * hy) +
      (t[1][2] * z + std::fabs(t[1][2]) * hz);
    const float b = (t[2][0] * x + std::fabs(t[2][0]) * hx) + (t[2][1] * y + std::fabs(t[2][1]) * hy) +
      (t[2][2] * z + std::fabs(t[2][2]) * hz);
    const float c = (t[3][0] * x + std::fabs(t[3][0]) * hx) + (t[3][1] * y + std::fabs(t[3][1]) * hy) +
      (t[3][2] * z + std::fabs(t[3][2]) * hz);
    touched[k] = ((std::fabs(height) <= reach) & (a >= t[1][3]) & (b >= t[2][3]) & (c >= t[3][3])) ? 1 << k : 0;
  }
  unsigned int bits = 0;
  for (int k = 0; k < Width; ++k)
  {
    bits |= static_cast<unsigned int>(touched[k]);
  }
  return bits;
}

/// Bits of the triangles that hide a part of the line, and which part.
SHADOWCONES_WIDE unsigned int LineShadows::CrossPlane(const Group& group, const Plane& plane, Crossings& crossings)
{
  alignas(32) double heights[3][Width];
  alignas(32) double places[3][Width];
  alignas(32) double ways[3][Width];
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* xs = group.Corners[3 * corner];
    const double* ys = group.Corners[3 * corner + 1];
    const double* zs = group.Corners[3 * corner + 2];
    for (int k = 0; k < Width; ++k)
    {
      const double x = xs[k] - plane.Origin[0];
      const double y = ys[k] - plane.Origin[1];
      const double z = zs[k] - plane.Origin[2];
      heights[corner][k] = plane.Normal[0] * x + plane.Normal[1] * y + plane.Normal[2] * z;
      places[corner][k] = plane.Along[0] * x + plane.Along[1] * y + plane.Along[2] * z;
      ways[corner][k] = plane.Towards[0] * x + plane.Towards[1] * y + plane.Towards[2] * z;
    }
  }
  const double nearest = plane.Nearest;
  const double farthest = plane.Farthest;
  const double perspective = plane.Perspective;
  double hides[Width];
  for (int k = 0; k < Width; ++k)
  {
    // The corner on one side alone, and the two on the other.
    const double h0 = heights[0][k];
    const double h1 = heights[1][k];
    const double h2 = heights[2][k];
    const double s0 = h0 >= 0.0 ? 1.0 : -1.0;
    const double s1 = h1 >= 0.0 ? 1.0 : -1.0;
    const double s2 = h2 >= 0.0 ? 1.0 : -1.0;
    const double sum = s0 + s1 + s2;
    const bool third = s0 == s1;
    const bool second = s0 == s2;
    const double h = third ? h2 : second ? h1 : h0;
    const double hu = third ? h0 : second ? h2 : h1;
    const double hw = third ? h1 : second ? h0 : h2;
    const double a = third ? places[2][k] : second ? places[1][k] : places[0][k];
    const double au = third ? places[0][k] : second ? places[2][k] : places[1][k];
    const double aw = third ? places[1][k] : second ? places[0][k] : places[2][k];
    const double b = third ? ways[2][k] : second ? ways[1][k] : ways[0][k];
    const double bu = third ? ways[0][k] : second ? ways[2][k] : ways[1][k];
    const double bw = third ? ways[1][k] : second ? ways[0][k] : ways[2][k];
    const double toU = h / (h - hu);
    const double toW = h / (h - hw);
    const double placeU = a + toU * (au - a);
    const double placeW = a + toW * (aw - a);
    const double wayU = b + toU * (bu - b);
    const double wayW = b + toW * (bw - b);
    // Cut to what lies between the line and the light.
    const double highest = wayU > wayW ? wayU : wayW;
    const double lowest = wayU > wayW ? wayW : wayU;
    double cutU = wayU > nearest ? wayU : nearest;
    cutU = cutU < farthest ? cutU : farthest;
    double cutW = wayW > nearest ? wayW : nearest;
    cutW = cutW < farthest ? cutW : farthest;
    const double slope = wayU == wayW ? 0.0 : (placeW - placeU) / (wayW - wayU);
    const double fromU = (placeU + (cutU - wayU) * slope) / (1.0 - perspective * cutU);
    const double fromW = (placeW + (cutW - wayW) * slope) / (1.0 - perspective * cutW);
    const double begin = fromU < fromW ? fromU : fromW;
    const double end = fromU < fromW ? fromW : fromU;
    crossings.Begin[k] = begin;
    crossings.End[k] = end;
    const bool crosses = (sum == 1.0) | (sum == -1.0);
    hides[k] =
      (crosses & (highest > nearest) & (lowest < farthest) & (end > plane.Begin) & (begin < plane.End) & (h - h == 0.0))
      ? 1.0
      : 0.0;
  }
  unsigned int bits = 0;
  for (int k = 0; k < Width; ++k)
  {
    bits |= hides[k] > 0.0 ? 1u << k : 0u;
  }
  return bits;
}

/// Pieces of one surface come one after the other: most of them touch what came last.
void LineShadows::Join(std::vector<RayInterval>& intervals, double begin, double end, double gap)
{
  if (!intervals.empty())
  {
    RayInterval& last = intervals.back();
    if (begin <= last.End + gap && end >= last.Begin - gap)
    {
      last.Begin = std::min(last.Begin, begin);
      last.End = std::max(last.End, end);
      return;
    }
  }
  intervals.push_back({ begin, end });
}

/// Sort, cut to the line and join what touches.
void LineShadows::SetApart(std::vector<RayInterval>& intervals, const RayInterval& line, double gap)
{
  std::sort(
    intervals.begin(), intervals.end(), [](const RayInterval& a, const RayInterval& b) { return a.Begin < b.Begin; });
  std::size_t apart = 0;
  for (const RayInterval interval : intervals)
  {
    const RayInterval part{ std::max(interval.Begin, line.Begin), std::min(interval.End, line.End) };
    if (apart > 0 && part.Begin <= intervals[apart - 1].End + gap)
    {
      intervals[apart - 1].End = std::max(intervals[apart - 1].End, part.End);
      continue;
    }
    intervals[apart++] = part;
  }
  intervals.resize(apart);
}

bool LineShadows::Find(const LineAndLight& query, const unsigned char* ignored, std::vector<RayInterval>& hidden) const
{
  hidden.clear();
  if (this->Groups.empty())
  {
    return true;
  }
  Plane plane;
  if (!this->PlaneOf(query, plane))
  {
    return false;
  }
  const double gap = joinedWithin * RoundingAlong(query.Line.Origin, std::fabs(query.Begin) + std::fabs(query.End));
  constexpr std::size_t mostOpen = 7 * 24 + 8; // seven wait on every level of eights
  int open[mostOpen];
  std::size_t count = 0;
  open[count++] = this->Root;
  std::int64_t looks = 0;
  Crossings crossings;
  bool all = false;
  while (count > 0 && !all)
  {
    const int child = open[--count];
    if (child >= 0)
    {
      const Node& node = this->Nodes[static_cast<std::size_t>(child)];
      for (unsigned int bits = Touched(node, plane); bits != 0; bits &= bits - 1)
      {
        open[count++] = node.Child[__builtin_ctz(bits)];
      }
      continue;
    }
    const Group& group = this->Groups[static_cast<std::size_t>(~child)];
    looks += 1;
    for (unsigned int bits = CrossPlane(group, plane, crossings); bits != 0 && !all; bits &= bits - 1)
    {
      const int lane = __builtin_ctz(bits);
      if (!ignored || !ignored[group.Triangles[lane]])
      {
        Join(hidden, crossings.Begin[lane], crossings.End[lane], gap);
        all = hidden.back().Begin <= plane.Begin && hidden.back().End >= plane.End;
      }
    }
  }
  groupsLookedAt += looks;
  if (all)
  {
    hidden.assign(1, { query.Begin, query.End });
    return true;
  }
  SetApart(hidden, { plane.Begin, plane.End }, gap);
  const double middle = 0.5 * (query.Begin + query.End);
  for (RayInterval& interval : hidden)
  {
    interval = { middle + interval.Begin, middle + interval.End };
  }
  if (!hidden.empty())
  {
    // What begins or ends with the line does so to the last bit.
    hidden.front().Begin = hidden.front().Begin <= query.Begin + gap ? query.Begin : hidden.front().Begin;
    hidden.back().End = hidden.back().End >= query.End - gap ? query.End : hidden.back().End;
  }
  return true;
}

} // namespace shadowcones
