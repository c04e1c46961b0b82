// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of the scattering image: where their shadows cost rays, and what a pixel at an edge is.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scRenderScattering.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scVisibilityGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{

/// A tilted plate between a lamp and a floor, in air that scatters nothing.
struct Stage
{
  TestMesh Mesh;
  Light Lamp = DiscLight({ 0.0, 3.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.4);
  Medium Air;
  Camera View;
  ScatteringOptions Options;

  Stage()
  {
    this->Mesh.AddSheet({ -0.7, 1.0, -0.5 }, { 1.2, 0.3, 0.0 }, { 0.0, 0.1, 1.1 }, 0);
    this->Mesh.AddSheet({ -6.0, 0.0, 6.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, -1);
    this->Air.SigmaS.assign(7, 0.0);
    this->Air.SigmaA.assign(7, 0.1);
    this->Air.Bounds = { { -7.0, -1.0, -7.0 }, { 7.0, 4.0, 7.0 } };
    this->View.Position = { 0.0, 5.0, 6.0 };
    this->View.Forward = Normalized({ 0.0, -0.8, -1.0 });
    this->View.Up = Cross(this->View.Right, this->View.Forward);
    this->View.HalfHeight = 0.4;
    this->Options.Width = 40;
    this->Options.Height = 30;
    this->Options.Extent = { 0, 39, 0, 29 };
  }

  /// A cone that holds all of the plate's shadow and begins half a base radius below the top of the plate.
  std::vector<Cone> BoundingCones() const
  {
    Cone cone;
    cone.Center = { -0.1, 1.15, 0.05 };
    cone.Axis = { 0.0, -1.0, 0.0 };
    cone.BaseRadius = 1.0;
    cone.HalfAngle = std::atan((1.0 + 0.4) / 1.5);
    cone.OccluderId = 0;
    return { cone };
  }

  ScatteringImage Render(ScatteringMode mode, const ConeHierarchy* cones = nullptr,
    const VisibilityGrid* grid = nullptr, const Monitor& monitor = {}) const
  {
    const OccluderScene occluders(this->Mesh.View());
    ScatteringOptions options = this->Options;
    options.Mode = mode;
    ScatteringImage image;
    EXPECT_TRUE(
      RenderScattering({ occluders, this->Lamp, this->Air, this->View, cones, grid }, options, monitor, image));
    return image;
  }
};

/// Parallel view along -z on a white plate x cos a + y sin a < offset at z = 0 under a sun along -z, pixels of side 1.
struct HalfPlane
{
  TestMesh Mesh;
  Light Sun = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  Medium Air;
  Camera View;
  ScatteringOptions Options;
  Vector3 Normal;
  double Offset;
  int Size = 32;

  HalfPlane(double angle, double offset)
    : Normal{ std::cos(angle), std::sin(angle), 0.0 }
    , Offset(offset)
  {
    const Vector3 along{ -this->Normal.Y, this->Normal.X, 0.0 };
    this->Mesh.AddSheet(offset * this->Normal - 100.0 * along, 200.0 * along, -200.0 * this->Normal, 0);
    this->Air.SigmaS.assign(7, 0.0);
    this->Air.SigmaA.assign(7, 0.0);
    this->Air.Bounds = { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
    this->View.Position = { 0.0, 0.0, 10.0 };
    this->View.Parallel = true;
    this->View.HalfHeight = 0.5 * this->Size;
    this->Options.Width = this->Options.Height = this->Size;
    this->Options.Extent = { 0, this->Size - 1, 0, this->Size - 1 };
    this->Options.Reflectance = 1.0;
    this->Options.NumberOfSurfaceLightSamples = 4;
  }

  /// One value a pixel, 1 where the plate fills it.
  std::vector<double> Render() const
  {
    const OccluderScene occluders(this->Mesh.View());
    ScatteringImage image;
    EXPECT_TRUE(RenderScattering({ occluders, this->Sun, this->Air, this->View }, this->Options, {}, image));
    std::vector<double> values;
    for (std::size_t pixel = 0; pixel < image.Depth.size(); ++pixel)
    {
      values.push_back(image.SurfaceRadiance[7 * pixel] * Pi);
    }
    return values;
  }

  /// The share of pixel (i, j) that the plate covers, over a fine grid of points.
  double Coverage(int i, int j) const
  {
    constexpr int parts = 64;
    int inside = 0;
    for (int k = 0; k < parts * parts; ++k)
    {
      const double x = i - 0.5 * this->Size + (k % parts + 0.5) / parts;
      const double y = j - 0.5 * this->Size + (k / parts + 0.5) / parts;
      inside += x * this->Normal.X + y * this->Normal.Y < this->Offset ? 1 : 0;
    }
    return static_cast<double>(inside) / (parts * parts);
  }
};

/// A grid over a box whose vertices hold @p fraction and @p marked of their places.
VisibilityGrid MakeGrid(const Box& box, int vertices, const std::function<double(const Vector3&)>& fraction,
  const std::function<bool(const Vector3&)>& marked)
{
  VisibilityGrid grid;
  grid.Origin = box.Min;
  grid.Spacing = (1.0 / (vertices - 1)) * box.Size();
  grid.Dimensions = { vertices, vertices, vertices };
  for (int k = 0; k < vertices; ++k)
  {
    for (int j = 0; j < vertices; ++j)
    {
      for (int i = 0; i < vertices; ++i)
      {
        const Vector3 vertex = grid.Vertex(i, j, k);
        grid.Visibility.push_back(static_cast<float>(fraction(vertex)));
        grid.Marked.push_back(marked(vertex) ? 1 : 0);
        grid.ShadowClasses.push_back(0);
      }
    }
  }
  return grid;
}

double Sum(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The same up to the noise of 16 light samples, which have no bias.
void ExpectAlike(const ScatteringImage& a, const ScatteringImage& b)
{
  const float largest = *std::max_element(b.SurfaceRadiance.begin(), b.SurfaceRadiance.end());
  for (std::size_t k = 0; k < b.SurfaceRadiance.size(); ++k)
  {
    ASSERT_NEAR(a.SurfaceRadiance[k], b.SurfaceRadiance[k], 0.02 * largest) << "pixel " << k / 7;
  }
  EXPECT_NEAR(Sum(a.SurfaceRadiance) / Sum(b.SurfaceRadiance), 1.0, 5e-4);
}

} // namespace

TEST(SurfaceShader, ConesSaveRaysAndNoByteOfTheImage)
{
  const Stage stage;
  const ConeHierarchy cones(stage.BoundingCones(), stage.Air.Bounds);
  const ScatteringImage bruteForce = stage.Render(ScatteringMode::BruteForce);
  const ScatteringImage medium = stage.Render(ScatteringMode::Medium, &cones);
  EXPECT_EQ(medium.Radiance, bruteForce.Radiance);
  EXPECT_EQ(medium.SurfaceRadiance, bruteForce.SurfaceRadiance);
  EXPECT_EQ(medium.NumberOfShortPixels, bruteForce.NumberOfShortPixels);
  // In half-shadow far more rays are taken than in the light, where BruteForce takes these alone.
  EXPECT_LT(medium.NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays * 3 / 4);
  EXPECT_GT(medium.NumberOfOcclusionRays, 0);
  for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume })
  {
    const ScatteringImage image = stage.Render(mode, &cones);
    ExpectAlike(image, bruteForce);
    EXPECT_EQ(image.NumberOfOcclusionRays, medium.NumberOfOcclusionRays) << static_cast<int>(mode);
  }
  // With nothing that bounds the shadow every mode but Fast and Soft asks for all of it.
  for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume })
  {
    const ScatteringImage image = stage.Render(mode);
    EXPECT_EQ(image.SurfaceRadiance, bruteForce.SurfaceRadiance) << static_cast<int>(mode);
    EXPECT_EQ(image.NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays) << static_cast<int>(mode);
  }
}

TEST(SurfaceShader, ASurfaceUpToOneRadiusBeforeABaseIsTraced)
{
  // Two floors face the lamp above: the upper one shadows half of the lower, and the cone's base lies below both.
  Stage stage;
  stage.Mesh = {};
  stage.Mesh.AddSheet({ -6.0, 0.0, 6.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, 0);
  stage.Mesh.AddSheet({ -6.0, 1.0, 0.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -6.0 }, 1);
  Cone cone;
  cone.Center = { 0.0, -7.9, 0.0 };
  cone.Axis = { 0.0, -1.0, 0.0 };
  cone.BaseRadius = 9.0;
  const Box space{ { -11.0, -11.0, -11.0 }, { 11.0, 11.0, 11.0 } };
  const ScatteringImage bruteForce = stage.Render(ScatteringMode::BruteForce);
  const ConeHierarchy near({ cone }, space);
  EXPECT_EQ(stage.Render(ScatteringMode::Medium, &near).SurfaceRadiance, bruteForce.SurfaceRadiance);
  cone.Center.Y = -10.1;
  const ConeHierarchy far({ cone }, space);
  const ScatteringImage missed = stage.Render(ScatteringMode::Medium, &far);
  EXPECT_EQ(missed.NumberOfOcclusionRays, 0);
  EXPECT_GT(Sum(missed.SurfaceRadiance), 1.02 * Sum(bruteForce.SurfaceRadiance));
}

TEST(SurfaceShader, VolumeTracesNearMarksOnly)
{
  const Stage stage;
  const ConeHierarchy cones(stage.BoundingCones(), stage.Air.Bounds);
  const VisibilityGrid marked = MakeGrid(
    stage.Air.Bounds, 25, [](const Vector3&) { return 1.0; }, [&](const Vector3& p) { return cones.Contains(p); });
  const ScatteringImage bruteForce = stage.Render(ScatteringMode::BruteForce);
  const ScatteringImage volume = stage.Render(ScatteringMode::Volume, nullptr, &marked);
  ExpectAlike(volume, bruteForce);
  EXPECT_LT(volume.NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays * 4 / 5);
  // A grid that says nothing of marks, or ends before the surfaces, is asked nothing.
  VisibilityGrid plain = marked;
  plain.Marked.clear();
  EXPECT_EQ(
    stage.Render(ScatteringMode::Volume, nullptr, &plain).NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays);
  const VisibilityGrid elsewhere = MakeGrid(
    { { 6.5, 3.5, 6.5 }, { 7.0, 4.0, 7.0 } }, 3, [](const Vector3&) { return 1.0; },
    [](const Vector3&) { return false; });
  EXPECT_EQ(
    stage.Render(ScatteringMode::Volume, nullptr, &elsewhere).NumberOfOcclusionRays, bruteForce.NumberOfOcclusionRays);
}

TEST(SurfaceShader, SoftScalesTheUnshadowedLightByTheGrid)
{
  Stage stage;
  stage.Mesh = {};
  stage.Mesh.AddSheet({ -6.0, 0.0, 6.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, 0);
  const VisibilityGrid all = MakeGrid(
    stage.Air.Bounds, 2, [](const Vector3&) { return 1.0; }, [](const Vector3&) { return true; });
  const ScatteringImage open = stage.Render(ScatteringMode::Soft, nullptr, &all);
  ExpectAlike(open, stage.Render(ScatteringMode::BruteForce));
  const VisibilityGrid half = MakeGrid(
    stage.Air.Bounds, 9, [](const Vector3& p) { return p.X < 0.0 ? 0.25 : 0.75; }, [](const Vector3&) { return true; });
  const ScatteringImage soft = stage.Render(ScatteringMode::Soft, nullptr, &half);
  EXPECT_EQ(soft.NumberOfOcclusionRays, 0);
  const std::size_t left = 7 * (15 * 40 + 5);
  const std::size_t right = 7 * (15 * 40 + 34);
  EXPECT_GT(open.SurfaceRadiance[left], 0.0f);
  EXPECT_NEAR(soft.SurfaceRadiance[left] / open.SurfaceRadiance[left], 0.25, 1e-6);
  EXPECT_NEAR(soft.SurfaceRadiance[right] / open.SurfaceRadiance[right], 0.75, 1e-6);
  // The value is that of one cell above the surface, where the surface's own shadow does not reach.
  const VisibilityGrid below = MakeGrid(
    stage.Air.Bounds, 9, [](const Vector3& p) { return p.Y < 0.0 ? 0.0 : 1.0; }, [](const Vector3&) { return true; });
  EXPECT_EQ(stage.Render(ScatteringMode::Soft, nullptr, &below).SurfaceRadiance, open.SurfaceRadiance);
}

TEST(SurfaceShader, LightThatNothingHidesHasNoNoise)
{
  // One floor; no cone is anywhere.
  Stage stage;
  stage.Mesh = {};
  stage.Mesh.AddSheet({ -6.0, 0.0, 6.0 }, { 12.0, 0.0, 0.0 }, { 0.0, 0.0, -12.0 }, 0);
  const ConeHierarchy none({}, stage.Air.Bounds);
  stage.Options.NumberOfSurfaceLightSamples = 1024;
  const ScatteringImage truth = stage.Render(ScatteringMode::BruteForce);
  stage.Options.NumberOfSurfaceLightSamples = 1;
  for (const ScatteringMode mode : { ScatteringMode::Guided, ScatteringMode::Volume, ScatteringMode::Soft })
  {
    const ScatteringImage image = stage.Render(mode, &none);
    EXPECT_EQ(image.NumberOfOcclusionRays, 0);
    for (std::size_t k = 0; k < truth.SurfaceRadiance.size(); ++k)
    {
      ASSERT_NEAR(image.SurfaceRadiance[k], truth.SurfaceRadiance[k], 1e-3 * truth.SurfaceRadiance[k] + 1e-9);
    }
  }
}

TEST(SurfaceShader, AnObliqueEdgeIsTheShareThatItCovers)
{
  for (const int samples : { 4, 9, 16 })
  {
    double worst = 0.0;
    double squares = 0.0;
    double bias = 0.0;
    int edges = 0;
    for (const double angle : { 0.1, 0.3, 0.55, 0.79, 1.2, 2.0 })
    {
      HalfPlane plane(angle, 0.37);
      plane.Options.NumberOfEdgeSamples = samples;
      const std::vector<double> values = plane.Render();
      for (int j = 0; j < plane.Size; ++j)
      {
        for (int i = 0; i < plane.Size; ++i)
        {
          const double coverage = plane.Coverage(i, j);
          const double value = values[static_cast<std::size_t>(j * plane.Size + i)];
          const double difference = value - coverage;
          worst = std::max(worst, std::fabs(difference));
          if (coverage > 0.0 && coverage < 1.0)
          {
            ++edges;
            squares += difference * difference;
            bias += difference;
          }
        }
      }
    }
    // Random points would be 0.4 / sqrt(n) off on average.
    EXPECT_LT(worst, 0.8 / std::sqrt(samples)) << samples;
    EXPECT_LT(std::sqrt(squares / edges), 0.22 / std::sqrt(samples)) << samples;
    EXPECT_LT(std::fabs(bias / edges), 0.01) << samples;
    EXPECT_GT(edges, 200);
  }
}

TEST(SurfaceShader, ThinSlatsBeforeABrightWallAreLinesWithoutDots)
{
  // A black slat at a slant in front of the white plate: a pixel is the share that the slat leaves free. The last one is
  // thinner than a pixel.
  for (const double width : { 2.3, 1.2, 0.75 })
  {
    for (const double angle : { 0.1, 1.5, 0.7 })
    {
      HalfPlane wall(angle, 1000.0);
      const Vector3 along{ -wall.Normal.Y, wall.Normal.X, 0.0 };
      const double begin = 0.37;
      const Vector3 lift{ 0.0, 0.0, 1.0 };
      wall.Mesh = {};
      wall.Mesh.AddSheet({ -60.0, -60.0, 0.0 }, { 120.0, 0.0, 0.0 }, { 0.0, 120.0, 0.0 }, 0);
      wall.Mesh.AddSheet(
        begin * wall.Normal - 100.0 * along + lift, width * wall.Normal, 200.0 * along, 0);
      wall.Options.SurfaceReflectance = { 1.0f, 1.0f, 0.0f, 0.0f };
      // Its shadow falls where the camera does not see it.
      const std::vector<double> values = wall.Render();
      double squares = 0.0;
      int crossed = 0;
      for (int j = 0; j < wall.Size; ++j)
      {
        for (int i = 0; i < wall.Size; ++i)
        {
          wall.Offset = begin + width;
          const double upTo = wall.Coverage(i, j);
          wall.Offset = begin;
          const double covered = upTo - wall.Coverage(i, j);
          const double difference = values[static_cast<std::size_t>(j * wall.Size + i)] - (1.0 - covered);
          EXPECT_LT(std::fabs(difference), 0.05) << width << ", " << angle << ", pixel " << i << ", " << j;
          squares += difference * difference;
          crossed += covered > 0.0 && covered < 1.0 ? 1 : 0;
        }
      }
      EXPECT_GT(crossed, 30);
      EXPECT_LT(std::sqrt(squares / crossed), 0.02) << width << ", " << angle;
    }
  }
}

TEST(SurfaceShader, AThinSlatBeforeTheMediumTakesItsShareOfTheMedium)
{
  // The medium begins behind the slat: a pixel's medium term is that of the free share of it. Under a sun from above the
  // term of a ray at height y is sigma_s E / (4 Pi) exp(-sigma_t (20 - y)) (1 - exp(-4 sigma_t)) / sigma_t.
  HalfPlane view(0.7, 0.37);
  const double width = 1.3;
  const double sigmaS = 0.02;
  const double sigmaT = 0.05;
  const Vector3 along{ -view.Normal.Y, view.Normal.X, 0.0 };
  view.Mesh = {};
  view.Mesh.AddSheet(view.Offset * view.Normal - 100.0 * along + Vector3{ 0.0, 0.0, 1.0 }, width * view.Normal,
    200.0 * along, 0);
  view.Sun = SunLight({ 0.0, -1.0, 0.0 }, 0.0);
  view.Air.SigmaS.assign(7, sigmaS);
  view.Air.SigmaA.assign(7, sigmaT - sigmaS);
  view.Air.Bounds = { { -20.0, -20.0, -6.0 }, { 20.0, 20.0, -2.0 } };
  const OccluderScene occluders(view.Mesh.View());
  for (const ScatteringMode mode : { ScatteringMode::BruteForce, ScatteringMode::Guided, ScatteringMode::Volume })
  {
    view.Options.Mode = mode;
    view.Options.MaximumSamples = 64;
    view.Options.RelativeErrorGoal = 0.0;
    view.Options.NumberOfLightSamples = 1;
    ScatteringImage image;
    ASSERT_TRUE(RenderScattering({ occluders, view.Sun, view.Air, view.View }, view.Options, {}, image));
    double squares = 0.0;
    int crossed = 0;
    for (int j = 0; j < view.Size; ++j)
    {
      for (int i = 0; i < view.Size; ++i)
      {
        view.Offset = 0.37 + width;
        const double upTo = view.Coverage(i, j);
        view.Offset = 0.37;
        const double covered = upTo - view.Coverage(i, j);
        const double y = j + 0.5 - 0.5 * view.Size;
        const double open =
          sigmaS / (4.0 * Pi) * std::exp(-sigmaT * (20.0 - y)) * (1.0 - std::exp(-4.0 * sigmaT)) / sigmaT;
        const std::size_t pixel = 7 * static_cast<std::size_t>(j * view.Size + i);
        const double difference = image.InScattering[pixel] / open - (1.0 - covered);
        EXPECT_LT(std::fabs(difference), 0.06) << "mode " << static_cast<int>(mode) << ", pixel " << i << ", " << j;
        squares += difference * difference;
        crossed += covered > 0.0 && covered < 1.0 ? 1 : 0;
      }
    }
    EXPECT_GT(crossed, 30);
    EXPECT_LT(std::sqrt(squares / crossed), 0.03) << "mode " << static_cast<int>(mode);
  }
}

TEST(SurfaceShader, OneSampleSwitchesAntiAliasingOff)
{
  HalfPlane plane(0.3, 0.37);
  plane.Options.NumberOfEdgeSamples = 1;
  const std::vector<double> hard = plane.Render();
  EXPECT_TRUE(
    std::all_of(hard.begin(), hard.end(), [](double value) { return value == 0.0 || std::fabs(value - 1.0) < 1e-6; }));
  plane.Options.NumberOfEdgeSamples = 4;
  const std::vector<double> smooth = plane.Render();
  EXPECT_GT(std::count_if(smooth.begin(), smooth.end(), [](double value) { return value > 0.1 && value < 0.9; }), 20);
}

TEST(SurfaceShader, OnlyWhatThePixelsCentreSeesIsInDepthAndTransmittance)
{
  Stage stage;
  const ScatteringImage smooth = stage.Render(ScatteringMode::BruteForce);
  stage.Options.NumberOfEdgeSamples = 1;
  const ScatteringImage hard = stage.Render(ScatteringMode::BruteForce);
  EXPECT_EQ(smooth.Depth, hard.Depth);
  EXPECT_EQ(smooth.Transmittance, hard.Transmittance);
  EXPECT_EQ(smooth.InScattering, hard.InScattering);
  EXPECT_NE(smooth.SurfaceRadiance, hard.SurfaceRadiance);
  // Light samples are shared among the two surfaces of a pixel.
  EXPECT_NEAR(
    static_cast<double>(smooth.NumberOfOcclusionRays) / static_cast<double>(hard.NumberOfOcclusionRays), 1.0, 0.05);
}

TEST(SurfaceShader, SmoothSurfacesHaveNoEdges)
{
  // A floor of many triangles up to the horizon, and a finely faceted sphere that fills the image.
  Stage stage;
  stage.Mesh = {};
  for (int i = -8; i < 8; ++i)
  {
    for (int j = -8; j < 8; ++j)
    {
      stage.Mesh.AddSheet({ 2.0 * i, 0.0, 2.0 * j }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 2.0 }, 0);
    }
  }
  stage.View.Position = { 0.0, 0.4, 8.0 };
  stage.View.Forward = Normalized({ 0.0, -0.3, -1.0 });
  stage.View.Up = Cross(stage.View.Right, stage.View.Forward);
  stage.View.HalfHeight = 0.2;
  const auto expectNoEdge = [&stage]()
  {
    stage.Options.NumberOfEdgeSamples = 4;
    const ScatteringImage smooth = stage.Render(ScatteringMode::BruteForce);
    EXPECT_EQ(std::count(smooth.Depth.begin(), smooth.Depth.end(), -1.0f), 0);
    stage.Options.NumberOfEdgeSamples = 1;
    EXPECT_EQ(smooth.SurfaceRadiance, stage.Render(ScatteringMode::BruteForce).SurfaceRadiance);
  };
  expectNoEdge();
  stage.Mesh = {};
  stage.Mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 40, 0);
  stage.View.Position = { 0.0, 3.0, 0.0 };
  stage.View.Forward = { 0.0, -1.0, 0.0 };
  stage.View.Up = { 0.0, 0.0, -1.0 };
  expectNoEdge();
}

TEST(SurfaceShader, EdgesAreFoundBetweenSurfacesThatDiffer)
{
  // Each scene splits the view in two along x = 0; the camera looks straight down.
  const auto changed = [](const std::function<void(Stage&)>& build)
  {
    Stage stage;
    stage.Mesh = {};
    stage.View.Position = { 0.011, 2.0, 0.0 };
    stage.View.Forward = { 0.0, -1.0, 0.0 };
    stage.View.Up = { 0.0, 0.0, -1.0 };
    stage.Options.LightVisible = false;
    build(stage);
    const ScatteringImage smooth = stage.Render(ScatteringMode::BruteForce);
    stage.Options.NumberOfEdgeSamples = 1;
    const ScatteringImage hard = stage.Render(ScatteringMode::BruteForce);
    int pixels = 0;
    for (std::size_t k = 0; k < smooth.Depth.size(); ++k)
    {
      pixels += smooth.SurfaceRadiance[7 * k] != hard.SurfaceRadiance[7 * k] ? 1 : 0;
    }
    return pixels;
  };
  const Vector3 back{ 0.0, 0.0, -8.0 };
  const auto sheets = [&back](Stage& stage, const Vector3& left, const Vector3& right, int other)
  {
    stage.Mesh.AddSheet({ 0.0, 0.0, 4.0 }, left, back, 0);
    stage.Mesh.AddSheet({ 0.0, 0.0, 4.0 }, right, back, other);
  };
  const int column = 30; // the pixels that the split runs through
  EXPECT_EQ(changed([&](Stage& s) { sheets(s, { -4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, 0); }), 0) << "one plane";
  EXPECT_EQ(changed([&](Stage& s) { sheets(s, { -4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, 1); }), column) << "occluder";
  EXPECT_EQ(changed([&](Stage& s) { sheets(s, { -4.0, 0.5, 0.0 }, { 4.0, 0.5, 0.0 }, 0); }), 0) << "a slight bend";
  EXPECT_EQ(changed([&](Stage& s) { sheets(s, { -4.0, 1.5, 0.0 }, { 4.0, 1.5, 0.0 }, 0); }), column) << "a crease";
  EXPECT_EQ(changed(
              [&](Stage& s)
              {
                sheets(s, { -4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, 0);
                s.Options.SurfaceReflectance = { 0.5f, 0.5f, 0.6f, 0.6f };
              }),
    column)
    << "reflectance";
  EXPECT_EQ(changed(
              [&](Stage& s) {
                s.Mesh.AddSheet({ 0.0, 0.0, 4.0 }, { 4.0, 0.0, 0.0 }, back, 0);
              }),
    column)
    << "nothing";
  EXPECT_EQ(changed(
              [&](Stage& s)
              {
                s.Mesh.AddSheet({ 0.0, 0.0, 4.0 }, { -4.0, 0.0, 0.0 }, back, 0);
                s.Mesh.AddSheet({ -1.0, -0.05, 4.0 }, { 5.0, 0.0, 0.0 }, back, 0);
              }),
    column)
    << "a step";
}

TEST(SurfaceShader, TheRimOfTheSeenLightIsSmooth)
{
  Stage stage;
  stage.Mesh = {};
  stage.Air.SigmaA.assign(7, 0.0);
  stage.Lamp = DiscLight({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 10.3);
  stage.View = {};
  stage.View.Position = { 0.2, 0.1, 5.0 };
  stage.View.Parallel = true;
  stage.View.HalfHeight = 15.0;
  stage.Options.Width = stage.Options.Height = 30;
  stage.Options.Extent = { 0, 29, 0, 29 };
  const ScatteringImage image = stage.Render(ScatteringMode::BruteForce);
  double sum = 0.0;
  int between = 0;
  for (std::size_t k = 0; k < image.Depth.size(); ++k)
  {
    sum += image.Radiance[7 * k];
    between += image.Radiance[7 * k] > 0.1f && image.Radiance[7 * k] < 0.9f ? 1 : 0;
  }
  EXPECT_NEAR(sum / (Pi * 10.3 * 10.3), 1.0, 0.01);
  EXPECT_GT(between, 30);
  EXPECT_EQ(Sum(image.SurfaceRadiance), 0.0);
}

TEST(SurfaceShader, SplitsGiveTheSameBytes)
{
  Stage stage;
  const ConeHierarchy cones(stage.BoundingCones(), stage.Air.Bounds);
  const ScatteringImage whole = stage.Render(ScatteringMode::Medium, &cones);
  vtkIdType rays = 0;
  for (const auto& extent :
    { std::array<int, 4>{ 0, 17, 0, 10 }, { 18, 39, 0, 10 }, { 0, 17, 11, 29 }, { 18, 39, 11, 29 } })
  {
    stage.Options.Extent = extent;
    const ScatteringImage part = stage.Render(ScatteringMode::Medium, &cones);
    rays += part.NumberOfOcclusionRays;
    std::size_t index = 0;
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, index += 7)
      {
        const auto place = static_cast<std::size_t>(7 * (40 * j + i));
        ASSERT_EQ(part.SurfaceRadiance[index], whole.SurfaceRadiance[place]) << i << ", " << j;
        ASSERT_EQ(part.Radiance[index], whole.Radiance[place]) << i << ", " << j;
        ASSERT_EQ(part.SurfaceRelativeError[index / 7], whole.SurfaceRelativeError[place / 7]) << i << ", " << j;
      }
    }
  }
  EXPECT_EQ(rays, whole.NumberOfOcclusionRays);
}
