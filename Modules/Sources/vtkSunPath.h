// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSunPath
 * @brief The Sun over a place on Earth: a light for every time, and the whole path.
 *
 * Where the Sun stands follows from Latitude, Longitude and time by ERFA, the routines of the International Astronomical
 * Union's standards: right to 0.004 degrees in the years 1900 to 2099, the range of Start and End. Times are taken for
 * UT1, from which UTC differs by less than 0.9 seconds as long as it has leap seconds; what they part by more moves the
 * Sun by 0.004 degrees a second. The scene's Up and North say how it is turned.
 *
 * The pipeline's time counts in seconds from Start. The time steps are 0, Step, 2 Step and so on, and the end; any time
 * between them can be asked for, and times outside are taken as the nearest one. Days have 86,400 seconds: a leap
 * second is none.
 *
 * Input: none.
 *
 * Output: poly data, a Sun as vtkAreaLightSource gives it, for the time asked: one vertex with active normals
 * "Normals", and the exact shape in field data ("LightShape" 4, "LightNormal", "LightRadius", "LightSpectrum" and the
 * others). With the middle of the Sun on the horizon or below there is no light: no vertex and no field array of a
 * light, and filters that are asked for an answer then say so. Every piece holds the whole.
 *
 * Field data, at all times:
 * - "SunAltitude", "SunAzimuth" (double 1, degrees): of the time asked; azimuth clockwise from north, 0 to 360
 * - "SunDirection" (double 3, unit): towards the Sun, at that time
 * - "SunAngularDiameter" (double 1, degrees), "SunUp" (double 3, unit): as they were set
 * - "SunPathTime" (double, seconds after Start), "SunPathDirection" (double 3), "SunPathAltitude", "SunPathAzimuth"
 *   (double, degrees): one tuple a time step
 * - "SunStepTime", "SunStepDirection", "SunStepAltitude", "SunStepAzimuth": the same at the middle of each step between
 *   two time steps; "SunStepLength" (double, seconds), the last step may be shorter than Step
 *
 * @sa vtkSunHours vtkAreaLightSource
 */
#ifndef vtkSunPath_h
#define vtkSunPath_h

#include "ShadowConesSourcesModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <map>    // for the spectrum
#include <string> // for dates
#include <vector>

class vtkDataArray;

namespace shadowcones
{
struct Light;
struct SunPath;
} // namespace shadowcones

class SHADOWCONESSOURCES_EXPORT vtkSunPath : public vtkPolyDataAlgorithm
{
public:
  static vtkSunPath* New();
  vtkTypeMacro(vtkSunPath, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * Geographic latitude, degrees, north is positive, -90 to 90. Default: 0.
   */
  vtkSetMacro(Latitude, double);
  vtkGetMacro(Latitude, double); ///< Geographic latitude, degrees, north is positive.
  ///@}

  ///@{
  /**
   * Geographic longitude, degrees, east is positive, -360 to 360. At a pole it is where south (north) is. Default: 0.
   */
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double); ///< Geographic longitude, degrees, east is positive.
  ///@}

  ///@{
  /**
   * The first time, a date or a date and time of ISO 8601: 2024-06-21, 2024-06-21T12:00, 2024-06-21T12:00:00.5+02:00.
   * Without a zone it is UTC; a date alone is its midnight. Years 1900 to 2099. Default: 2024-06-21T00:00:00Z.
   */
  vtkSetStdStringFromCharMacro(Start);
  vtkGetCharFromStdStringMacro(Start); ///< The first time, as it was set.
  ///@}

  ///@{
  /**
   * The last time, written as Start, and not before it. Default: 2024-06-22T00:00:00Z.
   */
  vtkSetStdStringFromCharMacro(End);
  vtkGetCharFromStdStringMacro(End); ///< The last time, as it was set.
  ///@}

  ///@{
  /**
   * Minutes between two time steps, above 0, so that there are at most 10,000,000. Default: 10.
   */
  vtkSetMacro(Step, double);
  vtkGetMacro(Step, double); ///< Minutes between two time steps.
  ///@}

  ///@{
  /**
   * Which way is up in the scene, any length above 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Up, double);
  /// Which way is up in the scene.
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Which way is north in the scene; what of it is along Up does not count, and something must be left. With both
   * defaults x is east. Default: (0, 1, 0).
   */
  vtkSetVector3Macro(North, double);
  /// Which way is north in the scene.
  vtkGetVector3Macro(North, double);
  ///@}

  ///@{
  /**
   * Lift the Sun as the air does, by Saemundsson's formula for 1010 hPa and 10 degrees Celsius: half a degree at the
   * horizon, 0.02 degrees at an altitude of 40. Default: off.
   */
  vtkSetMacro(Refraction, bool);
  vtkGetMacro(Refraction, bool); ///< Whether the air lifts the Sun.
  /// The air lifts the Sun.
  vtkBooleanMacro(Refraction, bool); ///< The Sun stands where it would be seen without air.
  ///@}

  ///@{
  /**
   * The angle under which the Sun is seen, degrees, from 0 (hard shadows) to 180. Default: 0.533, the mean from Earth.
   */
  vtkSetMacro(AngularDiameter, double);
  vtkGetMacro(AngularDiameter, double); ///< The angle under which the Sun is seen, degrees.
  ///@}

  ///@{
  /**
   * Number of wavelength samples, from 1 to 1000: the centres of equal bins from 400 to 700 nm. Default: 7.
   */
  vtkSetMacro(NumberOfWavelengths, int);
  vtkGetMacro(NumberOfWavelengths, int); ///< Number of wavelength samples.
  ///@}

  ///@{
  /**
   * Irradiance of a plane that faces the Sun, W m^-2, the same at every wavelength sample and every altitude, at least
   * 0. Setting it drops the values of SetRadianceSpectrum. Default: 1.
   */
  void SetRadiance(double radiance);
  double GetRadiance()
  {
    return this->Radiance;
  } ///< Irradiance at samples that SetRadianceSpectrum has not set, W m^-2.
  ///@}

  ///@{
  /**
   * Irradiance at one wavelength sample, W m^-2; indices from 0 to NumberOfWavelengths - 1. Default: Radiance.
   */
  void SetRadianceSpectrum(int index, double radiance);
  double GetRadianceSpectrum(int index); ///< Irradiance at one wavelength sample, index from 0, W m^-2.
  /// Irradiance at the first samples, in place of all that were set.
  void SetRadianceSpectrum(vtkDataArray* radiances);
  void ClearRadianceSpectrum(); ///< Every sample is Radiance again.
  ///@}

protected:
  vtkSunPath();
  ~vtkSunPath() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSunPath(const vtkSunPath&) = delete;
  void operator=(const vtkSunPath&) = delete;

  /// Start, in seconds as ReadCivilTime counts them, and the time steps. @return what is wrong, as a sentence, or
  /// nothing.
  std::string ReadTimes(double& start, std::vector<double>& steps) const;
  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  shadowcones::SunPath MakePath(double start, const std::vector<double>& steps, double now) const;
  /// @return false, with a sentence in @p error, where that is no light.
  bool MakeLight(const shadowcones::SunPath& path, shadowcones::Light& light, std::string& error) const;

  double Latitude = 0.0;
  double Longitude = 0.0;
  std::string Start = "2024-06-21T00:00:00Z";
  std::string End = "2024-06-22T00:00:00Z";
  double Step = 10.0;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double North[3] = { 0.0, 1.0, 0.0 };
  bool Refraction = false;
  double AngularDiameter = 0.533;
  int NumberOfWavelengths = 7;
  double Radiance = 1.0;
  std::map<int, double> RadianceSpectrum; // samples that differ from Radiance
};

#endif
