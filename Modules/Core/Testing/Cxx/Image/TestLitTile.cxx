// SPDX-License-Identifier: BSD-3-Clause
#include "LitScene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;

namespace
{
constexpr int size = 64;

/// Sixteen panels and 256 light points, for one ray.
LitPixel FinePixel(const LitScene& scene, int i, int j)
{
  const Ray ray = scene.Eye.PixelRay(i, j, size, size);
  LitPixel pixel;
  pixel.Line = ray;
  pixel.Span = scene.Quadrature.Spans.Find(ray);
  pixel.Edges.fill(0.0);
  pixel.Values.assign(scene.Quadrature.Layout.Size(), 0.0f);
  if (!pixel.Span.Empty())
  {
    LitProfiler profiler(scene.Quadrature);
    profiler.Evaluate(ray, pixel.Span, { 4, 3 }, pixel.Values.data());
    FinishPixel(scene.Quadrature, pixel);
  }
  return pixel;
}
} // namespace

TEST(LitTile, AgreesWithAFineRuleAtEveryDistance)
{
  constexpr double tolerance = 2e-3;
  for (const Light& light :
    { smallmeshes::PointLight({ 1.0, 1.6, 0.2 }), smallmeshes::DiscLight({ 2.0, 1.5, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5),
      smallmeshes::SphereLight({ 1.0, 2.0, 0.0 }, 0.4), smallmeshes::SunLight({ 0.3, -1.0, 0.2 }, 0.01) })
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
        ASSERT_EQ(pixel.Span.Empty(), fine.Span.Empty());
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
  const LitScene scene(smallmeshes::PointLight({ 1.0, 1.6, 0.2 }));
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
  const LitScene scene(smallmeshes::PointLight({ 1.0, 1.6, 0.2 }));
  const LitPixel pixel = scene.PixelOf(0, 16, size / 2);
  EXPECT_TRUE(pixel.Span.Empty());
  EXPECT_EQ(SumOfCells(pixel), 0.0);
}

TEST(LitTile, NothingIsLitBehindTheLight)
{
  const LitScene scene(smallmeshes::DiscLight({ 2.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.5));
  const LitPixel pixel = scene.PixelOf(15, 16, size / 2);
  EXPECT_NEAR(pixel.Span.Begin, 3.0, 1e-9) << "at the light's plane";
  EXPECT_NEAR(pixel.Span.MediumBegin, 1.0, 1e-9);
  EXPECT_GT(SumOfCells(pixel), 0.0);
}

TEST(LitTile, DoesNotRememberWhereItWas)
{
  const LitScene scene(smallmeshes::DiscLight({ 2.0, 1.5, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5));
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
  // A rectangle 2 x 2, 0.4 above rays that are all but parallel to it: nothing is smooth where they begin to pass below.
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = { 0.0, 4.0, 0.0 };
  light.Normal = { 0.0, -1.0, 0.0 };
  light.AxisU = { 1.0, 0.0, 0.0 };
  light.AxisV = { 0.0, 0.0, 1.0 };
  light.Spectrum = { 1.0 };
  ASSERT_EQ(PrepareLight(light), nullptr);
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
      profiler.Evaluate(pixel.Line, pixel.Span, { 3, 2 }, fine.Values.data());
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
