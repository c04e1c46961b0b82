// SPDX-License-Identifier: BSD-3-Clause
// Images of inhomogeneous media against what can be written down: closed form 6 with a density, and media in boxes.
#include "ClosedForms.h"
#include "SampledDensity.h"
#include "Scenes.h"
#include "TestMeshes.h"
#include "scCone.h"
#include "scConeHierarchy.h"
#include "scDensityGrid.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scVisibilityGrid.h"

#include "scFrame.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Tolerance = 0.005;
constexpr double Irradiance = 5.0;
const std::vector<double> SigmaS = { 0.5, 0.2 };
const std::vector<double> SigmaA = { 0.1, 1.0 };

/// A density that varies along x alone, over [0, length].
DensityGrid SampleAlongX(int points, double length, const std::function<double(double)>& density)
{
  return SampleDensity({ { points, 1, 1 } }, {}, UnitAxes({ length / (points - 1), 1.0, 1.0 }),
    [&](const Vector3& p) { return density(p.X); });
}

/// The slab of closed form 6, [0, length] x [0, 1] x [-1, 1], below a sun at the zenith.
struct Slab
{
  Light Sun;
  Medium Fog;
  TestMesh Mesh;
  ScatteringOptions Options;

  explicit Slab(double length, const DensityGrid* density)
  {
    this->Sun.Shape = LightShape::Sun;
    this->Sun.Spectrum = { Irradiance, Irradiance };
    this->Sun.Normal = { 0.0, -1.0, 0.0 };
    this->Sun.Radius = 0.0;
    EXPECT_EQ(PrepareLight(this->Sun), nullptr);
    this->Fog.SigmaS = SigmaS;
    this->Fog.SigmaA = SigmaA;
    this->Fog.Bounds.Min = { 0.0, 0.0, -1.0 };
    this->Fog.Bounds.Max = { length, 1.0, 1.0 };
    this->Fog.Density = density;
    this->Options.NumberOfSteps = 64;
    this->Options.MaximumHalvings = 6;
    this->Options.IntensityThreshold = 0.02;
    this->Options.NumberOfLightSamples = 1;
    this->Options.NumberOfSurfaceLightSamples = 0;
    this->Options.RelativeErrorGoal = 1e-3;
    this->Options.MaximumSamples = 1 << 16;
  }
  /// Darkness in [a, b] of x.
  void Shadow(double a, double b) { this->Mesh.AddSheet({ a, 2.0, -2.0 }, { b - a, 0.0, 0.0 }, { 0.0, 0.0, 4.0 }); }

  /// One pixel: what a ray sees.
  ScatteringImage Look(ScatteringMode mode, const Vector3& from, const Vector3& to)
  {
    if (this->Mesh.Points.empty())
    {
      this->Mesh.AddSheet({ 200.0, 200.0, 200.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.1, 0.0 });
    }
    const OccluderScene scene(this->Mesh.View());
    const Camera camera = LookAt(from, to, 1e-6, true);
    this->Options.Mode = mode;
    this->Options.Width = 1;
    this->Options.Height = 1;
    this->Options.Extent = { 0, 0, 0, 0 };
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering({ scene, this->Sun, this->Fog, camera }, this->Options, Monitor(), image));
    return image;
  }
};

/// In-scattered radiance of a horizontal ray through a slab in which the density depends on x alone.
double LayeredRadiance(int wavelength, double y, double length, const std::function<double(double)>& density,
  const std::function<double(double)>& depth)
{
  const double sigmaT = SigmaS[wavelength] + SigmaA[wavelength];
  return SigmaS[wavelength] * Irradiance / (4.0 * closedforms::Pi) *
    closedforms::Integrate(
      [&](double x) { return density(x) * std::exp(-sigmaT * (density(x) * (1.0 - y) + depth(x))); }, 0.0, length);
}

/// A lamp, a tilted plate and a floor: every term of an image is there.
struct Room
{
  Light Lamp;
  Medium Fog;
  TestMesh Mesh;
  Camera View = LookAt({ 0.0, 0.3, 7.0 }, { 0.0, 0.0, 0.0 }, 0.35);
  ScatteringOptions Options;

  Room()
  {
    this->Lamp.Shape = LightShape::Disc;
    this->Lamp.Spectrum = { 1.0, 2.0 };
    this->Lamp.Center = { 0.0, 2.0, 0.0 };
    this->Lamp.Normal = { 0.0, -1.0, 0.0 };
    this->Lamp.Radius = 0.4;
    EXPECT_EQ(PrepareLight(this->Lamp), nullptr);
    this->Fog.SigmaS = { 0.2, 0.1 };
    this->Fog.SigmaA = { 0.05, 0.0 };
    this->Fog.Bounds.Min = { -2.0, -2.0, -2.0 };
    this->Fog.Bounds.Max = { 2.0, 1.9, 2.0 };
    this->Mesh.AddSheet({ -0.7, 0.1, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 });
    this->Mesh.AddSheet({ -2.0, -1.9, -2.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
    this->Options.NumberOfEdgeSamples = 1;
    this->Options.Width = 12;
    this->Options.Height = 12;
    this->Options.Extent = { 0, 11, 0, 11 };
  }
  ScatteringImage Render(ScatteringMode mode) const
  {
    const OccluderScene scene(this->Mesh.View());
    // One wide cone below the plate: enough for every mode to have something to do.
    Cone cone;
    cone.Center = { -0.1, 0.3, 0.05 };
    cone.Axis = { 0.0, -1.0, 0.0 };
    cone.Normal = cone.Axis;
    cone.BaseRadius = 0.9;
    cone.HalfAngle = 0.3;
    const ConeHierarchy cones({ cone }, this->Fog.Bounds);
    ScatteringOptions options = this->Options;
    options.Mode = mode;
    VisibilityGridOptions filling;
    filling.Method = mode == ScatteringMode::Soft ? VisibilityMethod::Soft : VisibilityMethod::Exact;
    filling.Dimensions = { 9, 9, 9 };
    VisibilityGrid grid;
    if (mode == ScatteringMode::Soft || mode == ScatteringMode::Volume)
    {
      EXPECT_TRUE(FillVisibilityGrid({ cone }, this->Lamp, mode == ScatteringMode::Soft ? nullptr : &scene,
        this->Fog.Bounds, filling, Monitor(), grid));
    }
    ScatteringImage image;
    EXPECT_TRUE(
      RenderScattering({ scene, this->Lamp, this->Fog, this->View, &cones, &grid }, options, Monitor(), image));
    return image;
  }
};

/// Largest difference of two arrays, relative to the largest value.
double LargestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double difference = 0.0;
  double largest = 0.0;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    difference = std::max(difference, std::fabs(static_cast<double>(a[k]) - b[k]));
    largest = std::max(largest, std::fabs(static_cast<double>(b[k])));
  }
  EXPECT_GT(largest, 0.0);
  return difference / largest;
}

constexpr ScatteringMode Modes[] = { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast,
  ScatteringMode::Guided, ScatteringMode::Soft, ScatteringMode::Volume };
/// The two ways to the truth: marching, and unshadowed minus blocked light.
constexpr ScatteringMode Ways[] = { ScatteringMode::BruteForce, ScatteringMode::Guided };
} // namespace

TEST(DensityForms, AConstantImageIsTheHomogeneousMedium)
{
  const double density = 0.7;
  const DensityGrid grid = SampleDensity(
    { { 5, 6, 7 } }, { -2.5, -2.5, -2.5 }, UnitAxes({ 1.25, 1.0, 1.0 }),
    [density](const Vector3& p) { return density * (1.0 + 1e-6 * p.X); }); // one that is constant would be left out
  for (const ScatteringMode mode : Modes)
  {
    Room room;
    room.Options.RelativeErrorGoal = 0.0; // so that both take the same number of samples
    room.Options.MaximumSamples = 63; // fewer than lines are taken for
    room.Fog.Density = &grid;
    const ScatteringImage dense = room.Render(mode);
    room.Fog.Density = nullptr;
    for (int k = 0; k < 2; ++k)
    {
      room.Fog.SigmaS[k] *= density;
      room.Fog.SigmaA[k] *= density;
    }
    const ScatteringImage plain = room.Render(mode);
    // Marches take the same steps; the faster modes integrate the two media by different rules, each to 1e-3 or better.
    const bool marches = mode < ScatteringMode::Guided;
    const double bound = marches ? 1e-4 : 5e-4;
    EXPECT_LT(LargestDifference(dense.InScattering, plain.InScattering), bound) << "mode " << static_cast<int>(mode);
    EXPECT_LT(LargestDifference(dense.SurfaceRadiance, plain.SurfaceRadiance), 1e-4);
    EXPECT_LT(LargestDifference(dense.Transmittance, plain.Transmittance), 1e-4);
    EXPECT_LT(LargestDifference(dense.Radiance, plain.Radiance), bound);
    EXPECT_LT(LargestDifference(dense.RelativeError, plain.RelativeError), 1e-3);
    EXPECT_EQ(dense.Depth, plain.Depth);
    if (mode != ScatteringMode::Guided)
    {
      EXPECT_EQ(dense.SampleCount, plain.SampleCount);
      EXPECT_EQ(dense.NumberOfOcclusionRays, plain.NumberOfOcclusionRays);
    }
  }
}

TEST(DensityForms, AConstantImageCostsNothing)
{
  // The very bytes of the homogeneous medium: a half and a quarter are exact.
  const DensityGrid grid = SampleDensity(
    { { 5, 6, 7 } }, { -2.5, -2.5, -2.5 }, UnitAxes({ 1.25, 1.0, 1.0 }), [](const Vector3&) { return 0.25; });
  for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Guided })
  {
    Room room;
    room.Fog.Density = &grid;
    const ScatteringImage dense = room.Render(mode);
    room.Fog.Density = nullptr;
    for (int k = 0; k < 2; ++k)
    {
      room.Fog.SigmaS[k] *= 0.25;
      room.Fog.SigmaA[k] *= 0.25;
    }
    const ScatteringImage plain = room.Render(mode);
    EXPECT_EQ(dense.InScattering, plain.InScattering) << NameOf(mode);
    EXPECT_EQ(dense.Radiance, plain.Radiance) << NameOf(mode);
  }
  // Of a grid that ends inside of the bounds the density is not the same everywhere.
  double value = 0.0;
  EXPECT_TRUE(IsConstantIn(grid, { { -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } }, value));
  EXPECT_EQ(value, 0.25);
  EXPECT_FALSE(IsConstantIn(grid, { { -2.6, -2.0, -2.0 }, { 2.0, 2.0, 2.0 } }, value));
}

TEST(DensityForms, ExponentialAtmosphere)
{
  // Density exp(-y / H). With q = exp(-y / H) along a ray, density dt = -(H / dy) dq, and all depths are linear in q.
  const double H = 0.3;
  const double length = 4.0;
  const auto q = [H](double y) { return std::exp(-y / H); };
  const DensityGrid grid =
    SampleDensity({ { 1, 65, 1 } }, {}, UnitAxes({ 1.0, 1.0 / 64.0, 1.0 }), [&q](const Vector3& p) { return q(p.Y); });
  const std::vector<std::pair<double, double>> shadowed = { { 0.5, 1.2 }, { 2.0, 3.3 } };
  Slab slab(length, &grid);
  for (const auto& part : shadowed)
  {
    slab.Shadow(part.first, part.second);
  }
  for (const double y : { 0.05, 0.3, 0.77 })
  {
    for (const ScatteringMode mode : Ways)
    {
      const ScatteringImage image = slab.Look(mode, { -1.0, y, 0.0 }, { 1.0, y, 0.0 });
      for (int k = 0; k < 2; ++k)
      {
        const double sigmaT = (SigmaS[k] + SigmaA[k]) * q(y);
        const double sun = std::exp(-(SigmaS[k] + SigmaA[k]) * H * (q(y) - q(1.0)));
        // At y = 1 of the homogeneous form nothing is lost above: the sun's own leg comes here.
        const double expected =
          sun * closedforms::SlabRadiance(SigmaS[k] * q(y), sigmaT, Irradiance, 1.0, length, shadowed);
        EXPECT_NEAR(image.InScattering[k] / expected, 1.0, Tolerance)
          << "mode " << static_cast<int>(mode) << ", y " << y << ", wavelength " << k;
        EXPECT_NEAR(image.Transmittance[k] / std::exp(-sigmaT * length), 1.0, Tolerance);
      }
    }
  }

  Slab open(length, &grid);
  for (const auto& heights : { std::make_pair(0.1, 0.9), std::make_pair(0.95, 0.02) })
  {
    const Vector3 from{ 0.0, heights.first, 0.0 };
    const Vector3 to{ length, heights.second, 0.0 };
    const double rise = (heights.second - heights.first) / Length(to - from);
    for (const ScatteringMode mode : Ways)
    {
      const ScatteringImage image = open.Look(mode, from - 0.1 * (to - from), to);
      for (int k = 0; k < 2; ++k)
      {
        const double sigmaT = SigmaS[k] + SigmaA[k];
        const double q0 = q(heights.first);
        const double qe = q(heights.second);
        // Depth of both legs: H [q (1 - 1 / rise) - q(1) + q0 / rise].
        const double slope = sigmaT * H * (1.0 - 1.0 / rise);
        const double scale = std::exp(-sigmaT * H * (q0 / rise - q(1.0)));
        const double expected = SigmaS[k] * Irradiance / (4.0 * closedforms::Pi) * H / rise * scale *
          (std::exp(-slope * qe) - std::exp(-slope * q0)) / slope;
        EXPECT_NEAR(image.InScattering[k] / expected, 1.0, Tolerance)
          << "mode " << static_cast<int>(mode) << ", to " << heights.second << ", wavelength " << k;
        EXPECT_NEAR(image.Transmittance[k] / std::exp(-sigmaT * H / rise * (q0 - qe)), 1.0, Tolerance);
      }
    }
  }
}

TEST(DensityForms, RampInAnyOrientation)
{
  // A linear density is the same function on any grid: one along x, one turned in space, one far finer than needed.
  const double length = 4.0;
  const auto density = [](double x) { return 0.25 + 0.5 * x; };
  const auto depth = [](double x) { return 0.25 * x + 0.25 * x * x; };
  const DensityGrid straight = SampleAlongX(2, length, density);
  const Vector3 axis = Normalized({ 1.0, 2.0, -2.0 });
  const Frame frame = FrameAround(axis);
  const Vector3 middle{ 2.0, 0.5, 0.0 };
  // Negative values lie outside the bounds only.
  const auto linear = [&density](const Vector3& p) { return std::max(density(p.X), 0.0); };
  const DensityGrid turned = SampleDensity({ { 41, 61, 81 } }, middle - 5.0 * (frame.U + frame.V + axis),
    { { 0.25 * frame.U, 10.0 / 60.0 * frame.V, 0.125 * axis } }, linear);
  const DensityGrid mirrored =
    SampleDensity({ { 9, 2, 1 } }, { length, 1.0, 0.0 }, UnitAxes({ -0.5, -1.0, 1.0 }), linear);
  for (const DensityGrid* grid : { &straight, &turned, &mirrored })
  {
    Slab slab(length, grid);
    const double y = 0.4;
    for (const ScatteringMode mode : Ways)
    {
      const ScatteringImage image = slab.Look(mode, { -1.0, y, 0.0 }, { 1.0, y, 0.0 });
      for (int k = 0; k < 2; ++k)
      {
        const double expected = LayeredRadiance(k, y, length, density, depth);
        EXPECT_NEAR(image.InScattering[k] / expected, 1.0, 1e-3)
          << "mode " << static_cast<int>(mode) << ", wavelength " << k;
        EXPECT_NEAR(image.Transmittance[k] / std::exp(-(SigmaS[k] + SigmaA[k]) * depth(length)), 1.0, 1e-4);
      }
    }
  }
}

TEST(DensityForms, AStepIsTwoBoxes)
{
  const double thin = 0.4;
  const double thick = 1.5;
  const DensityGrid grid = SampleAlongX(
    1601, 4.0, [&](double x) { return std::fabs(x - 2.0) < 1e-6 ? 0.5 * (thin + thick) : (x < 2.0 ? thin : thick); });
  Slab slab(4.0, &grid);
  slab.Shadow(1.0, 1.5);
  slab.Shadow(2.5, 2.75);
  const double y = 0.3;
  for (const ScatteringMode mode : Ways)
  {
    const ScatteringImage image = slab.Look(mode, { -1.0, y, 0.0 }, { 1.0, y, 0.0 });
    for (int k = 0; k < 2; ++k)
    {
      const double sigmaT = SigmaS[k] + SigmaA[k];
      const double expected =
        closedforms::SlabRadiance(thin * SigmaS[k], thin * sigmaT, Irradiance, y, 2.0, { { 1.0, 1.5 } }) +
        std::exp(-2.0 * thin * sigmaT) *
          closedforms::SlabRadiance(thick * SigmaS[k], thick * sigmaT, Irradiance, y, 2.0, { { 0.5, 0.75 } });
      EXPECT_NEAR(image.InScattering[k] / expected, 1.0, Tolerance)
        << "mode " << static_cast<int>(mode) << ", wavelength " << k;
      EXPECT_NEAR(image.Transmittance[k] / std::exp(-sigmaT * 2.0 * (thin + thick)), 1.0, 1e-3);
    }
  }
}

TEST(DensityForms, ALayerThinnerThanAStepCountsInFull)
{
  // Two hundredths thick, where a march has eight steps over four units.
  const double dense = 5.0;
  const DensityGrid grid = SampleAlongX(4001, 4.0, [&](double x) { return x > 1.7295 && x < 1.7505 ? dense : 0.0; });
  Slab slab(4.0, &grid);
  slab.Options.NumberOfSteps = 8;
  slab.Options.MaximumHalvings = 3;
  // The sun comes from the side: its leg to the layer is empty, and within the layer as deep as the camera's.
  slab.Sun.Normal = { 1.0, 0.0, 0.0 };
  ASSERT_EQ(PrepareLight(slab.Sun), nullptr);
  for (const ScatteringMode mode : Ways)
  {
    const ScatteringImage image = slab.Look(mode, { -1.0, 0.5, 0.0 }, { 1.0, 0.5, 0.0 });
    const double depth = dense * 0.021; // twenty cells and a ramp over one at either side
    for (int k = 0; k < 2; ++k)
    {
      const double sigmaT = SigmaS[k] + SigmaA[k];
      const double expected =
        SigmaS[k] * Irradiance / (4.0 * closedforms::Pi) * (1.0 - std::exp(-2.0 * sigmaT * depth)) / (2.0 * sigmaT);
      EXPECT_NEAR(image.InScattering[k] / expected, 1.0, 0.01)
        << "mode " << static_cast<int>(mode) << ", wavelength " << k;
      EXPECT_NEAR(image.Transmittance[k] / std::exp(-sigmaT * depth), 1.0, 1e-3);
    }
  }
}

TEST(DensityForms, NoDensityIsNoMedium)
{
  const DensityGrid grid = SampleDensity(
    { { 2, 2, 2 } }, { -9.0, -9.0, -9.0 }, UnitAxes({ 18.0, 18.0, 18.0 }), [](const Vector3&) { return 0.0; });
  for (const ScatteringMode mode : Modes)
  {
    Room room;
    room.Options.NumberOfSurfaceLightSamples = 0;
    room.Fog.Density = &grid;
    const ScatteringImage image = room.Render(mode);
    EXPECT_EQ(image.InScattering, std::vector<float>(image.InScattering.size(), 0.0f));
    EXPECT_EQ(image.Transmittance, std::vector<float>(image.Transmittance.size(), 1.0f));
    if (mode != ScatteringMode::Guided)
    {
      EXPECT_EQ(image.NumberOfOcclusionRays, 0) << "mode " << static_cast<int>(mode);
    }
  }
}

// Guided and Volume in fog are cases of Testing/Invariants.
TEST(DensityForms, TheSameBytesForAnyNumberOfThreads)
{
  const DensityGrid grid = SampleDensity({ { 17, 17, 17 } }, { -2.0, -2.0, -2.0 }, UnitAxes({ 0.25, 0.25, 0.25 }),
    [](const Vector3& p) { return 1.0 + std::sin(3.0 * p.X) * std::cos(2.0 * p.Y + p.Z); });
  Room room;
  room.Fog.Density = &grid;
  room.Options.NumberOfSteps = 16;
  room.Options.Width = room.Options.Height = 6;
  room.Options.Extent = { 0, 5, 0, 5 };
  for (const ScatteringMode mode :
    { ScatteringMode::BruteForce, ScatteringMode::Medium, ScatteringMode::Fast, ScatteringMode::Soft })
  {
    const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
    vtkSMPTools::Initialize(1);
    const ScatteringImage one = room.Render(mode);
    vtkSMPTools::Initialize(2);
    const ScatteringImage two = room.Render(mode);
    vtkSMPTools::Initialize(threads);
    EXPECT_EQ(one.Radiance, two.Radiance) << "mode " << static_cast<int>(mode);
    EXPECT_EQ(one.RelativeError, two.RelativeError);
    EXPECT_EQ(one.SampleCount, two.SampleCount);
  }
}
