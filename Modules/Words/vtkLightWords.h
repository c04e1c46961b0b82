// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightWords
 * @brief Lights from words and back: "disc:0,5,0 radius 0.5 facing 0,-1,0".
 *
 * A lamp begins with its shape and place, and goes on with words in any order:
 *
 *     disc:x,y,z       radius r (or diameter d), facing x,y,z
 *     rectangle:x,y,z  size width,height, facing x,y,z, up x,y,z (in which the height is measured)
 *     sphere:x,y,z     radius r (or diameter d)
 *     point:x,y,z
 *     sun:             azimuth a altitude b (degrees; from north clockwise, and above the horizon), up x,y,z, north x,y,z;
 *                      or direction x,y,z (the way the light travels); diameter d (degrees)
 *     mesh:lamp.stl    or the file's name alone; in quotation marks where it has blanks. Every polygon shines.
 *
 * How much light, for every shape one of:
 *
 *     radiance 1             as SetRadiance of vtkAreaLightSource, the same at every wavelength; the default
 *     radiance 1,2,3         one a wavelength
 *     flux 800 lm, flux 60 W         all that leaves the lamp (not of the sun)
 *     intensity 100 cd, 5 W/sr       of a point
 *     irradiance 1000 W/m2, 90 klx   of a plane that faces the sun
 *
 * The last three are sums over all wavelengths, in equal shares, or in those of a list: flux 800 lm spectrum 1,2,3. Lumens are
 * what a standard observer sees of that spectrum. "wavelengths 3" says how many there are, "resolution 64" how finely discs
 * and spheres are drawn.
 *
 * Numbers are in world units; mm, cm, m, km, in and ft behind a length, and deg and rad behind an angle, are units of their own.
 * A direction may be an axis: facing -z. Capital letters do not matter; "radius=0.5" is "radius 0.5". A text holds several
 * lamps, one a line, or between semicolons; a comment begins with #. A text that is the name of a file ending in .txt stands for
 * the text in that file.
 *
 * @sa vtkAreaLightSource vtkMeshFiles
 */
#ifndef vtkLightWords_h
#define vtkLightWords_h

#include "ShadowConesWordsModule.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the lights

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkAreaLightSource;

class SHADOWCONESWORDS_EXPORT vtkLightWords : public vtkObject
{
public:
  static vtkLightWords* New();
  vtkTypeMacro(vtkLightWords, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Metres in a world unit, for lengths with a unit and for lumens and watts: 0.001 where the mesh is in millimetres. Radiant
   * intensities of points are then per square of a world unit, so that irradiance comes in W m^-2. Default: 1. Valid: above 0.
   */
  vtkSetMacro(UnitLength, double);
  vtkGetMacro(UnitLength, double); ///< Metres in a world unit.
  ///@}

  ///@{
  /**
   * The way up of a sun that has no word "up". Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Up, double);
  /// The way up of a sun that has no word "up".
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * The way north of a sun that has no word "north"; where it runs along up, -z, and with z up y. Default: (0, 1, 0).
   */
  vtkSetVector3Macro(North, double);
  /// The way north of a sun that has no word "north".
  vtkGetVector3Macro(North, double);
  ///@}

  /**
   * Read the lamps of a text, and the mesh files that it names. @return false, with a sentence of GetError(), where it is not
   * understood: it names the column, what is there and what was expected. There are no lights then.
   */
  bool Read(const std::string& text);
  /// What went wrong in Read(), as a sentence; empty where nothing did.
  std::string GetError() { return this->Error; }
  int GetErrorLine() { return this->ErrorLine; }     ///< The line of the error, from 1; 0: none, or of a file.
  int GetErrorColumn() { return this->ErrorColumn; } ///< The column of the error in characters, from 1; 0: none.

  /// Number of lights that were read.
  int GetNumberOfLights();
  /**
   * A light, index from 0: its output port is what AddLightConnection() of a filter takes. A vtkAreaLightSource, or of a mesh
   * lamp an algorithm that has the mesh, with field data "LightSpectrum".
   */
  vtkAlgorithm* GetLight(int index);

  /**
   * The words of a light: reading them gives the same light again, bit for bit. Nothing for a light that is none: a
   * shape that is not there, numbers that are not finite.
   */
  static std::string GetWords(vtkAreaLightSource* light);

protected:
  vtkLightWords();
  ~vtkLightWords() override;

private:
  vtkLightWords(const vtkLightWords&) = delete;
  void operator=(const vtkLightWords&) = delete;

  double UnitLength = 1.0;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double North[3] = { 0.0, 1.0, 0.0 };
  std::vector<vtkSmartPointer<vtkAlgorithm>> Lights;
  std::string Error;
  int ErrorLine = 0;
  int ErrorColumn = 0;
};

#endif
