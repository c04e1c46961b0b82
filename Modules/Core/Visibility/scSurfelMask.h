// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfelMask.h
 * @brief Which of 64 light samples a disc hides from a point: the innermost loops of the Soft probe. Internal to Core.
 *
 * From the point x the disc (c, n, r) hides the sample y where the segment from x to y crosses the disc. With q = x -
 * c, w = y - x and E = q (n.w) - (n.q) w, the line meets the disc where |E|^2 <= r^2 (n.w)^2, and between x and y where
 * n.q and n.q + n.w differ in sign.
 */
#ifndef scSurfelMask_h
#define scSurfelMask_h

#include <cstdint>

namespace shadowcones
{

/// Both conditions for a light in a plane: polynomials in its own coordinates (a, b).
struct PlanarSurfel
{
  double Disc[6];    ///< 1, a, b, a^2, ab, b^2: 0 or less on the disc
  double Between[3]; ///< 1, a, b: below 0 where the disc lies between
};
std::uint64_t PlanarSurfelMask(const PlanarSurfel& surfel, const double* a, const double* b);

/// For any light, sample by sample.
struct GeneralSurfel
{
  double Q[3];
  double Normal[3];
  double Height; ///< n.q
  double RadiusSquared;
  double Reach; ///< 1; 0 for a light at infinity, where every crossing ahead of the point counts
};
std::uint64_t GeneralSurfelMask(const GeneralSurfel& surfel, const double* x, const double* y, const double* z);

} // namespace shadowcones

#endif
