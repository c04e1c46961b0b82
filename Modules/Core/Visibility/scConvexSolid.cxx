// SPDX-License-Identifier: BSD-3-Clause
#include "scConvexSolid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shadowcones
{
namespace
{
/// Triangles with less than this share of a square over their longest edge have no area.
constexpr double leastArea = 1e-12;

void SetAxis(Vector3& point, int axis, double value)
{
  (axis == 0 ? point.X : axis == 1 ? point.Y : point.Z) = value;
}

/// One cut of a solid: what becomes of its faces, and the loop that is left open.
class Cutter
{
public:
  Cutter(ConvexSolid& solid, const std::vector<double>& heights, int axis, double value)
    : Solid(solid)
    , Heights(heights)
    , Axis(axis)
    , Value(value)
  {
  }

  void Run()
  {
    std::vector<std::vector<vtkIdType>> faces;
    for (const auto& face : this->Solid.Faces)
    {
      std::vector<vtkIdType> kept = this->Keep(face);
      if (kept.size() > 2)
      {
        faces.push_back(std::move(kept));
      }
    }
    while (!this->Next.empty())
    {
      std::vector<vtkIdType> lid;
      for (auto link = this->Next.begin(); link != this->Next.end();)
      {
        const vtkIdType to = link->second;
        lid.push_back(link->first);
        this->Next.erase(link);
        link = this->Next.find(to);
      }
      if (lid.size() > 2)
      {
        faces.push_back(std::move(lid));
      }
    }
    this->Solid.Faces.swap(faces);
  }

private:
  bool IsKept(vtkIdType point) const { return this->Heights[point] <= 0.0; }

  /// Where the edge between a kept and a removed point meets the plane: a point of the solid, if that is the kept one.
  vtkIdType Meet(vtkIdType kept, vtkIdType removed)
  {
    const double a = this->Heights[kept];
    const double b = this->Heights[removed];
    if (a == 0.0)
    {
      return kept;
    }
    const auto found = this->Cuts.emplace(std::make_pair(kept, removed), this->Solid.Points.size());
    if (found.second)
    {
      const Vector3 from = this->Solid.Points[kept];
      Vector3 point = from + (a / (a - b)) * (this->Solid.Points[removed] - from);
      SetAxis(point, this->Axis, this->Value);
      this->Solid.Points.push_back(point);
    }
    return found.first->second;
  }

  std::vector<vtkIdType> Keep(const std::vector<vtkIdType>& face)
  {
    std::vector<vtkIdType> kept;
    vtkIdType leave = -1;
    vtkIdType enter = -1;
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const vtkIdType here = face[k];
      const vtkIdType next = face[(k + 1) % face.size()];
      if (this->IsKept(here))
      {
        kept.push_back(here);
      }
      if (this->IsKept(here) != this->IsKept(next))
      {
        const vtkIdType met = this->IsKept(here) ? this->Meet(here, next) : this->Meet(next, here);
        (this->IsKept(here) ? leave : enter) = met;
        if (met != here && met != next)
        {
          kept.push_back(met);
        }
      }
    }
    if (leave != enter)
    {
      this->Next[enter] = leave;
    }
    return kept;
  }

  ConvexSolid& Solid;
  const std::vector<double>& Heights;
  int Axis;
  double Value;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Cuts;
  std::map<vtkIdType, vtkIdType> Next; ///< around the lid
};

double SquaredEdge(const Vector3& a, const Vector3& b)
{
  return Dot(b - a, b - a);
}

bool HasArea(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double longest = std::max({ SquaredEdge(a, b), SquaredEdge(b, c), SquaredEdge(c, a) });
  return Length(Cross(b - a, c - a)) > leastArea * longest;
}
} // anonymous namespace

void ConvexSolid::Cut(int axis, double value, double sign, double rounding)
{
  std::vector<double> heights;
  bool anyInside = false;
  bool anyOutside = false;
  for (Vector3& point : this->Points)
  {
    if (std::fabs(point[axis] - value) <= rounding)
    {
      SetAxis(point, axis, value);
    }
    heights.push_back(sign * (point[axis] - value));
  }
  for (const auto& face : this->Faces)
  {
    for (const vtkIdType point : face)
    {
      anyInside = anyInside || heights[point] < 0.0;
      anyOutside = anyOutside || heights[point] > 0.0;
    }
  }
  if (!anyInside)
  {
    this->Faces.clear();
  }
  else if (anyOutside)
  {
    Cutter(*this, heights, axis, value).Run();
  }
}

void ConvexSolid::CutTo(const Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = std::max(std::fabs(box.Min[axis]), std::fabs(box.Max[axis])) + box.Diagonal();
    this->Cut(axis, box.Min[axis], -1.0, 1e-12 * size);
    this->Cut(axis, box.Max[axis], 1.0, 1e-12 * size);
  }
}

void ConvexSolid::AppendTo(std::vector<Vector3>& points, std::vector<std::array<vtkIdType, 3>>& triangles) const
{
  std::vector<vtkIdType> ids(this->Points.size(), -1);
  const auto idOf = [&](vtkIdType point)
  {
    if (ids[point] < 0)
    {
      ids[point] = static_cast<vtkIdType>(points.size());
      points.push_back(this->Points[point]);
    }
    return ids[point];
  };
  for (const auto& face : this->Faces)
  {
    const std::size_t count = face.size();
    const auto corner = [&](std::size_t k) { return this->Points[face[k % count]]; };
    // A fan from a corner will do where it leaves no triangle without an area.
    std::size_t from = 0;
    const auto isGood = [&](std::size_t first)
    {
      bool good = true;
      for (std::size_t k = 1; k + 1 < count && good; ++k)
      {
        good = HasArea(corner(first), corner(first + k), corner(first + k + 1));
      }
      return good;
    };
    while (from < count && count <= 6 && !isGood(from))
    {
      ++from;
    }
    if (count <= 6 && from < count)
    {
      for (std::size_t k = 1; k + 1 < count; ++k)
      {
        triangles.push_back({ idOf(face[from]), idOf(face[(from + k) % count]), idOf(face[(from + k + 1) % count]) });
      }
      continue;
    }
    Vector3 middle;
    for (std::size_t k = 0; k < count; ++k)
    {
      middle += (1.0 / static_cast<double>(count)) * corner(k);
    }
    const auto center = static_cast<vtkIdType>(points.size());
    points.push_back(middle);
    for (std::size_t k = 0; k < count; ++k)
    {
      triangles.push_back({ center, idOf(face[k]), idOf(face[(k + 1) % count]) });
    }
  }
}

} // namespace shadowcones
