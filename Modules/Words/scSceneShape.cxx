// SPDX-License-Identifier: BSD-3-Clause
#include "scSceneShape.h"

#include "scOccluderScene.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

namespace
{

constexpr double Degree = 3.14159265358979323846 / 180.0;

Vector3 Axis(int axis, double length = 1.0)
{
  return { axis == 0 ? length : 0.0, axis == 1 ? length : 0.0, axis == 2 ? length : 0.0 };
}

// The axis that is up: away from which the lights shine, else in which the mesh is flat or tall, else y.
int AxisThatIsUp(const Vector3& size, const std::vector<Light>& lights)
{
  for (const Light& light : lights)
  {
    const bool directed =
      light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle || light.Shape == LightShape::Sun;
    const Vector3 towards = -light.Normal;
    if (directed && std::max(towards.Y, towards.Z) > 0.3)
    {
      return towards.Z > towards.Y ? 2 : 1;
    }
  }
  if (size.Y < 0.5 * std::min(size.X, size.Z) || size.Z < 0.5 * std::min(size.X, size.Y))
  {
    return size.Z < size.Y ? 2 : 1;
  }
  return size.Z > 1.5 * std::max(size.X, size.Y) ? 2 : 1;
}

// Heights of all surfaces above a place of the ground, ascending, as shares of the mesh's height.
std::vector<double> HeightsAt(const OccluderScene& scene, const SceneShape& shape, double u, double v)
{
  const int up = shape.Up;
  const Vector3 size = shape.Bounds.Size();
  const double below = 0.1 * size[up];
  const Vector3 start = shape.Bounds.Min + Axis((up + 1) % 3, u * size[(up + 1) % 3]) +
    Axis((up + 2) % 3, v * size[(up + 2) % 3]) - Axis(up, below);
  std::vector<RayHit> hits;
  scene.IntersectAll(start, Axis(up), 0.0, HUGE_VAL, hits);
  std::vector<double> heights;
  for (const RayHit& hit : hits)
  {
    heights.push_back((hit.T - below) / size[up]);
  }
  return heights;
}

struct Lid
{
  double Covered = 0.0; // share of the ground under a ceiling with room below it
  double Filled = 0.0;  // share of the ground where something stands between floor and ceiling
  double Height = 1.0;  // of the ceiling's lower side, a share of the mesh's height
};

Lid FindLid(const OccluderScene& scene, const SceneShape& shape)
{
  constexpr int count = 15;
  Lid lid;
  for (int i = 0; i < count * count; ++i)
  {
    // Off the middle and off regular places, where edges like to be.
    const double u = (i % count + 0.5137) / count;
    const double v = (i / count + 0.4871) / count;
    double ceiling = 2.0;
    double below = 0.0;
    bool filled = false;
    for (const double height : HeightsAt(scene, shape, u, v))
    {
      ceiling = height > 0.9 ? std::min(ceiling, height) : ceiling;
      below = height <= 0.9 ? height : below;
      filled = filled || (height > 0.03 && height < 0.85);
    }
    if (ceiling < 2.0 && below < 0.6)
    {
      lid.Covered += 1.0 / (count * count);
      lid.Height = std::min(lid.Height, ceiling);
    }
    lid.Filled += filled ? 1.0 / (count * count) : 0.0;
  }
  return lid;
}

// The share of a side that rays from inside meet a wall at, in its outer tenth.
double WallAt(const OccluderScene& scene, const SceneShape& shape, int axis, double sign)
{
  constexpr int count = 7;
  const Vector3 size = shape.Bounds.Size();
  const int across = 3 - axis - shape.Up;
  int walls = 0;
  for (int i = 0; i < count * count; ++i)
  {
    const double u = 0.1 + 0.8 * (i % count + 0.5137) / count;
    const double v = 0.1 + 0.75 * (i / count + 0.4871) / count;
    const Vector3 start = shape.Bounds.Min + Axis(axis, (0.5 + sign * 0.4) * size[axis]) + Axis(across, u * size[across]) +
      Axis(shape.Up, v * size[shape.Up]);
    walls += scene.Occluded(start, Axis(axis, sign), 0.0, HUGE_VAL) ? 1 : 0;
  }
  return static_cast<double>(walls) / (count * count);
}

void FindRoom(const TriangleMeshView& mesh, SceneShape& shape)
{
  const OccluderScene scene(mesh);
  const Lid lid = FindLid(scene, shape);
  if (lid.Covered < 0.6)
  {
    return;
  }
  int walls = 0;
  double least = 2.0;
  // The front first, then right, back and left: of several open sides the first one.
  for (const Vector3& side : { shape.Front, Cross(Axis(shape.Up), shape.Front), -shape.Front,
         Cross(shape.Front, Axis(shape.Up)) })
  {
    const int axis = std::fabs(side.X) > 0.5 ? 0 : std::fabs(side.Y) > 0.5 ? 1 : 2;
    const double wall = WallAt(scene, shape, axis, side[axis]);
    walls += wall > 0.5 ? 1 : 0;
    if (wall < least - 0.1)
    {
      least = wall;
      shape.Front = side;
    }
  }
  shape.Open = walls < 4;
  // A closed box with nothing in it is a thing to be looked at from outside.
  shape.Room = walls >= 2 && (shape.Open || lid.Filled > 0.02);
  shape.Ceiling = shape.Bounds.Min[shape.Up] + lid.Height * shape.Bounds.Size()[shape.Up];
}

// The least distance from the middle of a box at which a camera that looks along a direction sees all of it.
double DistanceToSee(const Box& box, const CameraPlace& camera, double aspect)
{
  const Vector3 back = Normalized(camera.Position - camera.FocalPoint);
  const Vector3 right = Normalized(Cross(camera.ViewUp, back));
  const Vector3 above = Cross(back, right);
  const double vertical = std::tan(0.5 * camera.ViewAngle * Degree);
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 p{ corner & 1 ? box.Max.X : box.Min.X, corner & 2 ? box.Max.Y : box.Min.Y,
      corner & 4 ? box.Max.Z : box.Min.Z };
    const Vector3 q = p - camera.FocalPoint;
    const double high = std::fabs(Dot(q, above)) / vertical;
    const double wide = std::fabs(Dot(q, right)) / (vertical * aspect);
    distance = std::max(distance, Dot(q, back) + std::max(high, wide));
  }
  return distance;
}

double LargestSide(const Box& box)
{
  const Vector3 size = box.Size();
  return std::max({ size.X, size.Y, size.Z });
}

// Widen a box to hold a lamp that is not far from the mesh.
void AddIfNear(const SceneShape& shape, const Light& light, Box& box)
{
  Vector3 center;
  double radius = 0.0;
  LightBoundingSphere(light, center, radius);
  const bool near = Length(center - shape.Bounds.Center()) + radius < 4.0 * LargestSide(shape.Bounds);
  if (!IsAtInfinity(light) && near)
  {
    const Vector3 half{ radius, radius, radius };
    box.Add(center + half);
    box.Add(center - half);
  }
}

CameraPlace CameraInRoom(const SceneShape& shape, double aspect)
{
  CameraPlace camera;
  const Vector3 center = shape.Bounds.Center();
  const Vector3 size = shape.Bounds.Size();
  const Vector3 right = Cross(Axis(shape.Up), shape.Front);
  const auto along = [&](const Vector3& a) { return std::fabs(Dot(size, a)); };
  camera.ViewUp = Axis(shape.Up);
  if (shape.Open)
  {
    // Far enough to see the whole of the open side, and no wall beside it.
    const double vertical = std::tan(0.5 * camera.ViewAngle * Degree);
    const double distance = 0.5 * std::max(along(Axis(shape.Up)), along(right) / aspect) / vertical;
    camera.FocalPoint = center;
    camera.Position = center + (0.5 * along(shape.Front) + 1.02 * distance) * shape.Front;
    return camera;
  }
  // From a corner over to the other side.
  camera.ViewAngle = 60.0;
  camera.Position = center + (0.44 * along(shape.Front)) * shape.Front + (0.36 * along(right)) * right +
    Axis(shape.Up, 0.1 * along(Axis(shape.Up)));
  camera.FocalPoint = center - (0.2 * along(shape.Front)) * shape.Front - Axis(shape.Up, 0.05 * along(Axis(shape.Up)));
  return camera;
}

} // namespace

SceneShape LookAtMesh(const TriangleMeshView& mesh, const std::vector<Light>& lights, int up)
{
  SceneShape shape;
  shape.Bounds = MeshBounds(mesh);
  if (shape.Bounds.Empty())
  {
    shape.Bounds.Add(Vector3{ -0.5, -0.5, -0.5 });
    shape.Bounds.Add(Vector3{ 0.5, 0.5, 0.5 });
  }
  // What is flat has a height too, so that nothing is divided by 0.
  const double least = std::max(1e-3 * LargestSide(shape.Bounds), 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (shape.Bounds.Size()[axis] < least)
    {
      const Vector3 middle = shape.Bounds.Center();
      shape.Bounds.Add(middle + Axis(axis, 0.5 * least));
      shape.Bounds.Add(middle - Axis(axis, 0.5 * least));
    }
  }
  shape.Up = up >= 0 ? up : AxisThatIsUp(shape.Bounds.Size(), lights);
  // Who looks along the third axis has x to the right.
  shape.Front = Cross(Axis(0), Axis(shape.Up));
  if (shape.Up == 0)
  {
    shape.Front = Axis(2);
  }
  if (mesh.NumberOfTriangles > 0)
  {
    FindRoom(mesh, shape);
  }
  return shape;
}

Light DefaultLamp(const SceneShape& shape)
{
  Light lamp;
  const Vector3 center = shape.Bounds.Center();
  const Vector3 size = shape.Bounds.Size();
  const double width = std::min(size[(shape.Up + 1) % 3], size[(shape.Up + 2) % 3]);
  const double largest = LargestSide(shape.Bounds);
  lamp.Normal = Axis(shape.Up, -1.0);
  if (shape.Room)
  {
    lamp.Radius = 0.09 * width;
    lamp.Center = center + Axis(shape.Up, shape.Ceiling - 0.005 * size[shape.Up] - center[shape.Up]);
    return lamp;
  }
  // Above and beside it, so that its shadow falls where nothing hides it.
  const Vector3 left = Cross(shape.Front, Axis(shape.Up));
  const Vector3 towards = Normalized(Axis(shape.Up) + 0.6 * left + 0.15 * shape.Front);
  lamp.Radius = 0.07 * largest;
  lamp.Center = center + (0.5 * size[shape.Up] + 0.5 * largest) / towards[shape.Up] * towards;
  lamp.Normal = -towards;
  return lamp;
}

Box DefaultMedium(const SceneShape& shape, const std::vector<Light>& lights)
{
  Box medium = shape.Bounds;
  if (shape.Room)
  {
    return medium;
  }
  const double largest = LargestSide(shape.Bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Not below the ground that the mesh stands on.
    const double more = (axis == shape.Up ? 0.2 : 0.8) * largest;
    medium.Max += Axis(axis, more);
    medium.Min += Axis(axis, axis == shape.Up ? 0.0 : -more);
  }
  for (const Light& light : lights)
  {
    AddIfNear(shape, light, medium);
  }
  return medium;
}

CameraPlace DefaultCamera(const SceneShape& shape, const std::vector<Light>& lights, double aspect)
{
  if (shape.Room)
  {
    return CameraInRoom(shape, aspect);
  }
  CameraPlace camera;
  const Vector3 right = Cross(Axis(shape.Up), shape.Front);
  camera.ViewUp = Axis(shape.Up);
  // The mesh and lamps near by, with a margin; the medium goes on beyond the picture.
  Box seen = shape.Bounds;
  for (const Light& light : lights)
  {
    AddIfNear(shape, light, seen);
  }
  const Vector3 margin = 0.05 * seen.Size();
  seen.Add(seen.Max + margin);
  seen.Add(seen.Min - margin);
  camera.FocalPoint = seen.Center();
  const Vector3 towards = Normalized(shape.Front + 0.35 * right + Axis(shape.Up, 0.25));
  camera.Position = camera.FocalPoint + towards;
  camera.Position = camera.FocalPoint + DistanceToSee(seen, camera, aspect) * towards;
  return camera;
}

double DefaultSigmaS(const Box& medium)
{
  return 0.7 / LargestSide(medium);
}

} // namespace shadowcones
