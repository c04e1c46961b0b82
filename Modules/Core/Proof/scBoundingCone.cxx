// SPDX-License-Identifier: BSD-3-Clause
#include "scBoundingCone.h"

#include "scConstants.h"
#include "scFrame.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace shadowcones
{
namespace
{

double AngleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(Length(Cross(a, b)), Dot(a, b));
}

/// The float at or above a value and above its rounding errors.
double StoredAbove(double value)
{
  return std::nextafter(
    static_cast<float>(RoundToSingle(value * (1.0 + 1e-12))), std::numeric_limits<float>::infinity());
}

/// The value in single precision, some of its neighbours further.
double Stepped(double value, int steps)
{
  auto stepped = static_cast<float>(RoundToSingle(value));
  for (int i = 0; i < std::abs(steps); ++i)
  {
    stepped = std::nextafter(stepped, steps > 0 ? 2.0f : -2.0f);
  }
  return stepped;
}

/// A point in the plane across the axis with the radius of a circle around it, negative where the cone widens up to it.
struct Circle
{
  double X;
  double Y;
  double Radius;
};

/// How far around a centre the circles reach, and the one that reaches farthest.
double ReachFrom(double x, double y, const std::vector<Circle>& circles, const Circle*& farthest)
{
  double reach = -HUGE_VAL;
  for (const Circle& circle : circles)
  {
    const double distance = std::sqrt((circle.X - x) * (circle.X - x) + (circle.Y - y) * (circle.Y - y)) + circle.Radius;
    if (distance > reach)
    {
      reach = distance;
      farthest = &circle;
    }
  }
  return reach;
}

/// The circles that reach farthest along some directions: they decide, near enough.
std::vector<Circle> Outermost(const std::vector<Circle>& circles)
{
  constexpr int directions = 48;
  if (circles.size() <= directions)
  {
    return circles;
  }
  std::vector<Circle> kept;
  for (int d = 0; d < directions; ++d)
  {
    const double x = std::cos(2.0 * Pi * d / directions);
    const double y = std::sin(2.0 * Pi * d / directions);
    kept.push_back(*std::max_element(circles.begin(), circles.end(), [x, y](const Circle& a, const Circle& b) {
      return a.X * x + a.Y * y + a.Radius < b.X * x + b.Y * y + b.Radius;
    }));
  }
  return kept;
}

/// A small circle around all circles, near the smallest (Badoiu and Clarkson 2003).
Circle CircleAround(const std::vector<Circle>& circles)
{
  const std::vector<Circle> outermost = Outermost(circles);
  Circle at{ 0.0, 0.0, 0.0 };
  for (const Circle& circle : outermost)
  {
    at.X += circle.X / static_cast<double>(outermost.size());
    at.Y += circle.Y / static_cast<double>(outermost.size());
  }
  Circle best = at;
  best.Radius = HUGE_VAL;
  const Circle* farthest = outermost.data();
  for (int k = 1; k <= 32; ++k)
  {
    const double reach = ReachFrom(at.X, at.Y, outermost, farthest);
    if (reach < best.Radius)
    {
      best = { at.X, at.Y, reach };
    }
    at.X += (farthest->X - at.X) / (k + 1.0);
    at.Y += (farthest->Y - at.Y) / (k + 1.0);
  }
  best.Radius = ReachFrom(best.X, best.Y, circles, farthest);
  return best;
}

Vector3 MeanDirection(const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points)
{
  // The middle of the box of directions: many points on one side do not draw it there.
  Box directions;
  for (const HeldPoint& held : points)
  {
    const LightPart& part = parts[held.Part];
    directions.Add(part.AtInfinity ? part.Center : Normalized(held.Point - part.Center));
  }
  return StoredDirection(Normalized(directions.Center()));
}
} // anonymous namespace

Vector3 StoredDirection(const Vector3& direction)
{
  const auto read = [](const Vector3& v) {
    return Normalized({ RoundToSingle(v.X), RoundToSingle(v.Y), RoundToSingle(v.Z) });
  };
  const auto stays = [&read](const Vector3& v) {
    const Vector3 again = read(v);
    return again.X == v.X && again.Y == v.Y && again.Z == v.Z;
  };
  // Normalising what was rounded may round otherwise the next time: look among the neighbours in single precision.
  for (const int x : { 0, 1, -1, 2, -2 })
  {
    for (const int y : { 0, 1, -1, 2, -2 })
    {
      for (const int z : { 0, 1, -1, 2, -2 })
      {
        const Vector3 near = read({ Stepped(direction.X, x), Stepped(direction.Y, y), Stepped(direction.Z, z) });
        if (stays(near))
        {
          return near;
        }
      }
    }
  }
  return read(direction);
}

BoundingCone::BoundingCone(const Cone& cone)
  : Center(cone.Center)
  , Axis(cone.Axis)
  , Radius(cone.BaseRadius)
  , Angle(cone.HalfAngle)
  , Sine(std::sin(cone.HalfAngle))
  , Cosine(std::cos(cone.HalfAngle))
{
}

double BoundingCone::DirectionDepth(const Vector3& v) const
{
  const double along = Dot(v, this->Axis);
  const double across = std::sqrt(std::max(0.0, Dot(v, v) - along * along));
  return along * this->Sine - across * this->Cosine;
}

double BoundingCone::Depth(const Vector3& point) const
{
  const Vector3 offset = point - this->Center;
  return this->Angle < 0.0
    ? -HUGE_VAL
    : std::min(Dot(offset, this->Axis), this->DirectionDepth(offset) + this->Radius * this->Cosine);
}

double BoundingCone::ShadowDepthAtLeast(const LightPart& part, const Vector3& point) const
{
  if (part.AtInfinity)
  {
    return AngleBetween(this->Axis, part.Center) + part.Radius + angularMargin <= this->Angle ? HUGE_VAL : -HUGE_VAL;
  }
  return this->DirectionDepth(point - part.Center) - part.Radius;
}

double BoundingCone::ShadowDepthAtMost(const LightPart& part, const Vector3& point) const
{
  const double least = this->ShadowDepthAtLeast(part, point);
  return part.Points.empty() ? least : least + part.Radius;
}

double BoundingCone::ShadowDepth(const LightPart& part, const Vector3& point) const
{
  if (part.Points.empty())
  {
    return this->ShadowDepthAtLeast(part, point);
  }
  double least = HUGE_VAL;
  for (const Vector3& y : part.Points)
  {
    least = std::min(least, this->DirectionDepth(point - y));
  }
  return least;
}

bool BoundingCone::Holds(const LightPart& part, const Vector3& point, double margin) const
{
  return this->Depth(point) >= margin && this->ShadowDepthAtMost(part, point) >= margin &&
    (this->ShadowDepthAtLeast(part, point) >= margin || this->ShadowDepth(part, point) >= margin);
}

double NeededAngle(const LightPart& part, const Vector3& axis, const Vector3& point, double margin)
{
  if (part.AtInfinity)
  {
    return AngleBetween(axis, part.Center) + part.Radius + angularMargin;
  }
  const auto toBall = [&](const Vector3& center, double radius) {
    const double distance = Length(point - center);
    return distance > radius ? AngleBetween(axis, point - center) + std::asin(radius / distance) : Pi;
  };
  if (part.Points.empty())
  {
    return toBall(part.Center, part.Radius + margin);
  }
  double needed = 0.0;
  for (const Vector3& y : part.Points)
  {
    needed = std::max(needed, toBall(y, margin));
  }
  return needed;
}

bool ConeAround(const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points, const Cone* core, Cone& cone)
{
  return ConeAlong(core ? core->Axis : MeanDirection(parts, points), parts, points, core, cone);
}

bool ConeAlong(const Vector3& axis, const std::vector<LightPart>& parts, const std::vector<HeldPoint>& points,
  const Cone* core, Cone& cone)
{
  cone.Axis = StoredDirection(axis);
  double angle = core ? std::max(0.0, core->HalfAngle) : 0.0;
  double front = core ? Dot(core->Center, cone.Axis) : HUGE_VAL;
  Cone probe = cone;
  probe.HalfAngle = angle;
  BoundingCone directions(probe);
  for (const HeldPoint& held : points)
  {
    // Most points need no wider cone than those before, and that is cheap to see.
    if (directions.ShadowDepthAtLeast(parts[held.Part], held.Point) < 1.0002 * held.Margin)
    {
      angle = std::max(angle, NeededAngle(parts[held.Part], cone.Axis, held.Point, 1.0001 * held.Margin));
      if (!(angle < largestProvedAngle))
      {
        return false;
      }
      probe.HalfAngle = angle;
      directions = BoundingCone(probe);
    }
    front = std::min(front, Dot(held.Point, cone.Axis) - 1.0001 * held.Margin);
  }
  if (points.empty())
  {
    return false;
  }
  cone.HalfAngle = angle > 0.0 ? StoredAbove(angle) : 0.0;
  const double tangent = std::tan(cone.HalfAngle);
  const double secant = 1.0 / std::cos(cone.HalfAngle);
  const Frame frame = FrameAround(cone.Axis);
  std::vector<Circle> circles;
  const auto add = [&](const Vector3& p, double radius) {
    const double height = Dot(p, cone.Axis) - front;
    circles.push_back({ Dot(p, frame.U), Dot(p, frame.V), radius - height * tangent });
  };
  for (const HeldPoint& held : points)
  {
    add(held.Point, 1.0001 * held.Margin * secant);
  }
  if (core)
  {
    add(core->Center, core->BaseRadius);
  }
  const Circle base = CircleAround(circles);
  cone.Center = base.X * frame.U + base.Y * frame.V + front * cone.Axis;
  cone.BaseRadius = base.Radius > 0.0 ? StoredAbove(base.Radius) : 0.0;
  return true;
}

} // namespace shadowcones
