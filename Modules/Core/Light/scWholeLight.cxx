// SPDX-License-Identifier: BSD-3-Clause
#include "scWholeLight.h"

#include "scConstants.h"
#include "scGaussLegendre.h"
#include "scLightSampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace shadowcones
{
namespace
{
/// A polygon's part above a plane has a corner more at most.
struct Corners
{
  std::array<Vector3, 6> Points;
  std::size_t Count = 0;
  void Add(const Vector3& point) { this->Points[this->Count++] = point; }
};

/// The part of a convex polygon above the plane through the origin.
Corners AboveHorizon(const Vector3* points, std::size_t count, const Vector3& normal)
{
  Corners above;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Vector3& a = points[k];
    const Vector3& b = points[(k + 1) % count];
    const double heightA = Dot(a, normal);
    const double heightB = Dot(b, normal);
    if (heightA > 0.0)
    {
      above.Add(a);
    }
    if ((heightA > 0.0) != (heightB > 0.0))
    {
      above.Add(a + (heightA / (heightA - heightB)) * (b - a));
    }
  }
  return above;
}

/// What an edge seen from the origin adds to twice the integral: its angle times the cosine of the plane that holds both.
double EdgeTerm(const Vector3& a, const Vector3& b, const Vector3& normal)
{
  const Vector3 across = Cross(a, b - a);
  const double length = Length(across);
  return length > 0.0 ? std::atan2(length, Dot(a, b)) * Dot(across, normal) / length : 0.0;
}

double PolygonIrradiance(const Vector3* points, std::size_t count, const Vector3& normal)
{
  const Corners above = AboveHorizon(points, count, normal);
  double sum = 0.0;
  for (std::size_t k = 0; k < above.Count; ++k)
  {
    sum += EdgeTerm(above.Points[k], above.Points[(k + 1) % above.Count], normal);
  }
  return 0.5 * std::fabs(sum);
}

/// Integral of 1 / (a + b cos) from 0 to @p angle; @p root is sqrt(a^2 - b^2), @p ratio sqrt((a - b) / (a + b)).
double InverseIntegral(double angle, double root, double ratio)
{
  const double turns = std::round(angle / TwoPi);
  const double rest = angle - turns * TwoPi;
  return (2.0 * std::atan(ratio * std::tan(0.5 * rest)) + turns * TwoPi) / root;
}

/// A disc as it is seen from the origin, which lies @p Height above its lit side.
struct SeenDisc
{
  Vector3 Center;
  Vector3 Normal; ///< unit, the side that emits
  double Radius;
  double Height;

  /// Where the plane through the origin does not cut it: the vector that it sends, along the normal and along the disc.
  double Whole(const Vector3& normal) const
  {
    const Vector3 lateral = this->Center + this->Height * this->Normal;
    const double h2 = this->Height * this->Height;
    const double r2 = this->Radius * this->Radius;
    const double x2 = Dot(lateral, lateral);
    const double z = h2 + x2 - r2;
    const double root = std::sqrt(z * z + 4.0 * r2 * h2);
    const double axial = z > 0.0 ? 4.0 * r2 * h2 / (root * (root + z)) : (root - z) / root;
    const double radial = 2.0 * this->Height * r2 / (root * (h2 + x2 + r2 + root));
    return Pi * (radial * Dot(lateral, normal) - 0.5 * axial * Dot(this->Normal, normal));
  }

  /// Where it does: the arc above the plane, and the chord in it. @p uphill in the disc, unit; @p slope of heights along it.
  double Cut(const Vector3& normal, const Vector3& uphill, double slope) const
  {
    const double half = std::acos(std::clamp(-Dot(normal, this->Center) / (this->Radius * slope), -1.0, 1.0));
    const Vector3 side = Cross(this->Normal, uphill);
    const Vector3 turned = Cross(normal, this->Center);
    // The integrand over the arc: (constant + c cos + s sin) / |r|^2.
    const double constant = this->Radius * this->Radius * Dot(normal, this->Normal);
    const double c = this->Radius * Dot(turned, side);
    const double s = -this->Radius * Dot(turned, uphill);
    const double along = Dot(this->Center, uphill);
    const double beside = Dot(this->Center, side);
    const double a = Dot(this->Center, this->Center) + this->Radius * this->Radius;
    const double b = 2.0 * this->Radius * std::hypot(along, beside);
    double arc = 0.0;
    if (b < 0.5 * a)
    {
      // Smooth: nothing cancels in a sum over nodes.
      static const GaussLegendre rule(32);
      for (std::size_t k = 0; k < rule.Nodes.size(); ++k)
      {
        const double angle = half * (2.0 * rule.Nodes[k] - 1.0);
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        arc += 2.0 * half * rule.Weights[k] * (constant + c * cosine + s * sine) /
          (a + 2.0 * this->Radius * (along * cosine + beside * sine));
      }
    }
    else
    {
      const double start = std::atan2(beside, along);
      const double from = -half - start;
      const double to = half - start;
      const double lateral = std::hypot(along, beside);
      const double near = this->Height * this->Height + (lateral - this->Radius) * (lateral - this->Radius);
      const double root = std::sqrt(near * (a + b));
      const double ratio = std::sqrt(near / (a + b));
      const double inverse = InverseIntegral(to, root, ratio) - InverseIntegral(from, root, ratio);
      const double cosines = c * std::cos(start) + s * std::sin(start);
      const double sines = s * std::cos(start) - c * std::sin(start);
      const double logarithm = std::log((a + b * std::cos(to)) / (a + b * std::cos(from)));
      arc = constant * inverse + (cosines * (to - from - a * inverse) - sines * logarithm) / b;
    }
    // The chord lies in the plane through the origin: it adds the angle that it spans there, with the sign of a whole arc.
    const Vector3 middle = this->Center + this->Radius * std::cos(half) * uphill;
    const Vector3 end = this->Radius * std::sin(half) * side;
    const double angle = std::atan2(2.0 * Length(Cross(middle, end)), Dot(middle, middle) - Dot(end, end));
    return 0.5 * std::max(angle - arc, 0.0);
  }

  double Irradiance(const Vector3& normal) const
  {
    if (!(this->Height > 0.0))
    {
      return 0.0;
    }
    const Vector3 slope = normal - Dot(normal, this->Normal) * this->Normal;
    const double reach = this->Radius * Length(slope);
    const double middle = Dot(normal, this->Center);
    if (middle >= reach)
    {
      return this->Whole(normal);
    }
    return middle <= -reach ? 0.0 : this->Cut(normal, Normalized(slope), Length(slope));
  }
};

/// A cone of directions as a disc at its end.
SeenDisc DiscOfCone(const Vector3& axis, double sine, double cosine)
{
  return { cosine * axis, -axis, sine, cosine };
}

double SphereIrradiance(const Light& light, const Vector3& from, const Vector3& normal)
{
  const Vector3 to = light.Center - from;
  const double distance = Length(to);
  if (!(distance > light.Radius))
  {
    return 0.0;
  }
  const double sine = light.Radius / distance;
  return DiscOfCone((1.0 / distance) * to, sine, std::sqrt(1.0 - sine * sine)).Irradiance(normal);
}

/// As bright as its whole cone brings 1.
double SunIrradiance(const Light& light, const Vector3& normal)
{
  if (!(light.Radius > 0.0))
  {
    return std::max(-Dot(light.Normal, normal), 0.0);
  }
  const double solidAngle = 4.0 * Pi * std::pow(std::sin(0.5 * light.Radius), 2);
  return DiscOfCone(-light.Normal, std::sin(light.Radius), std::cos(light.Radius)).Irradiance(normal) / solidAngle;
}

double RectangleIrradiance(const Light& light, const Vector3& from, const Vector3& normal)
{
  const Vector3 to = light.Center - from;
  if (!(Dot(to, light.Normal) < 0.0))
  {
    return 0.0;
  }
  const Vector3 corners[4] = { to - light.AxisU - light.AxisV, to + light.AxisU - light.AxisV,
    to + light.AxisU + light.AxisV, to - light.AxisU + light.AxisV };
  return PolygonIrradiance(corners, 4, normal);
}

double PointIrradiance(const Vector3& to, const Vector3& normal)
{
  const double squared = Dot(to, to);
  return std::max(Dot(to, normal), 0.0) / (squared * std::sqrt(squared));
}

double MeshIrradiance(const Light& light, const Vector3& from, const Vector3& normal)
{
  double sum = 0.0;
  for (std::size_t k = 0; light.Triangles.empty() && k < light.Vertices.size(); ++k)
  {
    sum += PointIrradiance(light.Vertices[k] - from, normal);
  }
  for (const std::array<Vector3, 3>& t : light.Triangles)
  {
    const Vector3 corners[3] = { t[0] - from, t[1] - from, t[2] - from };
    if (Dot(corners[0], Cross(t[1] - t[0], t[2] - t[0])) < 0.0)
    {
      sum += PolygonIrradiance(corners, 3, normal);
    }
  }
  return sum;
}
} // anonymous namespace

double WholeFluence(const Light& light, const Vector3& from)
{
  if (light.Shape == LightShape::Point)
  {
    return 1.0 / Dot(light.Center - from, light.Center - from);
  }
  if (light.Shape == LightShape::Mesh && light.Triangles.empty())
  {
    double sum = 0.0;
    for (const Vector3& vertex : light.Vertices)
    {
      sum += 1.0 / Dot(vertex - from, vertex - from);
    }
    return sum;
  }
  return light.Shape == LightShape::Sun ? 1.0 : LightSolidAngle(light, from);
}

double WholeIrradiance(const Light& light, const Vector3& from, const Vector3& normal)
{
  const Vector3 to = light.Center - from;
  switch (light.Shape)
  {
    case LightShape::Disc:
      return SeenDisc{ to, light.Normal, light.Radius, -Dot(to, light.Normal) }.Irradiance(normal);
    case LightShape::Rectangle:
      return RectangleIrradiance(light, from, normal);
    case LightShape::Sphere:
      return SphereIrradiance(light, from, normal);
    case LightShape::Sun:
      return SunIrradiance(light, normal);
    case LightShape::Mesh:
      return MeshIrradiance(light, from, normal);
    case LightShape::Point:
      break;
  }
  return PointIrradiance(to, normal);
}

} // namespace shadowcones
