// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeHierarchy.h
 * @brief A hierarchy over cones (section 6.2): where rays and points lie inside them.
 */
#ifndef scConeHierarchy_h
#define scConeHierarchy_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scCone.h"
#include "scOccluderInterval.h"
#include "scParallel.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

/// A half-space: the points x with Normal . x >= Offset.
struct BeamPlane
{
  Vector3 Normal;
  double Offset = 0.0;
};

/// A bounding-volume hierarchy over cones inside a box: built once, queried often, from any number of threads.
class SHADOWCONESCORE_EXPORT ConeHierarchy
{
public:
  /// Cones are copied, cut at @p length from their base and to @p bounds; queries see nothing outside the bounds.
  ConeHierarchy(std::vector<Cone> cones, const Box& bounds, double length = HUGE_VAL);
  ~ConeHierarchy();
  ConeHierarchy(const ConeHierarchy&) = delete;
  ConeHierarchy& operator=(const ConeHierarchy&) = delete;

  /// Merged intervals of the ray inside cones; @p intervals is overwritten, ascending.
  void Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
    std::vector<OccluderInterval>& intervals, bool perOccluder = false) const;
  /// Does any cone hold the point?
  bool Contains(const Vector3& point) const;
  /// The cones that hold the point, as indices into Cones(), ascending; @p cones is overwritten.
  void ConesAt(const Vector3& point, std::vector<int>& cones) const;
  /// The cones that may reach into all four half-spaces at once, as indices into Cones(), ascending; @p cones is overwritten.
  void ConesInBeam(const std::array<BeamPlane, 4>& planes, std::vector<int>& cones) const;
  /// The occluders whose cones hold the point, ascending, each once; @p occluderIds is overwritten.
  void OccludersAt(const Vector3& point, std::vector<int>& occluderIds) const;
  /**
   * Mark the vertices of a regular grid that a cone holds: marks[i + nx (j + ny k)] is 1 there and 0 elsewhere. The
   * spacing may be 0 or negative. One ray query a row, rows in parallel. @return false where aborted.
   */
  bool MarkGrid(const Vector3& origin, const Vector3& spacing, const std::array<int, 3>& dimensions,
    const Monitor& monitor, unsigned char* marks) const;
  const std::vector<Cone>& Cones() const;
  /// Where they are cut, from their base.
  double Length() const;
  /// Bytes: of the cones and of their slices, at most 16 a cone.
  std::int64_t Memory() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

} // namespace shadowcones

#endif
