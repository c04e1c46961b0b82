// SPDX-License-Identifier: BSD-3-Clause
// Dates of ISO 8601, read: seconds counted by hand or by the calendar, and what is no date.
#include "scCivilTime.h"

#include <gtest/gtest.h>

using namespace shadowcones;

namespace
{

double Seconds(const std::string& text)
{
  double seconds = -1e300;
  EXPECT_TRUE(ReadCivilTime(text, seconds)) << text;
  return seconds;
}

} // namespace

TEST(CivilTime, DatesAndTimes)
{
  EXPECT_EQ(Seconds("2000-01-01"), 0.0);
  EXPECT_EQ(Seconds("2000-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(Seconds("2000-01-02T01:02:03"), 86400.0 + 3723.0);
  EXPECT_EQ(Seconds("20000102T010203Z"), 86400.0 + 3723.0);
  EXPECT_EQ(Seconds("2000-01-02 01:02"), 86400.0 + 3720.0);
  EXPECT_EQ(Seconds("2000-01-02t01z"), 86400.0 + 3600.0);
  EXPECT_EQ(Seconds("2000-01-01T00:00:00.25"), 0.25);
  EXPECT_EQ(Seconds("2000-01-01T00:00:00,5Z"), 0.5);
  EXPECT_EQ(Seconds("2000-01-01T24:00"), 86400.0);
  // A leap second is the first second of the day after it.
  EXPECT_EQ(Seconds("2016-12-31T23:59:60Z"), Seconds("2017-01-01"));
  // Unix time begins in 1970, which is 946,684,800 seconds before 2000; 1,709,208,000 is 2024-02-29T12:00.
  EXPECT_EQ(Seconds("1970-01-01"), -946684800.0);
  EXPECT_EQ(Seconds("2024-02-29T12:00:00Z"), 1709208000.0 - 946684800.0);
  EXPECT_EQ(Seconds("1900-03-01") - Seconds("1900-02-28"), 86400.0); // 1900 has no leap day, 2000 has
  EXPECT_EQ(Seconds("2000-03-01") - Seconds("2000-02-28"), 2 * 86400.0);
}

TEST(CivilTime, Zones)
{
  const double noon = Seconds("2024-06-21T12:00:00Z");
  EXPECT_EQ(Seconds("2024-06-21T14:00:00+02:00"), noon);
  EXPECT_EQ(Seconds("2024-06-21T14:00+0200"), noon);
  EXPECT_EQ(Seconds("2024-06-21T14+02"), noon);
  EXPECT_EQ(Seconds("20240621T0500-0700"), noon);
  EXPECT_EQ(Seconds("2024-06-21T17:45:00+05:45"), noon);
  EXPECT_EQ(Seconds("2024-06-22T01:30:00+13:30"), noon);
}

TEST(CivilTime, WhatIsNoDate)
{
  for (const char* text :
    { "", "today", "2024", "2024-06", "2024-6-21", "24-06-21", "2024-13-01", "2024-00-10", "2024-04-31", "2023-02-29",
      "2024-06-00", "2024-06-21T", "2024-06-21T25:00", "2024-06-21T24:01", "2024-06-21T12:60", "2024-06-21T12:00:61",
      "2024-06-21T12:00:00.", "2024-06-21T12:00:00+", "2024-06-21T12:00:00+2", "2024-06-21T12:00:00+02:60",
      "2024-06-21T12:00:00+24:00", "2024-06-21T12:00:00 CET", "2024-06-21Z", "2024-06-21x", "2024-0621", "-2024-06-21",
      "2024-06-21T12:3", "2024-06-21T12:30:", " 2024-06-21" })
  {
    double seconds = 0.0;
    EXPECT_FALSE(ReadCivilTime(text, seconds)) << text;
  }
}

TEST(CivilTime, TheYearOfASecond)
{
  for (const int year : { 1900, 1903, 1950, 1999, 2000, 2001, 2024, 2050, 2099 })
  {
    const double first = Seconds(std::to_string(year) + "-01-01");
    EXPECT_EQ(YearOf(first), year);
    EXPECT_EQ(YearOf(first - 1.0), year - 1);
    EXPECT_EQ(YearOf(first + 364.9 * 86400.0), year);
  }
}
