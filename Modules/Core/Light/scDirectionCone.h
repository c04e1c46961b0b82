// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scDirectionCone.h
 * @brief A circular cone of directions, and the uniform map onto it. Internal to Core.
 */
#ifndef scDirectionCone_h
#define scDirectionCone_h

#include "scConcentricMap.h"
#include "scConstants.h"
#include "scFrame.h"

#include <array>
#include <cmath>

namespace shadowcones
{

/// A circular cone of directions. Its size is kept as 1 - cos, which a tiny cone does not round away.
struct DirectionCone
{
  Vector3 Axis;
  double OneMinusCosine;

  double SolidAngle() const { return TwoPi * this->OneMinusCosine; }
  /// A cone without a size is one direction, with all of the probability.
  double Pdf() const { return this->OneMinusCosine > 0.0 ? 1.0 / this->SolidAngle() : 1.0; }

  /// 1 - cos of the angle to the axis, and the direction.
  Vector3 Sample(double u, double v, double& oneMinusCosine) const
  {
    const std::array<double, 2> disc = ConcentricDisc(u, v);
    const double squared = disc[0] * disc[0] + disc[1] * disc[1];
    oneMinusCosine = squared * this->OneMinusCosine;
    const double scale = std::sqrt(this->OneMinusCosine * (2.0 - oneMinusCosine)); // sin over the disc's radius
    const Frame frame = FrameAround(this->Axis);
    return (1.0 - oneMinusCosine) * this->Axis + (scale * disc[0]) * frame.U + (scale * disc[1]) * frame.V;
  }

  /// 1 - cos of the angle between two directions; no digits are lost where it is small.
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

} // namespace shadowcones

#endif
