// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowVolume: volumes that can be written down, closed manifolds of any cones, what VTK makes of them, messages.
#include "vtkShadowVolume.h"

#include "Messages.h"
#include "TestPolyData.h"
#include "TestSolids.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "scLightData.h"
#include "scRandom.h"

#include "vtkBooleanOperationPolyDataFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkClipClosedSurface.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
using Filter = vtkSmartPointer<vtkShadowVolume>;
using Data = vtkSmartPointer<vtkPolyData>;

Cone MakeCone(const Vector3& center, double radius, double outer, double inner, int occluderId = 0)
{
  Cone cone;
  cone.Center = center;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  cone.BaseRadius = radius;
  cone.HalfAngle = outer;
  cone.InnerHalfAngle = inner;
  cone.OccluderId = occluderId;
  return cone;
}

/// Cones in all directions, crowded enough that many of them meet, of five occluders.
std::vector<Cone> RandomCones(int count, std::uint64_t seed)
{
  RandomStream random(seed, 0);
  const auto vector = [&] { return Vector3{ random.Next() - 0.5, random.Next() - 0.5, random.Next() - 0.5 }; };
  std::vector<Cone> cones;
  for (int i = 0; i < count; ++i)
  {
    // One after the other: compilers differ in which argument of a call comes first.
    const double inner = -0.5 * random.Next();
    const double half = 0.6 * random.Next() - 0.2;
    const double radius = 0.1 * random.Next();
    Cone cone = MakeCone(vector(), radius, half, inner, 2 * (i % 5));
    cone.Axis = Normalized(vector());
    cones.push_back(cone);
  }
  return cones;
}

Filter Volume(vtkPolyData* cones, double length, int resolution = 64)
{
  auto filter = Filter::New();
  filter->SetInputData(cones);
  filter->SetLength(length);
  filter->SetResolution(resolution);
  filter->Update();
  return filter;
}

double Frustum(double height, double r0, double r1)
{
  return Pi * height / 3.0 * (r0 * r0 + r0 * r1 + r1 * r1);
}

std::vector<int> Ids(vtkPolyData* surface)
{
  std::vector<int> ids;
  vtkDataArray* array = surface->GetCellData()->GetArray("OccluderId");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return ids;
}

/// The triangles of one occluder.
Data Part(vtkPolyData* surface, int occluderId)
{
  auto part = Data::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::map<vtkIdType, vtkIdType> local;
  const auto ids = Ids(surface);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(i, count, corners);
    if (ids[i] != occluderId)
    {
      continue;
    }
    triangles->InsertNextCell(3);
    for (int k = 0; k < 3; ++k)
    {
      const auto added = local.emplace(corners[k], points->GetNumberOfPoints());
      if (added.second)
      {
        points->InsertNextPoint(surface->GetPoint(corners[k]));
      }
      triangles->InsertCellPoint(added.first->second);
    }
  }
  part->SetPoints(points);
  part->SetPolys(triangles);
  return part;
}

/// The message for a changed filter over one good cone; the outputs must be empty.
template <typename Change>
std::string Error(Change&& change)
{
  const Data cones = ConeSetOf({ MakeCone({}, 0.5, 0.2, -0.1, 7) });
  auto filter = Filter::New();
  filter->SetInputData(cones);
  change(filter.Get(), cones.Get());
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfCells(), 0);
  return messages.Errors;
}

void ExpectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}
} // namespace

TEST(ShadowVolume, VolumesOfOneCone)
{
  for (const double inner : { -0.3, 0.1 })
  {
    const Data cones = ConeSetOf({ MakeCone({ 1.0, 2.0, 3.0 }, 0.5, 0.4, inner, 3) });
    const double length = 2.0;
    for (const int resolution : { 32, 64, 96 })
    {
      const double tolerance = 0.96 / resolution; // one per cent at 96
      const Filter filter = Volume(cones, length, resolution);
      const double outer = Frustum(length, 0.5, 0.5 + length * std::tan(0.4));
      EXPECT_NEAR(ExpectSolid(filter->GetOutput(0)) / outer, 1.0, tolerance);
      EXPECT_NEAR(VolumeOf(filter->GetOutput(0)) / outer, 1.0, tolerance);
      const double tip = std::min(length, inner < 0.0 ? 0.5 / std::tan(-inner) : HUGE_VAL);
      const double umbra = Frustum(tip, 0.5, 0.5 + tip * std::tan(inner));
      EXPECT_NEAR(ExpectSolid(filter->GetOutput(1)) / umbra, 1.0, tolerance);
      EXPECT_EQ(Ids(filter->GetOutput(0)), std::vector<int>(filter->GetOutput(0)->GetNumberOfCells(), 3));
      EXPECT_EQ(Ids(filter->GetOutput(1)), std::vector<int>(filter->GetOutput(1)->GetNumberOfCells(), 3));
    }
  }
}

TEST(ShadowVolume, DiscsTogetherHideMoreThanEachAlone)
{
  // A disc of radius 0.5 out of seven overlapping ones, under a disc light of radius 0.2 two units away.
  Light light;
  light.Normal = { 0.0, 0.0, 1.0 };
  light.Radius = 0.2;
  light.Spectrum = { 1.0 };
  ASSERT_EQ(PrepareLight(light), nullptr);
  std::vector<Cone> seven = { MakeCone({ 0.0, 0.0, 2.0 }, 0.25, 0.2, -0.2) };
  for (int k = 0; k < 6; ++k)
  {
    const double angle = Pi * k / 3.0;
    seven.push_back(MakeCone({ 0.25 * std::cos(angle), 0.25 * std::sin(angle), 2.0 }, 0.25, 0.2, -0.2));
  }
  const auto umbra = [&](const std::vector<Cone>& cones, int method)
  {
    const Data coneSet = ConeSetOf(cones);
    WriteLightFieldData(light, coneSet);
    auto filter = Filter::New();
    filter->SetInputData(coneSet);
    filter->SetLength(1.0);
    filter->SetUmbra(method);
    filter->Update();
    return ExpectSolid(filter->GetOutput(1));
  };
  // One disc: the umbra that can be written down, from either method.
  const double radius = 0.5 + (0.5 - 0.2) / 2.0;
  const double exact = Frustum(1.0, 0.5, radius);
  const std::vector<Cone> one = { MakeCone({ 0.0, 0.0, 2.0 }, 0.5, 0.3, std::atan(0.15)) };
  EXPECT_NEAR(umbra(one, vtkShadowVolume::InnerCones) / exact, 1.0, 0.015);
  EXPECT_NEAR(umbra(one, vtkShadowVolume::BaseDiscs) / exact, 1.0, 0.025);
  // The flower's shape: between its inscribed circle (where petals meet) and its circumscribed one.
  const double alone = umbra(seven, vtkShadowVolume::InnerCones);
  const double together = umbra(seven, vtkShadowVolume::BaseDiscs);
  EXPECT_GT(together, 2.0 * alone);
  EXPECT_LT(together, exact);
  EXPECT_GT(together, Frustum(1.0, 0.433, 0.433 + 0.5 * (0.433 - 0.2)));
}

TEST(ShadowVolume, BoundsCloseTheSurface)
{
  const Data cones = ConeSetOf({ MakeCone({}, 0.5, 0.2, -0.2) });
  auto filter = Filter::New();
  filter->SetInputData(cones);
  filter->SetBounds(0.0, 4.0, -4.0, 4.0, -1.0, 1.5);
  filter->Update();
  EXPECT_NEAR(ExpectSolid(filter->GetOutput(0)) / (0.5 * Frustum(1.5, 0.5, 0.5 + 1.5 * std::tan(0.2))), 1.0, 0.01);
  double bounds[6];
  filter->GetOutput(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 0.0, 1e-6);
  EXPECT_NEAR(bounds[4], 0.0, 1e-6);
  EXPECT_NEAR(bounds[5], 1.5, 1e-6);

  filter->SetLength(0.5); // cuts before the box does
  filter->Update();
  EXPECT_NEAR(filter->GetOutput(0)->GetBounds()[5], 0.5, 1e-6);

  filter->SetBounds(10.0, 11.0, 10.0, 11.0, 10.0, 11.0); // no shadow there
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
}

TEST(ShadowVolume, LengthWithoutBoundsIsTheDiagonalOfTheBases)
{
  const Data cones = ConeSetOf({ MakeCone({}, 0.5, 0.0, 0.0), MakeCone({ 3.0, 0.0, 0.0 }, 0.5, 0.0, 0.0) });
  const Filter filter = Volume(cones, 0.0);
  EXPECT_NEAR(filter->GetOutput(0)->GetBounds()[5], std::sqrt(16.0 + 1.0 + 1.0), 0.02);
}

TEST(ShadowVolume, AnyConesGiveClosedManifolds)
{
  for (const int resolution : { 4, 9, 17, 30 })
  {
    const Data cones = ConeSetOf(RandomCones(150, static_cast<std::uint64_t>(resolution)));
    auto filter = Volume(cones, 0.7, resolution);
    filter->SetBounds(-0.4, 0.6, -0.5, 0.45, -0.3, 0.7);
    filter->PerOccluderOff();
    filter->Update();
    EXPECT_GT(ExpectSolid(filter->GetOutput(0)), 0.1);
    EXPECT_GT(ExpectSolid(filter->GetOutput(1)), 0.0);

    filter->PerOccluderOn();
    filter->Update();
    for (const int occluder : { 0, 2, 4, 6, 8 })
    {
      EXPECT_GT(ExpectSolid(Part(filter->GetOutput(0), occluder)), 0.01);
      EXPECT_GT(ExpectSolid(Part(filter->GetOutput(1), occluder)), 0.0);
    }
  }
}

TEST(ShadowVolume, OneSurfaceAnOccluder)
{
  const Data cones = ConeSetOf({ MakeCone({}, 0.5, 0.1, -0.1, 9), MakeCone({ 0.3, 0.0, 0.0 }, 0.5, 0.1, -0.1, 4),
    MakeCone({ 0.0, 0.2, 0.0 }, 0.5, 0.1, -0.1, 9) });
  auto filter = Volume(cones, 1.0);
  const Data both = filter->GetOutput(0);
  const auto ids = Ids(both);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(std::set<int>(ids.begin(), ids.end()), (std::set<int>{ 4, 9 }));
  const double four = ExpectSolid(Part(both, 4));
  const double nine = ExpectSolid(Part(both, 9));
  EXPECT_NEAR(four / Frustum(1.0, 0.5, 0.5 + std::tan(0.1)), 1.0, 0.02);
  EXPECT_GT(nine, 1.1 * four);

  filter->PerOccluderOff();
  filter->Update();
  const double joint = ExpectSolid(filter->GetOutput(0));
  EXPECT_GT(joint, nine);
  EXPECT_LT(joint, 0.8 * (four + nine));
  EXPECT_EQ(Ids(filter->GetOutput(0)).front(), -1);
  EXPECT_EQ(Ids(filter->GetOutput(0)).back(), -1);
}

TEST(ShadowVolume, FarAwayAndTiny)
{
  const double reference = ExpectSolid(Volume(ConeSetOf({ MakeCone({}, 0.5, 0.4, -0.3) }), 2.0)->GetOutput());
  const Data far = ConeSetOf({ MakeCone({ 1e6, -1e6, 1e6 }, 0.5, 0.4, -0.3) });
  EXPECT_NEAR(ExpectSolid(Volume(far, 2.0)->GetOutput()) / reference, 1.0, 1e-5);
  const Data tiny = ConeSetOf({ MakeCone({}, 0.5e-3, 0.4, -0.3) });
  EXPECT_NEAR(ExpectSolid(Volume(tiny, 2e-3)->GetOutput()) / (1e-9 * reference), 1.0, 1e-5);
}

TEST(ShadowVolume, BooleanOperations)
{
  const Filter filter = Volume(ConeSetOf({ MakeCone({}, 0.5, 0.3, -0.2) }), 1.5, 16);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.3131, 3.0, -3.0, 3.0, -1.0, 1.2171);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  const double whole = VolumeOf(filter->GetOutput());
  double parts = 0.0;
  for (const int operation :
    { vtkBooleanOperationPolyDataFilter::VTK_INTERSECTION, vtkBooleanOperationPolyDataFilter::VTK_DIFFERENCE })
  {
    vtkNew<vtkBooleanOperationPolyDataFilter> boolean;
    boolean->SetInputData(0, filter->GetOutput());
    boolean->SetInputData(1, triangles->GetOutput());
    boolean->SetOperation(operation);
    boolean->Update();
    const double volume = VolumeOf(boolean->GetOutput());
    EXPECT_GT(volume, 0.2 * whole);
    EXPECT_LT(volume, 0.8 * whole);
    parts += volume;
  }
  EXPECT_NEAR(parts / whole, 1.0, 1e-3);
}

TEST(ShadowVolume, ClipClosedSurface)
{
  const Filter filter = Volume(ConeSetOf({ MakeCone({}, 0.5, 0.3, -0.2) }), 1.5);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetNormal(1.0, 0.3, 0.1);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  double parts = 0.0;
  for (int side = 0; side < 2; ++side)
  {
    vtkNew<vtkClipClosedSurface> clip;
    clip->SetInputConnection(filter->GetOutputPort(0));
    clip->SetClippingPlanes(planes);
    clip->Update();
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(clip->GetOutputPort());
    triangles->Update();
    EXPECT_EQ(Edges(triangles->GetOutput(), true), 0);
    EXPECT_GT(VolumeOf(triangles->GetOutput()), 0.2);
    parts += VolumeOf(triangles->GetOutput());
    plane->SetNormal(-1.0, -0.3, -0.1);
  }
  EXPECT_NEAR(parts / VolumeOf(filter->GetOutput()), 1.0, 1e-6);
}

TEST(ShadowVolume, EmptyAndFlatInputs)
{
  auto filter = Filter::New();
  Messages messages(filter);
  filter->SetInputData(ConeSetOf({}));
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_TRUE(filter->GetOutput(0)->GetCellData()->GetArray("OccluderId"));

  // A line has no volume; its neighbour has.
  filter->SetInputData(ConeSetOf({ MakeCone({}, 0.0, 0.0, 0.0, 1), MakeCone({}, 0.2, 0.1, -0.1, 2) }));
  filter->Update();
  EXPECT_EQ(Ids(filter->GetOutput(0)).front(), 2);
  EXPECT_EQ(messages.Errors, "");
}

TEST(ShadowVolume, FieldDataIsThatOfTheConeSet)
{
  const Data cones = ConeSetOf({ MakeCone({}, 0.5, 0.2, -0.1) });
  AddIntArray(cones->GetFieldData(), "Seed", 1, { 5 });
  const Filter filter = Volume(cones, 1.0, 8);
  EXPECT_EQ(filter->GetOutput(0)->GetFieldData()->GetArray("Seed")->GetComponent(0, 0), 5.0);
  EXPECT_EQ(filter->GetOutput(1)->GetFieldData()->GetArray("Seed")->GetComponent(0, 0), 5.0);
}

TEST(ShadowVolume, Messages)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int resolution : { 3, 1025 })
  {
    ExpectHas(Error([=](vtkShadowVolume* f, vtkPolyData*) { f->SetResolution(resolution); }), "Resolution is");
  }
  for (const double length : { -1.0, nan, HUGE_VAL })
  {
    ExpectHas(Error([=](vtkShadowVolume* f, vtkPolyData*) { f->SetLength(length); }), "Length is");
  }
  ExpectHas(
    Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetBounds(0, 1, 1, 0, 0, 1); }), "Bounds along y run from 1 to 0");
  ExpectHas(Error([=](vtkShadowVolume* f, vtkPolyData*) { f->SetBounds(0, 1, 0, nan, 0, 1); }),
    "Bounds along y run from 0 to nan");
  ExpectHas(Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetBounds(0, 1, 2, 2, 0, 1); }),
    "Bounds are flat: they must enclose a volume.");
  ExpectHas(Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetUmbra(2); }), "Umbra is 2");
  ExpectHas(Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetUmbraToBaseDiscs(); }), "does not carry the light");
  ExpectHas(Error([](vtkShadowVolume*, vtkPolyData* c) { c->GetPointData()->RemoveArray("Axis"); }), "Axis");
  ExpectHas(Error(
              [](vtkShadowVolume* f, vtkPolyData*)
              {
                f->SetResolution(1024);
                f->SetBounds(-1, 1, -1, 1, 0, 2);
              }),
    "The outer bound of occluder 7 needs");
  ExpectHas(Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetLength(1e308); }), "beyond double precision");
  ExpectHas(
    Error([](vtkShadowVolume* f, vtkPolyData*) { f->SetInputData(ConeSetOf({ MakeCone({}, 0.0, 0.2, -0.1) })); }),
    "set Length or Bounds");
}

TEST(ShadowVolume, PrintsEveryMember)
{
  std::ostringstream text;
  Filter::New()->Print(text);
  for (const char* part :
    { "Resolution: 64", "Bounds: 1, -1, 1, -1, 1, -1", "Length: 0", "Umbra: InnerCones", "PerOccluder: on" })
  {
    ExpectHas(text.str(), part);
  }
}
