// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeIntervals.h
 * @brief Where a ray runs inside cones (Hougs and Day, section 3.3.1 and appendix A), through a hierarchy (section 6.2).
 */
#ifndef scConeIntervals_h
#define scConeIntervals_h

#include "ShadowConesCoreModule.h"
#include "scConeSet.h"
#include "scVector3.h"

#include <array>
#include <memory>
#include <vector>

namespace shadowcones
{

struct RayInterval
{
  double Begin = 0.0;
  double End = 0.0;
  int OccluderId = -1; ///< of the cone; -1 after merging over occluders
};

/// @return true where the cone, cut at @p length from its base, holds the point.
SHADOWCONESCORE_EXPORT bool ConeContains(const Cone& cone, const Vector3& point, double length = HUGE_VAL);

/**
 * The part of [tMin, tMax] inside the cone, by the quadratic of appendix A for the truncated cone: base plane, only the sheet
 * ahead of it, cut at @p length from the base. A convex body, hence one interval. @return false where there is none.
 */
SHADOWCONESCORE_EXPORT bool IntersectCone(const Cone& cone, double length, const Vector3& origin, const Vector3& direction,
  double tMin, double tMax, RayInterval& interval);

/// Sort intervals and merge those that touch; with @p perOccluder only within the same occluder.
SHADOWCONESCORE_EXPORT void MergeIntervals(std::vector<RayInterval>& intervals, bool perOccluder = false);

/// A cone that holds a box, with a little to spare: with it as the only cone, whoever asks inside cones asks everywhere.
SHADOWCONESCORE_EXPORT Cone ConeAroundBox(const Box& box);

/// Cones that begin one base radius nearer to the light: points on a surface may lie just before the base fitted to it.
SHADOWCONESCORE_EXPORT std::vector<Cone> Lengthened(std::vector<Cone> cones);

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
  ConeHierarchy(const std::vector<Cone>& cones, const Box& bounds, double length = HUGE_VAL);
  ~ConeHierarchy();
  ConeHierarchy(const ConeHierarchy&) = delete;
  ConeHierarchy& operator=(const ConeHierarchy&) = delete;

  /// Merged intervals of the ray inside cones; @p intervals is overwritten, ascending.
  void Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
    std::vector<RayInterval>& intervals, bool perOccluder = false) const;
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

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

} // namespace shadowcones

#endif
