// SPDX-License-Identifier: BSD-3-Clause
#include "scBlockedLight.h"

#include "scRandom.h"

#include "scLampPlane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadowcones
{
namespace
{
/// Samples of a first look at a pixel.
constexpr int fewestSamples = 8;
constexpr int mostFirstSamples = 32;
/// More samples than the first look asks for, so that they seldom fall short.
constexpr double safety = 1.2;
/// Where samples are this many times as wrong as wanted more of them are taken.
constexpr double farOff = 1.5;
/// The error of n samples is about this share of the light in the intervals, over n^(3/4), where nothing is known yet.
constexpr double expectedSpread = 0.3;
/// An edge of the shadow may lie anywhere in the part of one sample: 1 / sqrt(12), once.
constexpr double edgeSpread = 0.29;
/// Where all samples say the same, or those that do not are single ones, a thin shadow or beam may have slipped between a
/// few of them.
constexpr double unseenSpread = 0.7;
/// Which is as much as this above what is wanted where nothing else is wrong.
constexpr double unseenExcess = 1.4;

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

BlockedLight::BlockedLight(const RenderContext& context, const LightLegs* legs)
  : Scene(context.Scene)
  , Options(context.Options)
  , Groups(context.Groups)
  , Sampler(context.Scene.Light, context.Options.Sampling)
  , OpticalDepth(context.Scene.Medium)
  , Legs(legs)
  , Rules(context.Scene.ShadowCasters().RulesFor(FlatFaceOf(context.Scene.Light)))
  , Ends(context.Options.ShareNearEnds)
  , Intervals(context.Groups)
  , Ratio(context.Groups)
{
  Sequence();
}

bool BlockedLight::Begin(const LitSums& lit, const std::vector<RayInterval>& intervals)
{
  this->Samples = 0;
  this->OcclusionRays = 0;
  this->Forget();
  if (!this->Intervals.Set(lit, intervals))
  {
    return false;
  }
  const LitPixel& pixel = lit.Profile();
  this->OpticalDepth.SetRay(pixel.Line.Origin, pixel.Line.Direction, pixel.Interval.MediumBegin, pixel.Interval.End);
  return true;
}

void BlockedLight::Forget()
{
  this->Passes.clear();
  this->SumOfWeights = 0.0;
  this->Ratio.Forget();
}

void BlockedLight::EstimateFrom(
  int count, const LitSums& lit, const std::vector<RayInterval>& intervals, std::uint64_t seed)
{
  if (this->Begin(lit, intervals))
  {
    this->Sample(lit, count, HashSeed(seed, 0));
  }
  this->Conclude(0.0);
}

void BlockedLight::Look(
  const LitSums& lit, const std::vector<RayInterval>& intervals, const Yardstick& yardstick, std::uint64_t seed)
{
  this->Lit = &lit;
  this->Measure = yardstick;
  this->Seed = seed;
  this->Wanted = 0.0;
  const double goal = this->Options.RelativeErrorGoal;
  if (!this->Begin(lit, intervals))
  {
    this->Conclude(yardstick.LitError);
    return;
  }
  const int most = std::max(this->Options.MaximumSamples, 1);
  if (!(goal > 0.0))
  {
    this->Ratio.LeaveAll(this->Intervals);
    this->Wanted = most;
    return;
  }
  const double largest = std::max({ lit.Mean(), this->Intervals.MeanInside(), yardstick.Darkest });
  const double inside = largest > 0.0 ? this->Intervals.MeanInside() / largest : 0.0; // light of none in an image of none
  const double first = std::ceil(std::pow(expectedSpread * inside / goal, 4.0 / 3.0));
  const double count = std::clamp<double>(first, fewestSamples, mostFirstSamples);
  this->Sample(lit, static_cast<int>(std::min<double>(count, most)), HashSeed(seed, 0));
  this->Conclude(yardstick.LitError);
  this->Wanted = std::max<double>(std::ceil(this->SamplesFor(this->Allowed())), fewestSamples);
}

double BlockedLight::Allowed() const
{
  // Where the unshadowed light is too wrong already, shadows need not be much better.
  const double wanted = this->Options.RelativeErrorGoal * std::max(this->Ratio.MeanLeft(), this->Measure.Darkest);
  return std::max(wanted * wanted - (this->SquaredError - this->SampledVariance), 0.25 * wanted * wanted);
}

void BlockedLight::Estimate(int most)
{
  if (!(this->Wanted > 0.0))
  {
    return;
  }
  most = std::min(most, std::max(this->Options.MaximumSamples, 1));
  const LitSums& lit = *this->Lit;
  if (most - this->Samples > this->Samples)
  {
    this->Forget(); // unless nearly all that may be taken went into the look
  }
  for (std::uint64_t pass = 1; this->Samples < most; ++pass)
  {
    this->Sample(
      lit, static_cast<int>(std::min<double>(this->Wanted, most - this->Samples)), HashSeed(this->Seed, pass));
    this->Conclude(this->Measure.LitError);
    const double allowed = this->Allowed();
    if (this->SampledVariance <= farOff * farOff * allowed)
    {
      return;
    }
    // As many as give all passes together the variance that is allowed.
    const double enough = this->SamplesFor(allowed / (1.0 - allowed / this->SampledVariance));
    this->Wanted = std::max<double>(std::ceil(enough), fewestSamples);
  }
}

BlockedLight::PassError BlockedLight::ErrorOf(const Pass& pass) const
{
  const double inside = this->Intervals.MeanInside();
  const double perAll = this->Ratio.PerAll();
  const double unit = perAll > 0.0 ? inside / (perAll * pass.Count) : 0.0;
  const SampleColumns::Error error =
    SampleColumns::ErrorOf(pass.Differences, pass.Count, this->Ratio.Ratio(), unit);
  const bool alike = pass.NumberOfVisible == 0 || pass.NumberOfVisible == pass.NumberOfLit;
  const double share = alike ? 1.0 : error.Roughness;
  const double unseen = inside / pass.Count;
  return { error.Variance * perAll * perAll,
    (share * unseenSpread * unseenSpread + (1.0 - share) * edgeSpread * edgeSpread) * unseen * unseen };
}

double BlockedLight::SamplesFor(double variance) const
{
  if (!(variance > 0.0))
  {
    return HUGE_VAL;
  }
  // Of n samples: edges / n^(3/2) + unseen / n^2, where nobody knows the first well.
  double edges = 0.0;
  double unseenSquared = 0.0;
  double weights = 0.0;
  for (const Pass& pass : this->Passes)
  {
    const double count = pass.Count;
    const PassError error = this->ErrorOf(pass);
    edges += error.Edges * pass.Weight * count;
    unseenSquared += error.Unseen * count * count * count;
    weights += count;
  }
  edges *= safety * std::sqrt(safety) / weights;
  const double unseen = std::sqrt(unseenSquared / weights) / unseenExcess;
  // From the larger of the two alone, by Newton's method in the logarithm.
  double n = std::max(std::pow(edges / variance, 2.0 / 3.0), unseen / std::sqrt(variance));
  for (int step = 0; step < 3 && n > 0.0 && n < 1e12; ++step)
  {
    const double a = edges / (n * std::sqrt(n));
    const double b = unseen * unseen / (n * n);
    n *= std::exp(std::log((a + b) / variance) * (a + b) / (1.5 * a + 2.0 * b));
  }
  return n;
}

void BlockedLight::Conclude(double litError)
{
  this->Ratio.Conclude(this->Intervals, this->SumOfWeights);
  this->SampledVariance = 0.0;
  for (const Pass& pass : this->Passes)
  {
    const double weight = pass.Weight / this->SumOfWeights;
    const PassError error = this->ErrorOf(pass);
    this->SampledVariance += weight * weight * (error.Edges + error.Unseen);
  }
  this->SquaredError = this->Ratio.SquaredError(
    this->Intervals, this->SampledVariance, litError, this->Legs ? this->Legs->ErrorOfLegs : 0.0);
}

/// Samples that are taken together: what of them has a ray, several at a time.
struct BlockedLight::Packet
{
  struct Place
  {
    double T = 0.0;
    double Density = 1.0; ///< of places here, over that of the intervals' light
    int Cell = 0;
    int Ray = -1; ///< -1: none
    double Weight = 0.0;
    std::uint32_t U = 0; ///< of the light point
    std::uint32_t V = 0;
  };
  int Count = 0;
  int Rays = 0;
  std::array<Place, OccluderScene::PacketSize> Places;
  std::array<Vector3, OccluderScene::PacketSize> Points; ///< of rays
  std::array<Vector3, OccluderScene::PacketSize> Directions;
  std::array<double, OccluderScene::PacketSize> Distances;
};

/// Where the drawing of places and light points is.
struct BlockedLight::Draws
{
  RandomStream Random;
  std::uint32_t ScrambleU = 0;
  std::uint32_t ScrambleV = 0;
  IntervalLight::Node Node{};
};

/// Samples from number @p first of @p count on.
void BlockedLight::Draw(const LitSums& lit, int first, int count, Draws& draws, Packet& packet)
{
  const Ray& ray = lit.Profile().Line;
  const LightSequence& sequence = Sequence();
  packet.Count = std::min(OccluderScene::PacketSize, count - first);
  packet.Rays = 0;
  for (int k = first; k < first + packet.Count; ++k)
  {
    const std::uint32_t index = static_cast<std::uint32_t>(k) % LightSequence::Count;
    if (index == 0)
    {
      const std::uint64_t scramble = draws.Random.NextWord();
      draws.ScrambleU = static_cast<std::uint32_t>(scramble >> 32);
      draws.ScrambleV = static_cast<std::uint32_t>(scramble);
    }
    double density = 1.0;
    const double t = this->Intervals.MoveTo(
      (k + draws.Random.Next()) / count * this->Intervals.Distributed(), this->Ends, draws.Node, density);
    const Vector3 point = ray.Origin + t * ray.Direction;
    this->Sampler.MoveTo(point);
    const std::uint32_t u = sequence.U[index] ^ draws.ScrambleU;
    const std::uint32_t v = sequence.V[index] ^ draws.ScrambleV;
    const IncidentSample sample = this->Sampler.Sample(u * 0x1p-32, v * 0x1p-32);
    const bool sent = sample.Weight > 0.0 && lit.Of(draws.Node.Cell) > 0.0;
    packet.Places[static_cast<std::size_t>(k - first)] = { t, density, draws.Node.Cell, sent ? packet.Rays : -1,
      sample.Weight, u, v };
    if (sent)
    {
      const auto at = static_cast<std::size_t>(packet.Rays++);
      packet.Points[at] = point;
      packet.Directions[at] = sample.Direction;
      packet.Distances[at] = sample.Distance;
    }
  }
}

/// What the samples show. @param spacing light of the intervals for each of them.
void BlockedLight::Add(const LitSums& lit, Packet& packet, double spacing, Pass& pass)
{
  const int groups = this->Groups.Count();
  const Vector3& along = lit.Profile().Line.Direction;
  const unsigned int occluded = packet.Rays == 0
    ? 0
    : this->Scene.ShadowCasters().OccludedPacket(
        packet.Points.data(), packet.Directions.data(), packet.Distances.data(), packet.Rays, this->Rules);
  this->OcclusionRays += packet.Rays;
  for (int k = 0; k < packet.Count; ++k)
  {
    const Packet::Place& place = packet.Places[static_cast<std::size_t>(k)];
    double all = 0.0;
    double visible = 0.0;
    if (place.Ray >= 0)
    {
      const auto at = static_cast<std::size_t>(place.Ray);
      const bool blocked = ((occluded >> place.Ray) & 1u) != 0;
      const Vector3& point = packet.Points[at];
      const Vector3& direction = packet.Directions[at];
      const double source = place.Weight * this->OpticalDepth.DensityAt(point) *
        EvaluatePhaseFunction(this->Scene.Medium.Phase, Dot(direction, along));
      const double depth = this->OpticalDepth.Along(place.T) +
        DepthTowards(this->Legs, this->OpticalDepth, point, direction, packet.Distances[at]);
      // Over the density of places: the light in the cell per its width, over all of the intervals' light.
      const double weight = spacing * lit.Width(place.Cell) / lit.Of(place.Cell) / place.Density;
      for (int g = 0; g < groups; ++g)
      {
        const auto group = static_cast<std::size_t>(g);
        const double part = weight * source * TransmittanceOver(this->Groups.SigmaT[group], depth);
        this->Ratio.Add(group, pass.Weight * part, blocked ? 0.0 : pass.Weight * part);
        all += this->Groups.MeanScatteredRadiance[group] * part;
      }
      visible = blocked ? 0.0 : all;
      pass.NumberOfLit += 1;
      pass.NumberOfVisible += blocked ? 0 : 1;
    }
    this->Columns.Add(all, visible, place.U, place.V);
  }
}

void BlockedLight::Sample(const LitSums& lit, int count, std::uint64_t seed)
{
  Pass pass;
  pass.Count = count;
  pass.Weight = count * std::sqrt(static_cast<double>(count));
  Draws draws{ RandomStream(seed, 0) };
  Packet packet;
  this->Columns.Begin(count);
  for (int first = 0; first < count; first += OccluderScene::PacketSize)
  {
    this->Draw(lit, first, count, draws, packet);
    this->Add(lit, packet, this->Intervals.Distributed() / count, pass);
  }
  pass.Differences = this->Columns.Sums();
  this->Samples += count;
  this->Passes.push_back(pass);
  this->SumOfWeights += pass.Weight;
}

} // namespace shadowcones
