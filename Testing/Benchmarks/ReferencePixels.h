// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferencePixels.h
 * @brief The image's medium term at some pixels from the reference, and how far an image is off.
 */
#ifndef ReferencePixels_h
#define ReferencePixels_h

#include "BenchmarkScene.h"

#include <string>
#include <vector>

namespace shadowcones
{

/// The medium term of a pixel, mean over wavelengths.
struct PixelTruth
{
  int I = 0;
  int J = 0;
  double Mean = 0.0;
  double StandardError = 0.0;
};

/// Pixels of a size x size image in the order of the golden ratio, which covers the image evenly; no values yet.
std::vector<PixelTruth> SpreadPixels(int size, int count);

/**
 * By Testing/Reference, @p samples a pixel. Kept in @p folder from one run to the next, in a file that is named by the
 * hash of mesh, light, medium, camera and sampling. Throws std::runtime_error where it cannot be written.
 */
std::vector<PixelTruth> ReferencePixels(
  const BenchmarkScene& scene, int size, int pixels, int samples, const std::string& folder);

/// The medium term of a pixel of an image, mean over wavelengths.
double MeanOfPixel(const ScatteringImage& image, std::size_t pixel);

struct ImageError
{
  double Rms = 0.0;       ///< over the mean, the reference's noise taken off
  double Bias = 0.0;      ///< mean difference over the mean
  double Reference = 0.0; ///< the reference's own noise over the mean
  double Smallest = 0.0;  ///< Rms below this cannot be told from none: two standard errors of it
};

/// @param values one for each pixel of @p truth.
ImageError Compare(const std::vector<double>& values, const std::vector<PixelTruth>& truth);

} // namespace shadowcones

#endif
