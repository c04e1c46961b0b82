// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RivalMarch.h
 * @brief The one marcher for all rivals: light that nothing hides, less the share that a rival says is blocked.
 *
 * A homogeneous medium only. The unshadowed light of a pixel and how it is spread over the ray's cells are the same numbers for
 * all, made once; a rival pays for its answers alone.
 */
#ifndef RivalMarch_h
#define RivalMarch_h

#include "Rival.h"

#include "scExtinctionGroups.h"
#include "scLightSampling.h"
#include "scScatteringScene.h"

#include <cstdint>
#include <vector>

namespace shadowcones
{

/// Light, mean over wavelengths, that reaches the camera by way of the place at distance @p t, once the weight is counted.
double ScatteredTowardsCamera(const ScatteringScene& scene, const ExtinctionGroups& groups, const Ray& line, double begin,
  double t, const IncidentSample& sample);

/// The variable in which light of a lamp comes evenly along a ray: t = Nearest + Height tan(angle). A Sun: t itself.
class EvenAngle
{
public:
  EvenAngle(const Light& light, const Ray& line);
  double At(double t) const;
  double Distance(double variable) const;
  /// dt / dvariable.
  double Slope(double variable) const;

private:
  bool Plain;
  double Nearest = 0.0;
  double Height = 1.0;
};

class RivalMarch
{
public:
  /// @param places a ray. The arguments must outlive it.
  RivalMarch(const ScatteringScene& scene, int width, int height, int places);

  const ScatteringScene& Scene() const { return this->Subject; }
  int Width() const { return this->Columns; }
  std::size_t NumberOfPixels() const { return this->Rays.size(); }
  /// Of the pixel; no places where it does not cross the medium.
  const RivalRay& PixelRay(std::size_t pixel) const { return this->Rays[pixel]; }
  /// The medium term where nothing is in the way, i fastest, mean over wavelengths.
  const std::vector<double>& Lit() const { return this->Unshadowed; }
  /// Processor seconds that it takes, by Volume with nothing marked.
  double LitSeconds() const { return this->UnshadowedSeconds; }

  void Render(const Rival& rival, std::vector<double>& image) const;
  /**
   * Path tracing of the whole term: @p samples random places a pixel, each with one random point of the light and one ray.
   * Places are uniform along the ray, or in the even angle about the light.
   */
  void TracePaths(int samples, bool evenAngle, std::vector<double>& image) const;

private:
  void RenderUnshadowed();
  void Prepare(std::size_t pixel);

  ScatteringScene Subject;
  int Columns;
  int Lines;
  int Places;
  ExtinctionGroups Groups;
  std::vector<RivalRay> Rays;
  std::vector<std::vector<double>> Weights; ///< a cell's share of the pixel's unshadowed light
  std::vector<double> Unshadowed;
  double UnshadowedSeconds = 0.0;
};

} // namespace shadowcones

#endif
