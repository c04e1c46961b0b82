// SPDX-License-Identifier: BSD-3-Clause
#include "VisibilityOctree.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

//------------------------------------------------------------------------------
VisibilityOctree::VisibilityOctree(
  const OccluderScene& scene, const Light& light, const Box& bounds, const VisibilityOctreeOptions& options)
  : Bounds(bounds)
  , Nodes(1)
{
  const LampRays lamp(scene, light, options.Rays);
  Corners corners{ lamp, options, {} };
  this->Build(0, 0, { 0, 0, 0 }, corners);
  this->Nodes.shrink_to_fit();
}

//------------------------------------------------------------------------------
/// @param corner on the lattice of the deepest cells.
unsigned char VisibilityOctree::Ask(const std::array<std::uint32_t, 3>& corner, Corners& corners) const
{
  const std::uint64_t key = corner[0] | static_cast<std::uint64_t>(corner[1]) << 21 | static_cast<std::uint64_t>(corner[2]) << 42;
  const auto [at, isNew] = corners.Known.try_emplace(key, 0);
  if (isNew)
  {
    const double cells = std::ldexp(1.0, corners.Options.Depth);
    const Vector3 size = this->Bounds.Size();
    const Vector3 x = this->Bounds.Min +
      Vector3{ corner[0] / cells * size.X, corner[1] / cells * size.Y, corner[2] / cells * size.Z };
    at->second = static_cast<unsigned char>(std::lround(255.0 * corners.Lamp.BlockedOfSamePoints(x)));
  }
  return at->second;
}

//------------------------------------------------------------------------------
/// @param cell number of the cell among those of its depth.
void VisibilityOctree::Build(
  std::size_t node, int depth, const std::array<std::uint32_t, 3>& cell, Corners& corners)
{
  const int rest = corners.Options.Depth - depth;
  std::array<unsigned char, 8> blocked;
  for (std::uint32_t k = 0; k < 8; ++k)
  {
    blocked[k] = this->Ask(
      { (cell[0] + (k & 1)) << rest, (cell[1] + (k >> 1 & 1)) << rest, (cell[2] + (k >> 2)) << rest }, corners);
  }
  this->Nodes[node].Blocked = blocked;
  const auto [least, most] = std::minmax_element(blocked.begin(), blocked.end());
  if (rest == 0 || (depth >= corners.Options.FirstDepth && *most - *least <= 255.0 * corners.Options.Threshold))
  {
    return;
  }
  const std::size_t first = this->Nodes.size();
  this->Nodes[node].Children = static_cast<std::int32_t>(first);
  this->Nodes.resize(first + 8);
  for (std::uint32_t k = 0; k < 8; ++k)
  {
    this->Build(first + k, depth + 1, { 2 * cell[0] + (k & 1), 2 * cell[1] + (k >> 1 & 1), 2 * cell[2] + (k >> 2) }, corners);
  }
}

//------------------------------------------------------------------------------
double VisibilityOctree::BlockedAt(const Vector3& x, RandomStream&) const
{
  const Vector3 size = this->Bounds.Size();
  double place[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = std::clamp((x[axis] - this->Bounds.Min[axis]) / size[axis], 0.0, 1.0);
  }
  const Node* node = this->Nodes.data();
  while (node->Children >= 0)
  {
    std::size_t child = static_cast<std::size_t>(node->Children);
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] *= 2.0;
      if (place[axis] >= 1.0)
      {
        place[axis] -= 1.0;
        child += std::size_t{ 1 } << axis;
      }
    }
    node = this->Nodes.data() + child;
  }
  const auto& b = node->Blocked;
  const auto between = [](double low, double high, double share) { return low + share * (high - low); };
  const double near = between(between(b[0], b[1], place[0]), between(b[2], b[3], place[0]), place[1]);
  const double far = between(between(b[4], b[5], place[0]), between(b[6], b[7], place[0]), place[1]);
  return between(near, far, place[2]) / 255.0;
}

} // namespace shadowcones
