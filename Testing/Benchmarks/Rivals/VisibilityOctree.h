// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibilityOctree.h
 * @brief An octree over the medium, cut where the blocked share differs between a cell's corners; linear inside a leaf.
 */
#ifndef VisibilityOctree_h
#define VisibilityOctree_h

#include "LampRays.h"
#include "Rival.h"

#include "scBox.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace shadowcones
{

struct VisibilityOctreeOptions
{
  int FirstDepth = 4; ///< everywhere: what is smaller than its cells and lies between corners is not found
  int Depth = 7;
  double Threshold = 0.1; ///< of a share; corners that differ by more cut a cell
  int Rays = 32;          ///< the same points of the light from every corner, so that noise cuts no cells
};

class VisibilityOctree : public PointRival
{
public:
  VisibilityOctree(
    const OccluderScene& scene, const Light& light, const Box& bounds, const VisibilityOctreeOptions& options);

  double BlockedAt(const Vector3& x, RandomStream& random) const override;
  std::int64_t Memory() const override { return static_cast<std::int64_t>(this->Nodes.size() * sizeof(Node)); }

private:
  struct Node
  {
    std::int32_t Children = -1;           ///< the first of eight; -1: a leaf
    std::array<unsigned char, 8> Blocked; ///< at the corners, 255: all
  };
  /// While it is built.
  struct Corners
  {
    const LampRays& Lamp;
    const VisibilityOctreeOptions& Options;
    std::unordered_map<std::uint64_t, unsigned char> Known;
  };
  void Build(std::size_t node, int depth, const std::array<std::uint32_t, 3>& cell, Corners& corners);
  unsigned char Ask(const std::array<std::uint32_t, 3>& corner, Corners& corners) const;

  Box Bounds;
  std::vector<Node> Nodes;
};

} // namespace shadowcones

#endif
