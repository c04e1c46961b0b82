// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of the scattering image: irradiances in closed form, errors as they are claimed, normals of curved bodies.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double reflectance = 0.5;

/// Parallel view straight down on a floor at z = 0 from x = -HalfHeight on, in a void.
struct Floor
{
  TestMesh Mesh;
  Light Lamp;
  Medium Void;
  Camera View;
  ScatteringOptions Options;

  Floor(Light lamp, int width, int height)
    : Lamp(std::move(lamp))
  {
    this->Mesh.AddSheet({ -50.0, -50.0, 0.0 }, { 100.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 }, -1);
    this->Void.SigmaS.assign(this->Lamp.Spectrum.size(), 0.0);
    this->Void.SigmaA.assign(this->Lamp.Spectrum.size(), 0.0);
    this->Void.Bounds = { { -60.0, -60.0, -1.0 }, { 60.0, 60.0, 30.0 } };
    this->View.Position = { 0.0, 0.0, 0.6 }; // below what shadows the floor
    this->View.Parallel = true;
    this->View.HalfHeight = 1.0;
    this->Options.Width = width;
    this->Options.Height = height;
    this->Options.Extent = { 0, width - 1, 0, height - 1 };
    this->Options.Reflectance = reflectance;
    this->Options.NumberOfEdgeSamples = 1;
    this->Options.LightVisible = false;
  }
  Vector3 PointOf(int i, int j) const
  {
    const double pixel = 2.0 * this->View.HalfHeight / this->Options.Height;
    return { (i + 0.5 - 0.5 * this->Options.Width) * pixel, (j + 0.5 - 0.5 * this->Options.Height) * pixel, 0.0 };
  }
  ScatteringImage Render(const OccluderScene& occluders, const ConeHierarchy* cones = nullptr) const
  {
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering({ occluders, this->Lamp, this->Void, this->View, cones }, this->Options, {}, image));
    return image;
  }
};

/// From an element to a parallel disc of radius r at height h whose centre is a aside (Howell, catalog of configuration
/// factors, differential element to disc in a parallel plane).
double FactorOfDisc(double r, double h, double a)
{
  if (a < 1e-9)
  {
    return r * r / (r * r + h * h);
  }
  const double z = 1.0 + h * h / (a * a) + r * r / (a * a);
  return 0.5 * (1.0 - (z - 2.0 * r * r / (a * a)) / std::sqrt(z * z - 4.0 * r * r / (a * a)));
}

/// The share of a disc beyond a chord at distance @p t from the centre, in radii.
double SegmentBeyond(double t)
{
  t = std::clamp(t, -1.0, 1.0);
  return (std::acos(t) - t * std::sqrt(1.0 - t * t)) / Pi;
}

/// A small far lamp above the floor, of which a half plane at mid height hides x above 0.03: one edge of half-shadow.
struct EdgeStage : Floor
{
  static constexpr double Height = 20.0;
  static constexpr double Radius = 0.5;

  EdgeStage(int width, int height)
    : Floor(DiscLight({ 0.0, 0.0, Height }, { 0.0, 0.0, -1.0 }, Radius), width, height)
  {
    this->Mesh.AddSheet({ 0.03, -30.0, 0.5 * Height }, { 30.0, 0.0, 0.0 }, { 0.0, 60.0, 0.0 }, 0);
  }
  double TruthAt(const Vector3& point) const
  {
    const double chord = point.X + 2.0 * (0.03 - point.X); // of the lamp's plane, from its centre
    const double open = 1.0 - SegmentBeyond(chord / Radius);
    return reflectance * FactorOfDisc(Radius, Height, std::hypot(point.X, point.Y)) * open;
  }
};

} // namespace

TEST(SurfaceLight, WhatNothingHidesIsThatOfADiscAboveAFloor)
{
  // Far, and so near that the floor sees it under nearly a half space.
  for (const double height : { 3.0, 0.3 })
  {
    Floor floor(DiscLight({ 0.2, 0.1, height }, { 0.0, 0.0, -1.0 }, 0.4), 24, 16);
    floor.View.Position.Z = 0.1;
    const OccluderScene occluders(floor.Mesh.View());
    const ConeHierarchy none({}, floor.Void.Bounds);
    for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast,
           ScatteringMode::Guided, ScatteringMode::Volume })
    {
      floor.Options.Mode = mode;
      const ScatteringImage image = floor.Render(occluders, &none);
      double mean = 0.0;
      for (const float value : image.SurfaceRadiance)
      {
        mean += value / static_cast<double>(image.SurfaceRadiance.size());
      }
      for (int j = 0; j < 16; ++j)
      {
        for (int i = 0; i < 24; ++i)
        {
          const Vector3 point = floor.PointOf(i, j);
          const double truth =
            reflectance * FactorOfDisc(0.4, height, std::hypot(point.X - 0.2, point.Y - 0.1));
          const std::size_t pixel = image.IndexOf(i, j);
          const double value = image.SurfaceRadiance[7 * pixel];
          ASSERT_NEAR(value / truth, 1.0, 1e-3) << height << ": " << i << ", " << j;
          const double claim = image.SurfaceRelativeError[pixel];
          if (mode == ScatteringMode::Fast)
          {
            ASSERT_EQ(claim, -1.0);
            continue;
          }
          ASSERT_LE(std::fabs(value / truth - 1.0), claim + 1e-6) << height << ": " << i << ", " << j;
          // What the rays of BruteForce may have missed is what is wanted of them; Medium says the same.
          const bool knows = mode == ScatteringMode::Guided || mode == ScatteringMode::Volume;
          ASSERT_LE(claim * value, knows ? 0.002 * value : 0.015 * std::max(value, 0.15 * mean));
        }
      }
      EXPECT_EQ(image.NumberOfShortPixels, 0);
    }
  }
}

TEST(SurfaceLight, AnEdgeThatHidesHalfOfADiscIsASegment)
{
  EdgeStage stage(48, 16);
  stage.View.HalfHeight = 0.25;
  const OccluderScene occluders(stage.Mesh.View());
  stage.Options.Mode = ScatteringMode::Guided;
  stage.Options.MaximumSamples = 16384;
  double largest = 0.0;
  for (int i = 0; i < 48; ++i)
  {
    largest = std::max(largest, stage.TruthAt(stage.PointOf(i, 8)));
  }
  for (const double goal : { 0.05, 0.01 })
  {
    stage.Options.RelativeErrorGoal = goal;
    int sampled = 0;
    int withinOne = 0;
    int withinTwo = 0;
    int bright = 0;
    double squares = 0.0;
    double squaresInTheDark = 0.0;
    double bias = 0.0;
    const int seeds = 4;
    for (int seed = 1; seed <= seeds; ++seed)
    {
      stage.Options.Seed = static_cast<std::uint64_t>(seed);
      const ScatteringImage image = stage.Render(occluders);
      EXPECT_EQ(image.NumberOfShortPixels, 0);
      for (int j = 0; j < 16; ++j)
      {
        for (int i = 0; i < 48; ++i)
        {
          const double truth = stage.TruthAt(stage.PointOf(i, j));
          const std::size_t pixel = image.IndexOf(i, j);
          const double value = image.SurfaceRadiance[7 * pixel];
          const double difference = value - truth;
          bias += difference / largest;
          if (truth < 0.02 * largest || truth > 0.98 * largest)
          {
            continue;
          }
          const double claim = image.SurfaceRelativeError[pixel] * value;
          ++sampled;
          withinOne += std::fabs(difference) <= claim ? 1 : 0;
          withinTwo += std::fabs(difference) <= 2.0 * claim ? 1 : 0;
          // What is nearly dark may look all dark, and err by as much as if it were lit.
          const bool isBright = truth > 0.2 * largest;
          bright += isBright ? 1 : 0;
          const double relative = difference / (goal * (isBright ? truth : largest));
          (isBright ? squares : squaresInTheDark) += relative * relative;
        }
      }
    }
    ASSERT_GT(sampled, 1000);
    // Of a normal distribution 0.68 and 0.95.
    EXPECT_GT(withinOne, 0.68 * sampled) << goal;
    EXPECT_GT(withinTwo, 0.95 * sampled) << goal;
    EXPECT_LT(std::sqrt(squares / bright), 1.2) << goal;
    EXPECT_LT(std::sqrt(squaresInTheDark / (sampled - bright)), 1.0) << goal;
    EXPECT_LT(std::fabs(bias) / (48 * 16 * seeds), 0.05 * goal) << goal;
  }
}

TEST(SurfaceLight, FewSamplesAreRightOnAverage)
{
  // Two samples look, and a handful count: over many seeds their mean is right at every pixel of the half-shadow.
  EdgeStage stage(24, 2);
  stage.View.HalfHeight = 0.05;
  stage.Options.RelativeErrorGoal = 0.5;
  stage.Options.NumberOfSurfaceLightSamples = 4;
  const OccluderScene occluders(stage.Mesh.View());
  const int seeds = 1000;
  std::vector<double> sums(48, 0.0);
  std::vector<double> squares(48, 0.0);
  for (int seed = 0; seed < seeds; ++seed)
  {
    stage.Options.Seed = static_cast<std::uint64_t>(seed);
    const ScatteringImage image = stage.Render(occluders);
    for (std::size_t pixel = 0; pixel < sums.size(); ++pixel)
    {
      const double truth = stage.TruthAt(stage.PointOf(static_cast<int>(pixel % 24), static_cast<int>(pixel / 24)));
      const double difference = image.SurfaceRadiance[7 * pixel] - truth;
      sums[pixel] += difference;
      squares[pixel] += difference * difference;
    }
  }
  double chiSquared = 0.0;
  for (std::size_t pixel = 0; pixel < sums.size(); ++pixel)
  {
    const double error = std::sqrt(squares[pixel]);
    const double truth = stage.TruthAt(stage.PointOf(static_cast<int>(pixel % 24), static_cast<int>(pixel / 24)));
    if (!(error > 1e-3 * truth * std::sqrt(seeds)))
    {
      continue; // no noise, but that of single precision
    }
    const double z = sums[pixel] / error;
    EXPECT_LT(std::fabs(z), 4.5) << pixel;
    chiSquared += z * z;
  }
  EXPECT_LT(chiSquared, 48.0 + 4.0 * std::sqrt(2.0 * 48.0));
  EXPECT_GT(chiSquared, 5.0) << "there is noise to average";
}

TEST(SurfaceLight, AllBlockedIsBlackAndSaysThatItMayHaveMissedSomething)
{
  EdgeStage stage(8, 8);
  stage.View.HalfHeight = 0.1;
  stage.View.Position.X = 5.0;
  const OccluderScene occluders(stage.Mesh.View());
  const ScatteringImage image = stage.Render(occluders);
  for (std::size_t pixel = 0; pixel < image.Depth.size(); ++pixel)
  {
    EXPECT_EQ(image.SurfaceRadiance[7 * pixel], 0.0f);
    EXPECT_EQ(image.SurfaceRelativeError[pixel], 1.0f);
  }
  // Two looks and an estimate of as many samples as make 0.85 / n about the goal.
  EXPECT_LT(image.NumberOfOcclusionRays, 64 * 140);
}

TEST(SurfaceLight, AHardSunTakesOneRayAndHasNoError)
{
  Floor floor(SunLight({ 0.0, 0.6, -0.8 }, 0.0), 16, 16);
  floor.Mesh.AddSheet({ 0.03, -30.0, 1.0 }, { 30.0, 0.0, 0.0 }, { 0.0, 60.0, 0.0 }, 0);
  const OccluderScene occluders(floor.Mesh.View());
  const ScatteringImage image = floor.Render(occluders);
  EXPECT_EQ(image.NumberOfOcclusionRays, 256);
  for (int k = 0; k < 256; ++k)
  {
    const bool lit = floor.PointOf(k % 16, k / 16).X < 0.03;
    EXPECT_NEAR(image.SurfaceRadiance[7 * k], lit ? reflectance / Pi * 0.8 : 0.0, 1e-6);
    EXPECT_EQ(image.SurfaceRelativeError[k], 0.0f);
  }
}

TEST(SurfaceLight, AMeetingPointOfAnEdgeKeepsTheGoal)
{
  // Two surfaces share each pixel of a column: their errors together are what is wanted of the pixel.
  EdgeStage stage(25, 16);
  stage.View.HalfHeight = 0.25;
  stage.Options.NumberOfEdgeSamples = 4;
  stage.Mesh.AddSheet({ 0.0, -50.0, 0.01 }, { 50.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 }, -2);
  const OccluderScene occluders(stage.Mesh.View());
  const double largest = reflectance * FactorOfDisc(0.5, 20.0, 0.0);
  double squares = 0.0;
  const int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    stage.Options.Seed = static_cast<std::uint64_t>(seed);
    const ScatteringImage image = stage.Render(occluders);
    for (int j = 0; j < 16; ++j)
    {
      const std::size_t pixel = image.IndexOf(12, j);
      const double truth = stage.TruthAt(stage.PointOf(12, j));
      const double difference = image.SurfaceRadiance[7 * pixel] - truth;
      squares += difference * difference / (16.0 * seeds);
      EXPECT_LT(image.SurfaceRelativeError[pixel] * image.SurfaceRadiance[7 * pixel], 0.03 * largest);
    }
  }
  EXPECT_LT(std::sqrt(squares), 1.5 * 0.01 * largest);
}

TEST(SurfaceLight, NormalsMakeACoarseSphereRound)
{
  // Of a body with its corners on the unit sphere the interpolated normal at a point is the point itself.
  Floor ball(SunLight(Normalized({ -1.0, -0.3, -0.4 }), 0.0), 64, 64);
  ball.Mesh = {};
  ball.Mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 12, 0);
  ball.View.Position = { 0.0, 0.0, 5.0 };
  const OccluderScene occluders(ball.Mesh.View());
  const ScatteringImage facets = ball.Render(occluders);
  const TriangleMeshView view = ball.Mesh.View();
  for (const float sign : { 1.0f, -2.0f }) // turned inwards, and of another length, is the same
  {
    ball.Options.SurfaceNormals.clear();
    for (vtkIdType k = 0; k < 3 * view.NumberOfPoints; ++k)
    {
      ball.Options.SurfaceNormals.push_back(sign * static_cast<float>(view.Points[k]));
    }
    const ScatteringImage image = ball.Render(occluders);
    const double sun = reflectance / Pi;
    int beyondTheFacets = 0;
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        const std::size_t pixel = image.IndexOf(i, j);
        if (image.Depth[pixel] < 0.0f)
        {
          continue;
        }
        Vector3 point = ball.PointOf(i, j);
        point.Z = 5.0 - image.Depth[pixel];
        const double cosine = -Dot(Normalized(point), ball.Lamp.Normal);
        const double value = image.SurfaceRadiance[7 * pixel];
        if (cosine > 0.02)
        {
          // No facet is black that the round body has in the light.
          ASSERT_NEAR(value, sun * cosine, 2e-5) << i << ", " << j;
          beyondTheFacets += facets.SurfaceRadiance[7 * pixel] == 0.0f ? 1 : 0;
        }
        ASSERT_LE(value, sun * std::max(cosine, 0.0) + 2e-5) << i << ", " << j;
      }
    }
    EXPECT_GT(beyondTheFacets, 20) << "which the facets alone have dark";
  }
  ball.Options.SurfaceNormals.assign(static_cast<std::size_t>(3 * view.NumberOfPoints), 0.0f);
  EXPECT_EQ(ball.Render(occluders).SurfaceRadiance, facets.SurfaceRadiance) << "no length: none";
}
