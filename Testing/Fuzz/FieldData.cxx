// SPDX-License-Identifier: BSD-3-Clause
// Field data of strangers: given to everything that reads them.
#include "Bytes.h"
#include "Harnesses.h"

#include "scConeData.h"
#include "scFingerprints.h"
#include "scLightData.h"
#include "scSunData.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPolyData.h"

namespace fuzz
{
namespace
{

using namespace shadowcones;

void FieldData(const std::uint8_t* raw, std::size_t count)
{
  Bytes bytes(raw, count);
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkFieldData> data;
  std::string error;
  const int kind = bytes.Below(4);
  if (kind == 0)
  {
    AddArrays(bytes, LightPlans(), 1 + bytes.Below(3), data);
    std::vector<Light> lights;
    const bool read = ReadLightShapes(data, lights, error);
    Check(read || !error.empty(), "a fault of a light has a sentence");
    ReadLightFingerprints(data);
    CompareFingerprints(lightFingerprint, data, { 1, 2 }, "The cone set on input port 1", "lights");
  }
  else if (kind == 1)
  {
    AddArrays(bytes,
      { { "SunStepTime", VTK_DOUBLE, 1, Values::Positive }, { "SunStepLength", VTK_DOUBLE, 1, Values::Positive },
        { "SunStepDirection", VTK_DOUBLE, 3, Values::Unit }, { "SunStepAltitude", VTK_DOUBLE, 1, Values::Any } },
      bytes.Below(6), data);
    AddArrays(bytes, { { "SunAngularDiameter", VTK_DOUBLE, 1, Values::Fraction }, { "SunUp", VTK_DOUBLE, 3, Values::Unit },
        { "SunAltitude", VTK_DOUBLE, 1, Values::Any } }, 1, data);
    SunCourse course;
    const bool read = ReadSunPath(data, 0.0, course, error);
    Check(read || !error.empty(), "a fault of a path has a sentence");
    for (const SunStep& step : course.Steps)
    {
      Check(!read || std::isfinite(step.Direction.X + step.Direction.Y + step.Direction.Z), "the Sun stands somewhere");
    }
    AltitudeBelowHorizon(data);
  }
  else if (kind == 2)
  {
    AddArrays(bytes, { { "Certified", VTK_INT, 1, Values::Flag }, { "CertifiedBounds", VTK_DOUBLE, 6, Values::Any },
        { "CertificateHash", VTK_UNSIGNED_LONG_LONG, 1, Values::Any }, { "CosineCorrection", VTK_INT, 1, Values::Flag } },
      1, data);
    std::vector<Cone> cones(1);
    ReadCertifiedBounds(data);
    ReadConeCertificate(data, cones, {}, {}, error);
    UndoCosineCorrection(data, cones);
  }
  else
  {
    AddArrays(bytes, { { "CastersFingerprint", VTK_UNSIGNED_LONG_LONG, 1, Values::Any },
        { "LightWavelengths", VTK_DOUBLE, 1, Values::Positive } }, bytes.Below(4), data);
    ReadFingerprints(castersFingerprint, data);
    vtkNew<vtkPolyData> owner;
    owner->SetFieldData(data);
    std::vector<double> wavelengths;
    const bool read = ReadWavelengths(owner, static_cast<std::size_t>(1 + bytes.Below(4)), wavelengths, error);
    Check(read || !error.empty(), "a fault of wavelengths has a sentence");
    for (const double length : wavelengths)
    {
      Check(!read || (std::isfinite(length) && length > 0.0), "wavelengths are finite and above 0");
    }
  }
}

const Entry entry("field-data", FieldData);

} // namespace
} // namespace fuzz
