// SPDX-License-Identifier: BSD-3-Clause
// One file because the search is read with the measures that it asks for.
#include "scConeTuning.h"

#include "scCone.h"
#include "scConeHierarchy.h"
#include "scConeTree.h"
#include "scOccluderInterval.h"
#include "scRandom.h"
#include "scTeam.h"
#include "scTuningData.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

namespace shadowcones
{
namespace
{
constexpr double coneCost = 0.05;      ///< Conservative: what a cone per vector is worth in leak
constexpr double boundsMargin = 0.5;   ///< Conservative: light counts in the paths' bounds, grown by this share of them
constexpr double previewMargin = 0.25; ///< Preview: the same, nearer to the occluders, where images look
constexpr double largestScale = 2.0;   ///< Soft: radii are not scaled beyond this
constexpr double tightLeak = 0.25;     ///< Tight: what leaks gets cones around parts of the mesh, which are tighter
/// Tight: for each light, of three quarters of the vectors; all of them make some 150. Each one more costs tightConeCost.
constexpr double mostTightCones = 120.0;
constexpr double tightConeCost = 0.01;
constexpr vtkIdType fewVectors = 6000;   ///< Preview and Soft: to search with
constexpr vtkIdType manyVectors = 40000; ///< to choose among the best with
constexpr std::size_t numberOfFinalists = 6;

/// What validating a kind of tuning needs again and again.
struct Validation
{
  Validation(const ShadowVectorView& vectors, const PhotonPathView& paths, std::size_t lights, ConeTuning tuning,
    vtkIdType largestNumberOfVectors)
    : Data(vectors, paths, largestNumberOfVectors)
    , Lights(lights)
    , Region(Data.Region(tuning == ConeTuning::Preview ? previewMargin : boundsMargin))
  {
    if (tuning == ConeTuning::Preview)
    {
      this->Samples = this->Data.SamplesIn(this->Region);
    }
  }

  TuningData Data;
  std::size_t Lights;              ///< their number
  Box Region;                      ///< where light counts
  std::vector<PathSample> Samples; ///< Preview
};

/// Lengths of light, summed over the held-out paths.
struct LightSums
{
  double Blocked = 0.0;
  double Leaked = 0.0; ///< blocked, outside the cones
  double Lost = 0.0;   ///< lit, inside the cones
};

LightSums SumLight(const Validation& validation, const std::vector<Cone>& cones)
{
  std::vector<std::unique_ptr<ConeHierarchy>> hierarchies;
  for (const std::vector<Cone>& ofLight : ConesOfLights(cones, validation.Lights))
  {
    hierarchies.push_back(std::make_unique<ConeHierarchy>(ofLight, validation.Region));
  }
  // Fixed chunks, joined in order: the sums do not depend on the number of threads.
  constexpr vtkIdType chunk = 256;
  const auto count = static_cast<vtkIdType>(validation.Data.HeldOut.size());
  std::vector<LightSums> parts(static_cast<std::size_t>((count + chunk - 1) / chunk));
  ParallelFor(static_cast<vtkIdType>(parts.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<OccluderInterval> intervals;
      for (vtkIdType part = first; part < last; ++part)
      {
        for (vtkIdType i = part * chunk; i < std::min(count, (part + 1) * chunk); ++i)
        {
          const HeldOutPath& path = validation.Data.HeldOut[i];
          double begin = 0.0;
          double end = HUGE_VAL;
          if (!validation.Region.Clip(path.Origin, path.Direction, begin, end))
          {
            continue;
          }
          const double stop = std::clamp(path.Stop, begin, end);
          hierarchies[path.Light]->Intersect(path.Origin, path.Direction, begin, end, intervals);
          double leaked = end - stop;
          double lost = 0.0;
          parts[part].Blocked += leaked;
          for (const OccluderInterval& interval : intervals)
          {
            leaked -= std::max(0.0, interval.End - std::max(interval.Begin, stop));
            lost += std::max(0.0, std::min(interval.End, stop) - interval.Begin);
          }
          parts[part].Leaked += std::max(0.0, leaked);
          parts[part].Lost += lost;
        }
      }
    });
  LightSums sums;
  for (const LightSums& part : parts)
  {
    sums.Blocked += part.Blocked;
    sums.Leaked += part.Leaked;
    sums.Lost += part.Lost;
  }
  return sums;
}

void SetSums(const LightSums& sums, ConeTuningResult& result)
{
  const double blocked = std::max(sums.Blocked, 1e-300);
  result.Leak = sums.Leaked / blocked;
  result.Lost = sums.Lost / blocked;
}

void MeasureConservative(const Validation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  SetSums(SumLight(validation, cones), result);
  result.Objective =
    result.Leak + coneCost * static_cast<double>(cones.size()) / static_cast<double>(validation.Data.Vectors().Count);
}

/// What the proof closes costs little: the light of the cones that is not in shadow counts.
void MeasureTight(const Validation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  SetSums(SumLight(validation, cones), result);
  const double held = 1.0 - result.Leak;
  const double most = mostTightCones * static_cast<double>(validation.Lights);
  result.Objective = result.Lost / std::max(held + result.Lost, 1e-300) + tightLeak * result.Leak +
    tightConeCost * std::max(0.0, static_cast<double>(cones.size()) - most);
}

/// For each sample the smallest share of the half angles at which a cone holds it; HUGE_VAL: none does at @p largest.
std::vector<double> HoldingFractions(const Validation& validation, const std::vector<Cone>& cones, double largest)
{
  std::vector<Cone> narrow = cones;
  for (Cone& cone : narrow)
  {
    cone.HalfAngle *= largest;
  }
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, validation.Lights);
  std::vector<ConeTree> trees;
  for (const std::vector<Cone>& ofLight : ConesOfLights(narrow, validation.Lights))
  {
    trees.push_back(ConeTree::OverSlices(ofLight, validation.Region, HUGE_VAL));
  }
  std::vector<double> fractions(validation.Samples.size(), HUGE_VAL);
  ParallelFor(static_cast<vtkIdType>(fractions.size()), {},
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double smallest = HUGE_VAL;
        const std::size_t light = validation.Samples[i].Light;
        trees[light].AnyAtPoint(validation.Samples[i].Point,
          [&](const ConeTree::Entry& entry)
          {
            const Cone& cone = conesOf[light][entry.Cone];
            const Vector3 offset = validation.Samples[i].Point - cone.Center;
            const double height = Dot(offset, cone.Axis);
            const double beyond = std::sqrt(std::max(0.0, Dot(offset, offset) - height * height)) - cone.BaseRadius;
            if (height >= 0.0)
            {
              smallest = std::min(smallest, beyond > 0.0 ? std::atan2(beyond, height) / cone.HalfAngle : 0.0);
            }
            return smallest == 0.0;
          });
        fractions[i] = smallest <= largest ? smallest : HUGE_VAL;
      }
    });
  return fractions;
}

/// The share of the angle at which as much lit light is lost inside the cones as blocked light leaks outside.
void MeasurePreview(const Validation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  std::vector<double> fractions;
  const auto at = [&](double limit)
  {
    LightSums sums;
    for (std::size_t i = 0; i < fractions.size(); ++i)
    {
      const PathSample& sample = validation.Samples[i];
      const bool inside = fractions[i] <= limit;
      sums.Blocked += sample.Blocked ? sample.Length : 0.0;
      sums.Leaked += sample.Blocked && !inside ? sample.Length : 0.0;
      sums.Lost += !sample.Blocked && inside ? sample.Length : 0.0;
    }
    return sums;
  };
  // Few samples lie in narrow cones, and the balance mostly lies there: wide ones are asked only where it does not.
  LightSums sums;
  double high = 0.0;
  for (const double largest : { 0.25, 1.0 })
  {
    high = largest;
    fractions = HoldingFractions(validation, cones, largest);
    sums = at(largest);
    if (sums.Lost >= sums.Leaked)
    {
      break;
    }
  }
  double low = 0.0;
  sums = at(low);
  high = sums.Lost < sums.Leaked ? high : low;
  for (int i = 0; i < 12 && low < high; ++i)
  {
    const double middle = 0.5 * (low + high);
    sums = at(middle);
    (sums.Lost < sums.Leaked ? low : high) = middle;
  }
  const double fraction = high;
  sums = at(fraction);
  SetSums(sums, result);
  result.Options.ExpansionFraction = fraction;

  constexpr int side = TuningData::CellsPerSide;
  std::vector<double> cells(side * side * side, 0.0);
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    const PathSample& sample = validation.Samples[i];
    if (sample.Blocked != (fractions[i] <= fraction))
    {
      cells[sample.Cell] += sample.Blocked ? sample.Length : -sample.Length;
    }
  }
  double imbalance = 0.0;
  for (const double cell : cells)
  {
    imbalance += std::abs(cell);
  }
  result.Objective = imbalance / std::max(sums.Blocked, 1e-300);
}

/// For each path the smallest factor on the radii at which a base disc blocks it; HUGE_VAL where none does up to the largest.
std::vector<double> BlockingScales(const Validation& validation, const std::vector<Cone>& cones)
{
  std::vector<Cone> discs = cones;
  for (Cone& disc : discs)
  {
    disc.BaseRadius *= largestScale;
    disc.Axis = disc.Normal;
  }
  const std::vector<std::vector<Cone>> conesOf = ConesOfLights(cones, validation.Lights);
  std::vector<ConeTree> trees;
  for (const std::vector<Cone>& ofLight : ConesOfLights(discs, validation.Lights))
  {
    trees.push_back(ConeTree::OverBases(ofLight));
  }
  std::vector<double> scales(validation.Data.HeldOut.size(), HUGE_VAL);
  ParallelFor(static_cast<vtkIdType>(scales.size()), {}, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType i = first; i < last; ++i)
    {
      const HeldOutPath& path = validation.Data.HeldOut[i];
      trees[path.Light].ForEachOnRay(path.Origin, path.Direction, 0.0, HUGE_VAL, [&](const ConeTree::Entry& entry) {
        const Cone& disc = conesOf[path.Light][entry.Cone];
        const double slope = Dot(path.Direction, disc.Normal);
        const double t = Dot(disc.Center - path.Origin, disc.Normal) / slope;
        if (t > 0.0 && std::isfinite(t))
        {
          const double distance = Length(path.Origin + t * path.Direction - disc.Center);
          scales[i] = std::min(scales[i], distance / disc.BaseRadius);
        }
      });
    }
  });
  return scales;
}

/// The factor on the radii at which as many lit paths are caught as blocked ones are missed.
void MeasureSoft(const Validation& validation, const std::vector<Cone>& cones, ConeTuningResult& result)
{
  const std::vector<double> scales = BlockingScales(validation, cones);
  std::vector<double> lit;
  std::vector<double> blocked;
  for (std::size_t i = 0; i < scales.size(); ++i)
  {
    (std::isfinite(validation.Data.HeldOut[i].Stop) ? blocked : lit).push_back(scales[i]);
  }
  std::sort(lit.begin(), lit.end());
  std::sort(blocked.begin(), blocked.end());
  const auto caught = [](const std::vector<double>& sorted, double scale) {
    return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), scale) - sorted.begin());
  };
  double low = 0.0;
  double high = largestScale;
  for (int i = 0; i < 30; ++i)
  {
    const double scale = 0.5 * (low + high);
    const double missed = static_cast<double>(blocked.size()) - caught(blocked, scale);
    (caught(lit, scale) < missed ? low : high) = scale;
  }
  const auto total = static_cast<double>(blocked.size());
  const double positives = caught(blocked, low);
  const double falsePositives = caught(lit, low);
  result.Options.RadiusScale = low;
  result.Leak = (total - positives) / total;
  result.Lost = falsePositives / total;
  result.Objective = 1.0 - positives / (total + falsePositives);
}

bool IsBetter(const ConeTuningResult& a, const ConeTuningResult& b)
{
  return a.Objective < b.Objective;
}

/// Fit with the options in the result, measure, and set what balances.
bool Measure(const Validation& validation, const std::vector<LightExtent>& lights, ConeTuning tuning,
  const Monitor& monitor, ConeTuningResult& result)
{
  ConeSetOptions options = result.Options;
  options.ExpansionFraction = 1.0;
  options.RadiusScale = 1.0;
  ConeSet set;
  const PhotonPathView paths = options.MaximumOverspill < 1.0 ? validation.Data.Paths() : PhotonPathView{};
  if (!FitConeSet(validation.Data.Vectors(), paths, lights, options, Monitor{ nullptr, monitor.Aborted }, set))
  {
    return false;
  }
  switch (tuning)
  {
    case ConeTuning::Preview:
      MeasurePreview(validation, set.Cones, result);
      break;
    case ConeTuning::Soft:
      MeasureSoft(validation, set.Cones, result);
      break;
    case ConeTuning::Tight:
      MeasureTight(validation, set.Cones, result);
      break;
    default:
      MeasureConservative(validation, set.Cones, result);
      break;
  }
  return true;
}

bool MakesBounds(ConeTuning tuning)
{
  return tuning == ConeTuning::Conservative || tuning == ConeTuning::Tight;
}

/// Parameter sets spread over the ranges, before the best is refined. A proof mends what a short search leaves.
int NumberOfParameterSamples(ConeTuning tuning)
{
  return tuning == ConeTuning::Tight ? 12 : 24;
}

/// Rounds of steps from the best.
int NumberOfRounds(ConeTuning tuning)
{
  return tuning == ConeTuning::Tight ? 1 : 2;
}

/// Where the search starts: what measuring found good for each use.
ConeSetOptions Recipe(ConeTuning tuning, ConeSetOptions options)
{
  options.NumberOfNeighbors = 100;
  options.PointsPerRing = 16;
  options.MinimumVectorsPerCone = 20;
  options.VarianceThreshold = tuning == ConeTuning::Soft ? 1.4 : 1.8;
  options.CosineCorrection = tuning == ConeTuning::Preview;
  options.Expansion = ConeExpansion::LightGeometry;
  options.Overlap = true;
  options.ExpansionFraction = 1.0;
  options.RadiusScale = 1.0;
  options.MaximumOverspill = tuning == ConeTuning::Preview ? 0.25 : 1.0;
  options.Leftovers = MakesBounds(tuning) ? ConeLeftovers::Cover : ConeLeftovers::Discard;
  return options;
}

/// The index-th of a sequence of parameter sets that is spread evenly over the useful ranges.
ConeSetOptions ParameterSample(ConeSetOptions options, int index)
{
  const auto u = SobolPoint(1, static_cast<std::uint32_t>(index));
  options.NumberOfNeighbors = static_cast<int>(24.0 * std::pow(10.0, u[0]));
  options.VarianceThreshold = 1.1 + 2.0 * u[1];
  options.MinimumVectorsPerCone = std::min(options.NumberOfNeighbors, static_cast<int>(6.0 * std::pow(5.0, u[2])));
  options.PointsPerRing = std::min(options.NumberOfNeighbors - 1, static_cast<int>(6.0 + 18.0 * u[3]));
  return options;
}

/// Steps from the options to either side, one parameter at a time.
std::vector<ConeSetOptions> Steps(const ConeSetOptions& options)
{
  std::vector<ConeSetOptions> steps;
  for (const double factor : { 0.75, 1.35 })
  {
    ConeSetOptions step = options;
    step.NumberOfNeighbors = std::max(8, static_cast<int>(factor * options.NumberOfNeighbors));
    steps.push_back(step);
    step = options;
    step.MinimumVectorsPerCone = std::max(4, static_cast<int>(factor * options.MinimumVectorsPerCone));
    steps.push_back(step);
    step = options;
    step.PointsPerRing = std::max(4, static_cast<int>(factor * options.PointsPerRing));
    steps.push_back(step);
    step = options;
    step.VarianceThreshold = std::max(1.0, options.VarianceThreshold + (factor - 1.0));
    steps.push_back(step);
    if (options.MaximumOverspill < 1.0)
    {
      step = options;
      step.MaximumOverspill = std::min(0.9, factor * factor * options.MaximumOverspill);
      steps.push_back(step);
    }
  }
  return steps;
}

/// What measuring fills in of a result.
std::array<double*, 5> FiguresOf(ConeTuningResult& result)
{
  return { &result.Objective, &result.Leak, &result.Lost, &result.Options.ExpansionFraction, &result.Options.RadiusScale };
}

/// Measures several parameter sets side by side: each is independent of the others, and many of its steps are in order.
class SideBySide
{
public:
  SideBySide(const Validation& validation, const std::vector<LightExtent>& lights, ConeTuning tuning,
    const Monitor& monitor, Team* workers)
    : TheValidation(validation)
    , Lights(lights)
    , Tuning(tuning)
    , TheMonitor(monitor)
    , Workers(workers)
  {
  }

  /// Fill in results, which hold their options. Progress goes from @p from to @p to. @return false where aborted.
  bool Run(std::vector<ConeTuningResult>& results, double from, double to)
  {
    // Steps inside ask too, and on the calling thread only: each of them may take long.
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> stopped{ false };
    const auto isAborted = [&]
    {
      if (std::this_thread::get_id() == caller && this->TheMonitor.IsAborted())
      {
        stopped = true;
      }
      return stopped.load();
    };
    const Monitor inside{ nullptr, isAborted };
    Monitor part = this->TheMonitor.Part(from, to);
    part.Aborted = isAborted;
    constexpr std::size_t count = std::tuple_size<decltype(FiguresOf(results.front()))>();
    std::vector<double> figures(count * results.size());
    const TeamShare share(this->Workers, static_cast<vtkIdType>(results.size()));
    TeamJoin join(this->Workers);
    join.AddItems(figures, share, count);
    const auto measure = [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        Measure(this->TheValidation, this->Lights, this->Tuning, inside, results[i]);
        const auto of = FiguresOf(results[i]);
        std::transform(of.begin(), of.end(), figures.begin() + count * i, [](const double* figure) { return *figure; });
      }
    };
    if (!TeamFor(this->Workers, join, share, part, measure))
    {
      return false;
    }
    for (std::size_t i = 0; i < figures.size(); ++i)
    {
      *FiguresOf(results[i / count])[i % count] = figures[i];
    }
    return true;
  }

private:
  const Validation& TheValidation;
  const std::vector<LightExtent>& Lights;
  const ConeTuning Tuning;
  const Monitor& TheMonitor;
  Team* const Workers;
};

/// Those that are valid, to be measured.
std::vector<ConeTuningResult> Candidates(const std::vector<ConeSetOptions>& sets)
{
  std::vector<ConeTuningResult> results;
  for (const ConeSetOptions& options : sets)
  {
    if (!CheckConeSetOptions(options))
    {
      results.emplace_back();
      results.back().Options = options;
    }
  }
  return results;
}

/// A recipe, samples of the ranges, then steps from the best. @param tried every parameter set measured, the recipe first.
bool Search(SideBySide& measuring, ConeTuning tuning, const ConeSetOptions& recipe, std::vector<ConeTuningResult>& tried)
{
  const double expected = 1.0 + NumberOfParameterSamples(tuning) + NumberOfRounds(tuning) * static_cast<double>(Steps(recipe).size());
  const auto attempt = [&](const std::vector<ConeSetOptions>& sets)
  {
    std::vector<ConeTuningResult> results = Candidates(sets);
    const auto share = [&](std::size_t more)
    { return std::min(1.0, static_cast<double>(tried.size() + more) / expected); };
    if (!measuring.Run(results, share(0), share(results.size())))
    {
      return false;
    }
    tried.insert(tried.end(), results.begin(), results.end());
    return true;
  };
  const auto best = [&]() { return *std::min_element(tried.begin(), tried.end(), IsBetter); };
  std::vector<ConeSetOptions> first{ recipe };
  for (int sample = 0; sample < NumberOfParameterSamples(tuning); ++sample)
  {
    first.push_back(ParameterSample(recipe, sample));
  }
  if (!attempt(first))
  {
    return false;
  }
  for (int round = 0; round < NumberOfRounds(tuning); ++round)
  {
    const ConeTuningResult from = best();
    if (!attempt(Steps(from.Options)))
    {
      return false;
    }
    if (!IsBetter(best(), from))
    {
      break;
    }
  }
  return true;
}

} // anonymous namespace

ConeSetOptions BoundsOptions(const ConeSetOptions& options)
{
  return Recipe(ConeTuning::Conservative, options);
}

bool MeasureTuning(const ShadowVectorView& vectors, const PhotonPathView& paths, const std::vector<LightExtent>& lights,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result)
{
  result = {};
  result.Options = options;
  const Validation validation(vectors, paths, lights.size(), tuning, manyVectors);
  result.Lacking = validation.Data.Lacking(!MakesBounds(tuning));
  if (!result.Lacking.empty())
  {
    return true;
  }
  result.NumberOfFits = 1;
  return Measure(validation, lights, tuning, monitor, result);
}

bool TuneConeSet(const ShadowVectorView& vectors, const PhotonPathView& paths, const std::vector<LightExtent>& lights,
  ConeTuning tuning, const ConeSetOptions& options, const Monitor& monitor, ConeTuningResult& result, Team* workers)
{
  result = {};
  result.Options = options;
  if (tuning == ConeTuning::Manual)
  {
    return true;
  }
  const bool many = !MakesBounds(tuning) && vectors.Count > fewVectors;
  const double part = many ? 0.5 : 1.0;
  std::vector<ConeTuningResult> tried;
  const Validation first(vectors, paths, lights.size(), tuning, many ? fewVectors : manyVectors);
  result.Lacking = first.Data.Lacking(!MakesBounds(tuning));
  if (!result.Lacking.empty())
  {
    result.Options = BoundsOptions(options);
    return true;
  }
  const Monitor search = monitor.Part(0.0, part);
  SideBySide measuring(first, lights, tuning, search, workers);
  if (!Search(measuring, tuning, Recipe(tuning, options), tried))
  {
    return false;
  }
  const auto fits = tried.size();
  std::stable_sort(tried.begin() + 1, tried.end(), IsBetter);
  if (many)
  {
    // More vectors make other cones of the same parameters: the recipe and the best few are measured again.
    const Validation validation(vectors, paths, lights.size(), tuning, manyVectors);
    tried.resize(std::min(tried.size(), 1 + numberOfFinalists));
    if (!SideBySide(validation, lights, tuning, monitor, workers).Run(tried, part, 1.0))
    {
      return false;
    }
  }
  result = *std::min_element(tried.begin(), tried.end(), IsBetter);
  result.StartObjective = tried.front().Objective;
  result.NumberOfFits = static_cast<int>(fits + (many ? tried.size() : 0));
  return true;
}

} // namespace shadowcones
