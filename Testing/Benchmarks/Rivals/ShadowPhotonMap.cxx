// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowPhotonMap.h"

#include "scPhotonEmission.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shadowcones
{

//------------------------------------------------------------------------------
ShadowPhotonMap::ShadowPhotonMap(
  const OccluderScene& scene, const Light& light, const Box& bounds, const ShadowPhotonOptions& options)
  : Neighbors(options.Neighbors)
  , AsksRays(options.Rays > 0)
  , Lamp(scene, light, std::max(1, options.Rays))
{
  // Aimed at the mesh and well beside it: elsewhere all is lit, and the nearest photons are lit ones.
  const double beside = 0.15 * scene.Bounds().Diagonal();
  Box target = scene.Bounds();
  target.Add(target.Min - Vector3{ beside, beside, beside });
  target.Add(target.Max + Vector3{ beside, beside, beside });
  const PhotonEmission emission(light, target, target.Diagonal());
  for (vtkIdType path = 0; path < options.Paths; ++path)
  {
    const EmittedPhoton photon = emission.Emit(5, path);
    double from = 0.0;
    double to = HUGE_VAL;
    if (!(photon.Power > 0.0) || !bounds.Clip(photon.Origin, photon.Direction, from, to))
    {
      continue;
    }
    RayHit hit;
    const double stopped = scene.Intersect(photon.Origin, photon.Direction, 0.0, to, hit) ? hit.T : HUGE_VAL;
    const auto power = static_cast<float>(photon.Power * (to - from));
    RandomStream random(6, static_cast<std::uint64_t>(path));
    for (int k = 0; k < options.PointsOfPath; ++k)
    {
      const double t = from + (k + random.Next()) / options.PointsOfPath * (to - from);
      this->Points.push_back(photon.Origin + t * photon.Direction);
      this->Powers.push_back(t > stopped ? -power : power);
    }
  }
  this->Tree = std::make_unique<PointTree>(bounds, static_cast<vtkIdType>(this->Points.size()),
    [this](vtkIdType id) { return this->Points[static_cast<std::size_t>(id)]; });
  std::vector<Vector3>().swap(this->Points);
}

//------------------------------------------------------------------------------
double ShadowPhotonMap::BlockedAt(const Vector3& x, RandomStream& random) const
{
  thread_local std::vector<vtkIdType> found;
  thread_local std::vector<double> squared;
  this->Tree->NearestTo(x, this->Neighbors, found, squared);
  double all = 0.0;
  double blocked = 0.0;
  for (const vtkIdType id : found)
  {
    const float power = this->Powers[static_cast<std::size_t>(id)];
    all += std::fabs(power);
    blocked -= std::min(power, 0.0f);
  }
  if (this->AsksRays && blocked > 0.0 && blocked < all)
  {
    return this->Lamp.BlockedAt(x, random);
  }
  return all > 0.0 ? blocked / all : 0.0;
}

//------------------------------------------------------------------------------
std::int64_t ShadowPhotonMap::Memory() const
{
  return this->Tree->Memory() + static_cast<std::int64_t>(this->Powers.size() * sizeof(float)) +
    (this->AsksRays ? this->Lamp.Memory() : 0);
}

} // namespace shadowcones
