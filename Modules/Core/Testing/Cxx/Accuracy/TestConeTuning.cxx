// SPDX-License-Identifier: BSD-3-Clause
#include "Chain.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scConeTuning.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scLightSampling.h"
#include "scRandom.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// A slatted sheet under a disc light: seven strips of 0.2 x 2 with gaps of 0.1, one unit below the light.
class TunedSlats : public ::testing::Test
{
protected:
  void SetUp() override
  {
    for (int strip = 0; strip < 7; ++strip)
    {
      this->Mesh.AddSheet({ -1.0 + 0.3 * strip, 0.0, -1.0 }, { 0.0, 0.0, 2.0 }, { 0.2, 0.0, 0.0 }, strip);
    }
    this->Source = DiscLight({ 0.0, 2.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3, { 1.0 });
    this->Scene = std::make_unique<OccluderScene>(this->Mesh.View());
    this->Trace(4000);
    this->Extent = LightExtentOf(this->Source);
  }

  void Trace(vtkIdType count)
  {
    ShadowVectorOptions options;
    options.TargetNumberOfVectors = count;
    this->Traced = testsupport::Trace(*this->Scene, this->Source, options);
    this->Vectors = ViewOf(this->Traced.Vectors);
    this->Paths = ViewOf(this->Traced.Paths);
  }

  /// Rays of a box below the slats, [blocked][inside the cones].
  using Counts = std::array<std::array<double, 2>, 2>;
  Counts CountLight(const std::vector<Cone>& cones) const
  {
    Box bounds;
    bounds.Add(Vector3{ -1.5, -2.0, -1.5 });
    bounds.Add(Vector3{ 1.5, -0.01, 1.5 });
    const ConeHierarchy hierarchy(cones, bounds);
    Counts counts = {};
    for (int i = 0; i < 20000; ++i)
    {
      RandomStream random(99, static_cast<std::uint64_t>(i));
      const Vector3 x{ 3.0 * random.Next() - 1.5, -0.01 - 1.99 * random.Next(), 3.0 * random.Next() - 1.5 };
      const double u = random.Next();
      const IncidentSample sample = SampleVisibleLight(this->Source, x, u, random.Next());
      const bool blocked = this->Scene->Occluded(x, sample.Direction, 0.0, sample.Distance);
      counts[blocked][hierarchy.Contains(x)] += 1.0;
    }
    return counts;
  }

  /// Shares of the blocked and of the lit light of the box that lie inside the cones.
  std::pair<double, double> SharesInside(const std::vector<Cone>& cones) const
  {
    const Counts counts = this->CountLight(cones);
    return { counts[1][1] / (counts[1][0] + counts[1][1]), counts[0][1] / (counts[0][0] + counts[0][1]) };
  }

  ConeSet FitTuned(const ConeTuningResult& tuned) const
  {
    ConeSet set;
    EXPECT_TRUE(FitConeSet(this->Vectors, this->Paths, this->Extent, tuned.Options, {}, set));
    return set;
  }

  TestMesh Mesh;
  Light Source;
  std::unique_ptr<OccluderScene> Scene;
  ShadowVectorResult Traced;
  ShadowVectorView Vectors;
  PhotonPathView Paths;
  LightExtent Extent;
};

} // anonymous namespace

TEST_F(TunedSlats, ConservativeConesHoldTheBlockedLight)
{
  ConeTuningResult tuned;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Conservative, {}, {}, tuned));
  EXPECT_LE(tuned.Objective, tuned.StartObjective);
  EXPECT_EQ(tuned.Options.Expansion, ConeExpansion::LightGeometry);
  EXPECT_TRUE(tuned.Options.Overlap);
  EXPECT_GE(this->SharesInside(this->FitTuned(tuned).Cones).first, 0.995);
}

TEST_F(TunedSlats, TightConesHaveTheirOwnMeasure)
{
  ConeTuningResult bounds;
  ConeTuningResult tight;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Conservative, {}, {}, bounds));
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Tight, {}, {}, tight));
  EXPECT_LE(tight.Objective, tight.StartObjective);
  EXPECT_LT(tight.NumberOfFits, bounds.NumberOfFits);
  EXPECT_EQ(tight.Options.Leftovers, ConeLeftovers::Cover);
  EXPECT_LE(this->FitTuned(tight).Cones.size(), 160u);
  // The lit share of the light inside the cones, and a quarter of what leaks.
  EXPECT_NEAR(tight.Objective, tight.Lost / (1.0 - tight.Leak + tight.Lost) + 0.25 * tight.Leak, 1e-12);
  ConeTuningResult measured;
  ASSERT_TRUE(MeasureTuning(this->Vectors, this->Paths, this->Extent, ConeTuning::Tight, bounds.Options, {}, measured));
  EXPECT_LE(tight.Objective, 1.05 * measured.Objective);
}

TEST_F(TunedSlats, PreviewBalancesLostAndLeakedLight)
{
  ConeTuningResult tuned;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Preview, {}, {}, tuned));
  EXPECT_GT(tuned.Options.ExpansionFraction, 0.0);
  EXPECT_LT(tuned.Options.ExpansionFraction, 1.0);
  EXPECT_NEAR(tuned.Lost, tuned.Leak, 0.1 * tuned.Leak + 0.01);
  // Full angles lose far more lit light than the balanced ones.
  ConeTuningResult full = tuned;
  full.Options.ExpansionFraction = 1.0;
  EXPECT_GT(
    this->SharesInside(this->FitTuned(full).Cones).second, 1.2 * this->SharesInside(this->FitTuned(tuned).Cones).second);
}

TEST_F(TunedSlats, PreviewTrimsBasesAndGains)
{
  ConeTuningResult tuned;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Preview, {}, {}, tuned));
  ASSERT_LT(tuned.Options.MaximumOverspill, 1.0);
  const ConeSet set = this->FitTuned(tuned);
  for (const Cone& cone : set.Cones)
  {
    EXPECT_LE(cone.Overspill, tuned.Options.MaximumOverspill);
  }
  // Whole bases, balanced anew, are wrong for more of the light.
  ConeSetOptions whole = tuned.Options;
  whole.MaximumOverspill = 1.0;
  ConeTuningResult balanced;
  ASSERT_TRUE(MeasureTuning(this->Vectors, this->Paths, this->Extent, ConeTuning::Preview, whole, {}, balanced));
  const auto wrong = [this](const std::vector<Cone>& cones) {
    const Counts counts = this->CountLight(cones);
    return counts[0][1] + counts[1][0];
  };
  EXPECT_LT(wrong(set.Cones), 0.9 * wrong(this->FitTuned(balanced).Cones));
}

TEST_F(TunedSlats, PreviewSearchesWithFewVectorsAndChoosesWithMany)
{
  this->Trace(8000);
  double last = 0.0;
  Monitor monitor;
  monitor.Progress = [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  };
  ConeTuningResult tuned;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Preview, {}, monitor, tuned));
  EXPECT_DOUBLE_EQ(last, 1.0);
  EXPECT_LE(tuned.Objective, tuned.StartObjective);
  ConeTuningResult measured;
  ASSERT_TRUE(
    MeasureTuning(this->Vectors, this->Paths, this->Extent, ConeTuning::Preview, tuned.Options, {}, measured));
  EXPECT_EQ(measured.Objective, tuned.Objective);
  EXPECT_EQ(measured.Options.ExpansionFraction, tuned.Options.ExpansionFraction);
}

TEST_F(TunedSlats, OrderOfThePathsHardlyMatters)
{
  this->Trace(20000);
  std::vector<vtkIdType> order(this->Traced.Paths.States.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b) { return this->Traced.Paths.States[a] < this->Traced.Paths.States[b]; });
  auto sorted = this->Traced.Paths;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    sorted.States[i] = this->Traced.Paths.States[order[i]];
    for (int k = 0; k < 3; ++k)
    {
      sorted.Points[3 * i + k] = this->Traced.Paths.Points[3 * order[i] + k];
      sorted.EmissionPoints[3 * i + k] = this->Traced.Paths.EmissionPoints[3 * order[i] + k];
      sorted.Directions[3 * i + k] = this->Traced.Paths.Directions[3 * order[i] + k];
    }
  }
  PhotonPathView view = this->Paths;
  view.Points = sorted.Points.data();
  view.EmissionPoints = sorted.EmissionPoints.data();
  view.Directions = sorted.Directions.data();
  view.States = sorted.States.data();
  ConeTuningResult asTraced;
  ConeTuningResult litFirst;
  ASSERT_TRUE(MeasureTuning(this->Vectors, this->Paths, this->Extent, ConeTuning::Soft, {}, {}, asTraced));
  ASSERT_TRUE(MeasureTuning(this->Vectors, view, this->Extent, ConeTuning::Soft, {}, {}, litFirst));
  EXPECT_NEAR(litFirst.Objective, asTraced.Objective, 0.03);
  EXPECT_NEAR(litFirst.Options.RadiusScale, asTraced.Options.RadiusScale, 0.03);
}

TEST_F(TunedSlats, SoftBalancesCaughtAndMissedPaths)
{
  ConeTuningResult tuned;
  ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Soft, {}, {}, tuned));
  EXPECT_NEAR(tuned.Lost, tuned.Leak, 0.02);
  EXPECT_GT(tuned.Options.RadiusScale, 0.3);
  EXPECT_LT(tuned.Options.RadiusScale, 2.0);
  EXPECT_LT(tuned.Objective, 0.5);
  EXPECT_FALSE(tuned.Options.CosineCorrection);
}

TEST_F(TunedSlats, ChoiceIsNearTheBestOfRandomSets)
{
  for (const ConeTuning kind : { ConeTuning::Conservative, ConeTuning::Preview, ConeTuning::Soft })
  {
    ConeTuningResult tuned;
    ASSERT_TRUE(TuneConeSet(this->Vectors, this->Paths, this->Extent, kind, {}, {}, tuned));
    std::vector<double> objectives;
    for (int i = 0; i < 24; ++i)
    {
      RandomStream random(7, static_cast<std::uint64_t>(i));
      ConeSetOptions options = tuned.Options;
      options.NumberOfNeighbors = 20 + static_cast<int>(180.0 * random.Next());
      options.PointsPerRing = 6 + static_cast<int>(18.0 * random.Next());
      options.MinimumVectorsPerCone = std::min(options.NumberOfNeighbors, 5 + static_cast<int>(25.0 * random.Next()));
      options.VarianceThreshold = 1.1 + 1.5 * random.Next();
      ConeTuningResult measured;
      ASSERT_TRUE(MeasureTuning(this->Vectors, this->Paths, this->Extent, kind, options, {}, measured));
      objectives.push_back(measured.Objective);
    }
    std::sort(objectives.begin(), objectives.end());
    EXPECT_LE(tuned.Objective, 1.3 * objectives.front()) << "kind " << static_cast<int>(kind);
    EXPECT_LT(tuned.Objective, 0.9 * objectives[objectives.size() / 2]) << "kind " << static_cast<int>(kind);
  }
}

TEST_F(TunedSlats, HeldOutPathsOfOneKindGiveBoundsAndSaySo)
{
  std::vector<int> states(this->Traced.Paths.States.size(), 0);
  PhotonPathView paths = this->Paths;
  paths.States = states.data();
  ConeTuningResult tuned;
  for (const ConeTuning kind : { ConeTuning::Conservative, ConeTuning::Preview, ConeTuning::Soft })
  {
    ASSERT_TRUE(TuneConeSet(this->Vectors, paths, this->Extent, kind, {}, {}, tuned));
    EXPECT_NE(tuned.Lacking.find(" 0 are blocked"), std::string::npos) << tuned.Lacking;
    EXPECT_EQ(tuned.NumberOfFits, 0);
    EXPECT_EQ(tuned.Options.Leftovers, ConeLeftovers::Cover);
    EXPECT_EQ(tuned.Options.Expansion, ConeExpansion::LightGeometry);
  }
  // Bounds need no lit path to learn from.
  states.assign(states.size(), 1);
  ASSERT_TRUE(TuneConeSet(this->Vectors, paths, this->Extent, ConeTuning::Conservative, {}, {}, tuned));
  EXPECT_TRUE(tuned.Lacking.empty()) << tuned.Lacking;
  EXPECT_GT(tuned.NumberOfFits, 1);
  ASSERT_TRUE(TuneConeSet(this->Vectors, paths, this->Extent, ConeTuning::Soft, {}, {}, tuned));
  EXPECT_NE(tuned.Lacking.find(" 0 are lit"), std::string::npos) << tuned.Lacking;
}

TEST_F(TunedSlats, AbortsAndReportsProgress)
{
  int calls = 0;
  Monitor monitor;
  monitor.Progress = [&](double share) {
    ++calls;
    EXPECT_LE(share, 1.0);
  };
  monitor.Aborted = [&]() { return calls > 2; };
  ConeTuningResult tuned;
  EXPECT_FALSE(TuneConeSet(this->Vectors, this->Paths, this->Extent, ConeTuning::Conservative, {}, monitor, tuned));
  EXPECT_EQ(calls, 3);
}
