// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageTesting.h
 * @brief A small lit scene for tests of vtkScatteringImageFilter, and what they ask of its images.
 */
#ifndef ImageTesting_h
#define ImageTesting_h

#include "vtkScatteringImageFilter.h"

#include "Messages.h"
#include "TestPolyData.h"

#include "scFieldArrays.h"
#include "vtkAreaLightSource.h"
#include "vtkVisibilityVolume.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace imagetesting
{

using namespace shadowcones::testsupport;

constexpr int width = 12;
constexpr int height = 10;
constexpr const char* arrays[] = { "Radiance", "InScattering", "SurfaceRadiance", "Transmittance", "Depth",
  "RelativeError", "SampleCount", "RGB", "SurfaceRelativeError" };
constexpr int allModes[] = { vtkScatteringImageFilter::BruteForce, vtkScatteringImageFilter::Medium,
  vtkScatteringImageFilter::Fast, vtkScatteringImageFilter::Guided, vtkScatteringImageFilter::Soft,
  vtkScatteringImageFilter::Volume };

inline vtkSmartPointer<vtkPolyData> TiltedPlate()
{
  return Plane({ -0.7, 0.1, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 });
}

inline vtkSmartPointer<vtkPolyData> Floor()
{
  return Plane({ -2.0, -1.9, -2.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
}

inline vtkSmartPointer<vtkPolyData> PlateAndFloor()
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(TiltedPlate());
  append->AddInputData(Floor());
  append->Update();
  return append->GetOutput();
}

/// One cone that holds all of the plate's shadow.
inline vtkSmartPointer<vtkPolyData> BoundingCone()
{
  return ConeSetOf({ MakeCone({ -0.1, 0.9, 0.0 }, { 0.0, -1.0, 0.0 }, 1.5, std::atan(2.0 / 1.1), 0) });
}

constexpr double discRadius = 0.6;
constexpr double discHeight = 0.5;
constexpr double lampHeight = 2.0;
constexpr double lampRadius = 0.4;

/// A round plate under the lamp.
inline vtkSmartPointer<vtkPolyData> Disc()
{
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNumberOfSides(200);
  disc->SetRadius(discRadius);
  disc->SetCenter(0.0, discHeight, 0.0);
  disc->SetNormal(0.0, 1.0, 0.0);
  disc->Update();
  return disc->GetOutput();
}

/// The cone that holds all of the disc's shadow and has the disc for its base.
inline vtkSmartPointer<vtkPolyData> DiscCone()
{
  shadowcones::Cone cone = MakeCone({ 0.0, discHeight, 0.0 }, { 0.0, -1.0, 0.0 }, discRadius,
    std::atan((lampRadius + discRadius) / (lampHeight - discHeight)), 0);
  cone.Normal = { 0.0, 1.0, 0.0 };
  return ConeSetOf({ cone });
}

/// An image over x, y and z from -2 to 2 with the same value everywhere.
inline vtkSmartPointer<vtkImageData> Constant(const char* name, float value, int edge = 3)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(edge, edge, edge);
  image->SetOrigin(-2.0, -2.0, -2.0);
  const double spacing = 4.0 / (edge - 1);
  image->SetSpacing(spacing, spacing, spacing);
  const auto count = static_cast<std::size_t>(image->GetNumberOfPoints());
  shadowcones::AddFloatArray(image->GetPointData(), name, 1, std::vector<float>(count, value));
  return image;
}

/// After an update.
inline vtkSmartPointer<vtkImageData> CopyOfOutput(vtkImageAlgorithm* filter)
{
  filter->Update();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
}

/// Update must fail with a message that holds the text, and leave no image.
inline void ExpectNoImage(vtkImageAlgorithm* filter, const std::string& part)
{
  filter->Modified();
  EXPECT_SAYS(ErrorsOf(filter), part);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
}

inline void SetLamp(vtkAreaLightSource* lamp)
{
  lamp->SetShapeToDisc();
  lamp->SetCenter(0.0, lampHeight, 0.0);
  lamp->SetNormal(0.0, -1.0, 0.0);
  lamp->SetRadius(lampRadius);
}

/// A filter with a lamp over a plate and a floor in brute force, at a test's sample counts.
class ImageTest : public testing::Test
{
protected:
  ImageTest()
  {
    SetLamp(this->Light);
    this->Camera->SetPosition(0.0, 0.0, 7.0);
    this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
    this->Camera->SetViewAngle(38.0);
    this->Filter->SetInputData(PlateAndFloor());
    this->Filter->SetLightConnection(this->Light->GetOutputPort());
    this->Filter->SetCamera(this->Camera);
    this->Filter->SetResolution(width, height);
    this->Filter->SetMediumBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
    this->Filter->SetModeToBruteForce();
    this->Filter->SetNumberOfSteps(10);
    this->Filter->SetNumberOfLightSamples(4);
    this->Volume->SetLightConnection(this->Light->GetOutputPort());
    this->Volume->SetDimensions(31, 31, 31);
    this->Volume->SetBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
    this->Volume->SetNumberOfLightSamples(32);
  }

  /// Everything that any mode needs: the round plate, its cone, and the volume of both.
  void ConnectDisc()
  {
    this->Filter->SetInputData(Disc());
    this->Filter->SetConeSetData(DiscCone());
    this->Volume->SetInputData(DiscCone());
    this->Volume->SetMeshData(Disc());
    this->Filter->SetVisibilityVolumeConnection(this->Volume->GetOutputPort());
    this->Filter->SetSoftDimensions(31, 31, 31);
    this->Filter->LightVisibleOff();
  }

  vtkSmartPointer<vtkImageData> Image() { return CopyOfOutput(this->Filter); }

  void ExpectError(const std::string& part) { ExpectNoImage(this->Filter, part); }

  vtkNew<vtkAreaLightSource> Light;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkVisibilityVolume> Volume;
  vtkNew<vtkScatteringImageFilter> Filter;
};

inline void ExpectSameBytes(vtkImageData* a, vtkImageData* b)
{
  for (const char* name : arrays)
  {
    vtkDataArray* first = a->GetPointData()->GetArray(name);
    vtkDataArray* second = b->GetPointData()->GetArray(name);
    ASSERT_TRUE(first && second) << name;
    ASSERT_EQ(first->GetNumberOfValues(), second->GetNumberOfValues()) << name;
    const auto bytes = static_cast<std::size_t>(first->GetNumberOfValues()) * first->GetDataTypeSize();
    EXPECT_EQ(std::memcmp(first->GetVoidPointer(0), second->GetVoidPointer(0), bytes), 0) << name;
  }
}

inline double Sum(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  double sum = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetComponent(i, 0);
  }
  return sum;
}

/// Root of the mean square of the difference of the medium terms, over the mean of the truth.
inline double Error(vtkImageData* image, vtkImageData* truth)
{
  vtkDataArray* a = image->GetPointData()->GetArray("InScattering");
  vtkDataArray* b = truth->GetPointData()->GetArray("InScattering");
  double squares = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    const double difference = a->GetComponent(i, 0) - b->GetComponent(i, 0);
    squares += difference * difference;
  }
  const auto count = static_cast<double>(a->GetNumberOfTuples());
  return std::sqrt(squares / count) / (Sum(truth, "InScattering") / count);
}

inline double Field(vtkImageData* image, const char* name, int component = 0)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, component) : std::nan("");
}

} // namespace imagetesting

#endif
