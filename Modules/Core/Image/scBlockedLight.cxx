// SPDX-License-Identifier: BSD-3-Clause
#include "scBlockedLight.h"

#include "scRandom.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{
namespace
{
constexpr int cells = LitProfileLayout::Cells;
/// Samples of a first look at a pixel.
constexpr int fewestSamples = 8;
constexpr int mostFirstSamples = 32;
/// More samples than the first look asks for, so that they seldom fall short.
constexpr double safety = 1.5;
/// Samples that are this many times as wrong as wanted are taken anew, and more of them.
constexpr double farOff = 1.5;
/// The error of n samples is about this share of the light in the stretches, over n^(3/4), where nothing is known yet.
constexpr double expectedSpread = 0.3;
/// An edge of the shadow may lie anywhere in the part of one sample: 1 / sqrt(12), once.
constexpr double unseenSpread = 0.29;

/// The first two dimensions of the Sobol sequence: any run of 2^k points has one in every 2^-k part of the square.
struct LightSequence
{
  static constexpr std::uint32_t Count = 4096;
  std::uint32_t U[Count];
  std::uint32_t V[Count];
  LightSequence()
  {
    constexpr SobolDirections directions;
    for (std::uint32_t k = 0; k < Count; ++k)
    {
      this->U[k] = ReverseBits32(k);
      this->V[k] = 0;
      for (int bit = 0; bit < 32; ++bit)
      {
        this->V[k] ^= (k >> bit) & 1u ? directions.Values[0][bit] : 0u;
      }
    }
  }
};

const LightSequence& Sequence()
{
  static const LightSequence sequence;
  return sequence;
}
} // anonymous namespace

BlockedLight::BlockedLight(
  const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups)
  : Scene(scene)
  , Options(options)
  , Groups(groups)
  , Sampler(scene.Source, options.Sampling)
  , Depth(scene.Fog)
{
  Sequence();
}

void BlockedLight::Estimate(const LitSums& lit, double litError, const std::vector<RayInterval>& stretches,
  double darkest, std::uint64_t seed)
{
  this->Sums.assign(static_cast<std::size_t>(this->Groups.Count()), 0.0);
  this->SquaredError = 0.0;
  this->Samples = 0;
  this->OcclusionRays = 0;
  this->Stretches.clear();
  const double all = lit.SumUpTo(lit.End());
  double light = 0.0;
  for (const RayInterval& stretch : stretches)
  {
    const double begin = std::min(lit.SumUpTo(lit.PlaceOf(stretch.Begin)), all);
    const double end = std::min(lit.SumUpTo(lit.PlaceOf(stretch.End)), all);
    if (end > begin)
    {
      this->Stretches.push_back({ begin, end - begin, light });
      light += end - begin;
    }
  }
  if (!(light > 0.0))
  {
    return;
  }
  const LitPixel& pixel = lit.Source();
  this->Depth.SetRay(pixel.Line.Origin, pixel.Line.Direction, pixel.Span.MediumBegin, pixel.Span.End);

  const double goal = this->Options.RelativeErrorGoal;
  const int most = std::max(this->Options.MaximumSamples, 1);
  if (!(goal > 0.0))
  {
    this->Sample(lit, light, most, HashSeed(seed, 0));
    return;
  }
  const double first = std::ceil(std::pow(expectedSpread * light / (goal * std::max(all, darkest)), 4.0 / 3.0));
  int count = std::min(most, static_cast<int>(std::clamp<double>(first, fewestSamples, mostFirstSamples)));
  for (std::uint64_t pass = 0; this->Samples < most; ++pass)
  {
    this->Sample(lit, light, count, HashSeed(seed, pass));
    double mean = all;
    for (int g = 0; g < this->Groups.Count(); ++g)
    {
      mean -= this->Groups.MeanSource[static_cast<std::size_t>(g)] * this->Sums[static_cast<std::size_t>(g)];
    }
    const double wanted = goal * std::max(mean, darkest);
    const double left = wanted * wanted - litError * litError;
    if (pass > 0 && this->SquaredError <= farOff * farOff * left)
    {
      return;
    }
    const double factor = left > 0.0 ? std::pow(this->SquaredError / left, 2.0 / 3.0) : HUGE_VAL;
    count = static_cast<int>(std::min<double>(std::max<double>(safety * factor * count, fewestSamples),
      std::max(most - this->Samples, 1)));
  }
}

void BlockedLight::Sample(const LitSums& lit, double light, int count, std::uint64_t seed)
{
  const Ray& ray = lit.Source().Line;
  const int groups = this->Groups.Count();
  const OccluderScene& occluders = this->Scene.Occluders;
  const double epsilon = occluders.Epsilon();
  const LightSequence& sequence = Sequence();
  std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
  RandomStream random(seed, 0);
  const std::uint64_t scramble = random.NextWord();
  const auto scrambleU = static_cast<std::uint32_t>(scramble >> 32);
  const auto scrambleV = static_cast<std::uint32_t>(scramble);

  std::size_t stretch = 0;
  int cell = 0;
  double before = 0.0;
  double squares = 0.0;
  for (int k = 0; k < count; ++k)
  {
    // Places ascend: stretch and cell are searched onwards from the last ones.
    const double wanted = (k + random.Next()) / count * light;
    while (stretch + 1 < this->Stretches.size() && wanted >= this->Stretches[stretch + 1].Before)
    {
      ++stretch;
    }
    const double target = this->Stretches[stretch].Begin + (wanted - this->Stretches[stretch].Before);
    while (cell + 1 < cells && target >= lit.SumUpTo({ cell, 1.0 }))
    {
      ++cell;
    }
    const double inCell = lit.Of(cell);
    const double share = inCell > 0.0 ? std::clamp((target - lit.SumUpTo({ cell, 0.0 })) / inCell, 0.0, 1.0) : 0.5;
    const double t = lit.DistanceOf({ cell, share });
    const Vector3 point = ray.Origin + t * ray.Direction;

    const std::uint32_t index = static_cast<std::uint32_t>(k) % LightSequence::Count;
    this->Sampler.MoveTo(point);
    const IncidentSample sample =
      this->Sampler.Sample((sequence.U[index] ^ scrambleU) * 0x1p-32, (sequence.V[index] ^ scrambleV) * 0x1p-32);
    double value = 0.0;
    if (sample.Weight > 0.0)
    {
      this->OcclusionRays += 1;
      if (occluders.Occluded(point, sample.Direction, epsilon, sample.Distance - epsilon))
      {
        const double source = sample.Weight * this->Depth.DensityAt(point) *
          EvaluatePhaseFunction(this->Scene.Fog.Phase, Dot(sample.Direction, ray.Direction));
        const double depth = this->Depth.Along(t) + this->Depth.Towards(point, sample.Direction, sample.Distance);
        // Over the density of places: the light in the cell per its width, over all of the stretches' light.
        const double weight = light * lit.Width(cell) / inCell / count;
        for (int g = 0; g < groups; ++g)
        {
          const auto group = static_cast<std::size_t>(g);
          const double part = weight * source * TransmittanceOver(this->Groups.SigmaT[group], depth);
          this->Sums[group] += part;
          value += this->Groups.MeanSource[group] * part;
        }
      }
    }
    if (k > 0)
    {
      squares += (value - before) * (value - before);
    }
    before = value;
  }
  this->Samples += count;
  const double unseen = unseenSpread * light / count;
  this->SquaredError = unseen * unseen;
  if (count > 1)
  {
    // Neighbours differ by the light point and by the place: this rates the sum as if light points were independent.
    this->SquaredError += 0.5 * squares * count / (count - 1);
  }
}

} // namespace shadowcones
