// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTriangleReflectance.h
 * @brief How much of the light that falls on a triangle a diffuse surface throws back.
 */
#ifndef scTriangleReflectance_h
#define scTriangleReflectance_h

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/// @p values has @p components (1, or one a wavelength) for each triangle, 0..1; where it is empty @p everywhere holds.
inline double TriangleReflectance(
  const std::vector<float>& values, int components, double everywhere, vtkIdType triangle, std::size_t wavelength)
{
  if (values.empty())
  {
    return everywhere;
  }
  const auto count = static_cast<std::size_t>(components);
  return values[static_cast<std::size_t>(triangle) * count + (count > 1 ? wavelength : 0)];
}

} // namespace shadowcones

#endif
