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
#include "scTileRange.h"

#include <cstddef>
#include <vector>

namespace shadowcones
{

/// One of several estimates of independent photons whose mean is taken.
struct IndirectPass
{
  const PhotonEstimates& Photons;
  int Number = 0;
  int Count = 1;
};

/**
 * Adds passes to "MultipleScattering" and "IndirectSurface", tile by tile; one a thread and pass. While passes come "PhotonError" of
 * one pass holds the variance of its photons as if they were independent, of several the sum of squared differences between
 * the passes and their mean (Welford). FinishIndirect() makes an error of it, and adds all to a finished "Radiance".
 */
class IndirectLight
{
public:
  /// Everything must outlive it. The light of the scene does not matter.
  IndirectLight(const ScatteringScene& scene, const ScatteringOptions& options, const ExtinctionGroups& groups,
    const IndirectPass& pass);

  /// The image's arrays have their size, and values of 0 before the first pass.
  void Add(const TileRange& tile, const PrimaryHits& hits, ScatteringImage& image);

  /// Pixels along a side of a tile: its rays gather together.
  static constexpr int TileSide = 8;

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// A ray of the tile, and its places in the packets.
  struct TileRay
  {
    PixelRay Ray;
    std::size_t Pixel = 0; ///< of the image
    std::size_t InMedium = none;
    std::size_t OnSurface = none;
    double Throughput = 0.0; ///< at the surface, mean over wavelengths
  };
  void AddRay(TileRay& ray);
  void AddRaysOf(std::size_t pixel, std::size_t begin, std::size_t end, ScatteringImage& image);

  const ScatteringScene& Scene;
  const ScatteringOptions& Options;
  const IndirectPass Pass;
  const SurfacePoints Points;
  MediumOpticalDepth OpticalDepth;
  DiscPacket InMedium;
  SurfacePacket OnSurfaces;
  std::vector<PixelRay> PixelRays; ///< scratch
  std::vector<TileRay> Rays;       ///< of the tile, pixel after pixel
  std::vector<double> Throughputs; ///< of rays that end at a surface, wavelengths of one after the other
  std::vector<double> Medium;      ///< of a pixel, per wavelength
  std::vector<double> Surface;
  SurfacePoint Point;
};

/// After the last pass: "PhotonError" and "Radiance" of pixels [begin, end) of the arrays.
void FinishIndirect(int passes, std::size_t begin, std::size_t end, ScatteringImage& image);

} // namespace shadowcones

#endif
