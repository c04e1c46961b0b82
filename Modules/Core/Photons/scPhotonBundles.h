// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonBundles.h
 * @brief Which photon leaves which light towards what. Internal to Core.
 */
#ifndef scPhotonBundles_h
#define scPhotonBundles_h

#include "scAimedBoxes.h"
#include "scLightShares.h"
#include "scPhotonEmission.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/**
 * Bundles of photons, each of one light and aimed at one box. The first bundles, one a light, are aimed at the bounds of all
 * occluders. Others may be aimed at occluders that these hardly meet. A path belongs to the first of the light's aimed bundles
 * whose box it meets, else to the light's own: there is one answer for every path, so that the photons of a bundle stand for
 * the flux of its paths, whatever the others do (stratified sampling of the paths).
 *
 * Photons count on from the aimed bundles to the lights', which share theirs by power, see LightShares.
 */
class PhotonBundles
{
public:
  PhotonBundles(const std::vector<Light>& lights, const TriangleMeshView& mesh, std::uint64_t seed);

  /// Aim photons of a light at boxes, a bundle each, which has the paths that meet its box from now on, unless an earlier one has them.
  void Aim(int light, const std::vector<Box>& boxes);
  std::size_t NumberOfBundles() const { return this->Bundles.size(); }
  int LightOf(std::size_t bundle) const { return this->Bundles[bundle].Light; }

  /// Photon @p index of a bundle; its Power is 0 where its path belongs to another one, or starts behind the light's face.
  EmittedPhoton Emit(std::size_t bundle, vtkIdType index) const;

  /// How many photons an aimed bundle has, none at first: without any it has no paths. The lights' own bundles have what is left.
  void SetPhotons(std::size_t bundle, vtkIdType photons);
  vtkIdType NumberOfAimedPhotons() const { return this->Ends.empty() ? 0 : this->Ends.back(); }
  vtkIdType PhotonsOf(std::size_t bundle) const;
  /// The first photon of an aimed bundle.
  vtkIdType FirstPhoton(std::size_t bundle) const;

  struct BundlePhoton
  {
    std::size_t Bundle = 0;
    vtkIdType Index = 0; ///< among its photons
  };
  BundlePhoton At(vtkIdType photon) const;
  /// How many of the first @p photons each bundle has.
  std::vector<vtkIdType> Counts(vtkIdType photons) const;

private:
  struct Bundle
  {
    int Light;
    PhotonEmission Emission;
    std::uint64_t Seed;
  };
  static std::vector<Bundle> BundlesOf(
    const std::vector<Light>& lights, const TriangleMeshView& mesh, std::uint64_t seed);
  static std::vector<double> PowersOf(const std::vector<Bundle>& bundles);
  std::size_t OwnerOf(int light, const EmittedPhoton& photon) const;

  const std::vector<Light>& Lights;
  double Whole;
  std::uint64_t Seed;
  std::vector<Bundle> Bundles;
  struct AimedBundles
  {
    std::vector<std::size_t> Bundles;
    AimedBoxes Boxes; ///< that their photons are aimed at
  };
  std::vector<AimedBundles> AimedOf; ///< of each light
  LightShares Shares;
  std::vector<vtkIdType> Ends; ///< of the aimed bundles' photons
};

} // namespace shadowcones

#endif
