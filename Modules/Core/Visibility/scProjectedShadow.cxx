// SPDX-License-Identifier: BSD-3-Clause
#include "scProjectedShadow.h"

#include "scConstants.h"
#include "scConvexGap.h"
#include "scConvexSolid.h"
#include "scDisjointSets.h"
#include "scPointWelding.h"
#include "scSurfacePatches.h"
#include "scTriangleSides.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace shadowcones
{
namespace
{
/// Points may lie so far outside of a convex part, over its size, for rounding: the meshes are often in single precision.
constexpr double flatness = 1e-6;
/// Faces whose normal turns less than this to the light are edge-on.
constexpr double edgeOn = 1e-12;

/// Triangles that hang together.
struct Part
{
  std::vector<vtkIdType> Triangles;
};

/// A mesh whose points in one place are one, and who neighbours whom.
struct WeldedMesh
{
  explicit WeldedMesh(const TriangleMeshView& mesh)
    : Mesh(mesh)
  {
    const std::vector<vtkIdType> kept = WeldPoints(mesh, nullptr, 0.0);
    for (vtkIdType i = 0; i < 3 * mesh.NumberOfTriangles; ++i)
    {
      this->Topology.Triangles.push_back(kept[mesh.Triangles[i]]);
    }
    this->Topology.Points.resize(static_cast<std::size_t>(mesh.NumberOfPoints));
    this->Topology.OccluderIds.assign(static_cast<std::size_t>(mesh.NumberOfTriangles), 0);
    this->Opposite = PairSides(this->Topology);
  }
  vtkIdType Id(vtkIdType side) const { return this->Topology.Triangles[side]; }
  Vector3 Corner(vtkIdType side) const { return this->Mesh.Point(this->Id(side)); }
  Vector3 NormalOf(vtkIdType t) const
  {
    const Vector3 a = this->Corner(3 * t);
    return Normalized(Cross(this->Corner(3 * t + 1) - a, this->Corner(3 * t + 2) - a));
  }
  std::vector<Part> Parts() const
  {
    DisjointSets sets(this->Mesh.NumberOfPoints);
    for (vtkIdType t = 0; t < this->Mesh.NumberOfTriangles; ++t)
    {
      sets.Unite(this->Id(3 * t), this->Id(3 * t + 1));
      sets.Unite(this->Id(3 * t), this->Id(3 * t + 2));
    }
    std::map<vtkIdType, Part> parts;
    for (vtkIdType t = 0; t < this->Mesh.NumberOfTriangles; ++t)
    {
      parts[sets.Root(this->Id(3 * t))].Triangles.push_back(t);
    }
    std::vector<Part> all;
    for (auto& part : parts)
    {
      all.push_back(std::move(part.second));
    }
    return all;
  }

  TriangleMeshView Mesh;
  OccluderTopology Topology;
  std::vector<vtkIdType> Opposite;
};

/// A part as a convex body, or as a sheet.
class ConvexPart
{
public:
  ConvexPart(const WeldedMesh& mesh, const Part& part)
    : Mesh(mesh)
    , Triangles(part.Triangles)
  {
    for (const vtkIdType t : this->Triangles)
    {
      for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
      {
        this->Extent.Add(mesh.Corner(side));
        this->Sheet = this->Sheet || mesh.Opposite[side] < 0;
      }
    }
    this->Tolerance = flatness * this->Extent.Diagonal();
    this->Turn = this->Sheet ? 1.0 : (this->SignedVolume() < 0.0 ? -1.0 : 1.0);
  }

  bool IsConvex() const { return this->IsWoundAlike() && (this->Sheet ? this->IsConvexSheet() : this->IsConvexBody()); }
  const Box& Bounds() const { return this->Extent; }

  /// The part and all behind it up to far copies. @return false where the light is inside.
  bool Extrude(const Light& light, const Box& bounds, ConvexSolid& solid) const;

private:
  Vector3 Outward(vtkIdType t) const { return this->Turn * this->Mesh.NormalOf(t); }

  double SignedVolume() const
  {
    double volume = 0.0;
    const Vector3 origin = this->Extent.Center();
    for (const vtkIdType t : this->Triangles)
    {
      volume += Dot(this->Mesh.Corner(3 * t) - origin,
        Cross(this->Mesh.Corner(3 * t + 1) - origin, this->Mesh.Corner(3 * t + 2) - origin));
    }
    return volume;
  }

  bool IsWoundAlike() const
  {
    return std::all_of(this->Triangles.begin(), this->Triangles.end(),
      [this](vtkIdType t)
      {
        bool alike = true;
        for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
        {
          const vtkIdType other = this->Mesh.Opposite[side];
          alike = alike && (other < 0 || this->Mesh.Id(side) != this->Mesh.Id(other));
        }
        return alike;
      });
  }

  /// Every edge is convex, and the faces cover the directions from the middle once.
  bool IsConvexBody() const
  {
    const Vector3 middle = this->Extent.Center();
    double covered = 0.0;
    for (const vtkIdType t : this->Triangles)
    {
      const Vector3 normal = this->Outward(t);
      const Vector3 a = this->Mesh.Corner(3 * t);
      if (!(Dot(a - middle, normal) > 0.0))
      {
        return false;
      }
      for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
      {
        const vtkIdType other = this->Mesh.Opposite[side];
        const vtkIdType apex = NextSide(NextSide(other));
        if (Dot(this->Mesh.Corner(apex) - a, normal) > this->Tolerance)
        {
          return false;
        }
      }
      const Vector3 p = a - middle;
      const Vector3 q = this->Mesh.Corner(3 * t + 1) - middle;
      const Vector3 r = this->Mesh.Corner(3 * t + 2) - middle;
      const double volume = this->Turn * Dot(p, Cross(q, r));
      covered += 2.0 *
        std::atan2(volume,
          Length(p) * Length(q) * Length(r) + Dot(p, q) * Length(r) + Dot(q, r) * Length(p) + Dot(r, p) * Length(q));
    }
    return std::fabs(covered - FourPi) < 0.01 * FourPi;
  }

  /// All points lie in one plane, behind each border.
  bool IsConvexSheet() const
  {
    const Vector3 normal = this->SheetNormal();
    const Vector3 origin = this->Mesh.Corner(3 * this->Triangles.front());
    for (const vtkIdType t : this->Triangles)
    {
      if (!(Dot(this->Mesh.NormalOf(t), normal) > 0.5))
      {
        return false;
      }
      for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
      {
        const Vector3 a = this->Mesh.Corner(side);
        if (std::fabs(Dot(a - origin, normal)) > this->Tolerance ||
          (this->Mesh.Opposite[side] < 0 && !this->IsBehind(a, this->Mesh.Corner(NextSide(side)), normal)))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool IsBehind(const Vector3& a, const Vector3& b, const Vector3& normal) const
  {
    const Vector3 outward = Normalized(Cross(b - a, normal));
    return std::all_of(this->Triangles.begin(), this->Triangles.end(),
      [&](vtkIdType t)
      {
        bool behind = true;
        for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
        {
          behind = behind && Dot(this->Mesh.Corner(side) - a, outward) <= this->Tolerance;
        }
        return behind;
      });
  }

  Vector3 SheetNormal() const
  {
    Vector3 sum;
    for (const vtkIdType t : this->Triangles)
    {
      const Vector3 a = this->Mesh.Corner(3 * t);
      sum += Cross(this->Mesh.Corner(3 * t + 1) - a, this->Mesh.Corner(3 * t + 2) - a);
    }
    return Normalized(sum);
  }

  const WeldedMesh& Mesh;
  const std::vector<vtkIdType>& Triangles;
  Box Extent;
  double Tolerance = 0.0;
  double Turn = 1.0; ///< -1: the triangles are wound inward
  bool Sheet = false;
};

/// Moves points away from the light, to beyond the bounds.
struct Projector
{
  bool AtInfinity = false;
  Vector3 Center; ///< a Sun: the way that the light travels
  double Factor = 0.0;

  Vector3 Far(const Vector3& p) const
  {
    return this->AtInfinity ? p + this->Factor * this->Center : this->Center + this->Factor * (p - this->Center);
  }
  /// Unit, from a point to the light.
  Vector3 ToLight(const Vector3& p) const { return this->AtInfinity ? -this->Center : Normalized(this->Center - p); }
};

Vector3 PlaceOf(const Light& light)
{
  return light.Shape == LightShape::Mesh ? light.Vertices.front() : light.Center;
}
} // anonymous namespace

bool ConvexPart::Extrude(const Light& light, const Box& bounds, ConvexSolid& solid) const
{
  Projector projector;
  projector.AtInfinity = IsAtInfinity(light);
  projector.Center = projector.AtInfinity ? light.Normal : PlaceOf(light);
  const double turn =
    this->Sheet && Dot(this->SheetNormal(), projector.ToLight(this->Mesh.Corner(3 * this->Triangles.front()))) < 0.0
    ? -1.0
    : this->Turn;

  // The face that the light stands highest over tells the way that everything moves.
  std::map<vtkIdType, bool> turned;
  Vector3 away = projector.AtInfinity ? light.Normal : Vector3{};
  double highest = 0.0;
  for (const vtkIdType t : this->Triangles)
  {
    const Vector3 normal = turn * this->Mesh.NormalOf(t);
    const Vector3 corner = this->Mesh.Corner(3 * t);
    turned[t] = Dot(normal, projector.ToLight(corner)) > edgeOn;
    const double height = projector.AtInfinity ? 0.0 : Dot(normal, projector.Center - corner);
    away = height > highest ? -normal : away;
    highest = std::max(highest, height);
  }
  if (std::none_of(turned.begin(), turned.end(), [](const auto& face) { return face.second; }))
  {
    return this->Sheet; // edge-on: it casts nothing
  }
  const double end = Dot(BoxBody(bounds).Farthest(away), away);
  double nearest = HUGE_VAL;
  for (const vtkIdType t : this->Triangles)
  {
    for (vtkIdType side = 3 * t; side < 3 * t + 3; ++side)
    {
      nearest = std::min(nearest, Dot(this->Mesh.Corner(side), away));
    }
  }
  const double from = projector.AtInfinity ? 0.0 : Dot(projector.Center, away);
  projector.Factor = projector.AtInfinity ? std::max(0.0, end - nearest) + this->Extent.Diagonal() + bounds.Diagonal()
                                          : 2.0 + 1.5 * std::max(0.0, end - from) / (nearest - from);

  std::map<vtkIdType, vtkIdType> nearIds;
  std::map<vtkIdType, vtkIdType> farIds;
  const auto idOf = [&](vtkIdType side, bool near)
  {
    auto& ids = near ? nearIds : farIds;
    const auto found = ids.emplace(this->Mesh.Id(side), solid.Points.size());
    if (found.second)
    {
      solid.Points.push_back(near ? this->Mesh.Corner(side) : projector.Far(this->Mesh.Corner(side)));
    }
    return found.first->second;
  };
  const auto addFace = [&](vtkIdType t, bool near, bool flip)
  {
    const vtkIdType a = 3 * t;
    solid.Faces.push_back({ idOf(a, near), idOf(flip ? a + 2 : a + 1, near), idOf(flip ? a + 1 : a + 2, near) });
  };
  const bool flip = turn < 0.0;
  for (const vtkIdType t : this->Triangles)
  {
    const bool near = turned[t];
    addFace(t, near, flip);
    if (this->Sheet)
    {
      addFace(t, false, !flip);
    }
    for (vtkIdType side = 3 * t; side < 3 * t + 3 && near; ++side)
    {
      const vtkIdType other = this->Mesh.Opposite[side];
      if (this->Sheet ? other < 0 : !turned[other / 3])
      {
        const vtkIdType a = flip ? NextSide(side) : side;
        const vtkIdType b = flip ? side : NextSide(side);
        solid.Faces.push_back({ idOf(b, true), idOf(a, true), idOf(a, false), idOf(b, false) });
      }
    }
  }
  return true;
}

bool HasHardShadows(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Sun && light.Radius == 0.0) ||
    (light.Shape == LightShape::Mesh && light.Triangles.empty() && light.Vertices.size() == 1);
}

bool ProjectShadow(
  const TriangleMeshView& mesh, const Light& light, const Box& bounds, ProjectedShadow& shadow, std::string& error)
{
  const WeldedMesh welded(mesh);
  for (const Part& part : welded.Parts())
  {
    const ConvexPart body(welded, part);
    if (!body.IsConvex())
    {
      error = "is neither a closed convex body nor a flat convex sheet, for which alone Projection is exact: use "
              "SetMethodToVisibility().";
      return false;
    }
    ConvexSolid solid;
    if (!body.Extrude(light, bounds, solid))
    {
      error = "has the light inside: all of space is in its shadow. Move the light.";
      return false;
    }
    solid.CutTo(bounds);
    if (!solid.Empty())
    {
      solid.AppendTo(shadow.Points, shadow.Triangles);
      ++shadow.NumberOfSolids;
    }
  }
  return true;
}

} // namespace shadowcones
