// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorCurve.h
 * @brief Error against time of one method over its knobs: the time at an error asked for, and growth with a parameter.
 */
#ifndef ErrorCurve_h
#define ErrorCurve_h

#include <string>
#include <vector>

namespace shadowcones
{

struct CurvePoint
{
  double Seconds = 0.0;
  double Error = 0.0;
};

struct TimeAtError
{
  enum Kind
  {
    Interpolated, ///< between two measured points
    AtMost,       ///< the cheapest point measured has a smaller error already: its time
    NotReached    ///< no point measured has so small an error; Seconds is 0
  };
  Kind Is = NotReached;
  double Seconds = 0.0;

  bool IsKnown() const { return this->Is != NotReached; }
};

/**
 * By straight lines in the logarithms of time and error, between those points that no other one beats in both. Never
 * beyond the measured points. Points whose error is 0 or whose time is 0 count as 1e-9.
 */
TimeAtError TimeAt(std::vector<CurvePoint> points, double error);

/// Exponent e of y ~ x^e by least squares in the logarithms; 0 for fewer than two different x. All values above 0.
double GrowthExponent(const std::vector<double>& x, const std::vector<double>& y);

/// Of an even number of values the mean of the two in the middle; 0 of none.
double Median(std::vector<double> values);

} // namespace shadowcones

#endif
