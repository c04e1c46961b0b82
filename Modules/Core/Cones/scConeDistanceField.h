// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeDistanceField.h
 * @brief The implicit function of a set of truncated cones: what their union is contoured from.
 */
#ifndef scConeDistanceField_h
#define scConeDistanceField_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scCone.h"
#include "scParallel.h"
#include "scRegularGrid.h"
#include "scVector3.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// Which of a cone's two angles counts.
enum class ConeBound : int
{
  Outer = 0, ///< HalfAngle: the bound of the penumbra
  Inner = 1  ///< InnerHalfAngle: the umbra of the base disc
};

/**
 * Signed distance to the union of truncated cones inside a box, negative inside. Outside of every cone and inside the
 * box it is the distance to the nearest one; inside the union its size is at most the distance to the surface. It
 * changes by at most the distance between two points (Lipschitz constant 1), hence a value tells how far around it no
 * surface can be.
 */
class SHADOWCONESCORE_EXPORT ConeDistanceField
{
public:
  /**
   * Cones are cut at @p length from their base, at their tip, and where they leave @p bounds (an empty box: nowhere;
   * the length must then be finite). Cones without volume are left out.
   */
  ConeDistanceField(const std::vector<Cone>& cones, ConeBound bound, double length, const Box& bounds = {});

  /// The box around the cut cones, within the bounds; empty where no cone has a volume there.
  const Box& Region() const { return this->Extent; }

  /// The field at a point, by a look at every cone.
  double Distance(const Vector3& point) const;

  /**
   * The field at the points of a grid: @p values receives grid.NumberOfPoints() of them. Wherever two neighbours differ
   * in sign, and at every point nearer to the surface than a cell's diagonal, the value is that of Distance();
   * elsewhere its sign is. Cones that cannot be the nearest of a block of points are left out of it, and blocks far
   * from the surface are filled.
   * @return false where aborted.
   */
  bool Sample(const RegularGrid& grid, const Monitor& monitor, float* values) const;

private:
  /// A truncated cone as it is measured against.
  struct Body
  {
    Vector3 Center;
    Vector3 Axis;
    double Height;
    double BaseRadius;
    double EndRadius;
    Vector3 Side; ///< X, Y: unit vector (outward, along the axis) along the side; Z: its length
  };
  struct Block;

  static double DistanceTo(const Body& body, const Vector3& point);
  double Clip(const Vector3& point, double distance) const;
  void SampleBlock(
    const RegularGrid& grid, const Block& block, const std::vector<int>& candidates, float* values) const;

  std::vector<Body> Bodies;
  Box Extent;
};

} // namespace shadowcones

#endif
