// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSphericalEllipse.h
 * @brief The solid angle under which a disc is seen, and the uniform map onto it (Guillen et al., EGSR 2017, radial)
 *
 * The cone through a circle is elliptic. Let l0 and l1 be the distances from the point to the nearest and the farthest
 * point of the rim; its half angles are then sin(alpha) = 2 R / (l0 + l1) across and sin(2 beta) = 2 h R / (l0 l1) in
 * the plane of point, centre and normal, and cos(alpha) / cos(beta) = 2 sqrt(l0 l1) / (l0 + l1). With the eccentric angle
 * chi, in which the rim's direction is (sin(alpha) cos(chi), sin(beta) sin(chi), w), the solid angle is
 *   sin(alpha) sin(beta) * integral over 2 pi of d chi / (1 + w),
 *   w^2 = cos^2(alpha) cos^2(chi) + cos^2(beta) sin^2(chi):
 * no differences of nearly equal numbers, however small or near the disc. Internal to Core.
 */
#ifndef scSphericalEllipse_h
#define scSphericalEllipse_h

#include "scFrame.h"
#include "scVector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowcones
{

class SphericalEllipse
{
public:
  /// The disc as seen from a point on its emitting side; SolidAngle() is 0 on the other side and in its plane.
  SphericalEllipse(const Vector3& center, const Vector3& normal, double radius, const Vector3& from);

  double SolidAngle() const { return 4.0 * this->SineAlpha * this->SineBeta * this->QuarterIntegral; }
  /// Distance from the point to the plane of the disc.
  double Height() const { return this->PlaneDistance; }

  Vector3 Sample(double u, double v) const
  {
    const int quarter = std::min(static_cast<int>(4.0 * u), 3);
    const double fraction = 4.0 * u - quarter;
    // Odd quarters run backwards, so that the map is continuous.
    return this->Along(this->SpokeAt(quarter % 2 ? 1.0 - fraction : fraction), quarter, v);
  }
  /// Samples of the same u lie on one spoke, from the axis outwards with v; spokes of the four quarters are mirrored.
  struct Spoke
  {
    double X; ///< of the rim's direction in the first quarter, across and outward
    double Y;
    double W; ///< and its cosine with the axis
  };
  Spoke SpokeAt(double fraction) const;
  Vector3 Along(const Spoke& spoke, int quarter, double v) const;
  std::array<double, 2> Invert(const Vector3& direction) const;

private:
  static constexpr double HalfPi = 1.57079632679489661923;
  static constexpr int NumberOfNodes = 8;
  static constexpr int MaximumHalvings = 40;

  // Panels of the quarter [0, pi/2]: [pi/4, pi/2], [pi/8, pi/4], ... and a last one down to 0 that is no wider than the
  // distance of the integrand's nearest complex singularity. Eight nodes in each give 11 digits.
  struct Rule
  {
    std::array<double, NumberOfNodes> Nodes{ 0.01985507175123188, 0.10166676129318664, 0.2372337950418355,
      0.4082826787521751, 0.5917173212478249, 0.7627662049581645, 0.8983332387068134, 0.9801449282487681 };
    std::array<double, NumberOfNodes> Weights{ 0.05061426814518813, 0.11119051722668724, 0.15685332293894363,
      0.181341891689181, 0.181341891689181, 0.15685332293894363, 0.11119051722668724, 0.05061426814518813 };
    // sin^2 at the nodes of [w, 2 w] and of [0, w], w = pi/2 2^-(depth+1).
    std::array<std::array<double, NumberOfNodes>, MaximumHalvings> Upper;
    std::array<std::array<double, NumberOfNodes>, MaximumHalvings> Last;
    Rule()
    {
      for (int depth = 0; depth < MaximumHalvings; ++depth)
      {
        const double width = std::ldexp(HalfPi, -(depth + 1));
        for (int i = 0; i < NumberOfNodes; ++i)
        {
          const double upper = std::sin(width * (1.0 + this->Nodes[i]));
          const double last = std::sin(width * this->Nodes[i]);
          this->Upper[depth][i] = upper * upper;
          this->Last[depth][i] = last * last;
        }
      }
    }
  };
  static const Rule& GetRule()
  {
    static const Rule rule;
    return rule;
  }

  double W(double sineSquared) const
  {
    return this->CosineBeta * std::sqrt(this->RatioSquared + (1.0 - this->RatioSquared) * sineSquared);
  }
  double PanelIntegral(const Rule& rule, double width, const std::array<double, NumberOfNodes>& sineSquared) const
  {
    double sum = 0.0;
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      sum += rule.Weights[i] / (1.0 + this->W(sineSquared[i]));
    }
    return width * sum;
  }
  // Of any part of one panel.
  double PartIntegral(double from, double to) const
  {
    const Rule& rule = GetRule();
    std::array<double, NumberOfNodes> sineSquared;
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      const double sine = std::sin(from + (to - from) * rule.Nodes[i]);
      sineSquared[i] = sine * sine;
    }
    return this->PanelIntegral(rule, to - from, sineSquared);
  }
  double QuarterAngle(double fraction) const;
  double QuarterFraction(double angle) const;

  Vector3 Across;
  Vector3 Outward; ///< in the plane of eye, centre and normal
  Vector3 Axis;
  double PlaneDistance = 0.0;
  double SineAlpha = 0.0;
  double SineBeta = 0.0;
  double CosineBeta = 1.0;
  double RatioSquared = 1.0; // (cos alpha / cos beta)^2
  double QuarterIntegral = 0.0;
  int Halvings = 0;                              // panels above the last one, less one
  std::array<double, MaximumHalvings + 1> Below; // integral over [0, pi/2 2^-depth]
};

inline SphericalEllipse::SphericalEllipse(
  const Vector3& center, const Vector3& normal, double radius, const Vector3& from)
{
  const Vector3 toCenter = center - from;
  const double h = -Dot(toCenter, normal);
  if (!(h > 0.0))
  {
    return;
  }
  this->PlaneDistance = h;
  const Frame frame = FrameAround(normal);
  const double p = Dot(toCenter, frame.U);
  const double q = Dot(toCenter, frame.V);
  const double offset = std::hypot(p, q);
  const double cosine = offset > 0.0 ? p / offset : 1.0;
  const double sine = offset > 0.0 ? q / offset : 0.0;
  const Vector3 outward = cosine * frame.U + sine * frame.V;
  this->Across = -sine * frame.U + cosine * frame.V;

  const double nearest = std::hypot(offset - radius, h);
  const double farthest = std::hypot(offset + radius, h);
  const double product = nearest * farthest;
  const double sum = nearest + farthest;
  this->SineAlpha = 2.0 * radius / sum;
  this->RatioSquared = std::min(4.0 * (nearest / sum) * (farthest / sum), 1.0);
  const double sineTwoBeta = std::min(2.0 * (h / nearest) * (radius / farthest), 1.0);
  const double cosineTwoBeta = (h * h + (offset - radius) * (offset + radius)) / product;
  if (cosineTwoBeta >= 0.0)
  {
    this->CosineBeta = std::sqrt(0.5 * (1.0 + cosineTwoBeta));
    this->SineBeta = 0.5 * sineTwoBeta / this->CosineBeta;
  }
  else
  {
    this->SineBeta = std::sqrt(0.5 * (1.0 - cosineTwoBeta));
    this->CosineBeta = 0.5 * sineTwoBeta / this->SineBeta;
  }
  // The cone's axis meets the disc at offset cos^2(alpha).
  const double axisOffset = offset * this->RatioSquared * this->CosineBeta * this->CosineBeta;
  const double axisLength = std::hypot(axisOffset, h);
  this->Axis = (axisOffset / axisLength) * outward - (h / axisLength) * normal;
  this->Outward = (h / axisLength) * outward + (axisOffset / axisLength) * normal;

  const Rule& rule = GetRule();
  const double ratio = std::sqrt(this->RatioSquared);
  while (this->Halvings + 1 < MaximumHalvings && std::ldexp(HalfPi, -(this->Halvings + 1)) > ratio)
  {
    ++this->Halvings;
  }
  double integral = this->PanelIntegral(rule, std::ldexp(HalfPi, -(this->Halvings + 1)), rule.Last[this->Halvings]);
  this->Below[this->Halvings + 1] = integral;
  for (int depth = this->Halvings; depth >= 0; --depth)
  {
    integral += this->PanelIntegral(rule, std::ldexp(HalfPi, -(depth + 1)), rule.Upper[depth]);
    this->Below[depth] = integral;
  }
  this->QuarterIntegral = integral;
}

// The eccentric angle below which the given fraction of a quarter lies. The integrand stays within [1/2, 1].
inline double SphericalEllipse::QuarterAngle(double fraction) const
{
  const double target = fraction * this->QuarterIntegral;
  int depth = 0;
  while (depth <= this->Halvings && target < this->Below[depth + 1])
  {
    ++depth;
  }
  const bool last = depth > this->Halvings;
  const double high = std::ldexp(HalfPi, -depth);
  const double low = last ? 0.0 : 0.5 * high;
  const double below = last ? 0.0 : this->Below[depth + 1];
  double angle = low + (high - low) * (target - below) / (this->Below[depth] - below);
  double integral = below + this->PartIntegral(low, angle);
  for (int i = 0; i < 8; ++i)
  {
    const double sine = std::sin(angle);
    const double w = this->W(sine * sine);
    const double next = std::clamp(angle + (target - integral) * (1.0 + w), low, high);
    if (std::fabs(next - angle) <= 1e-10 * high)
    {
      return next;
    }
    // Simpson's rule on the short step.
    const double middleSine = std::sin(0.5 * (angle + next));
    const double nextSine = std::sin(next);
    integral += std::fabs(next - angle) > 0.01 * high ? this->PartIntegral(angle, next)
                                                      : (next - angle) / 6.0 *
        (1.0 / (1.0 + w) + 4.0 / (1.0 + this->W(middleSine * middleSine)) + 1.0 / (1.0 + this->W(nextSine * nextSine)));
    angle = next;
  }
  return angle;
}

inline double SphericalEllipse::QuarterFraction(double angle) const
{
  int depth = 0;
  while (depth <= this->Halvings && angle < std::ldexp(HalfPi, -(depth + 1)))
  {
    ++depth;
  }
  const bool last = depth > this->Halvings;
  const double low = last ? 0.0 : std::ldexp(HalfPi, -(depth + 1));
  const double below = last ? 0.0 : this->Below[depth + 1];
  return (below + this->PartIntegral(low, angle)) / this->QuarterIntegral;
}

inline SphericalEllipse::Spoke SphericalEllipse::SpokeAt(double fraction) const
{
  const double angle = this->QuarterAngle(fraction);
  const double sine = std::sin(angle);
  return { this->SineAlpha * std::cos(angle), this->SineBeta * sine, this->W(sine * sine) };
}

inline Vector3 SphericalEllipse::Along(const Spoke& spoke, int quarter, double v) const
{
  const double x = quarter == 1 || quarter == 2 ? -spoke.X : spoke.X;
  const double y = quarter >= 2 ? -spoke.Y : spoke.Y;
  const double squared = x * x + y * y; // 1 - w^2
  const double oneMinusCosine = v * squared / (1.0 + spoke.W);
  const double scale = squared > 0.0 ? std::sqrt(oneMinusCosine * (2.0 - oneMinusCosine) / squared) : 0.0;
  return (1.0 - oneMinusCosine) * this->Axis + (scale * x) * this->Across + (scale * y) * this->Outward;
}

inline std::array<double, 2> SphericalEllipse::Invert(const Vector3& direction) const
{
  const double x = Dot(direction, this->Across);
  const double y = Dot(direction, this->Outward);
  const double angle = std::atan2(std::fabs(y) * this->SineAlpha, std::fabs(x) * this->SineBeta);
  const double fraction = this->QuarterFraction(angle);
  const int quarter = y >= 0.0 ? (x >= 0.0 ? 0 : 1) : (x >= 0.0 ? 3 : 2);
  const Vector3 difference = direction - this->Axis;
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double squared =
    this->SineAlpha * this->SineAlpha * cosine * cosine + this->SineBeta * this->SineBeta * sine * sine;
  const double limit = squared / (1.0 + this->W(sine * sine));
  return { 0.25 * (quarter + (quarter % 2 ? 1.0 - fraction : fraction)), 0.5 * Dot(difference, difference) / limit };
}

} // namespace shadowcones

#endif
