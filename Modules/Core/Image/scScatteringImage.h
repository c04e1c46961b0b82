// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scScatteringImage.h
 * @brief Light shafts along camera rays: what rendering gives. RenderScattering (scRenderScattering.h) makes it.
 */
#ifndef scScatteringImage_h
#define scScatteringImage_h

#include "scPixelArray.h"
#include "vtkType.h"

#include <array>
#include <cstddef>

namespace shadowcones
{

/**
 * Pixels of the extent, i fastest; NumberOfWavelengths values each where named "per wavelength". At edges
 * InScattering, SurfaceRadiance and the seen light are means over the pixel; Depth and Transmittance are of the ray
 * through its centre.
 */
struct ScatteringImage
{
  std::array<int, 4> Extent{ { 0, -1, 0, -1 } }; ///< pixels of the whole image: i from, to, j from, to (inclusive)
  int NumberOfWavelengths = 0;
  PixelArray<float> Radiance;        ///< per wavelength: InScattering + SurfaceRadiance (+ the light where seen)
  PixelArray<float> InScattering;    ///< per wavelength: the medium term alone, W m^-2 sr^-1
  PixelArray<float> SurfaceRadiance; ///< per wavelength: as seen through the medium
  PixelArray<float> Transmittance;   ///< per wavelength: to the first surface, or through the medium
  PixelArray<float> Depth;           ///< to the first surface; -1 where there is none
  PixelArray<float> RelativeError;   ///< one standard error of InScattering over its value (mean over wavelengths); -1: not known
  PixelArray<float> MediumError;     ///< the same, not over its value, which may be 0; -1: not known
  PixelArray<int> SampleCount;       ///< light samples taken for the medium term
  /// Only with photon maps, else empty: light that took more than one scattering or reflection, parts of Radiance too.
  PixelArray<float> MultipleScattering; ///< per wavelength: scattered towards the camera by the medium
  PixelArray<float> IndirectSurface;    ///< per wavelength: reflected by the first surface, as seen through the medium
  PixelArray<float> PhotonError; ///< one standard error of both over their sum, mean over wavelengths, of the noise alone
  PixelArray<float> SurfaceRelativeError; ///< one standard error of SurfaceRadiance over its value; -1: not known
  vtkIdType NumberOfOcclusionRays = 0; ///< rays towards the light, medium and surfaces together
  /// Guided: whole lines whose shadow was found at once; 0: rays were cheaper. Each counts as 16 samples and rays.
  vtkIdType NumberOfShadowLines = 0;
  /// BruteForce, Medium and Fast: rays that optically thick steps may make too bright by more than half a per cent, and
  /// the largest optical depth of such a step.
  vtkIdType NumberOfThickRays = 0;
  double MarchOpticalDepth = 0.0;
  /// Pixels whose surfaces miss the error goal for want of samples, and the largest relative error of these.
  vtkIdType NumberOfShortPixels = 0;
  double WorstSurfaceError = 0.0;

  /// Where a pixel of the whole image is in the arrays.
  std::size_t IndexOf(int i, int j) const
  {
    const auto columns = static_cast<std::size_t>(this->Extent[1] - this->Extent[0] + 1);
    return static_cast<std::size_t>(j - this->Extent[2]) * columns + static_cast<std::size_t>(i - this->Extent[0]);
  }
};

} // namespace shadowcones

#endif
