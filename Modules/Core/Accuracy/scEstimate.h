// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scEstimate.h
 * @brief Ratios of counts with confidence intervals.
 */
#ifndef scEstimate_h
#define scEstimate_h

#include "ShadowConesCoreModule.h"

#include <cstdint>
#include <limits>

namespace shadowcones
{

/// A 95 % confidence interval; a value that is not defined (0 / 0) is NaN in [0, 1].
struct Estimate
{
  double Value = std::numeric_limits<double>::quiet_NaN();
  double Low = 0.0;
  double High = 1.0;
};

/// A proportion of counts, with the interval of Wilson (1927).
SHADOWCONESCORE_EXPORT Estimate EstimateProportion(std::int64_t part, std::int64_t whole);

/// Sums of y and x over samples, for the ratio of both. Integers: the same for any order of adding.
struct RatioSums
{
  std::int64_t Y = 0;
  std::int64_t X = 0;
  std::int64_t YY = 0;
  std::int64_t XY = 0;
  std::int64_t XX = 0;

  void Add(std::int64_t y, std::int64_t x)
  {
    this->Y += y;
    this->X += x;
    this->YY += y * y;
    this->XY += x * y;
    this->XX += x * x;
  }
};

/**
 * Sum of y over sum of x where 0 <= y <= x in each sample. Wilson's interval for as many samples as give a proportion
 * the standard error of the ratio estimate (Cochran 1977, section 6.4); at the values 0 and 1, whose estimate is 0, for
 * (sum x)^2 / sum x^2 samples (Kish 1965).
 */
SHADOWCONESCORE_EXPORT Estimate EstimateFraction(const RatioSums& sums);
/// Sum of y over sum of x, 1.96 standard errors of the ratio estimate to either side.
SHADOWCONESCORE_EXPORT Estimate EstimateRatio(const RatioSums& sums);

} // namespace shadowcones

#endif
