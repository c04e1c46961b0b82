// SPDX-License-Identifier: BSD-3-Clause
#include "scSampleColumns.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Columns are so many times as long as cells of the lamp are many along its side: shorter ones tell less, and strata are no
/// longer about as large along the ray as on the lamp.
constexpr int shortestColumn = 4;
/// The least of several levels is less than each of them by chance.
constexpr double ofLeast = 1.1;
/// So many differences as large as one can be are taken for noise before any is looked at.
constexpr double noiseAtFirst = 6.0;
/// A lone edge: its variance over half the square of the step.
constexpr double ofEdge = 1.0 / 3.0;

/// 2^(2 level).
constexpr int CellsOf(int level)
{
  return 1 << (2 * level);
}
/// How many levels serve for so many samples: the last has strata as large along the ray as on the lamp, about.
int LevelsFor(int count)
{
  int levels = 1;
  while (levels < SampleColumns::MostLevels && (count >> (3 * levels)) >= shortestColumn)
  {
    ++levels;
  }
  return levels;
}
} // anonymous namespace

SampleColumns::SampleColumns()
  : Columns(static_cast<std::size_t>((CellsOf(MostLevels) - 1) / 3))
{
}

void SampleColumns::Begin(int count)
{
  this->InUse = LevelsFor(count);
  this->Found.fill(Level());
  std::fill_n(this->Columns.begin(), (CellsOf(this->InUse) - 1) / 3, Column());
}

void SampleColumns::Add(double all, double visible, std::uint32_t u, std::uint32_t v)
{
  Column* columns = this->Columns.data();
  for (int k = 0; k < this->InUse; ++k)
  {
    const auto place = [k](std::uint32_t x) { return static_cast<std::size_t>(std::uint64_t(x) << k >> 32); };
    Column& column = columns[(place(u) << k) + place(v)];
    columns += CellsOf(k);
    if (column.Samples > 0)
    {
      Level& level = this->Found[static_cast<std::size_t>(k)];
      const double allStep = all - column.All;
      const double visibleStep = visible - column.Visible;
      level.Squares.Add(allStep, visibleStep, allStep, visibleStep);
      level.Differences += 1;
      if (column.Samples > 1)
      {
        level.Turns.Add(column.AllStep, column.VisibleStep, allStep, visibleStep);
        level.Pairs += 1;
      }
      column.AllStep = allStep;
      column.VisibleStep = visibleStep;
    }
    column.Samples = std::min(column.Samples + 1, 2);
    column.All = all;
    column.Visible = visible;
  }
}

SampleColumns::Error SampleColumns::ErrorOf(const Levels& sums, int count, double ratio, double unit)
{
  Error least;
  int levels = 0;
  for (const Level& level : sums)
  {
    if (level.Differences == 0)
    {
      break;
    }
    const double squares = std::max(level.Squares.Of(ratio), 0.0);
    // As many as there are squares; noise makes them as large as these.
    const double turns = level.Pairs > 0
      ? std::max(-2.0 * level.Turns.Of(ratio), 0.0) * level.Differences / level.Pairs
      : squares;
    const double atFirst = noiseAtFirst * unit * unit;
    const double noise = atFirst + squares > 0.0 ? (atFirst + turns) / (atFirst + squares) : 1.0;
    const double variance = 0.5 * squares * count / level.Differences * (ofEdge + (1.0 - ofEdge) * noise);
    if (levels == 0 || variance < least.Variance)
    {
      least.Variance = variance;
      least.Roughness = squares > 0.0 ? std::min(turns / squares, 1.0) : 1.0;
    }
    ++levels;
  }
  least.Variance *= levels > 1 ? ofLeast : 1.0;
  return least;
}

} // namespace shadowcones
