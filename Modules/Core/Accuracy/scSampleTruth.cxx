// SPDX-License-Identifier: BSD-3-Clause
#include "scSampleTruth.h"

#include "scLampPlane.h"
#include "scLightSampling.h"
#include "scRandom.h"

#include <algorithm>
#include <array>

namespace shadowcones
{
namespace
{
/// Streams of random numbers that must not be alike.
constexpr std::uint64_t lightPointStream = 0x4C50;
constexpr std::uint64_t rotationStream = 0x524F;

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
  pattern.reserve(static_cast<std::size_t>(std::max(lightSamples, 0)));
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
    if (!MeasureTruth(
          points, scene, lights[k], lightSamples, seed, monitor.Part(done / count, (done + 1.0) / count), ofLight))
    {
      return false;
    }
    truth.insert(truth.end(), ofLight.begin(), ofLight.end());
  }
  return true;
}

} // namespace shadowcones
