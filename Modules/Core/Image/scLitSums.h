// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitSums.h
 * @brief Sums of the unshadowed medium term along one pixel's ray. Internal to Core.
 */
#ifndef scLitSums_h
#define scLitSums_h

#include "scExtinction.h"
#include "scLitTile.h"

#include <vector>

namespace shadowcones
{

/// Sums over the cells of one pixel's ray; one a thread.
class LitSums
{
public:
  explicit LitSums(const ExtinctionGroups& groups);
  /// The pixel must outlive the sums. @param tEnd where the ray ends.
  void Add(const LitPixel& pixel, double tEnd);
  /// What SumUpTo() and Of() need.
  void Accumulate();

  /// A place on the ray: a cell and a share of it.
  struct Place
  {
    int Cell = 0;
    double Share = 0.0;
  };
  Place PlaceOf(double t) const;
  double DistanceOf(const Place& place) const
  {
    const double begin = this->Pixel->EdgeAt(place.Cell);
    return begin + place.Share * (this->Pixel->EdgeAt(place.Cell + 1) - begin);
  }
  /// Source-weighted mean over wavelengths of all.
  double Mean() const { return this->Whole; }
  /// The same up to a place.
  double SumUpTo(const Place& place) const
  {
    const auto cell = static_cast<std::size_t>(place.Cell);
    return this->Cumulative[cell] + place.Share * (this->Cumulative[cell + 1] - this->Cumulative[cell]);
  }
  /// Of one cell, never below 0.
  double Of(int cell) const
  {
    return this->Cumulative[static_cast<std::size_t>(cell) + 1] - this->Cumulative[static_cast<std::size_t>(cell)];
  }
  double Width(int cell) const { return this->Pixel->EdgeAt(cell + 1) - this->Pixel->EdgeAt(cell); }
  const Place& End() const { return this->Last; }
  const LitPixel& Source() const { return *this->Pixel; }
  /// The unshadowed term of every group up to the end of the ray.
  const std::vector<double>& Groups() const { return this->Totals; }

private:
  const ExtinctionGroups& Extinction;
  const LitPixel* Pixel = nullptr;
  Place Last;
  std::vector<double> Cumulative; ///< up to the beginning of every cell
  std::vector<double> Totals;
  double Whole = 0.0;
};

} // namespace shadowcones

#endif
