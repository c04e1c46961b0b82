// SPDX-License-Identifier: BSD-3-Clause
#include "scVisibleRatio.h"

#include <algorithm>

namespace shadowcones
{

void VisibleRatio::LeaveAll(const IntervalLight& intervals)
{
  this->LeftOfGroups = intervals.Lit().Groups();
  this->Mean = intervals.Lit().Mean();
  this->MeanRatio = 1.0;
}

void VisibleRatio::Conclude(const IntervalLight& intervals, double weights)
{
  if (!(weights > 0.0))
  {
    this->LeaveAll(intervals);
    return;
  }
  const std::vector<double>& whole = intervals.Lit().Groups();
  double all = 0.0;
  double visible = 0.0;
  for (std::size_t g = 0; g < whole.size(); ++g)
  {
    all += this->Groups.MeanScatteredRadiance[g] * this->All[g];
    visible += this->Groups.MeanScatteredRadiance[g] * this->Visible[g];
  }
  this->MeanRatio = all > 0.0 ? visible / all : 1.0;
  this->LightPerAll = all > 0.0 ? intervals.MeanInside() * weights / all : 0.0;
  this->LeftOfGroups.resize(whole.size());
  this->Mean = 0.0;
  for (std::size_t g = 0; g < whole.size(); ++g)
  {
    const double ratio = this->All[g] > 0.0 ? this->Visible[g] / this->All[g] : this->MeanRatio;
    this->LeftOfGroups[g] = whole[g] - intervals.Inside()[g] * (1.0 - ratio);
    this->Mean += this->Groups.MeanScatteredRadiance[g] * this->LeftOfGroups[g];
  }
}

double VisibleRatio::SquaredError(
  const IntervalLight& intervals, double sampledVariance, double litError, double weightError) const
{
  const bool outside = intervals.Lit().Mean() > (1.0 + 1e-9) * intervals.MeanInside();
  const double hidden = outside ? 1.0 - this->MeanRatio : 0.0;
  const double ofWeights = weightError * intervals.MeanInside();
  return sampledVariance + litError * litError * (this->MeanRatio * this->MeanRatio + hidden * hidden) +
    ofWeights * ofWeights * std::max(this->MeanRatio * (1.0 - this->MeanRatio), 0.0);
}

} // namespace shadowcones
