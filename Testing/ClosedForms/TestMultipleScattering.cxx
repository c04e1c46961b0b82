// SPDX-License-Identifier: BSD-3-Clause
// Light that scatters and reflects more than once, as a user meets it: furnaces, and rooms with a geometric series.
#include "Messages.h"
#include "TestMeshes.h"
#include "TestPolyData.h"

#include "vtkAreaLightSource.h"
#include "vtkPhotonMapFilter.h"
#include "vtkScatteringImageFilter.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace shadowcones::testsupport;

namespace
{

constexpr int imageSide = 12;

/// Six lamps, the faces of a cube around the origin, which shine inward.
std::vector<vtkSmartPointer<vtkAreaLightSource>> LampsOfCube(double half, double radiance)
{
  std::vector<vtkSmartPointer<vtkAreaLightSource>> lamps;
  for (int face = 0; face < 6; ++face)
  {
    double center[3] = { 0.0, 0.0, 0.0 };
    center[face / 2] = face % 2 ? half : -half;
    auto lamp = vtkSmartPointer<vtkAreaLightSource>::New();
    lamp->SetShapeToRectangle();
    lamp->SetCenter(center);
    lamp->SetNormal(-center[0], -center[1], -center[2]);
    lamp->SetUp(face / 2 == 1 ? 1.0 : 0.0, face / 2 == 1 ? 0.0 : 1.0, 0.0);
    lamp->SetWidth(2.0 * half);
    lamp->SetHeight(2.0 * half);
    lamp->SetRadiance(radiance);
    lamp->SetNumberOfWavelengths(2);
    lamps.push_back(lamp);
  }
  return lamps;
}

/// Filters for the light inside a cube of this half edge, with one camera.
struct Furnace
{
  vtkNew<vtkPhotonMapFilter> Photons;
  vtkNew<vtkScatteringImageFilter> Image;
  vtkNew<vtkPolyData> Nothing;

  Furnace(double half, double sigmaS)
  {
    this->Photons->SetInputData(this->Nothing);
    this->Image->SetInputData(this->Nothing);
    this->Photons->SetMediumBounds(-half, half, -half, half, -half, half);
    this->Image->SetMediumBounds(-half, half, -half, half, -half, half);
    this->Photons->SetSigmaS(sigmaS);
    this->Image->SetSigmaS(sigmaS);
    this->Image->SetPhotonMapConnection(this->Photons->GetOutputPort(0));
    this->Image->AddPhotonMapConnection(this->Photons->GetOutputPort(1));
    this->Image->SetResolution(imageSide, imageSide);
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0.3 * half, -0.2 * half, 0.4 * half);
    camera->SetFocalPoint(-half, 0.4 * half, -0.3 * half);
    camera->SetViewAngle(80.0);
    this->Image->SetCamera(camera);
  }
  void AddLamp(vtkAreaLightSource* lamp)
  {
    this->Photons->AddLightConnection(lamp->GetOutputPort());
    this->Image->AddLightConnection(lamp->GetOutputPort());
  }
  std::vector<double> Values(const char* name)
  {
    this->Image->Update();
    vtkDataArray* array = this->Image->GetOutput()->GetPointData()->GetArray(name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  }
};

double MeanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}
} // namespace

// A medium of albedo 1 in light of radiance 1 from all sides cannot be seen: every pixel is 1.
TEST(MultipleScattering, WhiteFurnace)
{
  Furnace furnace(1.0, 1.0);
  const auto lamps = LampsOfCube(1.0, 1.0);
  for (const auto& lamp : lamps)
  {
    furnace.AddLamp(lamp);
  }
  furnace.Photons->SetNumberOfPhotons(150000);
  // Parallel rays from outside share no photons near the camera: the mean over the image has hardly any noise.
  vtkCamera* camera = furnace.Image->GetCamera();
  camera->SetPosition(4.0, -1.4, 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7);
  const std::vector<double> radiance = furnace.Values("Radiance");
  const std::vector<double> multiple = furnace.Values("MultipleScattering");
  const std::vector<double> errors = furnace.Values("PhotonError");
  ASSERT_EQ(radiance.size(), static_cast<std::size_t>(imageSide * imageSide));
  EXPECT_GT(MeanOf(multiple), 0.15) << "there is something to be seen";
  EXPECT_NEAR(MeanOf(radiance), 1.0, 0.01) << "photons blur a little light out of the cube's edges";
  for (std::size_t i = 0; i < radiance.size(); ++i)
  {
    EXPECT_NEAR(radiance[i], 1.0, 0.01 + 4.0 * errors[i] * multiple[i]) << "pixel " << i;
  }

  for (const auto& lamp : lamps)
  {
    lamp->SetRadiance(0.5);
  }
  const std::vector<double> half = furnace.Values("MultipleScattering");
  for (std::size_t i = 0; i < half.size(); ++i)
  {
    EXPECT_NEAR(half[i], 0.5 * multiple[i], 1e-5);
  }
}

// Passes of fresh photons converge to the white furnace, and the spread between them tells how far they are from it.
TEST(MultipleScattering, PassesConvergeAndTellTheirError)
{
  Furnace furnace(1.0, 1.0);
  const auto lamps = LampsOfCube(1.0, 1.0);
  for (const auto& lamp : lamps)
  {
    furnace.AddLamp(lamp);
  }
  furnace.Image->RemoveAllPhotonMaps();
  furnace.Image->SetNumberOfPhotonsPerPass(2000);
  vtkCamera* camera = furnace.Image->GetCamera();
  camera->SetPosition(4.0, -1.4, 1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7);
  std::vector<double> found;
  std::vector<double> told;
  for (const int passes : { 1, 4, 16 })
  {
    furnace.Image->SetNumberOfPhotonPasses(passes);
    const std::vector<double> radiance = furnace.Values("Radiance");
    const std::vector<double> multiple = furnace.Values("MultipleScattering");
    const std::vector<double> errors = furnace.Values("PhotonError");
    ASSERT_EQ(multiple.size(), static_cast<std::size_t>(imageSide * imageSide));
    double squares = 0.0;
    double squaresTold = 0.0;
    for (std::size_t i = 0; i < radiance.size(); ++i)
    {
      squares += (radiance[i] - 1.0) * (radiance[i] - 1.0);
      squaresTold += errors[i] * multiple[i] * errors[i] * multiple[i];
    }
    found.push_back(std::sqrt(squares / static_cast<double>(radiance.size())));
    told.push_back(std::sqrt(squaresTold / static_cast<double>(radiance.size())));
    RecordProperty("found" + std::to_string(passes), std::to_string(found.back()));
    RecordProperty("told" + std::to_string(passes), std::to_string(told.back()));
  }
  // 16 times the photons: between 16^(-1/3) and 16^(-1/2), with room for what is random.
  EXPECT_LT(found[2] / found[0], 0.5);
  EXPECT_GT(found[2] / found[0], 0.15);
  for (const std::size_t several : { 1, 2 })
  {
    EXPECT_GT(told[several] / found[several], 0.7);
    EXPECT_LT(told[several] / found[several], 1.5);
  }
}

// In a diffuse sphere with a lamp at its centre every place gets the same light: a geometric series of its reflectance.
TEST(MultipleScattering, WhiteSphereIsAGeometricSeries)
{
  const double reflectance = 0.6;
  Furnace furnace(1.0, 0.0);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  furnace.Photons->SetInputConnection(sphere->GetOutputPort());
  furnace.Image->SetInputConnection(sphere->GetOutputPort());
  furnace.Photons->SetReflectance(reflectance);
  furnace.Image->SetReflectance(reflectance);
  vtkNew<vtkAreaLightSource> lamp;
  lamp->SetShapeToPoint();
  lamp->SetNumberOfWavelengths(2);
  furnace.AddLamp(lamp);
  furnace.Photons->SetNumberOfPhotons(100000);
  // Flux 4 pi over an area of 4 pi: an irradiance of 1 straight from the lamp.
  const double expected = reflectance / Pi * reflectance / (1.0 - reflectance);
  const std::vector<double> indirect = furnace.Values("IndirectSurface");
  ASSERT_FALSE(indirect.empty());
  EXPECT_NEAR(MeanOf(indirect) / expected, 1.0, 0.02);
  EXPECT_NEAR(MeanOf(furnace.Values("SurfaceRadiance")), reflectance / Pi, 0.02 * reflectance / Pi);
  EXPECT_EQ(MeanOf(furnace.Values("MultipleScattering")), 0.0);
}

TEST(MultipleScattering, MapsOfAKindAreAveraged)
{
  Furnace furnace(1.0, 2.0);
  furnace.AddLamp(LampsOfCube(1.0, 1.0)[0]);
  furnace.Photons->SetNumberOfPhotons(20000);
  furnace.Image->SetPhotonNeighbors(32);
  const double once = MeanOf(furnace.Values("MultipleScattering"));
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(furnace.Photons->GetOutput(1));
  furnace.Image->AddPhotonMapData(copy);
  furnace.Image->SetPhotonNeighbors(64); // every photon is there twice
  const double twice = MeanOf(furnace.Values("MultipleScattering"));
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(twice / once, 1.0, 0.03);
  furnace.Image->RemoveAllPhotonMaps();
  EXPECT_TRUE(furnace.Values("MultipleScattering").empty()) << "without a map there is no such array";
  EXPECT_EQ(furnace.Image->GetOutput()->GetPointData()->HasArray("PhotonError"), 0);
}

TEST(MultipleScattering, SaysWhatIsNoPhotonMapAndWhatIsAnother)
{
  Furnace furnace(1.0, 2.0);
  furnace.AddLamp(LampsOfCube(1.0, 1.0)[0]);
  furnace.Photons->SetNumberOfPhotons(1000);
  furnace.Image->SetSigmaA(0.5);
  EXPECT_SAYS(WarningsOf(furnace.Image), "was made in another medium (SigmaA)");
  furnace.Image->SetPhotonMapData(furnace.Nothing);
  EXPECT_SAYS(ErrorsOf(furnace.Image), "Photon map (input port 5): It has no field array \"PhotonMap\"");
  EXPECT_EQ(furnace.Image->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(furnace.Photons->GetOutput(1));
  broken->GetPointData()->RemoveArray("Power");
  furnace.Image->SetPhotonMapData(broken);
  EXPECT_SAYS(ErrorsOf(furnace.Image), "Power");
  furnace.Image->SetPhotonMapConnection(furnace.Photons->GetOutputPort(1));
  furnace.Image->SetPhotonNeighbors(-1);
  EXPECT_SAYS(ErrorsOf(furnace.Image), "PhotonNeighbors is -1: it must be 0 (automatic) or above");
}
