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

} // namespace shadowcones

#endif
