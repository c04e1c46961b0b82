// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeClusters.h
 * @brief Few cones around many parts of occluders. Internal to Core.
 */
#ifndef scConeClusters_h
#define scConeClusters_h

#include "scOccluderParts.h"

#include <vector>

namespace shadowcones
{

struct ClusterOptions
{
  Box Region;                ///< where volume counts
  int LargestNumber = 150;   ///< cones to be added at most, where their half angles allow it
  double FreeFraction = 2e-4; ///< below that number cones join where it adds at most this share to their volume
};

struct ClusterResult
{
  std::vector<Cone> Cones;              ///< the given ones, grown or not, then the added ones
  std::vector<unsigned char> Grown;     ///< one a given cone
  std::vector<OccluderPart> WithoutCone; ///< parts that no cone below largestProvedAngle holds
};

/**
 * Hold all of the parts and their shadows: they are gathered by place into small clusters, each with a cone, and clusters
 * join each other or given cones, those first whose joint cone adds least to the volume that is held, or takes most away.
 * @return false where aborted.
 */
bool HoldParts(const OccluderParts& mesh, const std::vector<OccluderPart>& parts, const std::vector<Cone>& given,
  const ClusterOptions& options, const Monitor& monitor, ClusterResult& result);

} // namespace shadowcones

#endif
