// SPDX-License-Identifier: BSD-3-Clause
// Rays that are traced several at a time: the packets of an OccluderScene.
#include "scEmbreeQuery.h"
#include "scOccluderImplementation.h"
#include "scOccluderScene.h"
#include "scRayPacket.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// In a cell's frame, where it has a diagonal of 2: farther origins have too few digits in single precision.
constexpr double farthestOrigin = 2.0;

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
  const EmbreeQuery& query, const OccluderCell& cell, unsigned int wanted, unsigned int firstIndex, RayPacket& packet)
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

/// Without ends; the last ray stands for those that are missing.
WorldRays RaysOf(const Vector3* origins, const Vector3* directions, int count)
{
  WorldRays rays;
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const int from = std::min(k, count - 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      rays.Origins[axis][k] = origins[from][axis];
      rays.Directions[axis][k] = directions[from][axis];
    }
    rays.Ends[k] = HUGE_VAL;
  }
  return rays;
}
} // anonymous namespace

void OccluderScene::IntersectPacket(const Vector3* origins, const Vector3* directions, int count, RayHit* hits) const
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
  const WorldRays rays = RaysOf(origins, directions, count);
  RayPacket packet;
  SetFreeRays(impl.Cells.Cells[0], rays, (1u << count) - 1u, packet);
  const RayRules rules;
  EmbreeQuery query(impl.Mesh, rules);
  query.Origins = origins;
  query.Directions = directions;
  TraceNearestOfPacket(packet.Valid, impl.Scenes[0].Scene, query, packet.Traced);
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

unsigned int OccluderScene::OccludedPacket(
  const Vector3* origins, const Vector3* directions, const double* ends, int count, const RayRules& rules) const
{
  const Implementation& impl = *this->Impl;
  if (impl.Scenes.size() != 1)
  {
    unsigned int occluded = 0;
    for (int k = 0; k < count; ++k)
    {
      occluded |= this->Occluded(origins[k], directions[k], 0.0, ends[k], rules) ? 1u << k : 0u;
    }
    return occluded;
  }
  const OccluderCell& cell = impl.Cells.Cells[0];
  WorldRays rays = RaysOf(origins, directions, count);
  std::copy(ends, ends + count, rays.Ends);
  RayPacket packet;
  SetFreeRays(cell, rays, (1u << count) - 1u, packet);
  EmbreeQuery query(impl.Mesh, rules);
  query.SetScale(cell.Scale);
  query.Origins = origins;
  query.Directions = directions;
  query.Ends = ends;
  TraceAnyOfPacket(packet.Valid, impl.Scenes[0].Scene, query, packet.Traced.ray);
  return BlockedRays(packet);
}

std::uint64_t OccluderScene::Implementation::TraceFrom(
  const Vector3& origin, std::uint64_t wanted, EmbreeQuery& query) const
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
    TraceAnyOfPacket(packet.Valid, this->Scenes[0].Scene, query, packet.Traced.ray);
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
  EmbreeQuery query(impl.Mesh, rules);
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
  EmbreeQuery query(impl.Mesh, rules);
  query.X = x;
  query.Y = y;
  query.Z = z;
  query.End = infinity ? HUGE_VAL : 0.0;
  query.Found = &met;
  query.TakesClear = false; // the traversal goes on behind what it meets
  impl.TraceFrom(origin, wanted, query);
}

} // namespace shadowcones
