// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityGridSampler.h
 * @brief A visibility grid laid out for walks along camera rays. Internal to Core.
 */
#ifndef scVisibilityGridSampler_h
#define scVisibilityGridSampler_h

#include "scLitPixel.h"
#include "scLitSums.h"
#include "scVisibilityGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Built once, asked often, from any number of threads. The grid must outlive it.
class VisibilityGridSampler
{
public:
  explicit VisibilityGridSampler(const VisibilityGrid& grid);

  /// A bit for each cell of LitProfileLayout where a ray between those of these four may be in shadow.
  std::uint64_t CellsInShadow(const std::array<LitPixel, 4>& pixels) const;

  /**
   * Add what is hidden of the unshadowed light of every group along the ray: the sum over its cells of the light times
   * the hidden fraction of the light source, by the midpoint rule, finer where a cell is longer than one of the grid or
   * its bricks. Where all is hidden that is all of the light, to the last bit. @param wanted bits of the cells to look
   * at.
   * @return the number of places looked at.
   */
  int Walk(const LitSums& lit, std::uint64_t wanted, std::vector<double>& hidden) const;

  /// Bytes, without the grid.
  std::int64_t Memory() const;

private:
  static constexpr int MacroSide = 4; ///< grid cells along a side of a macro cell

  /// In units of the grid: (0, 0, 0) is its first vertex.
  Vector3 ToGrid(const Vector3& point) const;
  void FindOccupied(int macroJ, int macroK);
  bool AnyHidden(const int first[3], const int last[3]) const;
  float HiddenAt(float x, float y, float z, bool& inBrick) const;
  /// A ray in units of the grid.
  struct GridRay
  {
    float Origin[3];
    float Direction[3];
    float Speed; ///< largest component of the direction
  };
  /// Mean over a part of a ray.
  float HiddenBetween(const GridRay& ray, float begin, float width, int& looks) const;

  const VisibilityGrid& Grid;
  std::array<int, 3> Cells;
  std::array<int, 3> Macros;
  Vector3 PerLength;
  std::vector<float> Hidden; ///< 1 - Visibility, a vertex
  std::vector<int> BrickOf;  ///< a cell; -1: none; empty where there are no bricks
  std::vector<float> BrickHidden;
  std::vector<unsigned char> Occupied; ///< a macro cell: 1 where anything in it is hidden
};

} // namespace shadowcones

#endif
