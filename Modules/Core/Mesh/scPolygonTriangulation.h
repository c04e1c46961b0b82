// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPolygonTriangulation.h
 * @brief The one rule by which polygons of meshes and lights become triangles.
 */
#ifndef scPolygonTriangulation_h
#define scPolygonTriangulation_h

#include "ShadowConesCoreModule.h"
#include "scVector3.h"

#include <vector>

namespace shadowcones
{

/**
 * Triangles of one polygon, as indices into its corners, three each, wound as the polygon is. Right for every simple
 * polygon in any plane, wound either way, convex or not: the triangles do not overlap, and their areas add up to the
 * polygon's. Corners may lie on a straight edge, corners may be named twice in a row, the first may be named again at the
 * end, and holes may be joined to the outline by bridges that are walked there and back. Corners need not lie quite in one
 * plane: the outline is judged as seen along its mean normal.
 *
 * Ears are cut as seen along an axis of the world, in which coordinates stay exact; those whose triangle holds no other
 * corner and whose new edge crosses no other go first. An ear is never wound against the polygon: the winding numbers of the
 * triangles then add up to that of the polygon, so that they cover it once wherever it is 1. Corners closer to a line than
 * 1e-13 of the polygon's size, or than the coordinates resolve, lie on it.
 *
 * A quadrilateral is cut along the shorter of the diagonals that lie inside it. Corners on one line give a fan of
 * triangles without area, edges that are all walked there and back give none. Cost: the square of the number of corners.
 *
 * @return false, without triangles, where the outline crosses itself or goes round a place twice.
 */
SHADOWCONESCORE_EXPORT bool TriangulatePolygon(const std::vector<Vector3>& corners, std::vector<int>& triangles);

} // namespace shadowcones

#endif
