// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSunShape.h
 * @brief The functions of a Sun, a disc of directions: see scLightShapes.h. Internal to Core.
 */
#ifndef scSunShape_h
#define scSunShape_h

#include "scConstants.h"
#include "scDirectionCone.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scShapeParts.h"

#include <array>
#include <cmath>
#include <vector>

namespace shadowcones
{

struct SunShape
{
  static const char* Prepare(Light& light)
  {
    return light.Radius >= 0.0 && light.Radius <= 0.5 * Pi
      ? CheckLightNormal(light)
      : "The sun's angular diameter must be from 0 to 180 degrees.";
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    AddVector(fingerprint, light.Normal);
    fingerprint.AddNumber(light.Radius);
  }

  static double Area(const Light&) { return 0.0; }

  static void BoundingSphere(const Light&, Vector3& center, double& radius)
  {
    center = {};
    radius = 0.0;
  }

  static std::vector<Vector3> Hull(const Light&) { return {}; }

  static FlatFace Face(const Light&) { return {}; }

  /// Position is the direction towards the sampled point of its face.
  static LightSurfaceSample SampleArea(const Light& light, double u, double v)
  {
    const DirectionCone cone = ConeOf(light);
    double oneMinusCosine = 0.0;
    const Vector3 direction = cone.Sample(u, v, oneMinusCosine);
    return { direction, -direction, cone.Pdf() };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    return ConeOf(light).Invert(Normalized(position));
  }

  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3&, double u, double v)
  {
    const DirectionCone cone = ConeOf(light);
    double oneMinusCosine = 0.0;
    return { cone.Sample(u, v, oneMinusCosine), HUGE_VAL, cone.Pdf() };
  }

  static double SolidAnglePdf(const Light& light, const Vector3&, const Vector3& direction)
  {
    const DirectionCone cone = ConeOf(light);
    return cone.Contains(direction) || SameDirection(direction, cone.Axis) ? cone.Pdf() : 0.0;
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3&, const Vector3& direction)
  {
    return ConeOf(light).Invert(direction);
  }

  static double SolidAngle(const Light& light, const Vector3&) { return ConeOf(light).SolidAngle(); }

  /// Its spectrum is an irradiance: every direction brings all of it.
  static IncidentSample SampleIncident(const Light& light, const Vector3& from, double u, double v, LightSampling)
  {
    const LightDirectionSample sample = SampleSolidAngle(light, from, u, v);
    return { sample.Direction, sample.Distance, 1.0 };
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return SampleSolidAngle(light, from, u, v);
  }

private:
  static DirectionCone ConeOf(const Light& light)
  {
    return { -light.Normal, 2.0 * Square(std::sin(0.5 * light.Radius)) };
  }
};

} // namespace shadowcones

#endif
