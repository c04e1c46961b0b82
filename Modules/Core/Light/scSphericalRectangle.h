// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSphericalRectangle.h
 * @brief The solid angle under which a rectangle is seen, and the uniform map onto it (Urena, Fajardo, King, EGSR
 * 2013).
 *
 * The map subtracts angles of the order of pi, so that below MinimumSolidAngle its digits run out: sample by area
 * there. The solid angle itself keeps its relative precision at any size. Internal to Core.
 */
#ifndef scSphericalRectangle_h
#define scSphericalRectangle_h

#include "scConstants.h"
#include "scVector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowcones
{

/**
 * Solid angle of the triangle with these corners seen from the origin (Van Oosterom and Strackee 1983), >= 0. The
 * caller gives |a . (b x c)|, from the triangle's edges: from the corners it would cancel for a small or distant
 * triangle.
 */
inline double TriangleSolidAngle(double volume, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double la = Length(a);
  const double lb = Length(b);
  const double lc = Length(c);
  return 2.0 * std::atan2(volume, la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
}

class SphericalRectangle
{
public:
  static constexpr double MinimumSolidAngle = 1e-4; ///< sr

  /// The rectangle as seen from a point on its emitting side; SolidAngle() is 0 on the other side and in its plane.
  SphericalRectangle(
    const Vector3& center, const Vector3& normal, const Vector3& axisU, const Vector3& axisV, const Vector3& from)
  {
    const double halfU = Length(axisU);
    const double halfV = Length(axisV);
    if (!(halfU > 0.0 && halfV > 0.0))
    {
      return;
    }
    this->X = (1.0 / halfU) * axisU;
    this->Y = (1.0 / halfV) * axisV;
    this->Z = normal;
    const Vector3 toCenter = center - from;
    this->Z0 = Dot(toCenter, normal);
    const double x = Dot(toCenter, this->X);
    const double y = Dot(toCenter, this->Y);
    this->X0 = x - halfU;
    this->X1 = x + halfU;
    this->Y0 = y - halfV;
    this->Y1 = y + halfV;
    this->Height = 2.0 * halfV;
    this->Omega = this->Z0 < 0.0 ? this->PartSolidAngle(this->X1, 2.0 * halfU) : 0.0;
  }

  double SolidAngle() const { return this->Omega; }

  /// From the point to the sampled point, not normalised.
  Vector3 Sample(double u, double v) const { return this->Along(this->ColumnAt(u), v); }
  /// Samples of the same u lie on one line.
  struct Column
  {
    double X;   ///< along the first axis
    double Low; ///< sines of the line's ends
    double High;
  };
  Column ColumnAt(double u) const
  {
    const double z0 = this->Z0;
    const double n0 = -this->Y0 / std::hypot(this->Y0, z0);
    const double n2 = this->Y1 / std::hypot(this->Y1, z0);
    const double n3 = -this->X0 / std::hypot(this->X0, z0);
    const double k = TwoPi - std::acos(-n2 * n3) - std::acos(-n3 * n0);
    const double angle = u * this->Omega + k;
    const double f = (std::cos(angle) * n0 - n2) / std::sin(angle);
    const double c = std::clamp(std::copysign(1.0 / std::sqrt(f * f + n0 * n0), f), -1.0, 1.0);
    double xu = -(c * z0) / std::sqrt(std::max(1.0 - c * c, 1e-300));
    xu = std::clamp(std::isfinite(xu) ? xu : 0.5 * (this->X0 + this->X1), this->X0, this->X1);
    // Two steps of Newton on the solid angle to the left of xu give back the digits that grazing views lose.
    for (int i = 0; i < 2; ++i)
    {
      const double slope = -z0 / (xu * xu + z0 * z0) * (this->Sine(this->Y1, xu) - this->Sine(this->Y0, xu));
      const double step = (this->PartSolidAngle(xu, xu - this->X0) - u * this->Omega) / slope;
      xu = std::isfinite(step) ? std::clamp(xu - step, this->X0, this->X1) : xu;
    }
    return { xu, this->Sine(this->Y0, xu), this->Sine(this->Y1, xu) };
  }
  Vector3 Along(const Column& column, double v) const
  {
    const double h = column.Low + v * (column.High - column.Low);
    const double squared = 1.0 - h * h;
    const double yv = squared > 0.0 ? h * std::hypot(column.X, this->Z0) / std::sqrt(squared) : this->Y1;
    return column.X * this->X + std::clamp(yv, this->Y0, this->Y1) * this->Y + this->Z0 * this->Z;
  }

  std::array<double, 2> Invert(const Vector3& direction) const
  {
    const double scale = this->Z0 / Dot(direction, this->Z);
    const double x = std::clamp(scale * Dot(direction, this->X), this->X0, this->X1);
    const double y = std::clamp(scale * Dot(direction, this->Y), this->Y0, this->Y1);
    const double h0 = this->Sine(this->Y0, x);
    const double h1 = this->Sine(this->Y1, x);
    return { this->PartSolidAngle(x, x - this->X0) / this->Omega, (this->Sine(y, x) - h0) / (h1 - h0) };
  }

private:
  double Sine(double y, double x) const { return y / std::sqrt(x * x + y * y + this->Z0 * this->Z0); }
  // Of the part [X0, x], which is so wide.
  double PartSolidAngle(double x, double width) const
  {
    const double volume = std::fabs(this->Z0) * width * this->Height;
    const Vector3 a{ this->X0, this->Y0, this->Z0 };
    const Vector3 b{ x, this->Y0, this->Z0 };
    const Vector3 c{ x, this->Y1, this->Z0 };
    const Vector3 d{ this->X0, this->Y1, this->Z0 };
    return TriangleSolidAngle(volume, a, b, c) + TriangleSolidAngle(volume, a, c, d);
  }

  Vector3 X;
  Vector3 Y;
  Vector3 Z;
  double X0 = 0.0;
  double X1 = 0.0;
  double Y0 = 0.0;
  double Y1 = 0.0;
  double Z0 = 0.0;     // negative
  double Height = 0.0; // Y1 - Y0
  double Omega = 0.0;
};

} // namespace shadowcones

#endif
