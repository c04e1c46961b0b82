// SPDX-License-Identifier: BSD-3-Clause
#include "scShadowVectors.h"

#include "scAimedPhotons.h"
#include "scPhotonTracing.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace shadowcones
{
namespace
{
constexpr vtkIdType leastPhotons = 1024; // at once
constexpr vtkIdType photonsPerVectorLimit = 1000;

/// Trace photons behind the aimed ones until the target is met or the limit reached: @p photons are enough, @p traced were traced.
bool TraceUntil(const PhotonTracing& tracing, vtkIdType target, const Monitor& monitor, ShadowVectorResult& result,
  vtkIdType& photons, vtkIdType& traced)
{
  constexpr vtkIdType largest = std::numeric_limits<vtkIdType>::max();
  const vtkIdType aimed = tracing.Bundles.NumberOfAimedPhotons();
  const vtkIdType limit = aimed + std::min(target, (largest - aimed) / photonsPerVectorLimit) * photonsPerVectorLimit;
  double done = 0.0; // each range takes half of the progress that is left: nobody knows how many there will be
  const std::vector<vtkIdType>& indices = result.Vectors.PhotonIndices;
  const auto ofAimed = static_cast<double>(indices.size());
  traced = aimed;
  while (static_cast<vtkIdType>(indices.size()) < target && traced < limit)
  {
    // Guess what is missing from the yield so far.
    const auto found = static_cast<double>(indices.size()) - ofAimed;
    const double yield = traced > aimed ? std::max(found, 1.0) / static_cast<double>(traced - aimed) : 0.5;
    const double missing = static_cast<double>(target) - static_cast<double>(indices.size());
    const double guess = std::min(1.02 * missing / yield, double(1 << 20));
    const vtkIdType end = std::min(limit, traced + std::max(static_cast<vtkIdType>(guess), leastPhotons));
    const double next = 0.5 * (done + 1.0);
    if (!tracing.TraceRange(traced, end, monitor.Part(done, next), result))
    {
      return false;
    }
    done = next;
    traced = end;
  }
  const bool isMet = static_cast<vtkIdType>(indices.size()) >= target;
  photons = isMet ? std::max(aimed, indices[static_cast<std::size_t>(target - 1)] + 1) : traced;
  return true;
}

template <typename T>
void KeepRange(std::vector<T>& values, std::size_t components, std::size_t begin, std::size_t end)
{
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(components * end), values.end());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components * begin));
}

/// A photon stands for its part of what its own bundle sends.
void SharePowers(const PhotonBundles& bundles, const std::vector<vtkIdType>& counts,
  const std::vector<vtkIdType>& indices, std::vector<float>& powers)
{
  std::vector<float> shares;
  for (const vtkIdType photons : counts)
  {
    shares.push_back(static_cast<float>(1.0 / static_cast<double>(std::max<vtkIdType>(photons, 1))));
  }
  for (std::size_t i = 0; i < powers.size(); ++i)
  {
    powers[i] *= shares[bundles.At(indices[i]).Bundle];
  }
}

/// Drop what photons outside [first, last) left behind.
void KeepPhotons(ShadowVectorResult& result, vtkIdType first, vtkIdType last)
{
  const auto range = [first, last](const std::vector<vtkIdType>& indices)
  {
    return std::make_pair(
      static_cast<std::size_t>(std::lower_bound(indices.begin(), indices.end(), first) - indices.begin()),
      static_cast<std::size_t>(std::lower_bound(indices.begin(), indices.end(), last) - indices.begin()));
  };
  const std::pair<std::size_t, std::size_t> ranges[numberOfPhotonItems] = { range(result.Vectors.PhotonIndices),
    range(result.Paths.PhotonIndices), range(result.Photons.PhotonIndices) };
  ForEachArray(result, result,
    [&ranges](int item, int components, auto& values, auto&)
    { KeepRange(values, static_cast<std::size_t>(components), ranges[item].first, ranges[item].second); });
}
} // anonymous namespace

bool TraceShadowVectors(const OccluderScene& scene, const Light& light, const ShadowVectorOptions& options,
  const Monitor& monitor, ShadowVectorResult& result)
{
  return TraceShadowVectors(scene, std::vector<Light>{ light }, options, monitor, result);
}

bool TraceShadowVectors(const OccluderScene& scene, const std::vector<Light>& lights,
  const ShadowVectorOptions& options, const Monitor& whole, ShadowVectorResult& result)
{
  result = {};
  const PhotonTracer tracer(scene, lights, options.Storage);
  PhotonBundles bundles(lights, scene.Mesh(), options.Seed);
  const PhotonTracing tracing{ tracer, bundles, options.Workers };
  const double aiming = options.MinimumVectorsPerOccluder > 0 ? 0.3 : 0.0; // of the progress
  vtkIdType ofOthers = 0;
  if (options.MinimumVectorsPerOccluder > 0 &&
    !TraceAimedPhotons(tracing, scene.Mesh(), lights.size(), options, whole.Part(0.0, aiming), result, ofOthers))
  {
    return false;
  }
  const Monitor monitor = whole.Part(aiming, 1.0);
  const vtkIdType aimed = bundles.NumberOfAimedPhotons();
  vtkIdType photons = options.NumberOfPhotons;
  vtkIdType traced = 0;
  const auto bound = [&](int piece) { return PieceBound(photons, piece, options.NumberOfPieces); };
  if (options.TargetNumberOfVectors > 0)
  {
    // Every piece has to find out how many photons the whole takes.
    const auto ofAimed = static_cast<vtkIdType>(result.Vectors.PhotonIndices.size());
    const vtkIdType target = std::max(options.TargetNumberOfVectors, ofAimed + ofOthers);
    if (!TraceUntil(tracing, target, monitor, result, photons, traced))
    {
      return false;
    }
    if (whole.Progress)
    {
      whole.Progress(1.0);
    }
  }
  else
  {
    const vtkIdType begin = std::max(bound(options.Piece), aimed);
    const vtkIdType end = std::max(bound(options.Piece + 1), aimed);
    const PhotonTracing alone{ tracer, bundles };
    const bool isWhole = options.NumberOfPieces == 1;
    if (!isWhole && AreSeveral(options.Workers))
    {
      options.Workers->Count(end - begin);
    }
    if (!(isWhole ? tracing : alone).TraceRange(begin, end, monitor, result))
    {
      return false;
    }
    traced = aimed + end - begin;
  }
  KeepPhotons(result, bound(options.Piece), bound(options.Piece + 1));
  const std::vector<vtkIdType> counts = bundles.Counts(photons);
  SharePowers(bundles, counts, result.Paths.PhotonIndices, result.Paths.Powers);
  SharePowers(bundles, counts, result.Photons.PhotonIndices, result.Photons.Powers);
  result.NumberOfPhotons = photons;
  result.NumberOfAimedPhotons = aimed;
  result.PhotonsOfLights.assign(lights.size(), 0);
  for (std::size_t bundle = 0; bundle < counts.size(); ++bundle)
  {
    result.PhotonsOfLights[static_cast<std::size_t>(bundles.LightOf(bundle))] += counts[bundle];
  }
  result.MeanSolidAngle = traced > 0 ? result.MeanSolidAngle / static_cast<double>(traced) : 0.0;
  return true;
}

} // namespace shadowcones
