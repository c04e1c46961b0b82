// SPDX-License-Identifier: BSD-3-Clause
#include "scCivilTime.h"

#include <cmath>

namespace shadowcones
{
namespace
{

/// Takes a text from its beginning.
class Scanner
{
public:
  explicit Scanner(const std::string& text)
    : At(text.c_str())
  {
  }
  bool AtEnd() const { return *this->At == '\0'; }
  bool Take(const char* oneOf)
  {
    for (; *oneOf; ++oneOf)
    {
      if (*this->At == *oneOf)
      {
        ++this->At;
        return true;
      }
    }
    return false;
  }
  /// Exactly so many digits.
  bool Number(int digits, int& value)
  {
    value = 0;
    for (int k = 0; k < digits; ++k)
    {
      if (!this->IsDigit())
      {
        return false;
      }
      value = 10 * value + (*this->At++ - '0');
    }
    return true;
  }
  /// The digits behind a point, at least one.
  bool Fraction(double& value)
  {
    double place = 0.1;
    const bool any = this->IsDigit();
    for (value = 0.0; this->IsDigit(); place *= 0.1)
    {
      value += place * (*this->At++ - '0');
    }
    return any;
  }

private:
  bool IsDigit() const { return *this->At >= '0' && *this->At <= '9'; }
  const char* At;
};

/// Days from 2000-01-01 in the Gregorian calendar; years begin in March, so that leap days come last.
int DaysFromDate(int year, int month, int day)
{
  const int y = month > 2 ? year : year - 1;
  const int m = month > 2 ? month - 3 : month + 9;
  const int dayOfYear = (153 * m + 2) / 5 + day - 1;
  constexpr int untilTwoThousand = 730425; // days from 0000-03-01
  return 365 * y + y / 4 - y / 100 + y / 400 + dayOfYear - untilTwoThousand;
}

bool ReadDate(Scanner& text, int& days)
{
  int year = 0;
  int month = 0;
  int day = 0;
  if (!text.Number(4, year))
  {
    return false;
  }
  const bool dashes = text.Take("-");
  if (!text.Number(2, month) || (dashes && !text.Take("-")) || !text.Number(2, day) || month < 1 || month > 12 ||
    day < 1)
  {
    return false;
  }
  days = DaysFromDate(year, month, day);
  return month == 12 ? day <= 31 : days < DaysFromDate(year, month + 1, 1);
}

/// hh, hh:mm, hh:mm:ss and so on, with or without colons.
bool ReadClock(Scanner& text, double& seconds)
{
  int hour = 0;
  int minute = 0;
  int second = 0;
  double fraction = 0.0;
  if (!text.Number(2, hour))
  {
    return false;
  }
  Scanner ahead = text;
  const bool colons = ahead.Take(":");
  if (ahead.Number(2, minute))
  {
    text = ahead;
    if ((!colons || ahead.Take(":")) && ahead.Number(2, second))
    {
      text = ahead;
      if (text.Take(".,") && !text.Fraction(fraction))
      {
        return false;
      }
    }
  }
  seconds = 3600.0 * hour + 60.0 * minute + second + fraction;
  return minute < 60 && second <= 60 && (hour < 24 || seconds == SecondsOfDay);
}

/// Z, +hh, +hhmm or +hh:mm, seconds ahead of UTC.
bool ReadZone(Scanner& text, double& ahead)
{
  ahead = 0.0;
  if (text.AtEnd() || text.Take("Zz"))
  {
    return true;
  }
  const bool east = text.Take("+");
  int hours = 0;
  int minutes = 0;
  if ((!east && !text.Take("-")) || !text.Number(2, hours))
  {
    return false;
  }
  if (!text.AtEnd())
  {
    text.Take(":");
    if (!text.Number(2, minutes))
    {
      return false;
    }
  }
  ahead = (east ? 1.0 : -1.0) * (3600.0 * hours + 60.0 * minutes);
  return hours < 24 && minutes < 60;
}

} // anonymous namespace

bool ReadCivilTime(const std::string& text, double& seconds)
{
  Scanner scanner(text);
  int days = 0;
  double clock = 0.0;
  double ahead = 0.0;
  if (!ReadDate(scanner, days))
  {
    return false;
  }
  if (!scanner.AtEnd() && !(scanner.Take("Tt ") && ReadClock(scanner, clock) && ReadZone(scanner, ahead)))
  {
    return false;
  }
  seconds = SecondsOfDay * days + clock - ahead;
  return scanner.AtEnd();
}

int YearOf(double seconds)
{
  const int day = static_cast<int>(std::floor(seconds / SecondsOfDay));
  int year = 2000 + static_cast<int>(std::floor(day / 365.2425));
  year -= DaysFromDate(year, 1, 1) > day ? 1 : 0;
  return DaysFromDate(year + 1, 1, 1) <= day ? year + 1 : year;
}

} // namespace shadowcones
