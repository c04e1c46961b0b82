// SPDX-License-Identifier: BSD-3-Clause
#include "scLinesOfLight.h"

#include "scLampPlane.h"
#include "scPhaseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace shadowcones
{
namespace
{
/// Lines of a first look at a pixel, and of any estimate at least.
constexpr int fewestLines = 4;
/// The most in one pass.
constexpr int mostLinesOfPass = 1024;
/// Places on a line, visible and hidden ones together, at least one of each: what comes from a light at infinity varies
/// less along it.
constexpr int placesOfLine = 8;
constexpr int placesToInfinity = 2;
/// More lines than the first look asks for, so that they seldom fall short.
constexpr double safety = 1.5;
/// Where lines are this many times as wrong as wanted more of them are taken.
constexpr double farOff = 1.5;
/// Squared errors of n light points fall as n to this power.
constexpr double power = 1.75;
/// A part of the lamp that falls between n light points lights, or shades, something that none of them does: this share
/// of what is lit or shaded, whichever is less, over n^1.5.
constexpr double unseenSpread = 0.15;
/// Where all of them see the whole ray: this share of its light for a lamp that is large, less for those that look smaller.
constexpr double litSpread = 0.5;
constexpr double largeRadius = 0.1;
/// Where none of them sees any of it: this share of it, times the lamp's apparent radius.
constexpr double darkSpread = 0.1;
/// Lines in number fewer than this are rated by neighbours, which overrate slopes but say more.
constexpr int fewLines = 9;
/// The variance of n lines is rated so much higher, and by this over n more: few differences do not tell it well.
constexpr double caution = 1.5;
constexpr double doubt = 16.0;
constexpr double doubtOfFew = 9.0;
/// Lamps are kept away from by so many of their radii.
constexpr double radiiAway = 3.0;
constexpr double radiiBeside = 1.5; ///< by the line that goes on without end

/// Squares and what lies midway between them: strata of nearly square cells.
int NearestCount(double wanted)
{
  for (int side = 2; side * side < mostLinesOfPass; ++side)
  {
    for (const int count : { side * side, side * (side + 1) })
    {
      if (count >= wanted)
      {
        return count;
      }
    }
  }
  return mostLinesOfPass;
}

const LightStrata& StrataOf(int count)
{
  thread_local std::array<std::unique_ptr<LightStrata>, mostLinesOfPass + 1> strata;
  std::unique_ptr<LightStrata>& found = strata[static_cast<std::size_t>(count)];
  if (!found)
  {
    found = std::make_unique<LightStrata>(count);
  }
  return *found;
}
} // anonymous namespace

LinesOfLight::LinesOfLight(const RenderContext& context, const LineShadows& shadows, const LightLegs* legs)
  : Scene(context.Scene)
  , Options(context.Options)
  , Groups(context.Groups)
  , Shadows(shadows)
  , Rules(context.Scene.ShadowCasters().RulesFor(FlatFaceOf(context.Scene.Light)))
  , OpticalDepth(context.Scene.Medium)
  , Legs(legs)
  , Intervals(context.Groups)
  , Ratio(context.Groups)
{
  LightBoundingSphere(this->Scene.Light, this->LampCenter, this->LampRadius);
  this->Query.AtInfinity = IsAtInfinity(this->Scene.Light);
}

bool LinesOfLight::Fit(const RenderContext& context)
{
  // The points of a sphere that a place sees depend on the place.
  return context.Scene.Light.Shape != LightShape::Sphere && context.Options.Sampling != LightSampling::SolidAngle &&
    context.Options.MaximumSamples >= fewestLines * SamplesOfLine;
}

bool LinesOfLight::Fit(const LitPixel& pixel) const
{
  const Vector3& direction = pixel.Line.Direction;
  if (this->Query.AtInfinity)
  {
    const double turn = Length(Cross(direction, this->Scene.Light.Normal));
    return turn > radiiAway * std::sin(std::min(this->Scene.Light.Radius, 0.5)) + 1e-6;
  }
  // Nor does it point at the lamp: then no plane holds both, or planes turn with every point of the lamp.
  const auto distanceAt = [&](double t) { return Length(pixel.Line.Origin + t * direction - this->LampCenter); };
  const double along = Dot(this->LampCenter - pixel.Line.Origin, direction);
  const double nearest = std::clamp(along, pixel.Interval.Begin, pixel.Interval.End);
  return distanceAt(nearest) > radiiAway * this->LampRadius && distanceAt(along) > radiiBeside * this->LampRadius &&
    distanceAt(along) > 1e-6 * (pixel.Interval.End - pixel.Interval.Begin);
}

bool LinesOfLight::Begin(const LitSums& lit, const std::vector<RayInterval>& intervals)
{
  this->Lines = 0;
  this->LinesAsked = 0;
  this->Forget();
  if (!this->Intervals.Set(lit, intervals))
  {
    return false;
  }
  const LitPixel& pixel = lit.Profile();
  this->OpticalDepth.SetRay(pixel.Line.Origin, pixel.Line.Direction, pixel.Interval.MediumBegin, pixel.Interval.End);
  this->Query.Line = pixel.Line;
  this->Query.Begin = std::max(intervals.front().Begin, pixel.Interval.Begin);
  this->Query.End = std::min({ intervals.back().End, pixel.Interval.End, lit.End() });
  const Vector3 middle = pixel.Line.Origin + 0.5 * (this->Query.Begin + this->Query.End) * pixel.Line.Direction;
  this->Apparent = this->Query.AtInfinity ? std::sin(this->Scene.Light.Radius)
                                          : std::min(this->LampRadius / Length(this->LampCenter - middle), 1.0);
  this->HasPieces = false;
  const auto groups = static_cast<std::size_t>(this->Groups.Count());
  this->Before.resize(groups * (LitProfileLayout::Cells + 1));
  for (std::size_t g = 0; g < groups; ++g)
  {
    double* before = this->Before.data() + g * (LitProfileLayout::Cells + 1);
    const float* cell = pixel.Cells(static_cast<int>(g));
    before[0] = 0.0;
    for (int k = 0; k < LitProfileLayout::Cells; ++k)
    {
      before[k + 1] = before[k] + static_cast<double>(cell[k]);
    }
  }
  return this->Query.End > this->Query.Begin;
}

void LinesOfLight::Forget()
{
  this->Passes.clear();
  this->AllOfLine.clear();
  this->VisibleOfLine.clear();
  this->SumOfWeights = 0.0;
  this->Ratio.Forget();
}

int LinesOfLight::MostLines(int mostSamples) const
{
  return std::max(mostSamples / SamplesOfLine, 1);
}

void LinesOfLight::EstimateFrom(
  int lines, const LitSums& lit, const std::vector<RayInterval>& intervals, std::uint64_t seed)
{
  if (this->Begin(lit, intervals))
  {
    this->Sample(lines, HashSeed(seed, 0));
  }
  this->Conclude(0.0);
}

void LinesOfLight::Look(const LitSums& lit, const std::vector<RayInterval>& intervals,
  const BlockedLight::Yardstick& yardstick, std::uint64_t seed)
{
  this->Measure = yardstick;
  this->Seed = seed;
  this->Wanted = 0.0;
  if (!this->Begin(lit, intervals))
  {
    this->Conclude(yardstick.LitError);
    return;
  }
  if (!(this->Options.RelativeErrorGoal > 0.0))
  {
    this->Ratio.LeaveAll(this->Intervals);
    this->Wanted = this->MostLines(this->Options.MaximumSamples);
    return;
  }
  if (!(this->Apparent > 0.0))
  {
    this->Ratio.LeaveAll(this->Intervals);
    this->Wanted = fewestLines; // all are the same
    return;
  }
  this->Sample(fewestLines, HashSeed(seed, 0));
  this->Conclude(yardstick.LitError);
  this->Wanted = std::max<double>(this->LinesFor(this->Allowed()), fewestLines);
}

double LinesOfLight::Allowed() const
{
  const double wanted = this->Options.RelativeErrorGoal * std::max(this->Ratio.MeanLeft(), this->Measure.Darkest);
  return std::max(wanted * wanted - (this->SquaredError - this->SampledVariance), 0.25 * wanted * wanted);
}

void LinesOfLight::Estimate(int mostSamples)
{
  if (!(this->Wanted > 0.0))
  {
    return;
  }
  const int most = this->MostLines(std::min(mostSamples, std::max(this->Options.MaximumSamples, 1)));
  this->Lines = 0;
  this->Forget();
  for (std::uint64_t pass = 1; this->Lines < most; ++pass)
  {
    const int left = most - this->Lines;
    const bool all = !(this->Options.RelativeErrorGoal > 0.0);
    int count = std::min(all ? mostLinesOfPass : NearestCount(this->Wanted), left);
    count = left - count < fewestLines ? std::min(left, mostLinesOfPass) : count;
    this->Sample(count, HashSeed(this->Seed, pass));
    this->Conclude(this->Measure.LitError);
    const double allowed = this->Allowed();
    if (!all && this->SampledVariance <= farOff * farOff * allowed)
    {
      return;
    }
    const double enough = this->LinesFor(allowed / (1.0 - std::min(allowed / this->SampledVariance, 0.9)));
    this->Wanted = std::max<double>(enough, fewestLines);
  }
}

double LinesOfLight::VarianceOf(const Pass& pass)
{
  const double* all = this->AllOfLine.data() + pass.First;
  const double* visible = this->VisibleOfLine.data() + pass.First;
  std::vector<double>& residuals = this->Residuals;
  residuals.resize(static_cast<std::size_t>(pass.Count));
  for (int k = 0; k < pass.Count; ++k)
  {
    residuals[static_cast<std::size_t>(k)] = visible[k] - this->Ratio.Ratio() * all[k];
  }
  double variance = 0.0;
  if (pass.Count >= fewLines)
  {
    variance = (caution + doubt / pass.Count) * StrataOf(pass.Count).VarianceOfMean(residuals.data());
  }
  else
  {
    for (int k = 1; k < pass.Count; ++k)
    {
      const double step = residuals[static_cast<std::size_t>(k)] - residuals[static_cast<std::size_t>(k) - 1];
      variance += (caution + doubtOfFew / pass.Count) * step * step / (2.0 * (pass.Count - 1) * pass.Count);
    }
  }
  return variance * this->Ratio.PerAll() * this->Ratio.PerAll();
}

double LinesOfLight::Unseen() const
{
  const double inside = this->Intervals.MeanInside();
  if (!(this->Apparent > 0.0))
  {
    return 0.0; // all of the lamp is one point
  }
  const double share = std::min(this->Ratio.Ratio(), 1.0 - this->Ratio.Ratio());
  if (share > 1e-9)
  {
    return unseenSpread * share * inside;
  }
  const bool lit = this->Ratio.Ratio() > 0.5;
  return (lit ? litSpread * std::min(this->Apparent / largeRadius, 1.0) : darkSpread * this->Apparent) * inside;
}

double LinesOfLight::UnseenVariance(int count) const
{
  const double unseen = this->Unseen() / (count * std::sqrt(static_cast<double>(count)));
  return unseen * unseen;
}

double LinesOfLight::LinesFor(double variance)
{
  if (!(variance > 0.0))
  {
    return mostLinesOfPass;
  }
  double ofOne = 0.0; // squared error of a single line, by the power law
  double weights = 0.0;
  for (const Pass& pass : this->Passes)
  {
    ofOne += this->VarianceOf(pass) * std::pow(pass.Count, power) * pass.Count;
    weights += pass.Count;
  }
  ofOne *= safety / weights;
  const double unseen = this->Unseen();
  const double lines = std::pow(ofOne / variance, 1.0 / power);
  return std::max(lines, std::cbrt(unseen * unseen / variance));
}

void LinesOfLight::Conclude(double litError)
{
  this->Ratio.Conclude(this->Intervals, this->SumOfWeights);
  this->SampledVariance = 0.0;
  for (const Pass& pass : this->Passes)
  {
    const double weight = pass.Weight / this->SumOfWeights;
    this->SampledVariance += weight * weight * (this->VarianceOf(pass) + this->UnseenVariance(pass.Count));
  }
  this->SquaredError = this->Ratio.SquaredError(
    this->Intervals, this->SampledVariance, litError, this->Legs ? this->Legs->ErrorOfLegs : 0.0);
}

void LinesOfLight::Sample(int count, std::uint64_t seed)
{
  RandomStream random(seed, 0);
  const LightStrata& strata = StrataOf(count);
  Pass pass;
  pass.First = this->AllOfLine.size();
  pass.Count = count;
  pass.Weight = count * std::sqrt(static_cast<double>(count));
  for (int k = 0; k < count; ++k)
  {
    const LightStrata::Point uv = strata.Draw(k, random);
    this->AddLine(SampleLightArea(this->Scene.Light, uv.U, uv.V), pass.Weight / count, random);
  }
  this->Lines += count;
  this->SumOfWeights += pass.Weight;
  this->Passes.push_back(pass);
}

void LinesOfLight::AddLine(const LightSurfaceSample& point, double weight, RandomStream& random)
{
  if (this->Apparent > 0.0 || !this->HasPieces)
  {
    this->Query.Light = point.Position;
    this->LinesAsked += 1;
    if (!this->Shadows.Find(this->Query, this->Rules.Ignored, this->Hidden))
    {
      this->Hidden.clear();
    }
    this->CutPieces();
    this->SumUp();
    this->HasPieces = true;
  }
  this->OfVisible = this->Unhidden;
  this->OfHidden.assign(this->OfVisible.size(), 0.0);
  for (std::size_t g = 0; g < this->OfHidden.size(); ++g)
  {
    this->OfHidden[g] = this->HiddenPieces.empty() ? 0.0 : this->Intervals.Inside()[g] - this->Unhidden[g];
  }
  if (this->Apparent > 0.0)
  {
    this->AddDifferences(this->VisiblePieces, this->VisibleLight, point, random, this->OfVisible);
    this->AddDifferences(this->HiddenPieces, this->HiddenLight, point, random, this->OfHidden);
  }
  double all = 0.0;
  double visible = 0.0;
  for (std::size_t g = 0; g < this->OfVisible.size(); ++g)
  {
    const double ofBoth = this->OfVisible[g] + this->OfHidden[g];
    this->Ratio.Add(g, weight * ofBoth, weight * this->OfVisible[g]);
    all += this->Groups.MeanScatteredRadiance[g] * ofBoth;
    visible += this->Groups.MeanScatteredRadiance[g] * this->OfVisible[g];
  }
  this->VisibleOfLine.push_back(visible);
  this->AllOfLine.push_back(all);
}

/// Cut the light of the intervals into what is visible and what is hidden.
void LinesOfLight::CutPieces()
{
  const LitSums& lit = this->Intervals.Lit();
  this->VisiblePieces.clear();
  this->HiddenPieces.clear();
  this->VisibleLight = 0.0;
  this->HiddenLight = 0.0;
  const auto add = [](std::vector<Piece>& pieces, double& light, const Piece& piece)
  {
    if (piece.Light > 0.0)
    {
      pieces.push_back(piece);
      light += piece.Light;
    }
  };
  auto next = this->Hidden.begin();
  for (const IntervalLight::Part& part : this->Intervals.Parts())
  {
    const double end = part.Begin + part.Light;
    double at = part.Begin;
    double from = part.From;
    while (at < end && next != this->Hidden.end())
    {
      const double begin = std::clamp(lit.SumUpTo(lit.CellAt(next->Begin)), at, end);
      const double stop = std::clamp(lit.SumUpTo(lit.CellAt(next->End)), begin, end);
      const double first = std::clamp(next->Begin, from, part.To);
      const double last = std::clamp(next->End, first, part.To);
      add(this->VisiblePieces, this->VisibleLight, { at, begin - at, from, first });
      add(this->HiddenPieces, this->HiddenLight, { begin, stop - begin, first, last });
      at = stop;
      from = last;
      if (next->End > part.To)
      {
        break; // it goes on in the next part
      }
      ++next;
    }
    add(this->VisiblePieces, this->VisibleLight, { at, end - at, from, part.To });
  }
}

/// The unshadowed light of the visible pieces, as exact as the profile is.
void LinesOfLight::SumUp()
{
  if (this->HiddenPieces.empty())
  {
    this->Unhidden = this->Intervals.Inside();
    return;
  }
  this->Unhidden.assign(static_cast<std::size_t>(this->Groups.Count()), 0.0);
  for (const Piece& piece : this->VisiblePieces)
  {
    this->AddUpTo(piece.To, 1.0, this->Unhidden);
    this->AddUpTo(piece.From, -1.0, this->Unhidden);
  }
}

void LinesOfLight::AddUpTo(double t, double factor, std::vector<double>& sums) const
{
  const LitSums& lit = this->Intervals.Lit();
  if (t <= lit.Profile().Interval.Begin)
  {
    return;
  }
  const LitSums::CellCoordinate at = t < lit.End() ? lit.Locate(t) : lit.LastPlace();
  for (std::size_t g = 0; g < sums.size(); ++g)
  {
    const double before = this->Before[g * (LitProfileLayout::Cells + 1) + static_cast<std::size_t>(at.Cell)];
    sums[g] += factor * (before + lit.UpTo(at, static_cast<int>(g)));
  }
}

/// What the whole lamp would send by way of a place, were it all where the point is, but for attenuation, whose optical
/// depth is given; per unit of length.
double LinesOfLight::SentBy(const LightSurfaceSample& point, double t, double& depth) const
{
  const Light& light = this->Scene.Light;
  const Ray& ray = this->Query.Line;
  const Vector3 place = ray.Origin + t * ray.Direction;
  Vector3 direction = point.Position;
  double distance = HUGE_VAL;
  double weight = 1.0;
  if (!this->Query.AtInfinity)
  {
    const bool isFace =
      light.Shape != LightShape::Point && (light.Shape != LightShape::Mesh || !light.Triangles.empty());
    const Vector3 to = point.Position - place;
    const double squared = Dot(to, to);
    distance = std::sqrt(squared);
    direction = (1.0 / distance) * to;
    weight = (isFace ? std::max(-Dot(direction, point.Normal), 0.0) : 1.0) / (squared * point.Pdf);
  }
  depth = this->OpticalDepth.Along(t) + DepthTowards(this->Legs, this->OpticalDepth, place, direction, distance);
  return weight * this->OpticalDepth.DensityAlong(t) *
    EvaluatePhaseFunction(this->Scene.Medium.Phase, Dot(direction, ray.Direction));
}

/// By how much these pieces send more, or less, from the light point than from all of the lamp on average.
void LinesOfLight::AddDifferences(const std::vector<Piece>& pieces, double light, const LightSurfaceSample& point,
  RandomStream& random, std::vector<double>& sums) const
{
  if (pieces.empty())
  {
    return;
  }
  const LitSums& lit = this->Intervals.Lit();
  const int places = this->Query.AtInfinity ? placesToInfinity : placesOfLine;
  const int count = std::max(static_cast<int>(std::lround(places * light / this->Intervals.Distributed())), 1);
  std::size_t piece = 0;
  double before = 0.0;
  int cell = 0;
  for (int k = 0; k < count; ++k)
  {
    const double target = (k + random.Next()) / count * light;
    while (piece + 1 < pieces.size() && target >= before + pieces[piece].Light)
    {
      before += pieces[piece].Light;
      ++piece;
    }
    const double t = this->Intervals.MoveToSum(pieces[piece].Begin + (target - before), cell);
    const double inCell = lit.Of(cell);
    if (!(inCell > 0.0))
    {
      continue;
    }
    double depth = 0.0;
    const double sent = this->SentBy(point, t, depth);
    const double weight = light / count * lit.Width(cell) / inCell;
    const LitSums::CellCoordinate at = lit.Locate(t);
    for (std::size_t g = 0; g < sums.size(); ++g)
    {
      const double mean = lit.RiseAt(at, t, static_cast<int>(g));
      sums[g] += weight * (sent * TransmittanceOver(this->Groups.SigmaT[g], depth) - mean);
    }
  }
}

} // namespace shadowcones
