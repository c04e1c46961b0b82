// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderScene.h"

#include "scEmbreeQuery.h"
#include "scOccluderImplementation.h"
#include "scSinglePrecision.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace shadowcones
{
namespace
{
/// Pieces of one size have longest edges within a factor of 2^(1 / sizesOfOctave); the last are all that are no longer.
constexpr int numberOfSizes = 48;
constexpr double sizesOfOctave = 3.0;

struct PieceSize
{
  double LongestEdge = 0.0;
  double TwiceArea = 0.0;
};

PieceSize SizeOf(const CellPiece& piece)
{
  const auto corner = [&piece](std::size_t i)
  { return Vector3{ piece.Corners[i][0], piece.Corners[i][1], piece.Corners[i][2] }; };
  const Vector3 ab = corner(1) - corner(0);
  const Vector3 ac = corner(2) - corner(0);
  return { std::sqrt(std::max({ Dot(ab, ab), Dot(ac, ac), Dot(ac - ab, ac - ab) })), Length(Cross(ab, ac)) };
}

/// 0: of pieces that hold more than their triangle, whose hits are never clear.
unsigned int GroupOf(const CellPiece& piece)
{
  constexpr double largest = 2.0; // a cell's diagonal
  const double step = sizesOfOctave * std::log2(largest / SizeOf(piece).LongestEdge);
  return piece.Exact ? 1u + static_cast<unsigned int>(std::clamp(step, 0.0, numberOfSizes - 1.0)) : 0u;
}

bool WatchMemory(void* user, ssize_t bytes, bool post)
{
  auto* budget = static_cast<MemoryBudget*>(user);
  const std::int64_t used = budget->Used += bytes;
  return post || bytes <= 0 || budget->Limit == 0 || used <= budget->Limit;
}

bool AllInSinglePrecision(const TriangleMeshView& mesh)
{
  return std::all_of(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints, IsSinglePrecision);
}
} // anonymous namespace

OccluderScene::Implementation::Implementation(const TriangleMeshView& mesh)
  : Mesh(mesh)
  , Bounds(MeshBounds(mesh))
  , IsSinglePrecision(AllInSinglePrecision(mesh))
  , Cells(mesh)
{
}

OccluderScene::Implementation::~Implementation()
{
  for (EmbreeCell& cell : this->Scenes)
  {
    rtcReleaseScene(cell.Scene);
  }
  if (this->Device)
  {
    rtcReleaseDevice(this->Device);
  }
}

void OccluderScene::Implementation::ThrowOnError() const
{
  const RTCError error = rtcGetDeviceError(this->Device);
  if (error != RTC_ERROR_NONE)
  {
    throw std::runtime_error(error == RTC_ERROR_OUT_OF_MEMORY
        ? "there is not enough memory for the search structure of " + std::to_string(this->Mesh.NumberOfTriangles) +
          " triangles"
        : "Embree failed to build its search structure (error " + std::to_string(error) + ")");
  }
}

void OccluderScene::Implementation::Build(OccluderCell& cell)
{
  this->Scenes.emplace_back();
  EmbreeCell& built = this->Scenes.back();
  built.Scene = rtcNewScene(this->Device);
  rtcSetSceneFlags(built.Scene, RTC_SCENE_FLAG_ROBUST);
  built.Groups.resize(1 + numberOfSizes); // Embree keeps their addresses
  this->AddGeometries(built, std::exchange(cell.Pieces, {})); // their copies are gone when the tree is built: that is the peak
  rtcCommitScene(built.Scene);
  this->ThrowOnError();
}

void OccluderScene::Implementation::AddGeometries(EmbreeCell& cell, const std::vector<CellPiece>& pieces)
{
  std::vector<std::vector<unsigned int>> members(cell.Groups.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    members[GroupOf(pieces[i])].push_back(static_cast<unsigned int>(i));
  }
  for (std::size_t group = 0; group < members.size(); ++group)
  {
    if (!members[group].empty())
    {
      this->AddGeometry(cell, static_cast<unsigned int>(group), pieces, members[group]);
    }
  }
}

void OccluderScene::Implementation::AddGeometry(EmbreeCell& cell, unsigned int id, const std::vector<CellPiece>& pieces,
  const std::vector<unsigned int>& members)
{
  const std::size_t count = members.size();
  PieceGroup& group = cell.Groups[id];
  group.Triangles.reserve(count);
  PieceSize largest;
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(
    rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* corners = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(
    geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), count));
  if (points && corners)
  {
    for (const unsigned int member : members)
    {
      const CellPiece& piece = pieces[member];
      for (const auto& corner : piece.Corners)
      {
        points = std::copy(corner.begin(), corner.end(), points);
      }
      group.Triangles.push_back(static_cast<unsigned int>(piece.Triangle));
      const PieceSize size = SizeOf(piece);
      largest.LongestEdge = std::max(largest.LongestEdge, size.LongestEdge);
      largest.TwiceArea = std::max(largest.TwiceArea, size.TwiceArea);
    }
    std::iota(corners, corners + 3 * count, 0u);
    constexpr double twice = 2.0 * OccluderCells::Margin;
    group.ClearInside = id > 0 ? static_cast<float>(1.0 / (twice * largest.LongestEdge)) : 0.0f;
    group.ClearHeight = static_cast<float>(1.0 / (twice * largest.TwiceArea));
    rtcSetGeometryUserData(geometry, &group);
    rtcSetGeometryIntersectFilterFunction(geometry, FilterHits);
    rtcSetGeometryOccludedFilterFunction(geometry, FilterHits);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(cell.Scene, geometry, id);
  }
  rtcReleaseGeometry(geometry);
}

/// Ask the cells on the way of the query's one ray: for the nearest hit, if @p best is given. @return is there any?
bool OccluderScene::Implementation::Trace(EmbreeQuery& query, RayHit* best) const
{
  const Vector3& origin = *query.Origins;
  const Vector3& direction = *query.Directions;
  if (!IsFiniteRay(origin, direction))
  {
    return false;
  }
  if (this->Scenes.size() == 1)
  {
    // From inside nothing is to be cut off: Embree passes by what is beyond the bounds anyway.
    const Box& bounds = this->Cells.Cells[0].Bounds;
    double first = query.Begin;
    double last = query.End;
    return (bounds.Contains(origin) ? first < last : bounds.Clip(origin, direction, first, last)) &&
      this->TraceCell(0, query, first, last, best);
  }
  double end = query.End;
  return this->Cells.Visit(origin, direction, query.Begin, end,
    [&](std::size_t cell, double first, double last)
    {
      const bool met = this->TraceCell(cell, query, first, last, best);
      end = best && best->Triangle >= 0 ? std::min(end, best->T) : end;
      return met;
    });
}

bool OccluderScene::Implementation::TraceCell(
  std::size_t index, EmbreeQuery& query, double first, double last, RayHit* best) const
{
  const OccluderCell& cell = this->Cells.Cells[index];
  const EmbreeCell& built = this->Scenes[index];
  const Vector3& origin = *query.Origins;
  const Vector3& direction = *query.Directions;
  RTCRayHit rayHit;
  SetRay(rayHit.ray, cell, origin, direction, std::max(query.Begin, first - cell.Reach),
    std::min(query.End, last + cell.Reach));
  query.SetScale(cell.Scale);
  if (!best && !query.Found)
  {
    TraceAny(built.Scene, query, rayHit.ray);
    return rayHit.ray.tfar < 0.0f;
  }
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  TraceNearest(built.Scene, query, rayHit);
  if (best && rayHit.hit.geomID != RTC_INVALID_GEOMETRY_ID)
  {
    const RayHit hit = HitOf(this->Mesh, built.TriangleOf(rayHit.hit.geomID, rayHit.hit.primID), origin, direction);
    *best = best->Triangle < 0 || hit.T < best->T ? hit : *best;
  }
  return false;
}

OccluderScene::OccluderScene(const TriangleMeshView& mesh, const OccluderSceneOptions& options)
{
  if (mesh.NumberOfTriangles >= std::numeric_limits<unsigned int>::max() / 8)
  {
    throw std::runtime_error("the mesh has more triangles than Embree can address");
  }
  this->Impl = std::make_unique<Implementation>(mesh);
  Implementation& impl = *this->Impl;
  if (mesh.NumberOfTriangles == 0)
  {
    return;
  }
  // No "threads=1" here: it would throttle every user of TBB in the process.
  impl.Device = rtcNewDevice(nullptr);
  if (!impl.Device)
  {
    throw std::runtime_error("Embree could not be started (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
  }
  impl.Memory.Limit = std::max<std::int64_t>(options.MemoryLimit, 0);
  rtcSetDeviceMemoryMonitorFunction(impl.Device, WatchMemory, &impl.Memory);
  impl.Scenes.reserve(impl.Cells.Cells.size());
  for (OccluderCell& cell : impl.Cells.Cells)
  {
    impl.Build(cell);
  }
}

OccluderScene::~OccluderScene() = default;

const TriangleMeshView& OccluderScene::Mesh() const
{
  return this->Impl->Mesh;
}

const Box& OccluderScene::Bounds() const
{
  return this->Impl->Bounds;
}

vtkIdType OccluderScene::NumberOfCells() const
{
  return static_cast<vtkIdType>(this->Impl->Cells.Cells.size());
}

std::int64_t OccluderScene::Memory() const
{
  Implementation& impl = *this->Impl;
  std::int64_t bytes = impl.Memory.Used;
  for (const EmbreeCell& cell : impl.Scenes)
  {
    for (const PieceGroup& group : cell.Groups)
    {
      bytes += static_cast<std::int64_t>(group.Triangles.capacity() * sizeof(group.Triangles[0]));
    }
  }
  bytes += impl.LinesMemory;
  const std::lock_guard<std::mutex> lock(impl.Lock);
  for (const auto& lamp : impl.Lamps)
  {
    bytes += static_cast<std::int64_t>(lamp->Triangles.capacity());
  }
  return bytes;
}

const LineShadows& OccluderScene::Lines() const
{
  Implementation& impl = *this->Impl;
  std::call_once(impl.LinesOnce,
    [&impl]
    {
      impl.Lines = std::make_unique<const LineShadows>(impl.Mesh);
      impl.LinesMemory = impl.Lines->Memory();
    });
  return *impl.Lines;
}

RayRules OccluderScene::RulesFor(const FlatFace& lamp) const
{
  RayRules rules;
  if (!lamp.IsFlat)
  {
    return rules;
  }
  Implementation& impl = *this->Impl;
  const std::lock_guard<std::mutex> lock(impl.Lock);
  const auto same = [&lamp](const std::unique_ptr<Implementation::PassedBy>& other)
  {
    const Vector3 away = other->Lamp.Center - lamp.Center;
    const Vector3 turn = other->Lamp.Normal - lamp.Normal;
    return Dot(away, away) == 0.0 && Dot(turn, turn) == 0.0 && other->Lamp.Radius == lamp.Radius;
  };
  auto found = std::find_if(impl.Lamps.begin(), impl.Lamps.end(), same);
  if (found == impl.Lamps.end())
  {
    auto passed = std::make_unique<Implementation::PassedBy>();
    passed->Lamp = lamp;
    std::vector<unsigned char> flush(static_cast<std::size_t>(impl.Mesh.NumberOfTriangles), 0);
    bool touches = false; // what lies behind the plane and does not reach it is met by no ray anyway
    for (vtkIdType t = 0; t < impl.Mesh.NumberOfTriangles; ++t)
    {
      const Vector3 corners[3] = { impl.Mesh.Corner(t, 0), impl.Mesh.Corner(t, 1), impl.Mesh.Corner(t, 2) };
      if (IsFlush(lamp, corners[0], corners[1], corners[2]))
      {
        flush[static_cast<std::size_t>(t)] = 1;
        touches = touches || std::any_of(corners, corners + 3,
          [&lamp](const Vector3& p) { return Dot(p - lamp.Center, lamp.Normal) >= -FlushTolerance(lamp, p); });
      }
    }
    passed->Triangles = touches ? std::move(flush) : std::vector<unsigned char>();
    impl.Lamps.push_back(std::move(passed));
    found = impl.Lamps.end() - 1;
  }
  rules.Ignored = (*found)->Triangles.empty() ? nullptr : (*found)->Triangles.data();
  return rules;
}

double OccluderScene::SurfaceTolerance(const Vector3& point) const
{
  const double rounding = 0x1p-22 * LargestComponent(point);
  return this->Impl->IsSinglePrecision ? rounding : SinglePrecisionRounding(point);
}

bool OccluderScene::Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax, RayHit& hit,
  const RayRules& rules) const
{
  EmbreeQuery query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
  RayHit best;
  this->Impl->Trace(query, &best);
  if (best.Triangle < 0)
  {
    return false;
  }
  hit = best;
  return true;
}

void OccluderScene::IntersectAll(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
  std::vector<RayHit>& hits, const RayRules& rules) const
{
  hits.clear();
  thread_local std::vector<MetTriangle> found;
  found.clear();
  EmbreeQuery query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
  query.Found = &found;
  query.TakesClear = false;
  const TriangleMeshView& mesh = this->Impl->Mesh;
  this->Impl->Trace(query, nullptr);
  for (const MetTriangle& met : found)
  {
    FetchIds(mesh, met.Triangle);
  }
  for (const MetTriangle& met : found)
  {
    FetchCorners(mesh, met.Triangle);
  }
  for (const MetTriangle& met : found)
  {
    hits.push_back(HitOf(mesh, met.Triangle, origin, direction));
  }
  std::sort(hits.begin(), hits.end(),
    [](const RayHit& a, const RayHit& b) { return a.T != b.T ? a.T < b.T : a.Triangle < b.Triangle; });
  // Pieces of one triangle have found it at the very same distance.
  const auto same = [](const RayHit& a, const RayHit& b) { return a.Triangle == b.Triangle; };
  hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
}

bool OccluderScene::Occluded(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, const RayRules& rules) const
{
  EmbreeQuery query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
  return this->Impl->Trace(query, nullptr);
}

Vector3 OccluderScene::TriangleNormal(vtkIdType triangle) const
{
  const TriangleMeshView& mesh = this->Impl->Mesh;
  const Vector3 a = mesh.Corner(triangle, 0);
  return Normalized(Cross(mesh.Corner(triangle, 1) - a, mesh.Corner(triangle, 2) - a));
}

} // namespace shadowcones
