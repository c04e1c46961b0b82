// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSunHours.h
 * @brief How long points are in the Sun, along the path that it takes.
 */
#ifndef scSunHours_h
#define scSunHours_h

#include "ShadowConesCoreModule.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scTeam.h"
#include "scVector3.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// A stretch of time, for all of which the Sun is taken to stand where it is in its middle.
struct SunStep
{
  Vector3 Direction;  ///< unit, towards the Sun
  double Begin = 0.0; ///< hours
  double Length = 0.0;
  bool IsUp = false; ///< else it is dark
};

struct SunHoursOptions
{
  double AngularRadius = 0.0;    ///< of the Sun's disc, radians; 0: one ray a step
  Vector3 Up;                    ///< unit; 0: there is no horizon, and all of the disc counts
  double LowestAltitude = 0.0;   ///< radians; what of the disc is lower is below the horizon
  int NumberOfLightSamples = 64; ///< of the disc, a step, at least 1
  std::uint64_t Seed = 1;
  bool FindOccluders = false; ///< takes about as long again
  Team* Workers = nullptr;    ///< processes that ask at the same points: each at a share of them, then all have all
};

/// One value a point.
struct SunHoursResult
{
  std::vector<float> Hours;     ///< sum of the visible share of the disc times the step
  std::vector<float> First;     ///< begin of the first step with any Sun; -1: none
  std::vector<float> Last;      ///< end of the last one; -1: none
  std::vector<float> Longest;   ///< most hours in steps with some Sun, one after the other
  std::vector<float> Errors;    ///< bound of what the steps leave open, see below
  std::vector<int> OccluderIds; ///< takes most hours away, the smallest of several; -1: none does. Empty: not asked
};

/**
 * Ask at @p count points (3 values each) with normals (3 values each, any length; 0: no normal) or nullptr: light from
 * below a surface is hidden by it. A triangle in whose plane a point lies hides nothing from it, see VisibilityProbe.
 *
 * Rays of one point go out in packets; those of a hard Sun in the order of a Hilbert curve over their directions, so
 * that the rays of a year lie close together in them. A triangle that hid all of a packet is asked first for the next
 * one: where it covers the whole bundle of directions, by a margin, no ray is sent. Sums are taken in the order of
 * time. A disc is sampled alike at all steps, by a pattern that is a pure function of (Seed, the point's coordinates).
 *
 * Errors: between the middles of two steps with visible shares a and b the share was somewhere between them, if it went
 * one way only; then what was counted is off by no more than |a - b| times half a step. The bound is the sum of these.
 * It knows nothing of shadows that come and go between two middles, of Begin and End, nor of the sampling of the disc.
 *
 * @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ComputeSunHours(const OccluderScene& scene, const std::vector<SunStep>& steps,
  const double* points, const double* normals, vtkIdType count, const SunHoursOptions& options, const Monitor& monitor,
  SunHoursResult& result);

} // namespace shadowcones

#endif
