// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scEmbreeQuery.h
 * @brief One question to Embree, 3 or 4, and how its hits are decided in double precision. Internal to Core.
 */
#ifndef scEmbreeQuery_h
#define scEmbreeQuery_h

#include "scOccluderCells.h"
#include "scOccluderScene.h"
#include "scRayPacket.h"
#include "scTriangleCrossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shadowcones
{

/// What the filter has to know of a query; Embree hands it over by its own context, which comes first.
struct EmbreeQuery
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
  const double* Ends = nullptr; ///< of rays with Directions, where they differ
  double Begin = 0.0;
  double End = HUGE_VAL;    ///< of vectors: HUGE_VAL, or theirs where it is 0
  float ClearHeight = 1.0f; ///< factor of a group's
  bool TakesClear = true;   ///< hits beyond doubt need no look at their triangle
  /// All triangles that are crossed, some of them more than once.
  std::vector<OccluderScene::MetTriangle>* Found = nullptr;

  EmbreeQuery(const TriangleMeshView& mesh, const RayRules& rules)
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
      return { this->Origins[index], this->Directions[index], this->Begin, this->Ends ? this->Ends[index] : this->End,
        begin, end };
    }
    const Vector3 to{ this->X[index], this->Y[index], this->Z[index] };
    const double distance = std::sqrt(Dot(to, to));
    return { *this->Origins, (1.0 / distance) * to, 0.0, this->End > 0.0 ? HUGE_VAL : distance, begin, end };
  }
};

// Embree 3 and 4 differ in how a query is described and in nothing else that is used here.
#if RTC_VERSION_MAJOR >= 4
inline void TraceNearest(RTCScene scene, EmbreeQuery& query, RTCRayHit& rayHit)
{
  rtcInitRayQueryContext(&query.Context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.Context;
  rtcIntersect1(scene, &rayHit, &arguments);
}
inline void TraceNearestOfPacket(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRayHit8& rayHits)
{
  rtcInitRayQueryContext(&query.Context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &query.Context;
  rtcIntersect8(valid, scene, &rayHits, &arguments);
}
inline void TraceAny(RTCScene scene, EmbreeQuery& query, RTCRay& ray)
{
  rtcInitRayQueryContext(&query.Context);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.Context;
  rtcOccluded1(scene, &ray, &arguments);
}
inline void TraceAnyOfPacket(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRay8& rays)
{
  rtcInitRayQueryContext(&query.Context);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query.Context;
  rtcOccluded8(valid, scene, &rays, &arguments);
}
#else
inline void TraceNearest(RTCScene scene, EmbreeQuery& query, RTCRayHit& rayHit)
{
  rtcInitIntersectContext(&query.Context);
  rtcIntersect1(scene, &query.Context, &rayHit);
}
inline void TraceNearestOfPacket(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRayHit8& rayHits)
{
  rtcInitIntersectContext(&query.Context);
  query.Context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &query.Context, &rayHits);
}
inline void TraceAny(RTCScene scene, EmbreeQuery& query, RTCRay& ray)
{
  rtcInitIntersectContext(&query.Context);
  rtcOccluded1(scene, &query.Context, &ray);
}
inline void TraceAnyOfPacket(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRay8& rays)
{
  rtcInitIntersectContext(&query.Context);
  rtcOccluded8(valid, scene, &query.Context, &rays);
}
#endif

inline RayHit HitOf(const TriangleMeshView& mesh, vtkIdType triangle, const Vector3& origin, const Vector3& direction)
{
  RayHit hit;
  hit.Triangle = triangle;
  hit.T = DistanceToPlane(
    origin, direction, mesh.Corner(triangle, 0), mesh.Corner(triangle, 1), mesh.Corner(triangle, 2), hit.FrontFacing);
  return hit;
}

/// Begin to load what HitOf() reads, for several hits at a time: meshes are larger than caches.
inline void FetchIds(const TriangleMeshView& mesh, vtkIdType triangle)
{
  __builtin_prefetch(mesh.Triangles + 3 * triangle);
}
inline void FetchCorners(const TriangleMeshView& mesh, vtkIdType triangle)
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

/// A cell as Embree has it, its pieces in one geometry for each size.
struct EmbreeCell
{
  RTCScene Scene = nullptr;
  std::vector<PieceGroup> Groups;

  vtkIdType TriangleOf(unsigned int group, unsigned int piece) const { return this->Groups[group].Triangles[piece]; }
};

/// Hits are found in single precision, for one ray or some of a packet: keep those whose triangles are crossed. For queries
/// that are EmbreeQuery, of geometries whose user data is a PieceGroup.
void FilterHits(const RTCFilterFunctionNArguments* arguments);

/// A ray of a cell in single precision, a little longer than it is.
inline void SetRay(RTCRay& ray, const OccluderCell& cell, const Vector3& origin, const Vector3& direction, double begin,
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
  ray.tfar = static_cast<float>(cell.Scale * (end - first) + OccluderCells::RayMargin);
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = RayId(ray.tfar, index);
  ray.flags = 0;
}

/// Embree stops the program at a ray that is not a number. Differences are quicker than six questions.
inline bool IsFiniteRay(const Vector3& origin, const Vector3& direction)
{
  const Vector3 none = (origin - origin) + (direction - direction); // NOLINT(misc-redundant-expression)
  return none.X + none.Y + none.Z == 0.0;
}

} // namespace shadowcones

#endif
