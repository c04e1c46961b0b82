// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitProfileLayout.h
 * @brief The unshadowed medium term along one camera ray, cut into cells: how its values lie. Internal to Core.
 *
 * The ray's part in the medium is cut into 64 cells that are even in the angle under which they are seen from the
 * light, t = t0 + D tan(angle): equi-angular sampling (Kulla and Fajardo, EGSR 2012) turned into quadrature. In that
 * variable the light's 1 / d^2 is flat, and Gauss-Legendre panels integrate it with few nodes. See scLitVariable.h.
 */
#ifndef scLitProfileLayout_h
#define scLitProfileLayout_h

#include <cstddef>

namespace shadowcones
{

/**
 * Values of one ray, as floats in a row: 65 edges of the cells, distances from where its part in the medium begins;
 * then for each group of wavelengths 64 means over cells of the light scattered per unit of length, times the squared
 * distance from the light, which makes them smooth from ray to ray.
 */
struct LitProfileLayout
{
  static constexpr int Cells = 64;
  static constexpr int Edges = 72; ///< 65 in use
  int NumberOfGroups = 1;

  std::size_t Size() const { return static_cast<std::size_t>(Edges + this->NumberOfGroups * Cells); }
};

} // namespace shadowcones

#endif
