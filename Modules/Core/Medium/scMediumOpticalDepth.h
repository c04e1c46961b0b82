// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumOpticalDepth.h
 * @brief Optical depths along rays through a medium, homogeneous or not. Internal to Core.
 */
#ifndef scMediumOpticalDepth_h
#define scMediumOpticalDepth_h

#include "scDensityGrid.h"
#include "scMedium.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Length inside the box of the ray from a point in it.
inline double ExitDistance(const Box& box, const Vector3& point, const Vector3& direction)
{
  const auto along = [](double d, double low, double high, double x)
  { return d > 0.0 ? (high - x) / d : (d < 0.0 ? (low - x) / d : HUGE_VAL); };
  const double exitX = along(direction.X, box.Min.X, box.Max.X, point.X);
  const double exitY = along(direction.Y, box.Min.Y, box.Max.Y, point.Y);
  const double exitZ = along(direction.Z, box.Min.Z, box.Max.Z, point.Z);
  return std::max(0.0, std::min(exitX, std::min(exitY, exitZ)));
}

/// Transmittance over an optical depth in units of sigma_t; exact where nothing is taken away, also over infinity.
inline double TransmittanceOver(double sigmaT, double opticalDepth)
{
  return sigmaT > 0.0 && opticalDepth > 0.0 ? std::exp(-sigmaT * opticalDepth) : 1.0;
}

/**
 * Optical depths in units of sigma_t: lengths in a homogeneous medium, integrals of the density otherwise. One a thread;
 * the medium must outlive it.
 */
class MediumOpticalDepth
{
public:
  explicit MediumOpticalDepth(const Medium& medium)
    : Bounds(medium.Bounds)
    , Density(medium.Density)
  {
  }

  bool IsHomogeneous() const { return this->Density == nullptr; }

  /// The camera ray that Along() and MeanDensity() speak of; [tBegin, tEnd] is its part inside the bounds.
  void SetRay(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd)
  {
    this->TBegin = tBegin;
    if (this->Density)
    {
      this->Tabulate(origin, direction, tBegin, tEnd);
    }
  }
  /// From tBegin of the camera ray to @p t, in [tBegin, tEnd].
  double Along(double t) const { return this->Density ? this->LookUp(t) : t - this->TBegin; }
  /// Mean of the density over the part [a, b] of the camera ray, never below 0; exactly 1 in a homogeneous medium.
  double MeanDensity(double a, double b) const
  {
    return this->Density ? (b > a ? std::max(this->LookUp(b) - this->LookUp(a), 0.0) / (b - a) : 0.0) : 1.0;
  }

  /// Where Along() has a value, between two places where it has no more and no less.
  double DistanceAt(double opticalDepth, double low, double high) const
  {
    return std::clamp(
      this->Density ? this->LookUpDistance(opticalDepth, low, high) : this->TBegin + opticalDepth, low, high);
  }

  /// The density on the camera ray, which is the slope of Along(); 1 in a homogeneous medium.
  double DensityAlong(double t) const { return this->Density ? this->LookUpDensity(t) : 1.0; }

  /// From a point inside the bounds up to @p distance, which may be infinite: the part inside the bounds.
  double Towards(const Vector3& point, const Vector3& direction, double distance) const
  {
    const double length = std::min(distance, ExitDistance(this->Bounds, point, direction));
    return this->Density ? this->Density->Integrate(point, direction, 0.0, length) : length;
  }
  /// The same from a point anywhere.
  double TowardsFromOutside(const Vector3& point, const Vector3& direction, double distance) const
  {
    double from = 0.0;
    double to = distance;
    if (!this->Bounds.Clip(point, direction, from, to))
    {
      return 0.0;
    }
    return this->Density ? this->Density->Integrate(point, direction, from, to) : to - from;
  }

  /// 1 in a homogeneous medium.
  double DensityAt(const Vector3& point) const { return this->Density ? this->Density->At(point) : 1.0; }

private:
  SHADOWCONESCORE_EXPORT void Tabulate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd);

  /// The stretch that has a place between the ends of the table.
  std::size_t StretchAt(double t) const
  {
    const auto step = static_cast<std::size_t>((t - this->TableBegin) * this->StepsPerLength);
    std::size_t k = this->FirstOfStep[std::min(step, this->FirstOfStep.size() - 1)];
    while (k + 2 < this->Stretches.size() && this->Stretches[k + 1].Begin <= t)
    {
      ++k;
    }
    return k;
  }

  double LookUp(double t) const
  {
    if (!(t > this->TableBegin))
    {
      return 0.0;
    }
    if (!(t < this->Stretches.back().Begin))
    {
      return this->Stretches.back().OpticalDepth;
    }
    const std::size_t k = this->StretchAt(t);
    const DensityStretch& stretch = this->Stretches[k];
    // Where one cell holds what is thin and what is like ink, rounding may lead beyond its ends.
    return std::clamp(stretch.DepthAfter(t - stretch.Begin), stretch.OpticalDepth, this->Stretches[k + 1].OpticalDepth);
  }

  SHADOWCONESCORE_EXPORT double LookUpDistance(double depth, double low, double high) const;

  double LookUpDensity(double t) const
  {
    if (!(t >= this->TableBegin && t < this->Stretches.back().Begin))
    {
      return 0.0;
    }
    const DensityStretch& stretch = this->Stretches[this->StretchAt(t)];
    return std::max(stretch.DensityAfter(t - stretch.Begin), 0.0);
  }

  const Box& Bounds;
  const DensityGrid* Density;
  double TBegin = 0.0;
  std::vector<DensityStretch> Stretches{ DensityStretch() }; ///< of the camera ray's part where the density is not 0
  double TableBegin = 0.0;
  double StepsPerLength = 0.0;
  std::vector<std::uint32_t> FirstOfStep{ 0 }; ///< the stretch in which each of some equal steps of the ray begins
};

} // namespace shadowcones

#endif
