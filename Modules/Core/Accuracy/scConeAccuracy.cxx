// SPDX-License-Identifier: BSD-3-Clause
#include "scConeAccuracy.h"

#include "scConeIntervals.h"
#include "scConeTree.h"
#include "scLampPlane.h"
#include "scRandom.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>

namespace shadowcones
{
namespace
{

/// The normal distribution holds 95 % within as many standard deviations.
constexpr double z95 = 1.959963984540054;
/// Streams of random numbers that must not be alike.
constexpr std::uint64_t lightPointStream = 0x4C50;
constexpr std::uint64_t rotationStream = 0x524F;

Estimate WilsonInterval(double share, double samples)
{
  const double z2 = z95 * z95 / samples;
  const double center = (share + 0.5 * z2) / (1.0 + z2);
  const double half =
    std::sqrt(std::max(0.0, share * (1.0 - share) / samples + 0.25 * z2 / samples)) * z95 / (1.0 + z2);
  // Rounding must not put the value outside.
  return { share, std::clamp(center - half, 0.0, share), std::clamp(center + half, share, 1.0) };
}

/// Squared standard error of the ratio estimate.
double RatioVariance(const RatioSums& sums, double ratio)
{
  const double squares = static_cast<double>(sums.YY) - 2.0 * ratio * static_cast<double>(sums.XY) +
    ratio * ratio * static_cast<double>(sums.XX);
  const double whole = static_cast<double>(sums.X);
  return std::max(0.0, squares) / (whole * whole);
}

/// The occluders seen from one sample point.
class BlockerCounts
{
public:
  void Clear() { this->Counts.clear(); }
  void Add(int occluderId, double distance)
  {
    for (Count& count : this->Counts)
    {
      if (count.OccluderId == occluderId)
      {
        ++count.Rays;
        count.Distance += distance;
        return;
      }
    }
    this->Counts.push_back({ occluderId, 1, distance });
  }
  void Write(SampleTruth& truth) const
  {
    const Count* most = nullptr;
    for (const Count& count : this->Counts)
    {
      if (!most || count.Rays > most->Rays || (count.Rays == most->Rays && count.OccluderId < most->OccluderId))
      {
        most = &count;
      }
    }
    if (most)
    {
      truth.OccluderId = most->OccluderId;
      truth.OccluderDistance = most->Distance / most->Rays;
    }
  }

private:
  struct Count
  {
    int OccluderId;
    int Rays;
    double Distance;
  };
  std::vector<Count> Counts;
};

struct AtomicConeTally
{
  std::atomic<std::int64_t> Samples{ 0 };
  std::atomic<std::int64_t> Shadowed{ 0 };
  std::atomic<std::int64_t> Lit{ 0 };
};

} // anonymous namespace

bool DrawSamplePoints(
  const Box& bounds, vtkIdType count, std::uint64_t seed, const Monitor& monitor, std::vector<Vector3>& points)
{
  points.assign(bounds.Empty() ? 0 : static_cast<std::size_t>(count), {});
  const Vector3 size = bounds.Size();
  return ParallelFor(static_cast<vtkIdType>(points.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        const std::array<double, 4> u = SobolPoint(seed, static_cast<std::uint32_t>(k));
        points[k] = bounds.Min + Vector3{ u[0] * size.X, u[1] * size.Y, u[2] * size.Z };
      }
    });
}

bool MeasureTruth(const std::vector<Vector3>& points, const OccluderScene& scene, const Light& light, int lightSamples,
  std::uint64_t seed, const Monitor& monitor, std::vector<SampleTruth>& truth)
{
  std::vector<std::array<double, 4>> pattern;
  for (int s = 0; s < lightSamples; ++s)
  {
    pattern.push_back(SobolPoint(HashSeed(seed, lightPointStream), static_cast<std::uint32_t>(s)));
  }
  const auto wrap = [](double x) { return x < 1.0 ? x : x - 1.0; };
  truth.assign(points.size(), {});
  const RayRules rules = scene.RulesFor(FlatFaceOf(light));
  return ParallelFor(static_cast<vtkIdType>(points.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      BlockerCounts blockers;
      RayHit hit;
      for (vtkIdType k = begin; k < end; ++k)
      {
        RandomStream random(HashSeed(seed, rotationStream), static_cast<std::uint64_t>(k));
        const double shiftU = random.Next();
        const double shiftV = random.Next();
        blockers.Clear();
        for (const auto& p : pattern)
        {
          const IncidentSample sample = SampleVisibleLight(light, points[k], wrap(p[0] + shiftU), wrap(p[1] + shiftV));
          if (!(sample.Weight > 0.0))
          {
            continue;
          }
          ++truth[k].Emitting;
          if (scene.Intersect(points[k], sample.Direction, 0.0, sample.Distance, hit, rules))
          {
            ++truth[k].Blocked;
            blockers.Add(scene.Mesh().OccluderId(hit.Triangle), hit.T);
          }
        }
        blockers.Write(truth[k]);
      }
    });
}

bool MeasureTruth(const std::vector<Vector3>& points, const OccluderScene& scene, const std::vector<Light>& lights,
  int lightSamples, std::uint64_t seed, const Monitor& monitor, std::vector<SampleTruth>& truth)
{
  truth.clear();
  std::vector<SampleTruth> ofLight;
  const auto count = static_cast<double>(lights.size());
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    const auto done = static_cast<double>(k);
    if (!MeasureTruth(points, scene, lights[k], lightSamples, seed, monitor.Part(done / count, (done + 1.0) / count),
          ofLight))
    {
      return false;
    }
    truth.insert(truth.end(), ofLight.begin(), ofLight.end());
  }
  return true;
}

Estimate EstimateProportion(std::int64_t part, std::int64_t whole)
{
  return whole > 0 ? WilsonInterval(static_cast<double>(part) / static_cast<double>(whole), static_cast<double>(whole))
                   : Estimate{};
}

Estimate EstimateShare(const RatioSums& sums)
{
  if (sums.X <= 0)
  {
    return {};
  }
  const double whole = static_cast<double>(sums.X);
  const double share = static_cast<double>(sums.Y) / whole;
  const double variance = RatioVariance(sums, share);
  const bool spread = sums.Y > 0 && sums.Y < sums.X && variance > 0.0;
  return WilsonInterval(
    share, spread ? share * (1.0 - share) / variance : whole * whole / static_cast<double>(sums.XX));
}

Estimate EstimateRatio(const RatioSums& sums)
{
  if (sums.X <= 0)
  {
    return {};
  }
  const double ratio = static_cast<double>(sums.Y) / static_cast<double>(sums.X);
  const double half = z95 * std::sqrt(RatioVariance(sums, ratio));
  return { ratio, std::max(0.0, ratio - half), ratio + half };
}

void AccuracyTally::Add(const SampleTruth& truth, const SamplePrediction& prediction)
{
  if (truth.Emitting == 0)
  {
    return;
  }
  const bool inside = prediction.Inside();
  const bool shadowed = truth.Shadowed();
  const bool umbra = truth.Umbra();
  const bool predictedUmbra = prediction.Class == 2;
  this->TrueNegatives += !shadowed && !inside;
  this->TruePositives += shadowed && inside;
  this->FalsePositives += !shadowed && inside;
  this->FalseNegatives += shadowed && !inside;
  this->Umbra += umbra;
  this->PredictedUmbra += predictedUmbra;
  this->BothUmbra += umbra && predictedUmbra;
  this->BlockedOutside.Add(inside ? 0 : truth.Blocked, truth.Blocked);
  this->LitInside.Add(inside ? truth.Lit() : 0, truth.Lit());
  this->BlockedInside.Add(inside ? truth.Blocked : 0, inside ? truth.Emitting : 0);
  this->Volume.Add(inside, shadowed);
}

Estimate AccuracyTally::Lost(const AccuracyTally& all) const
{
  // Of this tally's samples y is what they are, of all others 0.
  RatioSums sums = this->LitInside;
  sums.X = all.LitInside.X;
  sums.XX = all.LitInside.XX;
  return EstimateShare(sums);
}

Estimate AccuracyTally::VolumeError() const
{
  const Estimate ratio = EstimateRatio(this->Volume);
  return this->Volume.X > 0 ? Estimate{ ratio.Value - 1.0, ratio.Low - 1.0, ratio.High - 1.0 }
                            : Estimate{ ratio.Value, -1.0, std::numeric_limits<double>::infinity() };
}

bool ClassifyByCones(const std::vector<Vector3>& points, const std::vector<SampleTruth>& truth,
  const std::vector<Cone>& cones, const Monitor& monitor, std::vector<SamplePrediction>& predictions,
  std::vector<ConeTally>& tallies)
{
  predictions.assign(points.size(), {});
  tallies.assign(cones.size(), {});
  Box bounds;
  for (const Vector3& point : points)
  {
    bounds.Add(point);
  }
  if (bounds.Empty() || cones.empty())
  {
    return !monitor.IsAborted();
  }

  const ConeTree tree = ConeTree::OverSlices(cones, bounds, HUGE_VAL);
  std::vector<AtomicConeTally> counts(cones.size());
  constexpr auto relaxed = std::memory_order_relaxed;
  const bool done = ParallelFor(static_cast<vtkIdType>(points.size()), monitor,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> holders;
      for (vtkIdType k = begin; k < end; ++k)
      {
        holders.clear();
        tree.ForEachAtPoint(points[k],
          [&](const ConeTree::Entry& entry)
          {
            if (ConeContains(cones[entry.Cone], points[k], entry.High))
            {
              holders.push_back(entry.Cone);
            }
          });
        if (holders.empty())
        {
          continue;
        }
        // A cone may be met once for each of its slices.
        std::sort(holders.begin(), holders.end());
        holders.erase(std::unique(holders.begin(), holders.end()), holders.end());
        SamplePrediction& prediction = predictions[k];
        prediction.Class = 1;
        prediction.ConeId = holders.front();
        prediction.Height = Dot(points[k] - cones[holders.front()].Center, cones[holders.front()].Axis);
        for (const int cone : holders)
        {
          Cone inner = cones[cone];
          inner.HalfAngle = inner.InnerHalfAngle;
          if (prediction.Class < 2 && ConeContains(inner, points[k]))
          {
            prediction.Class = 2;
          }
          if (truth[k].Emitting > 0)
          {
            counts[cone].Samples.fetch_add(1, relaxed);
            counts[cone].Shadowed.fetch_add(truth[k].Shadowed(), relaxed);
            counts[cone].Lit.fetch_add(truth[k].Lit(), relaxed);
          }
        }
      }
    });
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    tallies[i] = { counts[i].Samples.load(), counts[i].Shadowed.load(), counts[i].Lit.load() };
  }
  return done;
}

bool ClassifyByCones(std::size_t lights, const std::vector<Vector3>& points, const std::vector<SampleTruth>& truth,
  const std::vector<Cone>& cones, const Monitor& monitor, std::vector<SamplePrediction>& predictions,
  std::vector<ConeTally>& tallies)
{
  predictions.clear();
  tallies.assign(cones.size(), {});
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, lights);
  std::vector<std::vector<int>> indices(lights); // in cones
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    if (cones[i].LightId >= 0 && static_cast<std::size_t>(cones[i].LightId) < lights)
    {
      indices[static_cast<std::size_t>(cones[i].LightId)].push_back(static_cast<int>(i));
    }
  }
  const auto count = static_cast<double>(lights);
  for (std::size_t light = 0; light < lights; ++light)
  {
    const auto first = truth.begin() + static_cast<std::ptrdiff_t>(light * points.size());
    const std::vector<SampleTruth> part(first, first + static_cast<std::ptrdiff_t>(points.size()));
    std::vector<SamplePrediction> predicted;
    std::vector<ConeTally> counted;
    const auto done = static_cast<double>(light);
    if (!ClassifyByCones(points, part, conesOf[light], monitor.Part(done / count, (done + 1.0) / count), predicted,
          counted))
    {
      return false;
    }
    for (SamplePrediction& prediction : predicted)
    {
      if (prediction.ConeId >= 0)
      {
        prediction.ConeId = indices[light][static_cast<std::size_t>(prediction.ConeId)];
      }
    }
    predictions.insert(predictions.end(), predicted.begin(), predicted.end());
    for (std::size_t i = 0; i < counted.size(); ++i)
    {
      tallies[static_cast<std::size_t>(indices[light][i])] = counted[i];
    }
  }
  return true;
}

int CountedOccluder(const SampleTruth& truth, const SamplePrediction& prediction, const std::vector<Cone>& cones)
{
  if (truth.Shadowed())
  {
    return truth.OccluderId;
  }
  return prediction.ConeId >= 0 ? cones[prediction.ConeId].OccluderId : -1;
}

double CountedDepth(const SampleTruth& truth, const SamplePrediction& prediction)
{
  if (prediction.ConeId >= 0)
  {
    return prediction.Height;
  }
  return truth.Shadowed() ? truth.OccluderDistance : -1.0;
}

AccuracyReport TallyAccuracy(const std::vector<SampleTruth>& truth, const std::vector<SamplePrediction>& predictions,
  const std::vector<Cone>& cones, int depthBins)
{
  AccuracyReport report;
  double largest = 0.0;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    largest = std::max(largest, truth[k].Emitting > 0 ? CountedDepth(truth[k], predictions[k]) : 0.0);
  }
  report.Depths.resize(static_cast<std::size_t>(depthBins));
  for (int bin = 0; bin < depthBins; ++bin)
  {
    report.Depths[bin].Low = largest * bin / depthBins;
    report.Depths[bin].High = largest * (bin + 1) / depthBins;
  }

  std::map<int, OccluderTally> occluders;
  for (std::size_t k = 0; k < truth.size(); ++k)
  {
    report.All.Add(truth[k], predictions[k]);
    if (truth[k].Shadowed() || predictions[k].Inside())
    {
      OccluderTally& occluder = occluders[CountedOccluder(truth[k], predictions[k], cones)];
      occluder.Add(truth[k], predictions[k]);
    }
    const double depth = CountedDepth(truth[k], predictions[k]);
    if (depth >= 0.0 && depthBins > 0)
    {
      const double bin = largest > 0.0 ? depth / largest * depthBins : 0.0;
      report.Depths[static_cast<std::size_t>(std::clamp(bin, 0.0, depthBins - 1.0))].Add(truth[k], predictions[k]);
    }
  }
  for (auto& [id, tally] : occluders)
  {
    tally.OccluderId = id;
    report.Occluders.push_back(tally);
  }
  return report;
}

} // namespace shadowcones
