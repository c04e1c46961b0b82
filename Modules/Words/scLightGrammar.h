// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightGrammar.h
 * @brief Lamps in words: the grammar, as values. Opens no file. Internal to the module.
 */
#ifndef scLightGrammar_h
#define scLightGrammar_h

#include "scLight.h"
#include "scVector3.h"

#include <string>
#include <vector>

namespace shadowcones
{

/// How much light there is in all: what a total is given in.
enum class LightUnit
{
  None, ///< no total: Spectrum holds radiances
  Watt, ///< of flux, intensity or irradiance, over all wavelengths
  Lumen ///< the same as the eye sees it: lm, cd, lx
};

/// One lamp, as vtkAreaLightSource has it. Lengths in world units, angles in degrees.
struct Lamp
{
  LightShape Shape = LightShape::Disc;
  std::string MeshFile; ///< of Mesh
  Vector3 Center;
  Vector3 Normal{ 0.0, 0.0, 1.0 };
  Vector3 Up{ 0.0, 1.0, 0.0 };
  double Radius = 0.5;
  double Width = 1.0;
  double Height = 1.0;
  double AngularDiameter = 0.533;
  int NumberOfWavelengths = 7;
  int Resolution = 32;
  bool SaysHowMuch = false; ///< there was a word for the amount of light
  /// One value for all wavelengths or one each: what the light source's Radiance is; with a Total shares of it.
  std::vector<double> Spectrum{ 1.0 };
  LightUnit Unit = LightUnit::None;
  /// With a Unit: the flux of the lamp, for an intensity 4 pi times that; of Sun the irradiance.
  double Total = 0.0;
};

struct LightGrammarOptions
{
  double UnitLength = 1.0; ///< metres in a world unit
  Vector3 Up{ 0.0, 0.0, 1.0 };
  Vector3 North{ 0.0, 1.0, 0.0 };
};

/**
 * Radiances, one or one a wavelength as Spectrum has them, by which the lamp has its total; without one Spectrum itself.
 * @param emission watts that leave the lamp (of Sun: per square metre) for a radiance of 1.
 */
std::vector<double> RadiancesOf(const Lamp& lamp, double emission);

/// What is wrong with the words, and where: lines and columns (characters) from 1.
struct LightFault
{
  int Line = 0;
  int Column = 0;
  std::string Sentence;
};

/**
 * Read lamps: one a line, or several between semicolons; what follows # is a comment. Any bytes may come.
 * @return false, with @p fault, where a lamp is not understood.
 */
bool ParseLamps(
  const std::string& text, const LightGrammarOptions& options, std::vector<Lamp>& lamps, LightFault& fault);

} // namespace shadowcones

#endif
