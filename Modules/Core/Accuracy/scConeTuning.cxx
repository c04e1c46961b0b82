// SPDX-License-Identifier: BSD-3-Clause
#include "scConeTuning.h"

#include "scRandom.h"
#include "scTeam.h"
#include "scTuningMeasure.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

namespace shadowcones
{
namespace
{
constexpr vtkIdType fewVectors = 6000;   ///< Preview and Soft: to search with
constexpr vtkIdType manyVectors = 40000; ///< to choose among the best with
constexpr std::size_t numberOfFinalists = 6;

bool IsBetter(const ConeTuningResult& a, const ConeTuningResult& b)
{
  return a.Objective < b.Objective;
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
  SideBySide(const TuningValidation& validation, const std::vector<LightExtent>& lights, ConeTuning tuning,
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
        MeasureFit(this->TheValidation, this->Lights, this->Tuning, inside, results[i]);
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
  const TuningValidation& TheValidation;
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
  const TuningValidation validation(vectors, paths, lights.size(), tuning, manyVectors);
  result.Lacking = validation.Data.Lacking(!MakesBounds(tuning));
  if (!result.Lacking.empty())
  {
    return true;
  }
  result.NumberOfFits = 1;
  return MeasureFit(validation, lights, tuning, monitor, result);
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
  const TuningValidation first(vectors, paths, lights.size(), tuning, many ? fewVectors : manyVectors);
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
    const TuningValidation validation(vectors, paths, lights.size(), tuning, manyVectors);
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
