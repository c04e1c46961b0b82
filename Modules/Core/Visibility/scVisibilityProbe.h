// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scVisibilityProbe.h
 * @brief How much of the light points see, traced inside cones or from the cones' base discs alone.
 */
#ifndef scVisibilityProbe_h
#define scVisibilityProbe_h

#include "ShadowConesCoreModule.h"
#include "scArrivingLight.h"
#include "scCone.h"
#include "scLight.h"
#include "scOccluderScene.h"
#include "scParallel.h"
#include "scShadowClass.h"
#include "scTeam.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace shadowcones
{

enum class VisibilityMethod : int
{
  Exact = 0, ///< rays to the light, for points inside cones only
  Soft = 1   ///< the base discs of the cones are the occluders; no mesh
};

struct VisibilityOptions
{
  VisibilityMethod Method = VisibilityMethod::Exact;
  int NumberOfLightSamples = 64; ///< a point, at least 1
  std::uint64_t Seed = 1;
  bool OnSurfaces = false; ///< points lie on occluders: a curved surface's own discs do not hide them (Soft)
  bool Irradiance = false; ///< ask for it too, at points with a normal
  bool Fluence = false;    ///< ask for it too
  bool SameSamples = false; ///< every point takes the same samples: for edges of shadows, where neighbours are compared
  bool Outline = false; ///< every second sample lies on the light's outline: for where shadow begins and ends, not for fractions
};

struct PointVisibility
{
  double Fraction = 1.0; ///< visible share of the light that emits towards the point, 0..1
  ShadowClass Class = ShadowClass::Lit;
  int OccluderId = -1; ///< hides most samples, the smallest of several; -1: none hides any
  double Error = 0.0;  ///< standard error, see VisibilityProbe
  ArrivingLight Irradiance; ///< where it is asked for; on the side of the normal
  ArrivingLight Fluence;    ///< where it is asked for; with a normal: of the light above the surface
};

/// How many samples of a light an occluder hides from a point.
struct HiddenSamples
{
  int OccluderId;
  int Count;
};

/**
 * Built once, queried often, from any number of threads. Samples of a point are a pure function of (Seed, its
 * coordinates).
 *
 * With k of n samples visible the fraction is k / n and its error sqrt(p (1 - p) / n), p = (k + 1/2) / (n + 1): the
 * standard error of independent samples, which overrates that of the stratified ones, and is not 0 where all samples
 * agree. It is 0 where nothing is sampled: outside all cones, on the dark side of the light, and for lights without extent. It
 * knows nothing of shadow that the cones miss (Exact) nor of what the discs get wrong (Soft).
 *
 * Exact asks the rays inside cones and up to one base radius before their base, where surface points may lie. A
 * triangle in whose plane the point lies, as well as its coordinates and the mesh's can say (rounding to double precision,
 * or to single where they are in single precision), never hides anything from it, nor does a disc (Soft): a surface casts
 * no shadow on itself. Nor does a triangle that is flush with a flat light, see IsFlush() in scFlatFace.h.
 */
class SHADOWCONESCORE_EXPORT VisibilityProbe
{
public:
  /**
   * @param cones bounds of the shadow (Exact), or discs made with CosineCorrection off (Soft); @param scene the
   * occluders, without receivers; nullptr for Soft; must outlive the probe; @param bounds points outside see the whole
   * light.
   */
  VisibilityProbe(const std::vector<Cone>& cones, const Light& light, const OccluderScene* scene, const Box& bounds,
    const VisibilityOptions& options);
  ~VisibilityProbe();
  VisibilityProbe(const VisibilityProbe&) = delete;
  VisibilityProbe& operator=(const VisibilityProbe&) = delete;

  /// @param normal of the surface at the point, unit, or nullptr: light from below the surface is hidden by it.
  PointVisibility At(const Vector3& point, const Vector3* normal = nullptr) const;
  /**
   * Which occluders hide samples of the light that shines on the point, in ascending order of their ids; @p together are the
   * samples that any of them hides. @p hidden is overwritten.
   * @return the number of samples that shine on the point, above its surface: 0 on the dark side of the light.
   */
  int ShadowsAt(const Vector3& point, const Vector3* normal, std::vector<HiddenSamples>& hidden, int& together) const;
  /// Samples of the light, all of which are asked for; 1: it is a point, or a Sun without a size.
  int NumberOfSamples() const;
  bool AsksForIrradiance() const;
  bool AsksForFluence() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};

/// What is known at many points: one value a point and light each, those of a point side by side.
struct VisibilityResult
{
  std::vector<float> Visibility;
  std::vector<unsigned char> ShadowClasses;
  std::vector<int> OccluderIds;
  std::vector<float> Errors;
  std::vector<float> Irradiance; ///< of light with the spectrum 1 (see ArrivingLight); NaN without a normal; empty: not asked for
  std::vector<float> IrradianceErrors;
  std::vector<float> Fluence; ///< the same; empty: not asked for
  std::vector<float> FluenceErrors;
};

/**
 * Ask the probes, one a light, at @p count points (3 values each) with normals (3 values each, any length; 0: no
 * normal) or nullptr. @param workers processes that ask at the same points: each at a share of them, then all have all.
 * @return false where aborted.
 */
SHADOWCONESCORE_EXPORT bool ProbeVisibility(const std::vector<const VisibilityProbe*>& probes, const double* points,
  const double* normals, vtkIdType count, const Monitor& monitor, VisibilityResult& result, Team* workers = nullptr);
/// The same for one light.
SHADOWCONESCORE_EXPORT bool ProbeVisibility(const VisibilityProbe& probe, const double* points, const double* normals,
  vtkIdType count, const Monitor& monitor, VisibilityResult& result);

} // namespace shadowcones

#endif
