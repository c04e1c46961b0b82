// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scToneMap.h
 * @brief From spectral radiance to the bytes of a picture, and the exposure that shows it well.
 */
#ifndef scToneMap_h
#define scToneMap_h

#include "ShadowConesCoreModule.h"
#include "scParallel.h"
#include "scSpectrum.h"
#include "vtkType.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// One weight a wavelength sample (nm): their sum of products with a spectrum is its relative luminance, 1 for a spectrum of 1.
SHADOWCONESCORE_EXPORT std::vector<double> LuminanceWeights(const std::vector<double>& wavelengths);

/**
 * Pixels that stand for a whole image of this size: squares (i from, to, j from, to, inclusive), one in the middle of each
 * tile of 32 x 32 pixels, of at most 32 x 32 tiles. About 4,096 pixels in all, every pixel of a smaller image. They depend on
 * the size alone, so that any part of an image gets the exposure of the whole.
 */
SHADOWCONESCORE_EXPORT std::vector<std::array<int, 4>> ExposureSquares(int width, int height);

/**
 * Append the luminance of the pixels of a square: of the sum of parts, which have one value a wavelength of each pixel of the
 * extent, i fastest. The square lies in the extent; both are i from, to, j from, to, inclusive.
 */
SHADOWCONESCORE_EXPORT void AppendLuminances(const std::array<int, 4>& extent, const std::array<int, 4>& square,
  const std::vector<const float*>& parts, const std::vector<double>& weights, std::vector<double>& luminances);

/**
 * One over the luminance that is to be white: the 99th percentile, or the largest where that is not above 0. 1 where all is
 * black. Values that are not finite do not count.
 */
SHADOWCONESCORE_EXPORT double ExposureOf(std::vector<double> luminances);

/// What becomes of linear red, green and blue before they are encoded as sRGB.
enum class ToneCurve : int
{
  Linear = 0, ///< nothing: white from 1
  /// The fit of K. Narkowicz ("ACES Filmic Tone Mapping Curve", 2015) to the curve of the Academy Color Encoding System:
  /// 1 becomes 0.80, white begins at 7.2, dark tones gain contrast.
  Filmic = 1
};

/// The curve at a value; 0 up to 0, 1 from white on.
SHADOWCONESCORE_EXPORT double ApplyToneCurve(ToneCurve curve, double linear);

/// How radiance is shown.
struct ToneMapping
{
  std::vector<double> Wavelengths; ///< nm
  double Exposure = 1.0;
  ToneCurve Curve = ToneCurve::Linear;
};

/**
 * Bytes (red, green, blue a pixel) of the curve of exposure * radiance as sRGB. @p radiance has one value a wavelength of
 * each pixel. @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ToneMap(const float* radiance, vtkIdType numberOfPixels, const ToneMapping& mapping,
  const Monitor& monitor, unsigned char* rgb);

} // namespace shadowcones

#endif
