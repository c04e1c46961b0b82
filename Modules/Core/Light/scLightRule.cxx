// SPDX-License-Identifier: BSD-3-Clause
#include "scLightRule.h"

#include "scGaussLegendre.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
constexpr double twoPi = 6.28318530717958647692;
constexpr int ringsOfLevel[LightRule::NumberOfLevels] = { 2, 3, 5, 8, 16 }; // see LargestNumberOfRings
constexpr int sideOfLevel[LightRule::NumberOfLevels] = { 4, 6, 10, 16, 32 };
/// Radians of a Sun that takes fewer.
constexpr double narrow = 0.02;
constexpr int narrowRingsOfLevel[LightRule::NumberOfLevels] = { 1, 2, 3, 5, 8 };
/// Point lights are taken one by one up to so many.
constexpr std::size_t largestNumberOfVertices = 1024;

/// Rules over the area are for points at least this share of the light's radius away.
constexpr double nearFraction = 0.4;

/// A ring's spokes are turned by half a step against the next ring's.
double SpokeAngle(int ring, int spoke, int spokes)
{
  return twoPi * (spoke + 0.5 * (ring % 2) + 0.25) / spokes;
}
} // anonymous namespace

LightRule::LightRule(const Light& light, int level)
  : Lamp(light)
{
  const int rings = ringsOfLevel[level];
  switch (light.Shape)
  {
    case LightShape::Disc:
      this->AddDisc(rings);
      break;
    case LightShape::Rectangle:
      this->AddRectangle(sideOfLevel[level]);
      break;
    case LightShape::Sphere:
      this->AddCone(light.Radius > 0.0 ? rings : 0);
      break;
    case LightShape::Sun:
      // Over a narrow cone everything is all but linear.
      this->AddCone(light.Radius <= 0.0 ? 0 : light.Radius < narrow ? narrowRingsOfLevel[level] : rings);
      this->AddParallel();
      break;
    case LightShape::Point:
      this->AddVertices(1, level);
      break;
    case LightShape::Mesh:
      if (light.Triangles.empty())
      {
        this->AddVertices(light.Vertices.size(), level);
        break;
      }
      this->Mesh.emplace(light, level);
      this->Points = this->Mesh->Points();
      break;
  }
  this->AddOffsets();
}

void LightRule::SetNear(double radius)
{
  this->HasNear = true;
  this->Radius = radius;
  this->Near = nearFraction * radius;
  this->BesideSquared = (1.0 + nearFraction) * (1.0 + nearFraction) * radius * radius;
}

void LightRule::AddOffsets()
{
  double radius = 0.0;
  LightBoundingSphere(this->Lamp, this->Middle, radius);
  for (int component = 0; component < 7; ++component)
  {
    for (const LightPoint& lightPoint : this->Points)
    {
      const Vector3 offset = lightPoint.Position - this->Middle;
      this->Offsets.push_back(static_cast<float>(
        component < 3 ? offset[component] : (component < 6 ? lightPoint.Normal[component - 3] : lightPoint.Area)));
    }
  }
}

void LightRule::AddDisc(int rings)
{
  const GaussLegendre rule(rings);
  const Light& light = this->Lamp;
  const Frame frame = FrameAround(light.Normal);
  const int spokes = 4 * rings;
  const double area = LightArea(light);
  this->Lines = rule;
  this->SetNear(light.Radius);
  for (int ring = 0; ring < rings; ++ring)
  {
    const double radius = light.Radius * std::sqrt(rule.Nodes[ring]);
    for (int spoke = 0; spoke < spokes; ++spoke)
    {
      const double angle = SpokeAngle(ring, spoke, spokes);
      this->Points.push_back({ light.Center + radius * (std::cos(angle) * frame.U + std::sin(angle) * frame.V),
        light.Normal, area * rule.Weights[ring] / spokes });
    }
  }
}

void LightRule::AddRectangle(int side)
{
  const GaussLegendre rule(side);
  const Light& light = this->Lamp;
  const double area = LightArea(light);
  this->Lines = rule;
  this->SetNear(std::sqrt(Dot(light.AxisU, light.AxisU) + Dot(light.AxisV, light.AxisV)));
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const double weight = rule.Weights[i] * rule.Weights[j];
      this->Points.push_back(
        { light.Center + (2.0 * rule.Nodes[i] - 1.0) * light.AxisU + (2.0 * rule.Nodes[j] - 1.0) * light.AxisV,
          light.Normal, area * weight });
    }
  }
}

void LightRule::AddCone(int rings)
{
  if (rings == 0)
  {
    this->Nodes.push_back({ 0.5, 0.5, 1.0 });
    return;
  }
  // Cones are sampled through the concentric map: its inverse takes the rings' points back to the square.
  Light disc;
  disc.Radius = 1.0;
  const Frame frame = FrameAround(disc.Normal);
  const GaussLegendre rule(rings);
  const int spokes = 4 * rings;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double radius = std::sqrt(rule.Nodes[ring]);
    for (int spoke = 0; spoke < spokes; ++spoke)
    {
      const double angle = SpokeAngle(ring, spoke, spokes);
      const auto uv = InvertLightArea(disc, radius * (std::cos(angle) * frame.U + std::sin(angle) * frame.V));
      this->Nodes.push_back({ uv[0], uv[1], rule.Weights[ring] / spokes });
    }
  }
}

void LightRule::AddParallel()
{
  for (const Node& node : this->Nodes)
  {
    IncidentSample sample = SampleIncidentLight(this->Lamp, {}, node.U, node.V, LightSampling::SolidAngle);
    sample.Weight *= node.Weight;
    this->Parallel.push_back(sample);
  }
}

void LightRule::AddVertices(std::size_t vertices, int level)
{
  const bool each = vertices <= largestNumberOfVertices;
  const std::size_t count = each ? vertices : static_cast<std::size_t>(256 << level);
  for (std::size_t k = 0; k < count; ++k)
  {
    this->Nodes.push_back({ (k + 0.5) / count, 0.5, 1.0 / count });
  }
}

} // namespace shadowcones
