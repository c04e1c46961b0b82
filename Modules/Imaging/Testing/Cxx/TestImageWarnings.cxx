// SPDX-License-Identifier: BSD-3-Clause
// Images and volumes say what may be wrong with them, and say nothing where all is well.
#include "vtkScatteringImageFilter.h"
#include "vtkVisibilityVolume.h"

#include "ImageTesting.h"
#include "ProvedCones.h"

using namespace imagetesting;

namespace
{

class ImageWarnings : public ImageTest
{
protected:
  /// What the filter says of its next image.
  std::string Warnings()
  {
    Messages messages(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_EQ(messages.Errors, "");
    return messages.Warnings;
  }
  std::string VolumeWarnings()
  {
    Messages messages(this->Volume);
    this->Volume->Modified();
    this->Volume->Update();
    EXPECT_EQ(messages.Errors, "");
    return messages.Warnings;
  }
};

} // namespace

TEST_F(ImageWarnings, AnOrdinaryImageIsSilent)
{
  this->ConnectDisc();
  for (const int mode : { vtkScatteringImageFilter::BruteForce, vtkScatteringImageFilter::Medium,
         vtkScatteringImageFilter::Fast, vtkScatteringImageFilter::Soft, vtkScatteringImageFilter::Volume })
  {
    this->Filter->SetMode(mode);
    EXPECT_EQ(this->Warnings(), "") << mode;
  }
}

TEST_F(ImageWarnings, AGoalThatIsNotMetHasItsShareOfPixels)
{
  this->ConnectDisc();
  this->Filter->SetModeToGuided();
  this->Filter->SetRelativeErrorGoal(1e-4);
  this->Filter->SetMaximumSamples(8);
  EXPECT_SAYS(this->Warnings(), "miss the RelativeErrorGoal of 0.0001, the worst with a relative error of ");
  this->Filter->SetRelativeErrorGoal(0.0); // no goal
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(ImageWarnings, AMediumBesideTheViewIsNotSeen)
{
  this->Filter->SetMediumBounds(50.0, 51.0, 0.0, 1.0, 0.0, 1.0);
  EXPECT_SAYS(this->Warnings(), "None of 120 camera rays passes the medium");
}

TEST_F(ImageWarnings, ALampThatFacesAwayLightsNothing)
{
  this->Light->SetNormal(0.0, 1.0, 0.0);
  this->Filter->SetMediumBounds(-2.0, 2.0, -2.0, 1.9, -2.0, 2.0);
  EXPECT_SAYS(this->Warnings(), "All 120 pixels are black");
  // A part of an image may well be black.
  Messages messages(this->Filter);
  int extent[6] = { 0, 3, 0, 3, 0, 0 };
  this->Filter->Modified();
  this->Filter->UpdateExtent(extent);
  EXPECT_EQ(messages.Warnings, "");
}

TEST_F(ImageWarnings, AnEmptyConeSetOfAMeshThatCastsShadows)
{
  this->ConnectDisc();
  auto none = vtkSmartPointer<vtkPolyData>::New();
  shadowcones::WriteConeSet({}, none);
  this->Filter->SetConeSetData(none);
  this->Filter->SetModeToMedium();
  EXPECT_SAYS(this->Warnings(), "The cone set is empty, but 198 triangles of the mesh cast shadows");
  this->Volume->SetInputData(none);
  EXPECT_SAYS(this->VolumeWarnings(), "The cone set is empty, but 198 triangles of the mesh cast shadows");
}

TEST_F(ImageWarnings, AConeSetThatDiscardsMuch)
{
  this->ConnectDisc();
  auto cones = DiscCone();
  shadowcones::AddDoubleArray(cones->GetFieldData(), "DiscardedFraction", 1, { 0.5 });
  this->Filter->SetConeSetData(cones);
  this->Filter->SetModeToMedium();
  EXPECT_SAYS(this->Warnings(), "50 % of the shadow vectors lie in no cone");
  this->Filter->SetModeToFast(); // which does not take the cones for bounds
  EXPECT_EQ(this->Warnings(), "");
  this->Volume->SetInputData(cones);
  EXPECT_SAYS(this->VolumeWarnings(), "50 % of the shadow vectors lie in no cone");
}

TEST_F(ImageWarnings, ConesThatHoldAllOfTheMediumAreNotWhatRaysFind)
{
  this->ConnectDisc();
  this->Filter->SetConeSetData(ConeSetOf({ MakeCone({ 0.0, 1e3, 0.0 }, { 0.0, -1.0, 0.0 }, 100.0, 0.1, 0) }));
  this->Filter->SetModeToFast();
  EXPECT_SAYS(this->Warnings(), "Mode Fast asks no rays, and cones hold more than the shadow, or less: at 64 pixels the medium "
                                "shows 0 % of the light that rays find");
  this->Filter->SetModeToMedium(); // which asks inside of them
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(ImageWarnings, AProvedSetThatWasEditedIsNotProved)
{
  this->ConnectDisc();
  auto cones = ProvedConesOf(Disc(), this->Light);
  this->Filter->SetConeSetData(cones);
  this->Volume->SetInputData(cones);
  this->Filter->SetRelativeErrorGoal(0.0); // no goal to miss
  for (const int mode : { vtkScatteringImageFilter::Medium, vtkScatteringImageFilter::Guided })
  {
    this->Filter->SetMode(mode);
    EXPECT_EQ(this->Warnings(), "") << mode;
    EXPECT_EQ(Field(this->Image(), "Certified"), 1.0) << mode;
  }
  this->VolumeWarnings();
  EXPECT_EQ(Field(this->Volume->GetOutput(), "Certified"), 1.0);
  this->Filter->SetConeLength(100.0); // a cut that its user asks for
  EXPECT_EQ(this->Warnings(), "");
  EXPECT_EQ(Field(this->Image(), "Certified"), 0.0);
  this->Filter->SetConeLength(0.0);

  vtkDataArray* radii = cones->GetPointData()->GetArray("BaseRadius");
  radii->SetComponent(0, 0, 1.01 * radii->GetComponent(0, 0));
  EXPECT_SAYS(this->Warnings(), "The cone set on input port 2 says that it is proved, but not of these cones");
  EXPECT_EQ(Field(this->Image(), "Certified"), 0.0);
  EXPECT_SAYS(this->VolumeWarnings(), "The cone set on input port 0 says that it is proved, but not of these cones");
  EXPECT_EQ(Field(this->Volume->GetOutput(), "Certified"), 0.0);
  // Then vectors without a cone count.
  shadowcones::AddDoubleArray(cones->GetFieldData(), "DiscardedFraction", 1, { 0.5 });
  EXPECT_SAYS(this->Warnings(), "50 % of the shadow vectors lie in no cone");
}

TEST_F(ImageWarnings, AVolumeSmallerThanTheMedium)
{
  this->ConnectDisc();
  this->Filter->SetModeToVolume();
  this->Volume->SetBounds(-2.0, 2.0, -2.0, 1.0, -2.0, 2.0); // three quarters of the height
  EXPECT_SAYS(this->Warnings(), "25 % of the medium lies outside the visibility volume");
}

TEST_F(ImageWarnings, VolumesThatAreAllLitAllDarkOrTooCoarse)
{
  this->ConnectDisc();
  this->Volume->SetDimensions(5, 5, 5);
  this->Volume->SetBounds(-0.1, 0.1, 1.0, 1.2, -0.1, 0.1); // between lamp and plate
  EXPECT_SAYS(this->VolumeWarnings(), "None of 125 points is in shadow");
  this->Volume->SetBounds(-0.1, 0.1, 0.3, 0.49, -0.1, 0.1); // right below the plate
  EXPECT_SAYS(this->VolumeWarnings(), "None of 125 points sees any of the light");
  this->Light->SetShapeToPoint(); // a hard edge
  this->Volume->SetBounds(0.5, 1.1, 0.3, 0.49, -0.1, 0.1);
  this->Volume->SetDimensions(3, 2, 2);
  this->Volume->SetBrickParts(1);
  EXPECT_SAYS(this->VolumeWarnings(), "cells in reach of a shadow hold an edge");
}
