// SPDX-License-Identifier: BSD-3-Clause
// Several lights in every filter that has a light port: closed forms, order, ports, messages.
#include "Messages.h"
#include "TestPolyData.h"

#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetProbe.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{
constexpr double pi = 3.14159265358979323846;

vtkSmartPointer<vtkAreaLightSource> LampAt(double x, double radius = 0.4)
{
  auto lamp = LampAbove(4.0, radius);
  lamp->SetCenter(x, 0.0, 4.0);
  return lamp;
}

/// A wall at z = 2 over all x above 0.
vtkSmartPointer<vtkPolyData> HalfWall()
{
  MeshBuilder builder;
  const vtkIdType f = builder.AddPoint(0.0, -20.0, 2.0);
  builder.AddPoint(40.0, -20.0, 2.0);
  builder.AddPoint(40.0, 20.0, 2.0);
  builder.AddPoint(0.0, 20.0, 2.0);
  builder.AddQuad(f, f + 1, f + 2, f + 3, 0);
  return builder.Build();
}

/// Points on the x axis.
vtkSmartPointer<vtkPolyData> PointsOnAxis(const std::vector<double>& xs)
{
  std::vector<double> coordinates;
  for (const double x : xs)
  {
    coordinates.insert(coordinates.end(), { x, 0.0, 0.0 });
  }
  return PointsAt(coordinates);
}

/// The share of a disc of radius @p r about x = @p center that lies at x below @p edge.
double ShareBelow(double edge, double center, double r)
{
  const double t = std::clamp((edge - center) / r, -1.0, 1.0);
  return (std::acos(-t) + t * std::sqrt(1.0 - t * t)) / pi;
}

/// Cones of all lights that are connected, as bounds.
vtkSmartPointer<vtkConeSetFilter> ConesOf(const std::vector<vtkAreaLightSource*>& lamps, vtkPolyData* mesh)
{
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputData(mesh);
  for (vtkAreaLightSource* lamp : lamps)
  {
    vectors->AddLightConnection(lamp->GetOutputPort());
  }
  vectors->SetTargetNumberOfVectors(2000);
  vectors->SetStorageToHitPoint();
  auto cones = vtkSmartPointer<vtkConeSetFilter>::New();
  cones->SetInputConnection(vectors->GetOutputPort(0));
  cones->SetPhotonPathConnection(vectors->GetOutputPort(1));
  cones->SetExpansionToLightGeometry();
  cones->OverlapOn();
  cones->CosineCorrectionOff();
  cones->Update();
  return cones;
}

/// One cone that holds everything, without a light.
vtkSmartPointer<vtkPolyData> Everywhere()
{
  auto set = PointsOnAxis({ 0.0 });
  set->GetPoints()->SetPoint(0, 0.0, 0.0, -100.0);
  const auto add = [&](const char* name, int components, std::initializer_list<double> values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    set->GetPointData()->AddArray(array);
  };
  add("Axis", 3, { 0.0, 0.0, 1.0 });
  add("BaseRadius", 1, { 200.0 });
  add("HalfAngle", 1, { 0.3 });
  return set;
}

vtkSmartPointer<vtkConeSetProbe> Probe(vtkPolyData* points, vtkPolyData* mesh)
{
  auto probe = vtkSmartPointer<vtkConeSetProbe>::New();
  probe->SetInputData(points);
  probe->SetConeSetData(Everywhere());
  probe->SetMeshData(mesh);
  probe->SetNumberOfLightSamples(1024);
  return probe;
}
} // anonymous namespace

TEST(SeveralLights, TwoDiscsBehindHalfAWall)
{
  // From (x, 0, 0) the edge of the wall covers the lamps' plane at 2 times its height: lamp points beyond -x are
  // hidden.
  const auto a = LampAt(-0.1);
  const auto b = LampAt(0.15);
  const std::vector<double> xs = { -0.3, 0.0, 0.1, 0.9 };
  const auto probe = Probe(PointsOnAxis(xs), HalfWall());
  Messages messages(probe);
  probe->SetLightConnection(a->GetOutputPort());
  probe->AddLightConnection(b->GetOutputPort());
  probe->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_SAYS(messages.Warnings, "no \"LightId\" and 2 lights are connected");
  vtkPointData* data = probe->GetOutput()->GetPointData();
  vtkDataArray* visibility = ArrayOf(data, "Visibility", VTK_FLOAT, 2);
  vtkDataArray* classes = ArrayOf(data, "ShadowClass", VTK_UNSIGNED_CHAR, 2);
  vtkDataArray* occluders = ArrayOf(data, "OccluderId", VTK_INT, 2);
  ArrayOf(data, "VisibilityError", VTK_FLOAT, 2);
  for (std::size_t i = 0; i < xs.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    for (int light = 0; light < 2; ++light)
    {
      const double share = ShareBelow(-xs[i], light ? 0.15 : -0.1, 0.4);
      EXPECT_NEAR(visibility->GetComponent(point, light), share, 5e-3) << xs[i] << " " << light;
      EXPECT_EQ(classes->GetComponent(point, light), share == 1.0 ? 0.0 : share == 0.0 ? 2.0 : 1.0);
      EXPECT_EQ(occluders->GetComponent(point, light), share == 1.0 ? -1.0 : 0.0);
    }
  }
  EXPECT_EQ(probe->GetOutput()->GetFieldData()->GetAbstractArray("LightFingerprint")->GetNumberOfTuples(), 2);
}

TEST(SeveralLights, TwoSunsHaveAShadowEach)
{
  // At z = 0 below the edge of the wall the shadow of a sun of slope s begins at x = 2 s.
  const auto sun = [](double slope)
  {
    auto light = vtkSmartPointer<vtkAreaLightSource>::New();
    light->SetShapeToSun();
    light->SetNormal(slope, 0.0, -1.0);
    light->SetAngularDiameter(0.5);
    return light;
  };
  const auto probe = Probe(PointsOnAxis({ -1.2, 0.2, 1.2 }), HalfWall());
  Messages messages(probe);
  const auto left = sun(-0.5);
  const auto right = sun(0.5);
  probe->SetLightConnection(left->GetOutputPort());
  probe->AddLightConnection(right->GetOutputPort());
  probe->Update();
  vtkDataArray* visibility = ArrayOf(probe->GetOutput()->GetPointData(), "Visibility", VTK_FLOAT, 2);
  const double expected[3][2] = { { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.0 } };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(visibility->GetComponent(i, 0), expected[i][0]) << i;
    EXPECT_EQ(visibility->GetComponent(i, 1), expected[i][1]) << i;
  }
}

TEST(SeveralLights, TheOrderOfLightsIsThatOfComponents)
{
  const auto mesh = MeshBuilder().AddBox(0.0, 0.0, 1.5, 0.4, 0.3, 0.2, 5).Build();
  const auto a = LampAt(-0.8);
  const auto b = LampAt(0.7, 0.3);
  const auto cones = ConesOf({ a, b }, mesh);
  std::vector<double> xs;
  for (int i = 0; i < 60; ++i)
  {
    xs.push_back(-1.5 + 0.05 * i);
  }
  const auto run = [&](const std::vector<vtkAreaLightSource*>& lamps)
  {
    const auto probe = Probe(PointsOnAxis(xs), mesh);
    probe->SetConeSetConnection(cones->GetOutputPort(0));
    Messages messages(probe);
    for (vtkAreaLightSource* lamp : lamps)
    {
      probe->AddLightConnection(lamp->GetOutputPort());
    }
    probe->Update();
    EXPECT_EQ(messages.Errors + messages.Warnings, "");
    return probe;
  };
  const auto both = run({ a, b });
  const auto swapped = run({ b, a });
  const auto alone = run({ b });
  for (const char* name : { "Visibility", "ShadowClass", "OccluderId", "VisibilityError" })
  {
    vtkDataArray* ab = both->GetOutput()->GetPointData()->GetArray(name);
    vtkDataArray* ba = swapped->GetOutput()->GetPointData()->GetArray(name);
    vtkDataArray* onlyB = alone->GetOutput()->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(xs.size()); ++i)
    {
      EXPECT_EQ(ab->GetComponent(i, 0), ba->GetComponent(i, 1)) << name << i;
      EXPECT_EQ(ab->GetComponent(i, 1), ba->GetComponent(i, 0)) << name << i;
      EXPECT_EQ(ab->GetComponent(i, 1), onlyB->GetComponent(i, 0)) << name << i;
    }
  }
}

TEST(SeveralLights, BlocksAndConnectionsAreTheSame)
{
  const auto a = LampAt(-0.1);
  const auto b = LampAt(0.15);
  a->Update();
  b->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, a->GetOutput());
  blocks->SetBlock(1, b->GetOutput());
  const auto one = Probe(PointsOnAxis({ 0.0, 0.1 }), HalfWall());
  Messages said(one);
  one->SetLightData(blocks);
  one->Update();
  ASSERT_TRUE(one->GetOutputDataObject(0)->IsA("vtkPolyData")); // not run once a block
  const auto two = Probe(PointsOnAxis({ 0.0, 0.1 }), HalfWall());
  Messages saidToo(two);
  two->AddLightData(a->GetOutput());
  two->AddLightData(b->GetOutput());
  two->Update();
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_EQ(one->GetOutput()->GetPointData()->GetArray("Visibility")->GetComponent(c / 2, c % 2),
      two->GetOutput()->GetPointData()->GetArray("Visibility")->GetComponent(c / 2, c % 2));
  }
  // Set replaces all of them.
  two->SetLightData(b->GetOutput());
  two->Update();
  EXPECT_EQ(two->GetOutput()->GetPointData()->GetArray("Visibility")->GetNumberOfComponents(), 1);
  two->RemoveAllLights();
  two->Update();
  EXPECT_SAYS(saidToo.Errors, "No light on input port 2");
}

TEST(SeveralLights, VectorsAndConesTellTheirLight)
{
  const auto mesh = MeshBuilder().AddSquare(1.0, 0.6, 0).Build();
  const auto a = LampAt(-1.0);
  const auto b = LampAt(1.0);
  b->SetRadiance(3.0);
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputData(mesh);
  vectors->AddLightConnection(a->GetOutputPort());
  vectors->AddLightConnection(b->GetOutputPort());
  vectors->SetNumberOfPhotons(4096);
  vectors->Update();
  for (int port = 0; port < 3; ++port)
  {
    vtkPolyData* output = vectors->GetOutput(port);
    ArrayOf(output->GetPointData(), "LightId", VTK_INT, 1);
    ASSERT_EQ(output->GetFieldData()->GetArray("LightShape")->GetNumberOfTuples(), 2);
    // Three times the radiance, three times the photons.
    EXPECT_EQ(output->GetFieldData()->GetArray("PhotonsOfLights")->GetComponent(0, 0), 1024.0);
    EXPECT_EQ(output->GetFieldData()->GetArray("PhotonsOfLights")->GetComponent(1, 0), 3072.0);
  }
  vtkDataArray* ids = vectors->GetOutput(1)->GetPointData()->GetArray("LightId");
  vtkDataArray* emission = vectors->GetOutput(1)->GetPointData()->GetArray("EmissionPoint");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(emission->GetComponent(i, 0) > 0.0, ids->GetComponent(i, 0) == 1.0);
  }

  const auto cones = ConesOf({ a, b }, mesh);
  vtkPolyData* set = cones->GetOutput(0);
  vtkDataArray* lightIds = ArrayOf(set->GetPointData(), "LightId", VTK_INT, 1);
  vtkDataArray* axes = set->GetPointData()->GetArray("Axis");
  int counts[2] = { 0, 0 };
  for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
  {
    const int id = static_cast<int>(lightIds->GetComponent(i, 0));
    ++counts[id];
    // A lamp on the left throws shadows to the right.
    const double side = set->GetPoint(i)[0] + (id ? -1.0 : 1.0);
    EXPECT_GT(axes->GetComponent(i, 0) * side, 0.0) << i;
  }
  EXPECT_GT(counts[0], 0);
  EXPECT_GT(counts[1], 0);

  vtkNew<vtkShadowVolume> volume;
  volume->SetInputConnection(cones->GetOutputPort(0));
  volume->SetUmbraToBaseDiscs();
  volume->SetResolution(8);
  volume->Update();
  double range[2];
  ArrayOf(volume->GetOutput(0)->GetCellData(), "LightId", VTK_INT, 1)->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 1.0);
}

TEST(SeveralLights, TuningServesAllOfThem)
{
  const auto mesh = MeshBuilder().AddSquare(1.0, 0.6, 0).Build();
  const auto a = LampAt(-1.0);
  const auto b = LampAt(1.0);
  const auto cones = ConesOf({ a, b }, mesh);
  Messages messages(cones);
  cones->SetTuningToConservative();
  cones->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_LT(FieldValue(cones->GetOutput(0), "TuningLeak"), 0.2);
  double range[2];
  cones->GetOutput(0)->GetPointData()->GetArray("LightId")->GetRange(range);
  EXPECT_EQ(range[1], 1.0);
}

TEST(SeveralLights, AccuracyIsThatOfEachLightsCones)
{
  const auto mesh = MeshBuilder().AddSquare(1.0, 0.6, 0).Build();
  const auto a = LampAt(-1.0);
  const auto b = LampAt(1.0);
  const auto cones = ConesOf({ a, b }, mesh);
  vtkNew<vtkConeSetAccuracy> accuracy;
  Messages messages(accuracy);
  accuracy->SetConeSetConnection(cones->GetOutputPort(0));
  accuracy->SetMeshData(mesh);
  accuracy->AddLightConnection(a->GetOutputPort());
  accuracy->AddLightConnection(b->GetOutputPort());
  accuracy->SetNumberOfSamples(2000);
  accuracy->SetBounds(-2.0, 2.0, -2.0, 2.0, 0.0, 1.0);
  accuracy->Update();
  EXPECT_EQ(messages.Errors + messages.Warnings, "");
  vtkPointData* data = accuracy->GetOutput(0)->GetPointData();
  vtkDataArray* truth = ArrayOf(data, "Truth", VTK_FLOAT, 2);
  vtkDataArray* coneIds = ArrayOf(data, "ConeId", VTK_ID_TYPE, 2);
  vtkDataArray* prediction = ArrayOf(data, "Prediction", VTK_UNSIGNED_CHAR, 2);
  vtkDataArray* lightIds = cones->GetOutput(0)->GetPointData()->GetArray("LightId");
  int shadowed = 0;
  int found = 0;
  for (vtkIdType i = 0; i < truth->GetNumberOfTuples(); ++i)
  {
    for (int light = 0; light < 2; ++light)
    {
      const auto cone = static_cast<vtkIdType>(coneIds->GetComponent(i, light));
      EXPECT_TRUE(cone < 0 || lightIds->GetComponent(cone, 0) == light);
      shadowed += truth->GetComponent(i, light) < 1.0;
      found += truth->GetComponent(i, light) < 1.0 && prediction->GetComponent(i, light) > 0.0;
    }
  }
  EXPECT_GT(shadowed, 300);
  vtkTable* table = vtkTable::SafeDownCast(accuracy->GetOutputDataObject(1));
  ASSERT_NE(table, nullptr);
  EXPECT_NEAR(table->GetValueByName(0, "Value").ToDouble(), static_cast<double>(found) / shadowed, 1e-12);

  accuracy->SetConeSetData(Everywhere());
  accuracy->Update();
  EXPECT_SAYS(messages.Errors, "no \"LightId\" and 2 lights are connected");
}

TEST(SeveralLights, ConesOfOtherLightsAreSaid)
{
  const auto mesh = MeshBuilder().AddSquare(1.0, 0.6, 0).Build();
  const auto a = LampAt(-1.0);
  const auto b = LampAt(1.0);
  const auto cones = ConesOf({ a }, mesh);
  const auto probe = Probe(PointsOnAxis({ 0.0 }), mesh);
  Messages messages(probe);
  probe->SetConeSetConnection(cones->GetOutputPort(0));
  probe->SetLightConnection(b->GetOutputPort());
  probe->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_SAYS(messages.Warnings, "made with other lights: light 0 is none of its 1");
}

TEST(SeveralLights, VectorsThatLeftOtherLightsAreSaid)
{
  const auto mesh = MeshBuilder().AddSquare(1.0, 0.6, 0).Build();
  const auto a = LampAt(-1.0);
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputData(mesh);
  vectors->SetLightConnection(a->GetOutputPort());
  vectors->SetNumberOfPhotons(1000);
  vectors->Update();
  vtkNew<vtkPolyData> wrong;
  wrong->DeepCopy(vectors->GetOutput(0));
  wrong->GetFieldData()->GetArray("LightCenter")->SetComponent(0, 0, 2.0);
  vtkNew<vtkConeSetFilter> cones;
  Messages messages(cones);
  cones->SetInputData(wrong);
  cones->SetExpansionToLightGeometry();
  cones->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_SAYS(messages.Warnings, "left a point that is not on it");
}
