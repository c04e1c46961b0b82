// SPDX-License-Identifier: BSD-3-Clause
#include "scPhotonBundles.h"

#include "scRandom.h"

#include <algorithm>

namespace shadowcones
{
namespace
{
/// Aimed bundles draw from sequences of their own.
constexpr std::uint64_t aimedSequences = 0x61696d6564;
} // anonymous namespace

PhotonBundles::PhotonBundles(const std::vector<Light>& lights, const TriangleMeshView& mesh, std::uint64_t seed)
  : Lights(lights)
  , Whole(MeshBounds(mesh).Diagonal())
  , Seed(seed)
  , Bundles(BundlesOf(lights, mesh, seed))
  , AimedOf(lights.size())
  , Shares(PowersOf(this->Bundles))
{
}

std::vector<PhotonBundles::Bundle> PhotonBundles::BundlesOf(
  const std::vector<Light>& lights, const TriangleMeshView& mesh, std::uint64_t seed)
{
  std::vector<Bundle> bundles;
  bundles.reserve(lights.size());
  for (const Light& light : lights)
  {
    bundles.push_back({ static_cast<int>(bundles.size()), PhotonEmission(light, mesh), seed });
  }
  return bundles;
}

std::vector<double> PhotonBundles::PowersOf(const std::vector<Bundle>& bundles)
{
  std::vector<double> powers;
  for (const Bundle& bundle : bundles)
  {
    powers.push_back(bundle.Emission.Power());
  }
  return powers;
}

void PhotonBundles::Aim(int light, const std::vector<Box>& boxes)
{
  AimedBundles& aimed = this->AimedOf[static_cast<std::size_t>(light)];
  for (const Box& box : boxes)
  {
    aimed.Bundles.push_back(this->Bundles.size());
    this->Bundles.push_back({ light, PhotonEmission(this->Lights[static_cast<std::size_t>(light)], box, this->Whole),
      HashSeed(HashSeed(this->Seed, aimedSequences), this->Bundles.size()) });
    this->Ends.push_back(this->NumberOfAimedPhotons());
  }
  std::vector<Box> targets;
  for (const std::size_t bundle : aimed.Bundles)
  {
    targets.push_back(this->Bundles[bundle].Emission.Target());
  }
  aimed.Boxes = AimedBoxes(targets);
}

std::size_t PhotonBundles::OwnerOf(int light, const EmittedPhoton& photon) const
{
  const auto own = static_cast<std::size_t>(light);
  const AimedBundles& aimed = this->AimedOf[own];
  const std::size_t first = aimed.Boxes.FirstMet(
    photon.Origin, photon.Direction, [&](std::size_t k) { return this->PhotonsOf(aimed.Bundles[k]) > 0; });
  return first == aimed.Bundles.size() ? own : aimed.Bundles[first];
}

EmittedPhoton PhotonBundles::Emit(std::size_t bundle, vtkIdType index) const
{
  const Bundle& from = this->Bundles[bundle];
  EmittedPhoton photon = from.Emission.Emit(from.Seed, index);
  if (photon.Power > 0.0 && !this->Ends.empty() && this->OwnerOf(from.Light, photon) != bundle)
  {
    photon.Power = 0.0;
  }
  return photon;
}

void PhotonBundles::SetPhotons(std::size_t bundle, vtkIdType photons)
{
  const vtkIdType more = photons - this->PhotonsOf(bundle);
  for (std::size_t k = bundle - this->Lights.size(); k < this->Ends.size(); ++k)
  {
    this->Ends[k] += more;
  }
}

vtkIdType PhotonBundles::PhotonsOf(std::size_t bundle) const
{
  return this->Ends[bundle - this->Lights.size()] - this->FirstPhoton(bundle);
}

vtkIdType PhotonBundles::FirstPhoton(std::size_t bundle) const
{
  const std::size_t aimed = bundle - this->Lights.size();
  return aimed == 0 ? 0 : this->Ends[aimed - 1];
}

PhotonBundles::BundlePhoton PhotonBundles::At(vtkIdType photon) const
{
  const vtkIdType aimed = this->NumberOfAimedPhotons();
  if (photon < aimed)
  {
    const auto end = std::upper_bound(this->Ends.begin(), this->Ends.end(), photon);
    const auto bundle = this->Lights.size() + static_cast<std::size_t>(end - this->Ends.begin());
    return { bundle, photon - this->FirstPhoton(bundle) };
  }
  const LightShares::LightPhoton own = this->Shares.At(photon - aimed);
  return { static_cast<std::size_t>(own.Light), own.Index };
}

std::vector<vtkIdType> PhotonBundles::Counts(vtkIdType photons) const
{
  const vtkIdType aimed = this->NumberOfAimedPhotons();
  std::vector<vtkIdType> counts = this->Shares.Counts(std::max<vtkIdType>(photons - aimed, 0));
  for (std::size_t k = 0; k < this->Ends.size(); ++k)
  {
    const vtkIdType first = k == 0 ? 0 : this->Ends[k - 1];
    counts.push_back(std::clamp<vtkIdType>(photons - first, 0, this->Ends[k] - first));
  }
  return counts;
}

} // namespace shadowcones
