// SPDX-License-Identifier: BSD-3-Clause
#include "scLightGrammar.h"

#include "scMeshFormats.h"
#include "scSentence.h"
#include "scSpectrum.h"
#include "scWordReader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace shadowcones
{

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;

constexpr unsigned Bit(LightShape shape)
{
  return 1U << static_cast<unsigned>(shape);
}
constexpr unsigned Flat = Bit(LightShape::Disc) | Bit(LightShape::Rectangle);
constexpr unsigned Round = Bit(LightShape::Disc) | Bit(LightShape::Sphere);
constexpr unsigned Sun = Bit(LightShape::Sun);
constexpr unsigned Any = 0x3F;

struct WordRule
{
  const char* Word;
  Takes What;
  unsigned Shapes;                  // that have the word
  unsigned Needing;                 // shapes that cannot do without it
  std::vector<std::string> Instead; // words that say the same in another way: one is enough, two are too many
};

const WordRule Rules[] = {
  { "radius", Takes::Length, Round, Round, { "diameter" } },
  { "diameter", Takes::Length, Round, 0, { "radius" } },
  { "diameter", Takes::Angle, Sun, 0, {} },
  { "size", Takes::TwoLengths, Bit(LightShape::Rectangle), Bit(LightShape::Rectangle), {} },
  { "facing", Takes::Direction, Flat, Flat, {} },
  { "direction", Takes::Direction, Sun, 0, { "azimuth", "altitude", "north", "up" } },
  { "azimuth", Takes::Angle, Sun, Sun, { "direction" } },
  { "altitude", Takes::Angle, Sun, Sun, { "direction" } },
  { "up", Takes::Direction, Sun | Bit(LightShape::Rectangle), 0, { "direction" } },
  { "north", Takes::Direction, Sun, 0, { "direction" } },
  { "center", Takes::Place, Sun, 0, {} },
  { "radiance", Takes::Values, Any, 0, { "flux", "intensity", "irradiance", "spectrum" } },
  { "flux", Takes::Flux, Any & ~Sun, 0, { "radiance", "intensity" } },
  { "intensity", Takes::Intensity, Bit(LightShape::Point), 0, { "radiance", "flux" } },
  { "irradiance", Takes::Irradiance, Sun, 0, { "radiance" } },
  { "spectrum", Takes::Values, Any, 0, { "radiance" } },
  { "wavelengths", Takes::Count, Any, 0, {} },
  { "resolution", Takes::Count, Round, 0, {} },
};

struct ShapeName
{
  const char* Name;
  LightShape Shape;
};
const ShapeName Shapes[] = { { "disc", LightShape::Disc }, { "rectangle", LightShape::Rectangle },
  { "sphere", LightShape::Sphere }, { "point", LightShape::Point }, { "sun", LightShape::Sun },
  { "mesh", LightShape::Mesh } };

const char* NameOf(LightShape shape)
{
  return Shapes[static_cast<int>(shape)].Name;
}

bool Has(const std::vector<std::string>& words, const std::string& word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

class LampParser
{
public:
  LampParser(const std::string& text, std::size_t begin, std::size_t end, const LightGrammarOptions& options)
    : Reader(text, begin, end, options)
    , Options(options)
  {
  }

  /// @return false where there is nothing but blanks.
  bool Parse(Lamp& lamp)
  {
    this->Reader.SkipSpace();
    if (this->Reader.AtEnd())
    {
      return false;
    }
    const std::size_t begin = this->Reader.Where();
    this->ReadShape(lamp);
    if (lamp.MeshFile.find('"') != std::string::npos && lamp.MeshFile.find('\'') != std::string::npos)
    {
      WordReader::Expect("the name of a mesh file with quotation marks of one kind at most", begin); // or TextOf has none left
    }
    this->Shape = lamp.Shape;
    for (this->Reader.SkipSpace(); !this->Reader.AtEnd(); this->Reader.SkipSpace())
    {
      this->ReadClause();
    }
    this->CheckWhole();
    this->SetGeometry(lamp);
    this->SetAmount(lamp);
    return true;
  }

private:
  void ReadShape(Lamp& lamp)
  {
    const std::string word = this->Reader.Peek();
    const std::size_t after = this->Reader.Where() + word.size();
    const char next = this->Reader.At(after);
    const bool alone = next == '\0' || next == ':' || IsSpace(next);
    const auto* shape = std::find_if(
      std::begin(Shapes), std::end(Shapes), [&](const ShapeName& each) { return word == each.Name; });
    if (shape == std::end(Shapes) || !alone)
    {
      this->ReadFileAlone(lamp);
      return;
    }
    lamp.Shape = shape->Shape;
    this->Reader.MoveTo(after);
    this->Reader.Pass(':');
    if (lamp.Shape == LightShape::Mesh)
    {
      lamp.MeshFile = this->Reader.ReadPath();
    }
    else if (lamp.Shape != LightShape::Sun)
    {
      lamp.Center = AsVector(this->Reader.ReadValues(Takes::Place));
    }
  }

  // A lamp may be the name of a file and nothing else; with blanks in it, of the whole of the text.
  void ReadFileAlone(Lamp& lamp)
  {
    const std::size_t begin = this->Reader.Where();
    lamp.Shape = LightShape::Mesh;
    lamp.MeshFile = this->Reader.Rest();
    if (IsMeshFileName(lamp.MeshFile))
    {
      this->Reader.MoveTo(this->Reader.EndOfText());
      return;
    }
    lamp.MeshFile = this->Reader.ReadPath();
    if (!IsMeshFileName(lamp.MeshFile))
    {
      WordReader::Expect("a lamp: disc, rectangle, sphere, point, sun, mesh, or the name of a mesh file", begin);
    }
  }

  std::string ListOfWords() const
  {
    std::string list;
    for (const WordRule& rule : Rules)
    {
      if (rule.Shapes & Bit(this->Shape))
      {
        list += (list.empty() ? "" : ", ") + std::string(rule.Word);
      }
    }
    return list;
  }

  void ReadClause()
  {
    const std::size_t begin = this->Reader.Where();
    const std::string word = this->Reader.Peek();
    const auto* rule = std::find_if(std::begin(Rules), std::end(Rules),
      [&](const WordRule& each) { return word == each.Word && (each.Shapes & Bit(this->Shape)); });
    if (rule == std::end(Rules))
    {
      this->Reader.Expect(Sentence("a word of a ", NameOf(this->Shape), ": ", this->ListOfWords()));
    }
    if (this->Clauses.count(word))
    {
      this->Reader.Expect("each word once");
    }
    for (const auto& clause : this->Clauses)
    {
      if (Has(rule->Instead, clause.first))
      {
        WordReader::Expect(Sentence("nothing that says what \"", clause.first, "\" has said"), begin);
      }
    }
    this->Reader.MoveTo(begin + word.size());
    this->Reader.Pass('=');
    this->Clauses[word] = this->Reader.ReadValues(rule->What);
  }

  void CheckWhole() const
  {
    for (const WordRule& rule : Rules)
    {
      if (!(rule.Needing & Bit(this->Shape)) || this->Clauses.count(rule.Word))
      {
        continue;
      }
      const bool said = std::any_of(this->Clauses.begin(), this->Clauses.end(), [&](const auto& clause)
        { return Has(rule.Instead, clause.first); });
      if (!said)
      {
        const std::string other = rule.Instead.empty() ? "" : " or \"" + rule.Instead.front() + "\"";
        WordReader::Expect(Sentence("the word \"", rule.Word, "\"", other, ", which a ", NameOf(this->Shape), " needs"),
          this->Reader.EndOfText());
      }
    }
  }

  static Vector3 AsVector(const Clause& clause) { return { clause.Values[0], clause.Values[1], clause.Values[2] }; }
  const Clause* Find(const char* word) const
  {
    const auto found = this->Clauses.find(word);
    return found == this->Clauses.end() ? nullptr : &found->second;
  }

  void SetGeometry(Lamp& lamp) const
  {
    if (const Clause* radius = this->Find("radius"))
    {
      lamp.Radius = radius->Values[0];
    }
    if (const Clause* diameter = this->Find("diameter"))
    {
      if (lamp.Shape == LightShape::Sun && !(diameter->Values[0] >= 0.0 && diameter->Values[0] < 180.0))
      {
        WordReader::Expect("an angle of 0 and above, below 180 degrees", diameter->Position);
      }
      (lamp.Shape == LightShape::Sun ? lamp.AngularDiameter : lamp.Radius) =
        lamp.Shape == LightShape::Sun ? diameter->Values[0] : 0.5 * diameter->Values[0];
      if (!(lamp.Radius > 0.0))
      {
        WordReader::Expect("a length above 0", diameter->Position); // half of the smallest number is 0
      }
    }
    if (const Clause* size = this->Find("size"))
    {
      lamp.Width = size->Values[0];
      lamp.Height = size->Values[1];
    }
    if (const Clause* facing = this->Find("facing"))
    {
      lamp.Normal = AsVector(*facing);
    }
    if (const Clause* center = this->Find("center"))
    {
      lamp.Center = AsVector(*center);
    }
    if (lamp.Shape == LightShape::Rectangle && this->Find("up"))
    {
      lamp.Up = AsVector(*this->Find("up"));
    }
    if (lamp.Shape == LightShape::Sun)
    {
      lamp.Normal = this->SunDirection();
    }
    if (const Clause* resolution = this->Find("resolution"))
    {
      lamp.Resolution = WholeNumber(*resolution, 3, 4096, "a whole number from 3 to 4096");
    }
  }

  // The way that the Sun's light travels.
  Vector3 SunDirection() const
  {
    if (const Clause* direction = this->Find("direction"))
    {
      return AsVector(*direction);
    }
    const Clause* givenUp = this->Find("up");
    const Clause* givenNorth = this->Find("north");
    const Vector3 up = Normalized(givenUp ? AsVector(*givenUp) : this->Options.Up);
    Vector3 north = Normalized(givenNorth ? AsVector(*givenNorth) : this->Options.North);
    if (!givenNorth && Length(Cross(up, north)) < 1e-6)
    {
      // North cannot be up: where y is up, maps and models have it along -z.
      north = std::fabs(up.Y) > 0.5 ? Vector3{ 0.0, 0.0, -1.0 } : Vector3{ 0.0, 1.0, 0.0 };
    }
    const Vector3 east = Cross(north, up);
    if (Length(east) < 1e-6)
    {
      WordReader::Expect("a north that does not run along up", givenNorth ? givenNorth->Position : this->Reader.EndOfText());
    }
    const Clause& altitude = *this->Find("altitude");
    if (std::fabs(altitude.Values[0]) > 90.0)
    {
      WordReader::Expect("an altitude from -90 to 90 degrees", altitude.Position);
    }
    const double azimuth = this->Find("azimuth")->Values[0] * Degree;
    const Vector3 eastward = Normalized(east);
    const Vector3 northward = Cross(up, eastward);
    const double height = altitude.Values[0] * Degree;
    const Vector3 towards =
      std::cos(height) * (std::cos(azimuth) * northward + std::sin(azimuth) * eastward) + std::sin(height) * up;
    return -towards;
  }

  static int WholeNumber(const Clause& clause, int least, int most, const char* expected)
  {
    const double value = clause.Values[0];
    if (!(value >= least && value <= most && value == std::floor(value)))
    {
      WordReader::Expect(expected, clause.Position);
    }
    return static_cast<int>(value);
  }

  void SetAmount(Lamp& lamp) const
  {
    for (const char* word : { "flux", "intensity", "irradiance" })
    {
      if (const Clause* total = this->Find(word))
      {
        lamp.Total = std::string(word) == "intensity" ? 4.0 * Pi * total->Values[0] : total->Values[0];
        lamp.Unit = total->Unit;
        if (!std::isfinite(lamp.Total))
        {
          WordReader::Expect("a number that is not that large", total->Position);
        }
      }
    }
    lamp.SaysHowMuch = lamp.Unit != LightUnit::None || this->Find("radiance");
    const Clause* spectrum = this->Find("spectrum");
    const Clause* values = spectrum ? spectrum : this->Find("radiance");
    if (values)
    {
      lamp.Spectrum = values->Values;
      lamp.NumberOfWavelengths = values->Values.size() > 1 ? static_cast<int>(values->Values.size()) : 7;
      if (lamp.NumberOfWavelengths > MaximumWavelengths)
      {
        WordReader::Expect("at most 1000 numbers", values->Position);
      }
    }
    if (spectrum && lamp.Unit == LightUnit::None)
    {
      WordReader::Expect("a total beside \"spectrum\": flux, intensity or irradiance", this->Reader.EndOfText());
    }
    if (spectrum && *std::max_element(spectrum->Values.begin(), spectrum->Values.end()) <= 0.0)
    {
      WordReader::Expect("a spectrum that is not 0 everywhere", spectrum->Position);
    }
    if (const Clause* wavelengths = this->Find("wavelengths"))
    {
      const int count =
        WholeNumber(*wavelengths, 1, MaximumWavelengths, "a whole number of wavelengths from 1 to 1000");
      if (lamp.Spectrum.size() > 1 && count != lamp.NumberOfWavelengths)
      {
        WordReader::Expect(Sentence("as many wavelengths as the list has numbers, ", lamp.Spectrum.size()), wavelengths->Position);
      }
      lamp.NumberOfWavelengths = count;
    }
  }

  WordReader Reader;
  const LightGrammarOptions& Options;
  LightShape Shape = LightShape::Disc;
  std::map<std::string, Clause> Clauses;
};

// The word at a place of the text, fit to be shown.
std::string FoundAt(const std::string& text, std::size_t position, std::size_t end)
{
  std::string found;
  for (; position < end && !IsSpace(text[position]) && found.size() < 40; ++position)
  {
    found += text[position] >= 0x20 && text[position] < 0x7F ? text[position] : '?';
  }
  return found.empty() ? "the end" : "\"" + found + "\"";
}

void Report(const std::string& text, std::size_t end, const Unexpected& wrong, LightFault& fault)
{
  fault.Line = 1;
  fault.Column = 1;
  for (std::size_t i = 0; i < wrong.Position && i < text.size(); ++i)
  {
    if (text[i] == '\n')
    {
      ++fault.Line;
      fault.Column = 1;
    }
    else if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) // not inside a character of UTF-8
    {
      ++fault.Column;
    }
  }
  const std::string place = fault.Line > 1 || text.find('\n') != std::string::npos
    ? Sentence("line ", fault.Line, ", column ", fault.Column)
    : Sentence("column ", fault.Column);
  fault.Sentence = Sentence(
    "The words of the light, ", place, ": expected ", wrong.Expected, "; found ", FoundAt(text, wrong.Position, end), ".");
}

// The end of the lamp that begins here, and where the next one begins.
std::size_t EndOfLamp(const std::string& text, std::size_t begin, std::size_t& next)
{
  char quote = '\0';
  for (std::size_t i = begin; i < text.size(); ++i)
  {
    const char c = text[i];
    if (c == '\n' || (!quote && c == ';'))
    {
      next = i + 1;
      return i;
    }
    if (!quote && c == '#')
    {
      next = text.find('\n', i);
      next = next == std::string::npos ? text.size() : next + 1;
      return i;
    }
    if (quote ? c == quote : c == '"' || c == '\'')
    {
      quote = quote ? '\0' : c;
    }
  }
  next = text.size();
  return next;
}

} // namespace

std::vector<double> RadiancesOf(const Lamp& lamp, double emission)
{
  if (lamp.Unit == LightUnit::None)
  {
    return lamp.Spectrum;
  }
  constexpr double lumensPerWatt = 683.0; // at 555 nm
  const std::vector<double> wavelengths = DefaultWavelengths(lamp.NumberOfWavelengths);
  double sum = 0.0;
  for (std::size_t i = 0; i < wavelengths.size(); ++i)
  {
    const double share = lamp.Spectrum.size() > 1 ? lamp.Spectrum[i] : 1.0;
    sum += share * (lamp.Unit == LightUnit::Lumen ? lumensPerWatt * CieXyz(wavelengths[i])[1] : 1.0);
  }
  std::vector<double> radiances;
  for (const double share : lamp.Spectrum)
  {
    radiances.push_back(lamp.Total * (lamp.Spectrum.size() > 1 ? share : 1.0) / (sum * emission));
  }
  return radiances;
}

bool ParseLamps(
  const std::string& text, const LightGrammarOptions& options, std::vector<Lamp>& lamps, LightFault& fault)
{
  lamps.clear();
  std::size_t next = 0;
  for (std::size_t begin = 0; begin < text.size(); begin = next)
  {
    const std::size_t end = EndOfLamp(text, begin, next);
    try
    {
      Lamp lamp;
      if (LampParser(text, begin, end, options).Parse(lamp))
      {
        lamps.push_back(lamp);
      }
    }
    catch (const Unexpected& wrong)
    {
      Report(text, end, wrong, fault);
      lamps.clear();
      return false;
    }
  }
  if (lamps.empty())
  {
    Report(text, text.size(), Unexpected{ text.size(), "a lamp, such as disc:0,5,0 radius 0.5 facing 0,-1,0" }, fault);
    return false;
  }
  return true;
}

} // namespace shadowcones
