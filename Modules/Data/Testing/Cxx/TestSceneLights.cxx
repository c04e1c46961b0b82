// SPDX-License-Identifier: BSD-3-Clause
// Lights of a port: shapes that do not fit their mesh, several lights, and whose cones are whose.
#include "scConeData.h"
#include "scLightData.h"
#include "scSceneLights.h"
#include "scSentence.h"

#include "Messages.h"
#include "scVisibilityData.h"

#include "vtkAreaLightSource.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

using namespace shadowcones;

namespace
{
using PolyData = vtkSmartPointer<vtkPolyData>;

PolyData MakeLamp(const std::function<void(vtkAreaLightSource*)>& set)
{
  vtkNew<vtkAreaLightSource> source;
  set(source);
  source->Update();
  return source->GetOutput();
}

PolyData Disc(double x, double radius = 0.2)
{
  return MakeLamp(
    [&](vtkAreaLightSource* lamp)
    {
      lamp->SetShapeToDisc();
      lamp->SetCenter(x, 0.0, 4.0);
      lamp->SetNormal(0.0, 0.0, -1.0);
      lamp->SetRadius(radius);
    });
}

PolyData Sun()
{
  return MakeLamp([](vtkAreaLightSource* lamp) { lamp->SetShapeToSun(); });
}

/// The same light with other points: what a transform leaves.
PolyData Moved(vtkPolyData* lamp, const std::function<Vector3(const Vector3&)>& move, int type = VTK_DOUBLE)
{
  PolyData moved = PolyData::New();
  moved->DeepCopy(lamp);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (vtkIdType i = 0; i < lamp->GetNumberOfPoints(); ++i)
  {
    double x[3];
    lamp->GetPoint(i, x);
    const Vector3 p = move({ x[0], x[1], x[2] });
    points->InsertNextPoint(p.X, p.Y, p.Z);
  }
  moved->SetPoints(points);
  return moved;
}

/// Points, polygons and vertices of both, field data of the first: what joining leaves.
PolyData Joined(vtkPolyData* a, vtkPolyData* b)
{
  PolyData joined = PolyData::New();
  joined->GetFieldData()->ShallowCopy(a->GetFieldData());
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> vertices;
  for (vtkPolyData* lamp : { a, b })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < lamp->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(lamp->GetPoint(i));
    }
    polygons->Append(lamp->GetPolys(), first);
    vertices->Append(lamp->GetVerts(), first);
  }
  joined->SetPoints(points);
  joined->SetPolys(polygons);
  joined->SetVerts(vertices);
  return joined;
}

struct Result
{
  Light Read;
  std::string Warning;
  std::string Error;
};

Result ReadOne(vtkPolyData* lamp)
{
  Result result;
  const bool read = ReadLight(lamp, result.Read, result.Error, &result.Warning);
  EXPECT_EQ(read, result.Error.empty());
  return result;
}

SceneLights ReadPort(const std::vector<vtkDataObject*>& connections, std::string& error)
{
  vtkNew<vtkInformationVector> port;
  for (vtkDataObject* data : connections)
  {
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    port->Append(info);
  }
  SceneLights lights;
  const bool read = ReadLights(port, lights, error);
  EXPECT_EQ(read, error.empty());
  return lights;
}

} // namespace

TEST(SceneLights, AShapeThatFitsIsBelieved)
{
  for (const double far : { 0.0, 1e3, 1e6 })
  {
    const PolyData lamp = MakeLamp(
      [&](vtkAreaLightSource* source)
      {
        source->SetShapeToSphere();
        source->SetCenter(far, -far, far);
        source->SetRadius(0.5);
      });
    const Result exact = ReadOne(lamp);
    EXPECT_EQ(exact.Warning, "");
    EXPECT_EQ(exact.Read.Shape, LightShape::Sphere);
    // In single precision it fits to the rounding of that.
    const Result rounded = ReadOne(Moved(lamp, [](const Vector3& p) { return p; }, VTK_FLOAT));
    EXPECT_EQ(rounded.Warning, "") << far;
    EXPECT_EQ(rounded.Read.Shape, LightShape::Sphere);
    EXPECT_EQ(rounded.Read.Radius, 0.5);
  }
}

TEST(SceneLights, AMovedLampShinesFromWhereItIs)
{
  const Result turned = ReadOne(
    Moved(Disc(-3.0), [](const Vector3& p) { return Vector3{ 2.0 * p.Z, 2.0 * p.Y + 1.0, -2.0 * p.X }; }));
  EXPECT_EQ(turned.Warning, "");
  EXPECT_EQ(turned.Read.Shape, LightShape::Disc);
  EXPECT_LT(Length(turned.Read.Center - Vector3{ 8.0, 1.0, 6.0 }), 1e-9);
  EXPECT_LT(Length(turned.Read.Normal - Vector3{ -1.0, 0.0, 0.0 }), 1e-9);
  EXPECT_NEAR(turned.Read.Radius, 0.4, 1e-9);
}

TEST(SceneLights, PolygonsShineWhereTheShapeDoesNotFit)
{
  const double area = 12.0 * std::sin(3.14159265358979323846 / 12.0) * 0.04; // 24 corners on a rim of 0.2
  const Result both = ReadOne(Joined(Disc(-3.0), Disc(3.0)));
  EXPECT_EQ(both.Read.Shape, LightShape::Mesh);
  EXPECT_EQ(both.Read.Spectrum.size(), 7u);
  EXPECT_NEAR(LightArea(both.Read) / (2.0 * area), 1.0, 0.05);
  EXPECT_SAYS(both.Warning, "\"LightShape\" is Disc and does not fit its mesh, which lies up to 6 away");
  EXPECT_SAYS(both.Warning, "AddLightConnection");
  const Result stretched =
    ReadOne(Moved(Disc(0.0), [](const Vector3& p) { return Vector3{ 3.0 * p.X, p.Y, p.Z }; }));
  EXPECT_EQ(stretched.Read.Shape, LightShape::Mesh);
  EXPECT_SAYS(stretched.Warning, "lies up to 0.4 away");
}

TEST(SceneLights, PointsAndSunsAreVertices)
{
  const PolyData point = MakeLamp(
    [](vtkAreaLightSource* lamp)
    {
      lamp->SetShapeToPoint();
      lamp->SetCenter(1.0, 2.0, 3.0);
    });
  const auto shift = [](const Vector3& p) { return p + Vector3{ 5.0, 0.0, 0.0 }; };
  EXPECT_EQ(ReadOne(point).Read.Center.X, 1.0);
  EXPECT_EQ(ReadOne(Moved(point, shift)).Read.Center.X, 6.0);
  EXPECT_EQ(ReadOne(Moved(point, shift)).Warning, "");
  const Result points = ReadOne(Joined(point, Moved(point, shift)));
  EXPECT_EQ(points.Read.Vertices.size(), 2u);
  EXPECT_SAYS(points.Warning, "Point and it has 2 vertices");

  EXPECT_EQ(ReadOne(Sun()).Warning, "");
  // A place is nothing to a Sun, a turn is.
  EXPECT_EQ(ReadOne(Moved(Sun(), shift)).Warning, "");
  vtkNew<vtkTransform> turn;
  turn->RotateX(90.0); // from along z to along -y
  turn->Translate(0.0, 3.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetTransform(turn);
  turned->SetInputData(Sun());
  turned->Update();
  const Result read = ReadOne(turned->GetOutput());
  EXPECT_EQ(read.Warning, "");
  EXPECT_EQ(read.Read.Shape, LightShape::Sun);
  EXPECT_LT(Length(read.Read.Normal - Vector3{ 0.0, -1.0, 0.0 }), 1e-6);
  // One without a normal cannot tell.
  const PolyData old = Moved(Sun(), shift);
  old->GetPointData()->SetNormals(nullptr);
  EXPECT_SAYS(ReadOne(old).Warning, "lies 5 from where it was made");
  EXPECT_SAYS(ReadOne(Joined(Sun(), Sun())).Error, "0 triangles and 2 vertices");
  EXPECT_SAYS(ReadOne(Joined(Sun(), Disc(0.0))).Error, " triangles and ");
}

TEST(SceneLights, ConnectionsAndBlocksAreLights)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Disc(2.0));
  inner->SetBlock(2, Sun()); // block 1 is not there
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  outer->SetBlock(1, Disc(3.0));
  const PolyData first = Disc(1.0);
  std::string error;
  const SceneLights lights = ReadPort({ first, outer }, error);
  ASSERT_EQ(lights.Lights.size(), 4u);
  EXPECT_EQ(lights.Lights[0].Center.X, 1.0);
  EXPECT_EQ(lights.Lights[1].Center.X, 2.0);
  EXPECT_EQ(lights.Lights[2].Shape, LightShape::Sun);
  EXPECT_EQ(lights.Lights[3].Center.X, 3.0);
  EXPECT_NEAR(lights.Bounds.Min.X, 0.8, 1e-6);
  EXPECT_NEAR(lights.Bounds.Max.X, 3.2, 1e-6);
  EXPECT_EQ(lights.Bounds.Min.Z, 4.0);
}

TEST(SceneLights, FaultsNameTheLights)
{
  std::string error;
  vtkNew<vtkMultiBlockDataSet> empty;
  ReadPort({ empty }, error);
  EXPECT_SAYS(error, "There is no light");
  const PolyData seven = Disc(0.0);
  const PolyData three = MakeLamp([](vtkAreaLightSource* lamp) { lamp->SetNumberOfWavelengths(3); });
  ReadPort({ seven, three }, error);
  EXPECT_SAYS(error, "Light 0 has 7 wavelengths and light 1 has 3");
  vtkNew<vtkUnstructuredGrid> grid;
  ReadPort({ seven, grid }, error);
  EXPECT_SAYS(error, "Light 1 is a vtkUnstructuredGrid");
  for (const double value : { std::nan(""), HUGE_VAL, 0.0, -550.0 })
  {
    three->GetFieldData()->GetArray("LightWavelengths")->SetComponent(1, 0, value);
    ReadPort({ three }, error);
    EXPECT_SAYS(error, "The field array \"LightWavelengths\" holds " + Sentence(value));
  }
}

TEST(SceneLights, FieldDataHaveATupleALight)
{
  std::string error;
  const PolyData disc = Disc(1.0);
  const PolyData bare = Disc(2.0);
  const PolyData sun = Sun();
  bare->GetFieldData()->RemoveArray("LightShape");
  const SceneLights lights = ReadPort({ disc, bare, sun }, error);
  vtkNew<vtkPolyData> output;
  WriteLights(lights.Lights, output);
  vtkFieldData* field = output->GetFieldData();
  for (const char* name :
    { "LightShape", "LightCenter", "LightNormal", "LightAxes", "LightRadius", "LightSpectrum", "LightFingerprint" })
  {
    ASSERT_NE(field->GetAbstractArray(name), nullptr) << name;
    EXPECT_EQ(field->GetAbstractArray(name)->GetNumberOfTuples(), 3) << name;
  }
  std::vector<Light> read;
  ASSERT_TRUE(ReadLightShapes(field, read, error)) << error;
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(FingerprintOf(read[0]), FingerprintOf(lights.Lights[0]));
  EXPECT_EQ(read[1].Shape, LightShape::Mesh);
  EXPECT_EQ(FingerprintOf(read[2]), FingerprintOf(lights.Lights[2]));
  EXPECT_EQ(read[2].Spectrum, lights.Lights[2].Spectrum);
  EXPECT_EQ(ReadLightFingerprints(field)[1], FingerprintOf(lights.Lights[1]));
  // A mesh alone has no shape, and leaves none of another light.
  WriteLights({ lights.Lights[1] }, output);
  EXPECT_EQ(field->GetAbstractArray("LightShape"), nullptr);
  EXPECT_EQ(ReadLightFingerprints(field).size(), 1u);
}

TEST(SceneLights, ConesFindTheirLight)
{
  std::string error;
  const PolyData a = Disc(1.0);
  const PolyData b = Disc(2.0);
  const PolyData c = Disc(3.0);
  std::vector<Cone> made(2);
  made[0].Axis = made[0].Normal = { 0.0, 0.0, 1.0 };
  made[1] = made[0];
  made[1].LightId = 1;
  vtkNew<vtkPolyData> set;
  WriteConeSet(made, set);
  WriteLights(ReadPort({ a, b }, error).Lights, set);
  const auto assign = [&](const std::vector<vtkDataObject*>& connected, std::vector<int>& ids)
  {
    SceneLights lights = ReadPort(connected, error);
    std::vector<Cone> cones;
    EXPECT_TRUE(ReadConeSet(set, cones, error)) << error;
    AssignCones(set, lights, cones);
    ids.clear();
    for (const Cone& cone : cones)
    {
      ids.push_back(cone.LightId);
    }
    return lights.Warnings.empty() ? std::string() : lights.Warnings.front();
  };
  std::vector<int> ids;
  EXPECT_EQ(assign({ a, b }, ids), "");
  EXPECT_EQ(ids, (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(assign({ b, a }, ids), "");
  EXPECT_EQ(ids, (std::vector<int>{ 1, 0 }));
  EXPECT_EQ(assign({ b }, ids), "");
  EXPECT_EQ(ids, (std::vector<int>{ -1, 0 }));
  EXPECT_SAYS(assign({ a, c }, ids), "light 1 is none of its 2");
  EXPECT_EQ(ids, (std::vector<int>{ 0, 1 }));
  // Without the array that tells, each is taken to bound the shadow of all.
  set->GetPointData()->RemoveArray("LightId");
  set->GetFieldData()->RemoveArray("LightFingerprint");
  EXPECT_EQ(assign({ a }, ids), "");
  EXPECT_SAYS(assign({ a, b }, ids), "no \"LightId\" and 2 lights");
  EXPECT_EQ(ids, (std::vector<int>{ 0, 0, 1, 1 }));
}

TEST(SceneLights, VolumesHaveAComponentALight)
{
  std::string error;
  std::string warning;
  const PolyData a = Disc(1.0);
  const PolyData b = Disc(2.0);
  std::vector<VisibilityGrid> grids(2);
  for (std::size_t light = 0; light < 2; ++light)
  {
    VisibilityGrid& grid = grids[light];
    grid.Spacing = { 1.0, 1.0, 1.0 };
    grid.Dimensions = { 2, 2, 3 };
    grid.Visibility.assign(12, 1.0f);
    grid.ShadowClasses.assign(12, 0);
    grid.Marked.assign(12, 0);
    grid.Visibility[3 + light] = 0.25f;
    grid.ShadowClasses[3 + light] = 1;
    grid.Marked[3 + light] = 1;
    grid.BrickParts = 2;
    grid.BrickCells.assign(1, static_cast<vtkIdType>(1 - light)); // descending over both
    grid.BrickVisibility.assign(27, 0.5f + 0.125f * static_cast<float>(light));
  }
  const int extent[6] = { 0, 1, 0, 1, 0, 2 };
  vtkNew<vtkImageData> image;
  WriteVisibilityGrids(grids, extent, image);
  WriteLightFingerprints(ReadPort({ a, b }, error).Lights, image);
  EXPECT_EQ(image->GetPointData()->GetArray("Visibility")->GetNumberOfComponents(), 2);
  EXPECT_EQ(image->GetPointData()->GetArray("Visibility")->GetComponent(4, 1), 0.25);
  EXPECT_EQ(image->GetPointData()->GetArray("ShadowClass")->GetComponent(3, 0), 1.0);
  EXPECT_EQ(image->GetPointData()->GetArray("Marked")->GetComponent(4, 0), 1.0);

  std::vector<VisibilityGrid> read;
  ASSERT_TRUE(ReadVisibilityGrids(image, read, error, warning)) << error;
  SceneLights swapped = ReadPort({ b, a }, error);
  ASSERT_TRUE(AssignGrids(image->GetFieldData(), swapped, read, error)) << error;
  EXPECT_TRUE(swapped.Warnings.empty());
  for (std::size_t light = 0; light < 2; ++light)
  {
    EXPECT_EQ(read[light].Visibility, grids[1 - light].Visibility);
    EXPECT_EQ(read[light].BrickCells, grids[1 - light].BrickCells);
    EXPECT_EQ(read[light].BrickVisibility, grids[1 - light].BrickVisibility);
  }
  const PolyData c = Disc(3.0);
  SceneLights three = ReadPort({ a, b, c }, error);
  EXPECT_FALSE(AssignGrids(image->GetFieldData(), three, read, error));
  EXPECT_SAYS(error, "has 2 components and 3 lights are connected");
}
