// SPDX-License-Identifier: BSD-3-Clause
// Where the Sun stands, against values of the literature and a formula of another origin.
#include "scSunPositions.h"

#include "MeeusSun.h"
#include "scCivilTime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
/// A second of UT1 less UTC, and what a formula leaves out.
constexpr double tolerance = 0.005;

double Seconds(const std::string& text)
{
  double seconds = 0.0;
  EXPECT_TRUE(ReadCivilTime(text, seconds)) << text;
  return seconds;
}

/// Degrees.
SunPosition SunAt(const std::string& text, double latitude, double longitude)
{
  const double seconds = Seconds(text);
  SunPosition sun = SunPositions({ latitude * degree, longitude * degree }, seconds, seconds).At(seconds);
  sun.Altitude /= degree;
  sun.Azimuth /= degree;
  return sun;
}

} // namespace

TEST(SunPositions, TheExampleOfTheSolarPositionAlgorithm)
{
  // I. Reda and A. Andreas, Solar Position Algorithm for Solar Radiation Applications (NREL/TP-560-34302, 2003),
  // appendix A.5: topocentric altitude 39.872046 without air, azimuth 194.340241, at 1830 m, 820 hPa: with air
  // 39.888378.
  const SunPosition sun = SunAt("2003-10-17T12:30:30-07:00", 39.742476, -105.1786);
  EXPECT_NEAR(sun.Altitude, 39.872046, tolerance);
  EXPECT_NEAR(sun.Azimuth, 194.340241, tolerance);
  // Thinner air at that height lifts less.
  EXPECT_NEAR(sun.Altitude + Refraction(sun.Altitude * degree) / degree, 39.888378, 0.008);
  // Its sunrise, 06:12:43, is where the Sun stands at -.8333 from the Earth's middle: parallax is 8.8".
  EXPECT_NEAR(SunAt("2003-10-17T06:12:43-07:00", 39.742476, -105.1786).Altitude, -0.8333 - 8.794 / 3600.0, tolerance);
}

TEST(SunPositions, EquinoxesAndSolsticesAtThePoles)
{
  // J. Meeus, Astronomical Algorithms, table 27.E (of 1996, 2000, 2005) and example 27.a (1962), in terrestrial time,
  // which is 62, 64, 65 and 34 s ahead. At a pole the altitude is the declination, lowered by parallax.
  const double parallax = 8.794 / 3600.0;
  for (const char* equinox : { "1996-03-20T08:03:05", "2000-03-20T07:35:15", "2005-03-20T12:33:24",
         "1996-09-22T18:00:06", "2000-09-22T17:27:36", "2005-09-22T22:23:09" })
  {
    for (const double pole : { -90.0, 90.0 })
    {
      EXPECT_NEAR(SunAt(equinox, pole, 0.0).Altitude, -parallax, 0.0005) << equinox;
    }
  }
  struct Solstice
  {
    const char* Time;
    double Pole;
  };
  // The mean obliquity of date, 23.4393 - .0130 T, and nutation of .0026 at most; parallax there is .0022.
  for (const Solstice& solstice : { Solstice{ "1962-06-21T21:24:08", 90.0 }, { "2000-06-21T01:47:42", 90.0 },
         { "1996-12-21T14:05:54", -90.0 }, { "2000-12-21T13:37:26", -90.0 }, { "2005-12-21T18:34:56", -90.0 } })
  {
    const double centuries = Seconds(solstice.Time) / 86400.0 / 36525.0;
    const double obliquity = 23.43929 - 0.01300 * centuries;
    EXPECT_NEAR(SunAt(solstice.Time, solstice.Pole, 0.0).Altitude, obliquity - 0.0022, 0.0028) << solstice.Time;
    EXPECT_NEAR(SunAt(solstice.Time, -solstice.Pole, 0.0).Altitude, -obliquity - 0.0022, 0.0028) << solstice.Time;
  }
}

TEST(SunPositions, AnotherFormulaAgreesFrom1950To2050)
{
  double worst = 0.0;
  for (int k = 0; k < 600; ++k)
  {
    const double seconds = Seconds("1950-01-01") + k * 61.13 * 86400.0 + 7919.0 * k;
    const double latitude = -89.0 + 178.0 * (k % 37) / 36.0;
    const double longitude = -180.0 + 360.0 * (k % 23) / 22.0;
    const SunPosition sun = SunPositions({ latitude * degree, longitude * degree }, seconds, seconds).At(seconds);
    const Vector3 found = DirectionTo(sun, {}); // x is east
    worst = std::max(worst, Length(Cross(found, MeeusDirection(seconds, latitude, longitude))) / degree);
  }
  EXPECT_LT(worst, 0.012);  // the formula's own .01 in longitude, and in sidereal time
  EXPECT_GT(worst, 0.0005); // they are two formulas
}

TEST(SunPositions, TheSunDoesNotSetAtMidsummerBeyondThePolarCircle)
{
  // North Cape, 71.17 N 25.78 E. Lower culmination at latitude + declination - 90; on both sides of it the Sun is
  // higher. Solstice is at 20:51 of the first day.
  const double first = Seconds("2024-06-20T12:00:00Z");
  const SunPositions cape({ 71.17 * degree, 25.78 * degree }, first, first + 86400.0);
  double lowest = 90.0;
  double highest = -90.0;
  for (double t = 0.0; t < 86400.0; t += 60.0)
  {
    const double altitude = cape.At(first + t).Altitude / degree;
    lowest = std::min(lowest, altitude);
    highest = std::max(highest, altitude);
  }
  EXPECT_NEAR(lowest, 71.17 + 23.436 - 90.0 - 0.0024, 0.005);
  EXPECT_NEAR(highest, 90.0 - 71.17 + 23.436 - 0.0021, 0.005);
}

TEST(SunPositions, WhatIsFoundDoesNotDependOnTheRange)
{
  const double first = Seconds("2024-02-28T23:00:00Z");
  const GeographicPlace place{ 48.0 * degree, 11.0 * degree };
  const SunPositions longRange(place, first - 40.0 * 86400.0, first + 3.0 * 86400.0);
  for (double t = 0.0; t < 3.0 * 86400.0; t += 9973.0)
  {
    const SunPosition a = longRange.At(first + t);
    const SunPosition b = SunPositions(place, first + t, first + t).At(first + t);
    EXPECT_EQ(a.Altitude, b.Altitude);
    EXPECT_EQ(a.Azimuth, b.Azimuth);
  }
  // Nothing jumps at midnight, where other days are looked at: .1 s of the Earth's turn is .0004 degrees.
  const double midnight = Seconds("2024-02-29");
  EXPECT_NEAR(longRange.At(midnight - 0.05).Azimuth, longRange.At(midnight + 0.05).Azimuth, 0.001 * degree);
}

TEST(SunPositions, AScenesAxesAreFollowed)
{
  const SunPosition southEast{ 30.0 * degree, 135.0 * degree };
  const Vector3 usual = DirectionTo(southEast, {});
  const double level = std::cos(30.0 * degree) * std::sqrt(0.5);
  EXPECT_NEAR(Length(usual - Vector3{ level, -level, 0.5 }), 0.0, 1e-12);
  // y up, and north along -z, so that x stays east.
  const Vector3 turned = DirectionTo(southEast, { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 } });
  EXPECT_NEAR(Length(turned - Vector3{ level, 0.5, level }), 0.0, 1e-12);
}

TEST(SunPositions, RefractionIsThatOfTheTables)
{
  // Astronomical Algorithms, example 16.a: a true altitude of 33.2' is lifted by 24.618'.
  EXPECT_NEAR(Refraction(33.2 / 60.0 * degree) / degree * 60.0, 24.618, 0.08);
  EXPECT_NEAR(Refraction(90.0 * degree), 0.0, 1e-6);
  EXPECT_NEAR(Refraction(45.0 * degree) / degree * 3600.0, 60.0, 2.0);
  EXPECT_EQ(Refraction(-2.0 * degree), 0.0);
}
