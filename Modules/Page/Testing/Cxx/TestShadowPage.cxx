// SPDX-License-Identifier: BSD-3-Clause
// What a page holds, and what becomes of a file where it cannot be written.
#include "vtkShadowPage.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace
{
vtkPolyData* Cube(vtkCubeSource* source)
{
  source->Update();
  return source->GetOutput();
}

std::size_t Count(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}
} // namespace

TEST(ShadowPage, NamesAreTextAndNothingElse)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkShadowPage> page;
  page->SetTitle("<b>@SCENE@ & more");
  ASSERT_TRUE(page->AddMesh(Cube(cube), "</script><script>\"\\\n"));
  const std::string text = page->GetPage();
  EXPECT_EQ(Count(text, "&lt;b>@SCENE@ &amp; more"), 2u);
  EXPECT_EQ(Count(text, "</script>"), 2u); // of the scene and of the viewer
  EXPECT_NE(text.find("\\u003c/script>\\u003cscript>\\u0022\\u005c\\u000a"), std::string::npos);
}

TEST(ShadowPage, ClearForgetsWhatWasAdded)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkShadowPage> page;
  ASSERT_TRUE(page->AddMesh(Cube(cube), "a"));
  page->Clear();
  EXPECT_TRUE(page->GetPage().empty());
}

TEST(ShadowPage, AFarAwayMeshKeepsItsShape) // as float points it would be whole numbers
{
  vtkNew<vtkCubeSource> near;
  vtkNew<vtkShadowPage> here;
  vtkNew<vtkShadowPage> there;
  ASSERT_TRUE(here->AddMesh(Cube(near), "a"));
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(Cube(near));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const double* point = moved->GetPoint(i);
    points->InsertNextPoint(point[0] + 1e7, point[1], point[2] - 1e7);
  }
  moved->SetPoints(points);
  ASSERT_TRUE(there->AddMesh(moved, "a"));
  EXPECT_EQ(here->GetPage(), there->GetPage());
}

TEST(ShadowPage, AFileThatCannotBeReplacedStays)
{
  const std::string path = testing::TempDir() + "shadow-page.html";
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkShadowPage> page;
  ASSERT_TRUE(page->AddMesh(Cube(cube), "a"));
  ASSERT_TRUE(page->Write(path));
  page->Clear();
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_FALSE(page->Write(path));
  vtkObject::GlobalWarningDisplayOn();
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("\"name\":\"a\""), std::string::npos);
  EXPECT_EQ(std::remove(path.c_str()), 0);
}
