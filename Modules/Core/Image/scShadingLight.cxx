// SPDX-License-Identifier: BSD-3-Clause
#include "scShadingLight.h"

#include "scLampPlane.h"

namespace shadowcones
{

namespace
{
bool IsSinglePlace(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Sun && !(light.Radius > 0.0)) ||
    (light.Shape == LightShape::Mesh && light.Triangles.empty() && light.Vertices.size() == 1);
}
} // anonymous namespace

ShadingLight::ShadingLight(const ScatteringScene& scene, const ScatteringOptions& options)
  : Scene(scene)
  , Occlusion(scene, options)
  , Rules(scene.ShadowCasters().RulesFor(FlatFaceOf(scene.Light)))
  , IsSingle(IsSinglePlace(scene.Light))
{
  const int levels = scene.Light.Shape == LightShape::Mesh ? 0 : (this->IsSingle ? 1 : LightRule::NumberOfLevels);
  for (int level = 0; level < levels; ++level)
  {
    this->Levels.push_back(std::make_unique<LightRule>(scene.Light, level));
  }
}

} // namespace shadowcones
