// SPDX-License-Identifier: BSD-3-Clause
#include "scConeExpansion.h"

#include "scBasePartition.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
constexpr double pi = 3.14159265358979323846;
/// Half angles stay below this (89.4 degrees), so that tan() is finite.
constexpr double largestHalfAngle = 1.56;
/// A disc's rim as a polygon around it.
constexpr int rimPoints = 32;
/// Meshes with more vertices are taken as their bounding sphere.
constexpr std::size_t largestHull = 256;

Vector3 DirectionOf(const ShadowVectorView& vectors, vtkIdType id)
{
  const float* d = vectors.Directions + 3 * id;
  return Normalized({ d[0], d[1], d[2] });
}

/// Largest angle between a member's direction and their mean.
double MaximumDeviation(const ShadowVectorView& vectors, const std::vector<vtkIdType>& members, const Vector3& mean)
{
  double largest = 0.0;
  for (const vtkIdType id : members)
  {
    const Vector3 d = DirectionOf(vectors, id);
    largest = std::max(largest, std::atan2(Length(Cross(d, mean)), Dot(d, mean)));
  }
  return largest;
}

/// Angle by which the disc of the vectors' ends, one base radius ahead, is larger or (negative) smaller than the base.
double RadiusRatioAngle(
  const ShadowVectorView& vectors, const std::vector<vtkIdType>& members, const Cone& cone)
{
  const double length = cone.BaseRadius;
  if (!(length > 0.0))
  {
    return 0.0;
  }
  double base = 0.0;
  double end = 0.0;
  for (const vtkIdType id : members)
  {
    const double* p = vectors.Points + 3 * id;
    const Vector3 start = Vector3{ p[0], p[1], p[2] } - cone.Center;
    const Vector3 d = DirectionOf(vectors, id);
    const double slope = std::max(Dot(d, cone.Axis), 1e-3);
    const Vector3 lateral = start - Dot(start, cone.Axis) * cone.Axis;
    const Vector3 ahead = lateral + (length / slope) * (d - Dot(d, cone.Axis) * cone.Axis);
    base = std::max(base, Length(lateral));
    end = std::max(end, Length(ahead));
  }
  return std::atan2(end - base, length);
}
} // anonymous namespace

LightExtent LightExtentOf(const Light& light)
{
  LightExtent extent;
  extent.AtInfinity = IsAtInfinity(light);
  if (extent.AtInfinity)
  {
    extent.Radius = light.Radius;
    extent.Center = light.Normal;
    return extent;
  }
  LightBoundingSphere(light, extent.Center, extent.Radius);
  if (light.Shape == LightShape::Disc)
  {
    const Frame frame = FrameAround(light.Normal);
    const double radius = light.Radius / std::cos(pi / rimPoints);
    for (int i = 0; i < rimPoints; ++i)
    {
      const double angle = 2.0 * pi * i / rimPoints;
      extent.Extremes.push_back(
        light.Center + radius * std::cos(angle) * frame.U + radius * std::sin(angle) * frame.V);
    }
  }
  else if (light.Shape == LightShape::Rectangle)
  {
    for (const double u : { -1.0, 1.0 })
    {
      for (const double v : { -1.0, 1.0 })
      {
        extent.Extremes.push_back(light.Center + u * light.AxisU + v * light.AxisV);
      }
    }
  }
  else if (light.Shape == LightShape::Mesh && light.Triangles.empty() && light.Vertices.size() <= largestHull)
  {
    extent.Extremes = light.Vertices;
  }
  else if (light.Shape == LightShape::Mesh && 3 * light.Triangles.size() <= largestHull)
  {
    for (const auto& triangle : light.Triangles)
    {
      extent.Extremes.insert(extent.Extremes.end(), triangle.begin(), triangle.end());
    }
  }
  return extent;
}

LightExtent LightExtentOf(const double* emissionPoints, vtkIdType count)
{
  LightExtent extent;
  Box bounds;
  for (vtkIdType i = 0; i < count; ++i)
  {
    bounds.Add(Vector3{ emissionPoints[3 * i], emissionPoints[3 * i + 1], emissionPoints[3 * i + 2] });
  }
  if (bounds.Empty())
  {
    return extent;
  }
  extent.Center = bounds.Center();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vector3 p{ emissionPoints[3 * i], emissionPoints[3 * i + 1], emissionPoints[3 * i + 2] };
    extent.Radius = std::max(extent.Radius, Length(p - extent.Center));
  }
  return extent;
}

void PenumbraAngles(
  const LightExtent& light, const Vector3& center, const Vector3& axis, double baseRadius, double& outer, double& inner)
{
  if (light.AtInfinity)
  {
    // The mean of a few vectors is not quite the way from the middle of the Sun.
    const double turn = std::atan2(Length(Cross(axis, light.Center)), Dot(axis, light.Center));
    outer = std::min(light.Radius + turn, largestHalfAngle);
    inner = -outer;
    return;
  }
  if (light.Extremes.empty())
  {
    // Tangents to the sphere from the two points of the base's rim in the plane of axis and sphere.
    const Vector3 offset = light.Center - center;
    const double height = -Dot(offset, axis);
    const double lateral = Length(offset + height * axis);
    const auto spread = [&](double across) {
      const double distance = std::hypot(across, height);
      return light.Radius < distance ? std::asin(light.Radius / distance) : pi;
    };
    outer = std::atan2(baseRadius + lateral, height) + spread(baseRadius + lateral);
    inner = std::atan2(baseRadius - lateral, height) - spread(baseRadius - lateral);
    outer = std::min(outer, largestHalfAngle);
    inner = std::clamp(inner, -largestHalfAngle, largestHalfAngle);
    return;
  }
  outer = -largestHalfAngle;
  inner = largestHalfAngle;
  for (const Vector3& point : light.Extremes)
  {
    const Vector3 offset = point - center;
    const double height = -Dot(offset, axis);
    const double lateral = Length(offset + height * axis);
    const double distance = std::max(height, 1e-12 * (lateral + baseRadius));
    outer = std::max(outer, std::atan2(baseRadius + lateral, distance));
    inner = std::min(inner, std::atan2(baseRadius - lateral, distance));
  }
  outer = std::min(outer, largestHalfAngle);
  inner = std::max(inner, -largestHalfAngle);
}

void ExpandCone(const ShadowVectorView& vectors, const std::vector<vtkIdType>& members, const LightExtent& light,
  const ConeSetOptions& options, double planeRadius, Cone& cone)
{
  cone.Axis = MeanDirection(vectors, members);
  const double cosine = std::max(0.0, Dot(cone.Axis, cone.Normal));
  cone.BaseRadius = options.RadiusScale * (options.CosineCorrection ? planeRadius * cosine : planeRadius);

  double outer = 0.0;
  PenumbraAngles(light, cone.Center, cone.Axis, cone.BaseRadius, outer, cone.InnerHalfAngle);
  switch (options.Expansion)
  {
    case ConeExpansion::MaximumDeviation:
      outer = MaximumDeviation(vectors, members, cone.Axis);
      break;
    case ConeExpansion::RadiusRatio:
      outer = RadiusRatioAngle(vectors, members, cone);
      break;
    case ConeExpansion::LightGeometry:
      break;
  }
  cone.HalfAngle = std::clamp(options.ExpansionFraction * outer, -largestHalfAngle, largestHalfAngle);
}

} // namespace shadowcones
