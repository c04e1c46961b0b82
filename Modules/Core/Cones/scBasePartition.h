// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBasePartition.h
 * @brief The base disc around a seed: rings and sectors in the fitted plane (section 3.2.1). Internal to Core.
 */
#ifndef scBasePartition_h
#define scBasePartition_h

#include "scConeSet.h"
#include "scShadowVectorView.h"

#include <vector>

namespace shadowcones
{

struct BasePartition
{
  Vector3 Center;                 ///< the seed
  Vector3 Normal;                 ///< unit, of the fitted plane, on the side of the mean direction
  double Radius = 0.0;            ///< of the last ring that was accepted, in the plane
  double RmsHeight = 0.0;         ///< rms distance of the members from the plane
  std::vector<vtkIdType> Members; ///< vectors inside, the seed first, then outward; empty: no ring was accepted
};

/**
 * Project the neighbours (the seed first) along their mean direction onto the plane fitted to them; go outward ring by ring
 * (PointsPerRing vectors each) until the counts in the sectors vary too much or the ring leaves the plane.
 */
void PartitionBase(const ShadowVectorView& vectors, const std::vector<vtkIdType>& neighbors,
  const ConeSetOptions& options, BasePartition& base);

/// Unit mean of the directions of the vectors @p ids.
Vector3 MeanDirection(const ShadowVectorView& vectors, const std::vector<vtkIdType>& ids);

} // namespace shadowcones

#endif
