// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeshes.h
 * @brief Sheets, boxes, discs and spheres that are easy to know everything about, as plain meshes.
 */
#ifndef TestMeshes_h
#define TestMeshes_h

#include "scConstants.h"
#include "scTriangleMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace shadowcones
{
namespace testsupport
{

using shadowcones::Pi;

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

/// A triangle mesh that owns its arrays. Either all of its triangles have an occluder id or none.
struct TestMesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<int> OccluderIds;

  TriangleMeshView View() const
  {
    EXPECT_TRUE(this->OccluderIds.empty() || 3 * this->OccluderIds.size() == this->Triangles.size());
    TriangleMeshView view;
    view.Points = this->Points.data();
    view.NumberOfPoints = this->NumberOfPoints();
    view.Triangles = this->Triangles.data();
    view.NumberOfTriangles = static_cast<vtkIdType>(this->Triangles.size() / 3);
    view.OccluderIds = this->OccluderIds.empty() ? nullptr : this->OccluderIds.data();
    return view;
  }
  vtkIdType NumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size() / 3); }
  vtkIdType AddPoint(const Vector3& p)
  {
    this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
    return this->NumberOfPoints() - 1;
  }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Triangles.insert(this->Triangles.end(), { a, b, c });
  }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, int occluder)
  {
    this->AddTriangle(a, b, c);
    this->OccluderIds.push_back(occluder);
  }
  /// A parallelogram; its normal is u x v.
  void AddSheet(const Vector3& corner, const Vector3& u, const Vector3& v, int occluder = 0)
  {
    const vtkIdType a = this->AddPoint(corner);
    this->AddPoint(corner + u);
    this->AddPoint(corner + u + v);
    this->AddPoint(corner + v);
    this->AddTriangle(a, a + 1, a + 2, occluder);
    this->AddTriangle(a, a + 2, a + 3, occluder);
  }
  /// A closed box, normals outward.
  void AddBox(const Vector3& low, const Vector3& high, int occluder = 0)
  {
    const vtkIdType first = this->NumberOfPoints();
    for (int i = 0; i < 8; ++i)
    {
      this->AddPoint({ i & 1 ? high.X : low.X, i & 2 ? high.Y : low.Y, i & 4 ? high.Z : low.Z });
    }
    constexpr int quads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
      { 4, 5, 7, 6 } };
    for (const auto& q : quads)
    {
      this->AddTriangle(first + q[0], first + q[1], first + q[2], occluder);
      this->AddTriangle(first + q[0], first + q[2], first + q[3], occluder);
    }
  }
  /// A fan whose normal is u x v; u and v are of unit length.
  void AddDisc(const Vector3& center, double radius, const Vector3& u, const Vector3& v, int corners, int occluder = 0)
  {
    const vtkIdType middle = this->AddPoint(center);
    for (int k = 0; k < corners; ++k)
    {
      const double angle = 2.0 * Pi * k / corners;
      this->AddPoint(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    for (int k = 0; k < corners; ++k)
    {
      this->AddTriangle(middle, middle + 1 + k, middle + 1 + (k + 1) % corners, occluder);
    }
  }
  /// A fan in a plane of constant z.
  void AddDisc(const Vector3& center, double radius, int corners = 512, int occluder = 0)
  {
    this->AddDisc(center, radius, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, corners, occluder);
  }
  /// A closed sphere of 4 rings^2 triangles or so, normals outward.
  void AddSphere(const Vector3& center, double radius, int rings = 128, int occluder = 0)
  {
    const int around = 2 * rings;
    const vtkIdType top = this->AddPoint(center + Vector3{ 0.0, 0.0, radius });
    for (int i = 1; i < rings; ++i)
    {
      for (int k = 0; k < around; ++k)
      {
        const double theta = Pi * i / rings;
        const double phi = 2.0 * Pi * k / around;
        this->AddPoint(center +
          radius * Vector3{ std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) });
      }
    }
    const vtkIdType bottom = this->AddPoint(center - Vector3{ 0.0, 0.0, radius });
    const auto at = [&](int ring, int k) { return top + 1 + (ring - 1) * around + k % around; };
    for (int k = 0; k < around; ++k)
    {
      this->AddTriangle(top, at(1, k), at(1, k + 1), occluder);
      this->AddTriangle(bottom, at(rings - 1, k + 1), at(rings - 1, k), occluder);
      for (int i = 1; i + 1 < rings; ++i)
      {
        this->AddTriangle(at(i, k), at(i + 1, k), at(i + 1, k + 1), occluder);
        this->AddTriangle(at(i, k), at(i + 1, k + 1), at(i, k + 1), occluder);
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
};

/// Something that no test's light or ray meets.
inline TestMesh OutOfTheWay()
{
  TestMesh mesh;
  mesh.AddSheet({ 200.0, 200.0, 200.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.1, 0.0 });
  return mesh;
}

} // namespace testsupport
} // namespace shadowcones

#endif
