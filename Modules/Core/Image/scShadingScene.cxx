// SPDX-License-Identifier: BSD-3-Clause
#include "scShadingScene.h"

#include "scSurfaceLight.h"
#include "scSurfacePoint.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// The image's mean is looked at along so many rays by so many, with samples each; at less than one in all of them it
/// is not known.
constexpr int lookSide = 8;
constexpr int lookSamples = 16;
/// Pixels darker than this fraction of the image's mean are sampled as if they had it.
constexpr double darkestFraction = 0.1;

/// The mean radiance of surfaces in the light of one lamp, over the whole image, whatever part of it is asked for.
double LookAtImage(const ShadingLight& light, const ScatteringOptions& options, const ExtinctionGroups& groups)
{
  const ScatteringScene& scene = light.Scene;
  const SurfacePoints points(scene, options, groups);
  SurfaceLight surfaceLight(light, options, groups);
  SurfacePoint point;
  SurfaceEstimate estimate;
  double shown = 0.0;
  double lit = 0.0;
  for (int k = 0; k < lookSide * lookSide; ++k)
  {
    const int i = k % lookSide;
    const int j = k / lookSide;
    const Ray ray = scene.Camera.PixelRay((i + 0.5) * options.Width / lookSide - 0.5,
      (j + 0.5) * options.Height / lookSide - 0.5, options.Width, options.Height);
    const PrimaryHit hit = NearestSurface(scene.Occluders, ray);
    if (hit.HasSurface())
    {
      points.Find(ray, hit, point);
      surfaceLight.Look(point, lookSamples, 0, PixelShift(i, j), estimate);
      shown += estimate.Mean;
      lit += estimate.MeanLit;
    }
  }
  constexpr double rays = lookSide * lookSide;
  return std::max(shown, lit / (rays * lookSamples)) / rays;
}
} // anonymous namespace

ShadingScene::ShadingScene(const std::vector<ScatteringScene>& scenes, const ScatteringOptions& options,
  const std::vector<VisibleLight>& visibleLights)
  : Scenes(scenes)
  , Options(options)
  , Groups(scenes.front().Light.Spectrum, scenes.front().Medium)
  , Visible(visibleLights)
{
  for (const ScatteringScene& scene : scenes)
  {
    auto light = std::make_unique<ShadingLight>(scene, options);
    if (options.NumberOfSurfaceLightSamples > 0)
    {
      light->Darkest = darkestFraction * LookAtImage(*light, options, this->Groups);
    }
    this->Lights.push_back(std::move(light));
  }
}

} // namespace shadowcones
