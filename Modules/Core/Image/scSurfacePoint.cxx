// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfacePoint.h"

#include "scConstants.h"
#include "scTriangleReflectance.h"

#include <algorithm>

namespace shadowcones
{

SurfacePoints::SurfacePoints(
  const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , OpticalDepth(scene.Medium)
{
}

void SurfacePoints::Find(const Ray& ray, const PrimaryHit& hit, SurfacePoint& point) const
{
  point.Facet = NormalTowards(this->Scene.Occluders, ray, hit);
  point.Normal = point.Facet;
  point.Position = ray.Origin + hit.T * ray.Direction;
  if (!this->Options.SurfaceNormals.empty())
  {
    this->Smooth(hit.Triangle, point);
  }
  point.Position = point.Position + RoundingAlong(ray.Origin, hit.T) * point.Facet;
  point.Inside = this->Scene.Medium.Bounds.Contains(point.Position);

  const double depth = this->OpticalDepth.TowardsFromOutside(ray.Origin, ray.Direction, hit.T);
  point.Throughput.resize(this->Groups.GroupOf.size());
  for (std::size_t k = 0; k < point.Throughput.size(); ++k)
  {
    const double sigmaT = this->Groups.SigmaT[static_cast<std::size_t>(this->Groups.GroupOf[k])];
    const double reflectance = TriangleReflectance(this->Options.SurfaceReflectance,
      this->Options.ReflectanceComponents, this->Options.Reflectance, hit.Triangle, k);
    point.Throughput[k] = reflectance / Pi * TransmittanceOver(sigmaT, depth);
  }
}

void SurfacePoints::Smooth(vtkIdType triangle, SurfacePoint& point) const
{
  const TriangleMeshView& mesh = this->Scene.Occluders.Mesh();
  Vector3 corners[3];
  Vector3 normals[3];
  double side = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const vtkIdType id = mesh.Triangles[3 * triangle + c];
    const float* values = this->Options.SurfaceNormals.data() + 3 * id;
    const Vector3 given{ values[0], values[1], values[2] };
    const double length = Length(given);
    corners[c] = mesh.Point(id);
    normals[c] = length > 0.0 ? (1.0 / length) * given : Vector3{};
    side += Dot(normals[c], point.Facet);
  }
  const double sign = side < 0.0 ? -1.0 : 1.0;
  const Vector3 doubled = Cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double squared = Dot(doubled, doubled);
  if (!(squared > 0.0))
  {
    return;
  }
  Vector3 normal;
  Vector3 lift;
  for (int c = 0; c < 3; ++c)
  {
    const Vector3 across = Cross(corners[(c + 1) % 3] - point.Position, corners[(c + 2) % 3] - point.Position);
    const double weight = std::clamp(Dot(across, doubled) / squared, 0.0, 1.0);
    const double below = std::min(sign * Dot(point.Position - corners[c], normals[c]), 0.0);
    normal = normal + weight * sign * normals[c];
    lift = lift - weight * below * sign * normals[c];
  }
  const double length = Length(normal);
  if (length > 0.0 && Dot(normal, point.Facet) > 0.0)
  {
    point.Normal = (1.0 / length) * normal;
    point.Position = point.Position + lift;
  }
}

} // namespace shadowcones
