// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShiftedGrid.h
 * @brief Stratified points of a pixel, which neighbouring pixels complement. Internal to Core.
 */
#ifndef scShiftedGrid_h
#define scShiftedGrid_h

#include "scLightStrata.h"
#include "scRandom.h"

#include <cmath>
#include <cstdint>

namespace shadowcones
{

/**
 * By how much the points of a pixel are shifted in their cells, in parts of 2^-32 of them. Pixels in Morton's order
 * take turns along the R2 sequence (Roberts 2018): those of any small square are spread evenly, so that their errors
 * cancel and what noise is left is fine-grained (Ahmed and Wonka, ACM TOG 39(6), 2020).
 */
struct PixelShift
{
  std::uint32_t U = 0;
  std::uint32_t V = 0;

  PixelShift() = default;
  PixelShift(int i, int j)
  {
    constexpr auto stepU = static_cast<std::uint64_t>(0.75487766624669276 * 0x1p64);
    constexpr auto stepV = static_cast<std::uint64_t>(0.56984029099805327 * 0x1p64);
    const std::uint64_t order = Spread(static_cast<std::uint32_t>(i)) | Spread(static_cast<std::uint32_t>(j)) << 1;
    this->U = static_cast<std::uint32_t>(order * stepU >> 32);
    this->V = static_cast<std::uint32_t>(order * stepV >> 32);
  }

private:
  /// Bit k becomes bit 2 k.
  static std::uint64_t Spread(std::uint64_t x)
  {
    x = (x | x << 16) & 0x0000FFFF0000FFFFull;
    x = (x | x << 8) & 0x00FF00FF00FF00FFull;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Full;
    x = (x | x << 2) & 0x3333333333333333ull;
    return (x | x << 1) & 0x5555555555555555ull;
  }
};

/// The unit square in n x n or n x (n + 1) cells, row by row like a snake, with a random point in each: those of a
/// seed, the same for every pixel but for its shift.
class ShiftedGrid
{
public:
  /// The smallest grid of at least @p count cells, which is 1 or more.
  ShiftedGrid(int count, std::uint64_t seed, const PixelShift& shift)
    : Shift(shift)
  {
    const int root = static_cast<int>(std::sqrt(static_cast<double>(count)));
    this->Rows = root * (root + 1) >= count ? root : root + 1;
    this->Columns = this->Rows * this->Rows >= count ? this->Rows : this->Rows + 1;
    this->State = HashSeed(seed, static_cast<std::uint64_t>(this->Count()));
  }

  int Count() const { return this->Rows * this->Columns; }
  /// The cells of the largest grid of no more than @p most, which is 1 or more.
  static int LargestCount(int most)
  {
    const int root = static_cast<int>(std::sqrt(static_cast<double>(most)));
    return root * (root + 1) <= most ? root * (root + 1) : root * root;
  }

  LightStrata::Point At(int index) const
  {
    const int row = index / this->Columns;
    const int place = index - row * this->Columns;
    const int column = row % 2 == 0 ? place : this->Columns - 1 - place;
    const std::uint64_t word = Mix64(this->State + static_cast<std::uint64_t>(index) * 0x9E3779B97F4A7C15ull);
    const auto u = static_cast<std::uint32_t>(static_cast<std::uint32_t>(word >> 32) + this->Shift.U);
    const auto v = static_cast<std::uint32_t>(static_cast<std::uint32_t>(word) + this->Shift.V);
    return { (column + u * 0x1p-32) / this->Columns, (row + v * 0x1p-32) / this->Rows };
  }

  /// Squared standard error of the mean of one value a point.
  double VarianceOfMean(const double* values) const
  {
    return LightStrata::VarianceOfGrid(values, this->Rows, this->Columns);
  }

private:
  PixelShift Shift;
  int Rows = 1;
  int Columns = 1;
  std::uint64_t State = 0;
};

} // namespace shadowcones

#endif
