// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSunPath.h"

#include "scCivilTime.h"
#include "scFieldArrays.h"
#include "scFilterRun.h"
#include "scGuardedRequest.h"
#include "scLightData.h"
#include "scParameterRanges.h"
#include "scSentence.h"
#include "scSpectrum.h"
#include "scSpectrumSamples.h"
#include "scSunData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace shadowcones;
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int mostSteps = 10000000;
constexpr int firstYear = 1900;
constexpr int lastYear = 2099;

Vector3 VectorOf(const double* v)
{
  return { v[0], v[1], v[2] };
}

/// Up, and the part of north that lies in the plane; zero where there is none.
Horizon HorizonOf(const double* up, const double* north)
{
  Horizon horizon;
  horizon.Up = Normalized(VectorOf(up));
  const Vector3 towards = Normalized(VectorOf(north));
  const Vector3 level = towards - Dot(towards, horizon.Up) * horizon.Up;
  constexpr double least = 1e-6;
  horizon.North = Length(level) > least ? Normalized(level) : Vector3();
  return horizon;
}

/// Read a date of the parameter @p name. @return what is wrong with it.
std::string ReadDate(const char* name, const std::string& text, double& seconds)
{
  if (!ReadCivilTime(text, seconds))
  {
    return Sentence(
      name, " is \"", text, "\": it must be a date, or a date and time, such as 2024-06-21T12:00:00+02:00.");
  }
  const int year = YearOf(seconds);
  return year >= firstYear && year <= lastYear
    ? std::string()
    : Sentence(name, " is in the year ", year, ": it must be in ", firstYear, "..", lastYear, ".");
}

} // namespace

vtkStandardNewMacro(vtkSunPath);
scDefineGuardedRequests(vtkSunPath);

vtkSunPath::vtkSunPath()
{
  this->SetNumberOfInputPorts(0);
}

scDefineSpectrum(vtkSunPath, Radiance);

std::string vtkSunPath::ReadTimes(double& start, std::vector<double>& steps) const
{
  double end = 0.0;
  std::string fault = ReadDate("Start", this->Start, start);
  fault = fault.empty() ? ReadDate("End", this->End, end) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const double duration = end - start;
  if (duration < 0.0)
  {
    return Sentence("End, ", this->End, ", is before Start, ", this->Start, ".");
  }
  constexpr double secondsOfMinute = 60.0;
  const double step = secondsOfMinute * this->Step;
  // A remainder that is rounding is no step.
  const double count = std::ceil(duration / step - 1e-9);
  if (!(step > 0.0 && std::isfinite(step)) || !(count <= mostSteps))
  {
    return Sentence("Step is ", this->Step, " minutes: it must be above 0, and there may be at most ", mostSteps,
      " steps from Start to End.");
  }
  for (int k = 0; k < static_cast<int>(count); ++k)
  {
    steps.push_back(k * step);
  }
  steps.push_back(duration);
  return fault;
}

std::string vtkSunPath::CheckParameters() const
{
  const auto within = [](const char* name, double value, double least, double most) {
    return ParameterRange{ name, value, value >= least && value <= most, Sentence("in ", least, "..", most) };
  };
  std::string fault = FirstOutOfRange({ within("Latitude", this->Latitude, -90.0, 90.0),
    within("Longitude", this->Longitude, -360.0, 360.0), within("AngularDiameter", this->AngularDiameter, 0.0, 180.0),
    InRange("NumberOfWavelengths", this->NumberOfWavelengths, 1, 1000) });
  if (!fault.empty())
  {
    return fault;
  }
  const Horizon horizon = HorizonOf(this->Up, this->North);
  const bool isThere =
    IsFinite(horizon.Up) && IsFinite(horizon.North) && Length(horizon.North) > 0.0 && Length(horizon.Up) > 0.0;
  return isThere ? std::string()
                 : Sentence("Up is (", Listed(this->Up, 3), ") and North is (", Listed(this->North, 3),
                     "): both must be finite and longer than 0, and North must not lie along Up.");
}

int vtkSunPath::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  // Every piece needs the whole path.
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  info->Remove(Pipeline::TIME_STEPS());
  info->Remove(Pipeline::TIME_RANGE());
  double start = 0.0;
  std::vector<double> steps;
  if (this->ReadTimes(start, steps).empty()) // what is wrong is said by RequestData
  {
    const double range[2] = { 0.0, steps.back() };
    info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

SunPath vtkSunPath::MakePath(double start, const std::vector<double>& steps, double now) const
{
  const GeographicPlace place{ vtkMath::RadiansFromDegrees(this->Latitude),
    vtkMath::RadiansFromDegrees(this->Longitude) };
  const SunPositions positions(place, start, start + steps.back());
  const Horizon horizon = HorizonOf(this->Up, this->North);
  const auto at = [&](double time)
  {
    SunMoment moment;
    moment.Time = time;
    moment.Position = positions.At(start + time);
    moment.Position.Altitude += this->Refraction ? shadowcones::Refraction(moment.Position.Altitude) : 0.0;
    moment.Direction = DirectionTo(moment.Position, horizon);
    return moment;
  };
  SunPath path;
  path.Up = horizon.Up;
  path.AngularRadius = vtkMath::RadiansFromDegrees(0.5 * this->AngularDiameter);
  path.Now = at(std::min(std::max(0.0, now), steps.back()));
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    path.Times.push_back(at(steps[k]));
    if (k > 0)
    {
      path.Steps.push_back(at(0.5 * (steps[k - 1] + steps[k])));
      path.Lengths.push_back(steps[k] - steps[k - 1]);
    }
  }
  return path;
}

bool vtkSunPath::MakeLight(const SunPath& path, Light& light, std::string& error) const
{
  light.Shape = LightShape::Sun;
  light.Normal = -path.Now.Direction;
  light.Radius = path.AngularRadius;
  if (!ReadSpectrum(
        "Radiance", this->RadianceSpectrum, this->Radiance, this->NumberOfWavelengths, light.Spectrum, error))
  {
    return false;
  }
  const char* const fault = PrepareLight(light);
  error = fault ? fault : "";
  return !fault;
}

int vtkSunPath::RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const FilterRun run(this, request, inputs, outputs);
  vtkInformation* info = outputs->GetInformationObject(0);
  double start = 0.0;
  std::vector<double> steps;
  std::string error = this->CheckParameters();
  error = error.empty() ? this->ReadTimes(start, steps) : error;
  if (!error.empty())
  {
    return run.Fail(error);
  }
  const double now = info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  const SunPath path = this->MakePath(start, steps, now);
  Light light;
  if (!this->MakeLight(path, light, error))
  {
    return run.Fail(error);
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (path.Now.Position.Altitude > 0.0)
  {
    WriteSun(light, output);
    AddDoubleArray(output->GetFieldData(), "LightWavelengths", 1, DefaultWavelengths(this->NumberOfWavelengths));
  }
  WriteSunPath(path, output->GetFieldData());
  return 1;
}

void vtkSunPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "End: " << this->End << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "Up: " << Listed(this->Up, 3) << "\n";
  os << indent << "North: " << Listed(this->North, 3) << "\n";
  os << indent << "Refraction: " << (this->Refraction ? "on" : "off") << "\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
  os << indent << "NumberOfWavelengths: " << this->NumberOfWavelengths << "\n";
  os << indent << "Radiance: " << this->Radiance << "\n";
  os << indent << "RadianceSpectrum: " << TextOf(this->RadianceSpectrum) << "\n";
}
