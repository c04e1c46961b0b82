// SPDX-License-Identifier: BSD-3-Clause
#include "scRayPacket.h"

#include "scWideLoops.h"

#include <cmath>
#include <limits>

namespace shadowcones
{

SHADOWCONES_WIDE void SetNearRays(const OccluderCell& cell, const Vector3& start, const double* x, const double* y,
  const double* z, unsigned int wanted, unsigned int firstIndex, bool infinity, RayPacket& packet)
{
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr auto margin = static_cast<float>(OccluderCells::RayMargin);
  const double scale = infinity ? HUGE_VAL : cell.Scale;
  const auto startX = static_cast<float>(start.X);
  const auto startY = static_cast<float>(start.Y);
  const auto startZ = static_cast<float>(start.Z);
  RTCRay8& rays = packet.Traced.ray;
  int asked[rayPacketSize];
  for (int k = 0; k < rayPacketSize; ++k)
  {
    asked[k] = -static_cast<int>((wanted >> k) & 1u);
  }
  double directions[3][rayPacketSize];
  double ends[rayPacketSize];
  double inverses[rayPacketSize];
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const double distance = std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
    const double inverse = 1.0 / distance;
    inverses[k] = ((distance > 0.0) & (distance <= largest)) ? inverse : 0.0;
    ends[k] = scale * distance + 2.0 * OccluderCells::RayMargin;
    directions[0][k] = x[k] * inverses[k];
    directions[1][k] = y[k] * inverses[k];
    directions[2][k] = z[k] * inverses[k];
  }
  for (int k = 0; k < rayPacketSize; ++k)
  {
    packet.Valid[k] = inverses[k] > 0.0 ? asked[k] : 0;
  }
  for (int k = 0; k < rayPacketSize; ++k)
  {
    // A little longer than asked for, on both ends: the filter decides.
    rays.dir_x[k] = static_cast<float>(directions[0][k]);
    rays.dir_y[k] = static_cast<float>(directions[1][k]);
    rays.dir_z[k] = static_cast<float>(directions[2][k]);
    rays.org_x[k] = startX - margin * rays.dir_x[k];
    rays.org_y[k] = startY - margin * rays.dir_y[k];
    rays.org_z[k] = startZ - margin * rays.dir_z[k];
    rays.tnear[k] = 0.0f;
    rays.tfar[k] = static_cast<float>(ends[k]);
    rays.time[k] = 0.0f;
    rays.mask[k] = ~0u;
    rays.id[k] = RayId(rays.tfar[k], firstIndex + static_cast<unsigned int>(k));
    rays.flags[k] = 0;
  }
}

SHADOWCONES_WIDE void SetFreeRays(
  const OccluderCell& cell, const WorldRays& world, unsigned int wanted, RayPacket& packet)
{
  double begin[rayPacketSize] = {};
  double end[rayPacketSize];
  double unfit[rayPacketSize] = {}; // NaN where a ray is not a number
  for (int k = 0; k < rayPacketSize; ++k)
  {
    end[k] = world.Ends[k];
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = cell.Bounds.Min[axis];
    const double high = cell.Bounds.Max[axis];
    for (int k = 0; k < rayPacketSize; ++k)
    {
      // As in Box::Clip.
      const double o = world.Origins[axis][k];
      const double d = world.Directions[axis][k];
      const double a = (low - o) / d;
      const double b = (high - o) / d;
      const double past = ((o < low) | (o > high)) ? HUGE_VAL : -HUGE_VAL; // of a ray along the faces
      const double near = d == 0.0 ? past : a < b ? a : b;
      const double far = d == 0.0 ? HUGE_VAL : a < b ? b : a;
      begin[k] = near > begin[k] ? near : begin[k];
      end[k] = far < end[k] ? far : end[k];
      unfit[k] += (o - o) + (d - d);
    }
  }
  double starts[3][rayPacketSize];
  double ends[rayPacketSize];
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const double early = begin[k] - cell.Reach;
    const double first = (early > 0.0 ? early : 0.0) - cell.RayMargin;
    const double late = end[k] + cell.Reach;
    ends[k] = cell.Scale * ((late < world.Ends[k] ? late : world.Ends[k]) - first) + OccluderCells::RayMargin;
    starts[0][k] = cell.Scale * (world.Origins[0][k] + first * world.Directions[0][k] - cell.Center.X);
    starts[1][k] = cell.Scale * (world.Origins[1][k] + first * world.Directions[1][k] - cell.Center.Y);
    starts[2][k] = cell.Scale * (world.Origins[2][k] + first * world.Directions[2][k] - cell.Center.Z);
  }
  RTCRay8& rays = packet.Traced.ray;
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const bool enters = (begin[k] < end[k]) & (unfit[k] == 0.0);
    packet.Valid[k] = enters ? -static_cast<int>((wanted >> k) & 1u) : 0;
    rays.org_x[k] = enters ? static_cast<float>(starts[0][k]) : 0.0f;
    rays.org_y[k] = enters ? static_cast<float>(starts[1][k]) : 0.0f;
    rays.org_z[k] = enters ? static_cast<float>(starts[2][k]) : 0.0f;
    rays.dir_x[k] = enters ? static_cast<float>(world.Directions[0][k]) : 0.0f;
    rays.dir_y[k] = enters ? static_cast<float>(world.Directions[1][k]) : 0.0f;
    rays.dir_z[k] = enters ? static_cast<float>(world.Directions[2][k]) : 0.0f;
    rays.tnear[k] = 0.0f;
    rays.tfar[k] = static_cast<float>(ends[k]);
    rays.time[k] = 0.0f;
    rays.mask[k] = ~0u;
    rays.id[k] = RayId(rays.tfar[k], static_cast<unsigned int>(k));
    rays.flags[k] = 0;
    packet.Traced.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.Traced.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
}

SHADOWCONES_WIDE unsigned int BlockedRays(const RayPacket& packet)
{
  unsigned int blocked = 0;
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const int below = packet.Traced.ray.tfar[k] < 0.0f ? packet.Valid[k] : 0;
    blocked |= static_cast<unsigned int>(below) & (1u << k);
  }
  return blocked;
}

SHADOWCONES_WIDE bool FindClear(
  const RTCRay8& rays, const RTCHit8& hits, const int* valid, const ClearLimits& limits, int* clear)
{
  const ClearLimits l = limits;
  int found[rayPacketSize];
  int doubtful = 0;
  for (int k = 0; k < rayPacketSize; ++k)
  {
    const bool is = IsClear(hits.Ng_x[k], hits.Ng_y[k], hits.Ng_z[k], hits.u[k], hits.v[k], rays.tfar[k], rays.dir_x[k],
      rays.dir_y[k], rays.dir_z[k], EndOfRay(rays.id[k]), l);
    found[k] = is ? -1 : 0;
    doubtful |= valid[k] & ~found[k];
  }
  for (int k = 0; k < rayPacketSize; ++k)
  {
    clear[k] = found[k];
  }
  return doubtful != 0;
}

} // namespace shadowcones
