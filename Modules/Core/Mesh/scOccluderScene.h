// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderScene.h
 * @brief Ray queries on a triangle mesh. Hides Embree (3 and 4); nothing else calls it.
 */
#ifndef scOccluderScene_h
#define scOccluderScene_h

#include "ShadowConesCoreModule.h"
#include "scBox.h"
#include "scFlatFace.h"
#include "scTriangleMesh.h"
#include "scVector3.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

class LineShadows;

struct RayHit
{
  double T = 0.0;          ///< distance along the (unit) direction, world units
  vtkIdType Triangle = -1; ///< index into the mesh's triangles
  bool FrontFacing = true; ///< the ray runs against the triangle's normal
};

/**
 * How far a point that was computed at distance @p t along a ray lies off the ray, or off the surface that was met there,
 * at most; and how far a ray may pass outside a triangle that it is said to meet.
 */
inline double RoundingAlong(const Vector3& origin, double t)
{
  return 1e-12 * (std::fabs(origin.X) + std::fabs(origin.Y) + std::fabs(origin.Z) + std::fabs(t));
}

/// What a ray passes by, beyond what rounding in double precision makes necessary.
struct RayRules
{
  /// Triangles whose plane is so near to the ray's start, or end, in world units, are not met: for points that lie on
  /// surfaces as well as their coordinates can say. A thousandth of the triangle's size at most.
  double StartTolerance = 0.0;
  double EndTolerance = 0.0;
  const unsigned char* Ignored = nullptr; ///< one a triangle, 1: not met; or nullptr
};

struct OccluderSceneOptions
{
  std::int64_t MemoryLimit = 0; ///< bytes that Embree may take; 0: all there is
};

/**
 * Built once, queried often, from any number of threads.
 *
 * Embree finds the triangles that may be on a ray's way, in single precision; whether one is met is decided in double
 * precision against the mesh's own coordinates, so that neither the size of the whole nor its place matters. Where
 * triangles are far smaller than the whole (by 2^14), space is cut into cells, each with a frame of its own for Embree,
 * and large triangles are cut for them.
 *
 * A ray meets a triangle where its start and its end lie on the two sides of the triangle's plane, each farther from it
 * than rounding: a surface never hides a point of its own plane, be it where a ray starts or where it ends. Edges and
 * corners belong to all triangles that share them, up to rounding: nothing leaks between them.
 *
 * Not guaranteed: hits of rays that run along a triangle's plane within about 1e-6 of the cell's diagonal; where two
 * triangles are nearer to each other than that, which of the two is the nearest.
 */
class SHADOWCONESCORE_EXPORT OccluderScene
{
public:
  /// The mesh's arrays must outlive the scene. Throws std::runtime_error where Embree cannot start or runs out of memory.
  explicit OccluderScene(const TriangleMeshView& mesh, const OccluderSceneOptions& options = {});
  ~OccluderScene();
  OccluderScene(const OccluderScene&) = delete;
  OccluderScene& operator=(const OccluderScene&) = delete;

  const TriangleMeshView& Mesh() const;
  const Box& Bounds() const;
  /// Cells that space is cut into: 1 but where triangles are far smaller than the whole.
  vtkIdType NumberOfCells() const;
  /// Bytes of the search structures, without the mesh: some 200 a triangle, and 80 to 600 more once Lines() was asked for.
  std::int64_t Memory() const;
  /// What the mesh hides of whole lines. Built when it is asked for first.
  const LineShadows& Lines() const;

  /// What rays between a flat lamp and the points that it shines on pass by: see IsFlush(). Found once for each plane.
  RayRules RulesFor(const FlatFace& lamp) const;
  /// How far a point on a surface may lie off it for its coordinates or the mesh's being in single precision, else 0.
  double SurfaceTolerance(const Vector3& point) const;

  /// Nearest hit with T in (tMin, tMax); @p direction unit. @return false where there is none.
  bool Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax, RayHit& hit,
    const RayRules& rules = {}) const;
  /// So many rays at most in one call of IntersectPacket().
  static constexpr int PacketSize = 8;
  /**
   * Intersect for rays of any length that run close together, and faster. Answers for @p count of them, Triangle -1 where
   * there is no hit. Of triangles at one distance either may be found: it is the same one for the same packet.
   */
  void IntersectPacket(const Vector3* origins, const Vector3* directions, int count, RayHit* hits) const;
  /// All hits with T in (tMin, tMax), ascending, each triangle once; @p hits is overwritten.
  void IntersectAll(const Vector3& origin, const Vector3& direction, double tMin, double tMax,
    std::vector<RayHit>& hits, const RayRules& rules = {}) const;
  /// Is there any hit with T in (tMin, tMax)? tMax may be infinite.
  bool Occluded(
    const Vector3& origin, const Vector3& direction, double tMin, double tMax, const RayRules& rules = {}) const;
  /**
   * Occluded from the origins on for up to PacketSize rays from anywhere, faster the closer together they run: bit k of the
   * answer where there is a hit with T in (0, ends[k]), which may be infinite.
   */
  unsigned int OccludedPacket(
    const Vector3* origins, const Vector3* directions, const double* ends, int count, const RayRules& rules = {}) const;
  /**
   * Occluded for up to 64 rays from one point, several at a time: bit k of the answer where there is a hit on the way
   * along (x[k], y[k], z[k]); to @p infinity the vectors are unit and have no end. Only rays in @p wanted are asked for;
   * all three arrays have 64 values.
   */
  std::uint64_t OccludedFrom(const Vector3& origin, const double* x, const double* y, const double* z,
    std::uint64_t wanted, bool infinity, const RayRules& rules = {}) const;
  /// A triangle that ray @p Ray of up to 64 meets.
  struct MetTriangle
  {
    int Ray;
    vtkIdType Triangle;
  };
  /// For the rays of OccludedFrom() all that they meet on their way, in no order, some more than once; @p met is overwritten.
  void TrianglesFrom(const Vector3& origin, const double* x, const double* y, const double* z, std::uint64_t wanted,
    bool infinity, std::vector<MetTriangle>& met, const RayRules& rules = {}) const;
  /// Unit normal of a triangle by its winding.
  Vector3 TriangleNormal(vtkIdType triangle) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

} // namespace shadowcones

#endif
