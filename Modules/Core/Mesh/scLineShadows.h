// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLineShadows.h
 * @brief What a mesh hides of a point of light from a whole line at once, exactly. Internal to Core.
 *
 * A line and a point of light span a plane. Every triangle that crosses it leaves a segment there, and the segment's
 * shadow on the line is one interval: two crossings and two projections, whatever the light's distance. A line's worth of
 * occlusion rays costs some twenty of them.
 */
#ifndef scLineShadows_h
#define scLineShadows_h

#include "scBox.h"
#include "scRay.h"
#include "scRayInterval.h"
#include "scTriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// A part of a line and a point of light: between them lies a triangle, or a strip without end.
struct LineAndLight
{
  Ray Line;
  double Begin = 0.0;
  double End = 0.0;
  Vector3 Light; ///< a point, or the unit direction towards a light at infinity
  bool AtInfinity = false;
};

/// Built once, asked from any number of threads.
class LineShadows
{
public:
  /// The mesh is copied.
  explicit LineShadows(const TriangleMeshView& mesh);

  /**
   * The parts of the line from which the light cannot be seen, ascending and apart. As for rays (see OccluderScene) a
   * triangle hides nothing of its own plane, and nothing leaks between triangles that share an edge.
   * @param ignored one a triangle, 1: it hides nothing; or nullptr.
   * @return false where the line points at the light: then nothing is known.
   */
  bool Find(const LineAndLight& query, const unsigned char* ignored, std::vector<RayInterval>& hidden) const;

  /// Bytes.
  std::int64_t Memory() const;

  /// Groups of triangles that all queries of this thread have looked at so far: what they cost.
  static std::int64_t GroupsLookedAt();

private:
  static constexpr int Width = 8; ///< boxes of a node, and triangles of a group
  /// Boxes about the mesh's centre in single precision, and what they hold. Lanes of no use hold nothing.
  struct alignas(32) Node
  {
    float Center[3][Width];
    float Half[3][Width];
    int Child[Width]; ///< a node, or ~ a group
  };
  struct alignas(32) Group
  {
    double Corners[9][Width]; ///< X, Y, Z of the first corners, then of the second and third ones; unused: not a number
    unsigned int Triangles[Width];
  };
  struct Plane;
  struct Crossings;

  /// A triangle while the tree is built.
  struct Piece
  {
    Box Bounds;
    unsigned int Triangle;
  };
  static Vector3 SizeOfMiddles(const Piece* begin, const Piece* end);
  int Build(const TriangleMeshView& mesh, Piece* first, Piece* last);
  int AddGroup(const TriangleMeshView& mesh, const Piece* first, const Piece* last);
  void SetBox(Node& node, int lane, const Box& box) const;
  bool PlaneOf(const LineAndLight& query, Plane& plane) const;
  static unsigned int Touched(const Node& node, const Plane& plane);
  static unsigned int CrossPlane(const Group& group, const Plane& plane, Crossings& crossings);
  static void Join(std::vector<RayInterval>& intervals, double begin, double end, double gap);
  static void SetApart(std::vector<RayInterval>& intervals, const RayInterval& line, double gap);

  Vector3 Center;
  double Extent = 0.0; ///< half the diagonal
  std::vector<Node> Nodes;
  std::vector<Group> Groups;
  int Root = 0; ///< as Node::Child
};

} // namespace shadowcones

#endif
