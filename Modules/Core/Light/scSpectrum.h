// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSpectrum.h
 * @brief From spectral samples to CIE XYZ and sRGB.
 */
#ifndef scSpectrum_h
#define scSpectrum_h

#include "ShadowConesCoreModule.h"

#include <array>
#include <vector>

namespace shadowcones
{

/// Number of wavelength samples unless told otherwise (Hougs and Day, section 4.3).
constexpr int DefaultNumberOfWavelengths = 7;

/// Centres (nm) of @p count equal bins between 400 and 700 nm.
SHADOWCONESCORE_EXPORT std::vector<double> DefaultWavelengths(int count = DefaultNumberOfWavelengths);

/// CIE 1931 2-degree colour-matching functions at a wavelength in nm, by the multi-lobe fits of Wyman et al. (JCGT 2013).
SHADOWCONESCORE_EXPORT std::array<double, 3> CieXyz(double wavelength);

/**
 * Linear sRGB (D65, not clamped) of spectral samples, as a matrix: rgb[c] = sum_k matrix[c][k] * spectrum[k]. Normalised so
 * that a spectrum of 1 at every sample gives (1, 1, 1): equal energy is shown as white.
 */
SHADOWCONESCORE_EXPORT std::array<std::vector<double>, 3> SpectrumToLinearSrgb(const std::vector<double>& wavelengths);

/// The sRGB transfer curve (IEC 61966-2-1) of exposure * value, clamped, as a byte.
SHADOWCONESCORE_EXPORT unsigned char EncodeSrgb(double linear);

} // namespace shadowcones

#endif
