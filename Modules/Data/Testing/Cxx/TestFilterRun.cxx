// SPDX-License-Identifier: BSD-3-Clause
// What every filter shares.
#include "scFilterRun.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <vector>

using namespace shadowcones;

TEST(FilterRun, MonitorIsTheFilters)
{
  vtkNew<vtkSphereSource> filter;
  const Monitor monitor = MonitorOf(filter);
  monitor.Progress(0.375);
  EXPECT_EQ(filter->GetProgress(), 0.375);
  EXPECT_FALSE(monitor.IsAborted());
  filter->SetAbortExecute(1);
  EXPECT_TRUE(monitor.IsAborted());
}

namespace
{
/// As VTK's classes before 9.3, and from then on.
struct WithAFlag
{
  int Flag;
  int GetAbortExecute() const { return this->Flag; }
};
struct WithACheck : WithAFlag
{
  bool Downstream;
  bool CheckAbort() const { return this->Flag != 0 || this->Downstream; }
};
} // namespace

TEST(FilterRun, AbortIsAskedForAsTheVersionOfVTKHasIt)
{
  const WithAFlag idle{ 0 }, stopped{ 1 };
  EXPECT_FALSE(IsToStop(&idle, 0));
  EXPECT_TRUE(IsToStop(&stopped, 0));
  const WithACheck all{ { 0 }, false }, behind{ { 0 }, true };
  EXPECT_FALSE(IsToStop(&all, 0));
  EXPECT_TRUE(IsToStop(&behind, 0));
}

TEST(FilterRun, AnEmptiedImageIsStillAskedForItsExtent)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 3, 4);
  EmptyOutput(image);
  EXPECT_EQ(image->GetNumberOfPoints(), 0);
  EXPECT_EQ(image->GetInformation()->Get(vtkDataObject::DATA_EXTENT_TYPE()), VTK_3D_EXTENT);
}

TEST(FilterRun, ARequestIsCutToWhatThereIs)
{
  vtkNew<vtkInformation> info;
  const int whole[6] = { 0, 8, 0, 4, 0, 0 };
  const int larger[6] = { 2, 14, -1, 3, 0, 12 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), larger, 6);
  int extent[6];
  EXPECT_TRUE(RequestedExtent(info, extent));
  EXPECT_EQ(std::vector<int>(extent, extent + 6), (std::vector<int>{ 2, 8, 0, 3, 0, 0 }));
  const int beside[6] = { 9, 14, 0, 4, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), beside, 6);
  EXPECT_FALSE(RequestedExtent(info, extent));
}
