// SPDX-License-Identifier: BSD-3-Clause
// The angles of fitted cones against closed forms 1 and 2.
#include "Chain.h"
#include "ClosedForms.h"
#include "TestLights.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Degree = closedforms::Pi / 180.0;

/// Few, large cones from the photons of a light: as the filters make them.
std::vector<Cone> FitCones(const TestMesh& mesh, const Light& light, int vectors)
{
  const ShadowVectorResult traced = TraceToHits(OccluderScene(mesh.View()), light, vectors);
  ConeSetOptions options = BoundOptions();
  options.NumberOfNeighbors = static_cast<int>(traced.Vectors.OccluderIds.size());
  options.VarianceThreshold = ConeSetOptions().VarianceThreshold;
  options.PlanarityThreshold = 0.0;
  const ConeSet set = Fit(traced, light, options);
  EXPECT_FALSE(set.Cones.empty());
  return set.Cones;
}
} // namespace

TEST(ConeAngles, DiscUnderADisc)
{
  const double R = 0.5;
  const double r = 0.3;
  const double L = 2.0;
  const Light light = DiscLight({}, { 0.0, 0.0, 1.0 }, R, { 1.0 });
  double outer = 0.0;
  double inner = 0.0;
  PenumbraAngles(LightExtentOf(light), { 0.0, 0.0, L }, { 0.0, 0.0, 1.0 }, r, outer, inner);
  // The light's rim is a polygon around it: bounds may be wider, by half a per cent of R, and never narrower.
  EXPECT_GE(outer, closedforms::DiscPenumbraHalfAngle(R, r, L));
  EXPECT_LE(outer, closedforms::DiscPenumbraHalfAngle(1.005 * R, r, L));
  EXPECT_LE(inner, std::atan((r - R) / L));
  EXPECT_GE(inner, std::atan((r - 1.005 * R) / L));
  // A converging umbra ends where the closed form says.
  EXPECT_NEAR(r / std::tan(-inner), closedforms::DiscUmbraLength(R, r, L), 0.05);
}

TEST(ConeAngles, FittedConeOfADisc)
{
  const double R = 0.5;
  const double r = 0.3;
  const double L = 2.0;
  const Light light = DiscLight({}, { 0.0, 0.0, 1.0 }, R, { 1.0 });
  TestMesh mesh;
  mesh.AddDisc({ 0.0, 0.0, L }, r);
  for (const Cone& cone : FitCones(mesh, light, 400))
  {
    // Every base lies on the disc, and its angle is that of the base under the light.
    EXPECT_NEAR(cone.Center.Z, L, 1e-6);
    EXPECT_LE(std::hypot(cone.Center.X, cone.Center.Y), r);
    EXPECT_GT(cone.Axis.Z, 0.98);
    const double lateral = std::hypot(cone.Center.X, cone.Center.Y);
    EXPECT_GE(cone.HalfAngle + 0.02, closedforms::DiscPenumbraHalfAngle(R, cone.BaseRadius, L));
    EXPECT_LE(cone.HalfAngle, closedforms::DiscPenumbraHalfAngle(R, cone.BaseRadius + lateral, L) + 0.02);
    EXPECT_LT(cone.InnerHalfAngle, cone.HalfAngle);
  }
}

TEST(ConeAngles, SunAndEarth)
{
  // Kilometres.
  const double R = 695700.0;
  const double r = 6371.0;
  const double D = 149597870.7;
  const Light light = SphereLight({}, R, { 1.0 });
  double outer = 0.0;
  double inner = 0.0;
  PenumbraAngles(LightExtentOf(light), { 0.0, 0.0, D }, { 0.0, 0.0, 1.0 }, r, outer, inner);
  EXPECT_NEAR(outer / Degree, closedforms::SpherePenumbraHalfAngle(R, r, D) / Degree, 1e-5);
  EXPECT_NEAR(inner / Degree, -closedforms::SphereUmbraHalfAngle(R, r, D) / Degree, 1e-5);
  EXPECT_NEAR(inner / Degree, -0.2640, 5e-5);
  EXPECT_NEAR(r / std::tan(-inner), closedforms::SphereUmbraLength(R, r, D), 100.0);

  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, D }, r, 32);
  for (const Cone& cone : FitCones(mesh, light, 300))
  {
    EXPECT_LT(cone.BaseRadius, 2.0 * r);
    // The axis is the mean direction of the vectors; by how much it misses the Sun's centre widens both angles.
    const double tilt = std::atan2(Length(Cross(cone.Center, cone.Axis)), Dot(cone.Center, cone.Axis)) / Degree;
    EXPECT_LT(tilt, 0.05);
    EXPECT_NEAR(
      cone.HalfAngle / Degree, closedforms::SpherePenumbraHalfAngle(R, cone.BaseRadius, D) / Degree + tilt, 5e-5);
    EXPECT_NEAR(
      cone.InnerHalfAngle / Degree, -closedforms::SphereUmbraHalfAngle(R, cone.BaseRadius, D) / Degree - tilt, 5e-5);
  }
}
