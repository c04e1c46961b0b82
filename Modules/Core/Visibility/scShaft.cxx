// SPDX-License-Identifier: BSD-3-Clause
#include "scShaft.h"

#include "scConvexGap.h"

#include <algorithm>
#include <cstddef>

namespace shadowcones
{
namespace
{
constexpr std::size_t mostParts = 64;
/// What is flush with a plane up to this share of the numbers that say so is on no side of it.
constexpr double flush = 1e-12;

LightBody FaceOf(const std::vector<Vector3>& corners, const Vector3& normal)
{
  LightBody body;
  body.Corners = corners;
  body.Center = corners[0];
  body.OneSided = true;
  body.Normal = normal;
  return body;
}

std::vector<LightBody> FacesOf(const Light& light)
{
  std::vector<LightBody> bodies;
  if (light.Triangles.size() <= mostParts)
  {
    for (const auto& t : light.Triangles)
    {
      const Vector3 normal = Cross(t[1] - t[0], t[2] - t[0]);
      if (Dot(normal, normal) > 0.0)
      {
        bodies.push_back(FaceOf({ t[0], t[1], t[2] }, Normalized(normal)));
      }
    }
    return bodies;
  }
  LightBody whole;
  whole.Corners = LightHull(light);
  if (whole.Corners.empty())
  {
    whole.Kind = LightBody::Form::Ball;
    LightBoundingSphere(light, whole.Center, whole.Radius);
  }
  return { whole };
}

std::vector<LightBody> PointsOf(const std::vector<Vector3>& points)
{
  std::vector<LightBody> bodies;
  const std::size_t each = points.size() <= mostParts ? 1 : points.size();
  for (std::size_t k = 0; k < points.size(); k += each)
  {
    LightBody body;
    body.Corners.assign(points.begin() + static_cast<std::ptrdiff_t>(k),
      points.begin() + static_cast<std::ptrdiff_t>(std::min(k + each, points.size())));
    bodies.push_back(body);
  }
  return bodies;
}
} // anonymous namespace

bool LightBody::IsPoint() const
{
  return this->Kind == Form::Points ? this->Corners.size() == 1 : this->Radius == 0.0;
}

Vector3 LightBody::Farthest(const Vector3& along) const
{
  if (this->Kind == Form::Disc)
  {
    return this->Center + this->Radius * Normalized(along - Dot(along, this->Normal) * this->Normal);
  }
  if (this->Kind == Form::Ball)
  {
    return this->Center + this->Radius * Normalized(along);
  }
  return *std::max_element(this->Corners.begin(), this->Corners.end(),
    [&along](const Vector3& a, const Vector3& b) { return Dot(a, along) < Dot(b, along); });
}

Box LightBody::Bounds() const
{
  Box box;
  for (const Vector3& axis : { Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.0, 0.0, 1.0 } })
  {
    box.Add(this->Farthest(axis));
    box.Add(this->Farthest(-axis));
  }
  return box;
}

namespace
{
std::vector<LightBody> ConvexPartsOf(const Light& light)
{
  LightBody body;
  body.Center = light.Center;
  body.Radius = light.Radius;
  switch (light.Shape)
  {
    case LightShape::Disc:
      body.Kind = LightBody::Form::Disc;
      body.OneSided = true;
      body.Normal = light.Normal;
      return { body };
    case LightShape::Rectangle:
    {
      const Vector3 u = light.AxisU;
      const Vector3 v = light.AxisV;
      const Vector3 c = light.Center;
      return { FaceOf({ c - u - v, c + u - v, c + u + v, c - u + v }, light.Normal) };
    }
    case LightShape::Sphere:
      body.Kind = LightBody::Form::Ball;
      return { body };
    case LightShape::Sun:
      body.Kind = LightBody::Form::Directions;
      body.Center = -light.Normal;
      body.Radius = std::tan(std::min(light.Radius, widestSun));
      return { body };
    case LightShape::Mesh:
      return light.Triangles.empty() ? PointsOf(light.Vertices) : FacesOf(light);
    case LightShape::Point:
      break;
  }
  return PointsOf({ light.Center });
}
} // anonymous namespace

std::vector<LightBody> LightBodiesOf(const Light& light)
{
  std::vector<LightBody> bodies = ConvexPartsOf(light);
  for (LightBody& body : bodies)
  {
    body.Size = body.AtInfinity() ? 0.0 : body.Bounds().Diagonal();
  }
  return bodies;
}

Shaft::Shaft(const ShaftStart& start, const LightBody& light, const Box& casters)
  : From(start)
  , To(light)
{
  if (!light.AtInfinity())
  {
    this->Longest = Length(light.Middle() - start.Center) + light.Size + Length(start.Half) + start.Radius;
    return;
  }
  this->Longest = std::sqrt(1.0 + light.Radius * light.Radius);
  if (!casters.Empty())
  {
    const Vector3 corner = BoxBody(casters).Farthest(light.Center);
    this->Reach = std::max(0.0, Dot(corner, light.Center) - start.Least(light.Center)) + casters.Diagonal();
  }
}

Vector3 Shaft::Farthest(const Vector3& along) const
{
  const Vector3 here = this->From.Farthest(along);
  if (this->To.AtInfinity())
  {
    const Vector3 across = along - Dot(along, this->To.Center) * this->To.Center;
    const Vector3 way = this->To.Center + this->To.Radius * Normalized(across);
    return Dot(way, along) > 0.0 ? here + this->Reach * way : here;
  }
  const Vector3 there = this->To.Farthest(along);
  return Dot(there, along) > Dot(here, along) ? there : here;
}

int Shaft::SideOf(const Vector3& n, double spread) const
{
  if (this->To.AtInfinity())
  {
    const double middle = Dot(n, this->To.Center);
    const double least =
      this->To.Radius * Length(n - middle * this->To.Center) + flush * Length(n) + spread * this->Longest;
    return middle > least ? 1 : (middle < -least ? -1 : 0);
  }
  const double least = Dot(n, this->To.Farthest(-n)) - this->From.Largest(n);
  const double largest = Dot(n, this->To.Farthest(n)) - this->From.Least(n);
  const double margin =
    flush * Length(n) * (Length(this->From.Center) + Length(this->To.Middle())) + spread * this->Longest;
  return least > margin ? 1 : (largest < -margin ? -1 : 0);
}

int Shaft::Facing() const
{
  if (!this->To.OneSided)
  {
    return 1;
  }
  const double plane = Dot(this->To.Center, this->To.Normal);
  return this->From.Least(this->To.Normal) > plane ? 1 : (this->From.Largest(this->To.Normal) <= plane ? -1 : 0);
}

} // namespace shadowcones
