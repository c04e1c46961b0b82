// SPDX-License-Identifier: BSD-3-Clause
#include "scPartCluster.h"

#include "scConstants.h"
#include "scFrame.h"

#include <cmath>
#include <map>

namespace shadowcones
{

void KeepOutermost(std::vector<HeldPoint>& points)
{
  if (points.size() <= mostHeldPoints)
  {
    return;
  }
  std::vector<unsigned char> kept(points.size(), 0);
  std::map<int, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    groups[points[i].Part].push_back(i);
  }
  for (const auto& group : groups)
  {
    for (int d = 0; d < 27; ++d)
    {
      const Vector3 along{ d % 3 - 1.0, d / 3 % 3 - 1.0, d / 9 - 1.0 };
      std::size_t best = group.second.front();
      for (const std::size_t i : group.second)
      {
        best = Dot(points[i].Point, along) > Dot(points[best].Point, along) ? i : best;
      }
      kept[best] = 1;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (kept[i])
    {
      points[count++] = points[i];
    }
  }
  points.resize(count);
}

double VolumeIn(const Box& region, const Cone& cone)
{
  double begin = 0.0;
  double end = HUGE_VAL;
  const double length = region.Clip(cone.Center, cone.Axis, begin, end) ? end : region.Diagonal();
  const double slope = length * std::tan(cone.HalfAngle);
  return Pi * length * (cone.BaseRadius * (cone.BaseRadius + slope) + slope * slope / 3.0);
}

void TurnAxis(
  const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points, const Box& region, Cone& cone)
{
  constexpr int rounds = 4;
  double least = VolumeIn(region, cone);
  double step = 0.25 * std::tan(cone.HalfAngle);
  for (int round = 0; round < rounds; ++round, step *= 0.5)
  {
    const Vector3 axis = cone.Axis;
    const Frame frame = FrameAround(axis);
    for (const Vector3& aside : { frame.U, -1.0 * frame.U, frame.V, -1.0 * frame.V })
    {
      Cone turned = cone;
      if (ConeAlong(Normalized(axis + step * aside), parts, points, nullptr, turned) &&
        VolumeIn(region, turned) < least)
      {
        least = VolumeIn(region, turned);
        cone = turned;
      }
    }
  }
}

} // namespace shadowcones
