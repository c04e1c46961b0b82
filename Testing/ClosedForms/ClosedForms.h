// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedForms.h
 * @brief Shadows and airlight that can be written down: what every estimate is tested against.
 *
 * For the planar cases the light lies in the plane z = 0, the occluder in the plane z = L, and the point at depth
 * z > L with the lateral offset x; s = z / (z - L) is the scale of the occluder's image on the light.
 */
#ifndef ClosedForms_h
#define ClosedForms_h

#include "scConstants.h"
#include "scVector3.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace shadowcones
{
namespace closedforms
{

using shadowcones::Pi;

inline double ClampedAcos(double x)
{
  return std::acos(std::clamp(x, -1.0, 1.0));
}

/// Integral of a smooth function by Simpson's rule.
inline double Integrate(const std::function<double(double)>& function, double a, double b, int intervals = 20000)
{
  const double h = (b - a) / intervals;
  double sum = function(a) + function(b);
  for (int k = 1; k < intervals; ++k)
  {
    sum += (k % 2 ? 4.0 : 2.0) * function(a + k * h);
  }
  return sum * h / 3.0;
}

// 1. Disc light, coaxial disc occluder.

/// Overlap area of two discs of radius a and b whose centres are d apart.
inline double LensArea(double a, double b, double d)
{
  const double small = std::min(a, b);
  if (d >= a + b)
  {
    return 0.0;
  }
  if (d <= std::abs(a - b))
  {
    return Pi * small * small;
  }
  const double kite = (-d + a + b) * (d + a - b) * (d - a + b) * (d + a + b);
  return a * a * ClampedAcos((d * d + a * a - b * b) / (2.0 * d * a)) +
    b * b * ClampedAcos((d * d + b * b - a * a) / (2.0 * d * b)) - 0.5 * std::sqrt(std::max(kite, 0.0));
}

/// Visible fraction of a disc light of radius R behind a disc of radius r in the plane L.
inline double DiscVisibility(double R, double r, double L, double z, double x)
{
  const double s = z / (z - L);
  return 1.0 - LensArea(R, r * s, std::abs(x) * (s - 1.0)) / (Pi * R * R);
}
/// Radius of the umbra at depth z; negative beyond its tip.
inline double DiscUmbraRadius(double R, double r, double L, double z)
{
  return r - (R - r) * (z - L) / L;
}
/// Length of the umbra behind the occluder for R > r.
inline double DiscUmbraLength(double R, double r, double L)
{
  return r * L / (R - r);
}
inline double DiscPenumbraRadius(double R, double r, double L, double z)
{
  return r + (R + r) * (z - L) / L;
}
/// Outer half angle of the penumbra, radians.
inline double DiscPenumbraHalfAngle(double R, double r, double L)
{
  return std::atan((R + r) / L);
}

// 2. Sphere light, sphere occluder.

/// Solid angle shared by two spherical caps of half angles a and b whose axes are an angle d apart.
inline double CapOverlap(double a, double b, double d)
{
  if (d >= a + b)
  {
    return 0.0;
  }
  if (d <= std::abs(a - b))
  {
    const double sine = std::sin(0.5 * std::min(a, b));
    return 4.0 * Pi * sine * sine;
  }
  const double atCrossing = ClampedAcos((std::cos(d) - std::cos(a) * std::cos(b)) / (std::sin(a) * std::sin(b)));
  const double atA = ClampedAcos((std::cos(b) - std::cos(d) * std::cos(a)) / (std::sin(d) * std::sin(a)));
  const double atB = ClampedAcos((std::cos(a) - std::cos(d) * std::cos(b)) / (std::sin(d) * std::sin(b)));
  return 2.0 * (Pi - atCrossing - atA * std::cos(a) - atB * std::cos(b));
}

/// Visible fraction, by solid angle, of a sphere light (radius R at the origin) behind a sphere r at @p occluder.
inline double SphereVisibility(double R, double r, const Vector3& occluder, const Vector3& x)
{
  const Vector3 toOccluder = occluder - x;
  const double light = std::asin(R / Length(x));
  const double other = std::asin(r / Length(toOccluder));
  const double between = std::atan2(Length(Cross(-x, toOccluder)), Dot(-x, toOccluder));
  const double sine = std::sin(0.5 * light);
  return 1.0 - CapOverlap(light, other, between) / (4.0 * Pi * sine * sine);
}
/// Half angle (radians) of the umbra of a sphere r at the distance D from a sphere light R > r.
inline double SphereUmbraHalfAngle(double R, double r, double D)
{
  return std::asin((R - r) / D);
}
inline double SpherePenumbraHalfAngle(double R, double r, double D)
{
  return std::asin((R + r) / D);
}
/// From the occluder's centre to the tip of its umbra.
inline double SphereUmbraLength(double R, double r, double D)
{
  return r * D / (R - r);
}

// 3. Parallel rectangles.

/// Overlap length of [a - p, a + p] and [b - q, b + q].
inline double IntervalOverlap(double a, double p, double b, double q)
{
  return std::max(0.0, std::min(a + p, b + q) - std::max(a - p, b - q));
}
/// Visible fraction of a rectangle light (half sizes A, B) behind one with half sizes a, b, seen from (x, y, z).
inline double RectangleVisibility(double A, double B, double a, double b, double L, double x, double y, double z)
{
  const double s = z / (z - L);
  const double overlap = IntervalOverlap(0.0, A, x * (1.0 - s), a * s) * IntervalOverlap(0.0, B, y * (1.0 - s), b * s);
  return 1.0 - overlap / (4.0 * A * B);
}

// 4. Straight edge over a disc light.

/// Area of the part of a disc of radius R on the side x > h.
inline double CircularSegment(double R, double h)
{
  if (h >= R)
  {
    return 0.0;
  }
  if (h <= -R)
  {
    return Pi * R * R;
  }
  return R * R * std::acos(h / R) - h * std::sqrt(R * R - h * h);
}
/// Visible fraction of a disc light behind a half plane that covers x < 0 in the plane L.
inline double EdgeVisibility(double R, double L, double z, double x)
{
  const double s = z / (z - L);
  return CircularSegment(R, x * (1.0 - s)) / (Pi * R * R);
}

// 5. Airlight of a point light (Sun et al. 2005).

/// F(u, v) = integral from 0 to v of exp(-u tan x), by quadrature.
inline double AirlightF(double u, double v)
{
  return Integrate([u](double x) { return std::exp(-u * std::tan(x)); }, 0.0, v);
}

/**
 * Airlight from the eye up to a distance, of an isotropic point light in an endless homogeneous medium of albedo 1.
 * @param intensity W sr^-1; @param beta 1/unit; @param toLight distance eye to light; @param gamma angle between the
 * ray and the direction to the light, in (0, pi); @param along distance from the eye along the ray.
 */
inline double Airlight(double intensity, double beta, double toLight, double gamma, double along)
{
  const double tsv = beta * toLight;
  const double tvp = beta * along;
  const double a0 = beta * beta * intensity * std::exp(-tsv * std::cos(gamma)) / (2.0 * Pi * tsv * std::sin(gamma));
  const double a1 = tsv * std::sin(gamma);
  const double angle = 0.25 * Pi + 0.5 * std::atan((tvp - tsv * std::cos(gamma)) / (tsv * std::sin(gamma)));
  return a0 * (AirlightF(a1, angle) - AirlightF(a1, 0.5 * gamma));
}
/// The same over lit parts [begin, end] of the ray only: exact hard shadows.
inline double AirlightOver(
  double intensity, double beta, double toLight, double gamma, const std::vector<std::pair<double, double>>& lit)
{
  double sum = 0.0;
  for (const auto& part : lit)
  {
    sum +=
      Airlight(intensity, beta, toLight, gamma, part.second) - Airlight(intensity, beta, toLight, gamma, part.first);
  }
  return sum;
}

// 6. Parallel light on a slab.

/**
 * Radiance along a ray normal to parallel light, isotropic phase function. The light enters the slab at height 1, the
 * ray runs at height y over the length S; [a, b] are its shadowed parts.
 * @param irradiance of a plane that faces the light.
 */
inline double SlabRadiance(double sigmaS, double sigmaT, double irradiance, double y, double S,
  const std::vector<std::pair<double, double>>& shadowed)
{
  double sum = 1.0 - std::exp(-sigmaT * S);
  for (const auto& part : shadowed)
  {
    sum -= std::exp(-sigmaT * part.first) - std::exp(-sigmaT * part.second);
  }
  return sigmaS * irradiance / (4.0 * Pi * sigmaT) * std::exp(-sigmaT * (1.0 - y)) * sum;
}

// 7. Solid angle.

/// Solid angle of a disc of radius R from a point on its axis at the distance h.
inline double DiscSolidAngle(double R, double h)
{
  return 2.0 * Pi * (1.0 - h / std::hypot(h, R));
}

// 8. Phase functions.

inline double SchlickLobe(double k, double cosine)
{
  return (1.0 - k * k) / (4.0 * Pi * (1.0 - k * cosine) * (1.0 - k * cosine));
}
inline double HenyeyGreenstein(double g, double cosine)
{
  return (1.0 - g * g) / (4.0 * Pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}
inline double RayleighPhase(double cosine)
{
  return 3.0 / (16.0 * Pi) * (1.0 + cosine * cosine);
}
/// Integral of a phase function over the sphere.
inline double OverSphere(const std::function<double(double)>& phase)
{
  return 2.0 * Pi * Integrate(phase, -1.0, 1.0);
}

} // namespace closedforms
} // namespace shadowcones

#endif
