// SPDX-License-Identifier: BSD-3-Clause
// The probe as a filter: every kind of data set, points and cells, pieces, threads, abort, and what it refuses.
#include "vtkConeSetProbe.h"

#include "Messages.h"
#include "ProvedCones.h"
#include "TestPolyData.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "vtkAreaLightSource.h"

#include "vtkAppendFilter.h"
#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

using namespace shadowcones;
using namespace testsupport;

namespace
{
const char* const arrays[] = { "Visibility", "ShadowClass", "OccluderId", "VisibilityError" };

/// A square of half size 0.5 at height 1; triangles with the ids 3 and 8, and a receiver at height 0.5.
vtkSmartPointer<vtkPolyData> Mesh()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double y : { 1.0, 0.5 })
  {
    points->InsertNextPoint(-0.5, y, -0.5);
    points->InsertNextPoint(0.5, y, -0.5);
    points->InsertNextPoint(0.5, y, 0.5);
    points->InsertNextPoint(-0.5, y, 0.5);
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 0, 2, 3 });
  polys->InsertNextCell({ 4, 5, 6, 7 });
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  AddIntArray(mesh->GetCellData(), "OccluderId", 1, { 3, 8, -1 });
  return mesh;
}

/// One cone that holds all of the square's shadow; its base is the disc through the square's corners.
vtkSmartPointer<vtkPolyData> BoundingCone()
{
  return ConeSetOf({ MakeCone({ 0.0, 1.0, 0.0 }, { 0.0, -1.0, 0.0 }, std::sqrt(0.5), std::atan(1.2), 5) });
}

/// A grid of points behind the square, through its umbra, its penumbra and lit space.
vtkSmartPointer<vtkImageData> Grid(int n = 9)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-2.0, -1.5, -2.0);
  image->SetSpacing(4.0 / (n - 1), 3.0 / (n - 1), 4.0 / (n - 1));
  return image;
}

class ConeSetProbe : public testing::Test
{
protected:
  ConeSetProbe()
  {
    this->Light->SetShapeToDisc();
    this->Light->SetCenter(0.0, 2.0, 0.0);
    this->Light->SetNormal(0.0, -1.0, 0.0);
    this->Light->SetRadius(0.3);
    this->Filter->SetInputData(Grid());
    this->Filter->SetConeSetData(BoundingCone());
    this->Filter->SetLightConnection(this->Light->GetOutputPort());
    this->Filter->SetMeshData(Mesh());
  }

  vtkSmartPointer<vtkDataSet> Probed(vtkDataSet* input)
  {
    this->Filter->SetInputData(input);
    this->Filter->Update();
    auto copy = vtkSmartPointer<vtkDataSet>::Take(this->Filter->GetOutput()->NewInstance());
    copy->DeepCopy(this->Filter->GetOutput());
    return copy;
  }

  /// Visibility at one point; what the other arrays hold in the members.
  double At(double x, double y, double z)
  {
    vtkNew<vtkPolyData> point;
    SetVertices(point, { x, y, z });
    const vtkSmartPointer<vtkDataSet> output = this->Probed(point);
    this->Class = static_cast<int>(output->GetPointData()->GetArray("ShadowClass")->GetComponent(0, 0));
    this->Occluder = static_cast<int>(output->GetPointData()->GetArray("OccluderId")->GetComponent(0, 0));
    this->Error = output->GetPointData()->GetArray("VisibilityError")->GetComponent(0, 0);
    return output->GetPointData()->GetArray("Visibility")->GetComponent(0, 0);
  }

  /// Update must fail with a message that holds the text, and leave no arrays.
  void ExpectError(const std::string& part)
  {
    Messages messages(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_NE(messages.Errors.find(part), std::string::npos) << "got: " << messages.Errors;
    EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkConeSetProbe> Filter;
  int Class = -1;
  int Occluder = -2;
  double Error = -1.0;
};

void ExpectSameBytes(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  for (const char* name : arrays)
  {
    vtkDataArray* one = a->GetArray(name);
    vtkDataArray* two = b->GetArray(name);
    ASSERT_NE(one, nullptr) << name;
    ASSERT_NE(two, nullptr) << name;
    ASSERT_EQ(one->GetNumberOfTuples(), two->GetNumberOfTuples()) << name;
    EXPECT_EQ(std::memcmp(one->GetVoidPointer(0), two->GetVoidPointer(0),
                static_cast<std::size_t>(one->GetNumberOfTuples() * one->GetDataTypeSize())),
      0)
      << name;
  }
}

vtkIdType CountClass(vtkDataSetAttributes* data, int value)
{
  vtkDataArray* classes = data->GetArray("ShadowClass");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < classes->GetNumberOfTuples(); ++i)
  {
    count += classes->GetComponent(i, 0) == value;
  }
  return count;
}
} // namespace

TEST_F(ConeSetProbe, KnowsUmbraPenumbraAndLight)
{
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 0.0);
  EXPECT_EQ(this->Class, 2);
  EXPECT_EQ(this->Occluder, 0) << "named 3";
  EXPECT_GT(this->Error, 0.0);
  EXPECT_EQ(this->At(-0.2, 0.7, 0.2), 0.0);
  EXPECT_EQ(this->Occluder, 1) << "named 8";
  // The edge of a square over a disc light, seen from below its border: half of the light.
  EXPECT_NEAR(this->At(1.0, 0.0, 0.3), 0.5, 0.04);
  EXPECT_EQ(this->Class, 1);
  EXPECT_EQ(this->Occluder, 0) << "named 3";
  EXPECT_EQ(this->At(-3.0, 0.0, 0.0), 1.0);
  EXPECT_EQ(this->Class, 0);
  EXPECT_EQ(this->Occluder, -1);
  EXPECT_EQ(this->Error, 0.0);
  // Behind the light.
  EXPECT_EQ(this->At(0.0, 2.5, 0.0), 0.0);
  EXPECT_EQ(this->Class, 2);
  EXPECT_EQ(this->Occluder, -1);

  this->Filter->SetMethodToSoft();
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 0.0);
  EXPECT_EQ(this->Occluder, 5);
  EXPECT_EQ(this->At(-3.0, 0.0, 0.0), 1.0);
}

TEST_F(ConeSetProbe, ReceiversCastNoShadow)
{
  // A point beside the square's shadow and below the receiver, once the cone is wide enough.
  vtkSmartPointer<vtkPolyData> cones = BoundingCone();
  cones->GetPointData()->GetArray("BaseRadius")->SetComponent(0, 0, 10.0);
  this->Filter->SetConeSetData(cones);
  vtkSmartPointer<vtkPolyData> mesh = Mesh();
  for (vtkIdType p = 4; p < 8; ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    mesh->GetPoints()->SetPoint(p, x[0] + 5.0, x[1], x[2]);
  }
  this->Filter->SetMeshData(mesh);
  EXPECT_EQ(this->At(6.4, 0.1, 0.0), 1.0);
  EXPECT_EQ(this->Occluder, -1);
  mesh->GetCellData()->GetArray("OccluderId")->SetComponent(2, 0, 9);
  mesh->Modified();
  EXPECT_EQ(this->At(6.4, 0.1, 0.0), 0.0);
  EXPECT_EQ(this->Occluder, 2) << "named 9, after 3 and 8";
}

TEST_F(ConeSetProbe, TakesEveryKindOfDataSet)
{
  const vtkSmartPointer<vtkImageData> image = Grid();
  const vtkSmartPointer<vtkDataSet> expected = this->Probed(image);
  EXPECT_STREQ(expected->GetClassName(), "vtkImageData");
  EXPECT_GT(CountClass(expected->GetPointData(), 1), 10);
  EXPECT_GT(CountClass(expected->GetPointData(), 2), 10);
  EXPECT_GT(CountClass(expected->GetPointData(), 0), 10);

  vtkNew<vtkAppendFilter> append;
  append->AddInputData(image);
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  append->Update();
  ExpectSameBytes(this->Probed(append->GetOutput())->GetPointData(), expected->GetPointData());

  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(9, 9, 9);
  structured->SetPoints(append->GetOutput()->GetPoints());
  ExpectSameBytes(this->Probed(structured)->GetPointData(), expected->GetPointData());

  vtkNew<vtkPolyData> particles;
  particles->SetPoints(append->GetOutput()->GetPoints());
  const vtkSmartPointer<vtkDataSet> probed = this->Probed(particles);
  EXPECT_STREQ(probed->GetClassName(), "vtkPolyData");
  ExpectSameBytes(probed->GetPointData(), expected->GetPointData());

  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(9, 9, 9);
  vtkNew<vtkDoubleArray> axes[3];
  for (int k = 0; k < 9; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      axes[axis]->InsertNextValue(image->GetOrigin()[axis] + k * image->GetSpacing()[axis]);
    }
  }
  rectilinear->SetXCoordinates(axes[0]);
  rectilinear->SetYCoordinates(axes[1]);
  rectilinear->SetZCoordinates(axes[2]);
  ExpectSameBytes(this->Probed(rectilinear)->GetPointData(), expected->GetPointData());
}

TEST_F(ConeSetProbe, CellsAreAskedAtTheirCentres)
{
  const vtkSmartPointer<vtkImageData> image = Grid();
  vtkNew<vtkCellCenters> centers;
  centers->SetInputData(image);
  centers->Update();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(image->GetNumberOfCells());
  vtkCellCenters::ComputeCellCenters(image, coordinates);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkPolyData> particles;
  particles->SetPoints(points);
  const vtkSmartPointer<vtkDataSet> expected = this->Probed(particles);
  this->Filter->SetAssociationToCells();
  const vtkSmartPointer<vtkDataSet> found = this->Probed(image);
  EXPECT_EQ(found->GetPointData()->GetNumberOfArrays(), 0);
  ExpectSameBytes(found->GetCellData(), expected->GetPointData());
  EXPECT_GT(CountClass(found->GetCellData(), 1), 5);
}

TEST_F(ConeSetProbe, ArraysAreOfTheDocumentedTypes)
{
  const vtkSmartPointer<vtkDataSet> output = this->Probed(Grid());
  const int types[] = { VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_INT, VTK_FLOAT };
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 4);
  for (int k = 0; k < 4; ++k)
  {
    vtkDataArray* array = output->GetPointData()->GetArray(arrays[k]);
    ASSERT_NE(array, nullptr);
    EXPECT_EQ(array->GetDataType(), types[k]) << arrays[k];
    EXPECT_EQ(array->GetNumberOfComponents(), 1);
    EXPECT_EQ(array->GetNumberOfTuples(), output->GetNumberOfPoints());
  }
}

TEST_F(ConeSetProbe, LeavesTheInputAlone)
{
  vtkSmartPointer<vtkPolyData> mesh = Mesh();
  AddIntArray(mesh->GetPointData(), "OccluderId", 1, { 1, 2, 3, 4, 5, 6, 7, 8 });
  AddFloatArray(mesh->GetFieldData(), "Note", 1, { 4.0f });
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(mesh);
  const vtkMTimeType before = mesh->GetMTime();
  this->Filter->SetMeshData(mesh);
  for (const bool atCells : { false, true })
  {
    this->Filter->SetAssociation(atCells);
    const vtkSmartPointer<vtkDataSet> output = this->Probed(mesh);
    EXPECT_NE(output->GetFieldData()->GetArray("Note"), nullptr);
    EXPECT_EQ(output->GetNumberOfCells(), 3);
  }
  EXPECT_EQ(mesh->GetMTime(), before);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 1);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    EXPECT_EQ(mesh->GetPointData()->GetArray("OccluderId")->GetComponent(i, 0), i + 1.0);
    EXPECT_EQ(
      std::memcmp(mesh->GetPoint(i), std::vector<double>(copy->GetPoint(i), copy->GetPoint(i) + 3).data(), 24), 0);
  }
}

TEST_F(ConeSetProbe, NormalsDecideOnSurfaces)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -1.0, -4.0);
  plane->SetPoint1(-4.0, -1.0, 4.0);
  plane->SetPoint2(4.0, -1.0, -4.0); // its normals point up
  plane->SetResolution(16, 16);
  plane->Update();
  const vtkSmartPointer<vtkDataSet> up = this->Probed(plane->GetOutput());
  EXPECT_GT(CountClass(up->GetPointData(), 0), 20);
  EXPECT_GT(CountClass(up->GetPointData(), 2), 5);
  vtkNew<vtkPolyData> down;
  down->DeepCopy(plane->GetOutput());
  for (vtkIdType i = 0; i < down->GetNumberOfPoints(); ++i)
  {
    down->GetPointData()->GetNormals()->SetTuple3(i, 0.0, -1.0, 0.0);
  }
  EXPECT_EQ(CountClass(this->Probed(down)->GetPointData(), 2), down->GetNumberOfPoints());
  this->Filter->UseNormalsOff();
  ExpectSameBytes(this->Probed(down)->GetPointData(), up->GetPointData());
}

TEST_F(ConeSetProbe, AClosedSurfaceHasNoAcne)
{
  // A sphere under the light: its lit cap is lit, its far side dark, in both methods.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  sphere->Update();
  this->Filter->SetMeshData(sphere->GetOutput());
  Cone cone;
  cone.Center = { 0.0, 0.5, 0.0 };
  cone.Axis = { 0.0, -1.0, 0.0 };
  cone.Normal = cone.Axis;
  cone.BaseRadius = 0.7;
  cone.HalfAngle = 0.5;
  vtkNew<vtkPolyData> cones;
  WriteConeSet({ cone }, cones);
  this->Filter->SetConeSetData(cones);
  const vtkSmartPointer<vtkDataSet> output = this->Probed(sphere->GetOutput());
  int lit = 0;
  int dark = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const double seen = output->GetPointData()->GetArray("Visibility")->GetComponent(i, 0);
    if (x[1] > 0.25)
    {
      EXPECT_EQ(seen, 1.0) << x[0] << " " << x[1] << " " << x[2];
      ++lit;
    }
    if (x[1] < -0.05)
    {
      EXPECT_EQ(seen, 0.0) << x[0] << " " << x[1] << " " << x[2];
      ++dark;
    }
  }
  EXPECT_GT(lit, 100);
  EXPECT_GT(dark, 100);
}

TEST_F(ConeSetProbe, CosineCorrectionIsTakenBackForSoft)
{
  this->Filter->SetMethodToSoft();
  vtkSmartPointer<vtkPolyData> wide = BoundingCone();
  wide->GetPointData()->GetArray("Normal")->SetTuple3(0, 0.6, -0.8, 0.0);
  this->Filter->SetConeSetData(wide);
  const vtkSmartPointer<vtkDataSet> expected = this->Probed(Grid());
  vtkNew<vtkPolyData> narrow;
  narrow->DeepCopy(wide);
  const double radius = wide->GetPointData()->GetArray("BaseRadius")->GetComponent(0, 0);
  narrow->GetPointData()->GetArray("BaseRadius")->SetComponent(0, 0, radius * 0.8);
  this->Filter->SetConeSetData(narrow);
  const vtkIdType less = CountClass(this->Probed(Grid())->GetPointData(), 2);
  AddIntArray(narrow->GetFieldData(), "CosineCorrection", 1, { 1 });
  narrow->Modified();
  const vtkSmartPointer<vtkDataSet> corrected = this->Probed(Grid());
  EXPECT_LT(less, CountClass(expected->GetPointData(), 2));
  EXPECT_EQ(CountClass(corrected->GetPointData(), 2), CountClass(expected->GetPointData(), 2));
}

TEST_F(ConeSetProbe, PartsOfTheInputGiveTheBytesOfTheWhole)
{
  for (const int method : { vtkConeSetProbe::Exact, vtkConeSetProbe::Soft })
  {
    this->Filter->SetMethod(method);
    const auto grid = Grid(17);
    const vtkSmartPointer<vtkDataSet> whole = this->Probed(grid);
    for (int part = 0; part < 4; ++part)
    {
      const vtkIdType begin = grid->GetNumberOfPoints() * part / 4;
      const vtkIdType end = grid->GetNumberOfPoints() * (part + 1) / 4;
      std::vector<double> points;
      for (vtkIdType i = begin; i < end; ++i)
      {
        points.insert(points.end(), grid->GetPoint(i), grid->GetPoint(i) + 3);
      }
      const vtkSmartPointer<vtkDataSet> output = this->Probed(PointsAt(points));
      for (vtkIdType i = begin; i < end; ++i)
      {
        for (const char* name : arrays)
        {
          ASSERT_EQ(output->GetPointData()->GetArray(name)->GetComponent(i - begin, 0),
            whole->GetPointData()->GetArray(name)->GetComponent(i, 0))
            << name << " " << i;
        }
      }
    }
  }
}

TEST_F(ConeSetProbe, PassesPieceRequestsToItsInput)
{
  // The sphere source makes pieces of itself; cones, light and mesh are needed as a whole for each.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(1.3, -0.5, 0.0);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(16);
  this->Filter->SetInputConnection(sphere->GetOutputPort());
  this->Filter->UpdatePiece(0, 1, 0);
  const vtkIdType whole = this->Filter->GetOutput()->GetNumberOfCells();
  const double inPenumbra = static_cast<double>(CountClass(this->Filter->GetOutput()->GetPointData(), 1));
  EXPECT_GT(inPenumbra, 0.0);
  vtkIdType cells = 0;
  for (int piece = 0; piece < 4; ++piece)
  {
    this->Filter->UpdatePiece(piece, 4, 0);
    cells += this->Filter->GetOutput()->GetNumberOfCells();
    EXPECT_LT(this->Filter->GetOutput()->GetNumberOfCells(), whole);
    EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Visibility")->GetNumberOfTuples(),
      this->Filter->GetOutput()->GetNumberOfPoints());
  }
  EXPECT_EQ(cells, whole);
}

TEST_F(ConeSetProbe, EmptyInputsAreValid)
{
  Messages messages(this->Filter);
  vtkNew<vtkPolyData> nothing;
  for (const int association : { 0, 1 })
  {
    this->Filter->SetAssociation(association);
    const vtkSmartPointer<vtkDataSet> output = this->Probed(nothing);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    vtkDataSetAttributes* data =
      association ? static_cast<vtkDataSetAttributes*>(output->GetCellData()) : output->GetPointData();
    EXPECT_EQ(data->GetNumberOfArrays(), 4);
  }
  this->Filter->SetAssociationToPoints();
  vtkNew<vtkPolyData> noCones;
  this->Filter->SetConeSetData(noCones);
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 1.0);
  this->Filter->SetMethodToSoft();
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 1.0);
  this->Filter->SetMethodToExact();
  this->Filter->SetConeSetData(BoundingCone());
  this->Filter->SetMeshData(nothing);
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 1.0);
  EXPECT_EQ(messages.Errors, "");
}

TEST_F(ConeSetProbe, SoftNeedsNoMesh)
{
  Messages messages(this->Filter);
  this->Filter->SetMeshConnection(nullptr);
  this->Filter->SetMethodToSoft();
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 0.0);
  EXPECT_EQ(messages.Errors, "");
}

TEST_F(ConeSetProbe, SaysWhatIsWrong)
{
  this->Filter->SetMethod(7);
  this->ExpectError("Method is 7");
  this->Filter->SetMethodToExact();
  this->Filter->SetAssociation(-1);
  this->ExpectError("Association is -1");
  this->Filter->SetAssociationToPoints();
  this->Filter->SetNumberOfLightSamples(0);
  this->ExpectError("NumberOfLightSamples is 0");
  this->Filter->SetNumberOfLightSamples(65537);
  this->ExpectError("NumberOfLightSamples is 65537");
  this->Filter->SetNumberOfLightSamples(64);

  this->Filter->SetMeshConnection(nullptr);
  this->ExpectError("Exact needs the mesh on input port 3");
  vtkNew<vtkPolyData> particles;
  SetVertices(particles, { 0.0, 0.0, 0.0 });
  this->Filter->SetMeshData(particles);
  this->ExpectError("no polygon");
  this->Filter->SetMeshData(Mesh());

  this->Filter->SetLightConnection(nullptr);
  this->ExpectError("No light on input port 2");
  this->Filter->SetLightData(particles);
  this->Filter->SetConeSetConnection(nullptr);
  this->Filter->SetMethodToSoft();
  this->ExpectError("No cone set on input port 1");
  this->Filter->SetMethodToExact();
  vtkNew<vtkPolyData> cones;
  SetVertices(cones, { 0.0, 0.0, 0.0 });
  this->Filter->SetConeSetData(cones);
  this->ExpectError("\"Axis\"");
  this->Filter->SetConeSetData(BoundingCone());

  SetVertices(particles, { 0.0, 0.0, 0.0, 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0 });
  this->Filter->SetInputData(particles);
  this->Filter->SetLightData(BoundingCone());
  this->ExpectError("Point 1 of the data set");
}

TEST_F(ConeSetProbe, ExactNeedsNoCones)
{
  const auto withCones = this->Probed(Grid());
  EXPECT_GT(CountClass(withCones->GetPointData(), 1), 0);
  this->Filter->SetConeSetConnection(nullptr);
  Messages messages(this->Filter);
  const auto without = this->Probed(Grid());
  EXPECT_EQ(messages.Errors + messages.Warnings, "");
  for (const char* name : { "Visibility", "ShadowClass", "OccluderId" })
  {
    vtkDataArray* one = withCones->GetPointData()->GetArray(name);
    vtkDataArray* two = without->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(one->GetComponent(i, 0), two->GetComponent(i, 0)) << name << " " << i;
    }
  }
  // A point alone has no extent: it is asked for all the same. Under the middle of the square, in its umbra.
  EXPECT_EQ(this->At(0.2, 0.7, -0.2), 0.0);
}

TEST_F(ConeSetProbe, BeyondTheBoundsOfAProofEveryPointIsAsked)
{
  // A cone set that is proved above y = 0 only, and holds nothing.
  Cone elsewhere;
  elsewhere.Center = { 50.0, 0.0, 0.0 };
  elsewhere.Axis = { 0.0, 1.0, 0.0 };
  elsewhere.Normal = elsewhere.Axis;
  vtkNew<vtkPolyData> cones;
  WriteConeSet({ elsewhere }, cones);
  CertifyIn({ { -3.0, 0.0, -3.0 }, { 3.0, 3.0, 3.0 } }, cones);
  this->Filter->SetConeSetData(cones);
  EXPECT_EQ(this->At(0.0, 0.2, 0.0), 1.0) << "as the cones say";
  EXPECT_LT(this->At(0.0, -0.2, 0.0), 1.0);
}

TEST_F(ConeSetProbe, AProvedSetThatWasEditedIsNotProved)
{
  const auto cones = ProvedConesOf(Mesh(), this->Light);
  this->Filter->SetConeSetData(cones);
  Messages messages(this->Filter);
  const auto certified = [this]()
  { return this->Probed(Grid())->GetFieldData()->GetArray("Certified")->GetComponent(0, 0); };
  EXPECT_EQ(certified(), 1.0);
  EXPECT_EQ(messages.Warnings, "");
  cones->GetPointData()->GetArray("HalfAngle")->SetComponent(0, 0, 0.01);
  this->Filter->Modified();
  EXPECT_EQ(certified(), 0.0);
  EXPECT_SAYS(messages.Warnings, "The cone set on input port 1 says that it is proved, but not of these cones");
  this->Filter->SetConeSetConnection(nullptr); // every point is asked
  EXPECT_EQ(certified(), 1.0);
}

TEST_F(ConeSetProbe, PrintsEveryParameter)
{
  std::ostringstream text;
  this->Filter->Print(text);
  for (const char* line :
    { "Method: Exact", "Association: Points", "NumberOfLightSamples: 64", "UseNormals: on", "Seed: 1" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
