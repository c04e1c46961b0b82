// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scNearestVectors.h
 * @brief Nearest neighbours among points of which some die. Internal to Core.
 */
#ifndef scNearestVectors_h
#define scNearestVectors_h

#include "scBox.h"
#include "scPointTree.h"
#include "vtkType.h"

#include <memory>
#include <vector>

namespace shadowcones
{

/**
 * A kd-tree over the living points. The dead are skipped by a query and dropped when they outnumber the living, so that
 * rebuilding costs O(n log n) in all.
 */
class NearestVectors
{
public:
  /// @param points 3 doubles each, which must outlive this object. Throws std::length_error beyond 2^31 - 1 of them.
  NearestVectors(const double* points, vtkIdType count);
  ~NearestVectors();

  bool IsAlive(vtkIdType id) const { return this->Alive[id]; }
  void Kill(vtkIdType id);
  /// One that was alive when the tree was built lives again.
  void Revive(vtkIdType id);
  /// Rebuild where it pays. Not to be called beside Query. @return whether it was.
  bool Prune();
  /// After more deaths than these Prune() rebuilds.
  vtkIdType DeathsUntilPrune() const { return this->NumberAlive - static_cast<vtkIdType>(this->TreeIds.size()) / 2; }
  /// The (at most) @p k living points nearest to point @p id, nearest first, itself included. Safe from many threads.
  void Query(vtkIdType id, int k, std::vector<vtkIdType>& ids) const;

private:
  void Build();

  const double* Points;
  Box Bounds;
  std::vector<unsigned char> Alive;
  std::vector<vtkIdType> TreeIds; ///< point of each entry of the tree
  vtkIdType NumberAlive = 0;
  std::unique_ptr<PointTree> Tree;
};

} // namespace shadowcones

#endif
