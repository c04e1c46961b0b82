// SPDX-License-Identifier: BSD-3-Clause
// Cones of several lights: fitted apart, tuned together, and held against the mesh a light at a time.
#include "Chain.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scClassifyByCones.h"
#include "scConeTally.h"
#include "scConeTuning.h"
#include "scSamplePrediction.h"
#include "scSampleTruth.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace shadowcones;
using namespace testsupport;

namespace
{
/// Strips of 0.2 x 2 with gaps of 0.1 at y = 0.
TestMesh Slats()
{
  TestMesh mesh;
  for (int strip = 0; strip < 7; ++strip)
  {
    mesh.AddSheet({ -1.0 + 0.3 * strip, 0.0, -1.0 }, { 0.2, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }, strip);
  }
  return mesh;
}

Light LampAt(double x)
{
  return DiscLight({ x, 2.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.3);
}

/// What photons of lights leave behind at the slats.
struct Traced
{
  explicit Traced(const std::vector<Light>& lights, vtkIdType photons)
  {
    const TestMesh mesh = Slats();
    const OccluderScene scene(mesh.View());
    ShadowVectorOptions options;
    options.NumberOfPhotons = photons;
    this->Result = Trace(scene, lights, options);
    for (const Light& light : lights)
    {
      this->Extents.push_back(LightExtentOf(light));
    }
  }
  ShadowVectorView Vectors() const { return ViewOf(this->Result.Vectors); }
  PhotonPathView Paths() const { return ViewOf(this->Result.Paths); }

  ShadowVectorResult Result;
  std::vector<LightExtent> Extents;
};

bool SameCone(const Cone& a, const Cone& b)
{
  return Length(a.Center - b.Center) == 0.0 && Length(a.Axis - b.Axis) == 0.0 && a.BaseRadius == b.BaseRadius &&
    a.HalfAngle == b.HalfAngle && a.InnerHalfAngle == b.InnerHalfAngle && a.OccluderId == b.OccluderId &&
    a.VectorCount == b.VectorCount && a.Overspill == b.Overspill;
}
} // anonymous namespace

TEST(ConesOfLights, EachLightHasTheConesThatItHasAlone)
{
  const std::vector<Light> lights = { LampAt(-0.5), LampAt(0.7) };
  const Traced both(lights, 6000);
  ConeSetOptions options;
  options.Expansion = ConeExpansion::LightGeometry;
  options.MaximumOverspill = 0.5;
  ConeSet set;
  ASSERT_TRUE(FitConeSet(both.Vectors(), both.Paths(), both.Extents, options, {}, set));
  const std::vector<std::vector<Cone>> cones = ConesOfLights(set.Cones, 2);
  vtkIdType discarded = 0;
  std::size_t first = 0;
  for (int light = 0; light < 2; ++light)
  {
    const Traced one({ lights[static_cast<std::size_t>(light)] }, 3000);
    ConeSet alone;
    ASSERT_TRUE(FitConeSet(one.Vectors(), one.Paths(), one.Extents[0], options, {}, alone));
    const std::vector<Cone>& mine = cones[static_cast<std::size_t>(light)];
    ASSERT_EQ(mine.size(), alone.Cones.size());
    ASSERT_GT(mine.size(), 3u);
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
      EXPECT_TRUE(SameCone(mine[i], alone.Cones[i])) << i;
      EXPECT_EQ(set.Cones[first + i].LightId, light);
    }
    std::vector<vtkIdType> ids;
    for (std::size_t i = 0; i < set.ConeIds.size(); ++i)
    {
      if (both.Result.Vectors.LightIds[i] == light)
      {
        ids.push_back(set.ConeIds[i] < 0 ? -1 : set.ConeIds[i] - static_cast<vtkIdType>(first));
      }
    }
    EXPECT_EQ(ids, alone.ConeIds);
    discarded += alone.NumberOfDiscarded;
    first += mine.size();
  }
  EXPECT_EQ(set.NumberOfDiscarded, discarded);
}

TEST(ConesOfLights, ALightIdWithoutALightIsAFault)
{
  const Traced both({ LampAt(-0.5), LampAt(0.7) }, 200);
  ConeSet set;
  const std::vector<LightExtent> one(1, both.Extents[0]);
  EXPECT_THROW(FitConeSet(both.Vectors(), both.Paths(), one, ConeSetOptions(), {}, set), std::invalid_argument);
}

TEST(ConesOfLights, OneLampTwiceIsMeasuredLikeOnce)
{
  // The paths of each are held against its own cones: shares of light are those of one lamp.
  const Traced once({ LampAt(0.2) }, 3000);
  const Traced twice({ LampAt(0.2), LampAt(0.2) }, 6000);
  for (const ConeTuning tuning : { ConeTuning::Conservative, ConeTuning::Preview, ConeTuning::Soft })
  {
    ConeSetOptions options;
    options.Expansion = ConeExpansion::LightGeometry;
    options.Overlap = true;
    ConeTuningResult one;
    ConeTuningResult two;
    ASSERT_TRUE(MeasureTuning(once.Vectors(), once.Paths(), once.Extents, tuning, options, {}, one));
    ASSERT_TRUE(MeasureTuning(twice.Vectors(), twice.Paths(), twice.Extents, tuning, options, {}, two));
    if (tuning == ConeTuning::Preview)
    {
      // Its samples are shifted from path to path.
      EXPECT_NEAR(two.Options.ExpansionFraction, one.Options.ExpansionFraction, 0.05);
      continue;
    }
    EXPECT_NEAR(two.Leak, one.Leak, 1e-12);
    EXPECT_NEAR(two.Lost, one.Lost, 1e-12);
    EXPECT_NEAR(two.Objective, one.Objective, 1e-12);
    EXPECT_NEAR(two.Options.RadiusScale, one.Options.RadiusScale, 1e-12);
  }
}

TEST(ConesOfLights, TruthAndPredictionAreOfOneLightEach)
{
  // Half a wall at y = 1 hides the left lamp from a point on the left below, and not the right one.
  TestMesh mesh;
  mesh.AddSheet({ -2.0, 1.0, -2.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 }, 0);
  const OccluderScene scene(mesh.View());
  const std::vector<Light> lights = { LampAt(-1.0), LampAt(1.8) };
  const std::vector<Vector3> points = { { -1.0, 0.0, 0.0 }, { 1.6, 0.0, 0.0 } };
  Cone cone;
  cone.Center = { -1.0, 1.0, 0.0 };
  cone.Axis = { 0.0, -1.0, 0.0 };
  cone.BaseRadius = 0.9;
  std::vector<Cone> cones(2, cone);
  cones[0].LightId = 1;
  cones[0].Center.X = 9.0;
  std::vector<SampleTruth> truth;
  ASSERT_TRUE(MeasureTruth(points, scene, lights, 64, 1, {}, truth));
  ASSERT_EQ(truth.size(), 4u);
  EXPECT_TRUE(truth[0].Umbra());
  EXPECT_FALSE(truth[1].Shadowed());
  EXPECT_FALSE(truth[2].Shadowed());
  EXPECT_FALSE(truth[3].Shadowed());
  std::vector<SamplePrediction> predictions;
  std::vector<ConeTally> tallies;
  ASSERT_TRUE(ClassifyByCones(2, points, truth, cones, {}, predictions, tallies));
  ASSERT_EQ(predictions.size(), 4u);
  EXPECT_EQ(predictions[0].ConeId, 1);
  EXPECT_EQ(predictions[1].ConeId, -1);
  EXPECT_EQ(predictions[2].ConeId, -1);
  EXPECT_EQ(tallies[0].Samples, 0);
  EXPECT_EQ(tallies[1].Shadowed, 1);
}
