// SPDX-License-Identifier: BSD-3-Clause
#include "scAimedBoxes.h"

#include <numeric>

namespace shadowcones
{

AimedBoxes::AimedBoxes(const std::vector<Box>& boxes)
  : Boxes(boxes)
{
  std::vector<std::size_t> all(boxes.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  if (!all.empty())
  {
    this->Nodes.reserve(2 * all.size());
    this->Build(all.begin(), all.end());
  }
}

/// A node over a range of the boxes, which are sorted along the longest side of their centres' box and halved.
void AimedBoxes::Build(Index begin, Index end)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node;
  node.First = *std::min_element(begin, end);
  Box centers;
  std::for_each(begin, end,
    [&](std::size_t k)
    {
      node.Bounds.Add(this->Boxes[k]);
      centers.Add(this->Boxes[k].Center());
    });
  // Rounding must not cut a box from its node.
  constexpr double relative = 1e-9;
  const double margin = relative * (node.Bounds.Diagonal() + std::max(Length(node.Bounds.Min), Length(node.Bounds.Max)));
  node.Bounds.Min = node.Bounds.Min - Vector3{ margin, margin, margin };
  node.Bounds.Max = node.Bounds.Max + Vector3{ margin, margin, margin };
  if (end - begin > 1)
  {
    const Vector3 size = centers.Size();
    const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
      [&](std::size_t a, std::size_t b)
      {
        const double at = this->Boxes[a].Center()[axis];
        const double other = this->Boxes[b].Center()[axis];
        return at < other || (at == other && a < b);
      });
    this->Build(begin, middle);
    node.Right = static_cast<int>(this->Nodes.size());
    this->Build(middle, end);
  }
  this->Nodes[index] = node;
}

} // namespace shadowcones
