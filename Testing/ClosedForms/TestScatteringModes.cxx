// SPDX-License-Identifier: BSD-3-Clause
// Closed forms 5 to 9 in every mode that computes light: every pixel within 0.5 %.
#include "ClosedForms.h"
#include "Scenes.h"
#include "scRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace shadowcones;
using namespace testsupport;

namespace
{
constexpr double Tolerance = 0.005;

/// Every pixel and wavelength of every mode against @p expected(ray, wavelength).
void ExpectEveryMode(
  const ImageTestScene& scene, const std::function<double(const Ray& ray, std::size_t wavelength)>& expected)
{
  const std::size_t wavelengths = scene.Source.Spectrum.size();
  std::vector<double> truth;
  for (int j = 0; j < scene.Options.Height; ++j)
  {
    for (int i = 0; i < scene.Options.Width; ++i)
    {
      for (std::size_t k = 0; k < wavelengths; ++k)
      {
        truth.push_back(expected(scene.PixelRay(i, j), k));
      }
    }
  }
  for (const ScatteringMode mode : ExactModes)
  {
    const ScatteringImage image = scene.Render(mode);
    ASSERT_EQ(image.InScattering.size(), truth.size());
    double worst = 0.0;
    std::size_t where = 0;
    for (std::size_t index = 0; index < truth.size(); ++index)
    {
      const double error = std::fabs(image.InScattering[index] / truth[index] - 1.0);
      if (!(error <= worst))
      {
        worst = error;
        where = index;
      }
    }
    EXPECT_LT(worst, Tolerance) << NameOf(mode) << ": pixel " << where / wavelengths << ", wavelength "
                                << where % wavelengths;
  }
}

/// Where a ray is inside the endless cone with its apex at the origin and x^2 + y^2 <= (slope z)^2, z > nearest.
std::vector<std::pair<double, double>> InsideCone(const Ray& ray, double slope, double nearest)
{
  const Vector3& o = ray.Origin;
  const Vector3& d = ray.Direction;
  const double s = slope * slope;
  const double a = d.X * d.X + d.Y * d.Y - s * d.Z * d.Z;
  const double b = o.X * d.X + o.Y * d.Y - s * o.Z * d.Z;
  const double c = o.X * o.X + o.Y * o.Y - s * o.Z * o.Z;
  const double discriminant = b * b - a * c;
  // Flat enough a ray leaves the cone on both sides.
  if (!(a > 0.0) || !(discriminant > 0.0))
  {
    return {};
  }
  const double root = std::sqrt(discriminant);
  double begin = (-b - root) / a;
  double end = (-b + root) / a;
  if (o.Z + begin * d.Z < nearest || o.Z + end * d.Z < nearest)
  {
    // Through the base: it begins or ends at the plane.
    const double plane = (nearest - o.Z) / d.Z;
    (d.Z > 0.0 ? begin : end) = plane;
  }
  if (!(end > begin))
  {
    return {};
  }
  return { { begin, end } };
}

/// The lit parts of [0, end] around the shadowed ones.
std::vector<std::pair<double, double>> Around(const std::vector<std::pair<double, double>>& shadowed, double end)
{
  std::vector<std::pair<double, double>> lit;
  double begin = 0.0;
  for (const auto& part : shadowed)
  {
    lit.push_back({ begin, std::min(part.first, end) });
    begin = part.second;
  }
  if (begin < end)
  {
    lit.push_back({ begin, end });
  }
  return lit;
}

double EndInMedium(const ImageTestScene& scene, const Ray& ray)
{
  double begin = 0.0;
  double end = HUGE_VAL;
  EXPECT_TRUE(scene.Fog.Bounds.Clip(ray.Origin, ray.Direction, begin, end));
  EXPECT_EQ(begin, 0.0) << "the camera is inside the medium";
  return end;
}
} // namespace

TEST(ScatteringModes, AirlightOfAPointLight)
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Point, {}, { 0.0, 0.0, 1.0 }, 0.0, { 3.0, 1.0 });
  scene.SetMedium({ 0.05, 0.2 }, { 0.0, 0.0 }, { -10.0, -10.0, -10.0 }, { 10.0, 10.0, 10.0 });
  scene.AddNothing();
  scene.Eye = LookAt({ -4.0, -2.0, 0.0 }, { 10.0, -2.0, 0.0 }, 0.4);
  scene.SetSize(6, 6);
  scene.GridOptions.Dimensions = { 9, 9, 9 };
  ExpectEveryMode(scene,
    [&](const Ray& ray, std::size_t k)
    {
      const Vector3 toLight = scene.Source.Center - ray.Origin;
      const double gamma = std::acos(Dot(toLight, ray.Direction) / Length(toLight));
      return closedforms::Airlight(
        scene.Source.Spectrum[k], scene.Fog.SigmaS[k], Length(toLight), gamma, EndInMedium(scene, ray));
    });
}

TEST(ScatteringModes, AirlightBehindADisc)
{
  // The shadow of a disc under a point light is a cone with its apex at the light.
  const double L = 1.0;
  const double r = 0.35;
  ImageTestScene scene;
  scene.SetLight(LightShape::Point, {}, { 0.0, 0.0, 1.0 }, 0.0, { 3.0, 1.0 });
  scene.SetMedium({ 0.1, 0.3 }, { 0.0, 0.0 }, { -2.0, -2.0, 0.0 }, { 2.0, 2.0, 4.0 });
  scene.AddDisc({ 0.0, 0.0, L }, r, { 0.0, 0.0, 1.0 }, std::atan(r / L));
  scene.Eye = LookAt({ -1.9, -0.4, 2.2 }, { 3.0, 0.5, 2.0 }, 0.25);
  scene.SetSize(7, 7);
  // A hard edge: a grid of 129 with bricks of four parts: steps of 1/512 of the box.
  scene.GridOptions.Dimensions = { 129, 129, 129 };
  scene.GridOptions.BrickParts = 4;
  int shadowed = 0;
  ExpectEveryMode(scene,
    [&](const Ray& ray, std::size_t k)
    {
      const auto dark = InsideCone(ray, r / L, L);
      shadowed += !dark.empty();
      const Vector3 toLight = scene.Source.Center - ray.Origin;
      const double gamma = std::acos(Dot(toLight, ray.Direction) / Length(toLight));
      return closedforms::AirlightOver(scene.Source.Spectrum[k], scene.Fog.SigmaS[k], Length(toLight), gamma,
        Around(dark, EndInMedium(scene, ray)));
    });
  EXPECT_GT(shadowed, 2 * 24) << "of 49 pixels with 2 wavelengths";
}

TEST(ScatteringModes, SunBehindDiscs)
{
  const double irradiance = 5.0;
  const double S = 4.0;
  const double discs[2][3] = { { 0.9, 0.1, 0.5 }, { 2.7, -0.2, 0.7 } }; // x, y, radius
  for (const Placement& place : { Placements()[0], Placements()[1] })
  {
    SCOPED_TRACE(place.Name);
    ImageTestScene scene;
    scene.SetLight(LightShape::Sun, {}, { 0.0, 0.0, -1.0 }, 0.0, { irradiance, irradiance });
    scene.SetMedium({ 0.5, 0.2 }, { 0.1, 1.0 }, place({ 0.0, -1.0, 0.0 }), place({ S, 1.0, 1.0 }));
    for (const double* disc : discs)
    {
      scene.AddDisc(place({ disc[0], disc[1], 1.5 }), disc[2], { 0.0, 0.0, -1.0 }, 0.0);
    }
    scene.Eye = LookAt(place({ -1.0, 0.0, 0.5 }), place({ 1.0, 0.0, 0.5 }), 0.3, true);
    scene.SetSize(5, 5);
    scene.GridOptions.Dimensions = { 129, 65, 5 };
    scene.GridOptions.BrickParts = 4;
    int shadowed = 0;
    ExpectEveryMode(scene,
      [&](const Ray& ray, std::size_t k)
      {
        const Vector3 at = ray.Origin - place({});
        std::vector<std::pair<double, double>> dark;
        for (const double* disc : discs)
        {
          const double y = at.Y - disc[1];
          const double half = std::sqrt(std::max(disc[2] * disc[2] - y * y, 0.0));
          if (half > 0.0)
          {
            dark.push_back({ disc[0] - half, disc[0] + half });
          }
        }
        shadowed += static_cast<int>(dark.size());
        return closedforms::SlabRadiance(
          scene.Fog.SigmaS[k], scene.Fog.SigmaS[k] + scene.Fog.SigmaA[k], irradiance, at.Z, S, dark);
      });
    EXPECT_GT(shadowed, 2 * 25) << "of two discs, 25 pixels and 2 wavelengths";
  }
}

TEST(ScatteringModes, SolidAngleOfADisc)
{
  const double R = 0.5;
  for (const Placement& place : Placements())
  {
    for (const double h : { 0.1, 0.5, 1.0, 4.0 })
    {
      const double side = 0.002 * place.Scale;
      const Vector3 at = place({ 0.0, -h, 0.0 });
      const Vector3 half{ 0.5 * side, 0.5 * side, 0.5 * side };
      ImageTestScene scene;
      scene.SetLight(LightShape::Disc, place({}), { 0.0, -1.0, 0.0 }, R * place.Scale, { 2.0 });
      scene.SetMedium({ 0.01 }, { 0.0 }, at - half, at + half);
      scene.AddNothing();
      scene.Eye = LookAt(at - Vector3{ place.Scale, 0.0, 0.0 }, at, 1e-6 * place.Scale, true);
      scene.SetSize(1, 1);
      scene.Options.NumberOfLightSamples = 64;
      scene.GridOptions.Dimensions = { 3, 3, 3 };
      SCOPED_TRACE(std::string(place.Name) + ", h " + std::to_string(h));
      ExpectEveryMode(scene,
        [&](const Ray&, std::size_t)
        { return 0.01 * side * 2.0 * closedforms::DiscSolidAngle(R, h) / (4.0 * closedforms::Pi); });
    }
  }
}

TEST(ScatteringModes, RayUpToADisc)
{
  // Along the axis up to the light itself, which touches the medium.
  const double R = 0.5;
  const double H = 3.0;
  const double sigma = 1e-5;
  ImageTestScene scene;
  scene.SetLight(LightShape::Disc, {}, { 0.0, -1.0, 0.0 }, R, { 1.0 });
  scene.SetMedium({ sigma }, { 0.0 }, { -1.0, -H, -1.0 }, { 1.0, 0.0, 1.0 });
  scene.AddNothing();
  scene.Eye = LookAt({ 0.0, -H - 1.0, 0.0 }, {}, 1e-6, true);
  scene.SetSize(1, 1);
  scene.GridOptions.Dimensions = { 9, 9, 9 };
  ExpectEveryMode(
    scene, [&](const Ray&, std::size_t) { return 0.5 * sigma * (H - std::hypot(H, R) + R); });
}

TEST(ScatteringModes, AxisBehindADiscUnderADisc)
{
  // On the axis of two discs the light's hidden part is a disc too: what is seen is a difference of solid angles.
  const double R = 0.3;
  const double r = 0.2;
  const double L = 3.0;
  const double end = 15.0;
  const double sigma = 1e-4;
  ImageTestScene scene;
  scene.SetLight(LightShape::Disc, {}, { 0.0, 0.0, 1.0 }, R, { 2.0 });
  scene.SetMedium({ sigma }, { 0.0 }, { -1.0, -1.0, L + 1.0 }, { 1.0, 1.0, end });
  scene.AddDisc({ 0.0, 0.0, L }, r, { 0.0, 0.0, 1.0 }, closedforms::DiscPenumbraHalfAngle(R, r, L));
  scene.Eye = LookAt({ 0.0, 0.0, end + 1.0 }, {}, 1e-6, true);
  scene.SetSize(1, 1);
  scene.GridOptions.Dimensions = { 9, 9, 65 };
  scene.Options.NumberOfLightSamples = 1024;
  scene.Options.NumberOfSteps = 64;
  scene.GridOptions.NumberOfLightSamples = 256;
  ExpectEveryMode(scene,
    [&](const Ray&, std::size_t)
    {
      return sigma * 2.0 / (4.0 * closedforms::Pi) *
        closedforms::Integrate(
          [&](double z)
          {
            const double image = r * z / (z - L);
            return image < R ? closedforms::DiscSolidAngle(R, z) - closedforms::DiscSolidAngle(image, z) : 0.0;
          },
          L + r * L / (R - r), end);
    });
}

TEST(ScatteringModes, FurnaceOfAllPhaseFunctions)
{
  // Inside a box whose walls all emit, the in-scattered light is the walls' radiance whatever the phase function.
  const double s = 3.0;
  const double sigma = 1e-5;
  ImageTestScene scene;
  scene.Source.Shape = LightShape::Mesh;
  scene.Source.Spectrum = { 2.0 };
  const Vector3 axes[3] = { { s, 0.0, 0.0 }, { 0.0, s, 0.0 }, { 0.0, 0.0, s } };
  for (int wall = 0; wall < 6; ++wall)
  {
    // Wound so that the normals point inward.
    const double side = wall % 2 == 0 ? 1.0 : -1.0;
    const Vector3 n = side * axes[wall / 2];
    const Vector3 u = side * axes[(wall / 2 + 2) % 3];
    const Vector3 v = axes[(wall / 2 + 1) % 3];
    scene.Source.Triangles.push_back({ n - u - v, n + u - v, n + u + v });
    scene.Source.Triangles.push_back({ n - u - v, n + u + v, n - u + v });
  }
  ASSERT_EQ(PrepareLight(scene.Source), nullptr);
  scene.SetMedium({ sigma }, { 0.0 }, { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 });
  scene.AddNothing();
  scene.Eye = LookAt({ -2.0, 0.0, 0.0 }, {}, 0.5, true);
  scene.SetSize(2, 1);
  scene.Options.NumberOfSteps = 32;
  scene.Options.NumberOfLightSamples = 4096;
  scene.GridOptions.Dimensions = { 5, 5, 5 };
  for (const PhaseFunctionKind kind :
    { PhaseFunctionKind::Isotropic, PhaseFunctionKind::HenyeyGreenstein, PhaseFunctionKind::Rayleigh })
  {
    scene.Fog.Phase.Kind = kind;
    scene.Fog.Phase.Asymmetry = 0.5;
    SCOPED_TRACE("phase function " + std::to_string(static_cast<int>(kind)));
    ExpectEveryMode(scene, [&](const Ray&, std::size_t) { return 2.0 * sigma * 2.0; });
  }
}

TEST(ScatteringModes, AnUnoccludedSceneIsTheSameInEveryMode)
{
  ImageTestScene scene;
  scene.SetLight(LightShape::Disc, { 0.0, 5.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.5, { 1.0, 2.0 });
  scene.SetMedium({ 0.1, 0.2 }, { 0.0, 0.1 }, { -2.0, 0.0, -2.0 }, { 2.0, 4.5, 2.0 });
  scene.AddNothing();
  scene.Eye = LookAt({ -6.0, 2.5, 0.0 }, { 0.0, 2.5, 0.0 }, 0.5);
  scene.SetSize(8, 8);
  scene.GridOptions.Dimensions = { 9, 9, 9 };
  const auto smooth = scene.Render(ScatteringMode::Guided);
  for (const ScatteringMode mode : { ScatteringMode::Soft, ScatteringMode::Volume })
  {
    const ScatteringImage image = scene.Render(mode);
    EXPECT_EQ(image.InScattering, smooth.InScattering) << NameOf(mode);
    EXPECT_EQ(image.Transmittance, smooth.Transmittance) << NameOf(mode);
    EXPECT_EQ(image.NumberOfOcclusionRays, 0) << NameOf(mode);
  }
  scene.Options.NumberOfLightSamples = 256;
  const ScatteringImage brute = scene.Render(ScatteringMode::BruteForce);
  for (std::size_t k = 0; k < brute.InScattering.size(); ++k)
  {
    EXPECT_NEAR(smooth.InScattering[k], brute.InScattering[k], Tolerance * brute.InScattering[k]) << "value " << k;
  }
  EXPECT_GT(brute.NumberOfOcclusionRays, 0);
  for (const ScatteringMode mode : { ScatteringMode::Medium, ScatteringMode::Fast })
  {
    const ScatteringImage image = scene.Render(mode);
    EXPECT_EQ(image.InScattering, brute.InScattering) << NameOf(mode);
    EXPECT_EQ(image.Transmittance, brute.Transmittance) << NameOf(mode);
    EXPECT_EQ(image.NumberOfOcclusionRays, 0) << NameOf(mode);
  }
}

TEST(ScatteringModes, FarVertexAndSunCastTheSameHardShadow)
{
  const double far = 1e6;
  const double irradiance = 2.0;
  Light lamp;
  lamp.Shape = LightShape::Mesh;
  lamp.Spectrum = { irradiance * far * far };
  lamp.Vertices = { { 0.0, far, 0.0 } };
  const Light vertex = Prepared(lamp);
  const Light sun = SunLight({ 0.0, -1.0, 0.0 }, 0.0, { irradiance });

  ImageTestScene scene;
  scene.Mesh.AddSheet({ -0.5, 2.0, -0.7 }, { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.4 });
  const OccluderScene occluders(scene.Mesh.View());
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
      EXPECT_EQ(occluders.Occluded(x, sample.Direction, 0.0, sample.Distance) ? 0.0 : 1.0, expected);
    }
    blocked += expected == 0.0;
  }
  EXPECT_GT(blocked, 200);

  scene.SetMedium({ 0.1 }, { 0.05 }, { -1.0, 0.0, -1.0 }, { 1.0, 1.9, 1.0 });
  scene.Eye = LookAt({ -6.0, 1.5, 0.0 }, { 0.0, 1.0, 0.0 }, 0.3);
  scene.SetSize(16, 16);
  scene.Source = vertex;
  const ScatteringImage ofVertex = scene.Render(ScatteringMode::BruteForce);
  scene.Source = sun;
  const ScatteringImage ofSun = scene.Render(ScatteringMode::BruteForce);
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < ofSun.InScattering.size(); ++k)
  {
    difference += std::fabs(static_cast<double>(ofVertex.InScattering[k]) - ofSun.InScattering[k]);
    sum += ofSun.InScattering[k];
  }
  EXPECT_LT(difference, 1e-4 * sum);
}
