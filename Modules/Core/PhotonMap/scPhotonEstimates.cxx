// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonEstimates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shadowcones
{

int NeighboursOnSurfaces(vtkIdType photons)
{
  // Bias falls with r^2 and so with k / N, noise with 1 / sqrt(k): k in proportion to N^(2/3) makes them fall alike.
  constexpr double fewest = 32.0;
  constexpr double most = 4096.0;
  return static_cast<int>(std::clamp(0.1 * std::pow(static_cast<double>(photons), 2.0 / 3.0), fewest, most));
}

bool PreparePhotonEstimates(StoredPhotons surface, StoredPhotons volume, int neighbours, const Monitor& monitor,
  PhotonEstimates& estimates)
{
  const int onSurfaces = neighbours > 0 ? neighbours : NeighboursOnSurfaces(surface.Count());
  estimates.Surface = SurfacePhotons(std::move(surface), onSurfaces);
  return estimates.Volume.Build(std::move(volume), neighbours > 0 ? neighbours : NeighboursInMedium, monitor);
}

} // namespace shadowcones
