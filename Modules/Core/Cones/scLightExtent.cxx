// SPDX-License-Identifier: BSD-3-Clause
#include "scLightExtent.h"

#include "scCone.h"
#include "scConstants.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

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
  extent.Extremes = LightHull(light);
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
    outer = std::min(light.Radius + turn, LargestHalfAngle);
    inner = -outer;
    return;
  }
  if (light.Extremes.empty())
  {
    // Tangents to the sphere from the two points of the base's rim in the plane of axis and sphere.
    const Vector3 offset = light.Center - center;
    const double height = -Dot(offset, axis);
    const double lateral = Length(offset + height * axis);
    const auto spread = [&](double across)
    {
      const double distance = std::hypot(across, height);
      return light.Radius < distance ? std::asin(light.Radius / distance) : Pi;
    };
    outer = std::atan2(baseRadius + lateral, height) + spread(baseRadius + lateral);
    inner = std::atan2(baseRadius - lateral, height) - spread(baseRadius - lateral);
    outer = std::min(outer, LargestHalfAngle);
    inner = std::clamp(inner, -LargestHalfAngle, LargestHalfAngle);
    return;
  }
  outer = -LargestHalfAngle;
  inner = LargestHalfAngle;
  for (const Vector3& point : light.Extremes)
  {
    const Vector3 offset = point - center;
    const double height = -Dot(offset, axis);
    const double lateral = Length(offset + height * axis);
    const double distance = std::max(height, 1e-12 * (lateral + baseRadius));
    outer = std::max(outer, std::atan2(baseRadius + lateral, distance));
    inner = std::min(inner, std::atan2(baseRadius - lateral, distance));
  }
  outer = std::min(outer, LargestHalfAngle);
  inner = std::max(inner, -LargestHalfAngle);
}

} // namespace shadowcones
