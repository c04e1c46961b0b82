// SPDX-License-Identifier: BSD-3-Clause
#include "scLightRule.h"

#include "TestLights.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowcones;
using namespace testsupport;

namespace
{
double SumOfWeights(const LightRule& rule, const Vector3& from)
{
  double sum = 0.0;
  rule.ForEach(from,
    [&](const IncidentSample& sample)
    {
      EXPECT_GT(sample.Weight, 0.0);
      EXPECT_GT(sample.Distance, 0.0);
      EXPECT_NEAR(Length(sample.Direction), 1.0, 1e-9);
      sum += sample.Weight;
    });
  return sum;
}

Light RectangleLight()
{
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Normal = { 0.0, -1.0, 0.0 };
  light.AxisU = { 0.4, 0.0, 0.0 };
  light.AxisV = { 0.0, 0.0, 0.3 };
  return Prepared(light);
}
} // namespace

TEST(LightRule, WeightsSumToTheSolidAngle)
{
  const Vector3 down{ 0.0, -1.0, 0.0 };
  for (const Light& light : { DiscLight({}, down, 0.5), RectangleLight(), SphereLight({}, 0.4) })
  {
    for (const Vector3& from : { Vector3{ 0.1, -4.0, 0.2 }, Vector3{ 2.0, -0.7, 0.3 }, Vector3{ 0.2, -0.6, -0.1 } })
    {
      const double expected = LightSolidAngle(light, from);
      ASSERT_GT(expected, 0.0);
      double before = HUGE_VAL;
      for (int level = 0; level < LightRule::NumberOfLevels; ++level)
      {
        const double error = std::fabs(SumOfWeights(LightRule(light, level), from) / expected - 1.0);
        EXPECT_LT(error, before + 1e-6) << "shape " << static_cast<int>(light.Shape) << ", level " << level;
        before = error;
      }
      EXPECT_LT(before, 1e-6) << "shape " << static_cast<int>(light.Shape);
    }
  }
}

TEST(LightRule, PointsAreOneByOne)
{
  const Light bulb = PointLight({ 0.0, 2.0, 0.0 });
  const LightRule point(bulb, 0);
  EXPECT_NEAR(SumOfWeights(point, {}), 0.25, 1e-12);

  Light vertices;
  vertices.Shape = LightShape::Mesh;
  vertices.Vertices = { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 2.0 }, { -4.0, 0.0, 0.0 } };
  const Light prepared = Prepared(vertices);
  const LightRule rule(prepared, 0);
  int count = 0;
  rule.ForEach({}, [&](const IncidentSample&) { ++count; });
  EXPECT_EQ(count, 3);
  EXPECT_NEAR(SumOfWeights(rule, {}), 1.0 + 1.0 / 4.0 + 1.0 / 16.0, 1e-12);
}

TEST(LightRule, ASunHasItsIrradiance)
{
  const Light sharp = SunLight({ 0.0, -1.0, 0.0 }, 0.0);
  const Light soft = SunLight({ 0.0, -1.0, 0.0 }, 0.1);
  for (const Light* sun : { &sharp, &soft })
  {
    EXPECT_NEAR(SumOfWeights(LightRule(*sun, 1), { 3.0, 4.0, 5.0 }), 1.0, 1e-9);
  }
}

TEST(LightRule, NothingComesFromTheBack)
{
  const Light disc = DiscLight({}, { 0.0, -1.0, 0.0 }, 0.5);
  EXPECT_EQ(SumOfWeights(LightRule(disc, 0), { 0.1, 2.0, 0.0 }), 0.0);
  EXPECT_EQ(SumOfWeights(LightRule(disc, 0), { 0.1, 0.01, 0.0 }), 0.0);
}

TEST(LightRule, ADiscHasItsRulesByAreaAndNear)
{
  const Light disc = DiscLight({ 1.0, 2.0, 3.0 }, { 0.0, -1.0, 0.0 }, 0.5);
  const int counts[LightRule::NumberOfLevels] = { 16, 36, 100, 256, 1024 };
  for (int level = 0; level < LightRule::NumberOfLevels; ++level)
  {
    const LightRule rule(disc, level);
    const LightPoints points = rule.AreaPoints();
    EXPECT_EQ(points.Count, counts[level]);
    double area = 0.0;
    for (int k = 0; k < points.Count; ++k)
    {
      area += static_cast<double>(points.Area[k]);
    }
    EXPECT_NEAR(area / LightArea(disc), 1.0, 1e-5);
    EXPECT_TRUE(rule.IsByArea({ 1.0, 1.0, 3.0 }));
    EXPECT_FALSE(rule.IsByArea({ 1.1, 1.99, 3.0 }));
  }
  const Light sphere = SphereLight({}, 0.4);
  EXPECT_FALSE(LightRule(sphere, 0).IsByArea({ 9.0, 9.0, 9.0 }));
}

TEST(LightRule, AMeshIsCoveredByArea)
{
  // Two triangles as one square, 3 above.
  Light mesh;
  mesh.Shape = LightShape::Mesh;
  const Vector3 corners[4] = { { -0.5, 3.0, -0.5 }, { 0.5, 3.0, -0.5 }, { 0.5, 3.0, 0.5 }, { -0.5, 3.0, 0.5 } };
  mesh.Triangles = { { corners[0], corners[1], corners[2] }, { corners[0], corners[2], corners[3] } };
  const Light prepared = Prepared(mesh);
  EXPECT_NEAR(SumOfWeights(LightRule(prepared, 0), {}) / LightSolidAngle(prepared, {}), 1.0, 0.005);
  EXPECT_NEAR(SumOfWeights(LightRule(prepared, 4), {}) / LightSolidAngle(prepared, {}), 1.0, 5e-4);
}

namespace
{
/// A square of side 2 in the plane y = 0 that faces down, cut into columns^2 squares of two triangles each.
Light Panel(int columns)
{
  Light mesh;
  mesh.Shape = LightShape::Mesh;
  const auto corner = [columns](int i, int j)
  { return Vector3{ 2.0 * i / columns - 1.0, 0.0, 2.0 * j / columns - 1.0 }; };
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      mesh.Triangles.push_back({ corner(i, j), corner(i + 1, j), corner(i + 1, j + 1) });
      mesh.Triangles.push_back({ corner(i + 1, j + 1), corner(i, j + 1), corner(i, j) });
    }
  }
  return Prepared(mesh);
}

/// Solid angle of the panel: four rectangles with a corner above the point, each by its closed form.
double PanelSolidAngle(const Vector3& from)
{
  const double h = -from.Y;
  const auto quarter = [h](double a, double b) { return std::atan(a * b / (h * std::sqrt(a * a + b * b + h * h))); };
  return quarter(1.0 - from.X, 1.0 - from.Z) + quarter(1.0 + from.X, 1.0 - from.Z) +
    quarter(1.0 - from.X, 1.0 + from.Z) + quarter(1.0 + from.X, 1.0 + from.Z);
}

/// Its irradiance at a point with a normal that points up, over the radiance: the sum of a vector around its edges
/// (Lambert's formula).
double PanelIrradiance(const Vector3& from)
{
  const Vector3 corners[4] = { { -1.0, 0.0, -1.0 }, { 1.0, 0.0, -1.0 }, { 1.0, 0.0, 1.0 }, { -1.0, 0.0, 1.0 } };
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const Vector3 a = Normalized(corners[k] - from);
    const Vector3 b = Normalized(corners[(k + 1) % 4] - from);
    sum += std::acos(Dot(a, b)) * Normalized(Cross(a, b)).Y;
  }
  return 0.5 * std::fabs(sum);
}
} // namespace

TEST(LightRule, AMeshOfAnyNumberOfTrianglesIsRightAtAnyDistance)
{
  // 2 triangles to 5,000: products of Gauss rules, single points, groups of triangles.
  for (const int columns : { 1, 4, 6, 10, 13, 50 })
  {
    const Light panel = Panel(columns);
    double error[LightRule::NumberOfLevels] = {};
    for (int level = 0; level < LightRule::NumberOfLevels; ++level)
    {
      const LightRule rule(panel, level);
      for (const double height : { 1e-6, 1e-3, 0.02, 0.1, 0.3, 1.0, 4.0 })
      {
        for (const Vector3& foot : { Vector3{ 0.03, 0.0, -0.21 }, Vector3{ 0.999, 0.0, 0.2 }, Vector3{ 0.5, 0.0, 0.5 } })
        {
          const Vector3 from = foot - Vector3{ 0.0, height, 0.0 };
          double solidAngle = 0.0;
          double irradiance = 0.0;
          rule.ForEach(from,
            [&](const IncidentSample& sample)
            {
              solidAngle += sample.Weight;
              irradiance += sample.Weight * sample.Direction.Y;
              // All of the light lies in the plane y = 0.
              EXPECT_NEAR(from.Y + sample.Distance * sample.Direction.Y, 0.0, 1e-9);
            });
          error[level] = std::max({ error[level], std::fabs(solidAngle / PanelSolidAngle(from) - 1.0),
            std::fabs(irradiance / PanelIrradiance(from) - 1.0) });
        }
      }
    }
    EXPECT_LT(error[0], 0.01) << columns;
    EXPECT_LT(error[4], 1e-3) << columns;
  }
}

namespace
{
/// A level of a light's rule as rays use it: with the levels that near points need more.
template <typename Visitor>
void VisitRule(const Light& light, int level, const Vector3& from, Visitor&& visit)
{
  const LightRule rule(light, level);
  const int nearer = std::min(level + rule.LevelsNearer(from), LightRule::NumberOfLevels - 1);
  LightRule(light, nearer).ForEach(from, visit);
}
} // namespace

TEST(LightRule, ADiscHasItsFormFactorAtAnyDistance)
{
  // Of an element parallel to it, at height h and beside its centre: 1/2 (1 - (1 + H^2 - R^2) / sqrt(Z^2 - 4 R^2)) with
  // H = h / beside, R = radius / beside, Z = 1 + H^2 + R^2 (Howell's catalogue of configuration factors, B-13).
  const Light disc = testsupport::DiscLight({}, { 0.0, -1.0, 0.0 }, 1.0);
  double error[LightRule::NumberOfLevels] = {};
  double nearError[LightRule::NumberOfLevels] = {}; // by solid angle
  for (int level = 0; level < LightRule::NumberOfLevels; ++level)
  {
    for (const double h : { 1e-6, 1e-3, 0.02, 0.1, 0.3, 0.39, 0.41, 0.7, 1.0, 4.0 })
    {
      for (const double beside : { 0.03, 0.5, 0.9, 0.999, 1.2 })
      {
        double irradiance = 0.0;
        VisitRule(disc, level, { 0.6 * beside, -h, 0.8 * beside },
          [&](const IncidentSample& sample)
          {
            irradiance += sample.Weight * sample.Direction.Y;
            EXPECT_NEAR(sample.Distance * sample.Direction.Y, h, 1e-9); // all of it lies in the plane y = 0
          });
        // As 2 R^2 H^2 / (root (root + 1 + H^2 - R^2)), without differences of nearly equal numbers beside the disc.
        const double height = h * h / (beside * beside);
        const double radius = 1.0 / (beside * beside);
        const double z = 1.0 + height + radius;
        const double root = std::sqrt(z * z - 4.0 * radius);
        const double sum = 1.0 + height - radius;
        const double factor = sum > 0.0 ? 2.0 * radius * height / (root * (root + sum)) : 0.5 * (1.0 - sum / root);
        const bool byArea = LightRule(disc, level).IsByArea({ 0.6 * beside, -h, 0.8 * beside });
        double& worst = byArea ? error[level] : nearError[level];
        worst = std::max(worst, std::fabs(irradiance / (testsupport::Pi * factor) - 1.0));
      }
    }
  }
  EXPECT_LT(error[0], 0.03);
  EXPECT_LT(error[1], 1e-3);
  EXPECT_LT(error[2], 1e-5);
  EXPECT_LT(nearError[0], 2e-3);
  EXPECT_LT(nearError[1], 1e-4);
}

TEST(LightRule, ARectangleHasItsSolidAngleAndIrradianceAtAnyDistance)
{
  Light square;
  square.Shape = LightShape::Rectangle;
  square.Normal = { 0.0, -1.0, 0.0 };
  square.AxisU = { 1.0, 0.0, 0.0 };
  square.AxisV = { 0.0, 0.0, 1.0 };
  square = testsupport::Prepared(square);
  double error[LightRule::NumberOfLevels] = {};
  for (int level = 0; level < LightRule::NumberOfLevels; ++level)
  {
    for (const double height : { 1e-6, 1e-3, 0.02, 0.1, 0.3, 0.56, 0.57, 1.0, 4.0 })
    {
      for (const Vector3& foot : { Vector3{ 0.03, 0.0, -0.21 }, Vector3{ 0.999, 0.0, 0.2 }, Vector3{ 0.5, 0.0, 0.5 } })
      {
        const Vector3 from = foot - Vector3{ 0.0, height, 0.0 };
        double solidAngle = 0.0;
        double irradiance = 0.0;
        VisitRule(square, level, from,
          [&](const IncidentSample& sample)
          {
            solidAngle += sample.Weight;
            irradiance += sample.Weight * sample.Direction.Y;
          });
        error[level] = std::max({ error[level], std::fabs(solidAngle / PanelSolidAngle(from) - 1.0),
          std::fabs(irradiance / PanelIrradiance(from) - 1.0) });
      }
    }
  }
  EXPECT_LT(error[0], 3e-3);
  EXPECT_LT(error[1], 6e-4);
  EXPECT_LT(error[3], 3e-5);
}

TEST(LightRule, NoTwoLevelsOfAMeshAreTheSame)
{
  for (const int columns : { 1, 2, 4, 5, 6, 8, 10, 11, 12, 16, 20, 25, 40 })
  {
    const Light panel = Panel(columns);
    int before = 0;
    for (int level = 0; level < LightRule::NumberOfLevels; ++level)
    {
      const LightRule rule(panel, level);
      EXPECT_GT(rule.Count(), before) << 2 * columns * columns << " triangles, level " << level;
      before = rule.Count();
      double area = 0.0;
      const LightPoints points = rule.AreaPoints();
      for (int k = 0; k < points.Count; ++k)
      {
        area += static_cast<double>(points.Area[k]);
      }
      EXPECT_NEAR(area, 4.0, 1e-4);
    }
  }
}
