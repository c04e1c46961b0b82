// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scUmbraField.h
 * @brief The implicit function of what base discs together put in full shadow.
 */
#ifndef scUmbraField_h
#define scUmbraField_h

#include "scConeDistanceField.h"
#include "scLight.h"
#include "scRegularGrid.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/**
 * At a point, for each of some points of the light, the distance from the nearest rim of the discs to the place where
 * the segment between the two crosses their plane, negative inside; of these the largest. Negative where each of these
 * points is hidden by one disc or another, 0 where the first of them comes into view.
 */
class SHADOWCONESCORE_EXPORT UmbraField
{
public:
  /// Cones are cut at @p length from their base and to @p bounds (an empty box: not at all).
  UmbraField(const std::vector<Cone>& cones, const Light& light, double length, const Box& bounds = {});

  /// The box around what any disc can shade, within the bounds.
  const Box& Region() const { return this->Extent; }

  /// The field at a point, by a look at every disc and every point of the light.
  double Value(const Vector3& point) const;

  /**
   * The field at the points of a grid, clipped to @p region; values farther than two cells from 0 are cut off. @return
   * false where aborted.
   */
  bool Sample(const RegularGrid& grid, const Box& region, const Monitor& monitor, float* values) const;

  /// The box around the umbra within a box, to about a cell of a grid of @p resolution; empty where none is found, or
  /// aborted.
  Box Find(const Box& region, int resolution, const Monitor& monitor) const;

private:
  struct Disc
  {
    Vector3 Center;
    Vector3 Axis;
    double Radius;
    double Height; ///< cut
  };
  /// A point of the light, or with Scale 0 a direction towards it.
  struct PointOfLight
  {
    Vector3 Position;
    double Scale;
  };
  /// Where to look first: it changes no value.
  struct Memory
  {
    using Nearest = std::array<int, 16>; ///< the nearest first; -1: none
    std::size_t PointOfLight = 0;        ///< that decided at the point before
    std::vector<Nearest> Discs;          ///< for each point of the light
  };
  struct Blocks;
  static double DistanceFromRim(const Vector3& point, const PointOfLight& lit, const Disc& disc);
  void Remember(const Vector3& middle, const std::vector<int>& candidates, Memory& memory) const;
  double Value(const Vector3& point, const std::vector<int>& candidates, double largest, Memory& memory) const;
  std::vector<int> Near(const RegularGrid& grid, const Blocks& blocks, const std::vector<int>& candidates) const;
  void SampleBlocks(const RegularGrid& grid, const Box& region, const Blocks& blocks, const std::vector<int>& candidates,
    float* values) const;

  std::vector<Disc> Discs;
  std::vector<PointOfLight> Points;
  std::vector<ConeDistanceField> Penumbrae; ///< of each disc: what it can shade
  Box Extent;
};

} // namespace shadowcones

#endif
