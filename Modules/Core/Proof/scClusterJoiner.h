// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scClusterJoiner.h
 * @brief Clusters of parts joined to few. Internal to Core.
 */
#ifndef scClusterJoiner_h
#define scClusterJoiner_h

#include "scCone.h"
#include "scConeClusters.h"
#include "scOccluderParts.h"
#include "scParallel.h"
#include "scPartCluster.h"

#include <vector>

namespace shadowcones
{

/// Join clusters, those first whose joint cone adds least to the volume held. @return false where aborted.
bool JoinClusters(const OccluderParts& mesh, const std::vector<Cone>& given, const ClusterOptions& options,
  const Monitor& monitor, std::vector<PartCluster>& clusters);

} // namespace shadowcones

#endif
