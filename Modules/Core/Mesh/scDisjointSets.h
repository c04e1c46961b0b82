// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDisjointSets.h
 * @brief Sets of items that are united, two at a time. Internal to Core.
 */
#ifndef scDisjointSets_h
#define scDisjointSets_h

#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shadowcones
{

/// Disjoint sets; the root is the smallest member, so that labels do not depend on the order of unions.
class DisjointSets
{
public:
  explicit DisjointSets(vtkIdType count)
    : Parents(static_cast<std::size_t>(count))
  {
    std::iota(this->Parents.begin(), this->Parents.end(), vtkIdType(0));
  }
  vtkIdType Root(vtkIdType item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }
  void Unite(vtkIdType a, vtkIdType b)
  {
    a = this->Root(a);
    b = this->Root(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<vtkIdType> Parents;
};

} // namespace shadowcones

#endif
