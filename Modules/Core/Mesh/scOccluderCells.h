// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderCells.h
 * @brief A mesh cut into cells whose triangles are of a size that single precision can tell apart. Internal to Core.
 */
#ifndef scOccluderCells_h
#define scOccluderCells_h

#include "scTriangleMesh.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// What may be found in single precision on behalf of a triangle.
struct CellPiece
{
  std::array<std::array<float, 3>, 3> Corners; ///< in the cell's frame
  vtkIdType Triangle;
  bool Exact; ///< inside, by more than the margin, it holds nothing but its triangle
};

/// A box of space and all of the mesh in it. In its frame its centre is the origin and its diagonal is 2.
struct OccluderCell
{
  Box Bounds; ///< of what the cell is asked for
  Vector3 Center;
  double Scale = 1.0;     ///< world to the cell's frame
  double RayMargin = 0.0; ///< in the world
  double Reach = 0.0;     ///< in the world: so far before and beyond its bounds rays are still asked for
  std::vector<CellPiece> Pieces;
};

/**
 * Cells that together hold the mesh, as leaves of a binary tree. A ray within 1e-6 (in the cell's frame) of a triangle meets
 * a piece of it in single precision: pieces are a little larger than the triangles, needles become rectangles, and what
 * reaches out of a cell is cut off.
 */
class OccluderCells
{
public:
  /// By how much, in a cell's frame, pieces reach beyond their triangle: more than single precision gets wrong.
  static constexpr double Margin = 2e-6;
  /// By how much, in a cell's frame, rays start earlier and end later in single precision.
  static constexpr double RayMargin = 1e-4;
  /// By how much, in a cell's frame, rays start before it and end behind it: what lies on its border is in no doubt.
  static constexpr double Reach = 1e-2;

  explicit OccluderCells(const TriangleMeshView& mesh);

  std::vector<OccluderCell> Cells;

  /**
   * Call visit(cell, begin, end) for the cells on the way in [tMin, tMax], nearest first, until it answers true. Lowering
   * @p tMax in a visit ends the way there.
   */
  template <typename Visitor>
  bool Visit(const Vector3& origin, const Vector3& direction, double tMin, double& tMax, Visitor&& visit) const
  {
    return this->VisitNode(this->Root, origin, direction, tMin, tMax, visit);
  }

private:
  struct Node
  {
    Box Bounds;
    int Axis = 0;   ///< along which the children lie one after the other
    int First = -1; ///< child; -1: none
    int Second = -1;
    int Cell = -1; ///< of a leaf
  };

  template <typename Visitor>
  bool VisitNode(
    int index, const Vector3& origin, const Vector3& direction, double tMin, double& tMax, Visitor& visit) const
  {
    if (index < 0)
    {
      return false;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(index)];
    double begin = tMin;
    double end = tMax;
    if (!node.Bounds.Clip(origin, direction, begin, end))
    {
      return false;
    }
    if (node.Cell >= 0)
    {
      return visit(static_cast<std::size_t>(node.Cell), begin, end);
    }
    const bool forward = direction[node.Axis] >= 0.0;
    return this->VisitNode(forward ? node.First : node.Second, origin, direction, tMin, tMax, visit) ||
      this->VisitNode(forward ? node.Second : node.First, origin, direction, tMin, tMax, visit);
  }

  int Build(const TriangleMeshView& mesh, const std::vector<vtkIdType>& triangles, const Box& box, int depth);
  int AddLeaf(const TriangleMeshView& mesh, const std::vector<vtkIdType>& triangles, const Box& box);

  std::vector<Node> Nodes;
  int Root = -1;
};

} // namespace shadowcones

#endif
