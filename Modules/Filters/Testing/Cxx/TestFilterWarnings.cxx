// SPDX-License-Identifier: BSD-3-Clause
// Filters say what may be wrong with a result, and say nothing where all is well.
#include "Messages.h"
#include "TestPolyData.h"

#include "vtkConeSetAccuracy.h"
#include "vtkConeSetFilter.h"
#include "vtkConeSetProbe.h"
#include "vtkLabelOccluders.h"
#include "vtkShadowVectorFilter.h"
#include "vtkShadowVolume.h"

#include "vtkPlaneSource.h"

using namespace shadowcones::testsupport;

namespace
{

/// A lamp at z = 4 that faces down, a plate at z = 2, and a small one beside it.
class FilterWarnings : public testing::Test
{
protected:
  FilterWarnings()
  {
    this->Light = LampAbove(4.0);
    this->Vectors->SetLightConnection(this->Light->GetOutputPort());
    this->Vectors->SetNumberOfPhotons(2000);
    this->Vectors->SetStorageToHitPoint();
    this->Cones->SetInputConnection(this->Vectors->GetOutputPort(0));
    this->Cones->SetTuningToManual();
    this->Cones->SetLeftoversToDiscard();
    this->Cones->OverlapOn();
    this->Cones->CosineCorrectionOff();
    this->Cones->SetExpansionToLightGeometry();
    MeshBuilder builder;
    builder.AddSquare(2.0, 1.0, 0);
    this->Plate = builder.Build();
    this->Vectors->SetInputData(this->Plate);
  }
  std::string VectorWarnings()
  {
    Messages messages(this->Vectors);
    this->Vectors->Update();
    EXPECT_EQ(messages.Errors, "");
    return messages.Warnings;
  }

  vtkSmartPointer<vtkAreaLightSource> Light;
  vtkSmartPointer<vtkPolyData> Plate;
  vtkNew<vtkShadowVectorFilter> Vectors;
  vtkNew<vtkConeSetFilter> Cones;
};

} // namespace

TEST_F(FilterWarnings, APlateUnderALampIsAsItShouldBe)
{
  Messages cones(this->Cones);
  EXPECT_EQ(this->VectorWarnings(), "");
  this->Cones->Update();
  EXPECT_EQ(cones.Errors + cones.Warnings, "");
}

TEST_F(FilterWarnings, ALampInAClosedBoxLightsNothing)
{
  MeshBuilder builder;
  this->Vectors->SetInputData(builder.AddBox(0.0, 0.0, 4.0, 2.0, 2.0, 2.0, 0).Build());
  EXPECT_SAYS(this->VectorWarnings(), "All 2000 photons were stopped by an occluder");
}

TEST_F(FilterWarnings, APlateBehindTheLampIsNotInShadow)
{
  MeshBuilder builder;
  builder.AddSquare(6.0, 1.0, 0);
  this->Vectors->SetInputData(builder.Build());
  EXPECT_SAYS(this->VectorWarnings(), "met an occluder: nothing is in shadow");
}

TEST_F(FilterWarnings, OccludersThatNoPhotonMetAreCounted)
{
  MeshBuilder builder;
  builder.AddSquare(2.0, 1.0, 0);
  builder.AddSquare(5.0, 0.1, 1); // behind the lamp
  builder.AddSquare(1.0, 5.0, -1);
  this->Vectors->SetInputData(builder.Build());
  EXPECT_SAYS(this->VectorWarnings(), "1 of 2 occluders have no shadow vector:");
}

TEST_F(FilterWarnings, NoConesFromTooFewVectors)
{
  this->Vectors->SetNumberOfPhotons(10);
  Messages messages(this->Cones);
  this->Cones->Update();
  EXPECT_SAYS(messages.Warnings, "No cones from ");

  vtkNew<vtkConeSetProbe> probe;
  vtkNew<vtkPlaneSource> points;
  points->SetResolution(4, 4);
  probe->SetInputConnection(points->GetOutputPort());
  probe->SetConeSetConnection(this->Cones->GetOutputPort());
  probe->SetLightConnection(this->Light->GetOutputPort());
  probe->SetMeshData(this->Plate);
  Messages asked(probe);
  probe->Update();
  EXPECT_SAYS(asked.Warnings, "The cone set is empty, but 2 triangles of the mesh cast shadows");
}

TEST_F(FilterWarnings, OccludersWithoutAConeAreCounted)
{
  MeshBuilder builder;
  builder.AddSquare(2.0, 1.0, 0);
  builder.AddBox(3.0, 0.0, 2.0, 0.3, 0.3, 0.01, 1);
  this->Vectors->SetInputData(builder.Build());
  this->Vectors->Update();
  std::vector<int> met(2, 0);
  vtkDataArray* ids = this->Vectors->GetOutput(0)->GetPointData()->GetArray("OccluderId");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ++met[static_cast<std::size_t>(ids->GetComponent(i, 0))];
  }
  // A cone of at least so many vectors: only the plate has them.
  ASSERT_GT(met[1], 0);
  ASSERT_GT(met[0], 2 * met[1] + 20);
  this->Cones->SetMinimumVectorsPerCone(met[1] + 10);
  this->Cones->SetNumberOfNeighbors(met[1] + 100);
  this->Cones->SetVarianceThreshold(2.0);
  this->Cones->OverlapOff();
  Messages messages(this->Cones);
  this->Cones->Update();
  EXPECT_SAYS(messages.Warnings, "1 of 2 occluders have no shadow vector in any cone");
}

TEST_F(FilterWarnings, ASetThatDiscardsMuchIsDoubtedWhereItServesAsBounds)
{
  this->Cones->Update();
  vtkNew<vtkPolyData> cones;
  cones->DeepCopy(this->Cones->GetOutput());
  cones->GetFieldData()->GetArray("DiscardedFraction")->SetComponent(0, 0, 0.4);
  vtkNew<vtkPlaneSource> points; // at z = 0, below the plate
  points->SetResolution(4, 4);
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputConnection(points->GetOutputPort());
  probe->SetConeSetData(cones);
  probe->SetLightConnection(this->Light->GetOutputPort());
  probe->SetMeshData(this->Plate);
  Messages exact(probe);
  probe->Update();
  EXPECT_SAYS(exact.Warnings, "40 % of the shadow vectors lie in no cone");
  probe->SetMethodToSoft();
  Messages soft(probe);
  probe->Update();
  EXPECT_EQ(soft.Warnings.find("lie in no cone"), std::string::npos) << soft.Warnings;

  vtkNew<vtkConeSetAccuracy> accuracy;
  accuracy->SetConeSetData(cones);
  accuracy->SetMeshData(this->Plate);
  accuracy->SetLightConnection(this->Light->GetOutputPort());
  accuracy->SetNumberOfSamples(200);
  Messages measured(accuracy);
  accuracy->Update();
  EXPECT_SAYS(measured.Warnings, "40 % of the shadow vectors lie in no cone");
}

TEST_F(FilterWarnings, PointsThatAreAllLitOrAllDark)
{
  vtkNew<vtkPlaneSource> points;
  points->SetResolution(4, 4);
  points->SetCenter(0.0, 0.0, 3.0); // above the plate
  vtkNew<vtkConeSetProbe> probe;
  probe->SetInputConnection(points->GetOutputPort());
  probe->SetConeSetConnection(this->Cones->GetOutputPort());
  probe->SetLightConnection(this->Light->GetOutputPort());
  probe->SetMeshData(this->Plate);
  Messages lit(probe);
  probe->Update();
  EXPECT_SAYS(lit.Warnings, "None of 25 points is in shadow");

  points->SetCenter(0.0, 0.0, 1.9); // right below it: 1 x 1 of 2 x 2
  Messages dark(probe);
  probe->Update();
  EXPECT_SAYS(dark.Warnings, "None of 25 points sees any of the light");

  points->SetCenter(1.0, 0.0, 1.0); // across the edge
  Messages both(probe);
  probe->Update();
  EXPECT_EQ(both.Warnings, "");
}

TEST_F(FilterWarnings, ConesOutsideTheBoxHaveNoSurface)
{
  vtkNew<vtkShadowVolume> volume;
  volume->SetInputConnection(this->Cones->GetOutputPort());
  volume->SetResolution(8);
  volume->SetBounds(50.0, 51.0, 50.0, 51.0, 50.0, 51.0);
  Messages messages(volume);
  volume->Update();
  EXPECT_SAYS(messages.Warnings, "1 of 1 occluders have no surface");
}

TEST_F(FilterWarnings, TrianglesThatAreDroppedAreCounted)
{
  MeshBuilder builder;
  builder.AddSquare(0.0, 1.0, 0);
  builder.AddSquare(0.0, 1.0, 0); // on the same points, once welded
  vtkNew<vtkLabelOccluders> label;
  label->SetInputData(builder.Build());
  Messages messages(label);
  label->Update();
  EXPECT_SAYS(messages.Warnings, "2 of 4 triangles (50 %) were dropped");
}
