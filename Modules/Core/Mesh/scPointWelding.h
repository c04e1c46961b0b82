// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPointWelding.h
 * @brief Points of a mesh that are one but for rounding. Internal to Core.
 */
#ifndef scPointWelding_h
#define scPointWelding_h

#include "scTriangleMesh.h"

#include <vector>

namespace shadowcones
{

/**
 * For each point the earliest kept point that is one with it; points that no triangle uses get -1. @param blocks one a
 * triangle, or nullptr: points of different blocks are never one; @param relative distance within which points are one, over
 * the shortest edge at each of them; 0: exact duplicates only.
 */
std::vector<vtkIdType> WeldPoints(const TriangleMeshView& mesh, const int* blocks, double relative);

} // namespace shadowcones

#endif
