// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShapeOfMesh.h
 * @brief Whether an exact light shape and the mesh that goes with it are the same thing.
 */
#ifndef scShapeOfMesh_h
#define scShapeOfMesh_h

#include "ShadowConesCoreModule.h"
#include "scLight.h"

namespace shadowcones
{

/// How far a mesh is from an exact shape.
struct ShapeMisfit
{
  double Distance = 0.0; ///< of the corner that is farthest from the shape
  /// Area of the mesh on the emitting side over that of a whole mesh with as many corners on the rim (Sphere: the solid
  /// angle that it fills from the centre over that of all directions): less where a part is missing, negative inside
  /// out.
  double Fraction = 1.0;
};

/**
 * Hold the triangles of a mesh against a Disc (a regular polygon with its corners on the rim, cut in any way), a
 * Rectangle (cut in any way) or a Sphere (any closed mesh with its corners on it). @param tolerance by how much corners
 * may be off.
 */
SHADOWCONESCORE_EXPORT ShapeMisfit MisfitOf(
  const Light& shape, const std::vector<std::array<Vector3, 3>>& triangles, double tolerance);

/// Nothing is off by more than the tolerance.
SHADOWCONESCORE_EXPORT bool IsFit(const Light& shape, const ShapeMisfit& misfit, double tolerance);

/**
 * The Disc, Rectangle or Sphere that fits the triangles, where there is one: that of a mesh that was moved, turned or
 * scaled as a whole. @p shape tells the kind, and receives place and size.
 */
SHADOWCONESCORE_EXPORT bool FindShape(
  const std::vector<std::array<Vector3, 3>>& triangles, double tolerance, Light& shape);

} // namespace shadowcones

#endif
