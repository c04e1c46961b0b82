// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scWordReader.h
 * @brief Words, numbers and units from text, one after the other. Internal to the module.
 */
#ifndef scWordReader_h
#define scWordReader_h

#include "scLightGrammar.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shadowcones
{

/// What a word is followed by.
enum class Takes
{
  Place,
  Direction,
  Length,
  TwoLengths,
  Angle,
  Values,
  Flux,
  Intensity,
  Irradiance,
  Count
};

/// What followed a word, in world units and degrees.
struct Clause
{
  std::size_t Position = 0; ///< of its first value
  std::vector<double> Values;
  LightUnit Unit = LightUnit::None;
};

/// Thrown where the text is not understood: where, and what should stand there.
struct Unexpected
{
  std::size_t Position;
  std::string Expected;
};

inline bool IsSpace(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Capital letters made small; nothing else changes.
std::string Lower(std::string text);

/// Most numbers that a list may have.
constexpr int MaximumWavelengths = 1000;

/// Moves over a part of a text; every Read... throws Unexpected where the text goes on otherwise.
class WordReader
{
public:
  /// The part from @p begin to @p end, without blanks at its end.
  WordReader(const std::string& text, std::size_t begin, std::size_t end, const LightGrammarOptions& options);

  bool AtEnd() const { return this->Position >= this->End; }
  std::size_t Where() const { return this->Position; }
  std::size_t EndOfText() const { return this->End; }
  char Here() const { return this->AtEnd() ? '\0' : this->Text[this->Position]; }
  char At(std::size_t position) const { return position < this->End ? this->Text[position] : '\0'; }
  void MoveTo(std::size_t position) { this->Position = position; }
  void SkipSpace();
  /// Move behind a character that may stand here, and behind blanks around it.
  void Pass(char c);
  /// Letters from here on, in lower case; does not move.
  std::string Peek() const;
  /// All that is left; does not move.
  std::string Rest() const { return this->Text.substr(this->Position, this->End - this->Position); }

  /// The name of a file: up to a blank, or in quotation marks.
  std::string ReadPath();
  /// Numbers, and their unit.
  Clause ReadValues(Takes what);

  [[noreturn]] void Expect(const std::string& what) const { throw Unexpected{ this->Position, what }; }
  [[noreturn]] static void Expect(const std::string& what, std::size_t position)
  {
    throw Unexpected{ position, what };
  }

private:
  struct UnitRule;
  static const UnitRule Units[];

  double ReadNumber(const char* expected);
  bool Comma();
  std::vector<double> ReadList(int count, const char* expected);
  bool ReadAxis(std::vector<double>& values);
  const UnitRule* ReadUnit(Takes what);
  void ReadTotal(Takes what, const char* expected, Clause& clause);
  void ReadLengths(int count, const char* expected, Clause& clause);
  void ApplyUnit(Takes what, Clause& clause);

  const std::string& Text;
  std::size_t Position;
  std::size_t End;
  const LightGrammarOptions& Options;
};

} // namespace shadowcones

#endif
