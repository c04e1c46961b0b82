// SPDX-License-Identifier: BSD-3-Clause
// Half angles against what geometry says, and the three expansions on vectors made by hand.
#include "Chain.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "scCone.h"
#include "scConeSet.h"
#include "scFrame.h"
#include "scLightExtent.h"
#include "scRandom.h"
#include "scShadowVectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{

struct Angles
{
  double Outer = 0.0;
  double Inner = 0.0;
};

Angles Penumbra(const LightExtent& light, const Vector3& center, const Vector3& axis, double radius)
{
  Angles angles;
  PenumbraAngles(light, center, axis, radius, angles.Outer, angles.Inner);
  return angles;
}

const Vector3 Down{ 0.0, 0.0, -1.0 };

/// Even vectors on a disc of radius 1 around the origin, with directions of the caller's choice.
struct DiscOfVectors
{
  std::vector<double> Points;
  std::vector<float> Directions;
  std::vector<double> EmissionPoints;

  template <typename DirectionAt>
  explicit DiscOfVectors(DirectionAt directionAt)
  {
    for (int i = 0; i < 97; ++i)
    {
      const double r = std::sqrt(i / 96.0);
      const double phi = i * Pi * (3.0 - std::sqrt(5.0));
      const Vector3 p{ r * std::cos(phi), r * std::sin(phi), 0.0 };
      const Vector3 d = Normalized(directionAt(p));
      this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
      this->Directions.insert(
        this->Directions.end(), { static_cast<float>(d.X), static_cast<float>(d.Y), static_cast<float>(d.Z) });
    }
  }
  Cone Fit(ConeExpansion expansion, const LightExtent& light, double fraction = 1.0) const
  {
    ConeSetOptions options;
    options.NumberOfNeighbors = 97;
    options.NumberOfSectors = 8;
    options.Expansion = expansion;
    options.ExpansionFraction = fraction;
    ConeSet set;
    EXPECT_TRUE(
      FitConeSet({ 97, this->Points.data(), this->Directions.data(), nullptr, nullptr }, {}, light, options, {}, set));
    EXPECT_EQ(set.Cones.size(), 1u);
    return set.Cones.empty() ? Cone() : set.Cones[0];
  }
};

} // namespace

TEST(PenumbraAngles, OfADiscLightOnTheAxis)
{
  for (const double bigR : { 0.1, 0.5, 2.0 })
  {
    for (const double r : { 0.05, 0.5, 3.0 })
    {
      for (const double length : { 0.5, 5.0 })
      {
        const LightExtent light = LightExtentOf(DiscLight({ 0.0, 0.0, length }, Down, bigR));
        const Angles angles = Penumbra(light, {}, Down, r);
        // The disc is held by a polygon around it: up to 1 / cos(pi / 32) wider, never narrower.
        const double wide = bigR / std::cos(Pi / 32.0);
        EXPECT_GE(angles.Outer, std::atan((bigR + r) / length) - 1e-12);
        EXPECT_LE(angles.Outer, std::atan((wide + r) / length) + 1e-12);
        EXPECT_LE(angles.Inner, std::atan((r - bigR) / length) + 1e-12);
        EXPECT_GE(angles.Inner, std::atan((r - wide) / length) - 1e-12);
      }
    }
  }
}

TEST(PenumbraAngles, OfATiltedDiscAreReachedAtItsExtremePoints)
{
  const Light disc = DiscLight({ 1.0, 0.5, 4.0 }, { 0.4, -0.3, -1.0 }, 0.7);
  const Vector3 axis = Normalized({ -0.2, -0.1, -1.0 });
  const double r = 0.3;
  double outer = -2.0;
  double inner = 2.0;
  const Frame frame = FrameAround(disc.Normal);
  for (int i = 0; i < 3600; ++i)
  {
    const double phi = 2.0 * Pi * i / 3600;
    const Vector3 p = disc.Center + 0.7 * std::cos(phi) * frame.U + 0.7 * std::sin(phi) * frame.V;
    const double height = -Dot(p, axis);
    const double lateral = Length(p + height * axis);
    outer = std::max(outer, std::atan((r + lateral) / height));
    inner = std::min(inner, std::atan((r - lateral) / height));
  }
  const Angles angles = Penumbra(LightExtentOf(disc), {}, axis, r);
  EXPECT_GE(angles.Outer, outer);
  EXPECT_LE(angles.Outer, outer + 2e-3);
  EXPECT_LE(angles.Inner, inner);
  EXPECT_GE(angles.Inner, inner - 2e-3);
}

TEST(PenumbraAngles, OfASphereAreTangents)
{
  // The extremes over all points of the sphere, on the axis and beside it.
  for (const Vector3& center : { Vector3{ 0.0, 0.0, 3.0 }, Vector3{ 0.8, -0.4, 3.0 } })
  {
    const double bigR = 0.6;
    const double r = 0.25;
    const Angles angles = Penumbra(LightExtentOf(SphereLight(center, bigR)), {}, Down, r);
    double outer = -2.0;
    double inner = 2.0;
    for (int i = 0; i <= 720; ++i)
    {
      for (int k = 0; k < 720; ++k)
      {
        const double theta = Pi * i / 720;
        const double phi = 2.0 * Pi * k / 720;
        const Vector3 p =
          center + bigR * Vector3{ std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
        const double lateral = std::hypot(p.X, p.Y);
        outer = std::max(outer, std::atan((r + lateral) / p.Z));
        inner = std::min(inner, std::atan((r - lateral) / p.Z));
      }
    }
    EXPECT_NEAR(angles.Outer, outer, 1e-4) << center.X;
    EXPECT_NEAR(angles.Inner, inner, 1e-4) << center.X;
  }
}

TEST(PenumbraAngles, OfARectangleAndOfAMeshAreThoseOfTheirCorners)
{
  Light rectangle;
  rectangle.Shape = LightShape::Rectangle;
  rectangle.Center = { 0.0, 0.0, 2.0 };
  rectangle.Normal = Down;
  rectangle.AxisU = { 0.6, 0.0, 0.0 };
  rectangle.AxisV = { 0.0, -0.8, 0.0 };
  rectangle = Prepared(rectangle);
  const double outer = std::atan((0.5 + 1.0) / 2.0);
  const double inner = std::atan((0.5 - 1.0) / 2.0);
  const Angles angles = Penumbra(LightExtentOf(rectangle), {}, Down, 0.5);
  EXPECT_NEAR(angles.Outer, outer, 1e-12);
  EXPECT_NEAR(angles.Inner, inner, 1e-12);

  Light mesh;
  mesh.Shape = LightShape::Mesh;
  mesh.Triangles = { { Vector3{ -0.6, -0.8, 2.0 }, Vector3{ 0.6, 0.8, 2.0 }, Vector3{ 0.6, -0.8, 2.0 } } };
  const Angles ofMesh = Penumbra(LightExtentOf(Prepared(mesh)), {}, Down, 0.5);
  EXPECT_NEAR(ofMesh.Outer, outer, 1e-12);
  EXPECT_NEAR(ofMesh.Inner, inner, 1e-12);
}

TEST(PenumbraAngles, OfThePointAndTheSun)
{
  const Angles point = Penumbra(LightExtentOf(PointLight({ 0.0, 0.0, 4.0 })), {}, Down, 1.0);
  EXPECT_NEAR(point.Outer, std::atan(0.25), 1e-12);
  EXPECT_NEAR(point.Inner, std::atan(0.25), 1e-12); // no penumbra
  const Angles sun = Penumbra(LightExtentOf(SunLight(Down, 0.00465)), {}, Down, 1.0);
  EXPECT_NEAR(sun.Outer, 0.00465, 1e-12);
  EXPECT_NEAR(sun.Inner, -0.00465, 1e-12);
}

TEST(PenumbraAngles, OfASunReachAsFarAsTheAxisIsTurned)
{
  // Every way that light takes away from the Sun lies within its radius of the middle one, which is 0.02 off the axis.
  const Vector3 axis{ std::sin(0.02), 0.0, -std::cos(0.02) };
  const Angles sun = Penumbra(LightExtentOf(SunLight(Down, 0.1)), {}, axis, 1.0);
  EXPECT_NEAR(sun.Outer, 0.12, 1e-12);
  EXPECT_NEAR(sun.Inner, -0.12, 1e-12);
}

TEST(PenumbraAngles, OfTheWholeSkyStayBelowARightAngle)
{
  for (const double radius : { 1.5, 1.57, Pi / 2.0 })
  {
    for (const Vector3& axis : { Down, Normalized(Vector3{ 0.5, 0.2, -1.0 }) })
    {
      const Angles sky = Penumbra(LightExtentOf(SunLight(Down, radius)), {}, axis, 0.5);
      EXPECT_LT(static_cast<double>(static_cast<float>(sky.Outer)), Pi / 2.0);
      EXPECT_GT(static_cast<double>(static_cast<float>(sky.Inner)), -Pi / 2.0);
      EXPECT_GE(sky.Outer, std::min(radius, 1.56)); // a thousandth of the height still lies inside
      EXPECT_TRUE(std::isfinite(std::tan(sky.Outer)));
    }
  }
}

TEST(PenumbraAngles, StayFiniteForALightBesideOrAroundTheBase)
{
  for (const Light& light : { DiscLight({ 0.0, 0.0, 0.0 }, Down, 1.0), DiscLight({ 3.0, 0.0, -1.0 }, Down, 1.0),
         SphereLight({ 0.0, 0.0, 0.0 }, 2.0), PointLight({}) })
  {
    const Angles angles = Penumbra(LightExtentOf(light), {}, Down, 0.5);
    EXPECT_TRUE(std::isfinite(std::tan(angles.Outer)));
    EXPECT_TRUE(std::isfinite(std::tan(angles.Inner)));
    EXPECT_LT(std::abs(angles.Outer), Pi / 2.0);
    EXPECT_LT(std::abs(angles.Inner), Pi / 2.0);
  }
}

TEST(LightExtent, OfEmissionPointsHoldsThemAll)
{
  std::vector<double> points;
  RandomStream random(3, 0);
  for (int i = 0; i < 300; ++i)
  {
    points.push_back(7.0 + random.Next() * (i % 3 + 1));
  }
  const LightExtent extent = LightExtentOf(points.data(), 100);
  double farthest = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    farthest =
      std::max(farthest, Length(Vector3{ points[3 * i], points[3 * i + 1], points[3 * i + 2] } - extent.Center));
  }
  EXPECT_NEAR(extent.Radius, farthest, 1e-12);
  EXPECT_LT(extent.Radius, 2.0);
  EXPECT_TRUE(extent.Extremes.empty());
}

TEST(ConeExpansion, MaximumDeviationIsTheWidestVector)
{
  // Away from a point light at height 4: the rim's vectors deviate by atan(1 / 4).
  const DiscOfVectors vectors([](const Vector3& p) { return p - Vector3{ 0.0, 0.0, 4.0 }; });
  const LightExtent light = LightExtentOf(PointLight({ 0.0, 0.0, 4.0 }));
  const Cone cone = vectors.Fit(ConeExpansion::MaximumDeviation, light);
  EXPECT_NEAR(cone.HalfAngle, std::atan(0.25), 3e-3); // the mean of 97 directions is not quite the axis
  EXPECT_NEAR(cone.InnerHalfAngle, std::atan(0.25), 3e-3);
  // One outlier widens it to that vector's own angle.
  const DiscOfVectors outlier([](const Vector3& p) { return Length(p) < 1e-9 ? Vector3{ 0.5, 0.0, -1.0 } : Down; });
  EXPECT_NEAR(outlier.Fit(ConeExpansion::MaximumDeviation, light).HalfAngle, std::atan(0.5), 6e-3);
}

TEST(ConeExpansion, RadiusRatioFindsDivergingParallelAndConvergingSets)
{
  const LightExtent light = LightExtentOf(DiscLight({ 0.0, 0.0, 4.0 }, Down, 0.5));
  const auto angle = [&](const DiscOfVectors& vectors)
  { return vectors.Fit(ConeExpansion::RadiusRatio, light).HalfAngle; };
  EXPECT_NEAR(angle(DiscOfVectors(
                [](const Vector3& p) {
                  return p - Vector3{ 0.0, 0.0, 4.0 };
                })),
    std::atan(0.25), 5e-3);
  EXPECT_NEAR(angle(DiscOfVectors([](const Vector3&) { return Down; })), 0.0, 1e-6);
  // Towards a focus 5 ahead: a light larger than the base, seen through it.
  const DiscOfVectors converging([](const Vector3& p) { return Vector3{ 0.0, 0.0, -5.0 } - p; });
  EXPECT_NEAR(angle(converging), -std::atan(0.2), 5e-3);
  // MaximumDeviation cannot tell it from a diverging set.
  EXPECT_GT(converging.Fit(ConeExpansion::MaximumDeviation, light).HalfAngle, 0.1);
}

TEST(ConeExpansion, LightGeometryNeedsNoSampling)
{
  // All vectors straight down, yet the light is wide: the penumbra cone of the base disc.
  const DiscOfVectors vectors([](const Vector3&) { return Down; });
  const LightExtent light = LightExtentOf(DiscLight({ 0.0, 0.0, 4.0 }, Down, 0.5));
  const Cone cone = vectors.Fit(ConeExpansion::LightGeometry, light);
  EXPECT_NEAR(cone.BaseRadius, 1.0, 1e-6);
  EXPECT_NEAR(cone.HalfAngle, std::atan(1.5 / 4.0), 2e-3);
  EXPECT_NEAR(cone.InnerHalfAngle, std::atan(0.5 / 4.0), 2e-3);
  EXPECT_EQ(vectors.Fit(ConeExpansion::MaximumDeviation, light).HalfAngle, 0.0);
}

TEST(ConeExpansion, FractionScalesTheOuterAngleAlone)
{
  const DiscOfVectors vectors([](const Vector3& p) { return p - Vector3{ 0.0, 0.0, 4.0 }; });
  const LightExtent light = LightExtentOf(DiscLight({ 0.0, 0.0, 4.0 }, Down, 0.5));
  for (const ConeExpansion expansion :
    { ConeExpansion::MaximumDeviation, ConeExpansion::RadiusRatio, ConeExpansion::LightGeometry })
  {
    const Cone whole = vectors.Fit(expansion, light);
    const Cone part = vectors.Fit(expansion, light, 0.25);
    EXPECT_NEAR(part.HalfAngle, 0.25 * whole.HalfAngle, 1e-12);
    EXPECT_EQ(part.InnerHalfAngle, whole.InnerHalfAngle);
    EXPECT_EQ(vectors.Fit(expansion, light, 0.0).HalfAngle, 0.0);
  }
}

TEST(ConeExpansion, MaximumDeviationComesNearTheLightGeometryOfARealShadow)
{
  // Vectors of a disc light behind a small sheet: the widest sampled vector lies just inside the penumbra cone.
  TestMesh mesh;
  mesh.AddSheet({ -1.0, -1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, 0);
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, Down, 0.5);
  const OccluderScene scene(mesh.View());
  ShadowVectorOptions tracing;
  tracing.NumberOfPhotons = 4000;
  const ShadowVectorResult traced = Trace(scene, light, tracing);
  ConeSetOptions options;
  options.CosineCorrection = false;
  const ConeSet sampled = Fit(traced, light, options);
  options.Expansion = ConeExpansion::LightGeometry;
  const ConeSet exact = Fit(traced, light, options);
  ASSERT_GT(exact.Cones.size(), 10u);
  double shareSum = 0.0;
  for (std::size_t i = 0; i < exact.Cones.size(); ++i)
  {
    EXPECT_LE(sampled.Cones[i].HalfAngle, exact.Cones[i].HalfAngle + 1e-6);
    shareSum += sampled.Cones[i].HalfAngle / exact.Cones[i].HalfAngle;
  }
  EXPECT_GT(shareSum / static_cast<double>(exact.Cones.size()), 0.8);
}
