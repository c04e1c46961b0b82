// SPDX-License-Identifier: BSD-3-Clause
#include "scLitSums.h"

#include <algorithm>

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

void LitSums::Add(const LitPixel& pixel, double tEnd)
{
  this->Pixel = &pixel;
  const int groups = this->Extinction.Count();
  this->Totals.resize(static_cast<std::size_t>(groups));
  this->Last = this->PlaceOf(tEnd);
  this->Whole = 0.0;
  for (int g = 0; g < groups; ++g)
  {
    const float* cell = pixel.Cells(g);
    double total = this->Last.Share * static_cast<double>(cell[this->Last.Cell]);
    for (int k = 0; k < this->Last.Cell; ++k)
    {
      total += static_cast<double>(cell[k]);
    }
    this->Totals[static_cast<std::size_t>(g)] = total;
    this->Whole += this->Extinction.MeanSource[static_cast<std::size_t>(g)] * total;
  }
}

void LitSums::Accumulate()
{
  double sum = 0.0;
  for (int k = 0; k < cells; ++k)
  {
    double mean = 0.0;
    for (int g = 0; g < this->Extinction.Count(); ++g)
    {
      mean += this->Extinction.MeanSource[static_cast<std::size_t>(g)] * static_cast<double>(this->Pixel->Cells(g)[k]);
    }
    this->Cumulative[static_cast<std::size_t>(k)] = sum;
    sum += std::max(mean, 0.0);
  }
  this->Cumulative[cells] = sum;
}

LitSums::Place LitSums::PlaceOf(double t) const
{
  const float* edges = this->Pixel->Values.data();
  const auto offset = static_cast<float>(t - this->Pixel->Reference);
  const auto after = static_cast<int>(std::upper_bound(edges + 1, edges + cells, offset) - edges);
  const int cell = after - 1;
  const float width = edges[after] - edges[cell];
  const double share = width > 0.0f ? static_cast<double>((offset - edges[cell]) / width) : 0.0;
  return { cell, std::clamp(share, 0.0, 1.0) };
}

} // namespace shadowcones
