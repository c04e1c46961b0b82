// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scConeTally.h
 * @brief What single cones hold, as far as samples tell.
 */
#ifndef scConeTally_h
#define scConeTally_h

#include "scAccuracyTally.h"
#include "scEstimate.h"

#include <cstdint>

namespace shadowcones
{

/// What one cone holds.
struct ConeTally
{
  std::int64_t Samples = 0;
  std::int64_t Shadowed = 0;
  std::int64_t Lit = 0; ///< light that is not blocked

  Estimate Precision() const { return EstimateProportion(this->Shadowed, this->Samples); }
  /// Lit light inside this cone over all lit light.
  double Lost(const AccuracyTally& all) const
  {
    return all.LitInside.X > 0 ? static_cast<double>(this->Lit) / static_cast<double>(all.LitInside.X) : 0.0;
  }
};

} // namespace shadowcones

#endif
