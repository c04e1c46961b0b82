// SPDX-License-Identifier: BSD-3-Clause
// vtkRankWork: a process that works alone shares nothing; what several do is asked of real ones, in Testing/Python/test_ranks.py.
#include "vtkRankWork.h"

#include "vtkAreaLightSource.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <sstream>

TEST(RankWork, AProcessThatWorksAloneSharesNothing)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkAreaLightSource> light;
  light->SetCenter(0.0, 0.0, 5.0);
  light->SetNormal(0.0, 0.0, -1.0);
  vtkNew<vtkLabelOccluders> occluders;
  occluders->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkShadowVectorFilter> vectors;
  vectors->SetInputConnection(occluders->GetOutputPort());
  vectors->SetLightConnection(light->GetOutputPort());
  vectors->SetNumberOfPhotons(500);
  vtkRankWork::Reset();
  vectors->UpdatePiece(0, 2, 0); // a piece, and no other process
  EXPECT_GT(vectors->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(vtkRankWork::GetNumberOfItems(), 0);
  EXPECT_EQ(vtkRankWork::GetNumberOfMeetings(), 0);
  EXPECT_EQ(vtkRankWork::GetBytesSent(), 0);
  EXPECT_EQ(vtkRankWork::GetBytesReceived(), 0);
  EXPECT_EQ(vtkRankWork::GetSeconds(), 0.0);
  vtkNew<vtkRankWork> work;
  std::ostringstream text;
  work->Print(text);
  EXPECT_NE(text.str().find("NumberOfRays: 0"), std::string::npos) << text.str();
}
