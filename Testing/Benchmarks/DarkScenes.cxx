// SPDX-License-Identifier: BSD-3-Clause
#include "DarkScenes.h"

#include "scRandom.h"
#include "vtkAreaLightSource.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shadowcones
{
namespace
{
class MeshMaker
{
public:
  void AddQuad(const Vector3& corner, const Vector3& u, const Vector3& v)
  {
    vtkIdType ids[4];
    const Vector3 corners[4] = { corner, corner + u, corner + u + v, corner + v };
    for (int k = 0; k < 4; ++k)
    {
      ids[k] = this->Points->InsertNextPoint(corners[k].X, corners[k].Y, corners[k].Z);
    }
    this->Cells->InsertNextCell(4, ids);
  }
  void AddBrick(double x0, double x1, double y0, double y1, double z0, double z1)
  {
    const Vector3 u{ x1 - x0, 0.0, 0.0 };
    const Vector3 v{ 0.0, y1 - y0, 0.0 };
    const Vector3 w{ 0.0, 0.0, z1 - z0 };
    const Vector3 low{ x0, y0, z0 };
    const Vector3 high{ x1, y1, z1 };
    this->AddQuad(low, v, u);
    this->AddQuad(low, w, v);
    this->AddQuad(low, u, w);
    this->AddQuad(high, -u, -v);
    this->AddQuad(high, -v, -w);
    this->AddQuad(high, -w, -u);
  }
  /// Walls, floor and ceiling of a thickness around what lies inside.
  void AddRoom(const Box& inside, double t, bool firstWall)
  {
    const Vector3& a = inside.Min;
    const Vector3& b = inside.Max;
    this->AddBrick(a.X - t, b.X + t, a.Y - t, a.Y, a.Z, b.Z);
    this->AddBrick(a.X - t, b.X + t, b.Y, b.Y + t, a.Z, b.Z);
    this->AddBrick(b.X, b.X + t, a.Y, b.Y, a.Z, b.Z);
    this->AddBrick(a.X - t, b.X + t, a.Y - t, b.Y + t, a.Z - t, a.Z);
    this->AddBrick(a.X - t, b.X + t, a.Y - t, b.Y + t, b.Z, b.Z + t);
    if (firstWall)
    {
      this->AddBrick(a.X - t, a.X, a.Y, b.Y, a.Z, b.Z);
    }
  }
  /// A prism that stands on the floor.
  void AddColumn(double x, double z, double radius, double height)
  {
    constexpr int sides = 16;
    const auto at = [&](int k)
    {
      return Vector3{ x + radius * std::cos(6.28318530717958647692 * k / sides), 0.0,
        z + radius * std::sin(6.28318530717958647692 * k / sides) };
    };
    for (int k = 0; k < sides; ++k)
    {
      this->AddQuad(at(k), { 0.0, height, 0.0 }, at(k + 1) - at(k));
    }
  }
  vtkSmartPointer<vtkPolyData> Make() const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Cells);
    return mesh;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

vtkSmartPointer<vtkPolyData> Sun(double x, double y, double z)
{
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToSun();
  light->SetNormal(x, y, z);
  light->SetRadiance(10.0);
  light->Update();
  return light->GetOutput();
}

Camera LookAt(const Vector3& from, const Vector3& to, double halfHeight)
{
  Camera camera;
  camera.Position = from;
  camera.Forward = Normalized(to - from);
  camera.Right = Normalized(Cross(camera.Forward, { 0.0, 1.0, 0.0 }));
  camera.Up = Cross(camera.Right, camera.Forward);
  camera.HalfHeight = halfHeight;
  return camera;
}

Medium Air(const Box& bounds, double sigmaS, double asymmetry)
{
  Medium medium;
  medium.SigmaS = { sigmaS };
  medium.SigmaA = { 0.0 };
  medium.Bounds = bounds;
  medium.Phase.Kind = PhaseFunctionKind::HenyeyGreenstein;
  medium.Phase.Asymmetry = asymmetry;
  return medium;
}

DarkScene Blinds()
{
  MeshMaker mesh;
  const Box room{ { 0.0, 0.0, -2.0 }, { 6.0, 3.0, 2.0 } };
  mesh.AddRoom(room, 0.1, false);
  mesh.AddBrick(-0.1, 0.0, 0.0, 0.9, -2.0, 2.0); // a wall with a window
  mesh.AddBrick(-0.1, 0.0, 2.5, 3.0, -2.0, 2.0);
  mesh.AddBrick(-0.1, 0.0, 0.9, 2.5, -2.0, -1.2);
  mesh.AddBrick(-0.1, 0.0, 0.9, 2.5, 1.2, 2.0);
  for (int k = 0; k < 14; ++k)
  {
    mesh.AddBrick(-0.06, -0.02, 0.92 + 0.115 * k, 0.97 + 0.115 * k, -1.2, 1.2);
  }
  mesh.AddBrick(2.2, 3.4, 0.7, 0.75, -0.6, 0.6); // a table
  for (const double x : { 2.25, 3.3 })
  {
    for (const double z : { -0.55, 0.5 })
    {
      mesh.AddBrick(x, x + 0.06, 0.0, 0.7, z, z + 0.06);
    }
  }
  return { mesh.Make(), Sun(1.0, -0.42, -0.12), Air(room, 0.12, 0.4),
    LookAt({ 4.6, 1.6, 1.85 }, { 1.2, 1.3, -0.4 }, 0.6) };
}

DarkScene Canopy()
{
  MeshMaker mesh;
  for (std::uint64_t leaf = 0; leaf < 4000; ++leaf)
  {
    RandomStream random(7, leaf);
    const Vector3 center{ 12.0 * random.Next() - 6.0, 3.2 + 1.6 * random.Next(), 12.0 * random.Next() - 6.0 };
    const double z = 2.0 * random.Next() - 1.0;
    const double angle = 6.28318530717958647692 * random.Next();
    const double across = std::sqrt(1.0 - z * z);
    const Vector3 normal{ across * std::cos(angle), across * std::sin(angle), z };
    const Vector3 other = std::fabs(z) < 0.9 ? Vector3{ 0.0, 0.0, 1.0 } : Vector3{ 1.0, 0.0, 0.0 };
    const Vector3 u = Normalized(Cross(normal, other));
    const Vector3 v = Cross(normal, u);
    mesh.AddQuad(center - 0.16 * u - 0.1 * v, 0.32 * u, 0.2 * v);
  }
  return { mesh.Make(), Sun(0.25, -1.0, -0.1), Air({ { -6.0, 0.0, -6.0 }, { 6.0, 5.0, 6.0 } }, 0.06, 0.3),
    LookAt({ 0.0, 1.7, 9.0 }, { 0.0, 2.2, 0.0 }, 0.47) };
}

DarkScene Holes()
{
  MeshMaker mesh;
  const Box room{ { -2.0, 0.0, -2.0 }, { 2.0, 4.0, 2.0 } };
  mesh.AddRoom(room, 0.1, true);
  // A plate across the room at y = 3: bars between 6 x 6 holes of .08, .5 apart, and what is left beside them.
  constexpr int holes = 6;
  constexpr double first = -1.29;
  constexpr double size = 0.08;
  constexpr double apart = 0.5;
  for (int row = 0; row <= holes; ++row)
  {
    const double z0 = row == 0 ? -2.0 : first + apart * (row - 1) + size;
    const double z1 = row == holes ? 2.0 : first + apart * row;
    mesh.AddQuad({ -2.0, 3.0, z0 }, { 0.0, 0.0, z1 - z0 }, { 4.0, 0.0, 0.0 });
    for (int column = 0; row < holes && column <= holes; ++column)
    {
      const double x0 = column == 0 ? -2.0 : first + apart * (column - 1) + size;
      const double x1 = column == holes ? 2.0 : first + apart * column;
      mesh.AddQuad({ x0, 3.0, z1 }, { 0.0, 0.0, size }, { x1 - x0, 0.0, 0.0 });
    }
  }
  vtkNew<vtkAreaLightSource> light;
  light->SetShapeToDisc();
  light->SetCenter(0.1, 3.9, 0.05);
  light->SetNormal(0.0, -1.0, 0.0);
  light->SetRadius(0.06);
  light->SetRadiance(100.0);
  light->Update();
  return { mesh.Make(), light->GetOutput(), Air({ { -2.0, 0.0, -2.0 }, { 2.0, 3.0, 2.0 } }, 0.1, 0.2),
    LookAt({ -0.6, 1.4, 1.95 }, { 0.2, 1.5, -1.0 }, 0.75) };
}

DarkScene Colonnade()
{
  MeshMaker mesh;
  const Box hall{ { -8.0, 0.0, -2.5 }, { 8.0, 5.0, 2.5 } };
  mesh.AddBrick(-8.2, 8.2, -0.2, 0.0, -6.0, 6.0);
  mesh.AddBrick(-8.2, 8.2, 5.0, 5.3, -3.2, 3.2);
  mesh.AddBrick(-8.2, 8.2, 0.0, 5.0, -3.0, -2.5); // the wall behind
  mesh.AddBrick(-8.2, -8.0, 0.0, 5.0, -2.5, 2.7);
  mesh.AddBrick(8.0, 8.2, 0.0, 5.0, -2.5, 2.7);
  mesh.AddBrick(-8.2, 8.2, 4.2, 5.0, 2.5, 2.9); // what the columns bear
  for (int k = 0; k < 14; ++k)
  {
    mesh.AddColumn(-7.5 + 15.0 * k / 13.0, 2.7, 0.38, 4.2);
  }
  return { mesh.Make(), Sun(0.9, -0.75, -1.0), Air(hall, 0.05, 0.5),
    LookAt({ -7.6, 1.7, -1.9 }, { 8.0, 1.6, 1.2 }, 0.5) };
}
} // anonymous namespace

//------------------------------------------------------------------------------
const std::vector<std::string>& DarkSceneNames()
{
  static const std::vector<std::string> names = { "blinds", "canopy", "holes", "colonnade" };
  return names;
}

//------------------------------------------------------------------------------
bool IsDarkScene(const std::string& name)
{
  const std::vector<std::string>& names = DarkSceneNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

//------------------------------------------------------------------------------
DarkScene MakeDarkScene(const std::string& name)
{
  if (!IsDarkScene(name))
  {
    throw std::runtime_error("No scene '" + name + "': give blinds, canopy, holes or colonnade.");
  }
  return name == "blinds" ? Blinds() : name == "canopy" ? Canopy() : name == "holes" ? Holes() : Colonnade();
}

} // namespace shadowcones
