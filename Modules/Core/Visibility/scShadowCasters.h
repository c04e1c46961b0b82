// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowCasters.h
 * @brief What of a mesh lies in a shaft of light, and whether it hides all of it alike. Internal to Core.
 */
#ifndef scShadowCasters_h
#define scShadowCasters_h

#include "scShaft.h"
#include "scTriangleMesh.h"

#include <vector>

namespace shadowcones
{

/// What casters do to the light of a shaft.
enum class ShaftFinding
{
  Clear, ///< no triangle reaches into it: every ray is free
  Alike, ///< every ray meets the same surfaces: one ray tells for all
  Mixed  ///< neither could be shown
};

/**
 * Triangles in a tree of boxes, and which of them are neighbours. Built once for a light, queried often, from any number of
 * threads. About 150 bytes a triangle.
 *
 * Whether a ray is hidden changes, from one ray of a shaft to the next, only where an edge passes between them that is
 * the end of a surface, or between a face that turns to the ray and one that turns away; or where one of the ray's ends
 * passes through a surface. Where no such edge reaches into the shaft and no surface into its ends all rays are alike. Both
 * Clear and Alike are facts, up to rounding.
 */
class ShadowCasters
{
public:
  /// @param ignored one a triangle, 1: it casts no shadow of this light; or nullptr. The mesh must outlive this.
  ShadowCasters(const TriangleMeshView& mesh, const unsigned char* ignored, const std::vector<LightBody>& light);

  const Box& Bounds() const { return this->Extent; }

  /// Does any triangle reach into the shaft? Touching counts.
  bool Meets(const Shaft& shaft) const;
  ShaftFinding Look(const Shaft& shaft) const;

private:
  struct Node
  {
    Box Bounds;
    vtkIdType Begin = 0; ///< leaf: triangles in Order
    vtkIdType End = 0;   ///< 0: an inner node, whose first child follows it
    vtkIdType Second = 0;
    Vector3 Normal;      ///< unit, of the triangles and of their neighbours on the average
    double Spread = 0.0; ///< so far their normals lie from it, at most
    bool HasEnds =
      false; ///< a side without its one neighbour, or that is wound the other way, or a triangle at the light
  };
  void Build(vtkIdType begin, vtkIdType end);
  void FindNeighbors();
  void BoundNormals(vtkIdType begin, vtkIdType end, Node& node) const;
  Vector3 NormalOf(vtkIdType triangle) const;
  /// Are all triangles below a node turned to the light alike, with all of their neighbours, and none at its ends?
  static bool IsAlike(const Shaft& shaft, const Node& node);
  bool EndsInside(const Shaft& shaft, vtkIdType triangle) const;
  /// Call visit(triangle) for the triangles that reach into the shaft until it answers true, but for those of nodes for which
  /// skip(node) does. @return that.
  template <typename Skip, typename Visitor>
  bool Visit(const Shaft& shaft, Skip&& skip, Visitor&& visit) const;

  TriangleMeshView Mesh;
  Box Extent;
  std::vector<vtkIdType> Order;
  std::vector<Node> Nodes;
  std::vector<vtkIdType> Opposite;    ///< for each side of a triangle that of its only neighbour there, or -1
  std::vector<unsigned char> SameWay; ///< 1: the neighbour's side runs the same way: it is wound the other way round
  std::vector<unsigned char> AtLight; ///< one a triangle, 1: it reaches into the light
};

} // namespace shadowcones

#endif
