// SPDX-License-Identifier: BSD-3-Clause
#include "scPartCluster.h"

#include "scConstants.h"

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

} // namespace shadowcones
