// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightSampler.h
 * @brief SampleIncidentLight for many samples from one point: what they share is computed once. Internal to Core.
 */
#ifndef scLightSampler_h
#define scLightSampler_h

#include "scConcentricMap.h"
#include "scLight.h"
#include "scLightSampling.h"
#include "scSphericalEllipse.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shadowcones
{

/**
 * Gives what SampleIncidentLight gives, up to rounding: discs and rectangles by area from a prepared frame, and the
 * spherical ellipse of a near disc built once a point. One sampler a thread; the light must outlive it.
 */
class LightSampler
{
public:
  LightSampler(const Light& light, LightSampling sampling)
    : Lamp(light)
    , Sampling(sampling)
  {
    if (light.Shape == LightShape::Disc)
    {
      const Frame frame = FrameAround(light.Normal);
      this->U = light.Radius * frame.U;
      this->V = light.Radius * frame.V;
    }
    else if (light.Shape == LightShape::Rectangle)
    {
      this->U = light.AxisU;
      this->V = light.AxisV;
    }
    this->Area = LightArea(light);
    // As scLight.h says: by solid angle within two radii of the sphere around a disc or rectangle.
    const bool disc = light.Shape == LightShape::Disc;
    this->NearSquared = 9.0 * (disc ? light.Radius * light.Radius : Dot(this->U, this->U) + Dot(this->V, this->V));
  }

  void MoveTo(const Vector3& from)
  {
    this->From = from;
    this->ToCenter = this->Lamp.Center - from;
    const bool planar = this->Lamp.Shape == LightShape::Disc || this->Lamp.Shape == LightShape::Rectangle;
    const bool near = this->Sampling == LightSampling::SolidAngle ||
      (this->Sampling == LightSampling::Auto && Dot(this->ToCenter, this->ToCenter) < this->NearSquared);
    this->ByArea = planar && !near;
    this->Ellipse.reset();
    if (this->Lamp.Shape == LightShape::Disc && near)
    {
      this->Ellipse.emplace(this->Lamp.Center, this->Lamp.Normal, this->Lamp.Radius, from);
    }
  }

  IncidentSample Sample(double u, double v) const
  {
    if (this->ByArea)
    {
      double a = 2.0 * u - 1.0;
      double b = 2.0 * v - 1.0;
      if (this->Lamp.Shape == LightShape::Disc)
      {
        ConcentricDiscBySeries(a, b);
      }
      const Vector3 to = this->ToCenter + a * this->U + b * this->V;
      const double squared = Dot(to, to);
      const double distance = std::sqrt(squared);
      const double inverse = 1.0 / distance;
      const double cosine = -Dot(to, this->Lamp.Normal) * inverse;
      return { inverse * to, distance, cosine > 0.0 ? this->Area * cosine / squared : 0.0 };
    }
    if (this->Ellipse)
    {
      const double solidAngle = this->Ellipse->SolidAngle();
      if (!(solidAngle > 0.0))
      {
        return { Normalized(this->ToCenter), Length(this->ToCenter), 0.0 };
      }
      const Vector3 direction = this->Ellipse->Sample(u, v);
      const double cosine = -Dot(direction, this->Lamp.Normal);
      return { direction, cosine > 0.0 ? this->Ellipse->Height() / cosine : HUGE_VAL, solidAngle };
    }
    return SampleIncidentLight(this->Lamp, this->From, u, v, this->Sampling);
  }

private:
  const Light& Lamp;
  const LightSampling Sampling;
  Vector3 U;
  Vector3 V;
  double Area = 0.0;
  double NearSquared = 0.0;
  Vector3 From;
  Vector3 ToCenter;
  bool ByArea = false;
  std::optional<SphericalEllipse> Ellipse;
};

} // namespace shadowcones

#endif
