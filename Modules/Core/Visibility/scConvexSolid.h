// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConvexSolid.h
 * @brief A convex polyhedron that is cut by planes. Internal to Core.
 */
#ifndef scConvexSolid_h
#define scConvexSolid_h

#include "scBox.h"
#include "scVector3.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// Convex faces over shared points, wound outward. Every edge belongs to two faces, once in each direction.
struct ConvexSolid
{
  std::vector<Vector3> Points;
  std::vector<std::vector<vtkIdType>> Faces;

  bool Empty() const { return this->Faces.empty(); }

  /**
   * Keep what lies where sign (x[axis] - value) <= 0, and close it; points nearer to the plane than @p rounding are moved
   * onto it.
   */
  void Cut(int axis, double value, double sign, double rounding);
  /// Keep what lies in the box.
  void CutTo(const Box& box);

  /// Append triangles of the faces, and the points that they use; fans around a middle where corners lie in one line.
  void AppendTo(std::vector<Vector3>& points, std::vector<std::array<vtkIdType, 3>>& triangles) const;
};

} // namespace shadowcones

#endif
