// SPDX-License-Identifier: BSD-3-Clause
#include "scShadingScene.h"

namespace shadowcones
{

ShadingScene::ShadingScene(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const std::vector<VisibleLight>& visibleLights)
  : Scenes(scenes)
  , Options(options)
  , Groups(scenes.front().Light.Spectrum, scenes.front().Medium)
  , Visible(visibleLights)
  , Strata(options.NumberOfSurfaceLightSamples)
  , EdgeStrata((options.NumberOfSurfaceLightSamples + 1) / 2)
{
  for (const ScatteringScene& scene : scenes)
  {
    this->Lights.push_back(std::make_unique<ShadingLight>(scene, options));
  }
}

} // namespace shadowcones
