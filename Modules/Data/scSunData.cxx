// SPDX-License-Identifier: BSD-3-Clause
#include "scSunData.h"

#include "scFieldArrays.h"
#include "scProbePoints.h"
#include "scSentence.h"
#include "scTuples.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{
namespace
{

constexpr double secondsOfHour = 3600.0;

/// Arrays of moments, each named @p prefix and what is in it.
void WriteMoments(const std::string& prefix, const std::vector<SunMoment>& moments, vtkFieldData* data)
{
  std::vector<double> times, directions, altitudes, azimuths;
  for (const SunMoment& moment : moments)
  {
    times.push_back(moment.Time);
    directions.insert(directions.end(), { moment.Direction.X, moment.Direction.Y, moment.Direction.Z });
    altitudes.push_back(vtkMath::DegreesFromRadians(moment.Position.Altitude));
    azimuths.push_back(vtkMath::DegreesFromRadians(moment.Position.Azimuth));
  }
  AddDoubleArray(data, (prefix + "Time").c_str(), 1, times);
  AddDoubleArray(data, (prefix + "Direction").c_str(), 3, directions);
  AddDoubleArray(data, (prefix + "Altitude").c_str(), 1, altitudes);
  AddDoubleArray(data, (prefix + "Azimuth").c_str(), 1, azimuths);
}

/// The arrays that ReadSunPath needs.
struct StepArrays
{
  vtkDataArray* Times = nullptr;
  vtkDataArray* Lengths = nullptr;
  vtkDataArray* Directions = nullptr;
  vtkDataArray* Altitudes = nullptr;
  vtkDataArray* Diameter = nullptr;
  vtkDataArray* Up = nullptr;

  bool Find(vtkFieldData* data, std::string& error)
  {
    const auto find = [data, &error](const char* name, int components, vtkIdType tuples, vtkDataArray*& array)
    { return FindArray(data, "Sun's path", name, components, tuples, Need::Required, array, error); };
    const vtkIdType count = data->GetArray("SunStepTime") ? data->GetArray("SunStepTime")->GetNumberOfTuples() : 0;
    return find("SunStepTime", 1, count, this->Times) && find("SunStepLength", 1, count, this->Lengths) &&
      find("SunStepDirection", 3, count, this->Directions) && find("SunStepAltitude", 1, count, this->Altitudes) &&
      find("SunAngularDiameter", 1, 1, this->Diameter) && find("SunUp", 3, 1, this->Up);
  }

  bool Read(vtkIdType i, double& altitude, SunStep& step) const
  {
    altitude = this->Altitudes->GetComponent(i, 0);
    step.Length = this->Lengths->GetComponent(i, 0) / secondsOfHour;
    step.Begin = this->Times->GetComponent(i, 0) / secondsOfHour - 0.5 * step.Length;
    step.Direction = Normalized({ this->Directions->GetComponent(i, 0), this->Directions->GetComponent(i, 1),
      this->Directions->GetComponent(i, 2) });
    return !FaultOf({ step.Begin, altitude, step.Length }) && step.Length > 0.0 &&
      Dot(step.Direction, step.Direction) > 0.5 && IsFinite(step.Direction);
  }
};

} // anonymous namespace

void WriteSunPath(const SunPath& path, vtkFieldData* data)
{
  WriteMoments("Sun", { path.Now }, data);
  data->RemoveArray("SunTime"); // the data object has it
  WriteMoments("SunPath", path.Times, data);
  WriteMoments("SunStep", path.Steps, data);
  AddDoubleArray(data, "SunStepLength", 1, path.Lengths);
  AddDoubleArray(data, "SunUp", 3, { path.Up.X, path.Up.Y, path.Up.Z });
  AddDoubleArray(data, "SunAngularDiameter", 1, { 2.0 * vtkMath::DegreesFromRadians(path.AngularRadius) });
}

bool ReadSunPath(vtkFieldData* data, double minimumAltitude, SunCourse& course, std::string& error)
{
  course = {};
  if (!data->GetAbstractArray("SunStepTime"))
  {
    error = "The path of the Sun has no field array \"SunStepTime\": connect a vtkSunPath with SetPathConnection.";
    return false;
  }
  StepArrays arrays;
  if (!arrays.Find(data, error))
  {
    return false;
  }
  course.AngularRadius = 0.5 * vtkMath::RadiansFromDegrees(arrays.Diameter->GetComponent(0, 0));
  course.Up =
    Normalized({ arrays.Up->GetComponent(0, 0), arrays.Up->GetComponent(0, 1), arrays.Up->GetComponent(0, 2) });
  if (!(course.AngularRadius >= 0.0 && course.AngularRadius <= 0.5 * vtkMath::Pi()))
  {
    error = "The sun's angular diameter must be from 0 to 180 degrees.";
    return false;
  }
  if (!(Dot(course.Up, course.Up) > 0.5))
  {
    error = "\"SunUp\" of the Sun's path must be a direction.";
    return false;
  }
  for (vtkIdType i = 0; i < arrays.Times->GetNumberOfTuples(); ++i)
  {
    SunStep step;
    double altitude = 0.0;
    if (!arrays.Read(i, altitude, step))
    {
      error = Sentence("Step ", i, " of the Sun's path has a number that is not finite, no direction, or no length.");
      return false;
    }
    step.IsUp = altitude > minimumAltitude;
    course.Highest = std::max(course.Highest, altitude);
    course.Steps.push_back(step);
  }
  return true;
}

double AltitudeBelowHorizon(vtkFieldData* data)
{
  vtkDataArray* altitude = data->GetArray("SunAltitude");
  return altitude && altitude->GetNumberOfValues() == 1 ? std::min(altitude->GetComponent(0, 0), 0.0) : 0.0;
}

void WriteSunHours(
  const SunHoursResult& result, const std::vector<vtkIdType>& items, vtkIdType count, vtkDataSetAttributes* data)
{
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  const auto add = [&](const char* name, const std::vector<float>& values)
  { AddFloatArray(data, name, 1, Spread(values, 1, items, count, unknown)); };
  add("SunHours", result.Hours);
  add("FirstSun", result.First);
  add("LastSun", result.Last);
  add("LongestSun", result.Longest);
  add("SunHoursError", result.Errors);
  if (result.OccluderIds.size() == items.size())
  {
    AddIntArray(data, "OccluderId", 1, Spread(result.OccluderIds, 1, items, count, -1));
  }
}

} // namespace shadowcones
