// SPDX-License-Identifier: BSD-3-Clause
// The visibility grid behind a disc under a disc light: what its bricks are worth, and what is left of the error.
#include "ClosedForms.h"

#include "TestMeshes.h"
#include "scRandom.h"
#include "scVisibilityGrid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double R = 0.5;
constexpr double r = 0.6;
constexpr double L = 2.0;

/// Root mean square error at random points up to half a unit behind the disc, where its penumbra is narrow.
double ErrorBehindDisc(const Placement& place, VisibilityMethod method, int parts, int lightSamples)
{
  TestMesh disc;
  disc.AddDisc(place({ 0.0, 0.0, L }), r * place.Scale);
  const OccluderScene scene(disc.View());
  Light light;
  light.Center = place({});
  light.Radius = R * place.Scale;
  light.Spectrum = { 1.0 };
  EXPECT_EQ(PrepareLight(light), nullptr);
  Cone cone;
  cone.Center = place({ 0.0, 0.0, L });
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  cone.BaseRadius = r * place.Scale;
  cone.HalfAngle = closedforms::DiscPenumbraHalfAngle(R, r, L);

  VisibilityGridOptions options;
  options.Method = method;
  options.Dimensions = { 33, 33, 33 };
  options.NumberOfLightSamples = lightSamples;
  options.BrickParts = parts;
  VisibilityGrid grid;
  // The disc's plane lies between vertices.
  const Box bounds{ place({ -1.6, -1.6, 0.93 }), place({ 1.6, 1.6, 4.13 }) };
  EXPECT_TRUE(FillVisibilityGrid(
    { cone }, light, method == VisibilityMethod::Exact ? &scene : nullptr, bounds, options, {}, grid));
  constexpr int points = 10000;
  double sum = 0.0;
  for (int k = 0; k < points; ++k)
  {
    const auto u = SobolPoint(3, static_cast<std::uint32_t>(k));
    const double z = L + 0.05 + 0.5 * u[0];
    const double x = closedforms::DiscPenumbraRadius(R, r, L, z) * 1.1 * std::sqrt(u[1]);
    const double angle = 2.0 * closedforms::Pi * u[2];
    const double found = VisibilityAt(grid, place({ x * std::cos(angle), x * std::sin(angle), z }));
    const double truth = closedforms::DiscVisibility(R, r, L, z, x);
    sum += (found - truth) * (found - truth);
  }
  return std::sqrt(sum / points);
}
} // namespace

TEST(VisibilityGridForms, BricksCutTheErrorBehindADisc)
{
  for (const Placement& place : Placements())
  {
    for (const VisibilityMethod method : { VisibilityMethod::Exact, VisibilityMethod::Soft })
    {
      const double plain = ErrorBehindDisc(place, method, 1, 64);
      EXPECT_LT(ErrorBehindDisc(place, method, 2, 64), plain / 1.8) << place.Name;
      EXPECT_LT(ErrorBehindDisc(place, method, 4, 64), plain / 2.4) << place.Name;
    }
  }
}

TEST(VisibilityGridForms, SixteenSamplesDoNotSpoilThem)
{
  const Placement& place = Placements()[0];
  EXPECT_LT(ErrorBehindDisc(place, VisibilityMethod::Exact, 4, 16),
    ErrorBehindDisc(place, VisibilityMethod::Exact, 1, 16) / 1.8);
}
