// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDensityGrid.h
 * @brief The density of an inhomogeneous medium: values on a regular grid that may be turned in space.
 */
#ifndef scDensityGrid_h
#define scDensityGrid_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scTrilinear.h"
#include "scVector3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// The density along a part of a ray that lies in one cell, where it is a cubic.
struct DensityStretch
{
  double Begin = 0.0;                        ///< t of the ray
  double OpticalDepth = 0.0;                 ///< up to there
  std::array<double, 4> Cubic{ { 0.0, 0.0, 0.0, 0.0 } }; ///< times powers of the length from there on

  double DensityAfter(double s) const
  {
    return this->Cubic[0] + s * (this->Cubic[1] + s * (this->Cubic[2] + s * this->Cubic[3]));
  }
  double DepthAfter(double s) const
  {
    return this->OpticalDepth +
      s * (this->Cubic[0] + s * (0.5 * this->Cubic[1] + s * (this->Cubic[2] / 3.0 + s * 0.25 * this->Cubic[3])));
  }
};

/**
 * Density relative to SigmaS and SigmaA of the medium: trilinear between grid points, 0 outside the grid. An axis with a
 * single point is no limit: the density is constant along it.
 */
struct DensityGrid
{
  std::array<int, 3> Dimensions{ { 0, 0, 0 } };
  std::vector<float> Values;   ///< one a point, i fastest; finite and >= 0
  Vector3 Origin;              ///< of point (0, 0, 0), world
  std::array<Vector3, 3> Axes; ///< world step from a point to the next along i, j and k; linearly independent

  /// @name Filled by PrepareDensityGrid()
  ///@{
  std::array<Vector3, 3> ToIndex;                    ///< index coordinate a of x is Dot(ToIndex[a], x - Origin)
  std::array<std::size_t, 3> Strides{ { 0, 0, 0 } }; ///< from a value to the next; 0 along an axis with a single point
  Box Support; ///< index coordinates outside of which the density is 0; empty where it is 0 everywhere
  ///@}

  Vector3 IndexDirection(const Vector3& direction) const
  {
    return { Dot(this->ToIndex[0], direction), Dot(this->ToIndex[1], direction), Dot(this->ToIndex[2], direction) };
  }
  Vector3 IndexPoint(const Vector3& point) const { return this->IndexDirection(point - this->Origin); }

  /// Trilinear value at index coordinates; those outside the grid are moved to its border.
  double ValueAt(const Vector3& index) const;
  /// The density at a world point.
  double At(const Vector3& point) const
  {
    const Vector3 index = this->IndexPoint(point);
    return this->Support.Contains(index) ? this->ValueAt(index) : 0.0;
  }
  /// Integral of the density along the ray from @p tBegin to @p tEnd: exact, cell by cell.
  SHADOWCONESCORE_EXPORT double Integrate(
    const Vector3& origin, const Vector3& direction, double tBegin, double tEnd) const;
  /**
   * The same as a table of the ray's part where the density is not 0, ascending: places without any are one stretch. The last
   * has no length and holds the whole depth; it is the only one where the ray meets no density.
   */
  SHADOWCONESCORE_EXPORT void Tabulate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd,
    std::vector<DensityStretch>& stretches) const;
};

/// Check a grid and fill what is computed once. @return nullptr, or a sentence that says what is wrong.
SHADOWCONESCORE_EXPORT const char* PrepareDensityGrid(DensityGrid& grid);

/// Has a prepared grid one value all over the box?
SHADOWCONESCORE_EXPORT bool IsConstantIn(const DensityGrid& grid, const Box& box, double& value);

inline double DensityGrid::ValueAt(const Vector3& index) const
{
  std::size_t first = 0;
  double fraction[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Dimensions[static_cast<std::size_t>(axis)] - 1;
    const double x = std::min(std::max(index[axis], 0.0), static_cast<double>(last));
    const int cell = std::max(std::min(static_cast<int>(x), last - 1), 0);
    fraction[axis] = x - cell;
    first += static_cast<std::size_t>(cell) * this->Strides[static_cast<std::size_t>(axis)];
  }
  return Trilinear(this->Values.data() + first, this->Strides[0], this->Strides[1], this->Strides[2], fraction[0],
    fraction[1], fraction[2]);
}

} // namespace shadowcones

#endif
