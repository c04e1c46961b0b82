// SPDX-License-Identifier: BSD-3-Clause
// Footprints against areas by hand and closed forms; their outlines, holes and names; the file for maps.
#include "Messages.h"
#include "TestPolyData.h"

#include "vtkShadowFootprintWriter.h"
#include "vtkShadowFootprints.h"

#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkRegularPolygonSource.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// The floor z = 0, one quadrilateral that faces up.
vtkSmartPointer<vtkPolyData> Floor(double half)
{
  return Plane({ -half, -half, 0.0 }, { 2.0 * half, 0.0, 0.0 }, { 0.0, 2.0 * half, 0.0 });
}

vtkSmartPointer<vtkAreaLightSource> Sun(double x, double y, double z, double diameter)
{
  auto sun = vtkSmartPointer<vtkAreaLightSource>::New();
  sun->SetShapeToSun();
  sun->SetNormal(x, y, z);
  sun->SetAngularDiameter(diameter);
  return sun;
}

vtkSmartPointer<vtkShadowFootprints> Footprints(vtkPolyData* floor, vtkAlgorithm* light, vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkShadowFootprints>::New();
  filter->SetInputData(floor);
  filter->SetLightConnection(light->GetOutputPort());
  filter->SetMeshData(mesh);
  return filter;
}

double ShapeArea(vtkPolyData* data, vtkIdList* ids)
{
  double sum = 0.0;
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    double a[3];
    double b[3];
    data->GetPoint(ids->GetId(k), a);
    data->GetPoint(ids->GetId((k + 1) % ids->GetNumberOfIds()), b);
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

double CellValue(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetComponent(cell, 0);
}

/// Of the outlines (port 0) or areas (port 1) of one class and occluder, seen from above; holes count below 0.
double AreaOf(vtkShadowFootprints* filter, int port, int shadowClass, int occluder = 0, int light = 0)
{
  vtkPolyData* data = filter->GetOutput(port);
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (CellValue(data, "ShadowClass", cell) == shadowClass && CellValue(data, "OccluderId", cell) == occluder &&
      CellValue(data, "LightId", cell) == light)
    {
      data->GetCellPoints(cell, ids);
      sum += ShapeArea(data, ids);
    }
  }
  return sum;
}

/// Every outline ends where it begins.
bool AreAllClosed(vtkPolyData* outlines)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < outlines->GetNumberOfCells(); ++cell)
  {
    outlines->GetCellPoints(cell, ids);
    if (ids->GetId(0) != ids->GetId(ids->GetNumberOfIds() - 1))
    {
      return false;
    }
  }
  return true;
}

vtkSmartPointer<vtkPolyData> DiscAt(double z, double radius, int sides = 256)
{
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetCenter(0.0, 0.0, z);
  disc->SetRadius(radius);
  disc->SetNumberOfSides(sides);
  disc->Update();
  return disc->GetOutput();
}

std::string ReadFile(const std::string& path)
{
  std::ifstream file(path);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}
} // anonymous namespace

TEST(ShadowFootprints, OfASquarePostUnderAHardSun)
{
  // A post of 0.4 x 0.4, 1 high, under a Sun at 45 degrees along x: its foot, and a strip of 0.4 x 1 behind it. Inside the post,
  // on its foot, all is dark too.
  MeshBuilder post;
  post.AddBox(0.0, 0.0, 0.5, 0.2, 0.2, 0.5, 0);
  const auto sun = Sun(1.0, 0.0, -1.0, 0.0);
  const auto filter = Footprints(Floor(2.0), sun, post.Build());
  filter->SetRefinements(4);
  EXPECT_EQ(ErrorsOf(filter), "");
  const double exact = 0.4 * 0.4 + 0.4 * 1.0;
  EXPECT_NEAR(AreaOf(filter, 0, 2) / exact, 1.0, 0.003);
  EXPECT_NEAR(AreaOf(filter, 1, 2), AreaOf(filter, 0, 2), 1e-9) << "areas fill their outlines";
  EXPECT_EQ(AreaOf(filter, 1, 1), 0.0) << "no penumbra";
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfLines(), 1);
  EXPECT_TRUE(AreAllClosed(filter->GetOutput(0)));
  double bounds[6];
  filter->GetOutput(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 1.2, 1e-3);
  EXPECT_NEAR(bounds[3], 0.2, 1e-3);
  ArrayOf(filter->GetOutput(0)->GetCellData(), "ShadowClass", VTK_UNSIGNED_CHAR, 1);
  ArrayOf(filter->GetOutput(1)->GetCellData(), "OccluderId", VTK_INT, 1);
}

TEST(ShadowFootprints, OfADiscUnderADiscLamp)
{
  // Lamp R = 0.3 at z = 4, disc r = 0.5 at z = 2: on the floor the umbra has the radius 0.7, the whole shadow 1.3.
  const auto lamp = LampAbove(4.0, 0.3);
  const auto filter = Footprints(Floor(1.5), lamp, DiscAt(2.0, 0.5));
  filter->SetSpacing(0.07);
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_NEAR(AreaOf(filter, 0, 2) / (pi * 0.49), 1.0, 0.003);
  EXPECT_NEAR(AreaOf(filter, 0, 1) / (pi * 1.69), 1.0, 0.003);
  EXPECT_NEAR(AreaOf(filter, 1, 2), AreaOf(filter, 0, 2), 1e-9);
  EXPECT_NEAR(AreaOf(filter, 1, 1), AreaOf(filter, 0, 1) - AreaOf(filter, 0, 2), 1e-9) << "penumbra without umbra";
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfLines(), 2);
}

TEST(ShadowFootprints, ARingHasAHoleAndOutlinesFollowBorders)
{
  // A frame of 1 x 1 with a window of 0.5 x 0.5, lit from straight above; the floor ends under its middle.
  MeshBuilder frame;
  const double at[4] = { -0.5, -0.25, 0.25, 0.5 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (i != 1 || j != 1)
      {
        const vtkIdType f = frame.AddPoint(at[i], at[j], 1.0);
        frame.AddPoint(at[i + 1], at[j], 1.0);
        frame.AddPoint(at[i + 1], at[j + 1], 1.0);
        frame.AddPoint(at[i], at[j + 1], 1.0);
        frame.AddQuad(f, f + 1, f + 2, f + 3, 0);
      }
    }
  }
  const auto sun = Sun(0.0, 0.0, -1.0, 0.0);
  const auto whole = Footprints(Floor(1.03), sun, frame.Build());
  whole->SetRefinements(4);
  EXPECT_EQ(ErrorsOf(whole), "");
  EXPECT_EQ(whole->GetOutput(0)->GetNumberOfLines(), 2);
  EXPECT_NEAR(AreaOf(whole, 0, 2), 0.75, 0.003) << "the hole runs the other way around";
  const auto half = Footprints(Plane({ 0.0, -1.03, 0.0 }, { 1.03, 0.0, 0.0 }, { 0.0, 2.06, 0.0 }), sun, frame.Build());
  half->SetRefinements(4);
  EXPECT_EQ(ErrorsOf(half), "");
  EXPECT_NEAR(AreaOf(half, 0, 2), 0.375, 0.003);
  EXPECT_EQ(half->GetOutput(0)->GetNumberOfLines(), 1);
  EXPECT_TRUE(AreAllClosed(half->GetOutput(0)));
}

TEST(ShadowFootprints, EachOccluderHasItsOwnAndAllHaveOneTogether)
{
  // Two sheets that overlap seen from above, under two Suns.
  MeshBuilder sheets;
  for (int k = 0; k < 2; ++k)
  {
    const double x = -0.5 + 0.5 * k;
    const double z = 1.0 + 0.2 * k;
    const vtkIdType f = sheets.AddPoint(x, -0.5, z);
    sheets.AddPoint(x + 1.0, -0.5, z);
    sheets.AddPoint(x + 1.0, 0.5, z);
    sheets.AddPoint(x, 0.5, z);
    sheets.AddQuad(f, f + 1, f + 2, f + 3, 5 + k);
  }
  const auto noon = Sun(0.0, 0.0, -1.0, 0.0);
  const auto later = Sun(0.1, 0.0, -1.0, 0.5);
  const auto filter = Footprints(Floor(2.0), noon, sheets.Build());
  filter->AddLightConnection(later->GetOutputPort());
  filter->SetNumberOfLightSamples(32);
  filter->SetSpacing(0.1);
  EXPECT_EQ(ErrorsOf(filter), "");
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_NEAR(AreaOf(filter, 0, 2, k), 1.0, 0.005) << k;
    const double blur = (1.0 + 0.2 * k) * std::tan(0.25 * pi / 180.0);
    EXPECT_NEAR(AreaOf(filter, 0, 1, k, 1) - AreaOf(filter, 0, 2, k, 1), 2.0 * 4.0 * blur, 0.004) << k;
  }
  auto* names = filter->GetOutput(0)->GetFieldData()->GetAbstractArray("OccluderNames");
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetVariantValue(1).ToString(), "6");
  filter->PerOccluderOff();
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_NEAR(AreaOf(filter, 0, 2, -1), 1.5, 0.006) << "what both hide counts once";
}

TEST(ShadowFootprints, WrittenForMaps)
{
  const auto lamp = LampAbove(4.0, 0.3);
  // A ring seen by the lamp: its umbra has a hole, and so has its whole shadow.
  MeshBuilder ring;
  constexpr int sides = 48;
  for (int k = 0; k < sides; ++k)
  {
    for (const double r : { 0.6, 1.0 })
    {
      ring.AddPoint(r * std::cos(2.0 * pi * k / sides), r * std::sin(2.0 * pi * k / sides), 2.0);
    }
  }
  for (vtkIdType k = 0; k < sides; ++k)
  {
    const vtkIdType next = (k + 1) % sides;
    ring.AddQuad(2 * k, 2 * k + 1, 2 * next + 1, 2 * next, 12);
  }
  const auto filter = Footprints(Floor(2.5), lamp, ring.Build());
  vtkNew<vtkShadowFootprintWriter> writer;
  const std::string path = ::testing::TempDir() + "footprints.geojson";
  writer->SetInputConnection(filter->GetOutputPort(0));
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1);
  const std::string text = ReadFile(path);
  EXPECT_EQ(
    text.rfind(
      "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"OccluderName\":\"12\","
      "\"OccluderId\":0,\"LightId\":0,\"ShadowClass\":1,\"Shadow\":\"whole shadow\",\"Area\":",
      0),
    0u)
    << text.substr(0, 300);
  std::size_t features = 0;
  for (std::size_t at = text.find("\"Feature\""); at != std::string::npos; at = text.find("\"Feature\"", at + 1))
  {
    ++features;
  }
  EXPECT_EQ(features, 2u) << "two polygons, each with its hole";
  // Whole shadow: from 2 x 0.6 - 0.3 to 2 x 1 + 0.3; umbra: from 1.5 to 1.7.
  const std::size_t area = text.find("\"Area\":");
  EXPECT_NEAR(std::stod(text.substr(area + 7)) / (pi * (2.3 * 2.3 - 0.9 * 0.9)), 1.0, 0.01);
  EXPECT_NEAR(std::stod(text.substr(text.find("\"Area\":", area + 1) + 7)) / (pi * (1.7 * 1.7 - 1.5 * 1.5)), 1.0, 0.03);
  EXPECT_NE(text.find("]],[["), std::string::npos) << "a second ring";
  std::remove(path.c_str());

  Messages messages(writer);
  writer->SetFileName((::testing::TempDir() + "no-such-folder/a.geojson").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_SAYS(messages.Errors, "cannot be written");
  writer->SetFileName(nullptr);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_SAYS(messages.Errors, "There is no FileName to write to");
}

TEST(ShadowFootprints, TheWriterLeavesOutWhatIsNoPolygon)
{
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 1.0, 0.5);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  cells->InsertNextCell({ 0, 2, 1, 0 });
  lines->SetPoints(points);
  lines->SetLines(cells);
  vtkNew<vtkShadowFootprintWriter> writer;
  const std::string path = ::testing::TempDir() + "one-triangle.geojson";
  writer->SetInputData(lines);
  writer->SetFileName(path.c_str());
  Messages messages(writer);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_SAYS(messages.Warnings, "1 of 2 outlines are left out");
  EXPECT_NE(ReadFile(path).find("[[0.0,0.0,0.0],[1.0,0.0,0.0],[1.0,1.0,0.5],[0.0,0.0,0.0]]"), std::string::npos)
    << "turned counter-clockwise, with heights: " << ReadFile(path);
  std::remove(path.c_str());
  vtkNew<vtkIntArray> classes;
  classes->SetName("ShadowClass");
  classes->InsertNextValue(1);
  classes->InsertNextValue(7);
  lines->GetCellData()->AddArray(classes);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_SAYS(messages.Errors, "The \"ShadowClass\" of outlines' cell 1 is 7: it must be 0, 1 or 2.");
  lines->GetCellData()->RemoveArray("ShadowClass");
  points->SetPoint(1, std::nan(""), 0.0, 0.0);
  points->Modified();
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_SAYS(messages.Errors, "of the outlines has a coordinate that is not finite");
}

TEST(ShadowFootprints, SaysWhatIsWrong)
{
  const auto lamp = LampAbove(4.0, 0.3);
  const auto filter = Footprints(Floor(1.0), lamp, DiscAt(2.0, 0.5, 8));
  filter->SetSpacing(-1.0);
  EXPECT_SAYS(ErrorsOf(filter), "Spacing is -1: it must be 0 or above and finite.");
  filter->SetSpacing(1e-6);
  EXPECT_SAYS(ErrorsOf(filter), "are the most: raise it");
  filter->SetSpacing(0.0);
  filter->SetRefinements(9);
  EXPECT_SAYS(ErrorsOf(filter), "Refinements is 9: it must be in 0..8.");
  filter->SetRefinements(2);
  filter->SetInputData(PointsAt({ 0.0, 0.0, 0.0 }));
  EXPECT_SAYS(ErrorsOf(filter), "footprints are asked for on a surface");
  filter->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
  filter->SetInputData(Floor(1.0));
  filter->SetMeshData(vtkNew<vtkPolyData>());
  EXPECT_EQ(ErrorsOf(filter), "");
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0) << "nothing casts a shadow";
  filter->RemoveAllLights();
  EXPECT_SAYS(ErrorsOf(filter), "No light on input port 1");
}
