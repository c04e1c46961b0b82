// SPDX-License-Identifier: BSD-3-Clause
#include "scLitIntervals.h"

#include "scLampPlane.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Faces of the box are numbered from 0 to 5: twice the axis, one more for the larger coordinate. Then:
constexpr int atOrigin = 6; ///< of the ray: the camera is inside
constexpr int atLight = 7;  ///< its plane, or its sphere
constexpr int atDepth = 8;  ///< behind it nothing is seen
constexpr int numberOfFaces = 9;
} // anonymous namespace

LitIntervals::LitIntervals(const Light& light, const Box& bounds, double deepest)
  : Lamp(light)
  , Bounds(bounds)
  , Deepest(deepest)
  , Face(FlatFaceOf(light))
{
}

double LitIntervals::HalfChord(const Ray& ray) const
{
  const Vector3 offset = ray.Origin - this->Lamp.Center;
  const Vector3 nearest = offset - Dot(offset, ray.Direction) * ray.Direction;
  return std::sqrt(std::max(this->Lamp.Radius * this->Lamp.Radius - Dot(nearest, nearest), 0.0));
}

double LitIntervals::DistanceTo(const Ray& ray, int face) const
{
  switch (face)
  {
    case atOrigin:
      return 0.0;
    case atLight:
      if (!this->Face.IsFlat)
      {
        return Dot(this->Lamp.Center - ray.Origin, ray.Direction); // the middle of the sphere
      }
      return Dot(this->Face.Center - ray.Origin, this->Face.Normal) / Dot(ray.Direction, this->Face.Normal);
    default:
      return ((face % 2 == 0 ? this->Bounds.Min : this->Bounds.Max)[face / 2] - ray.Origin[face / 2]) /
        ray.Direction[face / 2];
  }
}

/// Nothing is lit behind a flat light, and its brightness has a kink or jump in its plane.
void LitIntervals::CutAtPlane(const Ray& ray, LitInterval& interval, int& first, int& exit) const
{
  const double slope = Dot(ray.Direction, this->Face.Normal);
  const double height = Dot(ray.Origin - this->Face.Center, this->Face.Normal);
  const double t = slope != 0.0 ? -height / slope : (height > 0.0 ? -HUGE_VAL : HUGE_VAL);
  if (slope < 0.0 && t < interval.End)
  {
    interval.End = t;
    exit = atLight;
  }
  else if (slope >= 0.0 && t > interval.Begin)
  {
    interval.Begin = t;
    first = atLight;
  }
}

/// Nothing is lit inside a sphere that emits.
void LitIntervals::CutAtSphere(const Ray& ray, LitInterval& interval, int& first, int& exit) const
{
  const double half = this->HalfChord(ray);
  const double middle = Dot(this->Lamp.Center - ray.Origin, ray.Direction);
  if (half > 0.0 && interval.Begin < middle - half && middle + half < interval.End)
  {
    interval.HasGap = true;
    interval.HalfGap = half;
  }
  else if (half > 0.0 && interval.Begin >= middle - half && interval.Begin < middle + half)
  {
    interval.Begin = middle + half;
    first = atLight;
  }
  else if (half > 0.0 && interval.End <= middle + half && interval.End > middle - half)
  {
    interval.End = middle - half;
    exit = atLight;
  }
}

LitInterval LitIntervals::Find(const Ray& ray) const
{
  LitInterval interval;
  interval.End = HUGE_VAL;
  int entry = atOrigin;
  int exit = atOrigin; // every ray leaves the box through a face
  for (int axis = 0; axis < 3; ++axis)
  {
    const double o = ray.Origin[axis];
    const double d = ray.Direction[axis];
    if (d == 0.0)
    {
      if (o < this->Bounds.Min[axis] || o > this->Bounds.Max[axis])
      {
        return {};
      }
      continue;
    }
    const int face = 2 * axis + (d > 0.0 ? 0 : 1);
    const double a = this->DistanceTo(ray, face);
    const double b = this->DistanceTo(ray, face ^ 1);
    if (a > interval.Begin)
    {
      interval.Begin = a;
      entry = face;
    }
    if (b < interval.End)
    {
      interval.End = b;
      exit = face ^ 1;
    }
  }
  interval.MediumBegin = interval.Begin;
  if (interval.Begin + this->Deepest < interval.End)
  {
    interval.End = interval.Begin + this->Deepest;
    exit = atDepth;
  }
  int first = entry;
  if (this->Face.IsFlat)
  {
    this->CutAtPlane(ray, interval, first, exit);
  }
  if (this->Lamp.Shape == LightShape::Sphere)
  {
    this->CutAtSphere(ray, interval, first, exit);
  }
  if (interval.Empty())
  {
    return {};
  }
  interval.Faces = (((interval.HasGap ? 1 : 0) * numberOfFaces + entry) * numberOfFaces + first) * numberOfFaces + exit;
  return interval;
}

LitInterval LitIntervals::Between(const Ray& ray, int faces) const
{
  const int exit = faces % numberOfFaces;
  const int first = faces / numberOfFaces % numberOfFaces;
  const int entry = faces / (numberOfFaces * numberOfFaces) % numberOfFaces;
  const bool sphere = this->Lamp.Shape == LightShape::Sphere;
  LitInterval interval;
  interval.MediumBegin = this->DistanceTo(ray, entry);
  interval.Begin = this->DistanceTo(ray, first) + (sphere && first == atLight ? this->HalfChord(ray) : 0.0);
  interval.End = exit == atDepth ? interval.MediumBegin + this->Deepest : this->DistanceTo(ray, exit);
  interval.End -= sphere && exit == atLight ? this->HalfChord(ray) : 0.0;
  interval.HasGap = faces >= numberOfFaces * numberOfFaces * numberOfFaces;
  interval.HalfGap = interval.HasGap ? this->HalfChord(ray) : 0.0;
  interval.Faces = faces;
  return interval;
}

} // namespace shadowcones
