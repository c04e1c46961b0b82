// SPDX-License-Identifier: BSD-3-Clause
#include "scRayMarcher.h"

#include "scLampPlane.h"

#include <algorithm>
#include <cmath>

namespace shadowcones
{

namespace
{

/// Keys of base nodes are this many bits apart: room for 16 halvings between them.
constexpr int keyBits = 16;

} // namespace

RayMarcher::RayMarcher(const RenderContext& context, const LightLegs* legs)
  : Context(context)
  , Scene(context.Scene)
  , Groups(context.Groups)
  , NumberOfGroups(context.Groups.Count())
  , Sampler(context.Scene.Light, context.Options.Sampling)
  , OpticalDepth(context.Scene.Medium)
  , Legs(legs)
  , Rules(context.Scene.ShadowCasters().RulesFor(FlatFaceOf(context.Scene.Light)))
  , Ends(context.Options.ShareNearEnds)
  , Intensities(static_cast<std::size_t>(context.Strata.Count()))
{
  for (int g = 0; g < this->NumberOfGroups; ++g)
  {
    const auto group = static_cast<std::size_t>(g);
    const double sigmaT = this->Groups.MeanScatteredRadiance[group] > 0.0 ? this->Groups.SigmaT[group] : 0.0;
    this->LargestSigmaT = std::max(this->LargestSigmaT, sigmaT);
  }
}

void RayMarcher::March(const Ray& ray, double tBegin, double tEnd, std::uint64_t pixel)
{
  this->CameraRay = ray;
  this->OpticalDepth.SetRay(ray.Origin, ray.Direction, tBegin, tEnd);
  this->PixelSeed = HashSeed(this->Context.Options.Seed, pixel);
  this->Sums.assign(static_cast<std::size_t>(this->NumberOfGroups), 0.0);
  this->SumOfVariances = 0.0;
  this->SumOfLeaves = 0.0;
  this->SumOfExcess = 0.0;
  this->WorstExcess = 0.0;
  this->WorstOpticalDepth = 0.0;
  this->Samples = 0;
  this->OcclusionRays = 0;

  this->FindIntervals(tBegin, tEnd);
  const std::size_t slots = this->Nodes.size() + static_cast<std::size_t>(this->Context.Options.MaximumHalvings);
  this->Values.resize(slots * static_cast<std::size_t>(this->NumberOfGroups));

  this->EvaluateBaseNodes();
  for (const MarchInterval& interval : this->Intervals)
  {
    this->PendingWeight = 0.0;
    const Node* nodes = this->Nodes.data() + interval.FirstNode;
    for (int step = 0; step < interval.NumberOfSteps; ++step)
    {
      this->Refine(nodes[step], nodes[step + 1], 0);
    }
    this->Add(nodes[interval.NumberOfSteps], this->PendingWeight);
  }
}

double RayMarcher::Variance() const
{
  if (!this->Legs)
  {
    return this->SumOfVariances;
  }
  double mean = 0.0;
  for (std::size_t g = 0; g < this->Sums.size(); ++g)
  {
    mean += this->Groups.MeanScatteredRadiance[g] * this->Sums[g];
  }
  const double ofTable = this->Legs->ErrorOfRays * mean;
  return this->SumOfVariances + ofTable * ofTable;
}

void RayMarcher::FindIntervals(double tBegin, double tEnd)
{
  const ScatteringOptions& options = this->Context.Options;
  this->InCones.clear();
  if (options.Mode != ScatteringMode::BruteForce && this->Scene.Cones)
  {
    this->Scene.Cones->Intersect(this->CameraRay.Origin, this->CameraRay.Direction, tBegin, tEnd, this->InCones);
  }
  if (options.Mode == ScatteringMode::Medium)
  {
    // A node on the very edge of a cone gets its rays, whatever the rounding.
    const double margin = 1e-9 * (tEnd - tBegin);
    for (OccluderInterval& interval : this->InCones)
    {
      interval.Begin -= margin;
      interval.End += margin;
    }
  }

  this->CutAtCones({ tBegin, tEnd });
  this->PlaceNodes();
}

/// Fast marches over what cones leave, the others over everything: in one go, but where samples lie denser near ends.
void RayMarcher::CutAtCones(const RayInterval& whole)
{
  const ScatteringMode mode = this->Context.Options.Mode;
  const bool denser = mode == ScatteringMode::Medium && !this->Ends.IsEven();
  this->Intervals.clear();
  double begin = whole.Begin;
  if (mode == ScatteringMode::Fast || denser)
  {
    for (const OccluderInterval& interval : this->InCones)
    {
      this->AddInterval(whole, begin, std::min(interval.Begin, whole.End), false);
      if (denser)
      {
        this->AddInterval(whole, std::max(begin, interval.Begin), std::min(interval.End, whole.End), true);
      }
      begin = std::max(begin, interval.End);
    }
  }
  this->AddInterval(whole, begin, whole.End, false);
}

void RayMarcher::AddInterval(const RayInterval& whole, double begin, double end, bool inCones)
{
  if (!(end > begin))
  {
    return;
  }
  int steps = this->Context.Options.NumberOfSteps;
  if (begin != whole.Begin || end != whole.End)
  {
    const double longest = (whole.End - whole.Begin) / steps;
    steps = std::max(static_cast<int>(std::ceil((end - begin) / longest)), 1);
  }
  this->Intervals.push_back({ { begin, end }, this->NumberOfNodes(), steps, inCones });
}

std::size_t RayMarcher::NumberOfNodes() const
{
  return this->Intervals.empty()
    ? 0
    : this->Intervals.back().FirstNode + static_cast<std::size_t>(this->Intervals.back().NumberOfSteps) + 1;
}

void RayMarcher::PlaceNodes()
{
  this->Nodes.resize(this->NumberOfNodes());
  for (const MarchInterval& interval : this->Intervals)
  {
    for (int k = 0; k <= interval.NumberOfSteps; ++k)
    {
      const std::size_t index = interval.FirstNode + static_cast<std::size_t>(k);
      const double part = static_cast<double>(k) / interval.NumberOfSteps;
      const double fraction = interval.InCones ? this->Ends.Place(part) : part;
      this->Nodes[index].T =
        k == interval.NumberOfSteps ? interval.End : interval.Begin + fraction * (interval.End - interval.Begin);
      this->Nodes[index].Key = static_cast<std::uint64_t>(index) << keyBits;
      this->Nodes[index].Slot = index;
    }
  }
}

void RayMarcher::EvaluateBaseNodes()
{
  // The ray's largest intensity comes from the base nodes, so that halving does not depend on the order of visits.
  double largest = 0.0;
  for (const MarchInterval& interval : this->Intervals)
  {
    Node* nodes = this->Nodes.data() + interval.FirstNode;
    double densityBefore = 0.0;
    for (int k = 0; k <= interval.NumberOfSteps; ++k)
    {
      const double densityAfter =
        k < interval.NumberOfSteps ? this->OpticalDepth.MeanDensity(nodes[k].T, nodes[k + 1].T) : 0.0;
      const double density = std::max(densityBefore, densityAfter);
      if (density > 0.0) // the others have no weight
      {
        this->Evaluate(nodes[k]);
        largest = std::max(largest, density * nodes[k].Intensity);
      }
      densityBefore = densityAfter;
    }
  }
  this->Threshold = this->Context.Options.IntensityThreshold * largest;
}

bool RayMarcher::NeedsOcclusionRays(double t) const
{
  switch (this->Context.Options.Mode)
  {
    case ScatteringMode::BruteForce:
      return true;
    case ScatteringMode::Fast:
      return false;
    default:
      break;
  }
  const auto after = std::upper_bound(this->InCones.begin(), this->InCones.end(), t,
    [](double value, const OccluderInterval& interval) { return value < interval.Begin; });
  if (after == this->InCones.begin())
  {
    return false;
  }
  const OccluderInterval& interval = *(after - 1);
  // Where intervals are cut at the cones, both parts have a node on the cut; it is outside of the cones by the margin.
  return this->Ends.IsEven() ? t <= interval.End : t > interval.Begin && t < interval.End;
}

void RayMarcher::Evaluate(Node& node)
{
  const ScatteringScene& scene = this->Scene;
  const LightStrata& strata = this->Context.Strata;
  const Vector3 point = this->CameraRay.Origin + node.T * this->CameraRay.Direction;
  const bool testOcclusion = this->NeedsOcclusionRays(node.T);
  const double cameraLeg = this->OpticalDepth.Along(node.T);
  const int groups = this->NumberOfGroups;
  const double* sigmaT = this->Groups.SigmaT.data();
  const double* meanSource = this->Groups.MeanScatteredRadiance.data();
  double* values = this->Values.data() + node.Slot * static_cast<std::size_t>(groups);
  std::fill(values, values + groups, 0.0);

  RandomStream random(this->PixelSeed, node.Key);
  this->Sampler.MoveTo(point);
  if (this->Legs)
  {
    this->Legs->LookAt(point, this->Place);
  }
  const int count = strata.Count();
  for (int s = 0; s < count; ++s)
  {
    const LightStrata::Point uv = strata.Draw(s, random);
    const IncidentSample sample = this->Sampler.Sample(uv.U, uv.V);
    double intensity = 0.0;
    if (sample.Weight > 0.0)
    {
      this->OcclusionRays += testOcclusion ? 1 : 0;
      if (!testOcclusion || !scene.ShadowCasters().Occluded(point, sample.Direction, 0.0, sample.Distance, this->Rules))
      {
        const double cosine = Dot(sample.Direction, this->CameraRay.Direction);
        const double source = sample.Weight * EvaluatePhaseFunction(scene.Medium.Phase, cosine);
        const double lightLeg = this->Legs ? this->Legs->Towards(this->Place, sample.Direction, sample.Distance)
                                           : this->OpticalDepth.Towards(point, sample.Direction, sample.Distance);
        for (int g = 0; g < groups; ++g)
        {
          const double value = source * TransmittanceOver(sigmaT[g], cameraLeg + lightLeg);
          values[g] += value;
          intensity += meanSource[g] * value;
        }
      }
    }
    this->Intensities[static_cast<std::size_t>(s)] = intensity;
  }
  node.Intensity = 0.0;
  for (int g = 0; g < groups; ++g)
  {
    values[g] /= count;
    node.Intensity += meanSource[g] * values[g];
  }
  node.Variance = strata.VarianceOfMean(this->Intensities.data());
  this->Samples += count;
}

void RayMarcher::Refine(const Node& a, const Node& b, int depth)
{
  // The density enters by its integral: a layer thinner than a step counts in full.
  const double density = this->OpticalDepth.MeanDensity(a.T, b.T);
  if (depth < this->Context.Options.MaximumHalvings && density * std::fabs(a.Intensity - b.Intensity) > this->Threshold)
  {
    Node middle;
    middle.T = 0.5 * (a.T + b.T);
    middle.Key = (a.Key + b.Key) / 2;
    middle.Slot = this->Nodes.size() + static_cast<std::size_t>(depth);
    this->Evaluate(middle);
    this->Refine(a, middle, depth + 1);
    this->Refine(middle, b, depth + 1);
    return;
  }
  // A leaf: leaves come from left to right, so the weight of a is complete now.
  this->RateStep(a, b, density);
  const double half = 0.5 * (b.T - a.T) * density;
  this->Add(a, this->PendingWeight + half);
  this->PendingWeight = half;
}

void RayMarcher::RateStep(const Node& a, const Node& b, double density)
{
  const double light = 0.5 * (b.T - a.T) * density * (a.Intensity + b.Intensity);
  const double depth = this->LargestSigmaT * density * (b.T - a.T);
  const double excess = depth > 1e-3 ? light * (1.0 - std::tanh(depth) / depth) : 0.0;
  this->SumOfLeaves += light;
  this->SumOfExcess += excess;
  if (excess > this->WorstExcess)
  {
    this->WorstExcess = excess;
    this->WorstOpticalDepth = depth;
  }
}

void RayMarcher::Add(const Node& node, double weight)
{
  const double* values = this->Values.data() + node.Slot * static_cast<std::size_t>(this->NumberOfGroups);
  for (int g = 0; g < this->NumberOfGroups; ++g)
  {
    this->Sums[static_cast<std::size_t>(g)] += weight * values[g];
  }
  this->SumOfVariances += weight * weight * node.Variance;
}

} // namespace shadowcones
