// SPDX-License-Identifier: BSD-3-Clause
// "RGB" of radiance: by vtkToneMapRadiance, and by vtkScatteringImageFilter without rendering anew.
#include "vtkToneMapRadiance.h"

#include "ImageTesting.h"

#include "vtkDoubleArray.h"

#include <algorithm>
#include <limits>
#include <sstream>

using namespace imagetesting;

namespace
{

/// An image of one wavelength whose pixel (i, j) has the radiance 0.01 (1 + i + columns j).
vtkSmartPointer<vtkImageData> Ramp(int columns, int rows)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  std::vector<float> values(static_cast<std::size_t>(columns) * rows);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = 0.01f * static_cast<float>(i + 1);
  }
  shadowcones::AddFloatArray(image->GetPointData(), "Radiance", 1, values);
  return image;
}

double Grey(vtkImageData* image, vtkIdType pixel)
{
  vtkDataArray* rgb = image->GetPointData()->GetArray("RGB");
  EXPECT_EQ(rgb->GetComponent(pixel, 0), rgb->GetComponent(pixel, 1));
  EXPECT_EQ(rgb->GetComponent(pixel, 0), rgb->GetComponent(pixel, 2));
  return rgb->GetComponent(pixel, 0);
}

void ExpectSameRgb(vtkImageData* part, vtkImageData* whole)
{
  vtkDataArray* a = part->GetPointData()->GetArray("RGB");
  vtkDataArray* b = whole->GetPointData()->GetArray("RGB");
  ASSERT_TRUE(a && b);
  int extent[6];
  part->GetExtent(extent);
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      int ijk[3] = { i, j, 0 };
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_EQ(a->GetComponent(part->ComputePointId(ijk), c), b->GetComponent(whole->ComputePointId(ijk), c));
      }
    }
  }
}

class ToneMapRadiance : public testing::Test
{
protected:
  vtkImageData* Map(vtkImageData* image)
  {
    this->Filter->SetInputData(image);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  vtkNew<vtkToneMapRadiance> Filter;
};

} // namespace

TEST_F(ToneMapRadiance, WhiteIsTheNinetyNinthPercentileOfTheRadiance)
{
  // Of 0.01, 0.02 ... 1.00 the 99th is 0.99. By the curve of sRGB 0.5 / 0.99 is 188.4 of 255.
  auto image = Ramp(10, 10);
  vtkImageData* output = this->Map(image);
  EXPECT_NEAR(Field(output, "Exposure"), 1.0 / 0.99, 1e-6);
  EXPECT_EQ(Grey(output, 99), 255.0);
  EXPECT_EQ(Grey(output, 98), 255.0);
  EXPECT_EQ(Grey(output, 49), 188.0);
  EXPECT_EQ(output->GetPointData()->GetScalars(), output->GetPointData()->GetArray("RGB"));
  EXPECT_EQ(output->GetPointData()->GetArray("Radiance"), image->GetPointData()->GetArray("Radiance"));
  EXPECT_FALSE(image->GetPointData()->HasArray("RGB"));
  EXPECT_FALSE(image->GetFieldData()->HasArray("Exposure"));
}

TEST_F(ToneMapRadiance, FilmicLeavesRoomAboveWhite)
{
  // 2.54 / 3.16 = 0.8038 is by the curve of sRGB 231.6 of 255.
  auto image = Ramp(10, 10);
  image->GetPointData()->GetArray("Radiance")->SetComponent(99, 0, 4.0);
  this->Filter->SetToneCurveToFilmic();
  vtkImageData* output = this->Map(image);
  EXPECT_NEAR(Field(output, "Exposure"), 1.0 / 0.99, 1e-6) << "as without the curve";
  EXPECT_EQ(Grey(output, 98), 232.0);
  EXPECT_GT(Grey(output, 99), 250.0);
  EXPECT_LT(Grey(output, 99), 255.0) << "four times as bright, and not cut";
  this->Filter->SetToneCurveToLinear();
  EXPECT_EQ(Grey(this->Map(image), 98), 255.0);
}

TEST_F(ToneMapRadiance, TheLampItselfIsLeftOut)
{
  auto image = Ramp(10, 10);
  const std::vector<float> nothing(100, 0.0f);
  std::vector<float> surface(100, 0.0f);
  std::fill_n(surface.begin(), 3, 0.25f);
  shadowcones::AddFloatArray(image->GetPointData(), "InScattering", 1, nothing);
  shadowcones::AddFloatArray(image->GetPointData(), "SurfaceRadiance", 1, surface);
  EXPECT_NEAR(Field(this->Map(image), "Exposure"), 4.0, 1e-12);
  // One of them alone does not tell the lamp.
  image->GetPointData()->RemoveArray("InScattering");
  image->Modified();
  EXPECT_NEAR(Field(this->Map(image), "Exposure"), 1.0 / 0.99, 1e-6);
}

TEST_F(ToneMapRadiance, BlackNegativeAndUndefinedPixelsAreBlack)
{
  auto image = Ramp(4, 1);
  vtkDataArray* radiance = image->GetPointData()->GetArray("Radiance");
  const float values[4] = { 0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f };
  for (vtkIdType i = 0; i < 4; ++i)
  {
    radiance->SetComponent(i, 0, values[i]);
  }
  vtkImageData* output = this->Map(image);
  EXPECT_EQ(Field(output, "Exposure"), 1.0);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Grey(output, i), 0.0) << i;
  }
}

TEST_F(ToneMapRadiance, ExposureByHandCountsWithAutoExposureOff)
{
  this->Filter->AutoExposureOff();
  this->Filter->SetExposure(2.0);
  Messages messages(this->Filter);
  vtkImageData* output = this->Map(Ramp(10, 10));
  EXPECT_EQ(Field(output, "Exposure"), 2.0);
  EXPECT_EQ(Grey(output, 24), 188.0); // 0.25 doubled: sRGB of 0.5 is 187.5
  EXPECT_EQ(messages.Warnings, "");
  this->Filter->AutoExposureOn();
  this->Filter->Update();
  EXPECT_NE(messages.Warnings.find("Exposure is 2, but AutoExposure is on"), std::string::npos) << messages.Warnings;
}

TEST_F(ToneMapRadiance, DoublesAndActiveArraysAreFine)
{
  auto image = Ramp(10, 10);
  auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
  doubles->DeepCopy(image->GetPointData()->GetArray("Radiance"));
  image->GetPointData()->SetScalars(doubles); // replaces the floats: the name is the same
  ASSERT_EQ(image->GetPointData()->GetNumberOfArrays(), 1);
  vtkImageData* output = this->Map(image);
  EXPECT_EQ(Grey(output, 49), 188.0);
  EXPECT_TRUE(output->GetPointData()->HasArray("Radiance"));
}

TEST_F(ToneMapRadiance, FaultsHaveTheirMessages)
{
  Messages messages(this->Filter);
  vtkNew<vtkImageData> nothing;
  EXPECT_EQ(this->Map(nothing)->GetNumberOfPoints(), 0);
  EXPECT_EQ(messages.Errors, "");
  auto image = Ramp(3, 3);
  image->GetPointData()->GetArray("Radiance")->SetName("Other");
  EXPECT_EQ(this->Map(image)->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_NE(
    messages.Errors.find("no point array \"Radiance\" with one tuple for each of its 9 points"), std::string::npos);
  for (const double exposure : { 0.0, -1.0, HUGE_VAL, std::nan("") })
  {
    messages.Errors.clear();
    this->Filter->SetExposure(exposure);
    this->Map(Ramp(3, 3));
    EXPECT_NE(messages.Errors.find("it must be above 0 and finite"), std::string::npos) << exposure;
  }
  messages.Errors.clear();
  this->Filter->SetExposure(1.0);
  image = Ramp(3, 3);
  shadowcones::AddDoubleArray(image->GetFieldData(), "LightWavelengths", 1, { std::nan("") });
  EXPECT_EQ(this->Map(image)->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_NE(messages.Errors.find("\"LightWavelengths\" holds nan"), std::string::npos) << messages.Errors;
  messages.Errors.clear();
  this->Filter->SetToneCurve(3);
  this->Map(Ramp(3, 3));
  EXPECT_NE(messages.Errors.find("ToneCurve is 3: it must be Linear (0) or Filmic (1)"), std::string::npos)
    << messages.Errors;
  std::ostringstream text;
  this->Filter->Print(text);
  EXPECT_NE(text.str().find("ToneCurve: 3"), std::string::npos);
  EXPECT_NE(text.str().find("AutoExposure: On"), std::string::npos);
}

using ImageExposure = ImageTest;

TEST_F(ImageExposure, AnotherExposureRendersNothingAnew)
{
  const auto found = this->Image();
  vtkDataArray* radiance = this->Filter->GetOutput()->GetPointData()->GetArray("Radiance");
  const double exposure = Field(found, "Exposure");
  EXPECT_GT(exposure, 0.0);

  this->Filter->AutoExposureOff();
  this->Filter->SetExposure(0.5 * exposure);
  const auto half = this->Image();
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Radiance"), radiance);
  EXPECT_EQ(Field(half, "RenderSeconds"), Field(found, "RenderSeconds"));
  EXPECT_EQ(Field(half, "Exposure"), 0.5 * exposure);
  EXPECT_LT(Sum(half, "RGB"), Sum(found, "RGB"));

  this->Filter->SetExposure(exposure);
  ExpectSameBytes(this->Image(), found);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Radiance"), radiance);

  this->Filter->SetToneCurveToFilmic();
  EXPECT_LT(Sum(this->Image(), "RGB"), Sum(found, "RGB"));
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Radiance"), radiance);
  vtkNew<vtkToneMapRadiance> again;
  again->SetInputData(found);
  again->SetToneCurveToFilmic();
  again->Update();
  ExpectSameRgb(again->GetOutput(), this->Filter->GetOutput());
  this->Filter->SetToneCurveToLinear();

  // What the image depends on renders it anew.
  const auto changes = { +[](ImageExposure_AnotherExposureRendersNothingAnew_Test& t) { t.Filter->SetSigmaS(0.2); },
    +[](ImageExposure_AnotherExposureRendersNothingAnew_Test& t) { t.Light->SetRadiance(2.0); },
    +[](ImageExposure_AnotherExposureRendersNothingAnew_Test& t) { t.Camera->Azimuth(5.0); },
    +[](ImageExposure_AnotherExposureRendersNothingAnew_Test& t) { t.Filter->Modified(); } };
  for (const auto& change : changes)
  {
    vtkSmartPointer<vtkDataArray> before = this->Filter->GetOutput()->GetPointData()->GetArray("Radiance");
    change(*this);
    this->Filter->Update();
    EXPECT_NE(this->Filter->GetOutput()->GetPointData()->GetArray("Radiance"), before);
  }
}

TEST_F(ImageExposure, AnExtentHasTheExposureOfTheWholeImage)
{
  // Larger than what is taken whole: 6 x 2 tiles, of each 16 x 16 pixels.
  this->Filter->SetResolution(192, 64);
  this->Filter->SetNumberOfSteps(1);
  this->Filter->SetMaximumDepth(0);
  this->Filter->SetNumberOfLightSamples(1);
  this->Filter->SetNumberOfSurfaceLightSamples(1);
  const auto whole = this->Image();
  int extent[6] = { 150, 170, 3, 30, 0, 0 };
  this->Filter->Modified();
  this->Filter->UpdateExtent(extent);
  EXPECT_EQ(Field(this->Filter->GetOutput(), "Exposure"), Field(whole, "Exposure"));
  ExpectSameRgb(this->Filter->GetOutput(), whole);

  // The next extent needs no pixels beside its own: it is found once.
  extent[0] = 100;
  extent[1] = 120;
  this->Filter->UpdateExtent(extent);
  ExpectSameRgb(this->Filter->GetOutput(), whole);

  vtkNew<vtkToneMapRadiance> again;
  again->SetInputData(whole);
  again->Update();
  ExpectSameRgb(again->GetOutput(), whole);
}

TEST_F(ImageExposure, TheLampInTheImageDoesNotCount)
{
  this->Camera->SetPosition(0.0, -1.5, 0.1);
  this->Camera->SetFocalPoint(0.0, 2.0, 0.0);
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  const auto seen = this->Image();
  this->Filter->LightVisibleOff();
  const auto unseen = this->Image();
  EXPECT_GT(Sum(seen, "Radiance"), 2.0 * Sum(unseen, "Radiance"));
  EXPECT_EQ(Field(seen, "Exposure"), Field(unseen, "Exposure"));
}
