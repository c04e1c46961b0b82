// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scRectangleShape.h
 * @brief The functions of a rectangle: see scLightShapes.h. Internal to Core.
 */
#ifndef scRectangleShape_h
#define scRectangleShape_h

#include "scConcentricMap.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scShapeParts.h"
#include "scSphericalRectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shadowcones
{

struct RectangleShape
{
  static const char* Prepare(Light& light)
  {
    const char* fault = CheckLightCenter(light);
    fault = fault ? fault : CheckLightNormal(light);
    return fault ? fault : StraightenAxes(light);
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    AddVector(fingerprint, light.Center);
    AddVector(fingerprint, light.Normal);
    AddVector(fingerprint, light.AxisU);
    AddVector(fingerprint, light.AxisV);
  }

  static double Area(const Light& light) { return 4.0 * Length(Cross(light.AxisU, light.AxisV)); }

  static void BoundingSphere(const Light& light, Vector3& center, double& radius)
  {
    center = light.Center;
    radius = std::sqrt(RadiusSquared(light));
  }

  static std::vector<Vector3> Hull(const Light& light)
  {
    std::vector<Vector3> points;
    for (const double u : { -1.0, 1.0 })
    {
      for (const double v : { -1.0, 1.0 })
      {
        points.push_back(light.Center + u * light.AxisU + v * light.AxisV);
      }
    }
    return points;
  }

  static FlatFace Face(const Light& light)
  {
    return { true, light.Center, light.Normal,
      std::max(Length(light.AxisU + light.AxisV), Length(light.AxisU - light.AxisV)) };
  }

  static LightSurfaceSample SampleArea(const Light& light, double u, double v)
  {
    return { light.Center + (2.0 * u - 1.0) * light.AxisU + (2.0 * v - 1.0) * light.AxisV, light.Normal,
      1.0 / Area(light) };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    const Vector3 offset = position - light.Center;
    return { UnitInterval(0.5 + 0.5 * Dot(offset, light.AxisU) / Dot(light.AxisU, light.AxisU)),
      UnitInterval(0.5 + 0.5 * Dot(offset, light.AxisV) / Dot(light.AxisV, light.AxisV)) };
  }

  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3& from, double u, double v)
  {
    const SphericalRectangle rectangle = SeenFrom(light, from);
    const double solidAngle = rectangle.SolidAngle();
    if (!(solidAngle > 0.0))
    {
      return TowardsCenter(light, from);
    }
    if (solidAngle < SphericalRectangle::MinimumSolidAngle)
    {
      return DirectionOf(SampleArea(light, u, v), from);
    }
    const Vector3 to = rectangle.Sample(u, v);
    const double distance = Length(to);
    return { (1.0 / distance) * to, distance, 1.0 / solidAngle };
  }

  static double SolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
  {
    PlaneHit hit;
    if (!HitPlane(light, from, direction, hit) || !Holds(light, hit))
    {
      return 0.0;
    }
    const double solidAngle = SolidAngle(light, from);
    return solidAngle < SphericalRectangle::MinimumSolidAngle ? Square(hit.Distance) / (hit.Cosine * Area(light))
                                                              : 1.0 / solidAngle;
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
  {
    const SphericalRectangle rectangle = SeenFrom(light, from);
    if (!(rectangle.SolidAngle() > 0.0))
    {
      return { 0.5, 0.5 };
    }
    if (rectangle.SolidAngle() < SphericalRectangle::MinimumSolidAngle)
    {
      PlaneHit hit;
      HitPlane(light, from, direction, hit);
      return InvertArea(light, from + hit.Distance * direction);
    }
    const std::array<double, 2> uv = rectangle.Invert(direction);
    return { UnitInterval(uv[0]), UnitInterval(uv[1]) };
  }

  static double SolidAngle(const Light& light, const Vector3& from) { return SeenFrom(light, from).SolidAngle(); }

  static IncidentSample SampleIncident(
    const Light& light, const Vector3& from, double u, double v, LightSampling sampling)
  {
    const bool bySolidAngle = sampling == LightSampling::SolidAngle ||
      (sampling == LightSampling::Auto && IsNearFlatLight(light, RadiusSquared(light), from));
    return IncidentOf(bySolidAngle ? SampleSolidAngle(light, from, u, v) : SampleVisible(light, from, u, v));
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return DirectionOf(SampleArea(light, u, v), from);
  }

private:
  static double RadiusSquared(const Light& light)
  {
    return Dot(light.AxisU, light.AxisU) + Dot(light.AxisV, light.AxisV);
  }
  static SphericalRectangle SeenFrom(const Light& light, const Vector3& from)
  {
    return { light.Center, light.Normal, light.AxisU, light.AxisV, from };
  }
  static bool Holds(const Light& light, const PlaneHit& hit)
  {
    const double u = Length(light.AxisU);
    const double v = Length(light.AxisV);
    return std::fabs(Dot(hit.Offset, light.AxisU)) <= u * (u + hit.Error) &&
      std::fabs(Dot(hit.Offset, light.AxisV)) <= v * (v + hit.Error);
  }

  /// nullptr, or what is wrong with the axes; they and the normal are exactly at right angles from here on.
  static const char* StraightenAxes(Light& light)
  {
    if (!IsFinite(light.AxisU) || !IsFinite(light.AxisV))
    {
      return "The axes of the rectangular light must be finite.";
    }
    const double u = Length(light.AxisU);
    const double v = Length(light.AxisV);
    if (!(u > 0.0 && v > 0.0))
    {
      return "The rectangular light has zero area: both axes must be longer than 0.";
    }
    constexpr double tolerance = 1e-6;
    if (std::fabs(Dot(light.AxisU, light.AxisV)) > tolerance * u * v)
    {
      return "The axes of the rectangular light must be at right angles to each other.";
    }
    if (std::fabs(Dot(light.Normal, light.AxisU)) > tolerance * u ||
      std::fabs(Dot(light.Normal, light.AxisV)) > tolerance * v)
    {
      return "The normal of the rectangular light must be at right angles to its axes.";
    }
    const Vector3 unitU = (1.0 / u) * light.AxisU;
    light.AxisV = v * Normalized(light.AxisV - Dot(light.AxisV, unitU) * unitU);
    const Vector3 normal = Normalized(Cross(light.AxisU, light.AxisV));
    light.Normal = Dot(normal, light.Normal) < 0.0 ? -normal : normal;
    return nullptr;
  }
};

} // namespace shadowcones

#endif
