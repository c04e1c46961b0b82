// SPDX-License-Identifier: BSD-3-Clause
#include "scOccluderScene.h"

#include "scOccluderCells.h"
#include "scTriangleCrossing.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>

namespace shadowcones
{
namespace
{
/// Rays in one query: eight fill the vectors of most machines.
constexpr int packetSize = OccluderScene::PacketSize;
/// In a cell's frame, where it has a diagonal of 2: farther origins have too few digits in single precision.
constexpr double farthestOrigin = 2.0;
/// Pieces of shape k have no edge longer than shapes[k] times the root of twice their area; 0: of any shape.
constexpr int numberOfShapes = 3;
constexpr double shapes[numberOfShapes] = { 4.0, 16.0, 0.0 };
constexpr double rayMargin = OccluderCells::RayMargin;

/// What a query wants of the triangles that it crosses.
enum class Wanted
{
  Any,
  Nearest,
  All
};

/// What the filter has to know of a query; Embree hands it over by its own context, which comes first.
struct Query
{
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext Context;
#else
  RTCIntersectContext Context;
#endif
  const TriangleMeshView* Mesh = nullptr;
  Wanted What = Wanted::Any;
  RayRules Rules;
  const RayStretch* Rays = nullptr; ///< one a ray, by the ray's id; nullptr: see Origin
  const Vector3* Origin = nullptr;  ///< of rays along (X, Y, Z) of their id
  const double* X = nullptr;
  const double* Y = nullptr;
  const double* Z = nullptr;
  bool Infinity = false;
  const float* Ends = nullptr; ///< by the ray's id, in the cell's frame
  float BeginFactor = 1.0f;    ///< how much larger the plane's slack is by the tolerances of the rules
  float EndFactor = 1.0f;
  bool TakesClear = true;  ///< hits beyond doubt need no look at their triangle
  std::vector<vtkIdType>* Found = nullptr; ///< All: triangles, some of them more than once

  void SetRules(const RayRules& rules, double scale)
  {
    this->Rules = rules;
    this->TakesClear = !rules.Ignored && !this->Found;
    if (rules.StartTolerance > 0.0 || rules.EndTolerance > 0.0)
    {
      this->BeginFactor = static_cast<float>(1.0 + rules.StartTolerance * scale / OccluderCells::Margin);
      this->EndFactor = static_cast<float>(1.0 + rules.EndTolerance * scale / OccluderCells::Margin);
    }
  }
  RayStretch RayOf(unsigned int id) const
  {
    if (this->Rays)
    {
      return this->Rays[id];
    }
    const Vector3 to{ this->X[id], this->Y[id], this->Z[id] };
    const double distance = std::sqrt(Dot(to, to));
    return { *this->Origin, (1.0 / distance) * to, 0.0, this->Infinity ? HUGE_VAL : distance,
      this->Rules.StartTolerance, this->Rules.EndTolerance };
  }
};

// Embree 3 and 4 differ in how a query is described and in nothing else that is used here.
#if RTC_VERSION_MAJOR >= 4
void Nearest(RTCScene scene, Query& query, RTCRayHit& rayHit)
{
  rtcInitRayQueryContext(&query.Context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.Context;
  rtcIntersect1(scene, &rayHit, &arguments);
}
void NearestOfPacket(const int* valid, RTCScene scene, Query& query, RTCRayHit8& rayHits)
{
  rtcInitRayQueryContext(&query.Context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &query.Context;
  rtcIntersect8(valid, scene, &rayHits, &arguments);
}
void Any(RTCScene scene, Query& query, RTCRay& ray)
{
  rtcInitRayQueryContext(&query.Context);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.Context;
  rtcOccluded1(scene, &ray, &arguments);
}
void AnyOfPacket(const int* valid, RTCScene scene, Query& query, RTCRay8& rays)
{
  rtcInitRayQueryContext(&query.Context);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.Context;
  rtcOccluded8(valid, scene, &rays, &arguments);
}
#else
void Nearest(RTCScene scene, Query& query, RTCRayHit& rayHit)
{
  rtcInitIntersectContext(&query.Context);
  rtcIntersect1(scene, &query.Context, &rayHit);
}
void NearestOfPacket(const int* valid, RTCScene scene, Query& query, RTCRayHit8& rayHits)
{
  rtcInitIntersectContext(&query.Context);
  query.Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &query.Context, &rayHits);
}
void Any(RTCScene scene, Query& query, RTCRay& ray)
{
  rtcInitIntersectContext(&query.Context);
  rtcOccluded1(scene, &query.Context, &ray);
}
void AnyOfPacket(const int* valid, RTCScene scene, Query& query, RTCRay8& rays)
{
  rtcInitIntersectContext(&query.Context);
  rtcOccluded8(valid, scene, &query.Context, &rays);
}
#endif

RayHit HitOf(const TriangleMeshView& mesh, vtkIdType triangle, const RayStretch& ray)
{
  RayHit hit;
  hit.Triangle = triangle;
  hit.T = DistanceToPlane(
    ray, mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2), hit.FrontFacing);
  return hit;
}

/**
 * Is hit @p i of N on a piece of some shape, found in single precision, one beyond doubt? It must lie inside by twice the margin,
 * one for the piece's own and one for what single precision gets wrong, and as far from both ends, all over the cosine.
 */
template <int Shape, unsigned int N> // N = 0: as many as the call says
bool IsClear(const RTCFilterFunctionNArguments* arguments, unsigned int i, const Query& query, float end)
{
  const unsigned int n = N ? N : arguments->N;
  constexpr auto margin = static_cast<float>(rayMargin);
  constexpr auto plane = static_cast<float>(2.0 * OccluderCells::Margin);
  constexpr auto edge = static_cast<float>(4.0 * OccluderCells::Margin * shapes[Shape]);
  RTCHitN* hit = arguments->hit;
  RTCRayN* ray = arguments->ray;
  const float x = RTCHitN_Ng_x(hit, n, i);
  const float y = RTCHitN_Ng_y(hit, n, i);
  const float z = RTCHitN_Ng_z(hit, n, i);
  const float u = RTCHitN_u(hit, n, i);
  const float v = RTCHitN_v(hit, n, i);
  const float t = RTCRayN_tfar(ray, n, i);
  const float rest = 1.0f - u - v;
  const float lesser = u < v ? u : v;
  const float least = lesser < rest ? lesser : rest;
  const float slope =
    std::fabs(x * RTCRayN_dir_x(ray, n, i) + y * RTCRayN_dir_y(ray, n, i) + z * RTCRayN_dir_z(ray, n, i));
  // Squares, for the normal is twice the area long.
  const float square = x * x + y * y + z * z;
  const float inside = least > 0.0f ? least * slope : 0.0f;
  const float fromBegin = t > margin ? (t - margin) * slope : 0.0f;
  const float toEnd = end - margin > t ? (end - margin - t) * slope : 0.0f;
  const float begin = query.BeginFactor * plane;
  const float last = query.EndFactor * plane;
  const float insideSquare = inside * inside;
  return (insideSquare * insideSquare > edge * edge * edge * edge * square) &
    (fromBegin * fromBegin > begin * begin * square) & (toEnd * toEnd > last * last * square);
}

/// A hit is found: keep it where its triangle is crossed in double precision.
template <int Shape, unsigned int N>
void FilterOne(const RTCFilterFunctionNArguments* arguments, unsigned int i, const Query& query)
{
  const unsigned int n = N ? N : arguments->N;
  const unsigned int id = RTCRayN_id(arguments->ray, n, i);
  const bool clear = shapes[Shape] > 0.0 && IsClear<Shape, N>(arguments, i, query, query.Ends[id]);
  if (clear && query.TakesClear)
  {
    return;
  }
  const auto* triangles = static_cast<const unsigned int*>(arguments->geometryUserPtr);
  const vtkIdType triangle = triangles[RTCHitN_primID(arguments->hit, n, i)];
  const TriangleMeshView& mesh = *query.Mesh;
  const bool met = !(query.Rules.Ignored && query.Rules.Ignored[triangle]) &&
    (clear || Crosses(query.RayOf(id), mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2)));
  if (met && query.Found)
  {
    query.Found->push_back(triangle);
  }
  if (!met || query.Found) // so that the traversal goes on
  {
    arguments->valid[i] = 0;
  }
}

/// Embree found pieces in single precision: for one ray, or for some of a packet.
template <int Shape>
void Filter(const RTCFilterFunctionNArguments* arguments)
{
  const auto& query = *reinterpret_cast<const Query*>(arguments->context);
  if (arguments->N == 1)
  {
    FilterOne<Shape, 1>(arguments, 0, query);
    return;
  }
  if (arguments->N != packetSize)
  {
    for (unsigned int i = 0; i < arguments->N; ++i)
    {
      if (arguments->valid[i])
      {
        FilterOne<Shape, 0>(arguments, i, query);
      }
    }
    return;
  }
  // Mostly one of a packet's rays is asked about: no branch for each of the others.
  unsigned int asked = 0;
  for (unsigned int i = 0; i < packetSize; ++i)
  {
    asked |= (static_cast<unsigned int>(arguments->valid[i]) & 1u) << i;
  }
  for (; asked != 0; asked &= asked - 1)
  {
    FilterOne<Shape, packetSize>(arguments, static_cast<unsigned int>(__builtin_ctz(asked)), query);
  }
}

constexpr RTCFilterFunctionN filters[numberOfShapes] = { Filter<0>, Filter<1>, Filter<2> };

/// A cell as Embree has it, its pieces in one geometry for each shape.
struct EmbreeCell
{
  RTCScene Scene = nullptr;
  std::vector<unsigned int> Triangles[numberOfShapes]; ///< of each piece of a geometry
};

/// The first shape that a piece has; the last one where it holds more than its triangle.
int ShapeOf(const CellPiece& piece)
{
  const auto corner = [&piece](std::size_t i)
  { return Vector3{ piece.Corners[i][0], piece.Corners[i][1], piece.Corners[i][2] }; };
  const Vector3 ab = corner(1) - corner(0);
  const Vector3 ac = corner(2) - corner(0);
  const double longest = std::max({ Length(ab), Length(ac), Length(ac - ab) });
  const double area = Length(Cross(ab, ac));
  int shape = 0;
  while (shape + 1 < numberOfShapes && !(piece.Exact && longest * longest < shapes[shape] * shapes[shape] * area))
  {
    ++shape;
  }
  return shape;
}

/// Embree's own memory; a limit makes it fail as if there were no more.
struct MemoryBudget
{
  std::atomic<std::int64_t> Used{ 0 };
  std::int64_t Limit = 0;
};

bool WatchMemory(void* user, ssize_t bytes, bool post)
{
  auto* budget = static_cast<MemoryBudget*>(user);
  const std::int64_t used = budget->Used += bytes;
  return post || bytes <= 0 || used <= budget->Limit;
}

/// A ray of a cell in single precision, a little longer than it is.
void SetRay(RTCRay& ray, const OccluderCell& cell, const RayStretch& stretch, double begin, double end)
{
  const double first = begin - cell.RayMargin;
  const Vector3 start = cell.Scale * (stretch.Origin + first * stretch.Direction - cell.Center);
  ray.org_x = static_cast<float>(start.X);
  ray.org_y = static_cast<float>(start.Y);
  ray.org_z = static_cast<float>(start.Z);
  ray.dir_x = static_cast<float>(stretch.Direction.X);
  ray.dir_y = static_cast<float>(stretch.Direction.Y);
  ray.dir_z = static_cast<float>(stretch.Direction.Z);
  ray.tnear = 0.0f;
  ray.tfar = static_cast<float>(cell.Scale * (end - first) + rayMargin);
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

/// One ray of a packet.
void SetLane(RTCRay8& rays, int k, const RTCRay& ray, unsigned int id)
{
  rays.org_x[k] = ray.org_x;
  rays.org_y[k] = ray.org_y;
  rays.org_z[k] = ray.org_z;
  rays.dir_x[k] = ray.dir_x;
  rays.dir_y[k] = ray.dir_y;
  rays.dir_z[k] = ray.dir_z;
  rays.tnear[k] = ray.tnear;
  rays.tfar[k] = ray.tfar;
  rays.time[k] = 0.0f;
  rays.mask[k] = ~0u;
  rays.id[k] = id;
  rays.flags[k] = 0;
}

/// Eight rays from one point in a cell or near it, @p start in its frame.
void SetNearRays(const Query& query, const OccluderCell& cell, const Vector3& start, int first, std::uint64_t wanted,
  RTCRay8& rays, int* valid)
{
  for (int k = 0; k < packetSize; ++k)
  {
    const double dx = query.X[first + k];
    const double dy = query.Y[first + k];
    const double dz = query.Z[first + k];
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const bool asked = ((wanted >> (first + k)) & 1u) && distance > 0.0 && std::isfinite(distance);
    const double scale = asked ? 1.0 / distance : 0.0;
    valid[k] = asked ? -1 : 0;
    rays.dir_x[k] = static_cast<float>(dx * scale);
    rays.dir_y[k] = static_cast<float>(dy * scale);
    rays.dir_z[k] = static_cast<float>(dz * scale);
    rays.tfar[k] = static_cast<float>(query.Infinity ? HUGE_VAL : cell.Scale * distance + 2.0 * rayMargin);
  }
  const auto margin = static_cast<float>(rayMargin);
  const auto startX = static_cast<float>(start.X);
  const auto startY = static_cast<float>(start.Y);
  const auto startZ = static_cast<float>(start.Z);
  for (int k = 0; k < packetSize; ++k)
  {
    // A little longer than asked for, on both ends: the filter decides.
    rays.org_x[k] = startX - margin * rays.dir_x[k];
    rays.org_y[k] = startY - margin * rays.dir_y[k];
    rays.org_z[k] = startZ - margin * rays.dir_z[k];
    rays.tnear[k] = 0.0f;
    rays.time[k] = 0.0f;
    rays.mask[k] = ~0u;
    rays.id[k] = static_cast<unsigned int>(first + k);
    rays.flags[k] = 0;
  }
}

/// Eight rays from one point far from a cell: each starts where it enters.
void SetFarRays(
  const Query& query, const OccluderCell& cell, int first, std::uint64_t wanted, RTCRay8& rays, int* valid)
{
  for (int k = 0; k < packetSize; ++k)
  {
    const auto id = static_cast<unsigned int>(first + k);
    const Vector3 to{ query.X[id], query.Y[id], query.Z[id] };
    RTCRay ray{};
    valid[k] = 0;
    if (((wanted >> id) & 1u) && IsFinite(to) && Dot(to, to) > 0.0)
    {
      const RayStretch stretch = query.RayOf(id);
      double begin = 0.0;
      double end = stretch.End;
      if (cell.Bounds.Clip(stretch.Origin, stretch.Direction, begin, end))
      {
        SetRay(ray, cell, stretch, begin, end);
        valid[k] = -1;
      }
    }
    SetLane(rays, k, ray, id);
  }
}

bool AllInSinglePrecision(const TriangleMeshView& mesh)
{
  return std::all_of(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints,
    [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
}

RayStretch StretchOf(
  const Vector3& origin, const Vector3& direction, double tMin, double tMax, const RayRules& rules)
{
  return { origin, direction, tMin, tMax, rules.StartTolerance, rules.EndTolerance };
}
} // anonymous namespace

struct OccluderScene::Implementation
{
  using PieceIterator = std::vector<CellPiece>::const_iterator;

  explicit Implementation(const TriangleMeshView& mesh)
    : Mesh(mesh)
    , Bounds(MeshBounds(mesh))
    , IsSinglePrecision(AllInSinglePrecision(mesh))
    , Cells(mesh)
  {
  }
  ~Implementation()
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

  void ThrowOnError() const
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

  void Build(OccluderCell& cell)
  {
    this->Scenes.emplace_back();
    EmbreeCell& built = this->Scenes.back();
    built.Scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(built.Scene, RTC_SCENE_FLAG_ROBUST);
    auto begin = cell.Pieces.begin();
    for (int shape = 0; shape < numberOfShapes; ++shape)
    {
      const auto end = std::stable_partition(
        begin, cell.Pieces.end(), [shape](const CellPiece& piece) { return ShapeOf(piece) <= shape; });
      this->AddGeometry(built, static_cast<unsigned int>(shape), begin, end);
      begin = end;
    }
    rtcCommitScene(built.Scene);
    this->ThrowOnError();
    cell.Pieces = {};
  }

  void AddGeometry(EmbreeCell& cell, unsigned int id, PieceIterator begin, PieceIterator end)
  {
    const auto count = static_cast<std::size_t>(end - begin);
    if (count == 0)
    {
      return;
    }
    std::vector<unsigned int>& triangles = cell.Triangles[id];
    triangles.reserve(count);
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
    auto* corners = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), count));
    if (points && corners)
    {
      for (auto piece = begin; piece != end; ++piece)
      {
        for (const auto& corner : piece->Corners)
        {
          points = std::copy(corner.begin(), corner.end(), points);
        }
        triangles.push_back(static_cast<unsigned int>(piece->Triangle));
      }
      std::iota(corners, corners + 3 * count, 0u);
      rtcSetGeometryUserData(geometry, triangles.data());
      rtcSetGeometryIntersectFilterFunction(geometry, filters[id]);
      rtcSetGeometryOccludedFilterFunction(geometry, filters[id]);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(cell.Scene, geometry, id);
    }
    rtcReleaseGeometry(geometry);
  }

  /// Ask the cells on the way of one ray; @p best receives the nearest hit. @return true where any is wanted and met.
  bool Trace(Query& query, const RayStretch& ray, const RayRules& rules, RayHit* best) const
  {
    if (!IsFinite(ray.Origin) || !IsFinite(ray.Direction))
    {
      return false; // Embree stops the program at a ray that is not a number
    }
    query.Mesh = &this->Mesh;
    query.Rays = &ray;
    if (this->Scenes.size() == 1)
    {
      double first = ray.Begin;
      double last = ray.End;
      return this->Cells.Cells[0].Bounds.Clip(ray.Origin, ray.Direction, first, last) &&
        this->TraceCell(0, query, ray, rules, first, last, best);
    }
    double end = ray.End;
    return this->Cells.Visit(ray.Origin, ray.Direction, ray.Begin, end,
      [&](std::size_t cell, double first, double last)
      {
        const bool met = this->TraceCell(cell, query, ray, rules, first, last, best);
        end = best && best->Triangle >= 0 ? std::min(end, best->T) : end;
        return met;
      });
  }

  bool TraceCell(std::size_t index, Query& query, const RayStretch& ray, const RayRules& rules, double first,
    double last, RayHit* best) const
  {
    const OccluderCell& cell = this->Cells.Cells[index];
    const EmbreeCell& built = this->Scenes[index];
    RTCRayHit rayHit;
    SetRay(rayHit.ray, cell, ray, first, last);
    const float frameEnd = rayHit.ray.tfar;
    query.Ends = &frameEnd;
    query.SetRules(rules, cell.Scale);
    if (query.What == Wanted::Any)
    {
      Any(built.Scene, query, rayHit.ray);
      return rayHit.ray.tfar < 0.0f;
    }
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Nearest(built.Scene, query, rayHit);
    if (rayHit.hit.geomID != RTC_INVALID_GEOMETRY_ID)
    {
      const RayHit hit = HitOf(this->Mesh, built.Triangles[rayHit.hit.geomID][rayHit.hit.primID], ray);
      *best = best->Triangle < 0 || hit.T < best->T ? hit : *best;
    }
    return false;
  }

  /// The triangles that a lamp's plane makes rays pass by.
  struct PassedBy
  {
    FlatFace Lamp;
    std::vector<unsigned char> Triangles; ///< empty: none
  };

  const TriangleMeshView Mesh;
  const Box Bounds;
  const bool IsSinglePrecision;
  std::mutex Lock; ///< of Lamps
  std::vector<std::unique_ptr<PassedBy>> Lamps;
  OccluderCells Cells;
  MemoryBudget Memory;
  RTCDevice Device = nullptr;
  std::vector<EmbreeCell> Scenes; ///< of the cells
};

Box MeshBounds(const TriangleMeshView& mesh)
{
  Box bounds;
  for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
  {
    bounds.Add(mesh.Point(mesh.Triangles[i]));
  }
  return bounds;
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
  if (options.MemoryLimit > 0)
  {
    impl.Memory.Limit = options.MemoryLimit;
    rtcSetDeviceMemoryMonitorFunction(impl.Device, WatchMemory, &impl.Memory);
  }
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
  Query query;
  query.What = Wanted::Nearest;
  RayHit best;
  this->Impl->Trace(query, StretchOf(origin, direction, tMin, tMax, rules), rules, &best);
  if (best.Triangle < 0)
  {
    return false;
  }
  hit = best;
  return true;
}

void OccluderScene::IntersectPacket(
  const Vector3* origins, const Vector3* directions, int count, RayHit* hits) const
{
  const Implementation& impl = *this->Impl;
  if (impl.Scenes.size() != 1)
  {
    for (int k = 0; k < count; ++k)
    {
      hits[k] = RayHit();
      this->Intersect(origins[k], directions[k], 0.0, HUGE_VAL, hits[k]);
    }
    return;
  }
  const OccluderCell& cell = impl.Cells.Cells[0];
  alignas(32) RTCRayHit8 packet;
  alignas(32) int valid[packetSize];
  RayStretch rays[packetSize];
  float ends[packetSize];
  for (int k = 0; k < packetSize; ++k)
  {
    RTCRay ray{};
    valid[k] = 0;
    double begin = 0.0;
    double end = HUGE_VAL;
    if (k < count && IsFinite(origins[k]) && IsFinite(directions[k]) &&
      cell.Bounds.Clip(origins[k], directions[k], begin, end))
    {
      rays[k] = StretchOf(origins[k], directions[k], 0.0, HUGE_VAL, {});
      SetRay(ray, cell, rays[k], begin, end);
      valid[k] = -1;
    }
    SetLane(packet.ray, k, ray, static_cast<unsigned int>(k));
    ends[k] = ray.tfar;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  Query query;
  query.What = Wanted::Nearest;
  query.Mesh = &impl.Mesh;
  query.Rays = rays;
  query.Ends = ends;
  NearestOfPacket(valid, impl.Scenes[0].Scene, query, packet);
  for (int k = 0; k < count; ++k)
  {
    const bool met = valid[k] && packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    hits[k] = met ? HitOf(impl.Mesh, impl.Scenes[0].Triangles[packet.hit.geomID[k]][packet.hit.primID[k]], rays[k]) : RayHit();
  }
}

void OccluderScene::IntersectAll(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
  std::vector<RayHit>& hits, const RayRules& rules) const
{
  hits.clear();
  thread_local std::vector<vtkIdType> found;
  found.clear();
  Query query;
  query.What = Wanted::All;
  query.Found = &found;
  const RayStretch ray = StretchOf(origin, direction, tMin, tMax, rules);
  this->Impl->Trace(query, ray, rules, nullptr);
  for (const vtkIdType triangle : found)
  {
    hits.push_back(HitOf(this->Impl->Mesh, triangle, ray));
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
  Query query;
  return this->Impl->Trace(query, StretchOf(origin, direction, tMin, tMax, rules), rules, nullptr);
}

std::uint64_t OccluderScene::OccludedFrom(const Vector3& origin, const double* x, const double* y, const double* z,
  std::uint64_t wanted, bool infinity, const RayRules& rules) const
{
  const Implementation& impl = *this->Impl;
  if (impl.Bounds.Empty() || !IsFinite(origin))
  {
    return 0;
  }
  std::uint64_t occluded = 0;
  if (impl.Scenes.size() > 1)
  {
    for (int k = 0; k < 64; ++k)
    {
      const Vector3 to{ x[k], y[k], z[k] };
      const double distance = (wanted >> k) & 1u ? Length(to) : 0.0;
      const bool hit =
        distance > 0.0 && this->Occluded(origin, (1.0 / distance) * to, 0.0, infinity ? HUGE_VAL : distance, rules);
      occluded |= static_cast<std::uint64_t>(hit) << k;
    }
    return occluded;
  }
  const OccluderCell& cell = impl.Cells.Cells[0];
  Query query;
  query.Mesh = &impl.Mesh;
  query.SetRules(rules, cell.Scale);
  query.Origin = &origin;
  query.X = x;
  query.Y = y;
  query.Z = z;
  query.Infinity = infinity;
  float ends[64];
  query.Ends = ends;
  const Vector3 start = cell.Scale * (origin - cell.Center);
  // From far away each ray starts at the bounds, at its own place.
  const bool isNear = Dot(start, start) < farthestOrigin * farthestOrigin;
  for (int first = 0; first < 64; first += packetSize)
  {
    if (((wanted >> first) & ((1u << packetSize) - 1)) == 0)
    {
      continue;
    }
    alignas(32) RTCRay8 rays;
    alignas(32) int valid[packetSize];
    isNear ? SetNearRays(query, cell, start, first, wanted, rays, valid)
           : SetFarRays(query, cell, first, wanted, rays, valid);
    std::copy(rays.tfar, rays.tfar + packetSize, ends + first);
    AnyOfPacket(valid, impl.Scenes[0].Scene, query, rays);
    for (int k = 0; k < packetSize; ++k)
    {
      const bool hit = valid[k] && rays.tfar[k] < 0.0f;
      occluded |= static_cast<std::uint64_t>(hit) << (first + k);
    }
  }
  return occluded;
}

Vector3 OccluderScene::TriangleNormal(vtkIdType triangle) const
{
  const TriangleMeshView& mesh = this->Impl->Mesh;
  const Vector3 a = mesh.Corner(triangle, 0);
  return Normalized(Cross(mesh.Corner(triangle, 1) - a, mesh.Corner(triangle, 2) - a));
}

} // namespace shadowcones
