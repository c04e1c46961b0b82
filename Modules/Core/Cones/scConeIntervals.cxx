// SPDX-License-Identifier: BSD-3-Clause
#include "scConeIntervals.h"

#include "scConeSlice.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

bool IntersectCone(const Cone& cone, double length, const Ray& ray, const RayInterval& part, OccluderInterval& interval)
{
  const double tangent = std::tan(cone.HalfAngle);
  const ConeSlice slice{ cone, tangent, 0.0, std::min(length, TipHeight(cone.BaseRadius, tangent)) };
  interval.OccluderId = cone.OccluderId;
  return slice.Intersect(ray, part, interval);
}

void MergeIntervals(std::vector<OccluderInterval>& intervals, bool perOccluder)
{
  if (!perOccluder)
  {
    for (OccluderInterval& interval : intervals)
    {
      interval.OccluderId = -1;
    }
  }
  std::sort(intervals.begin(), intervals.end(),
    [](const OccluderInterval& a, const OccluderInterval& b)
    { return a.OccluderId != b.OccluderId ? a.OccluderId < b.OccluderId : a.Begin < b.Begin; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < intervals.size(); ++i)
  {
    if (intervals[i].OccluderId == intervals[last].OccluderId && intervals[i].Begin <= intervals[last].End)
    {
      intervals[last].End = std::max(intervals[last].End, intervals[i].End);
    }
    else
    {
      intervals[++last] = intervals[i];
    }
  }
  intervals.resize(intervals.empty() ? 0 : last + 1);
  if (perOccluder)
  {
    std::stable_sort(intervals.begin(), intervals.end(),
      [](const OccluderInterval& a, const OccluderInterval& b) { return a.Begin < b.Begin; });
  }
}

} // namespace shadowcones
