// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSamplePrediction.h
 * @brief What cones, or another bound of shadow, predict for a sample point.
 */
#ifndef scSamplePrediction_h
#define scSamplePrediction_h

namespace shadowcones
{

/// What is predicted for a sample point.
struct SamplePrediction
{
  unsigned char Class = 0; ///< 0 lit, 1 penumbra, 2 umbra
  int ConeId = -1;         ///< the first cone that holds it
  double Height = 0.0;     ///< above that cone's base

  bool Inside() const { return this->Class > 0; }
};

} // namespace shadowcones

#endif
