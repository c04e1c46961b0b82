// SPDX-License-Identifier: BSD-3-Clause
#include "scLitSums.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int cells = LitProfileLayout::Cells;
} // anonymous namespace

LitSums::LitSums(const ExtinctionGroups& groups)
  : Extinction(groups)
  , Cumulative(cells + 1)
{
}

void LitSums::Add(const LitPixel& pixel, double tEnd, const MediumOpticalDepth* depth)
{
  this->Pixel = &pixel;
  this->OpticalDepth = depth;
  this->RayEnd = tEnd;
  const int groups = this->Extinction.Count();
  this->Totals.resize(static_cast<std::size_t>(groups));
  this->LastCoordinate = tEnd < pixel.Interval.End ? this->Locate(tEnd) : CellCoordinate{ cells - 1, 1.0 };
  this->Whole = 0.0;
  for (int g = 0; g < groups; ++g)
  {
    // What is interpolated may be below 0 where there is next to no light.
    const double total = std::max(this->SumOfCells(this->LastCoordinate, g), 0.0);
    this->Totals[static_cast<std::size_t>(g)] = total;
    this->Whole += this->Extinction.MeanScatteredRadiance[static_cast<std::size_t>(g)] * total;
  }
}

double LitSums::SumOfCells(const CellCoordinate& at, int group) const
{
  const float* cell = this->Pixel->Cells(group);
  double sum = 0.0;
  for (int k = 0; k < at.Cell; ++k)
  {
    sum += static_cast<double>(cell[k]);
  }
  return sum + this->UpTo(at, group);
}

double LitSums::UpTo(const CellCoordinate& at, int group) const
{
  const float* cell = this->Pixel->Cells(group);
  const auto value = static_cast<double>(cell[at.Cell]);
  const double x = at.Fraction;
  if (this->OpticalDepth || x >= 1.0)
  {
    return x * value;
  }
  return x * (value + 0.5 * (x - 1.0) * this->SlopeIn(at.Cell, group));
}

/// In the profile's variable the light is nearly linear over a cell, with the slope that its neighbours show.
double LitSums::SlopeIn(int at, int group) const
{
  const float* cell = this->Pixel->Cells(group);
  const LitVariable& variable = this->Pixel->Variable;
  const bool before = at > 0 && !variable.IsGap(at);
  const bool after = at + 1 < cells && !variable.IsGap(at + 1);
  const double slope = static_cast<double>(cell[at + (after ? 1 : 0)] - cell[at - (before ? 1 : 0)]);
  const double steepest = 2.0 * std::fabs(static_cast<double>(cell[at]));
  return std::clamp((before && after ? 0.5 : 1.0) * slope, -steepest, steepest);
}

double LitSums::RiseAt(const CellCoordinate& at, double t, int group) const
{
  const auto value = static_cast<double>(this->Pixel->Cells(group)[at.Cell]);
  if (this->OpticalDepth)
  {
    const double begin = this->Pixel->EdgeAt(at.Cell);
    const double end = this->Pixel->EdgeAt(at.Cell + 1);
    const double depth = this->OpticalDepth->Along(end) - this->OpticalDepth->Along(begin);
    return depth > 0.0 ? value * this->OpticalDepth->DensityAlong(t) / depth : value / (end - begin);
  }
  const LitVariable& variable = this->Pixel->Variable;
  const double perCell = variable.Flattened(t, at.Cell + at.Fraction) * variable.CellFactor();
  return (value + (at.Fraction - 0.5) * this->SlopeIn(at.Cell, group)) / perCell;
}

void LitSums::AddBetween(double from, double to, std::vector<double>& sums) const
{
  if (from >= this->RayEnd)
  {
    return;
  }
  const bool first = from <= this->Pixel->Interval.Begin;
  const CellCoordinate begin = first ? CellCoordinate() : this->Locate(from);
  const CellCoordinate end = to < this->RayEnd ? this->Locate(to) : this->LastCoordinate;
  for (int g = 0; g < this->Extinction.Count(); ++g)
  {
    const double upTo = to < this->RayEnd ? this->SumOfCells(end, g) : this->Totals[static_cast<std::size_t>(g)];
    sums[static_cast<std::size_t>(g)] += first ? upTo : upTo - this->SumOfCells(begin, g);
  }
}

LitSums::CellCoordinate LitSums::Locate(double t) const
{
  if (this->OpticalDepth)
  {
    // In a medium of varying density a cell's light lies where its depth is.
    CellCoordinate at = this->CellAt(t);
    const double begin = this->OpticalDepth->Along(this->Pixel->EdgeAt(at.Cell));
    const double depth = this->OpticalDepth->Along(this->Pixel->EdgeAt(at.Cell + 1)) - begin;
    at.Fraction = depth > 0.0 ? std::clamp((this->OpticalDepth->Along(t) - begin) / depth, 0.0, 1.0) : at.Fraction;
    return at;
  }
  const double coordinate = this->Pixel->Variable.CellCoordinate(t);
  const int cell = std::min(static_cast<int>(coordinate), cells - 1);
  return { cell, coordinate - cell };
}

void LitSums::Accumulate()
{
  double sum = 0.0;
  for (int k = 0; k < cells; ++k)
  {
    double mean = 0.0;
    for (int g = 0; g < this->Extinction.Count(); ++g)
    {
      mean += this->Extinction.MeanScatteredRadiance[static_cast<std::size_t>(g)] *
        static_cast<double>(this->Pixel->Cells(g)[k]);
    }
    this->Cumulative[static_cast<std::size_t>(k)] = sum;
    sum += std::max(mean, 0.0);
  }
  this->Cumulative[cells] = sum;
}

LitSums::CellCoordinate LitSums::CellAt(double t) const
{
  const double* edges = this->Pixel->Edges.data();
  const auto after = static_cast<int>(std::upper_bound(edges + 1, edges + cells, t) - edges);
  const int cell = after - 1;
  const double width = edges[after] - edges[cell];
  const double fraction = width > 0.0 ? (t - edges[cell]) / width : 0.0;
  return { cell, std::clamp(fraction, 0.0, 1.0) };
}

} // namespace shadowcones
