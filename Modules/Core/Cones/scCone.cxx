// SPDX-License-Identifier: BSD-3-Clause
#include "scCone.h"

#include <algorithm>

namespace shadowcones
{

bool ConeContains(const Cone& cone, const Vector3& point, double length)
{
  const Vector3 offset = point - cone.Center;
  const double h = Dot(offset, cone.Axis);
  const double radius = cone.BaseRadius + h * std::tan(cone.HalfAngle);
  const Vector3 lateral = offset - h * cone.Axis;
  return h >= 0.0 && h <= length && radius >= 0.0 && Dot(lateral, lateral) <= radius * radius;
}

Cone ConeAroundBox(const Box& box)
{
  Cone cone;
  cone.Axis = { 0.0, 0.0, 1.0 };
  cone.Normal = cone.Axis;
  const double spare = 0.01 * box.Diagonal() + 1e-6 * std::max(Length(box.Min), Length(box.Max));
  cone.Center = { box.Center().X, box.Center().Y, box.Min.Z - spare };
  cone.BaseRadius = 0.5 * std::hypot(box.Size().X, box.Size().Y) + spare;
  cone.InnerHalfAngle = -1.5;
  return cone;
}

std::vector<Cone> Lengthened(std::vector<Cone> cones)
{
  for (Cone& cone : cones)
  {
    const double before = cone.BaseRadius;
    cone.Center = cone.Center - before * cone.Axis;
    cone.BaseRadius += std::max(0.0, -before * std::tan(cone.HalfAngle));
  }
  return cones;
}

std::vector<std::vector<Cone>> ConesOfLights(const std::vector<Cone>& cones, std::size_t count)
{
  const auto isOfLight = [count](const Cone& cone)
  { return cone.LightId >= 0 && static_cast<std::size_t>(cone.LightId) < count; };
  std::vector<std::size_t> sizes(count, 0);
  for (const Cone& cone : cones)
  {
    if (isOfLight(cone))
    {
      ++sizes[static_cast<std::size_t>(cone.LightId)];
    }
  }
  std::vector<std::vector<Cone>> parts(count);
  for (std::size_t light = 0; light < count; ++light)
  {
    parts[light].reserve(sizes[light]);
  }
  for (const Cone& cone : cones)
  {
    if (isOfLight(cone))
    {
      parts[static_cast<std::size_t>(cone.LightId)].push_back(cone);
    }
  }
  return parts;
}

} // namespace shadowcones
