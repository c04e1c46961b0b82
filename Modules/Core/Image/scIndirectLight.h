// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scIndirectLight.h
 * @brief Light that came to a pixel by more than one scattering or reflection, from photon maps. Internal to Core.
 */
#ifndef scIndirectLight_h
#define scIndirectLight_h

#include "scExtinctionGroups.h"
#include "scMediumOpticalDepth.h"
#include "scPhotonEstimates.h"
#include "scPixelRay.h"
#include "scPrimaryHits.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scScatteringScene.h"
#include "scSurfacePoint.h"

#include <vector>

namespace shadowcones
{

/// Writes "MultipleScattering", "IndirectSurface" and "PhotonError", and adds to a finished "Radiance"; one a thread.
class IndirectLight
{
public:
  /// The image's arrays have their size; everything must outlive it. The scene has photons; its light does not matter.
  IndirectLight(const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups,
    const PrimaryHits& hits, ScatteringImage& image);

  void Add(int i, int j);

private:
  void AddMedium(const PixelRay& part);
  void AddSurface(const PixelRay& part);

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  const PrimaryHits& Hits;
  ScatteringImage& Image;
  const SurfacePoints Points;
  MediumOpticalDepth OpticalDepth;
  std::vector<PixelRay> Rays;        ///< of the pixel
  std::vector<double> Medium;        ///< of the pixel, per wavelength
  std::vector<double> Surface;       ///< of the pixel, per wavelength
  std::vector<double> Transmittance; ///< per group
  double Variance = 0.0;             ///< of the pixel's mean over wavelengths
  SurfacePoint Point;
  SurfaceQuery Query;
};

} // namespace shadowcones

#endif
