// SPDX-License-Identifier: BSD-3-Clause
#include "scLampPlane.h"

#include <algorithm>

namespace shadowcones
{

FlatFace FlatFaceOf(const Light& light)
{
  FlatFace face;
  if (light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle)
  {
    face = { true, light.Center, light.Normal, light.Radius };
    if (light.Shape == LightShape::Rectangle)
    {
      face.Radius = std::max(Length(light.AxisU + light.AxisV), Length(light.AxisU - light.AxisV));
    }
    return face;
  }
  if (light.Shape != LightShape::Mesh || light.Triangles.empty())
  {
    return face;
  }
  LightBoundingSphere(light, face.Center, face.Radius);
  Vector3 sum;
  double area = 0.0;
  for (const auto& t : light.Triangles)
  {
    const Vector3 normal = Cross(t[1] - t[0], t[2] - t[0]);
    sum += normal;
    area += Length(normal);
  }
  // Triangles that face other ways take from the sum.
  if (!(Length(sum) > 0.999 * area))
  {
    return face;
  }
  face.Normal = Normalized(sum);
  const Vector3 corner = light.Triangles[0][0];
  face.Center = face.Center - Dot(face.Center - corner, face.Normal) * face.Normal;
  face.IsFlat = std::all_of(light.Triangles.begin(), light.Triangles.end(),
    [&face](const std::array<Vector3, 3>& t)
    {
      return std::all_of(t.begin(), t.end(),
        [&face](const Vector3& p)
        { return std::fabs(Dot(p - face.Center, face.Normal)) <= 2.0 * FlushTolerance(face, p); });
    });
  return face;
}

} // namespace shadowcones
