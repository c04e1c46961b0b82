// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeField.h
 * @brief The implicit function of a set of truncated cones: what their union is contoured from.
 */
#ifndef scConeField_h
#define scConeField_h

#include "ShadowConesCoreModule.h"
#include "scConeSet.h"
#include "scParallel.h"
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

/// A regular grid of points, x fastest.
struct FieldGrid
{
  Vector3 Origin;
  Vector3 Spacing;
  std::array<int, 3> Dimensions{ 0, 0, 0 };

  vtkIdType NumberOfPoints() const
  {
    return static_cast<vtkIdType>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  }
  Vector3 Point(int i, int j, int k) const
  {
    return this->Origin + Vector3{ i * this->Spacing.X, j * this->Spacing.Y, k * this->Spacing.Z };
  }
};

/**
 * Points at the centres of the cells of a box, @p resolution cells along its longest side and as many of nearly that
 * size along the others, and one layer of points around it: a field that is clipped to the box changes sign exactly at
 * its faces. A box without volume has no cells: all dimensions are 0.
 */
SHADOWCONESCORE_EXPORT FieldGrid GridOver(const Box& box, int resolution);

/**
 * Signed distance to the union of truncated cones inside a box, negative inside. Outside of every cone and inside the
 * box it is the distance to the nearest one; inside the union its size is at most the distance to the surface. It
 * changes by at most the distance between two points (Lipschitz constant 1), hence a value tells how far around it no
 * surface can be.
 */
class SHADOWCONESCORE_EXPORT ConeField
{
public:
  /**
   * Cones are cut at @p length from their base, at their tip, and where they leave @p bounds (an empty box: nowhere;
   * the length must then be finite). Cones without volume are left out.
   */
  ConeField(const std::vector<Cone>& cones, ConeBound bound, double length, const Box& bounds = {});

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
  bool Sample(const FieldGrid& grid, const Monitor& monitor, float* values) const;

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
  void SampleBlock(const FieldGrid& grid, const Block& block, const std::vector<int>& candidates, float* values) const;

  std::vector<Body> Bodies;
  Box Extent;
};

} // namespace shadowcones

#endif
