// SPDX-License-Identifier: BSD-3-Clause
#include "LitScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int size = 64;

/// Sixteen panels and 256 light points, for one ray.
LitPixel FinePixel(const LitScene& scene, int i, int j)
{
  const Ray ray = scene.Eye.PixelRay(i, j, size, size);
  LitPixel pixel;
  pixel.Line = ray;
  pixel.Interval = scene.Quadrature.Intervals.Find(ray);
  pixel.Edges.fill(0.0);
  pixel.Values.assign(scene.Quadrature.Layout.Size(), 0.0f);
  if (!pixel.Interval.Empty())
  {
    LitProfiler profiler(scene.Quadrature);
    profiler.Evaluate(ray, pixel.Interval, { 4, 3 }, pixel.Values.data());
    FinishPixel(scene.Quadrature, pixel);
  }
  return pixel;
}

/// A square of side 2, or a disc of radius 1, at height 4 that faces down.
Light WideLamp(LightShape shape)
{
  Light light;
  light.Shape = shape;
  light.Center = { 0.0, 4.0, 0.0 };
  light.Normal = { 0.0, -1.0, 0.0 };
  light.AxisU = { 1.0, 0.0, 0.0 };
  light.AxisV = { 0.0, 0.0, 1.0 };
  light.Radius = 1.0;
  return testsupport::Prepared(light);
}

/// Of the wide lamp. The square: four rectangles with a corner above the point, each by its closed form. The disc: an
/// integral over the angle around the place above the point.
double WideLampSolidAngle(LightShape shape, const Vector3& from)
{
  const double h = 4.0 - from.Y;
  if (h <= 0.0)
  {
    return 0.0;
  }
  if (shape == LightShape::Rectangle)
  {
    const auto quarter = [h](double a, double b) { return std::atan(a * b / (h * std::sqrt(a * a + b * b + h * h))); };
    return quarter(1.0 - from.X, 1.0 - from.Z) + quarter(1.0 + from.X, 1.0 - from.Z) +
      quarter(1.0 - from.X, 1.0 + from.Z) + quarter(1.0 + from.X, 1.0 + from.Z);
  }
  const double offset = std::hypot(from.X, from.Z);
  constexpr int count = 160;
  double sum = 0.0;
  for (int k = 0; k < count; ++k)
  {
    // Beside the disc angles end where the rim is touched: their sines are even there in another angle's.
    const double turn = Pi * ((k + 0.5) / count - 0.5);
    const bool inside = offset < 1.0;
    const double sine = inside ? std::sin(2.0 * turn) : std::sin(turn) / offset;
    const double cosine = inside ? std::cos(2.0 * turn) : std::sqrt(1.0 - sine * sine);
    const double half = std::sqrt(std::max(1.0 - offset * offset * sine * sine, 0.0));
    const double nearest = inside ? 0.0 : offset * cosine - half;
    const double farthest = offset * cosine + half;
    const double step = inside ? 2.0 : std::cos(turn) / (offset * cosine);
    sum += step * (h / std::hypot(h, nearest) - h / std::hypot(h, farthest));
  }
  return Pi / count * sum;
}
} // namespace

TEST(LitTile, AgreesWithAFineRuleAtEveryDistance)
{
  constexpr double tolerance = 2e-3;
  for (const Light& light : { PointLight({ 1.0, 1.6, 0.2 }), DiscLight({ 2.0, 1.5, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5),
         SphereLight({ 1.0, 2.0, 0.0 }, 0.4), SunLight({ 0.3, -1.0, 0.2 }, 0.01) })
  {
    const LitScene scene(light, 0.2, 0.1);
    LitTile tile = scene.TileOf(size, tolerance);
    LitPixel pixel;
    double worst = 0.0;
    double shift = 0.0;
    for (const int first : { 0, LitTile::Side })
    {
      tile.MoveTo(first, 0);
      for (int k = 0; k < 48; ++k)
      {
        const int i = first + 7 * k % LitTile::Side;
        const int j = 11 * k % LitTile::Side;
        tile.Interpolate(i, j, pixel);
        const LitPixel fine = FinePixel(scene, i, j);
        ASSERT_EQ(pixel.Interval.Empty(), fine.Interval.Empty());
        const double all = SumOfCells(fine);
        for (int cells = 0; cells <= LitProfileLayout::Cells && all > 0.0; cells += 8)
        {
          // Edges are interpolated too.
          shift = std::max(shift, std::fabs(pixel.EdgeAt(cells) - fine.EdgeAt(cells)));
          worst = std::max(worst, std::fabs(SumOfCells(pixel, cells) - SumOfCells(fine, cells)) / all);
        }
      }
    }
    EXPECT_LT(shift, tolerance * 4.0) << "of the ray's length, shape " << static_cast<int>(light.Shape);
    // Rays that are not checked err more than those that are, but no more than the image promises.
    EXPECT_LT(worst, 0.005) << "shape " << static_cast<int>(light.Shape);
    EXPECT_LT(tile.NumberOfRays(), LitTile::Side * LitTile::Side) << "two squares cost less than one without it";
  }
}

TEST(LitTile, EdgesAscendFromEntryToExit)
{
  const LitScene scene(PointLight({ 1.0, 1.6, 0.2 }));
  const LitPixel pixel = scene.PixelOf(15, 16, size / 2);
  EXPECT_NEAR(pixel.EdgeAt(0), 1.0, 1e-6);
  EXPECT_NEAR(pixel.EdgeAt(LitProfileLayout::Cells), 5.0, 1e-6);
  for (int k = 0; k < LitProfileLayout::Cells; ++k)
  {
    EXPECT_LT(pixel.EdgeAt(k), pixel.EdgeAt(k + 1));
  }
}

TEST(LitTile, ARayBesideTheMediumHasNothing)
{
  const LitScene scene(PointLight({ 1.0, 1.6, 0.2 }));
  const LitPixel pixel = scene.PixelOf(0, 16, size / 2);
  EXPECT_TRUE(pixel.Interval.Empty());
  EXPECT_EQ(SumOfCells(pixel), 0.0);
}

TEST(LitTile, NothingIsLitBehindTheLight)
{
  const LitScene scene(DiscLight({ 2.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.5));
  const LitPixel pixel = scene.PixelOf(15, 16, size / 2);
  EXPECT_NEAR(pixel.Interval.Begin, 3.0, 1e-9) << "at the light's plane";
  EXPECT_NEAR(pixel.Interval.MediumBegin, 1.0, 1e-9);
  EXPECT_GT(SumOfCells(pixel), 0.0);
}

TEST(LitTile, DoesNotRememberWhereItWas)
{
  const LitScene scene(DiscLight({ 2.0, 1.5, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5));
  LitTile tile = scene.TileOf(size, 2e-3);
  LitPixel first;
  tile.MoveTo(0, 0);
  tile.Interpolate(20, 17, first);
  LitPixel other;
  tile.MoveTo(32, 32);
  tile.Interpolate(40, 40, other);
  LitPixel again;
  tile.MoveTo(0, 0);
  tile.Interpolate(3, 17, again);
  tile.Interpolate(20, 17, again);
  EXPECT_EQ(first.Values, again.Values);
  EXPECT_EQ(first.Edges, again.Edges);
}

TEST(LitTile, RaysCloseBelowAWideLampAreAsGoodAsTheySay)
{
  // A rectangle 2 x 2, 0.4 above rays that are all but parallel to it: nothing is smooth where they begin to pass
  // below.
  const Light light = WideLamp(LightShape::Rectangle);
  LitScene scene(light, 0.5);
  scene.Fog.Bounds.Min = { -3.0, -3.0, -3.0 };
  scene.Fog.Bounds.Max = { 3.0, 4.5, 3.0 };
  const LitQuadrature quadrature(light, scene.Fog, scene.Groups);
  scene.Eye.Position = { -6.0, 3.6, 0.011 };
  scene.Eye.Parallel = false;
  scene.Eye.HalfHeight = std::tan(5.0 * 3.14159265358979323846 / 180.0);
  LitTile tile(quadrature, scene.Eye, 32, 32, 1e-3, { 0.0 });
  tile.MoveTo(0, 0);
  LitProfiler profiler(quadrature);
  int pixels = 0;
  int held = 0;
  for (int j = 9; j < 24; j += 2)
  {
    for (int i = 8; i < 24; i += 2)
    {
      LitPixel pixel;
      tile.Interpolate(i, j, pixel);
      LitPixel fine = pixel;
      profiler.Evaluate(pixel.Line, pixel.Interval, { 3, 2 }, fine.Values.data());
      FinishPixel(quadrature, fine);
      const double error = std::fabs(SumOfCells(pixel) / SumOfCells(fine) - 1.0);
      pixels += 1;
      held += error <= pixel.Tolerance;
      EXPECT_LE(error, 3.0 * pixel.Tolerance) << i << ", " << j;
      EXPECT_LT(pixel.Tolerance, 0.03);
    }
  }
  EXPECT_GE(held, 0.95 * pixels);
}

TEST(LitTile, RaysCloseBelowAWideLampHaveItsSolidAngle)
{
  // In thin medium, where the light of a ray is the integral of the solid angle along it, over 4 pi.
  for (const LightShape shape : { LightShape::Rectangle, LightShape::Disc })
  {
    const Light light = WideLamp(shape);
    LitScene scene(light, 1e-9);
    scene.Fog.Bounds.Min = { -3.0, -3.0, -3.0 };
    scene.Fog.Bounds.Max = { 3.0, 4.5, 3.0 };
    const LitQuadrature quadrature(light, scene.Fog, scene.Groups);
    scene.Eye.Parallel = false;
    scene.Eye.HalfHeight = std::tan(0.1 * Pi / 180.0);
    for (const double below : { 0.4, 0.1, 0.02 })
    {
      scene.Eye.Position = { -6.0, 4.0 - below, 0.011 };
      LitTile tile(quadrature, scene.Eye, 32, 32, 1e-3, { 0.0 });
      tile.MoveTo(0, 0);
      double worst = 0.0;
      for (int j = 9; j < 24; j += 3)
      {
        for (int i = 8; i < 24; i += 5)
        {
          LitPixel pixel;
          tile.Interpolate(i, j, pixel);
          constexpr int steps = 800;
          double expected = 0.0;
          const double length = pixel.Interval.End - pixel.Interval.Begin;
          for (int k = 0; k < steps; ++k)
          {
            const double t = pixel.Interval.Begin + (k + 0.5) / steps * length;
            expected += WideLampSolidAngle(shape, pixel.Line.Origin + t * pixel.Line.Direction);
          }
          expected *= length / steps / (4.0 * Pi);
          const double error = std::fabs(SumOfCells(pixel) / expected - 1.0);
          EXPECT_LE(error, 2.0 * pixel.Tolerance) << static_cast<int>(shape) << ", " << below << ": " << i << ", " << j;
          worst = std::max(worst, error);
        }
      }
      EXPECT_LT(worst, 1e-3) << static_cast<int>(shape) << ", " << below;
    }
  }
}
