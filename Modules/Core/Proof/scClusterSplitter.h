// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scClusterSplitter.h
 * @brief Parts of occluders cut into small clusters. Internal to Core.
 */
#ifndef scClusterSplitter_h
#define scClusterSplitter_h

#include "scBox.h"
#include "scOccluderParts.h"
#include "scPartCluster.h"

#include <vector>

namespace shadowcones
{

/**
 * Cut the parts into at most @p number small clusters (more where a cone would be too wide) by light, occluder and place, the
 * one whose cone is largest first. @param withoutCone receives the parts that no cone below largestProvedAngle holds.
 */
std::vector<PartCluster> SplitIntoClusters(const OccluderParts& mesh, const std::vector<OccluderPart>& parts,
  const Box& region, int number, std::vector<OccluderPart>& withoutCone);

} // namespace shadowcones

#endif
