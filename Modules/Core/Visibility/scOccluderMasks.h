// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderMasks.h
 * @brief Which samples of a light each occluder hides from a point. Internal to Core.
 */
#ifndef scOccluderMasks_h
#define scOccluderMasks_h

#include "scLightPatterns.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Light samples that each occluder hides from one point; reused from point to point. One a thread.
struct OccluderMasks
{
  std::size_t NumberOfBlocks = 0;
  std::vector<int> OccluderIds;
  LightMask Words; ///< NumberOfBlocks an occluder
  std::size_t Last = 0;

  void Reset(std::size_t numberOfBlocks)
  {
    this->NumberOfBlocks = numberOfBlocks;
    this->OccluderIds.clear();
    this->Words.clear();
  }
  /// The words of an occluder, added where it is new.
  std::uint64_t* Of(int occluderId)
  {
    // The last one first: neighbours in a tree mostly belong to the same occluder.
    std::size_t i = this->Last;
    if (i >= this->OccluderIds.size() || this->OccluderIds[i] != occluderId)
    {
      i = 0;
      while (i < this->OccluderIds.size() && this->OccluderIds[i] != occluderId)
      {
        ++i;
      }
      if (i == this->OccluderIds.size())
      {
        this->OccluderIds.push_back(occluderId);
        this->Words.resize(this->Words.size() + this->NumberOfBlocks, 0);
      }
      this->Last = i;
    }
    return this->Words.data() + i * this->NumberOfBlocks;
  }
};

} // namespace shadowcones

#endif
