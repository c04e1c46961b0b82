// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRenderScattering.h
 * @brief Light shafts along camera rays, by the ray marcher of Hougs and Day (section 4.3) and by faster estimators.
 */
#ifndef scRenderScattering_h
#define scRenderScattering_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"

#include <array>
#include <vector>

namespace shadowcones
{

/**
 * Render the extent in the light of several lights: one scene each, which differ in Light, Cones and Visibility alone.
 * What the lights send adds up; samples and options count for each of them. Every light takes the random numbers that
 * it would take alone, so that images of single lights add up to the image of all. "RelativeError" adds the lights'
 * errors as if they were the same ones, and is no less than what they are together. A lamp hides no other.
 *
 * Guided without cones samples the whole of every ray. @return false where aborted. Throws std::invalid_argument where
 * the options are wrong.
 */
SHADOWCONESCORE_EXPORT bool RenderScattering(const std::vector<ScatteringScene>& scenes,
  const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image);
/// The same for one light.
SHADOWCONESCORE_EXPORT bool RenderScattering(
  const ScatteringScene& scene, const ScatteringOptions& options, const Monitor& monitor, ScatteringImage& image);

/**
 * The same for several parts of the image: image k is that of extents[k] (i from, to, j from, to, inclusive), with the
 * values that it has in the whole. Options.Extent is not used.
 */
SHADOWCONESCORE_EXPORT bool RenderScattering(const std::vector<ScatteringScene>& scenes,
  const ScatteringOptions& options, const std::vector<std::array<int, 4>>& extents, const Monitor& monitor,
  std::vector<ScatteringImage>& images);

} // namespace shadowcones

#endif
