// SPDX-License-Identifier: BSD-3-Clause
// Several lights in images and visibility volumes.
#include "ImageTesting.h"

#include "vtkAbstractArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>

using namespace imagetesting;

namespace
{
/// Two lamps over the round plate, and the cone for both.
class LightsOfImage : public ImageTest
{
protected:
  LightsOfImage()
  {
    this->Second->SetShapeToSphere();
    this->Second->SetCenter(1.0, 1.7, 0.3);
    this->Second->SetRadius(0.2);
    this->Second->SetRadiance(2.0);
    this->ConnectDisc();
    // Cones that tell no light stand for all.
    const auto cones = DiscCone();
    cones->GetPointData()->RemoveArray("LightId");
    cones->GetPointData()->GetArray("HalfAngle")->SetComponent(0, 0, 1.2);
    this->Filter->SetConeSetData(cones);
    this->Volume->SetInputData(cones);
    this->Filter->SetRelativeErrorGoal(0.05);
    this->Filter->SetNumberOfEdgeSamples(1);
    this->Volume->SetDimensions(13, 13, 13);
    this->Filter->SetSoftDimensions(13, 13, 13);
  }

  vtkSmartPointer<vtkImageData> ImageOf(const std::vector<vtkAreaLightSource*>& lamps)
  {
    this->Filter->RemoveAllLights();
    this->Volume->RemoveAllLights();
    for (vtkAreaLightSource* lamp : lamps)
    {
      this->Filter->AddLightConnection(lamp->GetOutputPort());
      this->Volume->AddLightConnection(lamp->GetOutputPort());
    }
    return this->Image();
  }

  vtkNew<vtkAreaLightSource> Second;
};
} // anonymous namespace

TEST_F(LightsOfImage, RadianceAddsUpInEveryMode)
{
  this->Filter->LightVisibleOn();
  Messages messages(this->Filter);
  for (const int mode : allModes)
  {
    this->Filter->SetMode(mode);
    const auto both = this->ImageOf({ this->Light, this->Second });
    const auto one = this->ImageOf({ this->Light });
    const auto two = this->ImageOf({ this->Second });
    for (const char* name : { "InScattering", "SurfaceRadiance", "Radiance" })
    {
      vtkDataArray* sum = both->GetPointData()->GetArray(name);
      for (vtkIdType i = 0; i < sum->GetNumberOfTuples(); ++i)
      {
        const double parts = one->GetPointData()->GetArray(name)->GetComponent(i, 0) +
          two->GetPointData()->GetArray(name)->GetComponent(i, 0);
        ASSERT_NEAR(sum->GetComponent(i, 0), parts, 2e-6 * parts) << name << " of mode " << mode << " at " << i;
      }
    }
    EXPECT_EQ(both->GetFieldData()->GetAbstractArray("LightFingerprint")->GetNumberOfTuples(), 2);
  }
  EXPECT_EQ(messages.Errors, "");
}

TEST_F(LightsOfImage, BlocksAreLights)
{
  this->Light->Update();
  this->Second->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, this->Light->GetOutput());
  blocks->SetBlock(1, this->Second->GetOutput());
  const auto connected = this->ImageOf({ this->Light, this->Second });
  this->Filter->SetLightData(blocks);
  const auto block = this->Image();
  ExpectSameBytes(connected, block);
}

TEST_F(LightsOfImage, AVolumeHasAComponentALight)
{
  this->ImageOf({ this->Light, this->Second });
  this->Volume->Update();
  vtkPointData* data = this->Volume->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetArray("Visibility")->GetNumberOfComponents(), 2);
  ASSERT_EQ(data->GetArray("ShadowClass")->GetNumberOfComponents(), 2);
  EXPECT_EQ(data->GetArray("Marked")->GetNumberOfComponents(), 1);
  // Under the middle of the plate all of the lamp above is hidden; far to the left the other lamp's shadow lies.
  vtkImageData* volume = this->Volume->GetOutput();
  const vtkIdType below = volume->FindPoint(0.0, 0.3, 0.0);
  EXPECT_EQ(data->GetArray("Visibility")->GetComponent(below, 0), 0.0);
  const vtkIdType left = volume->FindPoint(-1.3, -1.0, -0.3);
  EXPECT_EQ(data->GetArray("Visibility")->GetComponent(left, 1), 0.0);
  EXPECT_GT(data->GetArray("Visibility")->GetComponent(left, 0), 0.2);
  // Of one lamp when two are connected: not enough.
  this->ImageOf({ this->Light });
  this->Filter->SetModeToVolume();
  this->Filter->AddLightConnection(this->Second->GetOutputPort());
  this->ExpectError("has 1 components and 2 lights are connected");
}

TEST_F(LightsOfImage, OneLampTwiceIsTwiceAsBright)
{
  this->Filter->SetModeToGuided();
  const auto one = this->ImageOf({ this->Light });
  const auto two = this->ImageOf({ this->Light, this->Light });
  EXPECT_NEAR(Sum(two, "InScattering") / Sum(one, "InScattering"), 2.0, 1e-6);
}

TEST_F(LightsOfImage, ALampMovedByATransformShinesFromThere)
{
  vtkNew<vtkAreaLightSource> there;
  there->SetShapeToDisc();
  there->SetCenter(-1.0, lampHeight + 0.5, 0.2);
  there->SetNormal(0.0, -1.0, 0.0);
  there->SetRadius(lampRadius);
  const auto expected = this->ImageOf({ there });
  vtkNew<vtkTransform> move;
  move->Translate(-1.0, 0.5, 0.2);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(move);
  moved->SetInputConnection(this->Light->GetOutputPort());
  this->Filter->SetLightConnection(moved->GetOutputPort());
  const auto image = this->Image();
  EXPECT_LT(Error(image, expected), 1e-6);
}
