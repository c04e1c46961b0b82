// SPDX-License-Identifier: BSD-3-Clause
// When a warning is given and which numbers are in it; all numbers are counted by hand.
#include "scWarnings.h"

#include "scFieldArrays.h"
#include "scVisibilityGrid.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace shadowcones;

namespace
{

void ExpectSays(const std::string& sentence, const std::string& part)
{
  EXPECT_NE(sentence.find(part), std::string::npos) << "says: " << sentence;
}

/// 3 x 2 x 2 places, so two cells; all were asked for.
VisibilityGrid TwoCells(const std::vector<float>& values)
{
  VisibilityGrid grid;
  grid.Spacing = { 1.0, 1.0, 1.0 };
  grid.Dimensions = { 3, 2, 2 };
  grid.Visibility = values;
  grid.Marked.assign(12, 1);
  return grid;
}

} // namespace

TEST(Warnings, EachSentenceIsKeptOnce)
{
  Warnings warnings;
  for (const char* sentence : { "b", "", "a", "b" })
  {
    warnings.Add(sentence);
  }
  warnings.Add(std::vector<std::string>{ "c", "a" });
  EXPECT_EQ(warnings.GetSentences(), (std::vector<std::string>{ "b", "a", "c" }));
}

TEST(Warnings, Photons)
{
  ExpectSays(NothingInShadow(500, 0), "None of 500 photons");
  EXPECT_EQ(NothingInShadow(500, 1), "");
  EXPECT_EQ(NothingInShadow(0, 0), "");
  ExpectSays(NothingLit(500, 500, 6.28), "All 500 photons");
  EXPECT_EQ(NothingLit(500, 499, 6.28), "");
  EXPECT_EQ(NothingLit(500, 500, 0.1), ""); // a narrow bundle, aimed at a plate
  ExpectSays(TargetNotMet(7, 9, 1000), "Only 7 of 9 vectors were stored by 1000 photons");
  EXPECT_EQ(TargetNotMet(9, 9, 1000), "");
  // Occluders 0, 1, 5 and receivers; 1 and 5 have vectors.
  ExpectSays(OccludersWithoutVectors({ -1, 0, 0, 1, 5, -7 }, { 5, 1, 1 }), "1 of 3 occluders");
  EXPECT_EQ(OccludersWithoutVectors({ -1, 0 }, { 0 }), "");
}

TEST(Warnings, Cones)
{
  ExpectSays(NoCones(0, 12), "No cones from 12 shadow vectors");
  EXPECT_EQ(NoCones(0, 0), "");
  EXPECT_EQ(NoCones(1, 12), "");
  // Of the occluders 0, 2, 3 only 2 has a vector in a cone.
  ExpectSays(OccludersWithoutCone({ 0, 0, 2, 2, 3 }, { -1, -1, 4, -1, -1 }), "2 of 3 occluders");
  EXPECT_EQ(OccludersWithoutCone({ 0, 2 }, { 0, 0 }), "");
  EXPECT_EQ(OccludersWithoutCone({}, { 0, 0 }), ""); // vectors without ids
  ExpectSays(EmptyConeSet(0, 12), "12 triangles");
  EXPECT_EQ(EmptyConeSet(0, 0), "");

  vtkNew<vtkFieldData> field;
  EXPECT_EQ(TooManyDiscarded(nullptr, false), "");
  EXPECT_EQ(TooManyDiscarded(field, false), "");
  AddDoubleArray(field, "DiscardedFraction", 1, { 0.42 });
  ExpectSays(TooManyDiscarded(field, false), "42 % of the shadow vectors");
  EXPECT_EQ(TooManyDiscarded(field, true), "");
  AddDoubleArray(field, "DiscardedFraction", 1, { 0.3 });
  EXPECT_EQ(TooManyDiscarded(field, false), "");
}

TEST(Warnings, PhotonsOfScarceOccluders)
{
  EXPECT_EQ(TooFewVectors(0, 32, 0), "");
  ExpectSays(TooFewVectors(2, 32, 0), "2 times an occluder has fewer than 32 shadow vectors");
  ExpectSays(TooFewVectors(2, 32, 0), "Take more photons, or");
  ExpectSays(TooFewVectors(2, 32, 9000), "About 9000 photons are needed: SetNumberOfPhotons(9000), or");
}

TEST(Warnings, Places)
{
  ExpectSays(NoPlaceInShadow("points", 20, 0, 3), "None of 20 points is in shadow, although there are 3 cones");
  EXPECT_EQ(NoPlaceInShadow("points", 20, 1, 3), "");
  EXPECT_EQ(NoPlaceInShadow("points", 20, 0, 0), "");
  EXPECT_EQ(NoPlaceInShadow("points", 9, 0, 3), ""); // a few may well be lit
  ExpectSays(NoPlaceLit("cells", 10, 0), "None of 10 cells sees any of the light");
  EXPECT_EQ(NoPlaceLit("cells", 10, 1), "");
  ExpectSays(OccludersWithoutSurface(2, 5), "2 of 5 occluders");
  EXPECT_EQ(OccludersWithoutSurface(0, 5), "");
  ExpectSays(TrianglesDropped(3, 12), "3 of 12 triangles (25 %)");
  EXPECT_EQ(TrianglesDropped(1, 12), "");
}

TEST(Warnings, CellsThatAnEdgeCrosses)
{
  // The edge lies in the first cell of two: half of them.
  const std::vector<float> edge{ 0, 1, 1, 0, 1, 1, 0, 1, 1, 0, 1, 1 };
  ExpectSays(TooCoarse(TwoCells(edge), "Mend it."), "50 % of the 2 cells");
  std::vector<float> soft = edge;
  for (std::size_t i = 0; i < soft.size(); i += 3)
  {
    soft[i] = 0.5f;
  }
  EXPECT_EQ(TooCoarse(TwoCells(soft), ""), "");
  EXPECT_EQ(TooCoarse(VisibilityGrid{}, ""), "");

  // Refined by 2: of the brick's eight cells the four on one side hold it, a quarter of both cells together.
  VisibilityGrid grid = TwoCells(edge);
  grid.BrickParts = 2;
  grid.BrickCells = { 0 };
  for (int i = 0; i < 27; ++i)
  {
    grid.BrickVisibility.push_back(i % 3 == 0 ? 0.0f : 1.0f);
  }
  EXPECT_EQ(TooCoarse(grid, ""), "");
  grid.Marked.assign(12, 0); // the brick's cell alone is left
  ExpectSays(TooCoarse(grid, ""), "50 % of the 1 cells");
}

TEST(Warnings, CoordinatesThatAreTooCoarseForTheMesh)
{
  // Edges of 1 at x = 2^24, where neighbours in single precision are 2 apart, and at 2^20, where they are 1/8 apart.
  for (const double place : { 1048576.0, 16777216.0 })
  {
    for (const int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      vtkNew<vtkPoints> points;
      points->SetDataType(type);
      points->InsertNextPoint(place, 0.0, 0.0);
      points->InsertNextPoint(place, 1.0, 0.0);
      points->InsertNextPoint(place, 0.0, 1.0);
      vtkNew<vtkPolyData> mesh;
      mesh->SetPoints(points);
      vtkNew<vtkCellArray> cells;
      cells->InsertNextCell({ 0, 1, 2 });
      mesh->SetPolys(cells);
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, mesh);
      if (type == VTK_FLOAT && place > 2e6)
      {
        ExpectSays(CoarseCoordinates(mesh), "1 of 1 polygons (100 %)");
        ExpectSays(CoarseCoordinates(blocks), "1 of 1 polygons (100 %)");
      }
      else
      {
        EXPECT_EQ(CoarseCoordinates(mesh), "") << place;
      }
    }
  }
  EXPECT_EQ(CoarseCoordinates(nullptr), "");
  ExpectSays(ConesLeak(0.05), "5 % of the blocked light");
  EXPECT_EQ(ConesLeak(0.01), "");
}

TEST(Warnings, Images)
{
  ExpectSays(MediumNotSeen(100, 0), "None of 100 camera rays");
  EXPECT_EQ(MediumNotSeen(100, 1), "");
  ExpectSays(NothingSeen(100, 0), "All 100 pixels are black");
  EXPECT_EQ(NothingSeen(100, 1), "");
  ExpectSays(GoalNotMet(200, 50, 0.01, 0.25, 1024), "50 of 200 pixels (25 %)");
  ExpectSays(GoalNotMet(200, 50, 0.01, 0.25, 1024), "a relative error of 0.25: MaximumSamples, 1024");
  EXPECT_EQ(GoalNotMet(200, 2, 0.01, 0.25, 1024), "");
  ExpectSays(SurfaceGoalNotMet(200, 50, 0.01, 0.25, 1024), "The surfaces of 50 of 200 pixels (25 %)");
  EXPECT_EQ(SurfaceGoalNotMet(200, 2, 0.01, 0.25, 1024), "");
  ExpectSays(MediumBeyondVolume(0.125), "12.5 % of the medium");
  EXPECT_EQ(MediumBeyondVolume(0.0), "");
  ExpectSays(UnusedExposure(2.5), "Exposure is 2.5");
  EXPECT_EQ(UnusedExposure(1.0), "");
}
