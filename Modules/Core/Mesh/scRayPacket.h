// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRayPacket.h
 * @brief Eight rays as Embree takes them, filled and looked at with wide vectors. Internal to Core.
 */
#ifndef scRayPacket_h
#define scRayPacket_h

#include "scOccluderCells.h"
#include "scOccluderScene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <cstring>

namespace shadowcones
{

constexpr int rayPacketSize = OccluderScene::PacketSize;

/// A ray's id holds its end in the cell's frame (cut down, never longer) and, in its last bits, its index in the query.
constexpr unsigned int rayIndexMask = 63;
inline unsigned int RayId(float end, unsigned int index)
{
  unsigned int bits = 0;
  std::memcpy(&bits, &end, sizeof(bits));
  return (bits & ~rayIndexMask) | index;
}
inline float EndOfRay(unsigned int id)
{
  const unsigned int bits = id & ~rayIndexMask;
  float end = 0.0f;
  std::memcpy(&end, &bits, sizeof(end));
  return end;
}

struct RayPacket
{
  alignas(32) RTCRayHit8 Traced;
  alignas(32) int Valid[rayPacketSize]; ///< -1: to be traced
};

/// Eight rays in the world. Their values may be anything.
struct WorldRays
{
  double Origins[3][rayPacketSize];
  double Directions[3][rayPacketSize]; ///< unit
  double Ends[rayPacketSize];          ///< HUGE_VAL: none
};

/**
 * Rays from one point in a cell or near it, @p start in its frame, along (x[k], y[k], z[k]), as long as these are or
 * without an end. Bits of @p wanted say which.
 */
void SetNearRays(const OccluderCell& cell, const Vector3& start, const double* x, const double* y, const double* z,
  unsigned int wanted, unsigned int firstIndex, bool infinity, RayPacket& packet);

/// Rays up to their ends, from before they enter the cell, and no hits; bits of @p wanted say which.
void SetFreeRays(const OccluderCell& cell, const WorldRays& rays, unsigned int wanted, RayPacket& packet);

/// After a query for any hit: bits of the rays that have one.
unsigned int BlockedRays(const RayPacket& packet);

/**
 * When a hit on a piece, found in single precision, is one beyond doubt: it lies inside by twice the margin, once for the
 * piece's own and once for what single precision gets wrong, and its ray begins and ends as far from the piece's plane.
 * All over the cosine.
 */
struct ClearLimits
{
  float Inside; ///< 1 / (twice the margin times the longest edge that a piece may have); 0: never
  float
    Height; ///< 1 / (twice the margin, or what the query's rules ask for, times twice the area that a piece may have)
};

/// Normal (twice the piece's area long), barycentric coordinates, distance and direction as Embree found them.
inline bool IsClear(float x, float y, float z, float u, float v, float t, float dx, float dy, float dz, float end,
  const ClearLimits& limits)
{
  constexpr auto margin = static_cast<float>(OccluderCells::RayMargin);
  const float slope = std::fabs(x * dx + y * dy + z * dz); // twice the area times the cosine
  const float rest = 1.0f - u - v;
  const float lesser = u < v ? u : v;
  const float least = lesser < rest ? lesser : rest; // of the distances to the edges, over the heights
  const float begin = t - margin;
  const float ahead = end - margin - t;
  const float along = begin < ahead ? begin : ahead;
  return (limits.Inside * least * slope > 1.0f) & (limits.Height * along * slope > 1.0f);
}

/// IsClear for a packet: @p clear is -1 or 0 a ray. @return is any valid ray not clear?
bool FindClear(const RTCRay8& rays, const RTCHit8& hits, const int* valid, const ClearLimits& limits, int* clear);

} // namespace shadowcones

#endif
