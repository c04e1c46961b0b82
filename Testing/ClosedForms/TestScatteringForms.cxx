// SPDX-License-Identifier: BSD-3-Clause
// The brute-force image against closed forms 5, 6, 7, 9 and 10: every pixel within 1 %.
#include "TestMeshes.h"
#include "scConeIntervals.h"
#include "scScatteringImage.h"

#include <gtest/gtest.h>

#include <memory>

using namespace shadowcones;

namespace
{
constexpr double Tolerance = 0.01;

/// Something that no test's light or ray meets.
TestMesh OutOfTheWay()
{
  TestMesh mesh;
  mesh.AddParallelogram({ 200.0, 200.0, 200.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.1, 0.0 });
  return mesh;
}

Light NewLight(LightShape shape, std::vector<double> spectrum)
{
  Light light;
  light.Shape = shape;
  light.Spectrum = std::move(spectrum);
  return light;
}

Medium MakeMedium(std::vector<double> sigmaS, std::vector<double> sigmaA, const Vector3& a, const Vector3& b)
{
  Medium medium;
  medium.SigmaS = std::move(sigmaS);
  medium.SigmaA = std::move(sigmaA);
  medium.Bounds.Min = a;
  medium.Bounds.Max = b;
  return medium;
}

ScatteringImage Render(const OccluderScene& scene, const Light& light, const Medium& medium, const Camera& camera,
  ScatteringOptions options, const ConeHierarchy* cones = nullptr)
{
  options.Extent = { 0, options.Width - 1, 0, options.Height - 1 };
  ScatteringImage image;
  EXPECT_TRUE(RenderScattering({ scene, light, medium, camera, cones }, options, Monitor(), image));
  EXPECT_EQ(image.InScattering.size(), light.Spectrum.size() * options.Width * options.Height);
  return image;
}

/// BruteForce at a test's sample counts.
ScatteringOptions Options(int width, int height)
{
  ScatteringOptions options;
  options.Width = width;
  options.Height = height;
  options.NumberOfSteps = 64;
  options.MaximumDepth = 6;
  options.IntensityThreshold = 0.02;
  options.NumberOfLightSamples = 16;
  options.NumberOfSurfaceLightSamples = 0;
  return options;
}

/// Sum of the differences over the sum of b.
double RelativeDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    difference += std::abs(static_cast<double>(a[k]) - b[k]);
    sum += b[k];
  }
  return difference / sum;
}

/// A light that hangs over the chair-sized test scenes.
Light DiscLight()
{
  Light light = NewLight(LightShape::Disc, { 1.0, 2.0 });
  light.Center = { 0.0, 5.0, 0.0 };
  light.Normal = { 0.0, -1.0, 0.0 };
  light.Radius = 0.5;
  EXPECT_EQ(PrepareLight(light), nullptr);
  return light;
}
} // namespace

TEST(ScatteringForms, AirlightOfAPointLight)
{
  Light light = NewLight(LightShape::Point, { 3.0, 1.0 });
  ASSERT_EQ(PrepareLight(light), nullptr);
  const Medium medium = MakeMedium({ 0.05, 0.2 }, { 0.0, 0.0 }, { -10.0, -10.0, -10.0 }, { 10.0, 10.0, 10.0 });
  const TestMesh mesh = OutOfTheWay();
  const OccluderScene scene(mesh.View());
  const Camera camera = LookAt({ -4.0, -2.0, 0.0 }, { 10.0, -2.0, 0.0 }, 0.4);
  const int size = 6;
  const ScatteringImage image = Render(scene, light, medium, camera, Options(size, size));
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const Ray ray = camera.PixelRay(i, j, size, size);
      double begin = 0.0;
      double end = HUGE_VAL;
      ASSERT_TRUE(medium.Bounds.Clip(ray.Origin, ray.Direction, begin, end));
      const Vector3 toLight = light.Center - ray.Origin;
      const double gamma = std::acos(Dot(toLight, ray.Direction) / Length(toLight));
      for (int k = 0; k < 2; ++k)
      {
        const double expected = closedforms::Airlight(light.Spectrum[k], medium.SigmaS[k], Length(toLight), gamma, end);
        EXPECT_NEAR(image.InScattering[2 * (j * size + i) + k] / expected, 1.0, Tolerance)
          << "pixel " << i << ", " << j << ", wavelength " << k;
      }
    }
  }
}

TEST(ScatteringForms, AirlightBehindABar)
{
  Light light = NewLight(LightShape::Point, { 3.0 });
  ASSERT_EQ(PrepareLight(light), nullptr);
  const Medium medium = MakeMedium({ 0.1 }, { 0.0 }, { -10.0, -10.0, -10.0 }, { 10.0, 10.0, 10.0 });
  const double left = -0.4;
  const double right = 0.3;
  TestMesh mesh;
  mesh.AddParallelogram({ left, -1.0, -40.0 }, { right - left, 0.0, 0.0 }, { 0.0, 0.0, 80.0 });
  const OccluderScene scene(mesh.View());
  const Camera camera = LookAt({ -4.0, -2.0, 0.0 }, { 10.0, -2.0, 0.0 }, 0.05);
  const int size = 6;
  const ScatteringImage image = Render(scene, light, medium, camera, Options(size, size));
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const Ray ray = camera.PixelRay(i, j, size, size);
      double begin = 0.0;
      double end = HUGE_VAL;
      ASSERT_TRUE(medium.Bounds.Clip(ray.Origin, ray.Direction, begin, end));
      // The shadow of an edge x = c at y = -1 is the plane x = -c y.
      const auto meets = [&ray](double c)
      { return -(ray.Origin.X + c * ray.Origin.Y) / (ray.Direction.X + c * ray.Direction.Y); };
      const Vector3 toLight = light.Center - ray.Origin;
      const double gamma = std::acos(Dot(toLight, ray.Direction) / Length(toLight));
      const double whole = closedforms::Airlight(3.0, 0.1, Length(toLight), gamma, end);
      const double expected =
        closedforms::AirlightOver(3.0, 0.1, Length(toLight), gamma, { { 0.0, meets(left) }, { meets(right), end } });
      EXPECT_LT(expected, 0.9 * whole);
      EXPECT_NEAR(image.InScattering[j * size + i] / expected, 1.0, Tolerance) << "pixel " << i << ", " << j;
    }
  }
}

TEST(ScatteringForms, SunOnASlab)
{
  const double irradiance = 5.0;
  Light light = NewLight(LightShape::Sun, { irradiance, irradiance });
  light.Normal = { 0.0, -1.0, 0.0 };
  light.Radius = 0.0;
  ASSERT_EQ(PrepareLight(light), nullptr);
  const double S = 4.0;
  const std::vector<double> sigmaS = { 0.5, 0.2 };
  const std::vector<double> sigmaA = { 0.1, 1.0 };
  for (const Placement& place : { Placements()[0], Placements()[1] })
  {
    Medium medium = MakeMedium(sigmaS, sigmaA, place({ 0.0, 0.0, -1.0 }), place({ S, 1.0, 1.0 }));
    TestMesh mesh;
    const std::vector<std::pair<double, double>> shadowed = { { 0.5, 1.2 }, { 2.0, 3.3 } };
    for (const auto& part : shadowed)
    {
      mesh.AddParallelogram({ part.first, 2.0, -2.0 }, { part.second - part.first, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
    }
    mesh.Place(place);
    const OccluderScene scene(mesh.View());
    const Camera camera = LookAt(place({ -1.0, 0.5, 0.0 }), place({ 1.0, 0.5, 0.0 }), 0.4, true);
    const int size = 4;
    const ScatteringImage image = Render(scene, light, medium, camera, Options(size, size));
    for (int j = 0; j < size; ++j)
    {
      const double y = camera.PixelRay(0, j, size, size).Origin.Y - place({}).Y;
      for (int k = 0; k < 2; ++k)
      {
        const double expected = closedforms::SlabRadiance(sigmaS[k], sigmaS[k] + sigmaA[k], irradiance, y, S, shadowed);
        EXPECT_NEAR(image.InScattering[2 * (j * size + 1) + k] / expected, 1.0, Tolerance)
          << place.Name << ", y " << y << ", wavelength " << k;
      }
    }
  }
}

TEST(ScatteringForms, SolidAngleOfADisc)
{
  const double R = 0.5;
  for (const Placement& place : Placements())
  {
    Light light = NewLight(LightShape::Disc, { 2.0 });
    light.Center = place({});
    light.Normal = { 0.0, -1.0, 0.0 };
    light.Radius = R * place.Scale;
    ASSERT_EQ(PrepareLight(light), nullptr);
    for (const double h : { 0.1, 0.5, 1.0, 4.0 })
    {
      const double side = 0.002 * place.Scale;
      const Vector3 at = place({ 0.0, -h, 0.0 });
      const Vector3 half{ 0.5 * side, 0.5 * side, 0.5 * side };
      const Medium medium = MakeMedium({ 0.01 }, { 0.0 }, at - half, at + half);
      TestMesh mesh;
      mesh.AddParallelogram({ 3.0, -3.0, 3.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.1, 0.0 });
      mesh.Place(place);
      const OccluderScene scene(mesh.View());
      const Camera camera = LookAt(at - Vector3{ place.Scale, 0.0, 0.0 }, at, 1e-6 * place.Scale, true);
      ScatteringOptions options = Options(1, 1);
      options.NumberOfLightSamples = 64;
      const ScatteringImage image = Render(scene, light, medium, camera, options);
      const double expected = 0.01 * side * 2.0 * closedforms::DiscSolidAngle(R, h) / (4.0 * closedforms::Pi);
      EXPECT_NEAR(image.InScattering[0] / expected, 1.0, Tolerance) << place.Name << ", h " << h;
    }
  }
}

TEST(ScatteringForms, RayUpToADisc)
{
  // Along the axis up to the light itself, where points by area alone do not converge.
  const double R = 0.5;
  const double H = 3.0;
  const double sigma = 1e-5;
  Light light = NewLight(LightShape::Disc, { 1.0 });
  light.Normal = { 0.0, -1.0, 0.0 };
  light.Radius = R;
  ASSERT_EQ(PrepareLight(light), nullptr);
  const Medium medium = MakeMedium({ sigma }, { 0.0 }, { -1.0, -H, -1.0 }, { 1.0, 0.0, 1.0 });
  const TestMesh mesh = OutOfTheWay();
  const OccluderScene scene(mesh.View());
  const Camera camera = LookAt({ 0.0, -H - 1.0, 0.0 }, { 0.0, 0.0, 0.0 }, 1e-6, true);
  const ScatteringImage image = Render(scene, light, medium, camera, Options(1, 1));
  const double expected = 0.5 * sigma * (H - std::hypot(H, R) + R);
  EXPECT_NEAR(image.InScattering[0] / expected, 1.0, Tolerance);
}

TEST(ScatteringForms, FurnaceOfAllPhaseFunctions)
{
  // Inside a box whose walls all emit, the in-scattered light is the walls' radiance whatever the phase function.
  Light light = NewLight(LightShape::Mesh, { 2.0 });
  const double s = 3.0;
  const Vector3 axes[3] = { { s, 0.0, 0.0 }, { 0.0, s, 0.0 }, { 0.0, 0.0, s } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Vector3 n = side * axes[axis];
      const Vector3 u = axes[(axis + 1) % 3];
      const Vector3 v = axes[(axis + 2) % 3];
      // Wound so that the normals point inward.
      const Vector3 a = n - u - v;
      const Vector3 b = n + u - v;
      const Vector3 c = n + u + v;
      const Vector3 d = n - u + v;
      if (side < 0.0)
      {
        light.Triangles.push_back({ a, b, c });
        light.Triangles.push_back({ a, c, d });
      }
      else
      {
        light.Triangles.push_back({ a, c, b });
        light.Triangles.push_back({ a, d, c });
      }
    }
  }
  ASSERT_EQ(PrepareLight(light), nullptr);
  ASSERT_NEAR(LightArea(light), 24.0 * s * s, 1e-9);
  const double sigma = 1e-5;
  Medium medium = MakeMedium({ sigma }, { 0.0 }, { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  const TestMesh mesh = OutOfTheWay();
  const OccluderScene scene(mesh.View());
  const Camera camera = LookAt({ -2.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, 0.5, true);
  for (const PhaseFunctionKind kind :
    { PhaseFunctionKind::Isotropic, PhaseFunctionKind::HenyeyGreenstein, PhaseFunctionKind::Rayleigh })
  {
    medium.Phase.Kind = kind;
    medium.Phase.Asymmetry = 0.5;
    ScatteringOptions options = Options(2, 1);
    options.NumberOfLightSamples = 2048;
    const ScatteringImage image = Render(scene, light, medium, camera, options);
    for (const float value : image.InScattering)
    {
      EXPECT_NEAR(value / (2.0 * sigma * 2.0), 1.0, Tolerance) << "phase function " << static_cast<int>(kind);
    }
  }
}

TEST(ScatteringForms, FurnaceOfAllModes)
{
  const Light light = DiscLight();
  const Medium medium = MakeMedium({ 0.1, 0.2 }, { 0.0, 0.1 }, { -2.0, 0.0, -2.0 }, { 2.0, 4.5, 2.0 });
  const TestMesh mesh = OutOfTheWay();
  const OccluderScene scene(mesh.View());
  const Camera camera = LookAt({ -6.0, 2.5, 0.0 }, { 0.0, 2.5, 0.0 }, 0.5);
  const ConeHierarchy cones({}, medium.Bounds);
  ScatteringOptions options = Options(8, 8);
  const ScatteringImage brute = Render(scene, light, medium, camera, options);
  for (const ScatteringMode mode : { ScatteringMode::Medium, ScatteringMode::Fast })
  {
    options.Mode = mode;
    const ScatteringImage image = Render(scene, light, medium, camera, options, &cones);
    EXPECT_EQ(image.InScattering, brute.InScattering) << "mode " << static_cast<int>(mode);
    EXPECT_EQ(image.Transmittance, brute.Transmittance);
    EXPECT_EQ(image.NumberOfOcclusionRays, 0);
  }
  EXPECT_GT(brute.NumberOfOcclusionRays, 0);
}

TEST(ScatteringForms, FarVertexAndSunCastTheSameHardShadow)
{
  const double far = 1e6;
  const double irradiance = 2.0;
  Light vertex = NewLight(LightShape::Mesh, { irradiance * far * far });
  vertex.Vertices = { { 0.0, far, 0.0 } };
  ASSERT_EQ(PrepareLight(vertex), nullptr);
  Light sun = NewLight(LightShape::Sun, { irradiance });
  sun.Normal = { 0.0, -1.0, 0.0 };
  sun.Radius = 0.0;
  ASSERT_EQ(PrepareLight(sun), nullptr);

  TestMesh mesh;
  mesh.AddParallelogram({ -0.5, 2.0, -0.7 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.4 });
  const OccluderScene scene(mesh.View());
  int blocked = 0;
  for (int k = 0; k < 1000; ++k)
  {
    RandomStream random(3, static_cast<std::uint64_t>(k));
    const Vector3 x{ 2.0 * random.Next() - 1.0, 2.0 * random.Next(), 2.0 * random.Next() - 1.0 };
    if (std::abs(std::abs(x.X) - 0.5) < 1e-4 || std::abs(std::abs(x.Z) - 0.7) < 1e-4)
    {
      continue;
    }
    const double expected = std::abs(x.X) < 0.5 && std::abs(x.Z) < 0.7 ? 0.0 : 1.0;
    for (const Light* light : { &vertex, &sun })
    {
      const IncidentSample sample = SampleVisibleLight(*light, x, random.Next(), random.Next());
      ASSERT_EQ(sample.Weight, 1.0);
      EXPECT_EQ(scene.Occluded(x, sample.Direction, 0.0, sample.Distance) ? 0.0 : 1.0, expected);
    }
    blocked += expected == 0.0;
  }
  EXPECT_GT(blocked, 200);

  const Medium medium = MakeMedium({ 0.1 }, { 0.05 }, { -1.0, 0.0, -1.0 }, { 1.0, 1.9, 1.0 });
  const Camera camera = LookAt({ -6.0, 1.5, 0.0 }, { 0.0, 1.0, 0.0 }, 0.3);
  const ScatteringImage ofVertex = Render(scene, vertex, medium, camera, Options(16, 16));
  const ScatteringImage ofSun = Render(scene, sun, medium, camera, Options(16, 16));
  EXPECT_LT(RelativeDifference(ofVertex.InScattering, ofSun.InScattering), 1e-4);
}
