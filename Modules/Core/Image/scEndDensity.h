// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scEndDensity.h
 * @brief Samples that lie denser near both ends of an interval than in its middle (Hougs and Day, section 3.3.1). Internal to Core.
 */
#ifndef scEndDensity_h
#define scEndDensity_h

#include <algorithm>
#include <cmath>

namespace shadowcones
{

/**
 * A share of the samples follows the parabola 3 (2 x - 1)^2 over [0, 1], which is 0 in the middle, and the others are
 * even. Of a sample that has Density() the value is to be divided by it: then sums are unbiased whatever the share.
 */
class EndDensity
{
public:
  /// @param share 0 and above, below 1; 0: even.
  explicit EndDensity(double share)
    : Share(share)
  {
  }

  bool IsEven() const { return !(this->Share > 0.0); }

  double Density(double place) const
  {
    const double x = 2.0 * place - 1.0;
    return 1.0 - this->Share + 3.0 * this->Share * x * x;
  }

  /// The place below which lies this part of all samples; ascends with it. The middle and both ends stay where they are.
  double Place(double part) const
  {
    if (this->IsEven())
    {
      return part;
    }
    // Share x^3 + (1 - Share) x = 2 part - 1 has one real root, which hyperbolic functions give.
    const double linear = (1.0 - this->Share) / this->Share;
    const double stretch = std::sqrt(linear / 3.0);
    const double right = (2.0 * part - 1.0) / this->Share;
    const double x = 2.0 * stretch * std::sinh(std::asinh(0.5 * right / (stretch * stretch * stretch)) / 3.0);
    return std::clamp(0.5 * (1.0 + x), 0.0, 1.0);
  }

private:
  double Share;
};

} // namespace shadowcones

#endif
