// SPDX-License-Identifier: BSD-3-Clause
// vtkSunPath: the light at each time, the whole path, night, and a sentence for each fault.
#include "vtkSunPath.h"

#include "MeeusSun.h"
#include "Messages.h"
#include "scCivilTime.h"
#include "scLightData.h"
#include "vtkAreaLightSource.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace testsupport;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{

double Field(vtkSunPath* path, const char* name, vtkIdType tuple = 0, int component = 0)
{
  vtkDataArray* array = path->GetOutput()->GetFieldData()->GetArray(name);
  EXPECT_TRUE(array && tuple < array->GetNumberOfTuples()) << name;
  return array && tuple < array->GetNumberOfTuples() ? array->GetComponent(tuple, component) : -1e300;
}

vtkIdType Count(vtkSunPath* path, const char* name)
{
  vtkDataArray* array = path->GetOutput()->GetFieldData()->GetArray(name);
  return array ? array->GetNumberOfTuples() : -1;
}

/// A day in June at a place in the Alps.
vtkSmartPointer<vtkSunPath> Day()
{
  auto path = vtkSmartPointer<vtkSunPath>::New();
  path->SetLatitude(47.0);
  path->SetLongitude(11.0);
  path->SetStart("2024-06-21");
  path->SetEnd("2024-06-22");
  path->SetStep(30.0);
  return path;
}

} // namespace

TEST(SunPath, TheExampleOfTheSolarPositionAlgorithm)
{
  // See TestSunPositions.cxx.
  vtkNew<vtkSunPath> path;
  path->SetLatitude(39.742476);
  path->SetLongitude(-105.1786);
  path->SetStart("2003-10-17T00:00:00-07:00");
  path->SetEnd("2003-10-18T00:00:00-07:00");
  path->UpdateTimeStep(12.0 * 3600.0 + 30.0 * 60.0 + 30.0);
  EXPECT_NEAR(Field(path, "SunAltitude"), 39.872046, 0.005);
  EXPECT_NEAR(Field(path, "SunAzimuth"), 194.340241, 0.005);
  path->RefractionOn();
  path->UpdateTimeStep(12.0 * 3600.0 + 30.0 * 60.0 + 30.0);
  EXPECT_NEAR(Field(path, "SunAltitude"), 39.888378, 0.01);
}

TEST(SunPath, ItsLightIsASunOfTheAreaLight)
{
  const auto path = Day();
  path->SetAngularDiameter(0.7);
  path->SetRadiance(3.0);
  path->SetNumberOfWavelengths(4);
  path->SetRadianceSpectrum(2, 9.0);
  path->UpdateTimeStep(10.0 * 3600.0);
  vtkPolyData* made = path->GetOutput();
  Light light;
  std::string error;
  ASSERT_TRUE(ReadLight(made, light, error)) << error;
  EXPECT_EQ(light.Shape, LightShape::Sun);
  EXPECT_EQ(light.Spectrum, (std::vector<double>{ 3.0, 3.0, 9.0, 3.0 }));

  vtkNew<vtkAreaLightSource> usual;
  usual->SetShapeToSun();
  usual->SetNormal(light.Normal.X, light.Normal.Y, light.Normal.Z);
  usual->SetAngularDiameter(0.7);
  usual->SetNumberOfWavelengths(4);
  usual->SetRadiance(3.0);
  usual->SetRadianceSpectrum(2, 9.0);
  usual->Update();
  EXPECT_EQ(made->GetNumberOfVerts(), 1);
  EXPECT_EQ(made->GetPointData()->GetNormals()->GetNumberOfTuples(), 1);
  vtkFieldData* expected = usual->GetOutput()->GetFieldData();
  for (int k = 0; k < expected->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* one = expected->GetArray(k);
    vtkDataArray* other = made->GetFieldData()->GetArray(one->GetName());
    ASSERT_NE(other, nullptr) << one->GetName();
    EXPECT_EQ(one->GetDataType(), other->GetDataType()) << one->GetName();
    ASSERT_EQ(one->GetNumberOfTuples(), other->GetNumberOfTuples()) << one->GetName();
    ASSERT_EQ(one->GetNumberOfComponents(), other->GetNumberOfComponents()) << one->GetName();
    for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < one->GetNumberOfComponents(); ++c)
      {
        EXPECT_NEAR(one->GetComponent(i, c), other->GetComponent(i, c), 1e-15) << one->GetName();
      }
    }
  }
}

TEST(SunPath, TimesCountInSecondsFromTheStart)
{
  const auto path = Day();
  path->SetEnd("2024-06-21T01:10:00Z");
  path->UpdateInformation();
  vtkInformation* info = path->GetOutputInformation(0);
  ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), 4);
  const double steps[4] = { 0.0, 1800.0, 3600.0, 4200.0 };
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(info->Get(Pipeline::TIME_STEPS(), k), steps[k]);
  }
  EXPECT_EQ(info->Get(Pipeline::TIME_RANGE(), 0), 0.0);
  EXPECT_EQ(info->Get(Pipeline::TIME_RANGE(), 1), 4200.0);
  path->Update();
  EXPECT_EQ(Count(path, "SunPathTime"), 4);
  EXPECT_EQ(Count(path, "SunStepTime"), 3);
  EXPECT_EQ(Field(path, "SunPathTime", 3), 4200.0);
  EXPECT_EQ(Field(path, "SunStepTime", 2), 3900.0);
  EXPECT_EQ(Field(path, "SunStepLength", 2), 600.0);
  EXPECT_EQ(Field(path, "SunStepLength", 0), 1800.0);
  // The end may be the start.
  path->SetEnd("2024-06-21T00:00:00Z");
  EXPECT_EQ(ErrorsOf(path), "");
  EXPECT_EQ(Count(path, "SunPathTime"), 1);
  EXPECT_EQ(Count(path, "SunStepTime"), 0);
}

TEST(SunPath, TheWholePathStandsInFieldData)
{
  const auto path = Day();
  double start = 0.0;
  ASSERT_TRUE(ReadCivilTime("2024-06-21", start));
  path->UpdateTimeStep(36000.0);
  ASSERT_EQ(Count(path, "SunPathDirection"), 49);
  ASSERT_EQ(Count(path, "SunStepDirection"), 48);
  for (const char* kind : { "SunPath", "SunStep" })
  {
    const auto name = [kind](const char* what) { return std::string(kind) + what; };
    for (vtkIdType k = 0; k < 48; k += 5)
    {
      const double time = Field(path, name("Time").c_str(), k);
      const MeeusPosition sun = MeeusSun(start + time, 47.0, 11.0);
      EXPECT_NEAR(Field(path, name("Altitude").c_str(), k), sun.Altitude, 0.012);
      EXPECT_NEAR(Field(path, name("Azimuth").c_str(), k), sun.Azimuth, 0.03);
      const Vector3 direction = MeeusDirection(start + time, 47.0, 11.0);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(Field(path, name("Direction").c_str(), k, c), direction[c], 2.5e-4);
      }
    }
  }
  // At 10 h the light is that of the 21st step, and at any time between two its own.
  EXPECT_EQ(Field(path, "SunAltitude"), Field(path, "SunPathAltitude", 20));
  EXPECT_EQ(Field(path, "LightNormal", 0, 2), -Field(path, "SunPathDirection", 20, 2));
  path->UpdateTimeStep(36900.0);
  EXPECT_EQ(Field(path, "SunAltitude"), Field(path, "SunStepAltitude", 20));
  EXPECT_EQ(path->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 36900.0);
  path->UpdateTimeStep(1e9); // the nearest there is
  EXPECT_EQ(Field(path, "SunAltitude"), Field(path, "SunPathAltitude", 48));
}

TEST(SunPath, BelowTheHorizonThereIsNoLight)
{
  const auto path = Day(); // at 0 h the Sun is down
  path->Update();
  EXPECT_LT(Field(path, "SunAltitude"), -15.0);
  EXPECT_EQ(path->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(path->GetOutput()->GetFieldData()->GetArray("LightShape"), nullptr);
  EXPECT_EQ(Count(path, "SunPathDirection"), 49);
  Light light;
  std::string error;
  EXPECT_FALSE(ReadLight(path->GetOutput(), light, error));
  EXPECT_SAYS(error, "The Sun is below the horizon, at an altitude of -18.9");
  EXPECT_SAYS(error, " degrees: there is no light at this time. Ask for another time of the vtkSunPath.");
}

TEST(SunPath, PolesAndMidnightSun)
{
  const auto path = Day();
  for (const double latitude : { 90.0, 71.17, -90.0 })
  {
    path->SetLatitude(latitude);
    path->Update();
    int up = 0;
    for (vtkIdType k = 0; k < 49; ++k)
    {
      up += Field(path, "SunPathAltitude", k) > 0.0;
    }
    EXPECT_EQ(up, latitude > 0.0 ? 49 : 0) << latitude;
  }
  // At a pole the Sun goes round at one height; at longitude 11 it stands south at about 12 h - 44 min + the equation of time.
  path->SetLatitude(90.0);
  path->UpdateTimeStep(11.0 * 3600.0 + 18.0 * 60.0);
  EXPECT_NEAR(Field(path, "SunAzimuth"), 180.0, 0.2);
  EXPECT_NEAR(Field(path, "SunAltitude"), 23.436, 0.006);
}

TEST(SunPath, UpAndNorthTurnTheScene)
{
  const auto path = Day();
  path->UpdateTimeStep(36000.0);
  const double x = Field(path, "SunDirection", 0, 0);
  const double y = Field(path, "SunDirection", 0, 1);
  const double z = Field(path, "SunDirection", 0, 2);
  path->SetUp(0.0, 5.0, 0.0);
  path->SetNorth(0.0, 7.0, -2.0); // what is along Up does not count
  path->UpdateTimeStep(36000.0);
  EXPECT_NEAR(Field(path, "SunDirection", 0, 0), x, 1e-12);
  EXPECT_NEAR(Field(path, "SunDirection", 0, 1), z, 1e-12);
  EXPECT_NEAR(Field(path, "SunDirection", 0, 2), -y, 1e-12);
}

TEST(SunPath, FaultsAreSaid)
{
  struct Fault
  {
    std::function<void(vtkSunPath*)> Set;
    const char* Says;
  };
  const double nan = std::nan("");
  const std::vector<Fault> faults = {
    { [](vtkSunPath* p) { p->SetLatitude(90.5); }, "Latitude is 90.5: it must be in -90..90." },
    { [nan](vtkSunPath* p) { p->SetLatitude(nan); }, "Latitude is nan: it must be in -90..90." },
    { [](vtkSunPath* p) { p->SetLongitude(361.0); }, "Longitude is 361: it must be in -360..360." },
    { [](vtkSunPath* p) { p->SetStart("yesterday"); },
      "Start is \"yesterday\": it must be a date, or a date and time, such as 2024-06-21T12:00:00+02:00." },
    { [](vtkSunPath* p) { p->SetEnd(nullptr); }, "End is \"\": it must be a date" },
    { [](vtkSunPath* p) { p->SetStart("1899-12-31T23:59:59Z"); },
      "Start is in the year 1899: it must be in 1900..2099." },
    { [](vtkSunPath* p) { p->SetEnd("2100-01-01"); }, "End is in the year 2100: it must be in 1900..2099." },
    { [](vtkSunPath* p) { p->SetEnd("2024-06-20"); }, "End, 2024-06-20, is before Start, 2024-06-21." },
    { [](vtkSunPath* p) { p->SetStep(0.0); },
      "Step is 0 minutes: it must be above 0, and there may be at most 10000000 steps from Start to End." },
    { [](vtkSunPath* p) { p->SetStep(-5.0); }, "Step is -5 minutes" },
    { [nan](vtkSunPath* p) { p->SetStep(nan); }, "Step is nan minutes" },
    { [](vtkSunPath* p) { p->SetStep(1e-5); }, "Step is 1e-05 minutes" },
    { [](vtkSunPath* p) { p->SetUp(0.0, 0.0, 0.0); },
      "Up is (0, 0, 0) and North is (0, 1, 0): both must be finite and longer "
      "than 0, and North must not lie along Up." },
    { [](vtkSunPath* p) { p->SetNorth(0.0, 0.0, 2.0); }, "Up is (0, 0, 1) and North is (0, 0, 2): both" },
    { [nan](vtkSunPath* p) { p->SetNorth(0.0, nan, 2.0); }, "Up is (0, 0, 1) and North is (0, nan, 2): both" },
    { [](vtkSunPath* p) { p->SetAngularDiameter(181.0); }, "AngularDiameter is 181: it must be in 0..180." },
    { [](vtkSunPath* p) { p->SetNumberOfWavelengths(0); }, "NumberOfWavelengths is 0: it must be in 1..1000." },
    { [](vtkSunPath* p) { p->SetRadiance(-1.0); }, "The light's spectrum has a negative value." },
  };
  for (const Fault& fault : faults)
  {
    const auto path = Day();
    fault.Set(path);
    EXPECT_SAYS(ErrorsOf(path), fault.Says);
    EXPECT_EQ(path->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(path->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  }
}

TEST(SunPath, PrintsAllParameters)
{
  std::ostringstream text;
  Day()->Print(text);
  for (const char* name : { "Latitude: 47", "Longitude: 11", "Start: 2024-06-21", "End: 2024-06-22", "Step: 30",
         "Up: 0, 0, 1", "North: 0, 1, 0", "Refraction: off", "AngularDiameter: 0.533", "NumberOfWavelengths: 7",
         "Radiance: 1", "RadianceSpectrum: " })
  {
    EXPECT_SAYS(text.str(), name);
  }
}
