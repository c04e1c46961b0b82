// SPDX-License-Identifier: BSD-3-Clause
// A closed room with a slit: a beam that can be written down, and black air beside it.
#include "ClosedForms.h"
#include "Scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr int Size = 40;
constexpr double Low = 0.105; ///< of the slit along x: its edges lie midway between points of the grid and its bricks
constexpr double High = 0.165;

/// Walls a little outside of the air; the sun stands on the ceiling, which has a slit of half the room's depth.
ImageTestScene Room(bool slit)
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Sun, {}, { 0.0, -1.0, 0.0 }, 0.0, { 2.0 });
  scene.SetMedium({ 0.3 }, { 0.1 }, { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  const double w = 1.01;
  const auto ceiling = [&scene](double x0, double x1, double z0, double z1) {
    scene.Mesh.AddSheet({ x0, 1.01, z0 }, { x1 - x0, 0.0, 0.0 }, { 0.0, 0.0, z1 - z0 });
  };
  ceiling(-w, Low, -w, w);
  ceiling(High, w, -w, w);
  ceiling(Low, High, -w, -0.5);
  ceiling(Low, High, 0.5, w);
  if (!slit)
  {
    ceiling(Low, High, -0.5, 0.5);
  }
  scene.Mesh.AddSheet({ -w, -w, -w }, { 2.0 * w, 0.0, 0.0 }, { 0.0, 0.0, 2.0 * w });
  for (const double side : { -w, w })
  {
    scene.Mesh.AddSheet({ side, -w, -w }, { 0.0, 2.02, 0.0 }, { 0.0, 0.0, 2.0 * w });
    scene.Mesh.AddSheet({ -w, -w, side }, { 0.0, 2.02, 0.0 }, { 2.0 * w, 0.0, 0.0 });
  }
  Cone everywhere;
  everywhere.Center = { 0.0, 1.01, 0.0 };
  everywhere.Axis = { 0.0, -1.0, 0.0 };
  everywhere.Normal = everywhere.Axis;
  everywhere.BaseRadius = 3.0;
  scene.Bounds.push_back(everywhere);
  scene.Eye = LookAt({ -0.9, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, 0.9, true);
  scene.SetSize(Size, Size);
  scene.Options.RelativeErrorGoal = 0.03;
  scene.GridOptions.Dimensions = { 101, 5, 41 };
  return scene;
}

/// What is seen from x = -0.9 along x at the height y.
double Beam(const ImageTestScene& scene, double y)
{
  const double sigmaT = scene.Fog.SigmaS[0] + scene.Fog.SigmaA[0];
  return scene.Fog.SigmaS[0] * scene.Source.Spectrum[0] / (4.0 * closedforms::Pi * sigmaT) *
    std::exp(-sigmaT * (1.0 - y)) * (std::exp(-sigmaT * (Low + 0.9)) - std::exp(-sigmaT * (High + 0.9)));
}
} // namespace

TEST(DarkRooms, AClosedRoomIsBlack)
{
  const ImageTestScene scene = Room(false);
  for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume })
  {
    const ScatteringImage image = scene.Render(mode);
    EXPECT_EQ(std::count(image.InScattering.begin(), image.InScattering.end(), 0.0f), Size * Size) << NameOf(mode);
  }
}

TEST(DarkRooms, ABeamThroughASlit)
{
  const ImageTestScene scene = Room(true);
  for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume })
  {
    const ScatteringImage image = scene.Render(mode);
    int held = 0;
    int lit = 0;
    double sum = 0.0;
    double squares = 0.0;
    for (int pixel = 0; pixel < Size * Size; ++pixel)
    {
      const Vector3 origin = scene.PixelRay(pixel % Size, pixel / Size).Origin;
      const auto index = static_cast<std::size_t>(pixel);
      const double value = image.InScattering[index];
      if (std::fabs(origin.Z) > 0.55)
      {
        EXPECT_EQ(value, 0.0) << NameOf(mode) << ": the air beside the beam is black";
      }
      if (std::fabs(origin.Z) < 0.45)
      {
        const double expected = Beam(scene, origin.Y);
        const double difference = value / expected - 1.0;
        EXPECT_LT(std::fabs(difference), mode == ScatteringMode::Guided ? 0.25 : 0.15) << NameOf(mode) << ": a speck";
        if (mode == ScatteringMode::Guided)
        {
          ++lit;
          held += std::fabs(value - expected) <= 2.0 * value * image.RelativeError[index];
          EXPECT_LE(image.RelativeError[index], 0.0451f);
          sum += difference;
          squares += difference * difference;
        }
      }
    }
    if (mode == ScatteringMode::Guided)
    {
      EXPECT_GT(lit, 500);
      EXPECT_GE(held, 0.95 * lit);
      EXPECT_LE(std::fabs(sum), 3.0 * std::sqrt(squares)) << "of " << lit << " pixels: too bright or too dark";
    }
  }
}
