// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScarceOccluders.h
 * @brief Which occluders the photons of a scene hardly meet, and the boxes to aim more photons at. Internal to Core.
 */
#ifndef scScarceOccluders_h
#define scScarceOccluders_h

#include "scCasterBoxes.h"

#include <vector>

namespace shadowcones
{

/// A box around one occluder, or around several near each other.
struct ScarceOccluders
{
  std::vector<int> Ids; ///< ascending
  Box Bounds;           ///< with a margin, through which light passes beside them
};

/**
 * Boxes around the occluders whose entries in @p scarce are true: one each, or where there are more than @p most around groups
 * of neighbours. From small to large.
 */
std::vector<ScarceOccluders> BoxesToAimAt(
  const CasterBoxes& casters, const std::vector<bool>& scarce, std::size_t most);

} // namespace shadowcones

#endif
