// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLitSums.h
 * @brief Sums of the unshadowed medium term along one pixel's ray. Internal to Core.
 */
#ifndef scLitSums_h
#define scLitSums_h

#include "scExtinctionGroups.h"
#include "scLitPixel.h"
#include "scMediumOpticalDepth.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/**
 * Sums over the cells of one pixel's ray; one a thread. Of two kinds: what the light sends, up to a place, as exact as
 * the profile is; and a distribution of places, linear in distance within a cell, from which samples are drawn.
 */
class LitSums
{
public:
  explicit LitSums(const ExtinctionGroups& groups);
  /// The pixel must outlive the sums. @param tEnd where the ray ends; @param depth of the ray, nullptr in a homogeneous
  /// medium.
  void Add(const LitPixel& pixel, double tEnd, const MediumOpticalDepth* depth = nullptr);

  /// @name The unshadowed term
  ///@{
  /// Of every group up to the end of the ray.
  const std::vector<double>& Groups() const { return this->Totals; }
  /// Weighted mean over wavelengths of that.
  double Mean() const { return this->Whole; }
  /// Add that of every group between two places; all of the ray is Groups() to the last bit.
  void AddBetween(double from, double to, std::vector<double>& sums) const;
  /// The last cell that the ray reaches, and what it holds of it.
  int LastCell() const { return this->LastCoordinate.Cell; }
  double InLastCell(int group) const { return this->UpTo(this->LastCoordinate, group); }
  double End() const { return this->RayEnd; }
  /// A place on the ray: a cell and a fraction of it.
  struct CellCoordinate
  {
    int Cell = 0;
    double Fraction = 0.0;
  };
  /// Exactly where a distance lies among the cells.
  CellCoordinate Locate(double t) const;
  const CellCoordinate& LastPlace() const { return this->LastCoordinate; }
  /// What a group sends from a cell, up to a fraction of it.
  double UpTo(const CellCoordinate& at, int group) const;
  /// By how much that rises with the distance, at @p t, which lies there.
  double RiseAt(const CellCoordinate& at, double t, int group) const;
  ///@}

  /// @name The distribution of places
  ///@{
  /// What the rest needs.
  void Accumulate();
  CellCoordinate CellAt(double t) const;
  double DistanceOf(const CellCoordinate& at) const
  {
    const double begin = this->Pixel->EdgeAt(at.Cell);
    return begin + at.Fraction * (this->Pixel->EdgeAt(at.Cell + 1) - begin);
  }
  /// Mean over wavelengths up to a at.
  double SumUpTo(const CellCoordinate& at) const
  {
    const auto cell = static_cast<std::size_t>(at.Cell);
    return this->Cumulative[cell] + at.Fraction * (this->Cumulative[cell + 1] - this->Cumulative[cell]);
  }
  /// Of one cell, never below 0.
  double Of(int cell) const
  {
    return this->Cumulative[static_cast<std::size_t>(cell) + 1] - this->Cumulative[static_cast<std::size_t>(cell)];
  }
  double Width(int cell) const { return this->Pixel->EdgeAt(cell + 1) - this->Pixel->EdgeAt(cell); }
  ///@}

  const LitPixel& Profile() const { return *this->Pixel; }

private:
  double SlopeIn(int cell, int group) const;
  double SumOfCells(const CellCoordinate& at, int group) const;

  const ExtinctionGroups& Extinction;
  const LitPixel* Pixel = nullptr;
  const MediumOpticalDepth* OpticalDepth = nullptr;
  double RayEnd = 0.0;
  CellCoordinate LastCoordinate;
  std::vector<double> Cumulative; ///< up to the beginning of every cell
  std::vector<double> Totals;
  double Whole = 0.0;
};

} // namespace shadowcones

#endif
