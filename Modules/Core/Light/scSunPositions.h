// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSunPositions.h
 * @brief Where the Sun stands, seen from a place on Earth. Hides ERFA, and the only place that calls it.
 */
#ifndef scSunPositions_h
#define scSunPositions_h

#include "ShadowConesCoreModule.h"
#include "scVector3.h"

#include <vector>

namespace shadowcones
{

/// Radians; of the ellipsoid WGS 84, at sea level.
struct GeographicPlace
{
  double Latitude = 0.0;  ///< north is positive
  double Longitude = 0.0; ///< east is positive
};

/// Radians; of the middle of the Sun's disc.
struct SunPosition
{
  double Altitude = 0.0; ///< above the horizon
  double Azimuth = 0.0; ///< clockwise from north, 0 to 2 pi; at a pole the meridian of the longitude is north and south
};

/// How a scene is turned: two unit vectors at right angles.
struct Horizon
{
  Vector3 Up{ 0.0, 0.0, 1.0 };
  Vector3 North{ 0.0, 1.0, 0.0 };
};

/// The unit vector towards a Sun that stands there.
SHADOWCONESCORE_EXPORT Vector3 DirectionTo(const SunPosition& sun, const Horizon& horizon);

/**
 * By how much the air lifts a body that would be seen at an altitude without it, radians: Saemundsson's formula for
 * 1010 hPa and 10 degrees Celsius, which is right to .002 degrees, ordinary weather to .01 above 15 degrees and to some
 * tenths at the horizon. 0 more than a degree below that, where nobody sees the body anyway.
 */
SHADOWCONESCORE_EXPORT double Refraction(double altitude);

/**
 * Positions of the Sun between two times, which count in seconds from 2000-01-01T00:00 UTC (see scCivilTime.h):
 * VSOP2000 for the Earth, IAU 2006/2000A for precession, nutation and the Earth's rotation, aberration, and parallax.
 * Built once for a range, asked from any number of threads; what is found at a time does not depend on the range.
 *
 * In the years 1900 to 2100 positions are right to .004 degrees: UTC is taken for UT1, by which the Earth turns, and
 * differs from it by .9 s at most as long as it has leap seconds. The rest is far less: the motion of the poles, which
 * is left out, is below .0002 degrees.
 */
class SHADOWCONESCORE_EXPORT SunPositions
{
public:
  SunPositions(const GeographicPlace& place, double first, double last);
  SunPosition At(double seconds) const;

private:
  /// What changes slowly, at midnight of a day.
  struct Node
  {
    Vector3 Sun; ///< as it is seen from the Earth's middle, astronomical units, true equator and equinox of date
    double Equinoxes = 0.0; ///< apparent less mean sidereal time, radians
    double Ahead = 0.0;     ///< terrestrial time less UTC, days
  };
  static Node NodeOf(int day);

  GeographicPlace Place;
  Vector3 Observer; ///< in astronomical units, on the meridian
  int FirstDay;     ///< of the nodes, from 2000-01-01
  std::vector<Node> Nodes;
};

} // namespace shadowcones

#endif
