// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallMeshes.h
 * @brief Boxes, sheets and spheres that are easy to know everything about, and prepared lights.
 */
#ifndef SmallMeshes_h
#define SmallMeshes_h

#include "scLight.h"
#include "scOccluderScene.h"

#include <gtest/gtest.h>

#include <vector>

namespace smallmeshes
{

constexpr double Pi = 3.14159265358979323846;

struct Mesh
{
  std::vector<double> Points;
  std::vector<vtkIdType> Triangles;
  std::vector<int> OccluderIds;

  shadowcones::TriangleMeshView View() const
  {
    shadowcones::TriangleMeshView view;
    view.Points = this->Points.data();
    view.NumberOfPoints = static_cast<vtkIdType>(this->Points.size() / 3);
    view.Triangles = this->Triangles.data();
    view.NumberOfTriangles = static_cast<vtkIdType>(this->Triangles.size() / 3);
    view.OccluderIds = this->OccluderIds.data();
    return view;
  }
  vtkIdType AddPoint(const shadowcones::Vector3& p)
  {
    this->Points.insert(this->Points.end(), { p.X, p.Y, p.Z });
    return static_cast<vtkIdType>(this->Points.size() / 3) - 1;
  }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, int occluder)
  {
    this->Triangles.insert(this->Triangles.end(), { a, b, c });
    this->OccluderIds.push_back(occluder);
  }
  /// A parallelogram; its normal is u x v.
  void AddSheet(
    const shadowcones::Vector3& corner, const shadowcones::Vector3& u, const shadowcones::Vector3& v, int occluder)
  {
    const vtkIdType a = this->AddPoint(corner);
    this->AddPoint(corner + u);
    this->AddPoint(corner + u + v);
    this->AddPoint(corner + v);
    this->AddTriangle(a, a + 1, a + 2, occluder);
    this->AddTriangle(a, a + 2, a + 3, occluder);
  }
  /// A closed box, normals outward.
  void AddBox(const shadowcones::Vector3& low, const shadowcones::Vector3& high, int occluder)
  {
    const auto first = static_cast<vtkIdType>(this->Points.size() / 3);
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
  /// A closed sphere of 4 rings^2 triangles or so, normals outward.
  void AddSphere(const shadowcones::Vector3& center, double radius, int rings, int occluder)
  {
    const int around = 2 * rings;
    const vtkIdType top = this->AddPoint(center + shadowcones::Vector3{ 0.0, 0.0, radius });
    for (int i = 1; i < rings; ++i)
    {
      for (int k = 0; k < around; ++k)
      {
        const double theta = Pi * i / rings;
        const double phi = 2.0 * Pi * k / around;
        this->AddPoint(center +
          radius *
            shadowcones::Vector3{ std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) });
      }
    }
    const vtkIdType bottom = this->AddPoint(center - shadowcones::Vector3{ 0.0, 0.0, radius });
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
};

inline shadowcones::Light Prepared(shadowcones::Light light)
{
  if (light.Spectrum.empty())
  {
    light.Spectrum.assign(7, 1.0);
  }
  const char* fault = PrepareLight(light);
  EXPECT_EQ(fault, nullptr) << fault;
  return light;
}

inline shadowcones::Light DiscLight(
  const shadowcones::Vector3& center, const shadowcones::Vector3& normal, double radius)
{
  shadowcones::Light light;
  light.Shape = shadowcones::LightShape::Disc;
  light.Center = center;
  light.Normal = normal;
  light.Radius = radius;
  return Prepared(light);
}

inline shadowcones::Light PointLight(const shadowcones::Vector3& center)
{
  shadowcones::Light light;
  light.Shape = shadowcones::LightShape::Point;
  light.Center = center;
  return Prepared(light);
}

inline shadowcones::Light SphereLight(const shadowcones::Vector3& center, double radius)
{
  shadowcones::Light light;
  light.Shape = shadowcones::LightShape::Sphere;
  light.Center = center;
  light.Radius = radius;
  return Prepared(light);
}

inline shadowcones::Light SunLight(const shadowcones::Vector3& travels, double angularRadius)
{
  shadowcones::Light light;
  light.Shape = shadowcones::LightShape::Sun;
  light.Normal = travels;
  light.Radius = angularRadius;
  return Prepared(light);
}

} // namespace smallmeshes

#endif
