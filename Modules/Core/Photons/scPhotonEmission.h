// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPhotonEmission.h
 * @brief Photons that leave an area light towards the occluders' bounds. Internal to Core.
 */
#ifndef scPhotonEmission_h
#define scPhotonEmission_h

#include "scLight.h"
#include "scLightSampling.h"
#include "scTriangleMesh.h"

#include <cstdint>

namespace shadowcones
{

struct EmittedPhoton
{
  Vector3 Origin;          ///< on the light; Sun: outside the mesh's bounds, towards it
  Vector3 Direction;       ///< unit
  double Power = 0.0;      ///< W, mean over wavelengths, times the number of photons; 0: aimed behind the light's face
  double SolidAngle = 0.0; ///< sr, into which it was aimed (Sun: of its disc)
};

/**
 * Aims photons at the bounds of the occluders (triangles whose id is not negative): a face of the box in proportion to the
 * solid angle under which it is seen, then a direction uniform in that angle. From inside the bounds photons go out as the
 * light emits, over the whole hemisphere.
 */
class PhotonEmission
{
public:
  PhotonEmission(const Light& light, const TriangleMeshView& mesh);
  /// Aims at a box, which may be empty. @param whole diagonal of the bounds of all triangles, receivers included.
  PhotonEmission(const Light& light, const Box& target, double whole);
  /// What photons are aimed at: a little wider than what was given.
  const Box& Target() const { return this->Bounds; }
  /// Photon @p index of the sequence @p seed.
  EmittedPhoton Emit(std::uint64_t seed, vtkIdType index) const;

  /**
   * What lights share photons by, W, mean over wavelengths: pi times area times radiance, 4 pi times intensity for each
   * point, and for a Sun its irradiance times the area of the occluders' bounds as it sees them.
   */
  double Power() const;

private:
  EmittedPhoton EmitFromSun(const double (&u)[4]) const;
  EmittedPhoton EmitOverHemisphere(const LightSurfaceSample& start, double u, double v) const;

  const Light& Lamp;
  double MeanRadiance = 0.0;
  double Area = 0.0; ///< 1 for point lights, whose spectrum is an intensity
  bool IsPoint = false;
  Box Bounds;         ///< of the target
  double Whole = 0.0; ///< diagonal of all triangles' bounds, receivers included
  Light Faces[6];     ///< of the target, as rectangles that face outward
};

} // namespace shadowcones

#endif
