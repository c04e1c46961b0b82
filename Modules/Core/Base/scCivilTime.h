// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scCivilTime.h
 * @brief Dates and times as people write them.
 */
#ifndef scCivilTime_h
#define scCivilTime_h

#include "ShadowConesCoreModule.h"

#include <string>

namespace shadowcones
{

constexpr double SecondsOfDay = 86400.0;

/**
 * Read a date, or a date and time, of ISO 8601: 2024-06-21, 2024-06-21T12:30, 20240621T123000.5+0200. Without a zone it
 * is UTC, a date alone is its midnight, 24:00 is the next one, and a blank may stand for the T. @p seconds count from
 * 2000-01-01T00:00 UTC, 86,400 a day: a leap second is the first one of the day after it. @return false where it is no
 * such text.
 */
SHADOWCONESCORE_EXPORT bool ReadCivilTime(const std::string& text, double& seconds);

/// The year in which such a second lies.
SHADOWCONESCORE_EXPORT int YearOf(double seconds);

} // namespace shadowcones

#endif
