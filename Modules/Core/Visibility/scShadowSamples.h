// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowSamples.h
 * @brief Points of a light whose rays tell whether a place sees anything of it. Internal to Core.
 */
#ifndef scShadowSamples_h
#define scShadowSamples_h

#include "scLight.h"
#include "scOccluderScene.h"
#include "scShaft.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/**
 * The same points for every place, so that what is found changes only where the shadow of one of them ends: corners, or
 * the corners of a polygon of 32 sides drawn around a round light; and scrambled Sobol points inside. A straight edge thus
 * never shows light where no point does. Not an estimate: all points count alike.
 */
class ShadowSamples
{
public:
  /// @param inside points beside those that span the light.
  ShadowSamples(const Light& light, int inside, const OccluderScene& scene);

  int Count() const { return this->NumberOfSamples; }

  /// Does no point of the light that shines to the place hide? Both false where none shines there.
  struct Answer
  {
    bool AnyVisible = false;
    bool AnyHidden = false;
    int FirstVisible = -1;
  };
  /// Everything that is asked for by @p whole; else it ends at the first that is visible.
  Answer Ask(const Vector3& place, bool whole) const;
  /// Does this point of the light hide, or not shine there?
  bool IsHidden(const Vector3& place, int sample) const;
  /// Is the ray to a part of the light hidden? One of its points tells.
  bool IsHidden(const Vector3& place, const LightBody& part) const;

private:
  Vector3 Way(const Vector3& place, int sample) const;
  std::uint64_t LookAt(const Vector3& place, int block, double* x, double* y, double* z) const;
  void AddSpan(const Light& light);
  void AddCorners(const Light& light);
  void Add(const Vector3& position, const Vector3& normal);
  bool HidesRay(const Vector3& place, const Vector3& to) const;

  const OccluderScene& Scene;
  RayRules Rules;
  int NumberOfSamples = 0;
  bool AtInfinity = false;
  bool OfBall = false; ///< Positions are places on the unit disc, X and Y, seen from each place anew
  Vector3 Center;
  double Radius = 0.0;
  std::vector<Vector3> Positions; ///< at infinity: unit ways
  std::vector<Vector3> Normals;   ///< zero: it shines all around
};

} // namespace shadowcones

#endif
