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

#include <memory>
#include <vector>

namespace shadowcones
{

/// What shading by one light shares among pixels.
struct ShadingLight
{
  ShadingLight(const ScatteringScene& scene, const ScatteringOptions& options);

  const ScatteringScene& Scene;
  const SurfaceOcclusion Occlusion;
  const RayRules Rules; ///< for what is flush with the light
  /// All of it comes from one place: one ray says whether it is seen.
  const bool IsSingle;
  /// For light that nothing hides, ever finer; none for mesh lights, whose points are too many.
  std::vector<std::unique_ptr<const LightRule>> Levels;
  /// Surfaces that are darker, as a mean over wavelengths, are sampled as if they were this bright.
  double Darkest = 0.0;
};

} // namespace shadowcones

#endif
