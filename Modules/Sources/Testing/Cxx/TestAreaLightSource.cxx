// SPDX-License-Identifier: BSD-3-Clause
// vtkAreaLightSource, and lights read back from poly data: exact shapes, meshes, and a sentence for each fault.
#include "scLightData.h"
#include "vtkAreaLightSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
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

namespace
{

// Run the source and return what it reports; empty where it is content.
std::string UpdateErrors(vtkAreaLightSource* source)
{
  std::string text;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&text);
  observer->SetCallback([](vtkObject*, unsigned long, void* client, void* message) {
    *static_cast<std::string*>(client) += static_cast<const char*>(message);
  });
  const unsigned long a = source->AddObserver(vtkCommand::ErrorEvent, observer);
  const unsigned long b = source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  source->Update();
  source->RemoveObserver(a);
  source->GetExecutive()->RemoveObserver(b);
  return text;
}

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

vtkNew<vtkPolyData> Polygon(std::initializer_list<Vector3> corners)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<int>(corners.size()));
  for (const Vector3& c : corners)
  {
    polygons->InsertCellPoint(points->InsertNextPoint(c.X, c.Y, c.Z));
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

std::string ReadError(vtkPolyData* data)
{
  Light light;
  std::string error;
  EXPECT_FALSE(ReadLight(data, light, error));
  return error;
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
    ASSERT_EQ(UpdateErrors(source), "");
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
    ASSERT_EQ(UpdateErrors(source), "");
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
    const std::string text = UpdateErrors(source);
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
  expect(fault([](vtkAreaLightSource* s) { s->SetRadianceSpectrum(7, 1.0); }), "indices run from 0 to 6");
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
  for (const char* name : { "Shape: 0", "Center: 0 0 0", "Normal: 0 0 1", "Radius: 0.5", "Width: 1", "Height: 1",
         "Up: 0 1 0", "AngularDiameter: 0.533", "Radiance: 1", "RadianceSpectrum: [4] 8.5", "NumberOfWavelengths: 7",
         "Resolution: 32" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

//------------------------------------------------------------------------------
TEST(LightData, AnyMeshIsALight)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->Update();
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(sphere->GetOutputPort());
  const Light light = ReadBack(sphere->GetOutput());
  EXPECT_EQ(light.Shape, LightShape::Mesh);
  EXPECT_EQ(light.Spectrum, std::vector<double>(7, 1.0));
  EXPECT_NEAR(LightArea(light) / properties->GetSurfaceArea(), 1.0, 1e-6);
}

TEST(LightData, StripsEmitOnTheSideOfTheirPolygons)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(5, 3);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangles->GetOutputPort());
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  const Light light = ReadBack(stripper->GetOutput());
  EXPECT_EQ(light.Triangles.size(), 30u);
  EXPECT_NEAR(LightArea(light), 1.0, 1e-6);
  for (const auto& t : light.Triangles)
  {
    EXPECT_GT(Cross(t[1] - t[0], t[2] - t[0]).Z, 0.0);
  }
}

TEST(LightData, ConcavePolygonsKeepTheirArea)
{
  const auto data = Polygon({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 }, { 0, 4, 0 } });
  const Light light = ReadBack(data);
  EXPECT_NEAR(LightArea(light), 10.0, 1e-12);
  for (const auto& t : light.Triangles)
  {
    EXPECT_GT(Cross(t[1] - t[0], t[2] - t[0]).Z, 0.0);
  }
}

TEST(LightData, VerticesArePointLights)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(2.0, 0.0, 0.0);
  points->InsertNextPoint(3.0, 0.0, 0.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 1, 2 });
  data->SetPoints(points);
  data->SetVerts(vertices);
  vtkNew<vtkDoubleArray> spectrum;
  spectrum->SetName("LightSpectrum");
  spectrum->InsertNextValue(3.0);
  data->GetFieldData()->AddArray(spectrum);
  const Light light = ReadBack(data);
  ASSERT_EQ(light.Vertices.size(), 3u);
  EXPECT_EQ(light.Vertices[2].X, 3.0);
  EXPECT_EQ(light.Spectrum, std::vector<double>{ 3.0 });
}

TEST(LightData, EachFaultHasItsSentence)
{
  const auto expect = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in: " << text;
  };
  expect(ReadError(nullptr), "There is no light");
  vtkNew<vtkPolyData> empty;
  expect(ReadError(empty), "neither polygons nor vertices");
  expect(ReadError(Polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } })), "zero area");
  expect(ReadError(Polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } })), "zero area");
  expect(ReadError(Polygon({ { 0, 0, 0 }, { 1, vtkMath::Nan(), 0 }, { 2, 0, 0 } })),
    "Point 1 of the light is not finite");

  vtkNew<vtkAreaLightSource> source;
  source->SetShapeToRectangle();
  source->Update();
  for (const char* name : { "LightCenter", "LightNormal", "LightAxes", "LightSpectrum" })
  {
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(source->GetOutput());
    copy->GetFieldData()->RemoveArray(name);
    expect(ReadError(copy), ("\"" + std::string(name) + "\" is missing").c_str());
    vtkNew<vtkDoubleArray> wrong;
    wrong->SetName(name);
    copy->GetFieldData()->AddArray(wrong);
    expect(ReadError(copy), std::string(name) == "LightSpectrum" ? "\" is empty" : "\" has 0 values; it must have");
  }
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(source->GetOutput());
  vtkNew<vtkIntArray> shape;
  shape->SetName("LightShape");
  shape->InsertNextValue(6);
  copy->GetFieldData()->AddArray(shape);
  expect(ReadError(copy), "\"LightShape\" must be from 0 to 5");

  source->SetShapeToDisc();
  source->Update();
  copy->DeepCopy(source->GetOutput());
  copy->GetFieldData()->RemoveArray("LightRadius");
  expect(ReadError(copy), "\"LightRadius\" is missing");
  copy->DeepCopy(source->GetOutput());
  copy->GetFieldData()->GetArray("LightRadius")->SetComponent(0, 0, -1.0);
  expect(ReadError(copy), "radius must be finite and larger than 0");
  copy->DeepCopy(source->GetOutput());
  copy->GetFieldData()->GetArray("LightSpectrum")->SetComponent(3, 0, vtkMath::Nan());
  expect(ReadError(copy), "spectrum has a value that is not finite");
}

TEST(LightData, ReadingDoesNotAlterTheInput)
{
  const auto data = Polygon({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 }, { 0, 4, 0 } });
  const vtkMTimeType before = data->GetMTime();
  ReadBack(data);
  EXPECT_EQ(data->GetMTime(), before);
  EXPECT_EQ(data->GetFieldData()->GetNumberOfArrays(), 0);
}
