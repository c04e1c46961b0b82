// SPDX-License-Identifier: BSD-3-Clause
// The visibility volume as image data: arrays, bounds, bricks, files, extents, and a message for each fault.
#include "vtkVisibilityVolume.h"

#include "ImageTesting.h"
#include "ProvedCones.h"

#include "scConeData.h"
#include "scFieldArrays.h"
#include "scVisibilityData.h"
#include "vtkAreaLightSource.h"
#include "vtkScatteringImageFilter.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageReslice.h"
#include "vtkImageShrink3D.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

using namespace imagetesting;

namespace
{

vtkSmartPointer<vtkPolyData> Plate()
{
  return Plane({ -0.6, 0.43, -0.5 }, { 1.2, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
}

vtkSmartPointer<vtkPolyData> PlateCone(double height = 0.43)
{
  return ConeSetOf({ MakeCone({ 0.0, height, 0.0 }, { 0.0, -1.0, 0.0 }, 0.8, std::atan(1.2 / 1.57), 0) });
}

class VisibilityVolume : public testing::Test
{
protected:
  VisibilityVolume()
  {
    SetLamp(this->Light);
    this->Filter->SetInputData(PlateCone());
    this->Filter->SetLightConnection(this->Light->GetOutputPort());
    this->Filter->SetMeshData(Plate());
    this->Filter->SetDimensions(15, 21, 13);
    this->Filter->SetBounds(-1.0, 1.0, -1.0, 1.5, -1.1, 1.2);
  }

  vtkSmartPointer<vtkImageData> Volume() { return CopyOfOutput(this->Filter); }
  shadowcones::VisibilityGrid Read(vtkImageData* volume)
  {
    shadowcones::VisibilityGrid grid;
    std::string error;
    EXPECT_TRUE(shadowcones::ReadVisibilityGrid(volume, grid, error, this->Warning)) << error;
    return grid;
  }
  void ExpectError(const std::string& part) { ExpectNoImage(this->Filter, part); }
  /// Reading a volume after a change must fail with a sentence that holds the text.
  void ExpectUnreadable(const std::string& part, const std::function<void(vtkImageData*)>& change)
  {
    const auto volume = this->Volume();
    change(volume);
    shadowcones::VisibilityGrid grid;
    std::string error;
    EXPECT_FALSE(shadowcones::ReadVisibilityGrid(volume, grid, error, this->Warning)) << part;
    EXPECT_NE(error.find(part), std::string::npos) << "got: " << error;
  }

  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkVisibilityVolume> Filter;
  std::string Warning; ///< of the last volume that was read
};

/// Every point of an image has the values that the volume has at that place.
void ExpectPartOf(vtkImageData* part, vtkImageData* volume, vtkIdType points)
{
  ASSERT_EQ(part->GetNumberOfPoints(), points);
  vtkDataArray* values = part->GetPointData()->GetScalars();
  ASSERT_NE(values, nullptr);
  vtkDataArray* all = volume->GetPointData()->GetArray("Visibility");
  int different = 0;
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    part->GetPoint(i, p);
    const vtkIdType there = volume->FindPoint(p);
    double q[3];
    volume->GetPoint(std::max<vtkIdType>(there, 0), q);
    const double away = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    different += there < 0 || away > 1e-9 || std::abs(values->GetComponent(i, 0) - all->GetComponent(there, 0)) > 1e-6;
  }
  EXPECT_EQ(different, 0);
}

void ExpectSameGrids(const shadowcones::VisibilityGrid& a, const shadowcones::VisibilityGrid& b)
{
  EXPECT_EQ(a.Dimensions, b.Dimensions);
  EXPECT_NEAR(shadowcones::Length(a.Origin - b.Origin), 0.0, 1e-12);
  EXPECT_NEAR(shadowcones::Length(a.Spacing - b.Spacing), 0.0, 1e-12);
  EXPECT_EQ(a.Visibility, b.Visibility);
  EXPECT_EQ(a.ShadowClasses, b.ShadowClasses);
  EXPECT_EQ(a.Marked, b.Marked);
  EXPECT_EQ(a.BrickParts, b.BrickParts);
  EXPECT_EQ(a.BrickCells, b.BrickCells);
  EXPECT_EQ(a.BrickVisibility, b.BrickVisibility);
}

} // anonymous namespace

TEST_F(VisibilityVolume, HasTheDocumentedArrays)
{
  const auto cones = PlateCone();
  shadowcones::AddIntArray(cones->GetFieldData(), "NumberOfCones", 1, { 1 });
  this->Filter->SetInputData(cones);
  const auto volume = this->Volume();
  vtkPointData* points = volume->GetPointData();
  ASSERT_EQ(points->GetNumberOfArrays(), 3);
  EXPECT_STREQ(points->GetScalars()->GetName(), "Visibility");
  EXPECT_EQ(points->GetArray("Visibility")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(points->GetArray("ShadowClass")->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(points->GetArray("Marked")->GetDataType(), VTK_UNSIGNED_CHAR);
  double range[2];
  points->GetArray("ShadowClass")->GetRange(range);
  EXPECT_EQ(range[1], 2.0); // there is umbra
  const int* dimensions = volume->GetDimensions();
  EXPECT_EQ(dimensions[0], 15);
  EXPECT_EQ(dimensions[1], 21);
  EXPECT_EQ(dimensions[2], 13);
  const double* bounds = volume->GetBounds();
  EXPECT_NEAR(bounds[0], -1.0, 1e-12);
  EXPECT_NEAR(bounds[3], 1.5, 1e-12);
  EXPECT_NEAR(bounds[5], 1.2, 1e-12);
  vtkFieldData* field = volume->GetFieldData();
  EXPECT_EQ(field->GetArray("BrickParts")->GetComponent(0, 0), 2.0);
  EXPECT_EQ(field->GetArray("BrickVisibility")->GetNumberOfComponents(), 27);
  EXPECT_GT(field->GetArray("BrickCells")->GetNumberOfTuples(), 10);
  EXPECT_GT(field->GetArray("NumberOfOcclusionRays")->GetComponent(0, 0), 1000.0);
  EXPECT_EQ(field->GetArray("Seed")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(field->GetArray("NumberOfCones"), nullptr); // nothing of the cone set's own
}

TEST_F(VisibilityVolume, UnsetBoundsAreThoseOfTheMedium)
{
  this->Filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputData(Plate());
  image->SetLightConnection(this->Light->GetOutputPort());
  image->SetResolution(2, 2);
  image->Update();
  vtkDataArray* medium = image->GetOutput()->GetFieldData()->GetArray("MediumBounds");
  const auto exact = this->Volume();
  this->Filter->SetMethodToSoft();
  const auto soft = this->Volume();
  this->Filter->SetMeshConnection(nullptr);
  const auto alone = this->Volume();
  for (int side = 0; side < 6; ++side)
  {
    EXPECT_NEAR(exact->GetBounds()[side], medium->GetComponent(0, side), 1e-9);
    EXPECT_NEAR(soft->GetBounds()[side], medium->GetComponent(0, side), 1e-9);
  }
  // From the cone's base and the light.
  EXPECT_NEAR(alone->GetBounds()[0], -0.44, 1e-6);
  EXPECT_NEAR(alone->GetBounds()[2], 0.43 - 0.05 * 1.57, 1e-6);
}

TEST_F(VisibilityVolume, SoftNeedsNoMesh)
{
  this->Filter->SetMethodToSoft();
  this->Filter->SetMeshConnection(nullptr);
  const auto volume = this->Volume();
  double range[2];
  volume->GetPointData()->GetArray("Visibility")->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(volume->GetFieldData()->GetArray("NumberOfOcclusionRays")->GetComponent(0, 0), 0.0);
}

TEST_F(VisibilityVolume, ReceiversCastNoShadow)
{
  const auto mesh = Plate();
  vtkNew<vtkIntArray> ids;
  ids->SetName("OccluderId");
  ids->InsertNextValue(-1);
  mesh->GetCellData()->AddArray(ids);
  this->Filter->SetMeshData(mesh);
  double range[2];
  this->Volume()->GetPointData()->GetArray("Visibility")->GetRange(range);
  EXPECT_EQ(range[0], 1.0);
}

TEST_F(VisibilityVolume, SurvivesAFile)
{
  const auto volume = this->Volume();
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(volume);
  writer->WriteToOutputStringOn();
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  const shadowcones::VisibilityGrid grid = this->Read(volume);
  EXPECT_GT(grid.BrickCells.size(), 10u);
  ExpectSameGrids(grid, this->Read(reader->GetOutput()));
}

TEST_F(VisibilityVolume, ReadsWhatWasWritten)
{
  const shadowcones::VisibilityGrid grid = this->Read(this->Volume());
  const int whole[6] = { 0, 14, 0, 20, 0, 12 };
  vtkNew<vtkImageData> copy;
  shadowcones::WriteVisibilityGrid(grid, whole, copy);
  ExpectSameGrids(grid, this->Read(copy));
}

TEST_F(VisibilityVolume, AnyImageWithVisibilityIsAVolume)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(3, 5, 0, 1, -2, -1);
  image->SetSpacing(0.5, 1.0, 2.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("Visibility");
  for (int i = 0; i < 12; ++i)
  {
    values->InsertNextValue(i == 4 ? 0.0f : (i == 5 ? 0.5f : 1.0f));
  }
  image->GetPointData()->AddArray(values);
  const shadowcones::VisibilityGrid grid = this->Read(image);
  EXPECT_EQ(grid.Origin.X, 1.5);
  EXPECT_EQ(grid.Origin.Z, -4.0);
  EXPECT_EQ(grid.Dimensions, (std::array<int, 3>{ 3, 2, 2 }));
  EXPECT_EQ(grid.Marked, (std::vector<unsigned char>{ 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(grid.ShadowClasses, (std::vector<unsigned char>{ 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(grid.BrickParts, 0);
}

TEST_F(VisibilityVolume, BricksOfAnotherGridAreLeftOut)
{
  const auto volume = this->Volume();
  vtkNew<vtkImageData> half;
  half->CopyStructure(volume);
  half->SetExtent(0, 14, 0, 20, 0, 6);
  vtkNew<vtkFloatArray> values;
  values->SetName("Visibility");
  values->SetNumberOfTuples(half->GetNumberOfPoints());
  values->FillComponent(0, 1.0);
  half->GetPointData()->AddArray(values);
  half->GetFieldData()->ShallowCopy(volume->GetFieldData());
  EXPECT_TRUE(this->Read(half).BrickCells.empty());
}

TEST_F(VisibilityVolume, ExtentsBringTheirBricks)
{
  const shadowcones::VisibilityGrid whole = this->Read(this->Volume());
  std::vector<vtkIdType> cells;
  for (const bool upper : { false, true })
  {
    const int extent[6] = { 0, 14, 0, 20, upper ? 5 : 0, upper ? 12 : 5 };
    this->Filter->Modified();
    this->Filter->UpdateExtent(extent);
    vtkImageData* part = this->Filter->GetOutput();
    ASSERT_TRUE(std::equal(extent, extent + 6, part->GetExtent()));
    EXPECT_NEAR(part->GetOrigin()[2], -1.1, 1e-12);
    vtkDataArray* bricks = part->GetFieldData()->GetArray("BrickCells");
    for (vtkIdType b = 0; bricks && b < bricks->GetNumberOfTuples(); ++b)
    {
      cells.push_back(static_cast<vtkIdType>(bricks->GetComponent(b, 0)));
    }
  }
  EXPECT_EQ(cells, whole.BrickCells);
}

TEST_F(VisibilityVolume, ExactNeedsNoCones)
{
  const auto withCones = this->Volume();
  this->Filter->SetInputConnection(nullptr);
  Messages messages(this->Filter);
  const auto without = this->Volume();
  EXPECT_EQ(messages.Errors, "");
  vtkDataArray* one = withCones->GetPointData()->GetArray("Visibility");
  vtkDataArray* two = without->GetPointData()->GetArray("Visibility");
  ASSERT_EQ(one->GetNumberOfTuples(), two->GetNumberOfTuples());
  EXPECT_LT(one->GetRange()[0], 0.1);
  for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(one->GetComponent(i, 0), two->GetComponent(i, 0)) << i;
  }
  this->Filter->SetMethodToSoft();
  this->Filter->Update();
  EXPECT_NE(messages.Errors.find("There is no cone set."), std::string::npos) << messages.Errors;
}

TEST_F(VisibilityVolume, BeyondTheBoundsOfAProofEveryPointIsAsked)
{
  const double darkest = this->Volume()->GetPointData()->GetArray("Visibility")->GetRange()[0];
  EXPECT_LT(darkest, 0.1);
  // A set that holds nothing here, as if it were proved above y = 0 alone.
  auto cones = ConeSetOf({ MakeCone({ 50.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.1, 0.1, 0) });
  CertifyIn({ { -2.0, 0.0, -2.0 }, { 2.0, 2.0, 2.0 } }, cones);
  this->Filter->SetInputData(cones);
  EXPECT_EQ(this->Volume()->GetPointData()->GetArray("Visibility")->GetRange()[0], darkest);
  CertifyIn({}, cones); // everywhere
  this->Filter->Modified();
  EXPECT_EQ(this->Volume()->GetPointData()->GetArray("Visibility")->GetRange()[0], 1.0);
}

TEST_F(VisibilityVolume, AnEmptyConeSetLeavesEverythingLit)
{
  vtkNew<vtkPolyData> none;
  shadowcones::WriteConeSet({}, none);
  this->Filter->SetInputData(none);
  Messages messages(this->Filter);
  double range[2];
  this->Volume()->GetPointData()->GetArray("Visibility")->GetRange(range);
  EXPECT_EQ(range[0], 1.0);
  EXPECT_EQ(messages.Errors, "");
  // Nothing at all gives an empty volume.
  this->Light->SetShapeToSun();
  this->Filter->SetMethodToSoft();
  this->Filter->SetMeshConnection(nullptr);
  this->Filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  EXPECT_EQ(this->Volume()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(messages.Errors, "");
}

TEST_F(VisibilityVolume, BadParametersAreReported)
{
  this->Filter->SetMethod(2);
  this->ExpectError("Method is 2: it must be Exact (0) or Soft (1).");
  this->Filter->SetMethodToExact();
  this->Filter->SetNumberOfLightSamples(0);
  this->ExpectError("NumberOfLightSamples is 0: it must be in 1..65536.");
  this->Filter->SetNumberOfLightSamples(16);
  this->Filter->SetBrickParts(0);
  this->ExpectError("BrickParts is 0: it must be in 1..32.");
  this->Filter->SetBrickParts(2);
  this->Filter->SetRefinementThreshold(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("RefinementThreshold is nan: it must be in 0..1.");
  this->Filter->SetRefinementThreshold(0.5);
  this->Filter->SetBounds(-1.0, 1.0, 0.5, 0.5, -1.0, 1.0);
  this->ExpectError("Bounds are flat: they must enclose a volume.");
  this->Filter->SetBounds(-1.0, 1.0, 0.0, 1.0, -1.0, 1.0);
  this->Filter->SetDimensions(9, 1, 9);
  this->ExpectError("Dimensions are 9, 1, 9: each must be at least 2, and all together at most 2^31 - 1 points.");
  this->Filter->SetDimensions(5000, 5000, 5000);
  this->ExpectError("Dimensions are 5000, 5000, 5000");
  this->Filter->SetDimensions(9, 9, 9);
  EXPECT_EQ(this->Volume()->GetPointData()->GetNumberOfArrays(), 3);
}

TEST_F(VisibilityVolume, BadInputsAreReported)
{
  this->Filter->SetMeshConnection(nullptr);
  this->ExpectError("Exact needs the mesh: connect it with SetMeshConnection(), or use SetMethodToSoft().");
  vtkNew<vtkPolyData> points;
  points->DeepCopy(PlateCone());
  this->Filter->SetMeshData(points);
  this->ExpectError("The mesh on input port 2 has 1 cells and no polygon: shadows need surfaces.");
  this->Filter->SetMeshData(Plate());
  this->Filter->SetInputData(Plate());
  this->ExpectError("Cone set (input port 0): ");
  this->Filter->SetInputData(PlateCone());
  this->Filter->SetLightConnection(nullptr);
  this->ExpectError("There is no light: connect a vtkAreaLightSource or another poly data with SetLightConnection().");
  vtkNew<vtkPolyData> noLight;
  this->Filter->SetLightData(noLight);
  this->ExpectError("Light (input port 1): ");
  // A point-like light at the only cone has no extent.
  vtkNew<vtkAreaLightSource> sun;
  sun->SetShapeToSun();
  sun->SetNormal(0.0, -1.0, 0.0);
  this->Filter->SetLightConnection(sun->GetOutputPort());
  this->Filter->SetMethodToSoft();
  this->Filter->SetMeshConnection(nullptr);
  this->Filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  this->ExpectError("Bounds are not set, and cone set, mesh and light have no extent to take them from.");
}

TEST_F(VisibilityVolume, BadVolumesAreReported)
{
  this->ExpectUnreadable("has no point array \"Visibility\".",
    [](vtkImageData* volume) { volume->GetPointData()->RemoveArray("Visibility"); });
  this->ExpectUnreadable("\"Visibility\" of the visibility volume is 1.5 at point 7: it must be in 0..1.",
    [](vtkImageData* volume) { volume->GetPointData()->GetArray("Visibility")->SetComponent(7, 0, 1.5); });
  this->ExpectUnreadable("is nan at point 3",
    [](vtkImageData* volume) { volume->GetPointData()->GetArray("Visibility")->SetComponent(3, 0, std::nan("")); });
  this->ExpectUnreadable("\"ShadowClass\" of the visibility volume is 3 at point 4: it must be 0, 1 or 2.",
    [](vtkImageData* volume) { volume->GetPointData()->GetArray("ShadowClass")->SetComponent(4, 0, 3.0); });
  this->ExpectUnreadable("Point array \"Marked\" of the visibility volume has 2 values of 1 components",
    [](vtkImageData* volume) { volume->GetPointData()->GetArray("Marked")->SetNumberOfTuples(2); });
  this->ExpectUnreadable("rotated by its direction matrix",
    [](vtkImageData* volume) { volume->SetDirectionMatrix(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0); });
  this->ExpectUnreadable("with a spacing of -1", [](vtkImageData* volume) { volume->SetSpacing(0.1, -1.0, 0.1); });
  this->ExpectUnreadable("the spacing at least 1e-18", [](vtkImageData* volume) { volume->SetSpacing(0.1, 5e-324, 0.1); });
  this->ExpectUnreadable("has 1 points along y: it must have at least 2.",
    [](vtkImageData* volume) { volume->SetExtent(0, 14, 0, 0, 0, 12); });
  this->ExpectUnreadable("\"BrickVisibility\" must have a tuple for each of",
    [](vtkImageData* volume) { volume->GetFieldData()->GetArray("BrickParts")->SetComponent(0, 0, 3.0); });
  this->ExpectUnreadable("must be cells of the volume in ascending order: that of brick 1 is 0.",
    [](vtkImageData* volume) { volume->GetFieldData()->GetArray("BrickCells")->SetComponent(1, 0, 0.0); });
  this->ExpectUnreadable("\"BrickCells\" of the visibility volume must be",
    [](vtkImageData* volume) { volume->GetFieldData()->GetArray("BrickCells")->SetComponent(0, 0, -1.0); });
  this->ExpectUnreadable("The \"BrickLightId\" of brick 1 is 7: it must be that of a light of the volume.",
    [](vtkImageData* volume)
    {
      vtkNew<vtkIntArray> lights;
      lights->SetName("BrickLightId");
      lights->SetNumberOfTuples(volume->GetFieldData()->GetArray("BrickCells")->GetNumberOfTuples());
      lights->Fill(0.0);
      lights->SetValue(1, 7);
      volume->GetFieldData()->AddArray(lights);
    });
  this->ExpectUnreadable("do not fit together",
    [](vtkImageData* volume)
    {
      vtkNew<vtkIntArray> lights; // as many values, half as many tuples
      lights->SetName("BrickLightId");
      const vtkIdType bricks = volume->GetFieldData()->GetArray("BrickCells")->GetNumberOfTuples();
      lights->SetNumberOfComponents(static_cast<int>(bricks));
      lights->SetNumberOfTuples(1);
      lights->Fill(0.0);
      volume->GetFieldData()->AddArray(lights);
    });
  this->ExpectUnreadable("\"BrickVisibility\" of the visibility volume is -1 in brick 2: it must be in 0..1.",
    [](vtkImageData* volume) { volume->GetFieldData()->GetArray("BrickVisibility")->SetComponent(2, 5, -1.0); });
}

TEST_F(VisibilityVolume, PrintsEveryParameter)
{
  std::ostringstream text;
  this->Filter->Print(text);
  for (const char* name : { "Method: Exact", "Dimensions: 15, 21, 13", "Bounds: -1, 1, -1, 1.5, -1.1, 1.2",
         "NumberOfLightSamples: 16", "BrickParts: 2", "RefinementThreshold: 0.5", "Seed: 1" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

TEST_F(VisibilityVolume, WhatIsAnnouncedIsDelivered)
{
  this->Filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  this->Filter->SetDimensions(15, 21, 13);
  this->Filter->UpdateInformation();
  vtkInformation* info = this->Filter->GetOutputInformation(0);
  // By hand: plate -0.6..0.6, 0.43, -0.5..0.5 and lamp -0.4..0.4, 2, -0.4..0.4, each side 10 % longer about its middle.
  const double from[3] = { -0.66, 0.3515, -0.55 };
  const double to[3] = { 0.66, 2.0785, 0.55 };
  const int cells[3] = { 14, 20, 12 };
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(info->Get(vtkDataObject::ORIGIN(), axis), from[axis], 1e-7);
    EXPECT_NEAR(info->Get(vtkDataObject::SPACING(), axis), (to[axis] - from[axis]) / cells[axis], 1e-7);
    EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 2 * axis + 1), cells[axis]);
  }
  const auto volume = this->Volume();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(volume->GetOrigin()[axis], info->Get(vtkDataObject::ORIGIN(), axis));
    EXPECT_EQ(volume->GetSpacing()[axis], info->Get(vtkDataObject::SPACING(), axis));
  }
  EXPECT_LT(volume->GetPointData()->GetArray("Visibility")->GetRange()[0], 1.0);

  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(this->Filter->GetOutputPort());
  shrink->SetShrinkFactors(2, 2, 2);
  shrink->AveragingOff();
  shrink->Update();
  ExpectPartOf(shrink->GetOutput(), volume, 7 * 10 * 6);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputConnection(this->Filter->GetOutputPort());
  reslice->SetInterpolationModeToNearestNeighbor();
  reslice->Update();
  ExpectPartOf(reslice->GetOutput(), volume, 15 * 21 * 13);
  vtkNew<vtkExtractVOI> part;
  part->SetInputConnection(this->Filter->GetOutputPort());
  part->SetVOI(3, 9, 4, 20, 2, 11);
  part->Update();
  ExpectPartOf(part->GetOutput(), volume, 7 * 17 * 10);
  // A consumer that asks for parts.
  int extents[2][6] = { { 0, 14, 0, 9, 0, 12 }, { 0, 14, 10, 20, 0, 12 } };
  for (const auto& extent : extents)
  {
    this->Filter->Modified();
    this->Filter->UpdateExtent(extent);
    ExpectPartOf(this->Filter->GetOutput(), volume, 15 * (extent[3] - extent[2] + 1) * 13);
  }
}

TEST_F(VisibilityVolume, DimensionsMayChangeAfterAFault)
{
  // Larger and smaller ones, behind faults of both kinds: no request of an earlier run may stand.
  this->Filter->SetDimensions(5, 6, 7);
  this->Volume();
  this->Filter->SetNumberOfLightSamples(0);
  this->ExpectError("NumberOfLightSamples is 0");
  for (const int edge : { 9, 4 })
  {
    this->Filter->SetDimensions(edge, 1, edge);
    this->ExpectError("each must be at least 2");
    this->Filter->SetDimensions(edge, edge + 1, edge + 2);
    this->Filter->SetNumberOfLightSamples(0);
    this->ExpectError("NumberOfLightSamples is 0");
    this->Filter->SetNumberOfLightSamples(4);
    const auto volume = this->Volume();
    EXPECT_EQ(volume->GetNumberOfPoints(), edge * (edge + 1) * (edge + 2));
    EXPECT_EQ(volume->GetPointData()->GetNumberOfArrays(), 3);
  }
}

TEST_F(VisibilityVolume, BricksCountWhileTheyFitOnly)
{
  const auto original = this->Volume();
  EXPECT_GT(this->Read(original).BrickCells.size(), 0u);
  EXPECT_EQ(this->Warning, "");
  const auto expectDropped = [&](const char* changed, const std::function<void(vtkImageData*)>& change)
  {
    vtkNew<vtkImageData> edited;
    edited->DeepCopy(original);
    change(edited);
    EXPECT_EQ(this->Read(edited).BrickCells.size(), 0u) << changed;
    EXPECT_NE(this->Warning.find(std::string("were filled for another ") + changed + " than it has now"), std::string::npos)
      << this->Warning;
  };
  expectDropped("\"Visibility\"",
    [](vtkImageData* volume) { volume->GetPointData()->GetArray("Visibility")->SetComponent(100, 0, 0.125); });
  expectDropped("\"Visibility\"", [](vtkImageData* volume) { volume->GetFieldData()->RemoveArray("BrickHash"); });
  expectDropped("origin or spacing", [](vtkImageData* volume) { volume->SetOrigin(-1.0, -1.0, -1.05); });
  expectDropped("origin or spacing", [](vtkImageData* volume) { volume->SetSpacing(0.2, 0.1, 0.1); });
  expectDropped("dimensions",
    [&](vtkImageData* volume)
    {
      vtkNew<vtkExtractVOI> part;
      part->SetInputData(original);
      part->SetVOI(0, 14, 0, 20, 0, 11);
      part->Update();
      volume->ShallowCopy(part->GetOutput());
    });
}

TEST_F(VisibilityVolume, AnImageShowsEditedVisibility)
{
  // All light, by hand: no bricks may darken it, and it is the image without any occluder.
  const auto edited = this->Volume();
  edited->GetPointData()->GetArray("Visibility")->Fill(1.0);
  edited->GetPointData()->GetArray("Marked")->Fill(0.0);
  edited->GetPointData()->GetArray("ShadowClass")->Fill(0.0);
  vtkNew<vtkScatteringImageFilter> image;
  image->SetLightConnection(this->Light->GetOutputPort());
  image->SetVisibilityVolumeData(edited);
  image->SetModeToVolume();
  image->SetResolution(9, 7);
  image->SetMediumBounds(-1.0, 1.0, -1.0, 1.5, -1.1, 1.2);
  const std::string said = WarningsOf(image);
  EXPECT_NE(said.find("bricks of the visibility volume are left out"), std::string::npos) << said;
  vtkNew<vtkImageData> lit;
  lit->DeepCopy(image->GetOutput());
  vtkNew<vtkPolyData> nothing;
  image->SetInputData(nothing);
  image->SetVisibilityVolumeData(nullptr);
  image->SetModeToGuided();
  image->Update();
  vtkDataArray* shown = lit->GetPointData()->GetArray("InScattering");
  vtkDataArray* expected = image->GetOutput()->GetPointData()->GetArray("InScattering");
  ASSERT_GT(expected->GetRange(0)[1], 0.0);
  for (vtkIdType i = 0; i < shown->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(shown->GetComponent(i, 0), expected->GetComponent(i, 0), 1e-3 * expected->GetRange(0)[1]) << i;
  }
}
