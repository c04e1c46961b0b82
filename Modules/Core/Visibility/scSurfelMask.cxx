// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfelMask.h"

#include "scWideLoops.h"

namespace shadowcones
{
namespace
{
/// The bit of each sample as an array: a choice by mask that compilers vectorise, where a shift by index is not.
struct BitTable
{
  std::uint64_t Bits[64];
  constexpr BitTable()
    : Bits{}
  {
    for (int k = 0; k < 64; ++k)
    {
      this->Bits[k] = std::uint64_t(1) << k;
    }
  }
};
constexpr BitTable table;
} // anonymous namespace

SHADOWCONES_WIDE std::uint64_t PlanarSurfelMask(const PlanarSurfel& surfel, const double* a, const double* b)
{
  const double d0 = surfel.Disc[0];
  const double d1 = surfel.Disc[1];
  const double d2 = surfel.Disc[2];
  const double d3 = surfel.Disc[3];
  const double d4 = surfel.Disc[4];
  const double d5 = surfel.Disc[5];
  const double b0 = surfel.Between[0];
  const double b1 = surfel.Between[1];
  const double b2 = surfel.Between[2];
  std::uint64_t mask = 0;
  for (int k = 0; k < 64; ++k)
  {
    const double disc = d0 + a[k] * (d1 + d3 * a[k] + d4 * b[k]) + b[k] * (d2 + d5 * b[k]);
    const double between = b0 + b1 * a[k] + b2 * b[k];
    mask |= ((disc <= 0.0) & (between < 0.0)) ? table.Bits[k] : 0;
  }
  return mask;
}

SHADOWCONES_WIDE std::uint64_t GeneralSurfelMask(
  const GeneralSurfel& surfel, const double* x, const double* y, const double* z)
{
  const double q0 = surfel.Q[0];
  const double q1 = surfel.Q[1];
  const double q2 = surfel.Q[2];
  const double n0 = surfel.Normal[0];
  const double n1 = surfel.Normal[1];
  const double n2 = surfel.Normal[2];
  const double height = surfel.Height;
  const double square = surfel.RadiusSquared;
  const double start = surfel.Reach * height;
  std::uint64_t mask = 0;
  for (int k = 0; k < 64; ++k)
  {
    const double along = n0 * x[k] + n1 * y[k] + n2 * z[k];
    const double e0 = q0 * along - height * x[k];
    const double e1 = q1 * along - height * y[k];
    const double e2 = q2 * along - height * z[k];
    const double disc = e0 * e0 + e1 * e1 + e2 * e2 - square * along * along;
    const double between = height * (start + along);
    mask |= ((disc <= 0.0) & (between < 0.0)) ? table.Bits[k] : 0;
  }
  return mask;
}

} // namespace shadowcones
