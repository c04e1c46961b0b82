// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scTrilinear.h
 * @brief Values at the corners of a cell, linear along each axis in between. Internal to Core.
 */
#ifndef scTrilinear_h
#define scTrilinear_h

#include <cstddef>

namespace shadowcones
{

/**
 * The value at (x, y, z) of a cell, each from 0 to 1. @param corner the value at (0, 0, 0); @param strideX from there to the
 * corner (1, 0, 0), and so on. At the corners and where all eight agree it is theirs.
 */
template <typename Real>
[[gnu::always_inline]] inline Real Trilinear(
  const float* corner, std::size_t strideX, std::size_t strideY, std::size_t strideZ, Real x, Real y, Real z)
{
  const auto alongX = [strideX, x](const float* at)
  {
    const auto low = static_cast<Real>(at[0]);
    return low + x * (static_cast<Real>(at[strideX]) - low);
  };
  const auto alongY = [&alongX, strideY, y](const float* at)
  {
    const Real low = alongX(at);
    return low + y * (alongX(at + strideY) - low);
  };
  const Real low = alongY(corner);
  return low + z * (alongY(corner + strideZ) - low);
}

} // namespace shadowcones

#endif
