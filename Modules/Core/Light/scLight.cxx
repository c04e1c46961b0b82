// SPDX-License-Identifier: BSD-3-Clause
#include "scLight.h"

#include "scFingerprint.h"
#include "scSphericalEllipse.h"
#include "scSphericalRectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();

double Square(double x)
{
  return x * x;
}

// Into [0, 1), so that an inverse can be sampled again.
double UnitInterval(double x)
{
  return std::clamp(x, 0.0, 1.0 - 0x1p-53);
}

// Radius and azimuth of the concentric map of Shirley and Chiu (1997) onto the unit disc.
std::array<double, 2> ConcentricDisc(double u, double v)
{
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0)
  {
    return { 0.0, 0.0 };
  }
  const bool horizontal = std::fabs(a) > std::fabs(b);
  const double radius = horizontal ? a : b;
  const double azimuth = horizontal ? 0.25 * Pi * (b / a) : 0.5 * Pi - 0.25 * Pi * (a / b);
  return { radius * std::cos(azimuth), radius * std::sin(azimuth) };
}

std::array<double, 2> InvertConcentricDisc(double x, double y)
{
  const double radius = std::min(std::hypot(x, y), 1.0);
  double azimuth = std::atan2(y, x);
  azimuth = azimuth < -0.25 * Pi ? azimuth + 2.0 * Pi : azimuth;
  const int quarter = std::min(static_cast<int>((azimuth + 0.25 * Pi) / (0.5 * Pi)), 3);
  const double across = radius * (azimuth - 0.5 * Pi * quarter) / (0.25 * Pi);
  const double a = quarter == 0 ? radius : quarter == 1 ? -across : quarter == 2 ? -radius : across;
  const double b = quarter == 0 ? across : quarter == 1 ? radius : quarter == 2 ? -across : -radius;
  return { UnitInterval(0.5 * (a + 1.0)), UnitInterval(0.5 * (b + 1.0)) };
}

// A circular cone of directions. Its size is kept as 1 - cos, which a tiny cone does not round away.
struct DirectionCone
{
  Vector3 Axis;
  double OneMinusCosine;

  double SolidAngle() const { return 2.0 * Pi * this->OneMinusCosine; }
  // A cone without a size is one direction, with all of the probability.
  double Density() const { return this->OneMinusCosine > 0.0 ? 1.0 / this->SolidAngle() : 1.0; }

  // 1 - cos of the angle to the axis, and the direction.
  Vector3 Sample(double u, double v, double& oneMinusCosine) const
  {
    const std::array<double, 2> disc = ConcentricDisc(u, v);
    const double squared = Square(disc[0]) + Square(disc[1]);
    oneMinusCosine = squared * this->OneMinusCosine;
    const double scale = std::sqrt(this->OneMinusCosine * (2.0 - oneMinusCosine)); // sin over the disc's radius
    const Frame frame = FrameAround(this->Axis);
    return (1.0 - oneMinusCosine) * this->Axis + (scale * disc[0]) * frame.U + (scale * disc[1]) * frame.V;
  }

  static double OneMinusDot(const Vector3& a, const Vector3& b)
  {
    const Vector3 difference = a - b;
    return 0.5 * Dot(difference, difference);
  }

  bool Contains(const Vector3& direction) const
  {
    // Directions carry an error of a few 1e-16 in each component.
    const double tolerance = 1e-15 * std::sqrt(this->OneMinusCosine) + 1e-30;
    return OneMinusDot(direction, this->Axis) <= this->OneMinusCosine + tolerance;
  }

  std::array<double, 2> Invert(const Vector3& direction) const
  {
    if (!(this->OneMinusCosine > 0.0))
    {
      return { 0.5, 0.5 };
    }
    const Frame frame = FrameAround(this->Axis);
    const double x = Dot(direction, frame.U);
    const double y = Dot(direction, frame.V);
    const double length = std::hypot(x, y);
    const double radius = std::sqrt(OneMinusDot(direction, this->Axis) / this->OneMinusCosine);
    return length > 0.0 ? InvertConcentricDisc(radius * x / length, radius * y / length)
                        : std::array<double, 2>{ 0.5, 0.5 };
  }
};

DirectionCone SunCone(const Light& light)
{
  return { -light.Normal, 2.0 * Square(std::sin(0.5 * light.Radius)) };
}

// The cone in which a sphere is seen; its size is negative from inside.
DirectionCone SphereCone(const Light& light, const Vector3& from, double& distance)
{
  const Vector3 toCenter = light.Center - from;
  distance = Length(toCenter);
  if (!(distance >= light.Radius))
  {
    return { Normalized(toCenter), -1.0 };
  }
  const double squared = Square(light.Radius / distance);
  return { (1.0 / distance) * toCenter, squared / (1.0 + std::sqrt(1.0 - squared)) };
}

// Exactly representable directions only differ by rounding.
bool SameDirection(const Vector3& a, const Vector3& b)
{
  return Length(a - b) <= 1e-12;
}

Vector3 TriangleNormal(const std::array<Vector3, 3>& t)
{
  return Cross(t[1] - t[0], t[2] - t[0]);
}

bool HasTriangles(const Light& light)
{
  return !light.Triangles.empty();
}

// Lights without an extent: a point, or a mesh of vertices.
bool IsPointlike(const Light& light)
{
  return light.Shape == LightShape::Point || (light.Shape == LightShape::Mesh && !HasTriangles(light));
}

std::size_t NumberOfPoints(const Light& light)
{
  return light.Shape == LightShape::Mesh ? light.Vertices.size() : 1;
}

const Vector3& PointAt(const Light& light, std::size_t index)
{
  return light.Shape == LightShape::Mesh ? light.Vertices[index] : light.Center;
}

LightSurfaceSample SampleMeshArea(const Light& light, double u, double v)
{
  const double total = light.CumulativeArea.back();
  const double target = u * total;
  // The first running sum beyond the target: never a face without an area.
  const auto found = std::upper_bound(light.CumulativeArea.begin(), light.CumulativeArea.end() - 1, target);
  const std::size_t index = static_cast<std::size_t>(found - light.CumulativeArea.begin());
  const double before = index > 0 ? light.CumulativeArea[index - 1] : 0.0;
  const double share = (target - before) / (light.CumulativeArea[index] - before);
  const double root = std::sqrt(std::clamp(share, 0.0, 1.0));
  const std::array<Vector3, 3>& t = light.Triangles[index];
  return { t[0] + (root * (1.0 - v)) * (t[1] - t[0]) + (root * v) * (t[2] - t[0]), Normalized(TriangleNormal(t)),
    1.0 / total };
}

// Barycentric coordinates of the projection onto the triangle's plane.
bool Barycentric(const std::array<Vector3, 3>& t, const Vector3& position, double& b1, double& b2)
{
  const Vector3 normal = TriangleNormal(t);
  const double squared = Dot(normal, normal);
  if (!(squared > 0.0))
  {
    return false;
  }
  const Vector3 offset = position - t[0];
  b1 = Dot(Cross(offset, t[2] - t[0]), normal) / squared;
  b2 = Dot(Cross(t[1] - t[0], offset), normal) / squared;
  return true;
}

std::array<double, 2> InvertMeshArea(const Light& light, const Vector3& position)
{
  double best = Infinity;
  std::array<double, 2> result{ 0.5, 0.5 };
  for (std::size_t i = 0; i < light.Triangles.size(); ++i)
  {
    double b1 = 0.0;
    double b2 = 0.0;
    const std::array<Vector3, 3>& t = light.Triangles[i];
    if (!Barycentric(t, position, b1, b2))
    {
      continue;
    }
    b1 = std::max(b1, 0.0);
    b2 = std::max(b2, 0.0);
    const double sum = b1 + b2;
    b1 = sum > 1.0 ? b1 / sum : b1;
    b2 = sum > 1.0 ? b2 / sum : b2;
    const double distance = Length(t[0] + b1 * (t[1] - t[0]) + b2 * (t[2] - t[0]) - position);
    if (distance < best)
    {
      best = distance;
      const double root = std::min(sum, 1.0);
      const double before = i > 0 ? light.CumulativeArea[i - 1] : 0.0;
      const double area = light.CumulativeArea[i] - before;
      result = { UnitInterval((before + root * root * area) / light.CumulativeArea.back()),
        root > 0.0 ? UnitInterval(b2 / (b1 + b2)) : 0.5 };
    }
  }
  return result;
}

// Where a ray meets a face that faces it.
bool HitFace(const std::array<Vector3, 3>& t, const Vector3& from, const Vector3& direction, double& distance,
  double& cosine)
{
  const Vector3 normal = Normalized(TriangleNormal(t));
  cosine = -Dot(direction, normal);
  if (!(cosine > 0.0))
  {
    return false;
  }
  distance = Dot(from - t[0], normal) / cosine;
  double b1 = 0.0;
  double b2 = 0.0;
  constexpr double tolerance = 1e-9;
  return distance > 0.0 && Barycentric(t, from + distance * direction, b1, b2) && b1 >= -tolerance &&
    b2 >= -tolerance && b1 + b2 <= 1.0 + tolerance;
}

// Where a ray meets the emitting side of a disc or rectangle; false outside of it.
bool HitPlanarLight(const Light& light, const Vector3& from, const Vector3& direction, double& distance, double& cosine)
{
  const Vector3 toCenter = light.Center - from;
  const double height = -Dot(toCenter, light.Normal);
  cosine = -Dot(direction, light.Normal);
  if (!(height > 0.0 && cosine > 0.0))
  {
    return false;
  }
  distance = height / cosine;
  const Vector3 offset = distance * direction - toCenter;
  // Rounding of the hit point, relative to the light.
  const double error = 1e-15 * (distance + Length(toCenter)) / cosine;
  if (light.Shape == LightShape::Disc)
  {
    return Length(offset) <= light.Radius + error;
  }
  const double u = Length(light.AxisU);
  const double v = Length(light.AxisV);
  return std::fabs(Dot(offset, light.AxisU)) <= u * (u + error) &&
    std::fabs(Dot(offset, light.AxisV)) <= v * (v + error);
}

// The area's density seen from a point, per steradian; 0 on the dark side.
LightDirectionSample DirectionOfSurfaceSample(const LightSurfaceSample& surface, const Vector3& from)
{
  const Vector3 to = surface.Position - from;
  const double distance = Length(to);
  if (!(distance > 0.0))
  {
    return { -surface.Normal, 0.0, 0.0 };
  }
  const Vector3 direction = (1.0 / distance) * to;
  const double cosine = -Dot(direction, surface.Normal);
  return { direction, distance, cosine > 0.0 ? surface.Density * Square(distance) / cosine : 0.0 };
}

// A point of a point-like light; Density is the probability of that point.
LightDirectionSample DirectionOfPoint(const Light& light, const Vector3& from, double u)
{
  const std::size_t count = NumberOfPoints(light);
  const std::size_t index = std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
  const Vector3 to = PointAt(light, index) - from;
  const double distance = Length(to);
  const double density = distance > 0.0 ? 1.0 / static_cast<double>(count) : 0.0;
  return { distance > 0.0 ? (1.0 / distance) * to : light.Normal, distance, density };
}

LightDirectionSample TowardsCenter(const Light& light, const Vector3& from)
{
  const Vector3 to = light.Center - from;
  const double distance = Length(to);
  return { distance > 0.0 ? (1.0 / distance) * to : -light.Normal, distance, 0.0 };
}

const char* CheckRectangle(Light& light)
{
  if (!IsFinite(light.AxisU) || !IsFinite(light.AxisV))
  {
    return "The axes of the rectangular light must be finite.";
  }
  const double u = Length(light.AxisU);
  const double v = Length(light.AxisV);
  if (!(u > 0.0 && v > 0.0))
  {
    return "The rectangular light has zero area: both axes must be longer than 0.";
  }
  constexpr double tolerance = 1e-6;
  if (std::fabs(Dot(light.AxisU, light.AxisV)) > tolerance * u * v)
  {
    return "The axes of the rectangular light must be at right angles to each other.";
  }
  if (std::fabs(Dot(light.Normal, light.AxisU)) > tolerance * u ||
    std::fabs(Dot(light.Normal, light.AxisV)) > tolerance * v)
  {
    return "The normal of the rectangular light must be at right angles to its axes.";
  }
  // Exactly at right angles from here on.
  const Vector3 unitU = (1.0 / u) * light.AxisU;
  light.AxisV = v * Normalized(light.AxisV - Dot(light.AxisV, unitU) * unitU);
  const Vector3 normal = Normalized(Cross(light.AxisU, light.AxisV));
  light.Normal = Dot(normal, light.Normal) < 0.0 ? -normal : normal;
  return nullptr;
}

const char* CheckMesh(Light& light)
{
  light.CumulativeArea.clear();
  if (!HasTriangles(light))
  {
    for (const Vector3& vertex : light.Vertices)
    {
      if (!IsFinite(vertex))
      {
        return "A vertex of the light is not finite.";
      }
    }
    return light.Vertices.empty() ? "The light has neither polygons nor vertices." : nullptr;
  }
  light.CumulativeArea.reserve(light.Triangles.size());
  double total = 0.0;
  for (const std::array<Vector3, 3>& t : light.Triangles)
  {
    const double area = 0.5 * Length(TriangleNormal(t));
    if (!std::isfinite(area))
    {
      return "A point of the light's mesh is not finite.";
    }
    total += area;
    light.CumulativeArea.push_back(total);
  }
  return total > 0.0 ? nullptr : "The light's mesh has zero area.";
}

IncidentSample IncidentByArea(const Light& light, const Vector3& from, double u, double v)
{
  const LightDirectionSample sample = DirectionOfSurfaceSample(SampleLightArea(light, u, v), from);
  return { sample.Direction, sample.Distance, sample.Density > 0.0 ? 1.0 / sample.Density : 0.0 };
}

// Within two radii of the sphere around a disc or rectangle.
bool IsNear(const Light& light, const Vector3& from)
{
  const Vector3 toCenter = light.Center - from;
  const double squared = light.Shape == LightShape::Disc
    ? Square(light.Radius)
    : Dot(light.AxisU, light.AxisU) + Dot(light.AxisV, light.AxisV);
  return Dot(toCenter, toCenter) < 9.0 * squared;
}

} // namespace

//------------------------------------------------------------------------------
const char* PrepareLight(Light& light)
{
  for (const double value : light.Spectrum)
  {
    if (!std::isfinite(value))
    {
      return "The light's spectrum has a value that is not finite.";
    }
    if (value < 0.0)
    {
      return "The light's spectrum has a negative value.";
    }
  }
  if (light.Shape == LightShape::Mesh)
  {
    return CheckMesh(light);
  }
  if (light.Shape != LightShape::Sun && !IsFinite(light.Center))
  {
    return "The light's center must be finite.";
  }
  if (light.Shape == LightShape::Point)
  {
    return nullptr;
  }
  if (light.Shape == LightShape::Sun)
  {
    if (!(light.Radius >= 0.0 && light.Radius <= 0.5 * Pi))
    {
      return "The sun's angular diameter must be from 0 to 180 degrees.";
    }
  }
  else if (light.Shape != LightShape::Rectangle && !(std::isfinite(light.Radius) && light.Radius > 0.0))
  {
    return "The light's radius must be finite and larger than 0.";
  }
  if (light.Shape == LightShape::Sphere)
  {
    return nullptr;
  }
  const double length = Length(light.Normal);
  if (!(std::isfinite(length) && length > 0.0))
  {
    return "The light's normal must be finite and longer than 0.";
  }
  light.Normal = (1.0 / length) * light.Normal;
  return light.Shape == LightShape::Rectangle ? CheckRectangle(light) : nullptr;
}

//------------------------------------------------------------------------------
std::uint64_t FingerprintOf(const Light& light)
{
  Fingerprint fingerprint;
  fingerprint.AddWord(static_cast<std::uint64_t>(light.Shape));
  const auto add = [&fingerprint](const Vector3& v)
  {
    fingerprint.AddNumber(v.X);
    fingerprint.AddNumber(v.Y);
    fingerprint.AddNumber(v.Z);
  };
  if (light.Shape == LightShape::Mesh)
  {
    for (const std::array<Vector3, 3>& triangle : light.Triangles)
    {
      std::for_each(triangle.begin(), triangle.end(), add);
    }
    std::for_each(light.Vertices.begin(), light.Vertices.end(), add);
    return fingerprint.Value();
  }
  if (light.Shape != LightShape::Sun)
  {
    add(light.Center);
  }
  if (light.Shape != LightShape::Sphere && light.Shape != LightShape::Point)
  {
    add(light.Normal);
  }
  if (light.Shape == LightShape::Rectangle)
  {
    add(light.AxisU);
    add(light.AxisV);
  }
  else if (light.Shape != LightShape::Point)
  {
    fingerprint.AddNumber(light.Radius);
  }
  return fingerprint.Value();
}

//------------------------------------------------------------------------------
double LightArea(const Light& light)
{
  switch (light.Shape)
  {
    case LightShape::Disc:
      return Pi * Square(light.Radius);
    case LightShape::Rectangle:
      return 4.0 * Length(Cross(light.AxisU, light.AxisV));
    case LightShape::Sphere:
      return 4.0 * Pi * Square(light.Radius);
    case LightShape::Mesh:
      return light.CumulativeArea.empty() ? 0.0 : light.CumulativeArea.back();
    default:
      return 0.0;
  }
}

//------------------------------------------------------------------------------
void LightBoundingSphere(const Light& light, Vector3& center, double& radius)
{
  center = light.Center;
  radius = 0.0;
  switch (light.Shape)
  {
    case LightShape::Disc:
    case LightShape::Sphere:
      radius = light.Radius;
      break;
    case LightShape::Rectangle:
      radius = std::sqrt(Dot(light.AxisU, light.AxisU) + Dot(light.AxisV, light.AxisV));
      break;
    case LightShape::Point:
      break;
    case LightShape::Sun:
      center = {};
      break;
    case LightShape::Mesh:
    {
      Box box;
      for (const auto& triangle : light.Triangles)
      {
        for (const Vector3& corner : triangle)
        {
          box.Add(corner);
        }
      }
      if (!HasTriangles(light))
      {
        for (const Vector3& vertex : light.Vertices)
        {
          box.Add(vertex);
        }
      }
      center = box.Empty() ? Vector3{} : box.Center();
      radius = 0.5 * box.Diagonal();
      break;
    }
  }
}

//------------------------------------------------------------------------------
LightSurfaceSample SampleLightArea(const Light& light, double u, double v)
{
  switch (light.Shape)
  {
    case LightShape::Disc:
    {
      const std::array<double, 2> disc = ConcentricDisc(u, v);
      const Frame frame = FrameAround(light.Normal);
      return { light.Center + (light.Radius * disc[0]) * frame.U + (light.Radius * disc[1]) * frame.V, light.Normal,
        1.0 / LightArea(light) };
    }
    case LightShape::Rectangle:
      return { light.Center + (2.0 * u - 1.0) * light.AxisU + (2.0 * v - 1.0) * light.AxisV, light.Normal,
        1.0 / LightArea(light) };
    case LightShape::Sphere:
    {
      const double z = 1.0 - 2.0 * u;
      const double ring = 2.0 * std::sqrt(std::max(u * (1.0 - u), 0.0));
      const Vector3 normal{ ring * std::cos(2.0 * Pi * v), ring * std::sin(2.0 * Pi * v), z };
      return { light.Center + light.Radius * normal, normal, 1.0 / LightArea(light) };
    }
    case LightShape::Sun:
    {
      const DirectionCone cone = SunCone(light);
      double oneMinusCosine = 0.0;
      const Vector3 direction = cone.Sample(u, v, oneMinusCosine);
      return { direction, -direction, cone.Density() };
    }
    case LightShape::Mesh:
      if (HasTriangles(light))
      {
        return SampleMeshArea(light, u, v);
      }
      break;
    case LightShape::Point:
      break;
  }
  const std::size_t count = NumberOfPoints(light);
  const std::size_t index = std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
  return { PointAt(light, index), light.Normal, 1.0 / static_cast<double>(count) };
}

//------------------------------------------------------------------------------
std::array<double, 2> InvertLightArea(const Light& light, const Vector3& position)
{
  const Vector3 offset = position - light.Center;
  switch (light.Shape)
  {
    case LightShape::Disc:
    {
      const Frame frame = FrameAround(light.Normal);
      return InvertConcentricDisc(Dot(offset, frame.U) / light.Radius, Dot(offset, frame.V) / light.Radius);
    }
    case LightShape::Rectangle:
      return { UnitInterval(0.5 + 0.5 * Dot(offset, light.AxisU) / Dot(light.AxisU, light.AxisU)),
        UnitInterval(0.5 + 0.5 * Dot(offset, light.AxisV) / Dot(light.AxisV, light.AxisV)) };
    case LightShape::Sphere:
    {
      const double azimuth = std::atan2(offset.Y, offset.X) / (2.0 * Pi);
      // The half angle from the pole keeps its digits at both poles.
      const double polar = std::atan2(std::hypot(offset.X, offset.Y), offset.Z);
      return { UnitInterval(Square(std::sin(0.5 * polar))), UnitInterval(azimuth < 0.0 ? azimuth + 1.0 : azimuth) };
    }
    case LightShape::Sun:
      return SunCone(light).Invert(Normalized(position));
    case LightShape::Mesh:
      if (HasTriangles(light))
      {
        return InvertMeshArea(light, position);
      }
      break;
    case LightShape::Point:
      break;
  }
  const std::size_t count = NumberOfPoints(light);
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i)
  {
    best = Length(PointAt(light, i) - position) < Length(PointAt(light, best) - position) ? i : best;
  }
  return { (static_cast<double>(best) + 0.5) / static_cast<double>(count), 0.5 };
}

//------------------------------------------------------------------------------
LightDirectionSample SampleLightSolidAngle(const Light& light, const Vector3& from, double u, double v)
{
  double oneMinusCosine = 0.0;
  switch (light.Shape)
  {
    case LightShape::Disc:
    {
      const SphericalEllipse ellipse(light.Center, light.Normal, light.Radius, from);
      const double solidAngle = ellipse.SolidAngle();
      if (!(solidAngle > 0.0))
      {
        return TowardsCenter(light, from);
      }
      const Vector3 direction = ellipse.Sample(u, v);
      const double cosine = -Dot(direction, light.Normal);
      return { direction, cosine > 0.0 ? ellipse.Height() / cosine : Infinity, 1.0 / solidAngle };
    }
    case LightShape::Rectangle:
    {
      const SphericalRectangle rectangle(light.Center, light.Normal, light.AxisU, light.AxisV, from);
      const double solidAngle = rectangle.SolidAngle();
      if (!(solidAngle > 0.0))
      {
        return TowardsCenter(light, from);
      }
      if (solidAngle < SphericalRectangle::MinimumSolidAngle)
      {
        return DirectionOfSurfaceSample(SampleLightArea(light, u, v), from);
      }
      const Vector3 to = rectangle.Sample(u, v);
      const double distance = Length(to);
      return { (1.0 / distance) * to, distance, 1.0 / solidAngle };
    }
    case LightShape::Sphere:
    {
      double distance = 0.0;
      const DirectionCone cone = SphereCone(light, from, distance);
      if (cone.OneMinusCosine < 0.0)
      {
        return TowardsCenter(light, from);
      }
      const Vector3 direction = cone.Sample(u, v, oneMinusCosine);
      const double sineSquared = oneMinusCosine * (2.0 - oneMinusCosine);
      const double depth = std::sqrt(std::max(Square(light.Radius) - Square(distance) * sineSquared, 0.0));
      return { direction, std::max(distance * (1.0 - oneMinusCosine) - depth, 0.0), cone.Density() };
    }
    case LightShape::Sun:
    {
      const DirectionCone cone = SunCone(light);
      return { cone.Sample(u, v, oneMinusCosine), Infinity, cone.Density() };
    }
    case LightShape::Mesh:
      if (HasTriangles(light))
      {
        return DirectionOfSurfaceSample(SampleMeshArea(light, u, v), from);
      }
      break;
    case LightShape::Point:
      break;
  }
  return DirectionOfPoint(light, from, u);
}

//------------------------------------------------------------------------------
double LightSolidAngleDensity(const Light& light, const Vector3& from, const Vector3& direction)
{
  double distance = 0.0;
  double cosine = 0.0;
  switch (light.Shape)
  {
    case LightShape::Disc:
    case LightShape::Rectangle:
    {
      if (!HitPlanarLight(light, from, direction, distance, cosine))
      {
        return 0.0;
      }
      const double solidAngle = LightSolidAngle(light, from);
      return light.Shape == LightShape::Rectangle && solidAngle < SphericalRectangle::MinimumSolidAngle
        ? Square(distance) / (cosine * LightArea(light))
        : 1.0 / solidAngle;
    }
    case LightShape::Sphere:
    {
      const DirectionCone cone = SphereCone(light, from, distance);
      return cone.OneMinusCosine >= 0.0 && cone.Contains(direction) ? cone.Density() : 0.0;
    }
    case LightShape::Sun:
    {
      const DirectionCone cone = SunCone(light);
      return cone.Contains(direction) || SameDirection(direction, cone.Axis) ? cone.Density() : 0.0;
    }
    case LightShape::Mesh:
      if (HasTriangles(light))
      {
        // A direction that meets several faces is drawn from each of them.
        double sum = 0.0;
        for (const auto& triangle : light.Triangles)
        {
          sum += HitFace(triangle, from, direction, distance, cosine) ? Square(distance) / cosine : 0.0;
        }
        return sum / LightArea(light);
      }
      break;
    case LightShape::Point:
      break;
  }
  const std::size_t count = NumberOfPoints(light);
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    found += SameDirection(Normalized(PointAt(light, i) - from), direction) ? 1 : 0;
  }
  return static_cast<double>(found) / static_cast<double>(count);
}

//------------------------------------------------------------------------------
std::array<double, 2> InvertLightSolidAngle(const Light& light, const Vector3& from, const Vector3& direction)
{
  double distance = 0.0;
  double cosine = 0.0;
  switch (light.Shape)
  {
    case LightShape::Disc:
    {
      const SphericalEllipse ellipse(light.Center, light.Normal, light.Radius, from);
      if (!(ellipse.SolidAngle() > 0.0))
      {
        return { 0.5, 0.5 };
      }
      const std::array<double, 2> uv = ellipse.Invert(direction);
      return { UnitInterval(uv[0]), UnitInterval(uv[1]) };
    }
    case LightShape::Rectangle:
    {
      const SphericalRectangle rectangle(light.Center, light.Normal, light.AxisU, light.AxisV, from);
      if (!(rectangle.SolidAngle() > 0.0))
      {
        return { 0.5, 0.5 };
      }
      if (rectangle.SolidAngle() < SphericalRectangle::MinimumSolidAngle)
      {
        HitPlanarLight(light, from, direction, distance, cosine);
        return InvertLightArea(light, from + distance * direction);
      }
      const std::array<double, 2> uv = rectangle.Invert(direction);
      return { UnitInterval(uv[0]), UnitInterval(uv[1]) };
    }
    case LightShape::Sphere:
    {
      const DirectionCone cone = SphereCone(light, from, distance);
      return cone.OneMinusCosine >= 0.0 ? cone.Invert(direction) : std::array<double, 2>{ 0.5, 0.5 };
    }
    case LightShape::Sun:
      return SunCone(light).Invert(direction);
    case LightShape::Mesh:
      if (HasTriangles(light))
      {
        double nearest = Infinity;
        for (const auto& triangle : light.Triangles)
        {
          if (HitFace(triangle, from, direction, distance, cosine))
          {
            nearest = std::min(nearest, distance);
          }
        }
        return std::isfinite(nearest) ? InvertMeshArea(light, from + nearest * direction)
                                      : std::array<double, 2>{ 0.5, 0.5 };
      }
      break;
    case LightShape::Point:
      break;
  }
  const std::size_t count = NumberOfPoints(light);
  std::size_t best = 0;
  double bestDifference = Infinity;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double difference = Length(Normalized(PointAt(light, i) - from) - direction);
    best = difference < bestDifference ? i : best;
    bestDifference = std::min(difference, bestDifference);
  }
  return { (static_cast<double>(best) + 0.5) / static_cast<double>(count), 0.5 };
}

//------------------------------------------------------------------------------
double LightSolidAngle(const Light& light, const Vector3& from)
{
  switch (light.Shape)
  {
    case LightShape::Disc:
      return SphericalEllipse(light.Center, light.Normal, light.Radius, from).SolidAngle();
    case LightShape::Rectangle:
      return SphericalRectangle(light.Center, light.Normal, light.AxisU, light.AxisV, from).SolidAngle();
    case LightShape::Sphere:
    {
      double distance = 0.0;
      const DirectionCone cone = SphereCone(light, from, distance);
      return cone.OneMinusCosine > 0.0 ? cone.SolidAngle() : 0.0;
    }
    case LightShape::Sun:
      return SunCone(light).SolidAngle();
    case LightShape::Mesh:
    {
      double sum = 0.0;
      for (const auto& t : light.Triangles)
      {
        const double volume = Dot(from - t[0], TriangleNormal(t));
        sum += volume > 0.0 ? TriangleSolidAngle(volume, t[0] - from, t[1] - from, t[2] - from) : 0.0;
      }
      return sum;
    }
    case LightShape::Point:
      break;
  }
  return 0.0;
}

//------------------------------------------------------------------------------
IncidentSample SampleIncidentLight(
  const Light& light, const Vector3& from, double u, double v, LightSampling sampling)
{
  if (IsPointlike(light))
  {
    const LightDirectionSample sample = DirectionOfPoint(light, from, u);
    return { sample.Direction, sample.Distance,
      sample.Density > 0.0 ? 1.0 / (sample.Density * Square(sample.Distance)) : 0.0 };
  }
  if (light.Shape == LightShape::Sun)
  {
    const LightDirectionSample sample = SampleLightSolidAngle(light, from, u, v);
    return { sample.Direction, sample.Distance, 1.0 };
  }
  const bool planar = light.Shape == LightShape::Disc || light.Shape == LightShape::Rectangle;
  const bool bySolidAngle = sampling == LightSampling::SolidAngle ||
    (sampling == LightSampling::Auto && (light.Shape == LightShape::Sphere || (planar && IsNear(light, from))));
  if (!bySolidAngle)
  {
    return IncidentByArea(light, from, u, v);
  }
  const LightDirectionSample sample = SampleLightSolidAngle(light, from, u, v);
  return { sample.Direction, sample.Distance, sample.Density > 0.0 ? 1.0 / sample.Density : 0.0 };
}

//------------------------------------------------------------------------------
IncidentSample SampleVisibleLight(const Light& light, const Vector3& from, double u, double v)
{
  if (IsPointlike(light) || light.Shape == LightShape::Sphere || light.Shape == LightShape::Sun)
  {
    const LightDirectionSample sample = SampleLightSolidAngle(light, from, u, v);
    return { sample.Direction, sample.Distance, sample.Density > 0.0 ? 1.0 : 0.0 };
  }
  const LightDirectionSample sample = DirectionOfSurfaceSample(SampleLightArea(light, u, v), from);
  return { sample.Direction, sample.Distance, sample.Density > 0.0 ? 1.0 : 0.0 };
}

} // namespace shadowcones
