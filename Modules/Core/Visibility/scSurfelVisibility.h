// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfelVisibility.h
 * @brief The base discs of cones as the only occluders: which light samples they hide from a point. Internal to Core.
 */
#ifndef scSurfelVisibility_h
#define scSurfelVisibility_h

#include "scCone.h"
#include "scConeTree.h"
#include "scLightExtent.h"
#include "scLightPatterns.h"
#include "scOccluderMasks.h"

#include <vector>

namespace shadowcones
{

/**
 * A cone that holds the whole shadow of a disc under the light. The disc may be tilted: the base of the cone goes
 * through the point of the disc that is nearest to the light, and nothing of the disc is farther from the axis than its
 * radius.
 * @return false where the light is too near for a cone.
 */
bool PenumbraOf(const Cone& disc, const Light& light, const LightExtent& extent, Cone& penumbra);

/// Built once, queried often, from any number of threads.
class SurfelVisibility
{
public:
  /// Queries are for points in @p bounds. @p onSurfaces: a point on a curved surface is not hidden by that surface's
  /// discs.
  SurfelVisibility(const std::vector<Cone>& cones, const LightPatterns& light, const Box& bounds, bool onSurfaces);

  /// The discs whose shadow may reach the point; @p surfels is overwritten.
  void Find(const Vector3& point, std::vector<int>& surfels) const;
  /// Add what these discs hide of @p view, which was taken from @p point.
  void Hide(const Vector3& point, const std::vector<int>& surfels, const LightView& view, OccluderMasks& masks) const;

private:
  struct Surfel
  {
    Vector3 Center;
    Vector3 Normal;
    double Radius;
    double Tolerance; ///< points this near to the plane lie on it
    int OccluderId;
  };
  void HideBySurfel(const Surfel& surfel, const Vector3& point, const LightView& view, OccluderMasks& masks) const;

  const LightPatterns& Light;
  std::vector<Surfel> Surfels;
  std::vector<Cone> Penumbrae;  ///< of the surfels in Tree
  std::vector<double> Tangents; ///< of the penumbrae
  std::vector<int> SurfelOf;    ///< of the penumbrae
  std::vector<int> Unbounded;   ///< surfels next to the light: any point may be in their shadow
  ConeTree Tree;
};

} // namespace shadowcones

#endif
