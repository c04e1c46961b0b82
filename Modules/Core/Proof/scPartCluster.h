// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPartCluster.h
 * @brief Parts of occluders that share a cone. Internal to Core.
 */
#ifndef scPartCluster_h
#define scPartCluster_h

#include "scBoundingCone.h"
#include "scBox.h"
#include "scCone.h"
#include "scVolumeSample.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Parts that are to have one cone, or a given cone and parts that it is to hold as well.
struct PartCluster
{
  std::vector<int> Parts;
  std::vector<HeldPoint> Held; ///< outermost points of the parts
  int Given = -1;              ///< index of a given cone
  int Occluder = 0;
  Cone Bound;
  VolumeSample::Mask Points;
  double Volume = 0.0;
  bool Alive = true;
  std::vector<int> Neighbors;

  Vector3 Middle() const
  {
    Box box;
    for (const HeldPoint& held : this->Held)
    {
      box.Add(held.Point);
    }
    return box.Empty() ? this->Bound.Center : box.Center();
  }
};

/// Points that stand for a cluster while clusters join.
constexpr std::size_t mostHeldPoints = 40;

/// Keep the points that lie farthest along some directions, for each part of the light.
void KeepOutermost(std::vector<HeldPoint>& points);

/// Volume of a cone from its base to where its axis leaves the region.
double VolumeIn(const Box& region, const Cone& cone);

/// Turn the axis of a cone around the points, one without a core, while that makes it hold less of the region.
void TurnAxis(
  const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points, const Box& region, Cone& cone);

} // namespace shadowcones

#endif
