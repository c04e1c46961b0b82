// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeshes.h
 * @brief Finely tessellated occluders, cameras and samplers that the closed forms are tested with.
 */
#ifndef TestMeshes_h
#define TestMeshes_h

#include "ClosedForms.h"
#include "scCamera.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scRandom.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// Where a test happens: everything is scaled, then moved.
struct Placement
{
  const char* Name;
  double Scale;
  Vector3 Offset;

  Vector3 operator()(const Vector3& p) const { return this->Scale * p + this->Offset; }
};

inline const std::vector<Placement>& Placements()
{
  static const std::vector<Placement> placements = { { "at the origin", 1.0, {} },
    { "far away", 1.0, { 1e6, -1e6, 1e6 } }, { "tiny", 1e-3, {} } };
  return placements;
}

struct TestMesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;

  vtkIdType AddPoint(const Vector3& p)
  {
    this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
    return static_cast<vtkIdType>(this->Points.size() / 3) - 1;
  }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Triangles.insert(this->Triangles.end(), { a, b, c });
  }
  void AddParallelogram(const Vector3& corner, const Vector3& u, const Vector3& v)
  {
    const vtkIdType a = this->AddPoint(corner);
    const vtkIdType b = this->AddPoint(corner + u);
    const vtkIdType c = this->AddPoint(corner + u + v);
    const vtkIdType d = this->AddPoint(corner + v);
    this->AddTriangle(a, b, c);
    this->AddTriangle(a, c, d);
  }
  /// A fan in a plane of constant z.
  void AddDisc(const Vector3& center, double radius, int corners = 512)
  {
    const vtkIdType middle = this->AddPoint(center);
    for (int k = 0; k < corners; ++k)
    {
      const double angle = 2.0 * closedforms::Pi * k / corners;
      this->AddPoint(center + radius * Vector3{ std::cos(angle), std::sin(angle), 0.0 });
    }
    for (int k = 0; k < corners; ++k)
    {
      this->AddTriangle(middle, middle + 1 + k, middle + 1 + (k + 1) % corners);
    }
  }
  void AddSphere(const Vector3& center, double radius, int rings = 128)
  {
    const int around = 2 * rings;
    const vtkIdType first = static_cast<vtkIdType>(this->Points.size() / 3);
    for (int i = 0; i <= rings; ++i)
    {
      const double theta = closedforms::Pi * i / rings;
      for (int k = 0; k < around; ++k)
      {
        const double phi = 2.0 * closedforms::Pi * k / around;
        this->AddPoint(center +
          radius * Vector3{ std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) });
      }
    }
    for (int i = 0; i < rings; ++i)
    {
      for (int k = 0; k < around; ++k)
      {
        const vtkIdType a = first + i * around + k;
        const vtkIdType b = first + i * around + (k + 1) % around;
        this->AddTriangle(a, a + around, b + around);
        this->AddTriangle(a, b + around, b);
      }
    }
  }
  void Place(const Placement& place)
  {
    for (std::size_t k = 0; k < this->Points.size(); k += 3)
    {
      const Vector3 p = place({ this->Points[k], this->Points[k + 1], this->Points[k + 2] });
      this->Points[k] = p.X;
      this->Points[k + 1] = p.Y;
      this->Points[k + 2] = p.Z;
    }
  }
  TriangleMeshView View() const
  {
    TriangleMeshView view;
    view.Points = this->Points.data();
    view.NumberOfPoints = static_cast<vtkIdType>(this->Points.size() / 3);
    view.Triangles = this->Triangles.data();
    view.NumberOfTriangles = static_cast<vtkIdType>(this->Triangles.size() / 3);
    return view;
  }
};

/// Visible fraction of a light by points (u, v) on it, as the fast paths see it.
inline double VisibilityBy(
  const std::vector<std::array<double, 2>>& points, const OccluderScene& scene, const Light& light, const Vector3& x)
{
  double seen = 0.0;
  double all = 0.0;
  for (const auto& point : points)
  {
    const IncidentSample sample = SampleVisibleLight(light, x, point[0], point[1]);
    all += sample.Weight;
    if (sample.Weight > 0.0 && !scene.Occluded(x, sample.Direction, 0.0, sample.Distance))
    {
      seen += sample.Weight;
    }
  }
  return all > 0.0 ? seen / all : 0.0;
}

/// 1,024 points of a lattice with steps of the golden ratio.
inline double SampledVisibility(const OccluderScene& scene, const Light& light, const Vector3& x)
{
  static const std::vector<std::array<double, 2>> points = []
  {
    std::vector<std::array<double, 2>> lattice;
    for (int k = 0; k < 1024; ++k)
    {
      const double turns = k * 0.61803398874989485 + 0.3;
      lattice.push_back({ (k + 0.5) / 1024.0, turns - std::floor(turns) });
    }
    return lattice;
  }();
  return VisibilityBy(points, scene, light, x);
}

/// 1,024 scrambled Sobol points, which the filters draw from.
inline double SobolVisibility(const OccluderScene& scene, const Light& light, const Vector3& x, std::uint64_t seed)
{
  std::vector<std::array<double, 2>> points;
  for (std::uint32_t k = 0; k < 1024; ++k)
  {
    const auto point = SobolPoint(seed, k);
    points.push_back({ point[0], point[1] });
  }
  return VisibilityBy(points, scene, light, x);
}

inline Camera LookAt(const Vector3& from, const Vector3& to, double halfHeight, bool parallel = false)
{
  Camera camera;
  camera.Position = from;
  camera.Forward = Normalized(to - from);
  const Vector3 up = std::abs(camera.Forward.Y) < 0.9 ? Vector3{ 0.0, 1.0, 0.0 } : Vector3{ 0.0, 0.0, 1.0 };
  camera.Right = Normalized(Cross(camera.Forward, up));
  camera.Up = Cross(camera.Right, camera.Forward);
  camera.HalfHeight = halfHeight;
  camera.Parallel = parallel;
  return camera;
}

} // namespace shadowcones

#endif
