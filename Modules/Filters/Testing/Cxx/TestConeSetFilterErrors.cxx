// SPDX-License-Identifier: BSD-3-Clause
// vtkConeSetFilter: a message for each fault of parameters and arrays, and none where there are no vectors.
#include "Messages.h"
#include "TestPolyData.h"
#include "TracedBoard.h"
#include "vtkConeSetFilter.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"

#include <cmath>
#include <functional>
#include <string>

using namespace shadowcones::testsupport;

namespace
{

struct Outcome
{
  vtkIdType Cones = 0;
  vtkIdType Vectors = 0;
  std::string Errors;
};

Outcome Execute(vtkPolyData* vectors, vtkPolyData* paths, const std::function<void(vtkConeSetFilter*)>& change = {})
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(vectors);
  if (paths)
  {
    filter->SetPhotonPathData(paths);
  }
  if (change)
  {
    change(filter);
  }
  Messages messages(filter);
  filter->Update();
  return { filter->GetOutput(0)->GetNumberOfPoints(), filter->GetOutput(1)->GetNumberOfPoints(), messages.Errors };
}

void ExpectFault(const Outcome& outcome, const std::string& says)
{
  EXPECT_EQ(outcome.Cones, 0);
  EXPECT_EQ(outcome.Vectors, 0);
  EXPECT_SAYS(outcome.Errors, says);
}

} // namespace

TEST(ConeSetFilter, TrimmingNeedsPaths)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(Board().Vectors());
  filter->SetMaximumOverspill(0.1);
  Messages messages(filter);
  filter->Update();
  EXPECT_SAYS(messages.Errors, "MaximumOverspill is 0.1");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetPhotonPathData(Board().Paths());
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ConeSetFilter, NoVectorsGiveNoCones)
{
  vtkNew<vtkPolyData> empty;
  const Outcome outcome = Execute(empty, nullptr);
  EXPECT_EQ(outcome.Cones, 0);
  EXPECT_EQ(outcome.Errors, "");
  vtkNew<vtkPolyData> noPaths;
  const Outcome withPaths = Execute(Board().Vectors(), noPaths);
  EXPECT_GT(withPaths.Cones, 5);
  EXPECT_EQ(withPaths.Errors, "");
}

TEST(ConeSetFilterErrors, EachParameterHasItsMessage)
{
  const auto vectors = Board().Vectors();
  const auto run = [&](const std::function<void(vtkConeSetFilter*)>& change)
  { return Execute(vectors, nullptr, change); };
  ExpectFault(
    run([](vtkConeSetFilter* f) { f->SetNumberOfNeighbors(19); }), "must not be below MinimumVectorsPerCone (p4)");
  ExpectFault(
    run([](vtkConeSetFilter* f) { f->SetNumberOfNeighbors(2); }), "NumberOfNeighbors (p1) must lie in 3..1000000");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetNumberOfSectors(0); }), "NumberOfSectors (p2) must lie in 1..65536");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetNumberOfNeighbors(536870912); }), "must lie in 3..1000000");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetNumberOfSectors(2147483647); }), "must lie in 1..65536");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetPointsPerRing(2147483647); }), "must be below NumberOfNeighbors (p1)");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetPointsPerRing(0); }), "PointsPerRing (p3) must be at least 1");
  ExpectFault(
    run([](vtkConeSetFilter* f) { f->SetMinimumVectorsPerCone(0); }), "MinimumVectorsPerCone (p4) must be at least 1");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetVarianceThreshold(-1.0); }), "VarianceThreshold");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetPlanarityThreshold(std::nan("")); }), "PlanarityThreshold");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetExpansion(7); }), "Expansion must be");
  ExpectFault(run([](vtkConeSetFilter* f) { f->SetExpansionFraction(1.5); }), "ExpansionFraction must lie in 0..1");
}

TEST(ConeSetFilterErrors, TuningNeedsPathsToLearnFrom)
{
  const auto vectors = Board().Vectors();
  const auto tune = [](vtkConeSetFilter* f) { f->SetTuningToPreview(); };
  ExpectFault(Execute(vectors, nullptr, tune), "Tuning learns from photon paths and input port 1 has none");
  ExpectFault(
    Execute(vectors, Board().Paths(), [](vtkConeSetFilter* f) { f->SetTuning(7); }), "Tuning is 7: it must be Manual (0)");
  ExpectFault(Execute(vectors, nullptr, [](vtkConeSetFilter* f) { f->SetTuning(-1); }), "Tuning is -1: it must be Manual (0)");
  // Nothing to tune is no fault.
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(Execute(empty, Board().Paths(), tune).Errors, "");
}

TEST(ConeSetFilterErrors, EachArrayHasItsMessage)
{
  auto vectors = Board().Vectors();
  vectors->GetPointData()->RemoveArray("Direction");
  ExpectFault(Execute(vectors, nullptr), "no array \"Direction\"");

  vectors = Board().Vectors();
  vectors->GetPointData()->RemoveArray("EmissionPoint");
  EXPECT_EQ(Execute(vectors, nullptr).Errors, ""); // the light's exact shape is in the field data
  vectors->GetFieldData()->RemoveArray("LightShape");
  ExpectFault(Execute(vectors, nullptr), "no array \"EmissionPoint\"");

  vectors = Board().Vectors();
  vectors->GetFieldData()->RemoveArray("LightRadius");
  ExpectFault(Execute(vectors, nullptr), "\"LightRadius\" is missing");

  vectors = Board().Vectors();
  vectors->GetPointData()->GetArray("Direction")->SetComponent(17, 0, std::nan(""));
  ExpectFault(Execute(vectors, nullptr), "shadow vector 17");

  vectors = Board().Vectors();
  vectors->GetPointData()->GetArray("Direction")->SetTuple3(17, 0.0, 0.0, 2.0);
  ExpectFault(Execute(vectors, nullptr), "not 1");

  vectors = Board().Vectors();
  vectors->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  ExpectFault(Execute(vectors, nullptr), "position of shadow vector 5 is not finite");

  vectors = Board().Vectors();
  vtkNew<vtkFloatArray> shortArray;
  shortArray->SetName("Mine");
  shortArray->SetNumberOfTuples(10);
  vectors->GetPointData()->AddArray(shortArray);
  ExpectFault(Execute(vectors, nullptr), "\"Mine\" has 10 tuples where 3000 are needed");

  vectors = Board().Vectors();
  vectors->GetFieldData()->RemoveArray("LightShape");
  vectors->GetPointData()->GetArray("LightId")->SetTuple1(2, 2147483647);
  ExpectFault(Execute(vectors, nullptr), "has the \"LightId\" 2147483647 and 3000 vectors: count lights from 0");

  auto paths = Board().Paths();
  paths->GetPointData()->RemoveArray("PathState");
  ExpectFault(Execute(Board().Vectors(), paths), "no array \"PathState\"");

  paths = Board().Paths();
  paths->GetPointData()->GetArray("PathState")->SetTuple1(3, 4);
  ExpectFault(Execute(Board().Vectors(), paths), "\"PathState\" of photon path 3 is 4");

  // The mesh itself instead of its vectors: a slip that is easily made.
  ExpectFault(Execute(MeshBuilder().AddSquare(0.0, 1.0, 0).Build(), nullptr), "no array \"Direction\"");
}
