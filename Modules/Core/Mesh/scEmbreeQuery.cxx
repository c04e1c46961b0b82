// SPDX-License-Identifier: BSD-3-Clause
#include "scEmbreeQuery.h"

namespace shadowcones
{
namespace
{
const EmbreeQuery& QueryOf(const RTCFilterFunctionNArguments* arguments)
{
  return *reinterpret_cast<const EmbreeQuery*>(arguments->context);
}
const PieceGroup& GroupOf(const RTCFilterFunctionNArguments* arguments)
{
  return *static_cast<const PieceGroup*>(arguments->geometryUserPtr);
}

ClearLimits LimitsOf(const RTCFilterFunctionNArguments* arguments)
{
  const EmbreeQuery& query = QueryOf(arguments);
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
  const EmbreeQuery& query = QueryOf(arguments);
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

} // anonymous namespace

void FilterHits(const RTCFilterFunctionNArguments* arguments)
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

} // namespace shadowcones
