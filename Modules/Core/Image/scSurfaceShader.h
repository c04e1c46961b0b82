// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scSurfaceShader.h
 * @brief Direct light on the surfaces of a scattering image, and the light itself where it is seen. Internal to Core.
 */
#ifndef scSurfaceShader_h
#define scSurfaceShader_h

#include "scExtinctionGroups.h"
#include "scMediumOpticalDepth.h"
#include "scOccluderInterval.h"
#include "scPixelRay.h"
#include "scPrimaryHits.h"
#include "scScatteringImage.h"
#include "scScatteringOptions.h"
#include "scShadingScene.h"
#include "scShiftedGrid.h"
#include "scSurfaceLight.h"
#include "scSurfacePoint.h"

#include <memory>
#include <vector>

namespace shadowcones
{

/**
 * Writes "SurfaceRadiance", "SurfaceRelativeError", "Transmittance", "Depth" and, from the finished medium term,
 * "Radiance"; one a thread. A pixel at an edge takes surface and seen light from several rays, depth and transmittance
 * from the one through its centre.
 */
class SurfaceShader
{
public:
  /// The image's arrays have their size; everything must outlive the shader.
  SurfaceShader(const ShadingScene& shading, const PrimaryHits& hits, ScatteringImage& image);

  void Shade(int i, int j);

  vtkIdType NumberOfOcclusionRays() const;
  /// Pixels whose "Radiance" misses the goal for want of surface samples, MaximumSamples being too few, and the worst.
  vtkIdType NumberOfShortPixels() const { return this->ShortPixels; }
  double WorstError() const { return this->Worst; }

private:
  /// A surface that is seen in the pixel.
  struct Part
  {
    double Fraction = 0.0; ///< of the pixel
    std::uint64_t Key = 0; ///< among the pixel's rays
    const PixelRay* Source = nullptr;
    SurfacePoint Point;
    SurfaceEstimate Estimate; ///< of the light that is looked at
    bool Lit = true;          ///< false: dark without a look
  };

  void FindParts();
  /// Add what surfaces show in the light of this index. @return the standard error of the mean over wavelengths.
  double AddSurfaces(std::size_t light, const PixelShift& shift);
  void AddPart(std::size_t light, const Part& part);
  void AddSeenLight(const Ray& ray, const PrimaryHit& hit, double fraction);
  bool InForeignCone(const ConeHierarchy* cones, const Ray& ray, const PrimaryHit& hit);
  void Write(std::size_t index, const Ray& ray, const PrimaryHit& hit, double error);
  void CountIfShort(double radiance, double error);

  const ShadingScene& Shading;
  const PrimaryHits& Hits;
  const ScatteringOptions& Options;
  const ExtinctionGroups& Groups;
  ScatteringImage& Image;
  const MediumOpticalDepth OpticalDepth;
  const SurfacePoints Points;
  std::vector<std::unique_ptr<SurfaceLight>> Lights;
  std::vector<PixelRay> Rays; ///< of the pixel
  std::vector<Part> Parts;    ///< of the pixel; the first NumberOfParts
  std::size_t NumberOfParts = 0;
  bool StopsShort = false;       ///< the pixel
  std::vector<double> Surface;   ///< of the pixel, per wavelength
  std::vector<double> SeenLight; ///< of the pixel, per wavelength
  vtkIdType ShortPixels = 0;
  double Worst = 0.0;
  double Darkest = 0.0; ///< pixels that are darker are measured against this
  std::vector<OccluderInterval> Intervals;
};

} // namespace shadowcones

#endif
