// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitPixel.h
 * @brief The unshadowed profile of one camera ray, as it is read. Internal to Core.
 */
#ifndef scLitPixel_h
#define scLitPixel_h

#include "scLitInterval.h"
#include "scLitProfileLayout.h"
#include "scLitQuadrature.h"
#include "scLitVariable.h"
#include "scRay.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shadowcones
{

/// The profile of one camera ray: see LitProfileLayout.
struct LitPixel
{
  Ray Line;
  LitInterval Interval;
  LitVariable Variable;
  double Tolerance = 0.0; ///< error that was allowed, relative to the sum or a tenth of the image's typical sum
  std::array<double, LitProfileLayout::Cells + 1> Edges; ///< distances along the ray; may be off by a little
  std::vector<float> Values; ///< as in the layout, but with integrals over cells, no longer scaled

  double EdgeAt(int k) const { return this->Edges[static_cast<std::size_t>(k)]; }
  const float* Cells(int group) const
  {
    return this->Values.data() + LitProfileLayout::Edges + group * LitProfileLayout::Cells;
  }
};

/// Multiply the means of a profile to integrals, and give its edges their places on the ray.
void FinishPixel(const LitQuadrature& quadrature, LitPixel& pixel);

} // namespace shadowcones

#endif
