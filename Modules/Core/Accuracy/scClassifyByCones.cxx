// SPDX-License-Identifier: BSD-3-Clause
#include "scClassifyByCones.h"

#include "scConeTree.h"

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace shadowcones
{
namespace
{
struct AtomicConeTally
{
  std::atomic<std::int64_t> Samples{ 0 };
  std::atomic<std::int64_t> Shadowed{ 0 };
  std::atomic<std::int64_t> Lit{ 0 };
};

/// The cones that hold a point, ascending, each once.
void FindHolders(const ConeTree& tree, const std::vector<Cone>& cones, const Vector3& point, std::vector<int>& holders)
{
  holders.clear();
  tree.ForEachAtPoint(point,
    [&](const ConeTree::Entry& entry)
    {
      if (ConeContains(cones[entry.Cone], point, entry.High))
      {
        holders.push_back(entry.Cone);
      }
    });
  // A cone may be met once for each of its slices.
  std::sort(holders.begin(), holders.end());
  holders.erase(std::unique(holders.begin(), holders.end()), holders.end());
}

/// What cones predict for a point that @p holders hold.
SamplePrediction Predict(const std::vector<Cone>& cones, const std::vector<int>& holders, const Vector3& point)
{
  SamplePrediction prediction;
  prediction.Class = 1;
  prediction.ConeId = holders.front();
  prediction.Height = Dot(point - cones[holders.front()].Center, cones[holders.front()].Axis);
  for (const int cone : holders)
  {
    Cone inner = cones[cone];
    inner.HalfAngle = inner.InnerHalfAngle;
    if (ConeContains(inner, point))
    {
      prediction.Class = 2;
      break;
    }
  }
  return prediction;
}
} // anonymous namespace

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
        FindHolders(tree, cones, points[k], holders);
        if (holders.empty())
        {
          continue;
        }
        predictions[k] = Predict(cones, holders, points[k]);
        for (std::size_t i = 0; i < holders.size() && truth[k].Emitting > 0; ++i)
        {
          AtomicConeTally& count = counts[holders[i]];
          count.Samples.fetch_add(1, relaxed);
          count.Shadowed.fetch_add(truth[k].Shadowed(), relaxed);
          count.Lit.fetch_add(truth[k].Lit(), relaxed);
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
    if (!ClassifyByCones(
          points, part, conesOf[light], monitor.Part(done / count, (done + 1.0) / count), predicted, counted))
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

} // namespace shadowcones
