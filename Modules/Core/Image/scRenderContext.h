// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRenderContext.h
 * @brief What rendering in the light of one light reads again and again. Internal to Core.
 */
#ifndef scRenderContext_h
#define scRenderContext_h

#include "scExtinctionGroups.h"
#include "scLightStrata.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"

namespace shadowcones
{

/// For any part of the image: the options' Extent is not looked at. Scene and options must outlive it.
struct RenderContext
{
  RenderContext(const ScatteringScene& scene, const ScatteringOptions& options)
    : Scene(scene)
    , Options(options)
    , Groups(scene.Light.Spectrum, scene.Medium)
    , Strata(options.NumberOfLightSamples)
  {
  }

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups Groups;
  const LightStrata Strata; ///< of the light samples of one place
};

} // namespace shadowcones

#endif
