// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadingScene.h
 * @brief What shading the surfaces of an image shares. Internal to Core.
 */
#ifndef scShadingScene_h
#define scShadingScene_h

#include "scExtinctionGroups.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scShadingLight.h"
#include "scVisibleLight.h"

#include <memory>
#include <vector>

namespace shadowcones
{

/// What shading any part of an image shares.
struct ShadingScene
{
  /// @param scenes one a light; @param visibleLights one a light, or none where the camera does not see them.
  ShadingScene(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
    const std::vector<VisibleLight>& visibleLights);

  const std::vector<ScatteringScene>& Scenes;
  const ScatteringOptions& Options;
  const ExtinctionGroups Groups; ///< their ScatteredRadiance is that of the first light
  const std::vector<VisibleLight>& Visible;
  std::vector<std::unique_ptr<const ShadingLight>> Lights;
};

} // namespace shadowcones

#endif
