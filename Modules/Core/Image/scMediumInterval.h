// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumInterval.h
 * @brief The part of a camera ray inside the medium. Internal to Core.
 */
#ifndef scMediumInterval_h
#define scMediumInterval_h

#include "scBox.h"
#include "scOccluderScene.h"
#include "scPrimaryHit.h"
#include "scRay.h"
#include "scRayInterval.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

/// The part of a camera ray inside the medium's bounds, up to the first surface.
struct MediumInterval : RayInterval
{
  bool Crosses = false;
  double EndOfMarch = 0.0; ///< a little before a surface: an occlusion ray would start on the wrong side of it

  double Length() const { return this->Crosses ? this->End - this->Begin : 0.0; }
};

inline MediumInterval MediumIntervalOf(
  const Box& bounds, const OccluderScene& occluders, const Ray& ray, const PrimaryHit& hit)
{
  MediumInterval interval;
  interval.End = hit.T;
  interval.Crosses = bounds.Clip(ray.Origin, ray.Direction, interval.Begin, interval.End);
  interval.EndOfMarch = interval.End;
  if (interval.Crosses && hit.HasSurface() && interval.End >= hit.T)
  {
    const double cosine = std::fabs(Dot(ray.Direction, occluders.TriangleNormal(hit.Triangle)));
    const double gap = 4.0 * RoundingAlong(ray.Origin, hit.T) / std::max(cosine, 0.01);
    interval.EndOfMarch = std::max(interval.End - gap, 0.5 * (interval.Begin + interval.End));
  }
  return interval;
}

} // namespace shadowcones

#endif
