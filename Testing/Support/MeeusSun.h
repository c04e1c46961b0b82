// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeeusSun.h
 * @brief Where the Sun stands by a short formula of another origin than the one that is tested.
 */
#ifndef MeeusSun_h
#define MeeusSun_h

#include "scVector3.h"

#include <cmath>

namespace shadowcones
{
namespace testsupport
{

/// Degrees, azimuth clockwise from north.
struct MeeusPosition
{
  double Altitude;
  double Azimuth;
};

/**
 * J. Meeus, Astronomical Algorithms (2nd edition), chapter 25, "low accuracy": the Sun's longitude to .01 degrees;
 * sidereal time of chapter 12; parallax of chapter 40 as altitude. @param seconds from 2000-01-01T00:00 UTC; degrees,
 * east positive.
 */
inline MeeusPosition MeeusSun(double seconds, double latitude, double longitude)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const auto sine = [](double angle) { return std::sin(angle * degree); };
  const auto cosine = [](double angle) { return std::cos(angle * degree); };
  const double universal = seconds / 86400.0 - 0.5;        // days from noon of 2000-01-01
  const double t = (universal + 64.0 / 86400.0) / 36525.0; // centuries, terrestrial time
  const double anomaly = 357.52911 + 35999.05029 * t - 0.0001537 * t * t;
  const double center = (1.914602 - 0.004817 * t) * sine(anomaly) + (0.019993 - 0.000101 * t) * sine(2.0 * anomaly) +
    0.000289 * sine(3.0 * anomaly);
  const double node = 125.04 - 1934.136 * t;
  const double longitudeOfSun =
    280.46646 + 36000.76983 * t + 0.0003032 * t * t + center - 0.00569 - 0.00478 * sine(node);
  const double obliquity = 23.4392911 - 0.0130042 * t + 0.00256 * cosine(node);
  const double ascension = std::atan2(cosine(obliquity) * sine(longitudeOfSun), cosine(longitudeOfSun)) / degree;
  const double declination = std::asin(sine(obliquity) * sine(longitudeOfSun)) / degree;
  const double centuries = universal / 36525.0;
  const double sidereal = 280.46061837 + 360.98564736629 * universal + 0.000387933 * centuries * centuries -
    0.00478 * sine(node) * cosine(obliquity);
  const double hour = sidereal + longitude - ascension;
  const double up = sine(latitude) * sine(declination) + cosine(latitude) * cosine(declination) * cosine(hour);
  const double north = cosine(latitude) * sine(declination) - sine(latitude) * cosine(declination) * cosine(hour);
  const double east = -cosine(declination) * sine(hour);
  const double altitude = std::atan2(up, std::hypot(north, east)) / degree;
  const double azimuth = std::atan2(east, north) / degree;
  return { altitude - 8.794 / 3600.0 * cosine(altitude), azimuth < 0.0 ? azimuth + 360.0 : azimuth };
}

/// The same as a unit vector with x to the east, y to the north and z up.
inline Vector3 MeeusDirection(double seconds, double latitude, double longitude)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const MeeusPosition sun = MeeusSun(seconds, latitude, longitude);
  const double level = std::cos(sun.Altitude * degree);
  return { level * std::sin(sun.Azimuth * degree), level * std::cos(sun.Azimuth * degree),
    std::sin(sun.Altitude * degree) };
}

} // namespace testsupport
} // namespace shadowcones

#endif
