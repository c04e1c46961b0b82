// SPDX-License-Identifier: BSD-3-Clause
// What filters keep: found by its key, built once, dropped when nobody used it last.
#include "scPreparedInputs.h"

#include "TestPolyData.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

using namespace shadowcones;
using namespace shadowcones::testsupport;

namespace
{
struct Number : PreparedItem
{
  std::int64_t Memory() const override { return 100; }
};

PreparedKey KeyOf(double number)
{
  return PreparedKey(PreparedKind::Mesh).Add(number);
}

void Use(PreparedUser& user, double number)
{
  user.Get<Number>(KeyOf(number), [] { return std::make_shared<const Number>(); });
}

vtkSmartPointer<vtkPolyData> LabelledSheets()
{
  auto mesh = Plane({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  vtkNew<vtkIntArray> ids;
  ids->SetName("OccluderId");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    ids->InsertNextValue(0);
  }
  mesh->GetCellData()->AddArray(ids);
  return mesh;
}
} // namespace

TEST(PreparedScene, ARunKeepsWhatItUsedAndDropsTheRest)
{
  PreparedUser user;
  {
    const PreparedRun run(user);
    Use(user, 1.0);
    Use(user, 1.0);
    Use(user, 2.0);
  }
  EXPECT_EQ(user.NumberOfBuilds(), 2);
  EXPECT_EQ(user.Memory(), 200);
  {
    const PreparedRun run(user); // its parameters were wrong: it came to nothing
  }
  EXPECT_EQ(user.Memory(), 200);
  {
    const PreparedRun run(user);
    Use(user, 2.0);
  }
  EXPECT_EQ(user.NumberOfBuilds(), 2);
  EXPECT_EQ(user.Memory(), 100);
  {
    const PreparedRun run(user);
    Use(user, 1.0);
  }
  EXPECT_EQ(user.NumberOfBuilds(), 3);
  user.Release();
  EXPECT_EQ(user.Memory(), 0);
}

TEST(PreparedScene, IsSharedOnlyWhereItIsHandedOn)
{
  PreparedUser first;
  PreparedUser other;
  {
    const PreparedRun run(first);
    Use(first, 1.0);
  }
  EXPECT_NE(first.GetScene(), other.GetScene());
  EXPECT_TRUE(other.SetScene(first.GetScene()));
  {
    const PreparedRun run(other);
    Use(other, 1.0);
    Use(other, 2.0);
  }
  EXPECT_EQ(other.NumberOfBuilds(), 1); // the first was there
  EXPECT_EQ(first.Memory(), 200);
  {
    const PreparedRun run(first);
    Use(first, 3.0);
  }
  EXPECT_EQ(first.Memory(), 300); // the other one still uses 1 and 2

  EXPECT_FALSE(other.SetScene(vtkNew<vtkPolyData>().Get()));
  EXPECT_EQ(other.GetScene(), first.GetScene());
  EXPECT_TRUE(other.SetScene(nullptr));
  EXPECT_EQ(other.Memory(), 0);
  {
    const PreparedRun run(first);
    Use(first, 3.0);
  }
  EXPECT_EQ(first.Memory(), 100);
}

TEST(PreparedScene, OutlivesTheFilterThatHandedItOn)
{
  PreparedUser user;
  {
    PreparedUser gone;
    {
      const PreparedRun run(gone);
      Use(gone, 1.0);
    }
    user.SetScene(gone.GetScene());
  }
  const PreparedRun run(user);
  Use(user, 1.0);
  EXPECT_EQ(user.NumberOfBuilds(), 0);
}

TEST(PreparedScene, WhatFailsIsNotKept)
{
  PreparedUser user;
  std::string error;
  auto mesh = LabelledSheets();
  mesh->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
  for (int k = 0; k < 2; ++k)
  {
    error.clear();
    EXPECT_EQ(PrepareMesh(user, mesh, error), nullptr);
    EXPECT_NE(error.find("not finite"), std::string::npos) << error;
  }
  EXPECT_EQ(user.NumberOfBuilds(), 0);
}

TEST(PreparedScene, AChangedMeshIsReadAgain)
{
  PreparedUser user;
  std::string error;
  auto mesh = LabelledSheets();
  vtkIdType builds = 0;
  const auto prepare = [&](bool anew)
  {
    const PreparedRun run(user);
    const auto prepared = PrepareMesh(user, mesh, error);
    EXPECT_NE(prepared, nullptr);
    PrepareOccluders(user, PrepareCasters(user, prepared));
    EXPECT_EQ(user.NumberOfBuilds() > builds, anew);
    builds = user.NumberOfBuilds();
    return prepared;
  };
  prepare(true);
  prepare(false);
  mesh->GetPoints()->SetPoint(0, -5.0, 0.0, 0.0);
  mesh->GetPoints()->Modified();
  EXPECT_EQ(prepare(true)->Bounds.Min.X, -5.0);
  prepare(false);
  auto* ids = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("OccluderId"));
  ids->SetValue(0, -1);
  prepare(false); // nobody was told
  ids->Modified();
  const auto changed = prepare(true);
  EXPECT_EQ(changed->NumberOfCasters, static_cast<vtkIdType>(changed->Mesh.SourceCells.size()) - 2);
  prepare(false);
}

TEST(PreparedScene, ABlockThatChangesIsSeen)
{
  PreparedUser user;
  std::string error;
  auto block = LabelledSheets();
  vtkNew<vtkMultiBlockDataSet> mesh;
  mesh->SetBlock(0, block);
  mesh->SetBlock(1, LabelledSheets());
  const auto first = PrepareMesh(user, mesh, error);
  EXPECT_EQ(PrepareMesh(user, mesh, error), first);
  block->GetPoints()->SetPoint(0, -5.0, 0.0, 0.0);
  block->GetPoints()->Modified();
  const auto second = PrepareMesh(user, mesh, error);
  EXPECT_NE(second, first);
  mesh->SetBlock(1, nullptr);
  EXPECT_NE(PrepareMesh(user, mesh, error), second);
}

TEST(PreparedScene, CastersAreTheMeshItselfWithoutReceivers)
{
  PreparedUser user;
  std::string error;
  auto mesh = LabelledSheets();
  const auto whole = PrepareMesh(user, mesh, error);
  EXPECT_EQ(PrepareCasters(user, whole), whole);
  EXPECT_EQ(PrepareMesh(user, nullptr, error)->Mesh.Triangles.size(), 0u);
}
