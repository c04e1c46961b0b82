// SPDX-License-Identifier: BSD-3-Clause
#include "scMediumOpticalDepth.h"

namespace shadowcones
{
namespace
{
/// Of the search for a depth within a cell.
constexpr int mostSteps = 60;
constexpr double closeEnough = 1e-6;
} // anonymous namespace

void MediumOpticalDepth::Tabulate(const Vector3& origin, const Vector3& direction, double tBegin, double tEnd)
{
  // Cell by cell and exactly, as ways to the light are: where the medium is opaque within a part of a cell, a table in regular
  // steps would begin it before or behind where light finds it.
  this->Density->Tabulate(origin, direction, tBegin, tEnd, this->Stretches);
  this->TableBegin = this->Stretches.front().Begin;
  const double length = this->Stretches.back().Begin - this->TableBegin;
  const std::size_t steps = std::isfinite(length) ? 2 * this->Stretches.size() : 1;
  this->StepsPerLength = length > 0.0 ? static_cast<double>(steps) / length : 0.0;
  this->FirstOfStep.resize(steps);
  std::uint32_t stretch = 0;
  for (std::size_t k = 0; k < steps; ++k)
  {
    const double t = this->TableBegin + static_cast<double>(k) * length / static_cast<double>(steps);
    while (stretch + 2 < this->Stretches.size() && this->Stretches[stretch + 1].Begin <= t)
    {
      ++stretch;
    }
    // One back, as a place may be found in the step behind its own by rounding.
    this->FirstOfStep[k] = stretch > 0 ? stretch - 1 : 0;
  }
}

double MediumOpticalDepth::LookUpDistance(double depth, double low, double high) const
{
  if (this->Stretches.size() < 2)
  {
    return low;
  }
  const double end = this->Stretches.back().Begin;
  const auto inTable = [&](double t) { return std::clamp(t, this->TableBegin, end); };
  std::size_t k = this->StretchAt(inTable(low));
  for (std::size_t to = this->StretchAt(inTable(high)); k < to;)
  {
    const std::size_t between = (k + to + 1) / 2;
    this->Stretches[between].OpticalDepth <= depth ? k = between : to = between - 1;
  }
  // Within a stretch the depth grows as a quartic. As if the density were linear first, then by Newton's steps, or halves where
  // they leave what is left.
  const DensityStretch& stretch = this->Stretches[k];
  const double length = this->Stretches[k + 1].Begin - stretch.Begin;
  const double rest = std::max(depth - stretch.OpticalDepth, 0.0);
  const double root = std::sqrt(std::max(stretch.Cubic[0] * stretch.Cubic[0] + 2.0 * rest * stretch.Cubic[1], 0.0));
  double s = !(rest > 0.0) ? 0.0
    : stretch.Cubic[0] + root > 0.0 ? std::min(2.0 * rest / (stretch.Cubic[0] + root), length) : 0.5 * length;
  if (!std::isfinite(length) || (stretch.Cubic[2] == 0.0 && stretch.Cubic[3] == 0.0))
  {
    return stretch.Begin + s;
  }
  double from = 0.0;
  double to = length;
  for (int step = 0; step < mostSteps; ++step)
  {
    const double missing = depth - stretch.DepthAfter(s);
    (missing > 0.0 ? from : to) = s;
    const double density = stretch.DensityAfter(s);
    const double next = density > 0.0 ? s + missing / density : from;
    const double before = s;
    s = next >= from && next <= to ? next : 0.5 * (from + to);
    if (std::fabs(s - before) <= closeEnough * std::min(s, length - s))
    {
      break; // the next step would be of the square of this one
    }
  }
  return stretch.Begin + s;
}

} // namespace shadowcones
