// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LampRays.h
 * @brief Rays towards the light: what the paper calls brute force, and what grids and trees are filled by.
 */
#ifndef LampRays_h
#define LampRays_h

#include "LampPoints.h"
#include "Rival.h"

#include "scLightStrata.h"
#include "scOccluderScene.h"

namespace shadowcones
{

class LampRays : public PointRival
{
public:
  /// @param count rays from a place, 1..64. The scene and the light must outlive it.
  LampRays(const OccluderScene& scene, const Light& light, int count);

  /// Fresh stratified points of the light at each place: no bias.
  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  /// The same points for every place: what is answered changes steadily from place to place.
  double BlockedOfSamePoints(const Vector3& x) const;
  std::int64_t Memory() const override { return this->Scene.Memory(); }

private:
  template <class Sample>
  double Ask(const Vector3& x, Sample&& sample) const;

  const OccluderScene& Scene;
  const Light& Lamp;
  LampPoints Points;
  LightStrata Strata;
};

} // namespace shadowcones

#endif
