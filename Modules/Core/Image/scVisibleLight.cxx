// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibleLight.h"

#include "scConstants.h"

#include <algorithm>

namespace shadowcones
{

VisibleLight::VisibleLight(const Light& light)
  : Lamp(light)
{
  if (light.Shape == LightShape::Sun)
  {
    // The spectrum is an irradiance; spread over the solid angle 2 pi (1 - cos r) it is a radiance.
    const double s = std::sin(0.5 * light.Radius);
    const double solidAngle = FourPi * s * s;
    this->Scale = solidAngle > 0.0 ? 1.0 / solidAngle : 0.0;
  }
  if (light.Shape == LightShape::Mesh && !light.Triangles.empty())
  {
    for (const auto& triangle : light.Triangles)
    {
      for (const Vector3& corner : triangle)
      {
        this->Triangles.push_back(static_cast<vtkIdType>(this->Triangles.size()));
        this->Points.insert(this->Points.end(), { corner.X, corner.Y, corner.Z });
      }
    }
    TriangleMeshView view;
    view.Points = this->Points.data();
    view.NumberOfPoints = static_cast<vtkIdType>(this->Points.size() / 3);
    view.Triangles = this->Triangles.data();
    view.NumberOfTriangles = static_cast<vtkIdType>(light.Triangles.size());
    this->Faces = std::make_unique<OccluderScene>(view);
  }
}

bool VisibleLight::Intersect(
  const Vector3& origin, const Vector3& direction, double tMax, double& t, double& scale) const
{
  scale = this->Scale;
  return this->IntersectShape(origin, direction, tMax, t) && t > 0.0 && (t < tMax || t == HUGE_VAL);
}

bool VisibleLight::IntersectShape(const Vector3& origin, const Vector3& direction, double tMax, double& t) const
{
  const Light& light = this->Lamp;
  switch (light.Shape)
  {
    case LightShape::Disc:
    case LightShape::Rectangle:
    {
      const double approach = -Dot(direction, light.Normal);
      if (approach <= 0.0)
      {
        return false;
      }
      t = Dot(origin - light.Center, light.Normal) / approach;
      const Vector3 p = origin + t * direction - light.Center;
      if (light.Shape == LightShape::Disc)
      {
        return Dot(p, p) <= light.Radius * light.Radius;
      }
      return std::fabs(Dot(p, light.AxisU)) <= Dot(light.AxisU, light.AxisU) &&
        std::fabs(Dot(p, light.AxisV)) <= Dot(light.AxisV, light.AxisV);
    }
    case LightShape::Sphere:
    {
      const Vector3 q = origin - light.Center;
      const double b = Dot(q, direction);
      // The distance of the ray from the centre, by a vector: exact also for a small sphere far away.
      const Vector3 nearest = q - b * direction;
      const double h = light.Radius * light.Radius - Dot(nearest, nearest);
      if (h < 0.0)
      {
        return false;
      }
      t = -b - std::sqrt(h);
      return true;
    }
    case LightShape::Sun:
      t = HUGE_VAL;
      return tMax == HUGE_VAL && this->Scale > 0.0 &&
        Length(direction + light.Normal) <= 2.0 * std::sin(0.5 * light.Radius);
    case LightShape::Mesh:
    {
      if (!this->Faces)
      {
        return false;
      }
      thread_local std::vector<RayHit> hits;
      this->Faces->IntersectAll(origin, direction, 0.0, tMax, hits);
      const auto front =
        std::find_if(hits.begin(), hits.end(), [](const RayHit& hit) { return hit.FrontFacing; });
      if (front == hits.end())
      {
        return false;
      }
      t = front->T;
      return true;
    }
    case LightShape::Point:
      break;
  }
  return false;
}

} // namespace shadowcones
