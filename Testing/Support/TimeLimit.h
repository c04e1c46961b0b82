// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TimeLimit.h
 * @brief Limits of tests that look at the clock, in builds that are slower than usual.
 */
#ifndef TimeLimit_h
#define TimeLimit_h

#ifndef SHADOWCONES_TIME_FACTOR
#define SHADOWCONES_TIME_FACTOR 1
#endif

/// Seconds that something may take which takes less than @p seconds in a release.
constexpr double TimeLimit(double seconds)
{
  return seconds * SHADOWCONES_TIME_FACTOR;
}

#endif
