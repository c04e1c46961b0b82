// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConesAround.h
 * @brief Cones with another way inside (the introduction of Hougs and Day): outside of the cones nothing is asked.
 */
#ifndef ConesAround_h
#define ConesAround_h

#include "Rival.h"

#include "scConeHierarchy.h"

#include <memory>
#include <utility>
#include <vector>

namespace shadowcones
{

class ConesAround : public PointRival
{
public:
  /// The cones must outlive it.
  ConesAround(const ConeHierarchy& cones, std::unique_ptr<const PointRival> inside)
    : Cones(cones)
    , Inside(std::move(inside))
  {
  }

  double BlockedAt(const Vector3& x, RandomStream& random) const override
  {
    return this->Cones.Contains(x) ? this->Inside->BlockedAt(x, random) : 0.0;
  }
  void BlockedAlong(const RivalRay& ray, std::vector<double>& blocked) const override
  {
    thread_local std::vector<OccluderInterval> intervals;
    blocked.assign(ray.Count(), 0.0);
    if (ray.Count() == 0)
    {
      return;
    }
    this->Cones.Intersect(ray.Line.Origin, ray.Line.Direction, ray.Cuts.front(), ray.Cuts.back(), intervals);
    std::size_t k = 0;
    for (const OccluderInterval& interval : intervals)
    {
      for (; k < ray.Count() && ray.Places[k] <= interval.End; ++k)
      {
        if (ray.Places[k] >= interval.Begin)
        {
          RandomStream random(ray.Key, k);
          blocked[k] = this->Inside->BlockedAt(ray.Place(k), random);
        }
      }
    }
  }
  std::int64_t Memory() const override { return this->Cones.Memory() + this->Inside->Memory(); }

private:
  const ConeHierarchy& Cones;
  std::unique_ptr<const PointRival> Inside;
};

} // namespace shadowcones

#endif
