// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibilityVoxels.h
 * @brief Voxels: the blocked share of the light at every vertex of a grid over the medium, by rays; a byte each, linear in between.
 */
#ifndef VisibilityVoxels_h
#define VisibilityVoxels_h

#include "LampRays.h"
#include "Rival.h"

#include "scBox.h"

#include <vector>

namespace shadowcones
{

class VisibilityVoxels : public PointRival
{
public:
  /// @param side vertices along each side; @param rays for each of them.
  VisibilityVoxels(const OccluderScene& scene, const Light& light, const Box& bounds, int side, int rays);

  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  std::int64_t Memory() const override { return static_cast<std::int64_t>(this->Blocked.size()); }

private:
  Box Bounds;
  int Side;
  std::vector<unsigned char> Blocked; ///< 255: all
};

} // namespace shadowcones

#endif
