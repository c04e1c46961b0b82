// SPDX-License-Identifier: BSD-3-Clause
#include "scSurfaceLight.h"

#include "scLitKernel.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Largest error of unshadowed light over itself, and this share of what pixels may err by.
constexpr double litTolerance = 1e-3;
constexpr double litFraction = 0.2;
/// Unshadowed light is of no use where it errs by more than this share of what pixels may.
constexpr double largestLitFraction = 0.5;
/// A goal of 0 asks for MaximumSamples, and for unshadowed light as good as this one's.
constexpr double smallestGoal = 5e-3;
/// What samples of an uneven medium's attenuation leave unsaid, over the light.
constexpr double attenuationError = 1e-3;
/// An edge of the shadow may hide in the part of one sample: 1 / sqrt(12), once.
constexpr double edgeSpread = 0.29;
/// Where all samples say the same, a thin shadow or beam may have slipped between a few of them.
constexpr double unseenSpread = 0.85;
/// Which is as much as this above what is wanted where nothing else is wrong.
constexpr double unseenExcess = 1.5;
/// A straight edge across the middle of the light leaves n samples about this variance, over its square, times n^(3/2):
/// of a few samples that show less, because the edge runs along their rows, little is believed. In a look, which decides
/// on their number, with a margin.
constexpr double middleEdge = 0.2;
constexpr double lookMargin = 1.3;
/// Two levels of a rule that agree may both be wrong by more than they differ.
constexpr double litMargin = 2.0;
/// Steps of the share that a look sees.
constexpr double shareSteps = 256.0;

/// Seeds of the looks and of the samples that count.
enum Pass : std::uint64_t
{
  FirstLook = 0,
  SecondLook = 1,
  Estimate = 2
};

/// What one straight edge leaves that hides all but a fraction of the light; about a disc's chord.
double EdgeVariance(double fraction)
{
  return middleEdge * std::cbrt(4.0 * fraction * (1.0 - fraction));
}

/// Times n^(3/2): what samples show of edges, and what one edge leaves.
double BelievedEdges(double shown, double typical)
{
  return std::max(shown, 0.25 * shown + 0.75 * typical);
}

std::uint64_t SeedOf(const ScatteringOptions& options, std::uint64_t key, Pass pass)
{
  return HashSeed(options.Seed, ~(4 * key + pass));
}
} // anonymous namespace

SurfaceLight::SurfaceLight(
  const ShadingLight& light, const ScatteringOptions& options, const ExtinctionGroups& groups)
  : Shading(light)
  , Options(options)
  , Groups(groups)
  , OpticalDepth(light.Scene.Medium)
  , Sampler(light.Scene.Light, options.Sampling)
  , Coarse(groups.SigmaT.size())
  , Means(groups.SigmaT.size())
{
}

double SurfaceLight::MeanOf(const std::vector<double>& irradiance, const SurfaceEstimate& estimate) const
{
  double mean = 0.0;
  for (std::size_t g = 0; g < irradiance.size(); ++g)
  {
    mean += estimate.Weights[g] * irradiance[g];
  }
  return mean;
}

double SurfaceLight::OpticalDepthTo(const SurfacePoint& point, const Vector3& direction, double distance) const
{
  return point.Inside ? this->OpticalDepth.Towards(point.Position, direction, distance)
                      : this->OpticalDepth.TowardsFromOutside(point.Position, direction, distance);
}

/// Add the light that a rule knows of; without what the medium takes where not @p attenuated.
void SurfaceLight::AddRule(
  const LightRule& rule, const SurfacePoint& point, bool attenuated, std::vector<double>& sums)
{
  if (!point.Inside || !rule.IsByArea(point.Position) || (attenuated && !this->OpticalDepth.IsHomogeneous()))
  {
    rule.ForEach(point.Position,
      [&](const IncidentSample& sample)
      {
        const double weight = sample.Weight * Dot(sample.Direction, point.Normal);
        if (weight > 0.0)
        {
          const double depth = attenuated ? this->OpticalDepthTo(point, sample.Direction, sample.Distance) : 0.0;
          for (std::size_t g = 0; g < sums.size(); ++g)
          {
            sums[g] += weight * TransmittanceOver(this->Groups.SigmaT[g], depth);
          }
        }
      });
    return;
  }
  const LightPoints points = rule.AreaPoints();
  const auto count = static_cast<std::size_t>(points.Count);
  this->RuleValues.resize(3 * count);
  float* weight = this->RuleValues.data();
  float* cosine = weight + count;
  float* leg = cosine + count;
  // Of the surface's normal the cosine is asked, not of a ray's direction.
  LookAtLight(points, rule.ViewFrom(point.Position, point.Normal, this->Shading.Scene.Medium.Bounds), weight, cosine,
    leg);
  for (std::size_t k = 0; k < count; ++k)
  {
    weight[k] *= std::max(cosine[k], 0.0f);
  }
  for (std::size_t g = 0; g < sums.size(); ++g)
  {
    const double sigmaT = attenuated ? this->Groups.SigmaT[g] : 0.0;
    sums[g] += static_cast<double>(SumAttenuated(weight, leg, points.Count, static_cast<float>(sigmaT)));
  }
}

/// Find the unshadowed light, with levels of the rule until two of them agree.
void SurfaceLight::Illuminate(const SurfacePoint& point, SurfaceEstimate& estimate)
{
  const std::size_t groups = this->Groups.SigmaT.size();
  estimate.Lit.assign(groups, 0.0);
  estimate.MeanLit = 0.0;
  estimate.LitError = 0.0;
  estimate.LitIsKnown = !this->Shading.Levels.empty();
  if (!estimate.LitIsKnown)
  {
    return;
  }
  // Legs through an uneven medium cost far more than points of the light: the first level alone has them.
  const bool attenuated = this->OpticalDepth.IsHomogeneous();
  const double goal = this->Options.RelativeErrorGoal > 0.0 ? this->Options.RelativeErrorGoal : smallestGoal;
  const double tolerance = std::min(litTolerance, litFraction * goal);
  const auto first = std::min(static_cast<std::size_t>(this->Shading.Levels.front()->LevelsNearer(point.Position)),
    this->Shading.Levels.size() - 1);
  this->AddRule(*this->Shading.Levels[first], point, attenuated, estimate.Lit);
  estimate.MeanLit = this->MeanOf(estimate.Lit, estimate);
  for (std::size_t level = first + 1; level < this->Shading.Levels.size(); ++level)
  {
    const double before = estimate.MeanLit;
    estimate.Lit.assign(groups, 0.0);
    this->AddRule(*this->Shading.Levels[level], point, attenuated, estimate.Lit);
    estimate.MeanLit = this->MeanOf(estimate.Lit, estimate);
    estimate.LitError = litMargin * std::fabs(estimate.MeanLit - before);
    if (estimate.LitError <= tolerance * std::max(estimate.MeanLit, this->Shading.Darkest))
    {
      break;
    }
  }
  if (!attenuated && estimate.MeanLit > 0.0)
  {
    this->Coarse.assign(groups, 0.0);
    this->Means.assign(groups, 0.0);
    this->AddRule(*this->Shading.Levels.front(), point, false, this->Coarse);
    this->AddRule(*this->Shading.Levels.front(), point, true, this->Means);
    for (std::size_t g = 0; g < groups; ++g)
    {
      estimate.Lit[g] *= this->Coarse[g] > 0.0 ? this->Means[g] / this->Coarse[g] : 0.0;
    }
    estimate.MeanLit = this->MeanOf(estimate.Lit, estimate);
    estimate.LitError = std::hypot(estimate.LitError, attenuationError * estimate.MeanLit);
  }
  estimate.LitIsKnown =
    estimate.LitError <= largestLitFraction * goal * std::max(estimate.MeanLit, this->Shading.Darkest);
}

void SurfaceLight::Look(
  const SurfacePoint& point, int samples, std::uint64_t key, const PixelShift& shift, SurfaceEstimate& estimate)
{
  const std::vector<double>& spectrum = this->Shading.Scene.Light.Spectrum;
  estimate.Weights.assign(this->Groups.SigmaT.size(), 0.0);
  for (std::size_t k = 0; k < spectrum.size(); ++k)
  {
    estimate.Weights[static_cast<std::size_t>(this->Groups.GroupOf[k])] +=
      spectrum[k] * point.Throughput[k] / static_cast<double>(spectrum.size());
  }
  this->Illuminate(point, estimate);
  estimate.StopsShort = false;
  estimate.IsDone = true;
  estimate.Irradiance = estimate.Lit;
  estimate.Mean = estimate.MeanLit;
  estimate.Variance = estimate.LitError * estimate.LitError;
  if (estimate.LitIsKnown && !(estimate.MeanLit > 0.0))
  {
    return; // the light shines elsewhere
  }
  estimate.Traces = this->Shading.Occlusion.NeedsRays(point.Position);
  estimate.MayMiss = estimate.Traces || this->Options.Mode == ScatteringMode::Medium;
  if (this->Shading.IsSingle)
  {
    this->TakeOne(point, estimate);
    return;
  }
  if (estimate.MayMiss || !estimate.LitIsKnown)
  {
    estimate.IsDone = false;
    this->LookAgain(point, samples, SeedOf(this->Options, key, FirstLook), shift, estimate);
  }
}

/// The light is one place.
void SurfaceLight::TakeOne(const SurfacePoint& point, SurfaceEstimate& estimate)
{
  this->Draw(point, ShiftedGrid(1, 0, {}), estimate.Traces);
  estimate.Mean = this->Add(point, 0.0, estimate);
  estimate.Irradiance = this->Means;
  estimate.Variance = 0.0;
}

/// Look at what is in the way with samples that count no further.
void SurfaceLight::LookAgain(
  const SurfacePoint& point, int samples, std::uint64_t seed, const PixelShift& shift, SurfaceEstimate& estimate)
{
  estimate.Edges = 0.0;
  estimate.Agrees = true;
  estimate.Share = 1.0;
  estimate.Mean = estimate.MeanLit;
  if (!estimate.Traces && estimate.LitIsKnown)
  {
    return;
  }
  const ShiftedGrid grid(std::max(samples, 1), seed, shift);
  this->Draw(point, grid, estimate.Traces);
  estimate.Agrees = this->Drawn.Agree();
  if (estimate.Agrees && estimate.LitIsKnown)
  {
    estimate.Share = this->Drawn.NumberOfSeen == this->Drawn.NumberOfLit ? 1.0 : 0.0;
    estimate.Mean = estimate.Share * estimate.MeanLit;
    return;
  }
  const double seen = this->Add(point, 0.0, estimate);
  this->Visible = this->Drawn.Values;
  const double hidden = -this->Add(point, 1.0, estimate);
  const double all = seen + hidden;
  estimate.MeanLit = estimate.LitIsKnown ? estimate.MeanLit : all;
  // Rounded: so that wavelengths on their own have the samples and values that they have together.
  estimate.Share = estimate.LitIsKnown && all > 0.0 ? std::round(seen / all * shareSteps) / shareSteps : 0.0;
  estimate.Mean = estimate.LitIsKnown ? estimate.Share * estimate.MeanLit : seen;
  std::vector<double>& values = this->Drawn.Values;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    values[k] = (1.0 - estimate.Share) * this->Visible[k] + estimate.Share * values[k];
  }
  estimate.Edges = lookMargin * this->EdgesOf(grid, estimate);
}

/// The variance that the drawn samples leave, but for what they have not seen, times n^(3/2).
double SurfaceLight::EdgesOf(const ShiftedGrid& grid, const SurfaceEstimate& estimate) const
{
  const double fraction = this->Drawn.NumberOfLit > 0
    ? static_cast<double>(this->Drawn.NumberOfSeen) / static_cast<double>(this->Drawn.NumberOfLit)
    : 0.0;
  const double shown = grid.VarianceOfMean(this->Drawn.Values.data()) * std::pow(grid.Count(), 1.5);
  return BelievedEdges(shown, EdgeVariance(fraction) * estimate.MeanLit * estimate.MeanLit);
}

void SurfaceLight::Finish(const SurfacePoint& point, double allowed, double allowedInTheDark, std::uint64_t key,
  const PixelShift& shift, SurfaceEstimate& estimate)
{
  if (estimate.IsDone)
  {
    return;
  }
  const auto isDark = [&estimate] { return estimate.Agrees && !(estimate.Mean > 0.0); };
  const double inTheDark = std::max(allowed, allowedInTheDark);
  int count = this->SamplesFor(isDark() ? inTheDark : allowed, estimate);
  if (isDark())
  {
    this->LookAgain(point, count, SeedOf(this->Options, key, SecondLook), shift, estimate);
    allowed = isDark() ? inTheDark : allowed;
    count = this->SamplesFor(allowed, estimate);
  }
  const double lit = estimate.Share * estimate.LitError;
  const ShiftedGrid grid(count, SeedOf(this->Options, key, Estimate), shift);
  if (!estimate.Traces && estimate.LitIsKnown)
  {
    estimate.Variance = this->Unseen(true, count, estimate) + lit * lit; // as if they had been drawn
    return;
  }
  this->Draw(point, grid, estimate.Traces);
  this->Add(point, estimate.Share, estimate);
  for (std::size_t g = 0; g < this->Means.size(); ++g)
  {
    estimate.Irradiance[g] = estimate.Share * estimate.Lit[g] + this->Means[g];
  }
  estimate.Mean = this->MeanOf(estimate.Irradiance, estimate);
  const double unseen = estimate.MayMiss ? this->Unseen(this->Drawn.Agree(), grid.Count(), estimate) : 0.0;
  estimate.Variance = this->EdgesOf(grid, estimate) / std::pow(grid.Count(), 1.5) + unseen + lit * lit;
  estimate.StopsShort = grid.Count() >= ShiftedGrid::LargestCount(this->Options.MaximumSamples);
}

double SurfaceLight::Unseen(bool agree, double samples, const SurfaceEstimate& estimate) const
{
  const double unseen = (agree ? unseenSpread : edgeSpread) * estimate.MeanLit / samples;
  return unseen * unseen;
}

int SurfaceLight::SamplesFor(double allowed, const SurfaceEstimate& estimate) const
{
  const int most = ShiftedGrid::LargestCount(this->Options.MaximumSamples);
  if (!(this->Options.RelativeErrorGoal > 0.0) || !(allowed > 0.0))
  {
    return most;
  }
  // What two levels of a rule differ by is there whatever is sampled.
  const double lit = estimate.Share * estimate.LitError;
  const double left = std::max(allowed - lit * lit, 0.25 * allowed);
  const double unseen = estimate.MayMiss ? this->Unseen(estimate.Agrees, unseenExcess, estimate) : 0.0;
  const int fewest = std::min((this->Options.NumberOfSurfaceLightSamples + 1) / 2, most);
  for (int root = 1;; ++root)
  {
    for (const int count : { root * root, root * (root + 1) })
    {
      const double n = count;
      if (count >= most ||
        (count >= fewest && estimate.Edges / (n * std::sqrt(n)) + unseen / (n * n) <= left))
      {
        return std::min(count, most);
      }
    }
  }
}

void SurfaceLight::Draw(const SurfacePoint& point, const ShiftedGrid& grid, bool traces)
{
  Samples& drawn = this->Drawn;
  const int count = grid.Count();
  const auto size = static_cast<std::size_t>(count);
  drawn.Directions.resize(size);
  drawn.Distances.resize(size);
  drawn.Weights.resize(size);
  drawn.Seen.resize(size);
  drawn.NumberOfLit = 0;
  this->Sampler.MoveTo(point.Position);
  for (std::size_t k = 0; k < size; ++k)
  {
    const LightStrata::Point uv = grid.At(static_cast<int>(k));
    const IncidentSample sample = this->Sampler.Sample(uv.U, uv.V);
    drawn.Directions[k] = sample.Direction;
    drawn.Distances[k] = sample.Distance;
    drawn.Weights[k] = std::max(sample.Weight * Dot(sample.Direction, point.Normal), 0.0);
    drawn.Seen[k] = drawn.Weights[k] > 0.0 ? 1 : 0;
    drawn.NumberOfLit += drawn.Seen[k];
  }
  if (traces)
  {
    this->Trace(point);
  }
  drawn.NumberOfSeen = static_cast<int>(std::count(drawn.Seen.begin(), drawn.Seen.end(), char(1)));
}

/// Drop the samples that the mesh hides.
void SurfaceLight::Trace(const SurfacePoint& point)
{
  constexpr std::size_t batch = 64;
  Samples& drawn = this->Drawn;
  const bool infinity = IsAtInfinity(this->Shading.Scene.Light);
  double x[batch] = {};
  double y[batch] = {};
  double z[batch] = {};
  for (std::size_t first = 0; first < drawn.Seen.size(); first += batch)
  {
    const std::size_t size = std::min(drawn.Seen.size() - first, batch);
    std::uint64_t wanted = 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      const Vector3 to = (infinity ? 1.0 : drawn.Distances[first + k]) * drawn.Directions[first + k];
      x[k] = to.X;
      y[k] = to.Y;
      z[k] = to.Z;
      wanted |= static_cast<std::uint64_t>(drawn.Seen[first + k]) << k;
      this->OcclusionRays += drawn.Seen[first + k];
    }
    const std::uint64_t hidden = wanted == 0
      ? 0
      : this->Shading.Scene.ShadowCasters().OccludedFrom(point.Position, x, y, z, wanted, infinity, this->Shading.Rules);
    for (std::size_t k = 0; k < size; ++k)
    {
      drawn.Seen[first + k] = static_cast<char>((wanted & ~hidden) >> k & 1u);
    }
  }
}

/// Set the means per extinction group of what the samples send, less @p share of what they would send were nothing in
/// the way. @return their mean radiance.
double SurfaceLight::Add(const SurfacePoint& point, double share, const SurfaceEstimate& estimate)
{
  Samples& drawn = this->Drawn;
  const auto size = static_cast<double>(drawn.Seen.size());
  drawn.Values.assign(drawn.Seen.size(), 0.0);
  std::fill(this->Means.begin(), this->Means.end(), 0.0);
  for (std::size_t k = 0; k < drawn.Seen.size(); ++k)
  {
    const double part = (static_cast<double>(drawn.Seen[k]) - share) * drawn.Weights[k];
    if (part == 0.0)
    {
      continue;
    }
    const double depth = this->OpticalDepthTo(point, drawn.Directions[k], drawn.Distances[k]);
    for (std::size_t g = 0; g < this->Means.size(); ++g)
    {
      const double value = part * TransmittanceOver(this->Groups.SigmaT[g], depth);
      this->Means[g] += value / size;
      drawn.Values[k] += estimate.Weights[g] * value;
    }
  }
  return this->MeanOf(this->Means, estimate);
}

} // namespace shadowcones
