// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumSpan.h
 * @brief The part of a camera ray in the medium that the light can reach. Internal to Core.
 */
#ifndef scMediumSpan_h
#define scMediumSpan_h

#include "scCamera.h"
#include "scLampPlane.h"
#include "scLight.h"

#include <cmath>

namespace shadowcones
{

/**
 * The part of a camera ray in the medium that the light can reach and the camera can see: inside the box, not too deep,
 * on the side to which a flat light emits, outside of a sphere.
 */
struct MediumSpan
{
  double Begin = 0.0;
  double End = 0.0;         ///< not above Begin: there is no such part
  double MediumBegin = 0.0; ///< where the ray enters the box: attenuation counts from here
  bool HasGap = false;      ///< a sphere that emits lies in between
  double HalfGap = 0.0;     ///< half the length in it, about the ray's point nearest to its centre
  int Faces = -1;           ///< the same number: neighbouring rays change smoothly from one to the other; -1: no part

  bool Empty() const { return !(this->End > this->Begin); }
};

/// Finds spans; the light and the box must outlive it.
class MediumSpans
{
public:
  /// @param deepest length of medium behind which nothing is seen.
  MediumSpans(const Light& light, const Box& bounds, double deepest = HUGE_VAL);

  MediumSpan Find(const Ray& ray) const;
  /// Between the planes of the same faces, also where the ray passes beside them: then Begin may exceed End.
  MediumSpan Between(const Ray& ray, int faces) const;

private:
  double HalfChord(const Ray& ray) const;
  double DistanceTo(const Ray& ray, int face) const;

  const Light& Source;
  const Box& Bounds;
  double Deepest;
  const FlatFace Face;
};

} // namespace shadowcones

#endif
