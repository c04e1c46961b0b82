// SPDX-License-Identifier: BSD-3-Clause
// One file because rays, packets and all hits share the rounding of one intersection.
#include "scOccluderScene.h"

#include "scOccluderCells.h"
#include "scRayPacket.h"
#include "scSinglePrecision.h"
#include "scTriangleCrossing.h"

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
/// In a cell's frame, where it has a diagonal of 2: farther origins have too few digits in single precision.
constexpr double farthestOrigin = 2.0;
constexpr double rayMargin = OccluderCells::RayMargin;

/// What the filter has to know of a query; Embree hands it over by its own context, which comes first.
struct Query
{
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext Context;
#else
  RTCIntersectContext Context;
#endif
  const TriangleMeshView& Mesh;
  const RayRules& Rules;
  const Vector3* Origins = nullptr; ///< by the ray's index; where there are no Directions: the one of all rays
  const Vector3* Directions = nullptr;
  const double* X = nullptr; ///< vectors to the ends of rays, where there are no Directions
  const double* Y = nullptr;
  const double* Z = nullptr;
  double Begin = 0.0;
  double End = HUGE_VAL;                   ///< of vectors: HUGE_VAL, or theirs where it is 0
  float ClearHeight = 1.0f;                ///< factor of a group's
  bool TakesClear = true;                  ///< hits beyond doubt need no look at their triangle
  /// All triangles that are crossed, some of them more than once.
  std::vector<OccluderScene::MetTriangle>* Found = nullptr;

  Query(const TriangleMeshView& mesh, const RayRules& rules)
    : Mesh(mesh)
    , Rules(rules)
    , TakesClear(!rules.Ignored)
  {
  }
  /// Tolerances of the rules, in the frame of a cell.
  void SetScale(double scale)
  {
    const double tolerance = std::max(this->Rules.StartTolerance, this->Rules.EndTolerance);
    if (tolerance > 0.0)
    {
      this->ClearHeight = static_cast<float>(1.0 / (1.0 + tolerance * scale / OccluderCells::Margin));
    }
  }
  RayStretch RayOf(unsigned int index) const
  {
    const double begin = this->Rules.StartTolerance;
    const double end = this->Rules.EndTolerance;
    if (this->Directions)
    {
      return { this->Origins[index], this->Directions[index], this->Begin, this->End, begin, end };
    }
    const Vector3 to{ this->X[index], this->Y[index], this->Z[index] };
    const double distance = std::sqrt(Dot(to, to));
    return { *this->Origins, (1.0 / distance) * to, 0.0, this->End > 0.0 ? HUGE_VAL : distance, begin, end };
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

RayHit HitOf(const TriangleMeshView& mesh, vtkIdType triangle, const Vector3& origin, const Vector3& direction)
{
  RayHit hit;
  hit.Triangle = triangle;
  hit.T = DistanceToPlane(
    origin, direction, mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2), hit.FrontFacing);
  return hit;
}

/// Begin to load what HitOf() reads, for several hits at a time: meshes are larger than caches.
void FetchIds(const TriangleMeshView& mesh, vtkIdType triangle)
{
  __builtin_prefetch(mesh.Triangles + 3 * triangle);
}
void FetchCorners(const TriangleMeshView& mesh, vtkIdType triangle)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    __builtin_prefetch(mesh.Points + 3 * mesh.Triangles[3 * triangle + corner]);
  }
}

/// Pieces of about one size, as Embree has them.
struct PieceGroup
{
  float ClearInside = 0.0f; ///< see ClearLimits
  float ClearHeight = 0.0f;
  std::vector<unsigned int> Triangles; ///< of each piece
};

const Query& QueryOf(const RTCFilterFunctionNArguments* arguments)
{
  return *reinterpret_cast<const Query*>(arguments->context);
}
const PieceGroup& GroupOf(const RTCFilterFunctionNArguments* arguments)
{
  return *static_cast<const PieceGroup*>(arguments->geometryUserPtr);
}

ClearLimits LimitsOf(const RTCFilterFunctionNArguments* arguments)
{
  const Query& query = QueryOf(arguments);
  const PieceGroup& group = GroupOf(arguments);
  return { group.ClearInside, group.ClearHeight * query.ClearHeight };
}

/// Is hit @p i of n, found in single precision, one beyond doubt?
inline bool IsHitClear(const RTCFilterFunctionNArguments* arguments, unsigned int n, unsigned int i)
{
  RTCRayN* ray = arguments->ray;
  RTCHitN* hit = arguments->hit;
  return IsClear(RTCHitN_Ng_x(hit, n, i), RTCHitN_Ng_y(hit, n, i), RTCHitN_Ng_z(hit, n, i), RTCHitN_u(hit, n, i),
    RTCHitN_v(hit, n, i), RTCRayN_tfar(ray, n, i), RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i),
    RTCRayN_dir_z(ray, n, i), EndOfRay(RTCRayN_id(ray, n, i)), LimitsOf(arguments));
}

/// Keep a hit where its triangle is met. All are wanted: note it, and let the traversal go on as where it is not met.
void Decide(const RTCFilterFunctionNArguments* arguments, unsigned int i, bool clear)
{
  const Query& query = QueryOf(arguments);
  const TriangleMeshView& mesh = query.Mesh;
  const vtkIdType triangle = GroupOf(arguments).Triangles[RTCHitN_primID(arguments->hit, arguments->N, i)];
  const unsigned int index = RTCRayN_id(arguments->ray, arguments->N, i) & rayIndexMask;
  const bool met = !(query.Rules.Ignored && query.Rules.Ignored[triangle]) &&
    (clear ||
      Crosses(query.RayOf(index), mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2)));
  if (met && query.Found)
  {
    query.Found->push_back({ static_cast<int>(index), triangle });
  }
  if (!met || query.Found)
  {
    arguments->valid[i] = 0;
  }
}

[[gnu::noinline]] void FilterPacket(const RTCFilterFunctionNArguments* arguments)
{
  const auto& rays = *reinterpret_cast<const RTCRay8*>(arguments->ray);
  const auto& hits = *reinterpret_cast<const RTCHit8*>(arguments->hit);
  const bool takesClear = QueryOf(arguments).TakesClear;
  int clear[rayPacketSize];
  if (!FindClear(rays, hits, arguments->valid, LimitsOf(arguments), clear) && takesClear)
  {
    return;
  }
  for (unsigned int k = 0; k < rayPacketSize; ++k)
  {
    if (arguments->valid[k] && !(clear[k] && takesClear))
    {
      Decide(arguments, k, clear[k] != 0);
    }
  }
}

[[gnu::noinline]] void FilterAny(const RTCFilterFunctionNArguments* arguments)
{
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (arguments->valid[i])
    {
      Decide(arguments, i, IsHitClear(arguments, arguments->N, i));
    }
  }
}

/// Hits are found in single precision, for one ray or some of a packet: keep those whose triangles are crossed.
void Filter(const RTCFilterFunctionNArguments* arguments)
{
  if (arguments->N == 1)
  {
    if (!(IsHitClear(arguments, 1, 0) && QueryOf(arguments).TakesClear))
    {
      FilterAny(arguments);
    }
    return;
  }
  unsigned int asked = 0;
  if (arguments->N == rayPacketSize)
  {
    for (int k = 0; k < rayPacketSize; ++k)
    {
      asked |= static_cast<unsigned int>(arguments->valid[k]) & (1u << k);
    }
    // Mostly it is one ray of a packet. Embree has just written its distance alone: reading all eight would wait for it.
    if ((asked & (asked - 1)) != 0)
    {
      FilterPacket(arguments);
      return;
    }
  }
  if (!(asked && IsHitClear(arguments, rayPacketSize, static_cast<unsigned int>(__builtin_ctz(asked))) &&
        QueryOf(arguments).TakesClear))
  {
    FilterAny(arguments);
  }
}

/// A cell as Embree has it, its pieces in one geometry for each size.
struct EmbreeCell
{
  RTCScene Scene = nullptr;
  std::vector<PieceGroup> Groups;

  vtkIdType TriangleOf(unsigned int group, unsigned int piece) const { return this->Groups[group].Triangles[piece]; }
};

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

/// Embree's own memory; a limit makes it fail as if there were no more.
struct MemoryBudget
{
  std::atomic<std::int64_t> Used{ 0 };
  std::int64_t Limit = 0; ///< 0: none
};

bool WatchMemory(void* user, ssize_t bytes, bool post)
{
  auto* budget = static_cast<MemoryBudget*>(user);
  const std::int64_t used = budget->Used += bytes;
  return post || bytes <= 0 || budget->Limit == 0 || used <= budget->Limit;
}

/// A ray of a cell in single precision, a little longer than it is.
void SetRay(RTCRay& ray, const OccluderCell& cell, const Vector3& origin, const Vector3& direction, double begin,
  double end, unsigned int index = 0)
{
  const double first = begin - cell.RayMargin;
  const Vector3 start = cell.Scale * (origin + first * direction - cell.Center);
  ray.org_x = static_cast<float>(start.X);
  ray.org_y = static_cast<float>(start.Y);
  ray.org_z = static_cast<float>(start.Z);
  ray.dir_x = static_cast<float>(direction.X);
  ray.dir_y = static_cast<float>(direction.Y);
  ray.dir_z = static_cast<float>(direction.Z);
  ray.tnear = 0.0f;
  ray.tfar = static_cast<float>(cell.Scale * (end - first) + rayMargin);
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = RayId(ray.tfar, index);
  ray.flags = 0;
}

/// One ray of a packet.
void SetLane(RTCRay8& rays, int k, const RTCRay& ray)
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
  rays.id[k] = ray.id;
  rays.flags[k] = 0;
}

/// Eight rays from one point far from a cell: each starts where it enters.
void SetFarRays(
  const Query& query, const OccluderCell& cell, unsigned int wanted, unsigned int firstIndex, RayPacket& packet)
{
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const unsigned int index = firstIndex + static_cast<unsigned int>(k);
    const Vector3 to{ query.X[index], query.Y[index], query.Z[index] };
    RTCRay ray{};
    packet.Valid[k] = 0;
    if (((wanted >> k) & 1u) && IsFinite(to) && Dot(to, to) > 0.0)
    {
      const RayStretch stretch = query.RayOf(index);
      double begin = 0.0;
      double end = stretch.End;
      if (cell.Bounds.Clip(stretch.Origin, stretch.Direction, begin, end))
      {
        begin = std::max(0.0, begin - cell.Reach);
        end = std::min(stretch.End, end + cell.Reach);
        SetRay(ray, cell, stretch.Origin, stretch.Direction, begin, end, index);
        packet.Valid[k] = -1;
      }
    }
    SetLane(packet.Traced.ray, k, ray);
  }
}

bool AllInSinglePrecision(const TriangleMeshView& mesh)
{
  return std::all_of(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints, IsSinglePrecision);
}

/// Embree stops the program at a ray that is not a number. Differences are quicker than six questions.
bool IsFiniteRay(const Vector3& origin, const Vector3& direction)
{
  const Vector3 none = (origin - origin) + (direction - direction);
  return none.X + none.Y + none.Z == 0.0;
}
} // anonymous namespace

struct OccluderScene::Implementation
{
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
    std::vector<std::vector<unsigned int>> members(1 + numberOfSizes);
    for (std::size_t i = 0; i < cell.Pieces.size(); ++i)
    {
      members[GroupOf(cell.Pieces[i])].push_back(static_cast<unsigned int>(i));
    }
    built.Groups.resize(members.size()); // Embree keeps their addresses
    for (std::size_t group = 0; group < members.size(); ++group)
    {
      if (!members[group].empty())
      {
        this->AddGeometry(built, static_cast<unsigned int>(group), cell.Pieces, members[group]);
      }
    }
    rtcCommitScene(built.Scene);
    this->ThrowOnError();
    cell.Pieces = {};
  }

  void AddGeometry(EmbreeCell& cell, unsigned int id, const std::vector<CellPiece>& pieces,
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
      rtcSetGeometryIntersectFilterFunction(geometry, Filter);
      rtcSetGeometryOccludedFilterFunction(geometry, Filter);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(cell.Scene, geometry, id);
    }
    rtcReleaseGeometry(geometry);
  }

  /// Ask the cells on the way of the query's one ray: for the nearest hit, if @p best is given. @return is there any?
  bool Trace(Query& query, RayHit* best) const
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

  bool TraceCell(std::size_t index, Query& query, double first, double last, RayHit* best) const
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
      Any(built.Scene, query, rayHit.ray);
      return rayHit.ray.tfar < 0.0f;
    }
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    Nearest(built.Scene, query, rayHit);
    if (rayHit.hit.geomID != RTC_INVALID_GEOMETRY_ID)
    {
      const RayHit hit = HitOf(this->Mesh, built.TriangleOf(rayHit.hit.geomID, rayHit.hit.primID), origin, direction);
      *best = best->Triangle < 0 || hit.T < best->T ? hit : *best;
    }
    return false;
  }

  /// Ask the one cell that there is for up to 64 rays from one point. @return bits of those that are kept from going on.
  std::uint64_t TraceFrom(const Vector3& origin, std::uint64_t wanted, Query& query) const;

  /// The triangles that a lamp's plane makes rays pass by.
  struct PassedBy
  {
    FlatFace Lamp;
    std::vector<unsigned char> Triangles; ///< empty: none
  };

  Query QueryOf(
    const Vector3& origin, const Vector3& direction, double begin, double end, const RayRules& rules) const
  {
    Query query(this->Mesh, rules);
    query.Origins = &origin;
    query.Directions = &direction;
    query.Begin = begin;
    query.End = end;
    return query;
  }

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
  const std::lock_guard<std::mutex> lock(impl.Lock);
  for (const auto& lamp : impl.Lamps)
  {
    bytes += static_cast<std::int64_t>(lamp->Triangles.capacity());
  }
  return bytes;
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
  Query query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
  RayHit best;
  this->Impl->Trace(query, &best);
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
  WorldRays rays;
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const int from = std::min(k, count - 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      rays.Origins[axis][k] = origins[from][axis];
      rays.Directions[axis][k] = directions[from][axis];
    }
  }
  RayPacket packet;
  SetFreeRays(impl.Cells.Cells[0], rays, (1u << count) - 1u, packet);
  const RayRules rules;
  Query query(impl.Mesh, rules);
  query.Origins = origins;
  query.Directions = directions;
  NearestOfPacket(packet.Valid, impl.Scenes[0].Scene, query, packet.Traced);
  const RTCHit8& found = packet.Traced.hit;
  for (int k = 0; k < count; ++k)
  {
    hits[k] = RayHit();
    if (packet.Valid[k] && found.geomID[k] != RTC_INVALID_GEOMETRY_ID)
    {
      hits[k].Triangle = impl.Scenes[0].TriangleOf(found.geomID[k], found.primID[k]);
      FetchIds(impl.Mesh, hits[k].Triangle);
    }
  }
  for (int k = 0; k < count; ++k)
  {
    if (hits[k].Triangle >= 0)
    {
      FetchCorners(impl.Mesh, hits[k].Triangle);
    }
  }
  for (int k = 0; k < count; ++k)
  {
    hits[k] = hits[k].Triangle < 0 ? hits[k] : HitOf(impl.Mesh, hits[k].Triangle, origins[k], directions[k]);
  }
}

void OccluderScene::IntersectAll(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
  std::vector<RayHit>& hits, const RayRules& rules) const
{
  hits.clear();
  thread_local std::vector<MetTriangle> found;
  found.clear();
  Query query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
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
  Query query = this->Impl->QueryOf(origin, direction, tMin, tMax, rules);
  return this->Impl->Trace(query, nullptr);
}

std::uint64_t OccluderScene::Implementation::TraceFrom(const Vector3& origin, std::uint64_t wanted, Query& query) const
{
  const OccluderCell& cell = this->Cells.Cells[0];
  const bool infinity = query.End > 0.0;
  query.SetScale(cell.Scale);
  query.Origins = &origin;
  const Vector3 start = cell.Scale * (origin - cell.Center);
  // From far away each ray starts at the bounds, at its own place.
  const bool isNear = Dot(start, start) < farthestOrigin * farthestOrigin;
  std::uint64_t occluded = 0;
  for (unsigned int first = 0; first < 64; first += rayPacketSize)
  {
    const auto asked = static_cast<unsigned int>(wanted >> first) & ((1u << rayPacketSize) - 1u);
    if (asked == 0)
    {
      continue;
    }
    RayPacket packet;
    isNear ? SetNearRays(cell, start, query.X + first, query.Y + first, query.Z + first, asked, first, infinity, packet)
           : SetFarRays(query, cell, asked, first, packet);
    AnyOfPacket(packet.Valid, this->Scenes[0].Scene, query, packet.Traced.ray);
    occluded |= static_cast<std::uint64_t>(BlockedRays(packet)) << first;
  }
  return occluded;
}

std::uint64_t OccluderScene::OccludedFrom(const Vector3& origin, const double* x, const double* y, const double* z,
  std::uint64_t wanted, bool infinity, const RayRules& rules) const
{
  const Implementation& impl = *this->Impl;
  if (impl.Bounds.Empty() || !IsFinite(origin))
  {
    return 0;
  }
  if (impl.Scenes.size() > 1)
  {
    std::uint64_t occluded = 0;
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
  Query query(impl.Mesh, rules);
  query.X = x;
  query.Y = y;
  query.Z = z;
  query.End = infinity ? HUGE_VAL : 0.0;
  return impl.TraceFrom(origin, wanted, query);
}

void OccluderScene::TrianglesFrom(const Vector3& origin, const double* x, const double* y, const double* z,
  std::uint64_t wanted, bool infinity, std::vector<MetTriangle>& met, const RayRules& rules) const
{
  met.clear();
  const Implementation& impl = *this->Impl;
  if (impl.Bounds.Empty() || !IsFinite(origin))
  {
    return;
  }
  if (impl.Scenes.size() > 1)
  {
    thread_local std::vector<RayHit> hits;
    for (int k = 0; k < 64; ++k)
    {
      const Vector3 to{ x[k], y[k], z[k] };
      const double distance = (wanted >> k) & 1u ? Length(to) : 0.0;
      if (distance > 0.0)
      {
        this->IntersectAll(origin, (1.0 / distance) * to, 0.0, infinity ? HUGE_VAL : distance, hits, rules);
        std::for_each(hits.begin(), hits.end(), [&met, k](const RayHit& hit) { met.push_back({ k, hit.Triangle }); });
      }
    }
    return;
  }
  Query query(impl.Mesh, rules);
  query.X = x;
  query.Y = y;
  query.Z = z;
  query.End = infinity ? HUGE_VAL : 0.0;
  query.Found = &met;
  query.TakesClear = false; // the traversal goes on behind what it meets
  impl.TraceFrom(origin, wanted, query);
}

Vector3 OccluderScene::TriangleNormal(vtkIdType triangle) const
{
  const TriangleMeshView& mesh = this->Impl->Mesh;
  const Vector3 a = mesh.Corner(triangle, 0);
  return Normalized(Cross(mesh.Corner(triangle, 1) - a, mesh.Corner(triangle, 2) - a));
}

} // namespace shadowcones
