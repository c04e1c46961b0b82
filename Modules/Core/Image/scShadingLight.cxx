// SPDX-License-Identifier: BSD-3-Clause
#include "scShadingLight.h"

#include "scLampPlane.h"

namespace shadowcones
{

ShadingLight::ShadingLight(const ScatteringScene& scene, const ScatteringOptions& options)
  : Scene(scene)
  , Occlusion(scene, options)
  , Rules(scene.Occluders.RulesFor(FlatFaceOf(scene.Light)))
  , UsesRule(!IsMarched(options.Mode) && scene.Light.Shape != LightShape::Mesh)
  , Rule(scene.Light, 0)
  , NearRule(scene.Light, 2)
{
}

const LightRule& ShadingLight::RuleAt(const Vector3& point) const
{
  const bool planar = this->Scene.Light.Shape == LightShape::Disc || this->Scene.Light.Shape == LightShape::Rectangle;
  return planar && !this->Rule.IsByArea(point) ? this->NearRule : this->Rule;
}

} // namespace shadowcones
