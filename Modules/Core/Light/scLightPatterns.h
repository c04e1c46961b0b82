// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scLightPatterns.h
 * @brief The light seen from a point as a fixed number of stratified samples. Internal to Core.
 */
#ifndef scLightPatterns_h
#define scLightPatterns_h

#include "scLight.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace shadowcones
{

/// One bit a light sample, in blocks of 64.
using LightMask = std::vector<std::uint64_t>;

/// The samples of one point; arrays are padded with zeros to whole blocks of 64. One a thread.
struct LightView
{
  const double* A = nullptr; ///< Disc, Rectangle: place on the light, Center + A AxisU + B AxisV; else nullptr
  const double* B = nullptr;
  std::vector<double> X; ///< from the point to the sample (Sun: unit), one array a component
  std::vector<double> Y;
  std::vector<double> Z;
  LightMask Open; ///< samples whose face emits towards the point
  std::size_t First = 0; ///< of the samples, among those of all patterns
};

struct LightPatternOptions
{
  int NumberOfSamples = 64;
  std::uint64_t Seed = 1;
  bool Same = false;    ///< every point takes the same samples: what is counted changes steadily from point to point
  bool Outline = false; ///< every second sample lies on the outline of the light, its corners among them; Same
};

/**
 * Scrambled Sobol patterns, mapped to the light once: uniform by area (Disc, Rectangle, Mesh) or by the solid angle of
 * the visible cap (Sphere, Sun), as SampleVisibleLight. Which pattern a point takes is a pure function of (Seed, its
 * coordinates), so that it does not depend on how a data set is cut into pieces. A pattern is drawn when the first point looks
 * through it, in any thread: a few points do not wait for all patterns.
 */
class LightPatterns
{
public:
  LightPatterns(const Light& light, const LightPatternOptions& options);
  LightPatterns(const Light& light, int numberOfSamples, std::uint64_t seed)
    : LightPatterns(light, LightPatternOptions{ numberOfSamples, seed })
  {
  }

  /// Samples a point; point lights that are no more than asked for are taken once each, a Sun without a size once.
  int Count() const { return this->NumberOfSamples; }
  /// The samples are all of the light: there is no sampling error.
  bool IsExact() const { return this->Exact; }
  std::size_t NumberOfBlocks() const { return this->Stride / 64; }
  const Light& Lamp() const { return this->TheLight; }
  const Vector3& AxisU() const { return this->U; }
  const Vector3& AxisV() const { return this->V; }

  /// True where all of the light that can be seen from anywhere emits towards the point: no sample needs to be looked
  /// at.
  bool IsWholeFrom(const Vector3& point) const;
  void LookFrom(const Vector3& point, LightView& view) const;
  /**
   * What sample @p k of a view stands for of the integral over all directions, in a unit that is the same for all samples of
   * the view: the solid angle of an equal part of the light's area, or 1 where samples are uniform in solid angle; Point: 1 /
   * distance^2. For samples that are open.
   */
  double WeightOf(const LightView& view, std::size_t k) const;

private:
  std::size_t PatternOf(const Vector3& point) const;
  void DrawPattern(std::size_t pattern) const;
  void DrawSample(std::size_t place, double u, double v) const;
  void DrawOutlineSample(std::size_t place, double turn) const;
  void LookAtSphere(const Vector3& point, std::size_t first, LightView& view) const;

  Light TheLight;
  int NumberOfSamples;
  bool Exact = false;
  bool Outline = false;
  std::uint64_t Seed;
  std::size_t NumberOfPatterns = 1;
  std::size_t Stride = 0; ///< samples a pattern, whole blocks
  Vector3 U;
  Vector3 V;
  LightMask Full;
  mutable std::unique_ptr<std::once_flag[]> Drawn; ///< one a pattern; its samples below are written once, then only read
  mutable std::unique_ptr<double[]> As;            ///< Disc, Rectangle: place on the light; Sphere: place on the unit disc
  mutable std::unique_ptr<double[]> Bs;
  mutable std::vector<Vector3> Positions; ///< Sun, Mesh, Point
  mutable std::vector<Vector3> Normals;   ///< Mesh with faces
};

} // namespace shadowcones

#endif
