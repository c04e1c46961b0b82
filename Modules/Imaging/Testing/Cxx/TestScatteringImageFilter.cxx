// SPDX-License-Identifier: BSD-3-Clause
// The scattering image as a filter: arrays, camera, pieces, progress, and a message for each fault.
#include "vtkScatteringImageFilter.h"

#include "ImageTesting.h"
#include "ProvedCones.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <limits>
#include <sstream>

using namespace imagetesting;

using ScatteringImageFilter = ImageTest;

TEST_F(ScatteringImageFilter, OutputHoldsEveryDocumentedArray)
{
  this->Filter->SetSigmaA(0.02);
  this->Filter->SetSigmaSSpectrum(2, 0.3);
  const auto image = this->Image();
  int extent[6];
  image->GetExtent(extent);
  EXPECT_EQ(extent[1], width - 1);
  EXPECT_EQ(extent[3], height - 1);
  EXPECT_EQ(extent[5], 0);
  const int types[] = { VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_FLOAT, VTK_INT, VTK_UNSIGNED_CHAR,
    VTK_FLOAT };
  const int components[] = { 7, 7, 7, 7, 1, 1, 1, 3, 1 };
  for (int i = 0; i < 9; ++i)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(arrays[i]);
    ASSERT_NE(array, nullptr) << arrays[i];
    EXPECT_EQ(array->GetDataType(), types[i]) << arrays[i];
    EXPECT_EQ(array->GetNumberOfComponents(), components[i]) << arrays[i];
    EXPECT_EQ(array->GetNumberOfTuples(), width * height) << arrays[i];
  }
  EXPECT_EQ(image->GetPointData()->GetScalars(), image->GetPointData()->GetArray("RGB"));
  EXPECT_GT(Sum(image, "InScattering"), 0.0);
  EXPECT_GT(Sum(image, "SurfaceRadiance"), 0.0);
  EXPECT_EQ(Field(image, "Mode"), 0.0);
  EXPECT_EQ(Field(image, "Seed"), 1.0);
  EXPECT_EQ(Field(image, "RelativeErrorGoal"), 0.01);
  EXPECT_EQ(Field(image, "CameraPosition", 2), 7.0);
  EXPECT_EQ(Field(image, "CameraViewAngle"), 38.0);
  EXPECT_EQ(Field(image, "SigmaS", 1), 0.1);
  EXPECT_EQ(Field(image, "SigmaS", 2), 0.3);
  EXPECT_EQ(Field(image, "SigmaA", 6), 0.02);
  EXPECT_EQ(Field(image, "MediumBounds", 3), 2.0);
  EXPECT_GT(Field(image, "NumberOfOcclusionRays"), 0.0);
  EXPECT_GE(Field(image, "RenderSeconds"), 0.0);
}

TEST_F(ScatteringImageFilter, MediumHasTheBytesOfBruteForceAndFastIsDarker)
{
  const auto bruteForce = this->Image();
  this->Filter->SetConeSetData(BoundingCone());
  this->Filter->SetModeToMedium();
  const auto medium = this->Image();
  ExpectSameBytes(bruteForce, medium);
  EXPECT_LT(Field(medium, "NumberOfOcclusionRays"), Field(bruteForce, "NumberOfOcclusionRays"));
  this->Filter->SetModeToFast();
  const auto fast = this->Image();
  EXPECT_LT(Sum(fast, "InScattering"), Sum(bruteForce, "InScattering"));
  EXPECT_EQ(Field(fast, "NumberOfOcclusionRays"), 0.0);
  // Cut short, the cones darken less (section 5).
  this->Filter->SetConeLength(1.5);
  EXPECT_GT(Sum(this->Image(), "InScattering"), Sum(fast, "InScattering"));
}

TEST_F(ScatteringImageFilter, BeyondTheBoundsOfAProofItAsksEverywhere)
{
  const auto truth = this->Image();
  // A set that holds nothing here, as if it were proved above y = 0 alone.
  auto cones = ConeSetOf({ MakeCone({ 50.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 0.1, 0.1, 0) });
  CertifyIn({ { -2.0, 0.0, -2.0 }, { 2.0, 2.0, 2.0 } }, cones);
  this->Filter->SetConeSetData(cones);
  this->Filter->SetModeToMedium();
  ExpectSameBytes(truth, this->Image());
  this->Filter->SetModeToGuided();
  EXPECT_NEAR(Sum(this->Image(), "InScattering"), Sum(truth, "InScattering"), 0.03 * Sum(truth, "InScattering"));
  // Everywhere, it says: then nothing is in shadow.
  CertifyIn({}, cones);
  this->Filter->Modified();
  EXPECT_GT(Sum(this->Image(), "InScattering"), 1.05 * Sum(truth, "InScattering"));
  this->Filter->SetModeToMedium();
  EXPECT_GT(Sum(this->Image(), "InScattering"), 1.05 * Sum(truth, "InScattering"));
}

TEST_F(ScatteringImageFilter, FastCastsShadowsOfOtherOccludersOnSurfaces)
{
  this->Filter->SetConeSetData(BoundingCone());
  this->Filter->SetModeToFast();
  this->Camera->SetPosition(0.0, 5.0, 6.0);
  // Without ids the floor is the cone's own occluder; with them it is another one and lies in the cone.
  const double own = Sum(this->Image(), "SurfaceRadiance");
  auto mesh = PlateAndFloor();
  shadowcones::AddIntArray(mesh->GetCellData(), "OccluderId", 1, { 0, 1 });
  this->Filter->SetInputData(mesh);
  const double foreign = Sum(this->Image(), "SurfaceRadiance");
  EXPECT_LT(foreign, 0.7 * own);
  EXPECT_GT(foreign, 0.0);
}

TEST_F(ScatteringImageFilter, AnUnoccludedSceneIsTheSameInEveryMode)
{
  this->Filter->SetInputData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetConeSetData(vtkNew<vtkPolyData>().Get());
  const auto bruteForce = this->Image();
  EXPECT_GT(Sum(bruteForce, "InScattering"), 0.0);
  EXPECT_EQ(Sum(bruteForce, "Depth"), -1.0 * width * height);
  this->Filter->SetModeToMedium();
  ExpectSameBytes(bruteForce, this->Image());
  this->Filter->SetModeToFast();
  ExpectSameBytes(bruteForce, this->Image());
}

TEST_F(ScatteringImageFilter, FourPiecesMakeTheWholeImage)
{
  this->ConnectDisc();
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    const auto whole = this->Image();
    double rays = 0.0;
    int pixels = 0;
    for (int piece = 0; piece < 4; ++piece)
    {
      this->Filter->Modified();
      this->Filter->UpdateInformation();
      this->Filter->UpdatePiece(piece, 4, 0);
      vtkImageData* part = this->Filter->GetOutput();
      int extent[6];
      part->GetExtent(extent);
      ASSERT_LT(part->GetNumberOfPoints(), width * height);
      rays += Field(part, "NumberOfOcclusionRays");
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i, ++pixels)
        {
          int ijk[3] = { i, j, 0 };
          for (const char* name : arrays)
          {
            vtkDataArray* a = part->GetPointData()->GetArray(name);
            vtkDataArray* b = whole->GetPointData()->GetArray(name);
            for (int c = 0; c < a->GetNumberOfComponents(); ++c)
            {
              ASSERT_EQ(a->GetComponent(part->ComputePointId(ijk), c), b->GetComponent(whole->ComputePointId(ijk), c))
                << name << " in mode " << mode;
            }
          }
        }
      }
    }
    // Pieces of structured data share their borders.
    EXPECT_GE(pixels, width * height);
    EXPECT_GE(rays, Field(whole, "NumberOfOcclusionRays"));
  }
}

TEST_F(ScatteringImageFilter, ASubExtentIsCutFromTheWhole)
{
  this->ConnectDisc();
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    const auto whole = this->Image();
    int extent[6] = { 3, 7, 2, 5, 0, 0 };
    this->Filter->Modified();
    this->Filter->UpdateExtent(extent);
    vtkImageData* part = this->Filter->GetOutput();
    ASSERT_EQ(part->GetNumberOfPoints(), 20);
    int ijk[3] = { 4, 3, 0 };
    vtkDataArray* a = part->GetPointData()->GetArray("Radiance");
    vtkDataArray* b = whole->GetPointData()->GetArray("Radiance");
    EXPECT_EQ(a->GetComponent(part->ComputePointId(ijk), 0), b->GetComponent(whole->ComputePointId(ijk), 0)) << mode;
  }
}

TEST_F(ScatteringImageFilter, TheCameraIsPartOfTheState)
{
  const auto before = this->Image();
  const vtkMTimeType time = this->Filter->GetMTime();
  this->Camera->Azimuth(20.0);
  EXPECT_GT(this->Filter->GetMTime(), time);
  EXPECT_NE(Sum(before, "Depth"), Sum(this->Image(), "Depth"));
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(2.5);
  const auto parallel = this->Image();
  EXPECT_EQ(Field(parallel, "CameraParallelProjection"), 1.0);
  EXPECT_GT(Sum(parallel, "InScattering"), 0.0);
}

TEST_F(ScatteringImageFilter, WithoutACameraItLooksAtTheMeshFromTheFront)
{
  this->Filter->SetCamera(nullptr);
  const auto image = this->Image();
  EXPECT_EQ(Field(image, "CameraPosition", 0), 0.0);
  EXPECT_GT(Field(image, "CameraPosition", 2), 2.0);
  int seen = 0;
  vtkDataArray* depth = image->GetPointData()->GetArray("Depth");
  for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
  {
    seen += depth->GetComponent(i, 0) > 0.0;
  }
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, width * height);
}

TEST_F(ScatteringImageFilter, UnsetBoundsAreTheJointBoundsEnlarged)
{
  this->Filter->SetMediumBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  const auto image = this->Image();
  EXPECT_NEAR(Field(image, "MediumBounds", 0), -2.2, 1e-6);
  EXPECT_NEAR(Field(image, "MediumBounds", 1), 2.2, 1e-6);
  // From the floor at -1.9 to the lamp at 2: 3.9 high.
  EXPECT_NEAR(Field(image, "MediumBounds", 2), -1.9 - 0.195, 1e-5);
  EXPECT_NEAR(Field(image, "MediumBounds", 3), 2.0 + 0.195, 1e-5);
}

TEST_F(ScatteringImageFilter, ReflectanceComesFromTheMesh)
{
  this->Filter->SetSigmaS(0.0);
  const double half = Sum(this->Image(), "SurfaceRadiance");
  auto mesh = PlateAndFloor();
  shadowcones::AddFloatArray(mesh->GetCellData(), "Reflectance", 1, { 0.25f, 0.25f });
  this->Filter->SetInputData(mesh);
  EXPECT_NEAR(Sum(this->Image(), "SurfaceRadiance"), 0.5 * half, 1e-5 * half);
}

TEST_F(ScatteringImageFilter, NormalsOfTheMeshShadeItsSurfaces)
{
  // Turned by 60 degrees from the light, which is above: half of it is left where it is small and far.
  this->Light->SetRadius(0.01);
  auto mesh = PlateAndFloor();
  this->Filter->SetInputData(mesh);
  const auto flat = this->Image();
  std::vector<float> normals;
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    normals.insert(normals.end(), { 0.0f, 1.0f, 0.0f });
  }
  auto same = PlateAndFloor();
  shadowcones::AddFloatArray(same->GetPointData(), "Normals", 3, normals);
  this->Filter->SetInputData(same);
  EXPECT_NEAR(Sum(this->Image(), "SurfaceRadiance") / Sum(flat, "SurfaceRadiance"), 1.0, 1e-3);
  for (std::size_t k = 0; k < normals.size(); k += 3)
  {
    normals[k] = std::sqrt(0.75f);
    normals[k + 1] = 0.5f;
  }
  auto turned = PlateAndFloor();
  shadowcones::AddFloatArray(turned->GetPointData(), "Normals", 3, normals);
  this->Filter->SetInputData(turned);
  // On average over places to the left and right of the lamp.
  EXPECT_NEAR(Sum(this->Image(), "SurfaceRadiance") / Sum(flat, "SurfaceRadiance"), 0.5, 0.1);
}

TEST_F(ScatteringImageFilter, LightWavelengthsGiveRgbItsColours)
{
  this->Light->SetNumberOfWavelengths(2);
  this->Light->Update();
  vtkNew<vtkPolyData> light;
  light->DeepCopy(this->Light->GetOutput());
  light->GetFieldData()->RemoveArray("LightSpectrum");
  shadowcones::AddDoubleArray(light->GetFieldData(), "LightSpectrum", 1, { 0.0, 1.0 });
  const auto redness = [this, &light](double second)
  {
    light->GetFieldData()->RemoveArray("LightWavelengths");
    shadowcones::AddDoubleArray(light->GetFieldData(), "LightWavelengths", 1, { 550.0, second });
    light->Modified();
    this->Filter->SetLightData(light);
    const auto image = this->Image();
    double red = 0.0;
    double blue = 0.0;
    vtkDataArray* rgb = image->GetPointData()->GetArray("RGB");
    for (vtkIdType i = 0; i < rgb->GetNumberOfTuples(); ++i)
    {
      red += rgb->GetComponent(i, 0);
      blue += rgb->GetComponent(i, 2);
    }
    return red - blue;
  };
  EXPECT_GT(redness(620.0), 0.0);
  EXPECT_LT(redness(450.0), 0.0);
}

TEST_F(ScatteringImageFilter, PresetsSetTheLobes)
{
  this->Filter->SetPhasePresetToMurkyMie();
  EXPECT_EQ(this->Filter->GetPhaseFunction(), vtkScatteringImageFilter::BlasiSchlick);
  EXPECT_DOUBLE_EQ(this->Filter->GetPhaseLobes()[2], 0.91);
  this->Filter->SetPhasePresetToHazyMie();
  EXPECT_DOUBLE_EQ(this->Filter->GetPhaseLobes()[0], 0.12);
  this->Filter->SetPhasePresetToRayleigh();
  const double lobes = Sum(this->Image(), "InScattering");
  this->Filter->SetPhaseFunctionToRayleigh();
  EXPECT_NEAR(lobes / Sum(this->Image(), "InScattering"), 1.0, 0.052);
  this->Filter->SetPhaseFunctionToIsotropic();
  const double isotropic = Sum(this->Image(), "InScattering");
  this->Filter->SetPhaseFunctionToHenyeyGreenstein();
  EXPECT_NEAR(Sum(this->Image(), "InScattering") / isotropic, 1.0, 1e-6) << "asymmetry 0";
}

TEST_F(ScatteringImageFilter, MissingInputsHaveTheirOwnMessages)
{
  this->Image(); // so that an old image could be left behind
  this->Filter->SetModeToMedium();
  this->ExpectError("Mode is Medium but there is no cone set: connect a vtkConeSetFilter");
  this->Filter->SetModeToFast();
  this->ExpectError("Mode is Fast but there is no cone set");
  this->Filter->SetModeToSoft();
  this->ExpectError("Mode is Soft but there is no cone set");
  this->Filter->SetModeToVolume();
  this->ExpectError("Mode is Volume but there is no visibility volume: connect a vtkVisibilityVolume");
  this->Filter->SetInputConnection(nullptr);
  this->Filter->SetModeToGuided();
  this->ExpectError("Mode is Guided but there is no mesh: connect a vtkLabelOccluders");
  this->Filter->SetModeToBruteForce();
  this->ExpectError("Mode is BruteForce but there is no mesh");
  this->Filter->SetInputData(PlateAndFloor());
  this->Filter->SetModeToFast();
  auto cones = BoundingCone();
  cones->GetPointData()->RemoveArray("BaseRadius");
  this->Filter->SetConeSetData(cones);
  this->ExpectError("\"BaseRadius\"");
  this->Filter->SetModeToBruteForce();
  this->Filter->SetLightConnection(nullptr);
  this->ExpectError("There is no light: connect a vtkAreaLightSource");
  this->Filter->SetLightData(vtkNew<vtkPolyData>().Get());
  this->ExpectError("Light (input port 1):");
}

TEST_F(ScatteringImageFilter, BadInputsHaveTheirOwnMessages)
{
  auto mesh = PlateAndFloor();
  mesh->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
  this->Filter->SetInputData(mesh);
  this->ExpectError("Mesh (input port 0): Point 3");

  mesh = PlateAndFloor();
  shadowcones::AddFloatArray(mesh->GetCellData(), "Reflectance", 3, std::vector<float>(6, 0.5f));
  this->Filter->SetInputData(mesh);
  this->ExpectError("\"Reflectance\" of the mesh has 3 components: it must have 1, or 7");

  mesh = PlateAndFloor();
  shadowcones::AddFloatArray(mesh->GetCellData(), "Reflectance", 1, { 0.5f, 1.5f });
  this->Filter->SetInputData(mesh);
  this->ExpectError("\"Reflectance\" of the mesh is 1.5 at cell 1");

  mesh = PlateAndFloor();
  shadowcones::AddFloatArray(mesh->GetCellData(), "Reflectance", 1, { 0.5f });
  this->Filter->SetInputData(mesh);
  this->ExpectError("\"Reflectance\" of the mesh has 1 tuples for 2 cells");

  mesh = PlateAndFloor();
  shadowcones::AddFloatArray(mesh->GetPointData(), "Normals", 3, std::vector<float>(3, 0.5f));
  this->Filter->SetInputData(mesh);
  this->ExpectError("\"Normals\" of the mesh has 1 tuples of 3 components for");

  this->Filter->SetInputData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetMediumBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  this->Light->SetShapeToSun();
  this->ExpectError("MediumBounds are not set");

  this->Filter->SetMediumBounds(-1.0, 1.0, 0.0, 0.0, -1.0, 1.0);
  this->Filter->SetConeSetData(DiscCone());
  this->Filter->SetModeToSoft();
  this->ExpectError("Mode is Soft and MediumBounds are flat");
}

TEST_F(ScatteringImageFilter, BadImagesHaveTheirOwnMessages)
{
  this->Image();
  this->Filter->SetModeToVolume();
  this->Filter->SetVisibilityVolumeData(Constant("Light", 1.0f));
  this->ExpectError("Visibility volume (input port 3): The visibility volume has no point array \"Visibility\"");
  auto volume = Constant("Visibility", 1.0f);
  volume->GetPointData()->GetArray("Visibility")->SetComponent(5, 0, std::nan(""));
  this->Filter->SetVisibilityVolumeData(volume);
  this->ExpectError("\"Visibility\" of the visibility volume is nan at point 5");
  this->Filter->SetVisibilityVolumeData(vtkNew<vtkImageData>().Get());
  this->ExpectError("Visibility volume (input port 3): ");
  this->Filter->SetVisibilityVolumeData(Constant("Visibility", 1.0f));
  for (const int mode : { vtkScatteringImageFilter::BruteForce, vtkScatteringImageFilter::Volume })
  {
    this->Filter->SetMode(mode);
    this->Filter->SetDensityData(Constant("Density", -1.0f));
    this->ExpectError("Density (input port 4): ");
    this->Filter->SetDensityData(nullptr);
    EXPECT_GT(Sum(this->Image(), "InScattering"), 0.0);
  }
  // What is not used is not read.
  this->Filter->SetVisibilityVolumeData(volume);
  this->Filter->SetModeToBruteForce();
  EXPECT_GT(Sum(this->Image(), "InScattering"), 0.0);
}

TEST_F(ScatteringImageFilter, BadParametersHaveTheirOwnMessages)
{
  const double nan = std::nan("");
  vtkScatteringImageFilter* f = this->Filter;
  const auto expect = [&](const char* message, auto&& set, auto&& restore)
  {
    set();
    this->ExpectError(message);
    restore();
  };
  expect(
    "Mode is 7", [&] { f->SetMode(7); }, [&] { f->SetModeToBruteForce(); });
  expect(
    "PhaseFunction is -1", [&] { f->SetPhaseFunction(-1); }, [&] { f->SetPhaseFunctionToIsotropic(); });
  expect(
    "PhaseLobes are 2", [&] { f->SetPhaseLobes(2.0, 0.0, 0.0); }, [&] { f->SetPhaseLobes(0.5, 0.1, 0.1); });
  expect(
    "PhaseAsymmetry is 1", [&] { f->SetPhaseAsymmetry(1.0); }, [&] { f->SetPhaseAsymmetry(0.0); });
  expect(
    "NumberOfSteps is 0", [&] { f->SetNumberOfSteps(0); }, [&] { f->SetNumberOfSteps(4); });
  expect(
    "MaximumDepth is 17", [&] { f->SetMaximumDepth(17); }, [&] { f->SetMaximumDepth(1); });
  expect(
    "IntensityThreshold is nan", [&] { f->SetIntensityThreshold(nan); }, [&] { f->SetIntensityThreshold(0.1); });
  expect(
    "NumberOfLightSamples is 0", [&] { f->SetNumberOfLightSamples(0); }, [&] { f->SetNumberOfLightSamples(2); });
  expect(
    "NumberOfSurfaceLightSamples is -1", [&] { f->SetNumberOfSurfaceLightSamples(-1); },
    [&] { f->SetNumberOfSurfaceLightSamples(2); });
  expect(
    "NumberOfEdgeSamples is 0", [&] { f->SetNumberOfEdgeSamples(0); }, [&] { f->SetNumberOfEdgeSamples(1); });
  expect(
    "RelativeErrorGoal is -0.01", [&] { f->SetRelativeErrorGoal(-0.01); }, [&] { f->SetRelativeErrorGoal(0.01); });
  expect(
    "MaximumSamples is 0", [&] { f->SetMaximumSamples(0); }, [&] { f->SetMaximumSamples(8); });
  expect(
    "SoftDimensions are 65, 1, 65", [&] { f->SetSoftDimensions(65, 1, 65); }, [&] { f->SetSoftDimensions(9, 9, 9); });
  expect(
    "SoftDimensions are 2000, 2000, 2000", [&] { f->SetSoftDimensions(2000, 2000, 2000); },
    [&] { f->SetSoftDimensions(9, 9, 9); });
  expect(
    "NumberOfSoftLightSamples is 65537", [&] { f->SetNumberOfSoftLightSamples(65537); },
    [&] { f->SetNumberOfSoftLightSamples(64); });
  expect(
    "Reflectance is 1.1", [&] { f->SetReflectance(1.1); }, [&] { f->SetReflectance(0.5); });
  expect(
    "ConeLength is -1", [&] { f->SetConeLength(-1.0); }, [&] { f->SetConeLength(0.0); });
  expect(
    "Exposure is 0", [&] { f->SetExposure(0.0); }, [&] { f->SetExposure(1.0); });
  expect(
    "ToneCurve is 2", [&] { f->SetToneCurve(2); }, [&] { f->SetToneCurveToLinear(); });
  expect(
    "SigmaS is -1 at wavelength sample 0", [&] { f->SetSigmaS(-1.0); }, [&] { f->SetSigmaS(0.1); });
  expect(
    "SigmaA is inf at wavelength sample 3", [&] { f->SetSigmaASpectrum(3, std::numeric_limits<double>::infinity()); },
    [&] { f->SetSigmaA(0.0); });
  expect(
    "SigmaSSpectrum is set for wavelength sample 7: the light has 7, which count from 0.",
    [&] { f->SetSigmaSSpectrum(7, 0.1); }, [&] { f->SetSigmaS(0.1); });
  expect(
    "MediumBounds along y", [&] { f->SetMediumBounds(0.0, 1.0, 1.0, 0.0, 0.0, 1.0); },
    [&] { f->SetMediumBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0); });
  expect(
    "Resolution is 0 x 4", [&] { f->SetResolution(0, 4); }, [&] { f->SetResolution(4, 4); });
  expect(
    "The camera's position and focal point must be finite and differ",
    [&] { this->Camera->SetPosition(nan, 0.0, 0.0); }, [&] { this->Camera->SetPosition(0.0, 0.0, 7.0); });
  expect(
    "The camera's view up runs along its direction of view", [&] { this->Camera->SetViewUp(0.0, 0.0, 1.0); },
    [&] { this->Camera->SetViewUp(0.0, 1.0, 0.0); });
  // After all that the filter still works.
  EXPECT_GT(Sum(this->Image(), "InScattering"), 0.0);
}

TEST_F(ScatteringImageFilter, FarAwayAndTinyMeshesWork)
{
  const double whole = Sum(this->Image(), "InScattering");
  auto mesh = PlateAndFloor();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points->InsertNextPoint(p[0] + 1e6, p[1], p[2]);
  }
  mesh->SetPoints(points);
  this->Filter->SetInputData(mesh);
  this->Light->SetCenter(1e6, 2.0, 0.0);
  this->Filter->SetMediumBounds(1e6 - 2.0, 1e6 + 2.0, -2.0, 2.0, -2.0, 2.0);
  this->Camera->SetPosition(1e6, 0.0, 7.0);
  this->Camera->SetFocalPoint(1e6, 0.0, 0.0);
  EXPECT_NEAR(Sum(this->Image(), "InScattering") / whole, 1.0, 0.01);
}

TEST_F(ScatteringImageFilter, PrintsEveryMember)
{
  std::ostringstream text;
  this->Filter->SetSigmaSSpectrum(1, 0.4);
  this->Filter->Print(text);
  for (const char* name : { "Camera:", "Resolution: 12 x 10", "Mode:", "SigmaS:", "SigmaSSpectrum: [1] 0.4",
         "SigmaA:", "SigmaASpectrum: (none)", "PhaseFunction:", "PhaseLobes:", "PhaseAsymmetry:", "MediumBounds:",
         "NumberOfSteps: 10", "MaximumDepth:", "IntensityThreshold:", "NumberOfLightSamples: 4",
         "NumberOfSurfaceLightSamples:", "NumberOfEdgeSamples: 4", "RelativeErrorGoal: 0.01", "MaximumSamples: 1024",
         "SoftDimensions: 65, 65, 65", "NumberOfSoftLightSamples: 64", "LightVisible: On",
         "Reflectance:", "ConeLength:", "Exposure:", "ToneCurve: 0", "Seed:" })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name;
  }
}

TEST_F(ScatteringImageFilter, SpectraFillFromTheCommonValue)
{
  this->Filter->SetSigmaS(0.2);
  this->Filter->SetSigmaSSpectrum(4, 0.5);
  EXPECT_EQ(this->Filter->GetSigmaSSpectrum(3), 0.2);
  EXPECT_EQ(this->Filter->GetSigmaSSpectrum(4), 0.5);
  EXPECT_EQ(this->Filter->GetSigmaSSpectrum(6), 0.2);
  this->Filter->SetSigmaS(0.2);
  EXPECT_EQ(this->Filter->GetSigmaSSpectrum(4), 0.2) << "every wavelength again";

  vtkNew<vtkDoubleArray> coefficients;
  coefficients->InsertNextValue(0.3);
  coefficients->InsertNextValue(0.7);
  this->Filter->SetSigmaASpectrum(5, 1.0);
  this->Filter->SetSigmaASpectrum(coefficients);
  EXPECT_EQ(this->Filter->GetSigmaASpectrum(1), 0.7);
  EXPECT_EQ(this->Filter->GetSigmaASpectrum(5), 0.0) << "an array takes the place of all that were set";
  const vtkMTimeType set = this->Filter->GetMTime();
  this->Filter->SetSigmaASpectrum(coefficients);
  EXPECT_EQ(this->Filter->GetMTime(), set) << "nothing has changed";
  this->Filter->ClearSigmaASpectrum();
  EXPECT_EQ(this->Filter->GetSigmaASpectrum(1), 0.0);
  EXPECT_GT(this->Filter->GetMTime(), set);
}

TEST_F(ScatteringImageFilter, TheDensityArrayCanBeChosen)
{
  // Twice as dense is what twice the coefficients are.
  this->Filter->SetResolution(5, 4);
  this->Filter->SetDensityData(Constant("Density", 1.0f));
  this->Filter->SetSigmaS(0.2);
  const auto expected = this->Image();
  const auto density = Constant("Density", 1.0f);
  shadowcones::AddFloatArray(density->GetPointData(), "Smoke", 1, std::vector<float>(27, 2.0f));
  shadowcones::AddFloatArray(density->GetCellData(), "Dust", 1, std::vector<float>(8, 3.0f));
  density->GetPointData()->SetActiveScalars("Smoke");
  this->Filter->SetDensityData(density);
  const double sum = Sum(expected, "InScattering");
  EXPECT_NEAR(Sum(this->Image(), "InScattering"), sum, 1e-5 * sum); // "Density", as without a choice
  this->Filter->SetSigmaS(0.1);
  this->Filter->SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Smoke");
  EXPECT_NEAR(Sum(this->Image(), "InScattering"), sum, 1e-5 * sum);
  this->Filter->SetInputArrayToProcess(
    0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  EXPECT_NEAR(Sum(this->Image(), "InScattering"), sum, 1e-5 * sum);

  this->Filter->SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Smok");
  this->ExpectError("The density on input port 4 has no point array \"Smok\", which SetInputArrayToProcess chooses: it has "
                    "\"Density\", \"Smoke\".");
  this->Filter->SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Dust");
  this->ExpectError("SetInputArrayToProcess chooses a density that is not point data: run vtkCellDataToPointData first.");
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Smoke");
  this->ExpectError("SetInputArrayToProcess chooses an array of input port 0: the only one to be chosen is the density's");
  this->Filter->SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::TENSORS);
  this->ExpectError("The density on input port 4 lacks the attribute that SetInputArrayToProcess chooses.");
  this->Filter->SetInputArrayToProcess(0, 4, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ""); // no choice
  this->Filter->SetSigmaS(0.2);
  EXPECT_NEAR(Sum(this->Image(), "InScattering"), sum, 1e-5 * sum);
}

TEST_F(ScatteringImageFilter, TheResolutionMayChangeAfterAFault)
{
  this->Filter->SetResolution(4, 3);
  this->Image();
  this->Filter->SetNumberOfSteps(0);
  this->ExpectError("NumberOfSteps is 0");
  for (const int edge : { 6, 2 })
  {
    this->Filter->SetResolution(edge, 0);
    this->ExpectError("both must be at least 1");
    this->Filter->SetResolution(edge, edge + 1);
    this->Filter->SetNumberOfSteps(0);
    this->ExpectError("NumberOfSteps is 0");
    this->Filter->SetNumberOfSteps(2);
    EXPECT_EQ(this->Image()->GetNumberOfPoints(), edge * (edge + 1));
  }
}
