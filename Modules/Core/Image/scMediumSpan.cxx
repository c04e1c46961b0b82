// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumSpan.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Faces of the box are numbered from 0 to 5: twice the axis, one more for the larger coordinate. Then:
constexpr int atOrigin = 6; ///< of the ray: the camera is inside
constexpr int atLight = 7; ///< its plane, or its sphere
constexpr int atDepth = 8; ///< behind it nothing is seen
constexpr int numberOfFaces = 9;
} // anonymous namespace

MediumSpans::MediumSpans(const Light& light, const Box& bounds, double deepest)
  : Source(light)
  , Bounds(bounds)
  , Deepest(deepest)
  , Face(FlatFaceOf(light))
{
}

double MediumSpans::HalfChord(const Ray& ray) const
{
  const Vector3 offset = ray.Origin - this->Source.Center;
  const Vector3 nearest = offset - Dot(offset, ray.Direction) * ray.Direction;
  return std::sqrt(std::max(this->Source.Radius * this->Source.Radius - Dot(nearest, nearest), 0.0));
}

double MediumSpans::DistanceTo(const Ray& ray, int face) const
{
  switch (face)
  {
    case atOrigin:
      return 0.0;
    case atLight:
      if (!this->Face.IsFlat)
      {
        return Dot(this->Source.Center - ray.Origin, ray.Direction); // the middle of the sphere
      }
      return Dot(this->Face.Center - ray.Origin, this->Face.Normal) / Dot(ray.Direction, this->Face.Normal);
    default:
      return ((face % 2 == 0 ? this->Bounds.Min : this->Bounds.Max)[face / 2] - ray.Origin[face / 2]) /
        ray.Direction[face / 2];
  }
}

MediumSpan MediumSpans::Find(const Ray& ray) const
{
  MediumSpan span;
  span.End = HUGE_VAL;
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
    if (a > span.Begin)
    {
      span.Begin = a;
      entry = face;
    }
    if (b < span.End)
    {
      span.End = b;
      exit = face ^ 1;
    }
  }
  span.MediumBegin = span.Begin;
  if (span.Begin + this->Deepest < span.End)
  {
    span.End = span.Begin + this->Deepest;
    exit = atDepth;
  }
  int first = entry;
  if (this->Face.IsFlat)
  {
    // Nothing is lit behind the light, and its brightness has a kink or jump in its plane.
    const double slope = Dot(ray.Direction, this->Face.Normal);
    const double height = Dot(ray.Origin - this->Face.Center, this->Face.Normal);
    const double t = slope != 0.0 ? -height / slope : (height > 0.0 ? -HUGE_VAL : HUGE_VAL);
    if (slope < 0.0 && t < span.End)
    {
      span.End = t;
      exit = atLight;
    }
    else if (slope >= 0.0 && t > span.Begin)
    {
      span.Begin = t;
      first = atLight;
    }
  }
  if (this->Source.Shape == LightShape::Sphere)
  {
    const double half = this->HalfChord(ray);
    const double middle = Dot(this->Source.Center - ray.Origin, ray.Direction);
    if (half > 0.0 && span.Begin < middle - half && middle + half < span.End)
    {
      span.HasGap = true;
      span.HalfGap = half;
    }
    else if (half > 0.0 && span.Begin >= middle - half && span.Begin < middle + half)
    {
      span.Begin = middle + half;
      first = atLight;
    }
    else if (half > 0.0 && span.End <= middle + half && span.End > middle - half)
    {
      span.End = middle - half;
      exit = atLight;
    }
  }
  if (span.Empty())
  {
    return {};
  }
  span.Faces = (((span.HasGap ? 1 : 0) * numberOfFaces + entry) * numberOfFaces + first) * numberOfFaces + exit;
  return span;
}

MediumSpan MediumSpans::Between(const Ray& ray, int faces) const
{
  const int exit = faces % numberOfFaces;
  const int first = faces / numberOfFaces % numberOfFaces;
  const int entry = faces / (numberOfFaces * numberOfFaces) % numberOfFaces;
  const bool sphere = this->Source.Shape == LightShape::Sphere;
  MediumSpan span;
  span.MediumBegin = this->DistanceTo(ray, entry);
  span.Begin = this->DistanceTo(ray, first) + (sphere && first == atLight ? this->HalfChord(ray) : 0.0);
  span.End = exit == atDepth ? span.MediumBegin + this->Deepest : this->DistanceTo(ray, exit);
  span.End -= sphere && exit == atLight ? this->HalfChord(ray) : 0.0;
  span.HasGap = faces >= numberOfFaces * numberOfFaces * numberOfFaces;
  span.HalfGap = span.HasGap ? this->HalfChord(ray) : 0.0;
  span.Faces = faces;
  return span;
}

} // namespace shadowcones
