// SPDX-License-Identifier: BSD-3-Clause
#include "scSpectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowcones
{

namespace
{

/// A Gaussian whose width differs left and right of its centre (nm); slopes are 1 / standard deviation.
double SkewedLobe(double wavelength, double height, double center, double slopeBelow, double slopeAbove)
{
  const double t = (wavelength - center) * (wavelength < center ? slopeBelow : slopeAbove);
  return height * std::exp(-0.5 * t * t);
}

/// XYZ of the D65 white of sRGB, Y = 1 (IEC 61966-2-1).
constexpr double whiteD65[3] = { 0.95047, 1.0, 1.08883 };

/// XYZ to linear sRGB; each row is divided by its response to whiteD65, which rounding leaves just off 1.
constexpr double xyzToSrgb[3][3] = { { 3.2404542, -1.5371385, -0.4985314 }, { -0.9692660, 1.8760108, 0.0415560 },
  { 0.0556434, -0.2040259, 1.0572252 } };

} // namespace

std::vector<double> DefaultWavelengths(int count)
{
  std::vector<double> wavelengths(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = 0; k < count; ++k)
  {
    wavelengths[k] = 400.0 + 300.0 * (k + 0.5) / count;
  }
  return wavelengths;
}

std::array<double, 3> CieXyz(double wavelength)
{
  return { SkewedLobe(wavelength, 0.362, 442.0, 0.0624, 0.0374) + SkewedLobe(wavelength, 1.056, 599.8, 0.0264, 0.0323) +
      SkewedLobe(wavelength, -0.065, 501.1, 0.0490, 0.0382),
    SkewedLobe(wavelength, 0.821, 568.8, 0.0213, 0.0247) + SkewedLobe(wavelength, 0.286, 530.9, 0.0613, 0.0322),
    SkewedLobe(wavelength, 1.217, 437.0, 0.0845, 0.0278) + SkewedLobe(wavelength, 0.681, 459.0, 0.0385, 0.0725) };
}

std::array<std::vector<double>, 3> SpectrumToLinearSrgb(const std::vector<double>& wavelengths)
{
  const std::size_t count = wavelengths.size();
  std::vector<std::array<double, 3>> matching(count);
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < count; ++k)
  {
    matching[k] = CieXyz(wavelengths[k]);
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += matching[k][axis];
    }
  }

  std::array<std::vector<double>, 3> matrix;
  for (int c = 0; c < 3; ++c)
  {
    matrix[c].assign(count, 0.0);
    double white = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      white += xyzToSrgb[c][axis] * whiteD65[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // Scaling each of X, Y, Z takes equal energy to D65, for any choice of wavelengths, even one alone.
      // What is as far from being seen as numbers reach has no colour: its scale would be infinite.
      const double scale =
        sum[axis] >= std::numeric_limits<double>::min() ? xyzToSrgb[c][axis] * whiteD65[axis] / (white * sum[axis]) : 0.0;
      for (std::size_t k = 0; k < count; ++k)
      {
        matrix[c][k] += scale * matching[k][axis];
      }
    }
  }
  return matrix;
}

unsigned char EncodeSrgb(double linear)
{
  if (!(linear > 0.0))
  {
    return 0;
  }
  if (linear >= 1.0)
  {
    return 255;
  }
  const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255.0 * encoded));
}

} // namespace shadowcones
