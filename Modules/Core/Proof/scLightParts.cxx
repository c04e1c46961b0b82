// SPDX-License-Identifier: BSD-3-Clause
#include "scLightParts.h"

#include "scBox.h"
#include "scLightExtent.h"

#include <algorithm>
#include <numeric>

namespace shadowcones
{
namespace
{
/// A group of faces with more corners is held by the corners of its box.
constexpr std::size_t mostHullPoints = 24;
/// 1 / cos(pi / 64), rounded up: a polygon of 64 corners around a disc lies inside one of any number that is scaled so.
constexpr double polygonScale = 1.00121;

void SetBall(LightPart& part)
{
  // The mean lies in the hull, which ShadowDepthAtMost relies on.
  part.Center = {};
  for (const Vector3& point : part.Points)
  {
    part.Center += (1.0 / static_cast<double>(part.Points.size())) * point;
  }
  part.Radius = 0.0;
  for (const Vector3& point : part.Points)
  {
    part.Radius = std::max(part.Radius, Length(point - part.Center));
  }
}

/// Halves of a mesh light, by place, down to single faces or vertices.
class MeshLightParts
{
public:
  explicit MeshLightParts(const Light& light)
    : Lamp(light)
    , Faces(light.Triangles.empty() ? light.Vertices.size() : light.Triangles.size())
  {
    std::iota(this->Faces.begin(), this->Faces.end(), std::size_t{ 0 });
    this->Add(0, this->Faces.size());
  }

  std::vector<LightPart> Parts;

private:
  std::array<Vector3, 3> Corners(std::size_t face) const
  {
    const auto& vertices = this->Lamp.Vertices;
    return this->Lamp.Triangles.empty() ? std::array<Vector3, 3>{ vertices[face], vertices[face], vertices[face] }
                                        : this->Lamp.Triangles[face];
  }
  Vector3 Middle(std::size_t face) const
  {
    const auto corners = this->Corners(face);
    return (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
  }

  int Add(std::size_t begin, std::size_t end)
  {
    const auto index = static_cast<int>(this->Parts.size());
    this->Parts.push_back(this->PartOf(begin, end));
    if (end - begin > 1)
    {
      Box middles;
      for (std::size_t i = begin; i < end; ++i)
      {
        middles.Add(this->Middle(this->Faces[i]));
      }
      const Vector3 size = middles.Size();
      const int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
      std::sort(this->Faces.begin() + begin, this->Faces.begin() + end, [&](std::size_t a, std::size_t b) {
        const double x = this->Middle(a)[axis];
        const double y = this->Middle(b)[axis];
        return x != y ? x < y : a < b;
      });
      const std::size_t half = begin + (end - begin) / 2;
      const int first = this->Add(begin, half);
      const int second = this->Add(half, end);
      this->Parts[index].Halves = { first, second };
    }
    return index;
  }

  LightPart PartOf(std::size_t begin, std::size_t end) const
  {
    LightPart part;
    Box box;
    for (std::size_t i = begin; i < end; ++i)
    {
      for (const Vector3& corner : this->Corners(this->Faces[i]))
      {
        box.Add(corner);
        if (part.Points.size() <= mostHullPoints)
        {
          part.Points.push_back(corner);
        }
      }
    }
    if (part.Points.size() > mostHullPoints)
    {
      part.Points.clear();
      for (int i = 0; i < 8; ++i)
      {
        part.Points.push_back({ i & 1 ? box.Max.X : box.Min.X, i & 2 ? box.Max.Y : box.Min.Y, i & 4 ? box.Max.Z : box.Min.Z });
      }
    }
    SetBall(part);
    if (end - begin == 1 && !this->Lamp.Triangles.empty())
    {
      const auto corners = this->Corners(this->Faces[begin]);
      part.OneSided = true;
      part.Normal = Normalized(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
    return part;
  }

  const Light& Lamp;
  std::vector<std::size_t> Faces;
};
} // anonymous namespace

double LightPart::Distance(const Vector3& point) const
{
  if (this->AtInfinity)
  {
    return HUGE_VAL;
  }
  const double beyond = Length(point - this->Center) - this->Radius;
  return this->OneSided ? std::max(beyond, Dot(point - this->Center, this->Normal)) : beyond;
}

std::vector<LightPart> LightPartsOf(const Light& light)
{
  if (light.Shape == LightShape::Mesh)
  {
    return MeshLightParts(light).Parts;
  }
  const LightExtent extent = LightExtentOf(light);
  LightPart part;
  part.Points = extent.Extremes;
  part.AtInfinity = extent.AtInfinity;
  part.Center = extent.AtInfinity ? light.Normal : extent.Center;
  part.Radius = extent.Radius;
  if (light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle)
  {
    // The polygon around a disc is a little larger than it needs to be: others around the disc fit in between.
    for (Vector3& point : part.Points)
    {
      point = light.Center + (light.Shape == LightShape::Disc ? polygonScale : 1.0) * (point - light.Center);
    }
    SetBall(part);
    part.Center = light.Center;
    part.OneSided = true;
    part.Normal = light.Normal;
  }
  else if (light.Shape == LightShape::Point)
  {
    part.Points = { light.Center };
  }
  return { part };
}

Polygon InFrontOf(const LightPart& part, const std::array<Vector3, 3>& triangle)
{
  Polygon polygon;
  const auto inside = [&part](const Vector3& p) { return Length(p - part.Center) <= part.Radius; };
  if (part.Points.empty() && !part.AtInfinity && std::all_of(triangle.begin(), triangle.end(), inside))
  {
    return polygon; // a sphere shines outward
  }
  std::array<double, 3> heights{};
  for (int i = 0; i < 3; ++i)
  {
    heights[i] = part.OneSided ? Dot(triangle[i] - part.Center, part.Normal) : 1.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (heights[i] > 0.0)
    {
      polygon.Corners[polygon.Count++] = triangle[i];
    }
    if ((heights[i] > 0.0) != (heights[next] > 0.0))
    {
      const double fraction = heights[i] / (heights[i] - heights[next]);
      polygon.Corners[polygon.Count++] = triangle[i] + fraction * (triangle[next] - triangle[i]);
    }
  }
  return polygon;
}

} // namespace shadowcones
