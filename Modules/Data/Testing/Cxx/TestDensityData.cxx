// SPDX-License-Identifier: BSD-3-Clause
#include "scDensityData.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace shadowcones;

namespace
{

/// A function that is linear in space, so that its interpolant is the same on every grid.
double Linear(const double x[3])
{
  return 20.0 + 0.5 * x[0] - 0.25 * x[1] + 2.0 * x[2];
}

/// Point data "Density" with Linear() at every point, wherever the image says it lies.
void FillLinear(vtkImageData* image)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Density");
  for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
  {
    array->InsertNextValue(Linear(image->GetPoint(point)));
  }
  image->GetPointData()->AddArray(array);
}

DensityGrid Read(vtkImageData* image)
{
  DensityGrid grid;
  std::string error;
  EXPECT_TRUE(ReadDensity(image, nullptr, grid, error)) << error;
  return grid;
}

std::string ErrorOf(vtkImageData* image)
{
  DensityGrid grid;
  std::string error;
  EXPECT_FALSE(ReadDensity(image, nullptr, grid, error));
  return error;
}

} // namespace

TEST(DensityData, KeepsItsPlace)
{
  // Origin, spacing, an extent that does not start at 0 and a turned direction matrix, one after the other.
  for (int turn = 0; turn < 3; ++turn)
  {
    vtkNew<vtkImageData> image;
    image->SetExtent(-2, 3, 5, 9, 1, 4);
    image->SetOrigin(1.0, -2.0, 0.5);
    image->SetSpacing(0.5, 0.25, turn == 2 ? -0.75 : 0.75);
    if (turn > 0)
    {
      const double c = std::cos(0.6);
      const double s = std::sin(0.6);
      image->SetDirectionMatrix(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
    }
    FillLinear(image);
    const DensityGrid grid = Read(image);
    for (const vtkIdType point : { 0, 7, 31, 119 })
    {
      const double* at = image->GetPoint(point);
      EXPECT_NEAR(grid.At({ at[0], at[1], at[2] }), Linear(at), 1e-5) << "point " << point << ", turn " << turn;
    }
    double a[3];
    double b[3];
    image->GetPoint(0, a);
    image->GetPoint(119, b);
    const double between[3] = { 0.7 * a[0] + 0.3 * b[0], 0.7 * a[1] + 0.3 * b[1], 0.7 * a[2] + 0.3 * b[2] };
    EXPECT_NEAR(grid.At({ between[0], between[1], between[2] }), Linear(between), 1e-5);
    EXPECT_EQ(grid.At({ 1.1 * a[0] - 0.1 * b[0], 1.1 * a[1] - 0.1 * b[1], 1.1 * a[2] - 0.1 * b[2] }), 0.0);
  }
}

TEST(DensityData, ASingleSliceHasNoThickness)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, 0, 0, 4, 3, 3);
  image->SetSpacing(0.0, 0.5, 1.0);
  vtkNew<vtkFloatArray> array;
  for (const float value : { 4.0f, 3.0f, 2.0f, 1.0f, 0.0f })
  {
    array->InsertNextValue(value);
  }
  image->GetPointData()->SetScalars(array);
  EXPECT_NEAR(Read(image).At({ -70.0, 0.75, 900.0 }), 2.5, 1e-6);
}

TEST(DensityData, PrefersTheNamedArrayThenScalarsThenTheFirst)
{
  const auto add = [](vtkImageData* image, const char* name, unsigned char value, bool scalars)
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(name);
    array->SetNumberOfValues(image->GetNumberOfPoints());
    array->Fill(value);
    image->GetPointData()->AddArray(array);
    if (scalars)
    {
      image->GetPointData()->SetActiveScalars(name);
    }
  };
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  add(image, "First", 1, false);
  EXPECT_EQ(Read(image).At({ 0.5, 0.5, 0.5 }), 1.0);
  add(image, "Active", 2, true);
  EXPECT_EQ(Read(image).At({ 0.5, 0.5, 0.5 }), 2.0);
  add(image, "Density", 3, false);
  EXPECT_EQ(Read(image).At({ 0.5, 0.5, 0.5 }), 3.0);
}

TEST(DensityData, FaultsAreNamed)
{
  EXPECT_NE(ErrorOf(nullptr).find("no points"), std::string::npos);
  vtkNew<vtkImageData> image;
  EXPECT_NE(ErrorOf(image).find("no points"), std::string::npos);
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkFloatArray> cells;
  cells->SetName("Density");
  cells->SetNumberOfTuples(8);
  cells->Fill(1.0);
  image->GetCellData()->AddArray(cells);
  EXPECT_NE(ErrorOf(image).find("no point array"), std::string::npos);

  vtkNew<vtkFloatArray> array;
  array->SetName("Fog");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(27);
  array->Fill(1.0);
  image->GetPointData()->SetScalars(array);
  EXPECT_NE(ErrorOf(image).find("\"Fog\" has 3 components"), std::string::npos);

  vtkNew<vtkDoubleArray> density;
  density->SetName("Density");
  density->SetNumberOfTuples(26);
  density->Fill(1.0);
  image->GetPointData()->AddArray(density);
  EXPECT_NE(ErrorOf(image).find("26 values for 27 points"), std::string::npos);

  density->SetNumberOfTuples(27);
  for (const double bad : { -0.5, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e300 })
  {
    density->Fill(1.0);
    density->SetValue(13, bad);
    EXPECT_NE(ErrorOf(image).find("density of point 13 is"), std::string::npos) << bad;
  }
  density->Fill(1.0);
  Read(image);
  image->SetSpacing(1.0, 0.0, 1.0);
  EXPECT_NE(ErrorOf(image).find("span"), std::string::npos);
}
