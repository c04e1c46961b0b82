// SPDX-License-Identifier: BSD-3-Clause
// Closed forms 5, 6, 7, 9 and 10 as a user meets them: vtkAreaLightSource and vtkScatteringImageFilter in brute force.
#include "ClosedForms.h"
#include "FilterChain.h"
#include "Scenes.h"
#include "TestPolyData.h"

#include "vtkAreaLightSource.h"
#include "vtkScatteringImageFilter.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Tolerance = 0.01;

/// A filter at a test's sample counts, and what its pixels see.
class Picture
{
public:
  Picture(vtkPolyData* mesh, vtkAlgorithmOutput* light, int size)
    : Size(size)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->SetLightConnection(light);
    this->Filter->SetCamera(this->Camera);
    this->Filter->SetResolution(size, size);
    this->Filter->SetModeToBruteForce();
    this->Filter->SetSigmaA(0.0);
    this->Filter->SetNumberOfSteps(64);
    this->Filter->SetMaximumDepth(6);
    this->Filter->SetIntensityThreshold(0.02);
    this->Filter->SetNumberOfLightSamples(16);
    this->Filter->SetNumberOfSurfaceLightSamples(0);
  }
  void LookParallel(const Vector3& from, const Vector3& to, double halfHeight)
  {
    this->Look(from, to);
    this->Camera->ParallelProjectionOn();
    this->Camera->SetParallelScale(halfHeight);
  }
  void Look(const Vector3& from, const Vector3& to)
  {
    this->Camera->SetPosition(from.X, from.Y, from.Z);
    this->Camera->SetFocalPoint(to.X, to.Y, to.Z);
    this->Camera->SetViewUp(0.0, std::abs(to.Y - from.Y) > 0.9 * Length(to - from) ? 0.0 : 1.0,
      std::abs(to.Y - from.Y) > 0.9 * Length(to - from) ? 1.0 : 0.0);
  }
  void Bounds(const Vector3& a, const Vector3& b) { this->Filter->SetMediumBounds(a.X, b.X, a.Y, b.Y, a.Z, b.Z); }
  vtkDataArray* InScattering()
  {
    this->Filter->Update();
    return this->Filter->GetOutput()->GetPointData()->GetArray("InScattering");
  }
  double Value(int i, int j, int wavelength = 0)
  {
    return this->InScattering()->GetComponent(static_cast<vtkIdType>(j) * this->Size + i, wavelength);
  }

  vtkNew<vtkScatteringImageFilter> Filter;
  vtkNew<vtkCamera> Camera;
  int Size;
};
} // namespace

TEST(FilterForms, AirlightOfAPointLight)
{
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToPoint();
  light->SetRadiance(3.0);
  const int size = 4;
  Picture picture(ToPolyData(OutOfTheWay()), light->GetOutputPort(), size);
  picture.Look({ -4.0, -2.0, 0.0 }, { 10.0, -2.0, 0.0 });
  picture.Camera->SetViewAngle(30.0);
  picture.Bounds({ -10.0, -10.0, -10.0 }, { 10.0, 10.0, 10.0 });
  picture.Filter->SetSigmaS(0.05);
  picture.Filter->SetSigmaSSpectrum(3, 0.2);
  const Camera camera = LookAt({ -4.0, -2.0, 0.0 }, { 10.0, -2.0, 0.0 }, std::tan(15.0 * closedforms::Pi / 180.0));
  ASSERT_TRUE(picture.InScattering());
  ASSERT_EQ(picture.InScattering()->GetNumberOfComponents(), 7);
  const Box bounds{ { -10.0, -10.0, -10.0 }, { 10.0, 10.0, 10.0 } };
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const Ray ray = camera.PixelRay(i, j, size, size);
      double begin = 0.0;
      double end = HUGE_VAL;
      ASSERT_TRUE(bounds.Clip(ray.Origin, ray.Direction, begin, end));
      const double gamma = std::acos(Dot(-ray.Origin, ray.Direction) / Length(ray.Origin));
      for (const int k : { 0, 3 })
      {
        const double expected = closedforms::Airlight(3.0, k == 3 ? 0.2 : 0.05, Length(ray.Origin), gamma, end);
        EXPECT_NEAR(picture.Value(i, j, k) / expected, 1.0, Tolerance)
          << "pixel " << i << ", " << j << ", wavelength " << k;
      }
    }
  }
}

TEST(FilterForms, SunOnASlab)
{
  const double irradiance = 5.0;
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToSun();
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetAngularDiameter(0.0);
  light->SetRadiance(irradiance);
  const std::vector<std::pair<double, double>> shadowed = { { 0.5, 1.2 }, { 2.0, 3.3 } };
  TestMesh mesh;
  for (const auto& part : shadowed)
  {
    mesh.AddSheet({ part.first, 2.0, -2.0 }, { part.second - part.first, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
  }
  const int size = 4;
  Picture picture(ToPolyData(mesh), light->GetOutputPort(), size);
  picture.LookParallel({ -1.0, 0.5, 0.0 }, { 1.0, 0.5, 0.0 }, 0.4);
  picture.Bounds({ 0.0, 0.0, -1.0 }, { 4.0, 1.0, 1.0 });
  picture.Filter->SetSigmaS(0.5);
  picture.Filter->SetSigmaA(0.1);
  for (int j = 0; j < size; ++j)
  {
    const double y = 0.5 + 0.4 * ((j + 0.5) / size * 2.0 - 1.0);
    const double expected = closedforms::SlabRadiance(0.5, 0.6, irradiance, y, 4.0, shadowed);
    EXPECT_NEAR(picture.Value(1, j) / expected, 1.0, Tolerance) << "y " << y;
  }
}

TEST(FilterForms, SolidAngleOfADisc)
{
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.5);
  light->SetRadiance(2.0);
  for (const double h : { 0.1, 0.5, 4.0 })
  {
    Picture picture(ToPolyData(OutOfTheWay()), light->GetOutputPort(), 1);
    picture.LookParallel({ -1.0, -h, 0.0 }, { 0.0, -h, 0.0 }, 1e-6);
    picture.Bounds({ -0.001, -h - 0.001, -0.001 }, { 0.001, -h + 0.001, 0.001 });
    picture.Filter->SetSigmaS(0.01);
    picture.Filter->SetNumberOfLightSamples(64);
    const double expected = 0.01 * 0.002 * 2.0 * closedforms::DiscSolidAngle(0.5, h) / (4.0 * closedforms::Pi);
    EXPECT_NEAR(picture.Value(0, 0) / expected, 1.0, Tolerance) << "h " << h;
  }
}

TEST(FilterForms, FurnaceOfAllModes)
{
  // A small occluder under the light makes cones; the medium and the camera's rays stay clear of its shadow.
  vtkNew<vtkAreaLightSource> light;
  light->SetCenter(0.0, 5.0, 0.0);
  light->SetNormal(0.0, -1.0, 0.0);
  TestMesh mesh;
  mesh.AddSheet({ 20.0, 3.0, -0.5 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  light->Update();
  FilterChain chain(ToPolyData(mesh), light->GetOutput(), 500);
  chain.Update();
  Picture picture(nullptr, light->GetOutputPort(), 6);
  picture.Filter->SetInputConnection(chain.Labels->GetOutputPort());
  picture.Filter->SetConeSetConnection(chain.Cones->GetOutputPort());
  picture.Look({ -6.0, 2.5, 0.0 }, { 0.0, 2.5, 0.0 });
  picture.Bounds({ -2.0, 0.0, -2.0 }, { 2.0, 4.5, 2.0 });
  ASSERT_GT(chain.Cones->GetOutput()->GetNumberOfPoints(), 0);

  vtkNew<vtkImageData> brute;
  picture.InScattering();
  brute->DeepCopy(picture.Filter->GetOutput());
  vtkDataArray* expected = brute->GetPointData()->GetArray("InScattering");
  ASSERT_GT(expected->GetRange()[0], 0.0);
  for (const int mode : { vtkScatteringImageFilter::Medium, vtkScatteringImageFilter::Fast })
  {
    picture.Filter->SetMode(mode);
    vtkDataArray* values = picture.InScattering();
    ASSERT_EQ(values->GetNumberOfValues(), expected->GetNumberOfValues());
    EXPECT_EQ(std::memcmp(values->GetVoidPointer(0), expected->GetVoidPointer(0), 4 * values->GetNumberOfValues()), 0)
      << "mode " << mode;
  }
}

TEST(FilterForms, FarVertexAndSunCastTheSameHardShadow)
{
  const double far = 1e6;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, far, 0.0);
  vtkNew<vtkCellArray> vertices;
  const vtkIdType first = 0;
  vertices->InsertNextCell(1, &first);
  vtkNew<vtkPolyData> vertex;
  vertex->SetPoints(points);
  vertex->SetVerts(vertices);
  vtkNew<vtkDoubleArray> spectrum;
  spectrum->SetName("LightSpectrum");
  for (int k = 0; k < 7; ++k)
  {
    spectrum->InsertNextValue(2.0 * far * far);
  }
  vertex->GetFieldData()->AddArray(spectrum);
  vtkNew<vtkAreaLightSource> sun;
  sun->SetShapeToSun();
  sun->SetNormal(0.0, -1.0, 0.0);
  sun->SetAngularDiameter(0.0);
  sun->SetRadiance(2.0);

  TestMesh mesh;
  mesh.AddSheet({ -0.5, 2.0, -0.7 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.4 });
  Picture picture(ToPolyData(mesh), sun->GetOutputPort(), 12);
  picture.Look({ -6.0, 1.5, 0.0 }, { 0.0, 1.0, 0.0 });
  picture.Bounds({ -1.0, 0.0, -1.0 }, { 1.0, 1.9, 1.0 });
  vtkNew<vtkImageData> ofSun;
  picture.InScattering();
  ofSun->DeepCopy(picture.Filter->GetOutput());
  picture.Filter->SetLightData(vertex);
  vtkDataArray* values = picture.InScattering();
  vtkDataArray* expected = ofSun->GetPointData()->GetArray("InScattering");
  ASSERT_EQ(values->GetNumberOfTuples(), expected->GetNumberOfTuples());
  double difference = 0.0;
  double sum = 0.0;
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    difference += std::abs(values->GetTuple(k)[0] - expected->GetTuple(k)[0]);
    sum += expected->GetTuple(k)[0];
  }
  ASSERT_GT(sum, 0.0);
  EXPECT_LT(difference / sum, 1e-4);
}
