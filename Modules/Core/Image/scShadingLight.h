// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadingLight.h
 * @brief What shading by one light shares among pixels. Internal to Core.
 */
#ifndef scShadingLight_h
#define scShadingLight_h

#include "scLightRule.h"
#include "scOccluderScene.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scSurfaceOcclusion.h"

namespace shadowcones
{

/// What shading by one light shares among pixels.
struct ShadingLight
{
  ShadingLight(const ScatteringScene& scene, const ScatteringOptions& options);

  const ScatteringScene& Scene;
  const SurfaceOcclusion Occlusion;
  const RayRules Rules; ///< for what is flush with the light
  /// Where nothing can hide the light, the modes that are not bound to the bytes of BruteForce integrate without noise.
  const bool UsesRule;
  /// The rule for light that nothing hides from a surface point.
  const LightRule& RuleAt(const Vector3& point) const;

private:
  const LightRule Rule;
  const LightRule NearRule; ///< close to a planar light, where the surface's horizon may cut it
};

} // namespace shadowcones

#endif
