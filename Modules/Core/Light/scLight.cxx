// SPDX-License-Identifier: BSD-3-Clause
#include "scLight.h"

#include "scFingerprint.h"
#include "scLightShapes.h"

#include <cmath>

namespace shadowcones
{

const char* PrepareLight(Light& light)
{
  for (const double value : light.Spectrum)
  {
    if (!std::isfinite(value))
    {
      return "The light's spectrum has a value that is not finite.";
    }
    if (value < 0.0)
    {
      return "The light's spectrum has a negative value.";
    }
  }
  return VisitShape(light, [&](auto shape) { return shape.Prepare(light); });
}

std::uint64_t FingerprintOf(const Light& light)
{
  Fingerprint fingerprint;
  fingerprint.AddWord(static_cast<std::uint64_t>(light.Shape));
  VisitShape(light, [&](auto shape) { shape.AddTo(fingerprint, light); });
  return fingerprint.Value();
}

double LightArea(const Light& light)
{
  return VisitShape(light, [&](auto shape) { return shape.Area(light); });
}

void LightBoundingSphere(const Light& light, Vector3& center, double& radius)
{
  VisitShape(light, [&](auto shape) { shape.BoundingSphere(light, center, radius); });
}

std::vector<Vector3> LightHull(const Light& light)
{
  return VisitShape(light, [&](auto shape) { return shape.Hull(light); });
}

} // namespace shadowcones
