// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeBeam.h
 * @brief The intervals of many neighbouring rays inside cones. Internal to Core.
 *
 * Cones that a bundle of rays may meet are gathered once; each ray then meets all of them in one loop without branches.
 * Sorting intervals would cost more than meeting the cones: they are merged in bits, 128 along the ray, rounded outwards.
 */
#ifndef scConeBeam_h
#define scConeBeam_h

#include "scConeHierarchy.h"
#include "scRay.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// One a thread. The hierarchy must outlive it.
class ConeBeam
{
public:
  explicit ConeBeam(const ConeHierarchy& cones);

  /// Gather the cones that rays between these four may meet: the corners of the bundle in turn.
  void Gather(const std::array<Ray, 4>& corners);
  /// Intervals of [tBegin, tEnd] that hold all of a ray's points inside cones; ascending, apart from each other.
  void Intersect(const Ray& ray, double tBegin, double tEnd, std::vector<RayInterval>& intervals);

  std::size_t NumberOfCones() const { return this->Ids.size(); }

private:
  static constexpr int Bins = 128;
  /// Rows of Columns: one number a gathered cone each.
  enum Column
  {
    CenterX,
    CenterY,
    CenterZ,
    AxisX,
    AxisY,
    AxisZ,
    Radius,
    Tangent,
    Height,
    Enter,
    Exit,
    NumberOfColumns
  };

  const ConeHierarchy& Hierarchy;
  std::vector<int> Ids;
  std::vector<double> Columns;
};

} // namespace shadowcones

#endif
