// SPDX-License-Identifier: BSD-3-Clause
// vtkConeSetGeometry: surfaces that lie on their cones, cuts, and a message for each fault.
#include "Messages.h"
#include "TestPolyData.h"
#include "scConeData.h"
#include "scFieldArrays.h"
#include "vtkConeSetGeometry.h"

#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

using namespace shadowcones::testsupport;
using shadowcones::Cone;
using shadowcones::Cross;
using shadowcones::Dot;
using shadowcones::Length;
using shadowcones::Vector3;

namespace
{

std::vector<Cone> ThreeCones()
{
  std::vector<Cone> cones(3);
  cones[0].Axis = { 0.0, 0.0, -1.0 };
  cones[0].BaseRadius = 0.5;
  cones[0].HalfAngle = 0.3;
  cones[0].InnerHalfAngle = -0.4;
  cones[1].Center = { 2.0, 0.0, 1.0 };
  cones[1].Axis = Normalized(Vector3{ 0.3, 0.1, -1.0 });
  cones[1].BaseRadius = 0.25;
  cones[1].HalfAngle = 0.0;
  cones[1].InnerHalfAngle = 0.0;
  cones[2].Center = { 0.0, 3.0, 0.5 };
  cones[2].Axis = Normalized(Vector3{ 0.0, -0.4, -1.0 });
  cones[2].BaseRadius = 0.4;
  cones[2].HalfAngle = -0.5;
  cones[2].InnerHalfAngle = -0.7;
  for (std::size_t i = 0; i < 3; ++i)
  {
    cones[i].Normal = cones[i].Axis;
    cones[i].OccluderId = 10 + static_cast<int>(i);
  }
  return cones;
}

vtkSmartPointer<vtkPolyData> FittedSet(const std::vector<Cone>& cones)
{
  auto set = ConeSetOf(cones);
  shadowcones::AddIntArray(set->GetFieldData(), "NumberOfNeighbors", 1, { 100 });
  return set;
}

/// How far a point is off the surface of a cone that opens by @p halfAngle.
double OffSurface(const Cone& cone, double halfAngle, const double* p)
{
  const Vector3 offset = Vector3{ p[0], p[1], p[2] } - cone.Center;
  const double h = Dot(offset, cone.Axis);
  return std::abs(Length(Cross(offset, cone.Axis)) - (cone.BaseRadius + h * std::tan(halfAngle)));
}

double Height(const Cone& cone, const double* p)
{
  return Dot(Vector3{ p[0], p[1], p[2] } - cone.Center, cone.Axis);
}

std::string FaultOf(vtkPolyData* input, const std::function<void(vtkConeSetGeometry*)>& change = {})
{
  vtkNew<vtkConeSetGeometry> filter;
  filter->SetInputData(input);
  if (change)
  {
    change(filter);
  }
  Messages messages(filter);
  filter->Update();
  for (int port = 0; port < 3; ++port)
  {
    EXPECT_EQ(filter->GetOutput(port)->GetNumberOfCells(), 0);
  }
  return messages.Errors;
}

} // namespace

TEST(ConeSetGeometry, SurfacesLieOnTheirCones)
{
  const std::vector<Cone> cones = ThreeCones();
  vtkNew<vtkConeSetGeometry> filter;
  filter->SetInputData(FittedSet(cones));
  filter->SetLength(1.5);
  filter->SetResolution(12);
  filter->Update();
  for (const int port : { 0, 2 })
  {
    vtkPolyData* surface = filter->GetOutput(port);
    ASSERT_EQ(surface->GetNumberOfCells(), 3 * 12);
    vtkDataArray* ids = ArrayOf(surface->GetCellData(), "ConeId", VTK_ID_TYPE, 1);
    ArrayOf(surface->GetPointData(), "Normals", VTK_FLOAT, 3);
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    double top[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      const auto id = static_cast<std::size_t>(ids->GetTuple1(cell));
      EXPECT_EQ(id, static_cast<std::size_t>(cell / 12));
      EXPECT_EQ(surface->GetCellData()->GetArray("OccluderId")->GetTuple1(cell), 10.0 + static_cast<double>(id));
      vtkNew<vtkIdList> points;
      surface->GetCellPoints(cell, points);
      ASSERT_EQ(points->GetNumberOfIds(), 4);
      double face[3];
      vtkPolygon::ComputeNormal(surface->GetPoints(), 4, points->GetPointer(0), face);
      const double angle = port == 0 ? cones[id].HalfAngle : cones[id].InnerHalfAngle;
      for (vtkIdType k = 0; k < 4; ++k)
      {
        const vtkIdType point = points->GetId(k);
        double p[3];
        surface->GetPoint(point, p);
        EXPECT_LT(OffSurface(cones[id], angle, p), 1e-6);
        EXPECT_GE(Height(cones[id], p), -1e-6);
        top[id] = std::max(top[id], Height(cones[id], p));
        // Winding and normals both point outward.
        EXPECT_GT(face[0] * normals->GetComponent(point, 0) + face[1] * normals->GetComponent(point, 1) +
            face[2] * normals->GetComponent(point, 2),
          0.9);
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double angle = port == 0 ? cones[i].HalfAngle : cones[i].InnerHalfAngle;
      const double tip = angle < 0.0 ? cones[i].BaseRadius / std::tan(-angle) : 1e9;
      EXPECT_NEAR(top[i], std::min(1.5, tip), 1e-6);
    }
    EXPECT_EQ(FieldValue(surface, "NumberOfNeighbors"), 100.0);
  }
}

TEST(ConeSetGeometry, BasesAreDiscsThatFaceTheLight)
{
  const std::vector<Cone> cones = ThreeCones();
  vtkNew<vtkConeSetGeometry> filter;
  filter->SetInputData(FittedSet(cones));
  filter->SetResolution(60);
  filter->Update();
  vtkPolyData* bases = filter->GetOutput(1);
  ASSERT_EQ(bases->GetNumberOfCells(), 3);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    vtkNew<vtkIdList> points;
    bases->GetCellPoints(cell, points);
    ASSERT_EQ(points->GetNumberOfIds(), 60);
    double face[3];
    vtkPolygon::ComputeNormal(bases->GetPoints(), 60, points->GetPointer(0), face);
    const Cone& cone = cones[static_cast<std::size_t>(cell)];
    EXPECT_NEAR(Dot({ face[0], face[1], face[2] }, cone.Axis), -1.0, 1e-6);
    for (vtkIdType k = 0; k < 60; ++k)
    {
      double p[3];
      bases->GetPoint(points->GetId(k), p);
      EXPECT_NEAR(Length(Vector3{ p[0], p[1], p[2] } - cone.Center), cone.BaseRadius, 1e-6);
      EXPECT_NEAR(Height(cone, p), 0.0, 1e-6);
    }
  }
}

TEST(ConeSetGeometry, IsCutByPlaneAndBox)
{
  vtkNew<vtkConeSetGeometry> filter;
  std::vector<Cone> cones = ThreeCones();
  cones.pop_back(); // its tip comes first
  filter->SetInputData(FittedSet(cones));
  filter->SetCutToPlane();
  filter->SetPlaneOrigin(5.0, 5.0, -1.0);
  filter->SetPlaneNormal(0.0, 0.0, 3.0);
  filter->Update();
  EXPECT_NEAR(filter->GetOutput(0)->GetBounds()[4], -1.0, 1e-9);
  int atPlane = 0;
  for (vtkIdType i = 0; i < filter->GetOutput(0)->GetNumberOfPoints(); ++i)
  {
    atPlane += std::abs(filter->GetOutput(0)->GetPoint(i)[2] + 1.0) < 1e-9;
  }
  EXPECT_EQ(atPlane, 2 * 24); // every line of both cones ends there

  filter->SetCutToBox();
  filter->SetBoxBounds(-1.0, 2.5, -1.0, 1.0, -0.7, 1.5);
  filter->Update();
  double bounds[6];
  filter->GetOutput(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[4], -0.7, 1e-9);
  EXPECT_LE(bounds[1], 2.5 + 1e-9);

  filter->SetCutToLength();
  filter->SetLength(0.0); // the diagonal of the set's bounds: from (0, 0, 0) to (2, 0, 1)
  filter->Update();
  double deepest = 0.0;
  for (vtkIdType i = 0; i < 2 * 24; ++i)
  {
    deepest = std::max(deepest, Height(cones[0], filter->GetOutput(0)->GetPoint(i)));
  }
  EXPECT_NEAR(deepest, std::sqrt(5.0), 1e-9);
}

TEST(ConeSetGeometry, ASetOfOneOrNoConeIsFine)
{
  vtkNew<vtkConeSetGeometry> filter;
  std::vector<Cone> cones = ThreeCones();
  cones.resize(1);
  filter->SetInputData(FittedSet(cones));
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 24);
  // One cone has no diagonal: something must be seen all the same.
  EXPECT_GT(filter->GetOutput(0)->GetBounds()[5] - filter->GetOutput(0)->GetBounds()[4], 0.1);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(messages.Errors, "");
  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "Cut: Length", "Length: 0", "PlaneOrigin: 0, 0, 0", "PlaneNormal: 0, 1, 0",
         "BoxBounds: -1, 1, -1, 1, -1, 1", "Resolution: 24" })
  {
    EXPECT_SAYS(text.str(), line);
  }
}

TEST(ConeSetGeometryErrors, AConeSetFromElsewhere)
{
  for (const char* name : { "Axis", "BaseRadius", "HalfAngle" })
  {
    const auto set = FittedSet(ThreeCones());
    set->GetPointData()->RemoveArray(name);
    EXPECT_SAYS(FaultOf(set), std::string("The cone set has no array \"") + name + "\"");
  }
  // What is not required is made up.
  const auto bare = FittedSet(ThreeCones());
  for (const char* name : { "InnerHalfAngle", "Normal", "OccluderId", "VectorCount", "Planarity", "Overspill" })
  {
    bare->GetPointData()->RemoveArray(name);
  }
  vtkNew<vtkConeSetGeometry> filter;
  filter->SetInputData(bare);
  filter->Update();
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 3 * 24);

  auto set = FittedSet(ThreeCones());
  set->GetPointData()->GetArray("Axis")->SetTuple3(1, 0.0, 0.0, 0.0);
  EXPECT_SAYS(FaultOf(set), "\"Axis\" of cone 1");
  set = FittedSet(ThreeCones());
  set->GetPointData()->GetArray("BaseRadius")->SetTuple1(2, -1.0);
  EXPECT_SAYS(FaultOf(set), "\"BaseRadius\" of cone 2");
  set = FittedSet(ThreeCones());
  set->GetPointData()->GetArray("HalfAngle")->SetTuple1(0, 1.6);
  EXPECT_SAYS(FaultOf(set), "\"HalfAngle\" of cone 0");
  set = FittedSet(ThreeCones());
  set->GetPoints()->SetPoint(1, std::nan(""), 0.0, 0.0);
  EXPECT_SAYS(FaultOf(set), "position of cone 1 is not finite");
  set = FittedSet(ThreeCones());
  vtkNew<vtkFloatArray> shortArray;
  shortArray->SetName("Mine");
  shortArray->SetNumberOfTuples(2);
  set->GetPointData()->AddArray(shortArray);
  EXPECT_SAYS(FaultOf(set), "\"Mine\" has 2 tuples where 3 are needed");
}

TEST(ConeSetGeometryErrors, BadParameters)
{
  const auto set = FittedSet(ThreeCones());
  EXPECT_SAYS(FaultOf(set, [](vtkConeSetGeometry* f) { f->SetResolution(2); }), "Resolution is 2");
  EXPECT_SAYS(FaultOf(set, [](vtkConeSetGeometry* f) { f->SetCut(3); }), "Cut is 3");
  EXPECT_SAYS(FaultOf(set,
                [](vtkConeSetGeometry* f)
                {
                  f->SetCutToPlane();
                  f->SetPlaneNormal(0.0, 0.0, 0.0);
                }),
    "PlaneNormal is (0, 0, 0)");
  EXPECT_SAYS(FaultOf(set, [](vtkConeSetGeometry* f) { f->SetLength(-1.0); }), "Length is -1");
  EXPECT_SAYS(FaultOf(set, [](vtkConeSetGeometry* f) { f->SetLength(std::nan("")); }), "Length is");
  EXPECT_SAYS(FaultOf(set,
                [](vtkConeSetGeometry* f)
                {
                  f->SetCutToBox();
                  f->SetBoxBounds(1.0, -1.0, -1.0, 1.0, -1.0, 1.0);
                }),
    "BoxBounds");
}
