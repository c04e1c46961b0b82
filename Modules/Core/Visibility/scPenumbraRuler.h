// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPenumbraRuler.h
 * @brief How wide a penumbra is: the distance between two values of the visible fraction, across an edge or along a line.
 */
#ifndef scPenumbraRuler_h
#define scPenumbraRuler_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scCone.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scVector3.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

struct PenumbraWidthOptions
{
  double Lower = 0.05; ///< visible fractions between which it is measured, 0 < Lower < Upper < 1
  double Upper = 0.95;
  int NumberOfLightSamples = 256; ///< at least 1
  std::uint64_t Seed = 1;
  double MaximumWidth = 1.0; ///< world units: how far from a point an end is looked for
  int SamplesPerLine = 256;  ///< places along a line that are looked at for edges, at least 2
};

/// An edge of a shadow, measured.
struct PenumbraEdge
{
  double Width = 0.0;  ///< world units; 0 or below: there is none
  double Error = 0.0;  ///< of the two fractions' standard errors, world units
  int OccluderId = -1; ///< that hides most of the light half way
  Vector3 Dark;        ///< where the visible fraction is Lower
  Vector3 Bright;      ///< where it is Upper
  double From = 0.0;   ///< on a line: the lengths along it at which the edge begins and ends
  double To = 0.0;
};

/// What is seen at a place itself.
struct PenumbraPlace
{
  double Visibility = 1.0;
  int OccluderId = -1;
  PenumbraEdge Edge;
};

/**
 * Every place takes the same samples of the light, so that the visible fraction changes steadily along a way; the ends of
 * a width are found by halving on it. Built once, used from any number of threads.
 */
class SHADOWCONESCORE_EXPORT PenumbraRuler
{
public:
  /**
   * @param cones that hold the shadow; @param scene the occluders, without receivers; must outlive the ruler; @param bounds of
   * the places with MaximumWidth around them: outside, all is lit.
   */
  PenumbraRuler(const std::vector<Cone>& cones, const Light& light, const OccluderScene& scene, const Box& bounds,
    const PenumbraWidthOptions& options);
  ~PenumbraRuler();
  PenumbraRuler(const PenumbraRuler&) = delete;
  PenumbraRuler& operator=(const PenumbraRuler&) = delete;

  /// What is seen at a point, without a width. @param normal light from below it is hidden; or nullptr.
  PenumbraPlace Look(const Vector3& point, const Vector3* normal) const;

  /**
   * Across the edge that a point lies in whose visible fraction is from Lower to Upper: along the gradient of the
   * fraction in the plane through the point with this normal (unit), until Upper one way and Lower the other. No edge
   * where the fraction of the point is another one, where it turns back on the way, or gets nowhere within MaximumWidth.
   * @param facing light from below the plane is hidden by it.
   */
  PenumbraPlace At(const Vector3& point, const Vector3& normal, bool facing) const;

  /// All edges that a polyline crosses, in their order along it.
  std::vector<PenumbraEdge> Along(const std::vector<Vector3>& line) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

} // namespace shadowcones

#endif
