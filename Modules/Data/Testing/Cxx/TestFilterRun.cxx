// SPDX-License-Identifier: BSD-3-Clause
// What every filter shares.
#include "scFilterRun.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

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
