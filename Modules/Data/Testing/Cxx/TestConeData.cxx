// SPDX-License-Identifier: BSD-3-Clause
// Cone sets: written, read, and what is refused in which words.
#include "scConeData.h"

#include "scFieldArrays.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

Cone ExampleCone()
{
  Cone cone;
  cone.Center = { 1e6 + 0.1, 2.0, 3.0 };
  cone.Axis = Normalized({ 1.0, 2.0, 3.0 });
  cone.BaseRadius = 0.25;
  cone.HalfAngle = -0.125;
  cone.InnerHalfAngle = -0.5;
  cone.Normal = Normalized({ 0.0, 2.0, 3.0 });
  cone.OccluderId = 7;
  cone.VectorCount = 31;
  cone.Planarity = 0.0625;
  cone.Overspill = 0.75;
  return cone;
}

std::string ConeError(vtkPolyData* data)
{
  std::vector<Cone> cones(3);
  std::string error;
  EXPECT_FALSE(ReadConeSet(data, cones, error));
  EXPECT_TRUE(cones.empty());
  return error;
}

/// Two cones in which one value of the second is replaced.
std::string ConeErrorWith(const char* array, int component, double value)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone(), ExampleCone() }, data);
  data->GetPointData()->GetArray(array)->SetComponent(1, component, value);
  return ConeError(data);
}

} // namespace

TEST(ConeData, ConeSetRoundTrip)
{
  const Cone cone = ExampleCone();
  vtkNew<vtkPolyData> data;
  WriteConeSet({ Cone{ {}, { 0, 0, 1 }, 1.0, 0.5, 0.25, { 0, 0, 1 }, 0, 1, 0.0, -1.0 }, cone }, data);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_TRUE(vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("Axis")));
  EXPECT_TRUE(vtkIntArray::SafeDownCast(data->GetPointData()->GetArray("OccluderId")));

  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  ASSERT_EQ(cones.size(), 2u);
  const Cone& read = cones[1];
  EXPECT_EQ(read.Center.X, cone.Center.X) << "positions keep double precision";
  EXPECT_NEAR(Dot(read.Axis, cone.Axis), 1.0, 1e-12);
  EXPECT_NEAR(Length(read.Axis), 1.0, 1e-15);
  EXPECT_NEAR(Dot(read.Normal, cone.Normal), 1.0, 1e-12);
  EXPECT_EQ(read.BaseRadius, cone.BaseRadius);
  EXPECT_EQ(read.HalfAngle, cone.HalfAngle);
  EXPECT_EQ(read.InnerHalfAngle, cone.InnerHalfAngle);
  EXPECT_EQ(read.OccluderId, cone.OccluderId);
  EXPECT_EQ(read.VectorCount, cone.VectorCount);
  EXPECT_EQ(read.Planarity, cone.Planarity);
  EXPECT_EQ(read.Overspill, cone.Overspill);
}

TEST(ConeData, ConeSetFallbacks)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  for (const char* name : { "InnerHalfAngle", "Normal", "OccluderId", "VectorCount", "Planarity", "Overspill" })
  {
    data->GetPointData()->RemoveArray(name);
  }
  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  EXPECT_EQ(cones[0].InnerHalfAngle, -0.125);
  EXPECT_EQ(cones[0].Normal.X, cones[0].Axis.X);
  EXPECT_EQ(cones[0].OccluderId, 0);
  EXPECT_EQ(cones[0].VectorCount, 0);
  EXPECT_EQ(cones[0].Overspill, -1.0);
  EXPECT_TRUE(ReadConeSet(vtkNew<vtkPolyData>(), cones, error));
  EXPECT_TRUE(cones.empty());
}

TEST(ConeData, ConeSetFaultsAreNamed)
{
  for (const char* name : { "Axis", "BaseRadius", "HalfAngle" })
  {
    vtkNew<vtkPolyData> data;
    WriteConeSet({ ExampleCone() }, data);
    data->GetPointData()->RemoveArray(name);
    EXPECT_EQ(ConeError(data), std::string("The cone set has no array \"") + name + "\".");
  }
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  AddFloatArray(data->GetPointData(), "Axis", 2, { 1, 0 });
  EXPECT_EQ(ConeError(data), "The array \"Axis\" of the cone set has 2 components where 3 are needed.");
  AddFloatArray(data->GetPointData(), "Axis", 3, { 1, 0, 0, 1, 0, 0 });
  EXPECT_EQ(ConeError(data), "The array \"Axis\" of the cone set has 2 tuples where 1 are needed.");
  EXPECT_EQ(ConeError(nullptr), "There is no cone set.");

  EXPECT_EQ(ConeErrorWith("Axis", 0, NaN), "The \"Axis\" of cone 1 is not finite.");
  EXPECT_EQ(ConeErrorWith("Axis", 0, 5.0).find("The \"Axis\" of cone 1 has the length 5.0"), 0u);
  EXPECT_EQ(ConeErrorWith("Normal", 1, NaN), "The \"Normal\" of cone 1 is not finite.");
  EXPECT_EQ(ConeErrorWith("BaseRadius", 0, -1.0),
    "The \"BaseRadius\" of cone 1 is -1.000000: it must be finite, at most 1e18 and not negative.");
  EXPECT_EQ(ConeErrorWith("BaseRadius", 0, NaN).find("The \"BaseRadius\" of cone 1 is "), 0u);
  for (const double angle : { 1.5709, -1.5709, NaN, HUGE_VAL })
  {
    EXPECT_EQ(ConeErrorWith("HalfAngle", 0, angle).find("The \"HalfAngle\" of cone 1 is "), 0u) << angle;
    EXPECT_EQ(ConeErrorWith("InnerHalfAngle", 0, angle).find("The \"InnerHalfAngle\" of cone 1 is "), 0u) << angle;
  }
  EXPECT_EQ(ConeErrorWith("Overspill", 0, NaN), "The \"Planarity\" or \"Overspill\" of cone 1 is not finite.");

  WriteConeSet({ ExampleCone() }, data);
  data->GetPoints()->SetPoint(0, 0.0, NaN, 0.0);
  EXPECT_EQ(ConeError(data), "The position of cone 0 is not finite.");
}

TEST(ConeData, WholeNumbersThatAreNoneAreNamed)
{
  struct
  {
    const char* Array;
    double Value;
    const char* Said;
  } const faults[] = {
    { "VectorCount", NaN, "nan: it must be a whole number, 0 or more." },
    { "VectorCount", -1.0, "-1: it must be a whole number, 0 or more." },
    { "VectorCount", 1.5, "1.5: it must be a whole number, 0 or more." },
    { "LightId", NaN, "nan: it must be a whole number that 32 bits hold." },
    { "LightId", 0.5, "0.5: it must be a whole number that 32 bits hold." },
    { "LightId", 1e15, "1e+15: it must be a whole number that 32 bits hold." },
    { "ConeOrigin", 3.0, "3: it must be 0 (fitted), 1 (grown) or 2 (added)." },
    { "ConeOrigin", 0.5, "0.5: it must be 0 (fitted), 1 (grown) or 2 (added)." },
  };
  for (const auto& fault : faults)
  {
    vtkNew<vtkPolyData> data;
    WriteConeSet({ ExampleCone(), ExampleCone() }, data);
    AddDoubleArray(data->GetPointData(), fault.Array, 1, { 1.0, fault.Value });
    EXPECT_EQ(ConeError(data), std::string("The \"") + fault.Array + "\" of cone 1 is " + fault.Said);
  }
}

TEST(ConeData, BoundsOfAProofThatAreNoBoxProveNothing)
{
  const double all = HUGE_VAL;
  vtkNew<vtkPolyData> data;
  const auto read = [&data](const std::vector<double>& bounds)
  {
    AddDoubleArray(data->GetFieldData(), "CertifiedBounds", 6, bounds);
    return ReadCertifiedBounds(data->GetFieldData());
  };
  EXPECT_TRUE(read({ -all, all, -all, all, -all, all }).Empty());
  EXPECT_TRUE(read({ 0.0, 1.0, 0.0, 2.0, 0.0, 3.0 }).Contains({ 1.0, 2.0, 3.0 }));
  for (const std::vector<double>& bounds : { std::vector<double>{ NaN, 1.0, 0.0, 2.0, 0.0, 3.0 }, { 0.0, NaN, 0.0, 2.0, 0.0, 3.0 },
         { 1.0, 0.0, 0.0, 2.0, 0.0, 3.0 }, { 0.0, 1.0, 0.0, 2.0, 0.0, all } })
  {
    const Box box = read(bounds);
    EXPECT_FALSE(box.Empty());
    EXPECT_FALSE(box.Contains({ 0.5, 0.5, 0.5 }));
  }
}

TEST(ConeData, AxesNearUnitAreNormalised)
{
  vtkNew<vtkPolyData> data;
  WriteConeSet({ ExampleCone() }, data);
  AddDoubleArray(data->GetPointData(), "Axis", 3, { 0.0, 0.0, 1.0009 });
  std::vector<Cone> cones;
  std::string error;
  ASSERT_TRUE(ReadConeSet(data, cones, error)) << error;
  EXPECT_EQ(cones[0].Axis.Z, 1.0);
  AddDoubleArray(data->GetPointData(), "Axis", 3, { 0.0, 0.0, 1.0011 });
  EXPECT_FALSE(ReadConeSet(data, cones, error));
}
