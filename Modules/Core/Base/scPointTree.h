// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPointTree.h
 * @brief Nearest neighbours among points. Hides PCL, and the only place that calls it.
 */
#ifndef scPointTree_h
#define scPointTree_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace shadowcones
{

/// A kd-tree, built once. Points are held in single precision in a centred, scaled frame. Queries are safe from many threads.
class SHADOWCONESCORE_EXPORT PointTree
{
public:
  /**
   * @param bounds of the points: their frame. @param pointOf gives each of @p count points. Throws std::length_error beyond
   * 2^31 - 1 of them.
   */
  PointTree(const Box& bounds, vtkIdType count, const std::function<Vector3(vtkIdType)>& pointOf);
  ~PointTree();
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  vtkIdType Size() const { return this->Count; }
  /// Bytes, about.
  std::int64_t Memory() const;
  /// The (at most) @p k points nearest to point @p id, nearest first, itself included; @p found is overwritten.
  void NearestTo(vtkIdType id, int k, std::vector<vtkIdType>& found) const;
  /// The same for any place, with the squared distances.
  void NearestTo(const Vector3& place, int k, std::vector<vtkIdType>& found, std::vector<double>& squared) const;

private:
  struct Tree;

  Vector3 Center;
  double Scale = 1.0;
  vtkIdType Count = 0;
  std::unique_ptr<Tree> Index;
};

} // namespace shadowcones

#endif
