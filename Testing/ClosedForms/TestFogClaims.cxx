// SPDX-License-Identifier: BSD-3-Clause
// What Guided says of its error in uneven fog, whose way to the lamp it reads from a table, against plain sums.
#include "PlainTruth.h"
#include "SampledDensity.h"
#include "scDensityGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Size = 64;
constexpr int FirstI = 20; ///< of the part that is rendered: in and beside the shadow
constexpr int FirstJ = 16;
constexpr int Side = 24;

/// Slats under a disc in a room of wisps.
struct FoggyScene : ImageTestScene
{
  DensityGrid Fogs = SampleDensity({ { 25, 25, 25 } }, { -2.0, 0.0, -2.0 },
    UnitAxes({ 4.0 / 24.0, 4.0 / 24.0, 4.0 / 24.0 }),
    [](const Vector3& p)
    {
      return std::max(
        1.0 + std::sin(2.5 * p.X + 1.0) * std::cos(2.0 * p.Y + p.Z) + 0.5 * std::sin(5.0 * p.Z - 3.0 * p.X), 0.0);
    });

  FoggyScene()
  {
    this->SetLight(LightShape::Disc, { 0.4, 3.6, -0.2 }, { 0.1, -1.0, 0.05 }, 0.4, { 1.0 });
    this->SetMedium({ 0.2 }, { 0.1 }, { -2.0, 0.0, -2.0 }, { 2.0, 4.0, 2.0 }); // the lamp in it
    this->Fog.Density = &this->Fogs;
    this->Eye = LookAt({ 0.5, 1.5, 7.0 }, { 0.0, 1.3, 0.0 }, 0.5);
    this->SetSize(Size, Size);
    this->Options.Extent = { FirstI, FirstI + Side - 1, FirstJ, FirstJ + Side - 1 };
    this->Options.MaximumSamples = 1 << 14;
    for (int k = 0; k < 9; ++k)
    {
      this->Mesh.AddSheet({ -1.2 + 0.27 * k, 1.9, -1.3 }, { 0.13, 0.06, 0.0 }, { 0.0, 0.1, 2.6 });
    }
  }
};
} // namespace

TEST(FogClaims, HoldInWisps)
{
  FoggyScene scene;
  const OccluderScene occluders(scene.Mesh.View());
  std::vector<PlainTruth> truths;
  std::vector<std::size_t> pixels;
  for (int k = 0; k < 36; ++k)
  {
    truths.push_back(PlainInScattering(scene, occluders, FirstI + 4 * (k % 6), FirstJ + 4 * (k / 6), 1 << 12, 5));
    pixels.push_back(static_cast<std::size_t>(4 * (k / 6) * Side + 4 * (k % 6)));
  }
  for (const double goal : { 0.02, 0.01 })
  {
    scene.Options.RelativeErrorGoal = goal;
    const ScatteringImage image = scene.Render(ScatteringMode::Guided, nullptr, nullptr);
    const ClaimsHeld held = JudgeClaims(image, pixels, truths);
    EXPECT_GE(held.WithinTwo, 34) << "goal " << goal;
    EXPECT_LE(std::fabs(held.Mean), 0.35) << "goal " << goal << ": too bright or too dark";
    EXPECT_LE(held.Root, 1.25) << "goal " << goal; // standard errors that are right give 1 +- 0.12
  }
}
