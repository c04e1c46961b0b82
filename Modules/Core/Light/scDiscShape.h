// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDiscShape.h
 * @brief The functions of a disc: see scLightShapes.h. Internal to Core.
 */
#ifndef scDiscShape_h
#define scDiscShape_h

#include "scConcentricMap.h"
#include "scConstants.h"
#include "scFingerprint.h"
#include "scFlatFace.h"
#include "scFrame.h"
#include "scShapeParts.h"
#include "scSphericalEllipse.h"

#include <array>
#include <cmath>
#include <vector>

namespace shadowcones
{

struct DiscShape
{
  static constexpr int HullPoints = 32;

  static const char* Prepare(Light& light)
  {
    const char* fault = CheckLightCenter(light);
    fault = fault ? fault : CheckLightRadius(light);
    return fault ? fault : CheckLightNormal(light);
  }

  static void AddTo(Fingerprint& fingerprint, const Light& light)
  {
    AddVector(fingerprint, light.Center);
    AddVector(fingerprint, light.Normal);
    fingerprint.AddNumber(light.Radius);
  }

  static double Area(const Light& light) { return Pi * Square(light.Radius); }

  static void BoundingSphere(const Light& light, Vector3& center, double& radius)
  {
    center = light.Center;
    radius = light.Radius;
  }

  /// Corners of a polygon around the disc.
  static std::vector<Vector3> Hull(const Light& light)
  {
    std::vector<Vector3> points;
    const Frame frame = FrameAround(light.Normal);
    const double radius = light.Radius / std::cos(Pi / HullPoints);
    for (int i = 0; i < HullPoints; ++i)
    {
      const double angle = 2.0 * Pi * i / HullPoints;
      points.push_back(light.Center + radius * std::cos(angle) * frame.U + radius * std::sin(angle) * frame.V);
    }
    return points;
  }

  static FlatFace Face(const Light& light) { return { true, light.Center, light.Normal, light.Radius }; }

  static LightSurfaceSample SampleArea(const Light& light, double u, double v)
  {
    const std::array<double, 2> disc = ConcentricDisc(u, v);
    const Frame frame = FrameAround(light.Normal);
    return { light.Center + (light.Radius * disc[0]) * frame.U + (light.Radius * disc[1]) * frame.V, light.Normal,
      1.0 / Area(light) };
  }

  static std::array<double, 2> InvertArea(const Light& light, const Vector3& position)
  {
    const Vector3 offset = position - light.Center;
    const Frame frame = FrameAround(light.Normal);
    return InvertConcentricDisc(Dot(offset, frame.U) / light.Radius, Dot(offset, frame.V) / light.Radius);
  }

  static LightDirectionSample SampleSolidAngle(const Light& light, const Vector3& from, double u, double v)
  {
    const SphericalEllipse ellipse(light.Center, light.Normal, light.Radius, from);
    const double solidAngle = ellipse.SolidAngle();
    if (!(solidAngle > 0.0))
    {
      return TowardsCenter(light, from);
    }
    const Vector3 direction = ellipse.Sample(u, v);
    const double cosine = -Dot(direction, light.Normal);
    return { direction, cosine > 0.0 ? ellipse.Height() / cosine : HUGE_VAL, 1.0 / solidAngle };
  }

  static double SolidAnglePdf(const Light& light, const Vector3& from, const Vector3& direction)
  {
    PlaneHit hit;
    const bool inside = HitPlane(light, from, direction, hit) && Length(hit.Offset) <= light.Radius + hit.Error;
    return inside ? 1.0 / SolidAngle(light, from) : 0.0;
  }

  static std::array<double, 2> InvertSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
  {
    const SphericalEllipse ellipse(light.Center, light.Normal, light.Radius, from);
    if (!(ellipse.SolidAngle() > 0.0))
    {
      return { 0.5, 0.5 };
    }
    const std::array<double, 2> uv = ellipse.Invert(direction);
    return { UnitInterval(uv[0]), UnitInterval(uv[1]) };
  }

  static double SolidAngle(const Light& light, const Vector3& from)
  {
    return SphericalEllipse(light.Center, light.Normal, light.Radius, from).SolidAngle();
  }

  static IncidentSample SampleIncident(
    const Light& light, const Vector3& from, double u, double v, LightSampling sampling)
  {
    const bool bySolidAngle = sampling == LightSampling::SolidAngle ||
      (sampling == LightSampling::Auto && IsNearFlatLight(light, Square(light.Radius), from));
    return IncidentOf(bySolidAngle ? SampleSolidAngle(light, from, u, v) : SampleVisible(light, from, u, v));
  }

  static LightDirectionSample SampleVisible(const Light& light, const Vector3& from, double u, double v)
  {
    return DirectionOf(SampleArea(light, u, v), from);
  }
};

} // namespace shadowcones

#endif
