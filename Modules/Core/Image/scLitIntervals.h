// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitIntervals.h
 * @brief Finds the parts of camera rays in the medium that the light can reach. Internal to Core.
 */
#ifndef scLitIntervals_h
#define scLitIntervals_h

#include "scBox.h"
#include "scFlatFace.h"
#include "scLight.h"
#include "scLitInterval.h"
#include "scRay.h"

#include <cmath>

namespace shadowcones
{

/// Finds them; the light and the box must outlive it.
class LitIntervals
{
public:
  /// @param deepest length of medium behind which nothing is seen.
  LitIntervals(const Light& light, const Box& bounds, double deepest = HUGE_VAL);

  LitInterval Find(const Ray& ray) const;
  /// Between the planes of the same faces, also where the ray passes beside them: then Begin may exceed End.
  LitInterval Between(const Ray& ray, int faces) const;

private:
  void CutAtPlane(const Ray& ray, LitInterval& interval, int& first, int& exit) const;
  void CutAtSphere(const Ray& ray, LitInterval& interval, int& first, int& exit) const;
  double HalfChord(const Ray& ray) const;
  double DistanceTo(const Ray& ray, int face) const;

  const Light& Lamp;
  const Box& Bounds;
  double Deepest;
  const FlatFace Face;
};

} // namespace shadowcones

#endif
