// SPDX-License-Identifier: BSD-3-Clause
// A mesh becomes a picture in space: where the camera looks, and the same that the chain of filters gives.
#include "vtkLightShafts.h"

#include "Messages.h"
#include "TestPolyData.h"
#include "vtkAreaLightSource.h"
#include "vtkLabelOccluders.h"
#include "vtkSceneDefaults.h"
#include "vtkScatteringImageFilter.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

using namespace shadowcones::testsupport;

namespace
{

vtkSmartPointer<vtkPolyData> Box()
{
  return MeshBuilder().AddBox(10.0, 21.0, 30.0, 1.0, 1.0, 0.8, 0).Build();
}

vtkSmartPointer<vtkLightShafts> Shafts(vtkDataObject* mesh, int width = 24, int height = 18)
{
  auto shafts = vtkSmartPointer<vtkLightShafts>::New();
  shafts->SetInputDataObject(0, mesh);
  shafts->SetResolution(width, height);
  shafts->SetRelativeErrorGoal(0.1);
  return shafts;
}

vtkPolyData* Picture(vtkLightShafts* shafts)
{
  return vtkPolyData::SafeDownCast(shafts->GetOutputDataObject(0));
}

vtkImageData* Image(vtkLightShafts* shafts)
{
  return vtkImageData::SafeDownCast(shafts->GetOutputDataObject(2));
}

vtkNew<vtkCamera> CameraOf(double parallelScale, bool horizontal)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(13.0, 24.0, 36.0);
  camera->SetFocalPoint(10.2, 21.1, 30.3);
  camera->SetViewUp(0.3, 1.0, 0.2); // not across the direction of view
  camera->SetViewAngle(25.0);
  camera->SetUseHorizontalViewAngle(horizontal);
  camera->SetParallelProjection(parallelScale > 0.0);
  camera->SetParallelScale(parallelScale > 0.0 ? parallelScale : 1.0);
  return camera;
}

} // namespace

TEST(LightShafts, PictureCoversWhatTheCameraSeesAtItsFocalPoint)
{
  const auto box = Box();
  for (const double scale : { 0.0, 1.7 })
  {
    for (const bool horizontal : { false, true })
    {
      const vtkNew<vtkCamera> camera = CameraOf(scale, horizontal);
      const auto shafts = Shafts(box);
      shafts->SetCamera(camera);
      shafts->Update();
      vtkPolyData* picture = Picture(shafts);
      ASSERT_EQ(picture->GetNumberOfPoints(), 25 * 19);
      ASSERT_EQ(picture->GetNumberOfCells(), 24 * 18);
      // VTK's own projection puts the corners of the picture into those of the view: lowest row first.
      const vtkIdType corners[4] = { 0, 24, 18 * 25, 18 * 25 + 24 };
      const double view[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { -1.0, 1.0 }, { 1.0, 1.0 } };
      vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(24.0 / 18.0, -1.0, 1.0);
      for (int k = 0; k < 4; ++k)
      {
        double point[4] = { 0.0, 0.0, 0.0, 1.0 };
        picture->GetPoint(corners[k], point);
        const double depth = (point[0] - 10.2) * camera->GetDirectionOfProjection()[0] +
          (point[1] - 21.1) * camera->GetDirectionOfProjection()[1] +
          (point[2] - 30.3) * camera->GetDirectionOfProjection()[2];
        EXPECT_NEAR(depth, 0.0, 1e-12);
        double seen[4];
        matrix->MultiplyPoint(point, seen);
        EXPECT_NEAR(seen[0] / seen[3], view[k][0], 1e-9) << scale << horizontal;
        EXPECT_NEAR(seen[1] / seen[3], view[k][1], 1e-9) << scale << horizontal;
      }
    }
  }
}

TEST(LightShafts, GivesWhatTheChainGives)
{
  const auto box = Box();
  const auto shafts = Shafts(box);
  shafts->Update();

  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputData(box);
  occluders->Update();
  vtkNew<vtkSceneDefaults> defaults;
  defaults->SetMesh(occluders->GetOutput());
  ASSERT_TRUE(defaults->Find());
  vtkNew<vtkAreaLightSource> lamp;
  defaults->PlaceLight(lamp);
  vtkNew<vtkCamera> camera;
  defaults->PlaceCamera(camera, 24.0 / 18.0);
  double medium[6];
  defaults->GetMediumBounds(medium);
  vtkNew<vtkScatteringImageFilter> image;
  image->SetInputConnection(occluders->GetOutputPort());
  image->SetLightConnection(lamp->GetOutputPort());
  image->SetCamera(camera);
  image->SetResolution(24, 18);
  image->SetRelativeErrorGoal(0.1);
  image->SetMediumBounds(medium);
  image->SetSigmaS(defaults->GetSigmaS());
  image->SetPhaseFunctionToHenyeyGreenstein();
  image->SetToneCurveToFilmic();
  image->Update();

  auto* rgb = vtkUnsignedCharArray::SafeDownCast(image->GetOutput()->GetPointData()->GetScalars());
  auto* ofImage = vtkUnsignedCharArray::SafeDownCast(Image(shafts)->GetPointData()->GetScalars());
  auto* ofPicture = vtkUnsignedCharArray::SafeDownCast(Picture(shafts)->GetCellData()->GetScalars());
  ASSERT_TRUE(rgb && ofImage && ofPicture);
  ASSERT_EQ(rgb->GetNumberOfValues(), 24 * 18 * 3);
  const unsigned char* values = rgb->GetPointer(0);
  EXPECT_TRUE(std::equal(values, values + 24 * 18 * 3, ofImage->GetPointer(0)));
  EXPECT_TRUE(std::equal(values, values + 24 * 18 * 3, ofPicture->GetPointer(0)));
  EXPECT_GT(rgb->GetRange(0)[1], 100.0); // there is light
  auto* shown = vtkPolyData::SafeDownCast(shafts->GetOutputDataObject(1));
  EXPECT_EQ(shown->GetNumberOfPoints(), lamp->GetOutput()->GetNumberOfPoints());
}

TEST(LightShafts, ConnectedLightsTakeThePlaceOfTheLamp)
{
  const auto box = Box();
  const auto shafts = Shafts(box);
  const auto lamp = LampAbove(60.0);
  lamp->SetRadiance(0.0);
  shafts->AddLightConnection(lamp->GetOutputPort());
  shafts->Update();
  EXPECT_EQ(vtkPolyData::SafeDownCast(shafts->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
  EXPECT_EQ(Image(shafts)->GetPointData()->GetArray("Radiance")->GetRange(-1)[1], 0.0);

  shafts->RemoveAllLights();
  shafts->Update();
  EXPECT_GT(Image(shafts)->GetPointData()->GetArray("Radiance")->GetRange(-1)[1], 0.0);
}

TEST(LightShafts, ThicknessOfTheMediumIsThatOfItsLongestSide)
{
  // Half a box of twice the thickness scatters as much in a unit of length.
  const auto box = Box();
  double coefficients[2];
  for (int k = 0; k < 2; ++k)
  {
    const auto shafts = Shafts(box, 4, 3);
    shafts->SetMediumBounds(9.0, k ? 11.0 : 13.0, 20.0, 21.0, 29.0, 30.0);
    shafts->SetOpticalDepth(k ? 0.4 : 0.8);
    shafts->Update();
    coefficients[k] = FieldValue(Image(shafts), "SigmaS");
  }
  EXPECT_DOUBLE_EQ(coefficients[0], 0.2);
  EXPECT_DOUBLE_EQ(coefficients[1], 0.2);
}

TEST(LightShafts, EmptyMeshGivesEmptyOutputs)
{
  vtkNew<vtkPolyData> nothing;
  const auto shafts = Shafts(nothing);
  EXPECT_EQ(ErrorsOf(shafts), "");
  EXPECT_EQ(Picture(shafts)->GetNumberOfPoints(), 0);
  EXPECT_EQ(Image(shafts)->GetNumberOfPoints(), 0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(shafts->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
}

TEST(LightShafts, SaysWhatIsWrongInItsOwnWordsAndInThoseOfTheChain)
{
  const auto box = Box();
  const auto said = [&](const std::function<void(vtkLightShafts*)>& spoil)
  {
    const auto shafts = Shafts(box);
    shafts->Update();
    spoil(shafts);
    const std::string errors = ErrorsOf(shafts);
    EXPECT_EQ(Picture(shafts)->GetNumberOfPoints(), 0) << errors;
    return errors;
  };
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetResolution(0, 3); }), "Resolution is 0 x 3: both must be at least 1");
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetUp(4); }), "Up is 4");
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetRelativeErrorGoal(0.0); }), "RelativeErrorGoal is 0: it must be above 0");
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetOpticalDepth(-1.0); }), "OpticalDepth is -1");
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetPhaseAsymmetry(1.0); }), "PhaseAsymmetry is 1: it must be between -1 and 1");
  EXPECT_SAYS(said([](vtkLightShafts* s) { s->SetMediumBounds(2.0, 1.0, 0.0, 1.0, 0.0, 1.0); }), "MediumBounds");
  vtkNew<vtkMultiBlockDataSet> lights;
  lights->SetBlock(0, vtkNew<vtkImageData>());
  EXPECT_SAYS(said([&](vtkLightShafts* s) { s->SetLightData(lights); }), "is a vtkImageData");
}

TEST(LightShafts, WarningsOfTheChainAreHeard)
{
  const auto shafts = Shafts(Box());
  shafts->SetExposure(3.0); // AutoExposure is on
  EXPECT_SAYS(WarningsOf(shafts), "Exposure");
}
