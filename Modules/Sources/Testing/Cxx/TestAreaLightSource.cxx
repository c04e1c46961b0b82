// SPDX-License-Identifier: BSD-3-Clause
// vtkAreaLightSource: exact shapes read back, the mesh that shows them, and a sentence for each fault.
#include "scLightData.h"
#include "vtkAreaLightSource.h"

#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{

Light ReadBack(vtkPolyData* data)
{
  Light light;
  std::string error;
  EXPECT_TRUE(ReadLight(data, light, error)) << error;
  return light;
}

void ExpectSame(const Vector3& a, const Vector3& b)
{
  EXPECT_NEAR(Length(a - b), 0.0, 1e-15);
}

// Area of the polygons times their mean normal.
Vector3 VectorArea(vtkPolyData* data)
{
  vtkNew<vtkPolyData> copy;
  copy->SetPoints(data->GetPoints());
  copy->SetPolys(data->GetPolys());
  Vector3 sum;
  for (const auto& t : ReadBack(copy).Triangles)
  {
    sum += 0.5 * Cross(t[1] - t[0], t[2] - t[0]);
  }
  return sum;
}

} // namespace

//------------------------------------------------------------------------------
TEST(AreaLightSource, EachShapeComesBackExactly)
{
  for (int shape = vtkAreaLightSource::Disc; shape <= vtkAreaLightSource::Sun; ++shape)
  {
    SCOPED_TRACE(shape);
    vtkNew<vtkAreaLightSource> source;
    source->SetShape(shape);
    source->SetCenter(1.0, 2.0, 3.0);
    source->SetNormal(0.0, -3.0, 4.0);
    source->SetRadius(0.25);
    source->SetWidth(3.0);
    source->SetHeight(2.0);
    source->SetRadiance(5.0);
    source->SetRadianceSpectrum(2, 7.0);
    ASSERT_EQ(ErrorsOf(source), "");
    const Light light = ReadBack(source->GetOutput());
    EXPECT_EQ(static_cast<int>(light.Shape), shape);
    EXPECT_EQ(light.Spectrum, (std::vector<double>{ 5.0, 5.0, 7.0, 5.0, 5.0, 5.0, 5.0 }));
    if (shape != vtkAreaLightSource::Sun)
    {
      ExpectSame(light.Center, { 1.0, 2.0, 3.0 });
    }
    if (shape != vtkAreaLightSource::Sphere && shape != vtkAreaLightSource::Point)
    {
      ExpectSame(light.Normal, { 0.0, -0.6, 0.8 });
    }
    if (shape == vtkAreaLightSource::Disc || shape == vtkAreaLightSource::Sphere)
    {
      EXPECT_EQ(light.Radius, 0.25);
    }
    if (shape == vtkAreaLightSource::Rectangle)
    {
      EXPECT_NEAR(Length(light.AxisU), 1.5, 1e-15);
      ExpectSame(light.AxisV, { 0.0, 0.8, 0.6 });
      ExpectSame(Normalized(Cross(light.AxisU, light.AxisV)), light.Normal);
    }
    if (shape == vtkAreaLightSource::Sun)
    {
      EXPECT_NEAR(light.Radius, 0.5 * 0.533 * vtkMath::Pi() / 180.0, 1e-15);
    }
  }
}

TEST(AreaLightSource, WriteAndReadAgreeInEveryMember)
{
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = { -1.0, 0.1, 1e6 };
  light.Normal = { 0.0, 0.0, -1.0 };
  light.AxisU = { 2.0, 0.0, 0.0 };
  light.AxisV = { 0.0, 3.0, 0.0 };
  light.Spectrum = { 1.0, 0.0, 2.5 };
  vtkNew<vtkPolyData> data;
  WriteLightFieldData(light, data);
  const Light back = ReadBack(data);
  EXPECT_EQ(back.Shape, light.Shape);
  ExpectSame(back.Center, light.Center);
  ExpectSame(back.Normal, light.Normal); // U x V is the other way: the normal decides
  ExpectSame(back.AxisU, light.AxisU);
  ExpectSame(back.AxisV, light.AxisV);
  EXPECT_EQ(back.Spectrum, light.Spectrum);
}

TEST(AreaLightSource, TheMeshShowsTheLight)
{
  vtkNew<vtkAreaLightSource> source;
  source->SetCenter(1.0, 2.0, 3.0);
  source->SetNormal(1.0, -2.0, 0.5);
  source->SetResolution(256);
  const Vector3 normal = Normalized({ 1.0, -2.0, 0.5 });
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 1);
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(Dot(VectorArea(source->GetOutput()), normal), 0.25 * vtkMath::Pi(), 1e-4);
  source->SetShapeToRectangle();
  source->SetWidth(2.0);
  source->Update();
  EXPECT_NEAR(Dot(VectorArea(source->GetOutput()), normal), 2.0, 1e-14);

  source->SetShapeToSphere();
  for (const int resolution : { 3, 4, 5, 256 })
  {
    source->SetResolution(resolution);
    source->Update();
    // Closed: no vector area; oriented outward: a positive volume.
    EXPECT_NEAR(Length(VectorArea(source->GetOutput())), 0.0, 1e-12);
    double volume = 0.0;
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(source->GetOutput()->GetPoints());
    mesh->SetPolys(source->GetOutput()->GetPolys());
    for (const auto& t : ReadBack(mesh).Triangles)
    {
      volume += Dot(t[0] - Vector3{ 1.0, 2.0, 3.0 }, Cross(t[1] - t[0], t[2] - t[0])) / 6.0;
    }
    EXPECT_GT(volume, 0.0);
    if (resolution == 256)
    {
      EXPECT_NEAR(volume / (4.0 / 3.0 * vtkMath::Pi() * 0.125), 1.0, 1e-3);
    }
  }
  source->SetShapeToPoint();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfVerts(), 1);
  EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 1);
  source->SetShapeToSun();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfVerts(), 1);
}

TEST(AreaLightSource, ResolutionDoesNotChangeTheLight)
{
  vtkNew<vtkAreaLightSource> source;
  source->SetResolution(3);
  source->Update();
  EXPECT_DOUBLE_EQ(LightArea(ReadBack(source->GetOutput())), 0.25 * vtkMath::Pi());
}

TEST(AreaLightSource, UpMayBeParallelToNormal)
{
  vtkNew<vtkAreaLightSource> source;
  source->SetShapeToRectangle();
  for (const Vector3& up : { Vector3{ 0.0, -1.0, 0.0 }, Vector3{ 0.0, 0.0, 0.0 }, Vector3{ 1e-9, 2.0, 0.0 } })
  {
    source->SetNormal(0.0, 5.0, 0.0);
    source->SetUp(up.X, up.Y, up.Z);
    ASSERT_EQ(ErrorsOf(source), "");
    EXPECT_NEAR(LightArea(ReadBack(source->GetOutput())), 1.0, 1e-14);
  }
}

TEST(AreaLightSource, SpectrumAndWavelengths)
{
  vtkNew<vtkAreaLightSource> source;
  source->SetNumberOfWavelengths(3);
  source->SetRadianceSpectrum(1, 4.0);
  EXPECT_EQ(source->GetRadianceSpectrum(0), 1.0);
  EXPECT_EQ(source->GetRadianceSpectrum(1), 4.0);
  source->Update();
  vtkDataArray* wavelengths = source->GetOutput()->GetFieldData()->GetArray("LightWavelengths");
  ASSERT_NE(wavelengths, nullptr);
  ASSERT_EQ(wavelengths->GetNumberOfTuples(), 3);
  EXPECT_NEAR(wavelengths->GetComponent(0, 0), 450.0, 1e-12);
  EXPECT_NEAR(wavelengths->GetComponent(2, 0), 650.0, 1e-12);
  source->SetRadiance(2.0);
  EXPECT_EQ(source->GetRadianceSpectrum(1), 2.0);
  source->Update();
  EXPECT_EQ(ReadBack(source->GetOutput()).Spectrum, (std::vector<double>{ 2.0, 2.0, 2.0 }));

  vtkNew<vtkDoubleArray> radiances;
  radiances->InsertNextValue(5.0);
  radiances->InsertNextValue(6.0);
  source->SetRadianceSpectrum(2, 9.0);
  source->SetRadianceSpectrum(radiances);
  source->Update();
  EXPECT_EQ(ReadBack(source->GetOutput()).Spectrum, (std::vector<double>{ 5.0, 6.0, 2.0 }));
  source->ClearRadianceSpectrum();
  source->Update();
  EXPECT_EQ(ReadBack(source->GetOutput()).Spectrum, (std::vector<double>{ 2.0, 2.0, 2.0 }));
}

TEST(AreaLightSource, EachPieceHoldsTheWholeLight)
{
  vtkNew<vtkAreaLightSource> source;
  source->UpdatePiece(3, 4, 0);
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 1);
  EXPECT_NE(source->GetOutput()->GetFieldData()->GetArray("LightShape"), nullptr);
}

TEST(AreaLightSource, EachBadParameterHasItsSentence)
{
  const double nan = vtkMath::Nan();
  const auto fault = [](void (*change)(vtkAreaLightSource*)) {
    vtkNew<vtkAreaLightSource> source;
    source->Update();
    change(source);
    const std::string text = ErrorsOf(source);
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(source->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
    return text;
  };
  const auto expect = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in: " << text;
  };
  static double notANumber = nan;
  expect(fault([](vtkAreaLightSource* s) { s->SetRadius(0.0); }), "radius must be finite and larger than 0");
  expect(fault([](vtkAreaLightSource* s) { s->SetRadius(notANumber); }), "radius must be finite");
  expect(fault([](vtkAreaLightSource* s) { s->SetNormal(0.0, 0.0, 0.0); }), "normal must be finite and longer than 0");
  expect(fault([](vtkAreaLightSource* s) { s->SetNormal(0.0, notANumber, 0.0); }), "normal must be finite");
  expect(fault([](vtkAreaLightSource* s) { s->SetCenter(0.0, notANumber, 0.0); }), "Center must be finite");
  expect(fault([](vtkAreaLightSource* s) { s->SetRadiance(-1.0); }), "spectrum has a negative value");
  expect(fault([](vtkAreaLightSource* s) { s->SetRadianceSpectrum(3, notANumber); }), "spectrum has a value that");
  expect(fault([](vtkAreaLightSource* s) { s->SetRadianceSpectrum(7, 1.0); }), "wavelength sample 7: the light has 7, which count from 0.");
  expect(fault([](vtkAreaLightSource* s) { s->SetRadianceSpectrum(-1, 1.0); }), "wavelength sample -1");
  expect(fault([](vtkAreaLightSource* s) { s->SetNumberOfWavelengths(0); }), "NumberOfWavelengths is 0");
  expect(fault([](vtkAreaLightSource* s) { s->SetResolution(2); }), "Resolution is 2");
  expect(fault([](vtkAreaLightSource* s) { s->SetShape(9); }), "Shape is 9");
  expect(fault([](vtkAreaLightSource* s) {
    s->SetShapeToRectangle();
    s->SetWidth(0.0);
  }),
    "Width and Height must be finite and larger than 0");
  expect(fault([](vtkAreaLightSource* s) {
    s->SetShapeToRectangle();
    s->SetUp(0.0, notANumber, 0.0);
  }),
    "Up must be finite");
  expect(fault([](vtkAreaLightSource* s) {
    s->SetShapeToSun();
    s->SetAngularDiameter(200.0);
  }),
    "angular diameter must be from 0 to 180 degrees");
}

TEST(AreaLightSource, PrintSelfNamesEveryParameter)
{
  vtkNew<vtkAreaLightSource> source;
  source->SetRadianceSpectrum(4, 8.5);
  std::ostringstream text;
  source->Print(text);
  for (const char* name : { "Shape: 0", "Center: 0, 0, 0", "Normal: 0, 0, 1", "Radius: 0.5", "Width: 1", "Height: 1",
         "Up: 0, 1, 0", "AngularDiameter: 0.533", "Radiance: 1", "RadianceSpectrum: [4] 8.5", "NumberOfWavelengths: 7",
         "Resolution: 32" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}
