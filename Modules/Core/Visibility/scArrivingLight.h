// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scArrivingLight.h
 * @brief What a light brings to a point, from the whole of it and from the samples of it that the point sees.
 */
#ifndef scArrivingLight_h
#define scArrivingLight_h

#include <algorithm>
#include <cmath>

namespace shadowcones
{

/// Of a light whose spectrum is 1: sr (Point: 1 / square unit; Sun: 1). Times the spectrum it is W m^-2.
struct ArrivingLight
{
  double Factor = 0.0;
  double Error = 0.0; ///< standard error
};

/**
 * Light samples with their weights. What arrives is what the whole light brings (WholeIrradiance, WholeFluence), in closed
 * form, times the share of the weights that is seen: exact where all or none is, and the noise of unequal weights falls
 * out. Its standard error is the greater one of that of the ratio and of sqrt(p (1 - p) / n), where n is the number of
 * equal weights that would do as well and p = (n share + 1/2) / (n + 1), as VisibilityProbe has it.
 */
class SeenWeights
{
public:
  void Add(double weight, bool seen)
  {
    this->All += weight;
    this->Squares += weight * weight;
    this->Seen += seen ? weight : 0.0;
    this->SeenSquares += seen ? weight * weight : 0.0;
  }

  ArrivingLight Of(double whole) const
  {
    if (!(this->All > 0.0))
    {
      // The part of the light that counts lies between the samples: nothing is known of it.
      return { 0.5 * whole, 0.5 * whole };
    }
    const double share = this->Seen / this->All;
    const double equal = this->All * this->All / this->Squares;
    const double p = (equal * share + 0.5) / (equal + 1.0);
    const double ofRatio =
      (this->SeenSquares * (1.0 - share) * (1.0 - share) + (this->Squares - this->SeenSquares) * share * share) /
      (this->All * this->All);
    return { whole * share, whole * std::sqrt(std::max(ofRatio, p * (1.0 - p) / equal)) };
  }

private:
  double All = 0.0;
  double Seen = 0.0;
  double Squares = 0.0;
  double SeenSquares = 0.0;
};

} // namespace shadowcones

#endif
