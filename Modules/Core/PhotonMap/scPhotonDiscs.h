// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonDiscs.h
 * @brief Radiance along rays from the photons of a medium: the beam radiance estimate.
 *
 * After Jarosz, Zwicker and Jensen ("The Beam Radiance Estimate for Volumetric Photon Mapping", Eurographics 2008): every
 * photon is a disc that faces the ray, with the radius within which it has so many neighbours; a ray gathers all discs that
 * it pierces, each once, so that nothing is marched. The kernel is 3 / (pi r^2) (1 - d^2 / r^2)^2, d from the ray.
 *
 * Rays that lie together gather together: discs are as wide as many pixels, so that one way through the tree and one look at a
 * disc serve them all, side by side. What a ray finds does not depend on the others.
 */
#ifndef scPhotonDiscs_h
#define scPhotonDiscs_h

#include "ShadowConesCoreModule.h"
#include "scMedium.h"
#include "scParallel.h"
#include "scPhotonBalls.h"
#include "scRay.h"
#include "scRayInterval.h"
#include "scStoredPhotons.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace shadowcones
{

class PhotonDiscs;

/// A ray that gathers.
struct GatheringRay
{
  Ray Line;
  RayInterval Part; ///< in the medium
  /**
   * Where it ends at a surface, the unit normal of that on its side, else 0 and the ray has no end. Where the surface is slanted
   * as many photons in front of it lie beyond the end as are missing before it: those in front are taken, beyond the end by less
   * than the disc's radius times the tangent of the slant, which is right to first order.
   */
  Vector3 Facet;
};

/// Rays side by side, and what they have gathered; used again and again, by one thread.
class SHADOWCONESCORE_EXPORT DiscPacket
{
public:
  /// For rays in a medium, which must outlive it. Wavelengths of one extinction share an attenuation.
  explicit DiscPacket(const Medium& medium);

  /// No rays, near a place from which single precision is fine.
  void Clear(const Vector3& origin);
  /// @param depthAlong the optical depth of a ray from the begin of its part to a distance, in units of sigma_t; not used in a
  /// homogeneous medium.
  void Add(const GatheringRay& ray, const std::function<double(double)>& depthAlong);
  std::size_t Count() const { return this->Rays.size(); }
  /// What a ray has gathered at a wavelength: radiance.
  double Radiance(std::size_t ray, std::size_t wavelength) const { return this->Sums[wavelength * this->Width + ray]; }
  /// Variance of its mean over wavelengths, if photons are independent.
  double Variance(std::size_t ray) const { return this->Squares[ray]; }

private:
  friend class PhotonDiscs;

  /// Values of a ray, one array each: see Weigh().
  enum Value : int
  {
    OriginX,
    OriginY,
    OriginZ,
    AlongX,
    AlongY,
    AlongZ,
    Begin,
    End,
    Beyond,
    FacetX,
    FacetY,
    FacetZ,
    FacetOffset,
    Weight,
    Depth,
    Attenuated,
    Mean,
    NumberOfValues
  };
  struct Bound ///< of all rays, for what none of them meets
  {
    Vector3 Origin;
    Vector3 Direction;
    double Apart = 0.0;  ///< of an origin from that
    double Opens = 0.0;  ///< of a direction from that
    double End = 0.0;    ///< largest
    double Beyond = 0.0; ///< largest
  };
  float* Values(int value) { return this->Lanes.data() + static_cast<std::size_t>(value) * this->Width; }
  void LayOut();
  bool Meets(const PhotonBalls::Node& node) const;
  bool Meets(const PhotonBall& ball) const;
  void Take(const PhotonBall& ball, const float* direction, const float* power);
  bool Weigh(const PhotonBall& ball);
  void Scatter(const float* direction);
  void LookUpDepths();
  void Collect(const float* power);

  const shadowcones::Medium& Medium;
  std::vector<float> SigmaT;           ///< per group of wavelengths
  std::vector<std::size_t> GroupOf;    ///< per wavelength
  std::vector<std::size_t> Wavelengths; ///< group after group
  Vector3 From;
  std::vector<GatheringRay> Rays;
  std::vector<float> Depths; ///< in a density: knots of every ray
  std::vector<float> Steps;  ///< their distance
  std::size_t Width = 0;     ///< of an array
  Bound All;
  std::vector<float> Lanes;
  std::vector<float> Sums; ///< wavelength after wavelength
  std::vector<float> Squares;
};

class SHADOWCONESCORE_EXPORT PhotonDiscs
{
public:
  /// Nothing until Build().
  PhotonDiscs() = default;

  /// Take photons, whose discs are to hold so many neighbours. @return false where aborted.
  bool Build(StoredPhotons photons, double neighbours, const Monitor& monitor)
  {
    return this->Balls.Build(std::move(photons), neighbours, 3, monitor);
  }
  /// What is scattered towards the origins of the rays.
  void Gather(DiscPacket& packet) const;

  bool Empty() const { return this->Balls.Empty(); }
  const Vector3& Origin() const { return this->Balls.Origin(); }
  /// Mean radius of the discs, world units.
  double MeanRadius() const { return this->Balls.MeanRadius(); }
  std::int64_t Memory() const { return this->Balls.Memory(); }

private:
  PhotonBalls Balls;
};

} // namespace shadowcones

#endif
