// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMeshLightRule.h
 * @brief Quadrature over a mesh that emits light, finer where the point that looks at it is near. Internal to Core.
 */
#ifndef scMeshLightRule_h
#define scMeshLightRule_h

#include "scBox.h"
#include "scGaussLegendre.h"
#include "scLight.h"
#include "scLightPoint.h"
#include "scLightSampling.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/**
 * The mesh is cut into patches: single triangles with a product of Gauss rules each, or, where there are many, groups of
 * neighbours that face the same way, with one point each. No two levels are the same rule. From a point that is near
 * a patch in units of its size the patch is looked at triangle by triangle: with more points, and in polar coordinates
 * about the nearest place of the triangle where it is nearer than its own size. Those weights sum to the triangle's
 * exact solid angle. Built once, used from any number of threads.
 */
class MeshLightRule
{
public:
  /// @param level 0 and up; of a mesh with triangles.
  MeshLightRule(const Light& light, int level);

  const std::vector<LightPoint>& Points() const { return this->AllPoints; }

  struct Patch
  {
    Vector3 Middle;
    double NearSquared;        ///< squared distance from Middle within which its places do not do
    std::size_t FirstPoint;
    std::size_t EndOfPoints;
    std::size_t FirstTriangle; ///< of Ordered
    std::size_t EndOfTriangles;
  };
  const std::vector<Patch>& Patches() const { return this->AllPatches; }
  bool IsNear(const Patch& patch, const Vector3& from) const
  {
    const Vector3 offset = patch.Middle - from;
    return Dot(offset, offset) < patch.NearSquared;
  }
  /// Is any patch near? Seldom wrong, and then by answering yes.
  bool MayBeNear(const Vector3& from) const { return this->NearBounds.Contains(from); }

  /// Append what a near patch sends to a point: direction, distance and solid angle.
  void LookAt(const Patch& patch, const Vector3& from, std::vector<IncidentSample>& samples) const;

private:
  struct Triangle
  {
    std::array<Vector3, 3> Corners;
    Vector3 Middle;
    Vector3 AreaVector; ///< along the normal, as long as the area is large
    double Radius;      ///< of the sphere around Middle
    std::size_t Index;  ///< in the light
  };
  void CutIntoPatches(std::size_t begin, std::size_t end, std::size_t patches);
  void AddPatch(std::size_t begin, std::size_t end);
  void AddGaussPoints(const Triangle& triangle, const GaussLegendre& rule);
  void LookAtTriangle(const Triangle& triangle, const Vector3& from, std::vector<IncidentSample>& samples) const;
  void LookAround(const Triangle& triangle, const Vector3& from, std::vector<IncidentSample>& samples) const;
  double AddSector(const Triangle& triangle, const Vector3& from, const Vector3& axis, const Vector3& b,
    const Vector3& c, std::vector<IncidentSample>& samples) const;

  int Side = 0; ///< Gauss points along a side of every triangle; 0: groups of triangles
  double FarEnough; ///< how much farther than at level 0 points by area do
  GaussLegendre NearRule;
  GaussLegendre TurnRule;
  GaussLegendre TiltRule;
  std::vector<Triangle> Ordered;
  std::vector<Patch> AllPatches;
  std::vector<LightPoint> AllPoints;
  Box NearBounds;
};

} // namespace shadowcones

#endif
