// SPDX-License-Identifier: BSD-3-Clause
#include "ProjectedSolids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace shadowcones
{

//------------------------------------------------------------------------------
ProjectedSolids::ProjectedSolids(const TriangleMeshView& mesh, const Light& light, const Box& bounds, int points)
  : Points(light, points)
{
  const std::vector<bool> closed = ClosedOccluders(mesh);
  for (const Vector3& position : this->Points.Positions)
  {
    auto solid = std::make_unique<Solid>();
    Extrude(mesh, closed, position, this->Points.Parallel, bounds, *solid);
    solid->Search = std::make_unique<OccluderScene>(solid->View());
    this->Solids.push_back(std::move(solid));
  }
}

//------------------------------------------------------------------------------
TriangleMeshView ProjectedSolids::Solid::View() const
{
  TriangleMeshView view;
  view.Points = this->Points.data();
  view.NumberOfPoints = static_cast<vtkIdType>(this->Points.size() / 3);
  view.Triangles = this->Triangles.data();
  view.NumberOfTriangles = static_cast<vtkIdType>(this->Triangles.size() / 3);
  return view;
}

//------------------------------------------------------------------------------
void ProjectedSolids::Extrude(const TriangleMeshView& mesh, const std::vector<bool>& closed, const Vector3& light,
  bool parallel, const Box& bounds, Solid& solid)
{
  // The image of every point is beyond the medium: the light's own picture of the mesh, so much larger.
  Box all = bounds;
  all.Add(MeshBounds(mesh));
  double nearest = HUGE_VAL;
  for (vtkIdType k = 0; !parallel && k < mesh.NumberOfPoints; ++k)
  {
    nearest = std::min(nearest, Length(mesh.Point(k) - light));
  }
  if (!(nearest > 1e-6 * all.Diagonal()))
  {
    throw std::runtime_error("The light touches the mesh: its shadow has no solid.");
  }
  const double scale = parallel ? 0.0 : 1.01 * (Length(all.Center() - light) + all.Diagonal()) / nearest;
  const auto image = [&](const Vector3& p)
  { return parallel ? p - (1.01 * all.Diagonal()) * light : light + scale * (p - light); };

  std::vector<std::array<vtkIdType, 3>> faces;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges; // low, high: how often more it is run up than down
  for (vtkIdType k = 0; k < mesh.NumberOfTriangles; ++k)
  {
    std::array<vtkIdType, 3> face{ mesh.Triangles[3 * k], mesh.Triangles[3 * k + 1], mesh.Triangles[3 * k + 2] };
    const Vector3 a = mesh.Point(face[0]);
    const double side = Dot(Cross(mesh.Point(face[1]) - a, mesh.Point(face[2]) - a), parallel ? light : light - a);
    if (side == 0.0 || (side < 0.0 && closed[static_cast<std::size_t>(k)]))
    {
      continue;
    }
    if (side < 0.0)
    {
      std::swap(face[1], face[2]);
    }
    faces.push_back(face);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const vtkIdType p = face[c];
      const vtkIdType q = face[(c + 1) % 3];
      edges[{ std::min(p, q), std::max(p, q) }] += p < q ? 1 : -1;
    }
  }
  for (const bool far : { false, true })
  {
    for (vtkIdType k = 0; k < mesh.NumberOfPoints; ++k)
    {
      const Vector3 p = far ? image(mesh.Point(k)) : mesh.Point(k);
      solid.Points.insert(solid.Points.end(), { p.X, p.Y, p.Z });
    }
  }
  const vtkIdType n = mesh.NumberOfPoints;
  const auto add = [&solid](vtkIdType a, vtkIdType b, vtkIdType c) { solid.Triangles.insert(solid.Triangles.end(), { a, b, c }); };
  for (const std::array<vtkIdType, 3>& face : faces)
  {
    add(face[0], face[1], face[2]);
    add(n + face[0], n + face[2], n + face[1]);
  }
  for (const auto& [edge, times] : edges)
  {
    const auto [p, q] = times > 0 ? std::pair(edge.first, edge.second) : std::pair(edge.second, edge.first);
    for (int k = 0; k < std::abs(times); ++k)
    {
      add(q, p, n + p);
      add(q, n + p, n + q);
    }
  }
}

//------------------------------------------------------------------------------
void ProjectedSolids::AddSolid(
  std::size_t point, const RivalRay& ray, std::vector<double>& blocked, std::vector<double>& all) const
{
  thread_local std::vector<RayHit> hits;
  this->Solids[point]->Search->IntersectAll(ray.Line.Origin, ray.Line.Direction, 0.0, HUGE_VAL, hits);
  const auto weightAt = [&](std::size_t k)
  { return this->Points.Weight(this->Points.Towards(static_cast<int>(point), ray.Place(k))); };
  for (std::size_t k = 0; k < ray.Count(); ++k)
  {
    all[k] += weightAt(k);
  }
  std::size_t cell = ray.Count();
  const auto cover = [&](double begin, double end)
  {
    while (cell > 0 && ray.Cuts[cell - 1] >= end)
    {
      --cell;
    }
    for (std::size_t k = cell; k > 0 && ray.Cuts[k] > begin; --k)
    {
      const double length = std::min(ray.Cuts[k], end) - std::max(ray.Cuts[k - 1], begin);
      blocked[k - 1] += weightAt(k - 1) * length / (ray.Cuts[k] - ray.Cuts[k - 1]);
    }
  };
  // Beyond the last hit the ray is outside of all parts: from there back, an exit is an entry.
  int depth = 0;
  double end = 0.0;
  for (auto hit = hits.rbegin(); hit != hits.rend(); ++hit)
  {
    const int before = depth;
    depth += hit->FrontFacing ? -1 : 1;
    if (before <= 0 && depth > 0)
    {
      end = hit->T;
    }
    else if (before > 0 && depth <= 0)
    {
      cover(hit->T, end);
    }
  }
  if (depth > 0)
  {
    cover(0.0, end);
  }
}

//------------------------------------------------------------------------------
void ProjectedSolids::BlockedAlong(const RivalRay& ray, std::vector<double>& blocked) const
{
  thread_local std::vector<double> all;
  blocked.assign(ray.Count(), 0.0);
  all.assign(ray.Count(), 0.0);
  for (std::size_t point = 0; point < this->Solids.size(); ++point)
  {
    this->AddSolid(point, ray, blocked, all);
  }
  for (std::size_t k = 0; k < ray.Count(); ++k)
  {
    blocked[k] = all[k] > 0.0 ? std::min(1.0, blocked[k] / all[k]) : 0.0;
  }
}

//------------------------------------------------------------------------------
std::int64_t ProjectedSolids::Memory() const
{
  std::int64_t bytes = 0;
  for (const auto& solid : this->Solids)
  {
    bytes += solid->Search->Memory() +
      static_cast<std::int64_t>(solid->Points.size() * sizeof(double) + solid->Triangles.size() * sizeof(vtkIdType));
  }
  return bytes;
}

} // namespace shadowcones
