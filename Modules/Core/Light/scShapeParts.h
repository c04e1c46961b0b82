// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShapeParts.h
 * @brief What several shapes of light share. Internal to Core.
 */
#ifndef scShapeParts_h
#define scShapeParts_h

#include "scFingerprint.h"
#include "scLightSampling.h"

#include <cmath>

namespace shadowcones
{

inline double Square(double x)
{
  return x * x;
}

/// @name nullptr, or what is wrong with a value of the light
///@{
inline const char* CheckLightCenter(const Light& light)
{
  return IsFinite(light.Center) ? nullptr : "The light's center must be finite.";
}
inline const char* CheckLightRadius(const Light& light)
{
  return std::isfinite(light.Radius) && light.Radius > 0.0 ? nullptr
                                                           : "The light's radius must be finite and larger than 0.";
}
/// Makes it a unit vector.
inline const char* CheckLightNormal(Light& light)
{
  const double length = Length(light.Normal);
  if (!(std::isfinite(length) && length > 0.0))
  {
    return "The light's normal must be finite and longer than 0.";
  }
  light.Normal = (1.0 / length) * light.Normal;
  return nullptr;
}
///@}

/// A point of the light seen from another one: its density per steradian; 0 on the dark side.
inline LightDirectionSample DirectionOf(const LightSurfaceSample& surface, const Vector3& from)
{
  const Vector3 to = surface.Position - from;
  const double distance = Length(to);
  if (!(distance > 0.0))
  {
    return { -surface.Normal, 0.0, 0.0 };
  }
  const Vector3 direction = (1.0 / distance) * to;
  const double cosine = -Dot(direction, surface.Normal);
  return { direction, distance, cosine > 0.0 ? surface.Pdf * Square(distance) / cosine : 0.0 };
}

/// The direction to the centre of a light that cannot be seen.
inline LightDirectionSample TowardsCenter(const Light& light, const Vector3& from)
{
  const Vector3 to = light.Center - from;
  const double distance = Length(to);
  return { distance > 0.0 ? (1.0 / distance) * to : -light.Normal, distance, 0.0 };
}

/// What a direction brings of the light.
inline IncidentSample IncidentOf(const LightDirectionSample& sample)
{
  return { sample.Direction, sample.Distance, sample.Pdf > 0.0 ? 1.0 / sample.Pdf : 0.0 };
}

/// For fingerprints.
inline void AddVector(Fingerprint& fingerprint, const Vector3& v)
{
  fingerprint.AddNumber(v.X);
  fingerprint.AddNumber(v.Y);
  fingerprint.AddNumber(v.Z);
}

/// Directions differ by rounding alone.
inline bool SameDirection(const Vector3& a, const Vector3& b)
{
  return Length(a - b) <= 1e-12;
}

/// Where a ray meets the plane of a flat light from the side that is lit.
struct PlaneHit
{
  double Distance = 0.0;
  double Cosine = 0.0;
  Vector3 Offset;     ///< from the light's centre
  double Error = 0.0; ///< of the offset, by rounding
};

/// @return false where the ray does not meet the emitting side; @p hit is then of no use but for its Distance.
inline bool HitPlane(const Light& light, const Vector3& from, const Vector3& direction, PlaneHit& hit)
{
  const Vector3 toCenter = light.Center - from;
  const double height = -Dot(toCenter, light.Normal);
  hit.Cosine = -Dot(direction, light.Normal);
  if (!(height > 0.0 && hit.Cosine > 0.0))
  {
    return false;
  }
  hit.Distance = height / hit.Cosine;
  hit.Offset = hit.Distance * direction - toCenter;
  hit.Error = 1e-15 * (hit.Distance + Length(toCenter)) / hit.Cosine;
  return true;
}

/// Is a point within two radii of the sphere around a flat light, given the square of that sphere's radius?
inline bool IsNearFlatLight(const Light& light, double radiusSquared, const Vector3& from)
{
  const Vector3 toCenter = light.Center - from;
  return Dot(toCenter, toCenter) < 9.0 * radiusSquared;
}

} // namespace shadowcones

#endif
