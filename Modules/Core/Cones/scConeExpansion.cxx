// SPDX-License-Identifier: BSD-3-Clause
#include "scConeExpansion.h"

#include "scBasePartition.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
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
  cone.HalfAngle = std::clamp(options.ExpansionFraction * outer, -LargestHalfAngle, LargestHalfAngle);
}

} // namespace shadowcones
