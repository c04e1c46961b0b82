// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scAimedBoxes.h
 * @brief The first of many boxes that a photon's path meets. Internal to Core.
 */
#ifndef scAimedBoxes_h
#define scAimedBoxes_h

#include "scBoxRay.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// Boxes in an order of precedence, in a tree, so that a path asks few of them.
class AimedBoxes
{
public:
  AimedBoxes() = default;
  explicit AimedBoxes(const std::vector<Box>& boxes);

  /**
   * The first of the boxes that a ray meets and that counts(index) answers true for; the number of boxes where there is none. The answer
   * is that of asking one after the other: nodes are a little larger than their boxes, which have the last word.
   */
  template <typename Counts>
  std::size_t FirstMet(const Vector3& origin, const Vector3& direction, const Counts& counts) const
  {
    std::size_t first = this->Boxes.size();
    int stack[64]; // halves: the tree is no deeper
    int size = 0;
    if (!this->Nodes.empty())
    {
      stack[size++] = 0;
    }
    const BoxRay ray(origin, direction);
    while (size > 0)
    {
      const int index = stack[--size];
      const Node& node = this->Nodes[static_cast<std::size_t>(index)];
      double from = 0.0;
      double to = HUGE_VAL;
      if (node.First >= first || !ray.Clip(node.Bounds, from, to))
      {
        continue;
      }
      if (node.Right > 0)
      {
        // The one with the first box comes next.
        const int left = index + 1;
        const bool isLeft = this->Nodes[static_cast<std::size_t>(left)].First == node.First;
        stack[size++] = isLeft ? node.Right : left;
        stack[size++] = isLeft ? left : node.Right;
      }
      else
      {
        from = 0.0;
        to = HUGE_VAL;
        first = counts(node.First) && this->Boxes[node.First].Clip(origin, direction, from, to) ? node.First : first;
      }
    }
    return first;
  }

private:
  struct Node
  {
    Box Bounds; ///< with a margin
    std::size_t First = 0; ///< of the boxes below
    int Right = 0;         ///< the second child, the first one follows its parent; 0: one box
  };
  using Index = std::vector<std::size_t>::iterator;

  void Build(Index begin, Index end);

  std::vector<Box> Boxes;
  std::vector<Node> Nodes;
};

} // namespace shadowcones

#endif
