// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityGrid.h
 * @brief The visible fraction of the light on a regular grid, evaluated only where cones reach, with finer bricks.
 */
#ifndef scVisibilityGrid_h
#define scVisibilityGrid_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scCone.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scTeam.h"
#include "scVector3.h"
#include "scVisibilityProbe.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/**
 * Values at the vertices of a regular grid, at index i + nx (j + ny k), and of finer grids inside some of its cells.
 * Between vertices they are trilinear, in a cell's brick where it has one.
 */
struct VisibilityGrid
{
  Vector3 Origin;
  Vector3 Spacing;                          ///< above 0
  std::array<int, 3> Dimensions{ 0, 0, 0 }; ///< vertices, at least 2 each; 0: no grid
  std::vector<float> Visibility;            ///< visible fraction of the light, 0..1; 1 where not marked
  std::vector<unsigned char> ShadowClasses; ///< ShadowClass; Lit where not marked
  std::vector<unsigned char> Marked;   ///< 1: asked for, as a cone reaches a cell at the vertex; not behind the light
  int BrickParts = 0;                  ///< parts into which a brick cuts its cell's sides; 0: no bricks
  std::vector<vtkIdType> BrickCells;   ///< refined cells, ascending: i + (nx - 1) (j + (ny - 1) k) of the whole grid
  std::vector<float> BrickVisibility;  ///< (BrickParts + 1)^3 values a brick, i fastest, its cell's corners among them
  std::vector<float> Fluence;          ///< at vertices that are wanted, see ArrivingLight; empty: not asked for
  std::vector<float> FluenceErrors;
  vtkIdType NumberOfOcclusionRays = 0; ///< sent to fill it, by all processes; 0 where not known
  vtkIdType NumberOfOwnRays = 0;       ///< of these, by this process

  Vector3 Vertex(int i, int j, int k) const
  {
    return this->Origin + Vector3{ i * this->Spacing.X, j * this->Spacing.Y, k * this->Spacing.Z };
  }
  std::size_t VertexIndex(int i, int j, int k) const
  {
    return static_cast<std::size_t>(this->Dimensions[0]) *
      (static_cast<std::size_t>(this->Dimensions[1]) * static_cast<std::size_t>(k) + static_cast<std::size_t>(j)) +
      static_cast<std::size_t>(i);
  }
  vtkIdType CellIndex(int i, int j, int k) const
  {
    const vtkIdType row = j + static_cast<vtkIdType>(this->Dimensions[1] - 1) * k;
    return i + static_cast<vtkIdType>(this->Dimensions[0] - 1) * row;
  }
};

/// The value at a point: trilinear, 1 outside of the grid. Looks the brick up; not for the innermost loops.
SHADOWCONESCORE_EXPORT double VisibilityAt(const VisibilityGrid& grid, const Vector3& point);

struct VisibilityGridOptions
{
  VisibilityMethod Method = VisibilityMethod::Exact;
  std::array<int, 3> Dimensions{ 65, 65, 65 }; ///< vertices along each side, at least 2; at most 2^31 - 1 in all
  int NumberOfLightSamples = 16;               ///< a vertex, 1..65536
  std::uint64_t Seed = 1;
  bool Fluence = false;                        ///< ask for it too
  int BrickParts = 2; ///< parts into which refined cells are cut along each side, 1..32; 1: nothing is refined
  /**
   * Cells whose corners differ by more than this are refined, 0..1; 1: none are. An even number of parts is reached by
   * halves, which go on only where corners still differ by more than this.
   */
  double RefinementThreshold = 0.5;
  /// Vertices that are wanted, first and last along each axis, and the bricks of cells among them; last < first: all.
  /// What is wanted does not depend on what else is.
  std::array<int, 6> Extent{ 0, -1, 0, -1, 0, -1 };
  Team* Workers = nullptr; ///< processes that fill the same grid together: each asks a share of the points, then all have it
};

/// nullptr, or what is wrong with the options.
SHADOWCONESCORE_EXPORT const char* CheckVisibilityGridOptions(const VisibilityGridOptions& options);

/**
 * Fill a grid over @p bounds. Exact sends rays from every vertex of a cell that a cone reaches, whatever its own place;
 * Soft takes the base discs as the only occluders. Samples of a vertex are a pure function of (Seed, its coordinates).
 *
 * @param cones bounds of the shadow (Exact) or discs (Soft); @param scene the occluders, without receivers; nullptr for
 * Soft; @param bounds must have a volume. @return false where aborted. Throws std::invalid_argument where the bounds
 * have none or the options are wrong.
 */
SHADOWCONESCORE_EXPORT bool FillVisibilityGrid(const std::vector<Cone>& cones, const Light& light,
  const OccluderScene* scene, const Box& bounds, const VisibilityGridOptions& options, const Monitor& monitor,
  VisibilityGrid& grid);
/// The same for each of several lights, by cones of its own.
SHADOWCONESCORE_EXPORT bool FillVisibilityGrids(const std::vector<std::vector<Cone>>& conesOf,
  const std::vector<Light>& lights, const OccluderScene* scene, const Box& bounds, const VisibilityGridOptions& options,
  const Monitor& monitor, std::vector<VisibilityGrid>& grids);

} // namespace shadowcones

#endif
