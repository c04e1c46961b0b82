// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConcentricMap.h
 * @brief The concentric map of Shirley and Chiu (1997) from the square onto the disc, and its inverse. Internal to Core.
 */
#ifndef scConcentricMap_h
#define scConcentricMap_h

#include "scConstants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowcones
{

/// Into [0, 1), so that an inverse can be sampled again.
inline double UnitInterval(double x)
{
  return std::clamp(x, 0.0, 1.0 - 0x1p-53);
}

/// The point of the unit disc to which (u, v) in [0, 1)^2 is mapped, areas in proportion.
inline std::array<double, 2> ConcentricDisc(double u, double v)
{
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0)
  {
    return { 0.0, 0.0 };
  }
  const bool horizontal = std::fabs(a) > std::fabs(b);
  const double radius = horizontal ? a : b;
  const double azimuth = horizontal ? 0.25 * Pi * (b / a) : 0.5 * Pi - 0.25 * Pi * (a / b);
  return { radius * std::cos(azimuth), radius * std::sin(azimuth) };
}

/// The (u, v) that ConcentricDisc() maps to a point of the unit disc.
inline std::array<double, 2> InvertConcentricDisc(double x, double y)
{
  const double radius = std::min(std::hypot(x, y), 1.0);
  double azimuth = std::atan2(y, x);
  azimuth = azimuth < -0.25 * Pi ? azimuth + 2.0 * Pi : azimuth;
  const int quarter = std::min(static_cast<int>((azimuth + 0.25 * Pi) / (0.5 * Pi)), 3);
  const double across = radius * (azimuth - 0.5 * Pi * quarter) / (0.25 * Pi);
  const double a = quarter == 0 ? radius : quarter == 1 ? -across : quarter == 2 ? -radius : across;
  const double b = quarter == 0 ? across : quarter == 1 ? radius : quarter == 2 ? -across : -radius;
  return { UnitInterval(0.5 * (a + 1.0)), UnitInterval(0.5 * (b + 1.0)) };
}

/**
 * The same up to rounding, from (a, b) in [-1, 1]^2 and in place, for the innermost loops: no branch that no processor can
 * foresee, and short series for sine and cosine of an angle of at most pi/4.
 */
inline void ConcentricDiscBySeries(double& a, double& b)
{
  const double radius = std::max(std::fabs(a), std::fabs(b));
  if (radius == 0.0)
  {
    return;
  }
  const double angle = 0.78539816339744830962 * std::min(std::fabs(a), std::fabs(b)) / radius;
  const double x = angle * angle;
  const double sine = angle *
    (1.0 +
      x *
        (-1.0 / 6 +
          x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880 + x * (-1.0 / 39916800 + x / 6227020800.0))))));
  const double cosine = 1.0 +
    x *
      (-0.5 +
        x *
          (1.0 / 24 +
            x * (-1.0 / 720 + x * (1.0 / 40320 + x * (-1.0 / 3628800 + x * (1.0 / 479001600 - x / 87178291200.0))))));
  const double horizontal = static_cast<double>(std::fabs(a) > std::fabs(b));
  const double shift = (cosine - sine) * horizontal;
  a = std::copysign(radius * (sine + shift), a);
  b = std::copysign(radius * (cosine - shift), b);
}

} // namespace shadowcones

#endif
