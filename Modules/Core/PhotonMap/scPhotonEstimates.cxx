// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonEstimates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{
namespace
{
constexpr double fewest = 32.0;
constexpr double fewestInMedium = 8.0;
constexpr double most = 4096.0;
} // anonymous namespace

double NeighboursOnSurfaces(double photons)
{
  return std::clamp(0.1 * std::pow(photons, 2.0 / 3.0), fewest, most);
}

double NeighboursInMedium(double photons)
{
  return std::clamp(0.2 * std::sqrt(photons), fewestInMedium, most);
}

bool PreparePhotonEstimates(StoredPhotons surface, StoredPhotons volume, int neighbours, int passes,
  const Monitor& monitor, PhotonEstimates& estimates)
{
  const auto count = static_cast<double>(passes);
  const double onSurfaces =
    neighbours > 0 ? neighbours : NeighboursOnSurfaces(count * static_cast<double>(surface.Count()));
  const double inMedium =
    neighbours > 0 ? neighbours : NeighboursInMedium(count * static_cast<double>(volume.Count()));
  return estimates.Surface.Build(std::move(surface), onSurfaces / count, monitor.Part(0.0, 0.5)) &&
    estimates.Volume.Build(std::move(volume), inMedium / count, monitor.Part(0.5, 1.0));
}

} // namespace shadowcones
