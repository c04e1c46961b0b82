// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scOccluderScene.h
 * @brief Ray queries on a triangle mesh. Hides Embree (3 and 4), and the only place that calls it.
 */
#ifndef scOccluderScene_h
#define scOccluderScene_h

#include "ShadowConesCoreModule.h"
#include "scVector3.h"
#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

/// A triangle mesh, not owned. Points: 3 doubles each. Triangles: 3 point ids each.
struct TriangleMeshView
{
  const double* Points = nullptr;
  vtkIdType NumberOfPoints = 0;
  const vtkIdType* Triangles = nullptr;
  vtkIdType NumberOfTriangles = 0;
  const int* OccluderIds = nullptr; ///< one a triangle, or nullptr: all 0; negative: a receiver, it casts no vectors

  Vector3 Point(vtkIdType id) const { return { this->Points[3 * id], this->Points[3 * id + 1], this->Points[3 * id + 2] }; }
  Vector3 Corner(vtkIdType triangle, int corner) const { return this->Point(this->Triangles[3 * triangle + corner]); }
  int OccluderId(vtkIdType triangle) const { return this->OccluderIds ? this->OccluderIds[triangle] : 0; }
};

/// Bounds of the triangles' points.
SHADOWCONESCORE_EXPORT Box MeshBounds(const TriangleMeshView& mesh);

struct RayHit
{
  double T = 0.0;          ///< distance along the (unit) direction, world units
  vtkIdType Triangle = -1; ///< index into the mesh's triangles
  bool FrontFacing = true; ///< the ray runs against the triangle's normal
};

/**
 * Built once, queried often, from any number of threads. Triangles are held in single precision in a frame that is centred
 * on the mesh and scaled to unit size; distances found are refined against the triangles' own double coordinates.
 * Not guaranteed: hits within about 1e-6 of the mesh's diagonal from a ray's origin.
 */
class SHADOWCONESCORE_EXPORT OccluderScene
{
public:
  /// The mesh's arrays must outlive the scene. Throws std::runtime_error where Embree cannot start.
  explicit OccluderScene(const TriangleMeshView& mesh);
  ~OccluderScene();
  OccluderScene(const OccluderScene&) = delete;
  OccluderScene& operator=(const OccluderScene&) = delete;

  const TriangleMeshView& Mesh() const;
  const Box& Bounds() const;
  /// Length below which hits at a ray's start are not to be trusted: offset secondary rays by this much.
  double Epsilon() const;

  /// Nearest hit with T in (tMin, tMax); @p direction unit. @return false where there is none.
  bool Intersect(const Vector3& origin, const Vector3& direction, double tMin, double tMax, RayHit& hit) const;
  /// So many rays at most in one call of IntersectPacket().
  static constexpr int PacketSize = 8;
  /**
   * Intersect for rays of any length that run close together, and faster. Answers for @p count of them, Triangle -1 where
   * there is no hit. Of triangles at one distance either may be found: it is the same one for the same packet.
   */
  void IntersectPacket(const Vector3* origins, const Vector3* directions, int count, RayHit* hits) const;
  /// All hits with T in (tMin, tMax), ascending, each triangle once; @p hits is overwritten.
  void IntersectAll(
    const Vector3& origin, const Vector3& direction, double tMin, double tMax, std::vector<RayHit>& hits) const;
  /// Is there any hit with T in (tMin, tMax)? tMax may be infinite.
  bool Occluded(const Vector3& origin, const Vector3& direction, double tMin, double tMax) const;
  /**
   * Occluded for up to 64 rays from one point, several at a time: bit k of the answer where there is a hit on the way
   * along (x[k], y[k], z[k]), farther than Epsilon() from both ends; to @p infinity the vectors are unit and have no end.
   * Only rays in @p wanted are asked for; all three arrays have 64 values.
   */
  std::uint64_t OccludedFrom(const Vector3& origin, const double* x, const double* y, const double* z,
    std::uint64_t wanted, bool infinity) const;
  /// Unit normal of a triangle by its winding.
  Vector3 TriangleNormal(vtkIdType triangle) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

} // namespace shadowcones

#endif
