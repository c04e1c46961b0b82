// SPDX-License-Identifier: BSD-3-Clause
#include "scWordReader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

namespace shadowcones
{

struct WordReader::UnitRule
{
  Takes What;
  const char* Name;
  double Factor;
  LightUnit Kind;
};

// Names in lower case. Lengths in metres, angles in degrees.
const WordReader::UnitRule WordReader::Units[] = {
  { Takes::Length, "m", 1.0, LightUnit::None },
  { Takes::Length, "mm", 0.001, LightUnit::None },
  { Takes::Length, "cm", 0.01, LightUnit::None },
  { Takes::Length, "km", 1000.0, LightUnit::None },
  { Takes::Length, "in", 0.0254, LightUnit::None },
  { Takes::Length, "ft", 0.3048, LightUnit::None },
  { Takes::Angle, "deg", 1.0, LightUnit::None },
  { Takes::Angle, "\xC2\xB0", 1.0, LightUnit::None },
  { Takes::Angle, "rad", 180.0 / 3.14159265358979323846, LightUnit::None },
  { Takes::Flux, "w", 1.0, LightUnit::Watt },
  { Takes::Flux, "kw", 1000.0, LightUnit::Watt },
  { Takes::Flux, "lm", 1.0, LightUnit::Lumen },
  { Takes::Intensity, "w/sr", 1.0, LightUnit::Watt },
  { Takes::Intensity, "cd", 1.0, LightUnit::Lumen },
  { Takes::Irradiance, "w/m2", 1.0, LightUnit::Watt },
  { Takes::Irradiance, "w/m^2", 1.0, LightUnit::Watt },
  { Takes::Irradiance, "w/m\xC2\xB2", 1.0, LightUnit::Watt },
  { Takes::Irradiance, "lx", 1.0, LightUnit::Lumen },
  { Takes::Irradiance, "klx", 1000.0, LightUnit::Lumen },
};

namespace
{

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void CheckLeast(const Clause& clause, bool mayBeZero, const char* expected)
{
  for (const double value : clause.Values)
  {
    if (!std::isfinite(value) || value < 0.0 || (value == 0.0 && !mayBeZero))
    {
      WordReader::Expect(expected, clause.Position);
    }
  }
}

// Its length may be anything that a number can hold the square of.
void CheckDirection(const Clause& clause)
{
  const double largest =
    std::max({ std::fabs(clause.Values[0]), std::fabs(clause.Values[1]), std::fabs(clause.Values[2]) });
  if (largest < 1e-150 || largest > 1e150)
  {
    WordReader::Expect("a direction whose length is neither 0 nor immense", clause.Position);
  }
}

} // namespace

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

WordReader::WordReader(
  const std::string& text, std::size_t begin, std::size_t end, const LightGrammarOptions& options)
  : Text(text)
  , Position(begin)
  , End(end)
  , Options(options)
{
  while (this->End > this->Position && IsSpace(this->Text[this->End - 1]))
  {
    --this->End;
  }
}

void WordReader::SkipSpace()
{
  while (!this->AtEnd() && IsSpace(this->Here()))
  {
    ++this->Position;
  }
}

void WordReader::Pass(char c)
{
  this->SkipSpace();
  if (this->Here() == c)
  {
    ++this->Position;
    this->SkipSpace();
  }
}

std::string WordReader::Peek() const
{
  std::size_t end = this->Position;
  while (end < this->End && IsLetter(this->Text[end]))
  {
    ++end;
  }
  return Lower(this->Text.substr(this->Position, end - this->Position));
}

std::string WordReader::ReadPath()
{
  const char quote = this->Here();
  if (quote == '"' || quote == '\'')
  {
    const std::size_t end = this->Text.find(quote, this->Position + 1);
    if (end == std::string::npos || end >= this->End)
    {
      this->Expect("a second quotation mark behind the name of the file");
    }
    const std::string path = this->Text.substr(this->Position + 1, end - this->Position - 1);
    this->Position = end + 1;
    return path;
  }
  const std::size_t begin = this->Position;
  while (!this->AtEnd() && !IsSpace(this->Here()))
  {
    ++this->Position;
  }
  if (begin == this->Position)
  {
    this->Expect("the name of a mesh file");
  }
  return this->Text.substr(begin, this->Position - begin);
}

double WordReader::ReadNumber(const char* expected)
{
  this->SkipSpace();
  const char* const begin = this->Text.data() + this->Position + (this->Here() == '+' ? 1 : 0);
  double value = 0.0;
  const std::from_chars_result read = std::from_chars(begin, this->Text.data() + this->End, value);
  if (read.ec != std::errc() || !std::isfinite(value))
  {
    this->Expect(expected);
  }
  this->Position = static_cast<std::size_t>(read.ptr - this->Text.data());
  return value;
}

// Is there a comma, with or without blanks around it? Moves behind it.
bool WordReader::Comma()
{
  const std::size_t back = this->Position;
  this->SkipSpace();
  if (this->Here() == ',')
  {
    ++this->Position;
    return true;
  }
  this->Position = back;
  return false;
}

std::vector<double> WordReader::ReadList(int count, const char* expected)
{
  std::vector<double> values;
  do
  {
    values.push_back(this->ReadNumber(expected));
  } while (values.size() <= MaximumWavelengths && this->Comma());
  if (count > 0 && values.size() != static_cast<std::size_t>(count))
  {
    this->SkipSpace();
    this->Expect(expected);
  }
  return values;
}

// x, -y, +z: the axis as a vector. Does not move where there is none.
bool WordReader::ReadAxis(std::vector<double>& values)
{
  const char sign = this->Here();
  const std::size_t at = this->Position + (sign == '-' || sign == '+' ? 1 : 0);
  const char letter = Lower(std::string(1, this->At(at)))[0];
  if (letter < 'x' || letter > 'z' || (at + 1 < this->End && !IsSpace(this->Text[at + 1])))
  {
    return false;
  }
  values.assign(3, 0.0);
  values[letter - 'x'] = sign == '-' ? -1.0 : 1.0;
  this->Position = at + 1;
  return true;
}

// A unit here, or behind blanks.
const WordReader::UnitRule* WordReader::ReadUnit(Takes what)
{
  const std::size_t back = this->Position;
  this->SkipSpace();
  const bool touches = back == this->Position && !this->AtEnd();
  std::size_t end = this->Position;
  while (end < this->End && !IsSpace(this->Text[end]))
  {
    ++end;
  }
  const std::string name = Lower(this->Text.substr(this->Position, end - this->Position));
  for (const UnitRule& unit : Units)
  {
    if (unit.What == what && name == unit.Name)
    {
      this->Position = end;
      return &unit;
    }
  }
  if (touches)
  {
    this->Expect("a blank or a unit behind the number");
  }
  this->Position = back;
  return nullptr;
}

void WordReader::ApplyUnit(Takes what, Clause& clause)
{
  if (const UnitRule* unit = this->ReadUnit(what))
  {
    const double factor = what == Takes::Length ? unit->Factor / this->Options.UnitLength : unit->Factor;
    for (double& value : clause.Values)
    {
      value *= factor;
      if (!std::isfinite(value))
      {
        Expect("a number that is not that large", clause.Position);
      }
    }
  }
}

void WordReader::ReadTotal(Takes what, const char* expected, Clause& clause)
{
  clause.Values = this->ReadList(1, expected);
  const UnitRule* unit = this->ReadUnit(what);
  if (!unit)
  {
    this->SkipSpace();
    this->Expect(expected);
  }
  clause.Unit = unit->Kind;
  clause.Values[0] *= unit->Factor;
  CheckLeast(clause, true, expected);
}

void WordReader::ReadLengths(int count, const char* expected, Clause& clause)
{
  clause.Values = this->ReadList(count, expected);
  this->ApplyUnit(Takes::Length, clause);
  CheckLeast(clause, false, expected);
}

Clause WordReader::ReadValues(Takes what)
{
  Clause clause;
  clause.Position = this->Position;
  switch (what)
  {
    case Takes::Place:
      clause.Values = this->ReadList(3, "three numbers, x,y,z");
      this->ApplyUnit(Takes::Length, clause);
      break;
    case Takes::Direction:
      if (!this->ReadAxis(clause.Values))
      {
        clause.Values = this->ReadList(3, "a direction: three numbers, x,y,z, or an axis such as -z");
        this->ApplyUnit(Takes::Direction, clause);
      }
      CheckDirection(clause);
      break;
    case Takes::Length:
      this->ReadLengths(1, "a length above 0", clause);
      break;
    case Takes::TwoLengths:
      this->ReadLengths(2, "two lengths above 0, width,height", clause);
      break;
    case Takes::Angle:
      clause.Values = this->ReadList(1, "an angle in degrees");
      this->ApplyUnit(Takes::Angle, clause);
      break;
    case Takes::Values:
      clause.Values = this->ReadList(0, "a number, or one a wavelength: a,b,c");
      this->ApplyUnit(Takes::Values, clause);
      CheckLeast(clause, true, "numbers of 0 and above");
      break;
    case Takes::Flux:
      this->ReadTotal(what, "a flux of 0 and above, in W or lm", clause);
      break;
    case Takes::Intensity:
      this->ReadTotal(what, "an intensity of 0 and above, in W/sr or cd", clause);
      break;
    case Takes::Irradiance:
      this->ReadTotal(what, "an irradiance of 0 and above, in W/m2 or lx", clause);
      break;
    case Takes::Count:
      clause.Values = this->ReadList(1, "a whole number");
      this->ApplyUnit(Takes::Count, clause);
      break;
  }
  return clause;
}

} // namespace shadowcones
