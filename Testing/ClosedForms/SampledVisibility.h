// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledVisibility.h
 * @brief The visible fraction of a light by points on it, as the fast paths see it.
 */
#ifndef SampledVisibility_h
#define SampledVisibility_h

#include "scLight.h"
#include "scLightSampling.h"
#include "scOccluderScene.h"
#include "scRandom.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Visible fraction of a light by points (u, v) on it.
inline double VisibilityBy(
  const std::vector<std::array<double, 2>>& points, const OccluderScene& scene, const Light& light, const Vector3& x)
{
  double seen = 0.0;
  double all = 0.0;
  for (const auto& point : points)
  {
    const IncidentSample sample = SampleVisibleLight(light, x, point[0], point[1]);
    all += sample.Weight;
    if (sample.Weight > 0.0 && !scene.Occluded(x, sample.Direction, 0.0, sample.Distance))
    {
      seen += sample.Weight;
    }
  }
  return all > 0.0 ? seen / all : 0.0;
}

/// 1,024 points of a lattice with steps of the golden ratio.
inline double SampledVisibility(const OccluderScene& scene, const Light& light, const Vector3& x)
{
  static const std::vector<std::array<double, 2>> points = []
  {
    std::vector<std::array<double, 2>> lattice;
    for (int k = 0; k < 1024; ++k)
    {
      const double turns = k * 0.61803398874989485 + 0.3;
      lattice.push_back({ (k + 0.5) / 1024.0, turns - std::floor(turns) });
    }
    return lattice;
  }();
  return VisibilityBy(points, scene, light, x);
}

/// 1,024 scrambled Sobol points, which the filters draw from.
inline double SobolVisibility(const OccluderScene& scene, const Light& light, const Vector3& x, std::uint64_t seed)
{
  std::vector<std::array<double, 2>> points;
  for (std::uint32_t k = 0; k < 1024; ++k)
  {
    const auto point = SobolPoint(seed, k);
    points.push_back({ point[0], point[1] });
  }
  return VisibilityBy(points, scene, light, x);
}

} // namespace shadowcones

#endif
