// SPDX-License-Identifier: BSD-3-Clause
#include "scSunPositions.h"

#include "scCivilTime.h"
#include "scConstants.h"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{

constexpr double midnightOfTwoThousand = 2451544.5; // Julian date
constexpr double degree = Pi / 180.0;

/// Terrestrial time less UTC, days. Before 1960, when there was no UTC, ERFA has no leap seconds: right to 4 s since
/// 1950.
double TerrestrialAhead(int day)
{
  int year = 0;
  int month = 0;
  int dayOfMonth = 0;
  double fraction = 0.0;
  double leapSeconds = 0.0;
  eraJd2cal(midnightOfTwoThousand, day, &year, &month, &dayOfMonth, &fraction);
  eraDat(year, month, dayOfMonth, fraction, &leapSeconds);
  return (leapSeconds + ERFA_TTMTAI) / ERFA_DAYSEC;
}

/// The Sun as it is seen from the Earth's middle, astronomical units, in the axes of the stars.
void SeenFromEarth(double date, double time, double sun[3])
{
  double heliocentric[2][3];
  double barycentric[2][3];
  eraEpv00(date, time, heliocentric, barycentric);
  double towards[3] = { -heliocentric[0][0], -heliocentric[0][1], -heliocentric[0][2] };
  double distance = 0.0;
  double unit[3];
  eraPn(towards, &distance, unit);
  double velocity[3];
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    velocity[axis] = barycentric[1][axis] * (ERFA_DAU / ERFA_DAYSEC / ERFA_CMPS);
    square += velocity[axis] * velocity[axis];
  }
  double apparent[3];
  eraAb(unit, velocity, distance, std::sqrt(1.0 - square), apparent);
  eraSxp(distance, apparent, sun);
}

} // anonymous namespace

Vector3 DirectionTo(const SunPosition& sun, const Horizon& horizon)
{
  const Vector3 east = Cross(horizon.North, horizon.Up);
  const double level = std::cos(sun.Altitude);
  return Normalized(level * std::cos(sun.Azimuth) * horizon.North + level * std::sin(sun.Azimuth) * east +
    std::sin(sun.Altitude) * horizon.Up);
}

double Refraction(double altitude)
{
  const double h = altitude / degree;
  constexpr double lowest = -1.0;
  return h < lowest ? 0.0 : std::max(0.0, 1.02 / 60.0 / std::tan((h + 10.3 / (h + 5.11)) * degree)) * degree;
}

SunPositions::Node SunPositions::NodeOf(int day)
{
  Node node;
  node.Ahead = TerrestrialAhead(day);
  double seen[3];
  SeenFromEarth(midnightOfTwoThousand + day, node.Ahead, seen);
  double turn[3][3];
  eraPnm06a(midnightOfTwoThousand + day, node.Ahead, turn);
  double sun[3];
  eraRxp(turn, seen, sun);
  node.Sun = { sun[0], sun[1], sun[2] };
  const double date = midnightOfTwoThousand + day;
  node.Equinoxes = eraAnpm(eraGst06(date, 0.0, date, node.Ahead, turn) - eraGmst06(date, 0.0, date, node.Ahead));
  return node;
}

SunPositions::SunPositions(const GeographicPlace& place, double first, double last)
  : Place(place)
  , FirstDay(static_cast<int>(std::floor(first / SecondsOfDay)) - 1)
{
  double observer[3];
  eraGd2gc(ERFA_WGS84, 0.0, place.Latitude, 0.0, observer);
  this->Observer = (1.0 / ERFA_DAU) * Vector3{ observer[0], observer[1], observer[2] };
  const int lastDay = static_cast<int>(std::floor(last / SecondsOfDay)) + 2;
  for (int day = this->FirstDay; day <= lastDay; ++day)
  {
    this->Nodes.push_back(NodeOf(day));
  }
}

SunPosition SunPositions::At(double seconds) const
{
  const double day = std::floor(seconds / SecondsOfDay);
  const double x = seconds / SecondsOfDay - day;
  const int before = std::clamp(static_cast<int>(day) - this->FirstDay, 1, static_cast<int>(this->Nodes.size()) - 3);
  const Node* node = this->Nodes.data() + before;
  // Lagrange through four midnights: a year is so smooth that 1e-9 is lost.
  const double weights[4] = { -x * (x - 1.0) * (x - 2.0) / 6.0, (x + 1.0) * (x - 1.0) * (x - 2.0) / 2.0,
    -(x + 1.0) * x * (x - 2.0) / 2.0, (x + 1.0) * x * (x - 1.0) / 6.0 };
  Vector3 sun;
  double equinoxes = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    sun += weights[k] * node[k - 1].Sun;
    equinoxes += weights[k] * node[k - 1].Equinoxes;
  }
  const double date = midnightOfTwoThousand + day;
  const double turned =
    eraGmst06(date, x, date, x + node->Ahead) + equinoxes + this->Place.Longitude; // of the place from the equinox
  const double meridian = std::cos(turned) * sun.X + std::sin(turned) * sun.Y - this->Observer.X;
  const double east = std::cos(turned) * sun.Y - std::sin(turned) * sun.X;
  const double pole = sun.Z - this->Observer.Z;
  const double up = std::cos(this->Place.Latitude) * meridian + std::sin(this->Place.Latitude) * pole;
  const double north = std::cos(this->Place.Latitude) * pole - std::sin(this->Place.Latitude) * meridian;
  return { std::atan2(up, std::hypot(east, north)), eraAnp(std::atan2(east, north)) };
}

} // namespace shadowcones
