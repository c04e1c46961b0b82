// SPDX-License-Identifier: BSD-3-Clause
// vtkConeSetFilter: its arrays and field data, its parameters, and what tuning makes of them.
#include "Messages.h"
#include "TestPolyData.h"
#include "TracedBoard.h"
#include "vtkConeSetFilter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkVariant.h"

#include <cmath>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>

using namespace shadowcones::testsupport;

TEST(ConeSetFilter, GivesTheDocumentedArrays)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  const auto input = Board().Vectors();
  filter->SetInputData(input);
  filter->SetPhotonPathData(Board().Paths());
  filter->Update();

  vtkPolyData* cones = filter->GetOutput(0);
  const vtkIdType count = cones->GetNumberOfPoints();
  ASSERT_GT(count, 5);
  EXPECT_EQ(cones->GetNumberOfVerts(), count);
  EXPECT_EQ(cones->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkPointData* data = cones->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 11);
  EXPECT_EQ(ArrayOf(data, "LightId", VTK_INT, 1)->GetRange()[1], 0.0);
  vtkDataArray* axes = ArrayOf(data, "Axis", VTK_FLOAT, 3);
  vtkDataArray* radii = ArrayOf(data, "BaseRadius", VTK_FLOAT, 1);
  vtkDataArray* angles = ArrayOf(data, "HalfAngle", VTK_FLOAT, 1);
  vtkDataArray* innerAngles = ArrayOf(data, "InnerHalfAngle", VTK_FLOAT, 1);
  vtkDataArray* normals = ArrayOf(data, "Normal", VTK_FLOAT, 3);
  vtkDataArray* occluders = ArrayOf(data, "OccluderId", VTK_INT, 1);
  vtkDataArray* counts = ArrayOf(data, "VectorCount", VTK_INT, 1);
  vtkDataArray* planarities = ArrayOf(data, "Planarity", VTK_FLOAT, 1);
  vtkDataArray* overspills = ArrayOf(data, "Overspill", VTK_FLOAT, 1);
  EXPECT_EQ(ArrayOf(data, "ConeOrigin", VTK_INT, 1)->GetRange()[1], 0.0);
  double vectorSum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    EXPECT_LT(axes->GetComponent(i, 2), -0.9);
    EXPECT_NEAR(normals->GetComponent(i, 2), -1.0, 2e-2); // the board is flat
    EXPECT_GT(radii->GetTuple1(i), 0.0);
    EXPECT_LT(radii->GetTuple1(i), 0.8);
    // The lamp of radius 0.5 is 2 above the base.
    EXPECT_GT(angles->GetTuple1(i), 0.5 * std::atan(0.5 / 2.0));
    EXPECT_LT(angles->GetTuple1(i), std::atan((0.5 + radii->GetTuple1(i)) / 2.0) + 0.02);
    EXPECT_LT(innerAngles->GetTuple1(i), angles->GetTuple1(i));
    EXPECT_EQ(occluders->GetTuple1(i), 0.0) << "the mesh's one id, 4, is its name";
    EXPECT_GE(counts->GetTuple1(i), 20.0);
    EXPECT_GE(planarities->GetTuple1(i), 0.0);
    EXPECT_LT(planarities->GetTuple1(i), 0.25);
    EXPECT_GE(overspills->GetTuple1(i), 0.0);
    EXPECT_LT(overspills->GetTuple1(i), 0.3);
    vectorSum += counts->GetTuple1(i);
  }

  EXPECT_EQ(FieldValue(cones, "NumberOfVectors"), 3000.0);
  EXPECT_EQ(FieldValue(cones, "NumberOfCones"), static_cast<double>(count));
  EXPECT_EQ(FieldValue(cones, "NumberOfDiscarded"), 3000.0 - vectorSum);
  EXPECT_EQ(FieldValue(cones, "DiscardedFraction"), (3000.0 - vectorSum) / 3000.0);
  EXPECT_EQ(FieldValue(cones, "Seed"), 9.0);
  EXPECT_EQ(FieldValue(cones, "LightRadius"), 0.5);
  const std::map<std::string, double> parameters = { { "Tuning", 0 }, { "NumberOfNeighbors", 100 },
    { "NumberOfSectors", 20 }, { "PointsPerRing", 16 }, { "MinimumVectorsPerCone", 20 }, { "VarianceThreshold", 1.6 },
    { "PlanarityThreshold", 0 }, { "CosineCorrection", 1 }, { "Expansion", 0 }, { "ExpansionFraction", 1 },
    { "Overlap", 0 }, { "Leftovers", 0 }, { "Certified", 0 } };
  for (const auto& [name, value] : parameters)
  {
    EXPECT_EQ(FieldValue(cones, name.c_str()), value) << name;
  }

  // The vectors with all that they had, and their cone.
  vtkPolyData* labelled = filter->GetOutput(1);
  ASSERT_EQ(labelled->GetNumberOfPoints(), 3000);
  EXPECT_EQ(labelled->GetPointData()->GetNumberOfArrays(), input->GetPointData()->GetNumberOfArrays() + 1);
  vtkDataArray* ids = ArrayOf(labelled->GetPointData(), "ConeId", VTK_ID_TYPE, 1);
  std::map<vtkIdType, int> perCone;
  for (vtkIdType i = 0; i < 3000; ++i)
  {
    ++perCone[static_cast<vtkIdType>(ids->GetTuple1(i))];
    EXPECT_EQ(labelled->GetPoint(i)[0], input->GetPoint(i)[0]);
    EXPECT_EQ(labelled->GetPointData()->GetArray("PathLength")->GetTuple1(i),
      input->GetPointData()->GetArray("PathLength")->GetTuple1(i));
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    EXPECT_EQ(perCone[i], counts->GetTuple1(i)) << i;
  }
  EXPECT_EQ(perCone[-1], FieldValue(cones, "NumberOfDiscarded"));
}

TEST(ConeSetFilter, PathsAreOptional)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(Board().Vectors());
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfPoints(), 5);
  const double* range = filter->GetOutput()->GetPointData()->GetArray("Overspill")->GetRange();
  EXPECT_EQ(range[0], -1.0);
  EXPECT_EQ(range[1], -1.0);
}

TEST(ConeSetFilter, TakesVectorsOfAnotherTracer)
{
  // The least that another program has to write: points, directions in double precision, emission points.
  const auto full = Board().Vectors();
  vtkNew<vtkPolyData> plain;
  plain->SetPoints(full->GetPoints());
  for (const char* name : { "Direction", "EmissionPoint" })
  {
    vtkNew<vtkDoubleArray> array;
    array->DeepCopy(full->GetPointData()->GetArray(name));
    array->SetName(name);
    plain->GetPointData()->AddArray(array);
  }
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(plain);
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfPoints(), 5);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("OccluderId")->GetRange()[1], 0.0);
  // The light is then the sphere around the emission points: InnerHalfAngle changes a little, the cones not at all.
  vtkNew<vtkConeSetFilter> reference;
  reference->SetToPaper();
  reference->SetInputData(full);
  reference->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), reference->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    for (const char* name : { "BaseRadius", "HalfAngle" })
    {
      EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(i),
        reference->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(i));
    }
    // The sphere around a disc is seen under a slightly larger angle, never a smaller one.
    const double wider = reference->GetOutput()->GetPointData()->GetArray("InnerHalfAngle")->GetTuple1(i) -
      filter->GetOutput()->GetPointData()->GetArray("InnerHalfAngle")->GetTuple1(i);
    EXPECT_GE(wider, -2e-3); // emission points do not quite reach the rim
    EXPECT_LT(wider, 0.05);
  }
}

TEST(ConeSetFilter, ParametersChangeWhatTheySay)
{
  const auto vectors = Board().Vectors();
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(vectors);
  const auto run = [&]
  {
    filter->Update();
    return filter->GetOutput();
  };
  const auto largest = [&](const char* name) { return run()->GetPointData()->GetArray(name)->GetRange()[1]; };
  const vtkIdType cones = run()->GetNumberOfPoints();
  const double discarded = FieldValue(run(), "NumberOfDiscarded");
  const double angle = largest("HalfAngle");

  filter->SetExpansionFraction(0.5);
  EXPECT_NEAR(largest("HalfAngle"), 0.5 * angle, 1e-6);
  EXPECT_EQ(FieldValue(run(), "ExpansionFraction"), 0.5);
  filter->SetExpansionFraction(1.0);
  filter->SetExpansionToLightGeometry();
  EXPECT_GT(largest("HalfAngle"), angle);
  EXPECT_EQ(FieldValue(run(), "Expansion"), 2.0);
  filter->SetExpansionToRadiusRatio();
  EXPECT_EQ(FieldValue(run(), "Expansion"), 1.0);
  EXPECT_GT(largest("HalfAngle"), 0.0);
  filter->SetExpansionToMaximumDeviation();
  filter->OverlapOn();
  EXPECT_LT(FieldValue(run(), "NumberOfDiscarded"), discarded);
  filter->OverlapOff();
  filter->SetVarianceThreshold(0.6);
  EXPECT_GT(FieldValue(run(), "NumberOfDiscarded"), discarded);
  filter->SetVarianceThreshold(1.6);
  filter->SetMinimumVectorsPerCone(90);
  EXPECT_GE(run()->GetPointData()->GetArray("VectorCount")->GetRange()[0], 90.0);
  EXPECT_LT(run()->GetNumberOfPoints(), cones);
  filter->SetMinimumVectorsPerCone(20);
  filter->SetNumberOfNeighbors(50);
  EXPECT_LE(largest("VectorCount"), 50.0);
  EXPECT_GT(run()->GetNumberOfPoints(), cones);

  std::ostringstream text;
  filter->Print(text);
  for (const char* line : { "Tuning: Manual", "NumberOfNeighbors: 50", "NumberOfSectors: 20", "PointsPerRing: 16",
         "MinimumVectorsPerCone: 20", "VarianceThreshold: 1.6", "PlanarityThreshold: 0", "CosineCorrection: on",
         "Expansion: MaximumDeviation", "ExpansionFraction: 1", "Overlap: off" })
  {
    EXPECT_SAYS(text.str(), line);
  }
}

TEST(ConeSetFilter, TuningChoosesTheParametersAndSaysSo)
{
  const auto vectors = Board().Vectors();
  const auto paths = Board().Paths();
  const auto tuned = [&](int tuning)
  {
    vtkNew<vtkConeSetFilter> filter;
    filter->SetToPaper();
    filter->SetInputData(vectors);
    filter->SetPhotonPathData(paths);
    filter->SetTuning(tuning);
    filter->SetVarianceThreshold(0.3); // replaced
    filter->SetExpansionFraction(0.25);
    filter->SetRadiusScale(3.0);
    filter->SetNumberOfSectors(17); // kept
    filter->Update();
    vtkSmartPointer<vtkPolyData> cones = filter->GetOutput();
    EXPECT_GT(cones->GetNumberOfPoints(), 0) << tuning;
    EXPECT_EQ(FieldValue(cones, "Tuning"), tuning);
    EXPECT_EQ(FieldValue(cones, "Expansion"), vtkConeSetFilter::LightGeometry);
    EXPECT_EQ(FieldValue(cones, "NumberOfVectors"), 3000.0);
    EXPECT_GT(FieldValue(cones, "TuningFits"), 25.0);
    ArrayOf(cones->GetFieldData(), "TuningObjective", VTK_DOUBLE, 1);
    EXPECT_GE(FieldValue(cones, "VarianceThreshold"), 1.0);
    EXPECT_EQ(FieldValue(cones, "NumberOfSectors"), 17.0);
    // What was set stays set.
    EXPECT_EQ(filter->GetVarianceThreshold(), 0.3);
    return cones;
  };

  const auto conservative = tuned(vtkConeSetFilter::Conservative);
  EXPECT_EQ(FieldValue(conservative, "Overlap"), 1.0);
  EXPECT_EQ(FieldValue(conservative, "CosineCorrection"), 0.0);
  EXPECT_EQ(FieldValue(conservative, "ExpansionFraction"), 1.0);
  EXPECT_EQ(FieldValue(conservative, "RadiusScale"), 1.0);
  const double leak = FieldValue(conservative, "TuningLeak");
  EXPECT_GE(leak, 0.0);
  EXPECT_LT(leak, 0.01);
  EXPECT_GT(FieldValue(conservative, "TuningObjective"), leak); // cones cost something

  const auto preview = tuned(vtkConeSetFilter::Preview);
  EXPECT_EQ(FieldValue(preview, "Overlap"), 1.0);
  EXPECT_EQ(FieldValue(preview, "CosineCorrection"), 1.0);
  EXPECT_GT(FieldValue(preview, "MaximumOverspill"), 0.0);
  EXPECT_LT(FieldValue(preview, "MaximumOverspill"), 1.0);
  EXPECT_GT(FieldValue(preview, "ExpansionFraction"), 0.0);
  EXPECT_LE(FieldValue(preview, "ExpansionFraction"), 1.0);
  EXPECT_LT(FieldValue(preview, "TuningObjective"), 0.05); // a flat board is an easy shadow
  EXPECT_NEAR(FieldValue(preview, "TuningLost"), FieldValue(preview, "TuningLeak"), 0.02);

  const auto soft = tuned(vtkConeSetFilter::Soft);
  EXPECT_EQ(FieldValue(soft, "Overlap"), 1.0);
  EXPECT_GT(FieldValue(soft, "RadiusScale"), 0.5);
  EXPECT_LT(FieldValue(soft, "RadiusScale"), 1.2);
  EXPECT_NEAR(FieldValue(soft, "TuningLost"), FieldValue(soft, "TuningLeak"), 0.02);
  const double caught = 1.0 - FieldValue(soft, "TuningLeak");
  EXPECT_NEAR(FieldValue(soft, "TuningObjective"), 1.0 - caught / (1.0 + FieldValue(soft, "TuningLost")), 1e-12);
}

TEST(ConeSetFilter, ManualSetsHaveNoTuning)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(Board().Vectors());
  filter->SetPhotonPathData(Board().Paths());
  filter->Update();
  for (const char* name : { "TuningObjective", "TuningLeak", "TuningLost", "TuningFits" })
  {
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
}

TEST(ConeSetFilter, TunesToWhatAnotherTracerMade)
{
  // The documented arrays alone, in double precision.
  const auto plain = [](vtkPolyData* full, std::initializer_list<const char*> names)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->SetPoints(full->GetPoints());
    for (const char* name : names)
    {
      vtkNew<vtkDoubleArray> array;
      array->DeepCopy(full->GetPointData()->GetArray(name));
      array->SetName(name);
      copy->GetPointData()->AddArray(array);
    }
    return copy;
  };
  const auto vectors = plain(Board().Vectors(), { "Direction", "EmissionPoint" });
  const auto paths = plain(Board().Paths(), { "PathState", "Direction", "EmissionPoint" });
  vtkNew<vtkConeSetFilter> filter;
  filter->SetToPaper();
  filter->SetInputData(vectors);
  filter->SetPhotonPathData(paths);
  filter->SetTuningToConservative();
  Messages messages(filter);
  filter->Update();
  EXPECT_EQ(messages.Errors, "");
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(FieldValue(filter->GetOutput(), "TuningLeak"), 0.01);
}

TEST(ConeSetFilter, NoVectorIsLeftOverByDefault)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetInputData(Board().Vectors());
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "NumberOfDiscarded"), 0.0);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Leftovers"), 1.0);
  EXPECT_SAYS(filter->GetOutput()->GetFieldData()->GetAbstractArray("TuningChoice")->GetVariantValue(0).ToString(),
    "no photon paths are connected");
  filter->SetToPaper();
  filter->Update();
  EXPECT_GT(FieldValue(filter->GetOutput(), "NumberOfDiscarded"), 0.0);
}

TEST(ConeSetFilter, ParametersThatTuningReplacesAreNamed)
{
  vtkNew<vtkConeSetFilter> filter;
  filter->SetInputData(Board().Vectors());
  filter->SetNumberOfNeighbors(50);
  filter->OverlapOn();
  Messages messages(filter);
  filter->Update();
  EXPECT_SAYS(messages.Warnings, "is not used: NumberOfNeighbors, Overlap.");
  messages.Warnings.clear();
  filter->SetTuningToManual();
  filter->Update();
  EXPECT_EQ(messages.Warnings, "");
}

TEST(ConeSetFilter, PathsThatTeachNothingGiveBounds)
{
  const auto paths = Board().Paths();
  for (const int state : { 0, 1 })
  {
    paths->GetPointData()->GetArray("PathState")->Fill(state);
    vtkNew<vtkConeSetFilter> filter;
    filter->SetInputData(Board().Vectors());
    filter->SetPhotonPathData(paths);
    filter->SetTuning(state == 0 ? vtkConeSetFilter::Conservative : vtkConeSetFilter::Preview);
    Messages messages(filter);
    filter->Update();
    EXPECT_EQ(messages.Errors, "");
    EXPECT_SAYS(messages.Warnings, state == 0 ? " 0 are blocked" : " 0 are lit");
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(FieldValue(filter->GetOutput(), "NumberOfDiscarded"), 0.0);
  }
}
