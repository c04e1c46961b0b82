// SPDX-License-Identifier: BSD-3-Clause
#include "scLitVariable.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int cells = LitProfileLayout::Cells;
constexpr int middle = cells / 2; ///< where a gap is
/// Rays pass the light at no less than this fraction of its radius, as far as the change of variable is concerned.
constexpr double smallestDistance = 0.3;
/// Of a ray's length: nearer than this is not told apart from it, and nearer than that not in single precision.
constexpr double smallestScale = 1e-11;
constexpr double closeScale = 1e-4;
/// A light farther away than so many lengths of the ray looks the same from all of it.
constexpr double farAway = 1000.0;
/// Cells of a dense medium begin to grow at this optical depth.
constexpr double firstDepth = 0.1;
constexpr double largestDepth = 1e3 * LitQuadrature::DeepestOpticalDepth;
} // anonymous namespace

LitVariable::LitVariable(
  const LitQuadrature& quadrature, const Ray& ray, const LitInterval& interval, const MediumOpticalDepth* depth)
  : HasGap(interval.HasGap)
  , SigmaT(quadrature.DenseSigmaT)
  , OpticalDepth(depth)
{
  const double length = std::fabs(interval.End - interval.Begin);
  this->Dense = this->SigmaT > 0.0;
  this->Nearest = Dot(quadrature.Center - ray.Origin, ray.Direction);
  const double distance = Length(ray.Origin + this->Nearest * ray.Direction - quadrature.Center);
  this->IsLength = IsAtInfinity(quadrature.Lamp) || distance > farAway * quadrature.Extent;
  if (!this->IsLength)
  {
    this->Scale = std::max({ distance, smallestDistance * quadrature.Radius, smallestScale * length });
    this->Close = this->Scale < closeScale * length;
  }
  this->CellWidth = this->Between(interval.Begin, interval.End) / cells;
  if (this->HasGap)
  {
    this->SetPart(this->Parts[0], interval.Begin, this->Nearest - interval.HalfGap, 0, middle);
    this->SetPart(this->Parts[1], this->Nearest + interval.HalfGap, interval.End, middle, cells - middle);
    return;
  }
  this->SetPart(this->Parts[0], interval.Begin, interval.End, 0, cells);
}

void LitVariable::SetPart(Part& part, double begin, double end, int firstCell, int count) const
{
  part.Begin = begin;
  part.End = end;
  part.FirstCell = firstCell;
  part.Cells = count;
  part.Width = this->HasGap ? this->Between(begin, end) / count : this->CellWidth;
  part.Graded = this->Dense && firstCell == 0;
  if (part.Graded)
  {
    part.Logarithm = std::log1p(this->DepthBetween(begin, end) / firstDepth);
    part.Graded = part.Logarithm > 0.0;
  }
}

double LitVariable::Between(double from, double to) const
{
  if (this->IsLength)
  {
    return to - from;
  }
  // The difference of the two angles, from one arc tangent.
  const double a = (from - this->Nearest) / this->Scale;
  const double b = (to - this->Nearest) / this->Scale;
  return std::atan2(b - a, 1.0 + a * b);
}

double LitVariable::DepthBetween(double from, double to) const
{
  const double length =
    this->OpticalDepth ? this->OpticalDepth->Along(to) - this->OpticalDepth->Along(from) : to - from;
  return std::max(this->SigmaT * (this->OpticalDepth ? std::min(length, largestDepth / this->SigmaT) : length), 0.0);
}

double LitVariable::CoordinateIn(const Part& part, double t) const
{
  const double even = this->Between(part.Begin, t) / part.Width;
  if (!part.Graded)
  {
    return even;
  }
  const double graded = std::log1p(this->DepthBetween(part.Begin, t) / firstDepth) / part.Logarithm;
  return 0.5 * (even + graded * part.Cells);
}

double LitVariable::CellCoordinate(double t) const
{
  const Part& part = this->HasGap && t > this->Nearest ? this->Parts[1] : this->Parts[0];
  if (!(part.End > part.Begin))
  {
    return part.FirstCell;
  }
  return part.FirstCell + std::clamp<double>(this->CoordinateIn(part, t), 0.0, part.Cells);
}

double LitVariable::DistanceIn(const Part& part, double offset) const
{
  if (!part.Graded)
  {
    if (this->IsLength)
    {
      return part.Begin + offset * part.Width;
    }
    return this->Nearest +
      this->Scale * std::tan(std::atan((part.Begin - this->Nearest) / this->Scale) + offset * part.Width);
  }
  double low = part.Begin;
  double high = part.End;
  if (!this->OpticalDepth)
  {
    // Each half of the coordinate alone is a bound; the depth behind the entry is what has to be told apart.
    const auto atGraded = [&](double fraction)
    { return part.Begin + firstDepth / this->SigmaT * std::expm1(fraction * part.Logarithm); };
    const double fraction = offset / part.Cells;
    low = std::max(low, atGraded(std::max(2.0 * fraction - 1.0, 0.0)));
    high = std::min(high, atGraded(std::min(2.0 * fraction, 1.0)));
  }
  for (int step = 0; step < 60 && high - low > 1e-12 * (high - part.Begin); ++step)
  {
    const double between = 0.5 * (low + high);
    (this->CoordinateIn(part, between) < offset ? low : high) = between;
  }
  return 0.5 * (low + high);
}

double LitVariable::DistanceAt(double cellCoordinate) const
{
  const Part& part = this->PartOf(cellCoordinate);
  return this->DistanceIn(part, cellCoordinate - part.FirstCell);
}

void LitVariable::FillEven(const Part& part, double* edges) const
{
  if (this->IsLength)
  {
    for (int k = 0; k < part.Cells; ++k)
    {
      edges[k] = part.Begin + k * part.Width;
    }
    return;
  }
  // Tangents of even angles: a vector that is turned by the same angle again and again.
  const double cosine = std::cos(part.Width);
  const double sine = std::sin(part.Width);
  const double begin = std::atan((part.Begin - this->Nearest) / this->Scale);
  double x = std::cos(begin);
  double y = std::sin(begin);
  for (int k = 0; k < part.Cells; ++k)
  {
    edges[k] = this->Nearest + this->Scale * (y / x);
    const double turned = cosine * x - sine * y;
    y = sine * x + cosine * y;
    x = turned;
  }
}

void LitVariable::FillEdges(double* edges) const
{
  for (int k = 0; k < (this->HasGap ? 2 : 1); ++k)
  {
    const Part& part = this->Parts[static_cast<std::size_t>(k)];
    if (!part.Graded)
    {
      this->FillEven(part, edges + part.FirstCell);
      continue;
    }
    for (int cell = 0; cell < part.Cells; ++cell)
    {
      edges[part.FirstCell + cell] = this->DistanceIn(part, cell);
    }
  }
  // The cell before a gap takes it in.
  edges[0] = this->Parts[0].Begin;
  edges[cells] = this->Parts[this->HasGap ? 1 : 0].End;
}

double LitVariable::Flattened(double t, double cellCoordinate) const
{
  const Part& part = this->PartOf(cellCoordinate);
  const double offset = t - this->Nearest;
  const double even = this->IsLength ? 1.0 : this->Scale * this->Scale + offset * offset;
  if (!this->Dense)
  {
    return this->HasGap ? even * (part.Width / this->CellWidth) : even;
  }
  // Distance per cell.
  const double perCell = this->IsLength ? part.Width : part.Width * even / this->Scale;
  if (!part.Graded)
  {
    return perCell;
  }
  const double gradedPerCell = part.Logarithm / part.Cells * (firstDepth / this->SigmaT + (t - part.Begin));
  return 2.0 / (1.0 / perCell + 1.0 / gradedPerCell);
}

} // namespace shadowcones
