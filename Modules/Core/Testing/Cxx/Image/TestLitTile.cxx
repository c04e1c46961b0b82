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
  pixel.Span = scene.Quadrature.Spans.Find(ray);
  pixel.Reference = pixel.Span.Begin;
  pixel.Values.assign(scene.Quadrature.Layout.Size(), 0.0f);
  if (!pixel.Span.Empty())
  {
    LitProfiler profiler(scene.Quadrature);
    profiler.Evaluate(ray, pixel.Span, pixel.Reference,
      { 4, 3 }, pixel.Values.data());
    const LitAngle angle(scene.Quadrature, ray, pixel.Span);
    for (std::size_t k = LitProfileLayout::Edges; k < pixel.Values.size(); ++k)
    {
      pixel.Values[k] *= static_cast<float>(angle.CellFactor());
    }
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
  EXPECT_EQ(first.Reference, again.Reference);
}
