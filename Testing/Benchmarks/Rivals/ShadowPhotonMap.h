// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowPhotonMap.h
 * @brief Shadow photons (Jensen and Christensen 1995), lifted from surfaces into the medium.
 *
 * There a photon is stored on the first surface of a path and shadow photons, of negative power, on all further ones; the
 * nearest photons of a place tell what share of its light is blocked, and rays are sent only where they disagree. A medium has no
 * surfaces: photons are left at random places along the path's part in it, the same number on each, with its length as a factor of
 * their power; behind the first hit they are shadow photons.
 */
#ifndef ShadowPhotonMap_h
#define ShadowPhotonMap_h

#include "LampRays.h"
#include "Rival.h"

#include "scBox.h"
#include "scPointTree.h"

#include <memory>
#include <vector>

namespace shadowcones
{

struct ShadowPhotonOptions
{
  vtkIdType Paths = 50000;
  int PointsOfPath = 8;
  int Neighbors = 24;
  int Rays = 0; ///< sent where neighbours disagree; 0: their share is the answer
};

class ShadowPhotonMap : public PointRival
{
public:
  ShadowPhotonMap(const OccluderScene& scene, const Light& light, const Box& bounds, const ShadowPhotonOptions& options);

  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  std::int64_t Memory() const override;

private:
  int Neighbors;
  bool AsksRays;
  LampRays Lamp;
  std::vector<Vector3> Points; ///< until the tree is built
  std::vector<float> Powers;   ///< negative: a shadow photon
  std::unique_ptr<PointTree> Tree;
};

} // namespace shadowcones

#endif
