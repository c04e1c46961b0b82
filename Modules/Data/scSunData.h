// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSunData.h
 * @brief The path of the Sun as field data of its light, and hours in the Sun as arrays of points or cells.
 */
#ifndef scSunData_h
#define scSunData_h

#include "ShadowConesDataModule.h"
#include "scSunHours.h"
#include "scSunPositions.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;
class vtkPolyData;

namespace shadowcones
{

/// The Sun at a time.
struct SunMoment
{
  double Time = 0.0; ///< seconds after the start of the path
  SunPosition Position;
  Vector3 Direction; ///< unit, towards it
};

/// What vtkSunPath tells beside its light.
struct SunPath
{
  SunMoment Now;                ///< at the pipeline's time
  std::vector<SunMoment> Times; ///< at the time steps
  std::vector<SunMoment> Steps; ///< at the middle of each step between two of them
  std::vector<double> Lengths;  ///< of these steps, seconds
  double AngularRadius = 0.0;   ///< radians
  Vector3 Up;                   ///< unit
};

/// Write a path: the arrays that vtkSunPath.h lists.
SHADOWCONESDATA_EXPORT void WriteSunPath(const SunPath& path, vtkFieldData* data);

/// The steps of a path, in hours, and the size of the Sun.
struct SunCourse
{
  std::vector<SunStep> Steps;
  double AngularRadius = 0.0;
  Vector3 Up;
  double Highest = -90.0; ///< of all steps, degrees
};

/**
 * Read what WriteSunPath wrote; the Sun is up above @p minimumAltitude, degrees. @return false, with a sentence in @p
 * error, where an array is missing or of the wrong size, or a number is not finite.
 */
SHADOWCONESDATA_EXPORT bool ReadSunPath(
  vtkFieldData* data, double minimumAltitude, SunCourse& course, std::string& error);

/// The altitude that a light tells of that is none for it is below the horizon, degrees; 0 where there is no such
/// thing.
SHADOWCONESDATA_EXPORT double AltitudeBelowHorizon(vtkFieldData* data);

/**
 * Add "SunHours", "FirstSun", "LastSun", "LongestSun", "SunHoursError" and, where it was asked for, "OccluderId" of @p
 * count points or cells. @p items are those that the results belong to, ascending; the others are hidden: NaN and -1.
 */
SHADOWCONESDATA_EXPORT void WriteSunHours(
  const SunHoursResult& result, const std::vector<vtkIdType>& items, vtkIdType count, vtkDataSetAttributes* data);

} // namespace shadowcones

#endif
