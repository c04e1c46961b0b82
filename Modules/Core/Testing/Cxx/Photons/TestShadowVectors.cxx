// SPDX-License-Identifier: BSD-3-Clause
// What photons leave behind: exact exits of boxes, sheets, receivers, and the power that they carry.
// One file because every promise is asked of the same small meshes.
#include "TestLights.h"
#include "TestMeshes.h"
#include "scPhotonEmission.h"
#include "scShadowVectors.h"
#include "scTriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

using namespace shadowcones;
using namespace testsupport;

namespace
{

ShadowVectorResult Trace(const TestMesh& mesh, const Light& light, const ShadowVectorOptions& options)
{
  const OccluderScene scene(mesh.View());
  ShadowVectorResult result;
  EXPECT_TRUE(TraceShadowVectors(scene, light, options, {}, result));
  return result;
}

ShadowVectorOptions Photons(vtkIdType count, VectorStorage storage = VectorStorage::BackSide)
{
  ShadowVectorOptions options;
  options.NumberOfPhotons = count;
  options.Storage = storage;
  return options;
}

template <typename T>
Vector3 At(const std::vector<T>& values, std::size_t i)
{
  return { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
}

double Sum(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double BlockedPower(const PhotonPaths& paths)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < paths.Powers.size(); ++i)
  {
    sum += paths.States[i] ? paths.Powers[i] : 0.0;
  }
  return sum;
}

/// Cosine-weighted solid angle over a polygon seen from the origin, times the normal: Lambert's formula.
double Irradiance(const std::vector<Vector3>& corners, const Vector3& normal)
{
  Vector3 sum;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector3 a = Normalized(corners[i]);
    const Vector3 b = Normalized(corners[(i + 1) % corners.size()]);
    const Vector3 edge = Cross(a, b);
    sum += std::atan2(Length(edge), Dot(a, b)) * Normalized(edge);
  }
  return 0.5 * std::abs(Dot(sum, normal));
}

/// Directions within a sheet x, y in [-half, half] at z = 0 from a point above it.
std::vector<Vector3> SheetSeenFrom(const Vector3& point, double half)
{
  return { Vector3{ -half, -half, 0.0 } - point, Vector3{ half, -half, 0.0 } - point,
    Vector3{ half, half, 0.0 } - point, Vector3{ -half, half, 0.0 } - point };
}

TestMesh Sheet(double half)
{
  TestMesh mesh;
  mesh.AddSheet({ -half, -half, 0.0 }, { 2.0 * half, 0.0, 0.0 }, { 0.0, 2.0 * half, 0.0 }, 4);
  return mesh;
}

/// Every array of a result, by name, as bytes.
std::map<std::string, std::string> Bytes(const ShadowVectorResult& r)
{
  std::map<std::string, std::string> bytes;
  const auto add = [&bytes](const char* name, const auto& values)
  { bytes[name].assign(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])); };
  add("Vectors.Points", r.Vectors.Points);
  add("Vectors.Directions", r.Vectors.Directions);
  add("Vectors.Normals", r.Vectors.Normals);
  add("Vectors.OccluderIds", r.Vectors.OccluderIds);
  add("Vectors.EmissionPoints", r.Vectors.EmissionPoints);
  add("Vectors.PathLengths", r.Vectors.PathLengths);
  add("Vectors.Thicknesses", r.Vectors.Thicknesses);
  add("Vectors.PhotonIndices", r.Vectors.PhotonIndices);
  add("Paths.Points", r.Paths.Points);
  add("Paths.States", r.Paths.States);
  add("Paths.OccluderIds", r.Paths.OccluderIds);
  add("Paths.EmissionPoints", r.Paths.EmissionPoints);
  add("Paths.Directions", r.Paths.Directions);
  add("Paths.Powers", r.Paths.Powers);
  add("Paths.PhotonIndices", r.Paths.PhotonIndices);
  add("Photons.Points", r.Photons.Points);
  add("Photons.Normals", r.Photons.Normals);
  add("Photons.Directions", r.Photons.Directions);
  add("Photons.Powers", r.Photons.Powers);
  add("Photons.OccluderIds", r.Photons.OccluderIds);
  add("Photons.ReceiverIds", r.Photons.ReceiverIds);
  add("Photons.PhotonIndices", r.Photons.PhotonIndices);
  return bytes;
}

} // namespace

TEST(ShadowVectors, LeaveABoxAtItsExactExit)
{
  TestMesh mesh;
  const Box box{ { -0.5, -0.4, -0.3 }, { 0.6, 0.7, 0.2 } };
  mesh.AddBox(box.Min, box.Max, 3);
  const Light light = DiscLight({ 0.3, -0.2, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectorResult result = Trace(mesh, light, Photons(4000));
  const ShadowVectors& vectors = result.Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 1500u);
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 start = At(vectors.EmissionPoints, i);
    const Vector3 end = At(vectors.Points, i);
    const Vector3 direction = Normalized(end - start);
    double entry = 0.0;
    double exit = HUGE_VAL;
    ASSERT_TRUE(box.Clip(start, direction, entry, exit));
    EXPECT_NEAR(Length(end - start), exit, 1e-9);
    EXPECT_NEAR(vectors.PathLengths[i], exit, 1e-6);
    EXPECT_NEAR(vectors.Thicknesses[i], exit - entry, 1e-6);
    EXPECT_LT(Length(At(vectors.Directions, i) - direction), 1e-6);
    EXPECT_EQ(vectors.OccluderIds[i], 3);
    EXPECT_NEAR(start.Z, 3.0, 1e-12);
    EXPECT_LE(Length(start - light.Center), 0.5 + 1e-12);
    // Outward where the light would come out: the box's face through the point.
    const Vector3 normal = At(vectors.Normals, i);
    EXPECT_GT(Dot(normal, direction), 0.0);
    const Vector3 outside = end + 1e-6 * normal;
    EXPECT_FALSE(box.Contains(outside));
    EXPECT_TRUE(box.Contains(end - 1e-6 * normal - 1e-6 * direction));
  }
}

TEST(ShadowVectors, HitPointStoresTheEntry)
{
  TestMesh mesh;
  const Box box{ { -0.5, -0.4, -0.3 }, { 0.6, 0.7, 0.2 } };
  mesh.AddBox(box.Min, box.Max, 3);
  const Light light = PointLight({ 2.0, -1.0, 3.0 });
  const ShadowVectorResult back = Trace(mesh, light, Photons(2000));
  const ShadowVectorResult hit = Trace(mesh, light, Photons(2000, VectorStorage::HitPoint));
  ASSERT_EQ(back.Vectors.PhotonIndices, hit.Vectors.PhotonIndices);
  ASSERT_GT(hit.Vectors.OccluderIds.size(), 500u);
  for (std::size_t i = 0; i < hit.Vectors.OccluderIds.size(); ++i)
  {
    const Vector3 start = At(hit.Vectors.EmissionPoints, i);
    const Vector3 point = At(hit.Vectors.Points, i);
    const Vector3 direction = Normalized(point - start);
    double entry = 0.0;
    double exit = HUGE_VAL;
    ASSERT_TRUE(box.Clip(start, direction, entry, exit));
    EXPECT_NEAR(Length(point - start), entry, 1e-9);
    EXPECT_EQ(hit.Vectors.Thicknesses[i], back.Vectors.Thicknesses[i]);
    EXPECT_LT(Dot(At(hit.Vectors.Normals, i), direction), 0.0);
  }
}

TEST(ShadowVectors, StayOnAnOpenSheet)
{
  TestMesh mesh = Sheet(1.0);
  for (const double side : { 2.0, -2.0 }) // lit on its front and on its back
  {
    const Light light = DiscLight({ 0.0, 0.0, side }, { 0.0, 0.0, -side }, 0.3);
    for (const VectorStorage storage : { VectorStorage::BackSide, VectorStorage::HitPoint })
    {
      const ShadowVectors vectors = Trace(mesh, light, Photons(1000, storage)).Vectors;
      ASSERT_GT(vectors.OccluderIds.size(), 900u);
      for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
      {
        EXPECT_NEAR(vectors.Points[3 * i + 2], 0.0, 1e-12);
        EXPECT_EQ(vectors.Thicknesses[i], 0.0f);
        const double along = Dot(At(vectors.Normals, i), At(vectors.Directions, i));
        EXPECT_EQ(along > 0.0, storage == VectorStorage::BackSide);
      }
    }
  }
}

TEST(ShadowVectors, EveryOccluderOnThePathStoresOne)
{
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.2 }, 5);
  mesh.AddBox({ -1.0, -1.0, 1.0 }, { 1.0, 1.0, 1.2 }, 8);
  // One occluder in two parts, met twice: still one vector, at the exit of the part that is met first.
  mesh.AddBox({ -1.0, -1.0, 2.0 }, { 1.0, 1.0, 2.2 }, 9);
  mesh.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, -0.8 }, 9);
  const Light light = SunLight({ 0.0, 0.0, -1.0 }, 0.0);
  const ShadowVectorResult result = Trace(mesh, light, Photons(500));
  std::map<vtkIdType, std::vector<std::pair<double, int>>> found;
  for (std::size_t i = 0; i < result.Vectors.OccluderIds.size(); ++i)
  {
    found[result.Vectors.PhotonIndices[i]].emplace_back(
      result.Vectors.Points[3 * i + 2], result.Vectors.OccluderIds[i]);
  }
  ASSERT_GT(found.size(), 450u);
  for (const auto& [photon, vectors] : found)
  {
    ASSERT_EQ(vectors.size(), 3u) << photon;
    EXPECT_EQ(vectors[0].second, 9);
    EXPECT_NEAR(vectors[0].first, 2.0, 1e-9);
    EXPECT_EQ(vectors[1].second, 8);
    EXPECT_NEAR(vectors[1].first, 1.0, 1e-9);
    EXPECT_EQ(vectors[2].second, 5);
    EXPECT_NEAR(vectors[2].first, 0.0, 1e-9);
  }
  // The path ends at the first of them, and its shadow photon lies on the next.
  ASSERT_EQ(result.Photons.OccluderIds.size(), found.size());
  for (std::size_t i = 0; i < result.Photons.OccluderIds.size(); ++i)
  {
    EXPECT_EQ(result.Photons.OccluderIds[i], 9);
    EXPECT_EQ(result.Photons.ReceiverIds[i], 8);
    EXPECT_NEAR(result.Photons.Points[3 * i + 2], 1.2, 1e-9);
    EXPECT_GT(result.Photons.Normals[3 * i + 2], 0.99f);
  }
}

TEST(ShadowVectors, ReceiversEndPathsAndCatchShadowPhotons)
{
  TestMesh mesh;
  mesh.AddBox({ -0.5, -0.5, 1.0 }, { 0.5, 0.5, 1.4 }, 0);
  mesh.AddSheet({ -9.0, -9.0, 0.0 }, { 18.0, 0.0, 0.0 }, { 0.0, 18.0, 0.0 }, -1); // the floor
  mesh.AddBox({ -0.4, -0.4, -2.0 }, { 0.4, 0.4, -1.0 }, 1);                       // below it: no light gets there
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectorResult result = Trace(mesh, light, Photons(8000));

  std::map<vtkIdType, std::size_t> pathOf;
  std::size_t blocked = 0;
  for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
  {
    pathOf[result.Paths.PhotonIndices[i]] = i;
    blocked += result.Paths.States[i];
    EXPECT_EQ(result.Paths.OccluderIds[i], result.Paths.States[i] ? 0 : -1);
    const double z = result.Paths.Points[3 * i + 2];
    EXPECT_TRUE(result.Paths.States[i] ? z > 1.0 - 1e-9 : std::abs(z) < 1e-9) << z;
  }
  EXPECT_GT(blocked, 1000u);
  EXPECT_LT(blocked, result.Paths.States.size());

  ASSERT_EQ(result.Vectors.OccluderIds.size(), blocked);
  EXPECT_EQ(std::set<int>(result.Vectors.OccluderIds.begin(), result.Vectors.OccluderIds.end()), std::set<int>{ 0 });

  ASSERT_EQ(result.Photons.OccluderIds.size(), blocked);
  for (std::size_t i = 0; i < blocked; ++i)
  {
    EXPECT_EQ(result.Photons.ReceiverIds[i], -1);
    EXPECT_EQ(result.Photons.OccluderIds[i], 0);
    EXPECT_NEAR(result.Photons.Points[3 * i + 2], 0.0, 1e-9);
    const std::size_t path = pathOf.at(result.Photons.PhotonIndices[i]);
    EXPECT_EQ(result.Photons.Powers[i], -result.Paths.Powers[path]);
    // On the line of its photon.
    const Vector3 line = Normalized(At(result.Photons.Points, i) - At(result.Paths.EmissionPoints, path));
    EXPECT_LT(Length(line - At(result.Paths.Directions, path)), 1e-6);
  }
}

TEST(ShadowVectors, ASolidThatStandsOnOrInAReceiverIsLeftBelow)
{
  for (const double bottom : { 0.0, -0.1 })
  {
    TestMesh mesh;
    mesh.AddBox({ -0.2, -0.2, bottom }, { 0.2, 0.2, 1.0 }, 0);
    mesh.AddSheet({ -9.0, -9.0, 0.0 }, { 18.0, 0.0, 0.0 }, { 0.0, 18.0, 0.0 }, -1);
    const Light light = DiscLight({ 1.0, 0.5, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
    const ShadowVectors vectors = Trace(mesh, light, Photons(2000)).Vectors;
    ASSERT_GT(vectors.OccluderIds.size(), 500u);
    std::size_t through = 0;
    for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
    {
      EXPECT_GT(Dot(At(vectors.Normals, i), At(vectors.Directions, i)), 0.0);
      EXPECT_GE(vectors.Points[3 * i + 2], bottom - 1e-9);
      through += vectors.Points[3 * i + 2] < bottom + 1e-9;
    }
    EXPECT_GT(through, 10u); // some leave by the bottom
  }
}

TEST(ShadowVectors, PointOutwardBehindClosedSolidsEvenAtEdges)
{
  // A fine sphere: photons that hit edges must not be taken to have entered twice.
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 100, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const ShadowVectors vectors = Trace(mesh, light, Photons(100000)).Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 40000u);
  double shallow = 0;
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 point = At(vectors.Points, i);
    ASSERT_GT(Dot(At(vectors.Normals, i), At(vectors.Directions, i)), 0.0);
    // Entry and exit of the sphere itself, up to its tessellation.
    const Vector3 direction = At(vectors.Directions, i);
    const double chord = 2.0 * std::max(0.0, Dot(point, direction));
    shallow += std::abs(vectors.Thicknesses[i] - chord) > 0.1;
  }
  EXPECT_EQ(shallow, 0);
}

TEST(ShadowVectors, AnEdgeIsCrossedOnce)
{
  // A top of small squares, closed below by a pyramid. Beside the large floor it is so small that single precision leaves only
  // some 30,000 places on it: one photon in a hundred meets an edge exactly, and Embree reports both of its triangles.
  const int n = 64;
  TestMesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.AddPoint({ 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 0.0 });
    }
  }
  const vtkIdType tip = mesh.AddPoint({ 0.0, 0.0, -1.0 });
  const auto at = [n](int i, int j) { return static_cast<vtkIdType>(j * (n + 1) + i); };
  for (int k = 0; k < n; ++k)
  {
    mesh.AddTriangle(at(k + 1, 0), at(k, 0), tip, 0);
    mesh.AddTriangle(at(k, n), at(k + 1, n), tip, 0);
    mesh.AddTriangle(at(0, k), at(0, k + 1), tip, 0);
    mesh.AddTriangle(at(n, k + 1), at(n, k), tip, 0);
    for (int i = 0; i < n; ++i)
    {
      mesh.AddTriangle(at(i, k), at(i + 1, k), at(i + 1, k + 1), 0);
      mesh.AddTriangle(at(i, k), at(i + 1, k + 1), at(i, k + 1), 0);
    }
  }
  mesh.AddSheet({ -500.0, -600.0, -300.0 }, { 1000.0, 0.0, 0.0 }, { 0.0, 1000.0, 0.0 }, -1);
  const ShadowVectors vectors = Trace(mesh, SunLight({ 0.0, 0.0, -1.0 }, 0.0), Photons(20000)).Vectors;
  ASSERT_GT(vectors.OccluderIds.size(), 19000u);
  int shallow = 0;
  for (std::size_t i = 0; i < vectors.OccluderIds.size(); ++i)
  {
    const Vector3 p = At(vectors.Points, i);
    const double thickness = 1.0 - std::max(std::abs(p.X), std::abs(p.Y));
    shallow += std::abs(vectors.Thicknesses[i] - thickness) > 1e-3;
  }
  EXPECT_EQ(shallow, 0);
}

TEST(ShadowVectors, ALightInsideASolidIsStoppedByItsFarSide)
{
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 }, 0);
  const ShadowVectorResult result = Trace(mesh, PointLight({ 0.1, 0.2, 0.3 }), Photons(500));
  ASSERT_EQ(result.Vectors.OccluderIds.size(), 500u);
  for (std::size_t i = 0; i < 500u; ++i)
  {
    EXPECT_EQ(result.Vectors.Thicknesses[i], 0.0f);
    EXPECT_GT(Dot(At(result.Vectors.Normals, i), At(result.Vectors.Directions, i)), 0.0);
    const Vector3 p = At(result.Vectors.Points, i);
    EXPECT_NEAR(std::max({ std::abs(p.X), std::abs(p.Y), std::abs(p.Z) }), 1.0, 1e-9);
  }
}

TEST(ShadowVectors, DirectionsAndIndicesAreThoseOfTheirPaths)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 0.7, 12, 2);
  const ShadowVectorResult result = Trace(mesh, SphereLight({ 0.0, 1.0, 3.0 }, 0.4), Photons(3000));
  std::set<vtkIdType> blocked;
  for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
  {
    ASSERT_NEAR(Length(At(result.Paths.Directions, i)), 1.0, 1e-6);
    ASSERT_GT(result.Paths.Powers[i], 0.0f);
    if (result.Paths.States[i])
    {
      blocked.insert(result.Paths.PhotonIndices[i]);
    }
  }
  const std::set<vtkIdType> stored(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end());
  EXPECT_EQ(stored, blocked);
  EXPECT_TRUE(std::is_sorted(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end()));
  EXPECT_EQ(result.NumberOfPhotons, 3000);
}

TEST(ShadowVectors, LitPathsEndAtTheBoundsOfMeshAndLight)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 12, 0);
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 2.0);
  const PhotonPaths paths = Trace(mesh, light, Photons(2000)).Paths;
  int lit = 0;
  for (std::size_t i = 0; i < paths.States.size(); ++i)
  {
    if (paths.States[i] == 0)
    {
      ++lit;
      const Vector3 p = At(paths.Points, i);
      EXPECT_TRUE(
        std::abs(std::abs(p.X) - 2.0) < 1e-6 || std::abs(std::abs(p.Y) - 2.0) < 1e-6 || std::abs(p.Z + 1.0) < 1e-6);
    }
  }
  EXPECT_GT(lit, 100);
}

TEST(ShadowVectorPower, RectangleOverRectangleIsTheFormFactor)
{
  // Opposed equal squares, 2 by 2, 1 apart: the textbook form factor.
  const double x = 2.0;
  const double y = 2.0;
  const double xx = 1.0 + x * x;
  const double yy = 1.0 + y * y;
  const double factor = 2.0 / (Pi * x * y) *
    (std::log(std::sqrt(xx * yy / (1.0 + x * x + y * y))) + x * std::sqrt(yy) * std::atan(x / std::sqrt(yy)) +
      y * std::sqrt(xx) * std::atan(y / std::sqrt(xx)) - x * std::atan(x) - y * std::atan(y));
  Light light;
  light.Shape = LightShape::Rectangle;
  light.Center = { 0.0, 0.0, 1.0 };
  light.Normal = { 0.0, 0.0, -1.0 };
  light.AxisU = { 1.0, 0.0, 0.0 };
  light.AxisV = { 0.0, -1.0, 0.0 };
  light.Spectrum.assign(7, 3.0);
  light = Prepared(light);
  const ShadowVectorResult result = Trace(Sheet(1.0), light, Photons(40000));
  const double flux = 3.0 * Pi * 4.0 * factor;
  EXPECT_NEAR(BlockedPower(result.Paths), flux, 2e-3 * flux);
  // Photons are aimed at the bounds, which the sheet fills but for its margin.
  EXPECT_NEAR(Sum(result.Paths.Powers), flux, 4e-3 * flux);
  EXPECT_GE(Sum(result.Paths.Powers), BlockedPower(result.Paths));
}

TEST(ShadowVectorPower, DiscOverSquareIsTheIntegralOverTheDisc)
{
  const double radius = 0.8;
  const double height = 1.5;
  const double half = 0.6;
  // Midpoints of rings and sectors; the integrand is smooth.
  double flux = 0.0;
  const int rings = 60;
  const int sectors = 120;
  for (int i = 0; i < rings; ++i)
  {
    for (int k = 0; k < sectors; ++k)
    {
      const double r = radius * (i + 0.5) / rings;
      const double phi = 2.0 * Pi * (k + 0.5) / sectors;
      const Vector3 point{ 0.3 + r * std::cos(phi), r * std::sin(phi), height };
      const double area = r * (radius / rings) * (2.0 * Pi / sectors);
      flux += area * Irradiance(SheetSeenFrom(point, half), { 0.0, 0.0, 1.0 });
    }
  }
  const ShadowVectorResult result =
    Trace(Sheet(half), DiscLight({ 0.3, 0.0, height }, { 0.0, 0.0, -1.0 }, radius), Photons(40000));
  EXPECT_NEAR(BlockedPower(result.Paths), flux, 2e-3 * flux);
}

TEST(ShadowVectorPower, IsTheMeanOverTheSpectrum)
{
  Light light = DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const double one = Sum(Trace(Sheet(1.0), light, Photons(1000)).Paths.Powers);
  light.Spectrum = { 1.0, 2.0, 6.0 };
  EXPECT_NEAR(Sum(Trace(Sheet(1.0), light, Photons(1000)).Paths.Powers), 3.0 * one, 1e-4 * one);
  light.Spectrum = { 0.0, 0.0 };
  EXPECT_EQ(
    Trace(Sheet(1.0), light, Photons(1000)).Vectors.OccluderIds.size(), 0u); // a light that is off casts no shadow
}

TEST(ShadowVectorPower, PointLightIsIntensityTimesSolidAngle)
{
  // A square of half width a at distance h under a point light.
  const double a = 0.7;
  const double h = 1.3;
  const double solidAngle = 4.0 * std::asin(a * a / (a * a + h * h));
  const ShadowVectorResult result = Trace(Sheet(a), PointLight({ 0.0, 0.0, h }), Photons(20000));
  EXPECT_NEAR(BlockedPower(result.Paths), solidAngle, 2e-3 * solidAngle);
  EXPECT_NEAR(result.MeanSolidAngle, solidAngle, 5e-3 * solidAngle);
}

TEST(ShadowVectorPower, SunIsIrradianceTimesProjectedArea)
{
  // Spectrum of a Sun is the irradiance of a plane that faces it; at 30 degrees a 2 x 2 sheet catches half of 4.
  for (const double angular : { 0.0, 0.00465, 0.05 })
  {
    const Light sun = SunLight({ std::cos(Pi / 6.0), 0.0, -std::sin(Pi / 6.0) }, angular);
    const ShadowVectorResult result = Trace(Sheet(1.0), sun, Photons(40000));
    EXPECT_NEAR(BlockedPower(result.Paths), 2.0, 0.01) << angular;
    double widest = 0.0;
    for (std::size_t i = 0; i < result.Paths.States.size(); ++i)
    {
      const Vector3 d = At(result.Paths.Directions, i);
      widest = std::max(widest, std::atan2(Length(Cross(d, sun.Normal)), Dot(d, sun.Normal)));
    }
    EXPECT_NEAR(widest, angular, 1e-3 * angular + 1e-6);
  }
}

TEST(ShadowVectorPower, SphereLightOverASheetIsThatOfAPoint)
{
  // Outside a Lambertian sphere every direction sees pi R^2 of radiance: an intensity of pi R^2, whatever the direction. For
  // a sheet wholly below it the flux through it is that intensity's, because both are fields without divergence.
  const double radius = 0.4;
  const ShadowVectorResult result = Trace(Sheet(1.0), SphereLight({ 0.0, 0.0, 1.0 }, radius), Photons(60000));
  const double solidAngle = 4.0 * std::asin(1.0 / 2.0);
  EXPECT_NEAR(BlockedPower(result.Paths), Pi * radius * radius * solidAngle, 6e-3 * Pi * radius * radius * solidAngle);
}

TEST(ShadowVectorPower, ALightInsideTheBoundsSendsAllItsFlux)
{
  // Inside a closed room every photon is blocked: the whole flux of a Lambertian disc, pi times its area.
  TestMesh mesh;
  mesh.AddBox({ -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 }, 0);
  const ShadowVectorResult result = Trace(mesh, DiscLight({ 0.0, 0.0, 1.0 }, { 0.3, 0.1, -1.0 }, 0.5), Photons(5000));
  EXPECT_NEAR(BlockedPower(result.Paths), Pi * Pi * 0.25, 1e-4);
  EXPECT_EQ(BlockedPower(result.Paths), Sum(result.Paths.Powers));
}

TEST(ShadowVectors, ALightThatFacesAwayLeavesNothing)
{
  const ShadowVectorResult result =
    Trace(Sheet(1.0), DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 0.5), Photons(500));
  EXPECT_TRUE(result.Vectors.OccluderIds.empty());
  EXPECT_TRUE(result.Paths.States.empty());
  EXPECT_EQ(result.NumberOfPhotons, 500);
}

TEST(ShadowVectors, ARoofThatReceivesShadesFromTheSunHoweverHigh)
{
  for (const double height : { 3.0, 300.0 })
  {
    TestMesh mesh = Sheet(1.0);
    mesh.AddSheet({ -5.0, -5.0, height }, { 10.0, 0.0, 0.0 }, { 0.0, 10.0, 0.0 }, -1);
    const ShadowVectorResult result = Trace(mesh, SunLight({ 0.0, 0.0, -1.0 }, 0.001), Photons(500));
    EXPECT_TRUE(result.Vectors.OccluderIds.empty()) << height;
  }
}

TEST(ShadowVectorTarget, IsMetUpToTheLastPhotons)
{
  TestMesh mesh;
  mesh.AddBox({ -0.5, -0.5, 0.0 }, { 0.5, 0.5, 0.2 }, 0);
  mesh.AddBox({ -0.5, -0.5, 1.0 }, { 0.5, 0.5, 1.2 }, 1);
  mesh.AddBox({ 2.0, 2.0, 1.0 }, { 2.5, 2.5, 1.2 }, 2); // lowers the yield
  const Light light = DiscLight({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  for (const vtkIdType target : { 1, 7, 1000, 5800 })
  {
    ShadowVectorOptions options = Photons(1);
    options.TargetNumberOfVectors = target;
    const ShadowVectorResult result = Trace(mesh, light, options);
    const auto stored = static_cast<vtkIdType>(result.Vectors.OccluderIds.size());
    const vtkIdType last = result.Vectors.PhotonIndices.back();
    const auto ofLast = std::count(result.Vectors.PhotonIndices.begin(), result.Vectors.PhotonIndices.end(), last);
    EXPECT_GE(stored, target);
    EXPECT_LT(stored - ofLast, target);          // without the last photon it would not be met
    EXPECT_EQ(result.NumberOfPhotons, last + 1); // and that is the last one emitted
    // The same as asking for that many photons.
    EXPECT_EQ(Bytes(result), Bytes(Trace(mesh, light, Photons(result.NumberOfPhotons))));
  }
}

TEST(ShadowVectorTarget, GivesUpWhereNoLightArrives)
{
  ShadowVectorOptions options;
  options.TargetNumberOfVectors = 10;
  const ShadowVectorResult result = Trace(Sheet(1.0), DiscLight({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 1.0 }, 0.5), options);
  EXPECT_EQ(result.NumberOfPhotons, 10000);
  EXPECT_TRUE(result.Vectors.OccluderIds.empty());
}

TEST(ShadowVectorPieces, JoinToTheWhole)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  for (const vtkIdType target : { 0, 3000 })
  {
    ShadowVectorOptions options = Photons(5003); // no multiple of the pieces
    options.TargetNumberOfVectors = target;
    const auto whole = Bytes(Trace(mesh, light, options));
    for (const int pieces : { 2, 4, 7 })
    {
      std::map<std::string, std::string> joined;
      options.NumberOfPieces = pieces;
      for (options.Piece = 0; options.Piece < pieces; ++options.Piece)
      {
        for (const auto& [name, bytes] : Bytes(Trace(mesh, light, options)))
        {
          joined[name] += bytes;
        }
      }
      EXPECT_TRUE(joined == whole) << pieces << " pieces";
      options.Piece = 0;
      options.NumberOfPieces = 1;
    }
  }
}

TEST(ShadowVectorSeed, ChoosesThePhotons)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  ShadowVectorOptions options = Photons(1000);
  const auto first = Bytes(Trace(mesh, light, options));
  EXPECT_TRUE(first == Bytes(Trace(mesh, light, options)));
  options.Seed = 2;
  EXPECT_FALSE(first == Bytes(Trace(mesh, light, options)));
}

TEST(ShadowVectorMonitor, AbortStopsAndProgressOnlyGrows)
{
  TestMesh mesh;
  mesh.AddSphere({ 0.0, 0.0, 0.0 }, 1.0, 20, 0);
  mesh.AddBox({ 20.0, 20.0, 0.0 }, { 21.0, 21.0, 1.0 }, 1); // aims most photons beside the sphere
  const Light light = DiscLight({ 0.0, 0.0, 3.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const OccluderScene scene(mesh.View());
  for (const vtkIdType target : { 0, 40000 })
  {
    ShadowVectorOptions options = Photons(200000);
    options.TargetNumberOfVectors = target;
    std::vector<double> seen;
    Monitor monitor;
    monitor.Progress = [&seen](double share) { seen.push_back(share); };
    ShadowVectorResult result;
    ASSERT_TRUE(TraceShadowVectors(scene, light, options, monitor, result));
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_GE(std::set<double>(seen.begin(), seen.end()).size(), 3u);
    EXPECT_NEAR(seen.back(), 1.0, 1e-12) << target << " " << testing::PrintToString(seen) << result.NumberOfPhotons;

    monitor.Aborted = [&seen] { return seen.size() >= 2; };
    seen.clear();
    EXPECT_FALSE(TraceShadowVectors(scene, light, options, monitor, result));
    EXPECT_LE(seen.size(), 3u);
  }
}

TEST(ClosedOccluders, NeedEveryEdgeBothWays)
{
  TestMesh mesh;
  mesh.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 7);
  mesh.AddSheet({ 5.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 3);
  mesh.AddSphere({ 9.0, 0.0, 0.0 }, 1.0, 6, -2);
  std::vector<bool> closed = ClosedOccluders(mesh.View());
  for (std::size_t t = 0; t < closed.size(); ++t)
  {
    EXPECT_EQ(closed[t], mesh.OccluderIds[t] != 3) << t;
  }
  // Corners of their own for every triangle, as where normals differ, change nothing.
  TestMesh apart = mesh;
  apart.Points.clear();
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const auto corner = mesh.Points.begin() + 3 * mesh.Triangles[i];
    apart.Points.insert(apart.Points.end(), corner, corner + 3);
    apart.Triangles[i] = static_cast<vtkIdType>(i);
  }
  EXPECT_EQ(ClosedOccluders(apart.View()), closed);
  // One triangle turned round opens its occluder and no other.
  std::swap(mesh.Triangles[0], mesh.Triangles[1]);
  closed = ClosedOccluders(mesh.View());
  EXPECT_FALSE(closed[0]);
  EXPECT_FALSE(closed[11]);
  EXPECT_TRUE(closed.back());
}

TEST(PhotonEmission, PhotonsBeyondTheFirstFourThousandMillionAreOthers)
{
  // The index has more bits than the Sobol sequence: 2^32 photons later nothing may repeat.
  TestMesh mesh;
  mesh.AddBox({ -1.0, -1.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0);
  const Light light = DiscLight({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, -1.0 }, 0.5);
  const PhotonEmission emission(light, mesh.View());
  for (const vtkIdType later : { vtkIdType(1) << 32, vtkIdType(1) << 40 })
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const EmittedPhoton first = emission.Emit(1, i);
      const EmittedPhoton other = emission.Emit(1, i + later);
      EXPECT_GT(Length(first.Origin - other.Origin) + Length(first.Direction - other.Direction), 1e-3) << later;
    }
  }
}
