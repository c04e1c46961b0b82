// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonWalk.h
 * @brief The way of one photon through a scene: scPhotonMap.h has the weights. Internal to Core.
 */
#ifndef scPhotonWalk_h
#define scPhotonWalk_h

#include "scFreeFlight.h"
#include "scPhotonEmission.h"
#include "scPhotonMap.h"
#include "scRandom.h"
#include "scRay.h"

#include <vector>

namespace shadowcones
{

/// Follows photons; one a thread.
class PhotonWalk
{
public:
  /// Everything is referred to and must outlive the walk. @param rules of the lights: what rays from them pass by.
  PhotonWalk(const PhotonMapScene& scene, const PhotonMapOptions& options, const FreeFlight& flight,
    const std::vector<RayRules>& rules);

  /// A photon that leaves a light.
  struct Photon : EmittedPhoton
  {
    int Light = 0;
    double Share = 1.0; ///< of its Power, which is that of all photons of the light
    double Turn = 0.0;  ///< in [0, 1), chooses the hero wavelength
  };

  void Follow(const Photon& photon, RandomStream& random, PhotonMap& map);

private:
  /// Where a flight ends.
  struct FlightEnd
  {
    double T = 0.0;
    bool Collides = false;
    RayHit Hit; ///< Triangle -1 where it does not end on a surface
  };

  bool Start(const Photon& photon);
  FlightEnd Fly(const RayRules& rules, RandomStream& random);
  void Weigh(double opticalDepth, bool collides);
  bool Collide(double t, RandomStream& random, PhotonMap& map);
  bool Reflect(const FlightEnd& end, RandomStream& random, PhotonMap& map);
  bool GoOn(const std::vector<double>& after, std::vector<double>& absorbed, RandomStream& random, PhotonMap& map);
  void Store(const Vector3& point, const std::vector<double>& powers, StoredPhotons& photons) const;

  const PhotonMapScene& Scene;
  const PhotonMapOptions& Options;
  const FreeFlight& Flight;
  const std::vector<RayRules>& Rules;
  std::vector<double> SigmaT; ///< per wavelength
  std::vector<double> Albedo;
  bool SigmasDiffer = false;

  Ray Line;                    ///< of the photon's flight
  int Bounces = 0;             ///< before it
  std::size_t Hero = 0;
  std::vector<double> Weights; ///< per wavelength, W
  std::vector<double> Shares;  ///< per wavelength: density of the path over its mean
  std::vector<double> After;   ///< what is scattered or reflected of Weights
};

} // namespace shadowcones

#endif
