// SPDX-License-Identifier: BSD-3-Clause
#include "scIntervalLight.h"

#include <algorithm>

namespace shadowcones
{

bool IntervalLight::Set(const LitSums& lit, const std::vector<RayInterval>& intervals)
{
  this->Sums = &lit;
  this->InGroups.assign(static_cast<std::size_t>(this->Groups.Count()), 0.0);
  this->Mean = 0.0;
  this->PartsOfRay.clear();
  this->All = 0.0;
  const double all = lit.SumUpTo(lit.CellAt(lit.End()));
  for (const RayInterval& interval : intervals)
  {
    const double begin = std::min(lit.SumUpTo(lit.CellAt(interval.Begin)), all);
    const double end = std::min(lit.SumUpTo(lit.CellAt(interval.End)), all);
    if (end > begin)
    {
      this->PartsOfRay.push_back({ begin, end - begin, this->All, interval.Begin, std::min(interval.End, lit.End()) });
      this->All += end - begin;
      lit.AddBetween(interval.Begin, interval.End, this->InGroups);
    }
  }
  for (std::size_t g = 0; g < this->InGroups.size(); ++g)
  {
    this->InGroups[g] = std::max(this->InGroups[g], 0.0); // a difference of sums
    this->Mean += this->Groups.MeanScatteredRadiance[g] * this->InGroups[g];
  }
  return this->All > 0.0;
}

double IntervalLight::MoveToSum(double sum, int& cell) const
{
  const LitSums& lit = *this->Sums;
  while (cell + 1 < LitProfileLayout::Cells && sum >= lit.SumUpTo({ cell, 1.0 }))
  {
    ++cell;
  }
  const double inCell = lit.Of(cell);
  const double fraction = inCell > 0.0 ? std::clamp((sum - lit.SumUpTo({ cell, 0.0 })) / inCell, 0.0, 1.0) : 0.5;
  return lit.DistanceOf({ cell, fraction });
}

} // namespace shadowcones
