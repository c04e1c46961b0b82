// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSphereShape.h
 * @brief The functions of a sphere: see scLightShapes.h. Internal to Core.
 */
#ifndef scSphereShape_h
#define scSphereShape_h

#include "scConstants.h"
#include "scDirectionCone.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scShapeParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shadowcones
{

struct SphereShape
{
  static const char* Prepare(Light& light)
  {
    const char* fault = CheckLightCenter(light);
    return fault ? fault : CheckLightRadius(light);
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    AddVector(fingerprint, light.Center);
    fingerprint.AddNumber(light.Radius);
  }

  static double Area(const Light& light) { return 4.0 * Pi * Square(light.Radius); }

  static void BoundingSphere(const Light& light, Vector3& center, double& radius)
  {
    center = light.Center;
    radius = light.Radius;
  }

  static std::vector<Vector3> Hull(const Light&) { return {}; }

  static FlatFace Face(const Light&) { return {}; }

  static LightSurfaceSample SampleArea(const Light& light, double u, double v)
  {
    const double z = 1.0 - 2.0 * u;
    const double ring = 2.0 * std::sqrt(std::max(u * (1.0 - u), 0.0));
    const Vector3 normal{ ring * std::cos(2.0 * Pi * v), ring * std::sin(2.0 * Pi * v), z };
    return { light.Center + light.Radius * normal, normal, 1.0 / Area(light) };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    const Vector3 offset = position - light.Center;
    const double azimuth = std::atan2(offset.Y, offset.X) / (2.0 * Pi);
    // The half angle from the pole keeps its digits at both poles.
    const double polar = std::atan2(std::hypot(offset.X, offset.Y), offset.Z);
    return { UnitInterval(Square(std::sin(0.5 * polar))), UnitInterval(azimuth < 0.0 ? azimuth + 1.0 : azimuth) };
  }

  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3& from, double u, double v)
  {
    double distance = 0.0;
    const DirectionCone cone = ConeFrom(light, from, distance);
    if (cone.OneMinusCosine < 0.0)
    {
      return TowardsCenter(light, from);
    }
    double oneMinusCosine = 0.0;
    const Vector3 direction = cone.Sample(u, v, oneMinusCosine);
    const double sineSquared = oneMinusCosine * (2.0 - oneMinusCosine);
    const double depth = std::sqrt(std::max(Square(light.Radius) - Square(distance) * sineSquared, 0.0));
    return { direction, std::max(distance * (1.0 - oneMinusCosine) - depth, 0.0), cone.Pdf() };
  }

  static double SolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
  {
    double distance = 0.0;
    const DirectionCone cone = ConeFrom(light, from, distance);
    return cone.OneMinusCosine >= 0.0 && cone.Contains(direction) ? cone.Pdf() : 0.0;
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
  {
    double distance = 0.0;
    const DirectionCone cone = ConeFrom(light, from, distance);
    return cone.OneMinusCosine >= 0.0 ? cone.Invert(direction) : std::array<double, 2>{ 0.5, 0.5 };
  }

  static double SolidAngle(const Light& light, const Vector3& from)
  {
    double distance = 0.0;
    const DirectionCone cone = ConeFrom(light, from, distance);
    return cone.OneMinusCosine > 0.0 ? cone.SolidAngle() : 0.0;
  }

  static IncidentSample SampleIncident(
    const Light& light, const Vector3& from, double u, double v, LightSampling sampling)
  {
    return IncidentOf(sampling == LightSampling::Area ? DirectionOf(SampleArea(light, u, v), from)
                                                      : SampleSolidAngle(light, from, u, v));
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return SampleSolidAngle(light, from, u, v);
  }

private:
  /// The cone in which the sphere is seen; its size is negative from inside.
  static DirectionCone ConeFrom(const Light& light, const Vector3& from, double& distance)
  {
    const Vector3 toCenter = light.Center - from;
    distance = Length(toCenter);
    if (!(distance >= light.Radius))
    {
      return { Normalized(toCenter), -1.0 };
    }
    const double squared = Square(light.Radius / distance);
    return { (1.0 / distance) * toCenter, squared / (1.0 + std::sqrt(1.0 - squared)) };
  }
};

} // namespace shadowcones

#endif
