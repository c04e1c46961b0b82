// SPDX-License-Identifier: BSD-3-Clause
#include "scEstimate.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// The normal distribution holds 95 % within as many standard deviations.
constexpr double z95 = 1.959963984540054;
Estimate WilsonInterval(double fraction, double samples)
{
  const double z2 = z95 * z95 / samples;
  const double center = (fraction + 0.5 * z2) / (1.0 + z2);
  const double half =
    std::sqrt(std::max(0.0, fraction * (1.0 - fraction) / samples + 0.25 * z2 / samples)) * z95 / (1.0 + z2);
  // Rounding must not put the value outside.
  return { fraction, std::clamp(center - half, 0.0, fraction), std::clamp(center + half, fraction, 1.0) };
}

/// Squared standard error of the ratio estimate.
double RatioVariance(const RatioSums& sums, double ratio)
{
  const double squares = static_cast<double>(sums.YY) - 2.0 * ratio * static_cast<double>(sums.XY) +
    ratio * ratio * static_cast<double>(sums.XX);
  const double whole = static_cast<double>(sums.X);
  return std::max(0.0, squares) / (whole * whole);
}
} // anonymous namespace

Estimate EstimateProportion(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? WilsonInterval(static_cast<double>(part) / static_cast<double>(whole), static_cast<double>(whole))
                   : Estimate{};
}

Estimate EstimateFraction(const RatioSums& sums)
{
  if (sums.X <= 0)
  {
    return {};
  }
  const double whole = static_cast<double>(sums.X);
  const double fraction = static_cast<double>(sums.Y) / whole;
  const double variance = RatioVariance(sums, fraction);
  const bool spread = sums.Y > 0 && sums.Y < sums.X && variance > 0.0;
  return WilsonInterval(
    fraction, spread ? fraction * (1.0 - fraction) / variance : whole * whole / static_cast<double>(sums.XX));
}

Estimate EstimateRatio(const RatioSums& sums)
{
  if (sums.X <= 0)
  {
    return {};
  }
  const double ratio = static_cast<double>(sums.Y) / static_cast<double>(sums.X);
  const double half = z95 * std::sqrt(RatioVariance(sums, ratio));
  return { ratio, std::max(0.0, ratio - half), ratio + half };
}

} // namespace shadowcones
