// SPDX-License-Identifier: BSD-3-Clause
// Lights read from poly data: meshes, vertices, and a sentence for each fault.
#include "scLightData.h"

#include "vtkAreaLightSource.h"
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
#include <string>

using namespace shadowcones;

namespace
{

Light ReadBack(vtkPolyData* data)
{
  Light light;
  std::string error;
  EXPECT_TRUE(ReadLight(data, light, error)) << error;
  return light;
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
  const auto expect = [](const std::string& text, const char* part)
  { EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in: " << text; };
  expect(ReadError(nullptr), "There is no light");
  vtkNew<vtkPolyData> empty;
  expect(ReadError(empty), "neither polygons nor vertices");
  expect(ReadError(Polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } })), "zero area");
  expect(ReadError(Polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } })), "zero area");
  expect(
    ReadError(Polygon({ { 0, 0, 0 }, { 1, vtkMath::Nan(), 0 }, { 2, 0, 0 } })), "Point 1 of the light is not finite");

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
  expect(ReadError(copy), "\"LightShape\" must be a whole number from 0 to 5");
  vtkNew<vtkDoubleArray> half;
  half->SetName("LightShape");
  half->InsertNextValue(1.5);
  copy->GetFieldData()->AddArray(half);
  expect(ReadError(copy), "\"LightShape\" must be a whole number from 0 to 5");

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
