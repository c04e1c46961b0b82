// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVector3.h
 * @brief A point or direction in world units, in double precision.
 */
#ifndef scVector3_h
#define scVector3_h

#include <cmath>

namespace shadowcones
{

struct Vector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  constexpr double operator[](int axis) const { return axis == 0 ? this->X : axis == 1 ? this->Y : this->Z; }
  constexpr Vector3 operator-() const { return { -this->X, -this->Y, -this->Z }; }
  Vector3& operator+=(const Vector3& b)
  {
    this->X += b.X;
    this->Y += b.Y;
    this->Z += b.Z;
    return *this;
  }
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
constexpr Vector3 operator*(double s, const Vector3& a)
{
  return { s * a.X, s * a.Y, s * a.Z };
}
constexpr Vector3 operator*(const Vector3& a, double s)
{
  return s * a;
}
constexpr double Dot(const Vector3& a, const Vector3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
constexpr Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}
/// The unit vector along @p a; @p a itself where its length is 0.
inline Vector3 Normalized(const Vector3& a)
{
  const double length = Length(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}
inline bool IsFinite(const Vector3& a)
{
  return std::isfinite(a.X) && std::isfinite(a.Y) && std::isfinite(a.Z);
}

/// Two unit vectors that make a right-handed frame (U, V, axis) with a unit axis.
struct Frame
{
  Vector3 U;
  Vector3 V;
};

/// Branch-free frame of Duff et al., "Building an Orthonormal Basis, Revisited" (JCGT 2017).
inline Frame FrameAround(const Vector3& axis)
{
  const double sign = std::copysign(1.0, axis.Z);
  const double a = -1.0 / (sign + axis.Z);
  const double b = axis.X * axis.Y * a;
  return { { 1.0 + sign * axis.X * axis.X * a, sign * b, -sign * axis.X },
    { b, sign + axis.Y * axis.Y * a, -axis.Y } };
}

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
    return p.X >= this->Min.X && p.X <= this->Max.X && p.Y >= this->Min.Y && p.Y <= this->Max.Y &&
      p.Z >= this->Min.Z && p.Z <= this->Max.Z;
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

} // namespace shadowcones

#endif
