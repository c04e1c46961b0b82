// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeTree.h
 * @brief A tree of boxes over slices of cones. Internal to Core.
 */
#ifndef scConeTree_h
#define scConeTree_h

#include "scBoxRay.h"
#include "scCone.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

class ConeTree
{
public:
  /// A slice of a cone between two heights above its base.
  struct Entry
  {
    int Cone = 0;
    double Low = 0.0;
    double High = 0.0;
    Box Bounds;
  };

  /// Slices of the cones up to @p length from their base, within @p bounds.
  static ConeTree OverSlices(const std::vector<Cone>& cones, const Box& bounds, double length);
  /// The base discs alone.
  static ConeTree OverBases(const std::vector<Cone>& cones);

  /**
   * Call visit(entry) for every entry whose box the ray meets in [tMin, tMax], unless skip(enter, exit) answers true for the
   * part of the ray inside its box or a box around it.
   */
  template <typename Visitor, typename Skip>
  void ForEachOnRay(
    const Vector3& origin, const Vector3& direction, double tMin, double tMax, Visitor&& visit, Skip&& skip) const
  {
    const BoxRay ray(origin, direction);
    const auto test = [&](const Box& box) {
      double enter = tMin;
      double exit = tMax;
      return ray.Clip(box, enter, exit) && !skip(enter, exit);
    };
    this->Traverse(test, [&](const Entry& entry) {
      visit(entry);
      return false;
    });
  }
  template <typename Visitor>
  void ForEachOnRay(const Vector3& origin, const Vector3& direction, double tMin, double tMax, Visitor&& visit) const
  {
    this->ForEachOnRay(origin, direction, tMin, tMax, visit, [](double, double) { return false; });
  }
  /// Call visit(entry) for every entry whose box holds the point.
  template <typename Visitor>
  void ForEachAtPoint(const Vector3& point, Visitor&& visit) const
  {
    this->AnyAtPoint(point, [&](const Entry& entry) {
      visit(entry);
      return false;
    });
  }
  /// Does accept(entry) answer true for any entry whose box holds the point? Stops at the first.
  template <typename Predicate>
  bool AnyAtPoint(const Vector3& point, Predicate&& accept) const
  {
    return this->Traverse([&](const Box& box) { return box.Contains(point); }, accept);
  }

  std::int64_t Memory() const
  {
    return static_cast<std::int64_t>(this->Entries.capacity() * sizeof(Entry) + this->Nodes.capacity() * sizeof(Node));
  }

  /// Call visit(entry) for every entry whose box may reach inside: inside(box) answers for boxes, and for boxes around them.
  template <typename Test, typename Visitor>
  void ForEachInside(Test&& inside, Visitor&& visit) const
  {
    this->Traverse(inside, [&](const Entry& entry) {
      visit(entry);
      return false;
    });
  }

private:
  struct Node
  {
    Box Bounds;
    int Right = 0; ///< inner node: its right child, the left one follows it; leaf: first entry
    int Count = 0; ///< leaf: number of entries; inner node: 0
  };

  explicit ConeTree(std::vector<Entry> entries);
  void BuildNode(std::size_t begin, std::size_t end);

  /// Stops, and answers true, where visit(entry) does.
  template <typename Test, typename Visitor>
  bool Traverse(Test&& test, Visitor&& visit) const
  {
    if (this->Nodes.empty())
    {
      return false;
    }
    int stack[64];
    int size = 0;
    stack[size++] = 0;
    while (size > 0)
    {
      const int index = stack[--size];
      const Node& node = this->Nodes[index];
      if (!test(node.Bounds))
      {
        continue;
      }
      if (node.Count == 0)
      {
        stack[size++] = node.Right;
        stack[size++] = index + 1;
        continue;
      }
      for (int i = node.Right; i < node.Right + node.Count; ++i)
      {
        if (test(this->Entries[i].Bounds) && visit(this->Entries[i]))
        {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<Entry> Entries;
  std::vector<Node> Nodes;
};

} // namespace shadowcones

#endif
