// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scMediumSum.h
 * @brief The medium terms of several lights, added up. Internal to Core.
 */
#ifndef scMediumSum_h
#define scMediumSum_h

#include "scParallel.h"
#include "scPixelArray.h"
#include "scScatteringImage.h"

#include "vtkType.h"

#include <cstddef>

namespace shadowcones
{

/// Adds up the medium terms of lights, of which there is one at least.
class MediumSum
{
public:
  /// @return false where aborted.
  bool Add(const ScatteringImage& term, const Monitor& monitor);
  /// @return false where aborted.
  bool Write(const Monitor& monitor, ScatteringImage& image) const;

private:
  void WritePixel(std::size_t pixel, ScatteringImage& image) const;

  bool IsEmpty = true;
  PixelArray<double> InScattering;
  PixelArray<double> Errors; ///< of means over wavelengths; HUGE_VAL: not known
  PixelArray<int> Samples;
  vtkIdType OcclusionRays = 0;
  vtkIdType ShadowLines = 0;
  vtkIdType ThickRays = 0; ///< summed over lights
  double OpticalDepth = 0.0;
};

} // namespace shadowcones

#endif
