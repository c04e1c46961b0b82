// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfacePhotons.h
 * @brief Irradiance on surfaces from the photons of a surface map: the nearest ones.
 */
#ifndef scSurfacePhotons_h
#define scSurfacePhotons_h

#include "ShadowConesCoreModule.h"
#include "scPointTree.h"
#include "scStoredPhotons.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

/// A place on a surface that is asked for its irradiance; reused from one to the next.
struct SurfaceQuery
{
  std::vector<double> Irradiance; ///< per wavelength, W m^-2
  double Variance = 0.0;          ///< of its mean over wavelengths, if photons are independent

  std::vector<vtkIdType> Found; ///< scratch
  std::vector<double> Squared;
};

class SHADOWCONESCORE_EXPORT SurfacePhotons
{
public:
  /// None.
  SurfacePhotons() = default;

  /// @param neighbours photons of an estimate; they reach as far as the farthest of them.
  SurfacePhotons(StoredPhotons photons, int neighbours);

  /**
   * The irradiance on the side of the unit normal: of the photons whose surface faces about the same way, with the kernel
   * 3 / (pi r^2) (1 - d^2 / r^2)^2. Near the edge of a surface it is too small: what lies beyond has no photons.
   */
  void Estimate(const Vector3& place, const Vector3& normal, SurfaceQuery& query) const;

  bool Empty() const { return this->Stored.Count() == 0; }
  std::int64_t Memory() const;

private:
  StoredPhotons Stored;
  int Neighbours = 1;
  std::unique_ptr<const PointTree> Tree;
};

} // namespace shadowcones

#endif
