// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scBox.h
 * @brief A box along the axes.
 */
#ifndef scBox_h
#define scBox_h

#include "scVector3.h"

#include <cmath>

namespace shadowcones
{

/// An axis-aligned box; empty (Min > Max) until a point is added.
struct Box
{
  Vector3 Min{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
  Vector3 Max{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

  bool Empty() const { return !(this->Min.X <= this->Max.X); }
  void Add(const Vector3& p)
  {
    this->Min = { std::fmin(this->Min.X, p.X), std::fmin(this->Min.Y, p.Y), std::fmin(this->Min.Z, p.Z) };
    this->Max = { std::fmax(this->Max.X, p.X), std::fmax(this->Max.Y, p.Y), std::fmax(this->Max.Z, p.Z) };
  }
  void Add(const Box& b)
  {
    if (!b.Empty())
    {
      this->Add(b.Min);
      this->Add(b.Max);
    }
  }
  Vector3 Center() const { return 0.5 * (this->Min + this->Max); }
  Vector3 Size() const { return this->Max - this->Min; }
  double Diagonal() const { return this->Empty() ? 0.0 : Length(this->Size()); }
  bool Contains(const Vector3& p) const
  {
    return p.X >= this->Min.X && p.X <= this->Max.X && p.Y >= this->Min.Y && p.Y <= this->Max.Y && p.Z >= this->Min.Z &&
      p.Z <= this->Max.Z;
  }

  /// Cut [tMin, tMax] of the ray to the part inside the box; false where nothing is left.
  bool Clip(const Vector3& origin, const Vector3& direction, double& tMin, double& tMax) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double o = origin[axis];
      const double d = direction[axis];
      if (d == 0.0)
      {
        if (o < this->Min[axis] || o > this->Max[axis])
        {
          return false;
        }
        continue;
      }
      const double a = (this->Min[axis] - o) / d;
      const double b = (this->Max[axis] - o) / d;
      // Plain comparisons: faster than fmin and fmax, and NaN leaves the limits alone as there.
      const double near = a < b ? a : b;
      const double far = a < b ? b : a;
      tMin = near > tMin ? near : tMin;
      tMax = far < tMax ? far : tMax;
    }
    return tMin < tMax;
  }
};

/// What two boxes have in common; empty where they have no point.
inline Box Intersection(const Box& a, const Box& b)
{
  const Box box{ { std::fmax(a.Min.X, b.Min.X), std::fmax(a.Min.Y, b.Min.Y), std::fmax(a.Min.Z, b.Min.Z) },
    { std::fmin(a.Max.X, b.Max.X), std::fmin(a.Max.Y, b.Max.Y), std::fmin(a.Max.Z, b.Max.Z) } };
  return box.Min.X <= box.Max.X && box.Min.Y <= box.Max.Y && box.Min.Z <= box.Max.Z ? box : Box();
}

} // namespace shadowcones

#endif
