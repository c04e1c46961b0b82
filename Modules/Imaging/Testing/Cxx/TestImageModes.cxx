// SPDX-License-Identifier: BSD-3-Clause
// What the modes of the scattering image promise of each other, of their inputs and of their errors.
#include "vtkScatteringImageFilter.h"

#include "ImageTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkRegularPolygonSource.h"

using namespace imagetesting;

using ImageModes = ImageTest;

TEST_F(ImageModes, UnshadowedLightIsTheSameInTheFasterModes)
{
  this->Light->SetCenter(0.0, 2.6, 0.0); // above the medium, where a march converges soon
  this->Filter->SetNumberOfSteps(200);
  this->Filter->SetNumberOfLightSamples(64);
  this->Filter->SetInputData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetConeSetData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetVisibilityVolumeData(Constant("Visibility", 1.0f));
  const auto truth = this->Image();
  for (const int mode :
    { vtkScatteringImageFilter::Guided, vtkScatteringImageFilter::Soft, vtkScatteringImageFilter::Volume })
  {
    this->Filter->SetMode(mode);
    const auto image = this->Image();
    EXPECT_LT(Error(image, truth), 1e-3) << mode;
    EXPECT_EQ(Field(image, "NumberOfOcclusionRays"), 0.0) << mode;
  }
}

TEST_F(ImageModes, ReceiversHideNoLight)
{
  this->ConnectDisc();
  const auto labelled = [](const vtkSmartPointer<vtkPolyData>& mesh, int id)
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName("OccluderId");
    ids->SetNumberOfValues(mesh->GetNumberOfCells());
    ids->FillValue(id);
    mesh->GetCellData()->AddArray(ids);
    return mesh;
  };
  const vtkSmartPointer<vtkPolyData> casters = labelled(Disc(), 0);
  // All of the lamp lies behind the board, which no pixel sees.
  const vtkSmartPointer<vtkPolyData> board = labelled(Plane({ -1.5, 1.95, -1.5 }, { 3.0, 0.0, 0.0 }, { 0.0, 0.0, 3.0 }), -1);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(casters);
  both->AddInputData(board);
  both->Update();
  this->Camera->SetPosition(0.0, 0.0, 7.0);
  this->Camera->SetViewAngle(20.0);
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    this->Filter->SetInputData(casters);
    const auto without = this->Image();
    this->Filter->SetInputData(both->GetOutput());
    const auto with = this->Image();
    ASSERT_GT(Sum(without, "InScattering"), 0.0) << mode;
    ExpectSameBytes(with, without);
  }
}

TEST_F(ImageModes, GuidedIsTheDefaultAndKeepsItsGoal)
{
  EXPECT_EQ(vtkNew<vtkScatteringImageFilter>()->GetMode(), vtkScatteringImageFilter::Guided);
  this->ConnectDisc();
  this->Filter->SetNumberOfSteps(80);
  this->Filter->SetNumberOfLightSamples(36);
  const auto truth = this->Image();
  this->Filter->SetModeToGuided();
  this->Filter->SetMaximumSamples(100000);
  for (const double goal : { 0.05, 0.02 })
  {
    this->Filter->SetRelativeErrorGoal(goal);
    const auto image = this->Image();
    vtkDataArray* values = image->GetPointData()->GetArray("InScattering");
    vtkDataArray* expected = truth->GetPointData()->GetArray("InScattering");
    vtkDataArray* errors = image->GetPointData()->GetArray("RelativeError");
    vtkDataArray* noise = truth->GetPointData()->GetArray("RelativeError");
    int kept = 0;
    int inside = 0;
    int scattering = 0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const double value = values->GetComponent(i, 0);
      const double claimed = std::hypot(errors->GetComponent(i, 0), noise->GetComponent(i, 0));
      kept += value > 0.0 && errors->GetComponent(i, 0) <= 1.5 * goal;
      scattering += value > 0.0;
      inside += value > 0.0 && std::abs(value / expected->GetComponent(i, 0) - 1.0) <= 2.0 * claimed + 1e-3;
    }
    EXPECT_GE(kept, 0.9 * scattering) << goal; // the darkest pixels need not
    EXPECT_GE(inside, 0.95 * scattering) << goal;
    EXPECT_LT(Error(image, truth), goal);
  }
  const double rays = Field(this->Image(), "NumberOfOcclusionRays");
  this->Filter->SetMaximumSamples(4);
  this->Filter->SetNumberOfSurfaceLightSamples(0);
  EXPECT_LT(Field(this->Image(), "NumberOfOcclusionRays"), 0.5 * rays);
}

TEST_F(ImageModes, GuidedWithoutConesHasNoBias)
{
  this->ConnectDisc();
  this->Filter->SetNumberOfSteps(80);
  this->Filter->SetNumberOfLightSamples(36);
  const auto truth = this->Image();
  this->Filter->SetModeToGuided();
  const auto guided = this->Image();
  this->Filter->SetConeSetConnection(nullptr);
  const auto whole = this->Image();
  EXPECT_LT(Error(whole, truth), 0.01);
  EXPECT_GT(Sum(whole, "SampleCount"), Sum(guided, "SampleCount"));
}

TEST_F(ImageModes, VolumeAndSoftShowTheSameShadow)
{
  this->ConnectDisc();
  this->Filter->SetNumberOfSteps(80);
  this->Filter->SetNumberOfLightSamples(36);
  const auto truth = this->Image();
  this->Filter->SetModeToVolume();
  const auto volume = this->Image();
  EXPECT_LT(Error(volume, truth), 0.01);
  EXPECT_EQ(Field(volume, "Mode"), 5.0);
  this->Filter->SetModeToSoft();
  const auto soft = this->Image();
  EXPECT_LT(Error(soft, truth), 0.01);
  EXPECT_EQ(Field(soft, "NumberOfOcclusionRays"), 0.0);
  for (const auto& image : { volume, soft })
  {
    const double* range = image->GetPointData()->GetArray("RelativeError")->GetRange();
    EXPECT_EQ(range[0], -1.0);
    EXPECT_EQ(range[1], -1.0);
  }
  // Without the shadow it would be far off.
  this->Filter->SetConeSetData(vtkNew<vtkPolyData>().Get());
  EXPECT_GT(Error(this->Image(), truth), 0.03);
}

TEST_F(ImageModes, SoftTakesTheCosineOfItsDiscsBack)
{
  this->ConnectDisc();
  this->Filter->SetModeToSoft();
  const auto plain = this->Image();
  auto cones = DiscCone();
  const double cosine = 0.8; // of the light's direction to a tilted normal, by which a radius was divided
  vtkDataArray* radius = cones->GetPointData()->GetArray("BaseRadius");
  vtkDataArray* normal = cones->GetPointData()->GetArray("Normal");
  normal->SetTuple3(0, 0.6, cosine, 0.0);
  this->Filter->SetConeSetData(cones);
  const auto tilted = this->Image();
  radius->SetComponent(0, 0, cosine * discRadius);
  shadowcones::AddIntArray(cones->GetFieldData(), "CosineCorrection", 1, { 1 });
  cones->Modified();
  EXPECT_LT(Error(this->Image(), tilted), 1e-6);
  EXPECT_GT(Error(plain, tilted), 1e-4);
}

TEST_F(ImageModes, FastSoftAndVolumeNeedNoMesh)
{
  this->ConnectDisc();
  this->Filter->SetModeToSoft();
  const auto withMesh = this->Image();
  this->Filter->SetInputConnection(nullptr);
  const auto without = this->Image();
  EXPECT_EQ(Sum(without, "Depth"), -1.0 * width * height);
  EXPECT_LT(Error(without, withMesh), 0.05); // the plate hides a little of the medium
  for (const int mode : { vtkScatteringImageFilter::Fast, vtkScatteringImageFilter::Volume })
  {
    this->Filter->SetMode(mode);
    EXPECT_GT(Sum(this->Image(), "InScattering"), 0.0) << mode;
  }
  // The volume's box, or the cones' bases with the light, stand for the mesh's bounds.
  this->Filter->SetMediumBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  EXPECT_NEAR(Field(this->Image(), "MediumBounds", 2), discHeight - 0.05 * (lampHeight - discHeight), 1e-5);
  this->Filter->SetConeSetConnection(nullptr);
  EXPECT_NEAR(Field(this->Image(), "MediumBounds", 2), -2.0, 1e-5);
}

TEST_F(ImageModes, OutsideAVolumeEverythingIsLit)
{
  this->Filter->SetInputData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetVisibilityVolumeData(Constant("Visibility", 1.0f));
  this->Filter->SetModeToVolume();
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(1.9);
  const auto lit = this->Image();
  auto half = Constant("Visibility", 0.0f);
  half->SetSpacing(1.0, 2.0, 2.0); // from x = -2 to 0
  this->Filter->SetVisibilityVolumeData(half);
  const auto image = this->Image();
  vtkDataArray* values = image->GetPointData()->GetArray("InScattering");
  vtkDataArray* expected = lit->GetPointData()->GetArray("InScattering");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double all = expected->GetComponent(i, 0);
    EXPECT_NEAR(values->GetComponent(i, 0), i % width < width / 2 ? 0.0 : all, 1e-3 * all) << i;
  }
}

TEST_F(ImageModes, ANewCameraDoesNotFillTheVolumeAgain)
{
  this->ConnectDisc();
  this->Filter->SetModeToVolume();
  int executions = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&executions);
  count->SetCallback([](vtkObject*, unsigned long, void* executions, void*) { ++*static_cast<int*>(executions); });
  this->Volume->AddObserver(vtkCommand::StartEvent, count);
  double last = 0.0;
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Camera->Elevation(10.0);
    const double sum = Sum(this->Image(), "InScattering");
    EXPECT_NE(sum, last);
    last = sum;
  }
  int extent[6] = { 3, 7, 2, 5, 0, 0 };
  this->Filter->Modified();
  this->Filter->UpdateExtent(extent);
  EXPECT_EQ(executions, 1);
  this->Light->SetRadius(0.3);
  this->Image();
  EXPECT_EQ(executions, 2);
}

TEST_F(ImageModes, AConstantDensityIsAHomogeneousMedium)
{
  this->ConnectDisc();
  this->Filter->SetSigmaA(0.05);
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    this->Filter->SetSigmaS(0.2);
    this->Filter->SetSigmaA(0.1);
    this->Filter->SetDensityData(nullptr);
    const auto twice = this->Image();
    this->Filter->SetSigmaS(0.1);
    this->Filter->SetSigmaA(0.05);
    const auto once = this->Image();
    this->Filter->SetDensityData(Constant("Density", 2.0f, 9));
    EXPECT_LT(Error(this->Image(), twice), 1e-3) << mode;
    EXPECT_GT(Error(once, twice), 0.1) << mode;
  }
}

TEST_F(ImageModes, ThinFogAboveScattersLessThere)
{
  auto density = Constant("Density", 1.0f);
  vtkDataArray* values = density->GetPointData()->GetArray("Density");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, density->GetPoint(i)[1] > 0.5 ? 0.0 : 1.0);
  }
  this->ConnectDisc();
  this->Camera->ParallelProjectionOn();
  this->Camera->SetParallelScale(1.9);
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    this->Filter->SetDensityData(nullptr);
    const auto even = this->Image();
    this->Filter->SetDensityData(density);
    const auto bank = this->Image();
    const auto ratio = [&](int row)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(row) * width + 2; // beside the shadow
      return bank->GetPointData()->GetArray("InScattering")->GetComponent(pixel, 0) /
        even->GetPointData()->GetArray("InScattering")->GetComponent(pixel, 0);
    };
    EXPECT_LT(ratio(height - 1), 0.4) << mode; // between a density of 1 at y = 0 and of 0 at y = 2
    EXPECT_GT(ratio(0), 1.0) << mode;          // less fog on the way to the light
  }
}

TEST_F(ImageModes, ALightInsideTheMediumConverges)
{
  this->ConnectDisc();
  this->Filter->SetInputData(vtkNew<vtkPolyData>().Get());
  this->Filter->SetConeSetConnection(nullptr);
  this->Light->SetCenter(0.05, 1.0, 0.1);
  this->Filter->SetResolution(6, 5);
  this->Filter->SetNumberOfSteps(1000);
  this->Filter->SetMaximumDepth(6);
  this->Filter->SetNumberOfLightSamples(16);
  const auto truth = this->Image();
  this->Filter->SetModeToGuided();
  EXPECT_LT(Error(this->Image(), truth), 0.005) << "nothing in the way";
  // A plate close under it, without cones: the whole of every ray is sampled.
  vtkNew<vtkRegularPolygonSource> plate;
  plate->SetNumberOfSides(6);
  plate->SetRadius(0.3);
  plate->SetCenter(0.0, 0.8, 0.0);
  plate->SetNormal(0.1, 1.0, 0.0);
  this->Filter->SetInputConnection(plate->GetOutputPort());
  this->Filter->SetModeToBruteForce();
  this->Filter->SetNumberOfSteps(500);
  this->Filter->SetNumberOfLightSamples(25);
  const auto shadowed = this->Image();
  EXPECT_GT(Error(shadowed, truth), 0.05);
  this->Filter->SetModeToGuided();
  this->Filter->SetMaximumSamples(100000);
  double last = 1.0;
  for (const double goal : { 0.1, 0.02, 0.004 })
  {
    this->Filter->SetRelativeErrorGoal(goal);
    const double error = Error(this->Image(), shadowed);
    EXPECT_LT(error, last) << goal;
    last = error;
  }
  EXPECT_LT(last, 0.008);
}

TEST_F(ImageModes, EdgesAreSmoothWhereMoreSamplesAreTaken)
{
  this->ConnectDisc();
  this->Filter->SetModeToGuided();
  this->Camera->SetPosition(0.0, 5.0, 5.0);
  this->Filter->SetNumberOfEdgeSamples(1);
  const auto hard = this->Image();
  this->Filter->SetNumberOfEdgeSamples(16);
  const auto smooth = this->Image();
  vtkDataArray* depth = hard->GetPointData()->GetArray("Depth");
  vtkDataArray* air[2] = { hard->GetPointData()->GetArray("InScattering"),
    smooth->GetPointData()->GetArray("InScattering") };
  int mixed = 0;
  int same = 0;
  for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
  {
    mixed +=
      depth->GetComponent(i, 0) < 0.0 && smooth->GetPointData()->GetArray("SurfaceRadiance")->GetComponent(i, 0) > 0.0;
    same += air[0]->GetComponent(i, 0) == air[1]->GetComponent(i, 0);
  }
  EXPECT_GT(mixed, 0) << "a pixel whose centre misses the plate sees its edge";
  EXPECT_GT(Error(smooth, hard), 0.0) << "part of its medium term ends at the plate";
  EXPECT_GT(same, depth->GetNumberOfTuples() / 2) << "away from edges nothing changes";
}

TEST_F(ImageModes, AMediumTooDenseForTheMarchIsSaid)
{
  this->ConnectDisc();
  this->Filter->SetSigmaA(0.0);
  this->Filter->SetSigmaS(20.0);
  this->Filter->SetMaximumDepth(0);
  this->Filter->SetNumberOfSteps(64);
  imagetesting::Messages messages(this->Filter);
  for (const int mode : { vtkScatteringImageFilter::BruteForce, vtkScatteringImageFilter::Medium,
         vtkScatteringImageFilter::Fast, vtkScatteringImageFilter::Guided })
  {
    messages.Warnings.clear();
    this->Filter->SetMode(mode);
    this->Image();
    EXPECT_EQ(messages.Warnings.find("too dense for NumberOfSteps = 64") != std::string::npos,
      mode != vtkScatteringImageFilter::Guided)
      << "mode " << mode << ": " << messages.Warnings;
  }
  // Another medium, and steps that do for it.
  messages.Warnings.clear();
  this->Filter->SetModeToBruteForce();
  this->Filter->SetSigmaS(0.5);
  this->Image();
  EXPECT_EQ(messages.Warnings, "");
}
