// SPDX-License-Identifier: BSD-3-Clause
// Pictures at rising quality: whole, soon there, near the image, and left after an abort.
#include "vtkScatteringImageFilter.h"

#include "ImageTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"

#include <algorithm>
#include <functional>

using namespace imagetesting;

class ProgressiveImage : public ImageTest
{
protected:
  ProgressiveImage()
  {
    this->ConnectDisc();
    this->Filter->SetModeToGuided();
    this->Filter->SetRelativeErrorGoal(0.05);
    this->Filter->SetResolution(96, 80);
    this->Filter->SetMediumBounds(-2.0, 2.0, -2.0, 1.6, -2.0, 2.0); // below the lamp, next to which no few pixels would do
    this->Camera->SetPosition(0.0, 0.0, 4.5); // nothing but medium is seen
    this->Filter->SetNumberOfSurfaceLightSamples(2);
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* test, void*) { static_cast<ProgressiveImage*>(test)->OnPicture(); });
    this->Filter->AddObserver(vtkCommand::UpdateDataEvent, command);
  }
  void OnPicture()
  {
    this->Pictures.push_back(vtkSmartPointer<vtkImageData>::New());
    this->Pictures.back()->DeepCopy(this->Filter->GetPicture());
    if (this->Then)
    {
      this->Then();
    }
  }

  std::vector<vtkSmartPointer<vtkImageData>> Pictures;
  std::function<void()> Then;
};

TEST_F(ProgressiveImage, CoarsePicturesAreWholeAndNearTheImage)
{
  const auto once = this->Image();
  EXPECT_TRUE(this->Pictures.empty());
  EXPECT_EQ(this->Filter->GetPicture(), nullptr);

  this->Filter->ProgressiveOn();
  this->Filter->Update();
  EXPECT_TRUE(this->Pictures.empty()); // the image is kept: there is nothing to wait for
  this->Filter->Modified();
  const auto image = this->Image();
  ExpectSameBytes(image, once);
  ExpectSameBytes(this->Filter->GetPicture(), once);
  ASSERT_EQ(this->Pictures.size(), 1u);
  vtkImageData* picture = this->Pictures.front();
  EXPECT_EQ(picture->GetNumberOfPoints(), image->GetNumberOfPoints());
  EXPECT_LT(Error(picture, image), 0.1);
  EXPECT_GT(Error(picture, image), 0.0);
  for (const char* name : arrays)
  {
    EXPECT_NE(picture->GetPointData()->GetArray(name), nullptr) << name;
  }
  vtkDataArray* coarse = picture->GetPointData()->GetArray("InScattering");
  vtkDataArray* fine = image->GetPointData()->GetArray("InScattering");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(coarse->GetComponent(i, 0) > 0.0 || fine->GetComponent(i, 0) == 0.0) << i;
  }
}

TEST_F(ProgressiveImage, LargeImagesBeginCoarser)
{
  this->Filter->ProgressiveOn();
  this->Filter->SetResolution(1040, 800);
  this->Then = [this]
  {
    if (this->Pictures.size() == 2)
    {
      this->Filter->SetAbortExecute(1);
    }
  };
  this->Filter->Update();
  ASSERT_EQ(this->Pictures.size(), 2u);
  EXPECT_LT(Error(this->Pictures[0], this->Pictures[1]), 0.1);
}

TEST_F(ProgressiveImage, AnAbortLeavesTheLastWholePicture)
{
  this->Filter->ProgressiveOn();
  this->Then = [this] { this->Filter->SetAbortExecute(1); };
  this->Filter->Update();
  ASSERT_EQ(this->Pictures.size(), 1u);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  ASSERT_NE(this->Filter->GetPicture(), nullptr);
  ExpectSameBytes(this->Filter->GetPicture(), this->Pictures.front());
  EXPECT_GT(Sum(this->Filter->GetPicture(), "RGB"), 0.0);
}

TEST_F(ProgressiveImage, APartOfTheImageComesAtOnce)
{
  this->Filter->ProgressiveOn();
  int extent[6] = { 10, 40, 20, 50, 0, 0 };
  this->Filter->UpdateExtent(extent);
  EXPECT_TRUE(this->Pictures.empty());
  EXPECT_EQ(this->Filter->GetPicture(), nullptr);
}
