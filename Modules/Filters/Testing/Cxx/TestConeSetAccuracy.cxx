// SPDX-License-Identifier: BSD-3-Clause
// The accuracy overlay as a filter: its arrays and tables agree, samples may be given, faults have their own words.
#include "Messages.h"
#include "scConeData.h"
#include "vtkAreaLightSource.h"
#include "vtkConeSetAccuracy.h"
#include "vtkConeSetGeometry.h"
#include "vtkLabelOccluders.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

/// A disc of radius 1 at z = 2 below a disc light of radius 0.5 at z = 4, and the cones of its shadow.
class AccuracyTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Light->SetShapeToDisc();
    this->Light->SetCenter(0.0, 0.0, 4.0);
    this->Light->SetNormal(0.0, 0.0, -1.0);
    this->Light->SetRadius(0.5);
    this->Disc->SetNumberOfSides(128);
    this->Disc->SetRadius(1.0);
    this->Disc->SetCenter(0.0, 0.0, 2.0);
    this->Occluders->SetInputConnection(this->Disc->GetOutputPort());
    this->Connect(this->Filter);
    this->Filter->SetNumberOfSamples(4000);
    this->Filter->SetNumberOfLightSamples(32);
    this->Filter->SetBounds(-3.0, 3.0, -3.0, 3.0, 0.0, 3.0);
  }

  void Connect(vtkConeSetAccuracy* filter)
  {
    WriteConeSet({ DiscCone(std::atan(0.75)), DiscCone(std::atan(0.25)) }, this->Cones);
    filter->SetConeSetData(this->Cones);
    filter->SetMeshConnection(this->Occluders->GetOutputPort());
    filter->SetLightConnection(this->Light->GetOutputPort());
  }

  static Cone DiscCone(double halfAngle)
  {
    Cone cone;
    cone.Center = { 0.0, 0.0, 2.0 };
    cone.Axis = { 0.0, 0.0, -1.0 };
    cone.Normal = cone.Axis;
    cone.BaseRadius = 1.0;
    cone.HalfAngle = halfAngle;
    cone.InnerHalfAngle = std::atan(0.25);
    cone.OccluderId = 0;
    return cone;
  }

  std::string ErrorOf(vtkConeSetAccuracy* filter)
  {
    this->Said.Errors.clear();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    return this->Said.Errors;
  }

  vtkPolyData* Samples() { return this->Filter->GetOutput(); }
  vtkTable* Table(int port) { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(port)); }
  vtkPolyData* ConeOutput() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(4)); }
  double Sample(const char* name, vtkIdType k)
  {
    return this->Samples()->GetPointData()->GetArray(name)->GetComponent(k, 0);
  }

  /// Quantity to (value, low, high).
  std::map<std::string, std::vector<double>> Summary()
  {
    std::map<std::string, std::vector<double>> result;
    vtkTable* table = this->Table(1);
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      result[table->GetValueByName(row, "Quantity").ToString()] = { table->GetValueByName(row, "Value").ToDouble(),
        table->GetValueByName(row, "Low").ToDouble(), table->GetValueByName(row, "High").ToDouble() };
    }
    return result;
  }

  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkRegularPolygonSource> Disc;
  vtkNew<vtkLabelOccluders> Occluders;
  vtkNew<vtkPolyData> Cones;
  vtkNew<vtkConeSetAccuracy> Filter;
  testsupport::Messages Said{ this->Filter };
};

} // namespace

TEST_F(AccuracyTest, ArraysAndSummaryAgree)
{
  this->Filter->Update();
  ASSERT_EQ(this->Said.Errors, "");
  ASSERT_EQ(this->Samples()->GetNumberOfPoints(), 4000);
  EXPECT_EQ(this->Samples()->GetNumberOfVerts(), 4000);
  vtkPointData* data = this->Samples()->GetPointData();
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(data->GetArray("Truth")));
  EXPECT_TRUE(vtkUnsignedCharArray::SafeDownCast(data->GetArray("Prediction")));
  EXPECT_TRUE(vtkUnsignedCharArray::SafeDownCast(data->GetArray("Confusion")));
  EXPECT_TRUE(vtkIntArray::SafeDownCast(data->GetArray("OccluderId")));
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(data->GetArray("Depth")));

  double classes[4] = {};
  double lit = 0.0, lost = 0.0, blocked = 0.0, leaked = 0.0;
  for (vtkIdType k = 0; k < 4000; ++k)
  {
    const double truth = this->Sample("Truth", k);
    const bool inside = this->Sample("Prediction", k) > 0.0;
    const int confusion = static_cast<int>(this->Sample("Confusion", k));
    ASSERT_EQ(confusion, truth < 1.0 ? (inside ? 1 : 3) : (inside ? 2 : 0));
    ASSERT_EQ(inside, this->Sample("ConeId", k) == 0.0);
    ASSERT_EQ(this->Sample("OccluderId", k), confusion == 0 ? -1.0 : 0.0);
    const double z = this->Samples()->GetPoint(k)[2];
    ASSERT_NEAR(this->Sample("Depth", k), inside ? 2.0 - z : -1.0, 1e-6);
    ++classes[confusion];
    lit += truth;
    lost += inside ? truth : 0.0;
    blocked += 1.0 - truth;
    leaked += inside ? 0.0 : 1.0 - truth;
  }
  auto summary = this->Summary();
  EXPECT_EQ(this->Table(1)->GetNumberOfRows(), 10);
  EXPECT_DOUBLE_EQ(summary["Recall"][0], classes[1] / (classes[1] + classes[3]));
  EXPECT_DOUBLE_EQ(summary["Precision"][0], classes[1] / (classes[1] + classes[2]));
  EXPECT_DOUBLE_EQ(summary["IoU"][0], classes[1] / (classes[1] + classes[2] + classes[3]));
  EXPECT_NEAR(summary["Leak"][0], leaked / blocked, 1e-6);
  EXPECT_NEAR(summary["Lost"][0], lost / lit, 1e-6);
  EXPECT_NEAR(summary["VolumeError"][0], (classes[1] + classes[2]) / (classes[1] + classes[3]) - 1.0, 1e-12);
  EXPECT_GT(classes[2], 0.0);
  for (const auto& row : summary)
  {
    EXPECT_LE(row.second[1], row.second[0]) << row.first;
    EXPECT_GE(row.second[2], row.second[0]) << row.first;
    EXPECT_TRUE(row.second[1] < row.second[2] || row.first == "Certified") << row.first;
  }
  // The first cone is the exact bound.
  EXPECT_EQ(summary["Recall"][0], 1.0);
  EXPECT_GT(summary["Precision"][0], 0.9);
  EXPECT_GT(summary["UmbraPrecision"][0], 0.9);
}

TEST_F(AccuracyTest, SaysWhetherTheConesAreProved)
{
  this->Filter->SetNumberOfSamples(500);
  // The closed form's cone touches the shadow: a little wider it holds it, a little narrower it does not.
  for (const double wider : { 0.01, -0.01 })
  {
    Cone cone = DiscCone(std::atan(0.75) + wider);
    cone.Center.Z += 1e-4;
    cone.BaseRadius += 1e-3;
    WriteConeSet({ cone }, this->Cones);
    this->Cones->Modified();
    this->Filter->Update();
    EXPECT_EQ(this->Summary()["Certified"][0], wider > 0.0 ? 1.0 : 0.0);
  }
}

TEST_F(AccuracyTest, ComparesWithBoundsThatNeedNoPhotons)
{
  this->Filter->CompareBoundsOn();
  this->Filter->Update();
  auto summary = this->Summary();
  EXPECT_EQ(this->Table(1)->GetNumberOfRows(), 15);
  EXPECT_GE(summary["ClusterCones"][0], 1.0);
  EXPECT_EQ(summary["ClusterRecall"][0], 1.0);
  EXPECT_EQ(summary["SweptBoxRecall"][0], 1.0);
  // A flat disc of radius 1 in a box of 2 x 2: pi / 4 of the box, less for what the light's size adds to both.
  EXPECT_LT(summary["SweptBoxPrecision"][0], 0.95);
  EXPECT_GT(summary["SweptBoxPrecision"][0], 0.75);
  EXPECT_GT(summary["ClusterPrecision"][0], summary["SweptBoxPrecision"][0] - 0.1);
}

TEST_F(AccuracyTest, TablesByOccluderAndDepthAddUp)
{
  this->Filter->SetNumberOfDepthBins(5);
  this->Filter->Update();
  auto summary = this->Summary();
  ASSERT_EQ(this->Table(2)->GetNumberOfRows(), 1);
  EXPECT_EQ(this->Table(2)->GetValueByName(0, "OccluderId").ToInt(), 0);
  for (const char* name : { "Recall", "Precision", "IoU", "Leak", "Lost" })
  {
    EXPECT_NEAR(this->Table(2)->GetValueByName(0, name).ToDouble(), summary[name][0], 1e-12) << name;
    EXPECT_NEAR(
      this->Table(2)->GetValueByName(0, (std::string(name) + "High").c_str()).ToDouble(), summary[name][2], 1e-12);
  }
  ASSERT_EQ(this->Table(3)->GetNumberOfRows(), 5);
  double lost = 0.0;
  long long count = 0;
  for (int row = 0; row < 5; ++row)
  {
    lost += this->Table(3)->GetValueByName(row, "Lost").ToDouble();
    count += this->Table(3)->GetValueByName(row, "SampleCount").ToLongLong();
  }
  EXPECT_NEAR(lost, summary["Lost"][0], 1e-12);
  EXPECT_EQ(count, this->Table(2)->GetValueByName(0, "SampleCount").ToLongLong());
  EXPECT_NEAR(this->Table(3)->GetValueByName(4, "DepthMax").ToDouble(), 2.0, 0.01);
}

TEST_F(AccuracyTest, ConesSayHowWrongTheyAre)
{
  this->Filter->Update();
  vtkPointData* data = this->ConeOutput()->GetPointData();
  ASSERT_EQ(this->ConeOutput()->GetNumberOfPoints(), 2);
  EXPECT_TRUE(data->GetArray("HalfAngle"));
  EXPECT_GT(data->GetArray("SampleCount")->GetComponent(0, 0), data->GetArray("SampleCount")->GetComponent(1, 0));
  // The second cone lies in the umbra: nothing in it is lit.
  EXPECT_EQ(data->GetArray("Precision")->GetComponent(1, 0), 1.0);
  EXPECT_LT(data->GetArray("PrecisionLow")->GetComponent(1, 0), 1.0);
  EXPECT_LT(data->GetArray("Lost")->GetComponent(1, 0), 1e-3);
  EXPECT_NEAR(data->GetArray("Lost")->GetComponent(0, 0), this->Summary()["Lost"][0], 1e-6);
  vtkNew<vtkConeSetGeometry> geometry;
  geometry->SetInputConnection(this->Filter->GetOutputPort(4));
  geometry->SetLength(1.0);
  geometry->Update();
  EXPECT_TRUE(geometry->GetOutput()->GetCellData()->GetArray("Precision"));
}

TEST_F(AccuracyTest, SamplesMayBeAnyDataSetAndAnotherClassifierIsHeldAgainstTheSameTruth)
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(13, 13, 7);
  grid->SetOrigin(-3.0, -3.0, 0.1);
  grid->SetSpacing(0.5, 0.5, 0.25);
  vtkNew<vtkUnsignedCharArray> classes;
  classes->SetName("ShadowClass");
  classes->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    // Shadow is what lies in a cylinder, all of it umbra.
    const double* p = grid->GetPoint(i);
    classes->SetValue(i, p[0] * p[0] + p[1] * p[1] < 1.0 && p[2] < 2.0 ? 2 : 0);
  }
  grid->GetPointData()->AddArray(classes);
  this->Filter->SetInputData(grid);
  this->Filter->Update();
  ASSERT_EQ(this->Said.Errors, "");
  ASSERT_EQ(this->Samples()->GetNumberOfPoints(), 13 * 13 * 7);
  EXPECT_EQ(this->Samples()->GetPoint(1)[0], grid->GetPoint(1)[0]);
  ASSERT_TRUE(this->Samples()->GetPointData()->GetArray("ShadowClass"));
  auto summary = this->Summary();
  EXPECT_EQ(this->Table(1)->GetNumberOfRows(), 15);
  EXPECT_LT(summary["ShadowClassRecall"][0], summary["Recall"][0]);
  EXPECT_EQ(summary["ShadowClassPrecision"][0], 1.0);
  EXPECT_EQ(summary["ShadowClassUmbraPrecision"][0], 1.0);
  EXPECT_LT(summary["ShadowClassUmbraRecall"][0], 1.0);

  classes->SetValue(5, 3);
  classes->Modified();
  grid->Modified();
  EXPECT_NE(this->ErrorOf(this->Filter).find("holds a value that is not 0, 1 or 2 at point 5."), std::string::npos);
}

TEST_F(AccuracyTest, ReceiversBlockNothing)
{
  // The same disc, marked as a receiver: everything is lit.
  this->Occluders->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(this->Occluders->GetOutput());
  mesh->GetCellData()->GetArray("OccluderId")->Fill(-1.0);
  this->Filter->SetMeshData(mesh);
  this->Filter->Update();
  ASSERT_EQ(this->Said.Errors, "");
  EXPECT_EQ(this->Samples()->GetPointData()->GetArray("Truth")->GetRange()[0], 1.0);
  EXPECT_TRUE(std::isnan(this->Summary()["Recall"][0]));
  EXPECT_EQ(this->Summary()["Precision"][0], 0.0);
}

TEST_F(AccuracyTest, BoundsAreThoseOfMeshAndLightUnlessSet)
{
  this->Filter->SetBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  this->Filter->Update();
  const double* b = this->Samples()->GetBounds();
  EXPECT_NEAR(b[0], -1.0, 0.05);
  EXPECT_NEAR(b[4], 2.0, 0.05);
  EXPECT_NEAR(b[5], 4.0, 0.05);
  EXPECT_LE(b[5], 4.0);
}

TEST_F(AccuracyTest, AnEmptyMeshAndNoSamplesAreValid)
{
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetMeshData(nothing);
  this->Filter->SetConeSetData(nothing);
  this->Filter->Update();
  EXPECT_EQ(this->Samples()->GetNumberOfPoints(), 4000);
  EXPECT_EQ(this->Summary()["Lost"][0], 0.0);
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_EQ(this->Said.Errors, "");
  EXPECT_EQ(this->Samples()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Table(1)->GetNumberOfRows(), 10);
  EXPECT_EQ(this->Table(3)->GetNumberOfRows(), 16);
}

TEST_F(AccuracyTest, TheFirstPieceHasTheTables)
{
  for (int piece = 0; piece < 3; ++piece)
  {
    this->Filter->UpdatePiece(piece, 3, 0);
    EXPECT_GT(this->Samples()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Table(1)->GetNumberOfRows(), piece == 0 ? 10 : 0);
  }
}

TEST_F(AccuracyTest, EveryFaultHasItsOwnMessage)
{
  const auto expect = [&](const char* part)
  {
    const std::string error = this->ErrorOf(this->Filter);
    EXPECT_NE(error.find(part), std::string::npos) << part << " is not in: " << error;
  };
  this->Filter->SetConeSetConnection(nullptr);
  expect("No cone set on input port 1");
  this->Connect(this->Filter);
  this->Filter->SetMeshConnection(nullptr);
  expect("No mesh on input port 2");
  this->Connect(this->Filter);
  this->Filter->SetLightConnection(nullptr);
  expect("No light on input port 3");
  this->Connect(this->Filter);

  this->Filter->SetNumberOfSamples(-1);
  expect("NumberOfSamples is -1: it must be in 0..1000000000.");
  this->Filter->SetNumberOfSamples(10);
  this->Filter->SetNumberOfLightSamples(0);
  expect("NumberOfLightSamples is 0: it must be in 1..65536.");
  this->Filter->SetNumberOfLightSamples(8);
  this->Filter->SetNumberOfDepthBins(0);
  expect("NumberOfDepthBins is 0: it must be in 1..100000.");
  this->Filter->SetNumberOfDepthBins(4);
  this->Filter->SetBounds(0.0, 1.0, 2.0, 1.0, 0.0, 1.0);
  expect("Bounds along y run from 2 to 1");
  this->Filter->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);

  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> coordinates;
  coordinates->InsertNextPoint(0.0, 0.0, 0.0);
  coordinates->InsertNextPoint(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  points->SetPoints(coordinates);
  this->Filter->SetInputData(points);
  expect("Sample point 1 on input port 0 has a coordinate that is not finite.");
  this->Filter->SetInputConnection(0, nullptr);
  this->Cones->GetPointData()->RemoveArray("Axis");
  this->Cones->Modified();
  expect("\"Axis\"");
}
