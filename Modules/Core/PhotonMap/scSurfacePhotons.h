// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfacePhotons.h
 * @brief Irradiance on surfaces from the photons of a surface map.
 */
#ifndef scSurfacePhotons_h
#define scSurfacePhotons_h

#include "ShadowConesCoreModule.h"
#include "scPhotonBalls.h"
#include "scStoredPhotons.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace shadowcones
{

class SurfacePhotons;

/// Points on surfaces, and what each has found; used again and again, by one thread.
class SHADOWCONESCORE_EXPORT SurfacePacket
{
public:
  /// No points.
  void Clear() { this->Points.clear(); }
  /// @param normal unit, on the side that is asked.
  void Add(const Vector3& place, const Vector3& normal) { this->Points.push_back({ place, normal }); }
  std::size_t Count() const { return this->Points.size(); }
  /// W m^-2
  double Irradiance(std::size_t point, std::size_t wavelength) const
  {
    return this->Sums[point * this->NumberOfWavelengths + wavelength];
  }
  /// Variance of its mean over wavelengths, if photons are independent.
  double Variance(std::size_t point) const { return this->Squares[point]; }

private:
  friend class SurfacePhotons;

  struct PlacedPoint
  {
    Vector3 Place;
    Vector3 Normal;
  };
  std::vector<PlacedPoint> Points;
  std::vector<double> Sums; ///< point after point
  std::vector<double> Squares;
  std::size_t NumberOfWavelengths = 0;
  std::vector<std::size_t> Order; ///< scratch
  std::vector<float> Lanes; ///< scratch: points that ask together
};

class SHADOWCONESCORE_EXPORT SurfacePhotons
{
public:
  /// Nothing until Build().
  SurfacePhotons() = default;

  /// Take photons, which are to have so many neighbours within their radius. @return false where aborted.
  bool Build(StoredPhotons photons, double neighbours, const Monitor& monitor)
  {
    return this->Balls.Build(std::move(photons), neighbours, 2, monitor);
  }
  /**
   * The irradiance on the sides of the normals: of the photons within whose radius a point lies and whose surface faces about
   * the same way, with the kernel 3 / (pi r^2) (1 - d^2 / r^2)^2. Near the edge of a surface it is too small: what lies beyond has no
   * photons. What a point finds does not depend on the others.
   */
  void Estimate(SurfacePacket& packet) const;

  bool Empty() const { return this->Balls.Empty(); }
  double MeanRadius() const { return this->Balls.MeanRadius(); }
  std::int64_t Memory() const { return this->Balls.Memory(); }

private:
  void Ask(SurfacePacket& packet, std::size_t begin, std::size_t end) const;
  void AskTogether(SurfacePacket& packet, std::size_t begin, std::size_t end) const;

  PhotonBalls Balls;
};

} // namespace shadowcones

#endif
