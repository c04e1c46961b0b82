// SPDX-License-Identifier: BSD-3-Clause
#include "scShapeOfMesh.h"

#include "scConstants.h"
#include "scFrame.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace shadowcones
{
namespace
{
using Triangles = std::vector<std::array<Vector3, 3>>;

/// Shares this close to 1 are rounding.
constexpr double fractionTolerance = 1e-6;
/// Steps from corner to corner of a regular polygon may differ by this share.
constexpr double largestUnevenness = 1e-3;

double SizeOf(const Light& shape)
{
  return shape.Shape == LightShape::Rectangle ? std::min(Length(shape.AxisU), Length(shape.AxisV)) : shape.Radius;
}

Vector3 AreaVector(const Triangles& triangles)
{
  Vector3 sum;
  for (const auto& t : triangles)
  {
    sum += 0.5 * Cross(t[1] - t[0], t[2] - t[0]);
  }
  return sum;
}

double DistanceFrom(const Light& shape, const Vector3& corner)
{
  const Vector3 offset = corner - shape.Center;
  if (shape.Shape == LightShape::Sphere)
  {
    return std::fabs(Length(offset) - shape.Radius);
  }
  const double height = Dot(offset, shape.Normal);
  if (shape.Shape == LightShape::Disc)
  {
    return std::hypot(height, std::max(0.0, Length(offset - height * shape.Normal) - shape.Radius));
  }
  const double u = Length(shape.AxisU);
  const double v = Length(shape.AxisV);
  return std::hypot(height, std::max(0.0, std::fabs(Dot(offset, shape.AxisU)) / u - u),
    std::max(0.0, std::fabs(Dot(offset, shape.AxisV)) / v - v));
}

/// The area of the regular polygon whose corners are those of the triangles that lie on the rim; the disc's where they
/// are not spread evenly.
double AreaOfRim(const Light& disc, const Triangles& triangles, double tolerance)
{
  const Frame frame = FrameAround(disc.Normal);
  std::vector<double> angles;
  for (const auto& triangle : triangles)
  {
    for (const Vector3& corner : triangle)
    {
      const double x = Dot(corner - disc.Center, frame.U);
      const double y = Dot(corner - disc.Center, frame.V);
      if (std::fabs(std::hypot(x, y) - disc.Radius) <= tolerance)
      {
        angles.push_back(std::atan2(y, x));
      }
    }
  }
  std::sort(angles.begin(), angles.end());
  const double slack = 4.0 * tolerance / disc.Radius + 1e-9;
  std::vector<double> steps;
  double last = angles.empty() ? 0.0 : angles.back() - 2.0 * Pi;
  for (const double angle : angles)
  {
    if (angle - last > slack)
    {
      steps.push_back(angle - last);
      last = angle;
    }
  }
  const auto count = static_cast<double>(steps.size());
  const double step = 2.0 * Pi / std::max(count, 1.0);
  const bool even = count >= 3.0 &&
    std::all_of(steps.begin(), steps.end(),
      [&](double s) { return std::fabs(s - step) <= largestUnevenness * step + slack; });
  return disc.Radius * disc.Radius * (even ? 0.5 * count * std::sin(step) : Pi);
}

/// Seen from a point, positive where the triangle's normal points away; van Oosterom and Strackee (1983).
double SolidAngleOf(const std::array<Vector3, 3>& triangle, const Vector3& from)
{
  const Vector3 a = triangle[0] - from;
  const Vector3 b = triangle[1] - from;
  const Vector3 c = triangle[2] - from;
  const double la = Length(a);
  const double lb = Length(b);
  const double lc = Length(c);
  return 2.0 * std::atan2(Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
}

/// Every corner once.
std::vector<Vector3> CornersOf(const Triangles& triangles)
{
  std::vector<Vector3> corners;
  for (const auto& triangle : triangles)
  {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  const auto key = [](const Vector3& p) { return std::make_tuple(p.X, p.Y, p.Z); };
  std::sort(corners.begin(), corners.end(), [&](const Vector3& a, const Vector3& b) { return key(a) < key(b); });
  corners.erase(std::unique(corners.begin(), corners.end(),
                  [&](const Vector3& a, const Vector3& b) { return key(a) == key(b); }),
    corners.end());
  return corners;
}

/// Half edges of the rectangle of four corners, in the order of their angles around the normal.
bool FindAxes(std::vector<Vector3> corners, double tolerance, Light& rectangle)
{
  if (corners.size() != 4)
  {
    return false;
  }
  const Frame frame = FrameAround(rectangle.Normal);
  const auto angle = [&](const Vector3& p)
  { return std::atan2(Dot(p - rectangle.Center, frame.V), Dot(p - rectangle.Center, frame.U)); };
  std::sort(
    corners.begin(), corners.end(), [&](const Vector3& a, const Vector3& b) { return angle(a) < angle(b); });
  rectangle.AxisU = 0.5 * (corners[1] - corners[0]);
  rectangle.AxisV = 0.5 * (corners[2] - corners[1]);
  const double size = std::max(Length(rectangle.AxisU), Length(rectangle.AxisV));
  return std::fabs(Dot(rectangle.AxisU, rectangle.AxisV)) <= 2.0 * tolerance * size;
}
} // anonymous namespace

ShapeMisfit MisfitOf(const Light& shape, const Triangles& triangles, double tolerance)
{
  ShapeMisfit misfit;
  for (const auto& triangle : triangles)
  {
    for (const Vector3& corner : triangle)
    {
      misfit.Distance = std::max(misfit.Distance, DistanceFrom(shape, corner));
    }
  }
  if (shape.Shape == LightShape::Sphere)
  {
    double angle = 0.0;
    for (const auto& triangle : triangles)
    {
      angle += SolidAngleOf(triangle, shape.Center);
    }
    misfit.Fraction = angle / (4.0 * Pi);
    return misfit;
  }
  const double whole =
    shape.Shape == LightShape::Disc ? AreaOfRim(shape, triangles, tolerance) : LightArea(shape);
  misfit.Fraction = Dot(AreaVector(triangles), shape.Normal) / whole;
  return misfit;
}

bool IsFit(const Light& shape, const ShapeMisfit& misfit, double tolerance)
{
  return misfit.Distance <= tolerance &&
    std::fabs(misfit.Fraction - 1.0) <= fractionTolerance + 8.0 * tolerance / SizeOf(shape);
}

bool FindShape(const Triangles& triangles, double tolerance, Light& shape)
{
  const std::vector<Vector3> corners = CornersOf(triangles);
  if (corners.size() < 3)
  {
    return false;
  }
  Light found = shape;
  const double fraction = 1.0 / static_cast<double>(corners.size());
  found.Center = {};
  for (const Vector3& corner : corners)
  {
    found.Center += fraction * corner;
  }
  found.Radius = 0.0;
  for (const Vector3& corner : corners)
  {
    found.Radius += fraction * Length(corner - found.Center);
  }
  if (shape.Shape != LightShape::Sphere)
  {
    found.Normal = Normalized(AreaVector(triangles));
  }
  if (!(found.Radius > 2.0 * tolerance) ||
    (shape.Shape == LightShape::Rectangle && !FindAxes(corners, tolerance, found)) || PrepareLight(found) ||
    !IsFit(found, MisfitOf(found, triangles, tolerance), tolerance))
  {
    return false;
  }
  shape = found;
  return true;
}

} // namespace shadowcones
