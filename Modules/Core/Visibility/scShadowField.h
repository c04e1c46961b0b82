// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowField.h
 * @brief Which places see all of a light, and which see nothing of it: what solids of true visibility are contoured from.
 */
#ifndef scShadowField_h
#define scShadowField_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scRegularGrid.h"

#include <array>
#include <memory>
#include <vector>

namespace shadowcones
{

/// Which of the two solids of a shadow.
enum class ShadowBound : int
{
  Outer = 0, ///< some of the light is hidden: penumbra and umbra
  Inner = 1  ///< all of it is: the umbra
};

/// Where a surface crosses the edge between two neighbours of a grid.
struct GridCrossing
{
  vtkIdType Inside = 0; ///< the point of the grid inside the solid
  vtkIdType Outside = 0;
  double Fraction = 0.5; ///< of the way from the one to the other
};

/// Crossings, and triangles between them whose normals point out of the solid.
struct GridSurface
{
  std::vector<GridCrossing> Crossings;
  std::vector<std::array<vtkIdType, 3>> Triangles;

  Vector3 PointOf(const RegularGrid& grid, const GridCrossing& crossing) const;
};

/**
 * Built once for a light and its casters, queried from any number of threads.
 *
 * Outer: a place belongs to it where any caster reaches into the convex hull of the place and of the light: a fact of geometry,
 * however small the caster and whatever the light's shape. Inner: where none of the light's points sees the place; they are the
 * corners of a polygon drawn around the light, so that no straight edge lets light through between them, and points inside it.
 * A gap in the casters through which fewer than one of these points is seen may be missed. Lights that are points, and Suns
 * without width, are asked for by the one ray to each. Places that the light does not shine to, behind a lamp of one side, belong
 * to neither.
 *
 * Blocks of places are looked at as a whole first: where no edge that could end a shadow lies between them and the light they
 * are all alike, for sure.
 */
class SHADOWCONESCORE_EXPORT ShadowField
{
public:
  /// @param samples points inside the light, beside those around it. The scene must outlive the field. Throws std::invalid_argument for
  /// a Sun wider than 171 degrees.
  ShadowField(const OccluderScene& scene, const Light& light, int samples);
  ~ShadowField();
  ShadowField(const ShadowField&) = delete;
  ShadowField& operator=(const ShadowField&) = delete;

  bool Contains(const Vector3& place, ShadowBound bound) const;

  /**
   * A box inside @p region that holds what of the solid lies there, empty where nothing does or aborted: of Outer all of it,
   * of Inner all that a grid of half the resolution meets.
   */
  Box Find(const Box& region, ShadowBound bound, int resolution, const Monitor& monitor) const;

  /**
   * Which points of a grid belong to the solid: 1, else 0; the outermost layer does not. Where light passes between two points
   * of Inner that are both in full shadow the first of them is taken out: gaps down to about half a cell stay open.
   * @return false where aborted.
   */
  bool Classify(const RegularGrid& grid, ShadowBound bound, const Monitor& monitor, unsigned char* inside) const;

  /**
   * Move the crossings of a surface along their edges to where the solid ends, to a thousandth of a cell; then those of
   * triangles whose middle lies beyond its end (of Inner), or before it (of Outer), until it does not. Crossings of the outermost
   * layer stay at the middle, which is the face of the box that the grid was laid over.
   * @return false where aborted.
   */
  bool Place(const RegularGrid& grid, ShadowBound bound, const Monitor& monitor, GridSurface& surface) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

/**
 * A box that holds all shadow of casters in a box, up to @p length behind them.
 */
SHADOWCONESCORE_EXPORT Box ShadowReach(const Box& casters, const Light& light, double length);

} // namespace shadowcones

#endif
